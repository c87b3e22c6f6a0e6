// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What of a graph may keep a triangle from being one of its constrained Delaunay triangulation: vertices in its circle,
// and segments that meet it.
//
// Whether a box has a place in the circle is decided by the sign of a quadratic function there, which is that of the
// in-circle test; no center is computed, so flat triangles are no exception. Boxes may be found near that are not, by
// rounding, but never the converse. What is asked of a single segment is exact. O(1) for each question.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_TRIANGLE_REACH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_TRIANGLE_REACH_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/place_box.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_handles.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// More than what rounding does to functions of degree four of differences of coordinates, relative to the sum of the
/// magnitudes of their terms.
constexpr double rounding_of_reach = 64 * std::numeric_limits<double>::epsilon();

template <class Point>
bool do_meet(const Place_box<Point>& a, const Place_box<Point>& b) {
  return !(a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y);
}

/// Whether a box is certainly to the right of the line from a to b.
template <class Geometry>
bool is_right_of(const Place_box<typename Geometry::Point>& box, const typename Geometry::Point& a,
                 const typename Geometry::Point& b) {
  using std::fabs;
  const Vector d = Geometry::difference(b, a), low = Geometry::difference(box.low, a),
               high = Geometry::difference(box.high, a);
  const double l = d.x * (d.x > 0 ? high.y : low.y), r = d.y * (d.y > 0 ? low.x : high.x);
  return l - r < -rounding_of_reach * (fabs(l) + fabs(r));
}

/// Whether a segment may have a point in a box.
template <class Geometry>
bool may_meet(const Place_box<typename Geometry::Point>& box, const typename Geometry::Point& a,
              const typename Geometry::Point& b) {
  Place_box<typename Geometry::Point> of_segment{a, a};
  of_segment.add(b);
  return do_meet(box, of_segment) && !is_right_of<Geometry>(box, a, b) && !is_right_of<Geometry>(box, b, a);
}

template <class Geometry>
class Triangle_reach {
public:
  using Point = typename Geometry::Point;
  using Box = Place_box<Point>;

  /// A corner, and whether nothing is seen through the side opposite it.
  struct Corner {
    Point point;
    bool is_wall;
  };

  /// \param a, b, c counterclockwise
  Triangle_reach(const Corner& a, const Corner& b, const Corner& c)
      : p_{a.point, b.point, c.point}, is_wall_{a.is_wall, b.is_wall, c.is_wall}, box_{a.point, a.point} {
    using std::fabs;
    box_.add(p_[1]), box_.add(p_[2]);
    const Vector u = Geometry::difference(p_[1], p_[0]), w = Geometry::difference(p_[2], p_[0]);
    const double u2 = squared_length(u), w2 = squared_length(w);
    is_reliable_ = least_square < u2 && least_square < w2 && u2 + w2 < greatest_square;
    area_error_ = rounding_of_reach * (fabs(u.x * w.y) + fabs(u.y * w.x));
    area_ = cross(u, w) - area_error_;
    x_ = {w.y * u2 - u.y * w2, rounding_of_reach * (fabs(w.y) * u2 + fabs(u.y) * w2)};
    y_ = {u.x * w2 - w.x * u2, rounding_of_reach * (fabs(u.x) * w2 + fabs(w.x) * u2)};
  }

  /// Whether the circle is certainly in a box.
  bool is_within(const Box& box) const {
    if (!is_reliable_ || !(area_ > 1e8 * area_error_)) return false;
    const double x = x_.value / (2 * area_), y = y_.value / (2 * area_); // of the center
    const double reach = (1 + 1e-6) * std::sqrt(x * x + y * y) + (x_.error + y_.error) / area_;
    const Vector low = Geometry::difference(box.low, p_[0]), high = Geometry::difference(box.high, p_[0]);
    return low.x <= x - reach && x + reach <= high.x && low.y <= y - reach && y + reach <= high.y;
  }

  /// Whether a place of a box may be in the circle and not behind a side that nothing is seen through.
  /// \pre the box is not empty
  bool may_have_in_circle(const Box& box) const {
    for (int k = 0; k < 3; ++k)
      if (is_wall_[k] && is_right_of<Geometry>(box, p_[next_slot[k]], p_[previous_slot[k]])) return false;
    const Vector low = Geometry::difference(box.low, p_[0]), high = Geometry::difference(box.high, p_[0]);
    if (!is_reliable_ || !(squared_length(low) + squared_length(high) < greatest_square)) return true;
    return !(least(x_, low.x, high.x) + least(y_, low.y, high.y) > least_certain);
  }

  /// Whether the triangle and the box may have a point in common. \pre the box is not empty
  bool may_meet(const Box& box) const {
    return do_meet(box, box_) && !is_right_of<Geometry>(box, p_[0], p_[1]) &&
           !is_right_of<Geometry>(box, p_[1], p_[2]) && !is_right_of<Geometry>(box, p_[2], p_[0]);
  }

  /// Whether the triangle and the segment between two places that are not its corners have a point in common.
  bool meets(const Point& a, const Point& b) const {
    Box of_segment{a, a};
    of_segment.add(b);
    if (!do_meet(box_, of_segment)) return false;
    for (int k = 0; k < 3; ++k)
      if (turn(k, a) < 0 && turn(k, b) < 0) return false;
    const int first = Geometry::orientation(a, b, p_[0]);
    return first == 0 || Geometry::orientation(a, b, p_[1]) != first ||
           Geometry::orientation(a, b, p_[2]) != first;
  }

  /// Whether the segment from corner k to a place leads into the triangle, or along a side of it.
  bool is_entered(int k, const Point& to) const {
    return turn(k, to) >= 0 && turn(previous_slot[k], to) >= 0;
  }

private:
  /// A coefficient, and by how much it may be off.
  struct Coefficient {
    double value, error;
  };

  /// Products of four lengths whose squares are between these neither underflow nor overflow.
  static constexpr double least_square = 1e-140, greatest_square = 1e140;
  /// Below this, products may have underflowed.
  static constexpr double least_certain = 1e-290;

  Point p_[3];
  bool is_wall_[3];
  bool is_reliable_; // what is known of the circle
  Box box_;
  // A place p, seen from the first corner, is in the circle if area * p^2 < (x, y) * p.
  double area_, area_error_; // at most that large, as it may be off
  Coefficient x_, y_;

  /// The side of the line from corner k to the next one.
  int turn(int k, const Point& p) const { return Geometry::orientation(p_[k], p_[next_slot[k]], p); }

  /// At most the least value of `area * t^2 - b * t` for t from low to high.
  double least(const Coefficient& b, double low, double high) const {
    double found = std::numeric_limits<double>::infinity();
    if (high >= 0) found = least_of_parabola(b.value + b.error, std::max(low, 0.0), high);
    if (low < 0) found = std::min(found, least_of_parabola(b.value - b.error, low, std::min(high, 0.0)));
    return found;
  }
  double least_of_parabola(double b, double low, double high) const {
    const double at_ends = std::min((area_ * low - b) * low, (area_ * high - b) * high);
    if (!(area_ > 0)) return at_ends;
    const double t = b / (2 * area_);
    return low < t && t < high ? std::min(at_ends, -0.5 * b * t) : at_ends;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_TRIANGLE_REACH_H
