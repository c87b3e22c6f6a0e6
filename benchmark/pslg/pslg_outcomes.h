// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// All meshers on one input: the runs of each, and what they come to.

#ifndef QUADTREE_MESH_2_BENCHMARK_PSLG_OUTCOMES_H
#define QUADTREE_MESH_2_BENCHMARK_PSLG_OUTCOMES_H

#include "method_outcome.h"
#include "pslg_run.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// The runs of one mesher.
class Pslg_outcome : public Method_outcome<Pslg_method> {
public:
  using Method_outcome::Method_outcome;

  double to_triangulation() const {
    return median_of([](const Pslg_run& run) { return run.to_triangulation; });
  }
};

struct Pslg_comparison {
  std::string input;
  std::string family; ///< empty for files
  double min_angle = 0;
  double max_angle = 0; ///< 0: there was no run with such a bound
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

#endif // QUADTREE_MESH_2_BENCHMARK_PSLG_OUTCOMES_H
