// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "cluster_test_tools.h"
#include "random_numbers.h"

#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_frame.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/find_clusters.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/frame_clusters.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

namespace test_frame_clusters {

using namespace cluster_tests;
using internal::Cluster;
using internal::Cluster_site;
using internal::Framed_clusters;

namespace {

/// A quadtree that is balanced over corners, by what has to be split so that given squares exist: the eight
/// neighbors of each split square exist, too.
class Balanced_squares {
public:
  /// Makes a square exist, given by its level, column and row.
  void require(int level, std::int64_t x, std::int64_t y) {
    const std::int64_t size = std::int64_t(1) << level;
    if (level == 0 || x < 0 || y < 0 || x >= size || y >= size) return;
    if (!split_.insert({level - 1, x >> 1, y >> 1}).second) return;
    for (std::int64_t i = -1; i <= 1; ++i)
      for (std::int64_t j = -1; j <= 1; ++j) require(level - 1, (x >> 1) + i, (y >> 1) + j);
  }
  bool is_split(int level, std::int64_t x, std::int64_t y) const { return split_.count({level, x, y}) != 0; }
  bool is_leaf(int level, std::int64_t x, std::int64_t y) const {
    return !is_split(level, x, y) && is_split(level - 1, x >> 1, y >> 1);
  }
  std::size_t number_of_split_squares() const { return split_.size(); }

private:
  std::set<std::tuple<int, std::int64_t, std::int64_t>> split_;
};

/// The lower left square of the block of a site, and its size.
struct Block {
  int level;
  std::int64_t x, y, size;
};

Block block_of(const Place& place, int level, Cluster_site kind) {
  const std::int64_t side = std::int64_t(1) << (62 - level);
  const auto first = [&](std::uint64_t c) {
    const auto v = static_cast<std::int64_t>(c);
    return kind == Cluster_site::POINT ? v / side - 1 : (v + side / 2) / side - 2;
  };
  return {level, first(place.x), first(place.y), kind == Cluster_site::POINT ? 3 : 4};
}

/// Forces the blocks of all sites. They have to be whole and touched by nothing smaller, like the window's border.
/// \returns the number of squares that are split.
std::size_t check_blocks(const std::vector<Block>& blocks) {
  Balanced_squares squares;
  for (std::int64_t x = 1; x < 6; ++x)
    for (std::int64_t y = 1; y < 6; ++y) squares.require(3, x, y);
  for (const Block& b : blocks)
    for (std::int64_t i = 0; i < b.size; ++i)
      for (std::int64_t j = 0; j < b.size; ++j) squares.require(b.level, b.x + i, b.y + j);
  for (const Block& b : blocks)
    for (std::int64_t i = -1; i <= b.size; ++i)
      for (std::int64_t j = -1; j <= b.size; ++j) {
        REQUIRE_FALSE(squares.is_split(b.level, b.x + i, b.y + j));
        if (0 <= i && i < b.size && 0 <= j && j < b.size) REQUIRE(squares.is_leaf(b.level, b.x + i, b.y + j));
      }
  for (std::int64_t x = 1; x < 6; ++x)
    for (std::int64_t y = 1; y < 6; ++y)
      if (x == 1 || y == 1 || x == 5 || y == 5) REQUIRE(squares.is_leaf(3, x, y));
  return squares.number_of_split_squares();
}

void check_is_in_middle_cell(const Block& b) {
  const int shift = b.level - 3;
  for (std::int64_t first : {b.x, b.y}) {
    REQUIRE(first >> shift == 3);
    REQUIRE((first + b.size - 1) >> shift == 3);
  }
}

struct Checked_frames {
  std::size_t bridges = 0, split_squares = 0;
};

/// What Cluster_frame.h and find_clusters.h promise of each cluster's sites.
template <class Geometry>
Checked_frames check_frames(const Points<Geometry>& points, const Framed_clusters<Geometry>& framed) {
  REQUIRE(framed.frames.size() == framed.tree.clusters.size());
  Checked_frames result;
  std::size_t number_of_points = 0;
  for (std::size_t k = 0; k < framed.frames.size(); ++k) {
    const Cluster& c = framed.tree.clusters[k];
    const auto& frame = framed.frames[k];
    struct Site {
      typename Geometry::Point p;
      double distance;
      Cluster_site kind;
      int exponent;
    };
    std::vector<Site> sites;
    for (std::uint32_t i = c.first_point; i < c.end_point; ++i) {
      const std::uint32_t point = framed.tree.points[i];
      sites.push_back({points[point], framed.tree.nearest[point], Cluster_site::POINT, 0});
    }
    number_of_points += sites.size();
    for (auto child = std::size_t(c.first_child); child < std::size_t(c.end_child); ++child)
      sites.push_back({framed.frames[child].center(), framed.tree.clusters[child].distance,
                       Cluster_site::CLUSTER, framed.frames[child].exponent()});
    if (c.parent >= 0 && sites.size() == 1) ++result.bridges;
    REQUIRE(!sites.empty());
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const Site& site = sites[i];
      const int level = frame.level_of_site(site.distance, site.kind);
      REQUIRE(level >= 6);
      blocks.push_back(block_of(frame.place_of(site.p), level, site.kind));
      check_is_in_middle_cell(blocks.back());
      const int log_leaf = frame.log_side(level);
      const double leaf = std::ldexp(1.0, log_leaf);
      if (site.kind == Cluster_site::CLUSTER) {
        REQUIRE(log_leaf - site.exponent >= 6);
        check_ring(framed.frames[std::size_t(c.first_child) + i - (c.end_point - c.first_point)], log_leaf);
      }
      double nearest = INFINITY;
      for (std::size_t j = 0; j < sites.size(); ++j)
        if (i != j)
          nearest = std::min(nearest, internal::length_of(Geometry::difference(site.p, sites[j].p)));
      REQUIRE(nearest >= leaf * (site.kind == Cluster_site::POINT ? 6 : 7));
      // not much smaller than it may be
      if (level > 6 && std::isfinite(nearest))
        REQUIRE(nearest < 2.01 * leaf * (site.kind == Cluster_site::POINT ? 6 : 7));
    }
    result.split_squares += check_blocks(blocks);
  }
  REQUIRE(number_of_points == points.size());
  return result;
}

template <class Geometry>
Framed_clusters<Geometry> framed(const Points<Geometry>& points, double gap = internal::least_cluster_gap) {
  return internal::frame_clusters<CGAL::Sequential_tag, Geometry>(
      points, internal::find_clusters<CGAL::Sequential_tag, Geometry>(points, gap));
}

} // namespace

TEST_CASE("Sites of clusters have room", "[clusters]") {
  const int rounds = is_full_run() ? 400 : 40;
  std::size_t clusters = 0;
  for (int round = 0; round < rounds; ++round) {
    CAPTURE(round);
    Random_numbers random(std::uint64_t(round) + 100);
    const Points<Doubles> points = distinct(planted(5 + std::size_t(round) % 40, random, 0x1p-44));
    const auto result = framed<Doubles>(points);
    clusters += result.frames.size() - 1;
    CHECK(check_frames<Doubles>(points, result).bridges == 0);

    Points<Integers> integers;
    for (const auto& p : points) integers.push_back({std::int64_t(p.x * 0x1p55), std::int64_t(p.y * 0x1p55)});
    check_frames<Integers>(distinct(integers), framed<Integers>(distinct(integers)));
  }
  CHECK(clusters > std::size_t(rounds));
}

TEST_CASE("Clusters of exactly the least gap have room", "[clusters]") {
  // squares of four points and pairs at all scales of a power of two, a site or a cluster beside them
  for (int k = 0; k < 64; ++k) {
    CAPTURE(k);
    const double w = 0x1p-20 * (1 + k / 64.), d = internal::least_cluster_gap * w * (1 + 0x1p-40);
    for (double angle : {0., 0.3, 0.785, 1.5, 4.}) {
      const double x = std::cos(angle), y = std::sin(angle);
      // the last of them is the corner nearest to the other cluster
      const Points<Doubles> square{{0, 0}, {w, 0}, {0, w}, {w, w}};
      Points<Doubles> points = square;
      const Doubles::Point corner{x > 0 ? w : 0, y > 0 ? w : 0};
      points.push_back({corner.x + d * x, corner.y + d * y});
      points.push_back({points[4].x + (x > 0 ? w : -w), points[4].y + (y > 0 ? w : -w)});
      const auto result = framed<Doubles>(points, internal::least_cluster_gap);
      CHECK(result.frames.size() >= 2);
      check_frames<Doubles>(points, result);
    }
  }
}

TEST_CASE("Bridges span gaps beyond the bits of doubles", "[clusters]") {
  Points<Doubles> points{{0, 0}, {0x1p-600, 0}, {1, 1}};
  auto result = framed<Doubles>(points);
  const std::size_t bridges = check_frames<Doubles>(points, result).bridges;
  CHECK(bridges >= 10);
  CHECK(bridges <= 14);
  CHECK(result.frames.size() == bridges + 2);
  // exact coordinates need none
  Points<Exact> exacts;
  for (const auto& p : points) exacts.push_back({Exact::Coordinate(p.x), Exact::Coordinate(p.y)});
  const auto of_exacts = framed<Exact>(exacts);
  CHECK(check_frames<Exact>(exacts, of_exacts).bridges == 0);
  CHECK(of_exacts.frames.size() == 2);
  // a cluster in a cluster
  points = {{0, 0}, {0x1p-900, 0}, {0, 0x1p-700}, {0x1p-350, 0}, {1, 1}, {1, 1 + 0x1p-52}, {0x1p200, 0}};
  result = framed<Doubles>(points);
  CHECK(check_frames<Doubles>(points, result).bridges > 15);
}

TEST_CASE("Fifty clusters, one in the other, have frames", "[clusters]") {
  Points<Doubles> points;
  Points<Exact> exacts;
  const Number third = Number(1) / Number(3);
  for (int k = 0; k <= 50; ++k) {
    const double x = std::ldexp(1.0, -12 * k);
    points.push_back({x, k % 3 == 1 ? x / 2 : 0});
    exacts.push_back(
        {Exact::Coordinate(Number(third + Number(x))), Exact::Coordinate(Number(third * Number(x)))});
  }
  points.push_back({0, 0});
  exacts.push_back({Exact::Coordinate(third), Exact::Coordinate(0.)});
  const auto result = framed<Doubles>(points);
  CHECK(result.frames.size() == 51);
  const Checked_frames checked = check_frames<Doubles>(points, result);
  CHECK(checked.bridges == 0);
  // linear, whatever the ratio of the distances is
  CHECK(checked.split_squares < 60 * points.size());
  const auto of_exacts = framed<Exact>(exacts);
  CHECK(of_exacts.frames.size() == 51);
  CHECK(check_frames<Exact>(exacts, of_exacts).bridges == 0);
}

TEST_CASE("The number of squares does not depend on gaps", "[clusters]") {
  std::size_t least = std::size_t(-1), most = 0;
  for (int log_gap : {12, 20, 30, 43}) {
    Random_numbers random(1);
    Points<Doubles> points;
    const double w = std::exp2(-log_gap - 2);
    for (int i = 0; i < 25; ++i) {
      const double x = (i % 5 + 0.1 * random()) / 5, y = (i / 5 + 0.1 * random()) / 5;
      for (int k = 0; k < 5; ++k) points.push_back({x + w * random(), y + w * random()});
    }
    const auto result = framed<Doubles>(points);
    CHECK(result.frames.size() == 26);
    const std::size_t squares = check_frames<Doubles>(points, result).split_squares;
    least = std::min(least, squares);
    most = std::max(most, squares);
  }
  CHECK(double(most) < 1.1 * double(least));
  CHECK(most < 200 * 25);
}

TEST_CASE("Clusters at the last bits get larger squares or none", "[clusters]") {
  // a pair of integers, one unit apart
  const std::int64_t x = (std::int64_t(1) << 55) - 12345;
  Points<Integers> points{{x, x}, {x + 1, x}, {x, x - 1000000}};
  auto result = framed<Integers>(points);
  CHECK(result.frames.size() == 2);
  CHECK(result.frames[1].exponent() == 10);
  check_frames<Integers>(points, result);
  points[2].y = x - 400000;
  result = framed<Integers>(points);
  CHECK(result.frames.size() == 1);
  CHECK(result.tree.points == std::vector<std::uint32_t>{0, 1, 2});
  // one in the last place of a double
  const Points<Doubles> doubles{{1, 1}, {1, 1 + 0x1p-52}, {0, 0}};
  const auto of_doubles = framed<Doubles>(doubles);
  CHECK(of_doubles.frames.size() == 2);
  CHECK(of_doubles.frames[1].exponent() == -41);
  check_frames<Doubles>(doubles, of_doubles);
}

TEST_CASE("None, one and two points have frames", "[clusters]") {
  CHECK(framed<Doubles>({}).frames.empty());
  for (double x : {0., 1e-300, 3., 1e200}) {
    const Points<Doubles> one{{x, -x}};
    CHECK(check_frames<Doubles>(one, framed<Doubles>(one)).bridges == 0);
    const Points<Doubles> two{{x, -x}, {x / 2 - 1, 0}};
    CHECK(check_frames<Doubles>(two, framed<Doubles>(two)).bridges == 0);
  }
  const Points<Integers> one{{7, -7}};
  check_frames<Integers>(one, framed<Integers>(one));
}

} // namespace test_frame_clusters
