// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_DIRECTION_H
#define CGAL_QUADTREE_MESH_2_DIRECTION_H

#include <array>
#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// The eight directions to the neighbors of a square, counterclockwise: across sides and corners in turn.
enum class Direction {
  EAST,       ///< across the right side
  NORTH_EAST, ///< across the upper right corner
  NORTH,      ///< across the upper side
  NORTH_WEST, ///< across the upper left corner
  WEST,       ///< across the left side
  SOUTH_WEST, ///< across the lower left corner
  SOUTH,      ///< across the lower side
  SOUTH_EAST  ///< across the lower right corner
};

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// All directions, counterclockwise from east.
constexpr std::array<Direction, 8> all_directions() {
  return {{Direction::EAST, Direction::NORTH_EAST, Direction::NORTH, Direction::NORTH_WEST, Direction::WEST,
           Direction::SOUTH_WEST, Direction::SOUTH, Direction::SOUTH_EAST}};
}

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Returns the step in x, -1, 0 or 1, of a direction.
constexpr int step_x(Direction d) {
  return d == Direction::NORTH || d == Direction::SOUTH             ? 0
         : d >= Direction::NORTH_WEST && d <= Direction::SOUTH_WEST ? -1
                                                                    : 1;
}

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Returns the step in y, -1, 0 or 1, of a direction.
constexpr int step_y(Direction d) {
  return d == Direction::EAST || d == Direction::WEST ? 0 : d < Direction::WEST ? 1 : -1;
}

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Returns the opposite direction.
constexpr Direction opposite(Direction d) { return static_cast<Direction>((static_cast<int>(d) + 4) % 8); }

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Returns whether a direction leads across a corner.
constexpr bool is_diagonal(Direction d) { return static_cast<int>(d) % 2 != 0; }

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Returns the direction with the given steps.
/// \pre steps are -1, 0 or 1 and not both 0
constexpr Direction direction(int dx, int dy) {
  return dx > 0   ? (dy > 0   ? Direction::NORTH_EAST
                     : dy < 0 ? Direction::SOUTH_EAST
                              : Direction::EAST)
         : dx < 0 ? (dy > 0   ? Direction::NORTH_WEST
                     : dy < 0 ? Direction::SOUTH_WEST
                              : Direction::WEST)
                  : (dy > 0 ? Direction::NORTH : Direction::SOUTH);
}

} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_DIRECTION_H
