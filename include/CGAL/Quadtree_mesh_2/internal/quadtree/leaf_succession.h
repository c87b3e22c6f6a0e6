// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Which leaves of a tree are those of before, after some were split. They are numbered anew then, but in the same
// order, so their levels tell: a leaf of the same level is the same one, and else the next leaves, until they fill its
// square, are what it was split into. O(k) for k leaves.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LEAF_SUCCESSION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LEAF_SUCCESSION_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The levels of all leaves, in their order.
template <class Tree>
std::vector<int> levels_of_leaves(const Tree& tree) {
  std::vector<int> levels(tree.number_of_leaves());
  for (std::size_t l = 0; l < levels.size(); ++l) levels[l] = tree.level(Leaf_index(l));
  return levels;
}

/// The first leaf that is not in the square of a level in which leaf `begin` is the first one.
inline std::size_t end_of_square(const std::vector<int>& levels, std::size_t begin, int level) {
  if (levels[begin] == level) return begin + 1;
  for (int child = 0; child < 4; ++child) begin = end_of_square(levels, begin, level + 1);
  return begin;
}

/// Calls `kept(old, now)` for each leaf that was not split, and `fresh(now)` for all that others were split into.
/// \param before, after the levels of the leaves of a tree before and after some were split
template <class Kept, class Fresh>
void for_each_successor(const std::vector<int>& before, const std::vector<int>& after, const Kept& kept,
                        const Fresh& fresh) {
  std::size_t next = 0;
  for (std::size_t old = 0; old < before.size(); ++old)
    if (after[next] == before[old])
      kept(Leaf_index(old), Leaf_index(next++));
    else
      for (const std::size_t end = end_of_square(after, next, before[old]); next < end; ++next)
        fresh(Leaf_index(next));
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LEAF_SUCCESSION_H
