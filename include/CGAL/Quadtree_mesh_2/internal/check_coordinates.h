// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECK_COORDINATES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECK_COORDINATES_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Input_words.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/part_names.h>

#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// \throws Pslg_error_2 if a vertex or a seed is another one when it comes back from the kernel.
template <class Point, class Map>
void check_points_are_kept(const Pslg_2<Point>& pslg, const Map& map, const Input_words<Point>& words) {
  if (map.are_kept()) return;
  for (std::size_t v = 0; v < pslg.number_of_vertices(); ++v)
    if (!map.is_kept(pslg.vertices[v]))
      throw words.out_of_range(words.vertex(v), Map::loss_of_point, Pslg_parts_2().vertex(Vertex_index(v)));
  for (std::size_t h = 0; h < pslg.holes.size(); ++h)
    if (!map.is_kept(pslg.holes[h]))
      throw words.out_of_range("the point of " + hole_text(pslg, h), Map::loss_of_point,
                               Pslg_parts_2().hole(h));
  for (std::size_t r = 0; r < pslg.regions.size(); ++r)
    if (!map.is_kept(pslg.regions[r].point))
      throw words.out_of_range("the point of " + region_text(pslg, r), Map::loss_of_point,
                               Pslg_parts_2().region(r));
}

/// \throws Pslg_error_2 if a triangle is not counterclockwise any more after rounding to the user's coordinates.
template <class Geometry, class Point, class Map>
void check_mesh_is_kept(const Indexed_mesh_2<Point>& mesh, const Map& map) {
  if (!map.may_round_mesh()) return;
  for (const auto& t : mesh.triangles)
    if (Geometry::orientation(map.to_kernel(mesh.point(t[0])), map.to_kernel(mesh.point(t[1])),
                              map.to_kernel(mesh.point(t[2]))) <= 0)
      throw Pslg_error_2(Pslg_error_2::Kind::ROUNDING, Map::loss_of_mesh);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECK_COORDINATES_H
