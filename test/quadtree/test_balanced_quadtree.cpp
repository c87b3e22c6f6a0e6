// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "quadtree_checks.h"
#include "quadtree_test_inputs.h"

#include <CGAL/Balanced_quadtree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace test_balanced_quadtree {

using namespace quadtree_test;

TEMPLATE_TEST_CASE("The balanced quadtree is the smallest one", "[balanced]", Filtered_traits,
                   Fixed_32_traits, Fixed_64_traits, Exact_traits) {
  for (const Input& input : all_inputs())
    for (std::size_t max_points : {1u, 3u}) {
      CAPTURE(input.name, max_points);
      const auto points = make_points<TestType>(input);
      const CGAL::Balanced_quadtree<TestType> tree(points,
                                                   CGAL::Quadtree_options().max_points_per_leaf(max_points));
      check_quadtree(tree, naive_tree(tree.framework(), max_points), points);
    }
}

TEMPLATE_TEST_CASE("Small random quadtrees are the smallest ones", "[balanced]", Filtered_traits,
                   Fixed_32_traits, Fixed_64_traits, Exact_traits) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const auto points = make_points<TestType>(small_random(seed));
    const CGAL::Balanced_quadtree<TestType> tree(points);
    check_quadtree(tree, naive_tree(tree.framework(), 1), points);
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

TEST_CASE("Neighbors of a leaf come counterclockwise", "[balanced]") {
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
    CHECK(turn == Approx(2 * CGAL_PI));
  }
  CHECK(inner > 100);
}

TEST_CASE("The split squares of a balanced quadtree require that quadtree", "[balanced]") {
  using Tree = CGAL::Balanced_quadtree<Fixed_32_traits>;
  using CGAL::Quadtree_mesh_2::Node_index;
  const Tree tree(make_points<Fixed_32_traits>(uniform(60, 9)));
  CGAL::Quadtree_mesh_2::internal::Required_squares required;
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i) { // level by level
    const Node_index v(i);
    if (tree.is_leaf(v)) continue;
    unsigned split = 0;
    for (int q = 0; q < 4; ++q)
      if (!tree.is_leaf(tree.child(v, q))) split |= 1u << q;
    if (static_cast<int>(required.level_begin.size()) < tree.level(v) + 2) required.level_begin.push_back(0);
    required.children.push_back(static_cast<std::uint8_t>(split));
    required.level_begin.back() = static_cast<std::uint32_t>(required.size());
  }
  required.link_children<CGAL::Sequential_tag>();
  const Tree same(Tree::Framework(), {}, required);
  CHECK(same.is_valid());
  REQUIRE(same.number_of_nodes() == tree.number_of_nodes());
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
    CHECK(same.is_leaf(Node_index(i)) == tree.is_leaf(Node_index(i)));
}

TEST_CASE("A large quadtree satisfies the cheap invariants", "[balanced]") {
  const auto points = make_points<Filtered_traits>(uniform(20000, 10));
  const CGAL::Balanced_quadtree<Filtered_traits> tree(points,
                                                      CGAL::Quadtree_options().max_points_per_leaf(2));
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

} // namespace test_balanced_quadtree
