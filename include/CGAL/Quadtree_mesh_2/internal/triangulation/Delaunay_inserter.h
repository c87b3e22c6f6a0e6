// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Inserts vertices into a Delaunay triangulation, or into a block of one. A walk from a nearby triangle
// locates each vertex, and Lawson's flips follow. Orientation is exact. Flips are made only where the
// in-circle test is certain.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_DELAUNAY_INSERTER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_DELAUNAY_INSERTER_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/walk.h>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Delaunay_inserter {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Point = typename Geometry::Point;

  explicit Delaunay_inserter(Mesh& mesh) : mesh_(mesh) {}

  /// Inserts a vertex that is in no triangle yet, by a walk from triangle `hint`.
  /// \returns the vertex that stands for it: itself, the one at the same place, or none if a seam is in the way.
  Vertex_id insert(Vertex_id v, Triangle_id hint) {
    const Point p = mesh_.point(v);
    const Walk_end end = locate_exactly(mesh_, hint, p);
    if (end.is_blocked()) return {};
    const auto& r = mesh_.triangle(end.triangle);
    int on_slot = -1;
    for (int k = 0; k < 3; ++k) {
      if (mesh_.point(r.v[k]) == p) return r.v[k];
      if (Geometry::orientation(mesh_.point(r.v[next_slot[k]]), mesh_.point(r.v[previous_slot[k]]), p) == 0)
        on_slot = k;
    }
    if (on_slot < 0)
      mesh_.insert_in_triangle(end.triangle, v);
    else if (r.side[on_slot].is_seam())
      return {};
    else
      mesh_.insert_on_side(end.triangle, on_slot, v);
    return v;
  }

private:
  Mesh& mesh_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_DELAUNAY_INSERTER_H
