// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// All meshers on one input: the runs of each, and what they come to.

#ifndef QUADTREE_MESH_2_BENCHMARK_PSLG_OUTCOMES_H
#define QUADTREE_MESH_2_BENCHMARK_PSLG_OUTCOMES_H

#include "measurement.h"
#include "pslg_run.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The runs of one mesher. One that failed is not asked again, nor one that takes a good part of the time it
/// is given: noise matters little to it.
class Pslg_outcome {
public:
  explicit Pslg_outcome(const Pslg_method& method) : method_(method) {}

  void run(const Pslg_task& task) {
    if (has_failed_ || is_slow_) return;
    const std::optional<Pslg_run> run = method_.run(task, runs_.empty() ? Check::YES : Check::NO);
    has_failed_ = !run;
    if (!run) return;
    is_slow_ = run->mesh.wall > task.limit_seconds / 4.0;
    runs_.push_back(*run);
  }

  const Pslg_method& method() const { return method_; }
  bool has_mesh() const { return !has_failed_ && !runs_.empty(); }
  std::size_t number_of_runs() const { return runs_.size(); }
  /// The run that was looked at.
  const Pslg_run& first() const { return runs_.front(); }

  bool is_same_every_time() const {
    for (const Pslg_run& run : runs_)
      if (run.digest != first().digest || run.triangles != first().triangles) return false;
    return true;
  }

  template <class Function>
  double median_of(Function value) const {
    std::vector<double> values;
    for (const Pslg_run& run : runs_) values.push_back(value(run));
    return median(values);
  }
  double cpu() const {
    return median_of([](const Pslg_run& run) { return run.mesh.cpu; });
  }
  double wall() const {
    return median_of([](const Pslg_run& run) { return run.mesh.wall; });
  }
  double to_triangulation() const {
    return median_of([](const Pslg_run& run) { return run.to_triangulation; });
  }
  double memory_mb() const {
    return median_of([](const Pslg_run& run) { return run.peak_memory_mb; });
  }
  double phase(std::size_t i) const {
    return median_of([i](const Pslg_run& run) { return run.phases[i]; });
  }

private:
  Pslg_method method_;
  std::vector<Pslg_run> runs_;
  bool has_failed_ = false;
  bool is_slow_ = false;
};

struct Pslg_comparison {
  std::string input;
  std::string family; ///< empty for files
  double min_angle = 0;
  std::size_t vertices = 0;
  std::size_t segments = 0;
  std::vector<Pslg_outcome> outcomes; ///< the first is our sequential mesher

  const Pslg_outcome& ours() const { return outcomes.front(); }
  /// Nothing if the mesher was not asked or made no mesh.
  const Pslg_outcome* find(const std::string& name) const {
    for (const Pslg_outcome& outcome : outcomes)
      if (outcome.method().name == name && outcome.has_mesh()) return &outcome;
    return nullptr;
  }

  /// What is wrong with our meshes; empty if nothing is.
  std::string fault() const {
    for (const Pslg_outcome& outcome : outcomes) {
      const std::string& name = outcome.method().name;
      if (name.compare(0, 4, "ours") != 0) continue;
      if (!outcome.has_mesh()) return name + ": no mesh";
      if (!outcome.first().is_valid) return name + ": invalid mesh";
      if (!outcome.is_same_every_time()) return name + ": another mesh in every run";
    }
    const Pslg_outcome* parallel = nullptr;
    for (const Pslg_outcome& outcome : outcomes) {
      if (outcome.method().threads == 0) continue;
      if (parallel != nullptr && outcome.first().digest != parallel->first().digest)
        return "another mesh with another number of threads";
      parallel = &outcome;
    }
    return {};
  }
};

/// Runs the meshers alternately, so that all meet the same state of the machine.
inline std::vector<Pslg_outcome> run_alternately(const std::vector<Pslg_method>& methods,
                                                 const Pslg_task& task, int repetitions) {
  std::vector<Pslg_outcome> outcomes(methods.begin(), methods.end());
  for (int i = 0; i < repetitions; ++i)
    for (Pslg_outcome& outcome : outcomes) outcome.run(task);
  return outcomes;
}

#endif // QUADTREE_MESH_2_BENCHMARK_PSLG_OUTCOMES_H
