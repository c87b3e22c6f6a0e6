// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "quadtree_checks.h"
#include "quadtree_test_inputs.h"

#include <CGAL/Quadtree_framework.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace test_quadtree_framework {

using namespace quadtree_test;

namespace {

/// The smallest square that contains both points, found by going up from the unit squares.
Key smallest_common_square(Key p, Key q) {
  while (p != q) {
    p = parent_of(p);
    q = parent_of(q);
  }
  return p;
}

template <class Framework>
Key key(const Framework& framework, Node_index v) {
  const auto s = framework.square(v);
  return key_of_corner(s, s.level, framework.grid().depth());
}

template <class Framework>
Key key(const Framework& framework, Point_rank r) {
  const int depth = framework.grid().depth();
  return key_of_corner(framework.grid_point(r), depth, depth);
}

/// All squares with two nonempty children: a pair of points in two of them has no smaller common square.
template <class Traits>
std::set<Key> derived_squares(const CGAL::Quadtree_framework<Traits>& framework) {
  std::set<Key> squares;
  for (std::size_t i = 0; i < framework.number_of_points(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      squares.insert(smallest_common_square(key(framework, Point_rank(i)), key(framework, Point_rank(j))));
  return squares;
}

template <class Traits>
void check_points(const CGAL::Quadtree_framework<Traits>& framework,
                  const std::vector<typename Traits::Point_2>& points) {
  REQUIRE(framework.number_of_input_points() == points.size());
  REQUIRE(framework.number_of_points() + framework.duplicates().size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point_rank r = framework.rank(Point_index(i));
    CHECK(framework.grid_point(r) == framework.grid().grid_point(points[i]));
    const Point_index kept = framework.input_point(r);
    CHECK(!(Point_index(i) < kept));
    CHECK(points[std::size_t(kept)] == points[i]);
  }
  for (const auto& d : framework.duplicates()) {
    CHECK(d.kept < d.duplicate);
    CHECK(framework.input_point(framework.rank(d.duplicate)) == d.kept);
  }
}

/// Lemma 1: the points in a square are those of its interval.
template <class Traits>
void check_intervals(const CGAL::Quadtree_framework<Traits>& framework) {
  for (std::size_t v = 0; v < framework.number_of_nodes(); ++v) {
    const auto interval = framework.points(Node_index(v));
    for (std::size_t r = 0; r < framework.number_of_points(); ++r)
      REQUIRE(contains(key(framework, Node_index(v)), key(framework, Point_rank(r))) ==
              (interval.begin.value() <= r && r < interval.end.value()));
  }
}

/// Parents are the smallest squares around, subtrees are intervals of nodes and children partition.
template <class Traits>
void check_nesting(const CGAL::Quadtree_framework<Traits>& framework) {
  const std::size_t m = framework.number_of_nodes();
  for (std::size_t i = 0; i < m; ++i) {
    const Node_index v(i);
    Node_index smallest;
    for (std::size_t j = 0; j < m; ++j) {
      const bool is_inside = contains(key(framework, v), key(framework, Node_index(j)));
      REQUIRE(is_inside == (i <= j && j < framework.subtree_end(v).value()));
      if (i != j && contains(key(framework, Node_index(j)), key(framework, v)) &&
          (!smallest.is_valid() || framework.level(smallest) < framework.level(Node_index(j))))
        smallest = Node_index(j);
    }
    REQUIRE(framework.parent(v) == smallest);
    REQUIRE(framework.level_of_parent(v) == (smallest.is_valid() ? framework.level(smallest) : -1));

    std::size_t children = 0;
    Point_rank next = framework.points(v).begin;
    framework.for_each_child(
        v,
        [&](Node_index child) {
          CHECK(framework.parent(child) == v);
          CHECK(framework.points(child).begin == next);
          next = framework.points(child).end;
          ++children;
        },
        [&](Point_rank r) {
          CHECK(framework.node(r) == v);
          CHECK(r == next);
          ++next;
          ++children;
        });
    CHECK(next == framework.points(v).end);
    CHECK((2 <= children && children <= 4));
  }
}

} // namespace

TEMPLATE_TEST_CASE("The framework is that of Theorem 1", "[framework]", Filtered_traits, Fixed_32_traits,
                   Fixed_64_traits, Exact_traits) {
  for (const Input& input : all_inputs()) {
    CAPTURE(input.name);
    const auto points = make_points<TestType>(input);
    const CGAL::Quadtree_framework<TestType> framework(points);
    check_points(framework, points);
    const std::set<Key> expected = derived_squares(framework);
    REQUIRE(framework.number_of_nodes() == expected.size());
    REQUIRE(framework.root().is_valid() == (framework.number_of_points() >= 2));
    for (std::size_t v = 0; v < framework.number_of_nodes(); ++v)
      REQUIRE(expected.count(key(framework, Node_index(v))) == 1);
    check_intervals(framework);
    check_nesting(framework);
  }
}

TEST_CASE("The framework of nothing is empty", "[framework]") {
  const CGAL::Quadtree_framework<Filtered_traits> framework;
  CHECK(framework.number_of_points() == 0);
  CHECK(framework.number_of_nodes() == 0);
  CHECK_FALSE(framework.root().is_valid());
}

TEST_CASE("Equal points are merged with the first and reported", "[framework]") {
  const std::vector<Filtered_traits::Point_2> points{{1, 1}, {0, 0}, {1, 1}, {-0.0, 0}, {1, 1}};
  const CGAL::Quadtree_framework<Filtered_traits> framework(points);
  CHECK(framework.number_of_points() == 2);
  REQUIRE(framework.duplicates().size() == 3);
  CHECK(framework.duplicates()[0].kept == Point_index(1));
  CHECK(framework.duplicates()[0].duplicate == Point_index(3));
  CHECK(framework.duplicates()[1].kept == Point_index(0));
  CHECK(framework.duplicates()[1].duplicate == Point_index(2));
  CHECK(framework.duplicates()[2].duplicate == Point_index(4));
  CHECK(framework.node(Point_rank(0)) == framework.root());
}

TEST_CASE("A spiral as deep as the grid has one square per point", "[framework]") {
  std::vector<Filtered_traits::Point_2> points{{0, 0}};
  for (int i = 0; i < 60; ++i) points.emplace_back(std::ldexp(1.0, -i), std::ldexp(1.0, -i));
  const CGAL::Quadtree_framework<Filtered_traits> framework(points);
  CHECK(framework.number_of_nodes() == 60);
  for (std::size_t v = 1; v < 60; ++v) CHECK(framework.parent(Node_index(v)) == Node_index(v - 1));
  // The greatest point alone lies beyond the root's middle lines.
  CHECK(framework.level(Node_index(0)) == 0);
  for (std::size_t v = 2; v < 60; ++v)
    CHECK(framework.level(Node_index(v)) == framework.level(Node_index(v - 1)) + 1);
}

TEST_CASE("A framework can be built from other ranges", "[framework]") {
  const std::array<CGAL::Fixed_point_2<std::uint32_t>, 3> points{{{1, 2}, {3, 4}, {5, 6}}};
  const CGAL::Quadtree_framework<Fixed_32_traits> framework(points);
  CHECK(framework.number_of_points() == 3);
}

} // namespace test_quadtree_framework
