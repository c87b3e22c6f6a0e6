// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "quadtree_inputs.h"

#include <CGAL/Balanced_quadtree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <vector>

using namespace quadtree_test;
using CGAL::Quadtree_mesh_2::all_directions;
using CGAL::Quadtree_mesh_2::Direction;
using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::Node_index;
using CGAL::Quadtree_mesh_2::Point_index;
using CGAL::Quadtree_mesh_2::Point_rank;

namespace {

/// A square by level and corner, in units of its side.
using Key = std::tuple<int, std::uint64_t, std::uint64_t>;

Key parent_of(const Key& k) { return {std::get<0>(k) - 1, std::get<1>(k) >> 1, std::get<2>(k) >> 1}; }

std::vector<Key> children_of(const Key& k) {
  std::vector<Key> children;
  for (std::uint64_t i = 0; i < 2; ++i)
    for (std::uint64_t j = 0; j < 2; ++j)
      children.emplace_back(std::get<0>(k) + 1, 2 * std::get<1>(k) + i, 2 * std::get<2>(k) + j);
  return children;
}

/// The square of the same size next to `k`; false if it is outside the root.
bool step(const Key& k, Direction d, Key& neighbor) {
  const int level = std::get<0>(k);
  const std::uint64_t x = std::get<1>(k) + static_cast<std::uint64_t>(step_x(d));
  const std::uint64_t y = std::get<2>(k) + static_cast<std::uint64_t>(step_y(d));
  neighbor = {level, x, y};
  return x >> level == 0 && y >> level == 0;
}

/// A quadtree as the set of its split squares, made by the definition.
class Naive_tree {
public:
  /// Splits what has more than `max_points` of the distinct grid points, then whatever has a neighbour less
  /// than half its size, until there is nothing to split.
  template <class Framework>
  Naive_tree(const Framework& framework, std::size_t max_points) {
    std::vector<Key> points;
    for (std::size_t i = 0; i < framework.number_of_points(); ++i) {
      const auto p = framework.grid_point(Point_rank(i));
      points.emplace_back(Framework::Traits::depth, p.x, p.y);
    }
    split_crowded({0, 0, 0}, points, max_points);
    for (std::vector<Key> work(split_.begin(), split_.end()); !work.empty();) {
      const Key k = work.back();
      work.pop_back();
      for (const Key& child :
           children_of(k)) // in doubt as if it was a leaf; if not, its children ask for more
        for (Direction d : all_directions()) {
          Key n;
          if (!step(child, d, n)) continue;
          const Key leaf = leaf_around(n);
          if (std::get<0>(leaf) + 1 < std::get<0>(child)) {
            split_.insert(leaf);
            work.push_back(leaf);
            work.push_back(k); // its neighbour may still be too large
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
  void split_crowded(const Key& k, const std::vector<Key>& points, std::size_t max_points) {
    if (points.size() <= max_points) return;
    split_.insert(k);
    for (const Key& child : children_of(k)) {
      std::vector<Key> inside;
      for (const Key& p : points) {
        const int shift = std::get<0>(p) - std::get<0>(child);
        if (std::get<1>(p) >> shift == std::get<1>(child) && std::get<2>(p) >> shift == std::get<2>(child))
          inside.push_back(p);
      }
      split_crowded(child, inside, max_points);
    }
  }

  std::set<Key> split_;
};

template <class Traits>
Key key(const CGAL::Balanced_quadtree<Traits>& tree, Node_index v) {
  const auto s = tree.square(v);
  const int shift = Traits::depth - s.level;
  REQUIRE(s.x >> shift << shift == s.x);
  REQUIRE(s.y >> shift << shift == s.y);
  return {s.level, s.x >> shift, s.y >> shift};
}

template <class Traits>
std::map<Key, Node_index> nodes_by_square(const CGAL::Balanced_quadtree<Traits>& tree) {
  std::map<Key, Node_index> nodes;
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
    REQUIRE(nodes.emplace(key(tree, Node_index(i)), Node_index(i)).second);
  return nodes;
}

/// The squares are those of the naive tree: balanced, with no more leaves than needed.
template <class Traits>
void check_squares(const CGAL::Balanced_quadtree<Traits>& tree, const Naive_tree& expected) {
  REQUIRE(tree.number_of_leaves() == expected.number_of_leaves());
  int depth = 0;
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i) {
    const Node_index v(i);
    depth = std::max(depth, tree.level(v));
    REQUIRE(tree.is_leaf(v) != expected.is_split(key(tree, v)));
    if (i > 0) REQUIRE(tree.level(Node_index(i - 1)) <= tree.level(v));
    if (tree.is_leaf(v)) {
      REQUIRE(tree.node(tree.leaf(v)) == v);
      REQUIRE(tree.leaves(v).size() == 1);
      continue;
    }
    std::size_t leaves = 0;
    for (int q = 0; q < 4; ++q) {
      const Node_index child = tree.child(v, q);
      REQUIRE(key(tree, child) == children_of(key(tree, v))[std::size_t(q)]);
      REQUIRE(tree.parent(child) == v);
      REQUIRE(tree.leaves(child).begin.value() == tree.leaves(v).begin.value() + leaves);
      leaves += tree.leaves(child).size();
    }
    REQUIRE(tree.leaves(v).size() == leaves);
  }
  REQUIRE(tree.depth() == depth);
  REQUIRE_FALSE(tree.parent(tree.root()).is_valid());
  for (std::size_t i = 1; i < tree.number_of_leaves(); ++i) {
    const auto a = tree.square(Leaf_index(i - 1)), b = tree.square(Leaf_index(i));
    using Grid_point = typename Traits::Grid_point;
    REQUIRE(CGAL::Quadtree_mesh_2::internal::less_shuffle(Grid_point{a.x, a.y}, Grid_point{b.x, b.y}));
  }
}

template <class Traits>
void check_cross_pointers(const CGAL::Balanced_quadtree<Traits>& tree, const Naive_tree& expected) {
  const auto nodes = nodes_by_square(tree);
  for (const auto& entry : nodes)
    for (Direction d : all_directions()) {
      Key neighbor;
      const bool is_inside = step(entry.first, d, neighbor);
      const Node_index n = tree.neighbor(entry.second, d);
      REQUIRE(n.is_valid() == is_inside);
      if (is_inside) REQUIRE(n == nodes.at(expected.leaf_around(neighbor)));
    }
}

/// Neighbouring leaves against all pairs of leaves whose closed squares meet.
template <class Traits>
void check_neighbors(const CGAL::Balanced_quadtree<Traits>& tree) {
  if (tree.number_of_leaves() > 1500) return;
  const auto touch = [](const auto& a, const auto& b) {
    const auto side_a = decltype(a.x)(1) << (Traits::depth - a.level);
    const auto side_b = decltype(b.x)(1) << (Traits::depth - b.level);
    return a.x <= b.x + side_b && b.x <= a.x + side_a && a.y <= b.y + side_b && b.y <= a.y + side_a;
  };
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i) {
    const Leaf_index l(i);
    const auto range = tree.neighbors(l);
    const std::set<Leaf_index> neighbors(range.begin(), range.end());
    REQUIRE(neighbors.size() == range.size());
    const auto square = tree.square(l);
    for (std::size_t j = 0; j < tree.number_of_leaves(); ++j) {
      const auto other = tree.square(Leaf_index(j));
      const bool is_neighbor = i != j && touch(square, other);
      REQUIRE(is_neighbor == (neighbors.count(Leaf_index(j)) == 1));
      if (is_neighbor) REQUIRE(std::abs(square.level - other.level) <= 1);
    }
  }
}

template <class Traits>
bool contains(const CGAL::Balanced_quadtree<Traits>& tree, Leaf_index l,
              const typename Traits::Grid_point& p) {
  const auto s = tree.square(l);
  const auto side = typename Traits::Word(1) << (Traits::depth - s.level);
  return s.x <= p.x && p.x - s.x < side && s.y <= p.y && p.y - s.y < side;
}

template <class Traits>
void check_location(const CGAL::Balanced_quadtree<Traits>& tree,
                    const std::vector<typename Traits::Point_2>& points, std::size_t max_points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Leaf_index l = tree.leaf(Point_index(i));
    const auto rank = tree.framework().rank(Point_index(i));
    REQUIRE(contains(tree, l, tree.framework().grid_point(rank)));
    REQUIRE(tree.locate(points[i]) == l);
    const auto inside = tree.points(l);
    REQUIRE(!(rank < inside.begin));
    REQUIRE(rank < inside.end);
  }
  std::size_t sum = 0;
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i) {
    REQUIRE(tree.points(Leaf_index(i)).size() <= max_points);
    sum += tree.points(Leaf_index(i)).size();
  }
  REQUIRE(sum == tree.framework().number_of_points());
  REQUIRE(tree.points(tree.root()).size() == sum);

  std::mt19937_64 random(7);
  for (int i = 0; i < 200; ++i) {
    using Word = typename Traits::Word;
    const typename Traits::Grid_point p{static_cast<Word>(random() >> (64 - Traits::depth)),
                                        static_cast<Word>(random() >> (64 - Traits::depth))};
    REQUIRE(contains(tree, tree.locate(p), p));
  }
}

} // namespace

TEMPLATE_TEST_CASE("The balanced quadtree is the smallest one", "[balanced]", Filtered_traits,
                   Fixed_32_traits, Fixed_64_traits) {
  for (const Input& input : all_inputs())
    for (std::size_t max_points : {1u, 3u}) {
      CAPTURE(input.name, max_points);
      const auto points = make_points<TestType>(input);
      const CGAL::Balanced_quadtree<TestType> tree(points, CGAL::Quadtree_options().max_points_per_leaf(max_points));
      const Naive_tree expected(tree.framework(), max_points);
      REQUIRE(tree.is_valid());
      check_squares(tree, expected);
      check_cross_pointers(tree, expected);
      check_neighbors(tree);
      check_location(tree, points, max_points);
    }
}

TEMPLATE_TEST_CASE("Small random quadtrees are the smallest ones", "[balanced]", Filtered_traits,
                   Fixed_32_traits, Fixed_64_traits) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937_64 random(seed);
    Input input{"small", {}};
    for (unsigned i = 0; i < 2 + seed % 9; ++i) {
      const int shift = static_cast<int>(2 + random() % 40);
      input.points.push_back({random() >> shift, random() >> shift});
    }
    CAPTURE(seed);
    const auto points = make_points<TestType>(input);
    const CGAL::Balanced_quadtree<TestType> tree(points);
    const Naive_tree expected(tree.framework(), 1);
    check_squares(tree, expected);
    check_cross_pointers(tree, expected);
    check_neighbors(tree);
    check_location(tree, points, 1);
  }
}

TEST_CASE("The quadtree of nothing is a leaf", "[balanced]") {
  const CGAL::Balanced_quadtree<Filtered_traits> tree;
  CHECK(tree.number_of_nodes() == 1);
  CHECK(tree.number_of_leaves() == 1);
  CHECK(tree.depth() == 0);
  CHECK(tree.is_leaf(tree.root()));
  CHECK(tree.neighbors(Leaf_index(0)).size() == 0);
  CHECK_FALSE(tree.neighbor(tree.root(), Direction::EAST).is_valid());
  CHECK(tree.locate(Filtered_traits::Point_2(0, 0)) == Leaf_index(0));
}

TEST_CASE("Points outside the root are in no leaf", "[balanced]") {
  const std::vector<Filtered_traits::Point_2> points{{0, 0}, {1, 1}, {0.25, 0.5}};
  const CGAL::Balanced_quadtree<Filtered_traits> tree(points);
  CHECK_FALSE(tree.locate(Filtered_traits::Point_2(100, 0)).is_valid());
  CHECK_FALSE(tree.locate(Filtered_traits::Point_2(0, -1e300)).is_valid());
  const auto corners = tree.corners(tree.root());
  CHECK(tree.locate(corners[0]).is_valid());
  CHECK_FALSE(tree.locate(corners[2]).is_valid());
}

TEST_CASE("Corners of squares are exact", "[balanced]") {
  const auto points = make_points<Filtered_traits>(clusters(8));
  const CGAL::Balanced_quadtree<Filtered_traits> tree(points);
  const auto root = tree.corners(tree.root());
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i) {
    const Node_index v(i);
    const auto c = tree.corners(v);
    const double side = std::ldexp(root[1].x() - root[0].x(), -tree.level(v));
    CHECK((c[1].x() - c[0].x() == side && c[2].y() - c[1].y() == side));
    CHECK((c[0].x() == c[3].x() && c[0].y() == c[1].y() && c[2].x() == c[1].x() && c[2].y() == c[3].y()));
    CHECK(std::remainder(c[0].x() - root[0].x(), side) == 0);
  }
}

TEST_CASE("Neighbours of a leaf come counterclockwise", "[balanced]") {
  const auto points = make_points<Fixed_32_traits>(uniform(60, 9));
  const CGAL::Balanced_quadtree<Fixed_32_traits> tree(points);
  const auto center = [&](Leaf_index l) {
    const auto s = tree.square(l);
    const double half = std::ldexp(0.5, Fixed_32_traits::depth - s.level);
    return std::array<double, 2>{s.x + half, s.y + half};
  };
  const auto is_inner = [&](Leaf_index l) {
    const auto directions = all_directions();
    return std::all_of(directions.begin(), directions.end(),
                       [&](Direction d) { return tree.neighbor(tree.node(l), d).is_valid(); });
  };
  std::size_t inner = 0;
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i) {
    if (!is_inner(Leaf_index(i))) continue;
    ++inner;
    const auto c = center(Leaf_index(i));
    const auto around = tree.neighbors(Leaf_index(i));
    double turn = 0;
    for (std::size_t k = 0; k < around.size(); ++k) {
      const auto a = center(around[k]), b = center(around[(k + 1) % around.size()]);
      const double ax = a[0] - c[0], ay = a[1] - c[1], bx = b[0] - c[0], by = b[1] - c[1];
      const double angle = std::atan2(ax * by - ay * bx, ax * bx + ay * by);
      CHECK(angle > 0);
      turn += angle;
    }
    CHECK(turn == Approx(6.283185307179586));
  }
  CHECK(inner > 100);
}

TEST_CASE("A large quadtree satisfies the cheap invariants", "[balanced]") {
  const auto points = make_points<Filtered_traits>(uniform(20000, 10));
  const CGAL::Balanced_quadtree<Filtered_traits> tree(points, CGAL::Quadtree_options().max_points_per_leaf(2));
  std::size_t in_leaves = 0;
  for (std::size_t i = 0; i < tree.number_of_leaves(); ++i) {
    const Leaf_index l(i);
    in_leaves += tree.points(l).size();
    REQUIRE(tree.points(l).size() <= 2);
    for (Leaf_index n : tree.neighbors(l)) REQUIRE(std::abs(tree.level(l) - tree.level(n)) <= 1);
  }
  CHECK(in_leaves == 20000);
  CHECK(tree.is_valid());
}
