// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Minimum spanning trees of points, and the sets that their edges link, against Prim's algorithm and components by all
// pairs of points.

#include "catch.h"
#include "numbers_of_threads.h"
#include "quadtree_rounds.h"
#include "random_numbers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Linkage_boxes.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Single_linkage.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/find_clusters.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/neighbor_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/exact_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_single_linkage {

/// One thread, and blocks so small that few points are triangulated in several.
struct Small_blocks_tag : CGAL::Sequential_tag {};

} // namespace test_single_linkage

template <>
struct CGAL::Quadtree_mesh_2::internal::Block_sizes<test_single_linkage::Small_blocks_tag> {
  static constexpr std::size_t vertices = 16, triangles = 32;
};

namespace test_single_linkage {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using CGAL::Sequential_tag;
using internal::Component_id;
using internal::Link_id;
using internal::Measured_edge;
using internal::Measured_graph;
using internal::Single_linkage;
using internal::Vertex_id;
using Doubles = internal::Double_geometry_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Integers = internal::Integer_geometry_2<std::uint64_t>;
using Exact = internal::Exact_geometry_2<CGAL::Simple_cartesian<CGAL::Exact_rational>>;
using Points = std::vector<Doubles::Point>;
using Set = std::set<std::uint32_t>;

Points shuffled(Points points, std::uint64_t seed) {
  std::sort(points.begin(), points.end(), [](auto p, auto q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Random_numbers random(seed);
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[static_cast<std::size_t>(random() * double(i))]);
  return points;
}

Points lattice(int columns, int rows) {
  Points points;
  for (int i = 0; i < columns * rows; ++i) points.push_back({double(i % columns), double(i / columns)});
  return points;
}

/// All integer points at a distance from the origin: on a circle exactly.
Points circle(int squared_radius) {
  Points points;
  for (int x = -squared_radius; x <= squared_radius; ++x)
    for (int y = -squared_radius; y <= squared_radius; ++y)
      if (x * x + y * y == squared_radius) points.push_back({double(x), double(y)});
  return points;
}

Points uniform(std::size_t n, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random();
    points.push_back({x, random()});
  }
  return points;
}

/// Points of which some are multiplied into groups of all sizes, and some of these again.
Points planted(std::size_t n, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points = uniform(3, seed);
  while (points.size() < n) {
    const auto p = points[static_cast<std::size_t>(random() * double(points.size()))];
    const double radius = std::ldexp(1.0, -static_cast<int>(random() * 45));
    for (int k = static_cast<int>(random() * 3); k >= 0; --k) {
      const double dx = random() - 0.5;
      points.push_back({p.x + radius * dx, p.y + radius * (random() - 0.5)});
    }
  }
  return points;
}

/// Points on a line, each farther from the one before it: all join the first one of them, one after the other.
Points growing(std::size_t n, double factor) {
  Points points;
  double x = 0, step = 1;
  for (std::size_t i = 0; i < n; ++i, x += step, step *= factor)
    points.push_back({x, 0.25 * double(i % 2) * step});
  return points;
}

/// Small sets, with ties of all kinds.
std::vector<std::pair<std::string, Points>> small_sets() {
  std::vector<std::pair<std::string, Points>> sets{{"none", {}},
                                                   {"one", {{3, 4}}},
                                                   {"two", {{3, 4}, {5, 4}}},
                                                   {"square", lattice(2, 2)},
                                                   {"lattice", lattice(7, 7)},
                                                   {"rows", lattice(20, 2)},
                                                   {"row", lattice(40, 1)},
                                                   {"column", lattice(1, 40)},
                                                   {"circle", circle(325)},
                                                   {"growing", growing(60, 1.5)},
                                                   {"growing little", growing(80, 1.001)}};
  Points slanted;
  for (int i = 0; i < 40; ++i) slanted.push_back({3.0 * i * i, 7.0 * i * i});
  sets.emplace_back("on a slanted line", slanted);
  Points circles = circle(65);
  for (const auto& p : circle(65)) circles.push_back({p.x + 1000, p.y}), circles.push_back({p.x, p.y / 1024});
  sets.emplace_back("circles", circles);
  const std::uint64_t seeds = is_full_run() ? 100 : 10;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    sets.emplace_back("uniform", uniform(5 + 9 * seed % 90, seed));
    sets.emplace_back("planted", planted(5 + 9 * seed % 90, seed));
  }
  for (auto& [name, points] : sets) points = shuffled(points, 5);
  return sets;
}

template <class Geometry>
double distance(const std::vector<typename Geometry::Point>& points, std::size_t i, std::size_t j) {
  return internal::length_of(Geometry::difference(points[i], points[j]));
}

/// The lengths of the edges of a minimum spanning tree, which are those of all. By Prim's algorithm.
template <class Geometry>
std::vector<double> lengths_by_prim(const std::vector<typename Geometry::Point>& points) {
  std::vector<double> lengths, nearest(points.size(), INFINITY);
  std::vector<bool> is_in(points.size(), false);
  for (std::size_t next = 0; next < points.size();) {
    is_in[next] = true;
    std::size_t least = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (is_in[i]) continue;
      nearest[i] = std::min(nearest[i], distance<Geometry>(points, next, i));
      if (least == points.size() || nearest[i] < nearest[least]) least = i;
    }
    if (least < points.size()) lengths.push_back(nearest[least]);
    next = least;
  }
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

/// The sets of several points that distances up to one of the given lengths link.
template <class Geometry>
std::set<Set> sets_by_all_pairs(const std::vector<typename Geometry::Point>& points,
                                const std::vector<double>& lengths) {
  std::set<Set> sets;
  for (const double limit : lengths) {
    std::vector<bool> is_done(points.size(), false);
    for (std::size_t start = 0; start < points.size(); ++start) {
      if (is_done[start]) continue;
      std::vector<std::size_t> open{start};
      is_done[start] = true;
      Set set;
      while (!open.empty()) {
        const std::size_t i = open.back();
        open.pop_back();
        set.insert(static_cast<std::uint32_t>(i));
        for (std::size_t j = 0; j < points.size(); ++j)
          if (!is_done[j] && distance<Geometry>(points, i, j) <= limit) is_done[j] = true, open.push_back(j);
      }
      if (set.size() > 1) sets.insert(set);
    }
  }
  return sets;
}

/// The points of the set of each link, as chains say.
std::vector<Set> sets_of_links(const Single_linkage& linkage) {
  std::vector<Set> sets(linkage.number_of_links());
  const auto add = [&](Set& set, Component_id c) {
    const Link_id last = linkage.last_of_chain(c);
    if (last.is_valid())
      set.insert(sets[std::size_t(last)].begin(), sets[std::size_t(last)].end());
    else
      set.insert(linkage.graph().point(Vertex_id(c.value())));
  };
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const Link_id f(i);
    if (!linkage.is_first_of_chain(f)) sets[i] = sets[i - 1];
    add(sets[i], linkage.joining(f));
    if (linkage.joined_root(f).is_valid()) add(sets[i], linkage.joined_root(f));
  }
  return sets;
}

template <class Geometry>
void check_box(const std::vector<typename Geometry::Point>& points, const Set& set,
               const internal::Cluster_box& box) {
  for (const std::uint32_t side : {box.left, box.right, box.bottom, box.top}) REQUIRE(set.count(side) == 1);
  for (const std::uint32_t i : set) {
    REQUIRE_FALSE(points[i].x < points[box.left].x);
    REQUIRE_FALSE(points[box.right].x < points[i].x);
    REQUIRE_FALSE(points[i].y < points[box.bottom].y);
    REQUIRE_FALSE(points[box.top].y < points[i].y);
  }
}

template <class Tag, class Geometry>
void check_linkage(const std::vector<typename Geometry::Point>& points) {
  const Measured_graph graph = internal::neighbor_edges<Tag, Geometry>(points);
  const Single_linkage linkage = Single_linkage::of<Tag>(graph);
  const std::vector<double> expected = lengths_by_prim<Geometry>(points);
  std::vector<double> lengths;
  for (std::size_t f = 0; f < linkage.number_of_links(); ++f) lengths.push_back(linkage.length(Link_id(f)));
  std::sort(lengths.begin(), lengths.end());
  REQUIRE(lengths == expected);

  const std::vector<Set> sets = sets_of_links(linkage);
  const auto boxes = internal::Linkage_boxes<Tag, Geometry>(points, linkage).run();
  std::set<Set> linked;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const Link_id f(i);
    REQUIRE(linkage.distance(f) >= linkage.length(f));
    if (linkage.distance(f) == linkage.length(f)) continue; // a tie: others of this length come on top
    REQUIRE(linked.insert(sets[i]).second);
    check_box<Geometry>(points, sets[i], boxes[f]);
    double rest = INFINITY;
    for (const std::uint32_t p : sets[i])
      for (std::size_t q = 0; q < points.size(); ++q)
        if (sets[i].count(static_cast<std::uint32_t>(q)) == 0)
          rest = std::min(rest, distance<Geometry>(points, p, q));
    REQUIRE(linkage.distance(f) == rest);
  }
  REQUIRE(linked == sets_by_all_pairs<Geometry>(points, expected));
}

using Edge = std::tuple<double, std::uint32_t, std::uint32_t>;

std::vector<Edge> edges_of(const Measured_graph& graph) {
  std::vector<Edge> edges;
  for (const Measured_edge& e : graph.edges) {
    const std::uint32_t a = graph.point(e.a), b = graph.point(e.b);
    edges.emplace_back(e.length, std::min(a, b), std::max(a, b));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

} // namespace

TEST_CASE("Links are those of a minimum spanning tree, and their sets those of single linkage",
          "[clusters]") {
  for (const auto& [name, points] : small_sets()) {
    CAPTURE(name, points.size());
    check_linkage<Sequential_tag, Doubles>(points);
    check_linkage<Small_blocks_tag, Doubles>(points);
    std::vector<Integers::Point> integers;
    std::vector<Exact::Point> exact;
    for (const auto& p : points) {
      integers.push_back({static_cast<std::int64_t>(p.x * 1024), static_cast<std::int64_t>(p.y * 1024)});
      exact.push_back({Exact::Coordinate(p.x), Exact::Coordinate(p.y)});
    }
    if (name == "lattice" || name == "circle" || name == "on a slanted line")
      check_linkage<Sequential_tag, Integers>(integers);
    if (points.size() < 30) check_linkage<Sequential_tag, Exact>(exact);
  }
}

TEST_CASE("Edges between neighbors do not depend on blocks", "[clusters]") {
  for (const auto& [name, points] : small_sets()) {
    CAPTURE(name, points.size());
    const auto edges = edges_of(internal::neighbor_edges<Sequential_tag, Doubles>(points));
    REQUIRE(edges == edges_of(internal::neighbor_edges<Small_blocks_tag, Doubles>(points)));
    REQUIRE(edges.size() <= 3 * points.size());
  }
}

TEST_CASE("Places are in order at all scales", "[clusters]") {
  // Points along a curve that gets ever finer, in any order, are mostly next to those next to them on the curve.
  Points points;
  const std::size_t n = 4000;
  for (std::size_t k = 0; k < n; ++k)
    points.push_back({std::ldexp(1 + double(k % 10) / 10, -int(k / 10)), 0.0});
  const auto order = internal::order_of_places<Sequential_tag, Doubles>(shuffled(points, 3));
  const Points in_any_order = shuffled(points, 3);
  std::set<std::uint32_t> all(order.begin(), order.end());
  REQUIRE(all.size() == n);
  std::size_t jumps = 0;
  for (std::size_t i = 1; i < n; ++i) {
    const double a = in_any_order[order[i - 1]].x, b = in_any_order[order[i]].x;
    jumps += std::max(a, b) > 2.5 * std::min(a, b) ? 1 : 0;
  }
  CHECK(jumps < n / 4);
}

TEST_CASE("Trees of clusters are the same for any number of threads", "[clusters][threads]") {
#ifdef CGAL_LINKED_WITH_TBB
  for (const Points& points :
       {shuffled(planted(20000, 7), 1), shuffled(lattice(150, 150), 2), shuffled(lattice(20000, 1), 2)}) {
    const auto expected = internal::find_clusters<Sequential_tag, Doubles>(points, 100);
    for (const std::size_t threads : numbers_of_threads()) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      const auto tree = internal::find_clusters<CGAL::Parallel_tag, Doubles>(points, 100);
      REQUIRE(tree.points == expected.points);
      REQUIRE(tree.nearest == expected.nearest);
      REQUIRE(tree.clusters.size() == expected.clusters.size());
      for (std::size_t k = 0; k < tree.clusters.size(); ++k) {
        const auto &c = tree.clusters[k], &d = expected.clusters[k];
        REQUIRE(std::tie(c.parent, c.width, c.distance, c.least_point, c.first_child, c.end_child) ==
                std::tie(d.parent, d.width, d.distance, d.least_point, d.first_child, d.end_child));
        REQUIRE(std::tie(c.first_point, c.end_point, c.source, c.box.left, c.box.top) ==
                std::tie(d.first_point, d.end_point, d.source, d.box.left, d.box.top));
      }
    }
  }
#endif
}

TEST_CASE("Spanning trees and clusters take O(log n) rounds", "[clusters]") {
  const auto family = [](int number, std::size_t n) {
    switch (number) {
    case 0:
      return uniform(n, n);
    case 1:
      return planted(n, n);
    case 2:
      return growing(n, 1.0001); // one chain of all points, and a way of n exits to its root
    default:
      return lattice(static_cast<int>(n), 1);
    }
  };
  for (int number = 0; number < 4; ++number)
    for (const std::size_t n : {256u, 1024u, 4096u, 16384u}) {
      if (n > 4096 && !is_full_run() && number != 2) continue;
      const Points points = shuffled(family(number, n), 1);
      const double log_n = std::log2(static_cast<double>(n));
      const Measured_graph graph = internal::neighbor_edges<Counted_tag, Doubles>(points);
      std::size_t rounds = 0;
      const std::size_t links =
          Round_counter::instance()
              .count([&] { rounds = Single_linkage::of<Counted_tag>(graph).components().number_of_rounds(); })
              .steps;
      const std::size_t all = Round_counter::instance()
                                  .count([&] { internal::find_clusters<Counted_tag, Doubles>(points, 100); })
                                  .steps;
      CAPTURE(number, n, rounds, links, all);
      CHECK(static_cast<double>(rounds) <= log_n + 1);
      // Each round leaves half of the components, but where it leaves more, less has to be followed.
      CHECK(static_cast<double>(links) <= 12 * log_n + 20);
      CHECK(static_cast<double>(all) <= 20 * log_n + 60);
    }
}

} // namespace test_single_linkage
