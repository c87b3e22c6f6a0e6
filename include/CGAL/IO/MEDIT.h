// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_MEDIT_H
#define CGAL_IO_MEDIT_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>

#include <cstddef>
#include <ostream>
#include <string>

// Writes .mesh files of MEDIT in two dimensions, for Mmg, FreeFEM and the like. Coordinates have the fewest
// digits that give the same bits back. Takes linear time.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
std::string medit_text(const Indexed_mesh_2<Point>& mesh) {
  const auto from_1 = [](Vertex_index v) { return std::size_t(v) + 1; };
  Line_writer out;
  out.reserve(45 * mesh.points.size() + 26 * mesh.triangles.size() + 24 * mesh.constrained_edges.size() +
              128);
  (out << "MeshVersionFormatted 2").end_line(); // doubles
  (out << "Dimension 2").end_line();
  (out << "Vertices").end_line();
  (out << mesh.points.size()).end_line();
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    (out.write_point(mesh.points[v]) << mesh.marker(Vertex_index(v))).end_line();
  (out << "Edges").end_line();
  (out << mesh.constrained_edges.size()).end_line();
  for (const auto& e : mesh.constrained_edges)
    (out << from_1(e.vertices[0]) << from_1(e.vertices[1]) << e.marker).end_line();
  (out << "Triangles").end_line();
  (out << mesh.triangles.size()).end_line();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const int region = mesh.region_of_triangle.empty() ? -1 : mesh.region_of_triangle[t];
    (out << from_1(a) << from_1(b) << from_1(c) << region + 1).end_line();
  }
  (out << "End").end_line();
  return out.take();
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Writes a mesh as a `.mesh` file of MEDIT in two dimensions.
///
/// The file has all points in their order, used or not, with their markers as references. It has the
/// constrained edges with theirs. Triangles have the numbers of their regions, counted from 1, or 0 for none.
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`
template <class Point>
void write_MEDIT(std::ostream& out, const Indexed_mesh_2<Point>& mesh) {
  out << Quadtree_mesh_2::internal::medit_text(mesh);
}
/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written. An older file of that
/// name is then unchanged.
template <class Point>
void write_MEDIT(const std::string& file_name, const Indexed_mesh_2<Point>& mesh) {
  Quadtree_mesh_2::internal::replace_file(file_name, Quadtree_mesh_2::internal::medit_text(mesh));
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_MEDIT_H
