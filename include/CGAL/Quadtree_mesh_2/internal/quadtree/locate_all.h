// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The leaves that contain many points, which need not be those of the quadtree.
//
// Computes: for each point the leaf that contains it, by descents from the root, in parallel.
// Bound:    O(depth) for each point; one round.
// Deviates: the paper locates the quadtree's own points only. In our trees these ride down with their
//           squares. The paper's way is in locate_by_framework.h.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LOCATE_ALL_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LOCATE_ALL_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Returns for each of `queries` the leaf that contains it, invalid if it is outside the root.
/// \tparam PointRange a random access range with value type `Point_2`; several threads may read it.
template <class ConcurrencyTag, class Quadtree, class PointRange>
std::vector<Leaf_index> locate_all(const Quadtree& tree, const PointRange& queries) {
  const auto first = std::begin(queries);
  using Difference = typename std::iterator_traits<decltype(std::begin(queries))>::difference_type;
  std::vector<Leaf_index> result(static_cast<std::size_t>(std::distance(first, std::end(queries))));
  for_each_index<ConcurrencyTag>(
      result.size(), [&](std::size_t i) { result[i] = tree.locate(first[static_cast<Difference>(i)]); },
      default_block / 8);
  return result;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LOCATE_ALL_H
