// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_BOUNDS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_BOUNDS_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What every triangle has to satisfy, in squared quantities and kernel coordinates.
template <class Geometry>
struct Bounds {
  using Point = typename Geometry::Point;
  using Shape = typename Kernel_mesh<Geometry>::Shape;

  double angle = 0; ///< radians
  /// Squared sine of the bound, raised a little so that rounding cannot pass the user's bound.
  double sin2 = 0;
  /// Squared cosine of the bound on the greatest angle, an obtuse one, lowered likewise; 1, that of 180 degrees: none.
  double cosine2_of_widest = 1;
  double area2 = std::numeric_limits<double>::infinity();          ///< twice the largest area
  double squared_length = std::numeric_limits<double>::infinity(); ///< of the longest edge
  /// The squared length of the longest edge of a triangle with its centroid at the place; empty: no field.
  /// Called by several threads at once.
  std::function<double(const Point&)> squared_length_at;
  /// While edges are graded (Grader.h), whether the edges of a triangle of the given shape and corners are longer than
  /// the gradation allows; empty: edges are not graded. Called by several threads at once.
  std::function<bool(const Shape&, const Point&, const Point&, const Point&)> is_ungraded;
  /// Whether a triangle counts as too large that meets the bounds of size; empty: none does. Called by several threads
  /// at once.
  std::function<bool(const Point&, const Point&, const Point&)> is_refused;
  /// Twice the largest area in each region of `Kernel_mesh::region_of`; empty: regions have no bounds.
  Indexed_vector<Region_id, double> area2_of_region;
  /// No vertex is inserted nearer than this (squared) to another one.
  double least_squared_length = 0;

  /// Up to this angle refinement ended by itself on all inputs of the soak (doc/soak.md), which is no proof:
  /// 20.7048 degrees, whose squared sine, 1/8, is Mesh_2's default.
  static constexpr double established_angle = 0.3613671239067078 * (1 + 1e-12);
  bool is_established() const { return angle <= established_angle; }
  void lower_to_established() {
    if (!is_established()) set_angle(established_angle);
  }

  Bounds() = default;
  Bounds(double radians, double max_area, double max_length) {
    set_angle(radians);
    if (max_area > 0) area2 = 2 * max_area * (1 - margin);
    if (max_length > 0) squared_length = max_length * max_length * (1 - margin);
  }

  /// \pre the angle is obtuse
  void set_widest(double radians) {
    const double cosine = std::cos(radians);
    cosine2_of_widest = cosine * cosine * (1 - margin);
  }

  /// These bounds, with a share of the angle.
  Bounds with_share_of_angle(double share) const {
    Bounds lower = *this;
    const double sine = std::sin(share * angle);
    lower.sin2 = sine * sine;
    return lower;
  }

  /// By which bounds are tightened, so that rounding cannot pass them.
  static constexpr double margin = 2e-9;

  bool is_sharp(const Shape& s) const { return s.is_below(sin2); }
  bool has_widest() const { return cosine2_of_widest < 1; }
  bool is_wide(const Shape& s) const { return has_widest() && s.is_wider(cosine2_of_widest); }
  /// Whether an angle is below the least or above the greatest one.
  bool is_misshapen(const Shape& s) const { return is_sharp(s) || is_wide(s); }
  /// Whether the triangle a, b, c of the given shape and region is larger than wanted.
  bool is_large(const Shape& s, const Point& a, const Point& b, const Point& c, Region_id region) const {
    if (s.area2 > area2 || s.longest() > squared_length) return true;
    return (is_refused || is_local()) && is_large_there(s, a, b, c, region);
  }
  /// Whether bounds of size differ from place to place.
  bool is_local() const { return squared_length_at || is_ungraded || !area2_of_region.empty(); }
  bool is_size_bounded() const {
    return is_local() || area2 < std::numeric_limits<double>::infinity() ||
           squared_length < std::numeric_limits<double>::infinity();
  }

private:
  /// By what differs from place to place. Apart, so that compilers inline the rest.
  BOOST_NOINLINE bool is_large_there(const Shape& s, const Point& a, const Point& b, const Point& c,
                                     Region_id region) const {
    if (is_refused && is_refused(a, b, c)) return true;
    if (!area2_of_region.empty() && region.is_valid() && s.area2 > area2_of_region[region]) return true;
    if (squared_length_at && s.longest() > squared_length_at(centroid(a, b, c)) * (1 - margin)) return true;
    return is_ungraded && is_ungraded(s, a, b, c);
  }
  void set_angle(double radians) {
    angle = radians;
    sin2 = std::sin(angle) * std::sin(angle) * (1 + margin);
  }
  static Point centroid(const Point& a, const Point& b, const Point& c) {
    return Geometry::translate(
        a, (1.0 / 3) * (Geometry::scaled_difference(b, a) + Geometry::scaled_difference(c, a)));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_BOUNDS_H
