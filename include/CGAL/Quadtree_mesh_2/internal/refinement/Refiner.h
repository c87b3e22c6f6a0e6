// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Refinement on demand: one worklist of bad triangles, the sharpest first, one new vertex at a time. This is
// constrained Delaunay refinement by off-centers snapped to quadtree corners.
//
// For each bad triangle
//   a. one of its Steiner vertices is relocated so that its whole star meets the bound, if that is possible;
//   b. otherwise one vertex is inserted. It goes to the quadtree corner next to the triangle's off-center (Uengoer,
//      "Off-centers", 2004), of cells whose side is the power of two in (s/8, s/4], where s is the shortest edge.
//      If a constrained edge is in the way, or would be seen from there under more than 120 degrees (180 less twice
//      the bound, where that is less), the vertex goes on that edge instead (Splitter.h).
// Triangles are taken up by stretches of the mesh, in their order, and all that comes of a stretch is done before the
// next one: so memory is used while it is at hand. Within a stretch the sharpest is first (Worklist.h).
// Where an edge that gets no vertices is in the way, the vertex goes nearer to the triangle, or the triangle is left.
// The other rule (Refinement_rule) puts the vertex at the off-center itself, and the shortest edge is first.
//
// Flips restore the Delaunay property locally, and triangles that they make bad join the list. At the end the
// list is empty, which proves the bound, triangle by triangle.
//
// Termination is that of off-center refinement with dyadic shells and locked corners. It is established
// numerically for bounds up to 20.7 degrees, and a budget always enforces it. In a block of a mesh, anything
// that would reach beyond a seam is deferred. Expected O(k) time for k vertices made.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_REFINER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_REFINER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Progress.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Relocator.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Cavity.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/edge_next_to.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/least_edge.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/walk.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

enum class Refinement_end { DONE, CANCELLED, OUT_OF_BUDGET };

/// How large a mesh may become. Thin strips have as many vertices as triangles, other meshes half as many.
struct Mesh_limit {
  static constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  std::size_t vertices;
  std::size_t triangles = any;
};

template <class Geometry>
class Refiner {
public:
  using Point = typename Geometry::Point;
  using Number = typename Geometry::Number;
  using Vector = Basic_vector<Number>;
  using Shape = typename Kernel_mesh<Geometry>::Shape;

  Refiner(Meshing_state<Geometry>& state, Splitter<Geometry>& splitter)
      : state_(state), mesh_(state.mesh), splitter_(splitter), relocator_(state), cavity_(state.mesh),
        apex_height_(off_center_share * 0.5 / std::tan(state.bounds.angle / 2)),
        cosine2_of_encroachment_(state.encroachment == Encroachment::CIRCLES
                                     ? 0
                                     : std::min(cosine2_of_encroachment(state.leg_rule, state.bounds.angle),
                                                state.bounds.cosine2_of_widest)) {}

  /// Has all triangles looked at that may be bad. Those of the bulk are not.
  void push_all() {
    forget_rest(); // perhaps of another mesh
    next_to_push_ = Triangle_id(0), end_to_push_ = mesh_.triangles.end_id();
  }

  /// To be called when the mesh has become another one.
  void forget_rest() {
    refused_.clear(), blocked_.clear();
    rounds_of_blocked_ = 0;
    next_to_push_ = end_to_push_ = Triangle_id(0);
  }

  /// Processes the list until it is empty. Asks `shall_go_on()` every 4096 steps. Where the mesh has
  /// reached the limit, no vertex is inserted. What is not done then is done by the next run.
  template <class Continue>
  Refinement_end run(Mesh_limit limit, Continue&& shall_go_on) {
    state_.most_vertices = limit.vertices;
    for (std::size_t step = 1; !state_.worklist.is_empty() || takes_up_stretch() || takes_up_refused();
         ++step) {
      if (is_time_to_ask(step) && !shall_go_on()) return Refinement_end::CANCELLED;
      const Triangle_id t = state_.worklist.pop();
      if (!mesh_.is_alive(t)) continue;
      mesh_.prefetch_neighbors(t); // a vertex of it has to go, or another to come: both change what is around
      const Shape shape = mesh_.shape(mesh_.triangle(t));
      if (!state_.is_bad(t, shape) || state_.is_outdated(shape)) continue;
      if (mesh_.number_of_vertices() >= limit.vertices || mesh_.number_of_triangles() >= limit.triangles) {
        state_.push(t, shape);
        return Refinement_end::OUT_OF_BUDGET;
      }
      if (relocate_a_vertex_of(t, shape)) continue;
      refine(t, shape);
    }
    return Refinement_end::DONE;
  }

  /// Tries to cure a triangle whose greatest angle is above the bound: by another place for a vertex of it, else by one
  /// more vertex. Triangles that this makes bad join the list; those too wide do not.
  /// \pre the mesh is not beyond its limit of vertices
  void cure_wide(Triangle_id t) {
    const auto r = mesh_.triangle(t);
    const Shape shape = mesh_.shape(r);
    if (state_.encroachment != Encroachment::CIRCLES)
      for (const int k : {shape.slot_of_longest(), shape.slot_of_shortest(), shape.slot_of_middle()})
        if (!mesh_.is_input(r.v[k]) && relocator_.relocate_for_shape(r.v[k])) return;
    if (splitter_.open_lock_around(t) == Outcome::REFUSED) insert_vertex_for(t, shape);
    state_.legalize();
  }

  /// The edge that gets no vertices and is in the way of what would cure a bad triangle; none if no such edge is.
  Edge_id kept_edge_in_the_way(Triangle_id t) {
    if (!state_.problem.keeps_edges()) return {};
    const auto r = mesh_.triangle(t);
    const Shape s = mesh_.shape(r);
    const int k = s.slot_of_shortest();
    const Point q = place_at(center_for(r, s, k), r, s, k);
    const Walk_end end = walk_in_sight(mesh_, t, q, longest_walk());
    if (end.is_broken_off) return {};
    const Side side = side_in_the_way(end, q);
    if (!side.is_border()) return state_.kept_edge(side);
    const Side harmed = look_around(end.triangle, q).harmed;
    return harmed.is_border() ? Edge_id() : state_.kept_edge(harmed);
  }

  /// Puts what a run that was given up did not look at on the list of the state.
  void push_rest() {
    while (next_to_push_ < end_to_push_) push_stretch();
  }

private:
  /// Of the height of a place over the shortest edge: where else a vertex may go.
  static constexpr double shares_of_height[] = {0.8, 0.65, 0.5, 0.4};
  /// The off-center sees the shortest edge under an angle a little wider than the bound.
  static constexpr double off_center_share = 0.95;
  /// Of the angle from which on a vertex must not see an edge. A vertex that sees it under more than 180 degrees less
  /// twice the bound makes a triangle below the bound on it. For bounds above 30 degrees, 120 degrees are more than
  /// that: next to a corner, such triangles would follow each other, each similar to the one before.
  static double cosine2_of_encroachment(Leg_rule rule, double bound) {
    constexpr double cosine2_of_120_degrees = 0.25;
    const double cosine2_of_lens = std::cos(2 * bound) * std::cos(2 * bound);
    return rule == Leg_rule::FREE ? cosine2_of_lens : std::min(cosine2_of_lens, cosine2_of_120_degrees);
  }
  /// Once this many vertices were inserted for a triangle slot, its new vertices stay. So relocation cannot
  /// cycle.
  static constexpr unsigned char patience = 3;
  /// How often triangles are tried again that an edge without vertices was in the way of. What is around them has
  /// hardly changed.
  static constexpr int most_rounds_of_blocked = 8;
  /// No vertex is relocated more often, so relocations without insertions end.
  static constexpr unsigned char most_relocations = 32;

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Splitter<Geometry>& splitter_;
  Relocator<Geometry> relocator_;
  Cavity<Geometry> cavity_;
  double apex_height_; // of the off-center's triangle over a unit edge
  double cosine2_of_encroachment_;
  Uninitialized_indexed_vector<Triangle_id, unsigned char> trials_;    // vertices inserted for a triangle
  Uninitialized_indexed_vector<Vertex_id, unsigned char> relocations_; // of a vertex
  std::vector<Triangle_id> refused_, blocked_;
  int rounds_of_blocked_ = 0;
  Triangle_id next_to_push_{0}, end_to_push_{0};
  std::size_t vertices_when_taken_up_ = 0; // the refused ones

  /// In a Delaunay mesh the place for a triangle is at least its shortest edge away from all vertices, and
  /// edges in the way are not much shorter. Next to the seams of a block flips are missing. Edges shorter
  /// than this share (squared) have to wait there.
  static constexpr double least_distance2 = 0.25;

  /// A walk through a fan to the edge behind it is as long as the fan, and the vertex made there halves the fan. But
  /// where the edge is beyond a seam, all triangles of the fan would walk to the seam in vain. In a block, they wait
  /// after this many steps. Walks in coastlines take at most 15.
  static constexpr std::size_t longest_walk_in_block = 64;
  /// Elsewhere a walk that meets no triangle twice ends.
  std::size_t longest_walk() const {
    return state_.is_block() ? longest_walk_in_block : mesh_.triangles.size();
  }

  /// Puts the triangles of the next stretch on the list that may be bad.
  void push_stretch() {
    constexpr std::uint32_t slots_of_stretch = 1024;
    const Triangle_id end = std::min(end_to_push_, Triangle_id(next_to_push_.value() + slots_of_stretch));
    const auto& bulk = state_.bulk;
    push_suspects(next_to_push_, std::min(end, bulk.first_triangle));
    push_suspects(std::max(next_to_push_, bulk.end_of_triangles), end);
    next_to_push_ = end;
  }

  /// Of the triangles from `begin` on, before `end`; there may be none.
  void push_suspects(Triangle_id begin, Triangle_id end) {
    if (begin < end) mesh_.for_each_alive({begin, end}, [this](Triangle_id t) { state_.push_if_suspect(t); });
  }

  /// Goes on to the first stretch that has something to do; false if there is none.
  bool takes_up_stretch() {
    while (state_.worklist.is_empty() && next_to_push_ < end_to_push_) push_stretch();
    return !state_.worklist.is_empty();
  }

  /// Puts triangles back on the list that could not be cured before, if vertices were inserted since. The
  /// thin triangle may be gone in which a rounded point would have been beside its edge. False if none of them is left.
  bool takes_up_refused() {
    if (refused_.empty() && blocked_.empty()) return false;
    if (mesh_.number_of_vertices() == vertices_when_taken_up_) return false;
    vertices_when_taken_up_ = mesh_.number_of_vertices();
    if (rounds_of_blocked_++ < most_rounds_of_blocked)
      refused_.insert(refused_.end(), blocked_.begin(), blocked_.end());
    blocked_.clear();
    for (const Triangle_id t : refused_)
      if (mesh_.is_alive(t)) state_.push(t);
    refused_.clear();
    return !state_.worklist.is_empty();
  }

  bool relocate_a_vertex_of(Triangle_id t, const Shape& shape) {
    const auto r = mesh_.triangle(t);
    if (!state_.bounds.is_sharp(shape)) return false; // too large: a new vertex is needed anyway
    if (state_.encroachment == Encroachment::CIRCLES) return false;
    for (const Vertex_id v : r.v) {
      if (mesh_.is_input(v) || number_of_relocations(v) >= most_relocations) continue;
      if (!relocator_.relocate(v)) continue;
      ++number_of_relocations(v);
      return true;
    }
    return false;
  }

  unsigned char& number_of_relocations(Vertex_id v) {
    relocations_.make_room_for(v, 0);
    return relocations_[v];
  }

  /// Inserts one vertex for the bad triangle t. Puts t back on the list if it is still bad.
  void refine(Triangle_id t, const Shape& shape) {
    const Vertex_id end_before = mesh_.points.end_id();
    Outcome outcome = splitter_.open_lock_around(t);
    if (outcome == Outcome::REFUSED) outcome = insert_vertex_for(t, shape);
    const bool may_go_later = outcome == Outcome::REFUSED && state_.is_block();
    if (outcome == Outcome::BLOCKED) return blocked_.push_back(t);
    if (outcome == Outcome::DEFERRED || may_go_later) return state_.deferred.push_back(t);
    settle_new_vertices(t, end_before);
    if (outcome == Outcome::REFUSED) return refused_.push_back(t);
    if (mesh_.is_alive(t)) state_.push_if_suspect(t);
  }

  void settle_new_vertices(Triangle_id t, Vertex_id end_before) {
    trials_.make_room_for(t, 0);
    unsigned char& trials = trials_[t];
    if (trials < patience) ++trials;
    if (trials < patience) return;
    for (const Vertex_id v : Id_range<Vertex_id>(end_before, mesh_.points.end_id()))
      number_of_relocations(v) = most_relocations;
  }

  /// Refused if nothing could be inserted: the triangle is as small as coordinates allow.
  /// Blocked if an edge that gets no vertices is in the way.
  Outcome insert_vertex_for(Triangle_id t, const Shape& s) {
    const auto r = mesh_.triangle(t);
    const int k = s.slot_of_shortest();
    if (!Geometry::is_resolved(mesh_.point(r.v[next_slot[k]]), s.l[k])) return Outcome::REFUSED;
    const Vector center = center_for(r, s, k);
    const Point q = place_at(center, r, s, k);
    const Walk_end end = walk_in_sight(mesh_, t, q, longest_walk());
    if (end.is_broken_off) return state_.is_block() ? Outcome::DEFERRED : Outcome::REFUSED;
    const Side in_the_way = side_in_the_way(end, q);
    const Number distance2 = least_distance2 * s.l[k];
    if (!in_the_way.is_border()) {
      if (state_.is_kept(in_the_way)) return insert_before_kept_edge(t, s, center);
      return is_too_short(in_the_way, distance2)
                 ? Outcome::DEFERRED
                 : splitter_.split(in_the_way.triangle(), in_the_way.slot(), &q,
                                   is_within_rounding<Geometry>(s, q) ? Asker::NARROW : Asker::ORDINARY);
    }
    if (is_too_near(end.triangle, q, distance2)) return Outcome::DEFERRED;
    const auto found = look_around(end.triangle, q);
    if (!found.harmed.is_border()) return insert_before_kept_edge(t, s, center);
    return found.has_seam ? Outcome::DEFERRED : insert(end.triangle, q);
  }

  /// What has to be split before a vertex can be at q; the border if nothing has to.
  Side side_in_the_way(const Walk_end& end, const Point& q) const {
    return end.is_blocked() ? Side(end.triangle, end.blocked_slot) : most_encroached_side(end.triangle, q);
  }

  /// Where an edge that gets no vertices is in the way, the vertex goes nearer to the shortest edge, on the same
  /// bisector, to the first place that harms no edge. There it makes a triangle within the bound with the shortest
  /// edge, too. It comes no nearer to other vertices than the shortest edge is long, and no other edge is split for it:
  /// so such insertions end.
  /// \param center where the vertex should have gone, from the first end of the shortest edge
  Outcome insert_before_kept_edge(Triangle_id t, const Shape& s, const Vector& center) {
    // for one that is only too large, a nearer place may be too near to other vertices
    if (!state_.bounds.is_sharp(s)) return Outcome::BLOCKED;
    const auto r = mesh_.triangle(t);
    const int k = s.slot_of_shortest();
    const Point& a = mesh_.point(r.v[next_slot[k]]);
    const Vector middle = 0.5 * Geometry::scaled_difference(mesh_.point(r.v[previous_slot[k]]), a);
    bool may_go_later = false;
    for (const double share : shares_of_height) {
      const Vector offset = middle + share * (center - middle);
      if (squared_length(offset) < s.l[k]) break;
      const Point q = Geometry::translate(a, offset);
      const Walk_end end = walk_in_sight(mesh_, t, q, longest_walk());
      if (end.is_broken_off || !side_in_the_way(end, q).is_border()) continue;
      const auto found = look_around(end.triangle, q);
      if (!found.harmed.is_border()) continue;
      may_go_later |= found.has_seam;
      if (found.has_seam || is_too_near(end.triangle, q, least_distance2 * s.l[k])) continue;
      if (insert(end.triangle, q) == Outcome::CHANGED) return Outcome::CHANGED;
    }
    return may_go_later ? Outcome::DEFERRED : Outcome::BLOCKED;
  }

  /// The off-center of a triangle with an angle below the bound; of a triangle that is only too large, its
  /// circumcenter.
  /// \returns the way to it from the first end of the shortest edge
  Vector center_for(const typename Kernel_mesh<Geometry>::Triangle& r, const Shape& s, int k) const {
    const Point& a = mesh_.point(r.v[next_slot[k]]);
    const Point& b = mesh_.point(r.v[previous_slot[k]]);
    const Point& c = mesh_.point(r.v[k]);
    const Vector ab = Geometry::scaled_difference(b, a), ac = Geometry::scaled_difference(c, a),
                 middle = 0.5 * ab;
    const Number lb = squared_length(ab), lc = squared_length(ac), f = 0.5 / s.area2;
    Vector center = {f * (ac.y * lb - ab.y * lc), f * (ab.x * lc - ac.x * lb)};
    if (state_.bounds.is_sharp(s)) {
      const Vector off_center = middle + apex_height_ * Vector{-ab.y, ab.x};
      // not >= : the area of a triangle that is too flat for doubles gives a center that is no number
      if (!(squared_length(off_center - middle) >= squared_length(center - middle))) center = off_center;
    }
    return center;
  }

  /// The place at the end of that way, or the quadtree corner next to it, as is the rule.
  Point place_at(const Vector& center, const typename Kernel_mesh<Geometry>::Triangle& r, const Shape& s,
                 int k) const {
    const Point& a = mesh_.point(r.v[next_slot[k]]);
    const Point& b = mesh_.point(r.v[previous_slot[k]]);
    const Point& c = mesh_.point(r.v[k]);
    const Point q = Geometry::translate(a, center);
    if (state_.refinement_rule == Refinement_rule::OFF_CENTERS) return q;
    using std::sqrt;
    const Point corner = Geometry::nearest_corner(q, power_of_two_at_most(0.25 * sqrt(s.l[k])));
    const Basic_in_circle<Number> test(Geometry::scaled_difference(a, corner),
                                       Geometry::scaled_difference(b, corner),
                                       Geometry::scaled_difference(c, corner));
    return test.is_certainly_inside() ? corner : q;
  }

  // ---- edges that get no vertices

  /// What is around a place.
  struct Surroundings {
    Side harmed = Side::border(); ///< the first kept side that a vertex there would harm; else the border
    bool has_seam = false;        ///< beyond which there may be one
  };

  Surroundings look_around(Triangle_id t, const Point& q) {
    Surroundings found;
    if (!state_.problem.keeps_edges()) return found;
    cavity_.visit_sides({t}, q, [&](Side s) {
      const Side o = mesh_.across(s);
      if (!o.is_constrained()) return true;
      const bool is_kept = state_.is_kept(s);
      found.has_seam |= o.is_seam() && !is_kept;
      if (is_kept && would_harm(q, s)) found.harmed = s;
      return found.harmed.is_border();
    });
    return found;
  }

  /// Whether a vertex at q would make a triangle with a kept side that is below the bound and obtuse at q. Nothing
  /// cures such a triangle: its circumcenter lies beyond the side.
  bool would_harm(const Point& q, Side s) const {
    const Point &a = mesh_.point(mesh_.source(s)), &b = mesh_.point(mesh_.target(s));
    if (dot(Geometry::scaled_difference(a, q), Geometry::scaled_difference(b, q)) >= 0) return false;
    return state_.encroachment == Encroachment::CIRCLES || state_.bounds.is_sharp(mesh_.shape(a, b, q));
  }

  bool is_too_short(Side s, Number distance2) const {
    return state_.is_block() && squared_length(Geometry::scaled_difference(
                                    mesh_.point(mesh_.source(s)), mesh_.point(mesh_.target(s)))) < distance2;
  }

  /// Whether a vertex of t, or one opposite to it, is too near to q.
  bool is_too_near(Triangle_id t, const Point& q, Number distance2) const {
    if (!state_.is_block()) return false;
    const auto is_near = [&](Vertex_id v) {
      return squared_length(Geometry::scaled_difference(mesh_.point(v), q)) < distance2;
    };
    const auto& r = mesh_.triangle(t);
    for (int k = 0; k < 3; ++k)
      if (is_near(r.v[k]) || (!r.side[k].is_constrained() && is_near(mesh_.opposite(r.side[k])))) return true;
    return false;
  }

  /// The constrained side, of t or of a triangle next to it, that q sees under the widest angle above that of
  /// encroachment; else the border. Those that get no vertices have `would_harm()`.
  Side most_encroached_side(Triangle_id t, const Point& q) const {
    Side best = Side::border();
    double widest = cosine2_of_encroachment_;
    const auto look = [&](Side s) {
      const Vector x = Geometry::scaled_difference(mesh_.point(mesh_.source(s)), q);
      const Vector y = Geometry::scaled_difference(mesh_.point(mesh_.target(s)), q);
      const Number d = dot(x, y);
      if (d >= 0) return;
      const double cosine2 = ratio(d * d, squared_length(x) * squared_length(y));
      if (cosine2 > widest && !state_.is_kept(s)) widest = cosine2, best = s;
    };
    for (int k = 0; k < 3; ++k) {
      const Side o = mesh_.triangle(t).side[k];
      if (o.is_constrained()) {
        look(Side(t, k));
        continue;
      }
      for (const int j : {next_slot[o.slot()], previous_slot[o.slot()]})
        if (mesh_.triangle(o.triangle()).side[j].is_constrained()) look(Side(o.triangle(), j));
    }
    return best;
  }

  /// Puts a vertex at q, where a walk found that it is in t or on one of its sides, exactly: so all triangles made are
  /// counterclockwise.
  Outcome insert(Triangle_id t, const Point& q) {
    const auto& r = mesh_.triangle(t);
    int on_slot = -1, number_on = 0;
    for (int k = 0; k < 3; ++k)
      if (Geometry::orientation(mesh_.point(r.v[next_slot[k]]), mesh_.point(r.v[previous_slot[k]]), q) == 0)
        on_slot = k, ++number_on;
    if (on_slot >= 0 && r.side[on_slot].is_seam()) return Outcome::DEFERRED;
    if (number_on > 1 || (on_slot >= 0 && r.side[on_slot].is_constrained())) return Outcome::REFUSED;
    if (!has_room(mesh_, {t}, q, state_.bounds.least_squared_length)) return Outcome::REFUSED;
    const Vertex_id v = mesh_.add_vertex(q, free_vertex);
    if (on_slot >= 0)
      mesh_.insert_on_side(t, on_slot, v);
    else
      mesh_.insert_in_triangle(t, v);
    state_.push_suspects_around(v);
    return Outcome::CHANGED;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_REFINER_H
