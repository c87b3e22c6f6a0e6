// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_SVG_H
#define CGAL_IO_SVG_H

/// \file
/// Writes pictures of meshes as small files. Coordinates are whole numbers relative to the point before, and
/// edges are joined to long lines. Takes linear time, except for sorting the edges.

#include <CGAL/Bbox_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Svg_mesh_painter.h>
#include <CGAL/Quadtree_mesh_2/svg_options.h>

#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>

namespace CGAL {
namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Writes a picture of the mesh. Its edges are thin. The input segments are thick, inside and outside the
/// domain.
/// \param mesh `points`, `triangles` and `constrained_edges` are used.
/// \param pslg the graph that the mesh was made from.
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`.
template <class Point>
void write_SVG(std::ostream& out, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               const Svg_options_2& options = {}) {
  Quadtree_mesh_2::internal::Svg_mesh_painter<Point>(mesh, pslg, options).paint(out);
}

/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written. An older file of that
/// name is then unchanged.
template <class Point>
void write_SVG(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               const Svg_options_2& options = {}) {
  std::ostringstream out;
  write_SVG(out, mesh, pslg, options);
  Quadtree_mesh_2::internal::replace_file(file_name, out.str());
}

/// Writes a picture of the mesh with the leaves of a quadtree under its edges. The quadtree may be that of
/// the input, or one of sizes.
/// \tparam Quadtree a `Balanced_quadtree` of points of the same type
template <class Point, class Quadtree, class = typename Quadtree::Framework>
void write_SVG(std::ostream& out, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               const Quadtree& tree, const Svg_options_2& options = {}) {
  Quadtree_mesh_2::internal::Svg_mesh_painter<Point> painter(mesh, pslg, options);
  for (std::size_t l = 0; l < tree.number_of_leaves(); ++l) {
    const auto corners = tree.corners(typename Quadtree::Leaf_index(l));
    painter.add_square(corners[0], corners[2]);
  }
  painter.paint(out);
}

/// \throws std::system_error as above
template <class Point, class Quadtree, class = typename Quadtree::Framework>
void write_SVG(const std::string& file_name, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
               const Quadtree& tree, const Svg_options_2& options = {}) {
  std::ostringstream out;
  write_SVG(out, mesh, pslg, tree, options);
  Quadtree_mesh_2::internal::replace_file(file_name, out.str());
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_SVG_H
