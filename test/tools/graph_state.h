// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_GRAPH_STATE_H
#define QUADTREE_MESH_2_TEST_GRAPH_STATE_H

#include "catch.h"

#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Domain_rule.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <vector>

/// Graphs on the way through the stages of the mesher, for tests of one of them.
namespace graph_state_test {

namespace internal = CGAL::Quadtree_mesh_2::internal;

/// Triangulates a graph and keeps its domain. Acute corners are not looked for.
/// \param segments pairs of indices of points
template <class Geometry>
void triangulate(const std::vector<typename Geometry::Point>& points,
                 const std::vector<std::array<std::size_t, 2>>& segments,
                 internal::Meshing_problem<Geometry>& problem, internal::Meshing_state<Geometry>& state) {
  using First = internal::First_triangulation<CGAL::Sequential_tag, Geometry>;
  std::vector<typename First::Segment> kernel_segments;
  for (const auto& [a, b] : segments)
    kernel_segments.push_back({internal::Vertex_id(a), internal::Vertex_id(b)});
  First first(state.mesh, points);
  REQUIRE_FALSE(first.run(kernel_segments));
  problem.edges = internal::Input_edges(first.edges(), points.size());
  problem.edges.repeat(first.take_repeated_edges());
  problem.input_points.assign(points.begin(), points.end());
  problem.set_outside(
      internal::Domain_rule<Geometry>().apply(state.mesh, First::number_of_auxiliary_vertices));
  problem.corners.prepare(problem.edges, points.size());
}

/// The segments of a polygon with the vertices begin, begin + 1, ... , end - 1.
inline void append_loop(std::vector<std::array<std::size_t, 2>>& segments, std::size_t begin,
                        std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) segments.push_back({i, i + 1 < end ? i + 1 : begin});
}

template <class Geometry>
void refine(internal::Meshing_state<Geometry>& state) {
  internal::Splitter<Geometry> splitter(state);
  internal::Refiner<Geometry> refiner(state, splitter);
  refiner.push_all();
  REQUIRE(refiner.run({100000}, [] { return true; }) == internal::Refinement_end::DONE);
}

/// All triangles are counterclockwise and within the bounds, and have an area in all.
template <class Geometry>
void check_mesh(const internal::Meshing_state<Geometry>& state, double area) {
  double area2 = 0;
  for (const internal::Triangle_id t : state.mesh.triangles.ids()) {
    if (!state.mesh.is_alive(t)) continue;
    const auto shape = state.mesh.shape(state.mesh.triangle(t));
    CHECK(shape.area2 > 0);
    CHECK_FALSE(state.is_bad(t));
    area2 += shape.area2;
  }
  CHECK(area2 == Approx(2 * area));
}

} // namespace graph_state_test

#endif // QUADTREE_MESH_2_TEST_GRAPH_STATE_H
