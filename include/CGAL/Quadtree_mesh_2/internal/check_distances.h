// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What is near in a triangulated graph: what coordinates cannot tell apart is refused, what quadtrees cannot is noted.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECK_DISTANCES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECK_DISTANCES_H

#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Input_words.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/least_distance.h>

#include <optional>
#include <string>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Bounds the legs by the least distance, too, where coordinates are unlimited. O(n).
/// \tparam Map of coordinates
/// \returns the error for who wants quadtrees, if they could not tell vertices apart
/// \throws Pslg_error_2 if vertices are nearer to each other, or to segments, than the doubles can tell in which
/// angles are compared
template <class Map, class Geometry, class Point>
std::optional<Pslg_error_2> check_distances(Meshing_state<Geometry>& state, const Input_words<Point>& words) {
  if constexpr (Geometry::has_unlimited_coordinates) {
    // Coordinates are unlimited, and so are the distances that an input may have. Nothing in the way of a leg is
    // nearer than a small share of the least one.
    constexpr double clearance = 0x1p-34; // squared
    state.problem.least_share_of_leg = sqrt(clearance * least_squared_distance(state.mesh));
    if (const auto* near = find_too_near(state.mesh))
      return words.too_near(
          near->v,
          ", nearer to each other, or to being on a line, than the 2^-128 of the extent that quadtrees "
          "can tell: refine without them");
  } else if constexpr (Geometry::least_length > 0) {
    if (const auto* near = find_too_near(state.mesh))
      throw words.too_near(near->v, std::string(": nearer to each other, or to being on a line, than ") +
                                        Map::least_distance);
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECK_DISTANCES_H
