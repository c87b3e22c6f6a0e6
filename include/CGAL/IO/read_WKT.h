// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_READ_WKT_H
#define CGAL_IO_READ_WKT_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/WKT.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Simple_features.h>
#include <CGAL/Quadtree_mesh_2/internal/read_whole_file.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <exception>
#include <istream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Reads well-known text, by the adaptors of CGAL/IO/WKT.h to Boost.Geometry. CGAL's own function goes by lines, passes
// over what it does not know, prints its errors and tells no place; so geometries are told apart here.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Reads geometries, one after the other, and adds them to the features.
class Wkt_parser {
public:
  Wkt_parser(std::string_view text, const std::string& name, Simple_features& features)
      : text_(text), name_(name), features_(features) {}

  void read_all() {
    for (std::size_t begin = skip_blanks(0); begin < text_.size();) {
      const std::size_t end = end_of_geometry(begin);
      if (std::string_view geometry = text_.substr(begin, end - begin); !geometry.empty()) add(geometry, 0);
      begin = skip_blanks(end);
    }
  }

private:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  using Line_string = std::vector<Point>;
  using Polygon = Polygon_with_holes_2<Kernel>;
  static constexpr int max_depth_ = 100; // of collections in collections

  [[noreturn]] void fail(const std::string& what) const {
    throw Pslg_error_2(name_ + ':' + std::to_string(line_) + ": " + what);
  }

  static bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0 || c == ';'; }

  /// Goes over white space and semicolons, the names of reference systems of extended WKT, `SRID=4326;`, and comments,
  /// and counts lines.
  std::size_t skip_blanks(std::size_t i) {
    for (; i < text_.size(); ++i) {
      if (text_[i] == '#') i = std::min(text_.find('\n', i), text_.size() - 1);
      if (text_.compare(i, 5, "SRID=") == 0) i = std::min(text_.find_first_of(";\n", i), text_.size() - 1);
      if (text_[i] != '#' && !is_blank(text_[i])) return i;
      line_ += text_[i] == '\n';
    }
    return i;
  }

  /// A geometry ends with the parenthesis that closes its first one; one without any, `POINT EMPTY`, with its line.
  std::size_t end_of_geometry(std::size_t begin) {
    int depth = 0;
    first_line_ = line_;
    for (std::size_t i = begin; i < text_.size(); ++i) {
      const char c = text_[i];
      if (c == '\n' && depth == 0) return i;
      line_ += c == '\n';
      depth += (c == '(') - (c == ')');
      if (c == ')' && depth <= 0) return i + 1;
    }
    line_ = depth > 0 ? first_line_ : line_;
    if (depth > 0) fail("a parenthesis is not closed");
    return text_.size();
  }

  /// \param geometry begins with its type
  void add(std::string_view geometry, int depth) {
    const std::size_t last = line_;
    line_ = first_line_;
    const std::string type = type_of(geometry);
    // Boost.Geometry takes types in any case, but only known ones.
    if (type == "GEOMETRYCOLLECTION")
      add_parts(geometry.substr(type.size()), depth);
    else if (type == "POINT")
      add_point(geometry);
    else
      add_lines_or_polygons(type, geometry);
    line_ = last;
  }

  static std::string type_of(std::string_view geometry) {
    std::string type;
    for (const char c : geometry) {
      if (std::isalpha(static_cast<unsigned char>(c)) == 0) break;
      type += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return type;
  }

  /// "EMPTY" stands for the parentheses of a geometry that has nothing in it.
  bool is_empty(std::string_view geometry) const {
    if (geometry.find('(') != std::string_view::npos) return false;
    std::string_view rest = geometry.substr(type_of(geometry).size());
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    if (type_of(rest) != "EMPTY") fail("a geometry without parentheses is not EMPTY");
    return true;
  }

  void add_lines_or_polygons(const std::string& type, std::string_view text) {
    if (type == "MULTIPOINT") {
      std::vector<Point> points;
      CGAL::internal::Geometry_container<std::vector<Point>, boost::geometry::multi_point_tag> wrapped(
          points);
      read(text, wrapped);
      for (const Point& p : points) features_.add_point(place(p));
    } else if (type == "LINESTRING") {
      Line_string line;
      CGAL::internal::Geometry_container<Line_string, boost::geometry::linestring_tag> wrapped(line);
      read(text, wrapped);
      add_line(line);
    } else if (type == "MULTILINESTRING") {
      using Wrapped_line = CGAL::internal::Geometry_container<Line_string, boost::geometry::linestring_tag>;
      std::vector<Wrapped_line> lines;
      CGAL::internal::Geometry_container<std::vector<Wrapped_line>, boost::geometry::multi_linestring_tag>
          wrapped(lines);
      read(text, wrapped);
      for (const Wrapped_line& line : lines) add_line(*line.range);
    } else if (type == "POLYGON") {
      Polygon polygon;
      read(text, polygon);
      add_polygon(polygon);
    } else if (type == "MULTIPOLYGON") {
      std::vector<Polygon> polygons;
      CGAL::internal::Geometry_container<std::vector<Polygon>, boost::geometry::multi_polygon_tag> wrapped(
          polygons);
      read(text, wrapped);
      for (const Polygon& polygon : polygons) add_polygon(polygon);
    } else {
      fail("'" + type + "' is no type of geometry that is known here");
    }
  }

  template <class Geometry>
  void read(std::string_view text, Geometry& geometry) const {
    check_places(text);
    std::string one_line(text); // Boost.Geometry takes other white space for numbers
    std::replace_if(one_line.begin(), one_line.end(), is_blank, ' ');
    try {
      boost::geometry::read_wkt(one_line, geometry);
    } catch (const std::exception& error) {
      const std::string what = error.what(); // the whole geometry comes behind "in"
      fail(what.substr(0, what.find(" in '")));
    }
  }

  /// Boost.Geometry takes coordinates that are missing for zeros.
  void check_places(std::string_view text) const {
    std::size_t words = 2;
    bool is_in_word = false;
    for (const char c : text) {
      const bool is_mark = c == '(' || c == ')' || c == ',', is_word = !is_mark && !is_blank(c);
      if (is_word && !is_in_word) ++words;
      is_in_word = is_word;
      if (c != '(' && is_mark && words == 1) fail("a place has one coordinate only");
      if (is_mark) words = c == ')' ? 2 : 0;
    }
  }

  void add_point(std::string_view text) {
    if (is_empty(text)) return; // Boost.Geometry knows no empty point
    Point p;
    read(text, p);
    features_.add_point(place(p));
  }

  void add_line(const Line_string& line) {
    if (!line.empty()) features_.add_line(places(line), name_ + ':' + std::to_string(line_) + ": the line");
  }

  void add_polygon(const Polygon& polygon) {
    if (polygon.outer_boundary().is_empty()) return;
    const std::string name = name_ + ':' + std::to_string(line_) + ": ";
    features_.begin_polygon();
    features_.add_ring(places(polygon.outer_boundary().container()), name + "the outer ring");
    std::size_t holes = 0;
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
      features_.add_ring(places(hole->container()), name + "hole " + std::to_string(holes++));
  }

  template <class Range>
  Simple_features::Line places(const Range& points) const {
    Simple_features::Line line;
    for (const Point& p : points) line.push_back(place(p));
    return line;
  }
  Simple_features::Place place(const Point& p) const {
    if (!std::isfinite(p.x()) || !std::isfinite(p.y())) fail("a coordinate is not finite");
    return {p.x(), p.y()};
  }

  /// Adds what a collection consists of, between commas outside inner parentheses.
  void add_parts(std::string_view text, int depth) {
    if (is_empty(text)) return;
    if (depth == max_depth_) fail("collections are nested too deep");
    std::size_t begin = text.find('(') + 1;
    int open = 1;
    for (std::size_t i = begin; i < text.size() && open > 0; ++i) {
      open += (text[i] == '(') - (text[i] == ')');
      const bool is_end = (text[i] == ',' && open == 1) || open == 0;
      if (!is_end) continue;
      while (begin < i && is_blank(text[begin])) ++begin;
      add(text.substr(begin, i - begin), depth + 1);
      begin = i + 1;
    }
  }

  std::string_view text_;
  const std::string& name_;
  Simple_features& features_;
  std::size_t line_ = 1, first_line_ = 1; // now, and where the geometry begins
};

/// \throws Pslg_error_2
template <class Point>
Pslg_2<Point> parse_wkt(const std::string& text, const std::string& name) {
  Simple_features features;
  Wkt_parser(text, name, features).read_all();
  return features.to_pslg<Point>();
}

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// Reads a graph from a file of well-known text, or from one compressed by gzip: any number of `POLYGON`,
/// `MULTIPOLYGON`, `LINESTRING`, `MULTILINESTRING`, `POINT`, `MULTIPOINT` and `GEOMETRYCOLLECTION`, with white space or
/// semicolons between them.
///
/// They become a graph, with holes, as in `read_GeoJSON()`. Rings that are not closed are closed, as CGAL does.
/// \throws Pslg_error_2 with the file and the line where the geometry begins if the file is missing or malformed, or
/// a coordinate is not finite; `pslg` is then as it was.
/// \tparam Point can be made from two doubles.
template <class Point>
void read_WKT(const std::string& file_name, Pslg_2<Point>& pslg) {
  namespace internal = Quadtree_mesh_2::internal;
  pslg = internal::parse_wkt<Point>(internal::read_whole_file(file_name), file_name);
}

/// The same from a stream.
/// \throws Pslg_error_2 as above, with `name` for the name of the file.
template <class Point>
void read_WKT(std::istream& in, Pslg_2<Point>& pslg, const std::string& name = "input") {
  namespace internal = Quadtree_mesh_2::internal;
  pslg = internal::parse_wkt<Point>(internal::unpack_gzip(internal::read_whole_stream(in, name), name), name);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_WKT_H
