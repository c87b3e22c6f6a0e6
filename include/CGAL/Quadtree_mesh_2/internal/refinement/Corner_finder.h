// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Finds the acute corners of the domain and the radii of their rings (first part of the paper's section 6:
// "cut off acute angles ... at a distance proportional to the vertex's nearest neighbor, so that cut-off
// triangles do not contain other parts of the input, two such triangles on the same edge match up, and the
// new cutting edges are not unnecessarily short").
//
// The radius is as large as that allows. It is the shortest leg (half of it if the other end has a ring,
// too), or 0.6 of the distance to what intrudes into the corner's sectors. Intruders are found in the
// constrained Delaunay triangulation, from the apex outward in sight of it. So nothing is scanned, and
// nothing behind a constraint counts. O(n + triangles of the lopped sectors within the ring), and O(k log k)
// for k sectors at a vertex.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_CORNER_FINDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_CORNER_FINDER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Id_set.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel_sort.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Size_estimate.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Corner_finder {
public:
  using Number = typename Geometry::Number;
  using Vector = Basic_vector<Number>;
  using Leg = typename Acute_corners<Geometry>::Leg;
  using Corner = typename Acute_corners<Geometry>::Corner;

  Corner_finder(Meshing_state<Geometry>& state, const Acute_starts& starts)
      : state_(state), mesh_(state.mesh), corners_(state.corners), starts_(starts) {}

  /// Fills in `state.corners`; the mesh is the domain's first triangulation, without Steiner points.
  void run() {
    corners_.prepare(state_.edges, mesh_.number_of_vertices());
    collect_sectors();
    for (std::size_t i = 0; i < acute_.size();) {
      std::size_t j = i;
      bool is_any_lopped = false;
      for (; j < acute_.size() && acute_[j].apex == acute_[i].apex; ++j)
        is_any_lopped |= is_lopped(acute_[j]);
      if (is_any_lopped) link_sectors(i, j);
      i = j;
    }
    corners_.list_legs();
    is_visited_.resize(mesh_.triangles.size());
    for (const Corner_id c : corners_.corners.ids()) set_radius(c);
  }

private:
  /// A domain sector below 60 degrees: between two edges, counterclockwise; `first` is its clockwise-most
  /// triangle.
  struct Acute_sector {
    double angle;
    Vertex_id apex;
    Edge_id right, left;
    Triangle_id first;
  };

  using Leg_of_sector = std::pair<Edge_id, std::size_t>;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  /// A ring is cut at this share of the distance to what intrudes.
  static constexpr double clear_share = 0.6;
  /// What is as far as the ring up to this share of its radius does not intrude.
  static constexpr double rounding = 1e-9;

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Acute_corners<Geometry>& corners_;
  const Acute_starts& starts_;
  std::vector<Acute_sector> acute_;
  Indexed_vector<Corner_id, std::vector<Triangle_id>>
      first_triangles_; // where the sectors of all legs of a corner begin
  std::vector<Leg_of_sector> by_right_, by_left_;
  std::vector<Triangle_id> stack_;
  Id_set<Triangle_id> is_visited_; // those of the sector at hand
  std::vector<Triangle_id> visited_;

  Vector direction(Vertex_id from, Vertex_id to) const {
    return Geometry::scaled_difference(mesh_.point(to), mesh_.point(from));
  }
  Number distance(Vertex_id a, Vertex_id b) const { return length(direction(a, b)); }

  void collect_sectors() {
    append_by_blocks<ConcurrencyTag>(
        acute_, mesh_.triangles.size(),
        [this](std::size_t begin, std::size_t end, std::vector<Acute_sector>& found) {
          for_each_marked_slot([this](Triangle_id t) { return starts_.slots_of_triangle[t]; }, {begin, end},
                               [&](Side start) { add_sector(start.triangle(), start.slot(), found); });
        });
    for (const Acute_sector& s : acute_) corners_.is_acute[s.apex] = 1;
    sort<ConcurrencyTag>(acute_.begin(), acute_.end(),
                         [](const Acute_sector& a, const Acute_sector& b) { return a.apex < b.apex; });
  }

  /// Appends the sector whose clockwise-most triangle is t, at its vertex k, if it is acute.
  void add_sector(Triangle_id first, int k, std::vector<Acute_sector>& sectors) const {
    const Vertex_id apex = mesh_.triangle(first).v[k], right = mesh_.triangle(first).v[next_slot[k]];
    const Vector d = direction(apex, right);
    Triangle_id t = first;
    int i = k;
    while (!mesh_.triangle(t).side[next_slot[i]].is_constrained()) {
      // an acute sector's triangles all begin acute: give up early
      if (!is_below_60(d, direction(apex, mesh_.triangle(t).v[previous_slot[i]]))) return;
      const Side o = mesh_.triangle(t).side[next_slot[i]];
      t = o.triangle(), i = next_slot[o.slot()];
    }
    const Vertex_id left = mesh_.triangle(t).v[previous_slot[i]];
    const Vector e = direction(apex, left);
    if (left == right || !is_below_60(d, e) || mesh_.orientation(apex, right, left) <= 0) return;
    const Number area2 =
        Geometry::doubled_area_of_flat(d, e, mesh_.point(apex), mesh_.point(right), mesh_.point(left));
    const Number scale = power_of_two_at_most(dot(d, e)); // of the legs' squares, which may be beyond doubles
    sectors.push_back({std::atan2(ratio(area2, scale), ratio(dot(d, e), scale)), apex,
                       state_.edges.between(apex, right), state_.edges.between(apex, left), first});
  }

  static bool is_below_60(Vector d, Vector e) {
    const Number c = dot(d, e);
    return c > 0 && c * c > 0.25 * squared_length(d) * squared_length(e);
  }

  bool is_lopped(const Acute_sector& s) const { return s.angle < lopped_factor * state_.bounds.angle; }

  /// Joins the sectors [i, j), all at one vertex, to corners: maximal runs that share legs. Only a corner
  /// with a lopped sector is kept.
  void link_sectors(std::size_t i, std::size_t j) {
    sort_by_leg(i, j, &Acute_sector::right, by_right_);
    sort_by_leg(i, j, &Acute_sector::left, by_left_);
    std::vector<char> is_taken(j - i, 0);
    for (std::size_t s = i; s < j; ++s) {
      if (is_taken[s - i] != 0) continue;
      std::size_t first = s; // go clockwise to the run's first sector, or once around
      for (std::size_t p = sector_at(by_left_, acute_[s].right); p != none && p != s;) {
        first = p;
        p = sector_at(by_left_, acute_[p].right);
      }
      std::vector<std::size_t> run;
      for (std::size_t p = first; p != none && is_taken[p - i] == 0;
           p = sector_at(by_right_, acute_[p].left)) {
        is_taken[p - i] = 1;
        run.push_back(p);
      }
      add_corner(run);
    }
  }

  /// Sorts the sectors [i, j) by one of their legs. An edge is the right leg of one sector at a vertex, and
  /// the left leg of one.
  void sort_by_leg(std::size_t i, std::size_t j, Edge_id Acute_sector::*leg,
                   std::vector<Leg_of_sector>& sorted) const {
    sorted.clear();
    for (std::size_t s = i; s < j; ++s) sorted.push_back({acute_[s].*leg, s});
    std::sort(sorted.begin(), sorted.end());
  }

  static std::size_t sector_at(const std::vector<Leg_of_sector>& sorted, Edge_id leg) {
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), Leg_of_sector{leg, 0});
    return found != sorted.end() && found->first == leg ? found->second : none;
  }

  void add_corner(const std::vector<std::size_t>& run) {
    if (std::none_of(run.begin(), run.end(), [this](std::size_t s) { return is_lopped(acute_[s]); })) return;
    Corner corner;
    corner.apex = acute_[run.front()].apex;
    corner.least_angle = acute_[run.front()].angle;
    const Corner_id id = corners_.corners.end_id();
    const auto add_leg = [&](Edge_id e) {
      const Vertex_id far = state_.edges.other_end(e, corner.apex);
      corner.legs.push_back(corners_.add_leg(
          {id, e, corner.apex, far, distance(corner.apex, far), {}, {}, {}, {}, corner.apex}));
    };
    first_triangles_.emplace_back();
    add_leg(acute_[run.front()].right);
    for (const std::size_t s : run) {
      const bool closes = s == run.back() && run.size() > 1 && acute_[s].left == acute_[run.front()].right;
      const Leg_id right = corner.legs.back();
      if (!closes) add_leg(acute_[s].left);
      const Leg_id left = closes ? corner.legs.front() : corner.legs.back();
      corner.angles.push_back(acute_[s].angle);
      corner.least_angle = std::min(corner.least_angle, acute_[s].angle);
      first_triangles_.back().push_back(acute_[s].first);
      if (is_lopped(acute_[s])) corner.sectors.push_back(add_lopped_sector(right, left, acute_[s].angle));
    }
    corners_.corners.push_back(std::move(corner));
  }

  Sector_id add_lopped_sector(Leg_id right, Leg_id left, double angle) {
    const Number sine = std::sin(exempt_share * angle);
    const Sector_id id = corners_.sectors.add({right, left, angle, sine * sine * (1 + 2e-9), 0});
    corners_.leg(right).after = id;
    corners_.leg(left).before = id;
    return id;
  }

  void set_radius(Corner_id c) {
    Corner& corner = corners_.corner(c);
    Number r = corners_.leg(corner.legs.front()).length;
    for (const Leg_id l : corner.legs) {
      const Leg& leg = corners_.leg(l);
      const auto& at = corners_.legs_of_edge[leg.edge];
      const bool has_ring_at_far_end = at[0].is_valid() && at[1].is_valid();
      r = std::min<Number>(r, has_ring_at_far_end ? leg.length / 2 : leg.length);
    }
    for (const Triangle_id t : first_triangles_[c]) r = radius_clear_of_intruders(corner.apex, t, r);
    corner.radius = r;
  }

  /// The radius reduced to 0.6 of the distance to what is nearer than it in the sector that begins with
  /// triangle t.
  Number radius_clear_of_intruders(Vertex_id apex, Triangle_id first, Number r) {
    stack_.assign(1, first);
    const Vertex_id right =
        mesh_.triangle(first).v[next_slot[Kernel_mesh<Geometry>::slot_of(mesh_.triangle(first), apex)]];
    const Vertex_id left = left_end(apex, first);
    while (!stack_.empty()) {
      const Triangle_id t = stack_.back();
      stack_.pop_back();
      if (is_visited_.has(t)) continue;
      is_visited_.add(t), visited_.push_back(t);
      const auto& q = mesh_.triangle(t);
      for (int k = 0; k < 3; ++k) {
        if (q.v[k] != apex && q.v[k] != right && q.v[k] != left)
          r = clear_of_vertex(apex, right, left, q.v[k], r);
        const Vertex_id a = q.v[next_slot[k]], b = q.v[previous_slot[k]];
        if (a == apex || b == apex) {
          if (!q.side[k].is_constrained()) stack_.push_back(q.side[k].triangle());
          continue;
        }
        const Number d = distance_to_segment(apex, a, b);
        if (d >= r * (1 - rounding)) continue;
        if (!q.side[k].is_constrained())
          stack_.push_back(q.side[k].triangle());
        else if (a != right && a != left && b != right && b != left)
          r = clear_share * d;
      }
    }
    for (const Triangle_id t : visited_) is_visited_.remove(t);
    visited_.clear();
    return r;
  }

  Vertex_id left_end(Vertex_id apex, Triangle_id t) const {
    for (;;) {
      const auto& r = mesh_.triangle(t);
      const int i = Kernel_mesh<Geometry>::slot_of(r, apex);
      if (r.side[next_slot[i]].is_constrained()) return r.v[previous_slot[i]];
      t = r.side[next_slot[i]].triangle();
    }
  }

  /// A vertex intrudes if it lies within r, or so near the chord between the legs that it sees it under more
  /// than 105 degrees.
  Number clear_of_vertex(Vertex_id apex, Vertex_id right, Vertex_id left, Vertex_id v, Number r) const {
    const Number d = distance(apex, v);
    if (clear_share * d >= r) return r;
    if (d < r * (1 - rounding)) return clear_share * d;
    const Vector p = direction(apex, v), a = direction(apex, right), b = direction(apex, left);
    const Vector pa = (r / length(a)) * a - p, pb = (r / length(b)) * b - p;
    const Number c = dot(pa, pb);
    constexpr double cosine2 = 0.067; // of 105 degrees, squared
    return c < 0 && c * c > cosine2 * squared_length(pa) * squared_length(pb) ? Number(clear_share * d) : r;
  }

  Number distance_to_segment(Vertex_id p, Vertex_id a, Vertex_id b) const {
    const Vector ab = direction(a, b), ap = direction(a, p);
    const Number f = std::min(1.0, std::max(0.0, ratio(dot(ap, ab), squared_length(ab))));
    return length(ap - f * ab);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_CORNER_FINDER_H
