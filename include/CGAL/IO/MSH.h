// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_MSH_H
#define CGAL_IO_MSH_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/file_parts/Msh_parts_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Msh_2_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Msh_version.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Msh_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
std::string msh_text(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg, IO::Msh_version version,
                     IO::Element_order order) {
  return version == IO::Msh_version::V2_2 ? Msh_2_writer<Point>(mesh, pslg, order).text()
                                          : Msh_writer<Point>(mesh, pslg, order).text();
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Writes a mesh as text in Gmsh's format MSH, version 4.1 or 2.2.
///
/// Regions and markers become entities and physical groups of the same number, with a name:
/// - Region `r` is surface and group `r + 1`, called "region r", or "region r, attribute a" if the graph is
///   given. Triangles in no region come after that, as "no region". If there are no regions, everything is
///   "domain".
/// - The constrained edges with one marker `m` are a curve, "marker m", and group `m`. Numbers of groups have
///   to be positive, so other markers get the numbers after the largest.
///
/// Node `i + 1` is vertex `i`, used or not. Element `e + 1` is constrained edge `e`; the triangles follow. If the mesh
/// is renumbered, the view "input_index" has the nodes' indices in the input, -1 for Steiner vertices.
/// Takes linear time, except for sorting by markers.
/// \param pslg the graph that the mesh was made from
/// \param version of the format
/// \param order of second order, triangles have six nodes and edges three. The nodes in the middle of sides follow the
/// vertices. Constrained edges then have to be sides of triangles.
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`
template <class Point>
void write_MSH(std::ostream& out, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               Msh_version version = Msh_version::V4_1, Element_order order = Element_order::FIRST) {
  out << Quadtree_mesh_2::internal::msh_text(mesh, pslg, version, order);
}
/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written. An older file of that
/// name is then unchanged.
template <class Point>
void write_MSH(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               Msh_version version = Msh_version::V4_1, Element_order order = Element_order::FIRST) {
  Quadtree_mesh_2::internal::replace_file(file_name,
                                          Quadtree_mesh_2::internal::msh_text(mesh, pslg, version, order));
}

/// Writes a mesh without its graph, in MSH 4.1. Names have no attributes.
template <class Point>
void write_MSH(std::ostream& out, const Indexed_mesh_2<Point>& mesh) {
  write_MSH(out, mesh, Pslg_2<Point>());
}
/// \throws std::system_error as above
template <class Point>
void write_MSH(const std::string& file_name, const Indexed_mesh_2<Point>& mesh) {
  write_MSH(file_name, mesh, Pslg_2<Point>());
}

/// Writes a mesh in parts, as Gmsh does with `Mesh.PartitionSplitMeshFiles`: `mesh_1.msh`, `mesh_2.msh` and so on for
/// "mesh.msh", which itself is not written.
///
/// Part `p` has a run of triangles in the order of the mesh, all of the same length, so parts are compact after
/// `renumber_by_place()`; the constrained edges whose first triangle it has; and as ghosts one layer of other parts'
/// triangles, those that have a vertex with its own in common, with their owners. Vertices that nothing uses are in the
/// last part. Nodes and elements have the numbers that they have in the file of the whole mesh. Physical groups are the
/// same; entities of parts have those of the mesh as parents. One part is in memory at a time. O(n log n).
/// \param file_name ends in `.msh`
/// \param parts their number, at least 1. There are never more than triangles.
/// \throws std::system_error naming the file that cannot be written; then none is, and older files of these names are
/// unchanged. Further parts of an older mesh stay where they are.
template <class Point>
void write_MSH_parts(const std::string& file_name, const Indexed_mesh_2<Point>& mesh,
                     const Pslg_2<Point>& pslg, std::size_t parts) {
  Quadtree_mesh_2::internal::Replaced_files files;
  Quadtree_mesh_2::internal::Msh_parts_writer<Point>(mesh, pslg, parts).add_to(files, file_name);
  files.commit();
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_MSH_H
