// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Our mesher of points in all its modes, and CGAL Mesh_2 and Shewchuk's Triangle on the same points in a box,
// alternately, so that all meet the same state of the machine. Every run is a process of its own: its memory
// is what one mesher needs, and a mesher that does not end is stopped. Prints Markdown tables; --json FILE
// writes the same figures for programs. Ends with status 1 if a mesh of ours is not valid, has an angle
// outside of its range, or has other bits in another run or with another number of threads.

#include "benchmark_options.h"
#include "in_child.h"
#include "points_ours.h"
#include "points_outcomes.h"
#include "points_peers.h"
#include "points_tables.h"
#include "quadtree_inputs.h"

#include <CGAL/Quadtree_mesh_2/internal/frame/points_in_box.h>
#include <CGAL/point_set_lengths_2.h>
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
  std::vector<double> n; // as doubles, so that 1e5 can be written
  std::vector<std::string> inputs;
  std::vector<std::string> modes;
  std::vector<std::string> peers;
  std::string triangle;
  std::vector<unsigned> threads;
  int repetitions = 3;
  Limits limits;
  bool is_growth = false;
  std::string json_file;
};

std::vector<Points_method> methods_of(const Settings& settings) {
  std::vector<Points_method> methods;
  for (const std::string& mode : settings.modes) {
    auto more = points_ours::methods(mode, settings.threads);
    std::move(more.begin(), more.end(), std::back_inserter(methods));
  }
  for (const std::string& peer : settings.peers) {
    if (peer == "mesh_2") methods.push_back(points_peers::mesh_2());
    if (peer != "triangle") continue;
    methods.push_back(points_peers::triangle(settings.triangle));
    methods.push_back(points_peers::triangle_at_33(settings.triangle));
  }
  return methods;
}

/// In a process of its own, for its memory would count as that of every mesher.
double least_length(const Points& points, const Limits& limits) {
  const auto lengths = in_child([&] { return CGAL::point_set_lengths_2(points); }, limits.seconds).result;
  return lengths ? lengths->least_mesh() : 0;
}

Points_comparison compare(const std::string& input, std::size_t n, const Settings& settings) {
  const Points points = quadtree_inputs::by_name(input).make(n, n);
  const Pslg box = CGAL::Quadtree_mesh_2::internal::points_in_box(points);
  Points_comparison comparison;
  comparison.input = input;
  comparison.n = n;
  comparison.least_length = least_length(points, settings.limits);
  comparison.outcomes = run_alternately<Points_outcome>(
      methods_of(settings), Points_task{points, box, settings.limits.seconds, settings.limits.gigabytes},
      settings.repetitions);
  const std::string fault = comparison.fault();
  std::fprintf(stderr, "%s, %zu points: %s\n", input.c_str(), n, fault.empty() ? "ok" : fault.c_str());
  return comparison;
}

void print_preface(const Settings& settings) {
  std::printf(
      "Medians of %d runs (one where a run takes more than %g s), from points in memory to a mesh in "
      "memory;\n"
      "\"-\": no mesh within %u s and, of ours, %g GB. Our modes are bounded (all angles in [36, 80] "
      "degrees),\n"
      "tight ([37.5, 78.6]), wide ([30, 89.5]), acute (below 90, O(n) triangles), points (at least 20.7 in "
      "a\n"
      "box) and warped (warped squares, in [22.46, 112.64]), each with its coarsening effort behind a colon\n"
      "where that is not 2. The lower bound of lengths holds for every mesh of the points. MB is the most\n"
      "memory of the process, input and program included. Peers refine the Delaunay triangulation of the "
      "points\n"
      "in the box of \"points\", with the bound on angles that their names say; Mesh_2 is that of CGAL %s",
      settings.repetitions, settings.limits.seconds / 4.0, settings.limits.seconds, settings.limits.gigabytes,
      CGAL_VERSION_STR);
  if (std::count(settings.peers.begin(), settings.peers.end(), "triangle") > 0)
    std::printf(";\nTriangle's seconds are the milliseconds that it prints, without its files");
  if (settings.is_growth) std::printf(".\nk is the number of triangles before the mesh is coarsened");
  std::printf(".\n\n");
}

points_tables::Comparisons compare_sizes(const std::string& input, const Settings& settings) {
  points_tables::Comparisons comparisons;
  for (const double n : settings.n) comparisons.push_back(compare(input, std::size_t(n), settings));

  std::printf("### %s\n\n", input.c_str());
  points_tables::print_meshes(comparisons);
  points_tables::print_phases(comparisons);
  points_tables::print_ratios(comparisons);
  if (!settings.threads.empty()) points_tables::print_threads(comparisons);
  if (settings.is_growth) points_tables::print_growth(comparisons);
  return comparisons;
}

po::options_description visible_options(Settings& settings) {
  std::string inputs, modes;
  for (const auto& input : quadtree_inputs::all()) inputs += (inputs.empty() ? "" : ", ") + input.name;
  for (const auto& mode : points_ours::all_modes()) modes += (modes.empty() ? "" : ", ") + mode.name;
  po::options_description options("usage: points [option]... [INPUT]...\ninputs: " + inputs);
  options.add_options()("help,h", "print this") //
      ("n", po::value(&settings.n)->multitoken(),
       "numbers of points; 1e3 1e4 by default, with --growth 1e3 1e4 1e5") //
      ("modes", po::value(&settings.modes)->multitoken(),
       ("of ours: " + modes +
        "; with an effort of 0 to 3 as bounded:0; all and bounded's efforts by default, "
        "with --growth bounded, acute and points")
           .c_str()) //
      ("peers", po::value(&settings.peers)->multitoken(),
       "mesh_2, triangle or none; by default mesh_2, and triangle where its program is given; with --growth "
       "none")                                                                              //
      ("triangle", po::value(&settings.triangle), "the program Triangle of J. R. Shewchuk") //
      ("threads", po::value(&settings.threads)->multitoken(),
       "numbers of threads on which ours runs, too") //
      ("growth", po::bool_switch(&settings.is_growth),
       "measure time by n log n + k, and triangles per point")                                         //
      ("repeat", po::value(&settings.repetitions)->default_value(3), "runs of each mesher")            //
      ("limit", po::value(&settings.limits.seconds)->default_value(120), "seconds for one run")        //
      ("memory", po::value(&settings.limits.gigabytes)->default_value(8), "gigabytes for one of ours") //
      ("json", po::value(&settings.json_file), "write the figures to this file, too");
  return options;
}

/// Fills in what is not given, and refuses what makes no sense before hours are spent.
void complete(Settings& settings) {
  if (settings.n.empty())
    settings.n = settings.is_growth ? std::vector<double>{1e3, 1e4, 1e5} : std::vector<double>{1e3, 1e4};
  std::sort(settings.n.begin(), settings.n.end());
  if (!(settings.n.front() >= 2)) throw std::invalid_argument("there have to be two points");
  if (settings.inputs.empty())
    for (const auto& input : quadtree_inputs::all()) settings.inputs.push_back(input.name);
  for (const std::string& input : settings.inputs) quadtree_inputs::by_name(input);
  if (settings.modes.empty())
    settings.modes = settings.is_growth
                         ? std::vector<std::string>{"bounded", "acute", "points"}
                         : std::vector<std::string>{"bounded:0", "bounded:1", "bounded", "bounded:3", "tight",
                                                    "wide",      "acute",     "points",  "warped"};
  for (const std::string& mode : settings.modes) points_ours::mode_by_name(mode);
  if (settings.peers.empty() && !settings.is_growth) {
    settings.peers = {"mesh_2"};
    if (!settings.triangle.empty()) settings.peers.push_back("triangle");
  }
  for (const std::string& peer : settings.peers) {
    if (peer != "mesh_2" && peer != "triangle" && peer != "none")
      throw std::invalid_argument("there is no peer '" + peer + "'");
    if (peer == "triangle" && settings.triangle.empty())
      throw std::invalid_argument("--triangle has to say where that program is");
  }
  if (!settings.threads.empty() && !points_ours::has_threads)
    throw std::invalid_argument("the mesher is sequential: no --threads");
  settings.repetitions = std::max(settings.repetitions, 1);
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
  for (const std::string& input : settings->inputs)
    for (const Points_comparison& comparison : compare_sizes(input, *settings)) {
      has_fault |= !comparison.fault().empty();
      json.push_back(points_tables::to_json(comparison));
    }
  if (!settings->json_file.empty())
    write_figures(settings->json_file, "comparisons", json, settings->repetitions);
  return has_fault ? 1 : 0;
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << '\n';
  return 2;
}
