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
// Computes: for each constrained edge at a corner below 60 degrees, the longest straight chain of edges that begins
//           with it. The vertices inside of it are within two units in the last place of the line between its ends.
//           Nothing else ends at them, and no vertex next to the chain is beyond the line, unless it is inside of
//           another chain from the corner that ends on its own side: both are straight lines then.
// Bound:    O(n log n) time, and that of the chains that leave a corner within rounding of a line.
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
#include <map>
#include <utility>
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
      : mesh_(mesh), may_be_inside_(std::move(may_be_inside)), widest_reach_(reach_of(mesh.points)) {
    find_edges_at_vertices();
    find_vertices_across();
    find_triangles_at_vertices();
  }

  /// Per vertex, whether it is inside of a straight side of a corner.
  std::vector<char> inner_vertices() {
    is_inside_.assign(mesh_.points.size(), 0);
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) mark_legs(v);
    return std::move(is_inside_);
  }

private:
  static constexpr double units_of_rounding = 2;

  /// From a corner to the end of the straight side.
  struct Leg {
    std::vector<Vertex_index> path;
    std::vector<std::size_t> edges; // between each of them and the next

    Vertex_index end() const { return path.back(); }
    bool has_inside(Vertex_index v) const {
      return v != path.front() && v != path.back() && std::find(path.begin(), path.end(), v) != path.end();
    }
  };

  using Reach = std::array<double, 2>; // how far rounding may have moved a vertex, in x and in y

  /// The directions from a corner in which all vertices so far are passed within reach.
  class Cone {
  public:
    Cone(const Point& corner, const Reach& reach) : o_(corner), reach_(reach) {}

    bool has(const Point& p) const {
      return is_whole_ || (turn_(o_, right_, p) != RIGHT_TURN && turn_(o_, left_, p) != LEFT_TURN);
    }
    /// Whether rounding alone decides on the direction of what is so near to the corner.
    bool is_at_corner(const Point& p) const {
      return std::fabs(p.x() - o_.x()) <= reach_[0] && std::fabs(p.y() - o_.y()) <= reach_[1];
    }
    /// \pre p is not at the corner
    void narrow(const Point& p) {
      Point low = p, high = p; // the ends of the box around p as seen from the corner
      for (const double x : {p.x() - reach_[0], p.x() + reach_[0]})
        for (const double y : {p.y() - reach_[1], p.y() + reach_[1]}) {
          if (turn_(o_, low, Point(x, y)) == RIGHT_TURN) low = Point(x, y);
          if (turn_(o_, high, Point(x, y)) == LEFT_TURN) high = Point(x, y);
        }
      if (is_whole_ || turn_(o_, right_, low) == LEFT_TURN) right_ = low;
      if (is_whole_ || turn_(o_, left_, high) == RIGHT_TURN) left_ = high;
      is_whole_ = false;
    }

  private:
    Triangle_tree::Kernel::Orientation_2 turn_ = Triangle_tree::Kernel().orientation_2_object();
    Point o_, left_, right_; // what bounds it, as seen from the corner
    Reach reach_;
    bool is_whole_ = true;
  };

  const Mesh& mesh_;
  std::vector<char> may_be_inside_, is_inside_;
  Reach widest_reach_; // of all sides
  std::vector<std::size_t> first_,
      edges_; // the constrained edges at v are those from first_[v] to first_[v + 1]
  /// Per constrained edge, the third vertices of the triangles on its left and on its right.
  std::vector<std::array<Vertex_index, 2>> across_;
  /// The triangles at a vertex v that may be inside of a side are those from first_triangle_[v] to
  /// first_triangle_[v + 1].
  std::vector<std::size_t> first_triangle_, triangles_;
  std::vector<Leg> legs_;                  // at a corner
  std::vector<Vertex_index> next_to_apex_; // the ends of the edges at it, by number
  /// The sides so far, by their ends: the vertices inside next to these.
  std::map<std::pair<Vertex_index, Vertex_index>, std::pair<Vertex_index, Vertex_index>> sides_;

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

  void find_vertices_across() {
    std::map<std::pair<Vertex_index, Vertex_index>, std::size_t> edge_of;
    across_.resize(mesh_.constrained_edges.size());
    for (std::size_t e = 0; e < across_.size(); ++e) {
      const auto& [a, b] = mesh_.constrained_edges[e].vertices;
      edge_of.emplace(std::minmax(a, b), e);
    }
    for (const auto& t : mesh_.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vertex_index a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        if (const auto found = edge_of.find(std::minmax(a, b)); found != edge_of.end())
          across_[found->second][mesh_.constrained_edges[found->second].vertices[0] == a ? 0 : 1] = t[k];
      }
  }

  void find_triangles_at_vertices() {
    const std::size_t n = mesh_.points.size();
    const auto may_be_inside = [this](Vertex_index v) {
      return first_[std::size_t(v) + 1] == first_[std::size_t(v)] + 2 && may_be_inside_[std::size_t(v)] != 0;
    };
    first_triangle_.assign(n + 1, 0);
    for (const auto& t : mesh_.triangles)
      for (const Vertex_index v : t)
        if (may_be_inside(v)) ++first_triangle_[std::size_t(v) + 1];
    for (std::size_t v = 0; v < n; ++v) first_triangle_[v + 1] += first_triangle_[v];
    triangles_.resize(first_triangle_.back());
    std::vector<std::size_t> next(first_triangle_.begin(), first_triangle_.end() - 1);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const Vertex_index v : mesh_.triangles[t])
        if (may_be_inside(v)) triangles_[next[std::size_t(v)]++] = t;
  }

  Vertex_index other_end(std::size_t e, Vertex_index v) const {
    const auto& ends = mesh_.constrained_edges[e].vertices;
    return ends[ends[0] == v ? 1 : 0];
  }

  /// Whether p and q are seen from o at less than 60 degrees.
  bool are_within_60_degrees(const Point& o, const Point& p, const Point& q) const {
    const double ux = p.x() - o.x(), uy = p.y() - o.y(), vx = q.x() - o.x(), vy = q.y() - o.y();
    const double u = std::hypot(ux, uy), v = std::hypot(vx, vy);
    return ux / u * (vx / v) + uy / u * (vy / v) > 0.5; // products of lengths may be beyond doubles
  }

  /// Sorts the edges at v counterclockwise, beginning with those that point right.
  void sort_by_direction(std::size_t v) {
    const auto turn = Triangle_tree::Kernel().orientation_2_object();
    const Vertex_index own(v);
    const Point& o = mesh_.points[v];
    const auto is_in_lower_half = [&o](const Point& p) {
      return p.y() < o.y() || (p.y() == o.y() && p.x() < o.x());
    };
    std::sort(edges_.begin() + std::ptrdiff_t(first_[v]), edges_.begin() + std::ptrdiff_t(first_[v + 1]),
              [&](std::size_t e, std::size_t f) {
                const Point &p = mesh_.point(other_end(e, own)), &q = mesh_.point(other_end(f, own));
                const bool is_p_lower = is_in_lower_half(p), is_q_lower = is_in_lower_half(q);
                if (is_p_lower != is_q_lower) return is_q_lower;
                const Orientation from_p_to_q = turn(o, p, q);
                return from_p_to_q == COLLINEAR ? e < f : from_p_to_q == LEFT_TURN;
              });
  }

  /// Whether another edge at v than its i-th one is within 60 degrees, and none goes the same way.
  /// \pre the edges at v are in the order of their directions: those next to it are the nearest ones
  bool is_at_corner(std::size_t v, std::size_t i) const {
    const auto turn = Triangle_tree::Kernel().orientation_2_object();
    const std::size_t degree = first_[v + 1] - first_[v];
    const auto far_end = [&](std::size_t k) -> const Point& {
      return mesh_.point(other_end(edges_[first_[v] + k % degree], Vertex_index(v)));
    };
    const Point &o = mesh_.points[v], &p = far_end(i);
    bool is_any_near = false;
    for (const std::size_t next : {i + 1, i + degree - 1}) {
      if (next % degree == i || !are_within_60_degrees(o, p, far_end(next))) continue;
      if (turn(o, p, far_end(next)) == COLLINEAR) return false;
      is_any_near = true;
    }
    return is_any_near;
  }

  void mark_legs(std::size_t apex) {
    legs_.clear();
    sort_by_direction(apex);
    next_to_apex_.clear();
    for (std::size_t i = first_[apex]; i < first_[apex + 1]; ++i)
      next_to_apex_.push_back(other_end(edges_[i], Vertex_index(apex)));
    std::sort(next_to_apex_.begin(), next_to_apex_.end());
    for (std::size_t i = 0; i < first_[apex + 1] - first_[apex]; ++i) {
      if (!is_at_corner(apex, i)) continue;
      Leg leg = straight_leg(Vertex_index(apex), edges_[first_[apex] + i]);
      if (leg.edges.size() == 1 || !is_beside_same_side(leg)) legs_.push_back(std::move(leg));
    }
    // What is no leg may have been what another one relied on.
    while (drop_legs_with_vertex_across()) {
    }
    for (const Leg& leg : legs_) {
      for (std::size_t i = 1; i + 1 < leg.path.size(); ++i) is_inside_[std::size_t(leg.path[i])] = 1;
      may_be_inside_[std::size_t(leg.end())] = 0; // a side from elsewhere ends here, too
    }
  }

  bool drop_legs_with_vertex_across() {
    std::vector<Leg> kept;
    for (const Leg& leg : legs_)
      if (!has_vertex_across(leg)) kept.push_back(leg);
    const bool is_any_dropped = kept.size() < legs_.size();
    legs_ = std::move(kept);
    return is_any_dropped;
  }

  Leg straight_leg(Vertex_index apex, std::size_t e) const {
    Leg leg = path_from(apex, e);
    // Rounding is as coarse as the largest coordinate of the side, which is known with its end.
    for (std::size_t before = leg.path.size() + 1; leg.path.size() < before;) {
      before = leg.path.size();
      const std::size_t end = straight_end(leg.path, reach_of(leg.path));
      leg.path.resize(end + 1), leg.edges.resize(end);
    }
    return leg;
  }

  /// Whether a vertex next to the way is not on the same side of the line: new vertices on it would pass it over, and
  /// an edge that ends there might cross the line.
  bool has_vertex_across(const Leg& leg) const {
    if (leg.edges.size() == 1) return false;
    for (std::size_t i = 0; i < leg.edges.size(); ++i) {
      const std::size_t e = leg.edges[i];
      const bool is_forward = mesh_.constrained_edges[e].vertices[0] == leg.path[i];
      const Vertex_index left = across_[e][is_forward ? 0 : 1], right = across_[e][is_forward ? 1 : 0];
      if (left.is_valid() && !is_on_side(leg, left, LEFT_TURN)) return true;
      if (right.is_valid() && !is_on_side(leg, right, RIGHT_TURN)) return true;
    }
    for (std::size_t i = 1; i + 1 < leg.path.size(); ++i)
      if (has_vertex_across_near(leg, i)) return true;
    return false;
  }

  /// The same for vertices next to the i-th one of the way.
  bool has_vertex_across_near(const Leg& leg, std::size_t i) const {
    const Vertex_index before = leg.path[i - 1], own = leg.path[i], after = leg.path[i + 1];
    for (std::size_t at = first_triangle_[std::size_t(own)]; at < first_triangle_[std::size_t(own) + 1]; ++at)
      for (const Vertex_index w : mesh_.triangles[triangles_[at]])
        if (w != before && w != own && w != after && !is_on_side(leg, w, side_of_way(before, own, after, w)))
          return true;
    return false;
  }

  /// On which side of the way from a over b to c a vertex next to b is.
  Orientation side_of_way(Vertex_index a, Vertex_index b, Vertex_index c, Vertex_index v) const {
    const auto turn = Triangle_tree::Kernel().orientation_2_object();
    const Point &p = mesh_.point(a), &q = mesh_.point(b), &r = mesh_.point(c), &s = mesh_.point(v);
    const bool is_left_of_first = turn(p, q, s) == LEFT_TURN, is_left_of_second = turn(q, r, s) == LEFT_TURN;
    const bool is_left = turn(p, q, r) == LEFT_TURN ? is_left_of_first && is_left_of_second
                                                    : is_left_of_first || is_left_of_second;
    return is_left ? LEFT_TURN : RIGHT_TURN;
  }

  /// Whether a vertex is on a side of the line, or inside of another leg that is.
  bool is_on_side(const Leg& leg, Vertex_index v, Orientation side) const {
    const auto turn = Triangle_tree::Kernel().orientation_2_object();
    const Point &o = mesh_.point(leg.path.front()), &p = mesh_.point(leg.end());
    if (turn(o, p, mesh_.point(v)) == side) return true;
    const auto other =
        std::find_if(legs_.begin(), legs_.end(), [v](const Leg& l) { return l.has_inside(v); });
    return other != legs_.end() && &*other != &leg && turn(o, p, mesh_.point(other->end())) == side;
  }

  /// Whether an edge, or another side, has the same ends. Notes the side if not.
  bool is_beside_same_side(const Leg& leg) {
    const Vertex_index apex = leg.path.front(), last = leg.end();
    if (std::binary_search(next_to_apex_.begin(), next_to_apex_.end(), last)) return true;
    const auto inner = std::minmax(leg.path[1], leg.path[leg.path.size() - 2]);
    return sides_.emplace(std::minmax(apex, last), inner).first->second !=
           std::make_pair(inner.first, inner.second);
  }

  /// The vertices from a corner along an edge, as long as the way leads on and away, and may be straight.
  Leg path_from(Vertex_index apex, std::size_t e) const {
    Leg leg{{apex, other_end(e, apex)}, {e}};
    const Point& o = mesh_.point(apex);
    Cone cone(o, widest_reach_);
    for (;;) {
      if (!cone.is_at_corner(mesh_.point(leg.end()))) cone.narrow(mesh_.point(leg.end()));
      const Vertex_index v = leg.path.back();
      const std::size_t at = first_[std::size_t(v)];
      if (may_be_inside_[std::size_t(v)] == 0 || first_[std::size_t(v) + 1] != at + 2) return leg;
      const std::size_t next = edges_[at] == e ? edges_[at + 1] : edges_[at];
      const Vertex_index w = other_end(next, v);
      const Point &p = mesh_.point(v), &q = mesh_.point(w);
      const bool leads_on =
          std::hypot(q.x() - o.x(), q.y() - o.y()) > std::hypot(p.x() - o.x(), p.y() - o.y());
      if (mesh_.constrained_edges[next].marker != mesh_.constrained_edges[e].marker || !leads_on ||
          !are_within_60_degrees(o, p, q) || !cone.has(q))
        return leg;
      leg.path.push_back(w), leg.edges.push_back(next), e = next;
    }
  }

  Reach reach_of(const std::vector<Vertex_index>& path) const {
    std::vector<Point> points;
    points.reserve(path.size());
    for (const Vertex_index v : path) points.push_back(mesh_.point(v));
    return reach_of(points);
  }

  static Reach reach_of(const std::vector<Point>& points) {
    double x = 0, y = 0;
    for (const Point& p : points) x = std::max(x, std::fabs(p.x())), y = std::max(y, std::fabs(p.y()));
    const auto units = [](double magnitude) {
      return units_of_rounding *
             (std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude);
    };
    return {units(x), units(y)};
  }

  /// The place in the path of the last vertex to which the way is straight.
  std::size_t straight_end(const std::vector<Vertex_index>& path, const Reach& reach) const {
    Cone cone(mesh_.point(path[0]), reach);
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Point& p = mesh_.point(path[i]);
      if (!cone.has(p)) return i - 1;
      if (cone.is_at_corner(p)) return i;
      cone.narrow(p);
    }
    return path.size() - 1;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_STRAIGHT_LEGS_H
