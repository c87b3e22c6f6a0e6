// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_TRIANGLE_ANGLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_TRIANGLE_ANGLES_H

#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
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

/// The sides of a triangle of any size that doubles have, seen from one corner after the other. They are
/// scaled so that the longest extent is 1.
class Scaled_triangle {
public:
  template <class Point>
  Scaled_triangle(const Point& p, const Point& q, const Point& r) {
    // Halves differ without overflow.
    const std::array<double, 3> x{as_double(p.x()) / 2, as_double(q.x()) / 2, as_double(r.x()) / 2},
        y{as_double(p.y()) / 2, as_double(q.y()) / 2, as_double(r.y()) / 2};
    double extent = 0;
    for (std::size_t k = 0; k < 3; ++k)
      extent = std::max({extent, std::abs(x[k] - x[(k + 1) % 3]), std::abs(y[k] - y[(k + 1) % 3])});
    if (!(extent > 0)) extent = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      dx_[k] = (x[(k + 2) % 3] - x[(k + 1) % 3]) / extent;
      dy_[k] = (y[(k + 2) % 3] - y[(k + 1) % 3]) / extent;
    }
  }

  /// The angle at corner `k` in degrees.
  double angle(std::size_t k) const {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3; // side `j` begins at the corner, side `i` ends there
    const double sine = dx_[i] * dy_[j] - dy_[i] * dx_[j], cosine = -dx_[i] * dx_[j] - dy_[i] * dy_[j];
    return std::atan2(std::abs(sine), cosine) * 180 / pi;
  }
  /// Opposite the shortest side.
  double least_angle() const {
    return angle(opposite_to([](double a, double b) { return a < b; }));
  }
  /// Opposite the longest side.
  double largest_angle() const {
    return angle(opposite_to([](double a, double b) { return a > b; }));
  }

private:
  /// The corner opposite the first side in an order of lengths.
  template <class Order>
  std::size_t opposite_to(Order is_before) const {
    std::size_t first = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (is_before(dx_[k] * dx_[k] + dy_[k] * dy_[k], dx_[first] * dx_[first] + dy_[first] * dy_[first]))
        first = k;
    return first;
  }

  std::array<double, 3> dx_, dy_; // opposite each corner, counterclockwise
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_TRIANGLE_ANGLES_H
