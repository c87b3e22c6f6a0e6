// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "pslg_test_tools.h"

#include <CGAL/IO/Triangle_files.h>
#include <CGAL/find_pslg_defects.h>
#include <CGAL/repair_pslg_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_repair_pslg_2 {

using namespace pslg_test;
using Kind = CGAL::Pslg_defect_kind_2;
using Defects = std::vector<CGAL::Pslg_defect_2>;

namespace {

const auto splitting = CGAL::Pslg_repair_options_2().crossings(CGAL::Pslg_crossing_rule_2::SPLIT);

std::vector<std::string> texts(const Defects& defects) {
  std::vector<std::string> result;
  for (const CGAL::Pslg_defect_2& d : defects) result.push_back(d.to_string());
  return result;
}

std::vector<std::pair<std::size_t, std::size_t>> segment_pairs(const Pslg& pslg) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const auto& s : pslg.segments) result.emplace_back(s[0].value(), s[1].value());
  return result;
}

std::vector<std::size_t> values(const std::vector<Segment_index>& indices) {
  std::vector<std::size_t> result;
  for (const Segment_index i : indices) result.push_back(i.value());
  return result;
}

std::vector<std::size_t> values(const std::vector<Vertex_index>& indices) {
  std::vector<std::size_t> result;
  for (const Vertex_index i : indices) result.push_back(i.value());
  return result;
}

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
using Values = std::vector<std::size_t>;

// --- Brute force over small integers, all exact
// ------------------------------------------------------------------

/// A point with rational coordinates over one least positive denominator; equal points have equal numbers.
struct Rational_point {
  std::int64_t x, y, denominator;
  friend bool operator<(const Rational_point& a, const Rational_point& b) {
    return std::tie(a.x, a.y, a.denominator) < std::tie(b.x, b.y, b.denominator);
  }
  friend bool operator==(const Rational_point& a, const Rational_point& b) {
    return std::tie(a.x, a.y, a.denominator) == std::tie(b.x, b.y, b.denominator);
  }
};

Rational_point rational_point(std::int64_t x, std::int64_t y, std::int64_t denominator) {
  if (denominator < 0) return rational_point(-x, -y, -denominator);
  const std::int64_t divisor = std::gcd(std::gcd(x, y), denominator);
  return {x / divisor, y / divisor, denominator / divisor};
}

struct Integer_point {
  std::int64_t x, y;
};

std::int64_t turn(Integer_point a, Integer_point b, Integer_point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
int sign(std::int64_t x) { return (x > 0) - (x < 0); }

class Brute_force {
public:
  using Piece = std::pair<Rational_point, Rational_point>;

  explicit Brute_force(const Pslg& pslg) : pslg_(pslg) {
    for (const Point& p : pslg.vertices)
      places_.insert({static_cast<std::int64_t>(p.x()), static_cast<std::int64_t>(p.y()), 1});
    for (std::size_t s = 0; s < pslg.segments.size(); ++s) cut(s);
  }

  std::size_t duplicate_vertices() const { return pslg_.vertices.size() - places_.size(); }
  std::size_t zero_length_segments() const { return zero_length_segments_; }
  const std::set<std::pair<std::size_t, Rational_point>>& vertices_on_segments() const {
    return on_segments_;
  }
  const std::set<std::size_t>& overlapping_segments() const { return overlapping_; }
  /// Later segment and place, for each two that cross where no vertex is.
  const std::set<std::pair<std::size_t, Rational_point>>& crossings() const { return crossings_; }
  std::set<Rational_point> crossing_places() const {
    std::set<Rational_point> result;
    for (const auto& c : crossings_) result.insert(c.second);
    return result;
  }
  const std::set<Piece>& pieces() const { return pieces_; }

private:
  Integer_point end(std::size_t s, std::size_t k) const {
    const Point& p = pslg_.point(pslg_.segments[s][k]);
    return {static_cast<std::int64_t>(p.x()), static_cast<std::int64_t>(p.y())};
  }

  void cut(std::size_t s) {
    const Integer_point a = end(s, 0), b = end(s, 1);
    if (a.x == b.x && a.y == b.y) {
      ++zero_length_segments_;
      return;
    }
    std::vector<Rational_point> cuts{{a.x, a.y, 1}, {b.x, b.y, 1}};
    for (const Rational_point& p : places_)
      if (is_inside(s, {p.x, p.y})) {
        cuts.push_back(p);
        on_segments_.emplace(s, p);
      }
    for (std::size_t t = 0; t < pslg_.segments.size(); ++t) {
      Rational_point p{};
      if (!find_crossing(s, t, p) || places_.count(p) > 0) continue;
      cuts.push_back(p);
      if (t < s) crossings_.emplace(s, p);
    }
    // Along the segment, which is steep or not: by x, then by y, in floating point good enough for small
    // numbers.
    std::sort(cuts.begin(), cuts.end(), [](const Rational_point& p, const Rational_point& q) {
      return std::make_pair(p.x * q.denominator, p.y * q.denominator) <
             std::make_pair(q.x * p.denominator, q.y * p.denominator);
    });
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      if (!pieces_.emplace(cuts[i], cuts[i + 1]).second) overlapping_.insert(s);
  }

  bool is_inside(std::size_t s, Integer_point p) const {
    const Integer_point a = end(s, 0), b = end(s, 1);
    return turn(a, b, p) == 0 && (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) < 0;
  }

  bool find_crossing(std::size_t s, std::size_t t, Rational_point& p) const {
    const Integer_point a = end(s, 0), b = end(s, 1), c = end(t, 0), d = end(t, 1);
    if (sign(turn(a, b, c)) * sign(turn(a, b, d)) >= 0 || sign(turn(c, d, a)) * sign(turn(c, d, b)) >= 0)
      return false;
    const std::int64_t u = turn(c, d, a), w = u - turn(c, d, b);
    p = rational_point(a.x * w + u * (b.x - a.x), a.y * w + u * (b.y - a.y), w);
    return true;
  }

  const Pslg& pslg_;
  std::set<Rational_point> places_;
  std::size_t zero_length_segments_ = 0;
  std::set<std::pair<std::size_t, Rational_point>> on_segments_, crossings_;
  std::set<std::size_t> overlapping_;
  std::set<Piece> pieces_;
};

/// Segments between random vertices of a small grid: full of duplicates, overlaps, T-junctions and crossings.
Pslg random_grid_pslg(unsigned seed, int size, std::size_t vertices, std::size_t segments) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> coordinate(0, size);
  std::uniform_int_distribution<std::size_t> vertex(0, vertices + 2);
  Pslg pslg = make_pslg<double>({{0, 0}, {double(size), 0}, {0, double(size)}});
  for (std::size_t i = 0; i < vertices; ++i) {
    const int x = coordinate(random), y = coordinate(random);
    pslg.add_vertex(Point(x, y));
  }
  for (std::size_t i = 0; i < segments; ++i) {
    const std::size_t a = vertex(random), b = vertex(random);
    pslg.add_segment(Vertex_index(a), Vertex_index(b));
  }
  return pslg;
}

std::size_t count(const Defects& defects, Kind kind) {
  return static_cast<std::size_t>(
      std::count_if(defects.begin(), defects.end(), [kind](const auto& d) { return d.kind == kind; }));
}

std::set<std::size_t> named_segments(const Defects& defects, Kind kind) {
  std::set<std::size_t> result;
  for (const CGAL::Pslg_defect_2& d : defects)
    if (d.kind == kind) result.insert(d.segment.value());
  return result;
}

/// What holds for every repaired graph.
void check_repaired(const Pslg& input, const Pslg& output, const CGAL::Pslg_repair_report_2& report) {
  REQUIRE_NOTHROW(CGAL::validate_pslg_2(output));
  CHECK(texts(CGAL::find_pslg_defects(output)).empty());
  REQUIRE(report.vertex_map.size() == input.vertices.size());
  REQUIRE(report.segment_origin.size() == output.segments.size());
  for (std::size_t v = 0; v < input.vertices.size(); ++v)
    REQUIRE(output.point(report.vertex_map[v]) == input.vertices[v]);
  CHECK(output.vertices.size() == input.vertices.size() - report.merged_vertices + report.crossings);
  CHECK(std::is_sorted(report.segment_origin.begin(), report.segment_origin.end()));
}

} // namespace

TEST_CASE("a sound graph has no defects and stays as it is", "[repair]") {
  Pslg pslg = unit_square();
  pslg.segment_markers = {1, 2, 3, 4};
  pslg.holes = {Point(0.25, 0.5)};
  pslg.regions = {{Point(0.5, 0.5), 3, 0.5}};
  CHECK(CGAL::find_pslg_defects(pslg).empty());
  for (const CGAL::Pslg_repair_options_2& options : {CGAL::Pslg_repair_options_2(), splitting}) {
    CGAL::Pslg_repair_report_2 report;
    const Pslg same = CGAL::repair_pslg_2(pslg, options, report);
    CHECK(report.is_unchanged());
    CHECK(same.vertices == pslg.vertices);
    CHECK(same.segments == pslg.segments);
    CHECK(same.segment_markers == pslg.segment_markers);
    CHECK(same.holes == pslg.holes);
    REQUIRE(same.regions.size() == 1);
    CHECK(same.regions[0].point == Point(0.5, 0.5));
    CHECK(same.regions[0].attribute == 3);
    CHECK(same.regions[0].max_area == 0.5);
    CHECK(values(report.vertex_map) == Values{0, 1, 2, 3});
    CHECK(values(report.segment_origin) == Values{0, 1, 2, 3});
  }
}

TEST_CASE("the inputs of the other tests have no defects", "[repair]") {
  for (const char* name :
       {"us_states_10m.poly.gz", "gshhg_aegean_h.poly.gz", "syn_comb.poly", "syn_fan_1deg.poly",
        "syn_holes_400.poly.gz", "syn_near_1e-12.poly", "syn_wedge_0.01deg.poly"}) {
    CAPTURE(name);
    Pslg pslg;
    CGAL::IO::read_triangle_poly(data_file(name), pslg);
    CHECK(texts(CGAL::find_pslg_defects(pslg)).empty());
  }
}

TEST_CASE("duplicate vertices merge into the first", "[repair]") {
  Pslg pslg = make_pslg<double>({{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 0}, {-0., 0}}, {{0, 4}, {1, 3}, {3, 2}});
  pslg.vertex_markers = {0, 5, 7, 8, 9, 10};
  pslg.number_of_vertex_attributes = 1;
  pslg.vertex_attributes = {0.5, 1.5, 2.5, 3.5, 4.5, 5.5};
  CHECK(texts(CGAL::find_pslg_defects(pslg)) ==
        std::vector<std::string>{"vertex 2 is at the place of vertex 0 at (0, 0)",
                                 "vertex 4 is at the place of vertex 1 at (1, 0)",
                                 "vertex 5 is at the place of vertex 0 at (0, 0)"});
  CGAL::Pslg_repair_report_2 report;
  const Pslg result = CGAL::repair_pslg_2(pslg, {}, report);
  CHECK(report.merged_vertices == 3);
  CHECK(values(report.vertex_map) == Values{0, 1, 0, 2, 1, 0});
  CHECK(segment_pairs(result) == Pairs{{0, 1}, {1, 2}, {2, 0}});
  CHECK(result.vertex_markers == std::vector<int>{7, 5, 8});
  CHECK(result.vertex_attributes == std::vector<double>{0.5, 1.5, 3.5});
  check_repaired(pslg, result, report);
}

TEST_CASE("segments of length zero go", "[repair]") {
  Pslg pslg = make_pslg<double>({{0, 0}, {1, 0}, {0, 1}, {1, 0}}, {{0, 0}, {0, 1}, {1, 3}, {1, 2}});
  pslg.segment_markers = {1, 2, 3, 4};
  CHECK(texts(CGAL::find_pslg_defects(pslg)) ==
        std::vector<std::string>{"vertex 3 is at the place of vertex 1 at (1, 0)",
                                 "segment 0 has length zero at (0, 0)",
                                 "segment 2 has length zero at (1, 0)"});
  CGAL::Pslg_repair_report_2 report;
  const Pslg result = CGAL::repair_pslg_2(pslg, {}, report);
  CHECK(report.zero_length_segments == 2);
  CHECK(segment_pairs(result) == Pairs{{0, 1}, {1, 2}});
  CHECK(result.segment_markers == std::vector<int>{2, 4});
  CHECK(values(report.segment_origin) == Values{1, 3});
}

TEST_CASE("duplicate segments go, whichever way they run", "[repair]") {
  Pslg pslg = unit_square();
  pslg.add_segment(Vertex_index(1), Vertex_index(0));
  pslg.add_segment(Vertex_index(1), Vertex_index(2));
  pslg.segment_markers = {0, 2, 3, 4, 5, 6};
  CHECK(texts(CGAL::find_pslg_defects(pslg)) ==
        std::vector<std::string>{"segment 4 overlaps segment 0 at (1, 0)",
                                 "segment 5 overlaps segment 1 at (1, 0)"});
  CGAL::Pslg_repair_report_2 report;
  const Pslg result = CGAL::repair_pslg_2(pslg, {}, report);
  CHECK(report.overlapping_segments == 2);
  CHECK(segment_pairs(result) == Pairs{{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  CHECK(result.segment_markers == std::vector<int>{5, 2, 3, 4}); // 0 is no marker
}

TEST_CASE("segments are cut at the vertices on them", "[repair]") {
  Pslg pslg = make_pslg<double>({{0, 0}, {4, 0}, {3, 0}, {1, 0}, {1, 1}, {3, 1}}, {{0, 1}, {2, 5}, {3, 4}});
  pslg.segment_markers = {1, 2, 3};
  CHECK(texts(CGAL::find_pslg_defects(pslg)) ==
        std::vector<std::string>{"vertex 3 lies inside segment 0 at (1, 0)",
                                 "vertex 2 lies inside segment 0 at (3, 0)"});
  CGAL::Pslg_repair_report_2 report;
  const Pslg result = CGAL::repair_pslg_2(pslg, {}, report);
  CHECK(report.split_segments == 1);
  CHECK(segment_pairs(result) == Pairs{{0, 3}, {3, 2}, {2, 1}, {2, 5}, {3, 4}});
  CHECK(result.segment_markers == std::vector<int>{1, 1, 1, 2, 3});
  CHECK(values(report.segment_origin) == Values{0, 0, 0, 1, 2});
  check_repaired(pslg, result, report);
}

TEST_CASE("a chain of overlaps becomes one chain of pieces", "[repair]") {
  // 0-----2, 1-----4, 3--5 backwards, and one over all of them.
  const Pslg pslg = make_pslg<double>({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {0, 5}},
                                      {{0, 2}, {1, 4}, {5, 3}, {0, 5}});
  CGAL::Pslg_repair_report_2 report;
  const Pslg result = CGAL::repair_pslg_2(pslg, {}, report);
  CHECK(segment_pairs(result) == Pairs{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {5, 4}});
  CHECK(values(report.segment_origin) == Values{0, 0, 1, 1, 2});
  CHECK(report.overlapping_segments == 3);
  CHECK(report.split_segments == 4);
  check_repaired(pslg, result, report);
  const Defects defects = CGAL::find_pslg_defects(pslg);
  CHECK(count(defects, Kind::OVERLAPPING_SEGMENTS) == 5); // 1-0, 2-1, 3-0, 3-1, 3-2
  CHECK(count(defects, Kind::VERTEX_ON_SEGMENT) == 8);
}

TEST_CASE("crossing segments are an error that names both and the place", "[repair]") {
  Pslg pslg = make_pslg<double>({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 1}, {0, 2}, {1, 2}, {1, 3}});
  CHECK(error_of([&] { CGAL::repair_pslg_2(pslg); }) ==
        "segment 1 from vertex 0 (0, 0) to vertex 2 (4, 4) and segment 3 from vertex 1 (4, 0) to vertex 3 "
        "(0, 4) cross "
        "at (2, 2)");
  CHECK(texts(CGAL::find_pslg_defects(pslg)) ==
        std::vector<std::string>{"segment 3 crosses segment 1 at (2, 2)"});
  CGAL::Pslg_repair_report_2 report;
  report.merged_vertices = 17;
  CHECK_THROWS_AS(CGAL::repair_pslg_2(pslg, {}, report), CGAL::Pslg_error_2);
  CHECK(report.merged_vertices == 17);
}

TEST_CASE("segments that cross at a vertex of the input do not cross", "[repair]") {
  const Pslg pslg = make_pslg<double>({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}}, {{0, 2}, {1, 3}});
  const Pslg result = CGAL::repair_pslg_2(pslg);
  CHECK(segment_pairs(result) == Pairs{{0, 4}, {4, 2}, {1, 4}, {4, 3}});
}

TEST_CASE("crossings are cut on request", "[repair]") {
  Pslg pslg = make_pslg<double>({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 2}, {1, 3}});
  pslg.vertex_markers = {1, 2, 3, 4};
  pslg.segment_markers = {0, 9};
  pslg.number_of_vertex_attributes = 2;
  pslg.vertex_attributes = {0, 10, 100, 100, 4, 20, 100, 100};
  pslg.holes = {Point(2, 1)};
  pslg.first_number = 1;
  CGAL::Pslg_repair_report_2 report;
  const Pslg result = CGAL::repair_pslg_2(pslg, splitting, report);
  CHECK(result.first_number == 1);
  REQUIRE(result.vertices.size() == 5);
  CHECK(result.vertices[4] == Point(2, 2));
  CHECK(result.vertex_markers == std::vector<int>{1, 2, 3, 4, 9});
  CHECK(result.vertex_attributes[8] == Approx(2));
  CHECK(result.vertex_attributes[9] == Approx(15));
  CHECK(segment_pairs(result) == Pairs{{0, 4}, {4, 2}, {1, 4}, {4, 3}});
  CHECK(result.segment_markers == std::vector<int>{0, 0, 9, 9});
  CHECK(result.holes == pslg.holes);
  CHECK(report.crossings == 1);
  CHECK(report.split_segments == 2);
  check_repaired(pslg, result, report);
}

TEST_CASE("defective structure is not repaired but refused", "[repair]") {
  CHECK(error_of([] { CGAL::repair_pslg_2(Pslg()); }) == "there are no vertices");
  CHECK(error_of([] {
          CGAL::find_pslg_defects(make_pslg<double>({{0, 0}, {1, 0}, {0, 1}}, {{0, 3}}));
        }) == "segment 0 ends at vertex 3, but the vertices are 0 to 2");
}

TEST_CASE("random grids agree with brute force", "[repair]") {
  const unsigned rounds = is_full_run() ? 3000 : 300;
  for (unsigned seed = 0; seed < rounds; ++seed) {
    CAPTURE(seed);
    const Pslg pslg = random_grid_pslg(seed, 2 + int(seed % 9), 3 + seed % 17, seed % 23);
    const Brute_force expected(pslg);
    const Defects defects = CGAL::find_pslg_defects(pslg);
    CHECK(count(defects, Kind::DUPLICATE_VERTEX) == expected.duplicate_vertices());
    CHECK(count(defects, Kind::ZERO_LENGTH_SEGMENT) == expected.zero_length_segments());
    CHECK(count(defects, Kind::VERTEX_ON_SEGMENT) == expected.vertices_on_segments().size());
    CHECK(named_segments(defects, Kind::OVERLAPPING_SEGMENTS) == expected.overlapping_segments());
    CHECK(count(defects, Kind::CROSSING_SEGMENTS) == expected.crossings().size());
    for (const CGAL::Pslg_defect_2& d : defects)
      if (d.kind == Kind::CROSSING_SEGMENTS)
        CHECK(CGAL::Quadtree_mesh_2::internal::do_segments_cross(pslg, d.segment, d.other_segment));

    CGAL::Pslg_repair_report_2 report;
    const Pslg result = CGAL::repair_pslg_2(pslg, splitting, report);
    check_repaired(pslg, result, report);
    CHECK(report.merged_vertices == expected.duplicate_vertices());
    CHECK(report.zero_length_segments == expected.zero_length_segments());
    CHECK(report.overlapping_segments == expected.overlapping_segments().size());
    CHECK(report.crossings == expected.crossing_places().size());
    CHECK(result.segments.size() == expected.pieces().size());

    CGAL::Pslg_repair_report_2 strict_report;
    const bool is_refused = !error_of([&] { CGAL::repair_pslg_2(pslg, {}, strict_report); }).empty();
    CHECK(is_refused == !expected.crossings().empty());
    if (!is_refused) CHECK(strict_report.segment_origin == report.segment_origin);
  }
}

TEST_CASE("the pieces of a repaired graph are those of the arrangement", "[repair]") {
  int without_crossings = 0;
  for (unsigned seed = 1000; seed < 1400; ++seed) {
    CAPTURE(seed);
    const Pslg pslg = random_grid_pslg(seed, 3, 8, 4);
    const Brute_force expected(pslg);
    if (!expected.crossings().empty()) continue;
    ++without_crossings;
    const Pslg result = CGAL::repair_pslg_2(pslg);
    std::set<Brute_force::Piece> pieces;
    for (const auto& s : result.segments) {
      std::array<Rational_point, 2> ends{};
      for (std::size_t k = 0; k < 2; ++k)
        ends[k] = {static_cast<std::int64_t>(result.point(s[k]).x()),
                   static_cast<std::int64_t>(result.point(s[k]).y()), 1};
      std::sort(ends.begin(), ends.end());
      CHECK(pieces.emplace(ends[0], ends[1]).second);
    }
    CHECK(pieces == expected.pieces());
  }
  CHECK(without_crossings > 50);
}

TEST_CASE("a split graph has no crossings however they were rounded", "[repair]") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  SECTION("long random segments") {
    Pslg pslg;
    for (int i = 0; i < 60; ++i) {
      const Vertex_index a = pslg.add_vertex(Point(coordinate(random), coordinate(random)));
      pslg.add_segment(a, pslg.add_vertex(Point(coordinate(random), coordinate(random))));
    }
    CGAL::Pslg_repair_report_2 report;
    const Pslg result = CGAL::repair_pslg_2(pslg, splitting, report);
    CHECK(report.crossings == count(CGAL::find_pslg_defects(pslg), Kind::CROSSING_SEGMENTS));
    CHECK(report.crossings > 300);
    check_repaired(pslg, result, report);
  }
  SECTION("nearly through one point") {
    Pslg pslg;
    const Point center(0.1, 0.7);
    for (int i = 0; i < 40; ++i) {
      const double x = coordinate(random), y = coordinate(random);
      const Vertex_index a = pslg.add_vertex(Point(center.x() + x, center.y() + y));
      pslg.add_segment(a, pslg.add_vertex(Point(center.x() - x, center.y() - y)));
    }
    CGAL::Pslg_repair_report_2 report;
    const Pslg result = CGAL::repair_pslg_2(pslg, splitting, report);
    CHECK(report.crossings > 0);
    check_repaired(pslg, result, report);
  }
  SECTION("nearly on each other") {
    Pslg pslg = make_pslg<double>({{0, 0}, {0, 1}});
    for (int i = 0; i < 30; ++i) {
      const Vertex_index a =
          pslg.add_vertex(Point(-1 + 1e-3 * coordinate(random), 1e-13 * coordinate(random)));
      pslg.add_segment(a, pslg.add_vertex(Point(1 + 1e-3 * coordinate(random), 1e-13 * coordinate(random))));
    }
    CGAL::Pslg_repair_report_2 report;
    const Pslg result = CGAL::repair_pslg_2(pslg, splitting, report);
    check_repaired(pslg, result, report);
  }
}

TEST_CASE("a cut through many segments is repaired", "[repair]") {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(data_file(is_full_run() ? "gshhg_aegean_h.poly.gz" : "us_states_10m.poly.gz"),
                               pslg);
  pslg.add_segment(Vertex_index(0), Vertex_index(10000));
  const std::size_t crossings = count(CGAL::find_pslg_defects(pslg), Kind::CROSSING_SEGMENTS);
  CHECK(crossings > 10);
  CGAL::Pslg_repair_report_2 report;
  const Pslg result = CGAL::repair_pslg_2(pslg, splitting, report);
  CHECK(report.crossings == crossings);
  CHECK(result.segments.size() == pslg.segments.size() + 2 * crossings);
  CHECK(std::equal(pslg.vertices.begin(), pslg.vertices.end(), result.vertices.begin()));
}

} // namespace test_repair_pslg_2
