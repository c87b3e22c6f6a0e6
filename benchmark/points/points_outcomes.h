// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// All modes and peers on one set of points: the runs of each, and what they come to.

#ifndef QUADTREE_MESH_2_BENCHMARK_POINTS_OUTCOMES_H
#define QUADTREE_MESH_2_BENCHMARK_POINTS_OUTCOMES_H

#include "method_outcome.h"
#include "points_run.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using Points_outcome = Method_outcome<Points_method>;

struct Points_comparison {
  std::string input;
  std::size_t n = 0;
  double least_length = 0; ///< of all meshes that have these points
  std::vector<Points_outcome> outcomes;

  /// Nothing if the mesher was not asked or made no mesh.
  const Points_outcome* find(const std::string& name) const {
    for (const Points_outcome& outcome : outcomes)
      if (outcome.method().name == name && outcome.has_mesh()) return &outcome;
    return nullptr;
  }

  double per_point(std::size_t number) const { return double(number) / double(n); }

  /// What time is measured by where n points need k triangles before these become fewer: n log n + k.
  double expected_work(const Points_outcome& outcome) const {
    const Points_run& run = outcome.first();
    const std::size_t k = run.before_coarsening > 0 ? run.before_coarsening : run.triangles;
    return double(n) * std::log2(double(n)) + double(k);
  }

  /// What is wrong with our meshes; empty if nothing is. No mesh within the limits is nothing wrong, nor that
  /// points are refused whose quadtree would be too deep.
  std::string fault() const {
    const Points_outcome* parallel = nullptr;
    for (const Points_outcome& outcome : outcomes) {
      if (outcome.method().is_peer() || !outcome.has_mesh()) continue;
      const std::string& name = outcome.method().name;
      if (!outcome.first().is_valid) return name + ": invalid mesh";
      if (!outcome.is_same_every_time()) return name + ": another mesh in every run";
      if (outcome.method().threads == 0) {
        parallel = nullptr; // another mode
        continue;
      }
      if (parallel != nullptr && outcome.first().digest != parallel->first().digest)
        return name + ": another mesh with another number of threads";
      parallel = &outcome;
    }
    return {};
  }
};

#endif // QUADTREE_MESH_2_BENCHMARK_POINTS_OUTCOMES_H
