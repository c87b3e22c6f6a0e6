// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes of points with clusters from tiles to the end.

#include "catch.h"
#include "cluster_test_tools.h"
#include "random_numbers.h"
#include "site_mesh_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/clusters/find_clusters.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/frame_clusters.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/exact_axis_parallel_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Site_mesh.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_clustered_site_mesh {

using namespace site_mesh_test;

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
    const auto clusters = internal::frame_clusters<CGAL::Sequential_tag, Doubles>(
        points, internal::find_clusters<CGAL::Sequential_tag, Doubles>(points, 2248));
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

} // namespace test_clustered_site_mesh
