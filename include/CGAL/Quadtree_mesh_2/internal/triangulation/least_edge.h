// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Whether a place for a new vertex is far enough from the vertices in sight of it.
//
// The edges that an insertion makes go to the vertices of certain triangles: those whose circles hold the
// place and that are reached from it without crossing a constrained side (Lawson, 1977). The nearest vertex
// in sight is among them. So only these vertices are looked at. O(size of the cavity), a constant on average.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_LEAST_EDGE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_LEAST_EDGE_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Cavity.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <initializer_list>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Whether a vertex at q, inside the first of `holders` or on the side that both share, is no nearer than the
/// root of `least` to any other one it would be joined with. Invalid handles among the holders do not count.
template <class Geometry>
bool has_room(const Kernel_mesh<Geometry>& mesh, std::initializer_list<Triangle_id> holders,
              const typename Geometry::Point& q, double least) {
  if (least <= 0) return true;
  return Cavity<Geometry>(mesh).visit_sides(holders, q, [&](Side s) {
    return squared_length(Geometry::scaled_difference(mesh.point(mesh.opposite(s)), q)) >= least &&
           !mesh.across(s).is_seam(); // nobody knows what lies beyond
  });
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_LEAST_EDGE_H
