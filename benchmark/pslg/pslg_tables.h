// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The tables and the file that the benchmark of meshers writes.

#ifndef QUADTREE_MESH_2_BENCHMARK_PSLG_TABLES_H
#define QUADTREE_MESH_2_BENCHMARK_PSLG_TABLES_H

#include "markdown_table.h"
#include "pslg_outcomes.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace pslg_tables {

using Comparisons = std::vector<Pslg_comparison>;
using Row = Markdown_table::Row;

/// The names of the peers: of all that is no mesher of ours.
inline std::vector<std::string> peers(const Comparisons& comparisons) {
  std::vector<std::string> names;
  for (const Pslg_outcome& outcome : comparisons.front().outcomes)
    if (outcome.method().name.compare(0, 4, "ours") != 0) names.push_back(outcome.method().name);
  return names;
}

/// Cells of our mesher and of the peers, then of the ratios of ours to theirs.
template <class Value, class Text>
void append_cells(Row& row, const Pslg_comparison& comparison, const std::vector<std::string>& peer_names,
                  Value value, Text text) {
  const Pslg_outcome* const ours = comparison.find("ours");
  row.push_back(ours != nullptr ? text(value(*ours)) : "-");
  for (const std::string& name : peer_names) {
    const Pslg_outcome* const peer = comparison.find(name);
    row.push_back(peer != nullptr ? text(value(*peer)) : "-");
  }
  for (const std::string& name : peer_names) {
    const Pslg_outcome* const peer = comparison.find(name);
    const bool is_known = ours != nullptr && peer != nullptr && value(*peer) > 0;
    row.push_back(is_known ? fixed(value(*ours) / value(*peer), 3) : "-");
  }
}

/// The titles of the columns that `append_cells()` fills.
inline void append_titles(Row& row, const std::string& what, const std::vector<std::string>& peer_names) {
  row.push_back(what + ": ours");
  for (const std::string& name : peer_names) row.push_back(name);
  for (const std::string& name : peer_names) row.push_back("ours / " + name);
}

inline std::string whole(double value) { return fixed(value, 0); }

inline void print_triangles(const Comparisons& comparisons) {
  const auto names = peers(comparisons);
  Row titles{"input", "vertices"};
  append_titles(titles, "triangles", names);
  titles.push_back("below the bound: ours");
  for (const std::string& name : names) titles.push_back(name);
  titles.push_back("in acute corners: ours");
  for (const std::string& name : names) titles.push_back(name);
  Markdown_table table(titles);
  for (const Pslg_comparison& c : comparisons) {
    Row row{c.input, std::to_string(c.vertices)};
    const auto triangles = [](const Pslg_outcome& o) { return double(o.first().triangles); };
    append_cells(row, c, names, triangles, whole);
    for (const auto member : {&Pslg_run::below_bound, &Pslg_run::exempt}) {
      row.push_back(c.ours().has_mesh() ? std::to_string(c.ours().first().*member) : "-");
      for (const std::string& name : names) {
        const Pslg_outcome* const peer = c.find(name);
        row.push_back(peer != nullptr ? std::to_string(peer->first().*member) : "-");
      }
    }
    table.add_row(row);
  }
  table.print();
}

inline void print_time(const Comparisons& comparisons) {
  const auto names = peers(comparisons);
  Row titles{"input"};
  append_titles(titles, "CPU s", names);
  append_titles(titles, "wall s", names);
  titles.push_back("to a CGAL triangulation, CPU s");
  append_titles(titles, "MB", names);
  Markdown_table table(titles);
  for (const Pslg_comparison& c : comparisons) {
    Row row{c.input};
    append_cells(
        row, c, names, [](const Pslg_outcome& o) { return o.cpu(); }, three_digits);
    append_cells(
        row, c, names, [](const Pslg_outcome& o) { return o.wall(); }, three_digits);
    row.push_back(c.ours().has_mesh() ? three_digits(c.ours().to_triangulation()) : "-");
    append_cells(
        row, c, names, [](const Pslg_outcome& o) { return o.memory_mb(); }, whole);
    table.add_row(row);
  }
  table.print();
}

/// Microseconds per triangle of the mesher's own mesh, by phase.
inline void print_phases(const Comparisons& comparisons) {
  Markdown_table table({"input", "mesher", "µs per triangle", "by phase"});
  for (const Pslg_comparison& c : comparisons)
    for (const Pslg_outcome& o : c.outcomes) {
      if (!o.has_mesh()) continue;
      const double unit = 1e6 / double(o.first().triangles);
      std::string phases;
      for (std::size_t i = 0; i < o.method().phases.size(); ++i)
        phases += (i == 0 ? "" : ", ") + o.method().phases[i] + ' ' + fixed(unit * o.phase(i), 3);
      table.add_row({c.input, o.method().name, fixed(unit * o.cpu(), 3), phases});
    }
  table.print();
}

inline void print_threads(const Comparisons& comparisons) {
  Markdown_table table({"input", "mesher", "triangles", "wall s", "CPU s",
                        "speedup over the sequential mesher", "over one thread"});
  for (const Pslg_comparison& c : comparisons) {
    if (!c.ours().has_mesh()) continue;
    const Pslg_outcome* const one = c.find("ours, 1 thread");
    for (const Pslg_outcome& o : c.outcomes) {
      if (o.method().name.compare(0, 4, "ours") != 0 || !o.has_mesh()) continue;
      const bool is_parallel = o.method().threads > 0;
      table.add_row({c.input, o.method().name, std::to_string(o.first().triangles), three_digits(o.wall()),
                     three_digits(o.cpu()), fixed(c.ours().wall() / o.wall(), 2),
                     is_parallel && one != nullptr ? fixed(one->wall() / o.wall(), 2) : "-"});
    }
  }
  table.print();
}

/// Time per triangle of each family, and relative to the smallest of it.
inline void print_growth(const Comparisons& comparisons) {
  Markdown_table table(
      {"family", "vertices", "mesher", "triangles", "CPU s", "µs per triangle", "relative to the smallest"});
  for (std::size_t m = 0; m < comparisons.front().outcomes.size(); ++m) {
    double unit = 0;
    std::string family;
    for (const Pslg_comparison& c : comparisons) {
      const Pslg_outcome& o = c.outcomes[m];
      if (!o.has_mesh()) continue;
      const double time = 1e6 * o.cpu() / double(o.first().triangles);
      if (c.family != family) unit = time;
      family = c.family;
      table.add_row({c.family, std::to_string(c.vertices), o.method().name,
                     std::to_string(o.first().triangles), three_digits(o.cpu()), fixed(time, 3),
                     fixed(time / unit, 2)});
    }
  }
  table.print();
}

/// Our meshes without and with a bound on the greatest angle.
inline void print_angles(const Comparisons& comparisons) {
  Markdown_table table({"input", "mesher", "triangles", "above the greatest angle", "greatest exempt angle"});
  for (const Pslg_comparison& c : comparisons)
    for (const Pslg_outcome& o : c.outcomes)
      if (o.has_mesh())
        table.add_row({c.input, o.method().name, std::to_string(o.first().triangles),
                       std::to_string(o.first().above_max_angle), fixed(o.first().max_exempt_angle, 1)});
  table.print();
}

inline nlohmann::ordered_json to_json(const Pslg_outcome& outcome) {
  nlohmann::ordered_json json{{"mesher", outcome.method().name}, {"threads", outcome.method().threads}};
  if (!outcome.has_mesh()) return json;
  const Pslg_run& run = outcome.first();
  json.update({{"runs", outcome.number_of_runs()},
               {"vertices", run.vertices},
               {"triangles", run.triangles},
               {"below_bound", run.below_bound},
               {"exempt", run.exempt},
               {"min_angle", run.min_angle},
               {"above_max_angle", run.above_max_angle},
               {"max_exempt_angle", run.max_exempt_angle},
               {"is_valid", run.is_valid},
               {"cpu_seconds", outcome.cpu()},
               {"wall_seconds", outcome.wall()},
               {"to_triangulation_seconds", outcome.to_triangulation()},
               {"peak_memory_mb", outcome.memory_mb()}});
  for (std::size_t i = 0; i < outcome.method().phases.size(); ++i)
    json["phases"][outcome.method().phases[i]] = outcome.phase(i);
  return json;
}

inline nlohmann::ordered_json to_json(const Comparisons& comparisons) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Pslg_comparison& c : comparisons) {
    nlohmann::ordered_json outcomes = nlohmann::ordered_json::array();
    for (const Pslg_outcome& outcome : c.outcomes) outcomes.push_back(to_json(outcome));
    json.push_back({{"input", c.input},
                    {"min_angle_bound", c.min_angle},
                    {"max_angle_bound", c.max_angle},
                    {"vertices", c.vertices},
                    {"segments", c.segments},
                    {"meshers", outcomes}});
  }
  return json;
}

} // namespace pslg_tables

#endif // QUADTREE_MESH_2_BENCHMARK_PSLG_TABLES_H
