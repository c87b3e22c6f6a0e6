// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What follows when refinement on demand has spent its budget.
//
// Computes: a mesh in which quadtrees have made the islands where refinement does not come to rest (Island_finder.h,
//           Island_construction.h). All other triangles stay as they are, bit for bit. Refinement then goes on with
//           them, in the order in which it would have come to them. When it spends its budget again, there are other
//           islands.
// Bound:    at most `most_times_` budgets, and constructions. Each makes islands that were none before.
// Source:   ours.
//
// If the whole mesh is an island, there is nothing to keep, and it is left to the caller.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_ISLAND_TAKEOVER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_ISLAND_TAKEOVER_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/islands/Island.h>
#include <CGAL/Quadtree_mesh_2/internal/islands/Island_construction.h>
#include <CGAL/Quadtree_mesh_2/internal/islands/Island_finder.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Edge_sides.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Vertex_budgets.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

enum class Takeover_end {
  DONE,       ///< refinement came to rest in all that is not of quadtrees
  WHOLE_MESH, ///< the mesh is an island, and nothing was done
  REST_IS_BAD ///< quadtrees may not, or could not make an island, or islands were made too often
};

template <class Traits, class ConcurrencyTag>
class Island_takeover {
public:
  using Geometry = Mesher_geometry<Traits>;
  using Island_of_mesh = Island<ConcurrencyTag, Geometry>;

  /// \param budgets of the whole mesh
  Island_takeover(Meshing_state<Geometry>& state, Graph_of_islands<Traits> graph,
                  const Quality_mesh_options_2& options, const Vertex_budgets<Geometry>& budgets,
                  Quality_mesh_report_2& report)
      : state_(state), graph_(std::move(graph)), options_(options), budgets_(budgets), report_(report),
        limit_(budgets.of_refinement(report.trees.has_taken_over)), is_done_(state.edges.size(), 0),
        first_placed_(static_cast<Vertex_id>(state.problem.number_of_input_points())) {}

  /// `refine(limit)` has refinement go on.
  /// \pre refinement has spent its budget
  template <class Refine, class Continue>
  Takeover_end run(const Refine& refine, const Continue& shall_go_on) {
    for (int i = 0; report_.trees.has_taken_over && i < most_times_; ++i) {
      const Edge_sides sides(state_.mesh, state_.edges);
      const Unsettled_islands islands =
          Island_finder<ConcurrencyTag, Geometry>(state_, sides, share_taken()).run(is_done_);
      if (islands.triangles.size() == state_.mesh.number_of_triangles()) return Takeover_end::WHOLE_MESH;
      if (islands.number == 0 || !construct(islands, sides, shall_go_on)) return Takeover_end::REST_IS_BAD;
      limit_ = budgets_.from_now_on(budgets_.of_refinement(options_.patience() > 0), number_inserted());
      if (refine(limit_) != Refinement_end::OUT_OF_BUDGET) return Takeover_end::DONE;
    }
    return Takeover_end::REST_IS_BAD;
  }

  /// What refinement may take that quadtrees do not replace.
  Mesh_limit limit_of_rest() const {
    const Mesh_limit usual = budgets_.of_refinement(false);
    return report_.trees.islands > 0 ? budgets_.from_now_on(usual, number_inserted()) : usual;
  }

  /// The first of the vertices that quadtrees have placed, if they have made an island.
  Vertex_id first_placed() const { return first_placed_; }

private:
  static constexpr int most_times_ = 4;

  Meshing_state<Geometry>& state_;
  Graph_of_islands<Traits> graph_;
  const Quality_mesh_options_2& options_;
  Vertex_budgets<Geometry> budgets_;
  Quality_mesh_report_2& report_;
  Mesh_limit limit_;                      // that refinement has come to
  Indexed_vector<Edge_id, char> is_done_; // those of islands that were made, or tried
  Vertex_id first_placed_;

  std::size_t number_inserted() const {
    return state_.mesh.number_of_vertices() - state_.problem.number_of_input_points();
  }

  /// The vertices that there are when the budget is spent, for each that is expected.
  double share_taken() const {
    const std::size_t vertices = std::min(limit_.vertices, state_.mesh.number_of_vertices());
    return static_cast<double>(vertices) /
           (static_cast<double>(state_.problem.number_of_input_points()) + report_.estimated_triangles);
  }

  /// \returns false if quadtrees give no mesh; all is as it was then
  template <class Continue>
  bool construct(const Unsettled_islands& islands, const Edge_sides& sides, const Continue& shall_go_on) {
    using Construction = Island_construction<Traits, ConcurrencyTag>;
    using Result = typename Construction::Result;
    using Bad_triangles = typename Island_of_mesh::Bad_triangles;
    Island_of_mesh island(state_, sides, islands.triangles);
    for (const Edge_id e : island.whole_edges()) is_done_[e] = 1;
    Tree_separation_report_2 trees;
    const Result result = Construction(island, graph_, options_).run(trees, shall_go_on);
    const bool is_made = result != Result::NO_MESH, is_in_vain = result == Result::OUT_OF_BUDGET;
    trees.has_taken_over = true, trees.islands = report_.trees.islands + (is_made ? islands.number : 0);
    report_.trees = trees;
    report_.is_budget_exhausted = report_.is_budget_exhausted || is_in_vain;
    if (is_made)
      first_placed_ =
          island.put_back(state_, is_in_vain ? Bad_triangles::ARE_LEFT : Bad_triangles::ARE_LISTED);
    return is_made;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_ISLAND_TAKEOVER_H
