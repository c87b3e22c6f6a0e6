// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Sites that fail get blocks of tiles in which nothing can fail.

#include "catch.h"
#include "site_mesh_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Site_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_forest.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace test_tile_forest {

using namespace site_mesh_test;

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
      forest.find_leaves();
      int failures = 0;
      for (; !forest.is_certified(i); ++failures) forest.refine_for(i);
      CHECK(failures == 3);
      CHECK(forest.number_of_certified_points() == 1);
      const Site_mesh<Doubles> mesh = fill(forest);
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
    forest.find_leaves();
    for (std::size_t i = 0; i < points.size(); ++i)
      while (!forest.is_certified(i)) forest.refine_for(i);
    CHECK(forest.number_of_certified_points() == points.size());
    Site_mesh<Doubles> mesh = fill(forest);
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

} // namespace test_tile_forest
