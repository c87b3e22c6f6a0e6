// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Meshes of points from tiles to the end in blocks of any size, inputs of them, and what is checked of them.

#ifndef QUADTREE_MESH_2_TEST_SITE_MESH_TOOLS_H
#define QUADTREE_MESH_2_TEST_SITE_MESH_TOOLS_H

#include "catch.h"
#include "cluster_test_tools.h"
#include "numbers_of_threads.h"
#include "random_numbers.h"
#include "ring_mesh_checks.h"

#include <CGAL/Quadtree_mesh_2/internal/clusters/find_clusters.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/frame_clusters.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Ring_blocks.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Site_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Site_mesh_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_forest.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <set>
#include <string>
#include <vector>

/// A concurrency tag that cuts small meshes into blocks.
struct Tiny_rings_tag {};

/// In which order it works on them.
enum class Order_of_blocks { FORWARD, BACKWARD, PARALLEL };
inline Order_of_blocks order_of_blocks = Order_of_blocks::FORWARD;

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <>
struct Ring_block_sizes<Tiny_rings_tag> {
  static constexpr std::size_t vertices = 150;
};

template <>
struct Tile_run_sizes<Tiny_rings_tag> {
  static constexpr std::size_t leaves = 500;
};

template <>
struct Executor<Tiny_rings_tag> {
  template <class F>
  static void run(std::size_t n, const F& f) {
    if (order_of_blocks == Order_of_blocks::PARALLEL) return Executor<Parallel_tag>::run(n, f);
    const bool is_forward = order_of_blocks == Order_of_blocks::FORWARD;
    for (std::size_t i = 0; i < n; ++i) f(is_forward ? i : n - 1 - i);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

namespace site_mesh_test {

using namespace ring_test;
using internal::Coarsening_effort;
using internal::Framed_clusters;
using internal::Grid_frame;
using internal::Ring_block;
using internal::Site_mesh;
using internal::Tile_forest;
using internal::Tile_options;

using Point = Doubles::Point;
using Points = std::vector<Point>;

constexpr Bounds best{36, 80}, both{30, 89.5}, acute{0, 89.5};

inline Tile_options options_for(const Bounds& bounds) {
  Tile_options options;
  const bool is_narrow = bounds.high < 85;
  options.max_points_per_leaf = is_narrow ? 1 : 3;
  options.spacing = is_narrow ? internal::Spacing::NO_NEIGHBORS : internal::Spacing::DISTINCT;
  return options;
}

/// Fills, places and refines until nothing is left to do, and coarsens.
template <class Tag, class Geometry>
Site_mesh<Geometry> mesh_of(Tile_forest<Tag, Geometry>& forest, const Bounds& bounds,
                            const Coarsening_effort& effort) {
  constexpr int most_rounds = 30;
  const internal::Angle_range range(bounds.low, bounds.high);
  using Relaxer = internal::Site_mesh_relaxer<Tag, Geometry>;
  internal::Site_mesh_parts<Tag, Geometry> parts;
  for (int round = 0; round < most_rounds; ++round) {
    forest.find_leaves();
    const auto coarsen = [&](Site_mesh<Geometry>& mesh, std::size_t = 0) {
      Relaxer(mesh, range).coarsen(effort, [](double) { return true; });
    };
    const bool is_whole = forest.number_of_runs() == 1;
    std::vector<std::size_t> blamed;
    if (!is_whole) blamed = parts.make(forest, range, coarsen);
    if (blamed.empty()) {
      Site_mesh<Geometry> mesh = is_whole ? forest.mesh() : parts.joined(forest);
      blamed = Relaxer(mesh, range).place_sites([&](std::size_t p) { return !forest.is_certified(p); });
      if (blamed.empty()) {
        coarsen(mesh);
        return mesh;
      }
    }
    REQUIRE(std::is_sorted(blamed.begin(), blamed.end()));
    for (const std::size_t s : blamed) forest.refine_for(s);
  }
  FAIL("no end");
  return {};
}

template <class Tag>
Site_mesh<Doubles> mesh_of(const Points& points, const Bounds& bounds,
                           const Coarsening_effort& effort = Coarsening_effort()) {
  const auto frame = Grid_frame<Doubles>::axis_parallel<Tag>(points);
  Tile_forest<Tag, Doubles> forest(points, frame, options_for(bounds));
  return mesh_of(forest, bounds, effort);
}

template <class Tag, class Geometry>
Site_mesh<Geometry> clustered_mesh_of(const std::vector<typename Geometry::Point>& points,
                                      const Bounds& bounds, double gap = internal::least_cluster_gap,
                                      const Coarsening_effort& effort = Coarsening_effort()) {
  const auto frame = Grid_frame<Geometry>::template axis_parallel<Tag>(points);
  const Framed_clusters<Geometry> clusters = internal::frame_clusters<CGAL::Sequential_tag, Geometry>(
      points, internal::find_clusters<CGAL::Sequential_tag, Geometry>(points, gap));
  Tile_forest<Tag, Geometry> forest(points, frame, clusters, options_for(bounds));
  CHECK(forest.number_of_trees() == clusters.frames.size());
  return mesh_of(forest, bounds, effort);
}

/// Each site has a vertex for itself, at its place to the last bit, which is not to be moved.
template <class Geometry>
void check_sites(const Site_mesh<Geometry>& mesh, const std::vector<typename Geometry::Point>& points) {
  std::set<Ring_vertex> vertices(mesh.vertex_of_site.begin(), mesh.vertex_of_site.end());
  REQUIRE(vertices.size() == points.size());
  REQUIRE(mesh.vertex_of_site.size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Ring_vertex v = mesh.vertex_of_site[i];
    if (!mesh.mesh.is_alive(v)) FAIL("a site's vertex is gone");
    if (!(mesh.mesh.point(v) == points[i])) FAIL("a site's vertex is elsewhere");
    if (mesh.mesh.ring(v).mobility != Mobility::FIXED) FAIL("a site's vertex is not fixed");
    if (mesh.is_placed[i] == 0) FAIL("a site is not placed");
  }
}

/// Vertices of the border are on the sides of the root, of which all four corners are vertices; and triangles, which
/// are counterclockwise, cover it.
template <class Geometry>
void check_border(const Ring_mesh<Geometry>& mesh, const typename Geometry::Point& low,
                  const typename Geometry::Point& high) {
  int corners = 0;
  double area = 0;
  for (const Ring_vertex v : mesh.rings.ids()) {
    if (!mesh.is_alive(v)) continue;
    const auto& p = mesh.points[v];
    const bool is_across = p.x == low.x || p.x == high.x, is_along = p.y == low.y || p.y == high.y;
    if (mesh.rings[v].is_open != (is_across || is_along)) FAIL("the border is elsewhere");
    corners += is_across && is_along ? 1 : 0;
  }
  CHECK(corners == 4);
  mesh.for_each_triangle([&](Ring_vertex a, Ring_vertex b, Ring_vertex c) {
    const double doubled = cross(Geometry::difference(mesh.point(b), mesh.point(a)),
                                 Geometry::difference(mesh.point(c), mesh.point(a)));
    if (!(doubled > 0)) FAIL("a triangle is turned over");
    area += doubled;
  });
  const Vector extent = Geometry::difference(high, low);
  CHECK(area == Approx(2 * extent.x * extent.y).epsilon(1e-11));
}

template <class Geometry>
void check_covers_root(const Ring_mesh<Geometry>& mesh, const std::vector<typename Geometry::Point>& points) {
  constexpr std::uint64_t side = std::uint64_t(1) << 62;
  const auto frame = Grid_frame<Geometry>::template axis_parallel<CGAL::Sequential_tag>(points);
  check_disk(mesh);
  check_border(mesh, frame.to_point({0, 0}), frame.to_point({side, side}));
}

inline void check_angles(const Ring_mesh<Doubles>& mesh, const Bounds& bounds) {
  const Angle_extremes e = angle_extremes(mesh, [&](const Triangle& t) { return !are_rigid(mesh, t); });
  CHECK(e.least >= bounds.low);
  CHECK(e.greatest <= bounds.high);
}

/// Strictly, in rational arithmetic.
template <class Geometry>
bool are_all_acute(const Ring_mesh<Geometry>& mesh) {
  bool is_acute = true;
  mesh.for_each_triangle([&](Ring_vertex a, Ring_vertex b, Ring_vertex c) {
    is_acute = is_acute && cluster_tests::is_acute(cluster_tests::exact(mesh.point(a)),
                                                   cluster_tests::exact(mesh.point(b)),
                                                   cluster_tests::exact(mesh.point(c)));
  });
  return is_acute;
}

/// Meshes that differ at most in what is not in use.
inline bool are_same(const Site_mesh<Doubles>& a, const Site_mesh<Doubles>& b) {
  if (a.vertex_of_site != b.vertex_of_site || a.mesh.number_of_vertices() != b.mesh.number_of_vertices())
    return false;
  for (const Ring_vertex v : a.mesh.rings.ids()) {
    const Ring &r = a.mesh.rings[v], &s = b.mesh.rings[v];
    if (r.mobility != s.mobility) return false;
    if (r.mobility == Mobility::REMOVED) continue;
    if (std::memcmp(&a.mesh.points[v], &b.mesh.points[v], sizeof(Point)) != 0 || r.is_open != s.is_open ||
        !std::equal(r.neighbor.begin(), r.neighbor.begin() + r.size, s.neighbor.begin(),
                    s.neighbor.begin() + s.size))
      return false;
  }
  return true;
}

inline double triangles_per_site(const Site_mesh<Doubles>& mesh) {
  return double(mesh.mesh.number_of_triangles()) / double(mesh.sites.size());
}

/// Whether `make()` makes the same mesh in tiny blocks one after the other, in reverse order, and at the same time.
template <class Make>
void check_in_any_order(const Site_mesh<Doubles>& mesh, const Make& make) {
  order_of_blocks = Order_of_blocks::BACKWARD;
  CHECK(are_same(mesh, make()));
  order_of_blocks = Order_of_blocks::PARALLEL;
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t threads : numbers_of_threads()) {
    CAPTURE(threads);
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    CHECK(are_same(mesh, make()));
  }
#endif
  order_of_blocks = Order_of_blocks::FORWARD;
}

/// \name Inputs
/// @{
struct Input {
  std::string name;
  Points points;
};

inline Points uniform(std::size_t n, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random();
    points.push_back({x, random()});
  }
  return points;
}

inline Points blobs(std::size_t n, double radius, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  const Points centers = uniform(4, seed + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const double r = radius * random(), t = 6.28318 * random();
    points.push_back({centers[i % 4].x + r * std::cos(t), centers[i % 4].y + r * std::sin(t)});
  }
  return points;
}

inline Points grid(int n) {
  Points points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) points.push_back({i / 8., j / 8.});
  return points;
}

inline Points line(int n, double slope) {
  Points points;
  for (int i = 0; i < n; ++i) points.push_back({i / 7., slope * i});
  return points;
}

/// Points each of which has another near it.
inline Points pairs(std::size_t n, double distance, std::uint64_t seed) {
  Points points = uniform(n, seed);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2.399963 * double(i);
    points.push_back({points[i].x + distance * std::cos(t), points[i].y + distance * std::sin(t)});
  }
  return points;
}

inline std::vector<Input> all_inputs() {
  return {{"one", {{3, -5}}},
          {"two", {{0, 0}, {1, 0.3}}},
          {"two near each other and one", {{0, 0}, {1e-3, 1e-4}, {1, 1}}},
          {"uniform", uniform(25, 1)},
          {"blobs", blobs(24, 0.02, 2)},
          {"grid", grid(5)},
          {"line", line(20, 0.123)},
          {"horizontal line", line(12, 0)},
          {"near pairs", pairs(5, 1e-3, 3)},
          {"far from the origin", [] {
             Points points = uniform(15, 4);
             for (Point& p : points) p = {1e6 + p.x, -1e7 + p.y};
             return points;
           }()}};
}
/// @}

/// The mesh of all tiles.
template <class Tag, class Geometry>
Site_mesh<Geometry> fill(Tile_forest<Tag, Geometry>& forest) {
  forest.find_leaves();
  return forest.mesh();
}

/// A mesh with held, fixed and sliding vertices, not yet worked on.
template <class Tag>
Site_mesh<Doubles> filled(const Points& points) {
  const auto frame = Grid_frame<Doubles>::axis_parallel<Tag>(points);
  Tile_forest<Tag, Doubles> forest(points, frame, options_for(best));
  return fill(forest);
}

} // namespace site_mesh_test

#endif // QUADTREE_MESH_2_TEST_SITE_MESH_TOOLS_H
