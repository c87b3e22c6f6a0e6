// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Whether the chains of mesh edges, whose vertices are rounded, can be straightened to their input segments.
// Input vertices stay where they are, and no chain may pass over a vertex or cross another chain. If so, the
// chains divide the plane as the segments do (an isotopy; Epstein, "Curves on 2-manifolds and isotopies",
// 1966). All decisions are exact.
//
// A chain that is monotone along its segment can be straightened if no input vertex lies between the two. Two
// triangles of the input's triangulation are next to a segment, left and right. Their centroids cut each in
// thirds, one for each side. If a chain stays within the thirds at its segment, it passes over no vertex. It
// also meets no other chain that stays within its own thirds. Beyond an edge of the convex hull there is
// nothing to meet. This takes linear time, and suffices unless something is within a few units of rounding.
// The other chains are compared with all chains, by their boxes.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_CHAIN_ORDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_CHAIN_ORDER_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Input_domain.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Loops.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Mesh_error_log.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Straight_segment.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/exact_sign.h>
#include <CGAL/Segment_2.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Chain_order {
public:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  using Line = Straight_segment<Point>;
  using Domain = Input_domain<Kernel>;
  using Chains = std::vector<std::vector<std::uint32_t>>;

  /// \param chains for each piece of the domain the vertices along it, or none
  /// \param vertex_at for each place of the input the vertex of the mesh there, or `Domain::none`
  Chain_order(const std::vector<Point>& points, const Domain& domain, const Chains& chains,
              const std::vector<std::uint32_t>& vertex_at, const Loops& loops, Mesh_error_log& log)
      : points_(points), domain_(domain), chains_(chains), vertex_at_(vertex_at), loops_(loops), log_(log) {}

  /// \param line_of gives the line of a segment
  template <class Line_of>
  void check(const Line_of& line_of) {
    std::vector<std::uint32_t> close_chains;
    loops_.for_each_wrong(
        chains_.size(), [this](std::uint32_t p) { return keeps_to_its_thirds(p); },
        [&](std::uint32_t p) { close_chains.push_back(p); });
    if (close_chains.empty()) return;
    std::vector<Item_box> close, all;
    for (const std::uint32_t p : close_chains) append_edges(p, line_of(domain_.pieces()[p].segment), close);
    for (std::uint32_t p = 0; p < chains_.size(); ++p)
      append_edges(p, line_of(domain_.pieces()[p].segment), all);
    check_crossings(close, all);
    check_vertices_between(close, line_of);
  }

private:
  /// An edge of a chain, by its end there, from 1.
  struct Edge {
    std::uint32_t piece;
    std::size_t end;
  };
  /// The box of an edge of a chain with what lies between it and its segment, or of a vertex.
  struct Item_box : Box_intersection_d::Box_d<double, 2> {
    Item_box(const Bbox_2& box, std::size_t number)
        : Box_intersection_d::Box_d<double, 2>(box), item(number) {}
    std::size_t item; // in `edges_`, or the vertex
  };

  const Point& point(std::uint32_t v) const { return points_[v]; }
  std::uint32_t source(const Edge& e) const { return chains_[e.piece][e.end - 1]; }
  std::uint32_t target(const Edge& e) const { return chains_[e.piece][e.end]; }
  Segment_index segment(const Edge& e) const { return domain_.pieces()[e.piece].segment; }

  bool keeps_to_its_thirds(std::uint32_t p) const {
    const auto& piece = domain_.pieces()[p];
    const auto& chain = chains_[p];
    const Point &a = point(piece.ends[0]), &b = point(piece.ends[1]);
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      const Point& v = point(chain[i]);
      const Orientation side = CGAL::orientation(a, b, v);
      if (side == LEFT_TURN && !is_in_third(a, b, piece.apexes[0], v)) return false;
      if (side == RIGHT_TURN && !is_in_third(b, a, piece.apexes[1], v)) return false;
    }
    return true;
  }

  /// Whether `v`, which is on the left of the side from `a` to `b`, is within the third at that side of the
  /// triangle `a`, `b`, `apex`.
  bool is_in_third(const Point& a, const Point& b, std::uint32_t apex, const Point& v) const {
    if (apex == Domain::none) return true;
    return turn_from_centroid(a, b, point(apex), v) == NEGATIVE &&
           turn_from_centroid(b, a, point(apex), v) == POSITIVE;
  }
  /// The side of `v` seen from `a` toward the centroid of `a`, `b` and `c`.
  static Sign turn_from_centroid(const Point& a, const Point& b, const Point& c, const Point& v) {
    return exact_sign([&](auto number) {
      using Number = decltype(number);
      const Number ax(a.x()), ay(a.y()), two(2);
      const Number x = Number(b.x()) + Number(c.x()) - two * ax, y = Number(b.y()) + Number(c.y()) - two * ay;
      return Number(x * (Number(v.y()) - ay) - y * (Number(v.x()) - ax));
    });
  }

  void append_edges(std::uint32_t p, const Line& line, std::vector<Item_box>& boxes) {
    // a vertex within reach of its segment along both axes is nearer than the sum of these
    const double reach = line.reach()[0] + line.reach()[1];
    for (std::size_t i = 1; i < chains_[p].size(); ++i) {
      const Bbox_2 box = point(chains_[p][i - 1]).bbox() + point(chains_[p][i]).bbox();
      boxes.emplace_back(
          Bbox_2(box.xmin() - reach, box.ymin() - reach, box.xmax() + reach, box.ymax() + reach),
          edges_.size());
      edges_.push_back({p, i});
    }
  }

  void check_crossings(std::vector<Item_box>& close, std::vector<Item_box>& all) {
    CGAL::box_intersection_d(
        close.begin(), close.end(), all.begin(), all.end(), [&](const Item_box& a, const Item_box& b) {
          const Edge &e = edges_[a.item], &f = edges_[b.item];
          if (e.piece != f.piece && do_cross(e, f))
            log_.add("edges ", source(e), " ", target(e), " of input segment ", segment(e), " and ",
                     source(f), " ", target(f), " of input segment ", segment(f), " cross");
        });
  }

  /// Whether two edges have more in common than an end.
  bool do_cross(const Edge& e, const Edge& f) const {
    for (const auto& [s, t] : {std::pair(source(e), target(e)), std::pair(target(e), source(e))})
      for (const auto& [u, v] : {std::pair(source(f), target(f)), std::pair(target(f), source(f))})
        if (s == u)
          return CGAL::collinear(point(s), point(t), point(v)) &&
                 CGAL::angle(point(t), point(s), point(v)) == ACUTE;
    using Segment = Kernel::Segment_2;
    return CGAL::do_intersect(Segment(point(source(e)), point(target(e))),
                              Segment(point(source(f)), point(target(f))));
  }

  template <class Line_of>
  void check_vertices_between(std::vector<Item_box>& close, const Line_of& line_of) {
    std::vector<Item_box> vertices;
    for (std::uint32_t v : vertex_at_)
      if (v != Domain::none) vertices.emplace_back(point(v).bbox(), v);
    CGAL::box_intersection_d(close.begin(), close.end(), vertices.begin(), vertices.end(),
                             [&](const Item_box& a, const Item_box& w) {
                               const Edge& e = edges_[a.item];
                               if (is_between(e, static_cast<std::uint32_t>(w.item), line_of(segment(e))))
                                 log_.add("input vertex ", w.item, " is between input segment ", segment(e),
                                          " and its edge ", source(e), " ", target(e));
                             });
  }

  /// Whether `w` is between an edge of a chain and the segment, ends and other pieces of which it is not on.
  bool is_between(const Edge& e, std::uint32_t w, const Line& line) const {
    const auto& ends = domain_.pieces()[e.piece].ends;
    if (w == vertex_at_[ends[0]] || w == vertex_at_[ends[1]]) return false;
    const Point &p = point(source(e)), &q = point(target(e)), &r = point(w);
    if (line.is_ahead(r, p) || line.is_ahead(q, r)) return false;
    return CGAL::orientation(line.source(), line.target(), r) * CGAL::orientation(p, q, r) != POSITIVE;
  }

  const std::vector<Point>& points_;
  const Domain& domain_;
  const Chains& chains_;
  const std::vector<std::uint32_t>& vertex_at_;
  const Loops& loops_;
  Mesh_error_log& log_;
  std::vector<Edge> edges_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_CHAIN_ORDER_H
