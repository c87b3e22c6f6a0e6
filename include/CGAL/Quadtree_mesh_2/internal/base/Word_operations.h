// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_WORD_OPERATIONS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_WORD_OPERATIONS_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The operations of quadtrees on the bits of grid coordinates. Words longer than the machine's specialize
/// it.
template <class Word>
struct Word_operations {
  static_assert(std::is_integral<Word>::value, "include Long_words.h for longer words");

  /// Holds the level of any square.
  using Level = std::uint8_t;

  /// Whether corners are short enough to be stored with every square; if not they are found when asked for.
  static constexpr bool are_corners_stored = true;

  /// Returns the number of bits of `x ^ y`, up to the highest one set.
  static int width_of_difference(const Word& x, const Word& y) {
    return bit_width(static_cast<std::uint64_t>(x ^ y));
  }
  /// Returns bit `i`, 0 or 1.
  static int bit(const Word& w, int i) { return static_cast<int>(w >> i & 1); }
  /// Returns how many bits from bit `i` upward follow each other that have a value, `most` at the most.
  static int run_of_bits(const Word& w, int i, int value, int most) {
    const std::uint64_t others = (value == 0 ? std::uint64_t(w) : ~std::uint64_t(w)) >> i;
    return others == 0 ? most : std::min(most, lowest_bit(others));
  }
  /// Returns `w` with its lowest `i` bits cleared.
  static Word without_low_bits(const Word& w, int i) { return static_cast<Word>(w >> i << i); }
  /// Returns 2^i.
  static Word power_of_two(int i) { return static_cast<Word>(Word(1) << i); }
};

/// Returns which child, 2 i + j for offsets i in x and j in y, of a square of level `level` contains `p`.
template <class Word>
int quadrant(const Grid_point_2<Word>& p, int level, int depth) {
  using Operations = Word_operations<Word>;
  const int i = depth - 1 - level;
  return 2 * Operations::bit(p.x, i) + Operations::bit(p.y, i);
}

/// Returns the level of the smallest square that contains both points, their derived square.
template <class Word>
int level_of_derived_square(const Grid_point_2<Word>& p, const Grid_point_2<Word>& q, int depth) {
  using Operations = Word_operations<Word>;
  const int x = Operations::width_of_difference(p.x, q.x);
  const int y = Operations::width_of_difference(p.y, q.y);
  return depth - (x < y ? y : x);
}

/// Returns the lower left corner of the square of level `level` that contains `p`.
template <class Word>
Grid_point_2<Word> corner_of_square(const Grid_point_2<Word>& p, int level, int depth) {
  using Operations = Word_operations<Word>;
  return {Operations::without_low_bits(p.x, depth - level), Operations::without_low_bits(p.y, depth - level)};
}

/// Moves the lower left corner of a square to that of its child `q`, which has side 2^`log_side`.
template <class Word>
void move_to_child(Grid_point_2<Word>& corner, int q, int log_side) {
  const Word side = Word_operations<Word>::power_of_two(log_side);
  if (q / 2 == 1) corner.x += side;
  if (q % 2 == 1) corner.y += side;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_WORD_OPERATIONS_H
