// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "point_mesh_checks.h"
#include "point_sets.h"

#include <CGAL/Point_set_mesher_2.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <atomic>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace test_point_set_mesher_parallel {

namespace {

using point_mesh_test::Options;
using point_sets::Points;
using Domain = Options::Domain;

template <class Tag>
using Mesher_of = CGAL::Point_set_mesher_2<CGAL::Filtered_quadtree_traits_2<>, Tag>;
using Mesh = Mesher_of<CGAL::Sequential_tag>::Mesh;

bool is_same(const Mesh& a, const Mesh& b) {
  return a.points == b.points && a.triangles == b.triangles && a.neighbors == b.neighbors &&
         a.vertex_markers == b.vertex_markers;
}

std::vector<std::pair<std::string, Options>> all_modes() {
  return {{"row", Options().bounded_angles().effort(1)},
          {"square", Options().bounded_angles().effort(1).mesh_domain(Domain::SQUARE)},
          {"acute", Options().acute().effort(1)},
          {"acute, many clusters", Options().acute().clusters(2248).effort(1)},
          {"budget", Options().acute().effort(1).max_removals(500)},
          {"least angle", Options().least_angle()},
          {"warped squares", Options().warped_squares()}};
}

/// More than one block of vertices each.
std::vector<point_sets::Named_points> inputs() {
  const std::size_t n = is_full_run() ? 3000 : 130;
  return {{"uniform", quadtree_inputs::uniform(n, 1)},
          {"clusters", point_sets::nested_clusters(n / 2, 1e-7, 1, 2)},
          {"near pairs", point_sets::close_pairs(n / 2, 1e-5, 3)},
          {"line", quadtree_inputs::line(n / 2, 4)}};
}

} // namespace

TEST_CASE("Meshes of points are the same with any number of threads and from run to run",
          "[point_set_mesher][parallel]") {
  for (const auto& [name, options] : all_modes())
    for (const auto& input : inputs()) {
      CAPTURE(name, input.name);
      if (!is_full_run() && (name == "square" || name == "acute" || name == "least angle")) continue;
      const Mesh sequential = Mesher_of<CGAL::Sequential_tag>(options)(input.points);
      for (const std::size_t threads :
           is_full_run() ? std::vector<std::size_t>{1, 2, 4} : std::vector<std::size_t>{4}) {
        CAPTURE(threads);
#ifdef CGAL_LINKED_WITH_TBB
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
#endif
        CHECK(is_same(Mesher_of<CGAL::Parallel_tag>(options)(input.points), sequential));
      }
      if (is_full_run()) CHECK(is_same(Mesher_of<CGAL::Sequential_tag>(options)(input.points), sequential));
    }
}

TEST_CASE("Cancelling meshes of points from several threads leaves valid ones",
          "[point_set_mesher][parallel]") {
  const Points points = quadtree_inputs::uniform(500, 5);
  for (const int most : {0, 1, 3}) {
    std::atomic<int> calls{0};
    const Options options =
        Options().bounded_angles().effort(1).progress([&](double) { return ++calls <= most; });
    Mesher_of<CGAL::Parallel_tag> mesher(options);
    const Mesh mesh = mesher(points);
    CHECK(mesher.report().is_cancelled);
    for (const std::string& fault : point_mesh_test::faults_of(mesh, points, options, mesher.report()))
      FAIL_CHECK(fault);
  }
}

} // namespace test_point_set_mesher_parallel
