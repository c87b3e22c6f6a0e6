// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Acute corners that reach through most of the mesh: no block has all of one, so triangles wait for it however the
// blocks are cut. In a large mesh the rounds end early then, and the whole mesh decides.

#include "catch.h"
#include "mesh_in_parts.h"
#include "mesher_test_tools.h"
#include "tiny_blocks.h"

#include <CGAL/Quadtree_mesh_2/internal/rounds/Block_rounds.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <cstddef>

namespace test_corners_through_the_mesh {

using namespace mesher_test;
using CGAL::Quadtree_mesh_2::internal::Block_rounds;
using CGAL::Quadtree_mesh_2::internal::Round_extent;

namespace {

/// How many rounds there are if each has this extent, and so many triangles less wait after it.
int number_of_rounds(const Round_extent& extent, std::size_t waiting, std::size_t less) {
  Block_rounds rounds;
  rounds.waiting.resize(waiting);
  do {
    const std::size_t before = rounds.waiting.size();
    ++rounds.number;
    rounds.waiting.resize(before - less);
    rounds.note(before, extent);
  } while (rounds.may_go_on());
  return rounds.number;
}

} // namespace

TEST_CASE("A graph whose corners reach through the mesh is meshed in blocks", "[parts]") {
  const Pslg strip = read("hard_corners_through_the_mesh.poly");
  const auto made =
      mesh_in_parts<Tiny_blocks_tag>(strip, Options().separate(Options::Separation::THEOREM_5), 3);
  CHECK(made.ledger.rounds().size() > 1);
  CHECK(made.ledger.rounds().size() < 20); // 40 is the most
  CHECK(made.report.unmet_triangles.empty());
  CHECK(CGAL::mesh_quality_2(made.mesh, strip).is_valid());
}

TEST_CASE("Rounds through most of a large mesh end if they hardly help", "[parts]") {
  const std::size_t waiting = 400000, slots = 900000, zone = 450000;
  CHECK(number_of_rounds({20, zone, slots}, waiting, 4) == 5);
  CHECK(number_of_rounds({1, zone, slots}, waiting, 4) == 5);
  CHECK(number_of_rounds({20, zone, slots}, waiting, waiting / 10) == 10); // until none waits
}

TEST_CASE("Other rounds go on while they help at all, and several blocks in any case", "[parts]") {
  const std::size_t slots = 900000;
  CHECK(number_of_rounds({1, 1000, slots}, 100, 4) == 25); // until none waits
  CHECK(number_of_rounds({1, 1000, slots}, 100, 0) == 5);
  CHECK(number_of_rounds({20, 1000, slots}, 100, 0) == Block_rounds::most);
  CHECK(number_of_rounds({20, 1000, 1000}, 100, 0) == Block_rounds::most); // all of a small mesh
}

} // namespace test_corners_through_the_mesh
