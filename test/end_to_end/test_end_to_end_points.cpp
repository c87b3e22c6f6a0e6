// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Points to meshes, in each mode.

#include "catch.h"
#include "point_mesh_checks.h"
#include "point_sets.h"

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <string>

namespace test_end_to_end_points {

namespace {

using point_mesh_test::Options;

void check(const point_sets::Points& points, const Options& options) {
  CAPTURE(int(options.mode()));
  CGAL::Point_set_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag> mesher(options);
  const auto mesh = mesher(points);
  for (const std::string& fault : point_mesh_test::faults_of(mesh, points, options, mesher.report()))
    FAIL_CHECK(fault);
}

} // namespace

TEST_CASE("Points are meshed in each mode", "[end_to_end]") {
  using Domain = Options::Domain;
  // Sanitizers are slow where stars are moved again and again, and one input has all there is to find in that.
  const std::size_t n = is_full_run() ? 60 : 24;
  for (const point_sets::Named_points& input :
       {point_sets::Named_points{"uniform", quadtree_inputs::uniform(n, 1)},
        point_sets::Named_points{"clusters", point_sets::nested_clusters(n / 3, 1e-7, 1, 2)},
        point_sets::Named_points{"near pairs", point_sets::close_pairs(n / 3, 1e-5, 3)}}) {
    const int effort = is_full_run() || input.name == "uniform" ? 1 : 0;
    for (const Options& options :
         {Options().bounded_angles().effort(effort),
          Options().bounded_angles().effort(effort).mesh_domain(Domain::SQUARE),
          Options().acute().effort(effort), Options().least_angle(), Options().warped_squares()}) {
      CAPTURE(input.name);
      check(input.points, options);
    }
  }
}

TEST_CASE("A few points are meshed on threads", "[end_to_end][threads]") {
  const point_sets::Points points = quadtree_inputs::uniform(40, 1);
  for (const Options& options :
       {Options().bounded_angles().effort(0), Options().acute().effort(0), Options().warped_squares()})
    check(points, options);
}

} // namespace test_end_to_end_points
