// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_THEOREM_5_TOOLS_H
#define QUADTREE_MESH_2_TEST_THEOREM_5_TOOLS_H

// Runs of the mesher in which quadtrees separate the features.

#include "mesher_test_tools.h"
#include "random_pslg_shapes.h"

#include <cstddef>

namespace theorem_5_test {

using namespace mesher_test;
using Tree_options = CGAL::Tree_separation_options_2;
using End = CGAL::Tree_separation_report_2::End;

/// Quadtrees go on until they miss no triangle.
inline Options by_quadtrees() { return Options().separate(Tree_options::of_theorem()); }

/// Whether quadtrees take about as many triangles as refinement on demand, for inputs of a few features, too.
inline bool is_about_as_many(std::size_t by_trees, std::size_t on_demand) {
  return double(by_trees) <= 1.2 * double(on_demand) + 5;
}

/// Meshes, and checks that every bound is met, and that of angles by quadtrees alone.
inline Run run_by_quadtrees(const Pslg& pslg, const Options& options) {
  Run r = run_to_the_bound(pslg, options);
  CHECK(r.report.trees.rounds > 0);
  CHECK(r.report.trees.missed == 0);
  CHECK(r.report.trees.handed_over == 0);
  CHECK(r.report.trees.end == End::DONE);
  return r;
}

inline bool are_same(const Mesh& a, const Mesh& b) {
  return a.points == b.points && a.triangles == b.triangles && a.neighbors == b.neighbors &&
         a.segment_of_vertex == b.segment_of_vertex && a.vertex_markers == b.vertex_markers &&
         a.region_of_triangle == b.region_of_triangle;
}

} // namespace theorem_5_test

#endif // QUADTREE_MESH_2_TEST_THEOREM_5_TOOLS_H
