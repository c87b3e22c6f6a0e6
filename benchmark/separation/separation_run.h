// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What the benchmark of separations measures, and the ways to separate.

#ifndef QUADTREE_MESH_2_BENCHMARK_SEPARATION_RUN_H
#define QUADTREE_MESH_2_BENCHMARK_SEPARATION_RUN_H

#include "in_child.h"
#include "mesh_digest.h"
#include "method_outcome.h"
#include "pslg_run.h"
#include "thread_limit.h"

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/Trapezoidal_vertex_edge_neighbors_2.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// What one run gave; of fixed size, for it goes through a pipe.
struct Separation_run : Pslg_run {
  std::array<double, 7> phases{}; ///< processor seconds of `separation_phases`
  CGAL::Tree_separation_report_2 trees;
  std::size_t before_removal = 0; ///< triangles; with a check only
};

inline constexpr std::array<const char*, 7> separation_phases{"quadtree", "first mesh", "trees",  "construct",
                                                              "refine",   "coarsen",    "convert"};

/// A way to mesh.
struct Separation_method {
  using Task = Pslg_task;
  using Run = Separation_run;

  std::string mesh; ///< methods of one name make the same mesh
  std::string how;  ///< how they make it; may be empty
  unsigned threads; ///< 0: sequential
  CGAL::Quality_mesh_options_2 options;
  bool finds_by_trapezoids = false; ///< with Theorem 5

  std::string name() const {
    return mesh + (how.empty() ? "" : ", " + how) +
           (threads == 0 ? "" : ", " + std::to_string(threads) + " threads");
  }
  /// One run in a process of its own; nothing if it failed or took too long.
  std::optional<Run> run(const Task& task, Check check) const;
};

namespace separation_internal {

using Traits = CGAL::Filtered_quadtree_traits_2<>;

template <class ConcurrencyTag>
Separation_run mesh(const Separation_method& method, const Pslg_task& task, Check check) {
  using Options = CGAL::Quality_mesh_options_2;
  const Thread_limit limit(method.threads);
  Separation_run run;
  Options options = method.options;
  options.min_angle(task.min_angle).max_area(task.max_area);
  CGAL::Quality_mesher_2<Traits, ConcurrencyTag> mesher(options);
  if (method.finds_by_trapezoids)
    mesher.template find_neighbors_by<CGAL::Trapezoidal_vertex_edge_neighbors_2<Traits, ConcurrencyTag>>();
  const Stopwatch watch;
  const Indexed_mesh mesh = mesher(task.pslg);
  run.mesh = watch.seconds();
  run.peak_memory_mb = peak_memory_mb();

  const auto& report = mesher.report();
  const auto& s = report.seconds;
  run.phases = {s.quadtree, s.first_mesh, s.trees, s.construct, s.refine, s.coarsen, s.convert};
  run.vertices = report.vertices;
  run.triangles = report.triangles;
  run.trees = report.trees;
  run.digest = mesh_digest(mesh);
  if (check == Check::NO) return run;
  check_mesh(mesh, task, CGAL::Mesh_quality_options_2::Arrays::ALL, run);
  CGAL::Quality_mesher_2<Traits, ConcurrencyTag> whole(
      options.smooth(0).thin(0).coarsen(Options::Coarsening::NONE));
  run.before_removal = whole(task.pslg).triangles.size();
  return run;
}

} // namespace separation_internal

inline std::optional<Separation_run> Separation_method::run(const Pslg_task& task, Check check) const {
  using namespace separation_internal;
  const auto in_process = [&] {
#ifdef CGAL_LINKED_WITH_TBB
    if (threads > 0) return separation_internal::mesh<CGAL::Parallel_tag>(*this, task, check);
#endif
    return separation_internal::mesh<CGAL::Sequential_tag>(*this, task, check);
  };
  return in_child(in_process, task.limit_seconds).result;
}

/// On demand, as it is and with rounds of smoothing and thinning; the construction by quadtrees in its
/// variants; and with each number of threads.
inline std::vector<Separation_method> separation_methods(const std::vector<unsigned>& threads) {
  using Options = CGAL::Quality_mesh_options_2;
  using Trees = CGAL::Tree_separation_options_2;
  const Trees walking, centroids = Trees().subdivide(Trees::Subdivision::CENTROID_TREE),
                       rays = Trees().find_distances_by(Trees::Distances::AXIS_RAYS),
                       all = Trees::of_theorem();
  std::vector<Separation_method> methods{
      {"on demand", "", 0, Options()},
      {"on demand, smoothed and thinned", "", 0, Options().smooth(2).thin(2)},
      {"Theorem 5", "", 0, Options().separate(walking)},
      {"Theorem 5", "centroid trees", 0, Options().separate(centroids)},
      {"Theorem 5, distances by trapezoids", "", 0, Options().separate(rays), true},
      {"Theorem 5, all rounds", "", 0, Options().separate(all)}};
  for (const unsigned n : threads) {
    methods.push_back({"on demand", "", n, Options()});
    methods.push_back({"Theorem 5", "", n, Options().separate(walking)});
  }
  return methods;
}

#endif // QUADTREE_MESH_2_BENCHMARK_SEPARATION_RUN_H
