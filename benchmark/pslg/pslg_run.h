// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What the benchmark of meshers measures, whichever mesher it is.

#ifndef QUADTREE_MESH_2_BENCHMARK_PSLG_RUN_H
#define QUADTREE_MESH_2_BENCHMARK_PSLG_RUN_H

#include "measurement.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/mesh_quality_2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

using Pslg_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Pslg = CGAL::Pslg_2<Pslg_point>;
using Indexed_mesh = CGAL::Indexed_mesh_2<Pslg_point>;

/// What is to be meshed.
struct Pslg_task {
  const Pslg& pslg;
  double max_area;  ///< 0: no bound
  double min_angle; ///< degrees
  unsigned limit_seconds;
  double max_angle = 0; ///< degrees; triangles with a greater angle are counted; 0: they are not
};

/// What one run gave; of fixed size, for it goes through a pipe.
struct Pslg_run {
  Seconds mesh;                   ///< from points and segments in memory to a mesh in memory
  std::array<double, 5> phases{}; ///< processor seconds of the mesher's phases
  double to_triangulation = 0;    ///< processor seconds from the mesh to a triangulation of CGAL
  double peak_memory_mb = 0;      ///< until the mesh is made
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::uint64_t digest = 0; ///< of all bits of the mesh; 0 if the mesher has none

  // With a check only:
  std::size_t below_bound = 0; ///< triangles that miss the bound on angles where no acute corner forces it
  std::size_t exempt = 0;      ///< those where one does
  double min_angle = 0;        ///< degrees
  double max_angle = 0;
  std::size_t above_max_angle =
      0;                       ///< triangles above the task's greatest angle where no acute corner excuses it
  double max_exempt_angle = 0; ///< the greatest angle where one does; only of our mesher
  double total_length = 0;     ///< of all edges
  bool is_valid = false;
};

/// A way to mesh.
struct Pslg_method {
  using Task = Pslg_task;
  using Run = Pslg_run;

  std::string name;
  unsigned threads; ///< 0: sequential
  std::vector<std::string> phases;
  /// One run in a process of its own; nothing if it failed or took too long.
  std::function<std::optional<Pslg_run>(const Pslg_task&, Check)> run;
};

/// Looks at a mesh by the rules that hold for all meshers. Errors are printed.
inline void check_mesh(const Indexed_mesh& mesh, const Pslg_task& task,
                       CGAL::Mesh_quality_options_2::Arrays arrays, Pslg_run& run) {
  const auto quality = CGAL::mesh_quality_2(mesh, task.pslg,
                                            CGAL::Mesh_quality_options_2()
                                                .min_angle(task.min_angle)
                                                .max_angle(task.max_angle)
                                                .max_area(task.max_area)
                                                .check_arrays(arrays));
  for (const auto& unmet : quality.unmet_triangles) {
    run.below_bound += unmet.bound == CGAL::Mesh_quality_2::Bound::ANGLE;
    run.above_max_angle += unmet.bound == CGAL::Mesh_quality_2::Bound::GREATEST_ANGLE;
  }
  run.exempt = quality.exempt_triangles;
  run.min_angle = quality.min_angle;
  run.max_angle = quality.max_angle;
  run.total_length = quality.total_length;
  run.is_valid = quality.is_valid();
  if (!run.is_valid) std::fprintf(stderr, "invalid mesh: %s\n", quality.errors.front().c_str());
}

#endif // QUADTREE_MESH_2_BENCHMARK_PSLG_RUN_H
