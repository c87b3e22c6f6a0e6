// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "point_mesh_checks.h"
#include "point_sets.h"

#include <CGAL/IO/read_XY.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/point_set_lengths_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_point_set_mesher_2 {

namespace {

using point_mesh_test::Mode;
using point_mesh_test::Options;
using point_mesh_test::Report;
using point_sets::Point;
using point_sets::Points;
using Domain = Options::Domain;
using Point_error = CGAL::Quadtree_mesh_2::Point_error;
using Mesher = CGAL::Point_set_mesher_2<>;

struct Run {
  Mesher::Mesh mesh;
  Report report;
};

/// Meshes, and checks all that must hold for every mesh.
Run run(const Points& points, const Options& options) {
  Mesher mesher(options);
  Run r;
  r.mesh = mesher(points);
  r.report = mesher.report();
  for (const std::string& fault : point_mesh_test::faults_of(r.mesh, points, options, r.report))
    FAIL_CHECK(fault);
  return r;
}

std::vector<std::pair<std::string, Options>> all_modes() {
  return {{"row", Options().bounded_angles()},
          {"square", Options().bounded_angles().mesh_domain(Domain::SQUARE)},
          {"least range", Options().bounded_angles(37.5, 78.6)},
          {"any angles up to 89.5", Options().bounded_angles(0, 89.5)},
          {"acute", Options().acute()},
          {"least angle", Options().least_angle()},
          {"warped squares", Options().warped_squares()}};
}

bool is_same(const Mesher::Mesh& a, const Mesher::Mesh& b) {
  return a.points == b.points && a.triangles == b.triangles && a.neighbors == b.neighbors &&
         a.vertex_markers == b.vertex_markers;
}

Point_error error_of(const Points& points, const Options& options) {
  try {
    Mesher mesher(options);
    mesher(points);
  } catch (const Point_error& error) {
    return error;
  }
  FAIL("no error");
  throw std::logic_error("not reached");
}

} // namespace

TEST_CASE("Points of all kinds are meshed as promised", "[point_set_mesher]") {
  for (const auto& [name, options] : all_modes())
    for (const auto& input : point_sets::nasty(is_full_run() ? 20 : 1)) {
      CAPTURE(name, input.name);
      run(input.points, options);
    }
}

TEST_CASE("No points make no mesh, and least angles an empty box", "[point_set_mesher]") {
  for (const auto& [name, options] : all_modes()) {
    const Run r = run({}, options);
    CHECK(r.mesh.triangles.empty() == (options.mode() != Mode::LEAST_ANGLE));
  }
}

TEST_CASE("One place, wherever it is and however often it is given, is meshed as promised",
          "[point_set_mesher]") {
  for (const auto& [name, options] : all_modes())
    for (const double x : {0.0, 3.0, -1e-60, 1e10, 1e17, -1e20, 1e100})
      for (const std::size_t n : {std::size_t(1), std::size_t(10)}) {
        CAPTURE(name, x, n);
        const Run r = run(Points(n, Point(x, 4)), options);
        CHECK(r.report.is_met());
        CHECK(r.mesh.number_of_triangles() > 0);
      }
}

TEST_CASE("Options out of range of point meshes are refused", "[point_set_mesher]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double least : {-1., 37.6, 60., nan})
    CHECK_THROWS_AS(Mesher(Options().bounded_angles(least, 80)), std::invalid_argument);
  for (const double largest : {78.5, 89.6, 90., nan})
    CHECK_THROWS_AS(Mesher(Options().bounded_angles(36, largest)), std::invalid_argument);
  for (const int effort : {-1, 4}) CHECK_THROWS_AS(Mesher(Options().effort(effort)), std::invalid_argument);
  for (const double gap : {0., 2247., -1., nan})
    CHECK_THROWS_AS(Mesher(Options().acute().clusters(gap)), std::invalid_argument);
  CHECK_NOTHROW(Mesher(Options().bounded_angles(37.5, 78.6)));
  CHECK_NOTHROW(Mesher(Options().bounded_angles(0, 89.5)));
  CHECK_NOTHROW(Mesher(Options().acute().clusters(2248)));
}

TEST_CASE("Points that are no places are named", "[point_set_mesher]") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto& [name, options] : all_modes())
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
      CAPTURE(name, bad);
      Points points = point_sets::joined({{0, 0}, {0, 0}, {0, 0}}, quadtree_inputs::uniform(20, 1));
      points[7] = Point(0.5, bad);
      const Point_error error = error_of(points, options);
      CHECK(error.kind() == Point_error::Kind::NOT_FINITE);
      CHECK(std::size_t(error.point()) == 7);
    }
}

TEST_CASE("Angles that the grid of warped squares has no room for are in the report", "[point_set_mesher]") {
  Points points;
  CGAL::IO::read_XY(QUADTREE_MESH_TEST_DATA_DIR "/hard_points_2e-58_apart.xy", points);
  for (const double scale : {1.0, 0x1p8, 0x1p14, 0x1p20}) {
    Points scaled = points;
    for (std::size_t i = 2; i < 4; ++i) scaled[i] = Point(points[i].x() * scale, points[i].y() * scale);
    CAPTURE(scale);
    Mesher mesher(Options().warped_squares());
    const Mesher::Mesh mesh = mesher(scaled);
    const Report& report = mesher.report();
    if (scale > 0x1p18) CHECK(report.is_met()); // there is room
    for (const std::string& fault : point_mesh_test::faults_of(mesh, scaled, mesher.options(), report)) {
      const bool is_excused = !report.is_met() && fault.find("outside the range:") != std::string::npos;
      if (!is_excused) FAIL_CHECK(fault);
    }
  }
}

TEST_CASE("Angles of triangles between points ulps apart are in the report as they are",
          "[point_set_mesher]") {
  Points points;
  CGAL::IO::read_XY(QUADTREE_MESH_TEST_DATA_DIR "/hard_points_pairs_ulps_apart.xy", points);
  Mesher mesher(Options().least_angle().effort(1));
  const Mesher::Mesh mesh = mesher(points);
  for (const std::string& fault :
       point_mesh_test::faults_of(mesh, points, mesher.options(), mesher.report())) {
    const bool is_excused = fault.find("outside the range:") != std::string::npos; // there is no room
    if (!is_excused) FAIL_CHECK(fault);
  }
}

TEST_CASE("Points that are too near to each other are named, also after duplicates", "[point_set_mesher]") {
  for (const auto& [name, options] : all_modes()) {
    if (options.mode() == Mode::LEAST_ANGLE || options.mode() == Mode::ACUTE) continue; // take them
    for (const double gap : {0x1p-50, 0x1p-53}) {
      if (options.mode() == Mode::WARPED_SQUARES && gap > 0x1p-53) continue; // takes them
      CAPTURE(name, gap);
      Points points = point_sets::joined({{0, 0}, {0, 0}, {1, 1}, {0, 0}}, quadtree_inputs::uniform(20, 1));
      points[9] = Point(0.75, 0.75);
      points[15] = Point(0.75 - gap, 0.75);
      const Point_error error = error_of(points, options);
      const std::size_t p(error.point()), q(error.other());
      CHECK(std::min(p, q) == 9);
      CHECK(std::max(p, q) == 15);
      CHECK(error.kind() == Point_error::Kind::TOO_NEAR);
    }
  }
}

TEST_CASE("Points at one place of the grid are named, also after duplicates", "[point_set_mesher]") {
  const Points points{{1, 0}, {0.5, 0.5}, {1, 0}, {0, 0}, {0.5, 0.5}, {1e-300, 1e-300}, {1, 1}};
  for (const auto& [name, options] : all_modes()) {
    if (options.mode() == Mode::LEAST_ANGLE) continue;
    CAPTURE(name);
    if (options.mode() == Mode::ACUTE) { // clusters, with grids of their own
      CHECK(run(points, options).report.clusters >= 1);
      continue;
    }
    const Point_error error = error_of(points, options);
    const std::size_t p(error.point()), q(error.other());
    CHECK(std::min(p, q) == 3);
    CHECK(std::max(p, q) == 5);
    if (options.mode() == Mode::WARPED_SQUARES) {
      CHECK(error.kind() == Point_error::Kind::INDISTINGUISHABLE);
    } else {
      CHECK(error.kind() == Point_error::Kind::TOO_NEAR);
    }
  }
}

TEST_CASE("Points that no triangle can tell apart are named, not the graph that they are in",
          "[point_set_mesher]") {
  const Options options = Options().least_angle();
  const Point_error near = error_of({{1, 0}, {0, 0}, {0, 1}, {1e-320, 0}}, options);
  CHECK(near.kind() == Point_error::Kind::TOO_NEAR);
  CHECK(std::min(std::size_t(near.point()), std::size_t(near.other())) == 1);
  CHECK(std::max(std::size_t(near.point()), std::size_t(near.other())) == 3);
  CHECK(std::string(near.what()).find("than 2^-420 of the extent") != std::string::npos);
  const Point_error beyond = error_of({{2, 0}, {0, 0}, {0, 1e300}, {1, 1e-300}}, options);
  CHECK(beyond.kind() == Point_error::Kind::OUT_OF_RANGE);
  CHECK(std::size_t(beyond.point()) == 3);
}

TEST_CASE("Angles are the same promise at any effort, and more effort makes fewer triangles",
          "[point_set_mesher]") {
  for (const Options& options : {Options().bounded_angles(), Options().acute()}) {
    std::vector<std::size_t> triangles(4, 0);
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      const Points points = quadtree_inputs::uniform(50, seed);
      for (std::size_t effort = 0; effort < 4; ++effort)
        triangles[effort] +=
            run(points, Options(options).effort(static_cast<int>(effort))).mesh.number_of_triangles();
    }
    CAPTURE(triangles);
    CHECK(triangles[0] > triangles[1]);
    CHECK(triangles[1] > triangles[2]);
    CHECK(20 * triangles[3] < 21 * triangles[2]); // it may be a few more on small inputs
  }
}

TEST_CASE("A budget or a callback that says no leave a larger mesh", "[point_set_mesher]") {
  const Points points = quadtree_inputs::uniform(80, 4);
  for (const Options& options : {Options().bounded_angles(), Options().acute()}) {
    const std::size_t least = run(points, options).mesh.number_of_triangles();
    const Run limited = run(points, Options(options).max_removals(30));
    CHECK(limited.mesh.number_of_triangles() > least);
    CHECK_FALSE(limited.report.is_cancelled);

    double share = -1;
    bool is_sorted = true;
    const Run told = run(points, Options(options).progress([&](double s) {
      is_sorted = is_sorted && s >= share && s <= 1;
      share = s;
      return true;
    }));
    CHECK(is_sorted);
    CHECK(share >= 0);
    CHECK(told.mesh.number_of_triangles() == least);
    CHECK_FALSE(told.report.is_cancelled);

    const Run cancelled = run(points, Options(options).progress([](double) { return false; }));
    CHECK(cancelled.report.is_cancelled);
    CHECK(cancelled.mesh.number_of_triangles() > least);
  }
}

TEST_CASE("A mesher forgets its last points", "[point_set_mesher]") {
  const Points points = quadtree_inputs::uniform(30, 5), others = point_sets::duplicates(30, 6);
  for (const auto& [name, options] : all_modes()) {
    CAPTURE(name);
    Mesher mesher(options);
    const auto mesh = mesher(points);
    mesher(others);
    CHECK(is_same(mesh, mesher(points)));
    CHECK(mesher.report().merged_points == 0);
    CHECK(mesher.report().vertices == mesh.number_of_vertices());
  }
}

TEST_CASE("Edges of rows are as long in all as any mesh's, up to a constant", "[point_set_mesher]") {
  std::vector<std::size_t> sizes{50, 150};
  if (is_full_run()) sizes.insert(sizes.end(), {500, 2000});
  for (const std::size_t n : sizes)
    for (const Points& points :
         {quadtree_inputs::line(n, 1), point_sets::horizontal_line(n, 2), quadtree_inputs::uniform(n, 3)}) {
      const Run r = run(points, Options().effort(1));
      const double ratio = CGAL::total_edge_length_2(r.mesh) / CGAL::point_set_lengths_2(points).least_mesh();
      CAPTURE(n, ratio, points[1]);
      if (is_full_run()) WARN(n << ": " << ratio);
      CHECK(ratio < 60);
    }
}

TEST_CASE("Each factor of two between distances costs meshes with bounded angles the same",
          "[point_set_mesher]") {
  // In the smallest tree with balance across corners 27 squares of each size are around a group of points; their tiles
  // have 578 triangles.
  constexpr int groups = 4, factors = 10;
  std::vector<double> before, after;
  for (int exponent = -factors; exponent >= -3 * factors; exponent -= factors) {
    Points points;
    for (int ring = 0; ring < 3; ++ring)
      for (int group = 0; group < groups; ++group) {
        const double r = 1 + std::ldexp(ring, exponent), angle = 0.3 + 1.5707963267948966 * group;
        points.emplace_back(r * std::cos(angle), r * std::sin(angle));
      }
    const Run r = run(points, Options());
    before.push_back(double(r.report.triangles_before_coarsening));
    after.push_back(double(r.mesh.number_of_triangles()));
  }
  for (std::size_t i = 1; i < before.size(); ++i) {
    CHECK(before[i] - before[i - 1] < 600 * groups * factors);
    CHECK(after[i] - after[i - 1] < 36 * groups * factors);
  }
}

TEST_CASE("However near points are, acute meshes have a constant number of triangles for each",
          "[point_set_mesher]") {
  std::vector<std::size_t> sizes{100};
  if (is_full_run()) sizes = {100, 1000, 10000};
  for (const std::size_t n : sizes)
    for (const auto& input : std::vector<point_sets::Named_points>{
             {"spiral", point_sets::spiral(n, 0x1p-36)},
             {"close pairs", point_sets::close_pairs(n, 1e-10, 1)},
             {"nested clusters", point_sets::nested_clusters(n, 1e-4, 3, 2)}}) {
      CAPTURE(n, input.name);
      const Run r = run(input.points, Options().acute().effort(1));
      const double per_point = double(r.mesh.number_of_triangles()) / double(n);
      if (is_full_run())
        WARN(n << " " << input.name << ": " << per_point << ", before "
               << double(r.report.triangles_before_coarsening) / double(n));
      CHECK(per_point < 50); // a cluster of two costs about 80
    }
}

} // namespace test_point_set_mesher_2
