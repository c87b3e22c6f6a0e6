// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_QUADTREE_RUN_H
#define QUADTREE_MESH_2_BENCHMARK_QUADTREE_RUN_H

#include "measurement.h"
#include "quadtree_inputs.h"
#include "resources.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

/// Which balance a tree has: those with the same can be compared.
enum class Product { NOTHING, SORTED_KEYS, FRAMEWORK, UNBALANCED, SIDES, CORNERS };

inline const char* name_of(Product product) {
  static constexpr std::array<const char*, 6> names{"nothing",    "sorted keys", "framework",
                                                    "unbalanced", "sides",       "sides and corners"};
  return names[std::size_t(product)];
}

/// What a process that makes trees tells of itself.
struct Run {
  struct Stage {
    Seconds seconds;
    std::size_t size = 0; ///< squares of the framework, or leaves, when the stage is over
  };

  std::array<Stage, 3> stages;
  std::size_t crowded_leaves = 0; ///< with several points, in which the method did not meet the task
  int depth = 0;
  double memory_before_mb = 0; ///< the most before the first stage: the program and the points
};

/// Takes the time of one stage after the other.
class Run_recorder {
public:
  Run_recorder() {
    run_.memory_before_mb = peak_memory_mb();
    start();
  }

  /// Begins a stage; what happens between the end of the last one and this is nobody's.
  void start() { start_ = {cpu_seconds(), wall_seconds()}; }

  /// Ends a stage.
  void stop() {
    Seconds& seconds = run_.stages[number_of_stages_++].seconds;
    seconds.cpu = cpu_seconds() - start_.cpu;
    seconds.wall = wall_seconds() - start_.wall;
  }

  void set_size(std::size_t size) { run_.stages[number_of_stages_ - 1].size = size; }
  void set_depth(int depth) { run_.depth = depth; }
  void set_crowded_leaves(std::size_t n) { run_.crowded_leaves = n; }

  const Run& run() const { return run_; }

private:
  Run run_;
  Seconds start_;
  std::size_t number_of_stages_ = 0;
};

/// One way to make trees, or to do a part of the work, of points in memory.
struct Method {
  struct Stage {
    std::string name;
    Product product; ///< what there is when the stage is over
  };

  std::string name;
  std::vector<Stage> stages;
  std::function<Run(const Points&)> run;
  unsigned threads = 0; ///< 0 if the method is sequential
};

#endif // QUADTREE_MESH_2_BENCHMARK_QUADTREE_RUN_H
