// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_WRITE_TRIANGLE_FILES_H
#define CGAL_IO_WRITE_TRIANGLE_FILES_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_writer.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/Edge_finder.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>

#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// Writes the files of Jonathan Shewchuk's Triangle: .poly, .node and .ele
// (https://www.cs.cmu.edu/~quake/triangle.html). Numbers count from 0 or from 1, as in the file that the graph was read
// from (`Pslg_2::first_number`). Coordinates have the fewest digits that give the same bits back. Each file is made in
// memory, in linear time, and appears under its name only when it is complete.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Writes the vertices as in a .node file and in a .poly file.
template <class Point>
void write_vertices(Line_writer& out, const Pslg_2<Point>& pslg) {
  const std::size_t k = pslg.number_of_vertex_attributes;
  const bool has_markers = !pslg.vertex_markers.empty();
  (out << pslg.vertices.size() << 2 << k << int(has_markers)).end_line();
  for (std::size_t v = 0; v < pslg.vertices.size(); ++v) {
    (out << pslg.first_number + v).write_point(pslg.vertices[v]);
    for (std::size_t i = 0; i < k; ++i) out << pslg.vertex_attributes[v * k + i];
    if (has_markers) out << pslg.vertex_markers[v];
    out.end_line();
  }
}

template <class Point>
void write_holes_and_regions(Line_writer& out, const Pslg_2<Point>& pslg) {
  (out << pslg.holes.size()).end_line();
  for (std::size_t h = 0; h < pslg.holes.size(); ++h)
    (out << pslg.first_number + h).write_point(pslg.holes[h]).end_line();
  if (pslg.regions.empty()) return; // the section is optional
  (out << pslg.regions.size()).end_line();
  for (std::size_t r = 0; r < pslg.regions.size(); ++r) {
    const auto& region = pslg.regions[r];
    // Without the last column, Triangle would take the attribute for the area. -1 means no bound.
    (out << pslg.first_number + r).write_point(region.point)
        << region.attribute << (region.max_area > 0 ? region.max_area : -1.);
    out.end_line();
  }
}

/// \param nodes that follow the vertices; null: none
template <class Point>
Line_writer mesh_node_text(const Indexed_mesh_2<Point>& mesh, std::size_t first_number,
                           const Second_order_nodes_2* nodes = nullptr) {
  const bool is_renumbered = !mesh.input_index.empty();
  const std::size_t n = mesh.points.size() + (nodes != nullptr ? nodes->points.size() : 0);
  Line_writer out;
  out.reserve((is_renumbered ? 58 : 48) * n + 32);
  (out << n << 2 << int(is_renumbered) << 1).end_line();
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    (out << first_number + v).write_point(mesh.points[v]);
    if (is_renumbered && mesh.input_index[v].is_valid())
      out << first_number + std::size_t(mesh.input_index[v]);
    else if (is_renumbered)
      out << -1;
    (out << mesh.marker(Vertex_index(v))).end_line();
  }
  for (std::size_t i = 0; mesh.points.size() + i < n; ++i) {
    out << first_number + mesh.points.size() + i << nodes->points[i][0] << nodes->points[i][1];
    if (is_renumbered) out << -1;
    (out << nodes->edges[i].marker).end_line();
  }
  return out;
}

/// \param nodes of six for each triangle; null: three
template <class Point>
Line_writer mesh_ele_text(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                          const Second_order_nodes_2* nodes = nullptr) {
  const bool has_regions = !pslg.regions.empty() && !mesh.region_of_triangle.empty();
  const std::size_t first = pslg.first_number;
  Line_writer out;
  out.reserve(32 * mesh.triangles.size() + 32);
  (out << mesh.triangles.size() << (nodes != nullptr ? 6 : 3) << int(has_regions)).end_line();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& triangle = mesh.triangles[t];
    out << first + t;
    for (const Vertex_index v : triangle) out << first + std::size_t(v);
    if (nodes != nullptr)
      for (const Vertex_index v : nodes->nodes_of_triangle[t]) out << first + std::size_t(v);
    if (has_regions) {
      const int region = mesh.region_of_triangle[t];
      out << (region < 0 ? 0. : pslg.regions[static_cast<std::size_t>(region)].attribute);
    }
    out.end_line();
  }
  return out;
}

template <class Point>
Line_writer mesh_poly_text(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg) {
  const bool has_markers = !pslg.segment_markers.empty();
  const std::size_t first = pslg.first_number;
  Line_writer out;
  (out << 0 << 2 << 0 << 1).end_line();
  (out << mesh.constrained_edges.size() << int(has_markers)).end_line();
  for (std::size_t e = 0; e < mesh.constrained_edges.size(); ++e) {
    const auto& edge = mesh.constrained_edges[e];
    out << first + e << first + std::size_t(edge.vertices[0]) << first + std::size_t(edge.vertices[1]);
    if (has_markers) out << edge.marker;
    out.end_line();
  }
  write_holes_and_regions(out, pslg);
  return out;
}

/// Adds `stem.node`, `stem.ele` and `stem.poly` to the files about to be replaced.
template <class Point>
void add_triangle_files(Replaced_files& files, const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                        const std::string& stem, IO::Element_order order = IO::Element_order::FIRST) {
  std::optional<Second_order_nodes_2> nodes;
  if (order == IO::Element_order::SECOND) nodes = second_order_nodes<Sequential_tag>(mesh);
  const Second_order_nodes_2* const some = nodes ? &*nodes : nullptr;
  files.add(stem + ".node", mesh_node_text(mesh, pslg.first_number, some).take());
  files.add(stem + ".ele", mesh_ele_text(mesh, pslg, some).take());
  files.add(stem + ".poly", mesh_poly_text(mesh, pslg).take());
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Writes the vertices of a graph, with their attributes and markers, to a `.node` file.
/// \pre `check_pslg_structure(pslg)` passes; this holds for all functions here.
/// \throws std::system_error that names the file if it cannot be written. An older file of that name is then
/// unchanged. This holds for all functions here.
template <class Point>
void write_triangle_node(const std::string& file_name, const Pslg_2<Point>& pslg) {
  Quadtree_mesh_2::internal::Line_writer out;
  Quadtree_mesh_2::internal::write_vertices(out, pslg);
  Quadtree_mesh_2::internal::replace_file(file_name, out.take());
}

/// Writes a whole graph, including vertices, to a `.poly` file. `read_triangle_poly()` gives the same graph
/// back, bit for bit.
template <class Point>
void write_triangle_poly(const std::string& file_name, const Pslg_2<Point>& pslg) {
  namespace internal = Quadtree_mesh_2::internal;
  internal::Line_writer out;
  internal::write_vertices(out, pslg);
  const bool has_markers = !pslg.segment_markers.empty();
  const std::size_t first = pslg.first_number;
  (out << pslg.segments.size() << int(has_markers)).end_line();
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    out << first + s << first + std::size_t(pslg.segments[s][0]) << first + std::size_t(pslg.segments[s][1]);
    if (has_markers) out << pslg.segment_markers[s];
    out.end_line();
  }
  internal::write_holes_and_regions(out, pslg);
  internal::replace_file(file_name, out.take());
}

/// Writes all vertices of a mesh to a `.node` file, in their order, used or not, with their markers
/// (`Indexed_mesh_2::vertex_markers`). Vertices of a renumbered mesh have their number in the input as an attribute, -1
/// for Steiner vertices.
/// \param first_number of the first vertex: 0 or 1, the same as for the other files of the mesh
template <class Point>
void write_triangle_node(const std::string& file_name, const Indexed_mesh_2<Point>& mesh,
                         std::size_t first_number = 0) {
  namespace internal = Quadtree_mesh_2::internal;
  internal::replace_file(file_name, internal::mesh_node_text(mesh, first_number).take());
}

/// Writes the triangles of a mesh to an `.ele` file. If `pslg` has regions, triangles have the attributes of
/// their regions, or 0 outside regions.
/// \pre `mesh` is a mesh of `pslg`; this holds for all functions below.
template <class Point>
void write_triangle_ele(const std::string& file_name, const Indexed_mesh_2<Point>& mesh,
                        const Pslg_2<Point>& pslg) {
  namespace internal = Quadtree_mesh_2::internal;
  internal::replace_file(file_name, internal::mesh_ele_text(mesh, pslg).take());
}

/// Writes the constrained edges of a mesh, its holes and its regions to a `.poly` file without vertices. The
/// file belongs to the `.node` file of the same stem. If `pslg` has markers of segments, edges have those of
/// their segments.
template <class Point>
void write_triangle_poly(const std::string& file_name, const Indexed_mesh_2<Point>& mesh,
                         const Pslg_2<Point>& pslg) {
  namespace internal = Quadtree_mesh_2::internal;
  internal::replace_file(file_name, internal::mesh_poly_text(mesh, pslg).take());
}

/// Writes `stem.node`, `stem.ele` and `stem.poly` as the three functions above do. If one file cannot be
/// written, none is.
/// \param order of second order, as by Triangle's `-o2`, triangles have six nodes: the last three are in the middle of
/// the sides opposite the first three, and follow the vertices in the `.node` file
template <class Point>
void write_triangle_files(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                          const std::string& stem, Element_order order = Element_order::FIRST) {
  namespace internal = Quadtree_mesh_2::internal;
  internal::Replaced_files files;
  internal::add_triangle_files(files, mesh, pslg, stem, order);
  files.commit();
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_WRITE_TRIANGLE_FILES_H
