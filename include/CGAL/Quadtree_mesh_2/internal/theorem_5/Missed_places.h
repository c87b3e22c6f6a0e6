// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What is done to a quadtree about triangles that miss the bound, round after round.
//
// Computes: which leaves are split, and which vertices of the graph get windows (Vertex_windows.h). The largest
//           leaves at a triangle's vertices are split, or all of them. A vertex gets a window when triangles near
//           it are left in more rounds than the options say.
// Bound:    O(1) for each triangle, but for the degrees of its vertices.
// Source:   ours.
//
// Windows cost some 200 leaves each, and disturb sizes of leaves around them. So by default they come late: after two
// rounds hardly one vertex in ten thousand is left on maps (doc/guarantees.md).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_MISSED_PLACES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_MISSED_PLACES_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Tree_separation_options_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// \tparam Trees `Separation_trees`
template <class Trees>
class Missed_places {
public:
  using Geometry = typename Trees::Geometry;
  using Options = Tree_separation_options_2;

  /// What is to be done about some triangles.
  struct Measures {
    std::vector<Leaf_index> leaves;  ///< to be split; in order
    std::vector<Vertex_id> vertices; ///< that get windows; in order
    std::size_t handed_over = 0;     ///< triangles about which nothing can be done
  };

  Missed_places(const Meshing_state<Geometry>& state, const Trees& trees, const Options& options)
      : state_(state), trees_(trees), mesh_(state.mesh), options_(options) {}

  /// If a leaf around one of the vertices of a triangle has no room, the triangle is left to refinement.
  /// \param round counted from 1
  /// \param cramped_edges those without room for some of their vertices; in order
  Measures measures_for(const std::vector<Triangle_id>& missed, std::size_t round,
                        const std::vector<Edge_id>& cramped_edges) {
    Measures measures;
    std::vector<Leaf_index> around;
    for (const Triangle_id t : missed) {
      around.clear();
      for (const Vertex_id v : mesh_.triangle(t).v) append_leaves_at(mesh_.point(v), around);
      if (!std::all_of(around.begin(), around.end(),
                       [&](Leaf_index l) { return has_room(l, cramped_edges); }))
        ++measures.handed_over;
      else if (!find_vertices_that_failed(t, around, round, measures.vertices))
        append_leaves_to_split(around, round, measures.leaves);
    }
    make_unique(measures.leaves), make_unique(measures.vertices);
    return measures;
  }

private:
  /// After this many rounds all leaves around a triangle's vertices are split: what is left then is often a change of
  /// sizes that meets an edge under the same angle again and again.
  static constexpr std::size_t rounds_of_largest_leaves_ = 3;
  /// In sides of the largest leaves around a triangle: vertices nearer than this are near it.
  static constexpr double near_vertex_ = 5;

  struct Failures {
    std::size_t number = 0; ///< of rounds in which a triangle near the vertex was left
    std::size_t last = 0;   ///< of these rounds
  };

  const Meshing_state<Geometry>& state_;
  const Trees& trees_;
  const Kernel_mesh<Geometry>& mesh_;
  const Options options_;
  Indexed_vector<Vertex_id, Failures> failures_; // of input vertices

  template <class List>
  static void make_unique(List& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  /// Whether splitting a leaf may help: it can be split, and its edges can get vertices.
  bool has_room(Leaf_index l, const std::vector<Edge_id>& cramped_edges) const {
    const auto pieces = trees_.pieces_in_leaves()[l];
    return trees_.is_splittable(l) && std::none_of(pieces.begin(), pieces.end(), [&](const auto& p) {
             return std::binary_search(cramped_edges.begin(), cramped_edges.end(),
                                       static_cast<Edge_id>(p.segment.value()));
           });
  }

  void append_leaves_to_split(const std::vector<Leaf_index>& around, std::size_t round,
                              std::vector<Leaf_index>& leaves) const {
    const auto& tree = trees_.tree();
    int level = tree.framework().grid().depth();
    for (const Leaf_index l : around) level = std::min(level, tree.level(l));
    for (const Leaf_index l : around)
      if (tree.level(l) == level || round > rounds_of_largest_leaves_) leaves.push_back(l);
  }

  /// Notes that vertices near a triangle fail. Appends those that have failed often enough and have no window yet, and
  /// returns whether there are any.
  bool find_vertices_that_failed(Triangle_id t, const std::vector<Leaf_index>& around, std::size_t round,
                                 std::vector<Vertex_id>& vertices) {
    if (options_.place() != Options::Placement::CHOSEN) return false;
    if (failures_.empty()) failures_ = decltype(failures_)(state_.problem.number_of_input_points());
    bool is_any = false;
    for (const Vertex_id v : vertices_near(t, around)) {
      Failures& failures = failures_[v];
      if (failures.last != round) failures = {failures.number + 1, round};
      if (failures.number <= options_.failures_before_window() || trees_.windows().has(v)) continue;
      vertices.push_back(v);
      is_any = true;
    }
    return is_any;
  }

  /// The input vertices of a triangle. If there are none, the nearest of the ends of edges in the leaves around it, if
  /// it is near.
  std::vector<Vertex_id> vertices_near(Triangle_id t, const std::vector<Leaf_index>& around) const {
    std::vector<Vertex_id> vertices;
    for (const Vertex_id v : mesh_.triangle(t).v)
      if (mesh_.is_input(v)) vertices.push_back(v);
    if (!vertices.empty()) return vertices;
    const auto& p = mesh_.point(mesh_.triangle(t).v[0]);
    double side = 0;
    for (const Leaf_index l : around) side = std::max(side, trees_.side(l));
    double least = near_vertex_ * side;
    for (const Leaf_index l : around)
      for (const auto& piece : trees_.pieces_in_leaves()[l]) {
        const Input_edge& e = state_.problem.edges[static_cast<Edge_id>(piece.segment.value())];
        for (const Vertex_id v : {e.a, e.b}) {
          const Vector way = Geometry::difference(state_.problem.input_point(v), p);
          const double distance = std::sqrt(squared_length(way));
          if (distance >= least) continue;
          least = distance;
          vertices.assign(1, v);
        }
      }
    return vertices;
  }

  /// The leaves that a point is in, or on the border of.
  void append_leaves_at(const typename Geometry::Point& p, std::vector<Leaf_index>& leaves) const {
    using Grid_point = typename Trees::Grid_point;
    using Word = typename Grid_point::Word;
    const Grid_point g = trees_.grid_point(p);
    const auto before = [](const Word& w) { return w == 0 ? w : static_cast<Word>(w - 1); };
    for (const Word& x : {before(g.x), g.x})
      for (const Word& y : {before(g.y), g.y}) leaves.push_back(trees_.tree().locate(Grid_point{x, y}));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_MISSED_PLACES_H
