// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// How many triangles a mesh will need, from the constrained Delaunay triangulation of its domain alone.
//
// Computes: an estimate that is within a factor of 3 of the true number on maps and on thin boxes, rings, combs and
//           strips of any aspect, within a factor of 4 on the hard families of the tests, and of 2 for bounds of
//           size (test_quality_mesher_budget.cpp). Needles with short legs in them may take more.
// Bound:    O(n), with `field_samples` calls of the size field and a few for each triangle.
// Source:   Ruppert (1995): up to constants, any mesh with a bound on the least angle has as many triangles
//           as the integral of 1/lfs^2 over the domain, where lfs is the local feature size. Bern, Eppstein
//           and Gilbert (1994) for the layers around points.
// Method:   Four things make the integral large, and each shows in the triangulation. The constants are
//           measured.
//           - A triangle with longest edge L and height h over it asks for about log(L/h) layers.
//           - Two constrained edges that face each other across a gap g, over a length l, ask for about l/g
//             triangles in the gap, and for as many again behind each of them that has domain there, which they
//             grade up to the width of what is there. Such a pair meets in the fan of some vertex, in a sector of
//             its triangles. Either one edge is at the vertex, first or last in the sector, and the other closes a
//             triangle of the sector. Then the pair may meet at an end of the other edge, too, and each time counts
//             half. Or two consecutive edges close triangles of it.
//           - A vertex between two edges that meet makes the wedge beyond it as expensive as the wedge's
//             width there asks for.
//           - Bounds of size ask for the quotient of the area and the area of one triangle.
//           Otherwise edges that share a vertex do not count as facing each other. Rings cut off wedges
//           (Acute_corners.h), and their number grows with the logarithm only.
//
// The same look at each triangle finds where acute sectors may begin (Corner_finder.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SIZE_ESTIMATE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SIZE_ESTIMATE_H

#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Per triangle of the first triangulation, bit k: an acute sector may begin at its vertex k, which is the first end of
/// a constrained side then.
struct Acute_starts {
  Indexed_vector<Triangle_id, unsigned char> slots_of_triangle;
};

/// Calls `visit(side)` for the slots k of triangles whose mark has bit k, in order. They are gathered before that,
/// without branches, which would be taken at random.
template <class Visit>
void for_each_marked_slot(const Indexed_vector<Triangle_id, unsigned char>& marks,
                          Id_range<Triangle_id> triangles, const Visit& visit) {
  constexpr std::size_t most = 256; // triangles at once
  Side slots[3 * most];
  const auto end = static_cast<std::size_t>(*triangles.end());
  for (auto first = static_cast<std::size_t>(*triangles.begin()); first < end; first += most) {
    std::size_t count = 0;
    for (const Triangle_id t : Id_range<Triangle_id>(first, std::min(first + most, end)))
      for (int k = 0; k < 3; ++k) {
        slots[count] = Side(t, k);
        count += marks[t] >> k & 1u;
      }
    std::for_each(slots, slots + count, visit);
  }
}

template <class Geometry>
class Size_estimate {
public:
  using Point = typename Geometry::Point;
  using Number = typename Geometry::Number;
  using Vector = Basic_vector<Number>;
  using Shape = typename Kernel_mesh<Geometry>::Shape;

  /// Two constrained edges that face each other, by their ends, and what they ask for.
  struct Pair {
    Vertex_id a[2], b[2];
    double triangles = 0;
  };

  /// \pre the mesh is the first triangulation, restricted to the domain.
  template <class ConcurrencyTag>
  Size_estimate(const Meshing_state<Geometry>& state, ConcurrencyTag)
      : state_(state), mesh_(state.mesh), least_(std::sqrt(state.bounds.least_squared_length)) {
    if (state.bounds.squared_length_at)
      for (const auto& r : mesh_.triangles) total_area2_ = total_area2_ + mesh_.shape(r).area2;
    marks_.assign(mesh_.triangles.size(), 0);
    acute_starts_.slots_of_triangle.assign(mesh_.triangles.size(), 0);
    const Demand all = reduce<ConcurrencyTag>(
        mesh_.triangles.size(), Demand(),
        [this](std::size_t begin, std::size_t end) {
          Demand sum;
          mesh_.for_each_alive({begin, end}, [&](Triangle_id t) { add_triangle(t, sum); });
          return sum;
        },
        [](const Demand& a, const Demand& b) {
          return Demand{a.of_shapes + b.of_shapes, a.of_sizes + b.of_sizes};
        });
    of_shapes_ = all.of_shapes, of_sizes_ = all.of_sizes;
    for_each_marked_slot(marks_, mesh_.triangles.ids(),
                         [this](Side narrow) { add_facing_edges(narrow.triangle(), narrow.slot()); });
  }

  double triangles() const {
    const double above = std::max(0.0, state_.bounds.angle / radians_per_degree - 20.7);
    return (1 + per_degree * above) * (of_shapes_ + of_pairs_) + of_sizes_;
  }
  /// What bounds of size ask for alone.
  double triangles_of_sizes() const { return of_sizes_; }
  /// The pair that asks for most.
  const Pair& worst_pair() const { return worst_; }
  /// Where acute sectors may begin: the slots that can be the apex in the clockwise-most triangle of one.
  Acute_starts take_acute_starts() { return std::move(acute_starts_); }

private:
  static constexpr double per_triangle = 1.5;
  static constexpr double per_layer = 3;
  static constexpr double ordinary_aspect = 8, largest_aspect = 0x1p52;
  /// For each length of a gap as long as the gap is wide: in it, and behind each of its edges that has domain there.
  static constexpr double per_gap = 1, per_side_behind = 1;
  /// No gap is taken for narrower than this share of its length.
  static constexpr double least_gap = 1e-20;
  /// By how much more triangles a bound takes above 20.7 degrees.
  static constexpr double per_degree = 0.08;
  /// The area of a triangle that a bound on areas leads to, as a share of the bound.
  static constexpr double share_of_area = 0.55;
  /// The same for a bound h on edges, as a share of h^2.
  static constexpr double share_of_squared_edge = 0.28;
  static constexpr double field_samples = 20000;

  /// What triangles ask for, each for itself.
  struct Demand {
    double of_shapes = 0, of_sizes = 0;
  };

  const Meshing_state<Geometry>& state_;
  const Kernel_mesh<Geometry>& mesh_;
  double least_;
  Number total_area2_ = 0;
  double of_shapes_ = 0, of_pairs_ = 0, of_sizes_ = 0;
  Pair worst_;
  /// Bit k: for a narrow side k; 3 + k: for a sector begun there.
  Indexed_vector<Triangle_id, unsigned char> marks_;
  Acute_starts acute_starts_;
  std::vector<Side> opposite_; // the narrow sides opposite the apex of a sector

  void add_triangle(Triangle_id t, Demand& demand) {
    const auto& r = mesh_.triangle(t);
    const Shape s = reliable_shape(r);
    unsigned constrained = 0, narrow = 0, starts = 0;
    for (int k = 0; k < 3; ++k) { // no branches: they would be taken at random
      const unsigned is_constrained = r.side[k].is_constrained() ? 1 : 0;
      constrained += is_constrained;
      narrow |= (is_constrained & (2 * s.area2 < s.l[k] ? 1u : 0u)) << k;
      const int apex = next_slot[k]; // of the sector to the left of side k
      starts |= (is_constrained & (s.may_be_below_60_degrees(apex) ? 1u : 0u)) << apex;
    }
    marks_[t] = static_cast<unsigned char>(narrow);
    acute_starts_.slots_of_triangle[t] = static_cast<unsigned char>(starts);
    demand.of_shapes += per_triangle;
    if (constrained < 2 && s.longest() > ordinary_aspect * s.area2) {
      // collinear vertices give no area in doubles
      double aspect = std::min(ratio(s.longest(), s.area2), largest_aspect);
      if (least_ > 0)
        aspect = std::min(aspect, std::max(ordinary_aspect, std::sqrt(ratio(s.longest(), least_ * least_))));
      demand.of_shapes += per_layer * std::log2(std::min(aspect / ordinary_aspect, growth_around(r, s)));
    }
    demand.of_sizes += sizes_demand(t, s);
  }

  /// Vertices units in the last place from a line give any area in doubles, also a negative one.
  Shape reliable_shape(const typename Kernel_mesh<Geometry>::Triangle& r) const {
    const Shape s = mesh_.shape(r);
    return s.is_certainly_counterclockwise() ? s : mesh_.shape_of_flat(r.v[0], r.v[1], r.v[2]);
  }

  /// How much longer than the shortest edge of a needle the next edges around its apex are, at least 1: of
  /// needles side by side the layers are in common.
  double growth_around(const typename Kernel_mesh<Geometry>::Triangle& r, const Shape& s) const {
    const int k = s.slot_of_shortest();
    Number next = s.longest();
    for (const int j : {next_slot[k], previous_slot[k]}) {
      const Side o = r.side[j];
      if (o.is_constrained()) continue;
      const auto& n = mesh_.triangle(o.triangle());
      const Side base(o.triangle(), Kernel_mesh<Geometry>::slot_of(n, r.v[k]));
      next = std::min(next, squared_length(Geometry::scaled_difference(mesh_.point(mesh_.source(base)),
                                                                       mesh_.point(mesh_.target(base)))));
    }
    const bool is_needle = s.longest() > 16 * s.shortest();
    return !is_needle ? std::numeric_limits<double>::infinity()
                      : std::max(1.0, std::sqrt(ratio(next, s.shortest())));
  }

  double sizes_demand(Triangle_id t, const Shape& s) const {
    const Bounds<Geometry>& bounds = state_.bounds;
    if (!bounds.is_size_bounded()) return 0;
    double area2 = bounds.area2;
    if (!bounds.area2_of_region.empty() && mesh_.region(t).is_valid())
      area2 = std::min(area2, bounds.area2_of_region[mesh_.region(t)]);
    double per_area2 =
        std::max(1 / (share_of_area * area2), 0.5 / (share_of_squared_edge * bounds.squared_length));
    if (bounds.squared_length_at) per_area2 = std::max(per_area2, field_density(t, s));
    const double finest = least_ > 0 ? 0.5 / (share_of_squared_edge * least_ * least_) : per_area2;
    // finite, so that areas of exact numbers that doubles do not have are worth nothing
    constexpr double densest = std::numeric_limits<double>::max();
    return ratio(s.area2, 1) * std::min({per_area2, finest, densest});
  }

  /// The mean of the density that the size field asks for in t, at the centers of k^2 parts of equal area.
  double field_density(Triangle_id t, const Shape& s) const {
    const auto& r = mesh_.triangle(t);
    const Point& a = mesh_.point(r.v[0]);
    const Vector ab = Geometry::scaled_difference(mesh_.point(r.v[1]), a),
                 ac = Geometry::scaled_difference(mesh_.point(r.v[2]), a);
    const int k = static_cast<int>(std::ceil(std::sqrt(ratio(field_samples * s.area2, total_area2_))));
    double sum = 0;
    for (int i = 0; i < k; ++i)
      for (int j = 0; i + j < k; ++j)
        for (const double third : {1. / 3, 2. / 3}) {
          if (third > 0.5 && i + j + 1 == k) continue; // no second part at the border
          const Point p = Geometry::translate(a, ((i + third) / k) * ab + ((j + third) / k) * ac);
          sum += 0.5 / (share_of_squared_edge * state_.bounds.squared_length_at(p));
        }
    return sum / (static_cast<double>(k) * k);
  }

  // ---- edges that face each other

  /// Whether side k of t is constrained and longer than twice its distance to the apex: others are not
  /// looked at, as what they face is narrower from somewhere else, or costs little.
  bool is_narrow(Triangle_id t, int k) const { return (marks_[t] >> k & 1u) != 0; }

  /// Marks the sector that begins at slot k of t; false if it was marked already.
  bool mark_sector(Triangle_id t, int k) {
    const unsigned char bit = static_cast<unsigned char>(8u << k);
    if ((marks_[t] & bit) != 0) return false;
    marks_[t] = static_cast<unsigned char>(marks_[t] | bit);
    return true;
  }

  /// Visits the sector of triangles at v[k] of t, from one constrained side to the next, if it is not yet
  /// done.
  void add_facing_edges(Triangle_id t, int k) {
    const Triangle_id start = t;
    for (;;) {
      const Side o = mesh_.triangle(t).side[previous_slot[k]];
      if (o.is_constrained()) {
        if (mark_sector(t, k)) add_sector(t, k);
        return;
      }
      t = o.triangle();
      k = previous_slot[o.slot()];
      if (t == start) break;
    }
    const Vertex_id v = mesh_.triangle(t).v[k];
    t = mesh_.incident_triangle(v);
    k = Kernel_mesh<Geometry>::slot_of(mesh_.triangle(t), v);
    if (mark_sector(t, k)) add_whole_star(t, k);
  }

  /// The sector that begins at the side from v[k] to v[k + 1] of t.
  void add_sector(Triangle_id t, int k) {
    const Vertex_id apex = mesh_.triangle(t).v[k];
    const Side first(t, previous_slot[k]);
    opposite_.clear();
    for (;;) {
      const auto& r = mesh_.triangle(t);
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
    if (mesh_.target(first) == mesh_.source(last) && opposite_.size() > 1)
      add_wedge(apex, opposite_.back(), opposite_.front());
  }

  /// Whether the pair of p, at the apex of a sector, and s, opposite the apex, shows in the sector at an end of s, too:
  /// that end closes the triangle of p.
  bool is_met_from_both(Side p, Side s) const {
    const Vertex_id v = mesh_.opposite(p);
    return is_narrow(p.triangle(), p.slot()) && (v == mesh_.source(s) || v == mesh_.target(s));
  }

  /// The star of a vertex without constrained sides.
  void add_whole_star(Triangle_id start, int k) {
    opposite_.clear();
    Triangle_id t = start;
    do {
      const auto& r = mesh_.triangle(t);
      if (is_narrow(t, k)) opposite_.push_back(Side(t, k));
      const Side next = r.side[next_slot[k]];
      t = next.triangle();
      k = next_slot[next.slot()];
    } while (t != start);
    if (opposite_.size() > 1) opposite_.push_back(opposite_.front());
    add_consecutive(mesh_.triangle(start).v[k]);
  }

  void add_consecutive(Vertex_id apex) {
    for (std::size_t i = 0; i + 1 < opposite_.size(); ++i) {
      const Vertex_id ends[2] = {mesh_.source(opposite_[i]), mesh_.target(opposite_[i])};
      // they face each other where one looks past the apex, from behind its projection on
      add_pair(opposite_[i], opposite_[i + 1], projection(apex, ends), 1);
      add_wedge(apex, opposite_[i], opposite_[i + 1]);
    }
  }

  /// If the edges r and s end and begin in one vertex o, with v between them: beyond v the wedge is filled at
  /// the width that it has there, with a triangle for each angle phi of the way.
  void add_wedge(Vertex_id v, Side r, Side s) {
    const Vertex_id o = mesh_.target(r);
    if (mesh_.source(s) != o) return;
    using std::fabs, std::log, std::sqrt;
    const Vector a = Geometry::scaled_difference(mesh_.point(mesh_.source(r)), mesh_.point(o));
    const Vector b = Geometry::scaled_difference(mesh_.point(mesh_.target(s)), mesh_.point(o));
    const Number cosine = dot(a, b), sine = fabs(area2_beside(a, b, {o, mesh_.source(r)}, mesh_.target(s)));
    if (cosine <= 2 * sine) return; // above 27 degrees
    const Number v2 = squared_length(Geometry::scaled_difference(mesh_.point(v), mesh_.point(o)));
    const Number ratio2 = std::min(squared_length(a), squared_length(b)) / v2;
    if (ratio2 <= 1) return;
    const double narrowest =
        std::max(ratio(std::max(least_, Geometry::spacing(mesh_.point(v))), sqrt(v2)), least_gap);
    add_parts(ratio(0.5 * log(ratio2) * cosine, std::max<Number>(sine, narrowest * cosine)), r, s, 1);
  }

  /// \param share of the pair that this look at it counts
  void add_parts(double parts, Side p, Side q, double share) {
    if (parts <= 1) return;
    double per_part = per_gap;
    for (const Side s : {p, q})
      if (!mesh_.across(s).is_border()) per_part += per_side_behind;
    of_pairs_ += share * per_part * (parts - 1);
    if (per_part * parts > worst_.triangles)
      worst_ = {{mesh_.source(p), mesh_.target(p)}, {mesh_.source(q), mesh_.target(q)}, per_part * parts};
  }

  /// The cross product of u and w, from p[0] to p[1] and to v: twice the area of their triangle, however flat.
  Number area2_beside(const Vector& u, const Vector& w, const Vertex_id (&p)[2], Vertex_id v) const {
    return Geometry::doubled_area_of_flat(u, w, mesh_.point(p[0]), mesh_.point(p[1]), mesh_.point(v));
  }

  /// Where v is along the edge p, from 0 to 1 between its ends.
  double projection(Vertex_id v, const Vertex_id (&p)[2]) const {
    const Vector u = Geometry::scaled_difference(mesh_.point(p[1]), mesh_.point(p[0]));
    return ratio(dot(Geometry::scaled_difference(mesh_.point(v), mesh_.point(p[0])), u), squared_length(u));
  }

  /// Adds the integral of 1 / gap along the part of the edge p from position `begin` on, the domain on its
  /// left, that faces the edge s.
  void add_pair(Side edge, Side s, double begin, double share) {
    const Vertex_id p[2] = {mesh_.source(edge), mesh_.target(edge)};
    const Vertex_id q[2] = {mesh_.source(s), mesh_.target(s)};
    if (p[0] == q[0] || p[0] == q[1] || p[1] == q[0] || p[1] == q[1]) return;
    using std::fabs, std::sqrt;
    const Vector u = Geometry::scaled_difference(mesh_.point(p[1]), mesh_.point(p[0]));
    const Vector v = Geometry::scaled_difference(mesh_.point(q[0]), mesh_.point(p[0]));
    const Vector w = Geometry::scaled_difference(mesh_.point(q[1]), mesh_.point(p[0]));
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
    const double spacing = Geometry::spacing(mesh_.point(q[0])); // shorter edges do not come of it
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

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SIZE_ESTIMATE_H
