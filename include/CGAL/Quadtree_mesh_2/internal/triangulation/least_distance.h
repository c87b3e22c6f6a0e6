// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// How near features of the input are to each other. In a constrained Delaunay triangulation, the least distance of two
// vertices, or of a vertex and a segment that it sees, is a side or a height of a triangle. O(n).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_LEAST_DISTANCE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_LEAST_DISTANCE_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The square of the least distance, or 1, if that is less.
template <class Geometry>
typename Geometry::Number least_squared_distance(const Kernel_mesh<Geometry>& mesh) {
  typename Geometry::Number least = 1;
  for (const auto& t : mesh.triangles) {
    if (!t.v[0].is_valid()) continue;
    const auto s = mesh.shape(t);
    least = std::min({least, s.shortest(), s.area2 * s.area2 / s.longest()});
  }
  return least;
}

/// \returns the first triangle with a side or a height below `Geometry::least_length`; null if there is none
template <class Geometry>
const typename Kernel_mesh<Geometry>::Triangle* find_too_near(const Kernel_mesh<Geometry>& mesh) {
  constexpr double least = Geometry::least_length * Geometry::least_length;
  for (const auto& t : mesh.triangles) {
    if (!t.v[0].is_valid()) continue;
    const auto s =
        Geometry::has_unlimited_coordinates ? mesh.shape(t) : mesh.shape_of_flat(t.v[0], t.v[1], t.v[2]);
    if (!(s.shortest() >= least && s.area2 * s.area2 >= least * s.longest())) return &t;
  }
  return nullptr;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_LEAST_DISTANCE_H
