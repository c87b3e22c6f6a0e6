// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Energies against angles by trigonometry, steps against finite differences; and what relaxation promises of meshes.

#include "catch.h"
#include "random_numbers.h"
#include "relaxation_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Angle_range.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Star_relaxer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_star_relaxer {

using namespace relaxation_test;

namespace {

double cotangent(double degrees) { return 1 / std::tan(degrees * degree); }
double squared(double x) { return x * x; }

/// As Angle_range.h says, for a margin of 1.
double energy_by_trigonometry(const std::array<double, 3>& angles, const Bounds& bounds) {
  double energy = 0;
  for (const double a : angles) {
    energy += squared(squared(std::sin(bounds.high * degree)) *
                      std::max(0., cotangent(bounds.high - 1) - cotangent(a)));
    if (bounds.low > 0)
      energy += squared(squared(std::sin(bounds.low * degree)) *
                        std::max(0., cotangent(a) - cotangent(bounds.low + 1)));
  }
  return energy;
}

} // namespace

TEST_CASE("Energies are those of the angles", "[star_relaxer]") {
  Random_numbers random(1);
  for (const Bounds& bounds : all_bounds) {
    CAPTURE(bounds.low, bounds.high);
    const Range range(bounds.low, bounds.high);
    int number_without = 0, number_in_range = 0;
    for (int i = 0; i < 20000; ++i) {
      Vector b{1, 0}, c{0, 0};
      const double turn = random.between(0, 6.28), size = std::exp2(random.between(-8, 8));
      // a third of the triangles near the range
      const double alpha = (i % 3 == 0 ? random.between(30, 95) : random.between(1, 178)) * degree,
                   beta = (i % 3 == 0 ? random.between(30, 95) : random.between(1, 178)) * degree;
      if (alpha + beta > 3.12) continue;
      const double length = std::sin(beta) / std::sin(alpha + beta);
      b = {size * std::cos(turn), size * std::sin(turn)};
      c = {size * length * std::cos(turn + alpha), size * length * std::sin(turn + alpha)};
      const Triangle_lanes t = lanes_of(b, c);
      const Range_lanes r(t, range);
      const auto angles = angles_at(b, c);
      const double expected = energy_by_trigonometry(angles, bounds), depth = depth_in(angles, bounds);
      CAPTURE(i, alpha / degree, beta / degree);
      const double least = *std::min_element(angles.begin(), angles.end());
      if (least < 0.5) continue; // may count as flat
      if (std::fabs(r.energy[0] - expected) > 1e-5 + 1e-3 * expected)
        FAIL("energy " << r.energy[0] << " " << expected);
      if (depth > 1 + 1e-3 && r.energy[0] != 0) FAIL("energy inside");
      if (depth < 1 - 1e-2 && r.energy[0] == 0) FAIL("no energy outside the margin");
      number_without += r.energy[0] == 0 ? 1 : 0;
      const bool is_in_range = r.slack(t, range)[0] >= 0;
      if (is_in_range && depth < 0) FAIL("in the range though not in it by " << depth);
      if (!is_in_range && depth > 5e-3) FAIL("not in the range though in it by " << depth);
      number_in_range += is_in_range ? 1 : 0;
      for (int k = 0; k < Float_lanes::size; ++k)
        if (r.energy[k] != r.energy[0]) FAIL("lanes differ");
    }
    CHECK(number_without > 500);
    CHECK(number_in_range > number_without);
  }
}

TEST_CASE("What counts as in the range is in the exact range", "[star_relaxer]") {
  // as narrowly as floats go, from all three corners and in all sizes
  Random_numbers random(2);
  for (const Bounds& bounds : all_bounds) {
    CAPTURE(bounds.low, bounds.high);
    const Range range(bounds.low, bounds.high);
    const double least = std::max(bounds.low, 180 - 2 * bounds.high);
    int number_in_range = 0;
    for (int i = 0; i < 200000; ++i) {
      // one angle is next to a bound, another anything between
      const double first =
          (i % 2 == 0 && bounds.low > 0 ? bounds.low : bounds.high) + random.between(-4e-3, 4e-3);
      const double second = i % 5 == 0 ? bounds.high - random.between(0, 4e-3)
                                       : random.between(least, std::min(bounds.high, 180 - first - least));
      const double a[] = {first, second, 180 - first - second};
      const double alpha = a[i % 3] * degree, beta = a[(i + 1) % 3] * degree;
      const double turn = random.between(0, 6.28), length = std::sin(beta) / std::sin(alpha + beta);
      const Vector b{std::cos(turn), std::sin(turn)},
          c{length * std::cos(turn + alpha), length * std::sin(turn + alpha)};
      const Triangle_lanes t = lanes_of(b, c);
      if (Range_lanes(t, range).slack(t, range)[0] < 0) continue;
      ++number_in_range;
      const double depth = depth_in(angles_at(b, c), bounds);
      if (depth < 0) FAIL("outside by " << depth << " at angles " << a[0] << " " << a[1] << " " << a[2]);
    }
    CHECK(number_in_range > 20000);
  }
}

TEST_CASE("Flat triangles and those turned over have great energies", "[star_relaxer]") {
  const Range range(36, 80);
  const auto energy = [&](Vector b, Vector c) { return Range_lanes(lanes_of(b, c), range).energy[0]; };
  CHECK(energy({1, 0}, {1, 0}) >= 1000);
  CHECK(energy({1, 0}, {0.5, 1e-6}) >= 999);
  CHECK(energy({1, 0}, {0.5, 0}) == 1000);
  CHECK(energy({1, 0}, {0.5, -0.1}) > 1000);
  CHECK(energy({1, 0}, {0.5, -0.5}) > energy({1, 0}, {0.5, -0.1})); // the worse the more
  for (const Vector c : {Vector{1, 0}, Vector{0.5, 0}, Vector{-1, 0}, Vector{0.5, -0.8}}) {
    const Triangle_lanes t = lanes_of({1, 0}, c);
    CHECK(Range_lanes(t, range).slack(t, range)[0] < 0);
  }
}

TEST_CASE("Gradients of stars are those of finite differences", "[star_relaxer]") {
  int number_of_stars = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random_numbers random(seed);
    const Bounds& bounds = all_bounds[seed % all_bounds.size()];
    const Range range(bounds.low, bounds.high);
    Mesh mesh = lattice(5, 5);
    shake(mesh, random, 0.2);
    for (const Ring_vertex v : mesh.rings.ids()) {
      const Star_vectors star(mesh, v);
      const Star_energy e(star, range);
      // in doubles, with the center moved; the energies of floats are too coarse to be subtracted
      const auto energy_at = [&](double dx, double dy) {
        double sum = 0;
        for (int k = 0; k < star.number_of_triangles; ++k)
          sum += energy_by_trigonometry(angles_at({double(star.x[k]) - dx, double(star.y[k]) - dy},
                                                  {double(star.x[k + 1]) - dx, double(star.y[k + 1]) - dy}),
                                        bounds);
        return sum;
      };
      if (e.has_flat || e.energy == 0) continue;
      REQUIRE(double(e.energy) == Approx(energy_at(0, 0)).epsilon(1e-3).margin(1e-6));
      REQUIRE(double(star.energy(range, 0, 0)) == Approx(double(e.energy)).epsilon(1e-5));
      const double h = 1e-5;
      REQUIRE(double(e.gx) ==
              Approx((energy_at(h, 0) - energy_at(-h, 0)) / (4 * h)).epsilon(1e-2).margin(1e-4));
      REQUIRE(double(e.gy) ==
              Approx((energy_at(0, h) - energy_at(0, -h)) / (4 * h)).epsilon(1e-2).margin(1e-4));
      REQUIRE(e.hxx >= 0);
      REQUIRE(e.hyy >= 0);
      REQUIRE(double(e.hxx) * double(e.hyy) >= double(e.hxy) * double(e.hxy) * (1 - 1e-5) - 1e-9);
      // the energy of the star elsewhere
      const float there = star.energy(range, 0.05f, -0.03f);
      if (there < 900) {
        REQUIRE(double(there) == Approx(energy_at(double(0.05f), double(-0.03f))).epsilon(1e-3).margin(1e-5));
      }
      ++number_of_stars;
    }
  }
  CHECK(number_of_stars > 200);
}

TEST_CASE("A star tells which of its triangles are violated", "[star_relaxer]") {
  Random_numbers random(5);
  for (const Bounds& bounds : all_bounds) {
    const Range range(bounds.low, bounds.high);
    Mesh mesh = lattice(6, 6);
    shake(mesh, random, 0.3);
    for (const Ring_vertex i : mesh.rings.ids()) {
      const Ring_vertex v = Ring_vertex(i);
      const Ring& r = mesh.ring(v);
      const Star_vectors star(mesh, v);
      const unsigned violated = star.violated(range);
      REQUIRE(star.is_in_range(range) == (violated == 0));
      REQUIRE(violated >> r.number_of_triangles() == 0);
      for (int k = 0; k < r.number_of_triangles(); ++k) {
        const double depth = depth_in(angles_of(mesh, {v, r[k], r.next(k)}), bounds);
        if (depth < 0) REQUIRE((violated >> k & 1) == 1);
        if (depth > 1e-2) REQUIRE((violated >> k & 1) == 0);
      }
    }
  }
}

TEST_CASE("Relaxation says only of meshes in the range that they are", "[star_relaxer]") {
  int relaxed = 0, not_relaxed = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    Random_numbers random(seed);
    const Bounds& bounds = all_bounds[seed % 3];
    const Range range(bounds.low, bounds.high);
    Mesh mesh = equal_tiles(2);
    shake(mesh, random, 0.03 * double(1 + seed % 8));
    for (Ring& r : mesh.rings) {
      if (r.mobility != Mobility::FREE) continue;
      if (random() < 0.04) r.mobility = random() < 0.5 ? Mobility::FIXED : Mobility::HELD;
      if (random() < 0.03) r.block = -1;
    }
    const Mesh before = mesh;
    Workplace work(mesh, range);
    work.begin_with_all();
    const bool is_relaxed = work.relaxer.relax(30, Patience::MUCH);
    check_disk(mesh);
    check_motion(before, mesh);
    for (const Ring_vertex v : mesh.rings.ids())
      if (before.rings[v].block < 0)
        REQUIRE((are_same_bits(before.rings[v], mesh.rings[v]) && before.points[v] == mesh.points[v]));
    if (is_relaxed) REQUIRE(are_in_range(mesh, work.patch.members(), bounds));
    if (!is_relaxed)
      REQUIRE_FALSE(are_in_range(mesh, work.patch.members(), {bounds.low + 0.01, bounds.high - 0.01}));
    ++(is_relaxed ? relaxed : not_relaxed);
    work.patch.undo();
    REQUIRE(are_same_bits(mesh, before));
  }
  CHECK(relaxed > 30);
  CHECK(not_relaxed > 5);
}

TEST_CASE("Steps lower the energy of stars", "[star_relaxer]") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Random_numbers random(seed);
    const Range range(36, 80);
    Mesh mesh = equal_tiles(2);
    shake(mesh, random, seed % 3 == 0 ? 0.4 : 0.1); // some are turned over
    Workplace work(mesh, range);
    work.begin_with_all();
    for (const Ring_vertex v : work.patch.members()) {
      const auto p = mesh.point(v);
      const float before = Star_vectors(mesh, v).energy(range, 0, 0);
      const float returned = work.relaxer.step(v);
      const float after = Star_vectors(mesh, v).energy(range, 0, 0);
      REQUIRE(double(returned) == Approx(double(before)).epsilon(1e-5));
      if (mesh.point(v) == p) continue;
      REQUIRE(internal::is_movable(mesh.ring(v).mobility));
      REQUIRE(double(after) < double(before) * (1 + 1e-4));
    }
  }
}

TEST_CASE("Vertices slide along turned borders", "[star_relaxer]") {
  const Vector u{0.8, 0.6};
  const auto turned = [&](const Doubles::Point& p) {
    return Doubles::Point{u.x * p.x - u.y * p.y, u.y * p.x + u.x * p.y};
  };
  Random_numbers random(3);
  const Range range(36, 80);
  Mesh mesh = equal_tiles(2);
  const double side = 4;
  shake(mesh, random, 0.05);
  for (auto& p : mesh.points) p = turned(p);
  mesh.along = u;
  Workplace work(mesh, range);
  work.begin_with_all();
  const bool is_relaxed = work.relaxer.relax(30, Patience::MUCH);
  CHECK(is_relaxed == are_in_range(mesh, work.patch.members(), {36, 80}));
  for (const Ring_vertex v : mesh.rings.ids()) {
    const auto& p = mesh.points[v];
    const double x = u.x * p.x + u.y * p.y, y = u.x * p.y - u.y * p.x;
    if (mesh.rings[v].mobility == Mobility::SLIDES_ALONG)
      REQUIRE(std::min(std::fabs(y), std::fabs(y - side)) < 1e-14);
    if (mesh.rings[v].mobility == Mobility::SLIDES_ACROSS)
      REQUIRE(std::min(std::fabs(x), std::fabs(x - side)) < 1e-14);
  }
}

TEST_CASE("Nothing is asked of triangles of rigid vertices", "[star_relaxer]") {
  const Bounds bounds{30, 85};
  int relaxed = 0;
  const Range range(bounds.low, bounds.high);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    Random_numbers random(seed);
    Mesh mesh = equal_tiles(2);
    // a triangle that is not in the range, with vertices that are rigid, in the middle of the mesh
    const auto middle = std::find_if(mesh.points.begin(), mesh.points.end(), [](const Doubles::Point& p) {
      return std::fabs(p.x - 2.1) < 0.3 && std::fabs(p.y - 1.9) < 0.3;
    });
    const Ring_vertex a = Ring_vertex(middle - mesh.points.begin());
    const int k = int(seed) % mesh.ring(a).size;
    const Ring_vertex b = mesh.ring(a)[k], c = mesh.ring(a).next(k);
    const Vector far =
        Doubles::difference(mesh.point(a), mesh.point(b)) + Doubles::difference(mesh.point(a), mesh.point(c));
    mesh.points[a] = Doubles::translate(mesh.point(a), (-0.25 - 0.01 * double(seed % 5)) * far);
    for (const Ring_vertex v : {a, b, c}) mesh.ring(v).mobility = Mobility::RIGID;
    const auto angles = angles_of(mesh, {a, b, c});
    REQUIRE(depth_in(angles, bounds) < -0.1);
    const Mesh before = mesh;
    Workplace work(mesh, range);
    work.begin_with_all();
    const bool is_relaxed = work.relaxer.relax(40, Patience::MUCH);
    CHECK(is_relaxed == are_in_range(mesh, work.patch.members(), bounds));
    CHECK(angles_of(mesh, {a, b, c}) == angles);
    CHECK(has_triangle(mesh, a, b, c));
    check_motion(before, mesh);
    check_disk(mesh);
    std::vector<Ring_vertex> all;
    for (const Ring_vertex v : mesh.rings.ids()) all.push_back(v);
    if (!is_relaxed) continue;
    ++relaxed;
    CHECK(work.repairer.violated(all).empty());
    // with a vertex less of the kind it counts
    mesh.ring(a).mobility = Mobility::FIXED;
    CHECK(work.repairer.violated(all) == std::vector<Triangle>{canonical({a, b, c})});
  }
  CHECK(relaxed > 10);
}

TEST_CASE("Rigid vertices may have neighbors of very different distance", "[star_relaxer]") {
  // a vertex of an octagon: two spokes far away, two vertices beside it, two near it
  for (const double far : {0x1p10, 0x1p40, 0x1p70, 0x1p130, 0x1p300}) {
    CAPTURE(far);
    Mesh mesh;
    const double h = std::sqrt(0.75);
    mesh.points = {{0, 0},    {far, -far / 2}, {far, far / 2}, {0.5, h},
                   {-0.5, h}, {-1, 0},         {-0.5, -h},     {0.5, -h}};
    std::vector<std::array<int, 3>> triangles;
    for (int k = 1; k < 8; ++k) triangles.push_back({0, k, k % 7 + 1});
    mesh.set_triangles(triangles);
    for (const int v : {0, 1, 2, 3, 7}) mesh.ring(Ring_vertex(v)).mobility = Mobility::RIGID;
    const Range range(36, 80);
    const Star_vectors star(mesh, Ring_vertex(0));
    CHECK(star.is_in_range(range));
    CHECK(star.violated(range) == 0);
    CHECK(star.energy(range, 0, 0) == 0);
    mesh.points[Ring_vertex(4)].x = -0.9; // too far from 3, too near to 5
    const Star_vectors bad(mesh, Ring_vertex(0));
    CHECK(bad.violated(range) == 0b1000);
    CHECK(bad.energy(range, 0, 0) > 0);
    CHECK(bad.energy(range, 0, 0) < 10);
  }
}

} // namespace test_star_relaxer
