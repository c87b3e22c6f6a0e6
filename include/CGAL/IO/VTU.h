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
#include <CGAL/Quadtree_mesh_2/internal/file_parts/Pvtu_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Vtu_writer.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>
#include <CGAL/Quadtree_mesh_2/triangle_fields.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Writes the mesh as an unstructured grid of VTK, for ParaView and the like.
///
/// Points are those of the mesh, in their order, used or not. They have `marker` if the mesh has any. If it
/// is renumbered, they have `input_index`, -1 for Steiner vertices. Cells
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
/// \param order of second order, triangles and constrained edges are quadratic cells, with a node in the middle of each
/// side. Nodes follow the points of the mesh. Constrained edges then have to be sides of triangles.
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`
/// \throws std::invalid_argument if a field does not have a number for each triangle
template <class Point>
void write_VTU(std::ostream& out, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               const Triangle_fields_2& fields, Mode mode = BINARY,
               Element_order order = Element_order::FIRST) {
  out << Quadtree_mesh_2::internal::vtu_text(mesh, pslg, fields, mode, order);
}
/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written. An older file of that
/// name is then unchanged.
template <class Point>
void write_VTU(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               const Triangle_fields_2& fields, Mode mode = BINARY,
               Element_order order = Element_order::FIRST) {
  Quadtree_mesh_2::internal::replace_file(
      file_name, Quadtree_mesh_2::internal::vtu_text(mesh, pslg, fields, mode, order));
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

/// Writes the mesh in pieces, for meshes that are larger than a viewer or a solver wants in one file: `mesh_1.vtu`,
/// `mesh_2.vtu` and so on beside `mesh.pvtu`, which names them.
///
/// Pieces are runs of triangles in the order of the mesh, all of the same length, so they are compact after
/// `renumber_by_place()`. Constrained edges are in the piece of the first triangle beside them. What has no triangle,
/// vertices and segments outside, is in the last piece. Vertices of several pieces are in each of them. Data are as in
/// one file, besides `GlobalPointIds` and `GlobalCellIds`, the numbers that points and cells have there. One piece is
/// in memory at a time. O(n log n).
/// \param file_name ends in `.pvtu`
/// \param pieces their number; 0 for one for each 2^20 triangles. There are never more than triangles.
/// \throws std::system_error (a `std::runtime_error`) naming the file that cannot be written; then none is, and older
/// files of these names are unchanged. Further pieces of an older mesh stay where they are.
/// \throws std::invalid_argument if a field does not have a number for each triangle
template <class Point>
void write_PVTU(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                std::size_t pieces = 0, const Triangle_fields_2& fields = {}, Mode mode = BINARY) {
  Quadtree_mesh_2::internal::Replaced_files files;
  Quadtree_mesh_2::internal::add_pvtu_files(files, file_name, mesh, pslg, fields, pieces, mode);
  files.commit();
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_VTU_H
