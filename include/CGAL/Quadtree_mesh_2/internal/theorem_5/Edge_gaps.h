// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Whether two edges are too near each other for a leaf of a quadtree.
//
// Computes: the gap between the parts of two edges in a leaf and around it, and whether the leaf has to be
//           split for it.
// Bound:    O(1) for a pair.
// Source:   Bern, Eppstein, Teng, section 6: "each (piece of an original) edge is contained in a sufficiently
//           small square that no vertex or other edge passes nearby".
// Deviates: edges that share a vertex may be arbitrarily near each other around it, up to `vertex_window`
//           sides. So may those of an acute corner that will be cut off, up to where it is `strip_width`
//           sides wide. Up to there no corner of a leaf is far enough from both legs to become a vertex, so
//           the corner is a stack of trapezoids between its legs. This is how acute corners are cut off "at a
//           distance proportional to the nearest neighbor", because the sides of leaves are proportional to
//           it.
//
// Edges on opposite sides of the domain's outside do not count, nor do those less than 256 units of the coordinates
// apart.
//
// The arithmetic is rounded, relative to the side of the leaf (Near_segment.h). Rounding changes results only in
// near-ties. It affects sizes, but not the correctness of anything.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_EDGE_GAPS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_EDGE_GAPS_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Edge_sides.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Near_segment.h>
#include <CGAL/Tree_separation_options_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The shortest way from one segment to another.
struct Local_gap {
  Vector from, to;
  double length = std::numeric_limits<double>::infinity();

  static Local_gap between(const Local_segment& s, const Local_segment& t) {
    Local_gap best;
    const auto consider = [&](Vector p, Vector q) {
      const double l = std::sqrt(squared_length(q - p));
      if (l < best.length) best = {p, q, l};
    };
    consider(s.a, t.nearest_to(s.a)), consider(s.b, t.nearest_to(s.b));
    consider(s.nearest_to(t.a), t.a), consider(s.nearest_to(t.b), t.b);
    return best;
  }
  /// Whether it crosses a segment.
  bool is_blocked_by(const Local_segment& s) const {
    const Vector d = to - from, e = s.b - s.a;
    const double from_side = cross(e, from - s.a), to_side = cross(e, to - s.a);
    const double a_side = cross(d, s.a - from), b_side = cross(d, s.b - from);
    return from_side * to_side < 0 && a_side * b_side <= 0;
  }
};

template <class Geometry>
class Edge_gaps {
public:
  using Point = typename Geometry::Point;

  Edge_gaps(const Meshing_problem<Geometry>& problem, const Edge_sides& sides,
            const Tree_separation_options_2& options)
      : problem_(problem), sides_(sides), options_(options) {}

  /// A leaf, by its lower left corner and its side.
  struct Leaf {
    Point corner;
    double side;
  };
  /// A part of an edge, relative to the corner of a leaf, and the box around it.
  struct Part {
    Edge_id edge;
    Local_segment segment;
    Vector low, high;
  };
  /// Whether leaves next to a leaf may not have all that is to be far from what is in it (Features_in_sight.h). They
  /// have all that is half a side away.
  bool is_beyond_neighbors() const { return options_.edge_distance() > 0.5; }

  /// An edge relative to the corner of a leaf.
  Local_segment local(Edge_id e, const Leaf& leaf) const {
    const Input_edge& edge = problem_.edges[e];
    return Near_segment<Geometry>::of(problem_.input_point(edge.a), problem_.input_point(edge.b), leaf.corner,
                                      leaf.side);
  }

  /// The part of an edge in a leaf, if there is any.
  std::optional<Part> part_in(Edge_id e, const Leaf& leaf) const { return part(e, leaf, 0); }
  /// The part in and around it as far as edges may be too near.
  std::optional<Part> part_around(Edge_id e, const Leaf& leaf) const {
    return part(e, leaf, options_.edge_distance());
  }

  /// Whether two parts are so far apart that the gap between them asks for no smaller leaf; a first look.
  bool are_boxes_apart(const Part& p, const Part& q, const Leaf& leaf) const {
    const double least = options_.edge_distance() * leaf.side;
    return q.low.x - p.high.x >= least || p.low.x - q.high.x >= least || q.low.y - p.high.y >= least ||
           p.low.y - q.high.y >= least;
  }

  /// The gap between the part of an edge in a leaf and that of another one in and around it.
  Local_gap gap(Edge_id inside, Edge_id other, const Leaf& leaf) const {
    const auto p = part_in(inside, leaf), q = part_around(other, leaf);
    return p && q ? Local_gap::between(p->segment, q->segment) : Local_gap();
  }

  /// Whether a leaf is too large for a gap in it.
  bool is_too_large(const Leaf& leaf, Edge_id e, Edge_id f, const Local_gap& gap) const {
    if (gap.length >= options_.edge_distance() * leaf.side || !has_room(gap, leaf)) return false;
    if (!is_domain_toward(e, gap.to - gap.from, leaf) || !is_domain_toward(f, gap.from - gap.to, leaf))
      return false;
    return !may_be_near(leaf, e, f);
  }

  /// Whether edges that share a vertex may be nearer than others in a leaf: around it, or in an acute corner.
  bool may_be_near(const Leaf& leaf, Edge_id e, Edge_id f) const {
    const Vertex_id v = common_vertex(e, f);
    return v.is_valid() &&
           (is_in_window(v, leaf) ||
            (is_lopped(e, f, v) && width_of_corner(e, f, leaf) <= options_.strip_width() * leaf.side));
  }

  /// Whether edges may be as near to each other as they like in a leaf: a vertex that they share is near.
  bool are_joined_near(const Leaf& leaf, Edge_id e, Edge_id f) const {
    const Vertex_id v = common_vertex(e, f);
    return v.is_valid() && is_in_window(v, leaf);
  }

  /// Whether that holds for all of some pieces, whatever their number: they are around one vertex.
  template <class Pieces>
  bool are_all_joined_near(const Leaf& leaf, const Pieces& pieces) const {
    const auto edge = [&](std::size_t i) -> const Input_edge& {
      return problem_.edges[static_cast<Edge_id>(pieces[i].segment.value())];
    };
    for (const Vertex_id v : {edge(0).a, edge(0).b}) {
      std::size_t i = 1;
      while (i < pieces.size() && (edge(i).a == v || edge(i).b == v)) ++i;
      if (i == pieces.size() && is_in_window(v, leaf)) return true;
    }
    return false;
  }

  /// A vertex near a leaf at which one of some parts ends; none if there is none.
  Vertex_id vertex_near(const Leaf& leaf, const std::vector<Part>& parts) const {
    for (const Part& p : parts)
      for (const Vertex_id v : {problem_.edges[p.edge].a, problem_.edges[p.edge].b})
        if (is_in_window(v, leaf)) return v;
    return {};
  }
  /// Puts the parts of edges that end at a vertex first, in their order. \returns how many they are
  std::size_t put_first(Vertex_id v, std::vector<Part>& parts) const {
    const auto end = std::stable_partition(parts.begin(), parts.end(), [&](const Part& p) {
      return problem_.edges[p.edge].a == v || problem_.edges[p.edge].b == v;
    });
    return static_cast<std::size_t>(end - parts.begin());
  }

private:
  /// In units of the coordinates.
  static constexpr double least_gap_ = 256;

  const Meshing_problem<Geometry>& problem_;
  const Edge_sides& sides_;
  const Tree_separation_options_2& options_;

  /// Whether a gap is wide enough for vertices in it at places that are hardly rounded. Narrower ones force nothing:
  /// edges that are a few units apart may run beside each other for long, with millions of leaves as small as that.
  static bool has_room(const Local_gap& gap, const Leaf& leaf) {
    return gap.length >= least_gap_ * Geometry::spacing(leaf.corner);
  }

  /// Whether the domain is on the side of an edge to which a direction leads.
  bool is_domain_toward(Edge_id e, Vector direction, const Leaf& leaf) const {
    const Local_segment s = local(e, leaf);
    const double turn = cross(s.b - s.a, direction);
    return turn > 0 ? sides_.is_domain_on_left(e) : turn < 0 ? sides_.is_domain_on_right(e) : true;
  }

  /// \param reach how far around the leaf, in its sides
  std::optional<Part> part(Edge_id e, const Leaf& leaf, double reach) const {
    const double low = -reach * leaf.side, high = (1 + reach) * leaf.side;
    Local_segment s = local(e, leaf);
    if (s.is_beyond(low, high) || !s.clip(low, high)) return std::nullopt;
    return Part{e,
                s,
                {std::min(s.a.x, s.b.x), std::min(s.a.y, s.b.y)},
                {std::max(s.a.x, s.b.x), std::max(s.a.y, s.b.y)}};
  }

  static double square(double x) { return x * x; }

  bool is_in_window(Vertex_id v, const Leaf& leaf) const {
    const Vector apex = Geometry::difference(problem_.input_point(v), leaf.corner);
    const Vector middle{leaf.side / 2, leaf.side / 2};
    return squared_length(apex - middle) < square(options_.vertex_window() * leaf.side);
  }

  Vertex_id common_vertex(Edge_id e, Edge_id f) const {
    const Input_edge &p = problem_.edges[e], &q = problem_.edges[f];
    return p.a == q.a || p.a == q.b ? p.a : p.b == q.a || p.b == q.b ? p.b : Vertex_id();
  }

  /// Whether two edges are the legs of a lopped sector at v.
  bool is_lopped(Edge_id e, Edge_id f, Vertex_id v) const {
    const auto& corners = problem_.corners;
    const auto leg = [&](Edge_id x) { return corners.legs_of_edge[x][problem_.edges[x].a == v ? 0 : 1]; };
    const Leg_id l = leg(e), m = leg(f);
    if (!l.is_valid() || !m.is_valid()) return false;
    const auto &p = corners.leg(l), &q = corners.leg(m);
    return (p.after.is_valid() && p.after == q.before) || (p.before.is_valid() && p.before == q.after);
  }

  /// How wide a corner between e and f is where e leaves the leaf.
  double width_of_corner(Edge_id e, Edge_id f, const Leaf& leaf) const {
    Local_segment s = local(e, leaf);
    const Local_segment t = local(f, leaf);
    if (!s.clip(0, leaf.side)) return 0;
    return std::max(t.distance_to(s.a), t.distance_to(s.b));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_EDGE_GAPS_H
