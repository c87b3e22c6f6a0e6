// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_VTU_H
#define CGAL_IO_VTU_H

#include <CGAL/IO/io.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Vtu_writer.h>
#include <CGAL/Quadtree_mesh_2/triangle_fields.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

/// Writes the mesh as an unstructured grid of VTK, for ParaView and the like.
///
/// Points are those of the mesh, in their order, used or not. They have `marker` if the mesh has any. Cells
/// are the triangles, then the constrained edges, then the input segments of which no piece is in the mesh.
/// Cells have
/// - `region`: that of the triangle; -1 for none, and for edges
/// - `marker`: that of the edge or segment; 0 for triangles
/// - `least_angle`: in degrees
/// - `attribute`: that of the region, or 0 for none, if the graph has regions
/// - the fields
///
/// At an edge, `least_angle` and the fields have the least value of the triangles beside it. At a segment
/// outside they have the least of all. So colors range over the values of triangles. Takes linear time.
/// \param pslg the graph that the mesh was made from
/// \param fields more numbers for each triangle, see `Triangle_field_2`
/// \param mode `IO::BINARY` (appended, not compressed) or `IO::ASCII`; both give the same bits back
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`
/// \throws std::invalid_argument if a field does not have a number for each triangle
template <class Point>
void write_VTU(std::ostream& out, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               const Triangle_fields_2& fields, Mode mode = BINARY) {
  out << Quadtree_mesh_2::internal::Vtu_writer<Point>(mesh, pslg, fields).text(mode);
}
/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written. An older file of that
/// name is then unchanged.
template <class Point>
void write_VTU(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               const Triangle_fields_2& fields, Mode mode = BINARY) {
  Quadtree_mesh_2::internal::replace_file(
      file_name, Quadtree_mesh_2::internal::Vtu_writer<Point>(mesh, pslg, fields).text(mode));
}

/// Writes the mesh without further fields.
template <class Point>
void write_VTU(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               Mode mode = BINARY) {
  write_VTU(file_name, mesh, pslg, Triangle_fields_2(), mode);
}
/// Writes the mesh alone, without the parts of the input outside the domain.
template <class Point>
void write_VTU(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, Mode mode = BINARY) {
  write_VTU(file_name, mesh, Pslg_2<Point>(), mode);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_VTU_H
