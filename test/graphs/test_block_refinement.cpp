// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Rounds of blocks: they end with nothing that waits, and their zones are what they are said to be.

#include "catch.h"
#include "graph_state.h"
#include "random_pslg_shapes.h"
#include "tiny_blocks.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Block_refinement.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Corner_finder.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Size_estimate.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Triangle_zone.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace test_block_refinement {

namespace {

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

bool is_uncut(const Meshing_state<Geometry>& state, Leg_id l) {
  const auto& shells = state.corners.leg(l).shells;
  return std::none_of(shells.begin(), shells.end(),
                      [&](const auto& shell) { return state.mesh.is_used(shell.second); });
}

/// Whether the triangle has a vertex on a leg of a corner of which some leg could not be cut. Such a corner is owned by
/// no block.
bool has_vertex_at_uncut_leg(const Meshing_state<Geometry>& state, Triangle_id t) {
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
bool is_near_uncut_leg(const Meshing_state<Geometry>& state, Triangle_id t) {
  constexpr int rings = 4;
  Triangle_zone<CGAL::Sequential_tag, Geometry> zone(state.mesh);
  zone.add(std::vector<Triangle_id>{t});
  zone.grow(rings);
  return std::any_of(zone.triangles().begin(), zone.triangles().end(),
                     [&](Triangle_id near) { return has_vertex_at_uncut_leg(state, near); });
}

} // namespace

TEST_CASE("Rounds of tiny blocks end with nothing that waits", "[refiner]") {
  std::size_t cut = 0;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 100; seed < 140; ++seed) {
      CAPTURE(family.name, seed);
      const auto pslg = family.make(seed);
      Prepared prepared(pslg);
      prepared.problem.vertex_blocks =
          blocks_by_number(pslg.number_of_vertices(), Block_sizes<Tiny_blocks_tag>::vertices);
      Splitter<Geometry> splitter(prepared.state);
      splitter.cut_rings();
      constexpr std::size_t budget = 1000000;
      Block_rounds rounds;
      Block_refinement<Tiny_blocks_tag, Geometry> blocks(prepared.state, Finishing(), budget, rounds);
      if (!blocks.run([] { return true; }, [] {})) continue;
      ++cut;
      CHECK(rounds.number <= 20);
      const auto& mesh = prepared.state.mesh;
      for (const Triangle_id t : mesh.triangles.ids())
        if (mesh.is_alive(t) && prepared.state.is_bad(t)) CHECK(is_near_uncut_leg(prepared.state, t));
    }
  CHECK(cut > 100);
}

TEST_CASE("A zone has the rings around its seeds", "[refiner]") {
  Prepared prepared(random_pslg::all_families().front().make(7));
  const auto& mesh = prepared.state.mesh;
  const std::vector<Triangle_id> seeds{Triangle_id(0), Triangle_id(mesh.triangles.size() / 2),
                                       Triangle_id(0)};
  std::set<std::uint32_t> expected;
  for (const Triangle_id t : seeds) expected.insert(t.value());
  for (int rings = 0; rings < 6; ++rings) {
    Triangle_zone<CGAL::Parallel_tag, Geometry> zone(mesh);
    zone.add(seeds);
    zone.grow(rings);
    std::vector<std::uint32_t> found;
    for (const Triangle_id t : zone.triangles()) found.push_back(t.value());
    std::sort(found.begin(), found.end());
    REQUIRE(found == std::vector<std::uint32_t>(expected.begin(), expected.end()));
    const std::set<std::uint32_t> inner = expected;
    for (const std::uint32_t t : inner)
      for (const Side o : mesh.triangle(Triangle_id(t)).side)
        if (!o.is_border()) expected.insert(o.triangle().value());
  }
}

} // namespace test_block_refinement
