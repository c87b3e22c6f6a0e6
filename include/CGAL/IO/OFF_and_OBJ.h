// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_OFF_AND_OBJ_H
#define CGAL_IO_OFF_AND_OBJ_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>

#include <cstddef>
#include <ostream>
#include <string>

// Writes surfaces with z = 0, for programs that know meshes in space. Coordinates have the fewest digits that
// give the same bits back. Takes linear time.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
std::string off_text(const Indexed_mesh_2<Point>& mesh) {
  Line_writer out;
  out.reserve(45 * mesh.points.size() + 24 * mesh.triangles.size() + 64);
  (out << "OFF").end_line();
  (out << mesh.points.size() << mesh.triangles.size() << 0).end_line();
  for (const Point& p : mesh.points) (out.write_point(p) << 0).end_line();
  for (const auto& t : mesh.triangles) (out << 3 << t[0] << t[1] << t[2]).end_line();
  return out.take();
}

template <class Point>
std::string obj_text(const Indexed_mesh_2<Point>& mesh) {
  Line_writer out;
  out.reserve(45 * mesh.points.size() + 24 * mesh.triangles.size() + 64);
  for (const Point& p : mesh.points) ((out << "v").write_point(p) << 0).end_line();
  const auto from_1 = [](Vertex_index v) { return std::size_t(v) + 1; };
  for (const auto& t : mesh.triangles)
    (out << "f" << from_1(t[0]) << from_1(t[1]) << from_1(t[2])).end_line();
  return out.take();
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Writes all points of a mesh, in their order, used or not, and its triangles to an OFF file. The format has
/// nothing else.
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`
template <class Point>
void write_OFF(std::ostream& out, const Indexed_mesh_2<Point>& mesh) {
  out << Quadtree_mesh_2::internal::off_text(mesh);
}
/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written. An older file of that
/// name is then unchanged.
template <class Point>
void write_OFF(const std::string& file_name, const Indexed_mesh_2<Point>& mesh) {
  Quadtree_mesh_2::internal::replace_file(file_name, Quadtree_mesh_2::internal::off_text(mesh));
}

/// Writes the same to an OBJ file of Wavefront.
template <class Point>
void write_OBJ(std::ostream& out, const Indexed_mesh_2<Point>& mesh) {
  out << Quadtree_mesh_2::internal::obj_text(mesh);
}
/// \throws std::system_error as `write_OFF()` does
template <class Point>
void write_OBJ(const std::string& file_name, const Indexed_mesh_2<Point>& mesh) {
  Quadtree_mesh_2::internal::replace_file(file_name, Quadtree_mesh_2::internal::obj_text(mesh));
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_OFF_AND_OBJ_H
