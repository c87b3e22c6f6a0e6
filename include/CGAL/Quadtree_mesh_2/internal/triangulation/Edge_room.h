// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The room beside an input edge into which vertices of the edge may be rounded.
//
// Computes: the triangle that joins the edge to a point inside the triangle beside it, in a constrained
//           triangulation of the whole graph, including the outside.
// Bound:    O(1).
// Source:   ours.
//
// Rooms are disjoint except for common ends and tips, and no vertex is in one. Take a chain from one end of the edge to
// the other, monotone in x or y, with its vertices in the rooms on both sides. It stays there: where it changes
// sides, it crosses the edge between the ends. So a graph of such chains is the given graph, bent. All
// decisions are exact, on the rounded points. Points exactly on the edge need no room.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_EDGE_ROOM_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_EDGE_ROOM_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>

#include <cmath>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The room on the left of an edge from a to b; none if it was made without a triangle.
template <class Geometry>
class Edge_room {
public:
  using Point = typename Geometry::Point;

  Edge_room() = default;
  /// In the triangle a, b, c, counterclockwise. The tip is the center of the inscribed circle, so that rooms are as
  /// wide as they can be. If rounding does not leave it inside the triangle, there is no room.
  Edge_room(const Point& a, const Point& b, const Point& c) : tip_(center_of_inscribed_circle(a, b, c)) {
    exists_ = Geometry::orientation(a, b, tip_) > 0 && Geometry::orientation(b, c, tip_) > 0 &&
              Geometry::orientation(c, a, tip_) > 0;
  }

  /// Whether p, a rounded point of the edge, is on it, on its right, or in the room.
  bool has(const Point& a, const Point& b, const Point& p) const {
    return exists_ ? is_before_sides(a, b, p) : Geometry::orientation(a, b, p) <= 0;
  }

private:
  Point tip_;
  bool exists_ = false;

  /// The same bits whichever side of the triangle comes first: rooms of two sides with two tips may overlap.
  static Point center_of_inscribed_circle(const Point& a, const Point& b, const Point& c) {
    if (is_before(b, a) || is_before(c, a)) return center_of_inscribed_circle(b, c, a);
    const Vector ab = Geometry::difference(b, a), ac = Geometry::difference(c, a);
    const double of_a = length(ac - ab), of_b = length(ac), of_c = length(ab), sum = of_a + of_b + of_c;
    return Geometry::translate(a, (of_b / sum) * ab + (of_c / sum) * ac);
  }
  static bool is_before(const Point& a, const Point& b) {
    const Vector v = Geometry::difference(b, a);
    return v.x > 0 || (v.x == 0 && v.y > 0);
  }

  /// No squares, which may be too large or small for doubles: users' points are of any scale.
  static double length(Vector v) { return std::hypot(v.x, v.y); }
  bool is_before_sides(const Point& a, const Point& b, const Point& p) const {
    return Geometry::orientation(b, tip_, p) > 0 && Geometry::orientation(tip_, a, p) > 0;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_EDGE_ROOM_H
