// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_READ_WKT_H
#define CGAL_IO_READ_WKT_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_scanner.h>
#include <CGAL/Quadtree_mesh_2/internal/io/printable.h>
#include <CGAL/Quadtree_mesh_2/internal/io/read_whole_file.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Simple_features.h>

#include <cctype>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <utility>

// Reads well-known text (OGC 06-103r4, and PostGIS's extended form) in one pass over its words. CGAL's
// readers build on Boost.Geometry and cannot serve here. They accept a missing comma, take a third number for
// the next x, a missing number for 0 and `nan` for a number, and tell no line.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Reads geometries, one after the other, and adds them to the features.
class Wkt_parser {
public:
  Wkt_parser(std::string_view text, const std::string& name, Simple_features& features)
      : scanner_(text, name), features_(features) {
    scanner_.set_separators("(),;");
  }

  void read_all() {
    while (scanner_.has_more()) {
      if (try_pass(';') || try_reference_system()) continue;
      read_geometry(0);
    }
  }

private:
  using Place = Simple_features::Place;
  using Line = Simple_features::Line;

  static constexpr int max_depth_ = 100; // of collections in collections

  // --- Words and marks, wherever lines end ---

  static std::string in_capitals(std::string_view word) {
    std::string capitals(word);
    for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return capitals;
  }
  bool is_at_word() { return scanner_.has_more() && scanner_.separator_ahead() == '\0'; }
  /// The next word in capitals, without consuming it; empty if there is a mark or nothing.
  std::string word_ahead() {
    return is_at_word() ? in_capitals(scanner_.word_ahead({"a word"})) : std::string();
  }
  bool try_word(const char* word) {
    if (word_ahead() != word) return false;
    scanner_.pass_word();
    return true;
  }
  bool try_pass(char mark) {
    if (!scanner_.has_more() || scanner_.separator_ahead() != mark) return false;
    scanner_.pass_separator();
    return true;
  }
  void pass(char mark, const char* expected) {
    if (try_pass(mark)) return;
    scanner_.require_more({expected});
    const char other = scanner_.separator_ahead();
    const std::string found =
        other != '\0' ? in_quotes(std::string(1, other)) : in_quotes(scanner_.word_ahead({"a word"}));
    scanner_.fail(std::string(expected) + " is expected before " + found);
  }

  /// "(element, element, ...)" or "EMPTY"; elements are counted from 0.
  template <class Read_element>
  void read_list(const Read_element& read_element) {
    if (try_word("EMPTY")) return;
    pass('(', "'(' or EMPTY");
    std::size_t i = 0;
    do read_element(i++);
    while (try_pass(','));
    pass(')', "',' or ')'");
  }

  // --- Geometries ---

  /// Reads "SRID=4326;" before a geometry of extended WKT. Coordinates are taken as they are, but those of
  /// two systems cannot share one plane.
  bool try_reference_system() {
    const std::string word = word_ahead();
    if (word.compare(0, 5, "SRID=") != 0) return false;
    if (word.size() == 5 || word.find_first_not_of("0123456789", 5) != std::string::npos)
      scanner_.fail("a number is expected in " + in_quotes(word));
    if (!reference_system_.empty() && word != reference_system_)
      scanner_.fail(in_quotes(word) + " is another reference system than " + in_quotes(reference_system_) +
                    " before");
    reference_system_ = word;
    scanner_.pass_word();
    pass(';', "';'");
    return true;
  }

  void read_geometry(int depth) {
    scanner_.require_more({"a type of geometry"});
    const std::string_view word = scanner_.word_ahead({"a type of geometry"});
    std::string type = in_capitals(word);
    tag_ = split_tag(type);
    const bool is_collection = type == "GEOMETRYCOLLECTION";
    const Read_body read_body = find_reader(type);
    if (!is_collection && !read_body)
      scanner_.fail(in_quotes(word) +
                    " is no type of geometry; known are POINT, LINESTRING, POLYGON, their MULTI... and "
                    "GEOMETRYCOLLECTION");
    scanner_.pass_word();
    for (const char* const tag : {"Z", "M", "ZM"})
      if (tag_.empty() && try_word(tag)) tag_ = tag;
    ordinates_ = tag_.empty() ? 0 : 2 + tag_.size();
    if (!is_collection) return (this->*read_body)();
    if (depth == max_depth_) scanner_.fail("collections are nested too deep");
    read_list([&](std::size_t) { read_geometry(depth + 1); });
  }

  /// Removes a tag from the end of a type: "POINTZ".
  static std::string split_tag(std::string& type) {
    const std::size_t end = type.find_last_not_of("ZM") + 1; // no type ends with these
    const std::string tag = type.substr(end);
    if (tag != "Z" && tag != "M" && tag != "ZM") return std::string();
    type.resize(end);
    return tag;
  }

  using Read_body = void (Wkt_parser::*)();
  /// The function that reads the rest of a geometry of this type, if the type is known.
  static Read_body find_reader(const std::string& type) {
    constexpr std::pair<const char*, Read_body> readers[] = {
        {"POINT", &Wkt_parser::read_point},     {"MULTIPOINT", &Wkt_parser::read_points},
        {"LINESTRING", &Wkt_parser::read_line}, {"MULTILINESTRING", &Wkt_parser::read_lines},
        {"POLYGON", &Wkt_parser::read_polygon}, {"MULTIPOLYGON", &Wkt_parser::read_polygons}};
    for (const auto& [name, reader] : readers)
      if (type == name) return reader;
    return nullptr;
  }

  void read_point() {
    read_list([this](std::size_t i) {
      if (i > 0) scanner_.fail("a point has one place only");
      features_.add_point(read_place(i));
    });
  }
  void read_points() {
    read_list([this](std::size_t i) { read_point_of_many(i); });
  }
  /// With parentheses or without.
  void read_point_of_many(std::size_t i) {
    const std::string word = word_ahead();
    if (word.empty() || word == "EMPTY")
      read_point();
    else
      features_.add_point(read_place(i));
  }

  void read_line() {
    const std::string place = begin();
    const Line line = read_places();
    if (!line.empty()) features_.add_line(line, [&] { return place + ": the line"; });
  }

  void read_lines() {
    read_list([this](std::size_t) { read_line(); });
  }

  void read_polygon() {
    bool has_outer_ring = false;
    read_list([&](std::size_t i) {
      const std::string place = begin();
      const Line ring = read_places();
      if (ring.empty()) return;
      if (i > 0 && !has_outer_ring) scanner_.fail("a hole is in a polygon without an outer ring");
      if (i == 0) features_.begin_polygon();
      has_outer_ring = true;
      features_.add_ring(
          ring, [&] { return place + (i == 0 ? ": the outer ring" : ": hole " + std::to_string(i - 1)); });
    });
  }

  void read_polygons() {
    read_list([this](std::size_t) { read_polygon(); });
  }

  /// The line of the file where the next word or mark is.
  std::string begin() {
    scanner_.has_more();
    return scanner_.place();
  }

  // --- Places ---

  Line read_places() {
    Line line;
    read_list([&](std::size_t i) { line.push_back(read_place(i)); });
    return line;
  }

  /// x and y, and the further numbers of the tag. Without a tag there may be a z.
  Place read_place(std::size_t i) {
    constexpr std::size_t most = 4;
    Place p{};
    std::size_t n = 0;
    for (; n < 2 || is_at_word(); ++n) {
      const Column_name name{n == 0 ? "x of place" : n == 1 ? "y of place" : "a further number of place", i};
      scanner_.require_more(name);
      const double number = scanner_.read<double>(name);
      if (n < 2) p[n] = number;
      if (n == most) fail_at_place(i, "has more numbers than x, y, z and m");
    }
    check_number_of_ordinates(i, n);
    return p;
  }

  /// The number is the same for all places of a geometry.
  void check_number_of_ordinates(std::size_t i, std::size_t n) {
    if (ordinates_ == 0 && n == 4) fail_at_place(i, "has four numbers and the geometry no tag ZM");
    if (ordinates_ == 0) ordinates_ = n;
    if (n == ordinates_) return;
    const std::string why =
        tag_.empty() ? "where others of the geometry have " : "where the tag " + tag_ + " asks for ";
    fail_at_place(i, "has " + std::to_string(n) + " numbers " + why + std::to_string(ordinates_));
  }
  [[noreturn]] void fail_at_place(std::size_t i, const std::string& what) const {
    scanner_.fail("place " + std::to_string(i) + ' ' + what + "; is a comma missing?");
  }

  Line_scanner scanner_;
  Simple_features& features_;
  std::string reference_system_; // of the geometries so far, empty if none was said
  std::string tag_;              // of the geometry
  std::size_t ordinates_ = 0;    // of each of its places, 0 if not known yet
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

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Reads a graph from a file of well-known text, also from one compressed by gzip. The file has any number of
/// `POLYGON`, `MULTIPOLYGON`, `LINESTRING`, `MULTILINESTRING`, `POINT`, `MULTIPOINT` and
/// `GEOMETRYCOLLECTION`, in lower or upper case, with white space or semicolons between them. A comment
/// reaches from `#` to the end of its line.
///
/// They become a graph, with holes, as in `read_GeoJSON()`. Rings that are not closed are closed. Heights and
/// measures are dropped. With the tags `Z`, `M` and `ZM` each place has three or four numbers. Without a tag
/// it has two, or three of which the last is a height. All places of a geometry have the same number of
/// numbers.
/// \throws Pslg_error_2 with the file and the line if the file is missing or malformed, or a number is not
/// finite; `pslg` is then unchanged.
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
  pslg = internal::parse_wkt<Point>(internal::read_whole_stream(in, name), name);
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_WKT_H
