// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_THREAD_EXECUTOR_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_THREAD_EXECUTOR_H

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Runs independent tasks on threads of their own for each loop, which is slow. It replaces TBB where the
/// thread sanitizer looks for races. TBB's library is not built for the sanitizer. So the sanitizer cannot
/// see that tasks begin after everything before their loop, and end before everything after it.
struct Thread_executor {
  template <class F>
  static void run(std::size_t n, const F& f) {
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::exception_ptr error;
    const auto work = [&] {
      for (std::size_t i = next++; i < n; i = next++) {
        try {
          f(i);
        } catch (...) {
          const std::lock_guard<std::mutex> lock(mutex);
          if (!error) error = std::current_exception();
        }
      }
    };
    std::vector<std::thread> threads;
    for (std::size_t i = 1; i < std::min<std::size_t>(n, 4); ++i) threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
    if (error) std::rethrow_exception(error);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_THREAD_EXECUTOR_H
