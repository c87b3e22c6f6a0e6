// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Quadtrees make what refinement on demand did not come to rest in, and nothing else.
//
// Computes: a mesh of an island (Island.h) by the rounds of Tree_construction.h until nothing is missed. What they
//           leave is refined, and vertices that are not needed are removed.
// Bound:    that of Tree_construction.h for the island's part of the graph. Its budgets are those of a graph of its
//           size (Vertex_budgets.h), so the work ends in any case.
// Source:   Bern, Eppstein, Teng, Theorem 5.
// Deviates: the theorem has no refinement before. Here it has made the rest of the mesh.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_ISLAND_CONSTRUCTION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_ISLAND_CONSTRUCTION_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/islands/Island.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/nearest_hits.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Vertex_budgets.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/finish_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Block_refinement.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Separation_trees.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Tree_construction.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/cure_placed_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Thinner.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Quadtrees go on until they miss nothing: where refinement did not come to rest, it is not to cure what could keep it
/// going.
inline Tree_separation_options_2 options_where_refinement_fails(const Tree_separation_options_2& wanted) {
  return Tree_separation_options_2::of_theorem().subdivide(wanted.subdivide()).place(wanted.place());
}

/// The graph whose part an island is, as users know it.
template <class Traits>
struct Graph_of_islands {
  using Pslg = Pslg_2<typename Traits::Point_2>;

  const Pslg& pslg;
  const Order& order; ///< kernel vertex -> vertex of the graph
  const Coordinate_map<Traits, Mesher_geometry<Traits>>& map;
  const Traits& traits;
  Find_nearest_hits<Pslg>
      find_hits; ///< by which model neighbors of vertices are found; null: by the quadtree
};

template <class Traits, class ConcurrencyTag>
class Island_construction {
public:
  using Trees = Separation_trees<Traits, ConcurrencyTag>;
  using Geometry = typename Trees::Geometry;
  using Pslg = typename Trees::Pslg;
  using Report = Tree_separation_report_2;
  using Island_of_mesh = Island<ConcurrencyTag, Geometry>;

  Island_construction(Island_of_mesh& island, const Graph_of_islands<Traits>& whole,
                      const Quality_mesh_options_2& options)
      : island_(island), state_(island.state()), whole_(whole), options_(options),
        budgets_(options, island.problem().bounds, island.number_of_vertices(), island.expected_vertices(),
                 island.expected_of_sizes()) {
    for (const Vertex_id v : island.whole_vertices())
      graph_.vertices.push_back(whole.pslg.vertices[whole.order[std::size_t(v)]]);
    for (const Edge_id e : island.problem().edges.ids()) {
      const Input_edge& edge = island.problem().edges[e];
      graph_.add_segment(Vertex_index(std::size_t(edge.a)), Vertex_index(std::size_t(edge.b)));
    }
  }

  /// What came of it.
  enum class Result {
    NO_MESH,       ///< the state has none
    OUT_OF_BUDGET, ///< a mesh, but refinement after it did not come to rest
    MESH
  };

  /// `shall_go_on()` is asked again and again.
  template <class Continue>
  Result run(Report& report, const Continue& shall_go_on) {
    report.end = construct(report, shall_go_on);
    if (report.rounds == 0) return Result::NO_MESH;
    return finish(shall_go_on) == Refinement_end::OUT_OF_BUDGET ? Result::OUT_OF_BUDGET : Result::MESH;
  }

private:
  Island_of_mesh& island_;
  Meshing_state<Geometry>& state_;
  const Graph_of_islands<Traits>& whole_;
  const Quality_mesh_options_2& options_;
  Vertex_budgets<Geometry> budgets_;
  Pslg graph_; // the island's, in its order

  template <class Continue>
  Report::End construct(Report& report, const Continue& shall_go_on) {
    const Tree_separation_options_2 options = options_where_refinement_fails(options_.trees());
    const Kernel_mesh<Geometry> domain = std::move(state_.mesh);
    std::optional<Trees> trees;
    try {
      trees.emplace(island_.problem(), island_.sides(), graph_, whole_.map, options, whole_.traits, domain,
                    whole_.find_hits, budgets_.of_construction().leaves, report);
    } catch (const Point_error&) { // the grid of the quadtrees cannot tell two vertices apart
      return Report::End::FAILED;
    }
    if (trees->is_exhausted()) return Report::End::BUDGET;
    Tree_construction<Traits, ConcurrencyTag> construction(state_, *trees, domain, report);
    return construction.run(options, budgets_.of_construction(), shall_go_on);
  }

  /// Cures what quadtrees made, as other meshes by them are, and removes what is not needed.
  template <class Continue>
  Refinement_end finish(const Continue& shall_go_on) {
    Finishing finishing;
    if (options_.coarsen() == Quality_mesh_options_2::Coarsening::NONE) finishing.removal = Removal::NONE;
    Refinement_end end = Refinement_end::DONE;
    const bool shall_thin = cure_placed_mesh(
        state_, finishing, [&] { return work_off_in_blocks(finishing, shall_go_on); },
        [&](bool are_blocks) { end = refine(are_blocks, shall_go_on); });
    if (finishing.removal == Removal::NONE || end != Refinement_end::DONE) return end;
    finish_mesh(state_, finishing, shall_go_on);
    if (shall_thin) Thinner<Geometry>(state_).run(limit(), shall_go_on);
    return end;
  }

  Mesh_limit limit() const { return budgets_.of_repair(state_.mesh.number_of_vertices()); }

  template <class Continue>
  bool work_off_in_blocks(const Finishing& finishing, const Continue& shall_go_on) {
    Block_rounds rounds;
    Unwatched_rounds watch;
    return Block_refinement<ConcurrencyTag, Geometry>(state_, finishing, limit().vertices, rounds, watch)
        .run(shall_go_on, [] {});
  }

  /// \param is_listed whether all that is bad is on the worklist
  template <class Continue>
  Refinement_end refine(bool is_listed, const Continue& shall_go_on) {
    Splitter<Geometry> splitter(state_);
    Refiner<Geometry> refiner(state_, splitter);
    if (!is_listed) refiner.push_all();
    return refiner.run(limit(), shall_go_on);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_ISLAND_CONSTRUCTION_H
