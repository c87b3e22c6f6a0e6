// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes of points from tiles to the end: blocks, placing of sites, clusters, coarsening.

#include "catch.h"
#include "cluster_test_tools.h"
#include "random_numbers.h"
#include "ring_mesh_checks.h"

#include <CGAL/Quadtree_mesh_2/internal/clusters/find_clusters.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/frame_clusters.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/exact_axis_parallel_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Ring_blocks.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Site_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_forest.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// A concurrency tag that cuts small meshes into blocks.
struct Tiny_rings_tag {};

/// In which order it works on them.
enum class Order_of_blocks { FORWARD, BACKWARD, PARALLEL };
Order_of_blocks order_of_blocks = Order_of_blocks::FORWARD;

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <>
struct Ring_block_sizes<Tiny_rings_tag> {
  static constexpr std::size_t vertices = 150;
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

using namespace ring_test;
using internal::Coarsening_effort;
using internal::Framed_clusters;
using internal::Grid_frame;
using internal::Ring_block;
using internal::Site_mesh;
using internal::Tile_forest;
using internal::Tile_options;

namespace {

using Point = Doubles::Point;
using Points = std::vector<Point>;

struct Bounds {
  double low, high;
};
constexpr Bounds best{36, 80}, both{30, 89.5}, acute{0, 89.5};

Tile_options options_for(const Bounds& bounds) {
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
  for (int round = 0; round < most_rounds; ++round) {
    Site_mesh<Geometry> mesh = forest.fill();
    internal::Site_mesh_relaxer<Tag, Geometry> relaxer(mesh, range);
    const std::vector<std::size_t> blamed =
        relaxer.place_sites([&](std::size_t p) { return !forest.is_certified(p); });
    REQUIRE(std::is_sorted(blamed.begin(), blamed.end()));
    if (blamed.empty()) {
      relaxer.coarsen(effort, [](double) { return true; });
      return mesh;
    }
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
  const Framed_clusters<Geometry> clusters =
      internal::frame_clusters<Geometry>(points, internal::find_clusters<Geometry>(points, gap));
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
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    if (!mesh.is_alive(Ring_vertex(v))) continue;
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

bool are_rigid(const Ring_mesh<Doubles>& mesh, const Triangle& t) {
  return std::all_of(t.begin(), t.end(),
                     [&](Ring_vertex v) { return mesh.ring(v).mobility == Mobility::RIGID; });
}

void check_angles(const Ring_mesh<Doubles>& mesh, const Bounds& bounds) {
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
bool are_same(const Site_mesh<Doubles>& a, const Site_mesh<Doubles>& b) {
  if (a.vertex_of_site != b.vertex_of_site || a.mesh.number_of_vertices() != b.mesh.number_of_vertices())
    return false;
  for (std::size_t v = 0; v < a.mesh.number_of_vertices(); ++v) {
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

double triangles_per_site(const Site_mesh<Doubles>& mesh) {
  return double(mesh.mesh.number_of_triangles()) / double(mesh.sites.size());
}

/// Whether `make()` makes the same mesh in tiny blocks one after the other, in reverse order, and at the same time.
template <class Make>
void check_in_any_order(const Site_mesh<Doubles>& mesh, const Make& make) {
  order_of_blocks = Order_of_blocks::BACKWARD;
  CHECK(are_same(mesh, make()));
  order_of_blocks = Order_of_blocks::PARALLEL;
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t threads : {1u, 2u, 4u}) {
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

Points uniform(std::size_t n, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random();
    points.push_back({x, random()});
  }
  return points;
}

Points blobs(std::size_t n, double radius, std::uint64_t seed) {
  Random_numbers random(seed);
  Points points;
  const Points centers = uniform(4, seed + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const double r = radius * random(), t = 6.28318 * random();
    points.push_back({centers[i % 4].x + r * std::cos(t), centers[i % 4].y + r * std::sin(t)});
  }
  return points;
}

Points grid(int n) {
  Points points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) points.push_back({i / 8., j / 8.});
  return points;
}

Points line(int n, double slope) {
  Points points;
  for (int i = 0; i < n; ++i) points.push_back({i / 7., slope * i});
  return points;
}

/// Points each of which has another near it.
Points pairs(std::size_t n, double distance, std::uint64_t seed) {
  Points points = uniform(n, seed);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2.399963 * double(i);
    points.push_back({points[i].x + distance * std::cos(t), points[i].y + distance * std::sin(t)});
  }
  return points;
}

std::vector<Input> all_inputs() {
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

/// A mesh with held, fixed and sliding vertices, not yet worked on.
template <class Tag>
Site_mesh<Doubles> filled(const Points& points) {
  const auto frame = Grid_frame<Doubles>::axis_parallel<Tag>(points);
  return Tile_forest<Tag, Doubles>(points, frame, options_for(best)).fill();
}

} // namespace

TEST_CASE("Blocks renumber vertices and own what is inside", "[site_mesh]") {
  using Blocks = internal::Ring_blocks<Tiny_rings_tag, Doubles>;
  Site_mesh<Doubles> site_mesh = filled<CGAL::Sequential_tag>(uniform(30, 5));
  Ring_mesh<Doubles>& mesh = site_mesh.mesh;
  std::uint8_t count = 0;
  for (Ring& r : mesh.rings) r.tried_rings = ++count;
  Blocks blocks(mesh);
  for (int pass = 0; pass <= Blocks::number_of_passes; ++pass) {
    CAPTURE(pass);
    const Ring_mesh<Doubles> old = mesh;
    if (pass < Blocks::number_of_passes)
      blocks.cut(pass);
    else
      blocks.join();
    check_disk(mesh);
    // a bijection of the vertices in use, which keeps all but numbers
    std::set<Ring_vertex> numbers;
    std::size_t alive = 0;
    for (std::size_t i = 0; i < old.number_of_vertices(); ++i) {
      if (!old.is_alive(Ring_vertex(i))) continue;
      ++alive;
      const Ring_vertex v = blocks.new_number(Ring_vertex(i));
      REQUIRE(numbers.insert(v).second);
      const Ring &r = old.rings[i], &s = mesh.ring(v);
      REQUIRE(old.points[i] == mesh.point(v));
      REQUIRE((r.size == s.size && r.is_open == s.is_open && r.mobility == s.mobility &&
               r.tried_rings == s.tried_rings));
      for (int k = 0; k < r.size; ++k) REQUIRE(blocks.new_number(r[k]) == s[k]);
    }
    std::size_t alive_now = 0, visited = 0, owned = 0;
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      alive_now += mesh.is_alive(Ring_vertex(v)) ? 1 : 0;
    REQUIRE(alive == alive_now);
    // blocks, one after the other
    Ring_vertex begin = 0;
    std::int32_t number = 0;
    blocks.for_each_block([&](const Ring_block& block, std::vector<internal::Patch_marks>& marks) {
      REQUIRE(marks.size() == mesh.number_of_vertices());
      REQUIRE(block.number == number++);
      REQUIRE(block.begin == begin);
      REQUIRE(block.end > block.begin);
      REQUIRE(block.spare_end >= block.end + 16);
      begin = block.spare_end;
      for (Ring_vertex v = block.begin; v < block.end; ++v) {
        REQUIRE(mesh.is_alive(v));
        ++visited;
        const Ring& r = mesh.ring(v);
        bool is_inside = true;
        for (int k = 0; k < r.size; ++k) is_inside = is_inside && block.begin <= r[k] && r[k] < block.end;
        REQUIRE(r.block == (is_inside ? block.number : -1));
        owned += is_inside ? 1 : 0;
      }
      for (Ring_vertex v = block.end; v < block.spare_end; ++v) REQUIRE_FALSE(mesh.is_alive(v));
    });
    REQUIRE(std::size_t(begin) == mesh.number_of_vertices());
    REQUIRE(visited == alive);
    REQUIRE(std::size_t(number) == blocks.number_of_blocks());
    REQUIRE(blocks.is_whole() == (pass == Blocks::number_of_passes));
    if (blocks.is_whole()) REQUIRE(owned == alive);
    REQUIRE(owned > alive / 3);
  }
}

TEST_CASE("Seams of different passes are in different places", "[site_mesh]") {
  Site_mesh<Doubles> site_mesh = filled<CGAL::Sequential_tag>(uniform(60, 6));
  Ring_mesh<Doubles>& mesh = site_mesh.mesh;
  using Blocks = internal::Ring_blocks<Tiny_rings_tag, Doubles>;
  Blocks blocks(mesh);
  std::map<std::pair<double, double>, int> times_owned;
  for (int pass = 0; pass < Blocks::number_of_passes; ++pass) {
    blocks.cut(pass);
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      if (mesh.is_alive(Ring_vertex(v)))
        times_owned[{mesh.points[v].x, mesh.points[v].y}] += mesh.rings[v].block >= 0 ? 1 : 0;
  }
  std::size_t never = 0;
  for (const auto& t : times_owned) never += t.second == 0 ? 1 : 0;
  CHECK(never < times_owned.size() / 20);
}

TEST_CASE("Meshes of sites keep the range, with the same bits by any tag", "[site_mesh]") {
  for (const Input& input : all_inputs())
    for (const Bounds& bounds : {best, both, acute}) {
      CAPTURE(input.name, bounds.low, bounds.high);
      const Site_mesh<Doubles> mesh = mesh_of<CGAL::Sequential_tag>(input.points, bounds);
      check_sites(mesh, input.points);
      check_covers_root(mesh.mesh, input.points);
      check_angles(mesh.mesh, bounds);
      if (bounds.low == 0) CHECK(are_same(mesh, mesh_of<CGAL::Parallel_tag>(input.points, bounds)));
    }
}

TEST_CASE("Meshes of sites in tiny blocks are valid, the same in any order", "[site_mesh][parallel]") {
  for (const Input& input : {Input{"uniform", uniform(25, 7)}, Input{"blobs", blobs(16, 0.02, 8)},
                             Input{"line", line(12, 0.31)}, Input{"near pairs", pairs(3, 1e-3, 9)}})
    for (const Bounds& bounds : {best, acute}) {
      CAPTURE(input.name, bounds.low, bounds.high);
      const Site_mesh<Doubles> mesh = mesh_of<Tiny_rings_tag>(input.points, bounds);
      check_sites(mesh, input.points);
      check_covers_root(mesh.mesh, input.points);
      check_angles(mesh.mesh, bounds);
      check_in_any_order(mesh, [&] { return mesh_of<Tiny_rings_tag>(input.points, bounds); });
    }
}

TEST_CASE("Several blocks of full size give the same bits with any number of threads",
          "[site_mesh][parallel]") {
  const Points points = uniform(470, 10);
  Coarsening_effort effort;
  effort.tries_per_vertex = 0.01;
  const Site_mesh<Doubles> mesh = mesh_of<CGAL::Sequential_tag>(points, best, effort);
  check_sites(mesh, points);
  check_covers_root(mesh.mesh, points);
  check_angles(mesh.mesh, best);
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t threads : {1u, 2u, 4u}) {
    CAPTURE(threads);
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    CHECK(are_same(mesh, mesh_of<CGAL::Parallel_tag>(points, best, effort)));
  }
#endif
}

TEST_CASE("Coarsening leaves a few triangles for each point", "[site_mesh]") {
  const Points points = uniform(100, 11);
  Coarsening_effort none, little;
  none.most_rings = 0;
  little.tries_per_vertex = 0.05;
  double last = 1e9;
  for (const Coarsening_effort& effort : {none, little, Coarsening_effort()}) {
    const Site_mesh<Doubles> mesh = mesh_of<CGAL::Sequential_tag>(points, best, effort);
    check_sites(mesh, points);
    check_covers_root(mesh.mesh, points);
    check_angles(mesh.mesh, best);
    CHECK(triangles_per_site(mesh) < last);
    last = triangles_per_site(mesh);
    for (const Ring& r : mesh.mesh.rings) REQUIRE(r.mobility != Mobility::HELD);
  }
  CHECK(last < 12);
  CHECK(triangles_per_site(mesh_of<CGAL::Sequential_tag>(points, acute)) < 5.5);
  CHECK(triangles_per_site(mesh_of<CGAL::Sequential_tag>(points, both)) < 7.5);
}

TEST_CASE("Rows along the diameter have meshes of sites, too", "[site_mesh]") {
  const Points points = line(40, 0.07);
  const auto frame = Grid_frame<Doubles>::along_diameter<CGAL::Sequential_tag>(points);
  REQUIRE_FALSE(frame.rotation().is_one());
  for (const Bounds& bounds : {best, acute}) {
    CAPTURE(bounds.low, bounds.high);
    Tile_forest<CGAL::Sequential_tag, Doubles> forest(points, frame, options_for(bounds));
    const Site_mesh<Doubles> mesh = mesh_of(forest, bounds, Coarsening_effort());
    check_sites(mesh, points);
    check_disk(mesh.mesh);
    check_angles(mesh.mesh, bounds);
    CHECK(triangles_per_site(mesh) < 20);
  }
}

TEST_CASE("Points with integer coordinates have meshes of sites", "[site_mesh]") {
  std::vector<Integers::Point> points;
  for (const Point& p : uniform(40, 12))
    points.push_back({std::int64_t(p.x * 0x1p40), std::int64_t(p.y * 0x1p40) - 12345});
  const auto frame = Grid_frame<Integers>::axis_parallel<CGAL::Sequential_tag>(points);
  for (const Bounds& bounds : {best, acute}) {
    CAPTURE(bounds.low, bounds.high);
    Tile_forest<CGAL::Sequential_tag, Integers> forest(points, frame, options_for(bounds));
    const Site_mesh<Integers> mesh = mesh_of(forest, bounds, Coarsening_effort());
    check_sites(mesh, points);
    check_covers_root(mesh.mesh, points);
    const Angle_extremes e = angle_extremes(mesh.mesh);
    CHECK(e.least >= bounds.low);
    CHECK(e.greatest <= bounds.high);
    CHECK(are_all_acute(mesh.mesh));
  }
}

namespace {

/// Triangles with a vertex that is not to be moved because it belongs to a block for a site.
Angle_extremes angles_in_blocks(const Site_mesh<Doubles>& mesh, std::size_t* count) {
  return angle_extremes(mesh.mesh, [&](const Triangle& t) {
    const bool is_held = std::any_of(
        t.begin(), t.end(), [&](Ring_vertex v) { return mesh.mesh.ring(v).mobility == Mobility::HELD; });
    *count += is_held ? 1 : 0;
    return is_held;
  });
}

} // namespace

TEST_CASE("A site that fails again and again gets a block in which nothing can fail", "[site_mesh]") {
  for (const Input& input : {Input{"uniform", uniform(30, 13)}, Input{"near pairs", pairs(5, 1e-2, 14)}}) {
    CAPTURE(input.name);
    const Points& points = input.points;
    const auto frame = Grid_frame<Doubles>::axis_parallel<CGAL::Sequential_tag>(points);
    for (std::size_t i = 0; i < points.size(); i += 4) {
      CAPTURE(i);
      Tile_forest<CGAL::Sequential_tag, Doubles> forest(points, frame, options_for(best));
      forest.fill();
      int failures = 0;
      for (; !forest.is_certified(i); ++failures) forest.refine_for(i);
      CHECK(failures == 3);
      CHECK(forest.number_of_certified_points() == 1);
      const Site_mesh<Doubles> mesh = forest.fill();
      check_covers_root(mesh.mesh, points);
      CHECK(forest.is_certified(i));
      // its vertex is where the grid has it, and all around is held
      const Ring_vertex v = mesh.vertex_of_site[i];
      const Vector off = Doubles::difference(mesh.mesh.point(v), points[i]);
      CHECK(std::max(std::fabs(off.x), std::fabs(off.y)) < 1e-15);
      const Ring& r = mesh.mesh.ring(v);
      for (int k = 0; k < r.size; ++k) CHECK(mesh.mesh.ring(r[k]).mobility == Mobility::HELD);
      std::size_t count = 0;
      const Angle_extremes e = angles_in_blocks(mesh, &count);
      CHECK(count > 50);
      CHECK(e.least > 37.4);
      CHECK(e.greatest < 78.7);
    }
  }
}

TEST_CASE("When all sites have blocks nothing is left to do", "[site_mesh]") {
  for (const Input& input :
       {Input{"uniform", uniform(12, 15)}, Input{"pairs", pairs(4, 1e-2, 16)}, Input{"line", line(8, 0.2)}}) {
    CAPTURE(input.name);
    const Points& points = input.points;
    const auto frame = Grid_frame<Doubles>::axis_parallel<CGAL::Sequential_tag>(points);
    Tile_forest<CGAL::Sequential_tag, Doubles> forest(points, frame, options_for(best));
    forest.fill();
    for (std::size_t i = 0; i < points.size(); ++i)
      while (!forest.is_certified(i)) forest.refine_for(i);
    CHECK(forest.number_of_certified_points() == points.size());
    Site_mesh<Doubles> mesh = forest.fill();
    std::size_t count = 0;
    const Angle_extremes e = angles_in_blocks(mesh, &count);
    CHECK(count > 50 * points.size());
    CHECK(e.least > 37.4);
    CHECK(e.greatest < 78.7);
    const internal::Angle_range range(best.low, best.high);
    internal::Site_mesh_relaxer<CGAL::Sequential_tag, Doubles> relaxer(mesh, range);
    CHECK(relaxer.place_sites([](std::size_t) { return true; }).empty());
    check_angles(mesh.mesh, best);
    check_sites(mesh, points);
    relaxer.coarsen(Coarsening_effort(), [](double) { return true; });
    check_angles(mesh.mesh, best);
    check_sites(mesh, points);
    check_covers_root(mesh.mesh, points);
  }
}

namespace {

struct Clustered_input {
  std::string name;
  Points points;
  std::size_t clusters; ///< besides the root
};

/// One cluster in the other, about the origin, in steps of 2^-14.
Points nested(int levels) {
  Points points{{0, 0}};
  for (int k = 0; k <= levels; ++k) {
    const double x = std::ldexp(1.0, -14 * k);
    points.push_back({x, k % 3 == 1 ? x / 2 : 0});
  }
  return points;
}

std::vector<Clustered_input> clustered_inputs() {
  return {{"a pair and a point", {{0, 0}, {0x1p-20, 0}, {1, 1}}, 1},
          {"pairs", pairs(6, 1e-8, 17), 6},
          {"nested", nested(8), 8},
          {"beside each other",
           {{0.3, 0.3}, {0.3 + 1e-7, 0.3}, {0.301, 0.3}, {0.301, 0.3 + 1e-7}, {1, 1}, {0.9, 0.4}},
           2},
          {"blobs", blobs(24, 1e-6, 18), 4},
          {"no clusters", uniform(12, 19), 0},
          {"bridges", {{0, 0}, {0x1p-200, 0}, {1, 1}}, 4}};
}

} // namespace

TEST_CASE("Meshes with clusters are strictly acute", "[site_mesh][clusters]") {
  for (const Clustered_input& input : clustered_inputs()) {
    CAPTURE(input.name);
    const Points& points = input.points;
    const auto clusters =
        internal::frame_clusters<Doubles>(points, internal::find_clusters<Doubles>(points, 2248));
    CHECK(clusters.frames.size() == input.clusters + 1);
    for (const int most_rings : {0, 2}) {
      CAPTURE(most_rings);
      Coarsening_effort effort;
      effort.most_rings = most_rings;
      const Site_mesh<Doubles> mesh =
          clustered_mesh_of<CGAL::Sequential_tag, Doubles>(points, acute, 2248, effort);
      check_sites(mesh, points);
      check_covers_root(mesh.mesh, points);
      CHECK(are_all_acute(mesh.mesh));
      check_angles(mesh.mesh, acute);
      CHECK(mesh.mesh.number_of_triangles() <
            (most_rings == 0 ? 1500 : 100) * (points.size() + input.clusters));
      CHECK(are_same(mesh, clustered_mesh_of<CGAL::Parallel_tag, Doubles>(points, acute, 2248, effort)));
    }
  }
}

TEST_CASE("Meshes with clusters in tiny blocks are strictly acute", "[site_mesh][clusters][parallel]") {
  for (const Points& points : {pairs(4, 1e-8, 20), nested(2), blobs(12, 1e-5, 21)}) {
    const Site_mesh<Doubles> mesh = clustered_mesh_of<Tiny_rings_tag, Doubles>(points, acute);
    check_sites(mesh, points);
    check_covers_root(mesh.mesh, points);
    CHECK(are_all_acute(mesh.mesh));
    check_in_any_order(mesh, [&] { return clustered_mesh_of<Tiny_rings_tag, Doubles>(points, acute); });
  }
}

TEST_CASE("Planted clusters have strictly acute meshes", "[site_mesh][clusters]") {
  const int rounds = is_full_run() ? 60 : 6;
  for (int round = 0; round < rounds; ++round) {
    CAPTURE(round);
    Random_numbers random(std::uint64_t(round) + 300);
    const Points points =
        cluster_tests::distinct(cluster_tests::planted(5 + std::size_t(round) % 30, random, 0x1p-40));
    const Site_mesh<Doubles> mesh = clustered_mesh_of<CGAL::Sequential_tag, Doubles>(points, acute);
    check_sites(mesh, points);
    check_covers_root(mesh.mesh, points);
    CHECK(are_all_acute(mesh.mesh));
    CHECK(triangles_per_site(mesh) < 150);
  }
}

TEST_CASE("The number of triangles does not depend on how near points are", "[site_mesh][clusters]") {
  std::vector<double> counts;
  for (const double distance : {0x1p-16, 0x1p-24, 0x1p-32, 0x1p-40})
    counts.push_back(
        triangles_per_site(clustered_mesh_of<CGAL::Sequential_tag, Doubles>(pairs(6, distance, 22), acute)));
  for (const double count : counts) {
    CHECK(count < 90);
    CHECK(count < 1.3 * counts[0]);
  }
}

TEST_CASE("Integers and exact numbers with clusters have strictly acute meshes", "[site_mesh][clusters]") {
  std::vector<Integers::Point> integers;
  for (const Point& p : pairs(5, 1e-8, 23))
    integers.push_back({std::int64_t(p.x * 0x1p55), std::int64_t(p.y * 0x1p55)});
  const auto of_integers = clustered_mesh_of<CGAL::Sequential_tag, Integers>(integers, acute);
  check_sites(of_integers, integers);
  check_covers_root(of_integers.mesh, integers);
  CHECK(are_all_acute(of_integers.mesh));

  // gaps as wide as no floating point number spans
  for (const int exponent : {-30, -200}) {
    CAPTURE(exponent);
    const auto at = [](const cluster_tests::Number& x, const cluster_tests::Number& y) {
      const cluster_tests::Number third = cluster_tests::Number(1) / cluster_tests::Number(3);
      return cluster_tests::Exact::Point{cluster_tests::Exact::Coordinate(cluster_tests::Number(third + x)),
                                         cluster_tests::Exact::Coordinate(cluster_tests::Number(third - y))};
    };
    const cluster_tests::Number near = cluster_tests::power(exponent);
    const std::vector<cluster_tests::Exact::Point> points{at(0, 0), at(near, 0), at(0, near), at(1, 0),
                                                          at(1, 1)};
    const auto mesh = clustered_mesh_of<CGAL::Sequential_tag, cluster_tests::Exact>(points, acute);
    check_sites(mesh, points);
    check_disk(mesh.mesh);
    CHECK(are_all_acute(mesh.mesh));
  }
}

TEST_CASE("Many sites of all kinds", "[.slow][site_mesh]") {
  for (const Input& input :
       {Input{"uniform", uniform(4000, 30)}, Input{"blobs", blobs(2000, 0.05, 31)}, Input{"grid", grid(40)},
        Input{"line", line(500, 0.3)}, Input{"pairs", pairs(100, 1e-4, 32)}})
    for (const Bounds& bounds : {best, both, acute}) {
      CAPTURE(input.name, bounds.low, bounds.high);
      const Site_mesh<Doubles> mesh = mesh_of<CGAL::Parallel_tag>(input.points, bounds);
      check_sites(mesh, input.points);
      check_covers_root(mesh.mesh, input.points);
      check_angles(mesh.mesh, bounds);
      const Site_mesh<Doubles> in_blocks = mesh_of<Tiny_rings_tag>(input.points, bounds);
      check_sites(in_blocks, input.points);
      check_covers_root(in_blocks.mesh, input.points);
      check_angles(in_blocks.mesh, bounds);
    }
}
