// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Our mesher, CGAL Mesh_2 and Shewchuk's Triangle on the same graphs and the same bound, alternately, so that
// all meet the same state of the machine. Every run is a process of its own: its memory is what one mesher
// needs, and a mesher that does not end is stopped. Prints Markdown tables; --json FILE writes the same
// figures for programs. Ends with status 1 if a mesh of ours is not valid.

#include "benchmark_options.h"
#include "pslg_files.h"
#include "pslg_inputs.h"
#include "pslg_mesh_2.h"
#include "pslg_ours.h"
#include "pslg_outcomes.h"
#include "pslg_tables.h"
#include "pslg_triangle.h"

#include <CGAL/version.h>

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
  std::vector<double> min_angles{20.7};
  double max_angle = 0;
  std::vector<unsigned> threads;
  std::vector<std::string> peers;
  std::string triangle;
  std::vector<std::string> growth_families;
  std::vector<std::string> sizes{"1e4", "3e4", "1e5", "3e5", "1e6"};
  int repetitions = 5;
  unsigned limit_seconds = 120;
  std::string json_file;
  std::vector<std::string> inputs;
};

std::vector<Pslg_method> methods_of(const Settings& settings) {
  std::vector<Pslg_method> methods = pslg_ours::methods(settings.threads, settings.max_angle);
  for (const std::string& peer : settings.peers) {
    if (peer == "mesh_2") methods.push_back(pslg_mesh_2::method());
    if (peer == "triangle") methods.push_back(pslg_triangle::method(settings.triangle));
  }
  return methods;
}

Pslg_comparison compare(const std::string& name, double min_angle, const Settings& settings) {
  const pslg_inputs::Input input = pslg_files::input_of(name);
  Pslg_comparison comparison;
  comparison.input = pslg_files::short_name(name);
  if (pslg_inputs::is_name(name)) comparison.family = name.substr(0, name.find(':'));
  comparison.min_angle = min_angle;
  comparison.max_angle = settings.max_angle;
  comparison.vertices = input.pslg.number_of_vertices();
  comparison.segments = input.pslg.number_of_segments();
  comparison.outcomes = run_alternately<Pslg_outcome>(
      methods_of(settings),
      Pslg_task{input.pslg, input.max_area, min_angle, settings.limit_seconds, settings.max_angle},
      settings.repetitions);
  const std::string fault = comparison.fault();
  std::fprintf(stderr, "%s, %g degrees: %s\n", name.c_str(), min_angle, fault.empty() ? "ok" : fault.c_str());
  return comparison;
}

void print_preface(const Settings& settings) {
  std::printf(
      "Medians of %d runs (one where a run takes more than %g s), from points and segments in memory to a\n"
      "mesh in memory; \"-\": no mesh within %u s. Below the bound are triangles that no acute corner\n"
      "of the input forces there; those in acute corners are counted apart; both by mesh_quality_2(). MB is\n"
      "the most memory of the process, input and program included. Mesh_2 is that of CGAL %s",
      settings.repetitions, settings.limit_seconds / 4.0, settings.limit_seconds, CGAL_VERSION_STR);
  if (std::count(settings.peers.begin(), settings.peers.end(), "triangle") > 0)
    std::printf(";\nTriangle's seconds are the milliseconds that it prints, without its files");
  std::printf(".\n\n");
}

/// Every input, or every size of a family.
std::vector<std::string> names_of_inputs(const Settings& settings) {
  if (settings.growth_families.empty()) return settings.inputs;
  std::vector<std::string> names;
  for (const std::string& family : settings.growth_families)
    for (const std::string& size : settings.sizes) names.push_back(family + ':' + size);
  return names;
}

pslg_tables::Comparisons compare_all(double min_angle, const Settings& settings) {
  pslg_tables::Comparisons comparisons;
  for (const std::string& name : names_of_inputs(settings))
    comparisons.push_back(compare(name, min_angle, settings));

  std::printf("### %g degrees\n\n", min_angle);
  pslg_tables::print_triangles(comparisons);
  pslg_tables::print_time(comparisons);
  pslg_tables::print_phases(comparisons);
  if (settings.max_angle > 0) pslg_tables::print_angles(comparisons);
  if (!settings.threads.empty()) pslg_tables::print_threads(comparisons);
  if (!settings.growth_families.empty()) pslg_tables::print_growth(comparisons);
  return comparisons;
}

po::options_description visible_options(Settings& settings) {
  std::string families;
  for (const auto& family : pslg_inputs::all())
    families += (families.empty() ? "" : ", ") + family.name + ":<" + family.size_name + '>';
  po::options_description options("usage: pslg [option]... [INPUT]...\ninputs: FILE.poly, FILE.poly.gz, " +
                                  families);
  options.add_options()("help,h", "print this") //
      ("min-angle", po::value(&settings.min_angles)->multitoken(),
       "bounds, in degrees; 20.7 by default") //
      ("max-angle", po::value(&settings.max_angle),
       "have ours run again with this bound on the greatest angle, in degrees") //
      ("peers", po::value(&settings.peers)->multitoken(),
       "mesh_2, triangle or none; by default mesh_2, and triangle where its program is given") //
      ("triangle", po::value(&settings.triangle), "the program Triangle of J. R. Shewchuk")    //
      ("threads", po::value(&settings.threads)->multitoken(),
       "numbers of threads on which ours runs, too") //
      ("growth", po::value(&settings.growth_families)->multitoken(),
       "instead of inputs: families whose time per triangle is measured against their size")         //
      ("sizes", po::value(&settings.sizes)->multitoken(), "of them; 1e4 3e4 1e5 3e5 1e6 by default") //
      ("repeat", po::value(&settings.repetitions)->default_value(5), "runs of each mesher")          //
      ("limit", po::value(&settings.limit_seconds)->default_value(120), "seconds for one run")       //
      ("json", po::value(&settings.json_file), "write the figures to this file, too");
  return options;
}

/// Fills in what is not given, and refuses what makes no sense before hours are spent.
void complete(Settings& settings) {
  if (settings.peers.empty()) {
    settings.peers = {"mesh_2"};
    if (!settings.triangle.empty()) settings.peers.push_back("triangle");
  }
  for (const std::string& peer : settings.peers) {
    if (peer != "mesh_2" && peer != "triangle" && peer != "none")
      throw std::invalid_argument("there is no peer '" + peer + "'");
    if (peer == "triangle" && settings.triangle.empty())
      throw std::invalid_argument("--triangle has to say where that program is");
  }
  if (settings.max_angle != 0)
    CGAL::Quality_mesher_2<>(CGAL::Quality_mesh_options_2().max_angle(settings.max_angle));
  if (!settings.threads.empty() && !pslg_ours::has_threads)
    throw std::invalid_argument("the mesher is sequential: no --threads");
  settings.repetitions = std::max(settings.repetitions, 1);
  if (settings.inputs.empty()) settings.inputs = pslg_files::all_of_project();
  for (const std::string& name : settings.growth_families) {
    const pslg_inputs::Family* const family = pslg_inputs::find_family(name + ':');
    if (family == nullptr || family->size == pslg_inputs::Size::MEASURE)
      throw std::invalid_argument("there is no family '" + name + "' whose size is a number of things");
  }
  for (const std::string& name : names_of_inputs(settings)) pslg_files::check(name);
}

/// Nothing if the user asked for help.
std::optional<Settings> parse(int argc, char** argv) {
  Settings settings;
  const po::options_description visible = visible_options(settings);
  po::variables_map given;
  if (!parse_options_and_inputs(argc, argv, visible, settings.inputs, given)) return std::nullopt;
  complete(settings);
  return settings;
}

} // namespace

int main(int argc, char** argv) try {
  const std::optional<Settings> settings = parse(argc, argv);
  if (!settings) return 0;
  print_preface(*settings);
  ordered_json json = ordered_json::array();
  bool has_fault = false;
  for (const double min_angle : settings->min_angles) {
    const auto comparisons = compare_all(min_angle, *settings);
    for (const Pslg_comparison& comparison : comparisons) has_fault |= !comparison.fault().empty();
    for (auto& comparison : pslg_tables::to_json(comparisons)) json.push_back(comparison);
  }
  if (!settings->json_file.empty())
    write_figures(settings->json_file, "comparisons", json, settings->repetitions);
  return has_fault ? 1 : 0;
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << '\n';
  return 2;
}
