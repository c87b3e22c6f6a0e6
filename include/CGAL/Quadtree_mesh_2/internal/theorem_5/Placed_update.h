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
// Bound:    O(1) to look at each vertex of the mesh. All else is expected O(1) for each vertex placed in the scope,
//           one after the other: scopes are small.
// Source:   ours. The paper splits all leaves before it places vertices, so it makes its mesh once.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PLACED_UPDATE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PLACED_UPDATE_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Placement_scope.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Tree_corners.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Delaunay_remover.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_insertion.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_vertices.h>

#include <algorithm>
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
    remove_vertices();
    make_Delaunay();
    return Placed_insertion<ConcurrencyTag, Geometry>(state_, placed_, triangles_).add_to_mesh();
  }

private:
  using Tree = typename Trees::Tree;
  using Corners = Tree_corners<Tree>;
  using Grid_point = typename Trees::Grid_point;

  /// What becomes of a vertex of the mesh.
  enum class Fate { OUTSIDE, KEPT, REMOVED };

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  const Trees& trees_;
  const Corners corners_;
  const Placed& placed_;
  const Placement_scope& scope_;
  Placement_scope
      around_; // with the leaves next to it: a corner of one of these may belong to one of the scope
  const Edge_triangles<Geometry>& triangles_;
  std::vector<Vertex_id> kept_; // free vertices in the scope

  void remove_vertices() {
    const std::size_t first = state_.problem.input_points.size(), n = mesh_.number_of_vertices() - first;
    const auto vertex = [first](std::size_t i) { return static_cast<Vertex_id>(first + i); };
    const auto in_scope = pack_values<ConcurrencyTag, Vertex_id>(
        n, [&](std::size_t i) { return fate(vertex(i)) != Fate::OUTSIDE; }, vertex);
    Delaunay_remover<Geometry> remover(mesh_);
    for (const Vertex_id v : in_scope)
      if (fate(v) == Fate::KEPT)
        kept_.push_back(v);
      else
        remover.remove(v);
  }

  /// \param v none of the input
  Fate fate(Vertex_id v) const {
    if (!mesh_.is_used(v)) return Fate::OUTSIDE;
    if (!mesh_.is_free(v))
      return scope_.has(Segment_index(std::size_t(mesh_.edge(v)))) ? Fate::REMOVED : Fate::OUTSIDE;
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

  /// Around all vertices in the scope: cures leave triangles that are not.
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
