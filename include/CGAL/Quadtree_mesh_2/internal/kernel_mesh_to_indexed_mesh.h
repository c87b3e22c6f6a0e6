// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The kernel's mesh in flat arrays, in the user's coordinates and vertex order, and the report's account of
// every triangle. O(n), and a walk for each region.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_KERNEL_MESH_TO_INDEXED_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_KERNEL_MESH_TO_INDEXED_MESH_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/domain.h>
#include <CGAL/Quadtree_mesh_2/internal/radix_sort.h>
#include <CGAL/Quadtree_mesh_2/internal/walk.h>
#include <CGAL/Quality_mesh_report_2.h>

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
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (new_triangle_[t].is_valid()) add_triangle(out, static_cast<Triangle_id>(t));
    if (!pslg_.regions.empty()) add_regions(out);
    report_.triangles = out.triangles.size();
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
    if (!state_.is_suspect(t)) return;
    const Shape s = mesh_.shape(r);
    if (!state_.is_bad(t)) {
      ++report_.exempt_triangles;
      return;
    }
    Quality_mesh_report_2::Unmet_triangle unmet{new_triangle_[std::size_t(t)], {0, 0}, 0};
    for (const Vertex_id v : r.v) {
      const Point_2& p = out.points[std::size_t(new_vertex_[std::size_t(v)])];
      unmet.centroid[0] += static_cast<double>(p.x()) / 3;
      unmet.centroid[1] += static_cast<double>(p.y()) / 3;
    }
    unmet.least_angle =
        std::asin(std::sqrt(std::min(1.0, s.sin2_of_least_angle()))) * 180 / 3.14159265358979323846;
    report_.unmet_triangles.push_back(unmet);
  }

  void add_regions(Indexed_mesh_2<Point_2>& out) {
    out.region_of_triangle.assign(out.triangles.size(), -1);
    for (std::size_t i = 0; i < pslg_.regions.size(); ++i) {
      const Triangle_id first = find_triangle(map_.to_kernel(pslg_.regions[i].point));
      if (first < 0) continue;
      std::vector<Triangle_id> stack{first};
      while (!stack.empty()) {
        const Triangle_id t = stack.back();
        stack.pop_back();
        int& region = out.region_of_triangle[std::size_t(new_triangle_[std::size_t(t)])];
        if (region >= 0) continue;
        region = static_cast<int>(i);
        for (const Side o : mesh_.triangle(t).side)
          if (!o.is_constrained()) stack.push_back(o.triangle());
      }
    }
  }

  /// The triangle that holds p: by a walk, or, if that is stopped by the border, by looking everywhere; -1
  /// outside the domain.
  Triangle_id find_triangle(const typename Geometry::Point& p) const {
    Triangle_id start = 0;
    while (!mesh_.is_alive(start)) ++start;
    const Walk_end end = locate_exactly(mesh_, start, p);
    if (!end.is_blocked()) return end.triangle;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (mesh_.is_alive(static_cast<Triangle_id>(t)) && holds(mesh_.triangles[t], p))
        return static_cast<Triangle_id>(t);
    return -1;
  }

  bool holds(const typename Kernel_mesh<Geometry>::Triangle& r, const typename Geometry::Point& p) const {
    for (int k = 0; k < 3; ++k)
      if (Geometry::orientation(mesh_.point(r.v[k]), mesh_.point(r.v[next_slot[k]]), p) < 0) return false;
    return true;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_KERNEL_MESH_TO_INDEXED_MESH_H
