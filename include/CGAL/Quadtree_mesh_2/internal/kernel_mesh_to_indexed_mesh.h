// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The kernel's mesh in flat arrays, in the user's coordinates and vertex order, and the report's account of
// every triangle. O(n).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_KERNEL_MESH_TO_INDEXED_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_KERNEL_MESH_TO_INDEXED_MESH_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Angle_histogram.h>
#include <CGAL/Quadtree_mesh_2/internal/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/boundary_markers.h>
#include <CGAL/Quadtree_mesh_2/internal/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/radix_sort.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Traits>
class Kernel_mesh_converter {
public:
  using Geometry = typename Traits::Meshing_geometry_2;
  using Point_2 = typename Traits::Point_2;
  using Map = Coordinate_map<Traits, Geometry>;

  Kernel_mesh_converter(const Meshing_state<Geometry>& state, const Pslg_2<Point_2>& pslg, const Map& map,
                        const Order& order, Quality_mesh_report_2& report)
      : state_(state), mesh_(state.mesh), pslg_(pslg), map_(map), order_(order), report_(report) {}

  Indexed_mesh_2<Point_2> run() {
    Indexed_mesh_2<Point_2> out;
    number_vertices(out);
    number_triangles();
    const std::size_t count = mesh_.number_of_triangles();
    out.triangles.reserve(count), out.neighbors.reserve(count);
    if (!mesh_.region_of.empty()) out.region_of_triangle.reserve(count);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (new_triangle_[t].is_valid()) add_triangle(out, static_cast<Triangle_id>(t));
    set_boundary_markers(out, pslg_);
    report_.triangles = out.triangles.size();
    report_.least_angle_histogram = angles_.least;
    report_.largest_angle_histogram = angles_.largest;
    return out;
  }

private:
  const Meshing_state<Geometry>& state_;
  const Kernel_mesh<Geometry>& mesh_;
  const Pslg_2<Point_2>& pslg_;
  const Map& map_;
  const Order& order_;
  Quality_mesh_report_2& report_;
  std::vector<Vertex_index> new_vertex_;
  std::vector<Triangle_index> new_triangle_;
  Angle_histogram angles_;

  void number_vertices(Indexed_mesh_2<Point_2>& out) {
    const std::size_t n = order_.size();
    out.number_of_input_vertices = n;
    out.points.reserve(mesh_.number_of_vertices()), out.segment_of_vertex.reserve(mesh_.number_of_vertices());
    out.points = pslg_.vertices;
    out.segment_of_vertex.assign(n, Segment_index());
    new_vertex_.resize(mesh_.number_of_vertices());
    for (std::size_t v = 0; v < mesh_.number_of_vertices(); ++v) {
      if (v < n) new_vertex_[v] = Vertex_index(order_[v]);
      if (!mesh_.is_used(static_cast<Vertex_id>(v))) continue;
      ++report_.vertices;
      if (v < n) continue;
      new_vertex_[v] = Vertex_index(out.points.size());
      out.points.push_back(map_.to_user(mesh_.points[v]));
      const Edge_id e = mesh_.edge_of[v];
      out.segment_of_vertex.push_back(e >= 0 ? Segment_index(std::size_t(state_.edges[e].segment))
                                             : Segment_index());
    }
  }

  void number_triangles() {
    new_triangle_.resize(mesh_.triangles.size());
    std::size_t next = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (mesh_.is_alive(static_cast<Triangle_id>(t))) new_triangle_[t] = Triangle_index(next++);
  }

  void add_triangle(Indexed_mesh_2<Point_2>& out, Triangle_id t) {
    const auto& r = mesh_.triangle(t);
    std::array<Vertex_index, 3> v;
    std::array<Triangle_index, 3> neighbors;
    for (int k = 0; k < 3; ++k) {
      v[std::size_t(k)] = new_vertex_[std::size_t(r.v[k])];
      const Side o = r.side[k];
      if (!o.is_border()) neighbors[std::size_t(k)] = new_triangle_[std::size_t(o.triangle())];
      if (o.is_border() || (o.is_constrained() && t < o.triangle())) add_constrained_edge(out, Side(t, k));
    }
    out.triangles.push_back(v);
    out.neighbors.push_back(neighbors);
    if (!mesh_.region_of.empty()) out.region_of_triangle.push_back(mesh_.region(t));
    account_for(out, t);
  }

  void add_constrained_edge(Indexed_mesh_2<Point_2>& out, Side s) {
    const Vertex_id x = mesh_.source(s), y = mesh_.target(s);
    const Edge_id e = state_.edges.carrying(mesh_, x, y);
    if (e < 0) return;
    out.constrained_edges.push_back({{new_vertex_[std::size_t(x)], new_vertex_[std::size_t(y)]},
                                     Segment_index(std::size_t(state_.edges[e].segment))});
  }

  void account_for(const Indexed_mesh_2<Point_2>& out, Triangle_id t) {
    const auto& r = mesh_.triangle(t);
    const Shape s = mesh_.shape(r);
    angles_.add(s);
    if (!state_.bounds.is_sharp(s) && !state_.is_large(t, s)) return;
    if (!state_.is_bad(t)) return add_exempt(t);
    Quality_mesh_report_2::Unmet_triangle unmet{new_triangle_[std::size_t(t)], {0, 0}, 0, reason(t)};
    for (const Vertex_id v : r.v) {
      const Point_2& p = out.points[std::size_t(new_vertex_[std::size_t(v)])];
      unmet.centroid[0] += static_cast<double>(p.x()) / 3;
      unmet.centroid[1] += static_cast<double>(p.y()) / 3;
    }
    unmet.least_angle =
        std::asin(std::sqrt(std::min(1.0, s.sin2_of_least_angle()))) * 180 / 3.14159265358979323846;
    report_.unmet_triangles.push_back(unmet);
  }

  void add_exempt(Triangle_id t) {
    const auto& r = mesh_.triangle(t);
    const Sector_id s = state_.corners.sector_of(mesh_, r.v[0], r.v[1], r.v[2]);
    const Vertex_id apex = state_.corners.leg(state_.corners.sector(s).right).apex;
    report_.exempt_triangles.push_back({new_triangle_[std::size_t(t)], new_vertex_[std::size_t(apex)]});
  }

  /// Why a bad triangle was left.
  Quality_mesh_report_2::Reason reason(Triangle_id t) const {
    using Reason = Quality_mesh_report_2::Reason;
    if (report_.is_budget_exhausted) return Reason::BUDGET;
    if (report_.is_cancelled) return Reason::CANCELLED;
    if (state_.bounds.least_squared_length > 0) return Reason::LEAST_EDGE;
    if (!state_.bounds.is_guaranteed())
      for (const Vertex_id v : mesh_.triangle(t).v)
        if (is_at_acute_corner(v)) return Reason::CORNER;
    return Reason::COORDINATES;
  }

  bool is_at_acute_corner(Vertex_id v) const {
    const Edge_id e = mesh_.edge(v);
    const auto& is_acute = state_.corners.is_acute;
    if (mesh_.is_input(v)) return is_acute[std::size_t(mesh_.input_number(v))] != 0;
    return e >= 0 &&
           (is_acute[std::size_t(state_.edges[e].a)] != 0 || is_acute[std::size_t(state_.edges[e].b)] != 0);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_KERNEL_MESH_TO_INDEXED_MESH_H
