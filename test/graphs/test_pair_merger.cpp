// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Merging of pairs, in squares with edges within that were refined for a bound of areas which then falls away: fewer
// triangles, still a triangulation within the bound whose edges are those of the input, and nothing changed where a
// pair has no place.

#include "catch.h"
#include "graph_state.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Pair_merger.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace test_pair_merger {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using Geometry = internal::Double_geometry_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
using State = internal::Meshing_state<Geometry>;
using internal::Side;
using internal::Triangle_id;
using internal::Vertex_id;

constexpr auto go_on = [] { return true; };

internal::Bounds<Geometry> bounds(double degrees, double area) { return {degrees / 180 * CGAL_PI, area, 0}; }

/// Triangulates the unit square, with a diagonal or a square within.
enum class Within { NOTHING, DIAGONAL, SQUARE };
void make_square(Within within, internal::Meshing_problem<Geometry>& problem, State& state) {
  std::vector<Geometry::Point> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<std::array<std::size_t, 2>> segments;
  graph_state_test::append_loop(segments, 0, 4);
  if (within == Within::DIAGONAL) segments.push_back({0, 2});
  if (within == Within::SQUARE) {
    points.insert(points.end(), {{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}});
    graph_state_test::append_loop(segments, 4, 8);
  }
  graph_state_test::triangulate<Geometry>(points, segments, problem, state);
}

/// Both sides of each edge know of each other, and each vertex of one of its triangles.
void check_links(const State& state) {
  const auto& mesh = state.mesh;
  for (const Triangle_id t : mesh.triangles.ids()) {
    if (!mesh.is_alive(t)) continue;
    for (int k = 0; k < 3; ++k) {
      const Side here(t, k), beyond = mesh.across(here);
      const Triangle_id at = mesh.incident_triangle(mesh.opposite(here));
      CHECK((mesh.is_alive(at) && mesh.triangle(at).v[mesh.slot_of(mesh.triangle(at), mesh.opposite(here))] ==
                                      mesh.opposite(here)));
      if (beyond.is_border()) continue;
      CHECK(mesh.source(here) == mesh.target(beyond));
      CHECK(mesh.target(here) == mesh.source(beyond));
      CHECK(mesh.across(beyond).triangle() == t);
      CHECK(mesh.across(beyond).is_constrained() == beyond.is_constrained());
    }
  }
}

/// The length of all constrained sides on each edge of the input.
std::map<internal::Edge_id, double> lengths_of_edges(const State& state) {
  std::map<internal::Edge_id, double> lengths;
  const auto& mesh = state.mesh;
  for (const Triangle_id t : mesh.triangles.ids())
    for (int k = 0; k < 3 && mesh.is_alive(t); ++k) {
      const Side s(t, k), o = mesh.across(s);
      if (!o.is_constrained() || (!o.is_border() && o.triangle() < t)) continue;
      const internal::Edge_id e = state.edges.carrying(mesh, mesh.source(s), mesh.target(s));
      REQUIRE(e.is_valid());
      lengths[e] +=
          length(Geometry::scaled_difference(mesh.point(mesh.source(s)), mesh.point(mesh.target(s))));
    }
  return lengths;
}

void check_lengths(const State& state, const std::map<internal::Edge_id, double>& before) {
  const auto now = lengths_of_edges(state);
  REQUIRE(now.size() == before.size());
  for (const auto& [e, length] : before) CHECK(now.at(e) == Approx(length));
}

} // namespace

TEST_CASE("Pairs are merged within the bounds, and edges stay what they are", "[thinning]") {
  const double degrees = GENERATE(0.1, 20.7, 25., 30.), area = GENERATE(0.1, 0.01, 0.001);
  const Within within = GENERATE(Within::NOTHING, Within::DIAGONAL, Within::SQUARE);
  CAPTURE(degrees, area, int(within));
  internal::Meshing_problem<Geometry> problem;
  State state(problem);
  make_square(within, problem, state);
  problem.bounds = bounds(degrees, area);
  graph_state_test::refine(state);
  const auto lengths = lengths_of_edges(state);
  problem.bounds = bounds(degrees, 0);
  state.leg_rule = internal::Leg_rule::FREE;
  const std::size_t triangles = state.mesh.number_of_triangles();
  const std::size_t merged = internal::Pair_merger<Geometry>(state).run(go_on);
  const std::size_t left = state.mesh.number_of_triangles();
  CHECK(left + 2 * merged >= triangles); // a pair on the border is one triangle, else it is two
  CHECK(left + merged <= triangles);
  if (area < 0.05) CHECK(4 * left < 3 * triangles);
  graph_state_test::check_mesh(state, 1);
  check_links(state);
  check_lengths(state, lengths);
}

TEST_CASE("Pairs that have no place leave the mesh as it was", "[thinning]") {
  internal::Meshing_problem<Geometry> problem;
  State state(problem);
  make_square(Within::SQUARE, problem, state);
  problem.bounds = bounds(20.7, 0.01);
  graph_state_test::refine(state);
  problem.bounds = bounds(59, 0); // no star here is within it
  state.leg_rule = internal::Leg_rule::FREE;
  const auto points = state.mesh.points;
  const auto lengths = lengths_of_edges(state);
  const std::size_t triangles = state.mesh.number_of_triangles();
  CHECK(internal::Pair_merger<Geometry>(state).run(go_on) == 0);
  CHECK(state.mesh.number_of_triangles() == triangles);
  CHECK(state.mesh.points == points);
  check_links(state);
  check_lengths(state, lengths);
}

TEST_CASE("Merging of pairs that is stopped leaves a mesh within the bounds", "[thinning]") {
  internal::Meshing_problem<Geometry> problem;
  State state(problem);
  make_square(Within::NOTHING, problem, state);
  problem.bounds = bounds(30, 0.0005);
  graph_state_test::refine(state);
  problem.bounds = bounds(30, 0);
  int questions = 0;
  CHECK(internal::Pair_merger<Geometry>(state).run([&questions] { return ++questions < 1; }) > 0);
  CHECK(questions == 1);
  graph_state_test::check_mesh(state, 1);
  check_links(state);
}

} // namespace test_pair_merger
