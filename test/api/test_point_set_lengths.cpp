// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "quadtree_test_inputs.h"

#include <CGAL/Quadtree_mesh_2/internal/frame/points_in_box.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/point_set_lengths_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace test_point_set_lengths {

namespace {

using namespace quadtree_test;
using Point = Filtered_traits::Point_2;
using Points = std::vector<Point>;
using CGAL::point_set_lengths_2;

double distance(const Point& p, const Point& q) { return std::hypot(p.x() - q.x(), p.y() - q.y()); }

/// By Prim's algorithm on the complete graph.
double spanning_tree_by_definition(const Points& points) {
  std::vector<double> to_tree(points.size(), std::numeric_limits<double>::infinity());
  std::vector<char> is_in_tree(points.size(), 0);
  double sum = 0;
  for (std::size_t round = 0; round < points.size(); ++round) {
    std::size_t next = 0;
    while (is_in_tree[next]) ++next;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!is_in_tree[i] && to_tree[i] < to_tree[next]) next = i;
    is_in_tree[next] = 1;
    if (round > 0) sum += to_tree[next];
    for (std::size_t i = 0; i < points.size(); ++i)
      to_tree[i] = std::min(to_tree[i], distance(points[i], points[next]));
  }
  return sum;
}

/// Of the edges of all triangles with empty circles, for points of which no four are on a circle.
double delaunay_by_definition(const Points& points) {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  const auto is_empty = [&](const Point& a, const Point& b, const Point& c) {
    return std::none_of(points.begin(), points.end(), [&](const Point& p) {
      return CGAL::side_of_bounded_circle(a, b, c, p) == CGAL::ON_BOUNDED_SIDE;
    });
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        if (is_empty(points[i], points[j], points[k])) edges.insert({{j, i}, {k, i}, {k, j}});
  double sum = 0;
  for (const auto& [i, j] : edges) sum += distance(points[i], points[j]);
  return sum;
}

/// Of the edges that have no point to their right.
double hull_by_definition(const Points& points) {
  double sum = 0;
  for (const Point& p : points)
    for (const Point& q : points)
      if (p != q && std::none_of(points.begin(), points.end(),
                                 [&](const Point& r) { return CGAL::right_turn(p, q, r); }))
        sum += distance(p, q);
  return sum;
}

} // namespace

TEST_CASE("Lengths agree with their definitions", "[point_set_lengths]") {
  for (const Input& input : all_inputs()) {
    CAPTURE(input.name);
    const Points points = make_points<Filtered_traits>(input);
    CHECK(point_set_lengths_2(points).spanning_tree ==
          Approx(spanning_tree_by_definition(points)).margin(1e-300));
  }
  for (unsigned seed = 1; seed < 6; ++seed) {
    const Points points = make_points<Filtered_traits>(uniform(3 + 6 * seed, seed));
    const auto lengths = point_set_lengths_2(points);
    CHECK(lengths.spanning_tree == Approx(spanning_tree_by_definition(points)));
    CHECK(lengths.delaunay == Approx(delaunay_by_definition(points)));
    CHECK(lengths.hull == Approx(hull_by_definition(points)));
  }
}

TEST_CASE("Lengths of few and collinear points", "[point_set_lengths]") {
  CHECK(point_set_lengths_2(Points{}).least_mesh() == 0);
  CHECK(point_set_lengths_2(Points{{1, 2}}).least_mesh() == 0);
  CHECK(point_set_lengths_2(Points{{1, 2}, {1, 2}}).delaunay == 0);
  const auto two = point_set_lengths_2(Points{{0, 0}, {3, 4}});
  CHECK(two.spanning_tree == 5);
  CHECK(two.delaunay == 5);
  CHECK(two.hull == 10);
  const auto line = point_set_lengths_2(Points{{0, 0}, {5, 0}, {1, 0}, {2, 0}});
  CHECK(line.spanning_tree == 5);
  CHECK(line.hull == 10);
  const auto square = point_set_lengths_2(Points{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  CHECK(square.spanning_tree == 3);
  CHECK(square.hull == 4);
  CHECK(square.delaunay == Approx(4 + std::sqrt(2.0)));
  CHECK(square.least_mesh() == 4);
}

TEMPLATE_TEST_CASE("A mesh is at least as long as its points demand", "[point_set_lengths]", Filtered_traits,
                   Fixed_64_traits, Exact_traits) {
  Input input = uniform(200, 3);
  for (Raw_point& p : input.points) p = {p.x / 2, p.y / 2};
  const auto points = make_points<TestType>(input);
  const auto pslg = CGAL::Quadtree_mesh_2::internal::points_in_box(points);
  const auto mesh = CGAL::Quality_mesher_2<TestType>()(pslg);
  const double length = CGAL::total_edge_length_2(mesh);
  CHECK(length == Approx(CGAL::mesh_quality_2(mesh, pslg).total_length));
  CHECK(length >= point_set_lengths_2(points).least_mesh());
}

} // namespace test_point_set_lengths
