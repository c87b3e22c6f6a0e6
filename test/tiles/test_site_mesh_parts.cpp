// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes of sites in parts, at the seams where they are joined.

#include "catch.h"
#include "site_mesh_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/tiles/Site_mesh_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_forest.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

/// A concurrency tag with short runs of leaves, and blocks of vertices of full size.
struct Short_runs_tag {};

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <>
struct Tile_run_sizes<Short_runs_tag> {
  static constexpr std::size_t leaves = 4096;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

namespace test_site_mesh_parts {

using namespace site_mesh_test;

namespace {

/// The places of the vertices that are more than `rings` rings away from each site that waits.
std::vector<Point> places_far_from_waiting(const Site_mesh<Doubles>& mesh, int rings) {
  std::set<Ring_vertex> near;
  for (std::size_t s = 0; s < mesh.sites.size(); ++s)
    if (mesh.is_placed[s] == 0) near.insert(mesh.vertex_of_site[s]);
  for (; rings > 0; --rings) {
    const std::vector<Ring_vertex> inner(near.begin(), near.end());
    for (const Ring_vertex v : inner) {
      const Ring& r = mesh.mesh.ring(v);
      for (int k = 0; k < r.size; ++k) near.insert(r[k]);
    }
  }
  std::vector<Point> result;
  for (const Ring_vertex v : mesh.mesh.rings.ids())
    if (mesh.mesh.is_alive(v) && near.count(v) == 0) result.push_back(mesh.mesh.point(v));
  return result;
}

} // namespace

TEST_CASE("Sites at seams of parts find room, and nobody moves what was coarsened elsewhere", "[site_mesh]") {
  const Points points = uniform(1400, 21);
  const internal::Angle_range range(best.low, best.high);
  using Relaxer = internal::Site_mesh_relaxer<Short_runs_tag, Doubles>;
  const auto frame = Grid_frame<Doubles>::axis_parallel<Short_runs_tag>(points);
  Tile_forest<Short_runs_tag, Doubles> forest(points, frame, options_for(best));
  forest.find_leaves();
  REQUIRE(forest.number_of_runs() > 1);
  internal::Site_mesh_parts<Short_runs_tag, Doubles> parts;
  const auto coarsen = [&](Site_mesh<Doubles>& mesh, std::size_t) {
    Relaxer(mesh, range).coarsen(Coarsening_effort(), [](double) { return true; });
  };
  REQUIRE(parts.make(forest, range, coarsen).empty());
  Site_mesh<Doubles> mesh = parts.joined(forest);
  constexpr int rings_of_repair = 4;
  const std::vector<Point> far =
      places_far_from_waiting(mesh, 2 * internal::rings_of_placing + rings_of_repair);
  CHECK(far.size() > 100);
  CHECK(Relaxer(mesh, range).place_sites([](std::size_t) { return true; }).empty());
  check_sites(mesh, points);
  check_angles(mesh.mesh, best);
  std::set<std::pair<double, double>> places;
  for (const Ring_vertex v : mesh.mesh.rings.ids())
    if (mesh.mesh.is_alive(v)) places.insert({mesh.mesh.point(v).x, mesh.mesh.point(v).y});
  for (const Point& p : far) REQUIRE(places.count({p.x, p.y}) == 1);
}

} // namespace test_site_mesh_parts
