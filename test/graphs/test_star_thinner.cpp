// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Thinning star by star, in a square that was refined for a bound of areas which then falls away: fewer triangles,
// still a triangulation of the square within the bound, and none that a second run would take.

#include "catch.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Star_thinner.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Domain_rule.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

namespace test_star_thinner {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using Geometry = internal::Double_geometry_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
using First = internal::First_triangulation<CGAL::Sequential_tag, Geometry>;
using internal::Vertex_id;

constexpr auto go_on = [] { return true; };

internal::Bounds<Geometry> bounds(double degrees, double area) { return {degrees / 180 * CGAL_PI, area, 0}; }

/// Triangulates the unit square.
void make_square(internal::Meshing_problem<Geometry>& problem, internal::Meshing_state<Geometry>& state) {
  const std::vector<Geometry::Point> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<First::Segment> segments;
  for (std::size_t i = 0; i < points.size(); ++i) segments.push_back({Vertex_id(i), Vertex_id((i + 1) % 4)});
  First first(state.mesh, points);
  REQUIRE_FALSE(first.run(segments));
  problem.edges = internal::Input_edges(first.edges(), points.size());
  problem.input_points.assign(points.begin(), points.end());
  problem.set_outside(
      internal::Domain_rule<Geometry>().apply(state.mesh, First::number_of_auxiliary_vertices));
  problem.corners.prepare(problem.edges, points.size());
}

void refine(internal::Meshing_state<Geometry>& state) {
  internal::Splitter<Geometry> splitter(state);
  internal::Refiner<Geometry> refiner(state, splitter);
  refiner.push_all();
  REQUIRE(refiner.run({100000}, go_on) == internal::Refinement_end::DONE);
}

void check_square(const internal::Meshing_state<Geometry>& state) {
  double area2 = 0;
  for (const internal::Triangle_id t : state.mesh.triangles.ids()) {
    if (!state.mesh.is_alive(t)) continue;
    const auto shape = state.mesh.shape(state.mesh.triangle(t));
    CHECK(shape.area2 > 0);
    CHECK_FALSE(state.is_bad(t));
    area2 += shape.area2;
  }
  CHECK(area2 == Approx(2));
}

} // namespace

TEST_CASE("Stars are thinned until none can be", "[thinning]") {
  const double degrees = GENERATE(0., 20.7, 25., 30.);
  CAPTURE(degrees);
  internal::Meshing_problem<Geometry> problem;
  internal::Meshing_state<Geometry> state(problem);
  make_square(problem, state);
  problem.bounds = bounds(degrees, 0.01);
  refine(state);
  const std::size_t before = state.mesh.number_of_triangles();
  CHECK(before > 100);
  problem.bounds = bounds(degrees, 0);
  internal::Star_thinner<Geometry>(state).run(go_on);
  const std::size_t after = state.mesh.number_of_triangles();
  CHECK(after < before / 2);
  check_square(state);
  CHECK(state.worklist.is_empty());
  internal::Star_thinner<Geometry>(state).run(go_on);
  CHECK(state.mesh.number_of_triangles() <= after);
  check_square(state);
}

TEST_CASE("Thinning of stars that is stopped leaves a mesh within the bounds", "[thinning]") {
  internal::Meshing_problem<Geometry> problem;
  internal::Meshing_state<Geometry> state(problem);
  make_square(problem, state);
  problem.bounds = bounds(30, 0.001);
  refine(state);
  const std::size_t before = state.mesh.number_of_triangles();
  problem.bounds = bounds(30, 0);
  int questions = 0; // the first one comes after some trials
  internal::Star_thinner<Geometry>(state).run([&questions] { return ++questions < 1; });
  CHECK(questions == 1);
  CHECK(state.mesh.number_of_triangles() < before);
  check_square(state);
}

} // namespace test_star_thinner
