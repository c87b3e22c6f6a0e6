// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Meshes whose vertices are placed by rule alone: no triangle is below the bound from the beginning.

#include "theorem_5_tools.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_rule_placement {

namespace {

using namespace theorem_5_test;

Options by_rule() {
  return Options().separate(Tree_options::of_theorem().place(Tree_options::Placement::BY_RULE));
}

/// Checks that the first mesh is good as it is.
Run run_by_rule(const Pslg& pslg, const Options& options) {
  Run r = run_by_quadtrees(pslg, options);
  CHECK(r.report.trees.rounds == 1);
  CHECK(r.report.trees.missed_by_rule == 0);
  CHECK(r.report.trees.left_out == 0);
  return r;
}

/// In corners below those of the rule leaves are split to the width of the narrowest place: hours, and gigabytes.
bool has_acute_corners(const std::string& family) {
  return family == "fans and pairs" || family == "star" || family == "comb" || family == "fan" ||
         family == "wedge" || family == "needle";
}

} // namespace

TEST_CASE("By rule alone no triangle is below the bound", "[mesher][theorem5][columns]") {
  for (const std::string name :
       {"syn_square.poly", "syn_wedge_10deg.poly", "syn_wedge_1deg.poly", "syn_sliver_1deg.poly",
        "syn_near_1e-06.poly", "syn_near_1e-12.poly", "syn_holes_400.poly.gz"})
    for (const double angle : {18.43, 20.7}) {
      CAPTURE(name, angle);
      run_by_rule(read(name), by_rule().min_angle(angle));
    }
}

TEST_CASE("By rule alone, with vertices as far apart as its proof asks for", "[mesher][theorem5][columns]") {
  const auto trees = Tree_options::of_theorem().place(Tree_options::Placement::BY_RULE).vertex_distance(16);
  for (const std::string name : {"syn_square.poly", "syn_wedge_10deg.poly", "syn_near_1e-06.poly"}) {
    CAPTURE(name);
    run_by_rule(read(name), Options().separate(trees));
  }
}

TEST_CASE("By rule alone, without removal", "[mesher][theorem5][columns]") {
  for (const std::string name : {"syn_square.poly", "syn_wedge_10deg.poly", "syn_near_1e-06.poly"}) {
    CAPTURE(name);
    const Run r = run_by_rule(read(name), by_rule().coarsen(Options::Coarsening::NONE));
    CHECK(r.report.triangles == r.report.trees.triangles);
  }
}

TEST_CASE("Random inputs by rule alone", "[mesher][theorem5][columns]") {
  const std::uint64_t seeds = is_full_run() ? 20 : 1;
  for (const auto& family : random_pslg::all_families()) {
    const std::string name = family.name;
    if (has_acute_corners(name)) continue;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      CAPTURE(name, seed);
      run_by_rule(family.make(seed), by_rule());
    }
  }
}

/// One of its corners has 20.96 degrees: too little for the rule at vertices, and too much for an exemption.
TEST_CASE("A map by rule alone", "[mesher][theorem5][columns][.slow]") {
  const Run r = run_by_quadtrees(read("us_states_10m.poly.gz"), by_rule());
  CHECK(r.report.trees.rounds <= 2);
  CHECK(r.report.trees.left_out == 0);
}

} // namespace test_rule_placement
