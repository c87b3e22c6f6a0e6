// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The star of a Steiner vertex: its triangles counterclockwise, and the link around it.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_STAR_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_STAR_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Triangle i of a star has the link edge from `link[i]` to `link[i + 1]` opposite the vertex. A closed star
/// has as many link vertices as triangles (and `link[size]` repeats the first), an open one has one more.
struct Star {
  static constexpr int max_size = 28;

  int size = 0; ///< number of triangles
  bool is_closed = false;
  Vertex_id link[max_size + 1];
  Side corner[max_size]; ///< triangle, and slot of the vertex in it

  int number_of_link_vertices() const { return is_closed ? size : size + 1; }

  /// Collects the star of v, a Steiner vertex; false if it has more than `most` triangles, at most `max_size`, or
  /// goes on beyond a seam. It goes past no more than twice as many.
  template <class Geometry>
  bool collect(const Kernel_mesh<Geometry>& mesh, Vertex_id v, int most = max_size) {
    using Mesh = Kernel_mesh<Geometry>;
    size = 0;
    const Triangle_id first =
        mesh.edge(v).is_valid() ? clockwise_most(mesh, v, most) : mesh.incident_triangle(v);
    if (!first.is_valid()) return false;
    int i = Mesh::slot_of(mesh.triangle(first), v);
    for (Triangle_id t = first;;) {
      if (size == most) return false;
      const auto& r = mesh.triangle(t);
      const Side here(t, i);
      link[size] = r.v[here.slot_after()];
      corner[size++] = here;
      link[size] = r.v[here.slot_before()];
      prefetch(mesh.points.data() + link[size].value());
      const Side o = r.side[here.slot_after()];
      is_closed = !o.is_border() && o.triangle() == first;
      if (o.is_border()) return !o.is_seam();
      if (is_closed) return true;
      t = o.triangle();
      i = o.slot_after(); // the common side runs from v to the last link vertex, seen from there
    }
  }

private:
  /// None if there are more than `most` triangles, which are then the size, or a seam.
  template <class Geometry>
  Triangle_id clockwise_most(const Kernel_mesh<Geometry>& mesh, Vertex_id v, int most) {
    const Triangle_id start = mesh.incident_triangle(v);
    Triangle_id t = start;
    for (int passed = 0; passed < most; ++passed) {
      const auto& r = mesh.triangle(t);
      const Side o = r.side[previous_slot[Kernel_mesh<Geometry>::slot_of(r, v)]];
      if (o.is_border()) return o.is_seam() ? Triangle_id() : t;
      t = o.triangle();
      if (t == start) return t;
    }
    size = most;
    return {};
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_STAR_H
