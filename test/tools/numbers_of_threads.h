// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Runs the same with several numbers of threads.

#ifndef QUADTREE_MESH_2_TEST_NUMBERS_OF_THREADS_H
#define QUADTREE_MESH_2_TEST_NUMBERS_OF_THREADS_H

#include "catch.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <vector>

/// Numbers of threads to compare.
inline std::vector<std::size_t> numbers_of_threads() { return {1, 2, 4}; }

/// Calls `f()` while so many threads may run.
template <class F>
void for_numbers_of_threads(const F& f) {
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t threads : numbers_of_threads()) {
    CAPTURE(threads);
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    f();
  }
#else
  f();
#endif
}

#endif // QUADTREE_MESH_2_TEST_NUMBERS_OF_THREADS_H
