// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_MSH_H
#define CGAL_IO_MSH_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Msh_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

/// Writes a mesh as text in Gmsh's format MSH 4.1.
///
/// Regions and markers become entities and physical groups of the same number, with a name:
/// - Region `r` is surface and group `r + 1`, called "region r", or "region r, attribute a" if the graph is
///   given. Triangles in no region come after that, as "no region". If there are no regions, everything is
///   "domain".
/// - The constrained edges with one marker `m` are a curve, "marker m", and group `m`. Numbers of groups have
///   to be positive, so other markers get the numbers after the largest.
///
/// Node `i + 1` is vertex `i`, used or not. Element `e + 1` is constrained edge `e`; the triangles follow.
/// Takes linear time, except for sorting by markers.
/// \param pslg the graph that the mesh was made from
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`
template <class Point>
void write_MSH(std::ostream& out, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg) {
  out << Quadtree_mesh_2::internal::Msh_writer<Point>(mesh, pslg).text();
}
/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written. An older file of that
/// name is then unchanged.
template <class Point>
void write_MSH(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg) {
  Quadtree_mesh_2::internal::replace_file(file_name,
                                          Quadtree_mesh_2::internal::Msh_writer<Point>(mesh, pslg).text());
}

/// Writes a mesh without its graph. Names have no attributes.
template <class Point>
void write_MSH(std::ostream& out, const Indexed_mesh_2<Point>& mesh) {
  write_MSH(out, mesh, Pslg_2<Point>());
}
/// \throws std::system_error as above
template <class Point>
void write_MSH(const std::string& file_name, const Indexed_mesh_2<Point>& mesh) {
  write_MSH(file_name, mesh, Pslg_2<Point>());
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_MSH_H
