// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Sums along a linked list.
//
// Computes: for each member of a list the sum of the weights of those before it.
// Bound:    O(n) work, expected; four rounds of short tasks, and that again for a list of about n / 64 members,
//           as long as it has more than a block. So there are at most twelve for lists with 32-bit links.
// Method:   About every 64th member, by a fixed hash of its index, begins a piece of the list. Tasks go along
//           the pieces. A list of pieces tells what comes before each.
// Source:   Helman, JaJa, "Designing practical efficient algorithms for symmetric multiprocessors", ALENEX
//           1999; the pieces are theirs.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_SUMS_ALONG_LIST_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_SUMS_ALONG_LIST_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A member of a linked list.
struct List_link {
  static constexpr std::uint32_t none = 0xffffffffu;

  std::uint32_t next; ///< or none
  std::uint32_t weight;
};

/// Cuts a list into pieces; see the head of this file.
template <class ConcurrencyTag>
class List_pieces {
public:
  using Links = Uninitialized_vector<List_link>;
  using Sums = Uninitialized_vector<std::uint32_t>;

  List_pieces(const Links& links, std::uint32_t first) : links_(links), first_(first) {}

  Sums sums() {
    Sums sums(links_.size());
    if (links_.size() <= default_block) {
      std::uint32_t sum = 0;
      for (std::uint32_t i = first_; i != List_link::none; i = links_[i].next) {
        sums[i] = sum;
        sum += links_[i].weight;
      }
      return sums;
    }
    const Links pieces = make_pieces(sums);
    const Sums before = List_pieces(pieces, piece_[first_]).sums();
    for_each_index<ConcurrencyTag>(sums.size(), [&](std::size_t i) { sums[i] += before[piece_[i]]; });
    return sums;
  }

private:
  bool is_first_of_piece(std::size_t i) const {
    return i == first_ || (static_cast<std::uint32_t>(i) * 0x9e3779b1u) >> 26 == 0;
  }

  /// Lists the pieces, and finds the sums within each.
  Links make_pieces(Sums& sums) {
    const std::vector<std::uint32_t> first =
        pack<ConcurrencyTag>(links_.size(), [&](std::size_t i) { return is_first_of_piece(i); });
    piece_.resize(links_.size());
    for_each_index<ConcurrencyTag>(first.size(),
                                   [&](std::size_t p) { piece_[first[p]] = static_cast<std::uint32_t>(p); });
    Links pieces(first.size());
    for_each_index<ConcurrencyTag>(
        first.size(),
        [&](std::size_t p) {
          std::uint32_t i = first[p], sum = 0;
          do {
            if (i != first[p]) piece_[i] = static_cast<std::uint32_t>(p);
            sums[i] = sum;
            sum += links_[i].weight;
            i = links_[i].next;
          } while (i != List_link::none && !is_first_of_piece(i));
          pieces[p] = {i == List_link::none ? i : piece_[i], sum};
        },
        default_block / 64);
    return pieces;
  }

  const Links& links_;
  std::uint32_t first_;
  Uninitialized_vector<std::uint32_t> piece_; // by member
};

/// Returns for each member of a list the sum of the weights of the members before it.
/// \pre the list has all members, the first one before all others
template <class ConcurrencyTag>
Uninitialized_vector<std::uint32_t> sums_along_list(const Uninitialized_vector<List_link>& links,
                                                    std::uint32_t first) {
  return List_pieces<ConcurrencyTag>(links, first).sums();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_SUMS_ALONG_LIST_H
