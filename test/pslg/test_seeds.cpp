// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Points of holes and regions on segments, next to them, and on vertices.

#include "catch.h"
#include "mesher_test_tools.h"
#include "pslg_test_tools.h"
#include "random_pslg.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/refine_quality_mesh_2.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace test_seeds {

namespace {

using namespace mesher_test;
using CGAL::Pslg_seed_error_2;
using pslg_test::make_pslg;
using pslg_test::Point;
using Domain = Options::Domain;
using Mark = Pslg_seed_error_2::Mark;

using Doubles = CGAL::Filtered_quadtree_traits_2<>;
using Words = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
using Exact = CGAL::Exact_quadtree_traits_2<>;

/// With whole coordinates that are not negative, all kinds of numbers are the same.
template <class Traits>
typename Traits::Point_2 convert(const Point& p) {
  if constexpr (std::is_same_v<Traits, Words>)
    return {static_cast<std::uint64_t>(p.x()), static_cast<std::uint64_t>(p.y())};
  else
    return typename Traits::Point_2(p.x(), p.y());
}
template <class Traits>
CGAL::Pslg_2<typename Traits::Point_2> convert(const Pslg& pslg) {
  CGAL::Pslg_2<typename Traits::Point_2> result;
  for (const Point& p : pslg.vertices) result.vertices.push_back(convert<Traits>(p));
  result.segments = pslg.segments;
  for (const Point& p : pslg.holes) result.holes.push_back(convert<Traits>(p));
  for (const auto& r : pslg.regions)
    result.regions.push_back({convert<Traits>(r.point), r.attribute, r.max_area});
  return result;
}

/// Meshes the graph and checks the mesh; what is refused is returned.
template <class Traits>
std::optional<Pslg_seed_error_2> refusal(const Pslg& pslg, Domain domain = Domain::ENCLOSED) {
  const auto graph = convert<Traits>(pslg);
  CGAL::Mesh_quality_options_2 options;
  if (domain == Domain::MARKED) options.check_domain(CGAL::Mesh_quality_options_2::Domain::MARKED_BY_REGIONS);
  try {
    const auto mesh = CGAL::Quality_mesher_2<Traits>(Options().mesh_domain(domain))(graph);
    const auto quality = CGAL::mesh_quality_2(mesh, graph, options);
    CAPTURE(quality.errors);
    CHECK(quality.is_valid());
  } catch (const Pslg_seed_error_2& error) {
    return error;
  }
  return std::nullopt;
}

/// A box with a triangle, whose long side from (8, 8) to (24, 16) passes the points (10, 9), (12, 10), ...; a segment
/// dangles in the triangle, from (12, 12) to (14, 14).
Pslg box_with_triangle() {
  return make_pslg<double>(
      {{0, 0}, {32, 0}, {32, 32}, {0, 32}, {8, 8}, {24, 16}, {10, 24}, {12, 12}, {14, 14}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 4}, {7, 8}});
}

} // namespace

TEMPLATE_TEST_CASE("Points on segments between components are refused by name", "[mesher][domain][seeds]",
                   Doubles, Words, Exact) {
  Pslg pslg = box_with_triangle();
  SECTION("inside a segment") {
    pslg.holes = {Point(2, 2), Point(12, 10)};
    const auto error = refusal<TestType>(pslg);
    REQUIRE(error);
    CHECK(error->mark == Mark::HOLE);
    CHECK(error->seed == 1);
    CHECK(error->segment == pslg_test::Segment_index(4));
    CHECK_FALSE(error->vertex.is_valid());
    CHECK(std::string(error->what()).find("hole 1 (12, 10) lies on segment 4 ") != std::string::npos);
  }
  SECTION("on a vertex") {
    pslg.regions = {{Point(12, 14), 0, 0}, {Point(24, 16), 0, 0}};
    const auto error = refusal<TestType>(pslg);
    REQUIRE(error);
    CHECK(error->mark == Mark::REGION);
    CHECK(error->seed == 1);
    CHECK(error->vertex == pslg_test::Vertex_index(5));
    CHECK_FALSE(error->segment.is_valid());
    CHECK(std::string(error->what()).find("region 1 (24, 16) lies on vertex 5 ") != std::string::npos);
  }
  SECTION("on the border of the domain") {
    pslg.holes = {Point(5, 0)};
    CHECK(refusal<TestType>(pslg));
    pslg.holes = {Point(32, 32)};
    CHECK(refusal<TestType>(pslg));
    pslg.holes.clear();
    pslg.regions = {{Point(0, 7), 0, 0}};
    CHECK(refusal<TestType>(pslg, Domain::MARKED));
  }
  SECTION("on a segment with one component around it, or a vertex") {
    pslg.holes = {Point(13, 13)};
    CHECK_FALSE(refusal<TestType>(pslg));
    pslg.holes = {Point(12, 12)};
    CHECK_FALSE(refusal<TestType>(pslg));
    pslg.holes.clear();
    pslg.regions = {{Point(14, 14), 0, 0}, {Point(2, 2), 0, 0}};
    CHECK_FALSE(refusal<TestType>(pslg));
    CHECK_FALSE(refusal<TestType>(pslg, Domain::MARKED));
  }
  SECTION("off all segments, outside") {
    pslg.holes = {Point(1000, 1000)};
    CHECK_FALSE(refusal<TestType>(pslg));
  }
}

TEST_CASE("Holes next to segments are on the side where they are", "[mesher][domain][seeds]") {
  random_pslg::Random random(1);
  const auto any = [&] { return static_cast<double>(random.bits() >> 11) * 0x1p-53; };
  for (int i = 0; i < (is_full_run() ? 2000 : 100); ++i) {
    Pslg pslg = make_pslg<double>(
        {{-2, -2}, {3, -2}, {3, 3}, {-2, 3}, {any(), any()}, {1 + any(), any()}, {any(), 1 + any()}},
        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 4}});
    const Point p = pslg.vertices[4], q = pslg.vertices[5];
    if (CGAL::orientation(p, q, pslg.vertices[6]) != CGAL::LEFT_TURN) continue;
    const double share = any();
    const Point seed(p.x() + share * (q.x() - p.x()), p.y() + share * (q.y() - p.y()));
    pslg.holes = {seed};
    CAPTURE(i);
    const bool is_on_segment = CGAL::collinear(p, q, seed);
    CHECK(refusal<Doubles>(pslg).has_value() == is_on_segment);
    if (is_on_segment) continue;
    const double area = CGAL::mesh_quality_2(Mesher()(pslg), pslg).area;
    CHECK((area > 20) == (CGAL::orientation(p, q, seed) == CGAL::LEFT_TURN));
  }
}

TEST_CASE("Graphs with holes on their features", "[mesher][domain][seeds]") {
  const auto on_vertex = refusal<Doubles>(read("hole_on_vertex.poly"));
  REQUIRE(on_vertex);
  CHECK(on_vertex->seed == 0);
  CHECK(on_vertex->vertex == pslg_test::Vertex_index(0));
  Pslg pslg = read("hole_on_segment.poly");
  for (Point& p : pslg.vertices) p = Point(2 * p.x(), 2 * p.y()); // whole numbers, for words
  for (Point& p : pslg.holes) p = Point(2 * p.x(), 2 * p.y());
  for (const auto& error : {refusal<Doubles>(pslg), refusal<Words>(pslg), refusal<Exact>(pslg)}) {
    REQUIRE(error);
    CHECK(error->seed == 0);
    CHECK(error->segment == pslg_test::Segment_index(4));
  }
}

TEST_CASE("Seeds on constraints of a triangulation", "[mesher][domain][seeds]") {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Tds = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
                                                   CGAL::Delaunay_mesh_face_base_2<Kernel>>;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds>;
  const auto error_with = [](const Point& seed, Domain domain) -> std::string {
    const Pslg pslg = box_with_triangle();
    Cdt cdt;
    for (const auto& s : pslg.segments) cdt.insert_constraint(pslg.point(s[0]), pslg.point(s[1]));
    const std::vector<Point> seeds{Point(20, 20), seed};
    try {
      CGAL::refine_quality_mesh_2(cdt, seeds, Options().mesh_domain(domain));
    } catch (const CGAL::Pslg_error_2& error) {
      return error.what();
    }
    CHECK(cdt.is_valid());
    return {};
  };
  for (const Domain domain : {Domain::ENCLOSED, Domain::MARKED, Domain::NESTING_PARITY}) {
    CHECK(error_with(Point(12, 10), domain).find("seed 1 (12 10) lies on a constrained edge") == 0);
    CHECK(error_with(Point(8, 8), domain).find("seed 1 (8 8) lies on an end") == 0);
    CHECK(error_with(Point(13, 13), domain).empty());
    CHECK(error_with(Point(14, 14), domain).empty());
    CHECK(error_with(Point(2, 2), domain).empty());
  }
}

} // namespace test_seeds
