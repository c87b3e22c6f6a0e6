// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// One more vertex, where that cures a triangle below the bound: a corner of squares smaller than the leaves are, or a
// vertex on an edge.
//
// Computes: 1. A corner of squares whose side is the power of two in (s/4, s/2], where s is the shortest edge of the
//           triangle. All triangles around it meet the bound once it is a vertex, and their least angle is the
//           greatest of those around the corners that are looked at: the ones near the triangle's circumcenter,
//           and near the middle between that and its shortest edge. No edge hides it from the triangle.
//           2. If there is none, a place in the middle part of a side of the triangle that is on an edge, with
//           the same properties.
// Bound:    50 corners and 15 places on edges for each triangle; O(d) for one that would be joined with d vertices.
// Source:   ours. Such vertices are there after a leaf is split a few times. That would split leaves around it, too, to
//           keep the balance.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_VERTEX_ADDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_VERTEX_ADDER_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/keeps_orientation.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Cavity.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/walk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Vertex_adder {
public:
  using Point = typename Geometry::Point;
  using Number = typename Geometry::Number;
  using Vector = Basic_vector<Number>;
  using Shape = typename Kernel_mesh<Geometry>::Shape;

  explicit Vertex_adder(Meshing_state<Geometry>& state)
      : state_(state), mesh_(state.mesh), cavity_(state.mesh) {}

  /// Inserts a vertex that cures triangle t, if there is one.
  bool insert_for(Triangle_id t) { return insert_corner_for(t) || insert_on_side_of(t); }

private:
  struct Place {
    Point point;
    Triangle_id triangle; ///< that has the point; none if there is no place
    double sin2 = 0;      ///< the squared sine of the least angle around it
  };

  /// Corners are looked at in squares of so many sides to each side of a center.
  static constexpr int reach_ = 2;
  static constexpr std::size_t longest_walk_ = 16;
  /// Of a side, where a vertex may be.
  static constexpr double shares_of_side_[] = {0.5, 0.4, 0.6, 0.3, 0.7};

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Cavity<Geometry> cavity_;
  std::vector<Side> sides_; // of a cavity's triangles

  bool insert_corner_for(Triangle_id t) {
    const Place best = best_corner_for(t);
    if (!best.triangle.is_valid()) return false;
    mesh_.insert_in_triangle(best.triangle, mesh_.add_vertex(best.point, free_vertex));
    return true;
  }

  bool insert_on_side_of(Triangle_id t) {
    Place best;
    Side side;
    for (int k = 0; k < 3; ++k) {
      const Side s(t, k);
      const Edge_id e = mesh_.across(s).is_constrained() ? edge_at(s) : Edge_id();
      if (!e.is_valid() || state_.problem.is_kept(e)) continue;
      const double before = best.sin2;
      for (const double share : shares_of_side_) look_at_place_on(s, e, share, best);
      if (best.sin2 > before) side = s;
    }
    if (!best.triangle.is_valid()) return false;
    mesh_.insert_on_side(t, side.slot(), mesh_.add_vertex(best.point, edge_at(side)));
    return true;
  }

  Edge_id edge_at(Side s) const { return state_.edges.carrying(mesh_, mesh_.source(s), mesh_.target(s)); }

  void look_at_place_on(Side s, Edge_id e, double share, Place& best) {
    const Point q = state_.point_on_edge_between(e, mesh_.source(s), mesh_.target(s), share);
    if (!keeps_orientation(mesh_, s, q) || !state_.problem.is_clear_of_outside(e, q)) return;
    const Side o = mesh_.across(s);
    collect_cavity({s.triangle(), o.is_border() ? Triangle_id() : o.triangle()}, q);
    const double least = least_sin2_around(q, s);
    if (least > best.sin2) best = {q, s.triangle(), least};
  }

  Place best_corner_for(Triangle_id t) {
    using std::sqrt;
    const auto r = mesh_.triangle(t);
    const Shape s = mesh_.shape(r);
    const int k = s.slot_of_shortest();
    const Point& a = mesh_.point(r.v[next_slot[k]]);
    if (!Geometry::is_resolved(a, s.l[k])) return {};
    const Number side = power_of_two_at_most(0.5 * sqrt(s.l[k]));
    Place best;
    for (const Vector& center : centers_for(r, s, k)) {
      const Point middle = Geometry::nearest_corner(Geometry::translate(a, center), side);
      for (int i = -reach_; i <= reach_; ++i)
        for (int j = -reach_; j <= reach_; ++j)
          look_at(Geometry::translate(middle, Vector{Number(i) * side, Number(j) * side}), t, best);
    }
    return best;
  }

  /// The circumcenter, and the middle between it and the shortest edge; from the first end of that edge.
  std::array<Vector, 2> centers_for(const typename Kernel_mesh<Geometry>::Triangle& r, const Shape& s,
                                    int k) const {
    const Point& a = mesh_.point(r.v[next_slot[k]]);
    const Vector ab = Geometry::scaled_difference(mesh_.point(r.v[previous_slot[k]]), a),
                 ac = Geometry::scaled_difference(mesh_.point(r.v[k]), a);
    const Number lb = squared_length(ab), lc = squared_length(ac), f = 0.5 / s.area2;
    const Vector circumcenter{f * (ac.y * lb - ab.y * lc), f * (ab.x * lc - ac.x * lb)};
    return {circumcenter, 0.5 * (circumcenter + 0.5 * ab)};
  }

  void look_at(const Point& q, Triangle_id t, Place& best) {
    const Walk_end end = walk_in_sight(mesh_, t, q, longest_walk_);
    if (end.is_broken_off || end.is_blocked() || !is_inside(end.triangle, q)) return;
    collect_cavity({end.triangle}, q);
    if (!has(t)) return;
    const double least = least_sin2_around(q, Side());
    if (least > best.sin2) best = {q, end.triangle, least};
  }

  void collect_cavity(std::initializer_list<Triangle_id> holders, const Point& q) {
    sides_.clear();
    cavity_.visit_sides(holders, q, [this](Side s) {
      sides_.push_back(s);
      return true;
    });
  }

  /// The squared sine of the least angle around a place, if that is no sharp one; else 0.
  /// \param split the side that the place is on, if it is on one
  double least_sin2_around(const Point& q, Side split) const {
    double least = 2;
    for (const Side s : sides_) {
      if (!is_rim(s) || are_same(s, split) || are_same(mesh_.across(s), split)) continue;
      const Shape shape = mesh_.shape(mesh_.point(mesh_.source(s)), mesh_.point(mesh_.target(s)), q);
      if (state_.bounds.is_sharp(shape)) return 0;
      least = std::min(least, shape.sin2_of_least_angle());
    }
    return least;
  }

  static bool are_same(Side s, Side t) {
    return !s.is_border() && !t.is_border() && s.triangle() == t.triangle() && s.slot() == t.slot();
  }

  bool is_inside(Triangle_id t, const Point& q) const {
    const auto& v = mesh_.triangle(t).v;
    for (int k = 0; k < 3; ++k)
      if (Geometry::orientation(mesh_.point(v[next_slot[k]]), mesh_.point(v[previous_slot[k]]), q) <= 0)
        return false;
    return true;
  }

  bool has(Triangle_id t) const {
    return std::any_of(sides_.begin(), sides_.end(), [t](Side s) { return s.triangle() == t; });
  }
  bool is_rim(Side s) const {
    const Side o = mesh_.across(s);
    return o.is_constrained() || !has(o.triangle());
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_VERTEX_ADDER_H
