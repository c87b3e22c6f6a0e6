// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_GRAPH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_GRAPH_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Hdf5_file.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Which rows of each array are read: of so many slices of about the same length, the one with the number.
struct Hdf5_slice {
  std::size_t number = 0, slices = 1;

  std::size_t begin(std::size_t rows) const { return cut(rows, number); }
  std::size_t end(std::size_t rows) const { return cut(rows, number + 1); }

private:
  /// Without a product that might overflow.
  std::size_t cut(std::size_t rows, std::size_t i) const {
    return rows / slices * i + rows % slices * i / slices;
  }
};

/// Reads the arrays of a graph, or a slice of each.
template <class Point>
class Hdf5_graph_reader {
public:
  static constexpr std::size_t index_limit = std::numeric_limits<Vertex_index::size_type>::max() - 1;

  /// \param limit of rows
  explicit Hdf5_graph_reader(std::string file_name, Hdf5_slice slice = {}, std::size_t limit = index_limit)
      : file_name_(std::move(file_name)), slice_(slice), limit_(limit) {}

  /// See `IO::read_HDF5()`.
  Pslg_2<Point> read() {
    read_rows([this](std::size_t n) { graph_.segments.reserve(n); },
              [this](std::int64_t a, std::int64_t b) {
                graph_.segments.push_back({Vertex_index(a), Vertex_index(b)});
              });
    return std::move(graph_);
  }

  /// Reads all into `graph()` but the segments, of which `add_segment(end, end)` is told.
  template <class Reserve, class Add_segment>
  void read_rows(const Reserve& reserve_segments, const Add_segment& add_segment) try {
    const Hdf5_reader file(file_name_);
    read_vertices(file);
    read_segments(file, reserve_segments, add_segment);
    if (file.has("/pslg/holes"))
      for_each_row<Number>(array(file, "/pslg/holes", {2}),
                           [this](std::size_t, const Number* row) { graph_.holes.push_back(point(row)); });
    read_regions(file);
  } catch (const Hdf5_read_error& error) {
    fail(error.what());
  }

  Pslg_2<Point>& graph() { return graph_; }
  /// The rows of all slices.
  std::size_t number_of_vertices() const { return number_of_vertices_; }
  std::size_t number_of_segments() const { return number_of_segments_; }
  /// How many arrays have been begun. Of errors in slices, the first is that of the first array, and then of the first
  /// slice.
  std::int64_t arrays_begun() const { return arrays_begun_; }

private:
  using Coordinate = Coordinate_t<Point>;
  /// Whole coordinates as such, others as doubles.
  using Number = std::conditional_t<std::is_integral_v<Coordinate>, std::int64_t, double>;

  [[noreturn]] void fail(const std::string& what) const {
    throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE, file_name_ + ": " + what);
  }

  /// \param columns what is allowed; 0 for an array of one dimension
  Hdf5_reader::Array array(const Hdf5_reader& file, const std::string& path,
                           std::initializer_list<std::size_t> columns) {
    ++arrays_begun_;
    Hdf5_reader::Array result = file.array(path);
    if (std::find(columns.begin(), columns.end(), result.columns()) == columns.end())
      fail(path + " has " + shape(result.columns()) + ", not " + shape(*columns.begin()));
    if (result.rows() > limit_) fail(path + " has more rows than indices can name");
    return result;
  }
  template <class Row_number, class F>
  void for_each_row(const Hdf5_reader::Array& rows, const F& f) const {
    rows.template for_each_row<Row_number>(slice_.begin(rows.rows()), slice_.end(rows.rows()), f);
  }
  std::size_t rows_of_slice(std::size_t rows) const { return slice_.end(rows) - slice_.begin(rows); }
  static std::string shape(std::size_t columns) {
    return columns == 0 ? "one dimension" : std::to_string(columns) + (columns == 1 ? " column" : " columns");
  }

  static Point point(const Number* row) {
    const auto x =
        static_cast<std::conditional_t<std::is_integral_v<Coordinate>, Coordinate, double>>(row[0]);
    const auto y = static_cast<decltype(x)>(row[1]);
    if constexpr (std::is_constructible_v<Point, decltype(x), decltype(y)>)
      return Point(x, y);
    else
      return Point{x, y};
  }

  void read_vertices(const Hdf5_reader& file) {
    const auto vertices = array(file, "/pslg/vertices", {2});
    const std::size_t n = number_of_vertices_ = vertices.rows();
    graph_.vertices.reserve(rows_of_slice(n));
    for_each_row<Number>(vertices,
                         [this](std::size_t, const Number* row) { graph_.vertices.push_back(point(row)); });
    graph_.vertex_markers = markers(file, "/pslg/vertex_markers", n, "vertices");
    if (!file.has("/pslg/vertex_attributes")) return;
    ++arrays_begun_;
    const auto attributes = file.array("/pslg/vertex_attributes");
    check_length("/pslg/vertex_attributes", attributes.rows(), n, "vertices");
    const std::size_t width = std::max<std::size_t>(attributes.columns(), 1);
    graph_.number_of_vertex_attributes = width;
    graph_.vertex_attributes.reserve(rows_of_slice(n) * width);
    for_each_row<double>(attributes, [&](std::size_t, const double* row) {
      graph_.vertex_attributes.insert(graph_.vertex_attributes.end(), row, row + width);
    });
  }

  template <class Reserve, class Add_segment>
  void read_segments(const Hdf5_reader& file, const Reserve& reserve, const Add_segment& add) {
    if (!file.has("/pslg/segments")) return;
    const auto segments = array(file, "/pslg/segments", {2});
    check_whole("/pslg/segments", segments);
    number_of_segments_ = segments.rows();
    reserve(rows_of_slice(segments.rows()));
    for_each_row<std::int64_t>(segments, [&](std::size_t s, const std::int64_t* row) {
      for (const std::int64_t* end = row; end < row + 2; ++end)
        if (*end < 0 || static_cast<std::uint64_t>(*end) >= number_of_vertices_)
          fail("/pslg/segments: row " + std::to_string(s) + ": there is no vertex " + std::to_string(*end) +
               (number_of_vertices_ == 0
                    ? std::string()
                    : ", the vertices are 0 to " + std::to_string(number_of_vertices_ - 1)));
      add(row[0], row[1]);
    });
    graph_.segment_markers = markers(file, "/pslg/segment_markers", number_of_segments_, "segments");
  }

  void read_regions(const Hdf5_reader& file) {
    if (!file.has("/pslg/regions")) return;
    const auto regions = array(file, "/pslg/regions", {4, 3});
    const bool has_areas = regions.columns() == 4;
    // Places of whole numbers beside attributes that need not be: all as doubles.
    for_each_row<double>(regions, [&](std::size_t, const double* row) {
      const Number place[] = {static_cast<Number>(row[0]), static_cast<Number>(row[1])};
      graph_.regions.push_back({point(place), row[2], has_areas ? std::max(row[3], 0.) : 0.});
    });
  }

  std::vector<int> markers(const Hdf5_reader& file, const std::string& path, std::size_t n, const char* of) {
    std::vector<int> result;
    if (!file.has(path)) return result;
    const auto values = array(file, path, {0, 1});
    check_whole(path, values);
    check_length(path, values.rows(), n, of);
    result.reserve(rows_of_slice(n));
    for_each_row<std::int64_t>(values, [&](std::size_t i, const std::int64_t* value) {
      if (*value != static_cast<int>(*value))
        fail(path + ": row " + std::to_string(i) + ": " + std::to_string(*value) + " has more than 32 bits");
      result.push_back(static_cast<int>(*value));
    });
    return result;
  }

  void check_whole(const std::string& path, const Hdf5_reader::Array& values) const {
    if (!values.has_whole_numbers()) fail(path + " has numbers that are not whole");
  }
  void check_length(const std::string& path, std::size_t rows, std::size_t n, const char* of) const {
    if (rows != n) fail(path + " has " + std::to_string(rows) + " rows for " + std::to_string(n) + ' ' + of);
  }

  std::string file_name_;
  Hdf5_slice slice_;
  std::size_t limit_;
  Pslg_2<Point> graph_;
  std::size_t number_of_vertices_ = 0, number_of_segments_ = 0;
  std::int64_t arrays_begun_ = 0;
};

/// See `IO::write_HDF5()`.
template <class Point>
void write_hdf5_graph(Hdf5_writer& out, const Pslg_2<Point>& graph) {
  // Words as words; those of 64 bits are on grids of 2^62 units.
  using Number = std::conditional_t<std::is_integral_v<Coordinate_t<Point>>, std::int64_t, double>;
  const auto coordinate = [](const Point& p, std::size_t k) {
    if constexpr (std::is_integral_v<Coordinate_t<Point>>)
      return static_cast<Number>(k == 0 ? p.x() : p.y());
    else
      return as_double(k == 0 ? p.x() : p.y());
  };
  const auto add_points = [&](const char* path, const std::vector<Point>& points) {
    out.add_array(path, points.size(), 2,
                  [&](std::size_t i, std::size_t k) { return coordinate(points[i], k); });
  };
  const auto add_markers = [&](const char* path, const std::vector<int>& markers) {
    if (!markers.empty())
      out.add_array(path, markers.size(), 0,
                    [&](std::size_t i, std::size_t) { return static_cast<std::int32_t>(markers[i]); });
  };
  const std::size_t width = graph.number_of_vertex_attributes;
  out.add_group("/pslg");
  add_points("/pslg/vertices", graph.vertices);
  add_markers("/pslg/vertex_markers", graph.vertex_markers);
  if (width > 0)
    out.add_array("/pslg/vertex_attributes", graph.vertices.size(), width,
                  [&](std::size_t v, std::size_t k) { return graph.vertex_attributes[v * width + k]; });
  out.add_array("/pslg/segments", graph.segments.size(), 2, [&](std::size_t s, std::size_t k) {
    return static_cast<std::int64_t>(graph.segments[s][k].value());
  });
  add_markers("/pslg/segment_markers", graph.segment_markers);
  if (!graph.holes.empty()) add_points("/pslg/holes", graph.holes);
  if (graph.regions.empty()) return;
  out.add_array("/pslg/regions", graph.regions.size(), 4, [&](std::size_t r, std::size_t k) {
    const auto& region = graph.regions[r];
    return k < 2    ? as_double(k == 0 ? region.point.x() : region.point.y())
           : k == 2 ? region.attribute
                    : region.max_area;
  });
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_GRAPH_H
