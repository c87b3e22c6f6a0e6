// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Vertex-edge neighbors against brute force with exact intersections: every segment for every ray and
// sector.

#include "catch.h"
#include "numbers_of_threads.h"
#include "pslg_test_tools.h"
#include "random_pslg.h"
#include "vertex_edge_brute_force.h"
#include "vertex_edge_checks.h"

#include <CGAL/Quadtree_vertex_edge_neighbors_2.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace test_quadtree_vertex_edge_neighbors_2 {

using namespace vertex_edge_test;
using CGAL::Quadtree_vertex_edge_neighbors_2;
using CGAL::Sector_neighbor_2;
using CGAL::Vertex_edge_neighbor_2;
using CGAL::Vertex_edge_neighbors_options_2;

namespace {

/// All sectors below 180 degrees between two segments at v, neighbors around v or not.
template <class Neighbors, class Pslg>
std::size_t check_sectors(const Neighbors& neighbors, const Brute_force& brute_force, const Pslg& pslg,
                          Vertex_index v) {
  std::vector<std::pair<Segment_index, Vertex_index>> legs;
  for (std::size_t i = 0; i < pslg.segments.size() && legs.size() < 12; ++i)
    for (int k = 0; k < 2; ++k)
      if (brute_force.point(pslg.segments[i][std::size_t(k)]) == brute_force.point(v))
        legs.emplace_back(Segment_index(i), pslg.segments[i][std::size_t(1 - k)]);
  std::size_t n = 0;
  for (const auto& r : legs)
    for (const auto& l : legs) {
      if (CGAL::orientation(brute_force.point(v), brute_force.point(r.second), brute_force.point(l.second)) !=
          CGAL::LEFT_TURN)
        continue;
      ++n;
      const Nearest expected = brute_force.nearest_in_sector(v, r.second, l.second);
      const Sector_neighbor_2 found = neighbors.nearest_in_sector(v, r.first, l.first);
      CAPTURE(v.value(), r.first.value(), l.first.value(), found.distance, expected.distance());
      REQUIRE(found.vertex == expected.vertex);
      REQUIRE(found.segment == expected.segment);
      check_distance(found.distance, expected);
      if (!found.exists() || found.distance == 0) continue;
      REQUIRE(neighbors.clear_radius(v, r.first, l.first, found.distance * 0.99) == found.distance * 0.99);
      REQUIRE_FALSE(neighbors.nearest_in_sector(v, r.first, l.first, found.distance * 0.99).exists());
      REQUIRE(neighbors.clear_radius(v, r.first, l.first, found.distance * 1.01) == found.distance);
    }
  return n;
}

template <class Traits>
std::size_t check_graph(const random_pslg::Pslg& graph, std::size_t vertices) {
  const auto pslg = converted<Traits>(graph);
  const Brute_force brute_force(pslg);
  const Quadtree_vertex_edge_neighbors_2<Traits> neighbors(pslg);
  std::size_t sectors = 0;
  for (const Vertex_index v : sample(pslg, vertices)) {
    check_rays(neighbors, brute_force, v);
    check_lemma_5(neighbors, brute_force, v);
    sectors += check_sectors(neighbors, brute_force, pslg, v);
  }
  return sectors;
}

template <class Traits>
void check_families(std::uint64_t seeds, std::size_t vertices) {
  std::size_t sectors = 0;
  for (const auto& family : random_pslg::families())
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      CAPTURE(family.name, seed);
      sectors += check_graph<Traits>(family.make(seed), vertices);
    }
  REQUIRE(sectors > 50);
}

using pslg_test::make_pslg;
using Neighbors = Quadtree_vertex_edge_neighbors_2<Filtered_traits>;

void check_hit(const Vertex_edge_neighbor_2& hit, std::size_t segment, double distance) {
  REQUIRE(hit.segment == Segment_index(segment));
  REQUIRE(hit.distance == distance);
}

} // namespace

TEST_CASE("rays and sectors against brute force, doubles", "[neighbors]") {
  check_families<Filtered_traits>(is_full_run() ? 40 : 3, is_full_run() ? 200 : 15);
}
TEST_CASE("rays and sectors against brute force, exact numbers", "[neighbors]") {
  check_families<Exact_traits>(is_full_run() ? 20 : 2, is_full_run() ? 100 : 8);
}
TEST_CASE("rays and sectors against brute force, 32-bit words", "[neighbors]") {
  check_families<Fixed_32_traits>(is_full_run() ? 20 : 2, is_full_run() ? 100 : 12);
}
TEST_CASE("rays and sectors against brute force, 64-bit words", "[neighbors]") {
  check_families<Fixed_64_traits>(is_full_run() ? 20 : 2, is_full_run() ? 100 : 12);
}

TEST_CASE("what a ray hits: ends, segments along it, ties", "[neighbors]") {
  // Segments 0 and 1 meet in (2, 0); 2 lies on the ray to the east; 3 and 4 cross at (0, 1).
  const auto pslg = make_pslg<double>(
      {{0, 0}, {2, 0}, {3, 1}, {2, -1}, {4, 0}, {5, 0}, {-1, 0}, {1, 2}, {1, 0.5}, {-1, 1.5}},
      {{1, 2}, {3, 1}, {4, 5}, {6, 7}, {8, 9}});
  const Neighbors neighbors(pslg);
  const Vertex_index origin(0);
  check_hit(neighbors.first_hit(origin, Direction::EAST), 0, 2);
  check_hit(neighbors.first_hit(origin, Direction::NORTH), 3, 1);
  check_hit(neighbors.first_hit(origin, Direction::WEST), 3, 1);
  REQUIRE_FALSE(neighbors.first_hit(origin, Direction::SOUTH).exists());
  REQUIRE(neighbors.first_hit(origin, Direction::SOUTH).distance == infinity);
  check_hit(neighbors.nearest_hit(origin), 3, 1);
  check_hit(neighbors.first_hit(Vertex_index(1), Direction::EAST), 2, 2);
  check_hit(neighbors.first_hit(Vertex_index(5), Direction::WEST), 0, 3);
}

TEST_CASE("vertices on segments and equal vertices", "[neighbors]") {
  // Vertex 2 is inside segments 0 and 1 (which overlap), 3 equals vertex 0, 4 equals 2 and has a segment.
  const auto pslg = make_pslg<double>({{0, 0}, {4, 0}, {1, 0}, {0, 0}, {1, 0}, {1, 3}, {3, 0}},
                                      {{1, 6}, {0, 1}, {3, 6}, {4, 5}});
  const Neighbors neighbors(pslg);
  for (const Direction d : axis_directions)
    for (const std::size_t v : {2, 4}) check_hit(neighbors.first_hit(Vertex_index(v), d), 1, 0);
  for (const Direction d : axis_directions)
    for (const auto& pair : {std::make_pair(0, 3), std::make_pair(2, 4)})
      REQUIRE(neighbors.first_hit(Vertex_index(std::size_t(pair.first)), d).segment ==
              neighbors.first_hit(Vertex_index(std::size_t(pair.second)), d).segment);
  check_hit(neighbors.first_hit(Vertex_index(0), Direction::EAST), 3, 1);
  check_hit(neighbors.first_hit(Vertex_index(3), Direction::EAST), 3, 1);
}

TEST_CASE("graphs of almost nothing", "[neighbors]") {
  for (std::size_t n : {0, 1, 5}) {
    random_pslg::Pslg pslg;
    for (std::size_t i = 0; i < n; ++i)
      pslg.add_vertex({static_cast<double>(i % 4), static_cast<double>(i / 2)});
    const Neighbors neighbors(pslg);
    for (std::size_t i = 0; i < n; ++i) {
      REQUIRE_FALSE(neighbors.nearest_hit(Vertex_index(i)).exists());
      REQUIRE(neighbors.nearest_hit(Vertex_index(i)).distance == infinity);
    }
  }
  // A segment between equal vertices is a point.
  const auto point = make_pslg<double>({{0, 0}, {2, 0}, {2, 0}}, {{1, 2}});
  const Neighbors neighbors(point);
  check_hit(neighbors.nearest_hit(Vertex_index(0)), 0, 2);
  REQUIRE_FALSE(neighbors.nearest_hit(Vertex_index(1)).exists());
}

TEST_CASE("lattices of segments have ties everywhere", "[neighbors]") {
  const auto pslg = lattice_of_segments();
  check_graph<Filtered_traits>(pslg, 1000);
  check_graph<Exact_traits>(pslg, 20);
  check_graph<Fixed_32_traits>(pslg, 1000);
  check_graph<Fixed_64_traits>(pslg, 1000);
}

TEST_CASE("long segments that cross and share leaves", "[neighbors]") {
  const auto pslg = long_crossing_segments();
  check_graph<Filtered_traits>(pslg, 1000);
  check_graph<Fixed_64_traits>(pslg, 60);
}

TEST_CASE("vertices that only exact numbers tell apart", "[neighbors]") {
  const auto pslg = wedges_of_tiny_size();
  const Brute_force brute_force(pslg);
  const Quadtree_vertex_edge_neighbors_2<Exact_traits> neighbors(pslg);
  for (const Vertex_index v : sample(pslg, is_full_run() ? 100 : 30)) {
    for (const Direction d : axis_directions) {
      const Nearest expected = brute_force.first_hit(v, d);
      const Vertex_edge_neighbor_2 hit = neighbors.first_hit(v, d);
      REQUIRE(hit.segment == expected.segment);
      if (hit.exists()) REQUIRE(hit.distance > 0);
    }
  }
  // The second segment at vertex 8 lies in the sector between the first and the third one's far neighbors.
  const double tiny = neighbors.clear_radius(Vertex_index(8), Segment_index(9), Segment_index(8));
  const Nearest expected = brute_force.nearest_in_sector(Vertex_index(8), Vertex_index(10), Vertex_index(9));
  REQUIRE(expected.exists());
  const FT found(tiny);
  REQUIRE(found * found <= expected.squared_distance * FT(1 + 1e-11));
  REQUIRE(found * found >= expected.squared_distance * FT(1 - 1e-11));
}

TEST_CASE("points finer than the corners of leaves", "[neighbors]") {
  const auto pslg = points_finer_than_leaves();
  check_graph<Filtered_traits>(pslg, 1000);
}

TEST_CASE("nothing depends on threads or on options", "[neighbors]") {
  const auto pslg = read_map("us_states_10m.poly.gz");
  const Neighbors neighbors(pslg);
  const std::vector<double> expected = answers(neighbors);
  const auto check = [&](std::size_t max_segments, int refinements) {
    const Neighbors other(
        pslg,
        Vertex_edge_neighbors_options_2().max_segments_per_leaf(max_segments).max_refinements(refinements));
    REQUIRE(answers(other) == expected);
  };
  check(8, 3);
  check(1, 4);
  check(0, 1);
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t threads : numbers_of_threads()) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Quadtree_vertex_edge_neighbors_2<Filtered_traits, CGAL::Parallel_tag> parallel(pslg);
    REQUIRE(answers(parallel) == expected);
    REQUIRE(parallel.number_of_listed_segments() == neighbors.number_of_listed_segments());
  }
#endif
}

TEST_CASE("maps against brute force", "[neighbors]") {
  for (const char* name : {"us_states_10m.poly.gz", "gshhg_aegean_h.poly.gz"}) {
    CAPTURE(name);
    const auto pslg = read_map(name);
    const std::size_t n = is_full_run() ? 300 : 3;
    REQUIRE(check_graph<Filtered_traits>(pslg, n) >= n);
  }
}

TEST_CASE("the clear radius of a corner", "[neighbors]") {
  // A right angle with legs of length 10, and in turn what is to be found in it.
  const auto radius = [](double px, double py, double qx, double qy) {
    const auto pslg =
        make_pslg<double>({{0, 0}, {10, 0}, {0, 10}, {px, py}, {qx, qy}}, {{0, 1}, {0, 2}, {3, 4}});
    return Neighbors(pslg).clear_radius(Vertex_index(0), Segment_index(0), Segment_index(1));
  };
  CHECK(radius(3, 4, 30, 40) == Approx(5));               // a vertex
  CHECK(radius(-5, 15, 15, -5) == Approx(std::sqrt(50))); // the foot of a perpendicular
  CHECK(radius(-2, 5, 20, 27) == Approx(7));              // where a segment comes in over the leg
  CHECK(radius(10, 0, 30, 20) == Approx(10));             // at the end of a leg
  CHECK(radius(10, 0, 20, 0) == infinity);                // only on the sides of the sector
  CHECK(radius(-1, -1, -2, -5) == infinity);              // outside
  CHECK(radius(-3, -3, 2, 2) == 0);                       // through the apex
}

} // namespace test_quadtree_vertex_edge_neighbors_2
