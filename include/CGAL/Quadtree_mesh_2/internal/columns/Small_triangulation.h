// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The Delaunay triangulation of a few points near the origin.
//
// Computes: its triangles, counterclockwise.
// Bound:    O(n^2) for n points, a hundred or so.
// Source:   Bowyer, Watson (1981); constrained where edges bound an empty part of the plane.
// Deviates: computed in doubles. Of cocircular points any triangulation will do, because its least angle is the same.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_SMALL_TRIANGULATION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_SMALL_TRIANGULATION_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

struct Window_point {
  double x;
  double y;
};

class Small_triangulation {
public:
  using Triangle = std::array<std::size_t, 3>; ///< places of points in the range given

  /// \param points at most some hundred from the origin
  void triangulate(const std::vector<Window_point>& points) {
    triangulate(points, 0, [](const Triangle&) { return false; });
  }

  /// With edges as constraints that bound a part of the plane without other points: what is triangulated there, by the
  /// points on these edges, stays.
  /// \param number_on_edges how many of the points are on the edges; they come first
  /// \param is_apart called as `is_apart(triangle)`: whether the triangle of such points is in that part
  template <class Is_apart>
  void triangulate(const std::vector<Window_point>& points, std::size_t number_on_edges,
                   const Is_apart& is_apart) {
    points_.assign({{-3 * far_, -3.1 * far_}, {3.3 * far_, -2.9 * far_}, {300, 3.4 * far_}});
    points_.insert(points_.end(), points.begin(), points.end());
    all_.clear();
    append({0, 1, 2});
    apart_.clear();
    const std::size_t end_of_edges = around_ + number_on_edges;
    for (std::size_t v = around_; v < points_.size(); ++v) {
      if (v == end_of_edges) set_apart(is_apart);
      insert(v);
    }
  }

  /// Calls `f(triangle)`.
  template <class F>
  void for_each_triangle(const F& f) const {
    for (const auto* triangles : {&all_, &apart_})
      for (const Circle& t : *triangles) {
        const auto& v = t.vertices;
        if (v[0] >= around_ && v[1] >= around_ && v[2] >= around_)
          f(Triangle{v[0] - around_, v[1] - around_, v[2] - around_});
      }
  }

private:
  /// A triangle with the center and squared radius of its circle.
  struct Circle {
    Triangle vertices;
    Window_point center;
    double squared_radius;
  };
  using Side = std::pair<std::size_t, std::size_t>;

  /// Vertices of a triangle around all points.
  static constexpr std::size_t around_ = 3;
  static constexpr double far_ = 1e4;

  void append(const Triangle& vertices) {
    const Window_point &a = points_[vertices[0]], &b = points_[vertices[1]], &c = points_[vertices[2]];
    const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const double bb = bx * bx + by * by, cc = cx * cx + cy * cy, d = 2 * (bx * cy - by * cx);
    const double x = (cy * bb - by * cc) / d, y = (bx * cc - cx * bb) / d;
    // Points on a circle, but for rounding, are not in it.
    all_.push_back({vertices, {a.x + x, a.y + y}, (x * x + y * y) * (1 - 1e-11)});
  }

  template <class Is_apart>
  void set_apart(const Is_apart& is_apart) {
    const auto stays = [&](const Circle& t) {
      const auto& v = t.vertices;
      return v[0] < around_ || v[1] < around_ || v[2] < around_ ||
             !is_apart(Triangle{v[0] - around_, v[1] - around_, v[2] - around_});
    };
    const auto first = std::partition(all_.begin(), all_.end(), stays);
    apart_.assign(first, all_.end());
    all_.erase(first, all_.end());
  }

  bool contains(const Circle& t, const Window_point& p) const {
    const double x = p.x - t.center.x, y = p.y - t.center.y;
    return x * x + y * y < t.squared_radius;
  }

  /// Replaces the triangles in whose circle the vertex is by a fan: those that can be reached from the vertex.
  void insert(std::size_t v) {
    const Window_point p = points_[v];
    const auto first =
        std::partition(all_.begin(), all_.end(), [&](const Circle& t) { return !contains(t, p); });
    const auto last = apart_.empty() ? all_.end() : reachable(first, p);
    sides_.clear();
    for (auto t = first; t != last; ++t)
      for (std::size_t k = 0; k < 3; ++k) sides_.push_back({t->vertices[k], t->vertices[(k + 1) % 3]});
    all_.erase(first, last);
    for (const Side& s : sides_)
      if (std::find(sides_.begin(), sides_.end(), Side{s.second, s.first}) == sides_.end())
        append({s.first, s.second, v});
  }

  using Iterator = std::vector<Circle>::iterator;

  /// Puts the triangle around a point first, then those across sides; returns the end of these.
  Iterator reachable(Iterator first, const Window_point& p) {
    const auto around = [&](const Circle& t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Window_point &a = points_[t.vertices[k]], &b = points_[t.vertices[(k + 1) % 3]];
        if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < -1e-9) return false;
      }
      return true;
    };
    auto end = std::partition(first, all_.end(), around);
    for (auto t = first; t != end; ++t) {
      const Triangle v = t->vertices;
      end = std::partition(end, all_.end(), [&](const Circle& other) {
        std::size_t common = 0;
        for (const std::size_t w : other.vertices) common += w == v[0] || w == v[1] || w == v[2] ? 1u : 0u;
        return common == 2;
      });
    }
    return end;
  }

  std::vector<Window_point> points_;
  std::vector<Circle> all_, apart_;
  std::vector<Side> sides_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_SMALL_TRIANGULATION_H
