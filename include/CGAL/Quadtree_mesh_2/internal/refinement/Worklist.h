// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The list of triangles that may be bad, the sharpest first, or those with the shortest edges.
//
// Computes: which triangle is next. By the usual order, it is the sharpest. A thin triangle stands for a difference of
//           sizes that is yet to be bridged. That takes the fewest vertices from its short side. A vertex that comes
//           earlier, for a triangle that hardly misses the bound, is often in the way of a better place. On maps the
//           order saves one to two percent of the triangles, at 30 degrees five.
//           By the other order it is the one with the shortest edge, first in first out. Around a small feature this
//           makes rings of like triangles, one ring after the other. So a mesh that grows by powers of ten around a
//           square takes half the triangles.
// Bound:    O(1) by sharpness. Squared sines are told apart by levels, two to a factor of 2, and a level is a list,
//           last in first out: so work stays in one place for a while. O(log n) by length, with as fine levels.
// Source:   Shewchuk's Triangle has such levels of length.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_WORKLIST_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_WORKLIST_H

#include <CGAL/Quadtree_mesh_2/internal/base/Id_set.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Triangles that may be bad. Whether one is bad is decided when it is taken out, so that entries need not be withdrawn
/// when flips cure a triangle. All are pushed in one of the two ways, until the list is empty.
class Worklist {
public:
  Worklist() { first_.fill(end_); }

  bool is_empty() const { return words_in_use_ == 0 && by_length_.empty(); }

  /// The triangle will stand in the list once, as sharp as it was at first.
  /// \param share the squared sine of the least angle, as a share of the bound's; 1 or more where only the size is bad
  void push(Triangle_id t, double share) {
    if (!next_.has(t)) make_room_for(t);
    if (queued_.has(t)) return;
    queued_.add(t);
    const int level = level_of(share);
    next_[t] = first_[std::size_t(level)];
    first_[std::size_t(level)] = t;
    in_use_[std::size_t(level / 32)] |= 1u << level % 32;
    words_in_use_ |= 1u << level / 32;
  }

  /// Each time that the triangle is pushed, it gets another place.
  /// \param length2 the squared length of the shortest edge
  void push_by_length(Triangle_id t, double length2) {
    by_length_.push({level_of_length(length2), number_pushed_++, t});
  }

  /// Of the sharpest, the one pushed last; or of those with the shortest edge, the one pushed first.
  /// \pre it is not empty
  Triangle_id pop() {
    CGAL_precondition(!is_empty());
    return by_length_.empty() ? pop_sharpest() : pop_shortest();
  }

  /// Whether the triangle popped last, pushed by length, has another place on the list by its length now: it has
  /// changed, and was pushed again then.
  bool is_outdated(double length2) const { return level_of_length(length2) != level_of_popped_; }

private:
  static constexpr int number_of_levels_ = 256; // down to angles of 2^-64
  static constexpr Triangle_id end_{};

  struct By_length {
    int level;
    std::size_t turn;
    Triangle_id triangle;

    friend bool operator>(const By_length& a, const By_length& b) {
      return std::tie(a.level, a.turn) > std::tie(b.level, b.turn);
    }
  };

  std::array<Triangle_id, number_of_levels_> first_;
  // Of a mesh with a bulk few are ever listed, so most of the long array of the next ones is never touched.
  Id_set<Triangle_id> queued_;
  Uninitialized_indexed_vector<Triangle_id, Triangle_id> next_; // on the list of its level
  std::array<std::uint32_t, number_of_levels_ / 32> in_use_{};  // a bit for each level
  std::uint32_t words_in_use_ = 0;                              // a bit for each word of them
  std::priority_queue<By_length, std::vector<By_length>, std::greater<By_length>> by_length_;
  std::size_t number_pushed_ = 0; // by length
  int level_of_popped_ = 0;

  void make_room_for(Triangle_id t) {
    const std::size_t n = std::size_t(t) + std::size_t(t) / 2 + 64;
    next_.resize(n);
    queued_.resize(n);
  }

  Triangle_id pop_sharpest() {
    const auto word = static_cast<std::size_t>(lowest_bit(words_in_use_));
    const int bit = lowest_bit(in_use_[word]);
    Triangle_id& first = first_[32 * word + std::size_t(bit)];
    const Triangle_id t = first;
    first = next_[t];
    queued_.remove(t);
    if (first == end_) {
      in_use_[word] &= ~(1u << bit);
      if (in_use_[word] == 0) words_in_use_ &= ~(1u << word);
    }
    return t;
  }

  Triangle_id pop_shortest() {
    const By_length next = by_length_.top();
    by_length_.pop();
    level_of_popped_ = next.level;
    return next.triangle;
  }

  /// Two to a factor of 2 in length.
  static int level_of_length(double length2) { return std::ilogb(length2); }

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
