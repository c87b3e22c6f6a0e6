// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A segment seen from a place near it, in sides of the leaves there.
//
// Computes: the ends of a segment relative to a place. Where they are so far away that rounding their
//           differences would move the segment by more than a small share of the side, the line is put at
//           its distance from the place, and the segment ends where it is far enough away not to matter.
// Bound:    O(1); exact arithmetic only for lines far longer than the side that pass near the place.
// Source:   ours.
//
// Leaves may be any number of levels below the length of an edge that passes them: a vertex in the middle of an edge
// may be as near to it as coordinates can tell. Differences of far ends have no more digits than others.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_NEAR_SEGMENT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_NEAR_SEGMENT_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A segment relative to some place.
struct Local_segment {
  Vector a, b;

  /// The nearest point to p.
  Vector nearest_to(Vector p) const {
    const Vector d = b - a;
    const double l2 = squared_length(d);
    const double f = l2 > 0 ? std::min(1.0, std::max(0.0, dot(p - a, d) / l2)) : 0.0;
    return a + f * d;
  }
  double distance_to(Vector p) const { return std::sqrt(squared_length(nearest_to(p) - p)); }

  /// Whether it is beyond one side of the square [low, high]^2.
  bool is_beyond(double low, double high) const {
    return std::max(a.x, b.x) < low || std::min(a.x, b.x) > high || std::max(a.y, b.y) < low ||
           std::min(a.y, b.y) > high;
  }

  /// Cuts off what is outside the square [low, high]^2; false if nothing is left.
  bool clip(double low, double high) {
    double begin = 0, end = 1;
    const Vector d = b - a;
    const auto cut = [&](double slope, double room) {
      if (slope == 0) return room >= 0;
      const double t = room / slope;
      if (slope < 0)
        begin = std::max(begin, t);
      else
        end = std::min(end, t);
      return begin <= end;
    };
    if (!cut(-d.x, a.x - low) || !cut(d.x, high - a.x) || !cut(-d.y, a.y - low) || !cut(d.y, high - a.y))
      return false;
    const Vector p = a + begin * d, q = a + end * d;
    a = p, b = q;
    return true;
  }
};

/// Segments relative to places.
template <class Geometry>
class Near_segment {
public:
  using Point = typename Geometry::Point;

  /// The segment from a to b relative to p, where leaves have this side.
  static Local_segment of(const Point& a, const Point& b, const Point& p, double side) {
    const Local_segment rounded{Geometry::difference(a, p), Geometry::difference(b, p)};
    const double reach = std::max(extent(rounded.a), extent(rounded.b));
    return reach <= most_sides_ * side ? rounded : of_line(rounded, a, b, p, sides_kept_ * side);
  }

private:
  /// Up to so many sides rounding is of no account.
  static constexpr double most_sides_ = 0x1p30;
  /// What is farther away than so many sides does not matter to leaves.
  static constexpr double sides_kept_ = 0x1p20;

  static double extent(Vector v) { return std::max(std::fabs(v.x), std::fabs(v.y)); }

  /// The part of the line that is at most about `reach` from p.
  static Local_segment of_line(const Local_segment& rounded, const Point& a, const Point& b, const Point& p,
                               double reach) {
    const auto ab = Geometry::scaled_difference(b, a), bp = Geometry::scaled_difference(p, b);
    const Vector d = Geometry::difference(b, a);
    const double length = std::sqrt(squared_length(d));
    using std::sqrt;
    const double height = ratio(Geometry::doubled_area_of_flat(ab, bp, a, b, p), sqrt(squared_length(ab)));
    const Vector along = (1 / length) * d, foot = height * Vector{along.y, -along.x};
    const double begin = std::max(dot(rounded.a, along), -reach),
                 end = std::min(dot(rounded.b, along), reach);
    return begin < end ? Local_segment{foot + begin * along, foot + end * along} : rounded;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_NEAR_SEGMENT_H
