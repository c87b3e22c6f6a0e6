// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes of points from tiles to the end: blocks, placing of sites, coarsening.

#include "catch.h"
#include "numbers_of_threads.h"
#include "site_mesh_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Site_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_forest.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_site_mesh {

using namespace site_mesh_test;

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
  for (const std::size_t threads : numbers_of_threads()) {
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

} // namespace test_site_mesh
