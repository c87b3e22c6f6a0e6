// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Blocks of the first round may have no triangles: all at their vertices are outside the domain. They belong to a part
// like others, and nothing is done in them. Builds with sanitizers run this, too.

#include "catch.h"
#include "mesh_digest.h"
#include "mesh_in_parts.h"
#include "mesher_test_tools.h"
#include "recounted_ledger.h"
#include "tiny_blocks.h"

#include <CGAL/Quality_mesher_2.h>

namespace test_blocks_without_triangles {

using namespace mesher_test;
using Traits = Mesh_in_parts::Traits;

TEST_CASE("Blocks without triangles are in some part", "[parts]") {
  const Pslg holes = read("syn_holes_400.poly.gz");
  const auto whole = CGAL::Quality_mesher_2<Traits, Tiny_blocks_tag>()(holes);
  const Mesh_in_parts made = mesh_in_parts<Tiny_blocks_tag>(holes, Options(), 3);
  CHECK(mesh_digest(made.mesh) == mesh_digest(whole));
  CHECK(made.ledger.rounds().size() > 1);
}

TEST_CASE("Blocks without triangles send nothing", "[parts]") {
  using CGAL::Quadtree_mesh_2::internal::Mesh_pipeline;
  const Traits traits;
  CGAL::Quality_mesh_report_2 report;
  const Pslg star = read("star_of_72_spikes.poly");
  const Options options = Options().max_area(0.01);
  Mesh_pipeline<Traits, Tiny_blocks_tag, Recounted_ledger> pipeline(star, options, traits, nullptr, report,
                                                                    Recounted_ledger(3));
  pipeline.run();
  CHECK(pipeline.watch().number_recounted() > 0);
}

} // namespace test_blocks_without_triangles
