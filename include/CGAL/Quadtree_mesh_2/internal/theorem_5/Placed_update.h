// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Changes a mesh of placed vertices where leaves have changed, instead of making it anew.
//
// Computes: the mesh with the vertices that are placed now, in the scope of what changed (Placement_scope.h), and all
//           others as they were. It is constrained Delaunay in the scope. Local cures elsewhere stay (Local_cures.h);
//           those in the scope are undone.
// Bound:    O(depth) to look at each vertex of the mesh, at the same time. All else is expected O(1) for each vertex
//           that is inserted or removed, one after the other: scopes are small. What is placed again where it was
//           stays.
// Source:   ours. The paper splits all leaves before it places vertices, so it makes its mesh once.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PLACED_UPDATE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PLACED_UPDATE_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Placement_scope.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Tree_corners.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Delaunay_remover.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_insertion.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_vertices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// \tparam Trees `Separation_trees`
template <class ConcurrencyTag, class Trees>
class Placed_update {
public:
  using Geometry = typename Trees::Geometry;
  using Placed = Placed_vertices<Geometry>;

  /// \param state whose mesh a `Placed_insertion` has made, and updates since
  /// \param placed in the scope, and no others
  Placed_update(Meshing_state<Geometry>& state, const Trees& trees, const Placed& placed,
                const Placement_scope& scope, const Edge_triangles<Geometry>& triangles)
      : state_(state), mesh_(state.mesh), trees_(trees), corners_(trees.tree()), placed_(placed),
        scope_(scope), around_(scope), triangles_(triangles) {
    around_.grow(trees.tree(), 1);
  }

  /// \returns the edges of the scope without some of their vertices, which rounding has put in the wrong place
  std::vector<Edge_id> run() {
    list_placed_on_edges();
    remove_vertices();
    make_Delaunay();
    return Insertion(state_, placed_, triangles_).add_to_mesh(gaps());
  }

private:
  using Tree = typename Trees::Tree;
  using Corners = Tree_corners<Tree>;
  using Grid_point = typename Trees::Grid_point;
  using Insertion = Placed_insertion<ConcurrencyTag, Geometry>;
  using Gap = typename Insertion::Gap;

  /// A vertex that is placed on an edge.
  struct On_edge {
    Edge_id edge;
    double way; ///< from the edge's first end, along x or y, as rounded for this point
    Vertex_id placed;

    friend bool operator<(const On_edge& p, const On_edge& q) {
      return p.edge != q.edge ? p.edge < q.edge : p.way < q.way;
    }
  };

  /// What becomes of a vertex of the mesh.
  enum class Fate { OUTSIDE, KEPT, REMOVED };

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  const Trees& trees_;
  const Corners corners_;
  const Placed& placed_;
  const Placement_scope& scope_;
  /// With the leaves next to it: a corner of one of these may belong to one of the scope.
  Placement_scope around_;
  const Edge_triangles<Geometry>& triangles_;
  std::vector<On_edge> on_edges_; // in order
  /// By placed vertex on an edge: the one that is there, or none.
  Indexed_vector<Vertex_id, Vertex_id> in_mesh_;
  std::vector<Vertex_id> kept_; // of the scope

  void list_placed_on_edges() {
    for (const auto& run : placed_.runs)
      for (const Vertex_id v : run.vertices())
        on_edges_.push_back({run.edge, way(run.edge, placed_.points[v]), v});
    std::sort(on_edges_.begin(), on_edges_.end());
    in_mesh_.resize(placed_.first_corner.value());
  }

  double way(Edge_id e, const typename Geometry::Point& p) const {
    const auto& a = state_.problem.input_point(state_.edges[e].a);
    const Vector d = Geometry::difference(state_.problem.input_point(state_.edges[e].b), a);
    const Vector from_a = Geometry::difference(p, a);
    return std::fabs(d.y) > std::fabs(d.x) ? from_a.y : from_a.x;
  }

  /// The placed vertex where a vertex of an edge is; or none.
  Vertex_id placed_at(Vertex_id v) const {
    const On_edge wanted{mesh_.edge(v), way(mesh_.edge(v), mesh_.point(v)), {}};
    const auto [first, last] = std::equal_range(on_edges_.begin(), on_edges_.end(), wanted);
    const auto found = std::find_if(
        first, last, [&](const On_edge& p) { return placed_.points[p.placed] == mesh_.point(v); });
    return found == last ? Vertex_id() : found->placed;
  }

  void remove_vertices() {
    const std::size_t first = state_.problem.number_of_input_points(), n = mesh_.number_of_vertices() - first;
    const auto vertex = [first](std::size_t i) { return static_cast<Vertex_id>(first + i); };
    const auto in_scope = pack_values<ConcurrencyTag, Vertex_id>(
        n, [&](std::size_t i) { return fate(vertex(i)) != Fate::OUTSIDE; }, vertex);
    Delaunay_remover<Geometry> remover(mesh_);
    for (const Vertex_id v : in_scope)
      if (fate(v) == Fate::KEPT)
        keep(v);
      else
        remover.remove(v);
  }

  void keep(Vertex_id v) {
    kept_.push_back(v);
    if (!mesh_.is_free(v)) in_mesh_[placed_at(v)] = v;
  }

  std::vector<Gap> gaps() const {
    std::vector<Gap> gaps;
    for (const auto& run : placed_.runs) {
      Gap gap{{run.edge, {}, 0}, state_.edges[run.edge].a, {}};
      const auto close = [&](Vertex_id b) {
        gap.b = b;
        if (gap.run.size > 0) gaps.push_back(gap);
        gap = {{run.edge, {}, 0}, b, {}};
      };
      for (const Vertex_id v : run.vertices())
        if (in_mesh_[v].is_valid())
          close(in_mesh_[v]);
        else if (gap.run.size++ == 0)
          gap.run.first = v;
      close(state_.edges[run.edge].b);
    }
    return gaps;
  }

  /// \param v none of the input
  Fate fate(Vertex_id v) const {
    if (!mesh_.is_used(v)) return Fate::OUTSIDE;
    if (!mesh_.is_free(v)) {
      if (!scope_.has(Segment_index(std::size_t(mesh_.edge(v))))) return Fate::OUTSIDE;
      return placed_at(v).is_valid() ? Fate::KEPT : Fate::REMOVED;
    }
    const Grid_point p = trees_.grid_point(mesh_.point(v));
    const Leaf_index l = trees_.tree().locate(p);
    if (!around_.has(l)) return Fate::OUTSIDE;
    // What is no corner was moved or added by cures.
    const auto c = trees_.kernel_point(p) == mesh_.point(v) ? corners_.name(p) : Corners::none;
    if (c == Corners::none) return scope_.has(l) ? Fate::REMOVED : Fate::OUTSIDE;
    if (!scope_.has(Corners::leaf_of(c))) return Fate::OUTSIDE;
    const bool is_placed = std::binary_search(placed_.corners.begin(), placed_.corners.end(), c);
    return is_placed ? Fate::KEPT : Fate::REMOVED;
  }

  /// Around all vertices in the scope: cures leave triangles that are not. Where parts of the domain touch in an input
  /// vertex, it is the fan that the mesh knows of.
  void make_Delaunay() {
    std::vector<Side> doubtful;
    const auto append_sides_at = [&](Vertex_id v) {
      if (!mesh_.is_used(v)) return;
      mesh_.for_each_triangle_at(v, [&](Triangle_id t, int slot) {
        doubtful.push_back(Side(t, slot)), doubtful.push_back(Side(t, next_slot[slot]));
      });
    };
    const auto& framework = trees_.tree().framework();
    for (const Vertex_id v : kept_) append_sides_at(v);
    for (const Leaf_index l : scope_.leaves) {
      const auto points = trees_.tree().points(l);
      for (std::size_t r = points.begin.value(); r < points.end.value(); ++r)
        append_sides_at(static_cast<Vertex_id>(framework.input_point(typename Tree::Point_rank(r)).value()));
    }
    mesh_.make_Delaunay(doubtful);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PLACED_UPDATE_H
