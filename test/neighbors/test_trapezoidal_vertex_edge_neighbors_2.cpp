// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Vertex-edge neighbors by trapezoidal decompositions against brute force with exact intersections, and against
// those by the quadtree.

#include "catch.h"
#include "numbers_of_threads.h"
#include "pslg_test_tools.h"
#include "random_pslg.h"
#include "random_pslg_shapes.h"
#include "vertex_edge_brute_force.h"
#include "vertex_edge_checks.h"

#include <CGAL/Quadtree_vertex_edge_neighbors_2.h>
#include <CGAL/Trapezoidal_vertex_edge_neighbors_2.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace test_trapezoidal_vertex_edge_neighbors_2 {

using namespace vertex_edge_test;
using CGAL::Quadtree_vertex_edge_neighbors_2;
using CGAL::Trapezoidal_vertex_edge_neighbors_2;
using CGAL::Vertex_edge_neighbor_2;
using pslg_test::make_pslg;

namespace {

using Neighbors = Trapezoidal_vertex_edge_neighbors_2<Filtered_traits>;

/// Brute force at some vertices, and the other model and the parallel run at all.
template <class Traits>
void check_pslg(const CGAL::Pslg_2<typename Traits::Point_2>& pslg, std::size_t vertices) {
  const Trapezoidal_vertex_edge_neighbors_2<Traits> neighbors(pslg);
  const Brute_force brute_force(pslg);
  for (const Vertex_index v : sample(pslg, vertices)) {
    check_rays(neighbors, brute_force, v);
    check_lemma_5(neighbors, brute_force, v);
  }
  const std::vector<double> expected = answers(neighbors);
  REQUIRE(expected == answers(Quadtree_vertex_edge_neighbors_2<Traits>(pslg)));
  REQUIRE(expected == answers(Trapezoidal_vertex_edge_neighbors_2<Traits, CGAL::Parallel_tag>(pslg)));
}

template <class Traits>
void check_graph(const random_pslg::Pslg& graph, std::size_t vertices) {
  check_pslg<Traits>(converted<Traits>(graph), vertices);
}

void check_graph_with_all_traits(const random_pslg::Pslg& graph, std::size_t vertices) {
  check_graph<Filtered_traits>(graph, vertices);
  check_graph<Exact_traits>(graph, std::min<std::size_t>(vertices, 20));
  check_graph<Fixed_32_traits>(graph, vertices);
  check_graph<Fixed_64_traits>(graph, vertices);
}

template <class Traits>
void check_families(std::uint64_t seeds, std::size_t vertices) {
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      CAPTURE(family.name, seed);
      check_graph<Traits>(family.make(seed), vertices);
    }
}

/// Random segments between the points of a small lattice: nothing is in general position.
random_pslg::Pslg random_lattice_segments(std::uint64_t seed, int size, int vertices, int segments) {
  random_pslg::Random random(seed);
  random_pslg::Pslg pslg;
  for (int i = 0; i < vertices; ++i)
    pslg.add_vertex(
        {static_cast<double>(random.integer(0, size)), static_cast<double>(random.integer(0, size))});
  const auto vertex = [&] { return Vertex_index(static_cast<std::size_t>(random.integer(0, vertices - 1))); };
  for (int i = 0; i < segments; ++i) {
    const Vertex_index a = vertex(), b = vertex();
    pslg.add_segment(a, b);
  }
  return pslg;
}

/// Segments on few lines, many of which overlap.
random_pslg::Pslg overlapping_segments(std::uint64_t seed) {
  random_pslg::Random random(seed);
  random_pslg::Pslg pslg;
  const int directions[5][2] = {{1, 0}, {0, 1}, {1, 1}, {2, -1}, {1, 3}};
  for (int i = 0; i < 30; ++i) {
    const auto& d = directions[random.integer(0, 4)];
    const int offset = random.integer(0, 1), from = random.integer(-5, 5), to = random.integer(-5, 5);
    for (const int k : {from, to})
      pslg.add_vertex({static_cast<double>(k * d[0] + offset), static_cast<double>(k * d[1])});
    pslg.add_segment(Vertex_index(std::size_t(2 * i)), Vertex_index(std::size_t(2 * i + 1)));
  }
  return pslg;
}

void check_hit(const Vertex_edge_neighbor_2& hit, std::size_t segment, double distance) {
  REQUIRE(hit.segment == Segment_index(segment));
  REQUIRE(hit.distance == distance);
}

void check_no_hit(const Vertex_edge_neighbor_2& hit) {
  REQUIRE_FALSE(hit.exists());
  REQUIRE(hit.distance == infinity);
}

} // namespace

TEST_CASE("trapezoids against brute force, doubles", "[trapezoids]") {
  check_families<Filtered_traits>(is_full_run() ? 40 : 2, is_full_run() ? 200 : 10);
}
TEST_CASE("trapezoids against brute force, exact numbers", "[trapezoids]") {
  check_families<Exact_traits>(is_full_run() ? 10 : 1, is_full_run() ? 100 : 5);
}
TEST_CASE("trapezoids against brute force, 32-bit words", "[trapezoids]") {
  check_families<Fixed_32_traits>(is_full_run() ? 20 : 1, is_full_run() ? 100 : 10);
}
TEST_CASE("trapezoids against brute force, 64-bit words", "[trapezoids]") {
  check_families<Fixed_64_traits>(is_full_run() ? 20 : 1, is_full_run() ? 100 : 10);
}

TEST_CASE("trapezoids: what a ray hits", "[trapezoids]") {
  // Segments 0 and 1 meet in (2, 0); 2 lies on the ray to the east; 3 and 4 cross at (0, 1).
  const auto pslg = make_pslg<double>(
      {{0, 0}, {2, 0}, {3, 1}, {2, -1}, {4, 0}, {5, 0}, {-1, 0}, {1, 2}, {1, 0.5}, {-1, 1.5}},
      {{1, 2}, {3, 1}, {4, 5}, {6, 7}, {8, 9}});
  const Neighbors neighbors(pslg);
  const Vertex_index origin(0);
  check_hit(neighbors.first_hit(origin, Direction::EAST), 0, 2);
  check_hit(neighbors.first_hit(origin, Direction::NORTH), 3, 1);
  check_hit(neighbors.first_hit(origin, Direction::WEST), 3, 1);
  check_no_hit(neighbors.first_hit(origin, Direction::SOUTH));
  check_hit(neighbors.nearest_hit(origin), 3, 1);
  check_hit(neighbors.first_hit(Vertex_index(1), Direction::EAST), 2, 2);
  check_hit(neighbors.first_hit(Vertex_index(5), Direction::WEST), 0, 3);
  check_graph_with_all_traits(pslg, 100);
}

TEST_CASE("trapezoids: segments along the rays", "[trapezoids]") {
  // A stack of vertical segments with isolated vertices inside, below and above, and horizontal ones at its top.
  const auto pslg =
      make_pslg<double>({{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 5}, {0, 6}, {0, 8}, {-1, 8}, {1, 8}, {0, -2}},
                        {{8, 6}, {1, 3}, {4, 6}, {7, 6}});
  const Neighbors neighbors(pslg);
  check_hit(neighbors.first_hit(Vertex_index(9), Direction::NORTH), 1, 3);
  check_hit(neighbors.first_hit(Vertex_index(0), Direction::NORTH), 1, 1);
  check_no_hit(neighbors.first_hit(Vertex_index(0), Direction::SOUTH));
  // Beyond the end of the incident segment, past the vertex that is inside it.
  check_hit(neighbors.first_hit(Vertex_index(1), Direction::NORTH), 2, 4);
  check_hit(neighbors.first_hit(Vertex_index(3), Direction::NORTH), 2, 2);
  check_no_hit(neighbors.first_hit(Vertex_index(3), Direction::SOUTH));
  for (const Direction d : axis_directions) check_hit(neighbors.first_hit(Vertex_index(2), d), 1, 0);
  for (const Direction d : axis_directions) check_hit(neighbors.first_hit(Vertex_index(5), d), 2, 0);
  // Other segments at the far end of the incident one.
  check_hit(neighbors.first_hit(Vertex_index(4), Direction::NORTH), 0, 3);
  check_hit(neighbors.first_hit(Vertex_index(6), Direction::SOUTH), 1, 5);
  check_hit(neighbors.first_hit(Vertex_index(7), Direction::EAST), 0, 1);
  check_graph_with_all_traits(pslg, 100);
}

TEST_CASE("trapezoids: vertices on segments and equal vertices", "[trapezoids]") {
  // Vertex 2 is inside segments 0 and 1 (which overlap), 3 equals vertex 0, 4 equals 2 and has a segment.
  const auto pslg = make_pslg<double>({{0, 0}, {4, 0}, {1, 0}, {0, 0}, {1, 0}, {1, 3}, {3, 0}},
                                      {{1, 6}, {0, 1}, {3, 6}, {4, 5}});
  const Neighbors neighbors(pslg);
  for (const Direction d : axis_directions)
    for (const std::size_t v : {2, 4}) check_hit(neighbors.first_hit(Vertex_index(v), d), 1, 0);
  check_hit(neighbors.first_hit(Vertex_index(0), Direction::EAST), 3, 1);
  check_hit(neighbors.first_hit(Vertex_index(3), Direction::EAST), 3, 1);
  check_graph_with_all_traits(pslg, 100);
}

TEST_CASE("trapezoids: overlapping segments hide none that pass", "[trapezoids]") {
  // At vertex 1 segment 0 ends and segment 1 begins, and segment 2 passes beneath both.
  const auto pslg = make_pslg<double>({{0, 0}, {2, 1}, {4, 2}, {-2, -1}, {6, 3}}, {{0, 1}, {1, 2}, {3, 4}});
  const Neighbors neighbors(pslg);
  for (const Direction d : axis_directions) check_hit(neighbors.first_hit(Vertex_index(1), d), 2, 0);
  check_graph_with_all_traits(pslg, 100);
  for (std::uint64_t seed = 1; seed <= (is_full_run() ? 300 : 12); ++seed) {
    CAPTURE(seed);
    check_graph<Filtered_traits>(overlapping_segments(seed), 100);
  }
  check_graph_with_all_traits(overlapping_segments(7), 100);
}

TEST_CASE("trapezoids: graphs of almost nothing", "[trapezoids]") {
  for (std::size_t n : {0, 1, 5}) {
    random_pslg::Pslg pslg;
    for (std::size_t i = 0; i < n; ++i)
      pslg.add_vertex({static_cast<double>(i % 4), static_cast<double>(i / 2)});
    const Neighbors neighbors(pslg);
    for (std::size_t i = 0; i < n; ++i) check_no_hit(neighbors.nearest_hit(Vertex_index(i)));
  }
  // A segment between equal vertices is a point.
  const auto point = make_pslg<double>({{0, 0}, {2, 0}, {2, 0}, {5, 0}}, {{1, 2}});
  const Neighbors neighbors(point);
  check_hit(neighbors.nearest_hit(Vertex_index(0)), 0, 2);
  check_hit(neighbors.first_hit(Vertex_index(3), Direction::WEST), 0, 3);
  check_no_hit(neighbors.nearest_hit(Vertex_index(1)));
  // One segment along each axis, one across, and one twice.
  check_graph_with_all_traits(make_pslg<double>({{0, 0}, {0, 2}}, {{0, 1}}), 2);
  check_graph_with_all_traits(make_pslg<double>({{0, 0}, {2, 0}}, {{0, 1}}), 2);
  check_graph_with_all_traits(make_pslg<double>({{0, 0}, {2, 1}}, {{0, 1}}), 2);
  check_graph_with_all_traits(make_pslg<double>({{0, 0}, {2, 1}, {1, 0}, {1, 2}}, {{0, 1}, {1, 0}}), 4);
}

TEST_CASE("trapezoids: lattices have ties everywhere", "[trapezoids]") {
  check_graph_with_all_traits(lattice_of_segments(), 1000);
  for (std::uint64_t seed = 1; seed <= (is_full_run() ? 500 : 40); ++seed) {
    CAPTURE(seed);
    const int size = 2 + static_cast<int>(seed % 5);
    check_graph<Filtered_traits>(random_lattice_segments(seed, size, 3 * size, 2 * size), 100);
  }
  check_graph_with_all_traits(random_lattice_segments(1, 6, 30, 20), 100);
}

TEST_CASE("trapezoids: long segments that cross", "[trapezoids]") {
  const auto pslg = long_crossing_segments();
  check_graph<Filtered_traits>(pslg, is_full_run() ? 1000 : 40);
  check_graph<Fixed_64_traits>(pslg, 20);
}

TEST_CASE("trapezoids: vertices that only exact numbers tell apart", "[trapezoids]") {
  const auto pslg = wedges_of_tiny_size();
  const Brute_force brute_force(pslg);
  const Trapezoidal_vertex_edge_neighbors_2<Exact_traits> neighbors(pslg);
  for (const Vertex_index v : sample(pslg, 100))
    for (const Direction d : axis_directions)
      REQUIRE(neighbors.first_hit(v, d).segment == brute_force.first_hit(v, d).segment);
  check_graph<Filtered_traits>(points_finer_than_leaves(), 1000);
}

TEST_CASE("trapezoids: slabs meet without a seam, whatever the threads", "[trapezoids]") {
  // Long lines of vertices are cut by slabs, too.
  random_pslg::Random random(11);
  random_pslg::Pslg pslg;
  const std::size_t n = is_full_run() ? 4000 : 2500; // of several slabs
  for (std::size_t i = 0; i < n; ++i)
    pslg.add_vertex(
        {static_cast<double>(random.integer(0, 4)), static_cast<double>(random.integer(0, 3000))});
  for (std::size_t i = 0; i + 1 < n; i += 20) pslg.add_segment(Vertex_index(i), Vertex_index(i + 1));
  check_graph<Filtered_traits>(pslg, is_full_run() ? 300 : 10);

  const auto map = read_map("us_states_10m.poly.gz");
  check_graph<Filtered_traits>(map, is_full_run() ? 300 : 3);
#ifdef CGAL_LINKED_WITH_TBB
  const std::vector<double> expected = answers(Neighbors(map));
  for (const std::size_t threads : numbers_of_threads()) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    REQUIRE(answers(Trapezoidal_vertex_edge_neighbors_2<Filtered_traits, CGAL::Parallel_tag>(map)) ==
            expected);
  }
#endif
}

TEST_CASE("trapezoids: maps", "[trapezoids][.slow]") {
  for (const char* name : {"gshhg_aegean_h.poly.gz", "gshhg_norway_f.poly.gz"}) {
    CAPTURE(name);
    check_graph<Filtered_traits>(read_map(name), 300);
  }
}

} // namespace test_trapezoidal_vertex_edge_neighbors_2
