// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Both models of vertex-edge neighbors and the decompositions of CGAL alone on the same graphs, alternately, so
// that all meet the same state of the machine. Prints a Markdown table; --json FILE writes the same figures for
// programs. Ends with status 1 if the models differ in any first hit.

#include "benchmark_options.h"
#include "markdown_table.h"
#include "measurement.h"
#include "neighbors_cgal.h"
#include "pslg_inputs.h"
#include "thread_limit.h"

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/IO/read_triangle_files.h>
#include <CGAL/Quadtree_vertex_edge_neighbors_2.h>
#include <CGAL/Trapezoidal_vertex_edge_neighbors_2.h>

#include <boost/program_options.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace po = boost::program_options;
using nlohmann::ordered_json;
using Traits = CGAL::Filtered_quadtree_traits_2<>;
using Pslg = CGAL::Pslg_2<Traits::Point_2>;

struct Settings {
  std::vector<unsigned> threads{1, 2};
  int repetitions = 7;
  std::string json_file;
  std::vector<std::string> inputs;
};

struct Method {
  std::string name;
  unsigned threads; ///< 0: sequential
  std::function<void(const Pslg&)> run;
};

struct Outcome {
  Method method;
  std::vector<double> cpu, wall;
};

/// Makes the neighbors, and lets them go.
template <template <class, class> class Model, class ConcurrencyTag>
void make(const Pslg& pslg) {
  const Model<Traits, ConcurrencyTag> neighbors(pslg);
}

std::vector<Method> methods_of(const Settings& settings) {
  std::vector<Method> methods{
      {"CGAL", 0,
       [](const Pslg& pslg) {
         neighbors_cgal::decompose(pslg, true);
         neighbors_cgal::decompose(pslg, false);
       }},
      {"trapezoids", 0, make<CGAL::Trapezoidal_vertex_edge_neighbors_2, CGAL::Sequential_tag>},
      {"quadtree", 0, make<CGAL::Quadtree_vertex_edge_neighbors_2, CGAL::Sequential_tag>}};
  for (const unsigned threads : settings.threads) {
    methods.push_back(
        {"trapezoids", threads, make<CGAL::Trapezoidal_vertex_edge_neighbors_2, CGAL::Parallel_tag>});
    methods.push_back(
        {"quadtree", threads, make<CGAL::Quadtree_vertex_edge_neighbors_2, CGAL::Parallel_tag>});
  }
  return methods;
}

std::vector<Outcome> run_alternately(const Pslg& pslg, const Settings& settings) {
  std::vector<Outcome> outcomes;
  for (const Method& method : methods_of(settings)) outcomes.push_back({method, {}, {}});
  for (int i = 0; i < settings.repetitions; ++i)
    for (Outcome& outcome : outcomes) {
      const Thread_limit limit(outcome.method.threads);
      const Stopwatch stopwatch;
      outcome.method.run(pslg);
      const Seconds seconds = stopwatch.seconds();
      outcome.cpu.push_back(seconds.cpu);
      outcome.wall.push_back(seconds.wall);
    }
  return outcomes;
}

/// In how many first hits the models differ: in the segment, or in any bit of the distance.
std::size_t count_differences(const Pslg& pslg) {
  using CGAL::Quadtree_mesh_2::Direction;
  const CGAL::Trapezoidal_vertex_edge_neighbors_2<Traits> a(pslg);
  const CGAL::Quadtree_vertex_edge_neighbors_2<Traits> b(pslg);
  std::size_t n = 0;
  for (std::size_t i = 0; i < pslg.number_of_vertices(); ++i)
    for (const Direction d : {Direction::EAST, Direction::NORTH, Direction::WEST, Direction::SOUTH}) {
      const CGAL::Quadtree_mesh_2::Vertex_index v(i);
      const auto &p = a.first_hit(v, d), &q = b.first_hit(v, d);
      n += p.segment != q.segment || p.distance != q.distance ? 1 : 0;
    }
  return n;
}

Pslg input_of(const std::string& name) {
  if (pslg_inputs::is_name(name)) return pslg_inputs::by_name(name).pslg;
  Pslg pslg;
  CGAL::IO::read_triangle_poly(name, pslg);
  return pslg;
}

std::string name_of(const Method& method) {
  if (method.threads == 0) return method.name;
  return method.name + ", " + std::to_string(method.threads) + (method.threads == 1 ? " thread" : " threads");
}

/// Returns whether the models agree.
bool compare(const std::string& name, const Settings& settings, ordered_json& json) {
  const Pslg pslg = input_of(name);
  const std::size_t differences = count_differences(pslg);
  const std::vector<Outcome> outcomes = run_alternately(pslg, settings);
  const double cgal = median(outcomes[0].wall);
  std::printf("### %s: %zu vertices, %zu segments, %zu first hits differ\n\n",
              std::filesystem::path(name).filename().c_str(), pslg.number_of_vertices(),
              pslg.number_of_segments(), differences);
  Markdown_table table({"", "processor, ms", "wall, ms", "wall / CGAL's", "least wall, ms"});
  for (const Outcome& o : outcomes) {
    table.add_row({name_of(o.method), three_digits(1e3 * median(o.cpu)), three_digits(1e3 * median(o.wall)),
                   fixed(median(o.wall) / cgal, 2),
                   three_digits(1e3 * *std::min_element(o.wall.begin(), o.wall.end()))});
    json.push_back({{"input", name},
                    {"vertices", pslg.number_of_vertices()},
                    {"segments", pslg.number_of_segments()},
                    {"method", o.method.name},
                    {"threads", o.method.threads},
                    {"cpu_seconds", median(o.cpu)},
                    {"wall_seconds", median(o.wall)},
                    {"differences", differences}});
  }
  table.print();
  return differences == 0;
}

po::options_description visible_options(Settings& settings) {
  std::string families;
  for (const auto& family : pslg_inputs::all())
    families += (families.empty() ? "" : ", ") + family.name + ":<" + family.size_name + '>';
  po::options_description options(
      "usage: neighbors [option]... [INPUT]...\ninputs: FILE.poly, FILE.poly.gz, " + families);
  options.add_options()("help,h", "print this") //
      ("threads", po::value(&settings.threads)->multitoken(),
       "numbers of threads on which ours run, besides sequentially; 1 2 by default")        //
      ("repeat", po::value(&settings.repetitions)->default_value(7), "runs of each method") //
      ("json", po::value(&settings.json_file), "write the figures to this file, too");
  return options;
}

/// Nothing if the user asked for help.
std::optional<Settings> parse(int argc, char** argv) {
  Settings settings;
  const po::options_description visible = visible_options(settings);
  po::variables_map given;
  if (!parse_options_and_inputs(argc, argv, visible, settings.inputs, given)) return std::nullopt;
  settings.repetitions = std::max(settings.repetitions, 1);
  if (settings.inputs.empty())
    settings.inputs = {std::string(QUADTREE_MESH_SOURCE_DIR) + "/test/data/gshhg_norway_f.poly.gz",
                       "coast:1e5"};
  for (const std::string& name : settings.inputs)
    if (!pslg_inputs::is_name(name) && !std::filesystem::exists(name))
      throw std::invalid_argument("there is no input '" + name + "'");
  return settings;
}

} // namespace

int main(int argc, char** argv) try {
  const std::optional<Settings> settings = parse(argc, argv);
  if (!settings) return 0;
  std::printf(
      "Medians of %d runs, from a graph in memory to all first hits. \"CGAL\" is both arrangements and\n"
      "their vertical decompositions by CGAL %s alone.\n\n",
      settings->repetitions, CGAL_VERSION_STR);
  ordered_json json = ordered_json::array();
  bool is_equal = true;
  for (const std::string& name : settings->inputs) is_equal &= compare(name, *settings, json);
  if (!settings->json_file.empty())
    write_figures(settings->json_file, "neighbors", json, settings->repetitions);
  return is_equal ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << '\n';
  return 2;
}
