// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "random_numbers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/find_clusters.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/exact_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

namespace test_find_clusters {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using internal::Cluster;
using internal::Cluster_tree;
using Doubles = internal::Double_geometry_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Integers = internal::Integer_geometry_2<std::uint64_t>;
using Exact = internal::Exact_geometry_2<CGAL::Simple_cartesian<CGAL::Exact_rational>>;
using Point = Doubles::Point;
using Points = std::vector<Point>;
using Set = std::vector<std::uint32_t>;

/// The points of each cluster of a tree, by cluster.
std::vector<Set> sets_of(const Cluster_tree& tree) {
  std::vector<Set> sets(tree.clusters.size());
  for (std::size_t k = tree.clusters.size(); k-- > 0;) {
    const Cluster& c = tree.clusters[k];
    sets[k].insert(sets[k].end(), tree.points.begin() + c.first_point, tree.points.begin() + c.end_point);
    std::sort(sets[k].begin(), sets[k].end());
    if (k > 0) {
      Set& parent = sets[std::size_t(c.parent)];
      parent.insert(parent.end(), sets[k].begin(), sets[k].end());
    }
  }
  return sets;
}

/// All sets that are clusters by the definition. Such a set is what is within its width's gap of one of its
/// points, so it is what distances below some distance of two points link: for each such distance, all components
/// are tried.
template <class Geometry>
std::set<Set> brute_force_clusters(const std::vector<typename Geometry::Point>& points, double gap) {
  const std::size_t n = points.size();
  const auto distance = [&](std::size_t i, std::size_t j) {
    return internal::length_of(Geometry::difference(points[i], points[j]));
  };
  std::vector<double> distances;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) distances.push_back(distance(i, j));
  std::sort(distances.begin(), distances.end());
  distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
  std::set<Set> result;
  for (double limit : distances) {
    std::vector<bool> is_done(n, false);
    for (std::size_t start = 0; start < n; ++start) {
      if (is_done[start]) continue;
      std::vector<bool> is_in(n, false);
      std::vector<std::size_t> stack{start};
      is_in[start] = true;
      while (!stack.empty()) {
        const std::size_t i = stack.back();
        stack.pop_back();
        is_done[i] = true;
        for (std::size_t j = 0; j < n; ++j)
          if (!is_in[j] && distance(i, j) <= limit) is_in[j] = true, stack.push_back(j);
      }
      double rest = INFINITY, width = 0;
      Set set;
      for (std::uint32_t i = 0; i < n; ++i) {
        if (!is_in[i]) continue;
        set.push_back(i);
        for (std::size_t j = 0; j < n; ++j) {
          const auto v = Geometry::difference(points[i], points[j]);
          if (is_in[j])
            width = std::max({width, v.x, v.y});
          else
            rest = std::min(rest, internal::length_of(v));
        }
      }
      if (set.size() >= 2 && set.size() < n && rest >= gap * width) result.insert(set);
    }
  }
  return result;
}

/// Order and ranges of the tree, and its figures against the sets'.
template <class Geometry>
void check_tree(const std::vector<typename Geometry::Point>& points, const Cluster_tree& tree) {
  const std::vector<Set> sets = sets_of(tree);
  REQUIRE(tree.points.size() == points.size());
  REQUIRE(tree.clusters.size() <= std::max<std::size_t>(1, points.size()));
  if (points.empty()) return;
  CHECK(tree.clusters[0].parent == -1);
  CHECK(std::isinf(tree.clusters[0].distance));
  CHECK(sets[0].size() == points.size());
  std::int32_t next_child = 1;
  for (std::size_t k = 0; k < tree.clusters.size(); ++k) {
    const Cluster& c = tree.clusters[k];
    REQUIRE((k == 0 || c.parent < std::int32_t(k)));
    REQUIRE(c.least_point == sets[k].front());
    REQUIRE((k == 0 || c.number_of_sites() >= 2));
    if (c.first_child != c.end_child) {
      REQUIRE(c.first_child == next_child);
      next_child = c.end_child;
    }
    for (std::int32_t child = c.first_child; child < c.end_child; ++child) {
      REQUIRE(tree.clusters[std::size_t(child)].parent == std::int32_t(k));
      if (child > c.first_child)
        REQUIRE(tree.clusters[std::size_t(child) - 1].least_point <
                tree.clusters[std::size_t(child)].least_point);
    }
    double width = 0;
    for (std::uint32_t i : {c.box.left, c.box.right, c.box.bottom, c.box.top})
      REQUIRE(std::binary_search(sets[k].begin(), sets[k].end(), i));
    std::size_t outside = 0;
    for (std::uint32_t i : sets[k])
      outside += points[i].x < points[c.box.left].x || points[c.box.right].x < points[i].x ||
                 points[i].y < points[c.box.bottom].y || points[c.box.top].y < points[i].y;
    REQUIRE(outside == 0);
    width = internal::width_of<Geometry>(points, c.box);
    REQUIRE(c.width == width);
  }
  CHECK(next_child == std::int32_t(tree.clusters.size()));
}

/// Compares with all clusters by the definition.
template <class Geometry>
Cluster_tree check_clusters(const std::vector<typename Geometry::Point>& points, double gap) {
  const Cluster_tree tree = internal::find_clusters<CGAL::Sequential_tag, Geometry>(points, gap);
  check_tree<Geometry>(points, tree);
  std::vector<Set> sets = sets_of(tree);
  if (!sets.empty()) sets.erase(sets.begin());
  const std::set<Set> found(sets.begin(), sets.end());
  CHECK(found.size() == sets.size());
  CHECK(found == brute_force_clusters<Geometry>(points, gap));
  for (std::size_t i = 0; i < points.size(); ++i) {
    double nearest = INFINITY;
    for (std::size_t j = 0; j < points.size(); ++j)
      if (i != j)
        nearest = std::min(nearest, internal::length_of(Geometry::difference(points[i], points[j])));
    CHECK(tree.nearest[i] == nearest);
  }
  return tree;
}

template <class P>
void shuffle(std::vector<P>& points, Random_numbers& random) {
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[static_cast<std::size_t>(random() * double(i))]);
}

/// Points of which some are multiplied into tiny groups, and some of these again.
Points planted(std::size_t n, Random_numbers& random) {
  Points points;
  for (int i = 0; i < 4; ++i) points.push_back({random(), random()});
  while (points.size() < n) {
    const Point p = points[static_cast<std::size_t>(random() * double(points.size()))];
    const double radius = std::ldexp(1.0, -int(random() * 45));
    for (int k = int(random() * 3); k >= 0; --k)
      points.push_back({p.x + radius * (random() - 0.5), p.y + radius * (random() - 0.5)});
  }
  shuffle(points, random);
  return points;
}

Points distinct(Points points) {
  std::sort(points.begin(), points.end(),
            [](Point p, Point q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

} // namespace

TEST_CASE("Few points have the clusters they should have", "[clusters]") {
  CHECK(internal::find_clusters<CGAL::Sequential_tag, Doubles>({}, 100).clusters.empty());
  CHECK(check_clusters<Doubles>({{3, 4}}, 100).clusters.size() == 1);
  CHECK(check_clusters<Doubles>({{3, 4}, {5, 4}}, 100).clusters.size() == 1);
  CHECK(check_clusters<Doubles>({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, 100).clusters.size() == 1);
  // the distance is the gap times the width, exactly
  CHECK(check_clusters<Doubles>({{0, 0}, {1, 0}, {101, 0}}, 100).clusters.size() == 2);
  CHECK(check_clusters<Doubles>({{0, 0}, {1, 0}, {100.5, 0}}, 100).clusters.size() == 1);
  // on a line
  CHECK(check_clusters<Doubles>({{0, 0}, {1, 1}, {1000, 1000}, {1001, 1001}, {5000, 5000}}, 100)
            .clusters.size() == 3);
}

TEST_CASE("Points around a corner of squares are a cluster", "[clusters]") {
  const double e = 0x1p-30;
  Points four{{0.5 - e, 0.5 - e}, {0.5 + e, 0.5 - e}, {0.5 - e, 0.5 + e}, {0.5 + e, 0.5 + e}, {0, 0}, {1, 1}};
  CHECK(check_clusters<Doubles>(four, 0x1p14).clusters.size() == 2);
  // four pairs around it, clusters in a cluster
  const std::size_t n = four.size();
  for (std::size_t i = 0; i < n; ++i) four.push_back({four[i].x, four[i].y + 0x1p-50});
  const Cluster_tree tree = check_clusters<Doubles>(four, 0x1p14);
  CHECK(tree.clusters.size() == 8);
  CHECK(tree.clusters[1].number_of_sites() == 4);
}

TEST_CASE("Neighboring clusters are found apart and together", "[clusters]") {
  // pairs along a line at growing distances, each pair tiny
  Points points;
  for (int k = 0; k < 12; ++k) {
    const double x = std::ldexp(1.0, k);
    points.push_back({x, 0});
    points.push_back({x + x * 0x1p-20, 0});
  }
  CHECK(check_clusters<Doubles>(points, internal::least_cluster_gap).clusters.size() == 13);
  CHECK(check_clusters<Doubles>(points, 0x1p18).clusters.size() == 13);
  CHECK(check_clusters<Doubles>(points, 0x1p20).clusters.size() == 1);
}

TEST_CASE("Clusters are those of the definition for random points", "[clusters]") {
  const int rounds = is_full_run() ? 600 : 60;
  for (int round = 0; round < rounds; ++round) {
    CAPTURE(round);
    Random_numbers random(std::uint64_t(round) + 1);
    const double gap = round % 3 == 0 ? 3 : round % 3 == 1 ? 40 : internal::least_cluster_gap;
    Points points = distinct(planted(4 + std::size_t(round) % 37, random));
    shuffle(points, random);
    check_clusters<Doubles>(points, gap);
  }
}

TEST_CASE("Integers beyond 2^53 are told apart", "[clusters]") {
  const int rounds = is_full_run() ? 300 : 4;
  for (int round = 0; round < rounds; ++round) {
    CAPTURE(round);
    Random_numbers random(std::uint64_t(round) + 77);
    Points drafts = planted(40, random);
    std::vector<Integers::Point> points;
    for (const Point& p : drafts) {
      // a spread below the last bits of doubles
      const auto x = std::int64_t(p.x * 0x1p60), y = std::int64_t(p.y * 0x1p60);
      points.push_back({x, y});
      if (random() < 0.3)
        points.push_back({x + std::int64_t(9 * random()), y + 1 + std::int64_t(9 * random())});
    }
    std::sort(points.begin(), points.end(),
              [](auto p, auto q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    shuffle(points, random);
    check_clusters<Integers>(points, round % 2 == 0 ? 5 : 3000);
  }
}

TEST_CASE("Clusters are nested fifty deep", "[clusters]") {
  Points points;
  std::vector<Exact::Point> exact;
  const CGAL::Exact_rational third = CGAL::Exact_rational(1) / CGAL::Exact_rational(3);
  for (int k = 0; k <= 50; ++k) {
    const double x = std::ldexp(1.0, -12 * k);
    points.push_back({x, k % 3 == 1 ? x / 2 : 0});
    exact.push_back({Exact::Coordinate(CGAL::Exact_rational(third + CGAL::Exact_rational(points.back().x))),
                     Exact::Coordinate(CGAL::Exact_rational(third * CGAL::Exact_rational(points.back().y)))});
  }
  points.push_back({0, 0});
  exact.push_back({Exact::Coordinate(third), Exact::Coordinate(0.0)});
  const auto check = [](const Cluster_tree& tree) {
    REQUIRE(tree.clusters.size() == 51);
    for (std::size_t k = 1; k < 51; ++k) {
      CHECK(tree.clusters[k].parent == std::int32_t(k) - 1);
      CHECK(tree.clusters[k].number_of_sites() == 2);
    }
  };
  check(check_clusters<Doubles>(points, internal::least_cluster_gap));
  check(check_clusters<Exact>(exact, internal::least_cluster_gap));
}

TEST_CASE("A spiral has no clusters", "[clusters]") {
  Points points;
  for (int k = 0; k < 600; ++k) {
    const double r = std::exp2(-0.05 * k), angle = 0.3 * k;
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  CHECK(internal::find_clusters<CGAL::Sequential_tag, Doubles>(points, internal::least_cluster_gap)
            .clusters.size() == 1);
}

TEST_CASE("Points on a line, and one beside it, take no longer than others", "[clusters]") {
  Random_numbers random(9);
  Points points;
  for (int i = 0; i < 60000; ++i) points.push_back({random(), 0});
  points = distinct(points);
  shuffle(points, random);
  for (double y : {0., 1e-3}) {
    points.push_back({0.5, y});
    points = distinct(points);
    const Cluster_tree tree =
        internal::find_clusters<CGAL::Sequential_tag, Doubles>(points, internal::least_cluster_gap);
    check_tree<Doubles>(points, tree);
    CHECK(tree.clusters.size() > 5);
  }
}

TEST_CASE("Many points have at most as many clusters", "[clusters]") {
  Random_numbers random(5);
  Points points;
  for (int i = 0; i < 3000; ++i) {
    const Point p{random(), random()};
    for (int k = 0; k < 4; ++k) points.push_back({p.x + 1e-9 * random(), p.y + 1e-9 * random()});
  }
  const Cluster_tree tree =
      internal::find_clusters<CGAL::Sequential_tag, Doubles>(points, internal::least_cluster_gap);
  check_tree<Doubles>(points, tree);
  CHECK(tree.clusters.size() > 2900);
  // the same whatever the order of the points is
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  shuffle(order, random);
  Points shuffled;
  for (std::uint32_t i : order) shuffled.push_back(points[i]);
  std::set<Set> sets, others;
  for (const Set& s : sets_of(tree)) sets.insert(s);
  for (Set s : sets_of(
           internal::find_clusters<CGAL::Sequential_tag, Doubles>(shuffled, internal::least_cluster_gap))) {
    for (std::uint32_t& i : s) i = order[i];
    std::sort(s.begin(), s.end());
    others.insert(s);
  }
  CHECK(sets == others);
}

} // namespace test_find_clusters
