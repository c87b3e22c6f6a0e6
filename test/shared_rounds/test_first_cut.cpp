// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The blocks of the first round, found by who has some triangles from few words: those of the whole mesh.

#include "catch.h"
#include "random_pslg_shapes.h"
#include "rounds_of_parts_checks.h"
#include "tiny_blocks.h"

#include <CGAL/Quadtree_mesh_2/internal/rounds/Round_cuts.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace test_first_cut {

namespace {

using namespace rounds_of_parts_checks;

/// \returns how many blocks there are
std::size_t check_cut(const State& state, std::mt19937& random) {
  const Round_cuts<Tiny_blocks_tag, Geometry> cuts(state);
  const Block_cut whole = cuts.first();
  const First_cut cut = cuts.first_in_few_words();
  CHECK(cut.first == whole.first);

  Indexed_vector<Triangle_id, Block_id> block_of(state.mesh.triangles.size());
  for (std::size_t b = 0; b < whole.size(); ++b)
    for (const Triangle_id t : whole[b]) block_of[t] = static_cast<Block_id>(b);
  std::size_t wrong = 0;
  for (const Triangle_id t : state.mesh.triangles.ids())
    if (state.mesh.is_alive(t) && cuts.block_of(cut, state.mesh, t) != block_of[t]) ++wrong;
  CHECK(wrong == 0);

  const std::size_t begin = random() % (whole.size() + 1),
                    end = begin + random() % (whole.size() + 1 - begin);
  const auto is_here = [&](Triangle_id t) { // and some more
    const std::size_t b = block_of[t].value();
    return state.mesh.is_alive(t) && ((begin <= b && b < end) || t.value() % 3 == 0);
  };
  const Block_cut blocks = cuts.blocks_between(cut, begin, end, state.mesh, is_here);
  REQUIRE(blocks.size() == end - begin);
  for (std::size_t b = begin; b < end; ++b)
    CHECK(std::vector<Triangle_id>(blocks[b - begin].begin(), blocks[b - begin].end()) ==
          std::vector<Triangle_id>(whole[b].begin(), whole[b].end()));
  return whole.size();
}

} // namespace

TEST_CASE("Parts find the blocks of the first round in what they have", "[parts][distributed]") {
  std::mt19937 random(3);
  std::size_t by_vertices = 0, by_position = 0;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 1; seed < 4; ++seed) {
      CAPTURE(family.name, seed);
      Prepared prepared(family.make(seed));
      State& state = prepared.state;
      prepared.problem.vertex_blocks =
          blocks_by_number(prepared.problem.input_points.size(), Block_sizes<Tiny_blocks_tag>::vertices);
      Splitter<Geometry>(state).cut_rings();
      by_vertices += check_cut(state, random);
      state.has_placed_vertices = true;
      by_position += check_cut(state, random);
      const std::size_t n = state.mesh.number_of_vertices();
      state.bulk.first_vertex = Vertex_id(n / 4), state.bulk.end_of_vertices = Vertex_id(n);
      check_cut(state, random);
      state.bulk.first_vertex = Vertex_id(0); // nothing is in blocks
      check_cut(state, random);
    }
  CHECK(by_vertices > 100);
  CHECK(by_position > 100);
}

} // namespace test_first_cut
