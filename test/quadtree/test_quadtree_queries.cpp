// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "quadtree_test_inputs.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/locate_all.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/locate_by_framework.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/near_neighbors.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace test_quadtree_queries {

using namespace quadtree_test;
using CGAL::Quadtree_options;
using CGAL::Quadtree_mesh_2::Balance;
using CGAL::Quadtree_mesh_2::Balance_schedule;
using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::Node_index;
using CGAL::Quadtree_mesh_2::Point_rank;
using CGAL::Quadtree_mesh_2::internal::locate_all;
using CGAL::Quadtree_mesh_2::internal::locate_by_framework;
using CGAL::Quadtree_mesh_2::internal::near_neighbor;
using CGAL::Quadtree_mesh_2::internal::near_neighbor_factor;
using CGAL::Quadtree_mesh_2::internal::Near_neighbor_search;
using CGAL::Quadtree_mesh_2::internal::near_neighbors;

namespace {

using Integer = boost::multiprecision::cpp_int;

template <class Framework>
Integer squared_distance(const Framework& framework, std::size_t a, std::size_t b) {
  const auto p = framework.grid_point(Point_rank(a)), q = framework.grid_point(Point_rank(b));
  const Integer x = Integer(p.x) - Integer(q.x), y = Integer(p.y) - Integer(q.y);
  return x * x + y * y;
}

template <class Framework>
Integer squared_distance_of_nearest(const Framework& framework, std::size_t r) {
  Integer least = 0;
  for (std::size_t i = 0; i < framework.number_of_points(); ++i) {
    const Integer d = i == r ? Integer(0) : squared_distance(framework, r, i);
    if (d != 0 && (least == 0 || d < least)) least = d;
  }
  return least;
}

/// Whether `a <= (7 + sqrt(13)) / 4 b`.
bool is_within_squared_factor(const Integer& a, const Integer& b) {
  const Integer rest = 4 * a - 7 * b;
  return rest <= 0 || rest * rest <= 13 * b * b;
}

/// How bad the near neighbors of a tree are.
struct Quality {
  double factor = 1;
  std::size_t squares = 0; // looked at for a point
};

/// Checks near neighbors against all other points.
template <class Quadtree>
Quality check_near_neighbors(const Quadtree& tree) {
  Quality worst;
  const auto& framework = tree.framework();
  const std::vector<Point_rank> near = near_neighbors<CGAL::Sequential_tag>(tree);
  REQUIRE(near.size() == framework.number_of_points());
  for (std::size_t r = 0; r < near.size(); ++r) {
    Near_neighbor_search<Quadtree> search(tree, Point_rank(r));
    if (search.find() != near[r]) FAIL("point " << r << " has another near neighbor by itself");
    worst.squares = std::max(worst.squares, search.number_of_squares());
    if (near[r].is_valid() != (near.size() > 1)) FAIL("point " << r << " has a near neighbor or none");
    if (!near[r].is_valid()) continue;
    if (near[r] == Point_rank(r) || std::size_t(near[r]) >= near.size())
      FAIL("point " << r << " has no other one for its near neighbor");
    const Integer found = squared_distance(framework, r, std::size_t(near[r]));
    const Integer nearest = squared_distance_of_nearest(framework, r);
    if (!is_within_squared_factor(found, nearest)) FAIL("the near neighbor of point " << r << " is too far");
    worst.factor =
        std::max(worst.factor, std::sqrt(found.convert_to<double>() / nearest.convert_to<double>()));
  }
  return worst;
}

/// Few lattice points close to each other: distances are equal or nearly so.
Input small_lattice(unsigned seed) {
  std::mt19937_64 random(seed);
  Input input{"small lattice", {}};
  const int width = static_cast<int>(1 + random() % 5), shift = static_cast<int>(35 + random() % 20);
  for (unsigned i = 0; i < 2 + seed % 12; ++i) {
    const std::uint64_t x = random() >> (64 - width), y = random() >> (64 - width);
    input.points.push_back({(x + 7) << shift, (y + 8) << shift});
  }
  return input;
}

constexpr std::array<Balance_schedule, 2> schedules{
    {Balance_schedule::LEVEL_BY_LEVEL, Balance_schedule::SPACED_LEVELS}};

} // namespace

TEMPLATE_TEST_CASE("Near neighbors are within the factor", "[queries]", Filtered_traits, Fixed_32_traits,
                   Fixed_64_traits, Exact_traits) {
  Quality worst;
  const auto check = [&](const Input& input, const Quadtree_options& options) {
    CAPTURE(input.name, options.max_points_per_leaf(), int(options.schedule()));
    const CGAL::Balanced_quadtree<TestType> tree(make_points<TestType>(input), options);
    const Quality quality = check_near_neighbors(tree);
    worst.factor = std::max(worst.factor, quality.factor);
    worst.squares = std::max(worst.squares, quality.squares);
  };
  for (Balance_schedule schedule : schedules) {
    for (std::size_t max_points : {1u, 3u})
      for (const Input& input : all_inputs())
        check(input, Quadtree_options().schedule(schedule).max_points_per_leaf(max_points));
    for (unsigned seed = 0; seed < (is_full_run() ? 20000u : 400u); ++seed) {
      check(small_random(seed), Quadtree_options().schedule(schedule));
      check(small_lattice(seed), Quadtree_options().schedule(schedule));
    }
  }
  CHECK(worst.squares <= 456);
  CHECK(worst.factor <= near_neighbor_factor);
  if (is_full_run()) WARN("factor " << worst.factor << ", squares " << worst.squares);
}

TEST_CASE("The factor of near neighbors is sharp", "[queries]") {
  // A leaf of side 1 with a point at its left side, and a square of side 1/2 that is 1 away and holds two
  // points: its first one is in the lower left corner, and the nearest one in the upper right corner.
  const std::uint64_t side = std::uint64_t(1) << 50, x = 8 * side, y = 8 * side;
  const double height = (std::sqrt(13.0) - 2) / 2;
  const std::vector<Fixed_64_traits::Point_2> points{
      {x, y + static_cast<std::uint64_t>(height * double(side))},
      {x - 3 * side / 2, y},
      {x - side - 1, y + side / 2 - 1}};
  const CGAL::Balanced_quadtree<Fixed_64_traits> tree(points);
  const Point_rank p = tree.framework().rank(CGAL::Quadtree_mesh_2::Point_index(0));
  REQUIRE(tree.level(tree.leaf(p)) == 62 - 50);
  CHECK(near_neighbor(tree, p) == tree.framework().rank(CGAL::Quadtree_mesh_2::Point_index(1)));
  CHECK(check_near_neighbors(tree).factor > near_neighbor_factor - 1e-6);
}

TEST_CASE("Leaves far smaller than asked for do not spoil near neighbors", "[queries]") {
  for (const Input& input : all_inputs()) {
    CAPTURE(input.name);
    CGAL::Quadtree_framework<Fixed_64_traits> framework(make_points<Fixed_64_traits>(input));
    std::vector<int> levels;
    for (std::size_t r = 0; r < framework.number_of_points(); ++r)
      levels.push_back(static_cast<int>(3 + (r * 37) % 40));
    framework.annotate(levels);
    check_near_neighbors(CGAL::Balanced_quadtree<Fixed_64_traits>(framework));
    check_near_neighbors(
        CGAL::Balanced_quadtree<Fixed_64_traits>(framework, Quadtree_options().max_points_per_leaf(4)));
  }
}

TEST_CASE("Rounding to the grid adds less than four units", "[queries]") {
  // Doubles near 0 can be finer than the grid.
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::vector<Filtered_traits::Point_2> points{{-1, -1}, {1, 1}};
    const double unit = std::ldexp(1.0, -60); // near the grid's; 2^-62 of its root
    for (int i = 0; i < 12; ++i) {
      const double width = 2 + seed % 30;
      const auto coordinate = [&] { return std::ldexp(double(random() >> 11), -53) * width * unit; };
      points.emplace_back(coordinate(), coordinate());
    }
    const auto build = [&]() -> CGAL::Balanced_quadtree<Filtered_traits> {
      while (true) {
        try {
          return CGAL::Balanced_quadtree<Filtered_traits>(points);
        } catch (const CGAL::Quadtree_mesh_2::Point_error&) {
          points.pop_back(); // two in one unit
        }
      }
    };
    const auto tree = build();
    const auto root = tree.corners(tree.root());
    const double side_of_unit = std::ldexp(root[1].x() - root[0].x(), -62);
    const auto point = [&](Point_rank r) { return points[std::size_t(tree.framework().input_point(r))]; };
    for (std::size_t r = 0; r < tree.framework().number_of_points(); ++r) {
      const auto p = point(Point_rank(r)), q = point(near_neighbor(tree, Point_rank(r)));
      const double found = std::hypot(p.x() - q.x(), p.y() - q.y());
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i] == p) continue;
        const double d = std::hypot(p.x() - points[i].x(), p.y() - points[i].y());
        CHECK(found <= (near_neighbor_factor * d + 3.72 * side_of_unit) * (1 + 1e-12));
      }
    }
  }
}

TEMPLATE_TEST_CASE("Points are located by the framework of points and corners", "[queries]", Filtered_traits,
                   Fixed_32_traits, Fixed_64_traits, Exact_traits) {
  const auto check = [](const auto& tree) {
    const auto by_framework = locate_by_framework<CGAL::Sequential_tag>(tree);
    const auto& framework = tree.framework();
    REQUIRE(by_framework.size() == framework.number_of_points());
    std::size_t wrong = 0;
    for (std::size_t r = 0; r < by_framework.size(); ++r)
      wrong += by_framework[r] == tree.leaf(Point_rank(r)) ? 0 : 1;
    REQUIRE(wrong == 0);
    REQUIRE(locate_by_framework<CGAL::Parallel_tag>(tree) == by_framework);
  };
  using Tree = CGAL::Balanced_quadtree<TestType>;
  for (const Input& input : all_inputs())
    for (Balance balance : {Balance::NONE, Balance::SIDES, Balance::SIDES_AND_CORNERS})
      for (Balance_schedule schedule : schedules)
        for (std::size_t max_points : {1u, 3u}) {
          CAPTURE(input.name, int(balance), int(schedule), max_points);
          check(Tree(make_points<TestType>(input),
                     Quadtree_options().balance(balance).schedule(schedule).max_points_per_leaf(max_points)));
        }
  for (unsigned seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    check(Tree(make_points<TestType>(small_random(seed))));
    check(Tree(make_points<TestType>(small_lattice(seed))));
  }
}

TEST_CASE("Points in squares of one grid unit are located", "[queries]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<Fixed_32_traits::Point_2> points;
    for (int i = 0; i < 25; ++i)
      points.push_back({std::uint32_t(random() % 8 + 1000000), std::uint32_t(random() % 8 + 2000000)});
    CGAL::Quadtree_framework<Fixed_32_traits> framework(points);
    framework.annotate(std::vector<int>(framework.number_of_points(), 31));
    const CGAL::Balanced_quadtree<Fixed_32_traits> tree(framework);
    const auto leaves = locate_by_framework<CGAL::Sequential_tag>(tree);
    for (std::size_t r = 0; r < leaves.size(); ++r) REQUIRE(leaves[r] == tree.leaf(Point_rank(r)));
    check_near_neighbors(tree);
  }
}

TEST_CASE("Many points are located as one by one", "[queries]") {
  const CGAL::Balanced_quadtree<Filtered_traits> tree(make_points<Filtered_traits>(uniform(3000, 21)));
  const auto root = tree.corners(tree.root());
  const double side = root[1].x() - root[0].x();
  std::mt19937_64 random(22);
  const auto coordinate = [&](double low) {
    return low + side * (1.2 * std::ldexp(double(random() >> 11), -53) - 0.1);
  };
  std::vector<Filtered_traits::Point_2> queries{root[0], root[1], root[2], root[3]};
  for (int i = 0; i < 20000; ++i) queries.emplace_back(coordinate(root[0].x()), coordinate(root[0].y()));
  const auto leaves = locate_all<CGAL::Sequential_tag>(tree, queries);
  REQUIRE(leaves.size() == queries.size());
  std::size_t outside = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    REQUIRE(leaves[i] == tree.locate(queries[i]));
    outside += leaves[i].is_valid() ? 0 : 1;
  }
  CHECK(outside > 1000);
  CHECK(locate_all<CGAL::Parallel_tag>(tree, queries) == leaves);
  CHECK(locate_all<CGAL::Parallel_tag>(tree, std::vector<Filtered_traits::Point_2>()).empty());
}

TEST_CASE("Queries give the same results with any number of threads", "[queries]") {
  for (const Input& input : {uniform(30000, 23), spiral()}) {
    CAPTURE(input.name);
    const auto points = make_points<Filtered_traits>(input);
    const CGAL::Balanced_quadtree<Filtered_traits> sequential(points);
    const CGAL::Balanced_quadtree<Filtered_traits, CGAL::Parallel_tag> parallel(points);
    CHECK(near_neighbors<CGAL::Sequential_tag>(sequential) == near_neighbors<CGAL::Parallel_tag>(parallel));
    const auto leaves = locate_by_framework<CGAL::Sequential_tag>(sequential);
    CHECK(leaves == locate_by_framework<CGAL::Parallel_tag>(parallel));
    CHECK(leaves.size() == sequential.framework().number_of_points());
    for (std::size_t r = 0; r < leaves.size(); ++r) REQUIRE(leaves[r] == sequential.leaf(Point_rank(r)));
  }
}

} // namespace test_quadtree_queries
