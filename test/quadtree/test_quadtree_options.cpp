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
#include <cmath>
#include <random>
#include <vector>

namespace test_quadtree_options {

using namespace quadtree_test;
using CGAL::Quadtree_options;
using CGAL::Quadtree_mesh_2::Balance_schedule;

namespace {

/// Annotates about every third point with a level a few levels below its leaf's, or above.
template <class Framework>
std::vector<int> random_annotations(const Framework& framework, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<int> levels(framework.number_of_points(), 0);
  for (std::size_t r = 0; r < levels.size(); ++r) {
    const Node_index v = framework.node(Point_rank(r));
    const int level = v.is_valid() ? framework.level(v) : 0;
    if (random() % 3 == 0)
      levels[r] = std::min(framework.grid().depth(), level + static_cast<int>(random() % 7) - 2);
    levels[r] = std::max(levels[r], 0);
  }
  return levels;
}

/// The tree of points with annotations, by the definition.
template <class Framework>
Naive_tree naive_annotated_tree(const Framework& framework, std::size_t max_points, Balance balance) {
  const std::vector<Key> points = point_keys(framework);
  Naive_tree tree(points, [&](const Key& square, const std::vector<Key>& inside) {
    return inside.size() > max_points || std::any_of(inside.begin(), inside.end(), [&](const Key& p) {
             const std::size_t r =
                 static_cast<std::size_t>(std::find(points.begin(), points.end(), p) - points.begin());
             return framework.desired_level(Point_rank(r)) > std::get<0>(square);
           });
  });
  tree.balance(balance);
  return tree;
}

} // namespace

TEMPLATE_TEST_CASE("Quadtrees are balanced across sides only, or not at all", "[options]", Filtered_traits,
                   Fixed_32_traits, Exact_traits) {
  for (Balance balance : {Balance::NONE, Balance::SIDES})
    for (const Input& input : all_inputs()) {
      CAPTURE(input.name, int(balance));
      const auto points = make_points<TestType>(input);
      const CGAL::Balanced_quadtree<TestType> tree(points, Quadtree_options().balance(balance));
      check_quadtree(tree, naive_tree(tree.framework(), 1, balance), points);
    }
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const auto points = make_points<TestType>(small_random(seed));
    const CGAL::Balanced_quadtree<TestType> tree(points, Quadtree_options().balance(Balance::SIDES));
    check_quadtree(tree, naive_tree(tree.framework(), 1, Balance::SIDES), points);
  }
}

TEMPLATE_TEST_CASE("Spaced levels give the smallest quadtree for every balance", "[options]", Filtered_traits,
                   Fixed_32_traits, Fixed_64_traits, Exact_traits) {
  std::vector<Input> inputs = all_inputs();
  for (unsigned seed = 0; seed < 20; ++seed) inputs.push_back(small_random(seed));
  for (const Input& input : in_turn<TestType>(inputs))
    for (Balance balance : {Balance::NONE, Balance::SIDES, Balance::SIDES_AND_CORNERS})
      for (std::size_t max_points : {1u, 3u}) {
        CAPTURE(input.name, int(balance), max_points);
        const auto points = make_points<TestType>(input);
        const CGAL::Balanced_quadtree<TestType> tree(points, Quadtree_options()
                                                                 .max_points_per_leaf(max_points)
                                                                 .balance(balance)
                                                                 .schedule(Balance_schedule::SPACED_LEVELS));
        check_quadtree(tree, naive_tree(tree.framework(), max_points, balance), points);
      }
}

TEMPLATE_TEST_CASE("Leaves are as small as their points' annotations ask", "[options]", Filtered_traits,
                   Fixed_64_traits, Exact_traits) {
  std::vector<Input> inputs = all_inputs();
  for (unsigned seed = 0; seed < 20; ++seed) inputs.push_back(small_random(seed));
  unsigned seed = 0;
  for (const Input& input : in_turn<TestType>(inputs))
    for (std::size_t max_points : {1u, 4u}) {
      CAPTURE(input.name, max_points);
      const auto points = make_points<TestType>(input);
      CGAL::Quadtree_framework<TestType> framework(points);
      CHECK_FALSE(framework.has_annotations());
      framework.annotate(random_annotations(framework, ++seed));
      const auto options = Quadtree_options().max_points_per_leaf(max_points);
      const CGAL::Balanced_quadtree<TestType> tree(framework, options);
      check_quadtree(tree, naive_annotated_tree(framework, max_points, Balance::SIDES_AND_CORNERS), points);
      for (std::size_t r = 0; r < framework.number_of_points(); ++r)
        CHECK(tree.level(tree.leaf(Point_rank(r))) >= framework.desired_level(Point_rank(r)));
      // The spaced schedule follows annotations, too.
      const CGAL::Balanced_quadtree<TestType> spaced(
          framework, Quadtree_options(options).schedule(Balance_schedule::SPACED_LEVELS));
      check_same_quadtree(spaced, tree);
    }
}

TEMPLATE_TEST_CASE("Leaves are as small as a size function asks", "[options]", Filtered_traits,
                   Exact_traits) {
  const auto points = make_points<TestType>(uniform(40, 11));
  const CGAL::Quadtree_framework<TestType> framework(points);
  using Point = typename TestType::Point_2;
  // Small squares near a circle around the first point.
  const double cx = CGAL::to_double(points[0].x()), cy = CGAL::to_double(points[0].y());
  const double extent = std::ldexp(1.0, CGAL::to_double(points[0].x()) > 1e12 ? 57 : 28);
  const auto is_too_large = [&](double x, double y, double side) {
    return std::fabs(std::hypot(x + side / 2 - cx, y + side / 2 - cy) - extent / 3) < side &&
           side > extent / 100;
  };
  const auto must_split = [&](const Point& low, const Point& high) {
    return is_too_large(CGAL::to_double(low.x()), CGAL::to_double(low.y()),
                        CGAL::to_double(high.x() - low.x()));
  };
  for (Balance balance : {Balance::NONE, Balance::SIDES, Balance::SIDES_AND_CORNERS}) {
    CAPTURE(int(balance));
    const auto options = Quadtree_options().balance(balance).max_points_per_leaf(2);
    const CGAL::Balanced_quadtree<TestType> tree(points, options, must_split);
    const auto corners = tree.corners(tree.root());
    Naive_tree expected(point_keys(framework), [&](const Key& k, const std::vector<Key>& inside) {
      const double side = std::ldexp(CGAL::to_double(corners[1].x() - corners[0].x()), -std::get<0>(k));
      return inside.size() > 2 ||
             is_too_large(CGAL::to_double(corners[0].x()) + double(std::get<1>(k)) * side,
                          CGAL::to_double(corners[0].y()) + double(std::get<2>(k)) * side, side);
    });
    expected.balance(balance);
    CHECK(tree.number_of_leaves() > 300);
    check_quadtree(tree, expected, points);
  }
}

TEST_CASE("A size function alone makes a quadtree", "[options]") {
  using Quadtree = CGAL::Balanced_quadtree<Filtered_traits>;
  const std::vector<Filtered_traits::Point_2> none;
  const auto never = [](const auto&, const auto&) { return false; };
  CHECK(Quadtree(none, Quadtree_options(), never).number_of_leaves() == 1);
  const auto above = [](const auto& low, const auto& high) { return high.x() - low.x() > 0.1; };
  const Quadtree tree(none, Quadtree_options(), above);
  CHECK(tree.number_of_leaves() == 256); // the root of no points has side 1
  CHECK(tree.is_valid());
}

TEMPLATE_TEST_CASE("Refined quadtrees are the smallest ones with the leaves split", "[options]",
                   Filtered_traits, Fixed_32_traits, Exact_traits) {
  for (Balance balance : {Balance::NONE, Balance::SIDES, Balance::SIDES_AND_CORNERS})
    for (const Input& input : in_turn<TestType>(all_inputs())) {
      CAPTURE(input.name, int(balance));
      const auto points = make_points<TestType>(input);
      CGAL::Balanced_quadtree<TestType> tree(points, Quadtree_options().balance(balance));
      Naive_tree expected = naive_tree(tree.framework(), 1, balance);
      std::mt19937_64 random(5);
      for (int round = 0; round < 3; ++round) {
        std::vector<Leaf_index> leaves;
        for (int i = 0; i < 4; ++i) {
          const Leaf_index l(random() % tree.number_of_leaves());
          if (tree.level(l) == tree.framework().grid().depth()) continue;
          leaves.push_back(l);
          leaves.push_back(l);
          expected.split(key(tree, l));
        }
        expected.balance(balance);
        tree.refine(leaves);
        check_quadtree(tree, expected, points);
      }
      const std::size_t before = tree.number_of_leaves();
      tree.refine(std::vector<Leaf_index>());
      CHECK(tree.number_of_leaves() == before);
    }
}

TEST_CASE("Traversal is in preorder and stops where it is told to", "[options]") {
  const auto points = make_points<Fixed_64_traits>(uniform(100, 12));
  const CGAL::Balanced_quadtree<Fixed_64_traits> tree(points);
  std::vector<Node_index> visited;
  tree.traverse([&](Node_index v) {
    visited.push_back(v);
    return true;
  });
  REQUIRE(visited.size() == tree.number_of_nodes());
  std::size_t next_leaf = 0;
  for (Node_index v : visited)
    if (tree.is_leaf(v)) CHECK(tree.leaf(v) == Leaf_index(next_leaf++));
  visited.clear();
  tree.traverse(
      [&](Node_index v) {
        visited.push_back(v);
        return tree.level(v) < 2;
      },
      tree.child(tree.root(), 3));
  CHECK(visited.size() == 5);
}

} // namespace test_quadtree_options
