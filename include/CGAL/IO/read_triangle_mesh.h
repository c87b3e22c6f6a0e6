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
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/given_mesh_types.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_scanner.h>
#include <CGAL/Quadtree_mesh_2/internal/io/read_whole_file.h>
#include <CGAL/pslg_from_mesh_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// Reads meshes from files of Jonathan Shewchuk's Triangle, to be refined: .node, .ele, .poly and .area.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Triangle_point = Exact_predicates_inexact_constructions_kernel::Point_2;

/// The vertices and triangles of a mesh as they are read, with the nodes in the middle of edges.
struct Triangle_nodes {
  Pslg_2<Triangle_point> nodes;
  std::string file_name; ///< of the nodes
  std::vector<std::array<Vertex_index, 3>> triangles;
  std::vector<Vertex_index> middle_nodes;
  std::vector<Vertex_index> new_index; ///< per node, that without those in the middle; invalid for these

  /// Nodes in the middle of edges are no vertices, unless they are corners of triangles, too.
  void find_new_indices() {
    std::vector<char> is_dropped(nodes.vertices.size(), 0);
    for (const Vertex_index v : middle_nodes) is_dropped[std::size_t(v)] = 1;
    for (const auto& t : triangles)
      for (const Vertex_index v : t) is_dropped[std::size_t(v)] = 0;
    new_index.resize(is_dropped.size());
    std::size_t n = 0;
    for (std::size_t v = 0; v < is_dropped.size(); ++v)
      if (is_dropped[v] == 0) new_index[v] = Vertex_index(n++);
  }

  std::size_t number_of_vertices() const {
    return std::size_t(
        std::count_if(new_index.begin(), new_index.end(), [](Vertex_index v) { return v.is_valid(); }));
  }

  /// Leaves the dropped nodes out.
  void drop_middle_nodes() {
    const std::size_t k = nodes.number_of_vertex_attributes;
    drop(nodes.vertices, 1), drop(nodes.vertex_markers, 1), drop(nodes.vertex_attributes, k);
    for (auto& t : triangles)
      for (Vertex_index& v : t) v = new_index[std::size_t(v)];
  }

private:
  /// \param width how many values each node has
  template <class T>
  void drop(std::vector<T>& values, std::size_t width) const {
    if (values.empty()) return;
    std::vector<T> kept;
    for (std::size_t v = 0; v < new_index.size(); ++v)
      if (new_index[v].is_valid())
        kept.insert(kept.end(), values.begin() + std::ptrdiff_t(width * v),
                    values.begin() + std::ptrdiff_t(width * (v + 1)));
    values = std::move(kept);
  }
};

/// The segments of a .poly file. Its vertices, if it has its own, are the same as those of the .node file.
inline void read_segments_of_mesh(const std::string& name, const Triangle_nodes& mesh,
                                  Given_mesh_details_2& details) {
  const std::string text = read_whole_file(name);
  Line_scanner scanner(text, name);
  Pslg_2<Triangle_point> poly;
  Triangle_parser<Triangle_point> parser(scanner, poly);
  const Vertices_to_repeat<Triangle_point> same{mesh.nodes.vertices, mesh.number_of_vertices(),
                                                mesh.file_name};
  parser.read_vertices(&same);
  parser.set_number_of_vertices(mesh.nodes.vertices.size());
  poly.first_number = mesh.nodes.first_number;
  parser.read_segments();
  details.segments = std::move(poly.segments);
  details.segment_markers = std::move(poly.segment_markers);
  for (std::size_t s = 0; s < details.segments.size(); ++s)
    for (Vertex_index& v : details.segments[s]) {
      const Vertex_index corner = mesh.new_index[std::size_t(v)];
      if (!corner.is_valid())
        throw Pslg_error_2(Pslg_error_2::Kind::INVALID_MESH,
                           name + ": segment " + std::to_string(poly.first_number + s) + " ends at vertex " +
                               std::to_string(poly.first_number + std::size_t(v)) +
                               ", which is in the middle of an edge and no corner of a triangle",
                           Pslg_parts_2().segment(Segment_index(s)));
      v = corner;
    }
}

/// Of the vertices that are input of the graph.
inline std::vector<double> attributes_of_input(const Indexed_mesh_2<Triangle_point>& mesh,
                                               const Pslg_2<Triangle_point>& nodes) {
  const std::size_t k = nodes.number_of_vertex_attributes;
  if (mesh.input_index.empty() || k == 0) return nodes.vertex_attributes;
  std::vector<double> attributes(k * mesh.number_of_input_vertices);
  for (std::size_t v = 0; v < mesh.input_index.size(); ++v)
    if (const Vertex_index i = mesh.input_index[v]; i.is_valid())
      std::copy_n(nodes.vertex_attributes.begin() + std::ptrdiff_t(k * v), k,
                  attributes.begin() + std::ptrdiff_t(k * std::size_t(i)));
  return attributes;
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \ingroup PkgQuadtreeMesh2IO
/// Reads a mesh to be refined, as Triangle's `-r` does, from `stem.ele`, `stem.node` and, if there is
/// one, `stem.poly`; any of them may be compressed (`.gz`).
///
/// Segments are those of the `.poly` file, the border, and the edges between triangles with different attributes (the
/// first one in the `.ele` file). Holes and regions of the `.poly` file are ignored, as by Triangle. Vertices of the
/// `.poly` file, if it has any, have to be those of the `.node` file. All vertices are input of the graph, with their
/// attributes and markers, except for those inside of the straight sides of sharp corners. See `pslg_from_mesh_2()`.
///
/// Triangles may have six nodes. Those in the middle of edges are left out, with their attributes and markers. Where
/// nodes follow that are corners, these have lower numbers in the mesh.
///
/// Vertices may be at one place, and in the middle of sides of other triangles, which are cut there.
/// \param file_name the `.ele` file
/// \param[out] mesh the mesh
/// \param[out] pslg the graph that it is a mesh of
/// \param[out] given_triangle per triangle of the mesh, that of the file that it is, or is a piece of
/// \throws Pslg_error_2 with file and line as `read_triangle_poly()` does, or as `pslg_from_mesh_2()` does; `mesh`,
/// `pslg` and `given_triangle` are then unchanged.
inline void read_triangle_mesh(const std::string& file_name,
                               Indexed_mesh_2<Quadtree_mesh_2::internal::Triangle_point>& mesh,
                               Pslg_2<Quadtree_mesh_2::internal::Triangle_point>& pslg,
                               std::vector<Quadtree_mesh_2::Triangle_index>& given_triangle) {
  namespace internal = Quadtree_mesh_2::internal;
  const std::string stem = internal::stem_of_triangle_file(file_name);
  const std::string node_name = internal::existing_triangle_file(stem + ".node");
  if (node_name.empty())
    throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE,
                       file_name + ": there is no file " + stem + ".node beside it, which has the vertices");
  internal::Triangle_nodes read;
  read.file_name = node_name;
  internal::parse_triangle_node(internal::read_whole_file(node_name), node_name, read.nodes);
  const std::string text = internal::read_whole_file(file_name);
  internal::Line_scanner scanner(text, file_name);
  internal::Triangle_parser<internal::Triangle_point> parser(scanner, read.nodes);
  Given_mesh_details_2 details;
  parser.read_triangles(read.triangles, &details.attributes, &read.middle_nodes);
  parser.read_end();
  read.find_new_indices();
  const std::string poly_name = internal::existing_triangle_file(stem + ".poly");
  if (!poly_name.empty()) internal::read_segments_of_mesh(poly_name, read, details);
  if (!read.middle_nodes.empty()) read.drop_middle_nodes();
  details.first_number = read.nodes.first_number;
  Indexed_mesh_2<internal::Triangle_point> result;
  result.points = std::move(read.nodes.vertices);
  result.triangles = std::move(read.triangles);
  result.vertex_markers = std::move(read.nodes.vertex_markers);
  pslg = pslg_from_mesh_2(result, details, given_triangle);
  pslg.number_of_vertex_attributes = read.nodes.number_of_vertex_attributes;
  pslg.vertex_attributes = internal::attributes_of_input(result, read.nodes);
  mesh = std::move(result);
}

/// \ingroup PkgQuadtreeMesh2IO
/// The same, where it does not matter which triangles of the file were cut.
inline void read_triangle_mesh(const std::string& file_name,
                               Indexed_mesh_2<Quadtree_mesh_2::internal::Triangle_point>& mesh,
                               Pslg_2<Quadtree_mesh_2::internal::Triangle_point>& pslg) {
  std::vector<Quadtree_mesh_2::Triangle_index> given_triangle;
  read_triangle_mesh(file_name, mesh, pslg, given_triangle);
}

/// \ingroup PkgQuadtreeMesh2IO
/// Reads bounds of area by triangle from an `.area` file of Triangle: a number for each triangle of a mesh, which is
/// no bound where it is not positive.
/// \param file_name the `.area` file
/// \param given_triangle per triangle of the mesh, that of its `.ele` file, as `read_triangle_mesh()` tells
/// \param first_number what messages count from
/// \returns a bound for each triangle of the mesh
/// \throws Pslg_error_2 with file and line if the file is missing or malformed, or has not as many bounds as the `.ele`
/// file has triangles.
inline std::vector<double>
read_triangle_area(const std::string& file_name,
                   const std::vector<Quadtree_mesh_2::Triangle_index>& given_triangle,
                   std::size_t first_number = 0) {
  namespace internal = Quadtree_mesh_2::internal;
  const std::string text = internal::read_whole_file(file_name);
  internal::Line_scanner scanner(text, file_name);
  Pslg_2<internal::Triangle_point> numbers;
  numbers.first_number = first_number;
  internal::Triangle_parser<internal::Triangle_point> parser(scanner, numbers);
  const auto last = std::max_element(given_triangle.begin(), given_triangle.end());
  std::vector<double> given_areas, areas;
  parser.read_areas(last == given_triangle.end() ? 0 : std::size_t(*last) + 1, given_areas);
  parser.read_end();
  for (const Quadtree_mesh_2::Triangle_index t : given_triangle) areas.push_back(given_areas[std::size_t(t)]);
  return areas;
}

/// \ingroup PkgQuadtreeMesh2IO
/// The same for a mesh none of whose triangles was cut.
/// \param file_name the `.area` file
/// \param mesh whose triangles they are for
/// \param first_number what messages count from
template <class Point>
std::vector<double> read_triangle_area(const std::string& file_name, const Indexed_mesh_2<Point>& mesh,
                                       std::size_t first_number = 0) {
  std::vector<Quadtree_mesh_2::Triangle_index> same;
  for (std::size_t t = 0; t < mesh.number_of_triangles(); ++t)
    same.push_back(Quadtree_mesh_2::Triangle_index(t));
  return read_triangle_area(file_name, same, first_number);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_TRIANGLE_MESH_H
