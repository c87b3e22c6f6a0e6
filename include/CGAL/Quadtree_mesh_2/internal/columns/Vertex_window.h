// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The mesh between two consecutive edges around a vertex, amid equal leaves, in a window of its own.
//
// Computes: the points on an edge near its vertex. One is on a square ring, at the same distance on all edges,
//           measured along the axis that the edge follows more. The next one is halfway to the first crossing
//           with a grid line that is used. For a sector, the corners of leaves that are kept for some
//           thresholds, the Delaunay triangulation of all these points, its least angle, and which of three
//           pairs of thresholds gives the largest one.
// Bound:    O(1): at most some 200 points in the window of 7 sides of leaves. In every sector of at least 33
//           degrees, one of the pairs gives angles of at least 20.7 degrees: proven by branch and bound over
//           positions and directions, in integers (test_vertex_certificate.cpp).
// Source:   the ring is that of Bern, Eppstein, Teng, section 6 (acute corners). The thresholds are ours,
//           found by a search.
// Deviates: the ring is a square, so coordinates of points are polynomials in the vertex's place and the edges'
//           slopes.
//
// Points on an edge depend only on that edge and the vertex, corners on the two edges of their sector. So
// sectors are independent of each other. The unit of all lengths is the side of the leaves around the vertex.
// Computed in doubles, because the results are only choices. In sectors above 180 degrees the other side of
// the edges is empty.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_VERTEX_WINDOW_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_VERTEX_WINDOW_H

#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Column_rule.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Small_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// An edge from its vertex, along the axis that it follows more.
struct Edge_axis {
  bool is_steep;     ///< along y
  bool is_ascending; ///< to greater coordinates

  /// \param direction of the edge
  static Edge_axis of(const Window_point& direction) {
    const bool is_steep = std::abs(direction.y) > std::abs(direction.x);
    return {is_steep, (is_steep ? direction.y : direction.x) > 0};
  }
  double along(const Window_point& p) const { return is_steep ? p.y : p.x; }
  /// The coordinate of a grid line, counted ahead so that the vertex's leaf is between 0 and 1.
  int line(int ahead) const { return is_ascending ? ahead : 1 - ahead; }
  /// Whether a corner is on a grid line that is far from the vertex.
  bool is_far(const Window_point& corner) const {
    return is_ascending ? along(corner) >= line(first_far_line) : along(corner) <= line(first_far_line);
  }
};

/// The points of an edge near its end.
struct Edge_start {
  std::array<double, 2> distances; ///< from the vertex: of the points on the ring and halfway to the crossing
  double first_crossing;           ///< its distance from the vertex
  int first_line;                  ///< crossings with grid lines count from this one on; `Edge_axis::line()`
};

/// \param vertex relative to the lower left corner of its leaf
/// \param direction of the edge, of length 1
inline Edge_start edge_start(const Window_point& vertex, const Window_point& direction,
                             const Edge_axis& axis) {
  const double from = axis.along(vertex), step = std::abs(axis.along(direction));
  const double to_end = axis.is_ascending ? from : 1 - from; // of the leaf, from behind
  const int ahead = static_cast<int>(std::ceil(to_end + vertex_ring.least_crossing));
  const double crossing = (ahead - to_end) / step, on_ring = vertex_ring.radius / step;
  return {{on_ring, (on_ring + crossing) / 2}, crossing, axis.line(ahead)};
}

/// The sector between two edges of a vertex, counterclockwise from the first to the second one; all around the
/// only edge of a vertex if both are the same.
class Vertex_window {
public:
  /// \param vertex relative to the lower left corner of its leaf
  /// \param first, second directions of the edges, of length 1
  Vertex_window(const Window_point& vertex, const Window_point& first, const Window_point& second)
      : vertex_(vertex), edges_{first, second}, axes_{Edge_axis::of(first), Edge_axis::of(second)} {
    edge_points_.push_back({vertex, 3});
    append_points_of_edge(0);
    if (!is_only_edge()) append_points_of_edge(1);
  }

  /// Whether a corner is in the sector, edges excluded.
  bool is_in_sector(const Window_point& corner) const {
    return is_inside(corner.x - vertex_.x, corner.y - vertex_.y);
  }

  /// Whether a corner in the sector is a vertex of the mesh as far as the vertex is concerned: on lines that are far
  /// from it the rule for columns decides.
  bool is_kept_near(const Window_point& corner, const Sector_thresholds& t) const {
    const double x = corner.x - vertex_.x, y = corner.y - vertex_.y;
    if (x * x + y * y < t.clear_of_vertex * t.clear_of_vertex) return false;
    for (std::size_t e = 0; e < 2; ++e)
      if (!axes_[e].is_far(corner) && is_near_edge(e, x, y, t.clear_of_edge)) return false;
    return true;
  }
  /// The same with the rule for columns.
  bool is_kept(const Window_point& corner, const Sector_thresholds& t) const {
    const double x = corner.x - vertex_.x, y = corner.y - vertex_.y;
    for (std::size_t e = 0; e < 2; ++e)
      if (axes_[e].is_far(corner) && is_near_edge(e, x, y, equal_leaves_threshold)) return false;
    return is_kept_near(corner, t);
  }

  /// In degrees, of triangles not further than `radius_of_triangles` from the vertex: of all that depend on the
  /// thresholds.
  double least_angle(const Sector_thresholds& t) {
    points_ = edge_points_;
    const auto first = [](double v) { return std::ceil(v - radius_of_points); };
    for (double x = first(vertex_.x); x <= vertex_.x + radius_of_points; ++x)
      for (double y = first(vertex_.y); y <= vertex_.y + radius_of_points; ++y)
        if (is_near(x, y, radius_of_points) && is_in_sector({x, y}) && is_kept({x, y}, t))
          points_.push_back({{x, y}, 0});
    places_.clear();
    for (const Point& p : points_) places_.push_back(p.p);
    triangulation_.triangulate(places_, edge_points_.size(), [&](const Triangle& triangle) {
      return is_more_than_half() && !is_in_sector(center(triangle));
    });
    double least = 1;
    triangulation_.for_each_triangle([&](const Triangle& triangle) {
      if (is_in_mesh(triangle)) least = std::min(least, squared_sine_of_least_angle(triangle));
    });
    return std::asin(std::sqrt(least)) * degrees_per_radian;
  }

  /// The first thresholds with a least angle that is large enough, by their place in the list; if there are none
  /// those with the largest one.
  template <class List>
  std::size_t best_of(const List& list, double large_enough = 25) {
    std::size_t best = 0;
    double angle = 0;
    for (std::size_t i = 0; i < list.size() && angle < large_enough; ++i) {
      const double a = least_angle(list[i]);
      if (a < angle + least_lead) continue;
      angle = a;
      best = i;
    }
    return best;
  }

  static constexpr double radius_of_points = 7.2, radius_of_triangles = 5.2;

private:
  using Triangle = Small_triangulation::Triangle;
  struct Point {
    Window_point p;
    unsigned edges; ///< bit i: on edge i
  };

  void append_points_of_edge(std::size_t i) {
    const Window_point& e = edges_[i];
    const Edge_start start = edge_start(vertex_, e, axes_[i]);
    const auto append = [&](double t) {
      edge_points_.push_back({{vertex_.x + t * e.x, vertex_.y + t * e.y}, 1u << i});
    };
    for (const double t : start.distances) append(t);
    const double step = 1 / std::abs(axes_[i].along(e));
    for (double t = start.first_crossing; t < radius_of_points + 2; t += step) append(t);
  }

  bool is_near(double x, double y, double radius) const {
    return (x - vertex_.x) * (x - vertex_.x) + (y - vertex_.y) * (y - vertex_.y) <= radius * radius;
  }
  /// Whether a point relative to the vertex is beside an edge, ahead, and nearer than a threshold.
  bool is_near_edge(std::size_t e, double x, double y, double threshold) const {
    const Window_point& d = edges_[e];
    return x * d.x + y * d.y > 0 && std::abs(d.x * y - d.y * x) < threshold;
  }
  bool is_only_edge() const { return edges_[0].x == edges_[1].x && edges_[0].y == edges_[1].y; }
  bool is_more_than_half() const {
    return !is_only_edge() && edges_[0].x * edges_[1].y - edges_[0].y * edges_[1].x <= 0;
  }
  bool is_inside(double x, double y) const {
    if (is_only_edge()) return true;
    const Window_point &a = edges_[0], &b = edges_[1];
    const bool is_left_of_first = a.x * y - a.y * x > 0, is_right_of_second = x * b.y - y * b.x > 0;
    return is_more_than_half() ? is_left_of_first || is_right_of_second
                               : is_left_of_first && is_right_of_second;
  }

  double cross(const Triangle& t) const {
    const Window_point &a = place(t, 0), &b = place(t, 1), &c = place(t, 2);
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  const Window_point& place(const Triangle& t, std::size_t i) const { return points_[t[i]].p; }

  /// Whether the triangle has an area, is in the sector and near the vertex.
  bool is_in_mesh(const Triangle& t) const {
    unsigned edges = 3;
    for (std::size_t i = 0; i < 3; ++i) edges &= points_[t[i]].edges;
    const Window_point c = center(t);
    return edges == 0 && cross(t) > 1e-10 && is_near(c.x, c.y, radius_of_triangles) && is_in_sector(c);
  }
  Window_point center(const Triangle& t) const {
    const Window_point &a = place(t, 0), &b = place(t, 1), &c = place(t, 2);
    return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
  }

  double squared_sine_of_least_angle(const Triangle& t) const {
    const auto squared_length = [&](std::size_t i, std::size_t j) {
      const Window_point &p = place(t, i), &q = place(t, j);
      return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
    };
    const double area = cross(t), p = squared_length(0, 1), q = squared_length(1, 2),
                 r = squared_length(2, 0);
    return area * area * std::min({p, q, r}) / (p * q * r);
  }

  Window_point vertex_;
  std::array<Window_point, 2> edges_;
  std::array<Edge_axis, 2> axes_;
  std::vector<Point> edge_points_, points_;
  std::vector<Window_point> places_; // of all points
  Small_triangulation triangulation_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_VERTEX_WINDOW_H
