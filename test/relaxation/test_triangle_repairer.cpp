// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What repair promises of meshes.

#include "catch.h"
#include "random_numbers.h"
#include "relaxation_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Triangle_repairer.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_triangle_repairer {

using namespace relaxation_test;

TEST_CASE("Repairs leave the triangles that they say, within the block", "[star_relaxer]") {
  int started = 0, ended = 0, inserted = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    Random_numbers random(seed);
    const Bounds& bounds = all_bounds[seed % 3];
    const Range range(bounds.low, bounds.high);
    Mesh mesh = equal_tiles(2);
    for (Ring& r : mesh.rings) {
      if (r.mobility == Mobility::FREE && random() < 0.12) r.mobility = Mobility::FIXED;
      if (random() < 0.02) r.block = -1;
    }
    // fixed ones are moved, too
    for (const Ring_vertex v : mesh.rings.ids())
      if (!mesh.rings[v].is_open)
        mesh.points[v] = {mesh.points[v].x + random.between(-0.12, 0.12),
                          mesh.points[v].y + random.between(-0.12, 0.12)};
    const std::vector<Ring_vertex> spare = append_spare(mesh, seed % 4 == 3 ? 2 : 60);
    const Mesh before = mesh;
    Workplace work(mesh, range);
    work.spare = spare;
    std::vector<Ring_vertex> vertices;
    for (const Ring_vertex v : mesh.rings.ids())
      if (mesh.is_alive(v) && work.patch.is_ours(v)) vertices.push_back(v);
    const std::size_t n = vertices.size();
    started += int(work.repairer.violated(vertices).size());
    const std::vector<Triangle> left = work.repairer.repair_all(vertices);
    ended += int(left.size());
    inserted += int(vertices.size() - n);
    check_disk(mesh);
    check_motion(before, mesh);
    // new vertices are appended, and no longer spare
    REQUIRE(work.spare.size() + vertices.size() - n == spare.size());
    for (std::size_t i = n; i < vertices.size(); ++i)
      REQUIRE(vertices[i] == spare[spare.size() - 1 - (i - n)]);
    for (const Ring_vertex v : work.spare) REQUIRE_FALSE(mesh.is_alive(v));
    for (const Ring_vertex v : before.rings.ids())
      if (before.rings[v].block < 0)
        REQUIRE((are_same_bits(before.rings[v], mesh.rings[v]) && before.points[v] == mesh.points[v]));
    // those whose least vertex is one of the others' are not asked for
    const Triangle_set bad(left.begin(), left.end());
    mesh.for_each_triangle([&](Ring_vertex a, Ring_vertex b, Ring_vertex c) {
      const double depth = depth_in(angles_of(mesh, {a, b, c}), bounds);
      if (!work.patch.is_ours(a)) return;
      if (depth < 0) REQUIRE(bad.count({a, b, c}) == 1);
      if (depth > 1e-2) REQUIRE(bad.count({a, b, c}) == 0);
    });
  }
  CHECK(started > 500);
  CHECK(ended < started / 10);
  CHECK(inserted > 10);
}

} // namespace test_triangle_repairer
