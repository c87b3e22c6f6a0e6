// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// One more corner, of squares smaller than the leaves are, where that cures a triangle below the bound.
//
// Computes: a corner of squares whose side is the power of two in (s/4, s/2], where s is the shortest edge of the
//           triangle. All triangles around it meet the bound once it is a vertex, and their least angle is the
//           greatest of those around the corners that are looked at: the ones near the triangle's circumcenter,
//           and near the middle between that and its shortest edge.
// Bound:    50 corners for each triangle; O(d) for one that would be joined with d vertices.
// Source:   ours. Such corners are there after a leaf is split a few times. That would split leaves around it, too, to
//           keep the balance.
//
// No edge is split, and none hides the corner from the triangle.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_FINER_CORNERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_FINER_CORNERS_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Cavity.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/walk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Finer_corners {
public:
  using Point = typename Geometry::Point;
  using Number = typename Geometry::Number;
  using Vector = Basic_vector<Number>;
  using Shape = typename Kernel_mesh<Geometry>::Shape;

  explicit Finer_corners(Meshing_state<Geometry>& state)
      : state_(state), mesh_(state.mesh), cavity_(state.mesh) {}

  /// Inserts a corner that cures triangle t, if there is one.
  bool insert_for(Triangle_id t) {
    const Place best = best_place_for(t);
    if (!best.triangle.is_valid()) return false;
    const Vertex_id v = mesh_.add_vertex(best.point, free_vertex);
    mesh_.insert_in_triangle(best.triangle, v);
    return true;
  }

private:
  struct Place {
    Point point;
    Triangle_id triangle; ///< that has the point; none if there is no place
    double sin2 = 0;      ///< the squared sine of the least angle around it
  };

  /// Corners are looked at in squares of so many sides to each side of a center.
  static constexpr int reach_ = 2;
  static constexpr std::size_t longest_walk_ = 16;

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Cavity<Geometry> cavity_;
  std::vector<Side> sides_; // of a cavity's triangles

  Place best_place_for(Triangle_id t) {
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
    sides_.clear();
    cavity_.visit_sides({end.triangle}, q, [this](Side s) {
      sides_.push_back(s);
      return true;
    });
    if (!has(t)) return;
    double least = 2;
    for (const Side s : sides_) {
      if (!is_rim(s)) continue;
      const Shape shape = mesh_.shape(mesh_.point(mesh_.source(s)), mesh_.point(mesh_.target(s)), q);
      if (state_.bounds.is_sharp(shape)) return;
      least = std::min(least, shape.sin2_of_least_angle());
    }
    if (least > best.sin2) best = {q, end.triangle, least};
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

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_FINER_CORNERS_H
