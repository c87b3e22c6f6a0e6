// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_ROUNDS_OF_PARTS_CHECKS_H
#define QUADTREE_MESH_2_TEST_ROUNDS_OF_PARTS_CHECKS_H

#include "prepared_graph.h"

#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Rounds_of_parts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// Compares rounds of blocks in several memories with those in one.
namespace rounds_of_parts_checks {

using namespace prepared_graph;
using Mesh = Kernel_mesh<Geometry>;
using State = Meshing_state<Geometry>;

inline bool is_same(const Mesh& a, const Mesh& b, Triangle_id t) {
  const auto &r = a.triangle(t), &s = b.triangle(t);
  bool is_same = a.region(t) == b.region(t);
  for (int k = 0; k < 3; ++k) {
    const Side o = r.side[k], p = s.side[k];
    is_same = is_same && r.v[k] == s.v[k] && o.is_border() == p.is_border() && o.is_seam() == p.is_seam() &&
              o.is_constrained() == p.is_constrained() && o.slot() == p.slot() &&
              o.triangle() == p.triangle();
  }
  return is_same;
}

inline bool is_same(const Mesh& a, const Mesh& b, Vertex_id v) {
  return a.point(v).x == b.point(v).x && a.point(v).y == b.point(v).y && a.role(v) == b.role(v) &&
         a.incident_triangle(v) == b.incident_triangle(v) && a.is_dirty[v] == b.is_dirty[v];
}

inline bool are_same(const Acute_corners<Geometry>& a, const Acute_corners<Geometry>& b) {
  const auto of_shells = [](const auto& leg) {
    std::vector<std::pair<double, Vertex_id>> shells;
    for (const auto& [radius, v] : leg.shells) shells.push_back({radius, v});
    return shells;
  };
  bool is_same = a.legs.size() == b.legs.size() && a.sectors.size() == b.sectors.size();
  for (const Leg_id l : a.legs.ids())
    is_same = is_same && a.leg(l).apex_vertex == b.leg(l).apex_vertex && a.leg(l).ring == b.leg(l).ring &&
              of_shells(a.leg(l)) == of_shells(b.leg(l));
  for (const Sector_id s : a.sectors.ids())
    is_same = is_same && a.sector(s).lock_radius == b.sector(s).lock_radius;
  return is_same;
}

/// What came of the rounds, at one part.
struct Comparison {
  std::size_t faults = 0; ///< of all parts
  bool has_blocks = false;
  int rounds = 0;
  std::size_t triangles = 0; ///< of all parts; what follows is of one
  std::size_t most_held = 0, number_private = 0, number_shared = 0;
};

/// How often what is held differs from the mesh of one memory.
template <class Held>
std::size_t faults_of_records(const Mesh& right, const Mesh& mesh, const Held& held) {
  std::size_t faults = 0;
  for (const Triangle_id t : right.triangles.ids())
    if (held.is_held(t)) faults += right.is_alive(t) && is_same(mesh, right, t) ? 0 : 1;
  for (const Vertex_id v : right.points.ids())
    if (held.has(v)) faults += is_same(mesh, right, v) ? 0 : 1;
  return faults;
}

/// How many triangles are not held as they have to be: by one part, or by all; and how many vertices by none.
template <class Exchange, class Held>
std::size_t faults_of_holders(Exchange& exchange, const Mesh& right, const Held& held) {
  std::size_t faults = 0;
  Numbers holders, sharers, vouchers;
  for (const Triangle_id t : right.triangles.ids())
    holders.push_back(held.is_held(t) ? 1 : 0), sharers.push_back(held.is_shared(t) ? 1 : 0);
  for (const Vertex_id v : right.points.ids()) vouchers.push_back(held.has(v) ? 1 : 0);
  exchange.sum(holders), exchange.sum(sharers), exchange.sum(vouchers);
  for (const Triangle_id t : right.triangles.ids()) {
    const std::int64_t all = holders[t.value()], shared = sharers[t.value()];
    const bool is_right = right.is_alive(t) ? (all == 1 && (shared == 0 || exchange.size() == 1)) ||
                                                  (all == exchange.size() && shared == all)
                                            : all == 0;
    faults += is_right ? 0 : 1;
  }
  return faults + static_cast<std::size_t>(std::count(vouchers.begin(), vouchers.end(), 0));
}

/// A graph that is refined in rounds of blocks in one memory.
template <class Tag>
struct One_memory {
  Prepared prepared;
  Rounds_run<Unwatched_rounds> run;

  /// \param change changes the graph's `Prepared`
  template <class Pslg, class Change>
  One_memory(const Pslg& pslg, const Change& change)
      : prepared(pslg), run((change(prepared), run_rounds<Tag>(prepared))) {}
};

/// Refines the same graph in the memories of all parts, which all call it.
template <class Tag, class Exchange, class Pslg, class Change>
Comparison compare_with_one_memory(Exchange& exchange, const One_memory<Tag>& expected, const Pslg& pslg,
                                   const Change& change) {
  const auto& run = expected.run;
  const Mesh& right = expected.prepared.state.mesh;
  Prepared prepared(pslg);
  change(prepared);
  prepared.problem.vertex_blocks =
      blocks_by_number(prepared.problem.input_points.size(), Block_sizes<Tag>::vertices);
  Splitter<Geometry>(prepared.state).cut_rings();
  Block_rounds rounds;
  Rounds_of_parts<Tag, Exchange, Geometry> blocks(exchange, prepared.state, Finishing(), vertex_budget,
                                                  rounds);
  Comparison comparison;
  comparison.has_blocks = blocks.run([] { return true; });
  if (!comparison.has_blocks || !run.has_blocks) {
    comparison.faults = comparison.has_blocks == run.has_blocks ? 0 : 1;
    return comparison;
  }
  std::int64_t faults = 0;
  const auto note = [&](bool is_right) { faults += is_right ? 0 : 1; };
  const Mesh& mesh = prepared.state.mesh;
  note(mesh.triangles.size() == right.triangles.size());
  note(mesh.number_of_vertices() == right.number_of_vertices());
  note(rounds.number == run.rounds.number && rounds.fruitless == run.rounds.fruitless);
  note(rounds.waiting == run.rounds.waiting);
  note(rounds.at_seams == run.rounds.at_seams);
  note(are_same(prepared.state.corners, expected.prepared.state.corners));
  if (exchange.sum(faults) == 0) { // else handles have other meanings
    faults += static_cast<std::int64_t>(faults_of_records(right, mesh, blocks.held()));
    faults += static_cast<std::int64_t>(faults_of_holders(exchange, right, blocks.held()));
    const auto& dead = mesh.dead_triangles();
    const auto own = dead.begin() + static_cast<std::ptrdiff_t>(blocks.number_of_own_dead());
    std::vector<Triangle_id> all_dead = tell_all(exchange, std::vector<Triangle_id>(dead.begin(), own));
    all_dead.insert(all_dead.end(), own, dead.end());
    note(all_dead == right.dead_triangles());
  }
  comparison.faults = static_cast<std::size_t>(exchange.sum(faults));
  comparison.rounds = run.rounds.number;
  comparison.triangles = right.number_of_triangles();
  comparison.most_held = blocks.held().most_held();
  comparison.number_shared = blocks.held().number_shared();
  comparison.number_private = blocks.held().number_held() - comparison.number_shared;
  return comparison;
}
/// Makes a region of what segments enclose, every other one with a bound on areas: a share of the whole area.
inline void bound_every_other_region(Prepared& prepared, double share) {
  Mesh& mesh = prepared.state.mesh;
  mesh.region_of.assign(mesh.triangles.size(), Region_id());
  std::uint32_t regions = 0;
  double area2 = 0;
  for (const Triangle_id seed : mesh.triangles.ids()) {
    if (!mesh.is_alive(seed)) continue;
    area2 += static_cast<double>(mesh.shape(mesh.triangle(seed)).area2);
    if (mesh.region(seed).is_valid()) continue;
    const Region_id region(regions++ % 2);
    std::vector<Triangle_id> found{seed};
    mesh.set_region(seed, region);
    while (!found.empty()) {
      const Triangle_id t = found.back();
      found.pop_back();
      for (const Side o : mesh.triangle(t).side)
        if (!o.is_constrained() && !mesh.region(o.triangle()).is_valid())
          mesh.set_region(o.triangle(), region), found.push_back(o.triangle());
    }
  }
  prepared.problem.bounds.area2_of_region.assign(2, share * area2);
  prepared.problem.bounds.area2_of_region[Region_id(1)] = 4 * share * area2;
}

} // namespace rounds_of_parts_checks

#endif // QUADTREE_MESH_2_TEST_ROUNDS_OF_PARTS_CHECKS_H
