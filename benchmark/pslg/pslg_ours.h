// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Our mesher as the benchmark sees it. What it knows of its interface is here.

#ifndef QUADTREE_MESH_2_BENCHMARK_PSLG_OURS_H
#define QUADTREE_MESH_2_BENCHMARK_PSLG_OURS_H

#include "in_child.h"
#include "mesh_digest.h"
#include "pslg_run.h"
#include "thread_limit.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/indexed_mesh_to_triangulation_2.h>
#include <CGAL/tags.h>

#include <optional>
#include <string>
#include <vector>

namespace pslg_ours {

using Traits = CGAL::Filtered_quadtree_traits_2<>;

#ifdef CGAL_LINKED_WITH_TBB
constexpr bool has_threads = true;
#else
constexpr bool has_threads = false;
#endif

/// Processor seconds for what a program needs that goes on with CGAL's triangulations.
inline double seconds_to_triangulation(const Indexed_mesh& mesh, const Pslg& pslg) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Tds = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
                                                   CGAL::Delaunay_mesh_face_base_2<Kernel>>;
  CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds> cdt;
  const Stopwatch watch;
  CGAL::indexed_mesh_to_constrained_Delaunay_triangulation_2(mesh, pslg, cdt);
  return watch.seconds().cpu;
}

template <class ConcurrencyTag>
Pslg_run mesh(const Pslg_task& task, Check check, unsigned threads) {
  const Thread_limit limit(threads);
  Pslg_run run;
  CGAL::Quality_mesher_2<Traits, ConcurrencyTag> mesher(
      CGAL::Quality_mesh_options_2().min_angle(task.min_angle).max_area(task.max_area));
  const Stopwatch watch;
  const Indexed_mesh mesh = mesher(task.pslg);
  run.mesh = watch.seconds();
  run.peak_memory_mb = peak_memory_mb();

  const auto& report = mesher.report();
  const auto& seconds = report.seconds;
  run.phases = {seconds.quadtree, seconds.first_mesh, seconds.refine, seconds.coarsen, seconds.convert};
  run.vertices = report.vertices;
  run.triangles = report.triangles;
  run.digest = mesh_digest(mesh);
  if (check == Check::YES) check_mesh(mesh, task, CGAL::Mesh_quality_options_2::Arrays::ALL, run);
  run.to_triangulation = seconds_to_triangulation(mesh, task.pslg);
  return run;
}

template <class ConcurrencyTag>
Pslg_method method(const std::string& name, unsigned threads) {
  return {name,
          threads,
          {"quadtree", "first mesh", "refine", "coarsen", "convert"},
          [threads](const Pslg_task& task, Check check) {
            return in_child([&] { return mesh<ConcurrencyTag>(task, check, threads); }, task.limit_seconds)
                .result;
          }};
}

/// The sequential mesher, and the parallel one with each number of threads.
inline std::vector<Pslg_method> methods(const std::vector<unsigned>& threads) {
  std::vector<Pslg_method> result{method<CGAL::Sequential_tag>("ours", 0)};
  if constexpr (has_threads)
    for (const unsigned n : threads)
      result.push_back(
          method<CGAL::Parallel_tag>("ours, " + std::to_string(n) + (n == 1 ? " thread" : " threads"), n));
  return result;
}

} // namespace pslg_ours

#endif // QUADTREE_MESH_2_BENCHMARK_PSLG_OURS_H
