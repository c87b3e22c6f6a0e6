// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// How many parallel rounds the stages of Theorem 5 take.

#ifndef QUADTREE_MESH_2_BENCHMARK_SEPARATION_ROUNDS_H
#define QUADTREE_MESH_2_BENCHMARK_SEPARATION_ROUNDS_H

#include "in_child.h"
#include "pslg_run.h"
#include "quadtree_rounds.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/Trapezoidal_vertex_edge_neighbors_2.h>

#include <cmath>
#include <cstddef>
#include <optional>

/// A round is one parallel step: all that is in it may be done at the same time.
struct Separation_rounds {
  std::size_t of_points = 0;    ///< T_B
  std::size_t of_neighbors = 0; ///< trapezoidal decompositions and what vertices see along the axes
  std::size_t splits = 0;       ///< from T_B' to T_B*, each a level of some leaves
  std::size_t subdivisions = 0; ///< of edges by centroid trees, after each split
  std::size_t placings = 0;     ///< of vertices
  std::size_t triangles = 0;    ///< of these vertices
  std::size_t leaves = 0;       ///< of T_B*
  int centroid_height = 0;

  std::size_t all() const { return of_points + of_neighbors + splits + subdivisions + placings; }
  /// log2 k log2 n for n vertices and k triangles: Theorem 5 takes O(1) times that.
  double bound(std::size_t n) const { return std::log2(double(triangles)) * std::log2(double(n)); }
};

inline Separation_rounds count_separation_rounds(const Pslg_task& task) {
  using Traits = CGAL::Filtered_quadtree_traits_2<>;
  using Trees = CGAL::Tree_separation_options_2;
  Separation_rounds rounds;
  rounds.of_points =
      Round_counter::instance()
          .count([&] {
            CGAL::Balanced_quadtree<Traits, Counted_tag> tree(
                task.pslg.vertices,
                CGAL::Quadtree_options().schedule(CGAL::Quadtree_options::Balance_schedule::SPACED_LEVELS));
          })
          .steps;
  rounds.of_neighbors =
      Round_counter::instance()
          .count([&] { CGAL::Trapezoidal_vertex_edge_neighbors_2<Traits, Counted_tag> neighbors(task.pslg); })
          .steps;
  CGAL::Quality_mesher_2<Traits> mesher(
      CGAL::Quality_mesh_options_2()
          .min_angle(task.min_angle)
          .max_area(task.max_area)
          .coarsen(CGAL::Quality_mesh_options_2::Coarsening::NONE)
          .separate(Trees::of_theorem().subdivide(Trees::Subdivision::CENTROID_TREE)));
  mesher(task.pslg);
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
