// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Splits constrained edges, and keeps the rings around acute corners while it does.
//
// Computes: a new vertex on a constrained edge, and what the corner at an end of the edge needs with it.
//           - A subsegment away from acute corners is split where the caller wants, within its middle 30
//             percent.
//           - A leg of an acute vertex without a ring is split at a dyadic distance from that vertex
//             (Ruppert's concentric shells).
//           - Within a ring, the interval between two shells is halved on all legs of the corner at once, so
//             shells stay matched. But a shell does not pass over a sector in which the distance between legs
//             is much greater than the interval. This happens next to features far from the apex. Legs beyond
//             such a sector have no part in them.
//           - The chord that locks a lopped sector is never split. When something comes too close to it, the
//             lock moves down to the next shell. If there is none, a shell is made at 0.6 of the radius. What
//             was behind the chord becomes ordinary domain.
//           - Edges that get no vertices (kept_edges.h) are never split. Beside a leg of this kind a sector has no
//             chord.
// Bound:    O(degree + log n) for a split, times the number of legs within a ring, for n shells on a leg.
// Source:   Bern, Eppstein, Teng, section 6: "We can ignore the cut-off triangles for the remainder of the
//           algorithm, simply reattaching them (with appropriately subdivided cutting edges) after the final
//           warping step." The radii of the cuts are those of Corner_finder.h, which quotes how the paper
//           chooses them.
// Deviates: cut-off triangles stay in the mesh, behind their chords. A cutting edge is not subdivided.
//           Instead the cut moves toward the apex.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SPLITTER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SPLITTER_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/keeps_orientation.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/edge_next_to.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/least_edge.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// For what triangle an edge is to be split: an ordinary one, or one that is narrower than coordinates are rounded.
enum class Asker { ORDINARY, NARROW };

template <class Geometry>
class Splitter {
public:
  using Point = typename Geometry::Point;
  using Number = typename Geometry::Number;
  using Leg = typename Acute_corners<Geometry>::Leg;
  using Sector = typename Acute_corners<Geometry>::Sector;
  using Corner = typename Acute_corners<Geometry>::Corner;

  explicit Splitter(Meshing_state<Geometry>& state)
      : state_(state), mesh_(state.mesh), corners_(state.corners) {}

  /// Cuts the legs of all corners at their radius and locks the lopped sectors.
  void cut_rings() {
    for (Corner& corner : corners_.corners) {
      corner.radius = radius_of_ring(corner);
      for (const Leg_id l : corner.legs) cut_ring_on_leg(l, corner.radius, ring_tolerance(corner));
    }
    for (const Sector_id s : corners_.sectors.ids()) lock_at_ring(s);
  }

  /// Unlocks all lopped sectors: removal may then treat shell vertices as any others.
  void unlock_all() {
    for (Sector& s : corners_.sectors) {
      if (s.lock_radius > 0) release_chord(s);
      s.lock_radius = 0;
    }
  }

  /// Splits the constrained edge at side k of t, near `want` where nothing else is prescribed.
  /// Blocked if the edge gets no vertices. Refused if it cannot be split: it is as short as coordinates allow, or it is
  /// for the sake of a triangle between two edges that coordinates hardly tell apart. There would be no end of these.
  Outcome split(Triangle_id t, int k, const Point* want, Asker asker) {
    const Side side(t, k);
    if (mesh_.across(side).is_seam()) return Outcome::DEFERRED;
    const Vertex_id x = mesh_.source(side), y = mesh_.target(side);
    const Edge_id e = state_.edges.carrying(mesh_, x, y);
    if (!e.is_valid()) return split_chord(x, y);
    if (state_.problem.is_kept(e)) return Outcome::BLOCKED;
    for (const Leg_id l : corners_.legs_of_edge[e])
      if (l.is_valid() && !state_.owns(corners_.leg(l).corner)) return Outcome::DEFERRED;
    for (const Leg_id l : corners_.legs_of_edge[e])
      if (l.is_valid() && state_.leg_rule == Leg_rule::SHELLS && is_within_ring(l, x, y))
        return outcome(split_within_ring(l, x, y, want, asker));
    return outcome(split_subsegment(side, e, want, asker));
  }

  /// Splits a piece of an input edge at a distance from an end of the edge. If there is an acute corner, that becomes a
  /// shell of it.
  /// \param end of the edge: 0 or 1
  bool split_at(Side s, Edge_id e, std::size_t end, const Number& radius) {
    const Vertex_id apex = end == 0 ? state_.edges[e].a : state_.edges[e].b;
    const Vertex_id v = insert(s, e,
                               Geometry::between(state_.problem.input_point(apex),
                                                 state_.problem.input_point(state_.edges.other_end(e, apex)),
                                                 radius / length_of_edge(e)));
    if (!v.is_valid()) return false;
    const Leg_id l = corners_.legs_of_edge[e][end];
    if (l.is_valid()) corners_.leg(l).shells.insert(radius, v);
    return true;
  }

  /// Makes a bad triangle within a locked sector ordinary domain (or, if it touches the apex, halves its
  /// leg).
  /// Refused if t is not within a lock, or nothing can be done.
  Outcome open_lock_around(Triangle_id t) {
    const auto r = mesh_.triangle(t);
    const Sector_id s = corners_.sector_of(mesh_, r.v[0], r.v[1], r.v[2]);
    if (!s.is_valid() || is_between_kept(corners_.sector(s))) return Outcome::REFUSED;
    const Corner_id c = corners_.corner_of(corners_.sector(s));
    if (!state_.owns(c)) return Outcome::DEFERRED;
    if (corners_.sector(s).lock_radius == 0) return Outcome::REFUSED;
    const Number lock_radius = corners_.sector(s).lock_radius;
    // only at the ring may vertices stand in for those of the radius; further in the chord is the limit
    const bool is_at_ring = lock_radius == corners_.corner(c).radius;
    const Number tolerance = is_at_ring ? ring_tolerance(corners_.corner(c)) : same_radius * lock_radius;
    Number low = lock_radius, high = 0;
    for (const Vertex_id v : r.v) {
      const Number radius = shell_radius(s, v);
      if (radius < 0 || radius > lock_radius + tolerance) return Outcome::REFUSED;
      low = std::min(low, radius), high = std::max(high, radius);
    }
    if (low >= lock_radius) return outcome(lower_lock(s));
    return outcome(low == 0 ? insert_shell(c, shell_below(s, high)) : move_lock(s, low));
  }

private:
  static Outcome outcome(bool is_changed) { return is_changed ? Outcome::CHANGED : Outcome::REFUSED; }

  /// New shells next to the apex lie at this share of the innermost radius. Their ratio, 1.67, leaves room
  /// for ring vertices that are not quite matched (Acute_corners.h).
  static constexpr double innermost_share = 0.6;
  /// A far end or another ring's vertex within this share of the chord stands in for the ring vertex.
  static constexpr double chord_share_to_merge = 0.4;

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Acute_corners<Geometry>& corners_;

  /// Nothing is cut nearer to an acute apex than this share of the leg. For bounds that are established, only
  /// features as near as that could ask for it, or coordinates are the limit. Above these bounds, two corners
  /// of one vertex may drive each other on without end.
  Number least_share_of_leg() const {
    return state_.bounds.is_established() ? state_.problem.least_share_of_leg : Number(0x1p-12);
  }

  /// Shells nearer to each other than this share of the distance between two legs are not matched there. Copies of a
  /// feature at one leg's end would find features, and corners without room, at the same radius on other legs. Where
  /// legs are cut for the sake of circles, a piece has vertices of another leg in its own only if that is nearer than
  /// half of the piece: such legs follow, and no others, or each cut would be one of all legs of a fan.
  double least_share_of_chord() const { return state_.encroachment == Encroachment::CIRCLES ? 4 : 0x1p-5; }

  Number distance(Vertex_id a, Vertex_id b) const {
    return length(Geometry::scaled_difference(mesh_.point(a), mesh_.point(b)));
  }

  Point point_on_leg(const Leg& leg, Number radius) const {
    return Geometry::between(state_.problem.input_point(leg.apex), state_.problem.input_point(leg.far),
                             radius / leg.length);
  }

  static Number ring_tolerance(const Corner& c) { return ring_tolerance(c.least_angle, c.radius); }
  static Number ring_tolerance(double angle, Number radius) {
    return chord_share_to_merge * chord_of_sector(angle, radius);
  }

  // ---- shells

  /// Whether a leg gets no vertices. It has no shells then, and sectors beside it are ordinary domain.
  bool is_kept(const Leg& leg) const { return state_.problem.is_kept(leg.edge); }
  bool is_between_kept(const Sector& s) const {
    return is_kept(corners_.leg(s.right)) || is_kept(corners_.leg(s.left));
  }

  /// Where the ring meets a leg: at the vertex `beyond`, if that stands in for a new one, else before it.
  struct Ring_place {
    Vertex_id beyond;
    Number room; ///< its distance from the apex
    bool is_stand_in;
  };
  Ring_place ring_place(Leg_id l, Number radius, Number tolerance) const {
    const Leg& leg = corners_.leg(l);
    const auto& at = corners_.legs_of_edge[leg.edge];
    const Leg_id opposite = at[0] == l ? at[1] : at[0];
    const Vertex_id opposite_ring = opposite.is_valid() ? corners_.leg(opposite).ring : Vertex_id();
    const Vertex_id beyond = opposite_ring.is_valid() && opposite_ring != leg.apex ? opposite_ring : leg.far;
    const Number room = beyond == leg.far ? leg.length : distance(leg.apex, beyond);
    return {beyond, room, room <= radius + tolerance};
  }

  /// The greatest radius, of few below that of the corner, at which all legs can be cut; if there is none, that of the
  /// corner.
  Number radius_of_ring(const Corner& corner) const {
    constexpr double least_share = 0.1;
    for (double share = 1; share > least_share; share *= innermost_share)
      if (may_cut_ring(corner, share * corner.radius)) return share * corner.radius;
    return corner.radius;
  }

  /// Whether all legs can be cut at a radius. Rounding may put a vertex next to the far end of a leg beside the thin
  /// triangle there.
  bool may_cut_ring(const Corner& corner, Number radius) const {
    const Number tolerance = ring_tolerance(corner.least_angle, radius);
    return std::all_of(corner.legs.begin(), corner.legs.end(), [&](Leg_id l) {
      if (is_kept(corners_.leg(l))) return true;
      const Ring_place place = ring_place(l, radius, tolerance);
      if (place.is_stand_in) return true;
      const Leg& leg = corners_.leg(l);
      const Side s = state_.side_between(leg.apex, place.beyond);
      return !s.is_border() && keeps_orientation(mesh_, s, point_on_leg(leg, radius));
    });
  }

  void cut_ring_on_leg(Leg_id l, Number radius, Number tolerance) {
    Leg& leg = corners_.leg(l);
    if (is_kept(leg)) return;
    const Ring_place place = ring_place(l, radius, tolerance);
    leg.ring = place.is_stand_in
                   ? place.beyond
                   : insert_between(leg.apex, place.beyond, leg.edge, point_on_leg(leg, radius));
    if (leg.ring.is_valid()) leg.shells.insert(place.is_stand_in ? place.room : radius, leg.ring);
  }

  /// Cuts every leg of the corner at a radius within the ring, where it is not cut there yet.
  bool insert_shell(Corner_id c, Number radius, Asker asker = Asker::ORDINARY) {
    return insert_shell(c, {0, corners_.corner(c).legs.size()}, radius, asker);
  }

  bool insert_shell(Corner_id c, Leg_run run, Number radius, Asker asker) {
    bool is_changed = false;
    const Corner& corner = corners_.corner(c);
    if (is_cut_on_all_legs(corner)) asker = Asker::ORDINARY;
    for (std::size_t i = 0; i < run.size; ++i) {
      Leg& leg = corners_.leg(corner.legs[(run.first + i) % corner.legs.size()]);
      if (is_kept(leg)) continue;
      if (radius < least_share_of_leg() * leg.length) return false;
      const auto around =
          leg.shells.around(radius, leg.apex_vertex, [this](Vertex_id v) { return mesh_.is_used(v); });
      if (!around.above.vertex.is_valid() || around.below.radius >= radius * (1 - same_radius) ||
          around.above.radius <= radius * (1 + same_radius))
        continue;
      const Point p = point_on_leg(leg, radius);
      if (!may_insert_for(asker, state_.side_between(around.below.vertex, around.above.vertex), p)) continue;
      const Vertex_id v = insert_between(around.below.vertex, around.above.vertex, leg.edge, p);
      if (!v.is_valid()) continue;
      leg.shells.insert(radius, v);
      is_changed = true;
    }
    return is_changed;
  }

  /// Whether all legs have a ring vertex. Otherwise sectors are ordinary domain, however narrow.
  bool is_cut_on_all_legs(const Corner& c) const {
    return std::all_of(c.legs.begin(), c.legs.end(),
                       [this](Leg_id l) { return corners_.leg(l).ring.is_valid(); });
  }

  bool is_within_ring(Leg_id l, Vertex_id x, Vertex_id y) const {
    return radius_on_leg(corners_.leg(l), x) >= 0 && radius_on_leg(corners_.leg(l), y) >= 0;
  }

  /// The radius of a leg's shell vertex, 0 for the apex, -1 for other vertices.
  static Number radius_on_leg(const Leg& leg, Vertex_id v) {
    return v == leg.apex_vertex ? Number(0) : leg.shells.radius_of(v);
  }

  Number shell_radius(Sector_id s, Vertex_id v) const {
    const Sector& sector = corners_.sector(s);
    return std::max(radius_on_leg(corners_.leg(sector.right), v),
                    radius_on_leg(corners_.leg(sector.left), v));
  }

  /// Splits the interval x-y of a leg, and with it all legs to which that matters.
  bool split_within_ring(Leg_id l, Vertex_id x, Vertex_id y, const Point* want, Asker asker) {
    const Corner_id c = corners_.leg(l).corner;
    const Number p = radius_on_leg(corners_.leg(l), x), q = radius_on_leg(corners_.leg(l), y);
    const Number low = std::min(p, q), high = std::max(p, q);
    Leg_run run = corners_.legs_reached_from(l, low, (high - low) / least_share_of_chord());
    if (run.size == 1 && split_interval(l, x, y, want, asker)) return true;
    const Leg_run all{0, corners_.corner(c).legs.size()};
    if (run.size == 1 || (run.size < all.size && !lower_locks_beside(c, run, low))) run = all;
    const Number radius = low == 0 ? Number(innermost_share * high) : Number((low + high) / 2);
    return insert_shell(c, run, radius, asker) || split_interval(l, x, y, want, asker);
  }

  /// Makes sectors from a run to legs beside it ordinary domain beyond a radius, since their legs will not match.
  bool lower_locks_beside(Corner_id c, Leg_run run, Number low) {
    const auto& legs = corners_.corner(c).legs;
    const Leg_id right = legs[run.first], left = legs[(run.first + run.size - 1) % legs.size()];
    return lower_locks({corners_.leg(right).before, corners_.leg(left).after}, low);
  }

  /// Moves the locks of two sectors (or none) down to a radius or below.
  bool lower_locks(const std::array<Sector_id, 2>& sectors, Number low) {
    for (const Sector_id s : sectors)
      while (s.is_valid() && corners_.sector(s).lock_radius > low)
        if (!lower_lock(s)) return false;
    return true;
  }

  /// Splits one leg alone: features far from the apex may be much smaller than the radius. Sectors next to it become
  /// ordinary domain there.
  bool split_interval(Leg_id l, Vertex_id x, Vertex_id y, const Point* want, Asker asker) {
    const Leg& leg = corners_.leg(l);
    const Number low = std::min(radius_on_leg(leg, x), radius_on_leg(leg, y));
    if (low == 0 || !lower_locks({leg.before, leg.after}, low)) return false;
    const Side side = state_.side_between(x, y);
    return !side.is_border() && split_subsegment(side, leg.edge, want, asker);
  }

  // ---- locks

  /// Moves the lock that the chord x-y is.
  Outcome split_chord(Vertex_id x, Vertex_id y) {
    Sector_id locked;
    bool is_elsewhere = false;
    corners_.find_sector_of_chord(mesh_, x, y, [&](Sector_id s) {
      if (!state_.owns(corners_.corner_of(corners_.sector(s))))
        is_elsewhere = true;
      else if (is_locked_by(corners_.sector(s), x, y))
        locked = s;
      return locked.is_valid();
    });
    if (locked.is_valid()) return outcome(lower_lock(locked));
    return is_elsewhere ? Outcome::DEFERRED : Outcome::REFUSED;
  }

  bool is_locked_by(const Sector& s, Vertex_id x, Vertex_id y) const {
    if (s.lock_radius <= 0) return false;
    const Vertex_id a = vertex_at(s.right, s.lock_radius), b = vertex_at(s.left, s.lock_radius);
    return (a == x && b == y) || (a == y && b == x);
  }

  /// The largest radius below `radius` at which both legs have a shell vertex; 0 if there is none. Almost always that
  /// is the first one tried. Locks move down, past each unmatched one once.
  Number shell_below_on_both(const Sector& sector, Number radius) const {
    const auto& shells = corners_.leg(sector.right).shells;
    for (auto s = shells.from(radius * (1 - same_radius)); s != shells.begin();) {
      --s;
      if (mesh_.is_used(s->second) && vertex_at(sector.left, s->first).is_valid()) return s->first;
    }
    return 0;
  }

  Vertex_id vertex_at(Leg_id l, const Number& radius) const { return corners_.vertex_at(mesh_, l, radius); }

  Number shell_below(Sector_id s, Number radius) const {
    const Number below = shell_below_on_both(corners_.sector(s), radius);
    return below > 0 ? below : Number(innermost_share * radius);
  }

  void lock_at_ring(Sector_id s) {
    Sector& sector = corners_.sector(s);
    lock(sector, corners_.corner(corners_.leg(sector.right).corner).radius);
  }

  /// Locks the chord at a shell's radius, if it is an edge of the mesh; otherwise the sector stays ordinary
  /// domain.
  void lock(Sector& s, Number radius) {
    s.lock_radius = 0;
    const Vertex_id a = vertex_at(s.right, radius), b = vertex_at(s.left, radius);
    if (!a.is_valid() || !b.is_valid() || a == b) return;
    const Side chord = state_.side_between(a, b);
    if (chord.is_border()) return;
    mesh_.constrain(chord);
    s.lock_radius = radius;
  }

  void release_chord(const Sector& s) {
    const Vertex_id a = vertex_at(s.right, s.lock_radius), b = vertex_at(s.left, s.lock_radius);
    if (!a.is_valid() || !b.is_valid() || state_.edges.carrying(mesh_, a, b).is_valid())
      return; // a chord that is an input edge stays
    const Side chord = state_.side_between(a, b);
    if (chord.is_border()) return;
    mesh_.release(chord);
    mesh_.is_dirty[a] = mesh_.is_dirty[b] = 1;
    const Side o = mesh_.across(chord);
    state_.doubtful_sides.push_back(chord);
    for (const Triangle_id t : {chord.triangle(), o.triangle()})
      if (t.is_valid() && !o.is_border()) state_.push_if_suspect(t);
  }

  /// Moves the lock of a sector down by one shell, making one where there is none.
  bool lower_lock(Sector_id s) {
    const Number radius = corners_.sector(s).lock_radius;
    if (radius <= 0) return false;
    const Number below = shell_below(s, radius);
    insert_shell(corners_.leg(corners_.sector(s).right).corner, below);
    return move_lock(s, below);
  }

  bool move_lock(Sector_id s, Number radius) {
    Sector& sector = corners_.sector(s);
    if (!vertex_at(sector.right, radius).is_valid() || !vertex_at(sector.left, radius).is_valid())
      return false;
    release_chord(sector);
    lock(sector, radius);
    state_.legalize();
    return true;
  }

  // ---- single points

  Vertex_id insert_between(Vertex_id x, Vertex_id y, Edge_id e, Point p) {
    const Side s = state_.side_between(x, y);
    return s.is_border() ? Vertex_id() : insert(s, e, p);
  }

  /// Puts p on the side; none if p is not strictly between its ends as seen from the apexes of its triangles, or not
  /// clear of what is outside.
  Vertex_id insert(Side s, Edge_id e, Point p) {
    if (mesh_.number_of_vertices() >= state_.most_vertices || state_.problem.is_kept(e)) return {};
    if (!keeps_orientation(mesh_, s, p) || !state_.problem.is_clear_of_outside(e, p)) return {};
    const Side o = mesh_.across(s);
    const Triangle_id across = o.is_border() ? Triangle_id() : o.triangle();
    if (!has_room(mesh_, {s.triangle(), across}, p, state_.bounds.least_squared_length)) return {};
    const Vertex_id v = mesh_.add_vertex(p, e);
    mesh_.insert_on_side(s.triangle(), s.slot(), v);
    state_.push_suspects_around(v);
    return v;
  }

  bool split_subsegment(Side s, Edge_id e, const Point* want, Asker asker) {
    const Vertex_id x = mesh_.source(s), y = mesh_.target(s);
    const Vertex_id apex = is_acute_apex(x) ? x : is_acute_apex(y) ? y : Vertex_id();
    if (apex.is_valid()) {
      const Number length = distance(x, y), whole = length_of_edge(e);
      if (length < 2 * least_share_of_leg() * whole) return false;
      const Number radius = power_of_two_at_most(length * 2 / 3); // of length, in (1/3, 2/3]
      if (insert_for(asker, s, e, point_on_edge(e, apex, radius / whole))) return true;
    }
    const double share = apex.is_valid() ? 0.5 : share_of_split(x, y, e, want);
    for (const double f : {share, 0.5, 0.4, 0.6, 0.45, 0.55})
      if (insert_for(asker, s, e, state_.point_on_edge_between(e, x, y, f))) return true;
    return false;
  }

  bool insert_for(Asker asker, Side s, Edge_id e, const Point& p) {
    return may_insert_for(asker, s, p) && insert(s, e, p).is_valid();
  }

  bool may_insert_for(Asker asker, Side s, const Point& p) const {
    return asker == Asker::ORDINARY || s.is_border() || edge_next_to(mesh_, s, p).is_border();
  }

  Number length_of_edge(Edge_id e) const {
    return length(Geometry::scaled_difference(state_.problem.input_point(state_.edges[e].a),
                                              state_.problem.input_point(state_.edges[e].b)));
  }

  /// The point at a share of an input edge, from the end that a vertex of the mesh is.
  Point point_on_edge(Edge_id e, Vertex_id end, Number share) const {
    const Vertex_id from = mesh_.input_number(end);
    return Geometry::between(state_.problem.input_point(from),
                             state_.problem.input_point(state_.edges.other_end(e, from)), share);
  }

  bool is_acute_apex(Vertex_id v) const {
    return mesh_.is_input(v) && corners_.is_acute[mesh_.input_number(v)] != 0;
  }
  bool is_leg_without_ring(Edge_id e, int end) const {
    const Vertex_id apex = end == 0 ? state_.edges[e].a : state_.edges[e].b;
    return corners_.is_acute[apex] != 0 && !corners_.legs_of_edge[e][std::size_t(end)].is_valid();
  }

  /// Where x-y is split, for a wish in its middle 30 percent.
  double share_of_split(Vertex_id x, Vertex_id y, Edge_id e, const Point* want) const {
    if (want == nullptr || is_leg_without_ring(e, 0) || is_leg_without_ring(e, 1)) return 0.5;
    const auto d = Geometry::scaled_difference(mesh_.point(y), mesh_.point(x));
    const double f = ratio(dot(Geometry::scaled_difference(*want, mesh_.point(x)), d), squared_length(d));
    return Geometry::short_share(std::min(0.65, std::max(0.35, f)));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SPLITTER_H
