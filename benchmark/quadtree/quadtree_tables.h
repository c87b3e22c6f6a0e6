// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_QUADTREE_TABLES_H
#define QUADTREE_MESH_2_BENCHMARK_QUADTREE_TABLES_H

#include "quadtree_outcomes.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace quadtree_tables {

constexpr std::array<Product, 5> products{Product::SORTED_KEYS, Product::FRAMEWORK, Product::UNBALANCED,
                                          Product::SIDES, Product::CORNERS};

/// "sort 0.021 + refine 0.164": the stages up to the one that makes the product.
inline std::string stages_until(const Outcome& outcome, Product product) {
  std::string text;
  for (const Outcome::Stage& stage : outcome.stages) {
    std::array<char, 64> seconds;
    std::snprintf(seconds.data(), seconds.size(), "%.4f", outcome.seconds(stage.seconds));
    text += (text.empty() ? "" : " + ") + stage.name + ' ' + seconds.data();
    if (stage.product == product) break;
  }
  return text;
}

inline void print_row(const Comparison& comparison, const Outcome& outcome, Product product,
                      const std::string& base_method) {
  const Outcome::Stage& stage = *outcome.stage(product);
  const double seconds = outcome.seconds(stage.until);
  std::printf("| %s | %s | %zu | %s | %.4f | %.4f | %.1f |", name_of(product), outcome.method.c_str(),
              stage.size, stages_until(outcome, product).c_str(), stage.until.cpu, stage.until.wall,
              1e9 * seconds / double(comparison.n));
  if (const Outcome* base = comparison.outcome(base_method, product)) {
    const Seconds& base_seconds = base->stage(product)->until;
    std::printf(" %.2f |", seconds / (outcome.threads > 0 ? base_seconds.wall : base_seconds.cpu));
  } else {
    std::printf(" - |");
  }
  const bool is_complete = &stage == &outcome.stages.back();
  is_complete&& outcome.depth > 0 ? std::printf(" %d |", outcome.depth) : std::printf(" |");
  is_complete ? std::printf(" %.0f |", outcome.memory_mb) : std::printf(" |");
  std::printf(outcome.crowded_leaves > 0 ? " %zu |\n" : " |\n", outcome.crowded_leaves);
}

/// \param base the method of ours with which others are compared
inline void print(const Comparison& comparison, const std::string& base) {
  std::printf("\n### %s, %zu points\n\n", comparison.input.c_str(), comparison.n);
  std::printf("| made | by | size | stages, s | CPU s | wall s | ns/point | times ours | depth | MB "
              "| leaves with several points |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (Product product : products)
    for (const Outcome& outcome : comparison.outcomes)
      if (outcome.stage(product) != nullptr) print_row(comparison, outcome, product, base);
  for (const Outcome& outcome : comparison.outcomes)
    if (outcome.stages.empty())
      std::printf("\n%s made nothing within the limits of time and memory.\n", outcome.method.c_str());
  std::fflush(stdout);
}

/// Time for one point, relative to that with the fewest points.
inline void print_growth(const std::vector<Comparison>& comparisons) {
  const Comparison& first = comparisons.front();
  std::printf("\n### %s, growth: time per point relative to that for %zu points\n\n| made | by |",
              first.input.c_str(), first.n);
  for (const Comparison& c : comparisons) std::printf(" %zu |", c.n);
  std::printf("\n|---|---|");
  for (std::size_t i = 0; i < comparisons.size(); ++i) std::printf("---|");
  std::printf("\n");
  for (Product product : products)
    for (const Outcome& outcome : first.outcomes) {
      if (outcome.stage(product) == nullptr) continue;
      std::printf("| %s | %s |", name_of(product), outcome.method.c_str());
      const double unit = outcome.seconds(outcome.stage(product)->until) / double(first.n);
      for (const Comparison& c : comparisons) {
        const Outcome* const other = c.outcome(outcome.method, product);
        if (other != nullptr)
          std::printf(" %.2f |", other->seconds(other->stage(product)->until) / double(c.n) / unit);
        else
          std::printf(" - |");
      }
      std::printf("\n");
    }
  std::fflush(stdout);
}

inline nlohmann::ordered_json to_json(const Outcome& outcome) {
  nlohmann::ordered_json json = {
      {"method", outcome.method}, {"threads", outcome.threads}, {"runs", outcome.runs}};
  json["stages"] = nlohmann::ordered_json::array();
  for (const Outcome::Stage& stage : outcome.stages)
    json["stages"].push_back({{"name", stage.name},
                              {"made", name_of(stage.product)},
                              {"size", stage.size},
                              {"cpu_seconds", stage.seconds.cpu},
                              {"wall_seconds", stage.seconds.wall},
                              {"cpu_seconds_until", stage.until.cpu},
                              {"wall_seconds_until", stage.until.wall}});
  json["depth"] = outcome.depth;
  json["leaves_with_several_points"] = outcome.crowded_leaves;
  json["memory_mb"] = outcome.memory_mb;
  json["peak_memory_mb"] = outcome.peak_memory_mb;
  return json;
}

inline nlohmann::ordered_json to_json(const Comparison& comparison) {
  nlohmann::ordered_json json = {{"input", comparison.input}, {"points", comparison.n}};
  for (const Outcome& outcome : comparison.outcomes) json["methods"].push_back(to_json(outcome));
  return json;
}

} // namespace quadtree_tables

#endif // QUADTREE_MESH_2_BENCHMARK_QUADTREE_TABLES_H
