// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
// Whether a star may meet a bound with its vertex somewhere on a line, compared with looking at many places.

#include "catch.h"
#include "random_pslg.h"

#include <CGAL/Quadtree_mesh_2/internal/geometry/may_star_meet_bound_on_line.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_may_star_meet_bound_on_line {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using Vector = internal::Basic_vector<double>;

/// The squared sine of the least angle of the star with its vertex at p; -1 if it is no star then.
double least_sin2(const std::vector<Vector>& link, Vector p) {
  double least = 2;
  for (std::size_t i = 0; i + 1 < link.size(); ++i) {
    const Vector u = link[i] - p, v = link[i + 1] - link[i], w = link[i + 1] - p;
    const internal::Basic_shape<double> s = {{squared_length(v), squared_length(w), squared_length(u)},
                                             cross(u, v)};
    least = std::min(least, s.area2 <= 0 ? -1 : s.sin2_of_least_angle());
  }
  return least;
}

/// The greatest one of many places along the line, up to the distance 2.
double greatest_of_places(const std::vector<Vector>& link, Vector direction) {
  constexpr int places = 4000;
  double greatest = -1;
  for (int i = -places; i <= places; ++i)
    greatest = std::max(greatest, least_sin2(link, (2. * i / places) * direction));
  return greatest;
}

/// A closed link around the origin, or half of one, above the x-axis and with its ends on it.
std::vector<Vector> random_link(random_pslg::Random& random, bool is_closed) {
  const int n = int(random.integer(3, 8));
  std::vector<double> angles;
  for (int i = 0; i < n; ++i) angles.push_back(random.between(0, is_closed ? 2 * CGAL_PI : CGAL_PI));
  if (!is_closed) angles[0] = 0, angles[1] = CGAL_PI;
  std::sort(angles.begin(), angles.end());
  std::vector<Vector> link;
  for (const double angle : angles) {
    const double distance =
        random.integer(0, 3) == 0 ? std::exp2(random.between(-20, 0)) : random.between(0.5, 1);
    link.push_back({distance * std::cos(angle), distance * std::sin(angle)});
  }
  if (is_closed) link.push_back(link.front());
  return link;
}

} // namespace

TEST_CASE("A line on which a star meets the bound is never given up, and most others are", "[refiner]") {
  const bool is_closed = GENERATE(false, true);
  const double degrees = GENERATE(5., 20.7, 30., 34.);
  CAPTURE(is_closed, degrees);
  const double sin2 = std::pow(std::sin(degrees / 180 * CGAL_PI), 2);
  random_pslg::Random random(std::uint64_t(7));
  int possible = 0, impossible = 0, given_up = 0;
  for (int i = 0; i < (is_full_run() ? 400 : 60); ++i) {
    const std::vector<Vector> link = random_link(random, is_closed);
    const double angle = is_closed ? random.between(0, 2 * CGAL_PI) : 0;
    const Vector direction{std::cos(angle), std::sin(angle)};
    const bool may_meet =
        internal::may_star_meet_bound_on_line(link.data(), int(link.size()) - 1, direction, sin2);
    if (greatest_of_places(link, direction) >= sin2) {
      ++possible;
      CHECK(may_meet);
    } else {
      ++impossible;
      given_up += may_meet ? 0 : 1;
    }
  }
  CHECK(given_up >= 0.95 * impossible);
  CHECK(impossible > 0);
  if (degrees == 5) CHECK(possible > 0);
}

TEST_CASE("A regular star meets a bound below its angles, and none above", "[refiner]") {
  std::vector<Vector> link;
  for (int i = 0; i <= 6; ++i) link.push_back({std::cos(i * CGAL_PI / 3), std::sin(i * CGAL_PI / 3)});
  const Vector direction{0.6, 0.8};
  CHECK(
      internal::may_star_meet_bound_on_line(link.data(), 6, direction, 0.7499)); // a little below 60 degrees
  CHECK_FALSE(internal::may_star_meet_bound_on_line(link.data(), 6, direction, 0.7501));
}

} // namespace test_may_star_meet_bound_on_line
