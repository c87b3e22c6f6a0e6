// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What is meshed, by which rule, with which labels, and how CGAL's triangulations get there.

#include "catch.h"
#include "mesher_test_tools.h"
#include "numbers_of_threads.h"
#include "pslg_test_tools.h"
#include "random_pslg.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/refine_quality_mesh_2.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace test_quality_mesher_domain {

namespace {

using namespace mesher_test;
using pslg_test::make_pslg;
using pslg_test::Point;
using Domain = Options::Domain;

void add_square(Pslg& pslg, double x, double y, double half) {
  const std::size_t first = pslg.number_of_vertices();
  for (const auto& d : {std::array<double, 2>{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    pslg.add_vertex(Point(x + half * d[0], y + half * d[1]));
  for (std::size_t i = 0; i < 4; ++i)
    pslg.add_segment(pslg_test::Vertex_index(first + i), pslg_test::Vertex_index(first + (i + 1) % 4));
}

/// Squares with half sides 4, 3, 2, 1 in each other.
Pslg nested_squares() {
  Pslg pslg;
  for (const double half : {4., 3., 2., 1.}) add_square(pslg, 0, 0, half);
  return pslg;
}

/// Unit squares, all sides of which are segments.
Pslg chessboard(int side) {
  Pslg pslg;
  const auto vertex = [&](int i, int j) { return pslg_test::Vertex_index(i * (side + 1) + j); };
  for (int i = 0; i <= side; ++i)
    for (int j = 0; j <= side; ++j) pslg.add_vertex(Point(i, j));
  for (int i = 0; i <= side; ++i)
    for (int j = 0; j < side; ++j) {
      pslg.add_segment(vertex(i, j), vertex(i, j + 1));
      pslg.add_segment(vertex(j, i), vertex(j + 1, i));
    }
  return pslg;
}

double area(const Pslg& pslg, Domain domain) {
  return run_to_the_bound(pslg, Options().mesh_domain(domain)).quality.area;
}

bool holds(const Mesh& mesh, std::size_t t, const Point& p) {
  for (std::size_t k = 0; k < 3; ++k)
    if (CGAL::orientation(mesh.point(mesh.triangles[t][k]), mesh.point(mesh.triangles[t][(k + 1) % 3]), p) ==
        CGAL::RIGHT_TURN)
      return false;
  return true;
}

double area_of(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  return CGAL::area(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
}

/// Random points, and all segments between them that do not cross one drawn before, in a random order.
Pslg random_triangulation(random_pslg::Random& random) {
  Pslg pslg;
  const int n = random.integer(10, 26);
  std::vector<std::array<std::size_t, 2>> pairs;
  for (int i = 0; i < n; ++i) {
    pslg.add_vertex(Point(random.between(0, 1), random.between(0, 1)));
    for (int j = 0; j < i; ++j)
      pairs.insert(pairs.begin() + random.integer(0, int(pairs.size())), {std::size_t(j), std::size_t(i)});
  }
  const auto point = [&](auto v) { return pslg.vertices[std::size_t(v)]; };
  const auto cross = [&](const auto& s, const auto& t) {
    const auto side = [&](const auto& of, auto v) {
      return CGAL::orientation(point(of[0]), point(of[1]), point(v));
    };
    return side(s, t[0]) * side(s, t[1]) < 0 && side(t, s[0]) * side(t, s[1]) < 0;
  };
  for (const auto& p : pairs)
    if (std::none_of(pslg.segments.begin(), pslg.segments.end(), [&](const auto& s) { return cross(s, p); }))
      pslg.add_segment(pslg_test::Vertex_index(p[0]), pslg_test::Vertex_index(p[1]));
  return pslg;
}

/// How many triangles each region has, with those in none in front. Each region's point is in one of its.
std::vector<std::size_t> triangles_by_region(const Run& r, const Pslg& pslg) {
  REQUIRE(r.mesh.region_of_triangle.size() == r.mesh.number_of_triangles());
  std::vector<std::size_t> count(pslg.regions.size() + 1, 0);
  for (std::size_t t = 0; t < r.mesh.number_of_triangles(); ++t) {
    const int region = r.mesh.region_of_triangle[t];
    ++count[std::size_t(region + 1)];
    for (std::size_t i = 0; i < pslg.regions.size(); ++i)
      if (holds(r.mesh, t, pslg.regions[i].point)) CHECK(region >= 0);
    if (region >= 0 && pslg.regions[std::size_t(region)].max_area > 0)
      CHECK(area_of(r.mesh, t) <= pslg.regions[std::size_t(region)].max_area);
  }
  return count;
}

} // namespace

TEST_CASE("Nested squares by each rule", "[mesher][domain]") {
  Pslg pslg = nested_squares();
  CHECK(area(pslg, Domain::ENCLOSED) == Approx(64));
  CHECK(area(pslg, Domain::NESTING_PARITY) == Approx(64 - 36 + 16 - 4));
  pslg.holes = {Point(0, 1.5)};
  CHECK(area(pslg, Domain::ENCLOSED) == Approx(64 - 12));
  CHECK(area(pslg, Domain::NESTING_PARITY) == Approx(64 - 36));
  pslg.regions.push_back({Point(0, 2.5), 1, 0});
  pslg.regions.push_back({Point(0, 0), 2, 0});
  pslg.regions.push_back({Point(9, 9), 3, 0}); // outside whatever the rule
  CHECK(area(pslg, Domain::MARKED) == Approx(36 - 16 + 4));
  pslg.regions.push_back({Point(0, -1.5), 4, 0}); // a hole all the same
  CHECK(area(pslg, Domain::MARKED) == Approx(36 - 16 + 4));
}

TEST_CASE("Rules that leave nothing are errors", "[mesher][domain]") {
  const auto error = [](const Pslg& pslg, Domain domain) {
    return pslg_test::error_of([&] { Mesher(Options().mesh_domain(domain))(pslg); });
  };
  Pslg pslg = pslg_test::unit_square();
  CHECK(error(pslg, Domain::MARKED).find("region") != std::string::npos);
  pslg.regions.push_back({Point(2, 2), 0, 0});
  CHECK(error(pslg, Domain::MARKED).find("region") != std::string::npos);
  pslg.holes = {Point(0.5, 0.5)};
  CHECK(error(pslg, Domain::NESTING_PARITY).find("holes") != std::string::npos);
}

TEST_CASE("Random inputs by each rule", "[mesher][domain]") {
  const std::uint64_t seeds = is_full_run() ? 200 : 8;
  for (const random_pslg::Family& family : random_pslg::families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      if (std::string(family.name) == "wedge") continue; // one component
      CAPTURE(family.name, seed);
      Pslg pslg = family.make(seed);
      run(pslg, Options().mesh_domain(Domain::NESTING_PARITY));
      const auto& v = pslg.vertices;
      random_pslg::Random random(seed);
      for (int i = 0; i < 3; ++i) { // somewhere, but on no segment
        const auto corner = [&] { return v[std::size_t(random.integer(0, int(v.size()) - 1))]; };
        const Point p = CGAL::centroid(corner(), corner(), corner());
        const double x = random.between(0, 1e-3), y = random.between(0, 1e-3);
        pslg.regions.push_back({Point(p.x() + x, p.y() + y), double(i), 0.5});
      }
      if (pslg_test::error_of([&] { Mesher(Options().mesh_domain(Domain::MARKED))(pslg); }).empty()) {
        const Run r = run_to_the_bound(pslg, Options().mesh_domain(Domain::MARKED));
        CHECK(triangles_by_region(r, pslg)[0] == 0);
      }
      triangles_by_region(run_to_the_bound(pslg, Options()), pslg);
    }
}

TEST_CASE("Regions are found past segments that are not Delaunay", "[mesher][domain]") {
  const Pslg pslg = read("hard_walk_in_circles.poly");
  const auto count = triangles_by_region(run_to_the_bound(pslg, Options()), pslg);
  CHECK(count[0] + count[1] > 0);
}

TEST_CASE("Regions are found among all segments that there can be", "[mesher][domain]") {
  const std::uint64_t seeds = is_full_run() ? 1000 : 30;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    random_pslg::Random random(seed);
    Pslg pslg = random_triangulation(random);
    for (int i = 0; i < 20; ++i)
      pslg.regions.push_back({Point(random.between(0, 1), random.between(0, 1)), double(i), 0});
    triangles_by_region(run_to_the_bound(pslg, Options()), pslg);
  }
}

TEST_CASE("Regions have labels and area bounds of their own", "[mesher][domain]") {
  Pslg pslg = make_pslg<double>({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}},
                                {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {1, 4}});
  SECTION("one of two") {
    pslg.regions.push_back({Point(1.5, 0.5), 7.0, 0.001});
    const auto count = triangles_by_region(run_to_the_bound(pslg, Options()), pslg);
    CHECK(count[1] > 1000);
    CHECK(count[1] < 3000);
    CHECK(count[0] > 10); // on the way from the fine half
    CHECK(count[0] < 500);
  }
  SECTION("both, with a bound for all") {
    pslg.regions.push_back({Point(1.5, 0.5), 7.0, 0.001});
    pslg.regions.push_back({Point(0.5, 0.5), 8.0, 0.1});
    pslg.regions.push_back({Point(0.6, 0.5), 9.0, 0.00001}); // in a component that has one
    const Run r = run_to_the_bound(pslg, Options().max_area(0.01));
    const auto count = triangles_by_region(r, pslg);
    CHECK(count[0] == 0);
    CHECK(count[2] >= 100);
    CHECK(count[2] < 1000);
    CHECK(count[3] == 0);
  }
  SECTION("without removal") {
    pslg.regions.push_back({Point(1.5, 0.5), 7.0, 0.01});
    triangles_by_region(run_to_the_bound(pslg, Options().coarsen(Options::Coarsening::NONE)), pslg);
  }
  SECTION("scaled to the ends of the range") {
    for (const double scale : {1e-140, 1e140}) {
      Pslg scaled = pslg;
      for (Point& p : scaled.vertices) p = Point(scale * p.x(), scale * p.y());
      scaled.regions.push_back({Point(1.5 * scale, 0.5 * scale), 7.0, 0.01 * scale * scale});
      CHECK(triangles_by_region(run_to_the_bound(scaled, Options()), scaled)[1] >= 100);
    }
  }
}

TEST_CASE("A map with bounds by region", "[mesher][domain]") {
  Pslg pslg = read("us_states_10m.poly.gz");
  double x = 0, y = 0;
  for (const Point& p : pslg.vertices) {
    x += p.x() / double(pslg.number_of_vertices());
    y += p.y() / double(pslg.number_of_vertices());
  }
  pslg.regions.push_back({Point(x, y), 1, 1e8});
  const auto count = triangles_by_region(run_to_the_bound(pslg, Options()), pslg);
  CHECK(count[1] > 100);
}

TEST_CASE("Segments with the domain on both sides, dangling ones and isolated vertices", "[mesher][domain]") {
  Pslg pslg;
  add_square(pslg, 0, 0, 4);
  const auto a = pslg.add_vertex(Point(-1, 0)), b = pslg.add_vertex(Point(1, 0));
  pslg.add_segment(a, b);                                                         // on both sides
  pslg.add_segment(b, pslg.add_vertex(Point(2, 1)));                              // dangling
  pslg.add_segment(pslg_test::Vertex_index(0), pslg.add_vertex(Point(-3, -2.5))); // from the border
  const auto isolated = pslg.add_vertex(Point(0.123, 2.345));
  const auto outside = pslg.add_vertex(Point(7, 7));
  const Run r = run_to_the_bound(pslg, Options());
  CHECK(r.quality.area == Approx(64));
  std::set<pslg_test::Vertex_index> used;
  for (const auto& t : r.mesh.triangles) used.insert(t.begin(), t.end());
  CHECK(used.count(isolated) == 1);
  CHECK(used.count(outside) == 0);
  for (std::size_t v = 0; v < r.mesh.number_of_input_vertices; ++v)
    CHECK((used.count(pslg_test::Vertex_index(v)) == 1 || pslg_test::Vertex_index(v) == outside));
  CHECK(r.mesh.point(isolated) == Point(0.123, 2.345));
}

TEST_CASE("Several components, and holes that touch in a vertex", "[mesher][domain]") {
  SECTION("components") {
    Pslg pslg;
    for (int i = 0; i < 5; ++i) add_square(pslg, 3 * i, i % 2, 1);
    for (int i = 0; i < 5; ++i) pslg.regions.push_back({Point(3 * i, i % 2), double(i), 0.1 / (i + 1)});
    const auto count = triangles_by_region(run_to_the_bound(pslg, Options()), pslg);
    CHECK(count[0] == 0);
    for (std::size_t i = 1; i < 5; ++i) CHECK(count[i] < count[i + 1]);
  }
  SECTION("holes that share the vertex 4, and one that touches the border") {
    Pslg pslg = make_pslg<double>(
        {{-4, -4}, {4, -4}, {4, 4}, {-4, 4}, {0, 0}, {2, -1}, {2, 1}, {-2, -1}, {-2, 1}, {-1, 2}, {1, 2}},
        {{0, 1},
         {1, 2},
         {2, 3},
         {3, 0},
         {4, 5},
         {5, 6},
         {6, 4},
         {4, 7},
         {7, 8},
         {8, 4},
         {2, 9},
         {9, 10},
         {10, 2}});
    pslg.holes = {Point(1.5, 0), Point(-1.5, 0), Point(1, 2.1)};
    CHECK(run_to_the_bound(pslg, Options()).quality.area == Approx(64 - 2 - 2 - 2));
    CHECK(area(pslg, Domain::NESTING_PARITY) == Approx(64 - 2 - 2 - 2));
  }
}

TEST_CASE("Many holes and regions, with any number of threads", "[mesher][domain][threads]") {
  constexpr int side = 30;
  using Parallel_mesher = CGAL::Quality_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag>;
  random_pslg::Random random(17);
  Pslg pslg = chessboard(side);
  std::array<std::array<int, side>, side> region_of{};
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const bool is_center = random.integer(0, 1) == 0; // where the cell has a diagonal
      const Point p = is_center ? Point(i + 0.5, j + 0.5)
                                : Point(i + random.between(0.1, 0.9), j + random.between(0.1, 0.9));
      const bool is_hole = random.integer(0, 2) == 0;
      region_of[std::size_t(i)][std::size_t(j)] = is_hole ? -1 : static_cast<int>(pslg.regions.size());
      if (is_hole)
        pslg.holes.push_back(p);
      else
        pslg.regions.push_back({p, 0, 0});
    }
  const Run r = run_to_the_bound(pslg, Options());
  CHECK(r.quality.area == Approx(double(pslg.regions.size())));
  for (std::size_t t = 0; t < r.mesh.number_of_triangles(); ++t) {
    const auto& v = r.mesh.triangles[t];
    const Point c = CGAL::centroid(r.mesh.point(v[0]), r.mesh.point(v[1]), r.mesh.point(v[2]));
    REQUIRE(r.mesh.region_of_triangle[t] == region_of[std::size_t(c.x())][std::size_t(c.y())]);
  }
  for_numbers_of_threads([&] {
    const Mesh mesh = Parallel_mesher(Options())(pslg);
    CHECK(mesh.triangles == r.mesh.triangles);
    CHECK(mesh.region_of_triangle == r.mesh.region_of_triangle);
  });

  pslg.holes.insert(pslg.holes.begin() + 100, {Point(25, 25), Point(3, 4.5)});
  const auto refusal_by = [&](auto mesher) -> std::string {
    try {
      mesher(pslg);
    } catch (const CGAL::Pslg_error_2& error) {
      return error.what();
    }
    return {};
  };
  const std::string refusal = refusal_by(Mesher(Options()));
  CHECK(refusal.find("hole 101 ") != std::string::npos); // the first one in shuffle order
  for_numbers_of_threads([&] { CHECK(refusal_by(Parallel_mesher(Options())) == refusal); });
}

TEST_CASE("Markers are carried to vertices and edges", "[mesher][domain]") {
  Pslg pslg = pslg_test::unit_square();
  pslg.segment_markers = {10, 0, 12, 13};
  pslg.vertex_markers = {0, 21, 0, 0};
  const Run r = run_to_the_bound(pslg, Options().max_edge(0.2));
  REQUIRE(r.mesh.vertex_markers.size() == r.mesh.number_of_vertices());
  CHECK(r.mesh.vertex_markers[0] == 10); // of the first segment through it
  CHECK(r.mesh.vertex_markers[1] == 21);
  for (const auto& edge : r.mesh.constrained_edges)
    CHECK(edge.marker == pslg.segment_markers[std::size_t(edge.segment)]);
  std::size_t inside = 0;
  for (std::size_t v = 4; v < r.mesh.number_of_vertices(); ++v) {
    const auto segment = r.mesh.segment_of_vertex[v];
    const int own = segment.is_valid() ? pslg.segment_markers[std::size_t(segment)] : -1;
    CHECK(r.mesh.vertex_markers[v] == (own < 0 ? 0 : own == 0 ? 1 : own));
    inside += own < 0 ? 1 : 0;
  }
  CHECK(inside > 10);
}

// ---- CGAL triangulations

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vb = CGAL::Triangulation_vertex_base_2<Kernel>;
using Fb = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vb, Fb>>;

Cdt triangulation_of(const Pslg& pslg) {
  Cdt cdt;
  for (const auto& s : pslg.segments) cdt.insert_constraint(pslg.point(s[0]), pslg.point(s[1]));
  return cdt;
}

double area_in_domain(const Cdt& cdt) {
  double sum = 0;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    if (f->is_in_domain()) sum += cdt.triangle(f).area();
  return sum;
}

double longest_edge(const Cdt& cdt) {
  double longest = 0;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    for (int k = 0; k < 3 && f->is_in_domain(); ++k)
      longest = std::max(longest, std::sqrt(cdt.segment(f, k).squared_length()));
  return longest;
}

} // namespace

TEST_CASE("A triangulation is refined by criteria of Mesh_2 and its seeds", "[mesher][domain]") {
  const std::vector<Point> seeds{Point(0, 1.5), Point(0, 3.5)};
  using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;
  SECTION("seeds in holes") {
    Cdt cdt = triangulation_of(nested_squares());
    CHECK(CGAL::refine_quality_mesh_2(cdt, seeds.begin(), seeds.end(), Criteria(0.125, 0.5)).is_met());
    CHECK(area_in_domain(cdt) == Approx(64 - 12 - 28));
    CHECK(longest_edge(cdt) <= 0.5);
    CHECK(cdt.is_valid());
  }
  SECTION("seeds in the domain") {
    Cdt cdt = triangulation_of(nested_squares());
    CGAL::refine_quality_mesh_2(cdt, seeds.begin(), seeds.end(), Criteria(0.125, 0.5), true);
    CHECK(area_in_domain(cdt) == Approx(12 + 28));
    CHECK(cdt.is_valid());
  }
  SECTION("a range, with options") {
    Cdt cdt = triangulation_of(nested_squares());
    CGAL::refine_quality_mesh_2(cdt, seeds, Options().mesh_domain(Domain::MARKED));
    CHECK(area_in_domain(cdt) == Approx(12 + 28));
    cdt = triangulation_of(nested_squares());
    CGAL::refine_quality_mesh_2(cdt, Options().mesh_domain(Domain::NESTING_PARITY));
    CHECK(area_in_domain(cdt) == Approx(64 - 36 + 16 - 4));
    CHECK(cdt.is_valid());
  }
  SECTION("criteria alone") {
    Cdt cdt = triangulation_of(nested_squares());
    CGAL::refine_quality_mesh_2(cdt, Criteria());
    CHECK(area_in_domain(cdt) == Approx(64));
  }
}

TEST_CASE("Criteria of Mesh_2 become options", "[mesher][domain]") {
  using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;
  CHECK(CGAL::quality_mesh_options_2(Criteria()).min_angle() == Approx(20.704811).epsilon(1e-7));
  CHECK(CGAL::quality_mesh_options_2(Criteria(0.125, 3)).max_edge() == 3);
  CHECK(CGAL::quality_mesh_options_2(Criteria(0.25)).min_angle() == Approx(30));
  CHECK(CGAL::quality_mesh_options_2(Criteria(0.5)).min_angle() == 34);
  CHECK(CGAL::quality_mesh_options_2(Criteria(0)).min_angle() == 0);
  CHECK(CGAL::quality_mesh_options_2(CGAL::Delaunay_mesh_criteria_2<Cdt>(0.1)).min_angle() ==
        Approx(std::asin(std::sqrt(0.1)) * 180 / CGAL_PI));
}

} // namespace test_quality_mesher_domain
