// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_STRAIGHT_SEGMENT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_STRAIGHT_SEGMENT_H

#include <CGAL/Quadtree_mesh_2/internal/checker/exact_sign.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The distance from the magnitude of `x` to the next larger double.
inline double unit_in_last_place(double x) {
  constexpr int fraction_bits = 52, least_exponent = -1074;
  return x == 0 ? std::ldexp(1., least_exponent)
                : std::ldexp(1., std::max(std::ilogb(x) - fraction_bits, least_exponent));
}

/// An input segment, and which points of a mesh count as on it. All answers are exact, whatever the
/// coordinates.
template <class Point>
class Straight_segment {
public:
  /// A vertex may be this many units of each coordinate away from a point of the segment, see
  /// `Mesh_quality_options_2::coordinate_unit()`.
  static constexpr double units_of_rounding = 4;

  /// \param coordinate_unit that of the mesh's coordinates; at least that of doubles as large as those of the ends is
  /// taken
  Straight_segment(const Point& p, const Point& q, double coordinate_unit) : p_(p), q_(q) {
    const auto reach = [&](double a, double b) {
      return units_of_rounding *
             std::max(coordinate_unit, unit_in_last_place(std::max(std::abs(a), std::abs(b))));
    };
    reach_ = {reach(p.x(), q.x()), reach(p.y(), q.y())};
  }

  const Point& source() const { return p_; }
  const Point& target() const { return q_; }
  /// How far a vertex may be off, along each axis.
  const std::array<double, 2>& reach() const { return reach_; }

  /// Whether `b` comes after `a`, seen along the segment.
  bool is_ahead(const Point& a, const Point& b) const {
    return exact_sign([&](auto number) {
             using Number = decltype(number);
             return Number((Number(q_.x()) - Number(p_.x())) * (Number(b.x()) - Number(a.x())) +
                           (Number(q_.y()) - Number(p_.y())) * (Number(b.y()) - Number(a.y())));
           }) == POSITIVE;
  }

  /// Whether a point of the segment's line is within reach of `v` along each axis: |cross| <= |dx| r_y + |dy| r_x.
  bool passes_by(const Point& v) const {
    const double sign_x = q_.x() < p_.x() ? -1 : 1, sign_y = q_.y() < p_.y() ? -1 : 1;
    const auto excess = [&](double side) {
      return exact_sign([&, side](auto number) {
        using Number = decltype(number);
        const Number dx = Number(q_.x()) - Number(p_.x()), dy = Number(q_.y()) - Number(p_.y());
        const Number ux = Number(v.x()) - Number(p_.x()), uy = Number(v.y()) - Number(p_.y());
        return Number(Number(side) * (dx * uy - dy * ux) - Number(sign_x * reach_[1]) * dx -
                      Number(sign_y * reach_[0]) * dy);
      });
    };
    return excess(1) != POSITIVE && excess(-1) != POSITIVE;
  }

private:
  Point p_, q_;
  std::array<double, 2> reach_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_STRAIGHT_SEGMENT_H
