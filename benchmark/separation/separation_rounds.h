// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// How many parallel rounds Theorem 5 takes: those of its stages, and all loops of the mesher, from the input to the
// mesh.

#ifndef QUADTREE_MESH_2_BENCHMARK_SEPARATION_ROUNDS_H
#define QUADTREE_MESH_2_BENCHMARK_SEPARATION_ROUNDS_H

#include "in_child.h"
#include "pslg_run.h"
#include "quadtree_rounds.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Phase_clock.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Vertex_blocks.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/Trapezoidal_vertex_edge_neighbors_2.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// Whoever counts wants small blocks, so that a step is short and the number of blocks shows.
template <>
struct CGAL::Quadtree_mesh_2::internal::Block_sizes<Counted_tag> {
  static constexpr std::size_t vertices = 256;
  static constexpr std::size_t triangles = 512;
};

/// The steps of the phases of one run of the mesher, in which all loops are counted.
class Phase_steps {
public:
  using Phase = double CGAL::Quality_mesh_report_2::Seconds::*;

  static Phase_steps& instance() {
    static Phase_steps steps;
    return steps;
  }

  void clear() { *this = Phase_steps(); }
  void end(Phase phase) {
    const std::size_t now = Round_counter::instance().so_far().steps;
    steps_.emplace_back(phase, now - before_);
    before_ = now;
  }
  std::size_t of(Phase phase) const {
    std::size_t sum = 0;
    for (const auto& [p, steps] : steps_) sum += p == phase ? steps : 0;
    return sum;
  }

private:
  std::size_t before_ = 0;
  std::vector<std::pair<Phase, std::size_t>> steps_;
};

template <>
struct CGAL::Quadtree_mesh_2::internal::Phase_watch<Counted_tag> {
  static void end(Phase_steps::Phase phase) { Phase_steps::instance().end(phase); }
};

/// A round is one parallel step: all that is in it may be done at the same time, and its tasks are as long as a block.
struct Separation_rounds {
  std::size_t of_points = 0;    ///< T_B
  std::size_t of_neighbors = 0; ///< trapezoidal decompositions and what vertices see along the axes
  std::size_t splits = 0;       ///< from T_B' to T_B*, each a level of some leaves
  std::size_t subdivisions = 0; ///< of edges by centroid trees, after each split
  std::size_t placings = 0;     ///< of vertices
  std::size_t triangles = 0;    ///< of these vertices
  std::size_t leaves = 0;       ///< of T_B*
  int centroid_height = 0;
  // Steps of all loops of the mesher, by phase:
  std::size_t of_input = 0;   ///< the order, the triangulation of the graph, the domain
  std::size_t of_trees = 0;   ///< the quadtrees up to T_B*
  std::size_t of_placing = 0; ///< all placings, the triangulation of each, choice of corners, and splits
  std::size_t of_cure = 0;    ///< refinement of what is left, in blocks, with removal and thinning there
  std::size_t of_removal = 0; ///< what follows in the whole mesh
  std::size_t of_output = 0;
  double serial_share = 0; ///< of the processor time, spent outside of loops: on one thread

  /// Of the stages up to the rule's vertices; a triangulation counts as one.
  std::size_t all() const { return of_points + of_neighbors + splits + subdivisions + placings; }
  /// Of the whole run.
  std::size_t steps() const { return of_input + of_trees + of_placing + of_cure + of_removal + of_output; }
  /// log2 k log2 n for n vertices and k triangles: Theorem 5 takes O(1) times that.
  double bound(std::size_t n) const { return std::log2(double(triangles)) * std::log2(double(n)); }
};

inline Separation_rounds count_separation_rounds(const Pslg_task& task) {
  using Traits = CGAL::Filtered_quadtree_traits_2<>;
  using Trees = CGAL::Tree_separation_options_2;
  using Neighbors = CGAL::Trapezoidal_vertex_edge_neighbors_2<Traits, Counted_tag>;
  using Phases = CGAL::Quality_mesh_report_2::Seconds;
  Round_counter& counter = Round_counter::instance();
  Separation_rounds rounds;
  rounds.of_points =
      counter
          .count([&] {
            CGAL::Balanced_quadtree<Traits, Counted_tag> tree(
                task.pslg.vertices,
                CGAL::Quadtree_options().schedule(CGAL::Quadtree_options::Balance_schedule::SPACED_LEVELS));
          })
          .steps;
  rounds.of_neighbors = counter.count([&] { Neighbors neighbors(task.pslg); }).steps;
  CGAL::Quality_mesher_2<Traits, Counted_tag> mesher(
      CGAL::Quality_mesh_options_2()
          .min_angle(task.min_angle)
          .max_area(task.max_area)
          .separate(Trees::of_theorem().subdivide(Trees::Subdivision::CENTROID_TREE)));
  Phase_steps& steps = Phase_steps::instance();
  steps.clear();
  const Rounds whole = counter.count([&] { mesher(task.pslg); });
  rounds.serial_share = whole.serial / whole.work;
  rounds.of_input = steps.of(&Phases::quadtree) + steps.of(&Phases::first_mesh);
  rounds.of_trees = steps.of(&Phases::trees);
  rounds.of_placing = steps.of(&Phases::construct);
  rounds.of_cure = steps.of(&Phases::refine);
  rounds.of_removal = steps.of(&Phases::coarsen);
  rounds.of_output = steps.of(&Phases::convert);
  const CGAL::Tree_separation_report_2& trees = mesher.report().trees;
  rounds.splits = trees.splits;
  rounds.subdivisions = trees.subdivision_rounds;
  rounds.placings = trees.rounds;
  rounds.triangles = trees.triangles;
  rounds.leaves = trees.leaves_of_edges;
  rounds.centroid_height = trees.centroid_height;
  return rounds;
}

#endif // QUADTREE_MESH_2_BENCHMARK_SEPARATION_ROUNDS_H
