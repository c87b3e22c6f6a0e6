// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A second refinement of the graph of a small mesh: the mesh that is kept is within the bound and the smaller one, and
// what was there is put back where the second one does not help.

#include "catch.h"
#include "graph_state.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Second_refinement.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_second_refinement {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using Geometry = internal::Double_geometry_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
using graph_state_test::append_loop;
using graph_state_test::refine;
using graph_state_test::triangulate;

constexpr auto go_on = [] { return true; };

/// Triangulates the unit square with a square of a side within, not quite in its middle.
void make_squares(double side, internal::Meshing_problem<Geometry>& problem,
                  internal::Meshing_state<Geometry>& state) {
  const double low = 0.45, high = low + side;
  const std::vector<Geometry::Point> points{{0, 0},     {1, 0},      {1, 1},       {0, 1},
                                            {low, low}, {high, low}, {high, high}, {low, high}};
  std::vector<std::array<std::size_t, 2>> segments;
  append_loop(segments, 0, 4), append_loop(segments, 4, 8);
  triangulate(points, segments, problem, state);
}

void check_mesh(const internal::Meshing_state<Geometry>& state) {
  graph_state_test::check_mesh(state, 1);
  CHECK(state.worklist.is_empty());
  CHECK(state.refinement_rule == internal::Refinement_rule::CORNERS);
}

} // namespace

TEST_CASE("A second refinement leaves the smaller mesh, within the bound", "[refiner]") {
  const double degrees = GENERATE(20.7, 25., 30.), side = GENERATE(0.1, 1e-3, 1e-6, 1e-12);
  CAPTURE(degrees, side);
  internal::Meshing_problem<Geometry> problem;
  internal::Meshing_state<Geometry> state(problem);
  make_squares(side, problem, state);
  problem.bounds = {degrees / 180 * CGAL_PI, 0, 0};
  internal::Second_refinement<Geometry> second(state);
  second.keep_start();
  refine(state);
  const std::size_t before = state.mesh.number_of_triangles();
  state.leg_rule = internal::Leg_rule::FREE;
  const bool is_other = second.run(go_on);
  const std::size_t after = state.mesh.number_of_triangles();
  CHECK(is_other == (after < before));
  CHECK(after <= before);
  if (side < 1e-5 && degrees < 30)
    CHECK(double(after) < 8 * (1 - 0.6 * std::log2(side))); // rings of 8, 1.9 levels apart
  check_mesh(state);
  CHECK_FALSE(second.run(go_on)); // what it began from is used up
}

TEST_CASE("A second refinement that was not prepared leaves the first mesh", "[refiner]") {
  internal::Meshing_problem<Geometry> problem;
  internal::Meshing_state<Geometry> state(problem);
  make_squares(1e-12, problem, state);
  problem.bounds = {25. / 180 * CGAL_PI, 0, 0};
  internal::Second_refinement<Geometry> second(state);
  refine(state);
  const std::size_t before = state.mesh.number_of_triangles();
  state.leg_rule = internal::Leg_rule::FREE;
  CHECK_FALSE(second.run(go_on));
  CHECK(state.mesh.number_of_triangles() == before);
  check_mesh(state);
}

} // namespace test_second_refinement
