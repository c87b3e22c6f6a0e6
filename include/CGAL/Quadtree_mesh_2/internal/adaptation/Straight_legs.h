// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Vertices inside of the straight sides of corners, in a mesh that knows only edges.
//
// In a mesh from a file each constrained edge is a segment of its own. Where two sides meet at a sharp corner, the
// triangles between them are excused for the whole sides alone: edges farther away from the corner are only two near
// lines. So edges in a row become one side again, if they have one marker and their vertices are on a straight line but
// for rounding.
//
// Computes: for each constrained edge at a corner below 60 degrees, the longest straight chain of edges that begins with
//           it. The vertices inside of it are within two units in the last place of the line between its ends. Nothing
//           else ends at them.
// Bound:    O(n log n) time, and that of the chains that leave a corner without turning back.
// Source:   ours. The directions in which all vertices so far are passed form a cone, which only gets narrower.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_STRAIGHT_LEGS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_STRAIGHT_LEGS_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Triangle_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Straight_legs {
public:
  using Point = Triangle_tree::Point;
  using Mesh = Indexed_mesh_2<Point>;

  /// \param may_be_inside per vertex, whether it may be inside of a side
  Straight_legs(const Mesh& mesh, std::vector<char> may_be_inside)
      : mesh_(mesh), may_be_inside_(std::move(may_be_inside)) {
    find_edges_at_vertices();
  }

  /// Per vertex, whether it is inside of a straight side of a corner.
  std::vector<char> inner_vertices() {
    is_inside_.assign(mesh_.points.size(), 0);
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      for (std::size_t i = first_[v]; i < first_[v + 1]; ++i)
        if (is_at_corner(v, edges_[i])) mark_leg(Vertex_index(v), edges_[i]);
    return std::move(is_inside_);
  }

private:
  static constexpr double units_of_rounding = 2;

  const Mesh& mesh_;
  std::vector<char> may_be_inside_, is_inside_;
  std::vector<std::size_t> first_,
      edges_; // the constrained edges at v are those from first_[v] to first_[v + 1]
  std::vector<Vertex_index> path_;

  void find_edges_at_vertices() {
    first_.assign(mesh_.points.size() + 1, 0);
    for (const auto& e : mesh_.constrained_edges)
      for (const Vertex_index v : e.vertices) ++first_[std::size_t(v) + 1];
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) first_[v + 1] += first_[v];
    edges_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t e = 0; e < mesh_.constrained_edges.size(); ++e)
      for (const Vertex_index v : mesh_.constrained_edges[e].vertices) edges_[next[std::size_t(v)]++] = e;
  }

  Vertex_index other_end(std::size_t e, Vertex_index v) const {
    const auto& ends = mesh_.constrained_edges[e].vertices;
    return ends[ends[0] == v ? 1 : 0];
  }

  /// Whether p and q are seen from o at less than 60 degrees.
  bool are_within_60_degrees(const Point& o, const Point& p, const Point& q) const {
    const double ux = p.x() - o.x(), uy = p.y() - o.y(), vx = q.x() - o.x(), vy = q.y() - o.y();
    return ux * vx + uy * vy > 0.5 * std::hypot(ux, uy) * std::hypot(vx, vy);
  }

  bool is_at_corner(std::size_t v, std::size_t e) const {
    const Vertex_index own(v);
    const Point &o = mesh_.points[v], &p = mesh_.point(other_end(e, own));
    return std::any_of(
        edges_.begin() + std::ptrdiff_t(first_[v]), edges_.begin() + std::ptrdiff_t(first_[v + 1]),
        [&](std::size_t f) { return f != e && are_within_60_degrees(o, p, mesh_.point(other_end(f, own))); });
  }

  void mark_leg(Vertex_index apex, std::size_t e) {
    find_path(apex, e);
    // Rounding is as coarse as the largest coordinate of the side, which is known with its end.
    std::size_t end = path_.size() - 1;
    for (std::size_t before = end + 1; end < before;) {
      before = end;
      end = straight_end(reach_up_to(end));
    }
    for (std::size_t i = 1; i < end; ++i) is_inside_[std::size_t(path_[i])] = 1;
    may_be_inside_[std::size_t(path_[end])] = 0; // a side from elsewhere ends here, too
  }

  /// The vertices from a corner along an edge, as long as the way leads on and away.
  void find_path(Vertex_index apex, std::size_t e) {
    path_.assign({apex, other_end(e, apex)});
    const Point& o = mesh_.point(apex);
    for (;;) {
      const Vertex_index v = path_.back();
      const std::size_t at = first_[std::size_t(v)];
      if (may_be_inside_[std::size_t(v)] == 0 || first_[std::size_t(v) + 1] != at + 2) return;
      const std::size_t next = edges_[at] == e ? edges_[at + 1] : edges_[at];
      const Vertex_index w = other_end(next, v);
      const Point &p = mesh_.point(v), &q = mesh_.point(w);
      const bool leads_on =
          std::hypot(q.x() - o.x(), q.y() - o.y()) > std::hypot(p.x() - o.x(), p.y() - o.y());
      if (mesh_.constrained_edges[next].marker != mesh_.constrained_edges[e].marker || !leads_on ||
          !are_within_60_degrees(o, p, q))
        return;
      path_.push_back(w), e = next;
    }
  }

  std::array<double, 2> reach_up_to(std::size_t end) const {
    double x = 0, y = 0;
    for (std::size_t i = 0; i <= end; ++i) {
      x = std::max(x, std::fabs(mesh_.point(path_[i]).x()));
      y = std::max(y, std::fabs(mesh_.point(path_[i]).y()));
    }
    const auto units = [](double magnitude) {
      return units_of_rounding *
             (std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude);
    };
    return {units(x), units(y)};
  }

  /// The place in the path of the last vertex to which the way is straight.
  std::size_t straight_end(const std::array<double, 2>& reach) const {
    const auto turn = Triangle_tree::Kernel().orientation_2_object();
    const Point& o = mesh_.point(path_[0]);
    Point left, right; // of the cone, as seen from the corner
    bool has_cone = false;
    for (std::size_t i = 1; i < path_.size(); ++i) {
      const Point& p = mesh_.point(path_[i]);
      if (has_cone && (turn(o, right, p) == RIGHT_TURN || turn(o, left, p) == LEFT_TURN)) return i - 1;
      Point low = p, high = p; // the ends of the box around p as seen from the corner
      for (const double x : {p.x() - reach[0], p.x() + reach[0]})
        for (const double y : {p.y() - reach[1], p.y() + reach[1]}) {
          if (turn(o, low, Point(x, y)) == RIGHT_TURN) low = Point(x, y);
          if (turn(o, high, Point(x, y)) == LEFT_TURN) high = Point(x, y);
        }
      const bool is_around_corner =
          std::fabs(p.x() - o.x()) <= reach[0] && std::fabs(p.y() - o.y()) <= reach[1];
      if (is_around_corner) continue; // passed in any direction
      if (!has_cone || turn(o, right, low) == LEFT_TURN) right = low;
      if (!has_cone || turn(o, left, high) == RIGHT_TURN) left = high;
      has_cone = true;
    }
    return path_.size() - 1;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_STRAIGHT_LEGS_H
