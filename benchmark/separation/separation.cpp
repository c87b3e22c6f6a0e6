// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Our mesher's two ways to separate the features of a graph on the same inputs: on demand, and by the quadtrees of
// Theorem 5. Every run is a process of its own. Prints Markdown tables; --json FILE writes the same figures for
// programs. With --rounds it counts the parallel rounds of Theorem 5 instead, as graphs grow. Ends with status 1 if
// a mesh is not valid, or is another one for another way to make it.

#include "benchmark_options.h"
#include "pslg_files.h"
#include "separation_rounds.h"
#include "separation_run.h"
#include "separation_tables.h"

#include <boost/program_options.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace po = boost::program_options;
using nlohmann::ordered_json;

struct Settings {
  double min_angle = 20.7;
  std::vector<unsigned> threads;
  bool counts_rounds = false;
  std::vector<std::string> families{"coast", "segments", "holes"};
  std::vector<std::string> sizes{"1e3", "1e4", "1e5"};
  int repetitions = 3;
  unsigned limit_seconds = 120;
  std::string json_file;
  std::vector<std::string> inputs;
};

Separation_comparison compare(const std::string& name, const Settings& settings) {
  const pslg_inputs::Input input = pslg_files::input_of(name);
  Separation_comparison comparison;
  comparison.input = pslg_files::short_name(name);
  comparison.vertices = input.pslg.number_of_vertices();
  comparison.segments = input.pslg.number_of_segments();
  comparison.outcomes = run_alternately<Separation_outcome>(
      separation_methods(settings.threads),
      Pslg_task{input.pslg, input.max_area, settings.min_angle, settings.limit_seconds},
      settings.repetitions);
  const std::string fault = comparison.fault();
  std::fprintf(stderr, "%s: %s\n", name.c_str(), fault.empty() ? "ok" : fault.c_str());
  return comparison;
}

separation_tables::Comparisons compare_all(const Settings& settings) {
  std::printf(
      "Medians of %d runs (one where a run takes more than %g s), from points and segments in memory to a\n"
      "mesh in memory; the bound is %g degrees. MB is the most memory of the process, input and program\n"
      "included. The construction of Theorem 5 thins blocks out twice, or a small mesh once.\n\n",
      settings.repetitions, settings.limit_seconds / 4.0, settings.min_angle);
  separation_tables::Comparisons comparisons;
  for (const std::string& name : settings.inputs) comparisons.push_back(compare(name, settings));
  separation_tables::print_triangles(comparisons);
  separation_tables::print_trees(comparisons);
  separation_tables::print_time(comparisons);
  return comparisons;
}

/// The rounds of each size of each family.
ordered_json count_rounds(const Settings& settings) {
  std::printf("Parallel rounds of Theorem 5: what is in one may be done at the same time. n vertices, k "
              "triangles of the\n"
              "rule; edges are cut by centroid trees, after each split of leaves. Steps are all loops of the "
              "mesher, over\n"
              "blocks of 512 triangles, by what they are for. What is in no loop is done by one thread.\n\n");
  Markdown_table table({"input", "n", "leaves of T_B*", "k", "T_B", "neighbors", "splits", "centroid height",
                        "subdivisions", "placings", "all", "log2 k log2 n", "all / that"});
  Markdown_table steps({"input", "steps: input", "trees", "placing and triangulation", "cure", "removal",
                        "output", "all", "all / (log2 k log2 n)", "time in no step, %"});
  ordered_json json = ordered_json::array();
  for (const std::string& family : settings.families)
    for (const std::string& size : settings.sizes) {
      const std::string name = family + ':' + size;
      const pslg_inputs::Input input = pslg_inputs::by_name(name);
      const Pslg_task task{input.pslg, input.max_area, settings.min_angle, settings.limit_seconds};
      const auto rounds = in_child([&] { return count_separation_rounds(task); }, task.limit_seconds).result;
      if (!rounds) throw std::runtime_error(name + ": no mesh");
      const std::size_t n = input.pslg.number_of_vertices();
      const double bound = rounds->bound(n);
      table.add_row({name, std::to_string(n), std::to_string(rounds->leaves),
                     std::to_string(rounds->triangles), std::to_string(rounds->of_points),
                     std::to_string(rounds->of_neighbors), std::to_string(rounds->splits),
                     std::to_string(rounds->centroid_height), std::to_string(rounds->subdivisions),
                     std::to_string(rounds->placings), std::to_string(rounds->all()), fixed(bound, 0),
                     fixed(double(rounds->all()) / bound, 2)});
      steps.add_row({name, std::to_string(rounds->of_input), std::to_string(rounds->of_trees),
                     std::to_string(rounds->of_placing), std::to_string(rounds->of_cure),
                     std::to_string(rounds->of_removal), std::to_string(rounds->of_output),
                     std::to_string(rounds->steps()), fixed(double(rounds->steps()) / bound, 2),
                     fixed(100 * rounds->serial_share, 0)});
      json.push_back({{"input", name},
                      {"vertices", n},
                      {"leaves", rounds->leaves},
                      {"triangles", rounds->triangles},
                      {"of_points", rounds->of_points},
                      {"of_neighbors", rounds->of_neighbors},
                      {"splits", rounds->splits},
                      {"centroid_height", rounds->centroid_height},
                      {"subdivisions", rounds->subdivisions},
                      {"placings", rounds->placings},
                      {"of_input", rounds->of_input},
                      {"of_trees", rounds->of_trees},
                      {"of_placing", rounds->of_placing},
                      {"of_cure", rounds->of_cure},
                      {"of_removal", rounds->of_removal},
                      {"of_output", rounds->of_output},
                      {"steps", rounds->steps()},
                      {"serial_share", rounds->serial_share},
                      {"all", rounds->all()},
                      {"bound", bound}});
    }
  table.print();
  steps.print();
  return json;
}

po::options_description visible_options(Settings& settings) {
  std::string families;
  for (const auto& family : pslg_inputs::all())
    families += (families.empty() ? "" : ", ") + family.name + ":<" + family.size_name + '>';
  po::options_description options(
      "usage: separation [option]... [INPUT]...\ninputs: FILE.poly, FILE.poly.gz, " + families);
  options.add_options()("help,h", "print this")                                                           //
      ("min-angle", po::value(&settings.min_angle)->default_value(20.7, "20.7"), "the bound, in degrees") //
      ("threads", po::value(&settings.threads)->multitoken(), "numbers of threads to run on, too")        //
      ("rounds", po::bool_switch(&settings.counts_rounds),
       "count the rounds of families, for each of the sizes")                                      //
      ("families", po::value(&settings.families)->multitoken(), "coast segments holes by default") //
      ("sizes", po::value(&settings.sizes)->multitoken(), "1e3 1e4 1e5 by default")                //
      ("repeat", po::value(&settings.repetitions)->default_value(3), "runs of each")               //
      ("limit", po::value(&settings.limit_seconds)->default_value(120), "seconds for one run")     //
      ("json", po::value(&settings.json_file), "write the figures to this file, too");
  return options;
}

/// Nothing if the user asked for help.
std::optional<Settings> parse(int argc, char** argv) {
  Settings settings;
  const po::options_description visible = visible_options(settings);
  po::variables_map given;
  if (!parse_options_and_inputs(argc, argv, visible, settings.inputs, given)) return std::nullopt;
#ifndef CGAL_LINKED_WITH_TBB
  if (!settings.threads.empty()) throw std::invalid_argument("the mesher is sequential: no --threads");
#endif
  if (settings.counts_rounds && !settings.inputs.empty())
    throw std::invalid_argument("--rounds takes --families and --sizes, no inputs");
  settings.repetitions = std::max(settings.repetitions, 1);
  if (settings.inputs.empty()) settings.inputs = pslg_files::all_of_project();
  for (const std::string& name : settings.inputs) pslg_files::check(name);
  for (const std::string& family : settings.families)
    for (const std::string& size : settings.sizes) pslg_inputs::size_of(family + ':' + size);
  return settings;
}

} // namespace

int main(int argc, char** argv) try {
  const std::optional<Settings> settings = parse(argc, argv);
  if (!settings) return 0;
  bool has_fault = false;
  ordered_json json;
  if (settings->counts_rounds) {
    json = count_rounds(*settings);
  } else {
    const auto comparisons = compare_all(*settings);
    for (const Separation_comparison& comparison : comparisons) has_fault |= !comparison.fault().empty();
    json = separation_tables::to_json(comparisons);
  }
  if (!settings->json_file.empty())
    write_figures(settings->json_file, settings->counts_rounds ? "rounds" : "comparisons", json,
                  settings->repetitions);
  return has_fault ? 1 : 0;
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << '\n';
  return 2;
}
