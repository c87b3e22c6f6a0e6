// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_READ_TRIANGLE_FILES_H
#define CGAL_IO_READ_TRIANGLE_FILES_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_scanner.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/internal/io/read_whole_file.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <istream>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Reads the files of Jonathan Shewchuk's Triangle: .poly, .node, .ele and .area
// (https://www.cs.cmu.edu/~quake/triangle.html), in one pass over the text in memory. Triangle takes what it
// cannot read for zero. Here anything doubtful is an error that tells file and line.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The vertices of another file that a list of vertices has to repeat.
template <class Point>
struct Vertices_to_repeat {
  const std::vector<Point>& points;
  std::size_t least;     ///< so many of the first ones will do
  std::string file_name; ///< where they are
};

/// What stands at the head of a section.
struct Triangle_section {
  std::size_t n;
  std::size_t attributes;
  bool has_markers;
};

/// Reads the sections of Triangle's files, one after the other, from a scanner into a graph: whole ones, or headers and
/// records one by one.
template <class Point>
class Triangle_parser {
public:
  static constexpr std::size_t index_limit = (std::numeric_limits<Vertex_index::size_type>::max)() - 1;

  /// \param limit of counts
  Triangle_parser(Line_scanner& scanner, Pslg_2<Point>& pslg, std::size_t limit = index_limit)
      : scanner_(scanner), pslg_(pslg), limit_(limit) {}

  /// \name Vertices
  /// <# of vertices> <dimension (2)> <# of attributes> <# of markers (0 or 1)>, then
  /// <vertex #> <x> <y> [attributes] [marker]
  /// \param same what they have to be, if there are any; null: anything
  /// @{
  void read_vertices(const Vertices_to_repeat<Point>* same = nullptr) {
    const Triangle_section section = read_vertex_header();
    if (same != nullptr && section.n > 0 && section.n != same->points.size() && section.n != same->least)
      scanner_.fail("there are " + std::to_string(section.n) + " vertices, but " +
                    std::to_string(same->points.size()) + " in " + same->file_name);
    make_room_for_vertices(section.n, section);
    for (std::size_t i = 0; i < section.n; ++i) {
      read_vertex(i, section);
      if (same != nullptr && !are_equal(pslg_.vertices[i], same->points[i]))
        scanner_.fail("vertex " + std::to_string(pslg_.first_number + i) + " is elsewhere in " +
                      same->file_name);
    }
    number_of_vertices_ = section.n;
  }

  Triangle_section read_vertex_header() {
    scanner_.next_line({"the number of vertices"});
    Triangle_section section{};
    section.n = read_count("the number of vertices");
    const std::size_t dimension = optional_count("the dimension", 2);
    if (dimension != 2) scanner_.fail("the dimension is " + std::to_string(dimension) + " instead of 2");
    section.attributes = optional_count("the number of attributes", 0);
    section.has_markers = read_has_markers();
    scanner_.skip_more_columns({"a column behind the header"});
    pslg_.number_of_vertex_attributes = section.attributes;
    return section;
  }

  /// Makes room for so many more vertices, as far as the text that is left may have them.
  void make_room_for_vertices(std::size_t n, const Triangle_section& section) {
    const std::size_t believable = (std::min)(n, scanner_.remaining() / shortest_vertex + 1);
    pslg_.vertices.reserve(pslg_.vertices.size() + believable);
    if (section.attributes > 0)
      pslg_.vertex_attributes.reserve(pslg_.vertex_attributes.size() +
                                      (std::min)(scanner_.remaining() / 2, believable * section.attributes));
    if (section.has_markers) pslg_.vertex_markers.reserve(pslg_.vertex_markers.size() + believable);
  }

  /// \param i which one of all, counted from 0; the first one tells from where the file counts
  void read_vertex(std::size_t i, const Triangle_section& section) {
    scanner_.next_line({"vertex", i});
    const std::int64_t number = scanner_.template read<std::int64_t>({"the number of vertex", i});
    if (i == 0) {
      if (number != 0 && number != 1)
        scanner_.fail("the first vertex has the number " + std::to_string(number) + " instead of 0 or 1");
      pslg_.first_number = static_cast<std::size_t>(number);
    }
    if (number != static_cast<std::int64_t>(pslg_.first_number + i))
      scanner_.fail("vertex " + std::to_string(number) + " stands where vertex " +
                    std::to_string(pslg_.first_number + i) + " is expected");
    pslg_.vertices.push_back(
        read_point({"x of vertex", pslg_.first_number + i}, {"y of vertex", pslg_.first_number + i}));
    for (std::size_t k = 0; k < section.attributes; ++k)
      pslg_.vertex_attributes.push_back(
          scanner_.template read<double>({"an attribute of vertex", pslg_.first_number + i}));
    if (section.has_markers)
      pslg_.vertex_markers.push_back(
          scanner_.template read<int>({"the marker of vertex", pslg_.first_number + i}));
    scanner_.skip_more_columns({"a column behind vertex", pslg_.first_number + i});
  }

  /// How many vertices there are, if they were read elsewhere.
  void set_number_of_vertices(std::size_t n) { number_of_vertices_ = n; }
  /// @}

  /// \name Segments
  /// <# of segments> <# of markers (0 or 1)>, then <segment #> <endpoint> <endpoint> [marker]
  /// @{
  void read_segments() {
    const Triangle_section section = read_segment_header();
    const std::size_t believable = (std::min)(section.n, scanner_.remaining() / shortest_segment + 1);
    pslg_.segments.reserve(believable);
    if (section.has_markers) pslg_.segment_markers.reserve(believable);
    for (std::size_t i = 0; i < section.n; ++i) {
      const std::array<std::size_t, 2> ends = read_segment(i, section);
      pslg_.segments.push_back({Vertex_index(ends[0]), Vertex_index(ends[1])});
    }
  }

  Triangle_section read_segment_header() {
    scanner_.next_line({"the number of segments"});
    Triangle_section section{};
    section.n = read_count("the number of segments");
    section.has_markers = read_has_markers();
    scanner_.skip_more_columns({"a column behind the header"});
    return section;
  }

  /// The ends, counted from 0. The marker goes to the graph.
  std::array<std::size_t, 2> read_segment(std::size_t i, const Triangle_section& section) {
    const std::size_t number = pslg_.first_number + i;
    scanner_.next_line({"segment", number});
    scanner_.template read<std::int64_t>({"the number of segment", number}); // Triangle ignores it, too
    const std::size_t a = read_vertex_number({"an end of segment", number});
    const std::size_t b = read_vertex_number({"an end of segment", number});
    if (section.has_markers)
      pslg_.segment_markers.push_back(scanner_.template read<int>({"the marker of segment", number}));
    scanner_.skip_more_columns({"a column behind segment", number});
    return {{a, b}};
  }
  /// @}

  /// \name Holes
  /// <# of holes>, then <hole #> <x> <y>
  /// @{
  void read_holes() {
    const std::size_t n = read_hole_header();
    for (std::size_t i = 0; i < n; ++i) read_hole(i);
  }

  std::size_t read_hole_header() {
    scanner_.next_line({"the number of holes"});
    const std::size_t n = read_count("the number of holes");
    scanner_.skip_more_columns({"a column behind the header"});
    return n;
  }

  void read_hole(std::size_t i) {
    const std::size_t number = pslg_.first_number + i;
    scanner_.next_line({"hole", number});
    scanner_.template read<std::int64_t>({"the number of hole", number});
    pslg_.holes.push_back(read_point({"x of hole", number}, {"y of hole", number}));
    scanner_.skip_more_columns({"a column behind hole", number});
  }
  /// @}

  /// \name Regions
  /// Optional: <# of regions>, then <region #> <x> <y> <attribute> [maximum area]
  /// @{
  void read_regions() {
    const std::size_t n = read_region_header();
    for (std::size_t i = 0; i < n; ++i) read_region(i);
  }

  std::size_t read_region_header() {
    if (!scanner_.try_next_line()) return 0;
    const std::size_t n = read_count("the number of regions");
    scanner_.skip_more_columns({"a column behind the header"});
    return n;
  }

  void read_region(std::size_t i) {
    const std::size_t number = pslg_.first_number + i;
    scanner_.next_line({"region", number});
    scanner_.template read<std::int64_t>({"the number of region", number});
    const Point point = read_point({"x of region", number}, {"y of region", number});
    const double attribute = scanner_.template read<double>({"the attribute of region", number});
    double max_area = 0;
    if (scanner_.has_more_columns())
      max_area = scanner_.template read<double>({"the maximum area of region", number});
    // Triangle writes -1 for none.
    pslg_.regions.push_back({point, attribute, (std::max)(max_area, 0.)});
    scanner_.skip_more_columns({"a column behind region", number});
  }
  /// @}

  /// <# of triangles> <nodes per triangle> <# of attributes>, then <triangle #> <node> <node> <node> ...
  /// [attributes]
  /// \param attributes where the first of each triangle goes, if there are any; null: nowhere
  /// \param middle_nodes where the nodes behind the corners go if there are six of each triangle; null: there have to
  /// be three
  void read_triangles(std::vector<std::array<Vertex_index, 3>>& triangles,
                      std::vector<double>* attributes = nullptr,
                      std::vector<Vertex_index>* middle_nodes = nullptr) {
    scanner_.next_line({"the number of triangles"});
    const std::size_t n = read_count("the number of triangles");
    const std::size_t nodes = optional_count("the number of nodes per triangle", 3);
    if (nodes != 3 && (nodes != 6 || middle_nodes == nullptr))
      scanner_.fail("triangles have " + std::to_string(nodes) + " nodes instead of 3" +
                    (middle_nodes != nullptr ? " or 6" : ""));
    if (optional_count("the number of attributes", 0) == 0) attributes = nullptr;
    scanner_.skip_more_columns({"a column behind the header"});
    triangles.reserve((std::min)(n, scanner_.remaining() / shortest_triangle + 1));
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t number = pslg_.first_number + i;
      scanner_.next_line({"triangle", number});
      scanner_.template read<std::int64_t>({"the number of triangle", number});
      std::array<Vertex_index, 3> t;
      for (Vertex_index& v : t) v = Vertex_index(read_vertex_number({"a node of triangle", number}));
      triangles.push_back(t);
      for (std::size_t k = 3; k < nodes; ++k)
        middle_nodes->push_back(Vertex_index(read_vertex_number({"a node of triangle", number})));
      if (attributes != nullptr)
        attributes->push_back(scanner_.template read<double>({"the attribute of triangle", number}));
      scanner_.skip_more_columns({"an attribute of triangle", number});
    }
  }

  /// <# of triangles>, then <triangle #> <largest area>
  void read_areas(std::size_t number_of_triangles, std::vector<double>& areas) {
    scanner_.next_line({"the number of areas"});
    const std::size_t n = read_count("the number of areas");
    if (n != number_of_triangles)
      scanner_.fail("there are " + std::to_string(n) + " areas for " + std::to_string(number_of_triangles) +
                    " triangles");
    scanner_.skip_more_columns({"a column behind the header"});
    areas.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t number = pslg_.first_number + i;
      scanner_.next_line({"the area of triangle", number});
      scanner_.template read<std::int64_t>({"the number of triangle", number});
      areas.push_back(scanner_.template read<double>({"the area of triangle", number}));
      scanner_.skip_more_columns({"a column behind the area of triangle", number});
    }
  }

  void read_end() {
    if (scanner_.try_next_line()) scanner_.fail("nothing more is expected");
  }

private:
  static bool are_equal(const Point& p, const Point& q) { return p.x() == q.x() && p.y() == q.y(); }

  using Coordinate = Coordinate_t<Point>;
  /// Reads words as words, everything else as doubles.
  using Number = std::conditional_t<std::is_integral_v<Coordinate>, Coordinate, double>;

  // The shortest line is "0 0 0". This bounds the number of records that can follow, whatever a header claims.
  static constexpr std::size_t shortest_vertex = 6;
  static constexpr std::size_t shortest_segment = 6;
  static constexpr std::size_t shortest_triangle = 8;
  std::size_t read_count(const char* what) {
    const std::int64_t count = scanner_.template read<std::int64_t>({what});
    if (count < 0) scanner_.fail(std::string(what) + " is negative");
    if (static_cast<std::uint64_t>(count) > limit_)
      scanner_.fail(std::string(what) + ", " + std::to_string(count) + ", is more than indices can name");
    return static_cast<std::size_t>(count);
  }

  std::size_t optional_count(const char* what, std::size_t fallback) {
    return scanner_.has_more_columns() ? read_count(what) : fallback;
  }

  bool read_has_markers() {
    const std::size_t markers = optional_count("the number of markers", 0);
    if (markers > 1)
      scanner_.fail("the number of markers is " + std::to_string(markers) + " instead of 0 or 1");
    return markers == 1;
  }

  Point read_point(Column_name x_name, Column_name y_name) {
    const Number x = scanner_.template read<Number>(x_name);
    const Number y = scanner_.template read<Number>(y_name);
    if constexpr (std::is_constructible_v<Point, Number, Number>)
      return Point(x, y);
    else
      return Point{x, y};
  }

  std::size_t read_vertex_number(Column_name column) {
    const std::int64_t number = scanner_.template read<std::int64_t>(column);
    const std::int64_t first = static_cast<std::int64_t>(pslg_.first_number);
    if (number < first || number - first >= static_cast<std::int64_t>(number_of_vertices_))
      scanner_.fail(column.to_string() + ": there is no vertex " + std::to_string(number) +
                    (number_of_vertices_ == 0
                         ? std::string(", there are no vertices at all")
                         : ", the vertices are " + std::to_string(pslg_.first_number) + " to " +
                               std::to_string(pslg_.first_number + number_of_vertices_ - 1)));
    return static_cast<std::size_t>(number - first);
  }

  Line_scanner& scanner_;
  Pslg_2<Point>& pslg_;
  std::size_t limit_;
  std::size_t number_of_vertices_ = pslg_.vertices.size();
};

/// The .node file of a .poly file, or nothing if there is none. Either may be compressed (.gz).
inline std::string find_node_file(std::string file_name) {
  const auto drop_ending = [&file_name](const std::string& ending) {
    const bool has_ending = file_name.size() >= ending.size() &&
                            file_name.compare(file_name.size() - ending.size(), ending.size(), ending) == 0;
    if (has_ending) file_name.resize(file_name.size() - ending.size());
    return has_ending;
  };
  const bool is_packed = drop_ending(".gz");
  drop_ending(".poly");
  const std::string plain = file_name + ".node", packed = plain + ".gz";
  for (const std::string& name : {is_packed ? packed : plain, is_packed ? plain : packed})
    if (std::ifstream(name).good()) return name;
  return std::string();
}

/// The name of an .ele file without its ending, behind which there may be `.gz`.
inline std::string stem_of_triangle_file(std::string file_name) {
  const auto drop = [&file_name](const std::string& ending) {
    if (file_name.size() > ending.size() &&
        file_name.compare(file_name.size() - ending.size(), ending.size(), ending) == 0)
      file_name.resize(file_name.size() - ending.size());
  };
  drop(".gz"), drop(".ele");
  return file_name;
}

/// The file, or the same compressed by gzip; empty if there is neither.
inline std::string existing_triangle_file(const std::string& file_name) {
  for (const std::string& name : {file_name, file_name + ".gz"})
    if (std::ifstream(name).good()) return name;
  return std::string();
}

/// Whether a .poly file leaves its vertices to a .node file, known before `parse_triangle_poly()` finds out.
inline bool has_no_vertices(const std::string& file_name) {
  const std::string text = read_whole_file(file_name);
  Line_scanner scanner(text, file_name);
  scanner.next_line({"the number of vertices"});
  return scanner.read<std::int64_t>({"the number of vertices"}) == 0;
}

/// Reads the vertices of a .node file.
template <class Point>
void parse_triangle_node(const std::string& text, const std::string& name, Pslg_2<Point>& pslg) {
  Line_scanner scanner(text, name);
  Triangle_parser<Point> parser(scanner, pslg);
  parser.read_vertices();
  parser.read_end();
}

/// \param node_name the file with the vertices if `text` has none; may be empty.
template <class Point>
Pslg_2<Point> parse_triangle_poly(const std::string& text, const std::string& name,
                                  const std::string& node_name) {
  Pslg_2<Point> pslg;
  Line_scanner scanner(text, name);
  Triangle_parser<Point> parser(scanner, pslg);
  parser.read_vertices();
  if (pslg.vertices.empty()) {
    if (node_name.empty()) scanner.fail("no vertices here, and no .node file beside it that has them");
    pslg.number_of_vertex_attributes = 0;
    parse_triangle_node(read_whole_file(node_name), node_name, pslg);
    parser.set_number_of_vertices(pslg.vertices.size());
  }
  parser.read_segments();
  parser.read_holes();
  parser.read_regions();
  parser.read_end();
  return pslg;
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Reads a planar straight-line graph from a `.poly` file of Triangle, also from one compressed by gzip
/// (which needs a program linked with Boost.Iostreams).
///
/// Vertices may be numbered from 0 or from 1, which `Pslg_2::first_number` keeps for messages and for written
/// files; indices are 0-based. If the file has 0 vertices, they are taken from the `.node` file of the same
/// stem. A comment reaches from `#` to the end of its line. Regions have an attribute and, if there is one more
/// column, a largest area. Coordinates are the doubles nearest to the
/// decimals, or words if the coordinates of `Point` are integers. Only the indices of segments are checked;
/// see `check_pslg_structure()` and `repair_pslg_2()`. Takes linear time.
/// \throws Pslg_error_2 with file, line and culprit if the file is missing, truncated or malformed; `pslg` is
/// then unchanged.
template <class Point>
void read_triangle_poly(const std::string& file_name, Pslg_2<Point>& pslg) {
  namespace internal = Quadtree_mesh_2::internal;
  pslg = internal::parse_triangle_poly<Point>(internal::read_whole_file(file_name), file_name,
                                              internal::find_node_file(file_name));
}

/// The same from a stream, whose text has to contain the vertices.
/// \throws Pslg_error_2 as above, with `name` for the name of the file.
template <class Point>
void read_triangle_poly(std::istream& in, Pslg_2<Point>& pslg, const std::string& name = "input") {
  namespace internal = Quadtree_mesh_2::internal;
  const std::string text = internal::read_whole_stream(in, name);
  pslg = internal::parse_triangle_poly<Point>(text, name, std::string());
}

/// Reads vertices with their attributes and markers from a `.node` file: a graph without segments.
/// \throws Pslg_error_2 as `read_triangle_poly()` does; `pslg` is then unchanged.
template <class Point>
void read_triangle_node(const std::string& file_name, Pslg_2<Point>& pslg) {
  namespace internal = Quadtree_mesh_2::internal;
  Pslg_2<Point> result;
  internal::parse_triangle_node(internal::read_whole_file(file_name), file_name, result);
  pslg = std::move(result);
}

/// The same from a stream.
/// \throws Pslg_error_2 as above, with `name` for the name of the file.
template <class Point>
void read_triangle_node(std::istream& in, Pslg_2<Point>& pslg, const std::string& name = "input") {
  namespace internal = Quadtree_mesh_2::internal;
  Pslg_2<Point> result;
  internal::parse_triangle_node(internal::read_whole_stream(in, name), name, result);
  pslg = std::move(result);
}

/// Reads points and triangles of a mesh from `stem.node` and `stem.ele`. Everything else in `mesh` becomes
/// empty.
/// \throws Pslg_error_2 as `read_triangle_poly()` does; `mesh` is then unchanged.
template <class Point>
void read_triangle_files(const std::string& stem, Indexed_mesh_2<Point>& mesh) {
  namespace internal = Quadtree_mesh_2::internal;
  const std::string node_name = stem + ".node", ele_name = stem + ".ele";
  Pslg_2<Point> nodes;
  internal::parse_triangle_node(internal::read_whole_file(node_name), node_name, nodes);
  const std::string text = internal::read_whole_file(ele_name);
  internal::Line_scanner scanner(text, ele_name);
  internal::Triangle_parser<Point> parser(scanner, nodes);
  Indexed_mesh_2<Point> result;
  parser.read_triangles(result.triangles);
  parser.read_end();
  result.points = std::move(nodes.vertices);
  mesh = std::move(result);
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_TRIANGLE_FILES_H
