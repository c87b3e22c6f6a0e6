// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// How many triangles are asked for by constrained edges that face each other (Size_estimate.h), which are looked for in
// the sectors of triangles between two constrained sides at a vertex. O(size) for a sector.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_FACING_EDGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_FACING_EDGES_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Two constrained edges that face each other, by their ends, and what they ask for.
struct Facing_pair {
  Vertex_id a[2], b[2];
  double triangles = 0;
};

/// The sum over some sectors.
template <class Geometry>
class Facing_edges {
public:
  using Number = typename Geometry::Number;
  using Vector = Basic_vector<Number>;
  /// Per triangle, bit k: its side k is narrow, that is constrained and longer than twice its distance to the apex.
  /// Others are not looked at, as what they face is narrower from somewhere else, or costs little.
  using Narrow_sides = Indexed_vector<Triangle_id, unsigned char>;

  /// \param least_length no edges of the mesh are shorter
  Facing_edges(const Kernel_mesh<Geometry>& mesh, const Narrow_sides& narrow, double least_length)
      : mesh_(&mesh), narrow_(&narrow), least_(least_length) {}

  double triangles() const { return triangles_; }
  /// The pair that asks for most, the first of them.
  const Facing_pair& worst() const { return worst_; }

  /// Adds what was found in sectors that come later.
  void add(const Facing_edges& later) {
    triangles_ += later.triangles_;
    if (later.worst_.triangles > worst_.triangles) worst_ = later.worst_;
  }

  /// Where the sector at v[k] of a triangle begins that has side k narrow: at the slot whose side before is
  /// constrained, or, if the whole star of the vertex is one sector, at that of the triangle that the mesh knows there.
  static Side start_of_sector(const Kernel_mesh<Geometry>& mesh, Side narrow) {
    Triangle_id t = narrow.triangle();
    int k = narrow.slot();
    do {
      const Side o = mesh.triangle(t).side[previous_slot[k]];
      if (o.is_constrained()) return Side(t, k);
      t = o.triangle();
      k = previous_slot[o.slot()];
    } while (t != narrow.triangle());
    const Vertex_id v = mesh.triangle(t).v[k];
    t = mesh.incident_triangle(v);
    return Side(t, Kernel_mesh<Geometry>::slot_of(mesh.triangle(t), v));
  }

  /// Adds the sector that begins at a slot.
  void add_sector(Side start) {
    if (mesh_->triangle(start.triangle()).side[previous_slot[start.slot()]].is_constrained())
      add_fan(start.triangle(), start.slot());
    else
      add_whole_star(start.triangle(), start.slot());
  }

private:
  /// For each length of a gap as long as the gap is wide: in it, and behind each of its edges that has domain there.
  static constexpr double per_gap = 1, per_side_behind = 1;
  /// No gap is taken for narrower than this share of its length.
  static constexpr double least_gap = 1e-20;

  const Kernel_mesh<Geometry>* mesh_;
  const Narrow_sides* narrow_;
  double least_;
  double triangles_ = 0;
  Facing_pair worst_;
  std::vector<Side> opposite_; // the narrow sides opposite the apex of a sector

  bool is_narrow(Triangle_id t, int k) const { return ((*narrow_)[t] >> k & 1u) != 0; }

  /// The sector, not a whole star, that begins at the side from v[k] to v[k + 1] of t.
  void add_fan(Triangle_id t, int k) {
    const Vertex_id apex = mesh_->triangle(t).v[k];
    const Side first(t, previous_slot[k]);
    opposite_.clear();
    for (;;) {
      const auto& r = mesh_->triangle(t);
      if (is_narrow(t, k)) opposite_.push_back(Side(t, k));
      const Side next = r.side[next_slot[k]];
      if (next.is_constrained()) break;
      t = next.triangle();
      k = next_slot[next.slot()];
    }
    const Side last(t, next_slot[k]);
    for (const Side s : opposite_)
      for (const Side p : {first, last}) add_pair(p, s, 0, is_met_from_both(p, s) ? 0.5 : 1);
    add_consecutive(apex);
    if (mesh_->target(first) == mesh_->source(last) && opposite_.size() > 1)
      add_wedge(apex, opposite_.back(), opposite_.front());
  }

  /// Whether the pair of p, at the apex of a sector, and s, opposite the apex, shows in the sector at an end of s, too:
  /// that end closes the triangle of p.
  bool is_met_from_both(Side p, Side s) const {
    const Vertex_id v = mesh_->opposite(p);
    return is_narrow(p.triangle(), p.slot()) && (v == mesh_->source(s) || v == mesh_->target(s));
  }

  /// The star of a vertex without constrained sides.
  void add_whole_star(Triangle_id start, int k) {
    opposite_.clear();
    Triangle_id t = start;
    do {
      const auto& r = mesh_->triangle(t);
      if (is_narrow(t, k)) opposite_.push_back(Side(t, k));
      const Side next = r.side[next_slot[k]];
      t = next.triangle();
      k = next_slot[next.slot()];
    } while (t != start);
    if (opposite_.size() > 1) opposite_.push_back(opposite_.front());
    add_consecutive(mesh_->triangle(start).v[k]);
  }

  void add_consecutive(Vertex_id apex) {
    for (std::size_t i = 0; i + 1 < opposite_.size(); ++i) {
      const Vertex_id ends[2] = {mesh_->source(opposite_[i]), mesh_->target(opposite_[i])};
      // they face each other where one looks past the apex, from behind its projection on
      add_pair(opposite_[i], opposite_[i + 1], projection(apex, ends), 1);
      add_wedge(apex, opposite_[i], opposite_[i + 1]);
    }
  }

  /// If the edges r and s end and begin in one vertex o, with v between them: beyond v the wedge is filled at
  /// the width that it has there, with a triangle for each angle phi of the way.
  void add_wedge(Vertex_id v, Side r, Side s) {
    const Vertex_id o = mesh_->target(r);
    if (mesh_->source(s) != o) return;
    using std::fabs, std::log, std::sqrt;
    const Vector a = Geometry::scaled_difference(mesh_->point(mesh_->source(r)), mesh_->point(o));
    const Vector b = Geometry::scaled_difference(mesh_->point(mesh_->target(s)), mesh_->point(o));
    const Number cosine = dot(a, b), sine = fabs(area2_beside(a, b, {o, mesh_->source(r)}, mesh_->target(s)));
    if (cosine <= 2 * sine) return; // above 27 degrees
    const Number v2 = squared_length(Geometry::scaled_difference(mesh_->point(v), mesh_->point(o)));
    const Number ratio2 = std::min(squared_length(a), squared_length(b)) / v2;
    if (ratio2 <= 1) return;
    const double narrowest =
        std::max(ratio(std::max(least_, Geometry::spacing(mesh_->point(v))), sqrt(v2)), least_gap);
    add_parts(ratio(0.5 * log(ratio2) * cosine, std::max<Number>(sine, narrowest * cosine)), r, s, 1);
  }

  /// \param share of the pair that this look at it counts
  void add_parts(double parts, Side p, Side q, double share) {
    if (parts <= 1) return;
    double per_part = per_gap;
    for (const Side s : {p, q})
      if (!mesh_->across(s).is_border()) per_part += per_side_behind;
    triangles_ += share * per_part * (parts - 1);
    if (per_part * parts > worst_.triangles)
      worst_ = {{mesh_->source(p), mesh_->target(p)}, {mesh_->source(q), mesh_->target(q)}, per_part * parts};
  }

  /// The cross product of u and w, from p[0] to p[1] and to v: twice the area of their triangle, however flat.
  Number area2_beside(const Vector& u, const Vector& w, const Vertex_id (&p)[2], Vertex_id v) const {
    return Geometry::doubled_area_of_flat(u, w, mesh_->point(p[0]), mesh_->point(p[1]), mesh_->point(v));
  }

  /// Where v is along the edge p, from 0 to 1 between its ends.
  double projection(Vertex_id v, const Vertex_id (&p)[2]) const {
    const Vector u = Geometry::scaled_difference(mesh_->point(p[1]), mesh_->point(p[0]));
    return ratio(dot(Geometry::scaled_difference(mesh_->point(v), mesh_->point(p[0])), u), squared_length(u));
  }

  /// Adds the integral of 1 / gap along the part of the edge p from position `begin` on, the domain on its
  /// left, that faces the edge s.
  void add_pair(Side edge, Side s, double begin, double share) {
    const Vertex_id p[2] = {mesh_->source(edge), mesh_->target(edge)};
    const Vertex_id q[2] = {mesh_->source(s), mesh_->target(s)};
    if (p[0] == q[0] || p[0] == q[1] || p[1] == q[0] || p[1] == q[1]) return;
    using std::fabs, std::sqrt;
    const Vector u = Geometry::scaled_difference(mesh_->point(p[1]), mesh_->point(p[0]));
    const Vector v = Geometry::scaled_difference(mesh_->point(q[0]), mesh_->point(p[0]));
    const Vector w = Geometry::scaled_difference(mesh_->point(q[1]), mesh_->point(p[0]));
    const Number l2 = squared_length(u);
    const Number c0 = area2_beside(u, v, p, q[0]), c1 = area2_beside(u, w, p, q[1]);
    const Number d0 = dot(v, u), d1 = dot(w, u);
    const Number narrowest = std::min(fabs(c0), fabs(c1));
    if (narrowest >= l2 || narrowest >= fabs(d0 - d1)) return; // wider than long
    // in units of the edge p: positions along it and distances from it
    double t0 = ratio(d0, l2), t1 = ratio(d1, l2), g0 = ratio(c0, l2), g1 = ratio(c1, l2);
    if (t0 > t1) std::swap(t0, t1), std::swap(g0, g1);
    const double low = std::max({t0, begin, 0.0}), high = std::min(t1, 1.0);
    if (!(low < high)) return;
    const double spacing = Geometry::spacing(mesh_->point(q[0])); // shorter edges do not come of it
    const double slope = (g1 - g0) / (t1 - t0),
                 floor = std::max(ratio(std::max(least_, spacing), sqrt(l2)), least_gap);
    double a = g0 + slope * (low - t0), b = g0 + slope * (high - t0);
    if (std::max(a, b) <= 0) return; // behind p
    a = std::max(a, floor), b = std::max(b, floor);
    add_parts(std::fabs(a - b) < 1e-3 * a ? (high - low) / a : (high - low) * std::log(b / a) / (b - a), edge,
              s, share);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_FACING_EDGES_H
