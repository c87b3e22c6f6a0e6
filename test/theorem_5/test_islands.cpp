// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Where refinement does not come to rest in some components of the domain, quadtrees make these and nothing else.

#include "catch.h"
#include "island_graphs.h"
#include "numbers_of_threads.h"
#include "theorem_5_tools.h"

#include <CGAL/Quality_mesher_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_islands {

namespace {

using namespace theorem_5_test;
using namespace island_graphs;

using Triangle = std::array<Point, 3>;

/// The triangles of which `is_wanted(vertex)` holds for all vertices, each from its least vertex on, in order.
template <class Is_wanted>
std::vector<Triangle> triangles_of(const Mesh& mesh, const Is_wanted& is_wanted) {
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    Triangle t{mesh.point(a), mesh.point(b), mesh.point(c)};
    if (!std::all_of(t.begin(), t.end(), is_wanted)) continue;
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// What makes patience end when the mesh has so many vertices.
double patience_for(double vertices, const Pslg& pslg, const CGAL::Quality_mesh_report_2& report) {
  constexpr double allowance = 2e6;
  return vertices / (double(pslg.number_of_vertices()) + report.estimated_triangles + allowance);
}

/// Meshes without patience, and checks that quadtrees made so many components, to the bound.
Run run_with_islands(const Pslg& pslg, std::size_t islands) {
  const Run r = run_to_the_bound(pslg, Options().patience(0));
  CHECK(r.report.trees.has_taken_over);
  CHECK(r.report.trees.islands == islands);
  CHECK(r.report.trees.end == End::DONE);
  CHECK(r.report.trees.kept > 0);
  CHECK_FALSE(r.report.is_budget_exhausted);
  return r;
}

bool is_left_of(const Point& p, double x) { return p.x() < x; }

} // namespace

TEST_CASE("Quadtrees make the island where refinement spends its budget, and nothing else",
          "[mesher][theorem5][threads]") {
  Pslg pslg = read("syn_holes_400.poly.gz"); // from 0 to 20
  constexpr double begin_of_island = 24;
  add_comb(pslg, begin_of_island, 0, 60, 0.03);
  const auto others_of = [](const Mesh& mesh) {
    return triangles_of(mesh, [](const Point& p) { return is_left_of(p, begin_of_island); });
  };
  const Run ample = run_to_the_bound(pslg, Options());
  CHECK(ample.report.trees.islands == 0);
  // The comb has the last triangles of the first triangulation. All others are refined before it is halfway done.
  const double before_end = 0.2 * double(ample.report.vertices - pslg.number_of_vertices());
  const Options options =
      Options().patience(patience_for(double(ample.report.vertices) - before_end, pslg, ample.report));
  const Run r = run_to_the_bound(pslg, options);
  CHECK(r.report.trees.has_taken_over);
  CHECK(r.report.trees.islands == 1);
  CHECK(r.report.trees.end == End::DONE);
  CHECK_FALSE(r.report.is_budget_exhausted);
  CHECK_FALSE(are_same(r.mesh, ample.mesh));
  CHECK(others_of(r.mesh).size() > 5000);
  CHECK(others_of(r.mesh) == others_of(ample.mesh));
  // What quadtrees placed is in the comb.
  const auto in_comb = std::count_if(r.mesh.points.begin(), r.mesh.points.end(),
                                     [](const Point& p) { return !is_left_of(p, begin_of_island); });
  CHECK(r.report.trees.kept > 0);
  CHECK(r.report.trees.kept < std::size_t(in_comb));
  for_numbers_of_threads([&] {
    using Parallel = CGAL::Quality_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag>;
    CHECK(are_same(Parallel(options)(pslg), r.mesh));
  });
}

TEST_CASE("Components without a bad triangle are no islands", "[mesher][theorem5]") {
  Pslg pslg;
  add_square(pslg, 0, 0, 1);
  add_comb(pslg, 2, 0, 8, 0.3);
  add_square(pslg, 5, 0, 1);
  const Run r = run_with_islands(pslg, 1);
  for (const double x : {0., 5.})
    CHECK(triangles_of(r.mesh, [x](const Point& p) { return p.x() >= x && p.x() <= x + 1; }).size() == 2);
}

TEST_CASE("Where all of the mesh is an island quadtrees make it as a whole", "[mesher][theorem5]") {
  Pslg pslg;
  add_comb(pslg, 0, 0, 8, 0.3);
  add_comb(pslg, 0, 2, 8, 0.3);
  run_with_islands(pslg, 0);
}

TEST_CASE("Islands that touch other components in a vertex", "[mesher][theorem5]") {
  Pslg pslg;
  add_comb(pslg, 0, 0, 8, 0.25);   // its right side ends in (2, 0.5)
  add_comb(pslg, 2, 0.5, 8, 0.25); // where this one begins
  add_polygon(pslg, {Point(2, 0.5), Point(2.2, -0.3), Point(2.8, 0.2)});
  const Run r = run_with_islands(pslg, 2);
  CHECK(triangles_of(r.mesh, [](const Point& p) { return p.x() >= 2 && p.y() <= 0.5; }).size() == 1);
}

TEST_CASE("Islands beside a gap outside keep to their side of it", "[mesher][theorem5]") {
  for (const double gap : {1e-3, 1e-9, 1e-15}) {
    CAPTURE(gap);
    Pslg pslg;
    add_comb(pslg, 0, 0, 8, 0.3);
    add_square(pslg, 0, -2.4 - gap, 2.4);
    // Turned, so that points on edges are rounded.
    for (Point& p : pslg.vertices)
      p = Point(p.x() * std::cos(0.3) - p.y() * std::sin(0.3), p.x() * std::sin(0.3) + p.y() * std::cos(0.3));
    run_with_islands(pslg, 1);
  }
}

TEST_CASE("Regions of islands keep their bounds", "[mesher][theorem5]") {
  Pslg pslg;
  add_square(pslg, 0, 0, 1);
  add_comb(pslg, 2, 0, 8, 0.3);
  pslg.regions.push_back({Point(0.5, 0.5), 1., 1.});
  pslg.regions.push_back({Point(2.5, 0.1), 2., 1e-3});
  const Run r = run_with_islands(pslg, 1);
  for (const auto& [a, b, c] : r.mesh.triangles) {
    const bool is_in_comb = r.mesh.point(a).x() >= 2;
    CHECK(CGAL::area(r.mesh.point(a), r.mesh.point(b), r.mesh.point(c)) <= (is_in_comb ? 1e-3 : 1.));
  }
}

TEST_CASE("Where quadtrees give no mesh of an island refinement goes on", "[mesher][theorem5]") {
  Pslg pslg;
  add_square(pslg, 2, 2, 1);
  add_square(pslg, -0.5, -0.5, 1);
  pslg.add_vertex(Point(0x1p-70, 0)); // nearer to the next than their grid can tell
  pslg.add_vertex(Point(0x1p-69, 0));
  const Run r = run_to_the_bound(pslg, Options().patience(0));
  CHECK(r.report.trees.has_taken_over);
  CHECK(r.report.trees.islands == 0);
  CHECK(r.report.trees.end == End::FAILED);
  CHECK_FALSE(r.report.is_budget_exhausted);
}

TEST_CASE("Random graphs as islands", "[mesher][theorem5]") {
  const std::uint64_t seeds = is_full_run() ? 100 : 2;
  for (const random_pslg::Family& family : random_pslg::families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      CAPTURE(family.name, seed);
      Pslg pslg = family.make(seed);
      add_square(pslg, 1000, 1000, 1);
      const Run r = run_to_the_bound(pslg, Options().patience(0));
      // Where rings of acute corners meet the bound by themselves, there is nothing to take over.
      CHECK((r.report.trees.islands > 0) == r.report.trees.has_taken_over);
      const auto is_of_square = [](const Point& p) { return p.x() >= 1000; };
      CHECK(triangles_of(r.mesh, is_of_square).size() == 2);
    }
}

} // namespace test_islands
