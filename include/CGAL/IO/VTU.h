// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_VTU_H
#define CGAL_IO_VTU_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/IO/write_VTU.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Quadtree_mesh_2/internal/Replaced_files.h>
#include <CGAL/indexed_mesh_to_triangulation_2.h>

#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace IO {

/// Writes the mesh as an unstructured grid of VTK, for ParaView and its like, with CGAL's writer.
///
/// Cells are the triangles of the domain and the constrained edges, those outside the domain included.
/// Vertices outside the domain are in the file too.
/// \param mesh,pslg as for
/// `indexed_mesh_to_constrained_Delaunay_triangulation_2()`; the points are points of a kernel over double.
/// \param mode `IO::BINARY` or `IO::ASCII`
/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written; what was there
/// then still is; Pslg_error_2 as the conversion does. Memory and time are those of the conversion to a
/// triangulation, plus a look-up per triangle corner.
template <class Point>
void write_VTU(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               Mode mode = BINARY) {
  using Kernel = typename Kernel_traits<Point>::Kernel;
  static_assert(std::is_same_v<typename Kernel::FT, double>, "VTU files hold doubles");
  using Face_base = Delaunay_mesh_face_base_2<Kernel, Constrained_triangulation_face_base_2<Kernel>>;
  using Tds = Triangulation_data_structure_2<Triangulation_vertex_base_2<Kernel>, Face_base>;
  Constrained_Delaunay_triangulation_2<Kernel, Tds, Exact_predicates_tag> cdt;
  indexed_mesh_to_constrained_Delaunay_triangulation_2(mesh, pslg, cdt);
  std::ostringstream out;
  out.precision(17);
  write_VTU(out, std::as_const(cdt), mode);
  Quadtree_mesh_2::internal::replace_file(file_name, out.str());
}

/// Writes the mesh alone, without what the input has outside the domain.
template <class Point>
void write_VTU(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, Mode mode = BINARY) {
  write_VTU(file_name, mesh, Pslg_2<Point>(), mode);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_VTU_H
