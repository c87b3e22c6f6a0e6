// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "point_mesh_checks.h"
#include "point_sets.h"

#include <CGAL/Point_set_mesher_2.h>

#include <cstddef>
#include <cstdint>
#include <string>

/// A concurrency tag that cuts small meshes of points into blocks.
struct Tiny_ring_blocks_tag {};

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <>
struct Ring_block_sizes<Tiny_ring_blocks_tag> {
  static constexpr std::size_t vertices = 150;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

namespace test_point_set_mesher_blocks {

namespace {

using point_mesh_test::Options;
using Domain = Options::Domain;

void mesh_in_tiny_blocks(const point_sets::Points& points) {
  for (const Options& options : {Options().acute(), Options().bounded_angles(),
                                 Options().bounded_angles().mesh_domain(Domain::SQUARE)}) {
    CGAL::Point_set_mesher_2<CGAL::Filtered_quadtree_traits_2<>, Tiny_ring_blocks_tag> mesher(options);
    const auto mesh = mesher(points);
    CAPTURE(int(options.mode()), int(options.mesh_domain()));
    for (const std::string& fault : point_mesh_test::faults_of(mesh, points, options, mesher.report()))
      FAIL_CHECK(fault);
  }
}

} // namespace

TEST_CASE("Points of all kinds are meshed as promised in tiny blocks", "[point_set_mesher]") {
  for (const auto& input : point_sets::nasty(is_full_run() ? 10 : 1)) {
    CAPTURE(input.name);
    mesh_in_tiny_blocks(input.points);
  }
}

TEST_CASE("Some random point sets are meshed as promised in tiny blocks", "[point_set_mesher]") {
  const std::uint64_t first = 7000, last = first + (is_full_run() ? 300 : 5);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const point_sets::Points points = point_sets::Random_small_set(seed)();
    if (point_sets::least_distance(points) < 0x1p-40) continue; // may be refused
    CAPTURE(seed);
    mesh_in_tiny_blocks(points);
  }
}

} // namespace test_point_set_mesher_blocks
