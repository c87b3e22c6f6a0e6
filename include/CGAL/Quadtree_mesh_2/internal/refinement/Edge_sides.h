// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The domain, given by the edges that bound its components. So every triangulation of the graph has the same
// domain, wherever rounding puts vertices on edges, and seeds are located once.
//
// Computes: for each edge, on which sides the domain is, and in which region. Also the triangles of another
//           triangulation that are in the domain, with their regions.
// Bound:    O(n) for n triangles.
// Source:   ours. Any side of an edge on its boundary identifies a component. A component without edges is
//           not in the domain.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_EDGE_SIDES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_EDGE_SIDES_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kept_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What is beside the edges.
class Edge_sides {
public:
  /// Of no edges.
  Edge_sides() = default;

  /// Of some edges of a graph, numbered in this order.
  Edge_sides(const Edge_sides& whole, const std::vector<Edge_id>& edges) : has_regions_(whole.has_regions_) {
    for (const Edge_id e : edges) labels_.push_back(whole.labels_[e]);
  }

  /// \pre the mesh is one of the domain, whole and refined or not
  template <class Geometry>
  Edge_sides(const Kernel_mesh<Geometry>& mesh, const Input_edges& edges)
      : labels_(edges.size(), {outside_, outside_}), has_regions_(!mesh.region_of.empty()) {
    for (const Triangle_id t : mesh.triangles.ids())
      for (int k = 0; k < 3; ++k) {
        const Side s(t, k);
        if (!mesh.is_alive(t) || !mesh.across(s).is_constrained()) continue;
        const Edge_id e = edges.carrying(mesh, mesh.source(s), mesh.target(s));
        if (!e.is_valid()) continue; // a chord across a corner
        labels_[e][is_along(mesh, s, edges[e]) ? left_ : right_] = mesh.region(t);
      }
  }

  bool is_domain_on_left(Edge_id e) const { return labels_[e][left_] != outside_; }
  bool is_domain_on_right(Edge_id e) const { return labels_[e][right_] != outside_; }

  /// Restricts a triangulation of the whole graph, in which no edge is cut, to the domain, and labels its regions.
  template <class Mesh>
  void restrict(Mesh& mesh, const Input_edges& edges, std::size_t number_of_auxiliary_vertices) const {
    constexpr Region_id unknown(0xfffffffdu);
    Uninitialized_indexed_vector<Triangle_id, Region_id> label(mesh.triangles.size(), unknown);
    for_each_index<Chosen_tag>(label.size(), [&](std::size_t i) {
      const Triangle_id t(i);
      for (int k = 0; k < 3 && label[t] == unknown; ++k) {
        const Side s(t, k);
        if (mesh.across(s).is_border() || !mesh.across(s).is_constrained()) continue;
        const Vertex_id a = mesh.source(s);
        const Edge_id e = edges.between(a, mesh.target(s));
        label[t] = labels_[e][a == edges[e].a ? left_ : right_];
      }
    });
    spread(mesh, label, unknown);
    Indexed_vector<Triangle_id, char> is_kept(label.size());
    for_each_index<Chosen_tag>(label.size(), [&](std::size_t i) {
      const Triangle_id t(i);
      is_kept[t] = label[t] != outside_ && label[t] != unknown ? 1 : 0;
    });
    if (has_regions_) mesh.region_of = std::move(label);
    Kept_triangles(mesh, is_kept)
        .keep(static_cast<Vertex_id>(mesh.points.size() - number_of_auxiliary_vertices));
  }

private:
  static constexpr std::size_t left_ = 0, right_ = 1;
  static constexpr Region_id outside_{0xfffffffeu}; ///< an invalid one is the domain without a region

  Indexed_vector<Edge_id, std::array<Region_id, 2>> labels_;
  bool has_regions_ = false;

  /// Labels the triangles that no constrained side separates from a labeled one.
  template <class Mesh, class Labels>
  static void spread(const Mesh& mesh, Labels& label, Region_id unknown) {
    std::vector<Triangle_id> stack;
    for (const Triangle_id first : label.ids()) {
      if (label[first] != unknown) stack.push_back(first);
      while (!stack.empty()) {
        const Triangle_id t = stack.back();
        stack.pop_back();
        for (const Side o : mesh.triangle(t).side) {
          if (o.is_border() || o.is_constrained() || label[o.triangle()] != unknown) continue;
          label[o.triangle()] = label[t];
          stack.push_back(o.triangle());
        }
      }
    }
  }

  /// Whether a side on an edge runs from `edge.a` to `edge.b`.
  template <class Geometry>
  static bool is_along(const Kernel_mesh<Geometry>& mesh, Side s, const Input_edge& edge) {
    const auto along = [&mesh](Vertex_id from, Vertex_id to) {
      return Geometry::scaled_difference(mesh.point(to), mesh.point(from));
    };
    return dot(along(mesh.source(s), mesh.target(s)), along(edge.a, edge.b)) > 0;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_EDGE_SIDES_H
