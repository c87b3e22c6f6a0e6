// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Fillings of holes against all triangulations; and what removal promises of meshes.

#include "catch.h"
#include "random_numbers.h"
#include "relaxation_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Vertex_remover.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace test_vertex_remover {

using namespace relaxation_test;

namespace {

/// The least energy of all triangulations of the polygon of positions i to j that have no triangle turned over;
/// infinite if there is none.
double least_energy(const std::vector<Vector>& p, std::size_t i, std::size_t j, const Range& range) {
  if (j - i < 2) return 0;
  double least = INFINITY;
  for (std::size_t k = i + 1; k < j; ++k) {
    const double own = double(Range_lanes(lanes_of(p[k] - p[i], p[j] - p[i]), range).energy[0]);
    if (own >= 900) continue;
    least = std::min(least, own + least_energy(p, i, k, range) + least_energy(p, k, j, range));
  }
  return least;
}

/// A vertex, 0, within or on the border of a polygon.
Mesh wheel(const std::vector<Vector>& polygon, bool is_open) {
  Mesh mesh;
  mesh.points.push_back({0, 0});
  std::vector<std::array<int, 3>> triangles;
  const int n = int(polygon.size());
  for (const Vector& p : polygon) mesh.points.push_back({p.x, p.y});
  for (int k = 1; k < n; ++k) triangles.push_back({0, k, k + 1});
  if (!is_open) triangles.push_back({0, n, 1});
  mesh.set_triangles(triangles);
  return mesh;
}

} // namespace

TEST_CASE("Holes are filled with the least energy", "[star_relaxer]") {
  int possible = 0, impossible = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    CAPTURE(seed);
    Random_numbers random(seed);
    const std::size_t n = 3 + seed % 6;
    const bool is_open = seed % 5 == 0;
    const Range range(seed % 2 == 0 ? 36 : 0, seed % 2 == 0 ? 80 : 89.5);
    std::vector<Vector> polygon;
    for (std::size_t k = 0; k < n; ++k) {
      const double angle = seed % 7 == 6 ? random.between(0, 6.28) // may be turned over
                           : is_open     ? 3.14159 * double(k) / double(n - 1)
                                         : 6.28318 * (double(k) + 0.4 * random()) / double(n);
      const double radius = seed % 3 == 0 ? random.between(0.2, 1) : random.between(0.8, 1);
      polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const Mesh mesh = wheel(polygon, is_open);
    const Star_vectors star(mesh, Ring_vertex(0));
    const Ring_triangulation filling(star, int(n), range);
    // the same vectors, as the star has rounded them
    std::vector<Vector> rounded;
    for (std::size_t k = 0; k < n; ++k) rounded.push_back({double(star.x[k]), double(star.y[k])});
    const double least = least_energy(rounded, 0, n - 1, range);
    REQUIRE(filling.is_possible() == (least < 1e5));
    ++(filling.is_possible() ? possible : impossible);
    if (!filling.is_possible()) continue;
    REQUIRE(double(filling.energy()) == Approx(least).epsilon(1e-4).margin(1e-4));
    // triangles of the polygon, as many as there have to be; each side that is not the polygon's is a diagonal
    REQUIRE(filling.triangles().size() == n - 2);
    REQUIRE(filling.diagonals().size() == n - 3);
    double energy = 0, area = 0, area_of_polygon = 0;
    std::set<std::pair<int, int>> diagonals(filling.diagonals().begin(), filling.diagonals().end());
    REQUIRE(diagonals.size() == n - 3);
    for (const auto& t : filling.triangles()) {
      REQUIRE((t[0] < t[1] && t[1] < t[2]));
      const Vector &p = rounded[std::size_t(t[0])], &q = rounded[std::size_t(t[1])],
                   &r = rounded[std::size_t(t[2])];
      energy += double(Range_lanes(lanes_of(q - p, r - p), range).energy[0]);
      REQUIRE(cross(q - p, r - p) > 0);
      area += cross(q - p, r - p);
      for (const auto& [a, b] : {std::pair<int, int>{t[0], t[1]}, {t[1], t[2]}, {t[0], t[2]}})
        REQUIRE((b == a + 1 || (a == 0 && b == int(n) - 1) || diagonals.count({a, b}) == 1));
    }
    for (std::size_t k = 0; k < n; ++k) area_of_polygon += cross(rounded[k], rounded[(k + 1) % n]);
    REQUIRE(energy == Approx(least).epsilon(1e-4).margin(1e-4));
    REQUIRE(area == Approx(area_of_polygon).margin(1e-5));
  }
  CHECK(possible > 1500);
  CHECK(impossible > 20);
}

TEST_CASE("Removals keep the range or change nothing", "[star_relaxer]") {
  int removed = 0, kept = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    CAPTURE(seed);
    Random_numbers random(seed);
    const Bounds& bounds = all_bounds[seed % 3];
    const Range range(bounds.low, bounds.high);
    Mesh mesh = equal_tiles(2);
    shake(mesh, random, 0.04);
    for (Ring& r : mesh.rings) {
      if (r.mobility == Mobility::FREE && random() < 0.1) r.mobility = Mobility::FIXED;
      if (random() < 0.05) r.block = -1;
      r.tried_rings = 7;
    }
    Workplace work(mesh, range);
    work.begin_with_all();
    if (!work.relaxer.relax(60, Patience::MUCH)) continue;
    const Mesh start = mesh;
    for (int round = 0; round < 3; ++round)
      for (const Ring_vertex i : mesh.rings.ids()) {
        const Ring_vertex v = Ring_vertex(i);
        if (!mesh.is_alive(v) || !work.patch.is_ours(v)) continue;
        Mesh before = mesh;
        const int rings = 1 + round;
        if (work.remover.remove(v, rings, 9)) {
          ++removed;
          REQUIRE_FALSE(mesh.is_alive(v));
          REQUIRE(internal::is_movable(before.ring(v).mobility));
          check_disk(mesh);
          REQUIRE(are_in_range(mesh, work.patch.members(), bounds));
          for (const Ring_vertex u : work.patch.members()) REQUIRE(mesh.ring(u).tried_rings == 0);
        } else {
          ++kept;
          if (!work.patch.is_cut()) REQUIRE(mesh.ring(v).tried_rings == rings);
          before.ring(v).tried_rings = mesh.ring(v).tried_rings;
          REQUIRE(are_same_bits(before, mesh));
        }
      }
    check_motion(start, mesh);
    for (const Ring_vertex v : start.rings.ids())
      if (start.rings[v].block < 0)
        REQUIRE((are_same_bits(start.rings[v], mesh.rings[v]) && start.points[v] == mesh.points[v]));
    // nothing has left the range
    const Angle_extremes e = angle_extremes(mesh), before = angle_extremes(start);
    REQUIRE(e.least >= std::min(bounds.low, before.least));
    REQUIRE(e.greatest <= std::max(bounds.high, before.greatest));
  }
  CHECK(removed > 100);
  CHECK(kept > 100);
}

TEST_CASE("No new triangles of rigid vertices are made", "[star_relaxer]") {
  const Range range(36, 80);
  const auto set_rigid = [](Mesh& mesh) {
    for (const int v : {0, 1, 2}) mesh.ring(Ring_vertex(v)).mobility = Mobility::RIGID;
  };
  { // by removing the vertex within, with which everything is worse
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {0.5, 0.3}, {0.5, 0.1}};
    mesh.set_triangles(std::vector<std::array<int, 3>>{{0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    set_rigid(mesh);
    const Mesh before = mesh;
    Workplace work(mesh, range);
    CHECK_FALSE(work.remover.remove(Ring_vertex(3), 1, 9));
    CHECK(triangles_of(mesh) == triangles_of(before));
    mesh.ring(Ring_vertex(0)).mobility = Mobility::FIXED;
    work.patch.begin();
    CHECK(work.remover.take_out(Ring_vertex(3)));
  }
  { // by flipping an edge, which makes an angle of 85 degrees instead of one of 107
    Mesh mesh;
    mesh.points = {{-1, 0}, {0, -1.09}, {1, 0}, {0, 1.7}};
    mesh.set_triangles(std::vector<std::array<int, 3>>{{1, 3, 0}, {3, 1, 2}});
    set_rigid(mesh);
    mesh.ring(Ring_vertex(3)).mobility = Mobility::FIXED;
    const Mesh before = mesh;
    Workplace work(mesh, range);
    work.begin_with_all();
    CHECK_FALSE(work.relaxer.relax(9, Patience::MUCH));
    CHECK(triangles_of(mesh) == triangles_of(before));
    work.begin_with_all();
    CHECK_FALSE(work.relaxer.flip_anyway(Ring_vertex(1), Ring_vertex(3), Ring_vertex(0)));
    mesh.ring(Ring_vertex(0)).mobility = Mobility::FIXED;
    work.begin_with_all();
    CHECK_FALSE(work.relaxer.relax(9, Patience::MUCH));
    const Ring_vertex a(0), b(1), c(2), d(3);
    CHECK(triangles_of(mesh) == Triangle_set{{a, b, c}, {a, c, d}});
  }
}

} // namespace test_vertex_remover
