// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What the benchmark of meshes of points measures, whichever mesher it is.

#ifndef QUADTREE_MESH_2_BENCHMARK_POINTS_RUN_H
#define QUADTREE_MESH_2_BENCHMARK_POINTS_RUN_H

#include "pslg_run.h"
#include "quadtree_inputs.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// What is to be meshed.
struct Points_task {
  const Points& points;
  const Pslg& box; ///< the points and the box around them that peers fill
  unsigned limit_seconds;
  double limit_gigabytes;
};

/// What one run gave; of fixed size, for it goes through a pipe.
struct Points_run : Pslg_run {
  std::size_t before_coarsening = 0; ///< triangles; 0 if the mesher does not coarsen
  std::size_t clusters = 0;
  std::size_t rounds = 0;
};

/// A way to mesh points.
struct Points_method {
  using Task = Points_task;
  using Run = Points_run;

  std::string name;
  unsigned threads; ///< 0: sequential
  std::vector<std::string> phases;
  std::string rival; ///< of a peer: the mode of ours it is compared with
  /// One run in a process of its own; nothing if it failed or took too long.
  std::function<std::optional<Points_run>(const Points_task&, Check)> run;

  bool is_peer() const { return !rival.empty(); }
};

#endif // QUADTREE_MESH_2_BENCHMARK_POINTS_RUN_H
