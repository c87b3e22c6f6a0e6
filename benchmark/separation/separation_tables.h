// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// All separations on one input, and the tables and the file that their benchmark writes.

#ifndef QUADTREE_MESH_2_BENCHMARK_SEPARATION_TABLES_H
#define QUADTREE_MESH_2_BENCHMARK_SEPARATION_TABLES_H

#include "markdown_table.h"
#include "separation_run.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

using Separation_outcome = Method_outcome<Separation_method>;

struct Separation_comparison {
  std::string input;
  std::size_t vertices = 0;
  std::size_t segments = 0;
  std::vector<Separation_outcome> outcomes;

  /// What is wrong with the meshes; empty if nothing is.
  std::string fault() const {
    for (const Separation_outcome& outcome : outcomes) {
      const std::string name = outcome.method().name();
      if (!outcome.has_mesh()) return name + ": no mesh";
      if (!outcome.first().is_valid) return name + ": invalid mesh";
      if (!outcome.is_same_every_time()) return name + ": another mesh in every run";
      if (outcome.first().digest != first_of(outcome.method().mesh).digest) return name + ": another mesh";
    }
    return {};
  }

private:
  const Separation_run& first_of(const std::string& mesh) const {
    std::size_t i = 0;
    while (outcomes[i].method().mesh != mesh) ++i;
    return outcomes[i].first();
  }
};

namespace separation_tables {

using Comparisons = std::vector<Separation_comparison>;

/// Calls `f(comparison, outcome, run)` for all that have a mesh.
template <class F>
void for_each_outcome(const Comparisons& comparisons, const F& f) {
  for (const Separation_comparison& c : comparisons)
    for (const Separation_outcome& o : c.outcomes)
      if (o.has_mesh()) f(c, o, o.first());
}

/// One row for each mesh: how it is made does not matter.
inline void print_triangles(const Comparisons& comparisons) {
  Markdown_table table({"input", "vertices", "separation", "triangles without removal", "triangles",
                        "below the bound", "in acute corners", "least angle"});
  std::string last;
  for_each_outcome(comparisons, [&](const auto& c, const auto& o, const Separation_run& run) {
    const std::string row = c.input + ' ' + o.method().mesh;
    if (row == last || o.method().threads > 0) return;
    last = row;
    table.add_row({c.input, std::to_string(c.vertices), o.method().mesh, std::to_string(run.before_removal),
                   std::to_string(run.triangles), std::to_string(run.below_bound), std::to_string(run.exempt),
                   fixed(run.min_angle, 2)});
  });
  table.print();
}

/// What the quadtrees did.
inline void print_trees(const Comparisons& comparisons) {
  Markdown_table table({"input", "leaves: T_B", "T_B'", "T_B''", "T_B*", "rounds", "triangles of the rule",
                        "below the bound", "share, %", "left out", "left to refinement", "vertices placed",
                        "kept"});
  std::string last;
  for_each_outcome(comparisons, [&](const auto& c, const auto& o, const Separation_run& run) {
    const CGAL::Tree_separation_report_2& t = run.trees;
    const std::string row = c.input + ' ' + o.method().mesh;
    if (t.rounds == 0 || row == last || o.method().threads > 0) return;
    last = row;
    table.add_row({row, std::to_string(t.leaves_of_points), std::to_string(t.leaves_of_vertices),
                   std::to_string(t.leaves_of_pieces), std::to_string(t.leaves_of_edges),
                   std::to_string(t.rounds), std::to_string(t.triangles), std::to_string(t.missed_by_rule),
                   fixed(100 * double(t.missed_by_rule) / double(t.triangles), 2), std::to_string(t.left_out),
                   std::to_string(t.missed), std::to_string(t.placed), std::to_string(t.kept)});
  });
  table.print();
}

inline void print_time(const Comparisons& comparisons) {
  Markdown_table table({"input", "separation", "CPU s", "wall s", "MB", "CPU s by phase"});
  for_each_outcome(comparisons, [&](const auto& c, const auto& o, const Separation_run&) {
    std::string phases;
    for (std::size_t i = 0; i < separation_phases.size(); ++i)
      if (o.phase(i) > 0)
        phases +=
            (phases.empty() ? "" : ", ") + std::string(separation_phases[i]) + ' ' + three_digits(o.phase(i));
    table.add_row({c.input, o.method().name(), three_digits(o.cpu()), three_digits(o.wall()),
                   fixed(o.memory_mb(), 0), phases});
  });
  table.print();
}

inline nlohmann::ordered_json to_json(const CGAL::Tree_separation_report_2& t) {
  return {{"leaves_of_points", t.leaves_of_points},
          {"leaves_of_vertices", t.leaves_of_vertices},
          {"leaves_of_pieces", t.leaves_of_pieces},
          {"leaves_of_edges", t.leaves_of_edges},
          {"splits", t.splits},
          {"rounds", t.rounds},
          {"windows", t.windows},
          {"failed_windows", t.failed_windows},
          {"triangles", t.triangles},
          {"missed_by_rule", t.missed_by_rule},
          {"left_out", t.left_out},
          {"relocated", t.relocated},
          {"added", t.added},
          {"missed", t.missed},
          {"placed", t.placed},
          {"kept", t.kept}};
}

inline nlohmann::ordered_json to_json(const Separation_outcome& outcome) {
  nlohmann::ordered_json json{{"separation", outcome.method().name()}, {"threads", outcome.method().threads}};
  if (!outcome.has_mesh()) return json;
  const Separation_run& run = outcome.first();
  json.update({{"runs", outcome.number_of_runs()},
               {"triangles_without_removal", run.before_removal},
               {"triangles", run.triangles},
               {"below_bound", run.below_bound},
               {"exempt", run.exempt},
               {"is_valid", run.is_valid},
               {"cpu_seconds", outcome.cpu()},
               {"wall_seconds", outcome.wall()},
               {"peak_memory_mb", outcome.memory_mb()}});
  if (run.trees.rounds > 0) json["trees"] = to_json(run.trees);
  for (std::size_t i = 0; i < separation_phases.size(); ++i)
    json["phases"][separation_phases[i]] = outcome.phase(i);
  return json;
}

inline nlohmann::ordered_json to_json(const Comparisons& comparisons) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Separation_comparison& c : comparisons) {
    nlohmann::ordered_json outcomes = nlohmann::ordered_json::array();
    for (const Separation_outcome& outcome : c.outcomes) outcomes.push_back(to_json(outcome));
    json.push_back(
        {{"input", c.input}, {"vertices", c.vertices}, {"segments", c.segments}, {"outcomes", outcomes}});
  }
  return json;
}

} // namespace separation_tables

#endif // QUADTREE_MESH_2_BENCHMARK_SEPARATION_TABLES_H
