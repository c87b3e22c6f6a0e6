// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Rounds of blocks of a mesh in several memories: the bits of one memory for any number of parts, none of which has all.

#include "catch.h"
#include "mesher_test_tools.h"
#include "prepared_graph.h"
#include "pslg_inputs.h"
#include "random_pslg_shapes.h"
#include "tiny_blocks.h"

#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Rounds_of_parts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace test_rounds_of_parts {

namespace {

using namespace prepared_graph;
using Mesh = Kernel_mesh<Geometry>;
using Held = Held_mesh<In_memory_exchange, Geometry>;
using State = Meshing_state<Geometry>;
using mesher_test::Pslg;

constexpr std::size_t budget = 1000000;

bool is_same(const Mesh& a, const Mesh& b, Triangle_id t) {
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

bool is_same(const Mesh& a, const Mesh& b, Vertex_id v) {
  return a.point(v).x == b.point(v).x && a.point(v).y == b.point(v).y && a.role(v) == b.role(v) &&
         a.incident_triangle(v) == b.incident_triangle(v) && a.is_dirty[v] == b.is_dirty[v];
}

bool are_same(const Acute_corners<Geometry>& a, const Acute_corners<Geometry>& b) {
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

/// What parts hold together, and where they differ from one memory.
struct Findings {
  std::size_t faults = 0;
  std::vector<int> private_holders, holders, vouchers; // by triangle, by triangle, by vertex
  std::vector<Triangle_id> dead;
  std::size_t most_held = 0;
};

void compare(const State& expected, const Block_rounds& expected_rounds, const State& whole,
             const Block_rounds& rounds, const Held& held, Findings& found) {
  const auto note = [&](bool is_right) { found.faults += is_right ? 0 : 1; };
  const Mesh &mesh = whole.mesh, &right = expected.mesh;
  note(mesh.triangles.size() == right.triangles.size());
  note(mesh.number_of_vertices() == right.number_of_vertices());
  if (found.faults > 0) return;
  for (const Triangle_id t : right.triangles.ids()) {
    if (!held.is_held(t)) continue;
    note(right.is_alive(t) && is_same(mesh, right, t));
    ++found.holders[t.value()];
    if (held.is_private(t)) ++found.private_holders[t.value()];
  }
  for (const Vertex_id v : right.points.ids()) {
    if (!held.has(v)) continue;
    note(is_same(mesh, right, v));
    ++found.vouchers[v.value()];
  }
  note(rounds.number == expected_rounds.number && rounds.fruitless == expected_rounds.fruitless);
  note(rounds.waiting == expected_rounds.waiting);
  note(rounds.at_seams == expected_rounds.at_seams);
  note(are_same(whole.corners, expected.corners));
  found.most_held = std::max(found.most_held, held.most_held());
}

struct Outcome_of_parts {
  bool has_blocks = false;
  std::size_t most_held = 0, triangles = 0, rounds = 0;
  std::vector<Exchange_traffic> traffic;
};

/// Compares what so many parts make with what one memory makes.
template <class Tag, class Pslg>
Outcome_of_parts check_parts(const Pslg& pslg, int parts) {
  Prepared expected(pslg);
  const auto run = run_rounds<Tag>(expected);
  const std::size_t triangles = expected.state.mesh.triangles.size();
  Findings found;
  found.private_holders.resize(triangles), found.holders.resize(triangles);
  found.vouchers.resize(expected.state.mesh.number_of_vertices());
  std::mutex one_by_one;
  Outcome_of_parts outcome;
  outcome.traffic = In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
    Prepared prepared(pslg);
    prepared.problem.vertex_blocks =
        blocks_by_number(prepared.problem.input_points.size(), Block_sizes<Tag>::vertices);
    Splitter<Geometry>(prepared.state).cut_rings();
    Block_rounds rounds;
    Rounds_of_parts<Tag, In_memory_exchange, Geometry> blocks(exchange, prepared.state, Finishing(), budget,
                                                              rounds);
    const bool has_blocks = blocks.run([] { return true; });
    std::vector<Triangle_id> dead = prepared.state.mesh.dead_triangles();
    const auto own = dead.begin() + static_cast<std::ptrdiff_t>(blocks.number_of_own_dead());
    const std::vector<Triangle_id> own_dead = tell_all(exchange, std::vector<Triangle_id>(dead.begin(), own));
    const std::lock_guard<std::mutex> lock(one_by_one);
    found.faults += has_blocks == run.has_blocks ? 0 : 1;
    if (!has_blocks) return;
    compare(expected.state, run.rounds, prepared.state, rounds, blocks.held(), found);
    found.dead = own_dead;
    found.dead.insert(found.dead.end(), own, dead.end());
    found.faults += found.dead == expected.state.mesh.dead_triangles() ? 0 : 1;
  });
  CHECK(found.faults == 0);
  if (!run.has_blocks) return outcome;
  for (const Triangle_id t : expected.state.mesh.triangles.ids()) {
    const int privately = found.private_holders[t.value()], holders = found.holders[t.value()];
    const bool is_right = expected.state.mesh.is_alive(t)
                              ? (privately == 1 && holders == 1) || (privately == 0 && holders == parts)
                              : holders == 0;
    if (!is_right) CHECK(t.value() == 0xffffffff);
  }
  CHECK(std::count(found.vouchers.begin(), found.vouchers.end(), 0) == 0);
  outcome.has_blocks = true;
  outcome.most_held = found.most_held;
  outcome.triangles = expected.state.mesh.number_of_triangles();
  outcome.rounds = static_cast<std::size_t>(run.rounds.number);
  return outcome;
}

template <class Tag, class Pslg>
std::size_t check_all_parts(const Pslg& pslg) {
  std::size_t cut = 0;
  for (const int parts : {1, 2, 3, 7}) {
    CAPTURE(parts);
    if (check_parts<Tag>(pslg, parts).has_blocks) ++cut;
  }
  return cut;
}

/// The same graph with its vertices in the order of places, as the mesher has them.
Pslg in_order_of_places(const Pslg& pslg) {
  std::vector<Geometry::Point> points;
  for (const auto& p : pslg.vertices) points.push_back({p.x(), p.y()});
  const Place_keys<Geometry> key(points);
  std::vector<std::size_t> order(points.size()), place(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key(points[a]) < key(points[b]); });
  Pslg sorted;
  for (const std::size_t i : order) place[i] = sorted.vertices.size(), sorted.add_vertex(pslg.vertices[i]);
  for (const auto& [a, b] : pslg.segments)
    sorted.add_segment(CGAL::Quadtree_mesh_2::Vertex_index(place[std::size_t(a)]), CGAL::Quadtree_mesh_2::Vertex_index(place[std::size_t(b)]));
  return sorted;
}

} // namespace

TEST_CASE("Parts of random graphs in tiny blocks have the bits of one memory", "[parts][distributed]") {
  const auto& families = random_pslg::all_families();
  const std::uint64_t seeds = is_full_run() ? 100 : 3;
  std::size_t cut = 0;
  for (const auto& family : families)
    for (std::uint64_t seed = 100; seed < 100 + seeds; ++seed) {
      CAPTURE(family.name, seed);
      cut += check_all_parts<Tiny_blocks_tag>(family.make(seed));
    }
  CHECK(cut > 20);
}

TEST_CASE("Parts of graphs with acute corners and holes have the bits of one memory",
          "[parts][distributed]") {
  for (const char* name : {"stars:600", "blob:600", "segments:600", "coast:2000", "holes:100"}) {
    CAPTURE(name);
    CHECK(check_all_parts<Tiny_blocks_tag>(pslg_inputs::by_name(name).pslg) == 4);
  }
  CHECK(check_all_parts<Tiny_blocks_tag>(mesher_test::read("us_states_10m.poly.gz")) == 4);
  CHECK(check_all_parts<Small_blocks_tag>(mesher_test::read("us_states_10m.poly.gz")) == 4);
}

TEST_CASE("Parts of a coast have its bits, and their share of it", "[parts][distributed][.slow]") {
  const Pslg norway = in_order_of_places(mesher_test::read("gshhg_norway_f.poly.gz"));
  for (const int parts : {2, 7}) {
    const Outcome_of_parts outcome = check_parts<CGAL::Parallel_tag>(norway, parts);
    std::size_t messages = 0, bytes = 0;
    for (const Exchange_traffic& t : outcome.traffic)
      messages = std::max(messages, t.messages), bytes = std::max(bytes, t.bytes);
    WARN(parts << " parts: " << outcome.rounds << " rounds, " << outcome.triangles << " triangles, "
               << outcome.most_held << " held at most, " << messages << " messages and " << bytes
               << " bytes at most");
  }
}

} // namespace test_rounds_of_parts
