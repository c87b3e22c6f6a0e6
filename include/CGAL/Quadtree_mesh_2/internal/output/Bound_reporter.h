// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What the report says of a triangle that misses a bound: which acute corner excuses it, or why it was left.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_BOUND_REPORTER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_BOUND_REPORTER_H

#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Traits>
class Bound_reporter {
public:
  using Geometry = Mesher_geometry<Traits>;
  using Map = Coordinate_map<Traits, Geometry>;
  using Reason = Quality_mesh_report_2::Reason;
  using Unmet_triangle = Quality_mesh_report_2::Unmet_triangle;

  /// What ended refinement before it was done, if anything.
  static std::optional<Reason> end_of(const Quality_mesh_report_2& report) {
    if (report.is_budget_exhausted) return Reason::BUDGET;
    if (report.is_cancelled) return Reason::CANCELLED;
    return std::nullopt;
  }

  Bound_reporter(const Meshing_state<Geometry>& state, const Map& map, std::optional<Reason> end)
      : state_(state), mesh_(state.mesh), map_(map), end_(end) {}

  // Of triangles that miss a bound.

  /// Whether an acute corner excuses it.
  bool is_excused(Triangle_id t) const {
    const Shape s = mesh_.shape(mesh_.triangle(t));
    return !state_.is_bad(t, s) && !state_.is_too_wide(t, s);
  }
  /// The input vertex that does.
  Vertex_id excusing_corner(Triangle_id t) const {
    const auto& v = mesh_.triangle(t).v;
    const Sector_id s = state_.corners.excusing_sector(mesh_, v[0], v[1], v[2]);
    return state_.corners.leg(state_.corners.sector(s).right).apex;
  }

  /// Of one that is not excused.
  /// \param kept_edge_in_the_way of refinement, if there is one that gets no vertices
  Unmet_triangle unmet(Triangle_id t, Triangle_index name, Edge_id kept_edge_in_the_way) const {
    const auto& r = mesh_.triangle(t);
    const Shape s = mesh_.shape(r);
    Unmet_triangle unmet{name, {0, 0}, 0, reason(t, s, kept_edge_in_the_way)};
    if (unmet.reason == Reason::KEPT_SEGMENT) unmet.segment = state_.problem.kept_edges[kept_edge_in_the_way];
    for (const Vertex_id v : r.v) {
      const auto [x, y] = map_.place(mesh_.point(v));
      unmet.centroid[0] += x / 3, unmet.centroid[1] += y / 3;
    }
    unmet.least_angle = std::asin(std::sqrt(std::min(1.0, s.sin2_of_least_angle()))) * 180 / pi;
    unmet.greatest_angle = greatest_angle(s);
    return unmet;
  }

private:
  using Shape = typename Kernel_mesh<Geometry>::Shape;

  const Meshing_state<Geometry>& state_;
  const Kernel_mesh<Geometry>& mesh_;
  const Map& map_;
  std::optional<Reason> end_;

  /// In degrees.
  static double greatest_angle(const Shape& s) {
    const int k = s.slot_of_longest(), i = next_slot[k], j = previous_slot[k];
    const double p = ratio(s.l[i], s.l[k]), q = ratio(s.l[j], s.l[k]);
    return std::atan2(2 * ratio(s.area2, s.l[k]), p + q - 1) * 180 / pi;
  }

  /// Why a bad triangle was left.
  Reason reason(Triangle_id t, const Shape& s, Edge_id kept_edge_in_the_way) const {
    if (end_) return *end_;
    if (kept_edge_in_the_way.is_valid()) return Reason::KEPT_SEGMENT;
    if (state_.bounds.least_squared_length > 0) return Reason::LEAST_EDGE;
    if (!state_.is_bad(t, s)) return Reason::GREATEST_ANGLE;
    if (!state_.bounds.is_established())
      for (const Vertex_id v : mesh_.triangle(t).v)
        if (is_at_acute_corner(v)) return Reason::CORNER;
    return Reason::COORDINATES;
  }

  bool is_at_acute_corner(Vertex_id v) const {
    const Edge_id e = mesh_.edge(v);
    const auto& is_acute = state_.corners.is_acute;
    if (mesh_.is_input(v)) return is_acute[mesh_.input_number(v)] != 0;
    return e.is_valid() && (is_acute[state_.edges[e].a] != 0 || is_acute[state_.edges[e].b] != 0);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_BOUND_REPORTER_H
