// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What refinement costs where nothing can be done: in a block, a fan whose far side is beyond a seam.

#include "catch.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>

#include <cstddef>
#include <vector>

namespace test_refiner {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CGAL::Quadtree_mesh_2::Segment_index;
using internal::Side;
using internal::Triangle_id;
using internal::Vertex_id;

/// Counts its orientation tests.
struct Counting_geometry : internal::Double_geometry_2<Kernel> {
  static std::size_t orientations;
  static int orientation(const Point& a, const Point& b, const Point& c) {
    ++orientations;
    return internal::Double_geometry_2<Kernel>::orientation(a, b, c);
  }
};
std::size_t Counting_geometry::orientations = 0;

using Mesh = internal::Kernel_mesh<Counting_geometry>;

/// A fan of n triangles from (0, 0) to the points (i, 1). What is below it is beyond a seam.
Mesh fan(Vertex_id n) {
  Mesh mesh;
  mesh.add_vertex({0, 0}, internal::input_vertex(0));
  for (Vertex_id i = 0; i <= n; ++i) mesh.add_vertex({double(i), 1}, internal::input_vertex(i + 1));
  for (Vertex_id i = 0; i < n; ++i) {
    const Triangle_id t = mesh.new_triangle(); // its vertices: the hub, and two counterclockwise
    mesh.triangle(t).v[0] = 0, mesh.triangle(t).v[1] = i + 2, mesh.triangle(t).v[2] = i + 1;
    mesh.triangle_of[0] = mesh.triangle_of[std::size_t(i) + 1] = mesh.triangle_of[std::size_t(i) + 2] = t;
  }
  for (Triangle_id t = 0; t + 1 < n; ++t) mesh.link(t, 2, Side(t + 1, 1));
  mesh.link(n - 1, 2, Side::seam(0));
  return mesh;
}

} // namespace

TEST_CASE("A fan that goes on beyond a seam waits in linear time", "[refiner]") {
  const Vertex_id n = GENERATE(1000, 4000);
  internal::Meshing_problem<Counting_geometry> problem;
  problem.bounds = internal::Bounds<Counting_geometry>(20.7 / 180 * CGAL_PI, 0, 0);
  internal::Meshing_state<Counting_geometry> state(problem, {});
  state.mesh = fan(n);
  problem.input_points = state.mesh.points;
  std::vector<internal::Input_edge> edges{{0, 1, Segment_index(0)}};
  for (Vertex_id i = 0; i < n; ++i) edges.push_back({i + 1, i + 2, Segment_index(edges.size())});
  problem.edges = internal::Input_edges(edges, state.mesh.points.size());
  problem.corners.prepare(problem.edges, state.mesh.points.size());
  problem.set_outside({});
  internal::Splitter<Counting_geometry> splitter(state);
  internal::Refiner<Counting_geometry> refiner(state, splitter);
  Counting_geometry::orientations = 0;
  refiner.push_all();
  CHECK(refiner.run({10 * std::size_t(n)}, [] { return true; }) == internal::Refinement_end::DONE);
  CHECK(state.deferred.size() > std::size_t(n) / 2);
  CHECK(Counting_geometry::orientations < 200 * state.mesh.number_of_triangles());
}

} // namespace test_refiner
