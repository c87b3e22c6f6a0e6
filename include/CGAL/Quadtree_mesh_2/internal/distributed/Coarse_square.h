// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Squares as p4est has them: of at most 29 levels, with numbers along the shuffle order.
//
// A grid of 2^62 units has levels 0 to 62. p4est's squares have coordinates of 30 bits, the upper ones of the grid's,
// and levels up to 29. So what is below level 29 is not p4est's.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_COARSE_SQUARE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_COARSE_SQUARE_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>

#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The depth of the grids whose squares these are.
constexpr int fine_depth = 62;
/// How many bits the coordinates of coarse squares have.
constexpr int coarse_depth = 30;
/// The level of the smallest coarse squares.
constexpr int last_coarse_level = 29;

/// The number of a place along the shuffle order: those of a square follow each other.
using Coarse_code = std::uint64_t;

/// The number of places in a square, which is behind the last place for level 0.
constexpr Coarse_code codes_of_level(int level) { return Coarse_code(1) << 2 * (coarse_depth - level); }
constexpr Coarse_code code_behind_all() { return codes_of_level(0); }

inline Coarse_code coarse_code(const Grid_point_2<std::uint64_t>& place) {
  constexpr int shift = fine_depth - coarse_depth;
  return interleave(static_cast<std::uint32_t>(place.x >> shift),
                    static_cast<std::uint32_t>(place.y >> shift));
}

/// Bits of a code at even places, the lowest first.
constexpr std::uint32_t even_bits(std::uint64_t code) {
  std::uint64_t x = code & 0x5555555555555555u;
  x = (x | (x >> 1)) & 0x3333333333333333u;
  x = (x | (x >> 2)) & 0x0f0f0f0f0f0f0f0fu;
  x = (x | (x >> 4)) & 0x00ff00ff00ff00ffu;
  x = (x | (x >> 8)) & 0x0000ffff0000ffffu;
  return static_cast<std::uint32_t>(x | (x >> 16));
}

struct Coarse_square {
  Coarse_code code; ///< of its lower left corner
  int level;

  /// One past its last place.
  Coarse_code end() const { return code + codes_of_level(level); }
  Coarse_square child(int q) const {
    return {code + static_cast<Coarse_code>(q) * codes_of_level(level + 1), level + 1};
  }
  /// The square of a level that has a place.
  static Coarse_square around(Coarse_code place, int at_level) {
    return {place & ~(codes_of_level(at_level) - 1), at_level};
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_COARSE_SQUARE_H
