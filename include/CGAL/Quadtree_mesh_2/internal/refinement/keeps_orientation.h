// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Whether a side of a mesh may be split at a point: rounding may have put it beside the edge.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_KEEPS_ORIENTATION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_KEEPS_ORIENTATION_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Whether both parts of the triangle at a side keep their orientation if the side is split at p. Its parts have to be
/// so long that this does not depend on rounding.
template <class Geometry>
bool keeps_orientation_of_one(const Kernel_mesh<Geometry>& mesh, Side s, const typename Geometry::Point& p) {
  const auto& apex = mesh.point(mesh.opposite(s));
  for (const Vertex_id end : {mesh.source(s), mesh.target(s)})
    if (!Geometry::is_resolved(p, squared_length(Geometry::scaled_difference(mesh.point(end), p))))
      return false;
  return Geometry::orientation(apex, mesh.point(mesh.source(s)), p) > 0 &&
         Geometry::orientation(apex, p, mesh.point(mesh.target(s))) > 0;
}

/// The same for the triangles on both sides of the edge.
template <class Geometry>
bool keeps_orientation(const Kernel_mesh<Geometry>& mesh, Side s, const typename Geometry::Point& p) {
  const Side o = mesh.across(s);
  return keeps_orientation_of_one(mesh, s, p) && (o.is_border() || keeps_orientation_of_one(mesh, o, p));
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_KEEPS_ORIENTATION_H
