// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_MESH_CELLS_H
#define CGAL_IO_MESH_CELLS_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/mesh_dual_types.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>

// Writes cells around vertices as polygons: GeoJSON (RFC 7946) and well-known text (OGC 06-103r4). Takes linear time.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The text of a cell's polygons, with one mark between numbers, others around rings.
class Cell_text {
public:
  struct Marks {
    char open, close;       ///< of lists
    const char* open_place; ///< of a place
    const char* between_numbers;
    const char* close_place;
  };

  Cell_text(const Mesh_dual_2& dual, const Marks& marks) : dual_(dual), marks_(marks) {}

  std::size_t number_of_polygons(Vertex_index v) const {
    std::size_t n = 0;
    dual_.for_each_polygon(v, [&n](const auto* begin, const auto* end) { n += end - begin > 2 ? 1 : 0; });
    return n;
  }

  /// Its only polygon, or a list of all.
  void append(std::string& text, Vertex_index v) const {
    const bool is_list = number_of_polygons(v) > 1;
    if (is_list) text += marks_.open;
    bool is_first = true;
    dual_.for_each_polygon(v, [&](const std::uint32_t* begin, const std::uint32_t* end) {
      if (end - begin < 3) return;
      if (!is_first) text += ',';
      is_first = false;
      append_polygon(text, begin, end);
    });
    if (is_list) text += marks_.close;
  }

private:
  const Mesh_dual_2& dual_;
  const Marks& marks_;

  /// With the first corner at the end again.
  void append_polygon(std::string& text, const std::uint32_t* begin, const std::uint32_t* end) const {
    (text += marks_.open) += marks_.open;
    for (const std::uint32_t* c = begin; c != end; ++c) {
      append_place(text, *c);
      text += ',';
    }
    append_place(text, *begin);
    (text += marks_.close) += marks_.close;
  }

  void append_place(std::string& text, std::uint32_t corner) const {
    text += marks_.open_place;
    append_number(text, dual_.points[corner][0]);
    text += marks_.between_numbers;
    append_number(text, dual_.points[corner][1]);
    text += marks_.close_place;
  }
};

template <class Point>
std::string cells_geojson_text(const Mesh_dual_2& dual, const Indexed_mesh_2<Point>& mesh,
                               std::size_t first_number) {
  constexpr Cell_text::Marks marks{'[', ']', "[", ",", "]"};
  const Cell_text cells(dual, marks);
  std::string text = "{\"type\": \"FeatureCollection\", \"features\": [";
  text.reserve(400 * dual.number_of_cells() + 100);
  const char* before = "\n";
  for (std::size_t i = 0; i < dual.number_of_cells(); ++i) {
    const Vertex_index v(i);
    const std::size_t polygons = cells.number_of_polygons(v);
    if (polygons == 0) continue;
    text += before, before = ",\n";
    text += "{\"type\": \"Feature\", \"properties\": {\"vertex\": ";
    append_number(text, first_number + i);
    text += ", \"marker\": ";
    append_number(text, mesh.marker(v));
    text += ", \"area\": ";
    append_number(text, dual.areas[i]);
    text += "}, \"geometry\": {\"type\": \"";
    text += polygons > 1 ? "MultiPolygon" : "Polygon";
    text += "\", \"coordinates\": ";
    cells.append(text, v);
    text += "}}";
  }
  return text += "\n]}\n";
}

inline std::string cells_wkt_text(const Mesh_dual_2& dual) {
  constexpr Cell_text::Marks marks{'(', ')', "", " ", ""};
  const Cell_text cells(dual, marks);
  std::string text;
  text.reserve(300 * dual.number_of_cells());
  for (std::size_t i = 0; i < dual.number_of_cells(); ++i) {
    const Vertex_index v(i);
    const std::size_t polygons = cells.number_of_polygons(v);
    text += polygons > 1 ? "MULTIPOLYGON " : polygons == 1 ? "POLYGON " : "POLYGON EMPTY";
    if (polygons > 0) cells.append(text, v);
    text += '\n';
  }
  return text;
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Writes the cells of a mesh as GeoJSON: a feature for each vertex that triangles use, in their order, a `Polygon`, or
/// a `MultiPolygon` where the border touches itself. Properties are `vertex`, its number; `marker`, that of the vertex;
/// and `area`, that of the cell.
/// \param dual the cells, by `dual_of_mesh_2()`
/// \param mesh what they are the cells of
/// \param first_number the number of the first vertex, 0 or 1
template <class Point>
void write_cells_GeoJSON(std::ostream& out, const Mesh_dual_2& dual, const Indexed_mesh_2<Point>& mesh,
                         std::size_t first_number = 0) {
  out << Quadtree_mesh_2::internal::cells_geojson_text(dual, mesh, first_number);
}
/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written. An older file of that
/// name is then unchanged.
template <class Point>
void write_cells_GeoJSON(const std::string& file_name, const Mesh_dual_2& dual,
                         const Indexed_mesh_2<Point>& mesh, std::size_t first_number = 0) {
  namespace internal = Quadtree_mesh_2::internal;
  internal::replace_file(file_name, internal::cells_geojson_text(dual, mesh, first_number));
}

/// Writes cells as well-known text, one vertex a line: `POLYGON`, `MULTIPOLYGON` where the border touches itself, and
/// `POLYGON EMPTY` for a vertex that no triangle uses.
inline void write_cells_WKT(std::ostream& out, const Mesh_dual_2& dual) {
  out << Quadtree_mesh_2::internal::cells_wkt_text(dual);
}
/// \throws std::system_error as above
inline void write_cells_WKT(const std::string& file_name, const Mesh_dual_2& dual) {
  Quadtree_mesh_2::internal::replace_file(file_name, Quadtree_mesh_2::internal::cells_wkt_text(dual));
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_MESH_CELLS_H
