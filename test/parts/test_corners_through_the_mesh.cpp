// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Acute corners that reach through most of the mesh: no block has all of one, so triangles wait for it however the
// blocks are cut. Then the rounds end early, and the whole mesh decides.

#include "catch.h"
#include "mesh_in_parts.h"
#include "mesher_test_tools.h"
#include "tiny_blocks.h"

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

namespace test_corners_through_the_mesh {

using namespace mesher_test;

TEST_CASE("Rounds end where corners reach through the mesh", "[parts]") {
  const Pslg strip = read("hard_corners_through_the_mesh.poly");
  const auto made =
      mesh_in_parts<Tiny_blocks_tag>(strip, Options().separate(Options::Separation::THEOREM_5), 3);
  CAPTURE(made.ledger.rounds().size(), made.mesh.triangles.size());
  CHECK(made.ledger.rounds().size() > 1);
  CHECK(made.ledger.rounds().size() <= 8); // 40 is the most
  CHECK(made.report.unmet_triangles.empty());
  CHECK(CGAL::mesh_quality_2(made.mesh, strip).is_valid());
}

} // namespace test_corners_through_the_mesh
