// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Vertices at which half of all edges of the first triangulation meet: corners of boxes around points in convex
// position or on a line, hubs of fans. Work that is quadratic in their degree would take minutes here.

#include "catch.h"
#include "mesher_test_tools.h"

#include "pslg_inputs.h"

#include <cstddef>
#include <string>

namespace test_hubs {

using namespace mesher_test;

TEST_CASE("Vertices of huge degree are meshed to the bound", "[quality_mesher_2][hubs]") {
  const std::string name = GENERATE(as<std::string>(), "line:3000", "upright:3000", "parabola:3000",
                                    "circle:3000", "zigzag:3000", "fan:0.12");
  CAPTURE(name);
  run_to_the_bound(pslg_inputs::by_name(name).pslg, Options());
}

TEST_CASE("Vertices of huge degree cost no quadratic time", "[quality_mesher_2][hubs]") {
  const auto [family, large, small] =
      GENERATE(table<std::string, std::string, std::string>({{"upright", "2e5", "5e4"},
                                                             {"circle", "2e5", "5e4"},
                                                             {"zigzag", "2e5", "5e4"},
                                                             {"fan", "0.0018", "0.0072"}}));
  const std::string name = family + ':' + (is_full_run() ? large : small);
  CAPTURE(name);
  const auto graph = pslg_inputs::by_name(name).pslg;
  Mesher mesher;
  mesher(graph);
  CHECK(mesher.report().is_met());
  CHECK(mesher.report().triangles < 6 * graph.number_of_vertices());
}

} // namespace test_hubs
