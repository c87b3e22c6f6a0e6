// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// How fast edges grow: what is promised of any two edges of a mesh, judged by brute force.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "random_pslg.h"
#include "random_pslg_shapes.h"

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

namespace test_gradation {

using namespace test_meshes;
using Options = CGAL::Quality_mesh_options_2;
using Report = CGAL::Quality_mesh_report_2;
using Mesher = CGAL::Quality_mesher_2<>;

namespace {

double distance(const Point& p, const Point& q) {
  const double x = p.x() - q.x(), y = p.y() - q.y();
  return std::sqrt(x * x + y * y);
}

/// The corners with exempt triangles, and how far what is promised does not hold around them.
std::map<Vertex_index, double> zones(const Mesh& mesh, const Report& report, double gradation) {
  std::map<Vertex_index, double> radii;
  for (const auto& exempt : report.exempt_triangles)
    for (const Vertex_index v : mesh.triangles[std::size_t(exempt.triangle)]) {
      double& radius = radii[exempt.corner];
      const double leg = distance(mesh.point(v), mesh.point(exempt.corner));
      radius = std::max(radius, (2 + 2 / gradation) * leg);
    }
  return radii;
}

struct Growth_found {
  std::size_t judged = 0;                 ///< triangles outside of zones
  std::set<std::size_t> missed;           ///< those of them with an edge that is too long
  double greatest_ratio_of_neighbors = 0; ///< of edges with a common end, there
};

/// Tries all pairs of a triangle and an edge.
Growth_found growth_of(const Mesh& mesh, const Report& report, double gradation, double ratio) {
  std::vector<double> shortest(mesh.points.size(), std::numeric_limits<double>::infinity());
  const auto for_each_side = [&](std::size_t t, const auto& f) {
    for (std::size_t k = 0; k < 3; ++k) f(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for_each_side(t, [&](Vertex_index a, Vertex_index b) {
      for (const Vertex_index v : {a, b})
        shortest[std::size_t(v)] = std::min(shortest[std::size_t(v)], distance(mesh.point(a), mesh.point(b)));
    });
  const auto radii = zones(mesh, report, gradation);
  Growth_found found;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    const bool is_in_zone = std::any_of(radii.begin(), radii.end(), [&](const auto& zone) {
      return std::any_of(corners.begin(), corners.end(), [&](Vertex_index v) {
        return distance(mesh.point(v), mesh.point(zone.first)) <= zone.second * (1 + 1e-9);
      });
    });
    if (is_in_zone) continue;
    ++found.judged;
    double longest = 0;
    for_each_side(t, [&](Vertex_index a, Vertex_index b) {
      longest = std::max(longest, distance(mesh.point(a), mesh.point(b)));
    });
    for (const Vertex_index v : corners) {
      found.greatest_ratio_of_neighbors =
          std::max(found.greatest_ratio_of_neighbors, longest / shortest[std::size_t(v)]);
      for (std::size_t w = 0; w < shortest.size(); ++w)
        if (longest > ratio * shortest[w] + gradation * distance(mesh.point(v), mesh.points[w]))
          found.missed.insert(t);
    }
  }
  return found;
}

/// A wide square with two vertices near each other in it.
Pslg square_with_pair() {
  Pslg pslg;
  add_polygon(pslg, {Point(-3, -3), Point(3, -3), Point(3, 3), Point(-3, 3)});
  pslg.add_vertex(Point(1, 1)), pslg.add_vertex(Point(1.01, 1.002));
  return pslg;
}

} // namespace

TEST_CASE("edges grow by no more than the gradation, from any edge to any other", "[gradation]") {
  const Pslg pslg = square_with_pair();
  const std::size_t free = Mesher()(pslg).triangles.size();
  std::size_t triangles = free;
  for (const auto& [gradation, ratio] : {std::array{1., 3.}, {0.5, 3.}, {0.2, 3.}, {0.2, 4.5}, {0.15, 3.}}) {
    Mesher mesher(Options().gradation(gradation).max_edge_ratio(ratio));
    const Mesh mesh = mesher(pslg);
    CAPTURE(gradation, ratio, mesh.triangles.size());
    CHECK(mesher.report().is_met());
    CHECK(CGAL::mesh_quality_2(mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7)).is_met());
    const Growth_found found = growth_of(mesh, mesher.report(), gradation, ratio);
    CHECK(found.judged == mesh.triangles.size());
    CHECK(found.missed.empty());
    CHECK(found.greatest_ratio_of_neighbors <= ratio);
    if (ratio == 3) {
      CHECK(mesh.triangles.size() >= triangles);
      triangles = mesh.triangles.size();
    }
  }
  CHECK(triangles > 10 * free); // the option does something
  const Mesh mesh = Mesher()(pslg);
  CHECK_FALSE(growth_of(mesh, Report(), 0.2, 3).missed.empty()); // and the judge sees it
}

TEST_CASE("each of the two bounds has a default for the other", "[gradation]") {
  const Pslg pslg = square_with_pair();
  CHECK(Mesher(Options().gradation(0.3))(pslg).points ==
        Mesher(Options().gradation(0.3).max_edge_ratio(3))(pslg).points);
  CHECK(Mesher(Options().max_edge_ratio(5))(pslg).points ==
        Mesher(Options().gradation(1).max_edge_ratio(5))(pslg).points);
}

TEST_CASE("gradations that cannot be met are refused", "[gradation]") {
  for (const double gradation : {-0.1, 1.1, std::nan("")})
    CHECK_THROWS_AS(Mesher(Options().gradation(gradation)), std::invalid_argument);
  for (const double ratio : {-1., 1., 2.9, std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK_THROWS_AS(Mesher(Options().max_edge_ratio(ratio)), std::invalid_argument);
}

TEST_CASE("edges of all kinds of graphs grow slowly, or the report says where not", "[gradation]") {
  std::size_t judged = 0, graphs = 0;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 1; seed <= (is_full_run() ? 20u : 2u); ++seed) {
      const Pslg pslg = family.make(seed);
      if (pslg.vertices.size() > 200) continue;
      const double gradation = seed % 2 == 0 ? 0.3 : 1;
      Mesher mesher(Options().gradation(gradation).max_vertices(20000));
      const Mesh mesh = mesher(pslg);
      CAPTURE(family.name, seed, mesh.triangles.size());
      CHECK(CGAL::mesh_quality_2(mesh, pslg).number_of_errors == 0);
      if (mesh.triangles.size() > (is_full_run() ? 8000u : 2500u)) continue;
      const Growth_found found = growth_of(mesh, mesher.report(), gradation, 3);
      std::set<std::size_t> unmet;
      for (const auto& t : mesher.report().unmet_triangles) unmet.insert(std::size_t(t.triangle));
      CHECK(std::includes(unmet.begin(), unmet.end(), found.missed.begin(), found.missed.end()));
      if (!mesher.report().is_budget_exhausted) CHECK(mesher.report().is_met());
      judged += found.judged, ++graphs;
    }
  CHECK(graphs > 10);
  CHECK(judged > 2000);
}

TEST_CASE("corners of any angle draw in no vertices without end", "[gradation]") {
  for (const double degrees : {0.5, 4., 12., 20., 20.8, 22., 30., 45., 59.}) {
    Pslg pslg;
    add_polygon(pslg, {Point(-1, -1), Point(1, -1), Point(1, 1), Point(-1, 1)});
    const double angle = degrees * 3.14159265358979323846 / 180, leg = degrees < 20.7 ? 0.02 : 0.4;
    pslg.add_vertex(Point(0, 0)), pslg.add_vertex(Point(leg, 0));
    pslg.add_vertex(Point(0.9 * leg * std::cos(angle), 0.9 * leg * std::sin(angle)));
    add_segment(pslg, 4, 5), add_segment(pslg, 4, 6);
    Mesher mesher(Options().gradation(0.3));
    const Mesh mesh = mesher(pslg);
    CAPTURE(degrees, mesh.triangles.size());
    CHECK(mesher.report().is_met());
    CHECK(mesh.triangles.size() < 5000);
    const Growth_found found = growth_of(mesh, mesher.report(), 0.3, 3);
    CHECK(found.judged > mesh.triangles.size() / 2);
    CHECK(found.missed.empty());
  }
}

TEST_CASE("a budget or a least edge ends the work on growth, and what is left is reported", "[gradation]") {
  const Pslg pslg = square_with_pair();
  const Options graded = Options().gradation(0.2);
  const auto check = [&](const Options& options, Report::Reason reason) {
    Mesher mesher(options);
    const Mesh mesh = mesher(pslg);
    const Growth_found found = growth_of(mesh, mesher.report(), 0.2, 3);
    std::set<std::size_t> unmet;
    for (const auto& t : mesher.report().unmet_triangles) {
      CHECK(t.reason == reason);
      unmet.insert(std::size_t(t.triangle));
    }
    CHECK_FALSE(found.missed.empty());
    CHECK(std::includes(unmet.begin(), unmet.end(), found.missed.begin(), found.missed.end()));
  };
  const std::size_t few = Mesher()(pslg).points.size(), many = Mesher(graded)(pslg).points.size();
  check(Options(graded).max_vertices((few + many) / 2), Report::Reason::BUDGET);
  check(Options(graded).min_edge(0.1), Report::Reason::LEAST_EDGE);
}

TEST_CASE("bounds of regions, Delaunay edges and threads go with a gradation", "[gradation][threads]") {
  Pslg pslg = square_with_pair();
  pslg.regions.push_back({Point(0, 0), 1, 0.5});
  const Options options = Options().gradation(0.3).conform(Options::Conforming::DELAUNAY);
  Mesher mesher(options);
  const Mesh mesh = mesher(pslg);
  CHECK(mesher.report().is_met());
  CHECK(growth_of(mesh, mesher.report(), 0.3, 3).missed.empty());
  CGAL::Quality_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag> parallel(options);
  const Mesh by_all = parallel(pslg);
  CHECK(by_all.points == mesh.points);
  CHECK(by_all.triangles == mesh.triangles);
}

} // namespace test_gradation
