// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_ADCIRC_H
#define CGAL_IO_ADCIRC_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Flow_grid_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Writes a mesh as a grid of ADCIRC, `fort.14`.
///
/// Depths are 0, and there are no open boundaries: the border is land. Each outer loop is a boundary of type 0,
/// counterclockwise, and each island one of type 1, clockwise, both closed by repeating their first nodes. Where loops
/// touch, each is simple.
///
/// Models refuse nodes without elements, so vertices that no triangle uses are left out; the others keep their order.
/// Regions and markers are not written. O(T log d) for T triangles and at most d of them at a vertex.
/// \pre triangles are counterclockwise, and sides are between at most two
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`
template <class Point>
void write_ADCIRC(std::ostream& out, const Indexed_mesh_2<Point>& mesh) {
  using namespace Quadtree_mesh_2::internal;
  out << Flow_grid_writer<Point>(mesh, Flow_grid_kind::ADCIRC).text();
}
/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written. An older file of that
/// name is then unchanged.
template <class Point>
void write_ADCIRC(const std::string& file_name, const Indexed_mesh_2<Point>& mesh) {
  using namespace Quadtree_mesh_2::internal;
  replace_file(file_name, Flow_grid_writer<Point>(mesh, Flow_grid_kind::ADCIRC).text());
}

/// Writes a mesh as a grid of SCHISM, `hgrid.gr3`.
///
/// As for ADCIRC, but loops are closed in another way, as SCHISM's manual has it: without open boundaries an outer loop
/// is two land boundaries, each of which begins where the other ends; and the first node of an island is not repeated.
template <class Point>
void write_GR3(std::ostream& out, const Indexed_mesh_2<Point>& mesh) {
  using namespace Quadtree_mesh_2::internal;
  out << Flow_grid_writer<Point>(mesh, Flow_grid_kind::SCHISM).text();
}
/// \throws std::system_error as above
template <class Point>
void write_GR3(const std::string& file_name, const Indexed_mesh_2<Point>& mesh) {
  using namespace Quadtree_mesh_2::internal;
  replace_file(file_name, Flow_grid_writer<Point>(mesh, Flow_grid_kind::SCHISM).text());
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_ADCIRC_H
