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

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>

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

/// Whether a triangle has a side or a height below `Geometry::least_length`.
template <class Geometry>
bool is_too_near(const Kernel_mesh<Geometry>& mesh, const typename Kernel_mesh<Geometry>::Triangle& t) {
  constexpr double least = Geometry::least_length * Geometry::least_length;
  if (!t.v[0].is_valid()) return false;
  const auto s =
      Geometry::has_unlimited_coordinates ? mesh.shape(t) : mesh.shape_of_flat(t.v[0], t.v[1], t.v[2]);
  return !(s.shortest() >= least && s.area2 * s.area2 >= least * s.longest());
}

/// \returns the first triangle with a side or a height below `Geometry::least_length`; null if there is none
template <class Geometry>
const typename Kernel_mesh<Geometry>::Triangle* find_too_near(const Kernel_mesh<Geometry>& mesh) {
  const std::size_t n = mesh.triangles.size();
  const std::size_t first = reduce<Chosen_tag>(
      n, n,
      [&](std::size_t begin, std::size_t end) {
        for (const Triangle_id t : Id_range<Triangle_id>(begin, end))
          if (is_too_near(mesh, mesh.triangle(t))) return std::size_t(t);
        return n;
      },
      [](std::size_t a, std::size_t b) { return std::min(a, b); });
  return first == n ? nullptr : &mesh.triangle(static_cast<Triangle_id>(first));
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_LEAST_DISTANCE_H
