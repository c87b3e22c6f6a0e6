// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Our quadtrees, those of CGAL and of p4est and mere sorting on the same points, alternately, so that all
// meet the same state of the machine. Every run is a process of its own: its memory is what one method needs,
// and one that does not end is stopped. Prints Markdown tables; --json FILE writes the same figures for
// programs. With --rounds it counts steps, work and critical path of our trees instead.

#include "benchmark_options.h"
#include "quadtree_cgal.h"
#include "quadtree_floors.h"
#include "quadtree_inputs.h"
#include "quadtree_ours.h"
#include "quadtree_outcomes.h"
#include "quadtree_p4est.h"
#include "quadtree_rounds.h"
#include "quadtree_tables.h"

#include <CGAL/version.h>

#include <boost/program_options.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace po = boost::program_options;
using nlohmann::ordered_json;

struct Settings {
  std::vector<double> n{1e5, 1e6}; // as doubles, so that 1e6 can be written
  std::vector<std::string> inputs;
  std::vector<std::string> traits{"filtered"};
  std::vector<unsigned> threads;
  int repetitions = 5;
  Limits limits;
  bool has_peers = true;
  bool has_floors = true;
  bool counts_rounds = false;
  std::string json_file;
};

std::vector<Method> methods_of(const Settings& settings) {
  std::vector<Method> methods;
  const auto append = [&methods](std::vector<Method> more) {
    std::move(more.begin(), more.end(), std::back_inserter(methods));
  };
  if (settings.has_floors) append(quadtree_floors::methods());
  for (const std::string& traits : settings.traits) append(quadtree_ours::methods(traits, settings.threads));
  if (settings.has_peers) {
    append(quadtree_cgal::methods());
    append(quadtree_p4est::methods());
  }
  return methods;
}

void print_preface(const Settings& settings) {
  std::printf(
      "Medians of %d runs (one where the process takes more than %g s), from points in memory; trees\n"
      "with at most one point in a leaf. \"Size\" is the number of leaves, of squares of a framework or of\n"
      "keys; \"times ours\" compares with our sequential tree of the same balance; time per point and\n"
      "ratios are of processor seconds, with threads of wall seconds. \"MB\" is the most memory beyond\n"
      "the program and the points. Ours is cross-linked and has located every point. CGAL is %s,\n"
      "which cannot be deeper than %zu levels, and whose coordinates overflow below level 32, so that it\n"
      "does not end or leaves points together; it has a root of its own, so leaves differ.\n",
      settings.repetitions, settings.limits.seconds / 4.0, CGAL_VERSION_STR, quadtree_cgal::max_depth);
  std::printf(quadtree_p4est::methods().empty()
                  ? "p4est was not found by CMake: no figures of it.\n"
                  : "p4est has our root, sorts without indices, knows no points afterward and ends at level "
                    "29.\n");
}

std::vector<Comparison> compare_sizes(const quadtree_inputs::Input& input, const Settings& settings) {
  const std::vector<Method> methods = methods_of(settings);
  const std::string base = "ours, " + settings.traits.front();
  std::vector<Comparison> comparisons;
  for (double n : settings.n) {
    comparisons.push_back(compare(methods, input, std::size_t(n), settings.repetitions, settings.limits));
    quadtree_tables::print(comparisons.back(), base);
  }
  if (comparisons.size() > 1) quadtree_tables::print_growth(comparisons);
  return comparisons;
}

ordered_json compare_all(const Settings& settings) {
  print_preface(settings);
  ordered_json json;
  for (const std::string& input : settings.inputs)
    for (const Comparison& comparison : compare_sizes(quadtree_inputs::by_name(input), settings))
      json.push_back(quadtree_tables::to_json(comparison));
  return json;
}

Rounds median_rounds(const quadtree_inputs::Input& input, std::size_t n,
                     const CGAL::Quadtree_options& options, const Settings& settings) {
  using Tree = CGAL::Balanced_quadtree<quadtree_ours::Filtered_traits, Counted_tag>;
  Rounds rounds;
  std::vector<double> work, path, serial;
  for (int i = 0; i < settings.repetitions; ++i) {
    const auto child = in_child(
        [&] {
          const Points points = input.make(n, n);
          std::optional<Tree> tree; // not to count its end
          return Round_counter::instance().count([&] { tree.emplace(points, options); });
        },
        settings.limits.seconds);
    if (!child.result) throw std::runtime_error("counting rounds failed");
    rounds.steps = child.result->steps;
    work.push_back(child.result->work);
    path.push_back(child.result->path);
    serial.push_back(child.result->serial);
  }
  rounds.work = median(work);
  rounds.path = median(path);
  rounds.serial = median(serial);
  return rounds;
}

ordered_json count_rounds(const Settings& settings) {
  using CGAL::Quadtree_mesh_2::Balance_schedule;
  std::printf(
      "Parallel steps, work and critical path of our trees, balanced across sides and corners;\n"
      "medians of %d runs. The path is the time with a core for every task, its serial part that outside\n"
      "of tasks. Work / path is the number of cores there is work for; the last columns say by Brent's\n"
      "theorem how many times as fast 8 and 64 cores of that speed are at least, if memory keeps up.\n\n"
      "| input | points | schedule | steps | work, ms | path, ms | of it serial, ms | work / path | "
      "8 cores | 64 cores |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n",
      settings.repetitions);
  ordered_json json;
  for (const std::string& name : settings.inputs)
    for (const auto& [schedule, text] : {std::pair{Balance_schedule::LEVEL_BY_LEVEL, "level by level"},
                                         std::pair{Balance_schedule::SPACED_LEVELS, "spaced levels"}})
      for (double n : settings.n) {
        const auto options = CGAL::Quadtree_options().schedule(schedule);
        const Rounds rounds =
            median_rounds(quadtree_inputs::by_name(name), std::size_t(n), options, settings);
        std::printf("| %s | %zu | %s | %zu | %.2f | %.3f | %.3f | %.1f | %.1f | %.1f |\n", name.c_str(),
                    std::size_t(n), text, rounds.steps, 1e3 * rounds.work, 1e3 * rounds.path,
                    1e3 * rounds.serial, rounds.parallelism(), rounds.speedup(8), rounds.speedup(64));
        std::fflush(stdout);
        json.push_back({{"input", name},
                        {"points", std::size_t(n)},
                        {"schedule", text},
                        {"steps", rounds.steps},
                        {"work_seconds", rounds.work},
                        {"path_seconds", rounds.path},
                        {"serial_seconds", rounds.serial}});
      }
  return json;
}

/// Nothing if the user asked for help.
std::optional<Settings> parse(int argc, char** argv) {
  Settings settings;
  std::string names;
  for (const auto& input : quadtree_inputs::all()) names += (names.empty() ? "" : ", ") + input.name;
  po::options_description visible(
      "usage: quadtree [option]... [INPUT]...; inputs, by default the first six: " + names);
  visible.add_options()("help,h", "print this")                                            //
      ("n", po::value(&settings.n)->multitoken(), "numbers of points; 1e5 1e6 by default") //
      ("traits", po::value(&settings.traits)->multitoken(),
       "of our trees: filtered (the default), fixed32, fixed64, exact (Epeck), doubles (exact, Epick); the "
       "first are compared with") //
      ("threads", po::value(&settings.threads)->multitoken(),
       "numbers of threads on which ours run, too")                                                //
      ("repeat", po::value(&settings.repetitions)->default_value(5), "runs of each method")        //
      ("limit", po::value(&settings.limits.seconds)->default_value(60), "seconds for one run")     //
      ("memory", po::value(&settings.limits.gigabytes)->default_value(8), "gigabytes for one run") //
      ("no-peers", "leave out CGAL and p4est")                                                     //
      ("no-floors", "leave out sorting alone")                                                     //
      ("rounds", po::bool_switch(&settings.counts_rounds),
       "count parallel steps, work and critical path of our trees, and nothing else") //
      ("json", po::value(&settings.json_file), "write the figures to this file, too");
  po::variables_map given;
  if (!parse_options_and_inputs(argc, argv, visible, settings.inputs, given)) return std::nullopt;
  settings.has_peers = given.count("no-peers") == 0;
  settings.has_floors = given.count("no-floors") == 0;
  settings.repetitions = std::max(settings.repetitions, 1);
  std::sort(settings.n.begin(), settings.n.end());
  // Those on which CGAL's trees end, too, in reasonable time.
  if (settings.inputs.empty()) settings.inputs = {"uniform", "plummer", "kuzmin", "grid", "line", "spiral"};
  for (const std::string& input : settings.inputs) quadtree_inputs::by_name(input);
  return settings;
}

} // namespace

int main(int argc, char** argv) try {
  const std::optional<Settings> settings = parse(argc, argv);
  if (!settings) return 0;
  const ordered_json figures = settings->counts_rounds ? count_rounds(*settings) : compare_all(*settings);
  if (settings->json_file.empty()) return 0;
  write_figures(settings->json_file, settings->counts_rounds ? "rounds" : "comparisons", figures,
                settings->repetitions);
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << '\n';
  return 2;
}
