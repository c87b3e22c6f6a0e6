// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Which triangle of a mesh a place is in.
//
// Computes: the triangle with a place in it, or else the nearest one; the triangles whose boxes meet a box.
// Bound:    O(k log k) time to build for k triangles. A question takes O(log k) in meshes without small angles.
// Method:   Boxes in a binary tree, halved along their longer side (as in Points_sizing_field_2.h). Whether a triangle
//           has a place in it is decided exactly. Of several triangles the one with the lowest index is taken, so
//           answers do not depend on the tree.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_TRIANGLE_TREE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_TRIANGLE_TREE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Quadtree_mesh_2/Index.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The squared distance of `p` from the segment from a to b.
template <class Point>
double squared_distance_from_segment(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), length2 = dx * dx + dy * dy;
  const double along = (p.x() - a.x()) * dx + (p.y() - a.y()) * dy;
  const double t = length2 > 0 ? std::min(1., std::max(0., along / length2)) : 0;
  const double x = a.x() + t * dx - p.x(), y = a.y() + t * dy - p.y();
  return x * x + y * y;
}

/// A power of two whose product with a number is near 1: squares of coordinates themselves may be beyond doubles.
inline double unit_for(double magnitude) {
  constexpr int most = 1000;
  return magnitude > 0 ? std::ldexp(1, std::min(most, std::max(-most, -std::ilogb(magnitude)))) : 1;
}

/// The shares of the corners in the nearest place on the border of a triangle.
/// \pre squares of lengths are within doubles
template <class Point>
std::array<double, 3> weights_on_border(const std::array<Point, 3>& t, const Point& p) {
  std::array<double, 3> best{1, 0, 0};
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &a = t[k], &b = t[(k + 1) % 3];
    const double dx = b.x() - a.x(), dy = b.y() - a.y(), length2 = dx * dx + dy * dy;
    const double along = (p.x() - a.x()) * dx + (p.y() - a.y()) * dy;
    const double share = length2 > 0 ? std::min(1., std::max(0., along / length2)) : 0;
    const double distance = p == a || p == b ? 0 : squared_distance_from_segment(p, a, b);
    if (distance >= nearest) continue;
    nearest = distance, best = {};
    best[k] = p == b ? 0 : 1 - share, best[(k + 1) % 3] = p == b ? 1 : share;
  }
  return best;
}

/// Twice the area of the triangle of p, a and b, rounded at last.
template <class Point>
double exact_area2_from(const Point& p, const Point& a, const Point& b) {
  const auto difference = [](double x, double y) { return MP_Float(x) - MP_Float(y); };
  return CGAL::to_double(difference(a.x(), p.x()) * difference(b.y(), p.y()) -
                         difference(a.y(), p.y()) * difference(b.x(), p.x()));
}

/// The shares of the corners in a place: barycentric coordinates, those of the nearest place for one beside the
/// triangle. A corner has exactly (1, 0, 0), (0, 1, 0) or (0, 0, 1).
template <class Point>
std::array<double, 3> corner_weights(const std::array<Point, 3>& triangle, const Point& place) {
  double reach = 0;
  for (const Point& c : triangle)
    reach = std::max({reach, std::fabs(c.x() - place.x()), std::fabs(c.y() - place.y())});
  const double unit = unit_for(reach);
  const auto scaled = [unit](const Point& p) { return Point(unit * p.x(), unit * p.y()); };
  const std::array<Point, 3> t{scaled(triangle[0]), scaled(triangle[1]), scaled(triangle[2])};
  const Point p = scaled(place);
  constexpr double flat = 0x1p-10; // what rounding does to areas above this does not show
  const auto area2 = [&p](const Point& a, const Point& b) {
    return (a.x() - p.x()) * (b.y() - p.y()) - (a.y() - p.y()) * (b.x() - p.x());
  };
  std::array<double, 3> weights;
  for (std::size_t k = 0; k < 3; ++k) weights[k] = area2(t[(k + 1) % 3], t[(k + 2) % 3]);
  if (weights[0] + weights[1] + weights[2] < flat)
    for (std::size_t k = 0; k < 3; ++k) weights[k] = exact_area2_from(p, t[(k + 1) % 3], t[(k + 2) % 3]);
  const double sum = weights[0] + weights[1] + weights[2];
  if (std::min({weights[0], weights[1], weights[2]}) < 0 || !(sum > 0)) return weights_on_border(t, p);
  for (double& w : weights) w /= sum;
  return weights;
}

class Triangle_tree {
public:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  using Corners = std::array<Point, 3>;
  struct Box {
    std::array<double, 2> low, high;
  };
  struct Nearest {
    Triangle_index triangle; ///< the lowest index of those that are as near
    double distance;         ///< 0 within the triangle, its border included, and only there
  };

  /// \pre there is a triangle, and all are counterclockwise
  Triangle_tree(const std::vector<Point>& points, const std::vector<std::array<Vertex_index, 3>>& triangles) {
    entries_.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
      entries_.push_back({{points[std::size_t(triangles[t][0])], points[std::size_t(triangles[t][1])],
                           points[std::size_t(triangles[t][2])]},
                          Triangle_index(t)});
    std::size_t leaves = 1;
    while (leaves * leaf_size < entries_.size()) leaves *= 2;
    boxes_.resize(2 * leaves - 1);
    build(0, 0, entries_.size());
    const auto& [low, high] = boxes_[0];
    unit_ = unit_for(std::max({-low[0], -low[1], high[0], high[1]}));
  }

  static Box box_of(const Corners& t) {
    return {{std::min({t[0].x(), t[1].x(), t[2].x()}), std::min({t[0].y(), t[1].y(), t[2].y()})},
            {std::max({t[0].x(), t[1].x(), t[2].x()}), std::max({t[0].y(), t[1].y(), t[2].y()})}};
  }

  /// Calls `f(corners, index)` for the triangles whose boxes have a place in common with `box`.
  template <class F>
  void for_each_meeting(const Box& box, const F& f) const {
    visit(0, 0, entries_.size(), box, f);
  }

  /// The triangle with `p` in it, or else the nearest one.
  Nearest nearest(const Point& p) const {
    Candidate best{Triangle_index(), std::numeric_limits<double>::infinity()};
    search(0, 0, entries_.size(), p, best);
    if (best.squared_distance == 0) return {best.triangle, 0};
    return {best.triangle,
            std::max(std::numeric_limits<double>::denorm_min(), std::sqrt(best.squared_distance) / unit_)};
  }

  static bool has_inside_or_on(const Corners& t, const Point& p) {
    const auto turn = Kernel().orientation_2_object();
    return turn(t[0], t[1], p) != RIGHT_TURN && turn(t[1], t[2], p) != RIGHT_TURN &&
           turn(t[2], t[0], p) != RIGHT_TURN;
  }

private:
  static constexpr std::size_t leaf_size = 8;

  struct Entry {
    Corners corners;
    Triangle_index triangle;
  };
  struct Candidate {
    Triangle_index triangle;
    double squared_distance; // of scaled places
  };

  std::vector<Entry> entries_; // in the order of the leaves
  std::vector<Box> boxes_;     // the children of node i are 2 i + 1 and 2 i + 2
  double unit_ = 1;            // by which coordinates are multiplied before they are squared

  bool is_leaf(std::size_t node) const { return 2 * node + 1 >= boxes_.size(); }
  static std::size_t middle_of(std::size_t begin, std::size_t end) { return begin + (end - begin) / 2; }

  void build(std::size_t node, std::size_t begin, std::size_t end) {
    Box& box = boxes_[node];
    constexpr double infinity = std::numeric_limits<double>::infinity();
    box = {{infinity, infinity}, {-infinity, -infinity}};
    for (std::size_t i = begin; i < end; ++i) {
      const Box own = box_of(entries_[i].corners);
      for (std::size_t k = 0; k < 2; ++k) {
        box.low[k] = std::min(box.low[k], own.low[k]);
        box.high[k] = std::max(box.high[k], own.high[k]);
      }
    }
    if (is_leaf(node)) return;
    const bool is_wide = box.high[0] - box.low[0] >= box.high[1] - box.low[1];
    const auto center = [is_wide](const Entry& e) {
      const Corners& t = e.corners;
      return is_wide ? t[0].x() + t[1].x() + t[2].x() : t[0].y() + t[1].y() + t[2].y();
    };
    const auto at = [this](std::size_t i) { return entries_.begin() + std::ptrdiff_t(i); };
    const std::size_t middle = middle_of(begin, end);
    std::nth_element(at(begin), at(middle), at(end),
                     [&](const Entry& a, const Entry& b) { return center(a) < center(b); });
    build(2 * node + 1, begin, middle);
    build(2 * node + 2, middle, end);
  }

  template <class F>
  void visit(std::size_t node, std::size_t begin, std::size_t end, const Box& box, const F& f) const {
    if (!meet(boxes_[node], box)) return;
    if (is_leaf(node)) {
      for (std::size_t i = begin; i < end; ++i)
        if (meet(box_of(entries_[i].corners), box)) f(entries_[i].corners, entries_[i].triangle);
      return;
    }
    const std::size_t middle = middle_of(begin, end);
    visit(2 * node + 1, begin, middle, box, f);
    visit(2 * node + 2, middle, end, box, f);
  }

  static bool meet(const Box& a, const Box& b) {
    return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] && b.low[1] <= a.high[1];
  }

  Point scaled(const Point& p) const { return Point(unit_ * p.x(), unit_ * p.y()); }

  /// No triangle below the node is nearer than this (squared).
  double least(std::size_t node, const Point& p) const {
    const Box& b = boxes_[node];
    const double dx = std::max({unit_ * b.low[0] - unit_ * p.x(), unit_ * p.x() - unit_ * b.high[0], 0.});
    const double dy = std::max({unit_ * b.low[1] - unit_ * p.y(), unit_ * p.y() - unit_ * b.high[1], 0.});
    return dx * dx + dy * dy;
  }

  double squared_distance(const Corners& t, const Point& p) const {
    if (has_inside_or_on(t, p)) return 0;
    const Corners c{scaled(t[0]), scaled(t[1]), scaled(t[2])};
    const Point q = scaled(p);
    return std::max(
        std::numeric_limits<double>::min(),
        std::min({squared_distance_from_segment(q, c[0], c[1]), squared_distance_from_segment(q, c[1], c[2]),
                  squared_distance_from_segment(q, c[2], c[0])}));
  }

  void search(std::size_t node, std::size_t begin, std::size_t end, const Point& p, Candidate& best) const {
    if (least(node, p) > best.squared_distance) return;
    if (is_leaf(node)) {
      for (std::size_t i = begin; i < end; ++i) {
        const double d = squared_distance(entries_[i].corners, p);
        if (d < best.squared_distance || (d == best.squared_distance && entries_[i].triangle < best.triangle))
          best = {entries_[i].triangle, d};
      }
      return;
    }
    const std::size_t middle = middle_of(begin, end);
    const bool is_left_first = least(2 * node + 1, p) <= least(2 * node + 2, p);
    if (is_left_first) search(2 * node + 1, begin, middle, p, best);
    search(2 * node + 2, middle, end, p, best);
    if (!is_left_first) search(2 * node + 1, begin, middle, p, best);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_TRIANGLE_TREE_H
