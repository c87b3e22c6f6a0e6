// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Shells on legs of acute corners: where they are needed, and only there.

#include "catch.h"
#include "mesher_test_tools.h"

namespace test_splitter {

using namespace mesher_test;

TEST_CASE("A leg is cut as often as a segment along it asks for", "[splitter]") {
  const Pslg pslg = read("hard_segment_along_wedge.poly"); // at 2e-4 of the leg, for 0.8 of its length
  const Run r = run_to_the_bound(pslg, Options());
  const auto triangles = static_cast<double>(r.report.triangles);
  CHECK(triangles > 0.8 / 2e-4);
  CHECK(triangles < 4 * 0.8 / 2e-4);
}

} // namespace test_splitter
