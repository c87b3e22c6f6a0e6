// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Vertices on legs of acute corners: none is much farther from the apex than the one before, and the legs of a narrow
// sector match.

#include "catch.h"
#include "separation_test_tools.h"
#include "theorem_5_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Leg_spacing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_leg_spacing {

namespace {

using namespace separation_test;
using Traits = CGAL::Filtered_quadtree_traits_2<>;
using Graph = Prepared_graph<Traits>;
using Geometry = Graph::Geometry;
using Spacing = internal::Leg_spacing<Geometry>;
using internal::Edge_id;

constexpr double most_ratio = 1.85, rounding = 1e-12;

/// A square with a corner of so many degrees in it, and a diagonal that is no leg.
Graph::Pslg wedge(double degrees) {
  Graph::Pslg pslg;
  const auto add = [&](double x, double y) { return pslg.add_vertex({x, y}); };
  const auto a = add(-4, -4), b = add(4, -4), c = add(4, 4), d = add(-4, 4);
  const double angle = degrees * CGAL_PI / 180;
  const auto apex = add(0, 0), right = add(2, 0), left = add(2 * std::cos(angle), 2 * std::sin(angle));
  pslg.add_segment(a, b), pslg.add_segment(b, c), pslg.add_segment(c, d), pslg.add_segment(d, a);
  pslg.add_segment(apex, right), pslg.add_segment(apex, left);
  return pslg;
}

/// The edges for which something holds.
template <class Is_wanted>
std::vector<Edge_id> edges_that(const Graph& graph, const Is_wanted& is_wanted) {
  std::vector<Edge_id> edges;
  for (std::size_t e = 0; e < graph.problem().edges.size(); ++e)
    if (is_wanted(Edge_id(e))) edges.push_back(Edge_id(e));
  return edges;
}

Spacing::Vertices vertices_at(const Graph& graph, Edge_id e, const std::vector<double>& shares) {
  const auto& edge = graph.problem().edges[e];
  Spacing::Vertices vertices;
  for (const double s : shares)
    vertices.push_back(
        {s, 1 - s,
         Geometry::between(graph.problem().input_point(edge.a), graph.problem().input_point(edge.b), s)});
  return vertices;
}

/// The shares of the way from an end.
std::vector<double> ways(const Spacing::Vertices& vertices, std::size_t end) {
  std::vector<double> all;
  for (const auto& v : vertices) all.push_back(end == 0 ? v.share : v.rest);
  if (end == 1) std::reverse(all.begin(), all.end());
  return all;
}

} // namespace

TEST_CASE("Legs of acute corners are told from other edges", "[theorem5][corners]") {
  for (const double degrees : {0.01, 1., 20., 30., 40., 80.}) {
    CAPTURE(degrees);
    const Graph graph(wedge(degrees));
    const Spacing spacing(graph.problem());
    CHECK(edges_that(graph, [&](Edge_id e) { return spacing.is_leg(e); }).size() == (degrees < 33 ? 2 : 0));
  }
}

TEST_CASE("No vertex on a leg is much farther from the apex than the one before", "[theorem5][corners]") {
  const Graph graph(wedge(10));
  const Spacing spacing(graph.problem());
  random_pslg::Random random(7);
  for (int trial = 0; trial < 500; ++trial)
    for (const Edge_id e : edges_that(graph, [&](Edge_id f) { return spacing.is_leg(f); })) {
      const std::size_t end = spacing.is_leg_at(e, 0) ? 0 : 1;
      std::vector<double> before(std::size_t(random.integer(0, 6)));
      for (double& s : before) s = std::pow(10, random.between(-6, -0.01));
      std::sort(before.begin(), before.end());
      std::vector<double> shares = before; // from the first end of the edge
      if (end == 1) {
        std::transform(shares.begin(), shares.end(), shares.begin(), [](double s) { return 1 - s; });
        std::reverse(shares.begin(), shares.end());
      }
      const Spacing::Limits limits{random.between(0, 0.5), random.between(0.5, 1)};
      auto vertices = vertices_at(graph, e, shares);
      const std::vector<double> given = ways(vertices, end);
      spacing.space_out(e, end, limits, vertices);
      const std::vector<double> after = ways(vertices, end);
      CAPTURE(given, after, limits.most_of_first, limits.most_of_added);
      REQUIRE(after.empty() == given.empty());
      if (given.empty()) continue;
      CHECK(std::is_sorted(after.begin(), after.end()));
      const bool is_first_left_out = after[0] != given[0];
      if (is_first_left_out)
        CHECK((given.size() > 1 && after[0] == given[1] && given[1] > most_ratio * given[0] &&
               given[1] <= limits.most_of_first));
      CHECK(std::includes(after.begin(), after.end(), given.begin() + (is_first_left_out ? 1 : 0),
                          given.end()));
      for (std::size_t i = 0; i < after.size(); ++i) {
        const double next = i + 1 < after.size() ? after[i + 1] : 1;
        const bool is_room_for_more = after[i] * most_ratio <= limits.most_of_added;
        if (is_room_for_more && next < 1) CHECK(next <= most_ratio * after[i] * (1 + rounding));
        const bool is_added = !std::binary_search(given.begin(), given.end(), after[i]);
        if (is_added) CHECK(after[i] <= limits.most_of_added);
      }
      for (const auto& v : vertices) CHECK(v.share + v.rest == Approx(1));
    }
}

TEST_CASE("Legs with vertices at the same distances get the same ones", "[theorem5][corners]") {
  const Graph graph(wedge(15));
  const Spacing spacing(graph.problem());
  const std::vector<double> distances = {0.011, 0.03, 0.4};
  std::vector<std::vector<double>> after;
  for (const Edge_id e : edges_that(graph, [&](Edge_id f) { return spacing.is_leg(f); })) {
    const std::size_t end = spacing.is_leg_at(e, 0) ? 0 : 1;
    std::vector<double> shares = distances;
    if (end == 1) shares = {1 - 0.4, 1 - 0.03, 1 - 0.011};
    auto vertices = vertices_at(graph, e, shares);
    spacing.space_out(e, end, {0.05, 0.9}, vertices);
    after.push_back(ways(vertices, end));
  }
  REQUIRE(after.size() == 2);
  REQUIRE(after[0].size() == after[1].size());
  for (std::size_t i = 0; i < after[0].size(); ++i) CHECK(after[0][i] == Approx(after[1][i]));
  CHECK(after[0].front() == Approx(0.03)); // 0.011 is left out
}

TEST_CASE("Acute corners alone take one round", "[mesher][theorem5][corners]") {
  for (double degrees = 0.5; degrees < 60; degrees *= 1.3) {
    CAPTURE(degrees);
    CHECK(theorem_5_test::run_by_quadtrees(wedge(degrees), theorem_5_test::by_quadtrees())
              .report.trees.rounds == 1);
  }
}

} // namespace test_leg_spacing
