// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The constrained Delaunay triangulation of placed vertices, restricted to the domain.
//
// Computes: a mesh of the kernel in which input vertices have their numbers as handles.
// Bound:    that of First_triangulation.h: O(k) expected for k vertices, not counting sorting.
// Source:   Bern, Eppstein, Teng, section 6; constrained Delaunay where the paper triangulates each leaf.
//
// A corner of a leaf is left out if it is at the place of another vertex, or on a piece of an edge. Input
// vertices and vertices on edges stay as they are.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TREE_TRIANGULATION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TREE_TRIANGULATION_H

#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Edge_sides.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_vertices.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Triangulates placed vertices.
/// \pre what is placed on edges is in their rooms (Edge_rooms.h)
template <class ConcurrencyTag, class Geometry>
class Tree_triangulation {
public:
  /// \param is_merged for each input vertex whether another one stands for it
  /// \param sides where the domain is
  Tree_triangulation(const Placed_vertices<Geometry>& placed,
                     const Indexed_vector<Vertex_id, char>& is_merged, const Input_edges& edges,
                     const Edge_sides& sides)
      : placed_(placed), edges_(edges), sides_(sides), is_out_(placed.points.size(), 0) {
    std::copy(is_merged.begin(), is_merged.end(), is_out_.begin());
  }

  /// \param to_grid gives the grid point of a point
  /// \returns false if pieces of edges cross, or vertices on them coincide; the mesh is as it was then.
  template <class To_grid>
  bool run(const To_grid& to_grid, Kernel_mesh<Geometry>& mesh) {
    for (;;) {
      sort(to_grid);
      Kernel_mesh<Geometry> sorted;
      First first(sorted, points_);
      if (first.run(segments_)) return false;
      const Faults faults = faults_of(first);
      if (faults.are_others) return false;
      if (!faults.are_corners) {
        take(std::move(sorted), mesh);
        return true;
      }
    }
  }

private:
  using First = First_triangulation<ConcurrencyTag, Geometry>;

  struct Faults {
    bool are_corners = false, are_others = false;
  };

  const Placed_vertices<Geometry>& placed_;
  const Input_edges& edges_;
  const Edge_sides& sides_;
  Indexed_vector<Vertex_id, char> is_out_; // by placed vertex
  Order order_;                            // triangulated vertex -> placed vertex
  std::vector<typename Geometry::Point> points_;
  std::vector<typename First::Segment> segments_;

  template <class To_grid>
  void sort(const To_grid& to_grid) {
    const std::vector<std::uint32_t> used = pack<ConcurrencyTag>(
        placed_.points.size(), [&](std::size_t v) { return is_out_[static_cast<Vertex_id>(v)] == 0; });
    std::vector<std::decay_t<decltype(to_grid(placed_.points.front()))>> grid_points(used.size());
    for_each_index<ConcurrencyTag>(used.size(), [&](std::size_t i) {
      grid_points[i] = to_grid(placed_.points[static_cast<Vertex_id>(used[i])]);
    });
    order_ = shuffle_order<ConcurrencyTag>(grid_points);
    points_.resize(used.size());
    Indexed_vector<Vertex_id, Vertex_id> place(placed_.points.size());
    for_each_index<ConcurrencyTag>(used.size(), [&](std::size_t i) {
      order_[i] = used[order_[i]];
      const Vertex_id placed = static_cast<Vertex_id>(order_[i]);
      points_[i] = placed_.points[placed];
      place[placed] = static_cast<Vertex_id>(i);
    });
    segments_.resize(placed_.segments.size());
    for_each_index<ConcurrencyTag>(segments_.size(), [&](std::size_t s) {
      const auto [a, b] = placed_.segments[s];
      segments_[s] = {place[a], place[b]};
    });
  }

  Vertex_id placed_vertex(Vertex_id sorted) const { return static_cast<Vertex_id>(order_[sorted.value()]); }
  bool is_corner(Vertex_id placed) const { return placed_.role_of[placed].is_free(); }

  /// Finds vertices at the place of others, and on segments; corners among them are out from now on.
  Faults faults_of(const First& first) {
    Faults faults;
    const auto leave_out = [&](Vertex_id v) {
      (is_corner(v) ? faults.are_corners : faults.are_others) = true;
      is_out_[v] = is_corner(v) ? 1 : is_out_[v];
    };
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const Vertex_id v = static_cast<Vertex_id>(i), r = first.representative(v);
      if (r != v) leave_out(is_corner(placed_vertex(v)) ? placed_vertex(v) : placed_vertex(r));
    }
    if (first.number_of_vertices_on_segments() == 0 || faults.are_corners) return faults;
    for (const Input_edge& piece : first.edges()) {
      const auto& ends = segments_[piece.segment.value()];
      for (const Vertex_id v : {piece.a, piece.b})
        if (v != ends[0] && v != ends[1]) leave_out(placed_vertex(v));
    }
    return faults;
  }

  /// The edge that a constrained side is a piece of, and whether its triangle is on the left of that.
  std::pair<Edge_id, bool> edge_at(const Kernel_mesh<Geometry>& sorted, Side s) const {
    const Vertex_id from = placed_vertex(sorted.source(s)), to = placed_vertex(sorted.target(s));
    const Edge_id e = placed_.role_of[from].edge(), f = placed_.role_of[to].edge();
    // Vertices on an edge are numbered from its first end to its second.
    if (e.is_valid() && f.is_valid()) return {e, from < to};
    if (e.is_valid()) return {e, to == edges_[e].b};
    if (f.is_valid()) return {f, from == edges_[f].a};
    const Edge_id whole = edges_.between(from, to);
    return {whole, from == edges_[whole].a};
  }

  void take(Kernel_mesh<Geometry>&& sorted, Kernel_mesh<Geometry>& mesh) const {
    sides_.restrict(sorted, First::number_of_auxiliary_vertices, [&](Side s) { return edge_at(sorted, s); });
    mesh = Kernel_mesh<Geometry>();
    mesh.points = placed_.points, mesh.role_of = placed_.role_of;
    mesh.triangle_of.assign(mesh.points.size(), {}), mesh.is_dirty.assign(mesh.points.size(), 1);
    mesh.triangles = std::move(sorted.triangles), mesh.region_of = std::move(sorted.region_of);
    for_each_index<ConcurrencyTag>(mesh.triangles.size(), [&](std::size_t t) {
      for (Vertex_id& v : mesh.triangle(static_cast<Triangle_id>(t)).v) v = placed_vertex(v);
    });
    for_each_index<ConcurrencyTag>(order_.size(), [&](std::size_t i) {
      const Vertex_id v = static_cast<Vertex_id>(i);
      mesh.triangle_of[placed_vertex(v)] = sorted.triangle_of[v];
    });
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TREE_TRIANGULATION_H
