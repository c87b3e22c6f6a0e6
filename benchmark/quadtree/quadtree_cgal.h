// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_QUADTREE_CGAL_H
#define QUADTREE_MESH_2_BENCHMARK_QUADTREE_CGAL_H

#include "quadtree_run.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Orthtree/Traversals.h>
#include <CGAL/Quadtree.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadtree_cgal {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Quadtree = CGAL::Quadtree<Kernel, Points>;

/// Its nodes count levels in a byte, so trees that would have to be deeper have to be stopped here.
constexpr std::size_t max_depth = 255;

inline void look_at_leaves(const Quadtree& tree, Run_recorder& recorder) {
  std::size_t leaves = 0, crowded = 0;
  int depth = 0;
  for (const auto& leaf : tree.traverse(CGAL::Orthtrees::Leaves_traversal())) {
    ++leaves;
    crowded += leaf.size() > 1 ? 1 : 0;
    depth = std::max(depth, int(leaf.depth()));
  }
  recorder.set_depth(depth);
  recorder.set_crowded_leaves(crowded);
  recorder.set_size(leaves);
}

inline Run run(const Points& input) {
  Points points = input; // it asks for a range that it may reorder
  Run_recorder recorder;
  Quadtree tree(points);
  recorder.stop();
  recorder.start();
  tree.refine(max_depth, 1);
  recorder.stop();
  look_at_leaves(tree, recorder);
  recorder.start();
  tree.grade();
  recorder.stop();
  look_at_leaves(tree, recorder);
  return recorder.run();
}

inline std::vector<Method> methods() {
  return {{"CGAL::Quadtree",
           {{"construct", Product::NOTHING}, {"refine", Product::UNBALANCED}, {"grade", Product::SIDES}},
           run}};
}

} // namespace quadtree_cgal

#endif // QUADTREE_MESH_2_BENCHMARK_QUADTREE_CGAL_H
