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
#include <CGAL/Quadtree_mesh_2/internal/io/Vtk_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>
#include <CGAL/Quadtree_mesh_2/triangle_fields.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
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

/// What the numbers in the whole mesh are called in the data of points or of cells.
inline std::string global_numbers_of(const std::string& data) {
  return data == "PointData" ? "GlobalPointIds" : "GlobalCellIds";
}
/// Begins an element with the data of points or of cells, which says which array has the numbers in the whole mesh.
inline std::string vtu_data_tag(const std::string& element, const std::string& data) {
  return '<' + element + " GlobalIds=\"" + global_numbers_of(data) + "\">\n";
}

/// The XML text, and the bytes that are appended to it.
class Vtu_text {
public:
  explicit Vtu_text(IO::Mode mode)
      : is_binary_(mode == IO::BINARY), text_(opening("UnstructuredGrid") + "<UnstructuredGrid>\n") {}

  /// How a file with a kind of grid begins.
  static std::string opening(const std::string& grid) {
    const std::uint16_t one = 1;
    unsigned char first_byte;
    std::memcpy(&first_byte, &one, 1);
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + grid + "\" version=\"1.0\" byte_order=\"" +
           (first_byte == 1 ? "LittleEndian" : "BigEndian") + "\" header_type=\"UInt64\">\n";
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

  template <class Number>
  static std::string type_name() {
    const std::string size = std::to_string(8 * sizeof(Number));
    return (std::is_floating_point_v<Number> ? "Float" : std::is_signed_v<Number> ? "Int" : "UInt") + size;
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

private:
  /// Bytes are numbers here, not characters.
  template <class Number>
  static auto widened(Number x) {
    if constexpr (sizeof(Number) == 1)
      return static_cast<int>(x);
    else
      return x;
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

/// All of a grid.
template <class Point>
struct Whole_grid {
  const Vtk_grid<Point>& grid;

  std::size_t number_of_points() const { return grid.number_of_points(); }
  std::size_t number_of_cells() const { return grid.number_of_cells(); }
  std::size_t point(std::size_t i) const { return i; }
  std::size_t cell(std::size_t i) const { return i; }
  /// The number that a vertex of the mesh has in the file.
  std::int64_t number_of(Vertex_index v) const { return v.value(); }
  static constexpr bool has_global_numbers = false;
};

/// Writes a grid, or a piece of it, as a file for VTK. See `IO::write_VTU()`.
/// \tparam Part has the members of `Whole_grid`
template <class Point, class Part>
class Vtu_writer {
public:
  Vtu_writer(const Vtk_grid<Point>& grid, const Part& part) : grid_(grid), part_(part) {}

  std::string text(IO::Mode mode) const {
    Vtu_text text(mode);
    text.add("<Piece NumberOfPoints=\"" + std::to_string(part_.number_of_points()) + "\" NumberOfCells=\"" +
             std::to_string(part_.number_of_cells()) + "\">\n");
    text.reserve(32 * part_.number_of_points() + 61 * part_.number_of_cells());
    add_points(text);
    add_cells(text);
    add_cell_data(text);
    text.add("</Piece>\n");
    return text.take();
  }

private:
  /// \param at called with what is in the part, `n` times
  template <class Value_at, class At>
  static auto values(std::size_t n, const Value_at& value_at, const At& at) {
    std::vector<std::decay_t<decltype(value_at(n))>> result;
    result.reserve(n);
    for (std::size_t i = 0; i < n; ++i) result.push_back(value_at(at(i)));
    return result;
  }
  template <class Value_at>
  auto values_of_points(const Value_at& value_at) const {
    return values(part_.number_of_points(), value_at, [this](std::size_t i) { return part_.point(i); });
  }
  template <class Value_at>
  auto values_of_cells(const Value_at& value_at) const {
    return values(part_.number_of_cells(), value_at, [this](std::size_t i) { return part_.cell(i); });
  }
  static std::string opening_of(const std::string& data) {
    return Part::has_global_numbers ? vtu_data_tag(data, data) : '<' + data + ">\n";
  }
  std::int64_t number_of_point(std::size_t v) const {
    return static_cast<std::int64_t>(grid_.numbers().vertex(Vertex_index(v)));
  }

  void add_points(Vtu_text& text) const {
    std::vector<double> coordinates;
    coordinates.reserve(3 * part_.number_of_points());
    for (std::size_t i = 0; i < part_.number_of_points(); ++i)
      for (std::size_t k = 0; k < 3; ++k) coordinates.push_back(grid_.coordinate(part_.point(i), k));
    text.add("<Points>\n");
    text.add_array("Points", coordinates, 3);
    text.add("</Points>\n");
    bool has_data = Part::has_global_numbers;
    grid_.for_each_point_array([&has_data](const std::string&, const auto&) { has_data = true; });
    if (!has_data) return;
    text.add(opening_of("PointData"));
    grid_.for_each_point_array([&](const std::string& name, const auto& value_at) {
      text.add_array(name, values_of_points(value_at));
    });
    if (Part::has_global_numbers)
      text.add_array(global_numbers_of("PointData"),
                     values_of_points([this](std::size_t v) { return number_of_point(v); }));
    text.add("</PointData>\n");
  }

  void add_cells(Vtu_text& text) const {
    std::vector<std::int64_t> vertices, ends;
    vertices.reserve(3 * part_.number_of_cells());
    ends.reserve(part_.number_of_cells());
    for (std::size_t i = 0; i < part_.number_of_cells(); ++i) {
      const std::size_t cell = part_.cell(i);
      for (std::size_t k = 0; k < grid_.size(cell); ++k)
        vertices.push_back(part_.number_of(grid_.vertex(cell, k)));
      ends.push_back(static_cast<std::int64_t>(vertices.size()));
    }
    text.add("<Cells>\n");
    text.add_array("connectivity", vertices);
    text.add_array("offsets", ends);
    text.add_array("types", values_of_cells([this](std::size_t cell) { return grid_.type(cell); }));
    text.add("</Cells>\n");
  }

  void add_cell_data(Vtu_text& text) const {
    text.add(opening_of("CellData"));
    grid_.for_each_cell_array([&](const std::string& name, const auto& value_at) {
      text.add_array(name, values_of_cells(value_at));
    });
    if (Part::has_global_numbers)
      text.add_array(global_numbers_of("CellData"), values_of_cells([this](std::size_t cell) {
                       return static_cast<std::int64_t>(grid_.number_of_cell(cell));
                     }));
    text.add("</CellData>\n");
  }

  const Vtk_grid<Point>& grid_;
  const Part& part_;
};

/// The text of a file with all of a mesh.
template <class Point>
std::string vtu_text(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                     const IO::Triangle_fields_2& fields, IO::Mode mode,
                     IO::Element_order order = IO::Element_order::FIRST) {
  const Vtk_grid<Point> grid(mesh, pslg, fields, order);
  const Whole_grid<Point> whole{grid};
  return Vtu_writer<Point, Whole_grid<Point>>(grid, whole).text(mode);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_VTU_WRITER_H
