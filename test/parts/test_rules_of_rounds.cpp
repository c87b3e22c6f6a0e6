// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The six rules of rounds of blocks (doc/rounds.md), each on graphs in blocks of 24, seen by a watch on the rounds.

#include "catch.h"
#include "prepared_graph.h"
#include "random_pslg_shapes.h"
#include "tiny_blocks.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace test_rules_of_rounds {

namespace {

using namespace prepared_graph;
using State = Meshing_state<Geometry>;

/// How often something was looked at, and how often it was not as it has to be.
struct Finding {
  std::size_t looks = 0, faults = 0;
  void note(bool is_right) {
    ++looks;
    if (!is_right) ++faults;
  }
  Finding& operator+=(const Finding& other) {
    looks += other.looks, faults += other.faults;
    return *this;
  }
};

/// Watches the rounds for all six rules.
class Rule_watch : public Unwatched_rounds {
public:
  Finding caps;          // 1
  Finding seams;         // 2
  Finding carried;       // 3
  Finding corners;       // 4
  Finding seam_vertices; // 6

  template <class Zone>
  void zone_is_found(const State& whole, const Zone& zone, const std::vector<Triangle_id>& waiting) {
    std::set<std::uint32_t> in_zone, waits;
    for (const Triangle_id t : zone.triangles()) in_zone.insert(t.value());
    for (const Triangle_id t : waiting) waits.insert(t.value());
    const auto has = [&](Triangle_id t) { return in_zone.count(t.value()) != 0; };
    for (const Triangle_id t : whole.mesh.triangles.ids())
      if (whole.mesh.is_alive(t) && whole.is_bad(t))
        carried.note((waits.count(t.value()) != 0 && has(t)) || is_near_uncut_leg(whole, t));
    for (const Triangle_id t : waiting)
      if (whole.mesh.is_alive(t)) note_corners(whole, t, has);
  }

  template <class Blocks>
  void blocks_are_cut(const State& whole, const Blocks& blocks, int round) {
    if (round > 1) note_caps(blocks.cut(), round);
    triangles_before_.assign(whole.mesh.triangles.begin(), whole.mesh.triangles.end());
    points_before_.assign(whole.mesh.points.begin(), whole.mesh.points.end());
  }

  template <class Blocks>
  void are_written(const State& whole, const Blocks& blocks) {
    sides_at_seams_.clear();
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for (const auto& seam : blocks.seams_of(Block_id(b))) {
        sides_at_seams_.push_back(seam.now);
        const auto& before = triangles_before_[seam.here.triangle().value()];
        note_vertex(whole, before.v[next_slot[seam.here.slot()]], whole.mesh.source(seam.now));
        note_vertex(whole, before.v[previous_slot[seam.here.slot()]], whole.mesh.target(seam.now));
      }
  }

  void round_is_over(const State& whole) {
    const auto& mesh = whole.mesh;
    for (const Side s : sides_at_seams_) {
      const Side o = mesh.across(s); // where rounding is as it is, one of the two may not be sure
      seams.note(o.is_constrained() || !mesh.is_certainly_not_Delaunay(s.triangle(), s.slot()) ||
                 !mesh.is_certainly_not_Delaunay(o.triangle(), o.slot()));
    }
  }

private:
  std::vector<Kernel_mesh<Geometry>::Triangle> triangles_before_;
  std::vector<Geometry::Point> points_before_;
  std::vector<Side> sides_at_seams_;

  /// Blocks have at most so many triangles, and two in a row more than that: so there are few.
  void note_caps(const Block_cut& cut, int round) {
    std::size_t cap = Block_sizes<Tiny_blocks_tag>::triangles / 4;
    for (int r = 4; r <= std::min(round, 12); ++r) cap *= 4;
    caps.note(cut.size() <= 2 * cut.members.size() / cap + 1);
    for (std::size_t b = 0; b < cut.size(); ++b) caps.note(cut[b].size() <= cap);
  }

  void note_vertex(const State& whole, Vertex_id before, Vertex_id now) {
    const auto &p = points_before_[before.value()], &q = whole.mesh.point(now);
    seam_vertices.note(before == now && p.x == q.x && p.y == q.y);
  }

  /// The stars of all Steiner vertices where legs of a corner are cut have to be in the zone, if the triangle has a
  /// vertex on one of the legs.
  template <class Has>
  void note_corners(const State& whole, Triangle_id t, const Has& has) {
    for (const auto& corner : whole.corners.corners) {
      const auto& legs = corner.legs;
      const auto is_at_leg = [&](Vertex_id v) {
        return std::any_of(legs.begin(), legs.end(), [&](Leg_id l) {
          return whole.edges.is_on(whole.mesh, v, whole.corners.leg(l).edge);
        });
      };
      const auto& v = whole.mesh.triangle(t).v;
      if (!std::any_of(v, v + 3, is_at_leg)) continue;
      if (std::any_of(legs.begin(), legs.end(), [&](Leg_id l) { return is_uncut(whole, l); })) continue;
      for (const Leg_id l : legs)
        for (const auto& shell : whole.corners.leg(l).shells)
          if (whole.mesh.is_used(shell.second) && !whole.mesh.is_input(shell.second))
            whole.mesh.for_each_triangle_at(shell.second, [&](Triangle_id u, int) { corners.note(has(u)); });
    }
  }
};

/// Calls `look(prepared, run)` after the rounds of random graphs of all families.
template <class Look>
void for_each_run(const Look& look) {
  const std::uint64_t seeds = is_full_run() ? 200 : 5;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 300; seed < 300 + seeds; ++seed) {
      CAPTURE(family.name, seed);
      Prepared prepared(family.make(seed));
      const auto run = run_rounds<Tiny_blocks_tag, Rule_watch>(prepared);
      if (run.has_blocks) look(prepared, run);
    }
}

void check(Finding Rule_watch::*finding) {
  Finding sum;
  for_each_run([&](const Prepared&, const Rounds_run<Rule_watch>& run) { sum += run.watch.*finding; });
  CHECK(sum.looks > 100);
  CHECK(sum.faults == 0);
}

} // namespace

TEST_CASE("Rule 1: blocks grow from the fourth round on", "[refiner]") { check(&Rule_watch::caps); }

TEST_CASE("Rule 2: no side of a seam is left that has to be flipped", "[refiner]") {
  check(&Rule_watch::seams);
}

TEST_CASE("Rule 3: what waits is in the next zone, and nothing else is bad", "[refiner]") {
  check(&Rule_watch::carried);
}

TEST_CASE("Rule 4: who waits for a corner brings all of it into the next zone", "[refiner]") {
  check(&Rule_watch::corners);
}

TEST_CASE("Rule 5: rounds that do not help end, and the whole mesh decides", "[refiner]") {
  std::size_t runs = 0;
  for_each_run([&](Prepared& prepared, const Rounds_run<Rule_watch>& run) {
    ++runs;
    CHECK(run.rounds.number <= 20);
    if (run.rounds.waiting.empty()) return;
    CHECK(run.rounds.fruitless == 3);
    std::set<std::uint32_t> waits, on_worklist;
    for (const Triangle_id t : run.rounds.waiting) waits.insert(t.value());
    while (!prepared.state.worklist.is_empty()) on_worklist.insert(prepared.state.worklist.pop().value());
    CHECK(on_worklist == waits);
  });
  CHECK(runs > 20);
}

TEST_CASE("Rule 6: vertices at seams are neither moved nor removed", "[refiner]") {
  check(&Rule_watch::seam_vertices);
}

} // namespace test_rules_of_rounds
