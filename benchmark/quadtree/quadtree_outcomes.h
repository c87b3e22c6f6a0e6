// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_QUADTREE_OUTCOMES_H
#define QUADTREE_MESH_2_BENCHMARK_QUADTREE_OUTCOMES_H

#include "in_child.h"
#include "quadtree_run.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// The runs of one method on one input, summed up.
struct Outcome {
  struct Stage {
    std::string name;
    Product product;
    std::size_t size;
    Seconds seconds; ///< of this stage; medians
    Seconds until;   ///< from the points to the end of this stage; medians
  };

  std::string method;
  unsigned threads = 0;
  std::vector<Stage> stages; ///< none if the method did not end
  std::size_t runs = 0;
  std::size_t crowded_leaves = 0;
  int depth = 0;
  double memory_mb = 0; ///< beyond the program and the points
  double peak_memory_mb = 0;

  const Stage* stage(Product product) const {
    for (const Stage& s : stages)
      if (s.product == product) return &s;
    return nullptr;
  }
  /// What counts: processor seconds, or with threads those by the clock on the wall.
  double seconds(const Seconds& s) const { return threads > 0 ? s.wall : s.cpu; }
};

/// Gathers runs of one method. A method that failed is not asked again, nor one that takes a good part of the
/// time it is given: noise matters little to it.
class Outcome_builder {
public:
  explicit Outcome_builder(const Method& method) : method_(method) {}

  void run(const quadtree_inputs::Input& input, std::size_t n, const Limits& limits) {
    if (has_failed_ || is_slow_) return;
    const double start = wall_seconds();
    const auto child = in_child(
        [&] {
          limit_memory(limits.gigabytes);
          return method_.run(input.make(n, n));
        },
        limits.seconds);
    has_failed_ = !child.result;
    is_slow_ = wall_seconds() - start > limits.seconds / 4.0;
    if (has_failed_) return;
    runs_.push_back(*child.result);
    peak_memory_mb_.push_back(child.peak_memory_mb);
  }

  Outcome outcome() const {
    Outcome result;
    result.method = method_.name;
    result.threads = method_.threads;
    if (has_failed_ || runs_.empty()) return result;
    result.runs = runs_.size();
    result.crowded_leaves = runs_.front().crowded_leaves;
    result.depth = runs_.front().depth;
    result.peak_memory_mb = median(peak_memory_mb_);
    std::vector<double> memory;
    for (std::size_t i = 0; i < runs_.size(); ++i)
      memory.push_back(peak_memory_mb_[i] - runs_[i].memory_before_mb);
    result.memory_mb = median(memory);
    for (std::size_t i = 0; i < method_.stages.size(); ++i)
      result.stages.push_back({method_.stages[i].name, method_.stages[i].product,
                               runs_.front().stages[i].size, seconds(i, i), seconds(0, i)});
    return result;
  }

private:
  /// Medians of the time from stage `first` to stage `last`.
  Seconds seconds(std::size_t first, std::size_t last) const {
    std::vector<double> cpu, wall;
    for (const Run& run : runs_) {
      Seconds sum;
      for (std::size_t i = first; i <= last; ++i) sum += run.stages[i].seconds;
      cpu.push_back(sum.cpu);
      wall.push_back(sum.wall);
    }
    return {median(cpu), median(wall)};
  }

  const Method& method_;
  std::vector<Run> runs_;
  std::vector<double> peak_memory_mb_;
  bool has_failed_ = false;
  bool is_slow_ = false;
};

/// All methods on one input.
struct Comparison {
  std::string input;
  std::size_t n = 0;
  std::vector<Outcome> outcomes;

  const Outcome* outcome(const std::string& method, Product product) const {
    for (const Outcome& o : outcomes)
      if (o.method == method && o.stage(product) != nullptr) return &o;
    return nullptr;
  }
};

/// Runs the methods alternately, so that all meet the same state of the machine.
inline Comparison compare(const std::vector<Method>& methods, const quadtree_inputs::Input& input,
                          std::size_t n, int repetitions, const Limits& limits) {
  std::vector<Outcome_builder> builders(methods.begin(), methods.end());
  for (int i = 0; i < repetitions; ++i)
    for (Outcome_builder& builder : builders) builder.run(input, n, limits);
  Comparison comparison{input.name, n, {}};
  for (const Outcome_builder& builder : builders) comparison.outcomes.push_back(builder.outcome());
  return comparison;
}

#endif // QUADTREE_MESH_2_BENCHMARK_QUADTREE_OUTCOMES_H
