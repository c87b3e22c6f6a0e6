// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Thinning star by star, in a square that was refined for a bound of areas which then falls away: fewer triangles,
// still a triangulation of the square within the bound, and none that a second run would take.

#include "catch.h"
#include "graph_state.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Star_thinner.h>

#include <array>
#include <cstddef>
#include <vector>

namespace test_star_thinner {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using Geometry = internal::Double_geometry_2<CGAL::Exact_predicates_inexact_constructions_kernel>;

constexpr auto go_on = [] { return true; };

internal::Bounds<Geometry> bounds(double degrees, double area) { return {degrees / 180 * CGAL_PI, area, 0}; }

/// Triangulates the unit square.
void make_square(internal::Meshing_problem<Geometry>& problem, internal::Meshing_state<Geometry>& state) {
  std::vector<std::array<std::size_t, 2>> segments;
  graph_state_test::append_loop(segments, 0, 4);
  graph_state_test::triangulate<Geometry>({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, segments, problem, state);
}

} // namespace

TEST_CASE("Stars are thinned until none can be", "[thinning]") {
  const double degrees = GENERATE(0., 20.7, 25., 30.);
  CAPTURE(degrees);
  internal::Meshing_problem<Geometry> problem;
  internal::Meshing_state<Geometry> state(problem);
  make_square(problem, state);
  problem.bounds = bounds(degrees, 0.01);
  graph_state_test::refine(state);
  const std::size_t before = state.mesh.number_of_triangles();
  CHECK(before > 100);
  problem.bounds = bounds(degrees, 0);
  internal::Star_thinner<Geometry>(state).run(go_on);
  const std::size_t after = state.mesh.number_of_triangles();
  CHECK(after < before / 2);
  graph_state_test::check_mesh(state, 1);
  CHECK(state.worklist.is_empty());
  internal::Star_thinner<Geometry>(state).run(go_on);
  CHECK(state.mesh.number_of_triangles() <= after);
  graph_state_test::check_mesh(state, 1);
}

TEST_CASE("Thinning of stars that is stopped leaves a mesh within the bounds", "[thinning]") {
  internal::Meshing_problem<Geometry> problem;
  internal::Meshing_state<Geometry> state(problem);
  make_square(problem, state);
  problem.bounds = bounds(30, 0.001);
  graph_state_test::refine(state);
  const std::size_t before = state.mesh.number_of_triangles();
  problem.bounds = bounds(30, 0);
  int questions = 0; // the first one comes after some trials
  internal::Star_thinner<Geometry>(state).run([&questions] { return ++questions < 1; });
  CHECK(questions == 1);
  CHECK(state.mesh.number_of_triangles() < before);
  graph_state_test::check_mesh(state, 1);
}

} // namespace test_star_thinner
