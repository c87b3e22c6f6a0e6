// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_ID_SET_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_ID_SET_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A set of handles below a number, of one bit for each. Threads may ask at once, and only one may change it.
template <class Id>
class Id_set {
public:
  Id_set() = default;
  explicit Id_set(std::size_t n) { resize(n); }

  void resize(std::size_t n) { words_.resize(n / bits_of_word + 1, 0); }

  bool has(Id i) const { return (words_[word(i)] >> bit(i) & 1) != 0; }
  void add(Id i) { words_[word(i)] |= std::uint64_t(1) << bit(i); }
  void remove(Id i) { words_[word(i)] &= ~(std::uint64_t(1) << bit(i)); }

  /// Adds the handles from `begin` on, before `end`.
  void add(Id begin, Id end) {
    for (; begin < end && bit(begin) != 0; ++begin) add(begin);
    for (; begin < end && word(begin) < word(end); begin = Id(begin.value() + bits_of_word))
      words_[word(begin)] = ~std::uint64_t(0);
    for (; begin < end; ++begin) add(begin);
  }

private:
  static constexpr std::size_t bits_of_word = 64;

  std::vector<std::uint64_t> words_;

  static std::size_t word(Id i) { return std::size_t(i) / bits_of_word; }
  static unsigned bit(Id i) { return static_cast<unsigned>(std::size_t(i) % bits_of_word); }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_ID_SET_H
