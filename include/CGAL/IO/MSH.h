// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_MSH_H
#define CGAL_IO_MSH_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Msh_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/Replaced_files.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

/// Writes a mesh as text in Gmsh's format MSH 4.1.
///
/// Regions and markers become entities and physical groups of the same number, with a name that always tells which:
/// region `r` is surface and group `r + 1`, "region r", or "region r, attribute a" if the graph is given; what is in no
/// region comes behind, as "no region"; without any region all is "domain". The constrained edges with one marker are a
/// curve, "marker m", and group `m`; those with markers that are not positive, which groups have to be, get the numbers
/// behind the largest. Node `i + 1` is vertex `i`, used or not; element `e + 1` is constrained edge `e`, then come the
/// triangles. Linear in the mesh, but for sorting by markers.
/// \param pslg what the mesh was made from
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`
template <class Point>
void write_MSH(std::ostream& out, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg) {
  out << Quadtree_mesh_2::internal::Msh_writer<Point>(mesh, pslg).text();
}
/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written; what was there then
/// still is.
template <class Point>
void write_MSH(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg) {
  Quadtree_mesh_2::internal::replace_file(file_name,
                                          Quadtree_mesh_2::internal::Msh_writer<Point>(mesh, pslg).text());
}

/// Writes a mesh alone; names have no attributes.
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
