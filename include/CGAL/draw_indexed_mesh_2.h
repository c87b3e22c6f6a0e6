// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_DRAW_INDEXED_MESH_2_H
#define CGAL_DRAW_INDEXED_MESH_2_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/viewer/show_scene.h>
#include <CGAL/edges_of_mesh_2.h>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// Shows a mesh in a window, until that is closed: its triangles, its edges, and in red its constrained edges.
///
/// This is \cgal's basic viewer, for which a program defines `CGAL_USE_BASIC_VIEWER` and links
/// `CGAL::CGAL_Basic_viewer` (\cgal 6) or `CGAL::CGAL_Qt5`; the viewer is under the GPL. Without it, `std::cerr` gets a
/// line that says so. `IO::write_HTML()` needs no viewer but a browser. O(n log n) time for n triangles.
/// \param title of the window
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`.
template <class Point>
void draw(const Indexed_mesh_2<Point>& mesh, const char* title = "Mesh") {
  using Quadtree_mesh_2::internal::as_double;
  using Viewer_point = Exact_predicates_inexact_constructions_kernel::Point_2;
  const auto place = [&mesh](Quadtree_mesh_2::Vertex_index v) {
    return Viewer_point(as_double(mesh.point(v).x()), as_double(mesh.point(v).y()));
  };
  const auto fill = [&](auto& scene) {
    // The lights of the viewer make colors half as bright again.
    for (const auto& triangle : mesh.triangles) {
      scene.face_begin(IO::Color(85, 120, 145));
      for (const auto v : triangle) scene.add_point_in_face(place(v));
      scene.face_end();
    }
    for (const Mesh_edge_2& edge : edges_of_mesh_2(mesh))
      scene.add_segment(place(edge.vertices[0]), place(edge.vertices[1]));
    for (const auto& edge : mesh.constrained_edges)
      scene.add_segment(place(edge.vertices[0]), place(edge.vertices[1]), IO::Color(178, 24, 43));
  };
  Quadtree_mesh_2::internal::show_scene(fill, title);
}

} // namespace CGAL

#endif // CGAL_DRAW_INDEXED_MESH_2_H
