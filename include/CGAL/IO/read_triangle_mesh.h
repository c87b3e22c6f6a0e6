// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_READ_TRIANGLE_MESH_H
#define CGAL_IO_READ_TRIANGLE_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_triangle_files.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/given_mesh_types.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_scanner.h>
#include <CGAL/Quadtree_mesh_2/internal/io/read_whole_file.h>
#include <CGAL/pslg_from_mesh_2.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// Reads meshes from files of Jonathan Shewchuk's Triangle, to be refined: .node, .ele, .poly and .area.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Triangle_point = Exact_predicates_inexact_constructions_kernel::Point_2;

/// The segments of a .poly file, whose vertices are those of a .node file; all else in it is ignored.
inline void read_segments_of_mesh(const std::string& name, const Pslg_2<Triangle_point>& nodes,
                                  Given_mesh_details_2& details) {
  const std::string text = read_whole_file(name);
  Line_scanner scanner(text, name);
  Pslg_2<Triangle_point> poly;
  Triangle_parser<Triangle_point> parser(scanner, poly);
  parser.read_vertices();
  parser.set_number_of_vertices(nodes.vertices.size());
  poly.first_number = nodes.first_number;
  parser.read_segments();
  details.segments = std::move(poly.segments);
  details.segment_markers = std::move(poly.segment_markers);
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \ingroup PkgQuadtreeMesh2IO
/// Reads a mesh to be refined, as Triangle's `-r` does, from `stem.ele`, `stem.node` and, if there is
/// one, `stem.poly`; any of them may be compressed (`.gz`).
///
/// Segments are those of the `.poly` file, the border, and the edges between triangles with different attributes (the
/// first one in the `.ele` file). Vertices, holes and regions of the `.poly` file are ignored, as by Triangle. All
/// vertices are input of the graph, with their attributes and markers. See `pslg_from_mesh_2()`.
/// \param file_name the `.ele` file
/// \throws Pslg_error_2 with file and line as `read_triangle_poly()` does, or as `pslg_from_mesh_2()` does; `mesh`
/// and `pslg` are then unchanged.
inline void read_triangle_mesh(const std::string& file_name,
                               Indexed_mesh_2<Quadtree_mesh_2::internal::Triangle_point>& mesh,
                               Pslg_2<Quadtree_mesh_2::internal::Triangle_point>& pslg) {
  namespace internal = Quadtree_mesh_2::internal;
  const std::string stem = internal::stem_of_triangle_file(file_name);
  const std::string node_name = internal::existing_triangle_file(stem + ".node");
  if (node_name.empty())
    throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE,
                       file_name + ": there is no file " + stem + ".node beside it, which has the vertices");
  Pslg_2<internal::Triangle_point> nodes;
  internal::parse_triangle_node(internal::read_whole_file(node_name), node_name, nodes);
  const std::string text = internal::read_whole_file(file_name);
  internal::Line_scanner scanner(text, file_name);
  internal::Triangle_parser<internal::Triangle_point> parser(scanner, nodes);
  Indexed_mesh_2<internal::Triangle_point> result;
  Given_mesh_details_2 details;
  parser.read_triangles(result.triangles, &details.attributes);
  parser.read_end();
  const std::string poly_name = internal::existing_triangle_file(stem + ".poly");
  if (!poly_name.empty()) internal::read_segments_of_mesh(poly_name, nodes, details);
  details.first_number = nodes.first_number;
  result.points = std::move(nodes.vertices);
  result.vertex_markers = std::move(nodes.vertex_markers);
  pslg = pslg_from_mesh_2(result, details);
  pslg.number_of_vertex_attributes = nodes.number_of_vertex_attributes;
  pslg.vertex_attributes = std::move(nodes.vertex_attributes);
  mesh = std::move(result);
}

/// \ingroup PkgQuadtreeMesh2IO
/// Reads bounds of area by triangle from an `.area` file of Triangle: a number for each triangle of a mesh, which is
/// no bound where it is not positive.
/// \param mesh whose triangles they are for
/// \throws Pslg_error_2 with file and line if the file is missing or malformed, or has not as many bounds as the mesh
/// has triangles.
template <class Point>
std::vector<double> read_triangle_area(const std::string& file_name, const Indexed_mesh_2<Point>& mesh,
                                       std::size_t first_number = 0) {
  namespace internal = Quadtree_mesh_2::internal;
  const std::string text = internal::read_whole_file(file_name);
  internal::Line_scanner scanner(text, file_name);
  Pslg_2<Point> numbers;
  numbers.first_number = first_number;
  internal::Triangle_parser<Point> parser(scanner, numbers);
  std::vector<double> areas;
  parser.read_areas(mesh.number_of_triangles(), areas);
  parser.read_end();
  return areas;
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_TRIANGLE_MESH_H
