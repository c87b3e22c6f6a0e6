// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A mesh by quadtrees that separate the features of a planar straight-line graph.
//
// Computes: a triangulation of the domain with no angle below the bound except in acute corners. It is made
//           from the quadtree T_B*, and vertices placed by a rule, which are inserted into the constrained Delaunay
//           triangulation of the domain.
// Bound:    k triangles, within a constant of what any triangulation with such angles needs. O(n log n + k)
//           work for each round. A round is O(log^2 n) parallel steps, but for the changes that a later round makes to
//           the mesh, one after the other, where they concern less than an eighth of the leaves.
// Source:   Bern, Eppstein, Teng, Theorem 5 (Theorem 6 with one thread).
// Deviates: the paper's constants separate features so far that warping is bound to succeed. Ours are what
//           mostly suffices (Tree_separation_options_2.h). What they miss is found in the mesh. After the last round
//           that is wanted, the first by default, it is left to refinement, which cures it in blocks. Before:
//           1. A triangle below the bound is cured, if possible, by leaving out or moving one of its vertices,
//              because which corners near a feature become vertices is a choice, or by adding a corner of smaller
//              squares (Local_cures.h). Where each vertex has a leaf of its own, the rule first misses the bound on
//              maps at two or three triangles in a hundred. All but one in a hundred of these are cured.
//           2. If that is not possible, the largest leaves at the triangle's vertices are split, and later
//              all of them. The mesh is then changed there (Placed_update.h). So the features of a place are as far
//              apart, in sides of its leaves, as the bound needs.
//           3. Vertices near which triangles are left again and again get windows, in which another rule is
//              certain to meet the bound (Vertex_windows.h, Missed_places.h).
//
// The bound is met when a round finds no triangle below it. That is the proof, triangle by triangle. Some
// leaves keep to the bound by certificate: along an edge, away from its ends, those that are equal, and those
// in columns (Column_rule.h); at vertices, windows. That splitting ends elsewhere is established numerically
// (doc/guarantees.md). In any case the budget and the coordinates end it. Triangles at leaves that these leave
// no room to split are left to refinement, and the rest goes on. The budget bounds the vertices of a round, and
// those of all rounds together, as each round looks at all of them.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TREE_CONSTRUCTION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TREE_CONSTRUCTION_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Placement_scope.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Vertex_budgets.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Local_cures.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Missed_places.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_insertion.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_update.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_vertices.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Rule_placement.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Separation_trees.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Tree_placement.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How many of so many vertices, from a first one on, have a triangle; the mesh may have fewer by now.
template <class ConcurrencyTag, class Mesh>
std::size_t number_used(const Mesh& mesh, std::size_t first, std::size_t size) {
  const std::size_t vertices = mesh.number_of_vertices();
  return reduce<ConcurrencyTag>(
      std::min(size, vertices - std::min(vertices, first)), std::size_t(0),
      [&](std::size_t begin, std::size_t end) {
        std::size_t used = 0;
        for (const Vertex_id v : Id_range<Vertex_id>(first + begin, first + end))
          used += std::size_t(mesh.is_used(v) ? 1 : 0);
        return used;
      },
      std::plus<>());
}

template <class Traits, class ConcurrencyTag>
class Tree_construction {
public:
  using Trees = Separation_trees<Traits, ConcurrencyTag>;
  using Geometry = typename Trees::Geometry;
  using State = Meshing_state<Geometry>;
  using Report = Tree_separation_report_2;
  using End = Report::End;

  /// \param trees of the state's problem
  /// \param domain the constrained Delaunay triangulation of the problem's edges, restricted to the domain
  Tree_construction(State& state, Trees& trees, const Kernel_mesh<Geometry>& domain, Report& report)
      : state_(state), mesh_(state.mesh), trees_(trees), report_(report),
        triangles_(Edge_triangles<Geometry>::template of<ConcurrencyTag>(
            domain, state.edges, state.problem.number_of_input_points())) {}

  /// Replaces the mesh. What is below the bound at the end is on the worklist. `shall_go_on()` is asked once a round.
  /// The round that uses up the budget is the last.
  /// \pre the trees are not exhausted
  template <class Continue>
  End run(const Tree_separation_options_2& options, const Construction_budget& budget,
          const Continue& shall_go_on) {
    using Placement = Tree_separation_options_2::Placement;
    const Placement placement = options.place();
    Missed_places<Trees> places(state_, trees_, options);
    std::size_t vertices_of_all_rounds = 0;
    for (;;) {
      ++report_.rounds;
      report_.handed_over = 0;
      place_vertices(placement);
      std::vector<Triangle_id> sharp = missed_triangles<ConcurrencyTag>(state_);
      report_.triangles = mesh_.number_of_triangles();
      report_.missed_by_rule += sharp.size();
      report_.windows = trees_.windows().number_settled();
      report_.failed_windows += number_in_windows(sharp);
      const bool is_last = report_.rounds == options.rounds(); // blocks will leave out more than these
      if (placement == Placement::CHOSEN && !is_last)
        sharp = Local_cures<Geometry>(state_, report_).run(std::move(sharp));
      report_.missed = sharp.size();
      report_.placed = mesh_.number_of_vertices() - state_.problem.number_of_input_points();
      report_.leaves_of_edges = trees_.tree().number_of_leaves();
      for (const Triangle_id t : sharp) state_.push(t);
      if (mesh_.number_of_vertices() > budget.leaves) return End::BUDGET;
      if (sharp.empty()) return End::DONE;
      if (!shall_go_on()) return End::CANCELLED;
      if (is_last) return End::ROUNDS;
      vertices_of_all_rounds += mesh_.number_of_vertices();
      if (trees_.is_exhausted() || vertices_of_all_rounds >= budget.vertices_of_all_rounds)
        return End::BUDGET;
      const auto measures = places.measures_for(sharp, report_.rounds, cramped_edges_);
      report_.handed_over = measures.handed_over;
      if (!trees_.refine(measures.leaves, measures.vertices)) return End::COORDINATES;
    }
  }

private:
  State& state_;
  Kernel_mesh<Geometry>& mesh_;
  Trees& trees_;
  Report& report_;
  const Edge_triangles<Geometry> triangles_; // of the domain
  Placement_scopes scopes_;
  std::vector<Edge_id> cramped_edges_; // in order

  void place_vertices(Tree_separation_options_2::Placement placement) {
    state_.clear_worklist();
    state_.corners.forget_cuts(); // those of the mesh before
    state_.bulk = {};
    if (placement == Tree_separation_options_2::Placement::BY_RULE)
      return make_mesh(Rule_placement<Traits, ConcurrencyTag>(state_.problem, trees_, triangles_).run());
    const auto& windows = trees_.windows();
    static_assert(Trees::Windows::none == Placement_scopes::no_label, "a leaf in no window has no label");
    const Placement_scope scope = scopes_.next(trees_.tree(), trees_.pieces_in_leaves(),
                                               [&windows](Leaf_index l) { return windows.of(l); });
    const auto placed =
        Tree_placement<Traits, ConcurrencyTag>(state_.problem, trees_, triangles_, scope).run();
    if (scope.is_all)
      make_mesh(placed);
    else
      change_mesh(placed, scope);
  }

  void make_mesh(const Placed_vertices<Geometry>& placed) {
    report_.missed_by_rule = report_.left_out = report_.relocated = report_.added = 0;
    cramped_edges_ = placed.cramped_edges;
    note_cramped(Placed_insertion<ConcurrencyTag, Geometry>(state_, placed, triangles_).run());
  }

  void change_mesh(const Placed_vertices<Geometry>& placed, const Placement_scope& scope) {
    const auto is_in_scope = [&scope](Edge_id e) { return scope.has(Segment_index(std::size_t(e))); };
    cramped_edges_.erase(std::remove_if(cramped_edges_.begin(), cramped_edges_.end(), is_in_scope),
                         cramped_edges_.end());
    note_cramped(placed.cramped_edges);
    note_cramped(Placed_update<ConcurrencyTag, Trees>(state_, trees_, placed, scope, triangles_).run());
  }

  void note_cramped(const std::vector<Edge_id>& edges) {
    cramped_edges_.insert(cramped_edges_.end(), edges.begin(), edges.end());
    std::sort(cramped_edges_.begin(), cramped_edges_.end());
  }

  /// How many triangles are where a window is certain to meet the bound.
  std::size_t number_in_windows(const std::vector<Triangle_id>& triangles) const {
    const auto& windows = trees_.windows();
    if (windows.empty()) return 0;
    return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), [&](Triangle_id t) {
      const auto& v = mesh_.triangle(t).v;
      const auto center = Geometry::between(Geometry::between(mesh_.point(v[0]), mesh_.point(v[1]), 0.5),
                                            mesh_.point(v[2]), 1. / 3);
      const auto w = windows.of(trees_.tree().locate(trees_.grid_point(center)));
      return w != windows.none && windows[w].is_proven(Geometry::difference(
                                      center, state_.problem.input_point(windows[w].vertex())));
    }));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TREE_CONSTRUCTION_H
