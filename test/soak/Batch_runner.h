// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SOAK_BATCH_RUNNER_H
#define QUADTREE_MESH_2_TEST_SOAK_BATCH_RUNNER_H

// Runs cases in child processes, several in each: one that crashes, does not end or takes all memory ends with its
// child, and the rest of its batch goes on in another.

#include "judge.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace soak {

/// Above these a case has failed.
struct Limits {
  double cpu_seconds = 20; ///< of all threads, for each run of the mesher
  double gigabytes = 1;
};

struct Result {
  Verdict verdict;
  double seconds = 0; ///< of processors
  double megabytes = 0;
};

/// Runs what `run` does for the numbers 0 to n - 1, in this process' children, and calls `done` for each in this
/// process, in order.
/// \param workers how many children there are at a time
/// \param batch how many cases a child has
/// \param shall_go_on asked before each batch; after false no more is begun
void run_in_batches(std::size_t n, unsigned workers, std::size_t batch, const Limits& limits,
                    const std::function<Verdict(std::size_t)>& run,
                    const std::function<void(std::size_t, const Result&)>& done,
                    const std::function<bool()>& shall_go_on);

/// One case in a child of its own.
Result run_alone(const Limits& limits, const std::function<Verdict()>& run);

} // namespace soak

#endif // QUADTREE_MESH_2_TEST_SOAK_BATCH_RUNNER_H
