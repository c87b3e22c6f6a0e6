// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Points without segments: those of the tests, and pairs and spirals that are nearer to each other.

#include "families.h"
#include "shape_tools.h"

#include "point_sets.h"

namespace soak {

namespace {

Pslg of(std::vector<Point> points) {
  Pslg pslg;
  pslg.vertices = std::move(points);
  return pslg;
}

/// Up to 60 points of all kinds.
Pslg small_point_sets(std::uint64_t seed) { return of(point_sets::Random_small_set(seed)()); }

/// One of the nasty kinds, of at most some hundred points.
Pslg nasty_point_sets(std::uint64_t seed) {
  const std::vector<point_sets::Named_points> all = point_sets::nasty(1 + seed / 7 % 6);
  return of(all[seed % all.size()].points);
}

/// The small sets far from the origin, where some come to lie 0 to 100 steps of doubles from others.
Pslg offset_points(std::uint64_t seed) {
  Random random(seed);
  const double offset = power_of_ten(random.integer(0, 12));
  std::vector<Point> points = point_sets::Random_small_set(seed)();
  for (Point& p : points) p = Point(p.x() + offset, p.y() - offset);
  for (int k = random.integer(0, 3); k > 0; --k)
    points.push_back(near_by(
        random, points[static_cast<std::size_t>(random.integer(0, static_cast<int>(points.size()) - 1))],
        100));
  return of(points);
}

/// Pairs 2^-20 to 2^-45 apart, among few others.
Pslg far_pairs(std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points;
  for (int k = random.integer(1, 4); k > 0; --k) {
    const Point p = random_point(random, 0, 1);
    points.push_back(p);
    points.push_back(p + std::ldexp(random.between(1, 2), -random.integer(20, 45)) * direction(random));
  }
  for (int k = random.integer(0, 6); k > 0; --k) points.push_back(random_point(random, -2, 2));
  return of(points);
}

} // namespace

std::vector<Family> point_families() {
  constexpr Family::Kind points = Family::Kind::POINTS;
  return {{"small-point-sets", small_point_sets, points},
          {"nasty-point-sets", nasty_point_sets, points},
          {"offset-points", offset_points, points},
          {"far-pairs", far_pairs, points}};
}

} // namespace soak
