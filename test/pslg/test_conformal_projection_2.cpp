// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Projections against the sphere: lengths and angles there come from vectors in space.

#include "catch.h"

#include <CGAL/Conformal_projection_2.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace test_conformal_projection_2 {

using Projection = CGAL::Conformal_projection_2;
using Box = Projection::Box;
constexpr double degree = 3.14159265358979323846 / 180;

std::array<double, 3> on_sphere(double longitude, double latitude) {
  return {std::cos(latitude * degree) * std::cos(longitude * degree),
          std::cos(latitude * degree) * std::sin(longitude * degree), std::sin(latitude * degree)};
}

/// On the ground, in meters.
double distance(const Projection::Place& a, const Projection::Place& b) {
  const auto p = on_sphere(a[0], a[1]), q = on_sphere(b[0], b[1]);
  return Projection::radius * 2 * std::asin(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) / 2);
}

struct Case {
  Box box;
  Projection projection;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Box& box : {Box{{-93, 41}, {-75, 49}}, Box{{4, 57}, {32, 72}}, Box{{170, -48}, {190, -30}},
                         Box{{-30, -10}, {50, 20}}, Box{{0, 78}, {300, 89.5}}, Box{{-60, -89}, {60, -70}},
                         Box{{10, 30}, {10.001, 30.001}}, Box{{-180, 16}, {180, 20}}})
    all.push_back({box, Projection::for_box(box)});
  const Box europe{{-10, 35}, {30, 70}};
  all.push_back({europe, Projection::mercator(europe)});
  all.push_back({europe, Projection::lambert(europe)});
  all.push_back({europe, Projection::lambert(10, 50, 50)});
  all.push_back({europe, Projection::stereographic(10, 60)});
  return all;
}

TEST_CASE("projections go back to where they came from and keep angles and lengths to scale",
          "[Conformal_projection_2]") {
  for (const Case& c : cases()) {
    const auto range = c.projection.scale_range(c.box.low[1], c.box.high[1]);
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= 20; ++j) {
        const double x = c.box.low[0] + (0.001 + 0.998 * i / 20) * (c.box.high[0] - c.box.low[0]);
        const double y = c.box.low[1] + (c.box.high[1] - c.box.low[1]) * j / 20;
        CAPTURE(x, y, int(c.projection.kind()));
        const auto p = c.projection.forward(x, y);
        const auto back = c.projection.inverse(p[0], p[1]);
        REQUIRE(distance({x, y}, back) < 1e-6);
        // Steps of about a meter to the east and to the north.
        const double step = 1e-5, east = step / std::cos(y * degree);
        const auto a = c.projection.forward(x + east, y), b = c.projection.forward(x - east, y);
        const auto d = c.projection.forward(x, y + step), e = c.projection.forward(x, y - step);
        const double ux = a[0] - b[0], uy = a[1] - b[1], vx = d[0] - e[0], vy = d[1] - e[1];
        const double k = c.projection.scale(y), length = 2 * step * degree * Projection::radius;
        CHECK(std::abs(ux * vx + uy * vy) < 1e-6 * length * length * k * k);
        CHECK(ux * vy - uy * vx > 0);
        CHECK(std::abs(std::hypot(ux, uy) - k * length) < 1e-6 * k * length);
        CHECK(std::abs(std::hypot(vx, vy) - k * length) < 1e-6 * k * length);
        CHECK(range[0] <= k * (1 + 1e-12));
        CHECK(k <= range[1] * (1 + 1e-12));
      }
    for (const double parallel : c.projection.standard_parallels())
      CHECK(std::abs(c.projection.scale(parallel) - 1) < 1e-12);
  }
}

TEST_CASE("the projection is chosen by the latitude", "[Conformal_projection_2]") {
  using Kind = Projection::Kind;
  CHECK(Projection::for_box({{0, -5}, {1, 20}}).kind() == Kind::MERCATOR);
  CHECK(Projection::for_box({{0, 41}, {1, 49}}).kind() == Kind::LAMBERT);
  CHECK(Projection::for_box({{0, -49}, {1, -41}}).kind() == Kind::LAMBERT);
  CHECK(Projection::for_box({{0, 80}, {1, 81}}).kind() == Kind::STEREOGRAPHIC);
  CHECK(Projection::for_box({{0, -81}, {1, -80}}).cone_constant() == -1);
}

TEST_CASE("Lambert's projection has Snyder's cone", "[Conformal_projection_2]") {
  // His example of the sphere, p. 295: parallels 33 and 45 degrees, n = 0.6304777.
  CHECK(std::abs(Projection::lambert(-96, 33, 45).cone_constant() - 0.6304777) < 5e-8);
}

TEST_CASE("projections refuse poles and what has no cone", "[Conformal_projection_2]") {
  CHECK_THROWS_AS(Projection::for_box({{0, 80}, {1, 90}}), std::invalid_argument);
  CHECK_THROWS_AS(Projection::for_box({{0, -90}, {1, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(Projection::for_box({{0, 0}, {361, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(Projection::lambert(0, -30, 30), std::invalid_argument);
  CHECK_THROWS_AS(Projection::lambert(0, 0, 90), std::invalid_argument);
  CHECK_THROWS_AS(Projection::stereographic(0, 0), std::invalid_argument);
}

} // namespace test_conformal_projection_2
