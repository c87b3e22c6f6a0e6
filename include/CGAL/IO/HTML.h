// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_HTML_H
#define CGAL_IO_HTML_H

/// \file
/// Writes pages that show meshes in browsers: one file each, which asks for no other.

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/html_options.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/page/Page_writer.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Writes the mesh as a page that one can pan and zoom.
///
/// Its menu has what colors stand for, with a histogram: the least angle, the largest one, the longest edge,
/// or the region. It shows or hides edges, the segments of the input, a quadtree, and marks at triangles that
/// miss a bound. The triangle under the pointer tells its numbers and vertices, which count from
/// `Pslg_2::first_number`. Coordinates are there bit for bit. The page draws by WebGL, or without it where
/// there is none.
///
/// The file has about 28 bytes for each triangle, and 55 KB. Takes linear time.
/// \param pslg the graph that the mesh was made from
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`.
/// \throws std::invalid_argument if options name a triangle that the mesh has not, or have coordinates, but not for
/// each vertex
template <class Point>
void write_HTML(std::ostream& out, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                const Html_options_2& options = {}) {
  out << Quadtree_mesh_2::internal::Page_writer<Point>(mesh, pslg, options).text();
}

/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written. An older file of that
/// name is then unchanged.
template <class Point>
void write_HTML(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                const Html_options_2& options = {}) {
  Quadtree_mesh_2::internal::replace_file(
      file_name, Quadtree_mesh_2::internal::Page_writer<Point>(mesh, pslg, options).text());
}

/// Writes a page that can show a quadtree, too: that of the input, or one of sizes.
/// \tparam Quadtree a `Balanced_quadtree` of points of any type
template <class Point, class Quadtree, class = typename Quadtree::Framework>
void write_HTML(std::ostream& out, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                const Quadtree& tree, const Html_options_2& options = {}) {
  Quadtree_mesh_2::internal::Page_writer<Point> writer(mesh, pslg, options);
  writer.add_quadtree(tree);
  out << writer.text();
}

/// \throws std::system_error as above
template <class Point, class Quadtree, class = typename Quadtree::Framework>
void write_HTML(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                const Quadtree& tree, const Html_options_2& options = {}) {
  Quadtree_mesh_2::internal::Page_writer<Point> writer(mesh, pslg, options);
  writer.add_quadtree(tree);
  Quadtree_mesh_2::internal::replace_file(file_name, writer.text());
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_HTML_H
