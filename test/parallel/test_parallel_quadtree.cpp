// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Quadtrees of many points: the same for any number of threads, and of a size in proportion to the points
// whatever the depth.

#include "catch.h"
#include "numbers_of_threads.h"
#include "quadtree_checks.h"
#include "quadtree_test_inputs.h"

#include <CGAL/Balanced_quadtree.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace test_parallel_quadtree {

using namespace quadtree_test;
using CGAL::Parallel_tag;
using CGAL::Quadtree_options;
using CGAL::Sequential_tag;
using CGAL::Quadtree_mesh_2::Balance_schedule;

namespace {

/// A digest of numbers in their order (FNV-1a, 64 bits, a number at a time).
class Digest {
public:
  void add(std::uint64_t number) { value_ = (value_ ^ number) * 0x100000001b3u; }
  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

/// A digest of all that a quadtree answers.
template <class Tree>
std::uint64_t digest(const Tree& tree) {
  Digest all;
  const auto& framework = tree.framework();
  for (std::size_t r = 0; r < framework.number_of_points(); ++r) {
    const Point_rank rank(r);
    all.add(framework.input_point(rank).value());
    all.add(framework.node(rank).value());
    all.add(tree.leaf(rank).value());
  }
  for (const auto& d : framework.duplicates()) all.add(d.duplicate.value());
  for (std::size_t i = 0; i < framework.number_of_nodes(); ++i) {
    const Node_index v(i);
    all.add(framework.points(v).begin.value());
    all.add(framework.points(v).end.value());
    all.add(static_cast<std::uint64_t>(framework.level(v)));
    all.add(framework.parent(v).value());
    all.add(framework.subtree_end(v).value());
  }
  all.add(tree.number_of_nodes());
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i) {
    const Node_index v(i);
    all.add(static_cast<std::uint64_t>(tree.level(v)));
    all.add(tree.is_leaf(v) ? tree.leaf(v).value() : tree.child(v, 0).value());
    all.add(tree.points(v).begin.value());
    for (Direction d : all_directions()) all.add(tree.neighbor(v, d).value());
  }
  return all.value();
}

/// Points on a spiral whose radius goes down to 2^-depth, around `center`.
template <class Traits>
std::vector<typename Traits::Point_2> spiral_points(std::size_t n, double depth, double center) {
  std::vector<typename Traits::Point_2> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double radius = std::exp2(-depth * static_cast<double>(i) / static_cast<double>(n));
    const double angle = 0.7 * static_cast<double>(i);
    points.emplace_back(center + radius * std::cos(angle), center + radius * std::sin(angle));
  }
  return points;
}

/// Points of all kinds in great number: spread, in clusters, equal, and on the diagonal.
template <class Traits>
std::vector<typename Traits::Point_2> mixed_points(std::size_t n) {
  Input input = uniform(n / 2, 21);
  std::mt19937_64 random(22);
  while (input.points.size() < n) {
    const Raw_point& p = input.points[random() % input.points.size()];
    const int shift = static_cast<int>(4 + random() % 14);
    switch (random() % 3) {
    case 0:
      input.points.push_back({p.x ^ random() >> shift, p.y ^ random() >> shift});
      break;
    case 1:
      input.points.push_back(p);
      break;
    default:
      input.points.push_back({random() >> 2 & ~std::uint64_t(0xffffffff), p.x & 0xffff});
    }
  }
  return make_points<Traits>(input);
}

} // namespace

TEMPLATE_TEST_CASE("Quadtrees are the same for any number of threads and both schedules", "[parallel]",
                   Filtered_traits, Fixed_32_traits, Exact_traits) {
  const std::size_t n = is_full_run() ? 200000 : 9000;
  const auto points = mixed_points<TestType>(n);
  for (Balance balance : {Balance::SIDES_AND_CORNERS, Balance::SIDES}) {
    const auto options = Quadtree_options().balance(balance);
    const CGAL::Balanced_quadtree<TestType, Sequential_tag> sequential(points, options);
    CHECK(sequential.is_valid());
    const auto expected = digest(sequential);
    const auto leaves = sequential.locate_all(points);
    const bool has_neighbors = balance == Balance::SIDES_AND_CORNERS;
    const auto neighbors =
        has_neighbors ? sequential.near_neighbors() : decltype(sequential.near_neighbors())();
    for (Balance_schedule schedule : {Balance_schedule::LEVEL_BY_LEVEL, Balance_schedule::SPACED_LEVELS}) {
      const auto scheduled = Quadtree_options(options).schedule(schedule);
      CHECK(digest(CGAL::Balanced_quadtree<TestType, Sequential_tag>(points, scheduled)) == expected);
#ifdef CGAL_LINKED_WITH_TBB
      for (const std::size_t threads : numbers_of_threads()) {
        CAPTURE(threads);
        tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        const CGAL::Balanced_quadtree<TestType, Parallel_tag> parallel(points, scheduled);
        CHECK(digest(parallel) == expected);
      }
#endif
      const CGAL::Balanced_quadtree<TestType, Parallel_tag> parallel(points, scheduled);
      CHECK(digest(parallel) == expected);
      CHECK(parallel.locate_all(points) == leaves);
      if (has_neighbors) CHECK(parallel.near_neighbors() == neighbors);
    }
  }
}

TEST_CASE("Refined quadtrees are the same for any number of threads", "[parallel][threads]") {
  const auto points = mixed_points<Fixed_64_traits>(20000);
  CGAL::Balanced_quadtree<Fixed_64_traits, Sequential_tag> sequential(points);
  CGAL::Balanced_quadtree<Fixed_64_traits, Parallel_tag> parallel(points);
  std::vector<Leaf_index> leaves;
  for (std::size_t l = 0; l < sequential.number_of_leaves(); l += 7)
    if (sequential.level(Leaf_index(l)) < Fixed_64_traits::depth) leaves.emplace_back(l);
  sequential.refine(leaves);
  parallel.refine(leaves);
  CHECK(digest(parallel) == digest(sequential));
  CHECK(parallel.is_valid());
}

TEST_CASE("A spiral to the last double has squares in proportion to its points", "[parallel]") {
  for (std::size_t n : {1000u, 10000u}) {
    const auto points = spiral_points<Filtered_traits>(n, 52, 1);
    for (Balance_schedule schedule : {Balance_schedule::LEVEL_BY_LEVEL, Balance_schedule::SPACED_LEVELS}) {
      const CGAL::Balanced_quadtree<Filtered_traits> tree(points, Quadtree_options().schedule(schedule));
      CHECK(tree.is_valid());
      CHECK(tree.depth() > 50);
      CHECK(tree.framework().number_of_nodes() < tree.framework().number_of_points());
      CHECK(tree.number_of_leaves() < 8 * tree.framework().number_of_points());
      for (std::size_t l = 0; l < tree.number_of_leaves(); ++l)
        REQUIRE(tree.points(Leaf_index(l)).size() <= 1);
    }
  }
}

TEST_CASE("Spaced levels of deep spirals are the same for any number of threads", "[parallel][threads]") {
  const auto points = spiral_points<Exact_traits>(3000, 900, 0);
  for (Balance balance : {Balance::SIDES_AND_CORNERS, Balance::SIDES}) {
    const auto options = Quadtree_options().balance(balance);
    const auto expected = digest(CGAL::Balanced_quadtree<Exact_traits>(points, options));
    const auto spaced = Quadtree_options(options).schedule(Balance_schedule::SPACED_LEVELS);
    CHECK(digest(CGAL::Balanced_quadtree<Exact_traits, Parallel_tag>(points, spaced)) == expected);
  }
}

TEST_CASE("A spiral to 2^-900 has squares in proportion to its points and levels", "[parallel]") {
  const std::size_t n = is_full_run() ? 100000 : 5000;
  const auto points = spiral_points<Exact_traits>(n, 900, 0);
  for (Balance_schedule schedule : {Balance_schedule::LEVEL_BY_LEVEL, Balance_schedule::SPACED_LEVELS}) {
    const CGAL::Balanced_quadtree<Exact_traits> tree(points, Quadtree_options().schedule(schedule));
    CHECK(tree.framework().duplicates().empty());
    CHECK(tree.depth() > 895);
    CHECK(tree.framework().number_of_nodes() < n);
    CHECK(tree.number_of_leaves() < 8 * n + 50 * 900);
    for (std::size_t l = 0; l < tree.number_of_leaves(); ++l) REQUIRE(tree.points(Leaf_index(l)).size() <= 1);
    if (n <= 5000) CHECK(tree.is_valid());
    for (std::size_t i = 0; i < n; i += n / 100)
      CHECK(tree.locate(points[i]) == tree.leaf(CGAL::Quadtree_mesh_2::Point_index(i)));
  }
}

} // namespace test_parallel_quadtree
