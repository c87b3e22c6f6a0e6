// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The list of triangles that may be bad, the sharpest first.
//
// Computes: which triangle is next. A thin triangle stands for a difference of sizes that is yet to be bridged.
//           Bridged from its short side, it takes the fewest vertices; a vertex that comes earlier, for one that hardly
//           misses the bound, is often in the way of the better place. On maps the order saves one to two percent of
//           the triangles, at 30 degrees five.
// Bound:    O(1). Squared sines are told apart by levels, two to a factor of 2, and a level is a list, last in first
//           out: so work stays in one place for a while.
// Source:   Shewchuk's Triangle has such levels, too.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_WORKLIST_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_WORKLIST_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Triangles that may be bad; each stands in it at most once. Whether one is bad is decided when it is taken out, so
/// that entries need not be withdrawn when flips cure a triangle.
class Worklist {
public:
  Worklist() { first_.fill(end_); }

  bool is_empty() const { return words_in_use_ == 0; }

  /// \param share the squared sine of the least angle, as a share of the bound's; 1 or more where only the size is bad
  void push(Triangle_id t, double share) {
    next_.make_room_for(t, is_not_queued_);
    Triangle_id& next = next_[t];
    if (next != is_not_queued_) return;
    const int level = level_of(share);
    next = first_[std::size_t(level)];
    first_[std::size_t(level)] = t;
    in_use_[std::size_t(level / 32)] |= 1u << level % 32;
    words_in_use_ |= 1u << level / 32;
  }

  /// Of the sharpest, the one pushed last.
  /// \pre it is not empty
  Triangle_id pop() {
    CGAL_precondition(!is_empty());
    const auto word = static_cast<std::size_t>(lowest_bit(words_in_use_));
    const int bit = lowest_bit(in_use_[word]);
    Triangle_id& first = first_[32 * word + std::size_t(bit)];
    const Triangle_id t = first;
    first = next_[t];
    next_[t] = is_not_queued_;
    if (first == end_) {
      in_use_[word] &= ~(1u << bit);
      if (in_use_[word] == 0) words_in_use_ &= ~(1u << word);
    }
    return t;
  }

private:
  static constexpr int number_of_levels_ = 256; // down to angles of 2^-64
  static constexpr Triangle_id end_{}, is_not_queued_{0xfffffffeu};

  std::array<Triangle_id, number_of_levels_> first_;
  Uninitialized_indexed_vector<Triangle_id, Triangle_id> next_; // on the list of its level
  std::array<std::uint32_t, number_of_levels_ / 32> in_use_{};  // a bit for each level
  std::uint32_t words_in_use_ = 0;                              // a bit for each word of them

  /// By the exponent and the first bit of the significand. What is no number, of a flat triangle, counts as sharpest.
  static int level_of(double share) {
    constexpr int bits_left_out = 22;
    constexpr std::uint32_t bits_of_1 = 0x3f800000;
    if (share >= 1) return number_of_levels_ - 1;
    const float x = share > 0 ? static_cast<float>(share) : 0;
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    const auto steps = static_cast<int>((bits_of_1 - bits) >> bits_left_out);
    return number_of_levels_ - 2 - std::min(steps, number_of_levels_ - 2);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_WORKLIST_H
