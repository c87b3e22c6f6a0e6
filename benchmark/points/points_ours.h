// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Our mesher of points as the benchmark sees it. What it knows of its interface is here.

#ifndef QUADTREE_MESH_2_BENCHMARK_POINTS_OURS_H
#define QUADTREE_MESH_2_BENCHMARK_POINTS_OURS_H

#include "in_child.h"
#include "mesh_digest.h"
#include "points_run.h"
#include "thread_limit.h"

#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace points_ours {

using Traits = CGAL::Filtered_quadtree_traits_2<>;
using Options = CGAL::Point_set_mesh_options_2;

#ifdef CGAL_LINKED_WITH_TBB
constexpr bool has_threads = true;
#else
constexpr bool has_threads = false;
#endif

/// What is asked for, and the range that all angles have to be in.
struct Mode {
  std::string name;
  Options options;
  double least_angle, largest_angle; ///< degrees
};

inline const std::vector<Mode>& all_modes() {
  static const std::vector<Mode> modes{{"bounded", Options(), 36, 80},
                                       {"tight", Options().bounded_angles(37.5, 78.6), 37.5, 78.6},
                                       {"wide", Options().bounded_angles(30, 89.5), 30, 89.5},
                                       {"acute", Options().acute(), 0, 90},
                                       {"points", Options().least_angle(), 20.7, 180},
                                       {"warped", Options().warped_squares(), 22.46, 112.64}};
  return modes;
}

/// A mode by its name, with an effort if there is one: "bounded", "bounded:0".
inline Mode mode_by_name(const std::string& name) {
  const std::size_t colon = name.find(':');
  for (Mode mode : all_modes()) {
    if (mode.name != name.substr(0, colon)) continue;
    if (colon == std::string::npos) return mode;
    const std::string effort = name.substr(colon + 1);
    if (effort.size() != 1 || effort[0] < '0' || effort[0] > '3') break;
    mode.options.effort(effort[0] - '0');
    mode.name = name;
    return mode;
  }
  throw std::invalid_argument("there is no mode '" + name + "'");
}

/// Looks at a mesh by what is promised. Errors are printed.
template <class Mesh>
void check_mesh(const Mesh& mesh, const Points_task& task, const Mode& mode, Points_run& run) {
  using Quality_options = CGAL::Mesh_quality_options_2;
  Pslg points;
  points.vertices = task.points;
  const auto quality = CGAL::mesh_quality_2(
      mesh, points, Quality_options().min_angle(mode.least_angle).check_domain(Quality_options::Domain::ANY));
  run.below_bound = quality.unmet_triangles.size();
  run.min_angle = quality.min_angle;
  run.max_angle = quality.max_angle;
  run.total_length = quality.total_length;
  // Angles are rounded here.
  constexpr double tolerance = 1e-9;
  const bool is_met =
      quality.min_angle > mode.least_angle - tolerance && quality.max_angle < mode.largest_angle + tolerance;
  run.is_valid = quality.is_valid() && is_met;
  if (!quality.is_valid())
    std::fprintf(stderr, "invalid mesh: %s\n", quality.errors.front().c_str());
  else if (!is_met)
    std::fprintf(stderr, "%s: angles of %.9f to %.9f degrees\n", mode.name.c_str(), quality.min_angle,
                 quality.max_angle);
}

template <class ConcurrencyTag>
Points_run mesh(const Points_task& task, Check check, const Mode& mode, unsigned threads) {
  limit_memory(task.limit_gigabytes);
  const Thread_limit limit(threads);
  Points_run run;
  CGAL::Point_set_mesher_2<Traits, ConcurrencyTag> mesher(mode.options);
  const Stopwatch watch;
  const auto mesh = mesher(task.points);
  run.mesh = watch.seconds();
  run.peak_memory_mb = peak_memory_mb();

  const auto& report = mesher.report();
  const auto& seconds = report.seconds;
  run.phases = {seconds.quadtree, seconds.separate, seconds.coarsen, seconds.convert};
  run.vertices = report.vertices;
  run.triangles = report.triangles;
  run.before_coarsening = report.triangles_before_coarsening;
  run.clusters = report.clusters;
  run.rounds = report.rounds;
  run.digest = mesh_digest(mesh);
  if (check == Check::YES) check_mesh(mesh, task, mode, run);
  return run;
}

template <class ConcurrencyTag>
Points_method method(const std::string& name, const Mode& mode, unsigned threads) {
  return {name,
          threads,
          {"quadtree", "separate", "coarsen", "convert"},
          "",
          [mode, threads](const Points_task& task, Check check) {
            return in_child([&] { return mesh<ConcurrencyTag>(task, check, mode, threads); },
                            task.limit_seconds)
                .result;
          }};
}

/// The sequential mesher in a mode, and the parallel one with each number of threads.
inline std::vector<Points_method> methods(const std::string& mode_name,
                                          const std::vector<unsigned>& threads) {
  const Mode mode = mode_by_name(mode_name);
  std::vector<Points_method> result{method<CGAL::Sequential_tag>(mode_name, mode, 0)};
  if constexpr (has_threads)
    for (const unsigned n : threads)
      result.push_back(
          method<CGAL::Parallel_tag>(mode_name + ", " + std::to_string(n) + " threads", mode, n));
  return result;
}

} // namespace points_ours

#endif // QUADTREE_MESH_2_BENCHMARK_POINTS_OURS_H
