// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Vertices amid equal leaves: windows beside CGAL's triangulations, and least angles looked for by random search and by
// random descent from the worst cases. That there are no smaller ones is proven in test_vertex_certificate.cpp.

#include "catch.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Vertex_window.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace test_vertex_window {

namespace {

using namespace CGAL::Quadtree_mesh_2::internal;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;
using Point = Kernel::Point_2;

Window_point direction_of(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// A sector, or with the other directions a whole vertex; angles in radians.
struct Sector {
  Window_point vertex;
  double first, size;
};

struct Random {
  std::mt19937_64 generator;
  double operator()() { return std::uniform_real_distribution<double>(0, 1)(generator); }
  std::uint64_t below(std::uint64_t n) { return generator() % n; }

  /// Also on grid lines, diagonals and corners, with edges along them.
  Window_point vertex() {
    Window_point v{(*this)(), (*this)()};
    const auto kind = below(8);
    if (kind == 1) v.x = double(below(2)) / 2;
    if (kind == 2) v.x = v.y;
    if (kind == 3) v = {0, 0};
    return v;
  }
  double direction() { return below(4) == 0 ? double(below(8)) * CGAL_PI / 4 : 2 * CGAL_PI * (*this)(); }
  Sector sector(double least, double greatest) {
    const double share = (*this)();
    const double size = below(6) == 0 ? least : least + (greatest - least) * share * share;
    return {vertex(), direction(), size * CGAL_PI / 180};
  }
  Sector near(Sector s, double step, double least, double greatest) {
    const auto move = [&](double& value) { value += step * ((*this)() - 0.5); };
    move(s.vertex.x);
    move(s.vertex.y);
    move(s.first);
    if (below(3) > 0) move(s.size);
    s.size = std::min(std::max(s.size, least * CGAL_PI / 180), greatest * CGAL_PI / 180);
    return s;
  }
};

double least_angle(const Sector& s) {
  Vertex_window window(s.vertex, direction_of(s.first), direction_of(s.first + s.size));
  return window.least_angle(sector_thresholds[window.best_of(sector_thresholds)]);
}

/// The least angle of the worst sectors of `n`, after descent from the worst few.
double worst_angle(Random& random, int n, int descents, int steps, double least, double greatest) {
  std::vector<std::pair<double, Sector>> worst;
  for (int i = 0; i < n; ++i) {
    const Sector s = random.sector(least, greatest);
    worst.push_back({least_angle(s), s});
  }
  const auto is_worse = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::sort(worst.begin(), worst.end(), is_worse);
  for (int i = 0; i < descents; ++i) {
    auto& w = worst[static_cast<std::size_t>(i)];
    for (int k = 0; k < steps; ++k) {
      const Sector s = random.near(w.second, 0.3 * std::pow(10, -3 * random()), least, greatest);
      w = std::min(w, std::make_pair(least_angle(s), s), is_worse);
    }
  }
  return std::min_element(worst.begin(), worst.end(), is_worse)->first;
}

/// The edges of a vertex, and the thresholds of the sector after each.
struct Vertex {
  Window_point place;
  std::vector<double> directions;

  Window_point direction(std::size_t i) const { return direction_of(directions[i % directions.size()]); }
};

Vertex random_vertex(Random& random, double least) {
  Vertex v{random.vertex(), {random.direction()}};
  const double step = least * CGAL_PI / 180, end = v.directions[0] + 2 * CGAL_PI - step;
  for (double a = v.directions[0];;) {
    a += step + (random.below(2) == 0 ? 0 : 2 * random());
    if (a > end) break;
    v.directions.push_back(a);
    if (random.below(4) == 0) break;
  }
  if (v.directions.size() == 1) v.directions.push_back(v.directions[0] + CGAL_PI);
  return v;
}

/// How far points and triangles are looked at.
struct Radii {
  double points = Vertex_window::radius_of_points, triangles = Vertex_window::radius_of_triangles;
};

Cdt triangulation(const Vertex& v, const Radii& radii = {}) {
  Cdt cdt;
  const auto vertex = cdt.insert(Point(v.place.x, v.place.y));
  for (std::size_t i = 0; i < v.directions.size(); ++i) {
    const Window_point e = v.direction(i);
    auto last = vertex;
    const auto append = [&](double t) {
      const auto next = cdt.insert(Point(v.place.x + t * e.x, v.place.y + t * e.y));
      cdt.insert_constraint(last, next);
      last = next;
    };
    const Edge_start start = edge_start(v.place, e, Edge_axis::of(e));
    for (const double distance : start.distances) append(distance);
    const double step = 1 / std::max(std::abs(e.x), std::abs(e.y));
    for (double t = start.first_crossing; t < radii.points + 2; t += step) append(t);
    Vertex_window window(v.place, e, v.direction(i + 1));
    const Sector_thresholds t = sector_thresholds[window.best_of(sector_thresholds)];
    for (double x = -10; x <= 11; ++x)
      for (double y = -10; y <= 11; ++y)
        if (std::hypot(x - v.place.x, y - v.place.y) <= radii.points && window.is_in_sector({x, y}) &&
            window.is_kept({x, y}, t))
          cdt.insert(Point(x, y));
  }
  return cdt;
}

double least_angle(const Vertex& v, const Cdt& cdt, const Radii& radii = {}) {
  double least = CGAL_PI;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
    const Point center = CGAL::centroid(cdt.triangle(f));
    if (std::hypot(center.x() - v.place.x, center.y() - v.place.y) > radii.triangles) continue;
    if (cdt.triangle(f).area() < 1e-9) continue; // three points on an edge
    for (int i = 0; i < 3; ++i) {
      const auto a = f->vertex((i + 1) % 3)->point() - f->vertex(i)->point(),
                 b = f->vertex((i + 2) % 3)->point() - f->vertex(i)->point();
      least = std::min(least, std::acos(a * b / std::sqrt(a.squared_length() * b.squared_length())));
    }
  }
  return least * 180 / CGAL_PI;
}

} // namespace

TEST_CASE("Points of an edge near a vertex depend on the edge and the vertex only", "[columns]") {
  Random random{std::mt19937_64(1)};
  for (int i = 0; i < 1000; ++i) {
    const Window_point v = random.vertex(), e = direction_of(random.direction());
    CAPTURE(v.x, v.y, e.x, e.y);
    const Edge_axis axis = Edge_axis::of(e);
    const Edge_start start = edge_start(v, e, axis);
    const double step = std::max(std::abs(e.x), std::abs(e.y)), t = start.first_crossing;
    CHECK(start.distances[0] * step == Approx(vertex_ring.radius));
    CHECK(start.distances[1] == Approx((start.distances[0] + t) / 2));
    // A crossing with that grid line, and not with the one before.
    const double line = std::abs(e.x) >= std::abs(e.y) ? v.x + t * e.x : v.y + t * e.y;
    CHECK(line == Approx(start.first_line).margin(1e-9));
    CHECK(t * step >= vertex_ring.least_crossing - 1e-9);
    CHECK(t * step <= vertex_ring.least_crossing + 1 + 1e-9);
    // It is the first or the second of the lines that are far.
    const int first_far = axis.line(first_far_line), ahead = axis.is_ascending ? 1 : -1;
    CHECK((start.first_line == first_far || start.first_line == first_far + ahead));
  }
}

TEST_CASE("Windows of sectors have the angles of the triangulation at the vertex", "[columns]") {
  Random random{std::mt19937_64(2)};
  const int n = is_full_run() ? 5000 : 100;
  double worst = 180;
  for (int i = 0; i < n; ++i) {
    const Vertex v = random_vertex(random, least_sector);
    CAPTURE(i, v.place.x, v.place.y, v.directions.size(), v.directions[0]);
    double least = 180;
    for (std::size_t k = 0; k < v.directions.size(); ++k) {
      Vertex_window window(v.place, v.direction(k), v.direction(k + 1));
      least = std::min(least, window.least_angle(sector_thresholds[window.best_of(sector_thresholds)]));
    }
    const double angle = least_angle(v, triangulation(v));
    CHECK(angle == Approx(least).margin(1e-6));
    worst = std::min(worst, angle);
  }
  CHECK(worst >= least_angle_of_sectors);
}

TEST_CASE("At the only edge of a vertex angles are as large as in sectors", "[columns]") {
  Random random{std::mt19937_64(5)};
  const int n = is_full_run() ? 20000 : 300;
  double worst = 180;
  for (int i = 0; i < n; ++i) {
    const Vertex v{random.vertex(), {random.direction()}};
    worst = std::min(worst, least_angle(v, triangulation(v)));
  }
  if (is_full_run()) WARN("least angle found " << worst);
  CHECK(worst >= least_angle_of_sectors);
}

TEST_CASE("Behind their windows vertices have no smaller angles", "[columns]") {
  Random random{std::mt19937_64(6)};
  const Radii radii{10, 8};
  const int n = is_full_run() ? 10000 : 100;
  double worst = 180;
  for (int i = 0; i < n; ++i) {
    const Vertex v = random_vertex(random, least_sector);
    worst = std::min(worst, least_angle(v, triangulation(v, radii), radii));
  }
  if (is_full_run()) WARN("least angle found " << worst);
  CHECK(worst >= least_angle_of_sectors);
}

TEST_CASE("Random sectors have no smaller angles", "[columns]") {
  Random random{std::mt19937_64(3)};
  CHECK(worst_angle(random, 4000, 4, 250, least_sector, 330) >= least_angle_of_sectors);
}

TEST_CASE("A search for sectors with small angles finds none", "[columns][.slow]") {
  for (const double least : {least_sector, 45., 60., 90.}) {
    Random random{std::mt19937_64(4)};
    const double worst = worst_angle(random, 60000, 30, 1500, least, 330);
    WARN("sectors of at least " << least << " degrees: least angle found " << worst);
    CHECK(worst >= least_angle_of_sectors);
  }
}

} // namespace test_vertex_window
