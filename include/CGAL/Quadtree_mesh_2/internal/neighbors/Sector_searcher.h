// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Finds the feature nearest to the apex of a sector between two segments.
//
// Computes: the vertex or segment of a graph that is nearest to a vertex v within an open convex sector at v.
// Bound:    O(1) for each leaf, and for each point and segment listed there, that meets the sector within
//           about three times the distance found (of which there may be many).
// Method:   The square with v at its center is approximated by a square of the quadtree with v in it and its
//           eight neighbors. Anything outside these is further from v than a side. The blocks grow level by
//           level, from the leaf of v up, until something is certainly nearer than a side. Squares that are
//           certainly outside the sector, or too far, are not entered.
//
// Exact orientation predicates clip segments to the closed sector. The nearest point of the rest is found in
// intervals, and exactly where these overlap. Squares are pruned by doubles with error bounds.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_SECTOR_SEARCHER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_SECTOR_SEARCHER_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Point_arithmetic.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Leaf_segments.h>
#include <CGAL/Quadtree_mesh_2/vertex_edge_neighbor_types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Tree, class Graph>
class Sector_searcher {
  using Point = typename Tree::Point_2;
  using Arithmetic = Point_arithmetic<Point>;
  using Exact = typename Arithmetic::Exact;
  using Word = typename Tree::Word;
  using Grid_point = typename Tree::Grid_point;

public:
  /// The sector at `apex` counterclockwise from `right` to `left`.
  /// \param at_most nothing further away is searched for.
  /// \pre the turn apex, right, left is to the left
  Sector_searcher(const Tree& tree, const Leaf_segments& lists, const Graph& graph, Vertex_index apex,
                  Vertex_index right, Vertex_index left, double at_most)
      : tree_(tree), lists_(lists), graph_(graph), apex_index_(apex), apex_(graph.point(apex)),
        right_(graph.point(right)), left_(graph.point(left)), at_most_(at_most) {
    for (std::size_t i = 0; i < 2; ++i) {
      center_[i] = approximation(apex_, i);
      to_right_[i] = approximate_difference(right_, i);
      to_left_[i] = approximate_difference(left_, i);
    }
  }

  Sector_neighbor_2 find() {
    Node_index v = tree_.node(tree_.leaf(tree_.framework().rank(Point_index(apex_index_.value()))));
    visit_block(v, Node_index());
    while (v != tree_.root()) {
      const auto s = tree_.square(v);
      // No less than this is what v's block leaves out.
      const double side = least_side(s);
      if (side > at_most_ || (has_best() && upper_distance() < side)) break;
      const Node_index inner = v;
      v = tree_.parent(v);
      visit_block(v, inner);
    }
    return result();
  }

private:
  struct Approximation {
    double value;
    double error;
  };

  const Tree& tree_;
  const Leaf_segments& lists_;
  const Graph& graph_;
  Vertex_index apex_index_;
  const Point &apex_, &right_, &left_;
  double at_most_;
  std::array<Approximation, 2> center_, to_right_, to_left_;

  // the best so far
  Vertex_index vertex_;
  Segment_index segment_;
  Interval squared_distance_ = Interval(0);

  static constexpr double unit_roundoff = 4e-16; // with room

  static Approximation approximation(const Point& p, std::size_t axis) {
    const std::pair<double, double> b = Arithmetic::bounds(p, static_cast<int>(axis));
    return {b.first, b.second - b.first + unit_roundoff * std::fabs(b.first)};
  }
  Approximation approximate_difference(const Point& p, std::size_t axis) const {
    return minus(approximation(p, axis), center_[axis]);
  }
  static Approximation minus(const Approximation& a, const Approximation& b) {
    const double d = a.value - b.value;
    return {d, a.error + b.error + unit_roundoff * std::fabs(d)};
  }
  /// An upper bound of the product of what two approximations stand for, less that of two others.
  static double upper_cross(const Approximation& ax, const Approximation& by, const Approximation& ay,
                            const Approximation& bx) {
    const double d = ax.value * by.value - ay.value * bx.value;
    const auto error = [](const Approximation& p, const Approximation& q) {
      return std::fabs(p.value) * (q.error + unit_roundoff * std::fabs(q.value)) +
             p.error * (std::fabs(q.value) + q.error);
    };
    return d + (error(ax, by) + error(ay, bx)) * (1 + 1e-15);
  }

  bool has_best() const { return vertex_.is_valid() || segment_.is_valid(); }
  double upper_distance() const { return std::sqrt(squared_distance_.sup()) * (1 + 1e-15); }

  // -------- squares

  using Square = typename Tree::Square;

  Word side_of(int level) const {
    return Word_operations<Word>::power_of_two(tree_.framework().grid().depth() - level);
  }

  /// The lower left and upper right corner of a square, from the apex.
  std::array<std::array<Approximation, 2>, 2> box(const Square& s) const {
    const Word side = side_of(s.level);
    const auto& grid = tree_.framework().grid();
    const Point low = grid.point({s.x, s.y});
    const Point high = grid.point({static_cast<Word>(s.x + side), static_cast<Word>(s.y + side)});
    return {{{{approximate_difference(low, 0), approximate_difference(low, 1)}},
             {{approximate_difference(high, 0), approximate_difference(high, 1)}}}};
  }

  double least_side(const Square& s) const {
    const auto b = box(s);
    double side = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 2; ++i)
      side = std::min(side, b[1][i].value - b[0][i].value - b[1][i].error - b[0][i].error);
    return side * (1 - 1e-15);
  }

  /// Whether a square is certainly outside the sector or too far away.
  bool is_irrelevant(const Square& s) const {
    const auto b = box(s);
    double squared = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const double d = std::max({0.0, b[0][i].value - b[0][i].error, -b[1][i].value - b[1][i].error});
      squared += d * d;
    }
    const double distance = std::sqrt(squared) * (1 - 1e-15);
    if (distance > at_most_ || (has_best() && distance > upper_distance())) return true;
    bool is_right = true, is_left = true; // of the sector: all corners are
    for (const std::size_t i : {std::size_t(0), std::size_t(1)})
      for (const std::size_t j : {std::size_t(0), std::size_t(1)}) {
        const Approximation &x = b[i][0], &y = b[j][1];
        is_right = is_right && upper_cross(to_right_[0], y, to_right_[1], x) < 0;
        is_left = is_left && upper_cross(x, to_left_[1], y, to_left_[0]) < 0;
      }
    return is_right || is_left;
  }

  /// Visits v and its neighbors, without those squares around its child `inner` that have been visited.
  void visit_block(Node_index v, Node_index inner) {
    visit(v, inner);
    for (const Direction d : all_directions()) {
      const Node_index n = tree_.neighbor(v, d);
      if (n.is_valid()) visit(n, inner);
    }
  }

  void visit(Node_index v, Node_index inner) {
    if (is_irrelevant(tree_.square(v))) return;
    if (tree_.is_leaf(v)) return visit_leaf(tree_.leaf(v));
    for (int q = 0; q < 4; ++q) {
      const Node_index child = tree_.child(v, q);
      if (!is_in_block(child, inner)) visit(child, Node_index());
    }
  }

  bool is_in_block(Node_index v, Node_index inner) const {
    if (!inner.is_valid()) return false;
    if (v == inner) return true;
    for (const Direction d : all_directions())
      if (tree_.neighbor(inner, d) == v) return true;
    return false;
  }

  void visit_leaf(Leaf_index l) {
    const auto points = tree_.points(l);
    for (auto r = points.begin; r < points.end; ++r)
      try_vertex(Vertex_index(tree_.framework().input_point(r).value()));
    for (const Segment_index s : lists_[l]) try_segment(s);
  }

  // -------- what is in squares

  /// Positive to the left of the ray to the right end of the sector, and to the right of that to the left
  /// end.
  int inside_right(const Point& p) const { return Arithmetic::orientation(apex_, right_, p); }
  int inside_left(const Point& p) const { return Arithmetic::orientation(apex_, p, left_); }

  void try_vertex(Vertex_index v) {
    const Point& p = graph_.point(v);
    if (inside_right(p) <= 0 || inside_left(p) <= 0) return;
    Interval d(0);
    {
      Interval::Protector protector;
      d = squared_distance<Interval>(p);
    }
    const int c = compare_with_best(d, [&] { return squared_distance<Exact>(p); });
    if (c > 0 || (c == 0 && vertex_.is_valid() && !(v < vertex_))) return;
    vertex_ = v;
    segment_ = Segment_index();
    squared_distance_ = d;
  }

  void try_segment(Segment_index s) {
    const Clipped clipped = clip(s);
    if (clipped.is_empty) return;
    Interval d(0);
    {
      Interval::Protector protector;
      d = squared_distance<Interval>(clipped);
    }
    const int c = compare_with_best(d, [&] { return squared_distance<Exact>(clipped); });
    // What is as near as a vertex may be the vertex's segment.
    if (c > 0 || (c == 0 && (vertex_.is_valid() || !(s < segment_)))) return;
    vertex_ = Vertex_index();
    segment_ = s;
    squared_distance_ = d;
  }

  template <class Exact_value>
  int compare_with_best(const Interval& d, const Exact_value& exact) const {
    if (!has_best()) return -1;
    return compare_filtered(d, squared_distance_, [&] {
      const Exact a = exact(), b = best_squared_distance();
      return a < b ? -1 : b < a ? 1 : 0;
    });
  }

  Exact best_squared_distance() const {
    return vertex_.is_valid() ? squared_distance<Exact>(graph_.point(vertex_))
                              : squared_distance<Exact>(clip(segment_));
  }

  /// A segment from a to b, and which of its ends the sides of the sector cut off.
  struct Clipped {
    const Point &a, &b;
    int right_a, right_b, left_a, left_b;
    bool is_empty;
  };

  /// What is a point counts as a vertex only.
  static bool is_point(const Point& a, const Point& b) {
    return Arithmetic::compare(a, b, 0) == 0 && Arithmetic::compare(a, b, 1) == 0;
  }

  /// Cuts off what is not in the sector. Nothing remains if no point is in the open sector.
  Clipped clip(Segment_index s) const {
    const auto& ends = graph_.segment(s);
    const Point &a = graph_.point(ends[0]), &b = graph_.point(ends[1]);
    Clipped c{a, b, inside_right(a), inside_right(b), inside_left(a), inside_left(b), false};
    if (std::max(c.right_a, c.right_b) <= 0 || std::max(c.left_a, c.left_b) <= 0 || is_point(a, b))
      c.is_empty = true;
    // Enters over one side where it has left over the other: which comes first tells the side of the apex.
    else if (c.right_a <= 0 && c.left_b <= 0)
      c.is_empty = Arithmetic::orientation(apex_, a, b) <= 0;
    else if (c.right_b <= 0 && c.left_a <= 0)
      c.is_empty = Arithmetic::orientation(apex_, b, a) <= 0;
    return c;
  }

  template <class Number>
  Number from_apex(const Point& p, int axis) const {
    return Arithmetic::template difference<Number>(p, apex_, axis);
  }

  template <class Number>
  Number squared_distance(const Point& p) const {
    return CGAL::square(from_apex<Number>(p, 0)) + CGAL::square(from_apex<Number>(p, 1));
  }

  /// That of the point at `a + t (b - a)`, with t as near to that of the foot of the perpendicular as the
  /// ends and the cuts allow.
  template <class Number>
  Number squared_distance(const Clipped& c) const {
    const Number ax = from_apex<Number>(c.a, 0), ay = from_apex<Number>(c.a, 1);
    const Number dx = Arithmetic::template difference<Number>(c.b, c.a, 0),
                 dy = Arithmetic::template difference<Number>(c.b, c.a, 1);
    Number low(0), high(1);
    const auto cut = [&](const Point& side, int inside_a, int inside_b) {
      if (inside_a >= 0 && inside_b >= 0) return;
      const Number rx = from_apex<Number>(side, 0), ry = from_apex<Number>(side, 1);
      const Number t = (ry * ax - rx * ay) / (rx * dy - ry * dx);
      if (inside_a < 0)
        low = greatest(low, t);
      else
        high = least(high, t);
    };
    cut(right_, c.right_a, c.right_b);
    cut(left_, c.left_a, c.left_b);
    const Number squared_length = CGAL::square(dx) + CGAL::square(dy);
    const Number foot = -(ax * dx + ay * dy) / squared_length;
    // If the foot is within, its distance comes with fewer cancellations.
    if (CGAL::certainly(low < foot) && CGAL::certainly(foot < high))
      return CGAL::square(Number(ax * dy - ay * dx)) / squared_length;
    // Wide intervals may have lost that this is between 0 and 1.
    const Number t = least(greatest(least(greatest(foot, low), high), Number(0)), Number(1));
    return CGAL::square(Number(ax + t * dx)) + CGAL::square(Number(ay + t * dy));
  }

  Sector_neighbor_2 result() const {
    Sector_neighbor_2 found;
    if (!has_best()) return found;
    const Interval& d = squared_distance_;
    const double distance = is_narrow(d) && d.inf() > 0x1p-900 ? std::sqrt(d.inf() + (d.sup() - d.inf()) / 2)
                                                               : root_of_exact(best_squared_distance());
    if (distance > at_most_) return found;
    found.vertex = vertex_;
    found.segment = segment_;
    found.distance = distance;
    return found;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_SECTOR_SEARCHER_H
