// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Energies against angles by trigonometry, steps against finite differences, fillings of holes against all
// triangulations; and what relaxation, removal and repair promise of meshes.

#include "catch.h"
#include "random_numbers.h"
#include "ring_mesh_checks.h"

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Angle_range.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Star_relaxer.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Triangle_repairer.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Vertex_remover.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

using namespace ring_test;
using internal::Float_lanes;
using internal::Patch_marks;
using internal::Patience;
using internal::Range_lanes;
using internal::Ring_triangulation;
using internal::Star_energy;
using internal::Star_vectors;
using internal::Triangle_lanes;

namespace {

using Mesh = Ring_mesh<Doubles>;
using Range = internal::Angle_range;
using Patch = internal::Ring_patch<Doubles>;
using Relaxer = internal::Star_relaxer<Doubles>;
using Remover = internal::Vertex_remover<Doubles>;
using Repairer = internal::Triangle_repairer<Doubles>;

constexpr double degree = 0.017453292519943295;

struct Bounds {
  double low, high;
};
const std::array<Bounds, 4> all_bounds{{{36, 80}, {30, 89.5}, {0, 89.5}, {20, 95}}};

Triangle_lanes lanes_of(Vector b, Vector c) {
  const auto all = [](double x) { return Float_lanes(static_cast<float>(x)); };
  return Triangle_lanes(all(b.x), all(b.y), all(c.x), all(c.y));
}

/// In degrees, of the triangle 0, b, c.
std::array<double, 3> angles_at(Vector b, Vector c) {
  const auto angle = [](Vector u, Vector v) { return std::atan2(cross(u, v), dot(u, v)) / degree; };
  return {angle(b, c), angle(c - b, Vector() - b), angle(Vector() - c, b - c)};
}

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

/// How far the angles are inside the range; negative outside.
double depth_in(const std::array<double, 3>& angles, const Bounds& bounds) {
  return std::min(*std::min_element(angles.begin(), angles.end()) - bounds.low,
                  bounds.high - *std::max_element(angles.begin(), angles.end()));
}

/// A patch of all vertices of a mesh, and what works on it.
struct Workplace {
  Workplace(Mesh& m, const Range& range, std::int32_t block = 0)
      : marks(m.number_of_vertices()), patch(m, marks, block), relaxer(patch, range), remover(patch, relaxer),
        repairer(patch, relaxer, remover, spare) {}

  void begin_with_all() {
    patch.begin();
    for (std::size_t v = 0; v < patch.mesh().number_of_vertices(); ++v)
      if (patch.mesh().is_alive(Ring_vertex(v)) && patch.is_ours(Ring_vertex(v))) patch.add(Ring_vertex(v));
    for (const Ring_vertex v : patch.members()) patch.activate(v);
  }

  std::vector<Patch_marks> marks;
  std::vector<Ring_vertex> spare;
  Patch patch;
  Relaxer relaxer;
  Remover remover;
  Repairer repairer;
};

void shake(Mesh& mesh, Random_numbers& random, double amount) {
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Mobility m = mesh.rings[v].mobility;
    const double dx = random.between(-amount, amount), dy = random.between(-amount, amount);
    if (m == Mobility::FREE || m == Mobility::SLIDES_ALONG) mesh.points[v].x += dx;
    if (m == Mobility::FREE || m == Mobility::SLIDES_ACROSS) mesh.points[v].y += dy;
  }
}

/// Borders do not move but along themselves, and fixed vertices not at all.
void check_motion(const Mesh& before, const Mesh& after) {
  for (std::size_t v = 0; v < before.number_of_vertices(); ++v) {
    const Mobility m = before.rings[v].mobility;
    if (m == Mobility::FREE || m == Mobility::REMOVED) continue;
    if (after.rings[v].mobility == Mobility::REMOVED) {
      if (!internal::is_movable(m)) FAIL("a fixed vertex is gone");
      continue;
    }
    if (m != Mobility::SLIDES_ALONG && before.points[v].x != after.points[v].x) FAIL("moved in x");
    if (m != Mobility::SLIDES_ACROSS && before.points[v].y != after.points[v].y) FAIL("moved in y");
  }
}

bool are_rigid(const Mesh& mesh, const Triangle& t) {
  return std::all_of(t.begin(), t.end(),
                     [&](Ring_vertex v) { return mesh.ring(v).mobility == Mobility::RIGID; });
}

/// Whether the triangles at the given vertices are in the range, by trigonometry, up to the rounding of that.
template <class Vertices>
bool are_in_range(const Mesh& mesh, const Vertices& vertices, const Bounds& bounds) {
  const std::set<Ring_vertex> asked(vertices.begin(), vertices.end());
  const Angle_extremes e = angle_extremes(mesh, [&](const Triangle& t) {
    return !are_rigid(mesh, t) && asked.count(t[0]) + asked.count(t[1]) + asked.count(t[2]) > 0;
  });
  return e.least >= bounds.low && e.greatest <= bounds.high;
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
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
      const Star_vectors star(mesh, Ring_vertex(v));
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
    for (std::size_t i = 0; i < mesh.number_of_vertices(); ++i) {
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
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
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
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
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
    mesh.points[std::size_t(a)] = Doubles::translate(mesh.point(a), (-0.25 - 0.01 * double(seed % 5)) * far);
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
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) all.push_back(Ring_vertex(v));
    if (!is_relaxed) continue;
    ++relaxed;
    CHECK(work.repairer.violated(all).empty());
    // with a vertex less of the kind it counts
    mesh.ring(a).mobility = Mobility::FIXED;
    CHECK(work.repairer.violated(all) == std::vector<Triangle>{canonical({a, b, c})});
  }
  CHECK(relaxed > 10);
}

TEST_CASE("No new triangles of rigid vertices are made", "[star_relaxer]") {
  const Range range(36, 80);
  const auto set_rigid = [](Mesh& mesh) {
    for (const Ring_vertex v : {0, 1, 2}) mesh.ring(v).mobility = Mobility::RIGID;
  };
  { // by removing the vertex within, with which everything is worse
    Mesh mesh;
    mesh.points = {{0, 0}, {1, 0}, {0.5, 0.3}, {0.5, 0.1}};
    mesh.set_triangles(std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    set_rigid(mesh);
    const Mesh before = mesh;
    Workplace work(mesh, range);
    CHECK_FALSE(work.remover.remove(3, 1, 9));
    CHECK(triangles_of(mesh) == triangles_of(before));
    mesh.ring(0).mobility = Mobility::FIXED;
    work.patch.begin();
    CHECK(work.remover.take_out(3));
  }
  { // by flipping an edge, which makes an angle of 85 degrees instead of one of 107
    Mesh mesh;
    mesh.points = {{-1, 0}, {0, -1.09}, {1, 0}, {0, 1.7}};
    mesh.set_triangles(std::vector<Triangle>{{1, 3, 0}, {3, 1, 2}});
    set_rigid(mesh);
    mesh.ring(3).mobility = Mobility::FIXED;
    const Mesh before = mesh;
    Workplace work(mesh, range);
    work.begin_with_all();
    CHECK_FALSE(work.relaxer.relax(9, Patience::MUCH));
    CHECK(triangles_of(mesh) == triangles_of(before));
    work.begin_with_all();
    CHECK_FALSE(work.relaxer.flip_anyway(1, 3, 0));
    mesh.ring(0).mobility = Mobility::FIXED;
    work.begin_with_all();
    CHECK_FALSE(work.relaxer.relax(9, Patience::MUCH));
    CHECK(triangles_of(mesh) == Triangle_set{{0, 1, 2}, {0, 2, 3}});
  }
}

TEST_CASE("Rigid vertices may have neighbors of very different distance", "[star_relaxer]") {
  // a vertex of an octagon: two spokes far away, two vertices beside it, two near it
  for (const double far : {0x1p10, 0x1p40, 0x1p70, 0x1p130, 0x1p300}) {
    CAPTURE(far);
    Mesh mesh;
    const double h = std::sqrt(0.75);
    mesh.points = {{0, 0},    {far, -far / 2}, {far, far / 2}, {0.5, h},
                   {-0.5, h}, {-1, 0},         {-0.5, -h},     {0.5, -h}};
    std::vector<Triangle> triangles;
    for (Ring_vertex k = 1; k < 8; ++k) triangles.push_back({0, k, k % 7 + 1});
    mesh.set_triangles(triangles);
    for (const Ring_vertex v : {0, 1, 2, 3, 7}) mesh.ring(v).mobility = Mobility::RIGID;
    const Range range(36, 80);
    const Star_vectors star(mesh, 0);
    CHECK(star.is_in_range(range));
    CHECK(star.violated(range) == 0);
    CHECK(star.energy(range, 0, 0) == 0);
    mesh.points[4].x = -0.9; // too far from 3, too near to 5
    const Star_vectors bad(mesh, 0);
    CHECK(bad.violated(range) == 0b1000);
    CHECK(bad.energy(range, 0, 0) > 0);
    CHECK(bad.energy(range, 0, 0) < 10);
  }
}

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
  std::vector<Triangle> triangles;
  const Ring_vertex n = Ring_vertex(polygon.size());
  for (const Vector& p : polygon) mesh.points.push_back({p.x, p.y});
  for (Ring_vertex k = 1; k < n; ++k) triangles.push_back({0, k, k + 1});
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
    const Star_vectors star(mesh, 0);
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
      for (std::size_t i = 0; i < mesh.number_of_vertices(); ++i) {
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
    for (std::size_t v = 0; v < start.number_of_vertices(); ++v)
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
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      if (!mesh.rings[v].is_open)
        mesh.points[v] = {mesh.points[v].x + random.between(-0.12, 0.12),
                          mesh.points[v].y + random.between(-0.12, 0.12)};
    const std::vector<Ring_vertex> spare = append_spare(mesh, seed % 4 == 3 ? 2 : 60);
    const Mesh before = mesh;
    Workplace work(mesh, range);
    work.spare = spare;
    std::vector<Ring_vertex> vertices;
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      if (mesh.is_alive(Ring_vertex(v)) && work.patch.is_ours(Ring_vertex(v)))
        vertices.push_back(Ring_vertex(v));
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
    for (std::size_t v = 0; v < before.number_of_vertices(); ++v)
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
