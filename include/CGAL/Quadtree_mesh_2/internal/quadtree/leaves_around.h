// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The leaves of a quadtree up to some sides away from a leaf.
//
// Computes: the leaves that meet a square around a leaf.
// Bound:    O(1 + what is found) squares are looked at if the tree is balanced, for a fixed number of sides.
// Method:   Go up to a square as large as the way; all is in this square and its eight neighbors.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LEAVES_AROUND_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LEAVES_AROUND_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Leaf_segments.h>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Calls `f(leaf)` for leaf l and the leaves that are, along each axis, less than `sides` of its sides away. A
/// leaf larger than l may come several times.
/// \pre the tree is balanced, and `sides` is at least 1
template <class Tree, class F>
void for_each_leaf_around(const Tree& tree, Leaf_index l, int sides, const F& f) {
  using Word = typename Tree::Word;
  using Coordinate = typename Signed_grid<Word>::Product; // some sides of the root are no coordinates
  const auto side_of = [&tree](int level) {
    return Coordinate(Word_operations<Word>::power_of_two(tree.framework().grid().depth() - level));
  };
  const auto middle = tree.square(l);
  const Coordinate way = Coordinate(sides) * side_of(middle.level), far = way + side_of(middle.level);
  const auto is_around = [&](Node_index v) {
    const auto s = tree.square(v);
    const Coordinate x = Coordinate(s.x) - Coordinate(middle.x), y = Coordinate(s.y) - Coordinate(middle.y);
    const Coordinate side = side_of(s.level);
    return x < far && y < far && x + side > -way && y + side > -way;
  };
  const auto visit = [&](Node_index v) {
    if (!is_around(v)) return false;
    if (tree.is_leaf(v)) f(tree.leaf(v));
    return true;
  };
  Node_index top = tree.node(l);
  for (int reach = 1; reach < sides && tree.parent(top).is_valid(); reach *= 2) top = tree.parent(top);
  tree.traverse(visit, top);
  for (const Direction d : all_directions()) {
    const Node_index next = tree.neighbor(top, d);
    if (next.is_valid()) tree.traverse(visit, next);
  }
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LEAVES_AROUND_H
