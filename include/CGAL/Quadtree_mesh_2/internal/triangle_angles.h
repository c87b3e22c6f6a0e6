// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGLE_ANGLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGLE_ANGLES_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

// Angles for people to look at, by floating-point arithmetic alone.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Returns a number of a kernel, or of a built-in type, as a double.
template <class Number>
double as_double(const Number& x) {
  if constexpr (std::is_arithmetic_v<Number>)
    return static_cast<double>(x);
  else
    return CGAL::to_double(x);
}

struct Extreme_angles {
  double least = 180, largest = 0; ///< degrees
};

/// The least and the largest angle of a triangle, of any size that doubles have.
template <class Point>
Extreme_angles extreme_angles(const Point& p, const Point& q, const Point& r) {
  const std::array<double, 3> x{as_double(p.x()) / 2, as_double(q.x()) / 2, as_double(r.x()) / 2},
      y{as_double(p.y()) / 2, as_double(q.y()) / 2,
        as_double(r.y()) / 2}; // halves have differences without overflow
  double scale = 0;
  for (std::size_t k = 0; k < 3; ++k)
    scale = std::max({scale, std::abs(x[k] - x[(k + 1) % 3]), std::abs(y[k] - y[(k + 1) % 3])});
  if (!(scale > 0)) scale = 1;
  Extreme_angles angles;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double ux = (x[i] - x[k]) / scale, uy = (y[i] - y[k]) / scale;
    const double wx = (x[j] - x[k]) / scale, wy = (y[j] - y[k]) / scale;
    const double angle = std::atan2(std::abs(ux * wy - uy * wx), ux * wx + uy * wy) * 180 / CGAL_PI;
    angles.least = std::min(angles.least, angle);
    angles.largest = std::max(angles.largest, angle);
  }
  return angles;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGLE_ANGLES_H
