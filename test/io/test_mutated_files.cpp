// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Whatever a file says, a reader gives a graph with the places of the file and no others, or an error with its line.

#include "catch.h"
#include "mutate_text.h"
#include "scratch_folder.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_GeoJSON.h>
#include <CGAL/IO/read_WKT.h>
#include <CGAL/IO/read_XY.h>
#include <CGAL/IO/read_triangle_files.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace test_mutated_files {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point>;
using Place = std::array<double, 2>;

std::string data_file(const std::string& name) { return content(QUADTREE_MESH_TEST_DATA_DIR "/" + name); }

enum class Comments { NONE, BEHIND_HASH };

/// The words of a text between blanks and these marks, which are words, too; comments are none.
std::vector<std::string> words_of(const std::string& text, const std::string& marks, Comments comments) {
  std::vector<std::string> words;
  bool is_in_word = false, is_comment = false;
  for (const char c : text) {
    is_comment = c == '#' ? comments == Comments::BEHIND_HASH : is_comment && c != '\n' && c != '\r';
    const bool is_mark = marks.find(c) != std::string::npos,
               is_blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (is_comment || is_mark || is_blank) {
      is_in_word = false;
      if (is_mark && !is_comment) words.push_back(std::string(1, c));
      continue;
    }
    if (!is_in_word) words.emplace_back();
    words.back() += c;
    is_in_word = true;
  }
  return words;
}

std::optional<double> number_in(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (end != word.c_str() + word.size() || word.empty()) return std::nullopt;
  return value + 0.; // zero has two signs and is one place
}

/// What may stand before the x of a place, between x and y, and behind y: sets of marks; a blank stands for none.
struct Neighborhood {
  std::string before, between, behind;
};

/// All pairs of numbers of a text that can be places by what is around them.
std::set<Place> places_in(const std::string& text, const std::string& marks, Comments comments,
                          const Neighborhood& n) {
  const std::vector<std::string> words = words_of(text, marks, comments);
  const auto is_one_of = [&](std::size_t i, const std::string& allowed) {
    const bool is_mark =
        i < words.size() && words[i].size() == 1 && marks.find(words[i]) != std::string::npos;
    return is_mark ? allowed.find(words[i]) != std::string::npos : allowed.find(' ') != std::string::npos;
  };
  std::set<Place> places;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool has_mark_between =
        i + 1 < words.size() && words[i + 1].size() == 1 && n.between.find(words[i + 1]) != std::string::npos;
    const std::size_t j = i + (has_mark_between ? 2 : 1);
    if (j >= words.size() || (!has_mark_between && n.between.find(' ') == std::string::npos)) continue;
    const auto x = number_in(words[i]), y = number_in(words[j]);
    if (x && y && (i == 0 ? n.before.find(' ') != std::string::npos : is_one_of(i - 1, n.before)) &&
        is_one_of(j + 1, n.behind))
      places.insert({*x, *y});
  }
  return places;
}

struct Format {
  std::string name;
  std::vector<std::string> texts;
  std::function<void(std::istream&, Pslg&)> read;
  std::string marks;
  Comments comments;
  Neighborhood neighborhood;
  bool are_all_places_vertices; ///< those with such a neighborhood
};

std::vector<Format> formats() {
  const std::string poly =
      "5 2 1 1 # a box\n1 0 0 0.5 1\n2 4 0 1e2 2\n3 4 4 3 3\n4 0 4 -4 4\n5 1.5 1.25 7 0\n4 1\n"
      "1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n1\n1 1 1\n2\n1 3 3 17 0.25\n2 0.5 0.5 -18\n";
  const std::string wkt = "SRID=4326;POLYGON((0 0, 8 0, 8 8, 0 8, 0 0),(1 1, 3 1, 3 3, 1 1)) # lake\n"
                          "LINESTRING Z (10 0 5, 11 0 5.5, 11 1 6)\nMULTIPOINT((20 20), 21 21, EMPTY)\n"
                          "GEOMETRYCOLLECTION(POINT ZM(30 30 1 2), MULTILINESTRING((40 40, 41 41), EMPTY))\n";
  const auto poly_reader = [](std::istream& in, Pslg& g) { CGAL::IO::read_triangle_poly(in, g, "file"); };
  const auto wkt_reader = [](std::istream& in, Pslg& g) { CGAL::IO::read_WKT(in, g, "file"); };
  const auto geojson_reader = [](std::istream& in, Pslg& g) { CGAL::IO::read_GeoJSON(in, g, "", "file"); };
  const auto property_reader = [](std::istream& in, Pslg& g) {
    CGAL::IO::read_GeoJSON(in, g, "depth", "file");
  };
  const auto table_reader = [](std::istream& in, Pslg& g) { CGAL::IO::read_XY(in, g.vertices, "file"); };
  constexpr Comments hash = Comments::BEHIND_HASH, none = Comments::NONE;
  const Neighborhood of_words{" ", " ", " "}, of_wkt{"(,", " ", "), "}, of_json{"[", ",", "],"},
      of_table{" ,;", " ,;", " ,;"};
  const std::vector<std::string> json{data_file("island.geojson")},
      tables{"lon,lat\n0,0\n1.5,-0.2\n0.25,3\n", "0 0\n1 2 # here\n\n3;4\n"};
  return {{"poly", {poly, data_file("syn_square.poly")}, poly_reader, "", hash, of_words, false},
          {"wkt", {wkt, data_file("island.wkt")}, wkt_reader, "(),;", hash, of_wkt, true},
          {"geojson", json, geojson_reader, "[]{},:\"", none, of_json, false},
          {"property", json, property_reader, "[]{},:\"", none, of_json, false},
          {"table", tables, table_reader, ",;", hash, of_table, false}};
}

/// Reads a text; returns what the error says, empty if there is none.
std::string error_of(const Format& format, const std::string& text, Pslg& graph) {
  std::istringstream in(text);
  try {
    format.read(in, graph);
  } catch (const CGAL::Pslg_error_2& error) {
    return error.what();
  }
  return std::string();
}

bool names_line(const std::string& error) {
  return error.compare(0, 5, "file:") == 0 && error.size() > 8 && error[5] >= '1' && error[5] <= '9';
}

/// What `check_pslg_structure()` asks of arrays and numbers; the graph need not be one that can be meshed.
void check_arrays(const Pslg& graph) {
  const auto is_finite = [](const Point& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); };
  CHECK(std::all_of(graph.vertices.begin(), graph.vertices.end(), is_finite));
  CHECK(std::all_of(graph.holes.begin(), graph.holes.end(), is_finite));
  for (const auto& r : graph.regions)
    CHECK((is_finite(r.point) && std::isfinite(r.attribute) && r.max_area >= 0));
  for (const auto& s : graph.segments)
    for (const auto v : s) CHECK(std::size_t(v) < graph.vertices.size());
  CHECK((graph.vertex_markers.empty() || graph.vertex_markers.size() == graph.vertices.size()));
  CHECK((graph.segment_markers.empty() || graph.segment_markers.size() == graph.segments.size()));
  CHECK(graph.vertex_attributes.size() == graph.vertices.size() * graph.number_of_vertex_attributes);
}

void check_places(const Format& format, const std::string& text, const Pslg& graph) {
  check_arrays(graph);
  const std::set<Place> places = places_in(text, format.marks, format.comments, format.neighborhood);
  std::set<Place> vertices;
  for (const Point& p : graph.vertices) vertices.insert({p.x() + 0., p.y() + 0.});
  CHECK(std::includes(places.begin(), places.end(), vertices.begin(), vertices.end()));
  if (format.are_all_places_vertices) CHECK(vertices.size() == places.size());
}

} // namespace

TEST_CASE("a mutated file gives the places that it has, or an error with its line", "[mutated]") {
  const int rounds = is_full_run() ? 40000 : 1000;
  for (const Format& format : formats()) {
    std::size_t read = 0, refused = 0;
    for (int i = 0; i < rounds; ++i) {
      Text_mutator mutate(static_cast<std::uint64_t>(i));
      const std::string text = mutate(format.texts[static_cast<std::size_t>(i) % format.texts.size()]);
      CAPTURE(format.name, i, text);
      Pslg graph;
      const std::string error = error_of(format, text, graph);
      CAPTURE(error);
      if (error.empty())
        check_places(format, text, graph);
      else
        CHECK(names_line(error));
      ++(error.empty() ? read : refused);
    }
    CAPTURE(format.name, read, refused);
    CHECK(read > 50);
    CHECK(refused > 50);
  }
}

TEST_CASE("a mutated .node file beside a .poly file is read or named", "[mutated]") {
  const Scratch_folder folder;
  const std::string poly = folder.write("file.poly", "0 2 0 0\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  for (std::uint64_t i = 0; i < 500; ++i) {
    const std::string text = Text_mutator(i)("3 2 1 1\n1 0 0 7 1\n2 1 0 8 2\n3 0 1 9 3\n");
    folder.write("file.node", text);
    CAPTURE(i, text);
    Pslg graph;
    try {
      CGAL::IO::read_triangle_poly(poly, graph);
      check_arrays(graph);
    } catch (const CGAL::Pslg_error_2& error) {
      const std::string what = error.what();
      CHECK((what.find("file.node:") != std::string::npos || what.find("file.poly:") != std::string::npos));
    }
  }
}

TEST_CASE("a mutated .ele file is read or named", "[mutated]") {
  const Scratch_folder folder;
  folder.write("file.node", "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n");
  for (std::uint64_t i = 0; i < 500; ++i) {
    const std::string text = Text_mutator(i)("2 3 1\n0 0 1 2 5\n1 0 2 3 6\n");
    folder.write("file.ele", text);
    CAPTURE(i, text);
    CGAL::Indexed_mesh_2<Point> mesh;
    try {
      CGAL::IO::read_triangle_files(folder.file("file"), mesh);
      for (const auto& t : mesh.triangles)
        for (const auto v : t) CHECK(std::size_t(v) < mesh.points.size());
    } catch (const CGAL::Pslg_error_2& error) {
      CHECK(std::string(error.what()).find("file.ele:") != std::string::npos);
    }
  }
}

#ifdef CGAL_QUADTREE_MESH_2_HAS_GZIP
TEST_CASE("mutated gzip data are read or refused", "[mutated]") {
  const std::string packed = data_file("syn_holes_400.poly.gz");
  Pslg whole;
  std::istringstream in(packed);
  CGAL::IO::read_triangle_poly(in, whole);
  for (std::uint64_t i = 0; i < 300; ++i) {
    std::istringstream mutated(Text_mutator(i)(packed));
    Pslg graph;
    try {
      CGAL::IO::read_triangle_poly(mutated, graph, "file");
      CHECK(graph.vertices == whole.vertices); // the name of the packed file and its like may differ
      CHECK(graph.segments == whole.segments);
    } catch (const CGAL::Pslg_error_2& error) {
      CHECK(std::string(error.what()).compare(0, 5, "file:") == 0);
    }
  }
}
#endif

} // namespace test_mutated_files
