// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Our mesher and CGAL Mesh_2 on the same inputs and the same bound, alternately, so that both meet the same
// state of the machine. Every run is a process of its own: its memory is what one mesher needs, and a mesher
// that does not end is stopped. Prints a Markdown table; --json FILE writes the same figures for programs.

#include "in_child.h"
#include "mesh_2_peer.h"
#include "mesh_figures.h"
#include "resources.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quality_mesher_2.h>

#include <boost/program_options.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace {

namespace po = boost::program_options;

using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point_2>;

struct Settings {
  double min_angle = 20.7;
  int repetitions = 5;
  unsigned limit_seconds = 120;
  std::string json_file;
  std::vector<std::string> inputs;
};

struct Input_size {
  std::size_t vertices = 0;
  std::size_t segments = 0;
};

/// The runs of one mesher on one input, summed up.
struct Outcome {
  std::optional<Mesh_figures> figures; ///< with the median of the seconds; nothing if the mesher gave no mesh
  double peak_memory_mb = 0;
};

struct Row {
  std::string name;
  Input_size size;
  Outcome ours;
  Outcome mesh_2;
};

Pslg read_input(const std::string& file_name) {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(file_name, pslg);
  return pslg;
}

Mesh_figures mesh_by_ours(const Pslg& pslg, double min_angle) {
  Mesh_figures figures;
  CGAL::Quality_mesher_2<> mesher(CGAL::Quality_mesh_options_2().min_angle(min_angle));
  const double start = cpu_seconds();
  const auto mesh = mesher(pslg);
  figures.seconds = cpu_seconds() - start;
  figures.vertices = mesher.report().vertices;
  Mesh_figures_builder(figures, min_angle).add_triangles_of(mesh);
  return figures;
}

/// Gathers runs of one mesher; a mesher that failed once is not asked again.
class Outcome_builder {
public:
  template <class F>
  void run(F mesher, unsigned limit_seconds) {
    if (has_failed_) return;
    const auto child = in_child(mesher, limit_seconds);
    peak_memory_mb_.push_back(child.peak_memory_mb);
    if (child.result) runs_.push_back(*child.result);
    has_failed_ = !child.result;
  }

  Outcome outcome() const {
    Outcome result;
    if (!peak_memory_mb_.empty()) result.peak_memory_mb = median(peak_memory_mb_);
    if (runs_.empty() || has_failed_) return result;
    result.figures = runs_.front();
    std::vector<double> seconds;
    for (const Mesh_figures& run : runs_) seconds.push_back(run.seconds);
    result.figures->seconds = median(seconds);
    return result;
  }

private:
  static double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  }

  std::vector<Mesh_figures> runs_;
  std::vector<double> peak_memory_mb_;
  bool has_failed_ = false;
};

Row measure(const std::string& file_name, const Settings& settings) {
  Row row;
  row.name = std::filesystem::path(file_name).filename().string();
  row.name.resize(row.name.find(".poly"));
  const auto size = in_child(
      [&] {
        const Pslg pslg = read_input(file_name);
        return Input_size{pslg.number_of_vertices(), pslg.number_of_segments()};
      },
      settings.limit_seconds);
  if (!size.result) return row;
  row.size = *size.result;

  Outcome_builder ours, mesh_2;
  for (int i = 0; i < settings.repetitions; ++i) {
    ours.run([&] { return mesh_by_ours(read_input(file_name), settings.min_angle); }, settings.limit_seconds);
    mesh_2.run([&] { return mesh_by_Mesh_2(read_input(file_name), settings.min_angle, 0); },
               settings.limit_seconds);
  }
  row.ours = ours.outcome();
  row.mesh_2 = mesh_2.outcome();
  return row;
}

void print_cells(const Outcome& outcome) {
  if (!outcome.figures) {
    std::printf(" no mesh | - | - | - | %.0f |", outcome.peak_memory_mb);
    return;
  }
  const Mesh_figures& figures = *outcome.figures;
  std::printf(" %zu | %.4f | %.2f | %zu | %.0f |", figures.triangles, figures.seconds, figures.min_angle,
              figures.below_bound, outcome.peak_memory_mb);
}

void print_header(const Settings& settings) {
  std::printf("Bound %g degrees, medians of %d runs, processor seconds in memory to in memory, \"below\": "
              "triangles below the "
              "bound for whatever\nreason, peak memory of the process in MB; first our mesher, then CGAL "
              "Mesh_2 %s.\n\n",
              settings.min_angle, settings.repetitions, CGAL_VERSION_STR);
  std::printf("| input | vertices | triangles | s | least angle | below | MB "
              "| Mesh_2: triangles | s | least angle | below | MB | triangles, ratio | time, ratio |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void print_row(const Row& row) {
  std::printf("| %s | %zu |", row.name.c_str(), row.size.vertices);
  print_cells(row.ours);
  print_cells(row.mesh_2);
  if (row.ours.figures && row.mesh_2.figures)
    std::printf(" %.3f | %.3f |\n",
                double(row.ours.figures->triangles) / double(row.mesh_2.figures->triangles),
                row.ours.figures->seconds / row.mesh_2.figures->seconds);
  else
    std::printf(" - | - |\n");
  std::fflush(stdout);
}

nlohmann::ordered_json to_json(const Outcome& outcome) {
  if (!outcome.figures) return nullptr;
  const Mesh_figures& figures = *outcome.figures;
  return {{"vertices", figures.vertices},
          {"triangles", figures.triangles},
          {"min_angle", figures.min_angle},
          {"max_angle", figures.max_angle},
          {"below_bound", figures.below_bound},
          {"cpu_seconds", figures.seconds},
          {"peak_memory_mb", outcome.peak_memory_mb}};
}

void write_json(const std::vector<Row>& rows, const Settings& settings) {
  nlohmann::ordered_json json = {
      {"min_angle", settings.min_angle}, {"repetitions", settings.repetitions}, {"cgal", CGAL_VERSION_STR}};
  for (const Row& row : rows)
    json["inputs"].push_back({{"name", row.name},
                              {"vertices", row.size.vertices},
                              {"segments", row.size.segments},
                              {"ours", to_json(row.ours)},
                              {"mesh_2", to_json(row.mesh_2)}});
  std::ofstream out(settings.json_file);
  out << json.dump(2) << '\n';
  if (!out.flush()) throw std::runtime_error("cannot write '" + settings.json_file + "'");
}

bool is_input(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  return path.extension() == ".poly" ||
         (name.size() > 8 && name.compare(name.size() - 8, 8, ".poly.gz") == 0);
}

/// The inputs of the examples and of the tests.
std::vector<std::string> default_inputs() {
  std::vector<std::string> inputs;
  for (const char* folder : {"/examples/data", "/test/data"})
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(QUADTREE_MESH_SOURCE_DIR) + folder))
      if (is_input(entry.path())) inputs.push_back(entry.path().string());
  std::sort(inputs.begin(), inputs.end());
  return inputs;
}

/// Nothing if the user asked for help.
std::optional<Settings> parse(int argc, char** argv) {
  Settings settings;
  po::options_description visible("usage: versus_mesh_2 [option]... [FILE.poly[.gz]]...");
  visible.add_options()("help,h", "print this")                                                           //
      ("min-angle", po::value(&settings.min_angle)->default_value(20.7, "20.7"), "the bound, in degrees") //
      ("repetitions", po::value(&settings.repetitions)->default_value(5), "runs of each mesher")          //
      ("limit", po::value(&settings.limit_seconds)->default_value(120), "seconds for one run")            //
      ("json", po::value(&settings.json_file), "write the figures to this file, too");
  po::options_description all = visible;
  all.add_options()("input", po::value(&settings.inputs));
  po::positional_options_description positional;
  positional.add("input", -1);
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).run(), given);
  po::notify(given);
  if (given.count("help") > 0) {
    std::cout << visible;
    return std::nullopt;
  }
  if (settings.inputs.empty()) settings.inputs = default_inputs();
  return settings;
}

} // namespace

int main(int argc, char** argv) try {
  const std::optional<Settings> settings = parse(argc, argv);
  if (!settings) return 0;
  print_header(*settings);
  std::vector<Row> rows;
  for (const std::string& input : settings->inputs) {
    rows.push_back(measure(input, *settings));
    print_row(rows.back());
  }
  if (!settings->json_file.empty()) write_json(rows, *settings);
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << '\n';
  return 2;
}
