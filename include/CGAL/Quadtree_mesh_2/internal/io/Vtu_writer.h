// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_VTU_WRITER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_VTU_WRITER_H

#include <CGAL/IO/io.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/triangle_fields.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

// Unstructured grids of VTK, https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html. Each array is made in
// memory, then goes into the text, or behind it as bytes.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The XML text, and the bytes that are appended to it.
class Vtu_text {
public:
  explicit Vtu_text(IO::Mode mode) : is_binary_(mode == IO::BINARY) {
    const std::uint16_t one = 1;
    unsigned char first_byte;
    std::memcpy(&first_byte, &one, 1);
    text_ = std::string(
                "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"") +
            (first_byte == 1 ? "LittleEndian" : "BigEndian") +
            "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  }

  void add(const std::string& xml) { text_ += xml; }
  /// Room for so many bytes of arrays.
  void reserve(std::size_t size) { (is_binary_ ? appended_ : text_).reserve(size); }

  template <class Number>
  void add_array(const std::string& name, const std::vector<Number>& values, int components = 1) {
    text_ += "<DataArray type=\"" + type_name<Number>() + "\" Name=\"" + escaped(name) +
             "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"" +
             (is_binary_ ? "appended" : "ascii") + '"';
    if (is_binary_) {
      text_ += " offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
      append_bytes(values);
      return;
    }
    text_ += ">\n";
    for (std::size_t i = 0; i < values.size(); ++i) {
      append_number(text_, widened(values[i]));
      text_ += (i + 1) % 12 == 0 || i + 1 == values.size() ? '\n' : ' ';
    }
    text_ += "</DataArray>\n";
  }

  std::string take() {
    text_ += "</UnstructuredGrid>\n";
    if (is_binary_) {
      text_ += "<AppendedData encoding=\"raw\">\n_";
      text_ += appended_;
      text_ += "\n</AppendedData>\n";
    }
    text_ += "</VTKFile>\n";
    return std::move(text_);
  }

private:
  template <class Number>
  static std::string type_name() {
    const std::string size = std::to_string(8 * sizeof(Number));
    return (std::is_floating_point_v<Number> ? "Float" : std::is_signed_v<Number> ? "Int" : "UInt") + size;
  }

  /// Bytes are numbers here, not characters.
  template <class Number>
  static auto widened(Number x) {
    if constexpr (sizeof(Number) == 1)
      return static_cast<int>(x);
    else
      return x;
  }

  /// With `>`, too: VTK takes the first one for the begin of the numbers, wherever it is.
  static std::string escaped(const std::string& name) {
    std::string result;
    for (const char c : name) {
      const auto special = std::string_view("&<>\"").find(c);
      constexpr const char* entities[] = {"&amp;", "&lt;", "&gt;", "&quot;"};
      if (special == std::string_view::npos)
        result += c;
      else
        result += entities[special];
    }
    return result;
  }

  template <class Number>
  void append_bytes(const std::vector<Number>& values) {
    const std::uint64_t size = values.size() * sizeof(Number);
    appended_.append(reinterpret_cast<const char*>(&size), sizeof size);
    appended_.append(reinterpret_cast<const char*>(values.data()), static_cast<std::size_t>(size));
  }

  bool is_binary_;
  std::string text_, appended_;
};

/// See `IO::write_VTU()`.
template <class Point>
class Vtu_writer {
public:
  Vtu_writer(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
             const IO::Triangle_fields_2& fields)
      : mesh_(mesh), pslg_(pslg), fields_(fields) {
    for (const IO::Triangle_field_2& field : fields)
      if (field.values.size() != mesh.triangles.size())
        throw std::invalid_argument("the field '" + field.name + "' has " +
                                    std::to_string(field.values.size()) + " numbers for " +
                                    std::to_string(mesh.triangles.size()) + " triangles");
    find_outside_segments();
    find_triangles_at_edges();
  }

  std::string text(IO::Mode mode) const {
    Vtu_text text(mode);
    text.add("<Piece NumberOfPoints=\"" + std::to_string(mesh_.points.size()) + "\" NumberOfCells=\"" +
             std::to_string(number_of_cells()) + "\">\n");
    text.reserve(24 * mesh_.points.size() + (61 + 8 * fields_.size()) * number_of_cells());
    add_points(text);
    add_cells(text);
    add_cell_data(text);
    text.add("</Piece>\n");
    return text.take();
  }

private:
  using Edge = std::array<std::uint32_t, 2>;
  static constexpr std::size_t none_ = std::numeric_limits<std::size_t>::max();

  std::size_t number_of_cells() const {
    return mesh_.triangles.size() + mesh_.constrained_edges.size() + outside_.size();
  }

  void find_outside_segments() {
    std::vector<char> is_in_mesh(pslg_.segments.size(), 0);
    for (const auto& e : mesh_.constrained_edges)
      if (std::size_t(e.segment) < is_in_mesh.size()) is_in_mesh[e.segment] = 1;
    for (std::size_t s = 0; s < pslg_.segments.size(); ++s)
      if (is_in_mesh[s] == 0) outside_.push_back(s);
  }

  /// Only sides between vertices of constrained edges are looked for.
  void find_triangles_at_edges() {
    const std::size_t n = mesh_.constrained_edges.size();
    std::vector<std::pair<Edge, std::size_t>> edges;
    std::vector<char> is_end(mesh_.points.size(), 0);
    edges.reserve(n);
    for (std::size_t e = 0; e < n; ++e) {
      const auto& ends = mesh_.constrained_edges[e].vertices;
      edges.push_back({sorted(ends[0], ends[1]), e});
      for (const Vertex_index v : ends) is_end[v] = 1;
    }
    std::sort(edges.begin(), edges.end());
    triangles_at_.assign(n, {none_, none_});
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vertex_index a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
        if (is_end[a] == 0 || is_end[b] == 0) continue;
        const Edge side = sorted(a, b);
        for (auto e = std::lower_bound(edges.begin(), edges.end(), std::pair(side, std::size_t(0)));
             e != edges.end() && e->first == side; ++e) {
          auto& at = triangles_at_[e->second];
          at[at[0] == none_ ? 0 : 1] = t;
        }
      }
  }
  static Edge sorted(Vertex_index a, Vertex_index b) {
    return {std::min(a.value(), b.value()), std::max(a.value(), b.value())};
  }

  void add_points(Vtu_text& text) const {
    std::vector<double> coordinates;
    coordinates.reserve(3 * mesh_.points.size());
    for (const Point& p : mesh_.points)
      for (const double x : {as_double(p.x()), as_double(p.y()), 0.}) coordinates.push_back(x);
    text.add("<Points>\n");
    text.add_array("Points", coordinates, 3);
    text.add("</Points>\n");
    if (mesh_.vertex_markers.empty()) return;
    text.add("<PointData>\n");
    text.add_array("marker",
                   std::vector<std::int32_t>(mesh_.vertex_markers.begin(), mesh_.vertex_markers.end()));
    text.add("</PointData>\n");
  }

  void add_cells(Vtu_text& text) const {
    constexpr std::uint8_t vtk_line = 3, vtk_triangle = 5;
    std::vector<std::int64_t> vertices, ends;
    std::vector<std::uint8_t> types(mesh_.triangles.size(), vtk_triangle);
    types.resize(number_of_cells(), vtk_line);
    vertices.reserve(3 * number_of_cells());
    ends.reserve(number_of_cells());
    const auto add_cell = [&](const auto& cell) {
      for (const Vertex_index v : cell) vertices.push_back(v.value());
      ends.push_back(static_cast<std::int64_t>(vertices.size()));
    };
    for (const auto& t : mesh_.triangles) add_cell(t);
    for (const auto& e : mesh_.constrained_edges) add_cell(e.vertices);
    for (const std::size_t s : outside_) add_cell(pslg_.segments[s]);
    text.add("<Cells>\n");
    text.add_array("connectivity", vertices);
    text.add_array("offsets", ends);
    text.add_array("types", types);
    text.add("</Cells>\n");
  }

  void add_cell_data(Vtu_text& text) const {
    std::vector<std::int32_t> regions(mesh_.region_of_triangle.begin(), mesh_.region_of_triangle.end());
    regions.resize(mesh_.triangles.size(), -1);
    regions.resize(number_of_cells(), -1);
    std::vector<std::int32_t> markers(mesh_.triangles.size(), 0);
    for (const auto& e : mesh_.constrained_edges) markers.push_back(e.marker);
    for (const std::size_t s : outside_)
      markers.push_back(pslg_.segment_markers.empty() ? 0 : pslg_.segment_markers[s]);
    text.add("<CellData>\n");
    text.add_array("region", regions);
    text.add_array("marker", markers);
    text.add_array("least_angle", with_edges(least_angles()));
    if (!pslg_.regions.empty()) text.add_array("attribute", with_edges(attributes(regions)));
    for (const IO::Triangle_field_2& field : fields_) text.add_array(field.name, with_edges(field.values));
    text.add("</CellData>\n");
  }

  std::vector<double> least_angles() const {
    std::vector<double> result;
    result.reserve(number_of_cells());
    for (const auto& t : mesh_.triangles)
      result.push_back(
          Scaled_triangle(mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2])).least_angle());
    return result;
  }

  std::vector<double> attributes(const std::vector<std::int32_t>& regions) const {
    std::vector<double> result;
    result.reserve(number_of_cells());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto r = static_cast<std::size_t>(regions[t]); // -1 becomes too large
      result.push_back(r < pslg_.regions.size() ? pslg_.regions[r].attribute : 0);
    }
    return result;
  }

  /// The values of triangles, and behind them those of edges.
  std::vector<double> with_edges(std::vector<double> values) const {
    double least = values.empty() ? 0 : values.front();
    for (const double value : values) least = std::min(least, value);
    values.reserve(number_of_cells());
    for (const auto& [t, u] : triangles_at_) {
      const double value = t == none_ ? least : values[t];
      values.push_back(u == none_ ? value : std::min(value, values[u]));
    }
    values.resize(number_of_cells(), least);
    return values;
  }

  const Indexed_mesh_2<Point>& mesh_;
  const Pslg_2<Point>& pslg_;
  const IO::Triangle_fields_2& fields_;
  std::vector<std::size_t> outside_;                     // segments
  std::vector<std::array<std::size_t, 2>> triangles_at_; // per constrained edge
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_VTU_WRITER_H
