// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Some sets of points; test/soak.sh has them without end.

#include "catch.h"
#include "point_mesh_checks.h"
#include "point_sets.h"

#include <CGAL/Point_set_mesher_2.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace test_point_set_mesher_soak {

namespace {

using point_mesh_test::Options;
using Domain = Options::Domain;

/// Nearer to each other, points of the unit square may be refused, or have no room for angles between them.
constexpr double least_gap = 0x1p-40;

/// With all that makes a difference: least gaps around clusters, too.
std::vector<std::pair<std::string, Options>> all_options() {
  return {{"acute", Options().acute()},
          {"acute, many clusters", Options().acute().clusters(2248)},
          {"row", Options().bounded_angles()},
          {"square", Options().bounded_angles().mesh_domain(Domain::SQUARE)}};
}

/// What is wrong with the mesh; empty if nothing is.
std::string fault_of_mesh(const point_sets::Points& points, const Options& options) try {
  CGAL::Point_set_mesher_2<> mesher(options);
  const auto mesh = mesher(points);
  const std::vector<std::string> faults = point_mesh_test::faults_of(mesh, points, options, mesher.report());
  return faults.empty() ? std::string() : faults.front();
} catch (const std::exception& error) {
  return std::string("exception: ") + error.what();
}

} // namespace

TEST_CASE("Some random point sets are meshed as promised", "[point_set_mesher]") {
  std::size_t sets = 0;
  for (std::uint64_t seed = 0; sets < 4; ++seed) {
    const point_sets::Points points = point_sets::Random_small_set(seed)();
    if (point_sets::least_distance(points) < least_gap) continue;
    ++sets;
    for (const auto& [name, options] : all_options()) {
      CAPTURE(seed, name, points.size());
      CHECK(fault_of_mesh(points, options) == "");
    }
  }
}

} // namespace test_point_set_mesher_soak
