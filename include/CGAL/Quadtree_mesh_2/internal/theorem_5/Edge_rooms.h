// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where rounded points may stand for points on the edges of a graph.
//
// Computes: for each edge the rooms on both sides of it (Edge_room.h). Edges whose vertices are rounded within their
//           rooms neither cross nor touch, and no vertex gets to the other side of one.
// Bound:    O(1) for a point.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_EDGE_ROOMS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_EDGE_ROOMS_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_problem.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Edge_room.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Edge_rooms {
public:
  using Point = typename Geometry::Point;

  /// \param triangles beside the edges, kept by reference. Of an edge at the border of the domain, the problem knows
  ///        what is beyond it.
  Edge_rooms(const Meshing_problem<Geometry>& problem, const Edge_triangles<Geometry>& triangles)
      : problem_(problem), triangles_(triangles) {}

  /// Whether an edge may get vertices.
  bool has_rooms(Edge_id e) const { return triangles_[e].is_any(); }

  /// Whether p lies between `last` and the edge's second end, so far from both that rounding turns no piece
  /// of the edge much. Here `last` is the vertex before p, or the edge's first end.
  bool is_in_order(Edge_id e, const Point& last, const Point& p) const {
    const Vector d = direction(e), before = Geometry::difference(p, last),
                 behind = Geometry::difference(problem_.input_point(problem_.edges[e].b), p);
    const double least = least_distance_ * Geometry::spacing(p);
    for (const double distance : {along(d, before), along(d, behind)})
      if (!(distance > 0 && distance >= least)) return false;
    return true;
  }

  /// The place in the room of an edge that is p or next to it, if there is one.
  /// \pre p is a point of the edge, rounded
  std::optional<Point> place_next_to(Edge_id e, const Point& p) const {
    if (is_in_room(e, p)) return p;
    if constexpr (!Geometry::has_unlimited_coordinates) {
      // On the edge, if that were possible, and to either side of it, no further than how p was rounded.
      const Vector d = direction(e),
                   from_a = Geometry::difference(p, problem_.input_point(problem_.edges[e].a));
      const bool is_steep = std::fabs(d.y) > std::fabs(d.x);
      const double way = cross(d, from_a) / (is_steep ? d.y : -d.x);
      const double spacing = Geometry::spacing(is_steep ? p.x : p.y),
                   rounding = std::numeric_limits<double>::epsilon() * std::fabs(along(d, from_a));
      const auto beside = [&](double f) {
        return Geometry::translate(p, is_steep ? Vector{way + f, 0} : Vector{0, way + f});
      };
      if (const Point q = beside(0); is_in_room(e, q)) return q;
      for (double step = spacing; step < 2 * std::max(spacing, rounding); step *= 2)
        for (const double f : {step, -step})
          if (const Point q = beside(f); is_in_room(e, q)) return q;
    }
    return std::nullopt;
  }

private:
  /// Of neighbors on an edge, in units of the coordinates.
  static constexpr double least_distance_ = 8;

  const Meshing_problem<Geometry>& problem_;
  const Edge_triangles<Geometry>& triangles_;

  Vector direction(Edge_id e) const {
    return Geometry::difference(problem_.input_point(problem_.edges[e].b),
                                problem_.input_point(problem_.edges[e].a));
  }
  /// How far a way goes on in x, or in y where d is steep.
  static double along(Vector d, Vector way) {
    return std::fabs(d.y) > std::fabs(d.x) ? std::copysign(1.0, d.y) * way.y
                                           : std::copysign(1.0, d.x) * way.x;
  }

  bool is_in_room(Edge_id e, const Point& p) const {
    if constexpr (Geometry::has_unlimited_coordinates) {
      static_cast<void>(e), static_cast<void>(p);
      return true; // it is on the edge
    } else {
      const Point &a = problem_.input_point(problem_.edges[e].a),
                  &b = problem_.input_point(problem_.edges[e].b);
      const int side = Geometry::orientation(a, b, p);
      if (side == 0) return true;
      const Side triangle = side > 0 ? triangles_[e].left : triangles_[e].right;
      if (triangle.is_border()) return problem_.is_clear_of_outside(e, p);
      const Edge_room<Geometry> room = side > 0 ? Edge_room<Geometry>(a, b, triangles_.apex(triangle))
                                                : Edge_room<Geometry>(b, a, triangles_.apex(triangle));
      return side > 0 ? room.has(a, b, p) : room.has(b, a, p);
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_EDGE_ROOMS_H
