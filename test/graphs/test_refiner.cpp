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
#include <cstdint>

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
Mesh fan(std::uint32_t n) {
  Mesh mesh;
  mesh.add_vertex({0, 0}, internal::input_vertex(Vertex_id(0)));
  for (std::uint32_t i = 0; i <= n; ++i)
    mesh.add_vertex({double(i), 1}, internal::input_vertex(Vertex_id(i + 1)));
  for (std::uint32_t i = 0; i < n; ++i) {
    const Triangle_id t = mesh.new_triangle(); // its vertices: the hub, and two counterclockwise
    const Vertex_id corners[3] = {Vertex_id(0), Vertex_id(i + 2), Vertex_id(i + 1)};
    for (int k = 0; k < 3; ++k) mesh.triangle(t).v[k] = corners[k], mesh.triangle_of[corners[k]] = t;
  }
  for (std::uint32_t i = 0; i + 1 < n; ++i) mesh.link(Triangle_id(i), 2, Side(Triangle_id(i + 1), 1));
  mesh.link(Triangle_id(n - 1), 2, Side::seam(0));
  return mesh;
}

} // namespace

TEST_CASE("A fan that goes on beyond a seam waits in linear time", "[refiner]") {
  const std::uint32_t n = GENERATE(1000u, 4000u);
  internal::Meshing_problem<Counting_geometry> problem;
  problem.bounds = internal::Bounds<Counting_geometry>(20.7 / 180 * CGAL_PI, 0, 0);
  internal::Meshing_state<Counting_geometry> state(problem, {});
  state.mesh = fan(n);
  problem.input_points = state.mesh.points;
  internal::Input_edge_list edges{{Vertex_id(0), Vertex_id(1), Segment_index(0)}};
  for (std::uint32_t i = 0; i < n; ++i)
    edges.push_back({Vertex_id(i + 1), Vertex_id(i + 2), Segment_index(edges.size())});
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
