// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Quadtrees made by their definition, and what is checked of every quadtree against them.

#ifndef QUADTREE_MESH_2_TEST_QUADTREE_CHECKS_H
#define QUADTREE_MESH_2_TEST_QUADTREE_CHECKS_H

#include "catch.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace quadtree_test {

using CGAL::Quadtree_mesh_2::all_directions;
using CGAL::Quadtree_mesh_2::Balance;
using CGAL::Quadtree_mesh_2::Direction;
using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::Node_index;
using CGAL::Quadtree_mesh_2::Point_index;
using CGAL::Quadtree_mesh_2::Point_rank;

/// A square by level and corner, in units of its side; grids have at most 62 levels here.
using Key = std::tuple<int, std::uint64_t, std::uint64_t>;

struct Key_hash {
  std::size_t operator()(const Key& k) const {
    const auto& [level, x, y] = k;
    const std::uint64_t mixed = (x * 0x9e3779b97f4a7c15 + y) * 0xc2b2ae3d27d4eb4f + std::uint64_t(level);
    return static_cast<std::size_t>(mixed ^ mixed >> 32);
  }
};

inline Key parent_of(const Key& k) { return {std::get<0>(k) - 1, std::get<1>(k) >> 1, std::get<2>(k) >> 1}; }

inline std::vector<Key> children_of(const Key& k) {
  std::vector<Key> children;
  for (std::uint64_t i = 0; i < 2; ++i)
    for (std::uint64_t j = 0; j < 2; ++j)
      children.emplace_back(std::get<0>(k) + 1, 2 * std::get<1>(k) + i, 2 * std::get<2>(k) + j);
  return children;
}

/// Whether `inner` is `outer` or lies in it.
inline bool contains(const Key& outer, const Key& inner) {
  const int levels = std::get<0>(inner) - std::get<0>(outer);
  return levels >= 0 && std::get<1>(inner) >> levels == std::get<1>(outer) &&
         std::get<2>(inner) >> levels == std::get<2>(outer);
}

/// The square of the same size next to `k`; false if it is outside the root.
inline bool step(const Key& k, Direction d, Key& neighbor) {
  const int level = std::get<0>(k);
  const std::uint64_t x = std::get<1>(k) + static_cast<std::uint64_t>(step_x(d));
  const std::uint64_t y = std::get<2>(k) + static_cast<std::uint64_t>(step_y(d));
  neighbor = {level, x, y};
  return x >> level == 0 && y >> level == 0;
}

/// The corner of a square, or a point, as a key of the given level.
template <class Corner>
Key key_of_corner(const Corner& c, int level, int depth) {
  const std::uint64_t x = static_cast<std::uint64_t>(c.x), y = static_cast<std::uint64_t>(c.y);
  if ((x | y) >> (depth - level) << (depth - level) != (x | y))
    FAIL("no corner of a square of level " << level);
  return {level, x >> (depth - level), y >> (depth - level)};
}

/// The distinct points of a framework as unit squares.
template <class Framework>
std::vector<Key> point_keys(const Framework& framework) {
  std::vector<Key> points;
  const int depth = framework.grid().depth();
  for (std::size_t i = 0; i < framework.number_of_points(); ++i)
    points.push_back(key_of_corner(framework.grid_point(Point_rank(i)), depth, depth));
  return points;
}

/// A quadtree as the set of its split squares, made by the definition.
class Naive_tree {
public:
  /// Splits squares for which `must_split(square, points)` is true, `points` being those inside, beginning
  /// with the root.
  using Must_split = std::function<bool(const Key&, const std::vector<Key>&)>;
  Naive_tree(const std::vector<Key>& points, const Must_split& must_split) {
    split({0, 0, 0}, points, must_split);
  }

  /// Splits a leaf.
  void split(const Key& k) { split_.insert(k); }

  /// Splits whatever has a neighbor less than half its size, until there is nothing to split.
  void balance(Balance balance) {
    if (balance == Balance::NONE) return;
    for (std::vector<Key> work(split_.begin(), split_.end()); !work.empty();) {
      const Key k = work.back();
      work.pop_back();
      for (const Key& child :
           children_of(k)) // in doubt as if it was a leaf; if not, its children ask for more
        for (Direction d : all_directions()) {
          Key n;
          if (balance == Balance::SIDES && is_diagonal(d)) continue;
          if (!step(child, d, n)) continue;
          const Key leaf = leaf_around(n);
          if (std::get<0>(leaf) + 1 < std::get<0>(child)) {
            split_.insert(leaf);
            work.push_back(leaf);
            work.push_back(k); // its neighbor may still be too large
          }
        }
    }
  }

  bool is_split(const Key& k) const { return split_.count(k) > 0; }
  std::size_t number_of_leaves() const { return 3 * split_.size() + 1; }

  /// The square `k`, or the leaf that contains it.
  Key leaf_around(Key k) const {
    while (std::get<0>(k) > 0 && !is_split(parent_of(k))) k = parent_of(k);
    return k;
  }

private:
  void split(const Key& k, const std::vector<Key>& points, const Must_split& must_split) {
    if (!must_split(k, points)) return;
    split_.insert(k);
    for (const Key& child : children_of(k)) {
      std::vector<Key> inside;
      std::copy_if(points.begin(), points.end(), std::back_inserter(inside),
                   [&](const Key& p) { return contains(child, p); });
      split(child, inside, must_split);
    }
  }

  std::unordered_set<Key, Key_hash> split_;
};

/// The quadtree in which no leaf has more than `max_points` points, balanced.
template <class Framework>
Naive_tree naive_tree(const Framework& framework, std::size_t max_points,
                      Balance balance = Balance::SIDES_AND_CORNERS) {
  Naive_tree tree(point_keys(framework),
                  [&](const Key&, const std::vector<Key>& points) { return points.size() > max_points; });
  tree.balance(balance);
  return tree;
}

template <class Tree, class Index>
Key key(const Tree& tree, Index v) {
  const auto s = tree.square(v);
  return key_of_corner(s, s.level, tree.framework().grid().depth());
}

template <class Tree>
std::unordered_map<Key, Node_index, Key_hash> nodes_by_square(const Tree& tree) {
  std::unordered_map<Key, Node_index, Key_hash> nodes;
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
    nodes.emplace(key(tree, Node_index(i)), Node_index(i));
  REQUIRE(nodes.size() == tree.number_of_nodes());
  return nodes;
}

/// The squares are those of the naive tree: balanced, with no more leaves than needed. Of many nodes the first one at
/// fault is told.
template <class Tree>
void check_squares(const Tree& tree, const Naive_tree& expected) {
  REQUIRE(tree.number_of_leaves() == expected.number_of_leaves());
  int depth = 0;
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i) {
    const Node_index v(i);
    depth = std::max(depth, tree.level(v));
    const Key square = key(tree, v);
    if (tree.is_leaf(v) == expected.is_split(square))
      FAIL("node " << i << " is a leaf or not as it should not be");
    if (i > 0 && tree.level(Node_index(i - 1)) > tree.level(v)) FAIL("node " << i << " is before its level");
    if (tree.is_leaf(v)) {
      if (tree.node(tree.leaf(v)) != v || tree.leaves(v).size() != 1)
        FAIL("node " << i << " is another leaf");
      continue;
    }
    std::size_t leaves = 0;
    const std::vector<Key> children = children_of(square);
    for (int q = 0; q < 4; ++q) {
      const Node_index child = tree.child(v, q);
      if (key(tree, child) != children[std::size_t(q)] || tree.parent(child) != v ||
          tree.leaves(child).begin.value() != tree.leaves(v).begin.value() + leaves)
        FAIL("child " << q << " of node " << i << " is another one");
      leaves += tree.leaves(child).size();
    }
    if (tree.leaves(v).size() != leaves) FAIL("node " << i << " has other leaves");
  }
  REQUIRE(tree.depth() == depth);
  REQUIRE_FALSE(tree.parent(tree.root()).is_valid());
  for (std::size_t i = 1; i < tree.number_of_leaves(); ++i) {
    const auto a = tree.square(Leaf_index(i - 1)), b = tree.square(Leaf_index(i));
    using Grid_point = typename Tree::Grid_point;
    if (!CGAL::Quadtree_mesh_2::internal::less_shuffle(Grid_point{a.x, a.y}, Grid_point{b.x, b.y}))
      FAIL("leaf " << i << " is not in shuffle order");
  }
}

template <class Tree>
void check_cross_pointers(const Tree& tree, const Naive_tree& expected) {
  const auto nodes = nodes_by_square(tree);
  for (const auto& entry : nodes)
    for (Direction d : all_directions()) {
      Key neighbor;
      const bool is_inside = step(entry.first, d, neighbor);
      const Node_index n = tree.neighbor(entry.second, d);
      if (n.is_valid() != is_inside) FAIL("neighbors are outside");
      if (is_inside && n != nodes.at(expected.leaf_around(neighbor))) FAIL("a neighbor is another one");
    }
}

/// A square by its least and greatest coordinates on the grid.
struct Closed_square {
  std::uint64_t x0, y0, x1, y1;
  int level;
  Closed_square(const Key& k, int depth) : level(std::get<0>(k)) {
    const int shift = depth - level;
    x0 = std::get<1>(k) << shift, x1 = (std::get<1>(k) + 1) << shift;
    y0 = std::get<2>(k) << shift, y1 = (std::get<2>(k) + 1) << shift;
  }
};

inline bool do_touch(const Closed_square& a, const Closed_square& b) {
  return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

/// Neighboring leaves against all pairs of leaves whose closed squares meet.
template <class Tree>
void check_neighbors(const Tree& tree) {
  if (tree.number_of_leaves() > 1500) return;
  const int levels_apart = tree.options().balance() == Balance::SIDES_AND_CORNERS ? 1 : 64;
  std::vector<Closed_square> leaves;
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i)
    leaves.emplace_back(key(tree, Leaf_index(i)), tree.framework().grid().depth());
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    std::vector<char> is_neighbor(leaves.size(), 0);
    for (const Leaf_index l : tree.neighbors(Leaf_index(i))) {
      if (is_neighbor[l.value()] != 0) FAIL("leaf " << i << " has a neighbor twice");
      is_neighbor[l.value()] = 1;
    }
    // Of millions of pairs the first one at fault is asserted.
    const Closed_square& leaf = leaves[i];
    const char* given = is_neighbor.data();
    std::size_t j = 0, at_fault = leaves.size();
    for (const Closed_square& other : leaves) {
      const bool is_expected = j != i && do_touch(leaf, other);
      if (is_expected != (given[j] != 0) ||
          (is_expected && std::abs(leaf.level - other.level) > levels_apart)) {
        at_fault = j;
        break;
      }
      ++j;
    }
    if (at_fault < leaves.size()) FAIL("leaves " << i << " and " << at_fault << " are neighbors or not");
  }
}

/// Every point is in its leaf, and any query in the leaf that is found.
template <class Tree, class Points>
void check_location(const Tree& tree, const Points& points) {
  const auto& framework = tree.framework();
  const int depth = framework.grid().depth();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Leaf_index l = tree.leaf(Point_index(i));
    const auto rank = framework.rank(Point_index(i));
    if (!contains(key(tree, l), key_of_corner(framework.grid_point(rank), depth, depth)) ||
        tree.locate(points[i]) != l)
      FAIL("point " << i << " is in another leaf");
    const auto inside = tree.points(l);
    if (rank < inside.begin || !(rank < inside.end)) FAIL("point " << i << " is not among those of its leaf");
  }
  std::size_t sum = 0;
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i) sum += tree.points(Leaf_index(i)).size();
  REQUIRE(sum == framework.number_of_points());
  REQUIRE(tree.points(tree.root()).size() == sum);

  std::mt19937_64 random(7);
  for (int i = 0; i < 200; ++i) {
    using Word = typename Tree::Word;
    const std::uint64_t x = random() >> (64 - depth), y = random() >> (64 - depth);
    const Leaf_index l = tree.locate(typename Tree::Grid_point{static_cast<Word>(x), static_cast<Word>(y)});
    if (!contains(key(tree, l), Key{depth, x, y})) FAIL("a place is located in another leaf");
  }
}

/// All of the above; few enough points in each leaf.
template <class Tree, class Points>
void check_quadtree(const Tree& tree, const Naive_tree& expected, const Points& points) {
  REQUIRE(tree.is_valid());
  check_squares(tree, expected);
  check_cross_pointers(tree, expected);
  if (tree.options().balance() != Balance::NONE) check_neighbors(tree);
  check_location(tree, points);
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i)
    if (tree.points(Leaf_index(i)).size() > tree.options().max_points_per_leaf())
      FAIL("leaf " << i << " has too many points");
}

/// Two quadtrees of the same points answer the same: numbers, levels, links, points and cross pointers.
template <class Tree, class Other_tree>
void check_same_quadtree(const Tree& tree, const Other_tree& other) {
  REQUIRE(tree.number_of_nodes() == other.number_of_nodes());
  REQUIRE(tree.number_of_leaves() == other.number_of_leaves());
  REQUIRE(tree.depth() == other.depth());
  std::size_t different = 0;
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i) {
    const Node_index v(i);
    bool is_same = tree.is_leaf(v) == other.is_leaf(v) && tree.level(v) == other.level(v) &&
                   tree.parent(v) == other.parent(v) && tree.points(v) == other.points(v) &&
                   tree.leaves(v).begin == other.leaves(v).begin &&
                   tree.leaves(v).end == other.leaves(v).end &&
                   (tree.is_leaf(v) || tree.child(v, 0) == other.child(v, 0));
    for (Direction d : all_directions()) is_same = is_same && tree.neighbor(v, d) == other.neighbor(v, d);
    different += is_same ? 0 : 1;
  }
  for (std::size_t l = 0; l < tree.number_of_leaves(); ++l)
    different += tree.node(Leaf_index(l)) == other.node(Leaf_index(l)) ? 0 : 1;
  for (std::size_t r = 0; r < tree.framework().number_of_points(); ++r)
    different += tree.leaf(Point_rank(r)) == other.leaf(Point_rank(r)) ? 0 : 1;
  REQUIRE(different == 0);
}

} // namespace quadtree_test

#endif // QUADTREE_MESH_2_TEST_QUADTREE_CHECKS_H
