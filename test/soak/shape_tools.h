// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SOAK_SHAPE_TOOLS_H
#define QUADTREE_MESH_2_TEST_SOAK_SHAPE_TOOLS_H

// What families are made of. Nothing here takes a sine or a power of the C library, which may differ in a bit.

#include "random_pslg.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace soak {

using random_pslg::Builder;
using random_pslg::Point;
using random_pslg::Pslg;
using random_pslg::Random;
using Vector = random_pslg::Kernel::Vector_2;

/// 2 to a random power in [low, high], times a number in [1, 2).
inline double magnitude(Random& random, int low, int high) {
  return std::ldexp(random.between(1, 2), random.integer(low, high));
}

/// The double `k` steps above `x`, or below it for negative `k`.
inline double steps_from(double x, int k) {
  std::int64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  constexpr std::int64_t least = std::int64_t(1) << 63;
  const std::int64_t ordered = (bits < 0 ? least - bits : bits) + k;
  const std::int64_t result = ordered < 0 ? least - ordered : ordered;
  std::memcpy(&x, &result, sizeof x);
  return x;
}
inline Point steps_from(const Point& p, int i, int j) {
  return Point(steps_from(p.x(), i), steps_from(p.y(), j));
}
/// As many steps as `most` in either direction, but not none in both.
inline Point near_by(Random& random, const Point& p, int most) {
  for (;;) {
    const int i = random.integer(-most, most), j = random.integer(-most, most);
    if (i != 0 || j != 0) return steps_from(p, i, j);
  }
}

/// A unit vector of a rational direction: exact but for rounding.
inline Vector direction(Random& random) {
  const double t = random.between(-1, 1), norm = 1 + t * t;
  const Vector v((1 - t * t) / norm, 2 * t / norm);
  switch (random.integer(0, 3)) {
  case 0:
    return v;
  case 1:
    return Vector(-v.y(), v.x());
  case 2:
    return -v;
  default:
    return Vector(v.y(), -v.x());
  }
}

inline Point random_point(Random& random, double low, double high) {
  const double x = random.between(low, high), y = random.between(low, high);
  return Point(x, y);
}

inline void add_square(Builder& b, const Point& low, double side) {
  const Vector x(side, 0), y(0, side);
  b.loop({low, low + x, low + x + y, low + y});
}

/// Whether the segment from `p` to `q` would cross another one in the interior of both.
inline bool crosses_any(const Builder& b, const Point& p, const Point& q) {
  for (const auto& s : b.pslg.segments) {
    const Point &a = b.pslg.point(s[0]), &c = b.pslg.point(s[1]);
    if (CGAL::orientation(a, c, p) * CGAL::orientation(a, c, q) < 0 &&
        CGAL::orientation(p, q, a) * CGAL::orientation(p, q, c) < 0)
      return true;
  }
  return false;
}
inline bool add_uncrossed(Builder& b, const Point& p, const Point& q) {
  if (p == q || crosses_any(b, p, q)) return false;
  const std::size_t v = b.vertex(p);
  b.segment(v, b.vertex(q));
  return true;
}

/// `n` points around `c`, counterclockwise in directions that the square's corners at (+-1, +-1) are pushed through,
/// at distances of `r` times [inner, 1].
inline std::vector<Point> star_around(Random& random, const Point& c, double r, int n, double inner) {
  std::vector<double> turns;
  for (int i = 0; i < n; ++i) turns.push_back(4 * (i + random.between(0.05, 0.95)) / n);
  std::vector<Point> points;
  for (const double turn : turns) {
    // Around the square with corners (1, 0), (0, 1), (-1, 0), (0, -1), then onto the circle.
    const int side = static_cast<int>(turn);
    const double t = turn - side;
    const double x = side == 0 ? 1 - t : side == 1 ? -t : side == 2 ? t - 1 : t;
    const double y = side == 0 ? t : side == 1 ? 1 - t : side == 2 ? -t : t - 1;
    const double length = r * random.between(inner, 1) / std::sqrt(x * x + y * y);
    points.emplace_back(c.x() + length * x, c.y() + length * y);
  }
  return points;
}

inline void move(Pslg& pslg, const Vector& by) {
  for (Point& p : pslg.vertices) p = p + by;
  for (Point& p : pslg.holes) p = p + by;
  for (auto& region : pslg.regions) region.point = region.point + by;
}
inline void scale(Pslg& pslg, double by) {
  const auto scaled = [by](const Point& p) { return Point(by * p.x(), by * p.y()); };
  for (Point& p : pslg.vertices) p = scaled(p);
  for (Point& p : pslg.holes) p = scaled(p);
  for (auto& region : pslg.regions) region.point = scaled(region.point);
}

/// 10 to the power of `e`, rounded.
inline double power_of_ten(int e) {
  double result = 1;
  for (int i = 0; i < std::abs(e); ++i) result *= 10;
  return e < 0 ? 1 / result : result;
}

} // namespace soak

#endif // QUADTREE_MESH_2_TEST_SOAK_SHAPE_TOOLS_H
