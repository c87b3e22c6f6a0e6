// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Theorem 6: quadtrees that separate a graph of n vertices take O(n log n + k) steps. Steps are counted, not timed.

#include "catch.h"
#include "growth.h"
#include "pslg_inputs.h"
#include "quadtree_test_inputs.h"
#include "separation_test_tools.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace test_separation_steps {

namespace {

using namespace separation_test;
using Prepared = Prepared_graph<quadtree_test::Filtered_traits>;

/// What is done once for each step: a leaf is made or tested, or an edge is followed into the next leaf.
std::size_t steps(const CGAL::Tree_separation_report_2& report) {
  return report.leaves_made + report.pieces_cut + report.leaf_tests;
}

} // namespace

TEST_CASE("Steps grow as n log n + k", "[trees][separation][growth]") {
  for (const Tree_options& options : {Tree_options(), Tree_options::of_theorem()})
    for (const std::string family : {"coast", "segments", "holes"}) {
      std::vector<double> ratios, splits, leaves;
      for (std::size_t n = is_full_run() ? 100 : 50; n <= (is_full_run() ? 102400u : 3200u); n *= 4) {
        const auto input = pslg_inputs::by_name(family + ':' + std::to_string(n));
        Prepared prepared(input.pslg);
        const auto trees = prepared.trees(options);
        const double vertices = double(input.pslg.number_of_vertices());
        const double k = double(trees.tree().number_of_leaves() + trees.pieces().size());
        ratios.push_back(double(steps(prepared.report)) / (vertices * std::log2(vertices) + k));
        splits.push_back(double(prepared.report.splits));
        leaves.push_back(k);
      }
      CAPTURE(family, options.edge_distance(), ratios, splits, leaves);
      CHECK(growth::is_bounded(ratios));
    }
}

} // namespace test_separation_steps
