// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The Delaunay triangulation of a few points near the origin.
//
// Computes: its triangles, counterclockwise.
// Bound:    O(n^2) for n points, a hundred or so.
// Source:   Bowyer, Watson (1981).
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
    points_.assign({{-3 * far_, -3.1 * far_}, {3.3 * far_, -2.9 * far_}, {300, 3.4 * far_}});
    points_.insert(points_.end(), points.begin(), points.end());
    all_.clear();
    append({0, 1, 2});
    for (std::size_t v = around_; v < points_.size(); ++v) insert(v);
  }

  /// Calls `f(triangle)`.
  template <class F>
  void for_each_triangle(const F& f) const {
    for (const Circle& t : all_) {
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

  /// Replaces the triangles in whose circle the vertex is by a fan.
  void insert(std::size_t v) {
    const Window_point p = points_[v];
    sides_.clear();
    for (std::size_t i = 0; i < all_.size();) {
      const Circle& t = all_[i];
      const double x = p.x - t.center.x, y = p.y - t.center.y;
      if (x * x + y * y >= t.squared_radius) {
        ++i;
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) sides_.push_back({t.vertices[k], t.vertices[(k + 1) % 3]});
      all_[i] = all_.back();
      all_.pop_back();
    }
    for (const Side& s : sides_)
      if (std::find(sides_.begin(), sides_.end(), Side{s.second, s.first}) == sides_.end())
        append({s.first, s.second, v});
  }

  std::vector<Window_point> points_;
  std::vector<Circle> all_;
  std::vector<Side> sides_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_SMALL_TRIANGULATION_H
