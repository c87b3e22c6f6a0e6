// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_TRIANGLE_TOWARD_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_TRIANGLE_TOWARD_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Returns the triangle at v that the ray from v to p begins in, of those connected to a triangle at v; none if the ray
/// begins outside of them.
template <class Geometry>
Triangle_id triangle_toward(const Kernel_mesh<Geometry>& mesh, Vertex_id v, Triangle_id start,
                            const typename Geometry::Point& p) {
  Fan_walk<Kernel_mesh<Geometry>> fan(mesh, v, start);
  do {
    const auto& r = mesh.triangle(fan.triangle());
    if (Geometry::orientation(mesh.point(v), mesh.point(r.v[next_slot[fan.slot()]]), p) >= 0 &&
        Geometry::orientation(mesh.point(v), mesh.point(r.v[previous_slot[fan.slot()]]), p) <= 0)
      return fan.triangle();
  } while (fan.advance());
  return {};
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_TRIANGLE_TOWARD_H
