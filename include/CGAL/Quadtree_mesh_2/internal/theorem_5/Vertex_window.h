// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The mesh between two consecutive edges around a vertex, amid equal leaves, in a window of its own.
//
// Computes: the points on an edge near its vertex. One is on a ring, at the same distance on all edges.
//           Another is halfway to the first crossing with a grid line if that is far. For a sector, the
//           corners of leaves that are kept for some thresholds, the Delaunay triangulation of all these
//           points, its least angle, and which of a few pairs of thresholds gives the largest one.
// Bound:    O(1): at most some 150 points in the window of 6 sides of leaves.
// Source:   the ring is that of Bern, Eppstein, Teng, section 6 (acute corners). The thresholds are ours,
//           found by a search. Bowyer, Watson (1981) for the triangulation.
// Deviates: established numerically only. Random search and descent over positions, directions and sectors of
//           at least 33 degrees finds no least angle below `least_angle_of_sectors` (test_vertex_window.cpp).
//
// Points on an edge depend only on that edge and the vertex, corners on the two edges of their sector. So
// sectors are independent of each other. The unit of all lengths is the side of the leaves around the vertex.
// Computed in doubles, because the results are only choices. In sectors above 180 degrees the other side of
// the edges is empty, and edges are sides of triangles if the sectors there are at least 20 degrees.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_VERTEX_WINDOW_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_VERTEX_WINDOW_H

#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Column_rule.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

struct Window_point {
  double x;
  double y;
};

/// The points of an edge near its end.
struct Edge_start {
  std::array<double, 2> distances; ///< from the vertex, by size
  std::size_t number_of_distances;
  double first_crossing; ///< crossings with grid lines count from this distance on
};

/// \param vertex relative to some corner of a leaf
/// \param direction of the edge, of length 1
inline Edge_start edge_start(const Window_point& vertex, const Window_point& direction,
                             const Vertex_ring& ring) {
  const bool is_steep = std::abs(direction.y) > std::abs(direction.x);
  const double from = is_steep ? vertex.y : vertex.x, step = is_steep ? direction.y : direction.x;
  // The first grid line that is far enough.
  const double least = from + step * (ring.radius + ring.least_gap);
  const double line = step > 0 ? std::ceil(least) : std::floor(least);
  const double crossing = (line - from) / step;
  Edge_start start{{ring.radius, 0}, 1, crossing};
  if (crossing - ring.radius > ring.greatest_gap)
    start.distances[start.number_of_distances++] = (ring.radius + crossing) / 2;
  return start;
}

/// The sector between two edges of a vertex, counterclockwise from the first to the second one; all around the
/// only edge of a vertex if both are the same.
class Vertex_window {
public:
  /// \param vertex relative to some corner of a leaf
  /// \param first, second directions of the edges, of length 1
  Vertex_window(const Window_point& vertex, const Window_point& first, const Window_point& second,
                const Vertex_ring& ring)
      : vertex_(vertex), edges_{first, second} {
    edge_points_.push_back({vertex, 3});
    append_points_of_edge(0, ring);
    if (!is_only_edge()) append_points_of_edge(1, ring);
  }

  /// Whether a corner is in the sector, edges excluded.
  bool is_in_sector(const Window_point& corner) const {
    return is_inside(corner.x - vertex_.x, corner.y - vertex_.y);
  }

  /// Whether a corner in the sector is a vertex of the mesh.
  bool is_kept(const Window_point& corner, const Sector_thresholds& t) const {
    const double x = corner.x - vertex_.x, y = corner.y - vertex_.y;
    if (x * x + y * y < t.clear_of_vertex * t.clear_of_vertex) return false;
    for (const Window_point& e : edges_) {
      const double along = x * e.x + y * e.y;
      const double threshold = along < vertex_reach ? t.clear_of_edge : equal_leaves_threshold;
      if (along > 0 && std::abs(e.x * y - e.y * x) < threshold) return false;
    }
    return true;
  }

  /// In degrees, of triangles not further than `radius_of_triangles` from the vertex.
  double least_angle(const Sector_thresholds& t) {
    points_ = edge_points_;
    const auto first = [](double v) { return std::ceil(v - radius_of_points); };
    for (double x = first(vertex_.x); x <= vertex_.x + radius_of_points; ++x)
      for (double y = first(vertex_.y); y <= vertex_.y + radius_of_points; ++y)
        if (is_near(x, y, radius_of_points) && is_in_sector({x, y}) && is_kept({x, y}, t))
          points_.push_back({{x, y}, 0});
    triangulate();
    double least = 1;
    for (const Triangle& triangle : triangles_)
      if (is_in_mesh(triangle)) least = std::min(least, squared_sine_of_least_angle(triangle));
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

  static constexpr double radius_of_points = 6.2, radius_of_triangles = 4.2;

private:
  struct Point {
    Window_point p;
    unsigned edges; ///< bit i: on edge i
  };
  /// With the center and squared radius of its circle.
  struct Triangle {
    std::array<std::size_t, 3> vertices;
    Window_point center;
    double squared_radius;
  };

  void append_points_of_edge(std::size_t i, const Vertex_ring& ring) {
    const Window_point& e = edges_[i];
    const Edge_start start = edge_start(vertex_, e, ring);
    const auto append = [&](double t) {
      edge_points_.push_back({{vertex_.x + t * e.x, vertex_.y + t * e.y}, 1u << i});
    };
    for (std::size_t k = 0; k < start.number_of_distances; ++k) append(start.distances[k]);
    const double step = 1 / std::max(std::abs(e.x), std::abs(e.y));
    for (double t = start.first_crossing; t < radius_of_points + 2; t += step) append(t);
  }

  bool is_near(double x, double y, double radius) const {
    return (x - vertex_.x) * (x - vertex_.x) + (y - vertex_.y) * (y - vertex_.y) <= radius * radius;
  }
  bool is_only_edge() const { return edges_[0].x == edges_[1].x && edges_[0].y == edges_[1].y; }
  bool is_inside(double x, double y) const {
    if (is_only_edge()) return true;
    const Window_point &a = edges_[0], &b = edges_[1];
    const bool is_left_of_first = a.x * y - a.y * x > 0, is_right_of_second = x * b.y - y * b.x > 0;
    return a.x * b.y - a.y * b.x > 0 ? is_left_of_first && is_right_of_second
                                     : is_left_of_first || is_right_of_second;
  }

  double cross(const Triangle& t) const {
    const Window_point &a = point(t, 0), &b = point(t, 1), &c = point(t, 2);
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  const Window_point& point(const Triangle& t, std::size_t i) const { return points_[t.vertices[i]].p; }

  /// Whether the triangle has an area, is in the sector and near the vertex.
  bool is_in_mesh(const Triangle& t) const {
    unsigned edges = 3;
    Window_point sum{0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      if (t.vertices[i] < 3) return false; // of the surrounding triangle
      edges &= points_[t.vertices[i]].edges;
      sum = {sum.x + point(t, i).x, sum.y + point(t, i).y};
    }
    const Window_point center{sum.x / 3, sum.y / 3};
    return edges == 0 && cross(t) > 1e-10 && is_near(center.x, center.y, radius_of_triangles) &&
           is_in_sector(center);
  }

  double squared_sine_of_least_angle(const Triangle& t) const {
    const auto squared_length = [&](std::size_t i, std::size_t j) {
      const Window_point &p = point(t, i), &q = point(t, j);
      return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
    };
    const double area = cross(t), p = squared_length(0, 1), q = squared_length(1, 2),
                 r = squared_length(2, 0);
    return area * area * std::min({p, q, r}) / (p * q * r);
  }

  void triangulate() {
    constexpr double far = 1e4;
    const std::array<Point, 3> around{
        {{{-3 * far, -3.1 * far}, 0}, {{3.3 * far, -2.9 * far}, 0}, {{300, 3.4 * far}, 0}}};
    points_.insert(points_.begin(), around.begin(), around.end());
    triangles_.clear();
    append_triangle({0, 1, 2});
    for (std::size_t v = 3; v < points_.size(); ++v) insert(v);
  }

  void append_triangle(const std::array<std::size_t, 3>& vertices) {
    const Window_point &a = points_[vertices[0]].p, &b = points_[vertices[1]].p, &c = points_[vertices[2]].p;
    const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const double bb = bx * bx + by * by, cc = cx * cx + cy * cy, d = 2 * (bx * cy - by * cx);
    const double x = (cy * bb - by * cc) / d, y = (bx * cc - cx * bb) / d;
    triangles_.push_back({vertices, {a.x + x, a.y + y}, x * x + y * y});
  }

  /// Replaces the triangles in whose circle the vertex is by a fan.
  void insert(std::size_t v) {
    const Window_point& p = points_[v].p;
    sides_.clear();
    const auto removed = std::remove_if(triangles_.begin(), triangles_.end(), [&](const Triangle& t) {
      const double x = p.x - t.center.x, y = p.y - t.center.y;
      if (x * x + y * y >= t.squared_radius * (1 - 1e-11)) return false;
      for (std::size_t i = 0; i < 3; ++i) sides_.push_back({t.vertices[i], t.vertices[(i + 1) % 3]});
      return true;
    });
    triangles_.erase(removed, triangles_.end());
    for (const auto& s : sides_)
      if (std::find(sides_.begin(), sides_.end(), Point_pair{s[1], s[0]}) == sides_.end())
        append_triangle({s[0], s[1], v});
  }

  using Point_pair = std::array<std::size_t, 2>;

  Window_point vertex_;
  std::array<Window_point, 2> edges_;
  std::vector<Point> edge_points_, points_;
  std::vector<Triangle> triangles_;
  std::vector<Point_pair> sides_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_VERTEX_WINDOW_H
