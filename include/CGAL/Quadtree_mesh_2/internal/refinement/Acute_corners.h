// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The acute corners of the input: which legs meet in them, at which radii the legs are cut, and which
// triangles they excuse.
//
// A sector is the part of the domain between two consecutive input edges, its legs, at an input vertex, its
// apex. Sectors below 60 degrees that share legs form a corner. A sector below `lopped_factor` times the
// bound is lopped: no free point enters it within its lock radius. All legs of a corner with a lopped sector
// are cut at the same radii, the shells. So a lopped sector is a stack of isosceles trapezoids on one
// isosceles triangle at the apex. The apex angle is never split.
//
// A triangle below the bound is exempt if all its vertices lie on the two legs of a lopped sector of angle
// phi and its least angle is at least 0.9 phi. No other triangle is. For consecutive shells r < R <= 1.9 r,
// the least angle of a trapezoid's triangles is atan(sin(phi) / (R/r - cos(phi))). This is at least min(0.9
// phi, 20.7 degrees).
//
// Data and queries only. Corner_finder.h finds the corners, and Splitter.h cuts the legs. O(log degree) for a
// query.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_ACUTE_CORNERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_ACUTE_CORNERS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Sparse_values.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Shells.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Sectors below this multiple of the bound are lopped (numerically established: above it refinement ends
/// without).
constexpr double lopped_factor = 1.6;
/// An exempt triangle keeps this share of its sector's angle.
constexpr double exempt_share = 0.9;
/// Radii of a shell on several legs come from one number, so they are the same to units in the last place. Other shells
/// may be nearly as near, if features beside a leg's end are as small as the distance between legs there.
constexpr double same_radius = 0x1p-50;

using Leg_id = Index<struct Leg_tag>;
using Sector_id = Index<struct Sector_tag>;
using Corner_id = Index<struct Corner_tag>;

template <class Number>
struct Basic_leg {
  Corner_id corner;
  Edge_id edge;
  Vertex_id apex, far; ///< input numbers
  Number length;
  Sector_id before, after; ///< lopped sectors clockwise and counterclockwise of it
  /// Where it is cut. A far end may stand in for a ring vertex that would come close to it.
  Shells<Number> shells;
  /// The vertex at the corner's radius; the far end or another ring's vertex may stand in for one that would
  /// come close to it.
  Vertex_id ring;
  Vertex_id apex_vertex; ///< the apex in the mesh (or block) at hand, as are `ring` and those of `shells`

  template <class Archive>
  void transfer(Archive& archive) {
    archive(corner, edge, apex, far, length, before, after, shells, ring, apex_vertex);
  }
};

template <class Number>
struct Basic_sector {
  Leg_id right, left; ///< counterclockwise from right to left
  double angle;
  Number exempt_sin2;     ///< squared sine of 0.9 times the angle
  Number lock_radius = 0; ///< the chord between the shells of this radius is locked; 0: none is
};

template <class Number>
struct Basic_corner {
  Vertex_id apex;
  Number radius = 0;
  std::vector<Leg_id> legs;   ///< counterclockwise
  std::vector<double> angles; ///< from each leg to the next; as many as legs if sectors go around the apex
  std::vector<Sector_id> sectors; ///< the lopped ones
  double least_angle = 0;

  template <class Archive>
  void transfer(Archive& archive) {
    archive(apex, radius, legs, angles, sectors, least_angle);
  }
};

/// Legs of a corner that follow each other counterclockwise.
struct Leg_run {
  std::size_t first, size; ///< the place of the first in the corner
};

/// The distance between the legs of a sector at a radius.
template <class Number>
Number chord_of_sector(double angle, Number radius) {
  return 2 * std::sin(angle / 2) * radius;
}

template <class Geometry>
class Acute_corners {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Number = typename Geometry::Number;
  using Leg = Basic_leg<Number>;
  using Sector = Basic_sector<Number>;
  using Corner = Basic_corner<Number>;

  Indexed_vector<Leg_id, Leg> legs;
  Indexed_vector<Sector_id, Sector> sectors;
  Indexed_vector<Corner_id, Corner> corners; ///< in the order of their apexes
  /// Per input edge, the leg it is seen from its end a, from its end b; none where the corner has no lopped
  /// sector.
  Sparse_values<Edge_id, std::array<Leg_id, 2>> legs_of_edge;
  /// Per input vertex: a domain sector below 60 degrees lies at it.
  Indexed_vector<Vertex_id, char> is_acute;

  Leg& leg(Leg_id l) { return legs[l]; }
  const Leg& leg(Leg_id l) const { return legs[l]; }
  Sector& sector(Sector_id s) { return sectors[s]; }
  const Sector& sector(Sector_id s) const { return sectors[s]; }
  Corner& corner(Corner_id c) { return corners[c]; }
  const Corner& corner(Corner_id c) const { return corners[c]; }
  Corner_id corner_of(const Sector& s) const { return leg(s.right).corner; }

  void prepare(const Input_edges& edges, std::size_t number_of_input_vertices) {
    edges_ = &edges;
    legs_of_edge = Sparse_values<Edge_id, std::array<Leg_id, 2>>(edges.size());
    is_acute.assign(number_of_input_vertices, 0);
    on_leg_.assign(number_of_input_vertices, 0);
  }

  /// Writes or reads them, once they are prepared (Checkpoint_file.h).
  template <class Archive>
  void transfer(Archive& archive) {
    archive(legs, sectors, corners, legs_of_edge, is_acute, on_leg_);
    if (Archive::is_reading) list_legs();
  }

  /// As before legs were cut, in a mesh that has the input vertices' numbers for handles.
  void forget_cuts() {
    forget_cuts([](Edge_id) { return true; });
  }

  /// The same for the corners whose legs are such edges. All legs of a corner are, or none is.
  template <class Is_edge>
  void forget_cuts(const Is_edge& is_edge) {
    for (Leg& l : legs)
      if (is_edge(l.edge)) l.shells.clear(), l.ring = {}, l.apex_vertex = l.apex;
    for (Sector& s : sectors)
      if (is_edge(leg(s.right).edge)) s.lock_radius = 0;
  }

  Leg_id add_leg(Leg leg) {
    const Leg_id l = legs.end_id();
    legs_of_edge.at(leg.edge)[(*edges_)[leg.edge].a == leg.apex ? 0 : 1] = l;
    on_leg_[leg.apex] = on_leg_[leg.far] = 1;
    legs.push_back(std::move(leg));
    return l;
  }
  /// To be called once all legs are added.
  void list_legs() {
    const auto key = [this](Leg_id l) { return std::pair(leg(l).far, leg(l).apex); };
    legs_by_far_end_.clear();
    for (const Leg_id l : legs.ids()) legs_by_far_end_.push_back(l);
    std::sort(legs_by_far_end_.begin(), legs_by_far_end_.end(),
              [&](Leg_id l, Leg_id m) { return key(l) < key(m); });
  }

  /// The range of the legs with this far end, an input number, in the order of their apexes.
  auto legs_to(Vertex_id far) const {
    const auto begin = std::partition_point(legs_by_far_end_.begin(), legs_by_far_end_.end(),
                                            [&](Leg_id l) { return leg(l).far < far; });
    const auto end =
        std::partition_point(begin, legs_by_far_end_.end(), [&](Leg_id l) { return leg(l).far == far; });
    return std::pair(begin, end);
  }
  /// The same of the corners with this apex.
  auto corners_at(Vertex_id apex) const {
    const auto begin =
        std::partition_point(corners.begin(), corners.end(), [&](const Corner& c) { return c.apex < apex; });
    const auto end =
        std::partition_point(begin, corners.end(), [&](const Corner& c) { return c.apex == apex; });
    return std::pair(begin, end);
  }

  /// The legs to which one comes from leg l over sectors whose legs are not farther apart than a distance at a radius.
  Leg_run legs_reached_from(Leg_id l, Number radius, Number distance) const {
    const Corner& around = corner(leg(l).corner);
    const std::size_t n = around.legs.size();
    const auto is_narrow = [&](std::size_t sector) {
      return sector < around.angles.size() && chord_of_sector(around.angles[sector], radius) <= distance;
    };
    const auto place = std::find(around.legs.begin(), around.legs.end(), l);
    Leg_run run{static_cast<std::size_t>(place - around.legs.begin()), 1};
    while (run.size < n && is_narrow((run.first + n - 1) % n)) run = {(run.first + n - 1) % n, run.size + 1};
    while (run.size < n && is_narrow((run.first + run.size - 1) % n)) ++run.size;
    return run.size == n ? Leg_run{0, n} : run;
  }

  /// Whether v lies on a leg of some corner with a lopped sector: only then can its triangles be exempt.
  bool is_on_leg(const Mesh& mesh, Vertex_id v) const {
    if (mesh.is_free(v)) return false;
    if (mesh.is_input(v)) return on_leg_[mesh.input_number(v)] != 0;
    const Edge_id e = mesh.edge(v);
    return legs_of_edge[e][0].is_valid() || legs_of_edge[e][1].is_valid();
  }

  /// The leg with the given apex (an input number) that carries v, if there is one.
  Leg_id leg_at(const Mesh& mesh, Vertex_id apex, Vertex_id v) const {
    const Edge_id e = mesh.is_input(v) ? edges_->between(apex, mesh.input_number(v)) : mesh.edge(v);
    if (!e.is_valid()) return {};
    const Input_edge& edge = (*edges_)[e];
    return edge.a == apex ? legs_of_edge[e][0] : edge.b == apex ? legs_of_edge[e][1] : Leg_id();
  }

  /// The vertex of a leg at the radius of a shell or of the ring, if the mesh has one there.
  Vertex_id vertex_at(const Mesh& mesh, Leg_id l, const Number& radius) const {
    using std::fabs;
    const Leg& at = leg(l);
    if (radius == corner(at.corner).radius)
      return at.ring.is_valid() && mesh.is_used(at.ring) ? at.ring : Vertex_id();
    const Number tolerance = same_radius * radius;
    for (auto s = at.shells.from(radius - 2 * tolerance); s != at.shells.end(); ++s) {
      if (s->first > radius + 2 * tolerance) break;
      if (fabs(s->first - radius) <= tolerance && mesh.is_used(s->second)) return s->second;
    }
    return {};
  }

  /// The lopped sector whose two legs carry a, b and c (the apex lies on both), if there is one.
  Sector_id sector_of(const Mesh& mesh, Vertex_id a, Vertex_id b, Vertex_id c) const {
    return find_sector(mesh, a, b, c, [](Sector_id) { return true; });
  }

  /// Calls `f(sector)` for the lopped sectors from one leg to the other of which the chord x-y runs: there may be
  /// several if x or y is the far end of legs of two corners. Stops when f returns true.
  template <class Function>
  void find_sector_of_chord(const Mesh& mesh, Vertex_id x, Vertex_id y, Function f) const {
    const auto is_wanted = [&](Leg_id l, Vertex_id end) {
      const Sector_id s = !l.is_valid() ? Sector_id() : common_sector(l, leg_at(mesh, leg(l).apex, end));
      return s.is_valid() && f(s);
    };
    for (int pass = 0; pass < 2; ++pass, std::swap(x, y)) {
      const Edge_id e = mesh.edge(x);
      if (e.is_valid()) {
        for (const Leg_id l : legs_of_edge[e])
          if (is_wanted(l, y)) return;
      } else if (mesh.is_input(x)) {
        for (auto [l, end] = legs_to(mesh.input_number(x)); l != end; ++l)
          if (is_wanted(*l, y)) return;
      }
    }
  }

  /// Whether a triangle below the bound is excused by its corner.
  bool is_exempt(const Mesh& mesh, Vertex_id a, Vertex_id b, Vertex_id c) const {
    const Sector_id s = sector_of(mesh, a, b, c);
    return s.is_valid() && !mesh.shape_of_flat(a, b, c).is_below(sector(s).exempt_sin2);
  }

  /// The sector that excuses a triangle below the bound, if one does. Where legs are not cut, the triangle may be
  /// between the legs of several.
  Sector_id excusing_sector(const Mesh& mesh, Vertex_id a, Vertex_id b, Vertex_id c) const {
    return find_sector(mesh, a, b, c, [&](Sector_id s) {
      return !mesh.shape_of_flat(a, b, c).is_below(sector(s).exempt_sin2);
    });
  }

private:
  const Input_edges* edges_ = nullptr;
  Indexed_vector<Vertex_id, char> on_leg_; // per input vertex: an apex or the far end of a leg
  std::vector<Leg_id> legs_by_far_end_;    // and then by their apex

  /// The first of the lopped sectors whose two legs carry a, b and c for which `f(sector)` is true.
  template <class Function>
  Sector_id find_sector(const Mesh& mesh, Vertex_id a, Vertex_id b, Vertex_id c, const Function& f) const {
    if (legs.empty() || !is_on_leg(mesh, a) || !is_on_leg(mesh, b) || !is_on_leg(mesh, c)) return {};
    const Vertex_id v[3] = {a, b, c};
    const auto is_wanted = [&f](Sector_id s) { return s.is_valid() && f(s); };
    for (int k = 0; k < 3; ++k) {
      const Vertex_id x = v[next_slot[k]], y = v[previous_slot[k]];
      const Edge_id e = mesh.edge(v[k]);
      if (mesh.is_input(v[k])) {
        const Vertex_id apex = mesh.input_number(v[k]);
        const Sector_id s = common_sector(leg_at(mesh, apex, x), leg_at(mesh, apex, y));
        if (is_wanted(s)) return s;
        continue;
      }
      for (const Leg_id l : legs_of_edge[e]) {
        const Sector_id s = !l.is_valid() ? Sector_id() : sector_with(mesh, l, x, y);
        if (is_wanted(s)) return s;
      }
    }
    return {};
  }

  Sector_id common_sector(Leg_id l, Leg_id m) const {
    if (!l.is_valid() || !m.is_valid() || l == m) return {};
    const Leg &p = leg(l), &q = leg(m);
    if (p.after.is_valid() && p.after == q.before) return p.after;
    if (p.before.is_valid() && p.before == q.after) return p.before;
    return {};
  }

  /// The lopped sector next to leg l whose legs carry x and y too.
  Sector_id sector_with(const Mesh& mesh, Leg_id l, Vertex_id x, Vertex_id y) const {
    const Vertex_id apex = leg(l).apex;
    const auto carrying = [&](Vertex_id v) {
      return mesh.role(v) == input_vertex(apex) ? l : leg_at(mesh, apex, v);
    };
    const Leg_id lx = carrying(x), ly = carrying(y);
    if (!lx.is_valid() || !ly.is_valid()) return {};
    if (lx == l) return common_sector(l, ly);
    return ly == l || ly == lx ? common_sector(l, lx) : Sector_id();
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_ACUTE_CORNERS_H
