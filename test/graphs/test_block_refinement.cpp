// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Rounds of blocks: they end with nothing that waits, and their zones are what they are said to be.

#include "catch.h"
#include "prepared_graph.h"
#include "pslg_inputs.h"
#include "random_pslg_shapes.h"
#include "tiny_blocks.h"

#include <CGAL/Quadtree_mesh_2/internal/rounds/Block_refinement.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Triangle_zone.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace test_block_refinement {

namespace {

using namespace prepared_graph;

/// \returns whether the graph was large enough for blocks
template <class Tag, class Pslg>
bool check_that_nothing_waits(const Pslg& pslg) {
  Prepared prepared(pslg);
  const auto run = run_rounds<Tag>(prepared);
  if (!run.has_blocks) return false;
  CHECK(run.rounds.number <= 20);
  const auto& mesh = prepared.state.mesh;
  for (const Triangle_id t : mesh.triangles.ids())
    if (mesh.is_alive(t) && prepared.state.is_bad(t)) CHECK(is_near_uncut_leg(prepared.state, t));
  return true;
}

/// Refines the blocks of a graph; `look(block, taken)` is called for each once it is written, with what was taken out.
template <class Look>
void refine_blocks(Meshing_state<Geometry>& state, const Look& look) {
  using Tag = Small_blocks_tag;
  state.problem.vertex_blocks =
      blocks_by_number(state.problem.input_points.size(), Block_sizes<Tag>::vertices);
  Block_assignment assignment;
  Mesh_blocks<Tag, Geometry> blocks(state.mesh, assignment, Round_cuts<Tag, Geometry>(state).first());
  const auto owned = Corner_places<Tag, Geometry>(state).by_block(
      blocks.size(), [&](Triangle_id t) { return blocks.block_of(t); });
  const Block_work<Geometry> work(state.problem, Finishing(), 1);
  blocks.for_each(
      [&](Mesh_block<Geometry>& block) {
        const auto left = work.run(block, owned[block.id()], 100000, [] { return true; });
        for (const Triangle_id t : left) CHECK(block.mesh.is_alive(t));
      },
      [&](const Mesh_block<Geometry>& block) {
        work.name_in_whole(block, owned[block.id()]);
        look(block, blocks.cut()[block.id().value()]);
      });
  blocks.put_together();
}

} // namespace

TEST_CASE("Rounds of tiny blocks end with nothing that waits", "[refiner]") {
  const auto& families = random_pslg::all_families();
  const std::uint64_t seeds = is_full_run() ? 5000 / families.size() + 1 : 20;
  std::size_t cut = 0;
  for (const auto& family : families)
    for (std::uint64_t seed = 100; seed < 100 + seeds; ++seed) {
      CAPTURE(family.name, seed);
      if (check_that_nothing_waits<Tiny_blocks_tag>(family.make(seed))) ++cut;
    }
  CHECK(cut > 100);
}

TEST_CASE("Rounds of blocks of 256 end with nothing that waits", "[refiner]") {
  const int sizes = is_full_run() ? 1250 : 3;
  for (const char* family : {"coast:", "stars:", "segments:", "blob:"})
    for (int i = 0; i < sizes; ++i) {
      const std::string name = family + std::to_string(600 + i);
      CAPTURE(name);
      CHECK(check_that_nothing_waits<Small_blocks_tag>(pslg_inputs::by_name(name).pslg));
    }
}

TEST_CASE("What came and went in a block gets no handle in the whole mesh", "[refiner]") {
  std::size_t gone = 0;
  for (const char* name : {"coast:3000", "stars:2000", "segments:2000"}) {
    CAPTURE(name);
    Prepared prepared(pslg_inputs::by_name(name).pslg);
    auto& state = prepared.state;
    const std::size_t triangles = state.mesh.triangles.size(), vertices = state.mesh.number_of_vertices();
    refine_blocks(state, [&](const Mesh_block<Geometry>& block, Span<Triangle_id> taken) {
      gone += block.mesh.triangles.size() - taken.size() - block.number_of_new_triangles();
    });
    std::size_t unused = 0;
    for (const Triangle_id t : Id_range<Triangle_id>(triangles, state.mesh.triangles.size()))
      unused += state.mesh.is_alive(t) ? 0 : 1;
    for (const Vertex_id v : Id_range<Vertex_id>(vertices, state.mesh.number_of_vertices()))
      unused += state.mesh.is_used(v) || !state.mesh.is_free(v) ? 0 : 1;
    CHECK(unused == 0);
    CHECK(state.mesh.triangles.size() > triangles);
  }
  CHECK(gone > 0);
}

TEST_CASE("What is at seams of a block gets its first new handles", "[refiner]") {
  for (const char* name : {"coast:3000", "stars:2000", "segments:2000"}) {
    CAPTURE(name);
    Prepared prepared(pslg_inputs::by_name(name).pslg);
    std::size_t blocks = 0, wrong = 0, late = 0, moved = 0;
    refine_blocks(prepared.state, [&](const Mesh_block<Geometry>& block, Span<Triangle_id> taken) {
      ++blocks;
      std::set<Triangle_id> handles, at_seams;
      std::set<Triangle_id> expected(taken.begin(), taken.end());
      for (const Triangle_id t : block.dead()) expected.erase(t);
      const Triangle_id first = block.first_new_triangle();
      const std::size_t number = block.number_of_new_triangles();
      for (std::size_t i = 0; i < number; ++i) expected.insert(Triangle_id(first.value() + i));
      for (const Triangle_id t : block.mesh.triangles.ids()) {
        if (!block.mesh.is_alive(t)) continue;
        const Triangle_id handle = block.whole_triangle(t);
        handles.insert(handle);
        if (t.value() < taken.size() && handle != taken[t.value()]) ++moved;
        for (const Side s : block.mesh.triangle(t).side)
          if (s.is_seam()) at_seams.insert(handle);
      }
      if (handles != expected || handles.size() != block.mesh.number_of_triangles()) ++wrong;
      for (const Triangle_id t : at_seams)
        if (at_seams.size() <= number && (t < first || t.value() >= first.value() + at_seams.size())) ++late;
    });
    CHECK(wrong == 0);
    CHECK(late == 0);
    CHECK(blocks > 2);
    CHECK(moved > 0);
  }
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
