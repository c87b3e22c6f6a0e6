// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARE_COLLECTOR_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARE_COLLECTOR_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/morton.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Takes squares of one level in any order and gives them back in shuffle order, each once.
///
/// Where the squares are so dense in the level that a bit for each square of the level costs no more than the
/// squares themselves, they are marked; otherwise they are sorted. Both take time linear in the number of
/// insertions.
template <class Word>
class Square_collector {
public:
  using Square = Grid_point_2<Word>;

  /// \param level the level, at most 62.
  /// \param expected about how many squares will be inserted.
  Square_collector(int level, std::size_t expected) : level_(level) {
    if (2 * level <= bit_width(expected) + 6) marks_.assign(((std::size_t(1) << (2 * level)) + 63) / 64, 0);
  }

  void insert(const Square& s) {
    if (!marks_.empty()) {
      const std::uint64_t k = key(s);
      marks_[k / 64] |= std::uint64_t(1) << (k % 64);
    } else if (level_ <= 32) {
      keys_.push_back(key(s));
    } else {
      squares_.push_back(s);
    }
  }

  /// Returns what was inserted; the collector is to be used no more.
  std::vector<Square> take_sorted() {
    if (!marks_.empty()) return read_marks();
    if (level_ <= 32) return sort_keys();
    return sort_squares();
  }

private:
  static std::uint64_t key(const Square& s) {
    return interleave(static_cast<std::uint32_t>(s.x), static_cast<std::uint32_t>(s.y));
  }
  static Square square(std::uint64_t key) { return {gather_bits(key >> 1), gather_bits(key)}; }

  std::vector<Square> read_marks() const {
    std::vector<Square> result;
    result.reserve(number_of_marks());
    for (std::size_t i = 0; i < marks_.size(); ++i)
      for (std::uint64_t word = marks_[i]; word != 0; word &= word - 1)
        result.push_back(square(64 * i + static_cast<std::uint64_t>(bit_width(word & (~word + 1)) - 1)));
    return result;
  }

  std::size_t number_of_marks() const {
    std::size_t sum = 0;
    for (std::uint64_t word : marks_)
      for (; word != 0; word &= word - 1) ++sum;
    return sum;
  }

  std::vector<Square> sort_keys() {
    radix_sort(keys_);
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    std::vector<Square> result;
    result.reserve(keys_.size());
    for (std::uint64_t k : keys_) result.push_back(square(k));
    return result;
  }

  std::vector<Square> sort_squares() const {
    std::vector<Square> result;
    for (std::uint32_t i : shuffle_order(squares_))
      if (result.empty() || result.back() != squares_[i]) result.push_back(squares_[i]);
    return result;
  }

  int level_;
  std::vector<std::uint64_t> marks_;
  std::vector<std::uint64_t> keys_;
  std::vector<Square> squares_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARE_COLLECTOR_H
