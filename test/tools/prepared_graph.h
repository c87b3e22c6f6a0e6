// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_PREPARED_GRAPH_H
#define QUADTREE_MESH_2_TEST_PREPARED_GRAPH_H

#include "graph_state.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Corner_finder.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Size_estimate.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Block_refinement.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Triangle_zone.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

/// Graphs on the way to the rounds of blocks.
namespace prepared_graph {

using namespace CGAL::Quadtree_mesh_2::internal;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Geometry = Double_geometry_2<Kernel>;

/// A graph up to refinement.
struct Prepared {
  Meshing_problem<Geometry> problem;
  Meshing_state<Geometry> state{problem};

  template <class Pslg>
  explicit Prepared(const Pslg& pslg) {
    std::vector<Geometry::Point> points;
    for (const auto& p : pslg.vertices) points.push_back({p.x(), p.y()});
    std::vector<std::array<std::size_t, 2>> segments;
    for (const auto& [a, b] : pslg.segments) segments.push_back({std::size_t(a), std::size_t(b)});
    graph_state_test::triangulate(points, segments, problem, state);
    problem.bounds = Bounds<Geometry>(20.7 * radians_per_degree, 0, 0);
    Size_estimate<Geometry> estimate(state, CGAL::Sequential_tag());
    Corner_finder<CGAL::Sequential_tag, Geometry>(state, estimate.take_acute_starts()).run();
  }
};

inline bool is_uncut(const Meshing_state<Geometry>& state, Leg_id l) {
  const auto& shells = state.corners.leg(l).shells;
  return std::none_of(shells.begin(), shells.end(),
                      [&](const auto& shell) { return state.mesh.is_used(shell.second); });
}

/// Whether the triangle has a vertex on a leg of a corner of which some leg could not be cut. Such a corner is owned by
/// no block.
inline bool has_vertex_at_uncut_leg(const Meshing_state<Geometry>& state, Triangle_id t) {
  for (const auto& corner : state.corners.corners)
    for (const Leg_id uncut : corner.legs) {
      if (!is_uncut(state, uncut)) continue;
      for (const Vertex_id v : state.mesh.triangle(t).v)
        for (const Leg_id l : corner.legs)
          if (v == state.corners.leg(l).apex_vertex ||
              state.edges.is_on(state.mesh, v, state.corners.leg(l).edge))
            return true;
    }
  return false;
}

/// Whether that is so for the triangle, or for one nearby: the edge to be split for it may be across some others.
inline bool is_near_uncut_leg(const Meshing_state<Geometry>& state, Triangle_id t) {
  constexpr int rings = 4;
  Triangle_zone<CGAL::Sequential_tag, Geometry> zone(state.mesh);
  zone.add(std::vector<Triangle_id>{t});
  zone.grow(rings);
  return std::any_of(zone.triangles().begin(), zone.triangles().end(),
                     [&](Triangle_id near) { return has_vertex_at_uncut_leg(state, near); });
}

/// How many vertices rounds may make.
constexpr std::size_t vertex_budget = 1000000;

/// What `run_rounds()` leaves, with who watched.
template <class Watch>
struct Rounds_run {
  Block_rounds rounds;
  Watch watch;
  bool has_blocks = false; ///< else the graph was too small for them
};

/// Refines in rounds of blocks.
template <class Tag, class Watch = Unwatched_rounds>
Rounds_run<Watch> run_rounds(Prepared& prepared) {
  prepared.problem.vertex_blocks =
      blocks_by_number(prepared.problem.input_points.size(), Block_sizes<Tag>::vertices);
  Splitter<Geometry> splitter(prepared.state);
  splitter.cut_rings();
  Rounds_run<Watch> run;
  Block_refinement<Tag, Geometry, Watch> blocks(prepared.state, Finishing(), vertex_budget, run.rounds,
                                                run.watch);
  run.has_blocks = blocks.run([] { return true; }, [] {});
  return run;
}

} // namespace prepared_graph

#endif // QUADTREE_MESH_2_TEST_PREPARED_GRAPH_H
