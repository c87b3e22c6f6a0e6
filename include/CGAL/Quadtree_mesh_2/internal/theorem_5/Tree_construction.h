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
//           work for each round. A round is O(log^2 n) parallel steps.
// Source:   Bern, Eppstein, Teng, Theorem 5 (Theorem 6 with one thread).
// Deviates: the paper's constants separate features so far that warping is bound to succeed. Ours are what
//           mostly suffices (Tree_separation_options_2.h). What they miss is found in the mesh. After the last round
//           that is wanted, the first by default, it is left to refinement, which cures it in blocks. Before:
//           1. A triangle below the bound is cured, if possible, by leaving out one of its vertices, because
//              which corners near a feature become vertices is a choice. Where each vertex has a leaf of its
//              own, the rule first misses the bound on maps at two or three triangles in a hundred. Two
//              thirds of these are cured.
//           2. If that is not possible, the largest leaves at the triangle's vertices are split, and later
//              all of them. The mesh is then made anew. So the features of a place are as far apart, in sides
//              of its leaves, as the bound needs.
//
// The bound is met when a round finds no triangle below it. That is the proof, triangle by triangle. Some
// leaves along an edge, away from its ends, keep to the bound by certificate: those that are equal, and those
// in columns (Column_rule.h). That splitting ends elsewhere is established numerically (doc/guarantees.md).
// In any case the budget and the coordinates end it. Triangles at leaves that these leave no room to split
// are left to refinement, and the rest goes on. The budget bounds the vertices of a round, and those of all
// rounds together, each of which is a mesh of its own.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TREE_CONSTRUCTION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TREE_CONSTRUCTION_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Remover.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Vertex_budgets.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Edge_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_insertion.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Rule_placement.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Separation_trees.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Tree_placement.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
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
  Tree_construction(State& state, Trees& trees, const typename Trees::Map& map,
                    const Kernel_mesh<Geometry>& domain, Report& report)
      : state_(state), mesh_(state.mesh), trees_(trees), map_(map), report_(report),
        triangles_(Edge_triangles<Geometry>::template of<ConcurrencyTag>(domain, state.edges,
                                                                         state.problem.input_points.size())) {
  }

  /// Replaces the mesh. What is below the bound at the end is on the worklist. `shall_go_on()` is asked once a round.
  /// The round that uses up the budget is the last.
  /// \pre the trees are not exhausted
  template <class Continue>
  End run(const Tree_separation_options_2& options, const Construction_budget& budget,
          const Continue& shall_go_on) {
    using Placement = Tree_separation_options_2::Placement;
    const Placement placement = options.place();
    std::size_t vertices_of_all_rounds = 0;
    for (;;) {
      ++report_.rounds;
      report_.handed_over = 0;
      make_mesh(placement);
      std::vector<Triangle_id> sharp = sharp_triangles();
      report_.triangles = mesh_.number_of_triangles();
      report_.missed_by_rule = sharp.size();
      const bool is_last = report_.rounds == options.rounds(); // blocks will leave out more than these
      if (placement == Placement::CHOSEN && !is_last) sharp = choose_corners(sharp);
      report_.missed = sharp.size();
      report_.placed = mesh_.number_of_vertices() - state_.problem.input_points.size();
      report_.leaves_of_edges = trees_.tree().number_of_leaves();
      for (const Triangle_id t : sharp) state_.push(t);
      if (sharp.empty()) return End::DONE;
      if (!shall_go_on()) return End::CANCELLED;
      if (is_last) return End::ROUNDS;
      vertices_of_all_rounds += mesh_.number_of_vertices();
      if (mesh_.number_of_vertices() >= budget.leaves || trees_.is_exhausted() ||
          vertices_of_all_rounds >= budget.vertices_of_all_rounds)
        return End::BUDGET;
      if (!trees_.refine(leaves_to_blame(sharp))) return End::COORDINATES;
    }
  }

private:
  using Grid_point = typename Trees::Grid_point;

  State& state_;
  Kernel_mesh<Geometry>& mesh_;
  Trees& trees_;
  const typename Trees::Map& map_;
  Report& report_;
  const Edge_triangles<Geometry> triangles_; // of the domain
  std::vector<Edge_id> cramped_edges_;       // of the last round

  Grid_point grid_point(const typename Geometry::Point& p) const {
    return trees_.tree().framework().grid().grid_point(map_.to_user(p));
  }

  void make_mesh(Tree_separation_options_2::Placement placement) {
    state_.clear_worklist();
    state_.corners.forget_cuts(); // those of the mesh that is replaced
    state_.bulk = {};
    const auto placed =
        placement == Tree_separation_options_2::Placement::BY_RULE
            ? Rule_placement<Traits, ConcurrencyTag>(state_.problem, trees_, triangles_).run()
            : Tree_placement<Traits, ConcurrencyTag>(state_.problem, trees_, triangles_).run();
    cramped_edges_ = Placed_insertion<ConcurrencyTag, Geometry>(state_, placed, triangles_).run();
    cramped_edges_.insert(cramped_edges_.end(), placed.cramped_edges.begin(), placed.cramped_edges.end());
    std::sort(cramped_edges_.begin(), cramped_edges_.end());
  }

  bool is_sharp(Triangle_id t) const {
    const auto& r = mesh_.triangle(t);
    const auto s = mesh_.shape(r);
    return state_.bounds.is_sharp(s) && !state_.is_exempt(r.v[0], r.v[1], r.v[2]);
  }

  std::vector<Triangle_id> sharp_triangles() const {
    return pack_values<ConcurrencyTag, Triangle_id>(
        mesh_.triangles.size(), [&](std::size_t t) { return is_sharp(static_cast<Triangle_id>(t)); },
        [](std::size_t t) { return static_cast<Triangle_id>(t); });
  }

  /// Cures triangles by leaving out a vertex; returns those left.
  std::vector<Triangle_id> choose_corners(const std::vector<Triangle_id>& sharp) {
    Remover<Geometry> remover(state_);
    report_.left_out = 0;
    for (const Triangle_id t : sharp)
      if (mesh_.is_alive(t) && is_sharp(t) && leave_out_vertex_of(t, remover)) ++report_.left_out;
    std::vector<Triangle_id> left;
    for (const Triangle_id t : sharp)
      if (mesh_.is_alive(t) && is_sharp(t)) left.push_back(t);
    return left;
  }

  bool leave_out_vertex_of(Triangle_id t, Remover<Geometry>& remover) {
    const auto r = mesh_.triangle(t);
    return std::any_of(std::begin(r.v), std::end(r.v), [&](Vertex_id v) { return remover.remove(v); });
  }

  /// After this many rounds all leaves around a triangle's vertices are split: what is left then is often a change of
  /// sizes that meets an edge under the same angle again and again.
  static constexpr std::size_t rounds_of_largest_leaves_ = 3;

  /// Whether splitting a leaf may help: it can be split, and its edges can get vertices.
  bool has_room(Leaf_index l) const {
    const auto pieces = trees_.pieces_in_leaves()[l];
    return trees_.is_splittable(l) && std::none_of(pieces.begin(), pieces.end(), [this](const Edge_piece& p) {
             return std::binary_search(cramped_edges_.begin(), cramped_edges_.end(),
                                       static_cast<Edge_id>(p.segment.value()));
           });
  }

  /// The leaves around the vertices of each triangle: the largest ones, or all. If one of them has no room,
  /// the triangle is left to refinement.
  std::vector<Leaf_index> leaves_to_blame(const std::vector<Triangle_id>& sharp) {
    std::vector<Leaf_index> leaves, around;
    const auto& tree = trees_.tree();
    for (const Triangle_id t : sharp) {
      around.clear();
      for (const Vertex_id v : mesh_.triangle(t).v) append_leaves_at(mesh_.point(v), around);
      if (!std::all_of(around.begin(), around.end(), [this](Leaf_index l) { return has_room(l); })) {
        ++report_.handed_over;
        continue;
      }
      int level = tree.framework().grid().depth();
      for (const Leaf_index l : around) level = std::min(level, tree.level(l));
      for (const Leaf_index l : around)
        if (tree.level(l) == level || report_.rounds > rounds_of_largest_leaves_) leaves.push_back(l);
    }
    std::sort(leaves.begin(), leaves.end());
    leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
    return leaves;
  }

  /// The leaves that a point is in, or on the border of.
  void append_leaves_at(const typename Geometry::Point& p, std::vector<Leaf_index>& leaves) const {
    using Word = typename Grid_point::Word;
    const Grid_point g = grid_point(p);
    const auto before = [](const Word& w) { return w == 0 ? w : static_cast<Word>(w - 1); };
    for (const Word& x : {before(g.x), g.x})
      for (const Word& y : {before(g.y), g.y}) leaves.push_back(trees_.tree().locate(Grid_point{x, y}));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TREE_CONSTRUCTION_H
