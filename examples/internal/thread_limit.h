// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_THREAD_LIMIT_H
#define QUADTREE_MESH_2_BENCHMARK_THREAD_LIMIT_H

#include "resources.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <memory>
#include <thread>

/// Lets parallel algorithms have so many threads while it lives, and starts them: a program does so once, not
/// for every tree. 0 leaves everything as it is.
class Thread_limit {
public:
  /// How many threads there may be at once.
  static unsigned greatest() { return has_threads ? std::max(1u, std::thread::hardware_concurrency()) : 1; }

#ifdef CGAL_LINKED_WITH_TBB
  static constexpr bool has_threads = true;

  explicit Thread_limit(unsigned threads) {
    using Control = tbb::global_control;
    if (threads == 0) return;
    control_ = std::make_unique<Control>(Control::max_allowed_parallelism, threads);
    tbb::parallel_for(0u, 4 * threads, [](unsigned) {
      const double end = wall_seconds() + 0.001;
      while (wall_seconds() < end) {
      }
    });
  }

private:
  std::unique_ptr<tbb::global_control> control_;
#else
  static constexpr bool has_threads = false;

  explicit Thread_limit(unsigned) {}
#endif
};

#endif // QUADTREE_MESH_2_BENCHMARK_THREAD_LIMIT_H
