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
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/indexed_mesh_to_triangulation_2.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
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

/// Degrees; 0 if no triangle is exempt.
inline double greatest_exempt_angle(const Indexed_mesh& mesh, const CGAL::Quality_mesh_report_2& report) {
  double greatest = 0;
  for (const auto& exempt : report.exempt_triangles) {
    const auto& t = mesh.triangles[std::size_t(exempt.triangle)];
    const CGAL::Quadtree_mesh_2::internal::Scaled_triangle triangle(mesh.point(t[0]), mesh.point(t[1]),
                                                                    mesh.point(t[2]));
    greatest = std::max(greatest, triangle.largest_angle());
  }
  return greatest;
}

/// \param max_angle the bound on the greatest angle, in degrees; 0: none
template <class ConcurrencyTag>
Pslg_run mesh(const Pslg_task& task, Check check, unsigned threads, double max_angle) {
  const Thread_limit limit(threads);
  Pslg_run run;
  CGAL::Quality_mesher_2<Traits, ConcurrencyTag> mesher(
      CGAL::Quality_mesh_options_2().min_angle(task.min_angle).max_angle(max_angle).max_area(task.max_area));
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
  if (check == Check::YES) {
    check_mesh(mesh, task, CGAL::Mesh_quality_options_2::Arrays::ALL, run);
    run.max_exempt_angle = greatest_exempt_angle(mesh, report);
  }
  run.to_triangulation = seconds_to_triangulation(mesh, task.pslg);
  return run;
}

template <class ConcurrencyTag>
Pslg_method method(const std::string& name, unsigned threads, double max_angle = 0) {
  return {name,
          threads,
          {"quadtree", "first mesh", "refine", "coarsen", "convert"},
          [threads, max_angle](const Pslg_task& task, Check check) {
            return in_child([&] { return mesh<ConcurrencyTag>(task, check, threads, max_angle); },
                            task.limit_seconds)
                .result;
          }};
}

inline std::string name_with_max_angle(double degrees) {
  char number[32];
  std::snprintf(number, sizeof number, "%g", degrees);
  return std::string("ours, no angle above ") + number;
}

/// The sequential mesher, again with a bound on the greatest angle if that is not 0, and the parallel one with each
/// number of threads.
inline std::vector<Pslg_method> methods(const std::vector<unsigned>& threads, double max_angle = 0) {
  std::vector<Pslg_method> result{method<CGAL::Sequential_tag>("ours", 0)};
  if (max_angle > 0)
    result.push_back(method<CGAL::Sequential_tag>(name_with_max_angle(max_angle), 0, max_angle));
  if constexpr (has_threads)
    for (const unsigned n : threads)
      result.push_back(
          method<CGAL::Parallel_tag>("ours, " + std::to_string(n) + (n == 1 ? " thread" : " threads"), n));
  return result;
}

} // namespace pslg_ours

#endif // QUADTREE_MESH_2_BENCHMARK_PSLG_OURS_H
