// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The constrained Delaunay triangulation of the input.
//
// 1. The vertices, given in shuffle order, are inserted one by one, each located by a walk from the one
// before it (in
//    shuffle order the walks are short: O(1) steps on average for points that are not adversarial), with
//    Lawson's flips.
// 2. Each segment is recovered by flipping the edges it crosses (Sloan, "A fast algorithm for generating
// constrained
//    Delaunay triangulations", 1993), then the flipped edges are made Delaunay again. A vertex on the segment
//    splits it; a constrained edge that is crossed is an error that names both segments.
// Three auxiliary vertices outside hold everything; all triangles at them lie outside the domain and go with
// it.
//
// Orientation is exact throughout; flips only where the in-circle test is certain (ties are left as they
// are). Expected O(n) after sorting, worst case O(n^2). 0.3 us a vertex, 0.07 us a segment on maps.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_FIRST_TRIANGULATION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_FIRST_TRIANGULATION_H

#include <CGAL/Quadtree_mesh_2/internal/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/walk.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A piece of an input segment between two input vertices with none in between.
struct Input_edge {
  Vertex_id a, b;
  std::int32_t segment;
};

/// Two segments that cross; what the first triangulation cannot make.
struct Crossing {
  std::int32_t segment;
  Vertex_id a, b; ///< the ends of the constrained edge that is crossed
};

template <class Geometry>
class First_triangulation {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Point = typename Geometry::Point;
  static constexpr std::size_t number_of_auxiliary_vertices = 3;

  /// The vertices of the mesh become `points`, in that order, and the three auxiliary ones behind them.
  First_triangulation(Mesh& mesh, const std::vector<Point>& points) : mesh_(mesh) {
    start(points);
    Triangle_id hint = 0;
    for (Vertex_id v = 0; v < number_of_points_; ++v) {
      insert(v, hint);
      if (mesh_.is_used(v)) hint = mesh_.incident_triangle(v);
    }
  }

  /// For each vertex itself, or the earlier vertex at the same place (which then stands for it).
  const std::vector<Vertex_id>& representatives() const { return representative_; }
  std::size_t number_of_vertices_on_segments() const { return vertices_on_segments_; }
  const std::vector<Input_edge>& edges() const { return edges_; }

  /// Makes the segment from a to b (representatives) a chain of constrained edges, appended to `edges()`.
  /// \throws Crossing if a constrained edge is in the way.
  void insert_segment(Vertex_id a, Vertex_id b, std::int32_t segment) {
    for (Vertex_id from = a; from != b;) {
      const Vertex_id to = recover_up_to_first_vertex(from, b, segment);
      if (to != b) ++vertices_on_segments_;
      from = to;
    }
  }

private:
  /// How a segment leaves its first vertex.
  struct Exit {
    Side along = Side::border(); ///< an edge on the segment, ending at `vertex`
    Vertex_id vertex = -1;
    Side crossed = Side::border(); ///< else the first edge it crosses
  };

  Mesh& mesh_;
  Vertex_id number_of_points_ = 0;
  std::vector<Vertex_id> representative_;
  std::vector<Input_edge> edges_;
  std::size_t vertices_on_segments_ = 0;
  std::vector<std::array<Vertex_id, 2>> crossed_, made_;
  std::vector<Side> doubtful_;

  void start(const std::vector<Point>& points) {
    const std::size_t n = points.size();
    number_of_points_ = static_cast<Vertex_id>(n);
    mesh_.points.reserve(4 * n + 16), mesh_.triangle_of.reserve(4 * n + 16),
        mesh_.edge_of.reserve(4 * n + 16);
    mesh_.triangles.reserve(8 * n + 16);
    representative_.resize(n);
    Point low = points.front(), high = points.front();
    for (const Point& p : points) {
      mesh_.add_vertex(p, input_vertex(static_cast<Vertex_id>(mesh_.number_of_vertices())));
      low.x = std::min(low.x, p.x), low.y = std::min(low.y, p.y);
      high.x = std::max(high.x, p.x), high.y = std::max(high.y, p.y);
    }
    const Vector size = Geometry::difference(high, low);
    const double extent = std::max(size.x, size.y);
    // As near as they can be: differences of 62-bit coordinates must not overflow. Nothing inside the domain
    // sees them.
    for (const Vector corner : {Vector{-1, -0.1}, Vector{2, -0.1}, Vector{0.5, 2.9}})
      mesh_.add_vertex(Geometry::translate(low, extent * corner),
                       input_vertex(static_cast<Vertex_id>(mesh_.number_of_vertices())));
    const Triangle_id t = mesh_.new_triangle();
    for (int k = 0; k < 3; ++k) {
      mesh_.triangle(t).v[k] = number_of_points_ + k;
      mesh_.triangle(t).side[k] = Side::border();
      mesh_.triangle_of[std::size_t(number_of_points_ + k)] = t;
    }
  }

  void insert(Vertex_id v, Triangle_id hint) {
    const Point p = mesh_.point(v);
    const Triangle_id t = locate_exactly(mesh_, hint, p).triangle;
    const auto& r = mesh_.triangle(t);
    representative_[std::size_t(v)] = v;
    int on_slot = -1;
    for (int k = 0; k < 3; ++k) {
      if (mesh_.point(r.v[k]) == p) {
        representative_[std::size_t(v)] = r.v[k];
        return;
      }
      if (Geometry::orientation(mesh_.point(r.v[next_slot[k]]), mesh_.point(r.v[previous_slot[k]]), p) == 0)
        on_slot = k;
    }
    if (on_slot >= 0 && !r.side[on_slot].is_border())
      mesh_.insert_on_side(t, on_slot, v);
    else
      mesh_.insert_in_triangle(t, v);
  }

  /// Whether the segment a-b leaves a along the edge a-p.
  bool is_along(Vertex_id a, Vertex_id p, Vertex_id b, int orientation_apb) const {
    return orientation_apb == 0 && dot(Geometry::difference(mesh_.point(p), mesh_.point(a)),
                                       Geometry::difference(mesh_.point(b), mesh_.point(a))) > 0;
  }

  Exit exit_towards(Vertex_id a, Vertex_id b) const {
    const Triangle_id start = mesh_.incident_triangle(a);
    Triangle_id t = start;
    do {
      const auto& r = mesh_.triangle(t);
      const int i = Mesh::slot_of(r, a);
      const Vertex_id p = r.v[next_slot[i]], q = r.v[previous_slot[i]];
      const int op = mesh_.orientation(a, p, b);
      if (p == b || is_along(a, p, b, op)) return {Side(t, previous_slot[i]), p, Side::border()};
      if (op > 0 && mesh_.orientation(a, q, b) < 0) return {Side::border(), -1, Side(t, i)};
      t = r.side[next_slot[i]].triangle();
    } while (t != start);
    return {};
  }

  Vertex_id recover_up_to_first_vertex(Vertex_id a, Vertex_id b, std::int32_t segment) {
    const Exit exit = exit_towards(a, b);
    if (exit.vertex >= 0) {
      constrain(exit.along, a, exit.vertex, segment);
      return exit.vertex;
    }
    const Vertex_id end = collect_crossed(a, b, exit.crossed, segment);
    flip_crossed(a, end);
    constrain(side_between(a, end), a, end, segment);
    make_Delaunay();
    return end;
  }

  void constrain(Side s, Vertex_id a, Vertex_id b, std::int32_t segment) {
    if (mesh_.across(s).is_constrained()) return; // an earlier segment runs here
    mesh_.constrain(s);
    edges_.push_back({a, b, segment});
  }

  /// Lists the edges between a and the first vertex on the segment a-b; returns that vertex.
  Vertex_id collect_crossed(Vertex_id a, Vertex_id b, Side s, std::int32_t segment) {
    crossed_.clear();
    for (;;) {
      const Vertex_id p = mesh_.source(s), q = mesh_.target(s); // p to the right of a-b, q to the left
      const Side o = mesh_.across(s);
      if (o.is_constrained()) throw Crossing{segment, p, q};
      crossed_.push_back({p, q});
      const Vertex_id d = mesh_.opposite(o);
      const int turn = d == b ? 0 : mesh_.orientation(a, b, d);
      if (turn == 0) return d;
      const auto& r = mesh_.triangle(o.triangle());
      s = Side(o.triangle(),
               Mesh::slot_of(r, turn > 0 ? q : p)); // leave across the edge that d shares with the other
    }
  }

  /// The side between two vertices one of which is not auxiliary (the star of an auxiliary vertex is open).
  Side side_between(Vertex_id p, Vertex_id q) const {
    return p < number_of_points_ ? mesh_.find_side(p, q) : mesh_.find_side(q, p);
  }

  void flip_crossed(Vertex_id a, Vertex_id end) {
    made_.clear();
    for (std::size_t i = 0; i < crossed_.size(); ++i) {
      const auto [p, q] = crossed_[i];
      const Side s = side_between(p, q), o = mesh_.across(s);
      const Vertex_id A = mesh_.opposite(s), B = mesh_.source(s), C = mesh_.target(s), D = mesh_.opposite(o);
      if (mesh_.orientation(A, B, D) <= 0 || mesh_.orientation(A, D, C) <= 0) {
        crossed_.push_back({p, q}); // not convex yet: later
        continue;
      }
      mesh_.flip(s.triangle(), s.slot());
      if (is_crossing(a, end, A, D))
        crossed_.push_back({A, D});
      else
        made_.push_back({A, D});
    }
  }

  bool is_crossing(Vertex_id a, Vertex_id b, Vertex_id c, Vertex_id d) const {
    if (c == a || c == b || d == a || d == b) return false;
    return mesh_.orientation(a, b, c) * mesh_.orientation(a, b, d) < 0;
  }

  void make_Delaunay() {
    for (const auto& [p, q] : made_) {
      const Side s = side_between(p, q);
      if (s.is_border()) continue; // flipped away already
      doubtful_.push_back(s);
      while (!doubtful_.empty()) {
        const Side d = doubtful_.back();
        doubtful_.pop_back();
        const Side o = mesh_.across(d);
        if (o.is_constrained() || !mesh_.is_certainly_not_Delaunay(d.triangle(), d.slot())) continue;
        mesh_.flip(d.triangle(), d.slot());
        const Triangle_id t = d.triangle(), u = o.triangle();
        for (const Side n : {Side(t, 0), Side(u, 0), Side(t, 2), Side(u, 1)}) doubtful_.push_back(n);
      }
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_FIRST_TRIANGULATION_H
