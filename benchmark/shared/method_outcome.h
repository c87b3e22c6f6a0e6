// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The runs of each of several meshers on one input, and what they come to.

#ifndef QUADTREE_MESH_2_BENCHMARK_METHOD_OUTCOME_H
#define QUADTREE_MESH_2_BENCHMARK_METHOD_OUTCOME_H

#include "measurement.h"

#include <cstddef>
#include <optional>
#include <vector>

/// The runs of one mesher. One that failed is not asked again, nor one that takes a good part of the time it
/// is given: noise matters little to it.
///
/// \tparam Method has a `Task` with `limit_seconds`, a `Run` with what `cpu()` and others give, and a function
///         `run(task, check)` that returns such a run or nothing.
template <class Method>
class Method_outcome {
public:
  using Run = typename Method::Run;
  using Task = typename Method::Task;

  explicit Method_outcome(const Method& method) : method_(method) {}

  void run(const Task& task) {
    if (has_failed_ || is_slow_) return;
    const std::optional<Run> run = method_.run(task, runs_.empty() ? Check::YES : Check::NO);
    has_failed_ = !run;
    if (!run) return;
    is_slow_ = run->mesh.wall > task.limit_seconds / 4.0;
    runs_.push_back(*run);
  }

  const Method& method() const { return method_; }
  bool has_mesh() const { return !has_failed_ && !runs_.empty(); }
  std::size_t number_of_runs() const { return runs_.size(); }
  /// The run that was looked at.
  const Run& first() const { return runs_.front(); }

  bool is_same_every_time() const {
    for (const Run& run : runs_)
      if (run.digest != first().digest || run.triangles != first().triangles) return false;
    return true;
  }

  template <class Function>
  double median_of(Function value) const {
    std::vector<double> values;
    for (const Run& run : runs_) values.push_back(value(run));
    return median(values);
  }
  double cpu() const {
    return median_of([](const Run& run) { return run.mesh.cpu; });
  }
  double wall() const {
    return median_of([](const Run& run) { return run.mesh.wall; });
  }
  double memory_mb() const {
    return median_of([](const Run& run) { return run.peak_memory_mb; });
  }
  double phase(std::size_t i) const {
    return median_of([i](const Run& run) { return run.phases[i]; });
  }

private:
  Method method_;
  std::vector<Run> runs_;
  bool has_failed_ = false;
  bool is_slow_ = false;
};

/// Runs the methods alternately, so that all meet the same state of the machine.
template <class Outcome, class Method, class Task>
std::vector<Outcome> run_alternately(const std::vector<Method>& methods, const Task& task, int repetitions) {
  std::vector<Outcome> outcomes(methods.begin(), methods.end());
  for (int i = 0; i < repetitions; ++i)
    for (Outcome& outcome : outcomes) outcome.run(task);
  return outcomes;
}

#endif // QUADTREE_MESH_2_BENCHMARK_METHOD_OUTCOME_H
