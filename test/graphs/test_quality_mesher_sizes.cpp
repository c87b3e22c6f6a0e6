// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Size fields, the least edge, and the account that the report gives.

#include "catch.h"
#include "mesher_test_tools.h"
#include "pslg_test_tools.h"
#include "random_pslg.h"

#include <CGAL/Grid_sizing_field_2.h>
#include <CGAL/Points_sizing_field_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_quality_mesher_sizes {

namespace {

using namespace mesher_test;
using pslg_test::Point;
using pslg_test::unit_square;
using Field = std::function<double(double, double)>;
using Reason = CGAL::Quality_mesh_report_2::Reason;

double length(const Mesh& mesh, std::size_t t, std::size_t k) {
  const auto& v = mesh.triangles[t];
  return std::sqrt(CGAL::squared_distance(mesh.point(v[(k + 1) % 3]), mesh.point(v[(k + 2) % 3])));
}

/// Meshes to the size field, and checks that each triangle keeps it at its centroid.
Run run_to_the_size(const Pslg& pslg, Options options, const Field& field) {
  const Run r = run_to_the_bound(pslg, options.size(field));
  for (std::size_t t = 0; t < r.mesh.number_of_triangles(); ++t) {
    double x = 0, y = 0, longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      x += r.mesh.point(r.mesh.triangles[t][k]).x() / 3, y += r.mesh.point(r.mesh.triangles[t][k]).y() / 3;
      longest = std::max(longest, length(r.mesh, t, k));
    }
    if (longest > field(x, y) * (1 + 1e-12)) FAIL_CHECK("too large at " << x << ' ' << y);
  }
  return r;
}

/// The number of equilateral triangles with these sizes in the unit square, by the midpoint rule.
double ideal_count(const Field& field) {
  constexpr int n = 400;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double size = field((i + 0.5) / n, (j + 0.5) / n);
      sum += 1 / (size * size * std::sqrt(3.0) / 4) / n / n;
    }
  return sum;
}

} // namespace

TEST_CASE("Size fields are kept, with about as many triangles as they ask for", "[mesher][sizes]") {
  const std::vector<Field> fields{
      [](double, double) { return 0.03; }, [](double x, double y) { return 0.01 + 0.2 * std::hypot(x, y); },
      [](double x, double) { return std::fabs(x - 0.5) < 0.1 ? 0.02 : 0.2; }, // a jump
      [](double x, double y) { return 0.02 * (2 + std::sin(20 * x) * std::cos(20 * y)); }};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    CAPTURE(i);
    const Run r = run_to_the_size(unit_square(), Options(), fields[i]);
    const double ideal = ideal_count(fields[i]);
    CHECK(double(r.report.triangles) > ideal);
    CHECK(double(r.report.triangles) < 4 * ideal);
    run_to_the_size(unit_square(), Options().min_angle(0), fields[i]);
  }
}

TEST_CASE("Size fields near sharp corners and with other bounds", "[mesher][sizes]") {
  const Field field = [](double x, double y) { return 0.05 + 0.1 * std::hypot(x, y); };
  run_to_the_size(read("syn_wedge_1deg.poly"), Options(), field);
  run_to_the_size(read("syn_fan_1deg.poly"), Options().max_area(0.01), field);
  run_to_the_size(random_pslg::segments(3), Options().max_edge(0.1), field);
}

TEST_CASE("The size field of a grid", "[mesher][sizes]") {
  const CGAL::Grid_sizing_field_2 field({0, 0}, {0.5, 1}, 3, 2, {0.1, 0.2, 0.05, 0.1, 0.02, 0.05});
  CHECK(field(0, 0) == 0.1);
  CHECK(field(0.5, 0) == 0.2);
  CHECK(field(1, 1) == 0.05);
  CHECK(field(0.25, 0) == Approx(0.15));
  CHECK(field(0.5, 0.5) == Approx(0.11));
  CHECK(field(-3, -1) == 0.1); // as at the nearest place of the grid
  CHECK(field(9, 0.5) == Approx(0.05));
  const Run r = run_to_the_size(unit_square(), Options(), field);
  CHECK(double(r.report.triangles) < 4 * ideal_count(field));

  const CGAL::Grid_sizing_field_2 one({0, 0}, {1, 1}, 1, 1, {3});
  CHECK(one(-5, 7) == 3);
  using Grid = CGAL::Grid_sizing_field_2;
  CHECK_THROWS_AS(Grid({0, 0}, {1, 1}, 2, 2, {1, 1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(Grid({0, 0}, {1, 1}, 0, 2, {}), std::invalid_argument);
  CHECK_THROWS_AS(Grid({0, 0}, {0, 1}, 1, 1, {1}), std::invalid_argument);
  CHECK_THROWS_AS(Grid({0, 0}, {1, 1}, 1, 1, {0}), std::invalid_argument);
}

TEST_CASE("Meshes follow a limited grid, and are free where it has no bound", "[mesher][sizes]") {
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> sizes(11 * 11, 1);
  sizes[3 * 11 + 4] = 0.01, sizes[8 * 11 + 8] = none;
  CGAL::Grid_sizing_field_2 field({0, 0}, {0.1, 0.1}, 11, 11, sizes);
  const Run steep = run_to_the_size(unit_square(), Options(), field);
  const Run flat = run_to_the_size(unit_square(), Options(), field.limit_gradient(0.15));
  CHECK(flat.report.triangles > 2 * steep.report.triangles);
  CHECK(double(flat.report.triangles) < 4 * ideal_count(field));

  const CGAL::Grid_sizing_field_2 half({0, 0}, {1, 1}, 2, 1, {0.05, none}); // of the west alone
  const Run west = run_to_the_size(unit_square(), Options(), half);
  CHECK(double(west.report.triangles) < 4 * ideal_count(half));
  CHECK(west.report.triangles < run(unit_square(), Options().max_edge(0.05)).report.triangles * 3 / 4);
  run_to_the_size(unit_square(), Options().max_edge(0.3), half);
  const CGAL::Grid_sizing_field_2 nothing({0, 0}, {1, 1}, 1, 1, {none});
  CHECK(run(unit_square(), Options().size(nothing)).mesh.points == run(unit_square(), Options()).mesh.points);
}

TEST_CASE("Meshes follow sizes at points", "[mesher][sizes]") {
  const CGAL::Points_sizing_field_2 field({{0.2, 0.3, 0.001}, {0.8, 0.8, 0.01}, {0.5, 0.5, 0.3}}, 0.3);
  const Run r = run_to_the_size(unit_square(), Options(), field);
  CHECK(double(r.report.triangles) < 4 * ideal_count(field));
}

// ---- rules of the user's

TEST_CASE("A triangle is left only if the user's rule lets it pass", "[mesher][sizes]") {
  using Corners = Options::Corners;
  // Fine on both sides of a circle: no size at a place says so.
  const auto crosses_coarsely = [](const Corners& corners) {
    std::size_t inside = 0;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = corners[k];
      const auto& q = corners[(k + 1) % 3];
      inside += std::hypot(p[0] - 0.5, p[1] - 0.5) < 0.3 ? 1 : 0;
      longest = std::max(longest, std::hypot(p[0] - q[0], p[1] - q[1]));
    }
    return inside != 0 && inside != 3 && longest > 0.02;
  };
  const Run r = run_to_the_bound(unit_square(), Options().max_edge(0.2).refine_where(crosses_coarsely));
  std::size_t coarse = 0;
  for (const auto& t : r.mesh.triangles) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = {r.mesh.point(t[k]).x(), r.mesh.point(t[k]).y()};
    coarse += crosses_coarsely(corners) ? 1 : 0;
  }
  CHECK(coarse == 0);
  CHECK(r.mesh.number_of_triangles() > 200);
  CHECK(r.mesh.number_of_triangles() < 3000);
}

TEST_CASE("A rule that nothing satisfies ends with the budget", "[mesher][sizes]") {
  CGAL::Quality_mesher_2<> mesher(
      Options().max_vertices(5000).refine_where([](const Options::Corners&) { return true; }));
  const Mesh mesh = mesher(unit_square());
  CHECK(mesher.report().is_budget_exhausted);
  CHECK(mesh.number_of_vertices() <= 5000);
  REQUIRE(mesher.report().unmet_triangles.size() == mesh.number_of_triangles());
  CHECK(mesher.report().unmet_triangles[0].reason == Reason::BUDGET);
}

// ---- the least edge

namespace {

/// The shortest edge with an end that is not a vertex of the input.
double shortest_new_edge(const Mesh& mesh) {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.number_of_triangles(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (std::size_t(mesh.triangles[t][(k + 1) % 3]) >= mesh.number_of_input_vertices ||
          std::size_t(mesh.triangles[t][(k + 2) % 3]) >= mesh.number_of_input_vertices)
        shortest = std::min(shortest, length(mesh, t, k));
  return shortest;
}

void run_with_least_edge(const Pslg& pslg, double least, Options options) {
  const Run r = run(pslg, options.min_edge(least));
  CHECK(shortest_new_edge(r.mesh) >= least * (1 - 1e-12));
  std::set<Mesh::Triangle_index> reported, found; // the checker lists a triangle for each bound it misses
  for (const auto& unmet : r.report.unmet_triangles) {
    reported.insert(unmet.triangle);
    if (unmet.reason != Reason::LEAST_EDGE) FAIL_CHECK("another reason");
  }
  for (const auto& unmet : r.quality.unmet_triangles) found.insert(unmet.triangle);
  // the mesher excuses triangles in sectors that it lops only, so that it may report some that are excusable
  CHECK(std::includes(reported.begin(), reported.end(), found.begin(), found.end()));
  CHECK(reported.size() <= found.size() + r.quality.exempt_triangles);
}

} // namespace

TEST_CASE("No vertex is inserted nearer than the least edge", "[mesher][sizes]") {
  const std::uint64_t seeds = is_full_run() ? 200 : 8;
  for (const random_pslg::Family& family : random_pslg::families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      CAPTURE(family.name, seed);
      const Pslg pslg = family.make(seed);
      const auto box = CGAL::bounding_box(pslg.vertices.begin(), pslg.vertices.end());
      const double extent = std::max(box.xmax() - box.xmin(), box.ymax() - box.ymin());
      for (const double least : {2e-4 * extent, 1e-2 * extent}) {
        run_with_least_edge(pslg, least, Options());
        run_with_least_edge(pslg, least, Options().max_edge(0.0203 * extent).min_angle(25));
      }
    }
  const Run met = run_to_the_bound(unit_square(), Options().max_edge(0.1).min_edge(0.001));
  CHECK(met.report.is_met()); // one that asks for nothing changes nothing
  CHECK(met.mesh.points == run(unit_square(), Options().max_edge(0.1)).mesh.points);
}

// ---- the report

TEST_CASE("The report counts angles by degrees", "[mesher][sizes]") {
  const std::string name = GENERATE(as<std::string>(), "us_states_10m.poly.gz", "syn_fan_1deg.poly");
  const Run r = run(read(name), Options());
  std::array<std::size_t, 60> least{};
  std::array<std::size_t, 120> largest{};
  std::size_t on_border = 0; // of two bins: may be in either
  const auto is_on_border = [](double angle) { return std::fabs(angle - std::round(angle)) < 1e-11; };
  for (std::size_t t = 0; t < r.mesh.number_of_triangles(); ++t) {
    double low = 180, high = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& corners = r.mesh.triangles[t];
      const Point& apex = r.mesh.point(corners[k]);
      const auto u = r.mesh.point(corners[(k + 1) % 3]) - apex, v = r.mesh.point(corners[(k + 2) % 3]) - apex;
      const double angle = std::atan2(u.x() * v.y() - u.y() * v.x(), u * v) * 180 / CGAL_PI;
      low = std::min(low, angle), high = std::max(high, angle);
    }
    on_border += (is_on_border(low) ? 1 : 0) + (is_on_border(high) ? 1 : 0);
    ++least[std::min<std::size_t>(59, std::size_t(low))];
    ++largest[std::min<std::size_t>(119, std::size_t(std::max(0.0, high - 60)))];
  }
  std::size_t different = 0;
  for (std::size_t i = 0; i < 60; ++i)
    different +=
        least[i] > r.report.least_angle_histogram[i] ? least[i] - r.report.least_angle_histogram[i] : 0;
  for (std::size_t i = 0; i < 120; ++i)
    different += largest[i] > r.report.largest_angle_histogram[i]
                     ? largest[i] - r.report.largest_angle_histogram[i]
                     : 0;
  CHECK(different <= on_border);
  const auto sum = [](const auto& bins) { return std::accumulate(bins.begin(), bins.end(), std::size_t(0)); };
  CHECK(sum(r.report.least_angle_histogram) == r.report.triangles);
  CHECK(sum(r.report.largest_angle_histogram) == r.report.triangles);
}

TEST_CASE("Exempt triangles name the corner that excuses them", "[mesher][sizes]") {
  const Pslg pslg = read("syn_fan_1deg.poly");
  const Run r = run_to_the_bound(pslg, Options());
  CHECK_FALSE(r.report.exempt_triangles.empty());
  for (const auto& exempt : r.report.exempt_triangles) {
    REQUIRE(std::size_t(exempt.corner) < pslg.number_of_vertices());
    for (const auto v : r.mesh.triangles[std::size_t(exempt.triangle)]) {
      // on a segment at the corner, or the corner itself
      const auto is_at_corner = [&](const auto& s) {
        return (s[0] == exempt.corner || s[1] == exempt.corner) &&
               (s[0] == v || s[1] == v || r.mesh.segment_of_vertex[std::size_t(v)].is_valid());
      };
      CHECK(std::any_of(pslg.segments.begin(), pslg.segments.end(), is_at_corner));
    }
  }
}

TEST_CASE("Unmet triangles say why", "[mesher][sizes]") {
  const Pslg pslg = read("us_states_10m.poly.gz");
  for (const auto& unmet : run(pslg, Options().max_vertices(15000)).report.unmet_triangles)
    CHECK(unmet.reason == Reason::BUDGET);
  const Run stopped = run(pslg, Options().progress([](double) { return false; }));
  CHECK(stopped.report.is_cancelled);
  CHECK_FALSE(stopped.report.unmet_triangles.empty());
  for (const auto& unmet : stopped.report.unmet_triangles) CHECK(unmet.reason == Reason::CANCELLED);
}

} // namespace test_quality_mesher_sizes
