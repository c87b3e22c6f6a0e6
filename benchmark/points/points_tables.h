// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The tables and the file that the benchmark of meshes of points writes.

#ifndef QUADTREE_MESH_2_BENCHMARK_POINTS_TABLES_H
#define QUADTREE_MESH_2_BENCHMARK_POINTS_TABLES_H

#include "markdown_table.h"
#include "points_outcomes.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace points_tables {

using Comparisons = std::vector<Points_comparison>;
using Row = Markdown_table::Row;

/// Calls `f` with all that made a mesh.
template <class Function>
void for_each_mesh(const Comparisons& comparisons, Function f) {
  for (const Points_comparison& c : comparisons)
    for (const Points_outcome& o : c.outcomes)
      if (o.has_mesh()) f(c, o);
}

inline std::string length_over_bound(const Points_comparison& c, const Points_run& run) {
  return c.least_length > 0 ? three_digits(run.total_length / c.least_length) : "-";
}

/// Sizes, shapes and costs of all sequential meshers.
inline void print_meshes(const Comparisons& comparisons) {
  Markdown_table table({"points", "mesher", "triangles", "per point", "before coarsening, per point",
                        "least angle", "largest angle", "clusters", "rounds", "length / lower bound", "CPU s",
                        "µs per point", "MB"});
  for (const Points_comparison& c : comparisons)
    for (const Points_outcome& o : c.outcomes) {
      if (o.method().threads > 0) continue;
      Row row{std::to_string(c.n), o.method().name};
      if (!o.has_mesh()) {
        row.resize(13, "-");
        table.add_row(row);
        continue;
      }
      const Points_run& run = o.first();
      const bool is_peer = o.method().is_peer();
      for (const std::string& cell :
           {std::to_string(run.triangles), fixed(c.per_point(run.triangles), 2),
            is_peer ? "-" : fixed(c.per_point(run.before_coarsening), 2), fixed(run.min_angle, 2),
            fixed(run.max_angle, 2), is_peer ? "-" : std::to_string(run.clusters),
            is_peer ? "-" : std::to_string(run.rounds), length_over_bound(c, run), three_digits(o.cpu()),
            three_digits(1e6 * o.cpu() / double(c.n)), fixed(o.memory_mb(), 0)})
        row.push_back(cell);
      table.add_row(row);
    }
  table.print();
}

inline void print_phases(const Comparisons& comparisons) {
  Markdown_table table({"points", "mesher", "CPU s", "by phase"});
  for_each_mesh(comparisons, [&](const Points_comparison& c, const Points_outcome& o) {
    if (o.method().threads > 0) return;
    std::string phases;
    for (std::size_t i = 0; i < o.method().phases.size(); ++i)
      phases += (i == 0 ? "" : ", ") + o.method().phases[i] + ' ' + three_digits(o.phase(i));
    table.add_row({std::to_string(c.n), o.method().name, three_digits(o.cpu()), phases});
  });
  table.print();
}

/// Cells of ours, of the peer, and of the ratio.
inline void append_ratio(Row& row, double ours, double theirs, std::string (*text)(double)) {
  row.push_back(text(ours));
  row.push_back(text(theirs));
  row.push_back(theirs > 0 ? fixed(ours / theirs, 3) : "-");
}

/// Every peer beside the mode of ours that it is compared with.
inline void print_ratios(const Comparisons& comparisons) {
  Markdown_table table({"points", "ours", "peer", "triangles: ours", "peer", "ours / peer", "CPU s: ours",
                        "peer", "ours / peer", "MB: ours", "peer", "ours / peer", "least angle: ours", "peer",
                        "largest angle: ours", "peer"});
  bool is_empty = true;
  for_each_mesh(comparisons, [&](const Points_comparison& c, const Points_outcome& peer) {
    if (!peer.method().is_peer()) return;
    const Points_outcome* const ours = c.find(peer.method().rival);
    if (ours == nullptr) return;
    const auto whole = [](double value) { return fixed(value, 0); };
    Row row{std::to_string(c.n), ours->method().name, peer.method().name};
    append_ratio(row, double(ours->first().triangles), double(peer.first().triangles), whole);
    append_ratio(row, ours->cpu(), peer.cpu(), three_digits);
    append_ratio(row, ours->memory_mb(), peer.memory_mb(), whole);
    for (const double angle :
         {ours->first().min_angle, peer.first().min_angle, ours->first().max_angle, peer.first().max_angle})
      row.push_back(fixed(angle, 2));
    table.add_row(row);
    is_empty = false;
  });
  if (!is_empty) table.print();
}

/// Ours with threads beside the sequential mesher of the same mode, which goes before them.
inline void print_threads(const Comparisons& comparisons) {
  Markdown_table table({"points", "mesher", "triangles", "wall s", "CPU s",
                        "speedup over the sequential mesher", "bits of the sequential mesher's mesh"});
  for (const Points_comparison& c : comparisons) {
    const Points_outcome* sequential = nullptr;
    for (const Points_outcome& o : c.outcomes) {
      if (o.method().is_peer()) continue;
      const bool is_parallel = o.method().threads > 0;
      if (!is_parallel) sequential = o.has_mesh() ? &o : nullptr;
      if (!o.has_mesh() || sequential == nullptr) continue;
      const bool is_same = o.first().digest == sequential->first().digest;
      table.add_row({std::to_string(c.n), o.method().name, std::to_string(o.first().triangles),
                     three_digits(o.wall()), three_digits(o.cpu()),
                     is_parallel ? fixed(sequential->wall() / o.wall(), 2) : "-",
                     !is_parallel ? "-"
                     : is_same    ? "yes"
                                  : "no"});
    }
  }
  table.print();
}

/// Each mesher's time by what it should grow with, relative to the fewest points too, and triangles per point.
inline void print_growth(const Comparisons& comparisons) {
  Markdown_table table({"mesher", "points", "triangles per point", "before coarsening, per point", "CPU s",
                        "ns / (n log2 n + k)", "relative to the fewest points"});
  for (const Points_outcome& first : comparisons.front().outcomes) {
    double unit = 0;
    for (const Points_comparison& c : comparisons) {
      const Points_outcome* const o = c.find(first.method().name);
      if (o == nullptr) continue;
      const double time = 1e9 * o->cpu() / c.expected_work(*o);
      if (unit == 0) unit = time;
      const Points_run& run = o->first();
      table.add_row(
          {o->method().name, std::to_string(c.n), fixed(c.per_point(run.triangles), 2),
           run.before_coarsening > 0 ? fixed(c.per_point(run.before_coarsening), 2) : std::string("-"),
           three_digits(o->cpu()), three_digits(time), fixed(time / unit, 2)});
    }
  }
  table.print();
}

inline nlohmann::ordered_json to_json(const Points_outcome& outcome) {
  nlohmann::ordered_json json{{"mesher", outcome.method().name}, {"threads", outcome.method().threads}};
  if (!outcome.has_mesh()) return json;
  const Points_run& run = outcome.first();
  json.update({{"runs", outcome.number_of_runs()},
               {"vertices", run.vertices},
               {"triangles", run.triangles},
               {"triangles_before_coarsening", run.before_coarsening},
               {"clusters", run.clusters},
               {"rounds", run.rounds},
               {"below_bound", run.below_bound},
               {"min_angle", run.min_angle},
               {"max_angle", run.max_angle},
               {"total_length", run.total_length},
               {"is_valid", run.is_valid},
               {"digest", run.digest},
               {"cpu_seconds", outcome.cpu()},
               {"wall_seconds", outcome.wall()},
               {"peak_memory_mb", outcome.memory_mb()}});
  for (std::size_t i = 0; i < outcome.method().phases.size(); ++i)
    json["phases"][outcome.method().phases[i]] = outcome.phase(i);
  return json;
}

inline nlohmann::ordered_json to_json(const Points_comparison& comparison) {
  nlohmann::ordered_json json{{"input", comparison.input},
                              {"points", comparison.n},
                              {"least_length", comparison.least_length},
                              {"meshers", nlohmann::ordered_json::array()}};
  for (const Points_outcome& outcome : comparison.outcomes) json["meshers"].push_back(to_json(outcome));
  return json;
}

} // namespace points_tables

#endif // QUADTREE_MESH_2_BENCHMARK_POINTS_TABLES_H
