// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_SCALED_SIDES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_SCALED_SIDES_H

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The sides of a triangle of any size that doubles have, scaled by a power of two so that nothing vanishes or
/// overflows. Its area, and so each of its angles, has a relative error below 1e-11, however thin it is.
template <class Point>
class Scaled_sides {
public:
  Scaled_sides(const Point& p, const Point& q, const Point& r) : corners_{p, q, r} {
    double largest = 0;
    for (const Point& c : corners_) largest = std::max({largest, std::abs(c.x()), std::abs(c.y())});
    // differences of the largest doubles overflow; what their last bits lose is nothing beside them
    const int before = largest > 0x1p1000 ? -32 : 0;
    const double down = before == 0 ? 1 : 0x1p-32;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &a = corners_[(k + 1) % 3], &b = corners_[(k + 2) % 3];
      x_[k] = down * b.x() - down * a.x();
      y_[k] = down * b.y() - down * a.y();
    }
    double extent = 0;
    for (std::size_t k = 0; k < 3; ++k) extent = std::max({extent, std::abs(x_[k]), std::abs(y_[k])});
    const int exponent = extent > 0 ? std::ilogb(extent) : 0;
    // in two steps, as the power of two may be none that doubles have
    const double half = std::ldexp(1., -exponent / 2), rest = std::ldexp(1., -exponent - -exponent / 2);
    for (std::size_t k = 0; k < 3; ++k) {
      x_[k] = half * x_[k] * rest;
      y_[k] = half * y_[k] * rest;
    }
    exponent_ = exponent - before;
    doubled_area_ = compute_doubled_area();
  }

  double area() const { return std::ldexp(doubled_area_ / 2, 2 * exponent_); }
  /// Of the side opposite corner `k`.
  double length(std::size_t k) const { return std::ldexp(std::hypot(x_[k], y_[k]), exponent_); }
  double longest() const { return std::max({length(0), length(1), length(2)}); }
  /// The angle at corner `k` in degrees.
  double angle(std::size_t k) const {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    return std::atan2(std::abs(doubled_area_), -(x_[i] * x_[j] + y_[i] * y_[j])) * (180 / CGAL_PI);
  }

private:
  double compute_doubled_area() const {
    constexpr double least_share =
        0x1p-10; // of the products that is left of their difference with enough bits
    const double left = x_[0] * y_[1], right = y_[0] * x_[1];
    if (std::abs(left - right) >= least_share * (std::abs(left) + std::abs(right))) return left - right;
    using Number = Exact_rational;
    const std::array<Number, 3> x{corners_[0].x(), corners_[1].x(), corners_[2].x()},
        y{corners_[0].y(), corners_[1].y(), corners_[2].y()};
    const Number exact = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    const int half = exponent_ / 2;
    const Number scale = Number(std::ldexp(1., -half)) * Number(std::ldexp(1., half - exponent_));
    return CGAL::to_double(Number(exact * scale * scale));
  }

  std::array<Point, 3> corners_;
  std::array<double, 3> x_, y_;
  int exponent_;
  double doubled_area_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_SCALED_SIDES_H
