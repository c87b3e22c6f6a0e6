// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What the parts of a mesh would send each other in rounds of blocks, if each had a memory of its own: messages and
// bytes, counted in one memory (Part_ledger.h). Prints Markdown tables; --json FILE writes the same figures for
// programs. Ends with status 1 if a mesh has other bits than without parts.
//
// With --memory the mesh, the graph and the ledger may be larger than memory: long arrays are in a scratch file.

#include "benchmark_options.h"
#include "markdown_table.h"
#include "mesh_digest.h"
#include "mesh_in_parts.h"
#include "pslg_files.h"

#include <CGAL/Quadtree_mesh_2/new_in_scratch_memory.h> // of this program's own long vectors
#include <CGAL/Scratch_memory.h>

#include <boost/program_options.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cinttypes>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace po = boost::program_options;
using nlohmann::ordered_json;

#ifdef CGAL_LINKED_WITH_TBB
using Concurrency_tag = CGAL::Parallel_tag;
#else
using Concurrency_tag = CGAL::Sequential_tag;
#endif

struct Settings {
  double min_angle = 20.7;
  std::vector<std::size_t> parts;
  bool prints_supersteps = false;
  bool is_without_comparison = false;
  double memory = 0; ///< gigabytes; 0: no limit
  std::string scratch = ".";
  std::string json_file;
  std::vector<std::string> inputs;
};

/// What parts send by kind of superstep.
ordered_json by_superstep(const Mesh_in_parts::Ledger& ledger) {
  struct Sums {
    std::size_t supersteps = 0, messages = 0, bytes = 0;
  };
  std::map<int, Sums> sums;
  for (const auto& step : ledger.exchange().supersteps()) {
    Sums& sum = sums[static_cast<int>(step.kind)];
    ++sum.supersteps;
    for (const auto& traffic : step.sent) sum.messages += traffic.messages, sum.bytes += traffic.bytes;
  }
  ordered_json json = ordered_json::array();
  for (const auto& [kind, sum] : sums)
    json.push_back({{"superstep", name_of(CGAL::Quadtree_mesh_2::internal::Superstep_kind(kind))},
                    {"supersteps", sum.supersteps},
                    {"messages", sum.messages},
                    {"bytes", sum.bytes}});
  return json;
}

std::string hexadecimal(std::uint64_t word) {
  std::array<char, 20> text;
  std::snprintf(text.data(), text.size(), "%016" PRIx64, word);
  return text.data();
}

ordered_json figures_of(const Mesh_in_parts& made, const std::string& input, std::size_t parts) {
  const Part_counts counts = counts_of(made.ledger);
  return {{"input", input},
          {"parts", parts},
          {"triangles", made.mesh.triangles.size()},
          {"digest", hexadecimal(mesh_digest(made.mesh))},
          {"rounds", counts.rounds},
          {"mean_messages", counts.mean_messages},
          {"most_messages", counts.most_messages},
          {"mean_bytes", counts.mean_bytes},
          {"most_bytes", counts.most_bytes},
          {"most_triangles", counts.most_triangles},
          {"most_vertices", counts.most_vertices},
          {"share_worked_on_again", counts.share_worked_on_again},
          {"supersteps", by_superstep(made.ledger)}};
}

void print(const ordered_json& figures) {
  Markdown_table table({"input", "parts", "digest", "rounds", "triangles", "messages a part", "most",
                        "kB a part", "most", "triangles held at most", "worked on again, %"});
  for (const auto& f : figures)
    table.add_row({f["input"], f["parts"].dump(), f["digest"], f["rounds"].dump(), f["triangles"].dump(),
                   fixed(f["mean_messages"], 0), f["most_messages"].dump(),
                   three_digits(f["mean_bytes"].get<double>() / 1e3),
                   three_digits(f["most_bytes"].get<double>() / 1e3), f["most_triangles"].dump(),
                   fixed(100 * f["share_worked_on_again"].get<double>(), 1)});
  table.print();
}

void print_supersteps(const ordered_json& figures) {
  for (const auto& f : figures) {
    const double parts = f["parts"];
    std::printf("%s, %s parts; for each part on average:\n\n", f["input"].get<std::string>().c_str(),
                f["parts"].dump().c_str());
    Markdown_table table({"superstep", "of them", "messages", "kB"});
    for (const auto& s : f["supersteps"])
      table.add_row({s["superstep"], s["supersteps"].dump(),
                     three_digits(s["messages"].get<double>() / parts),
                     three_digits(s["bytes"].get<double>() / parts / 1e3)});
    table.print();
  }
}

po::options_description visible_options(Settings& settings) {
  std::string families;
  for (const auto& family : pslg_inputs::all())
    families += (families.empty() ? "" : ", ") + family.name + ":<" + family.size_name + '>';
  po::options_description options("usage: parts [option]... INPUT...\ninputs: FILE.poly, FILE.poly.gz, " +
                                  families);
  options.add_options()("help,h", "print this")                                                           //
      ("min-angle", po::value(&settings.min_angle)->default_value(20.7, "20.7"), "the bound, in degrees") //
      ("parts", po::value(&settings.parts)->multitoken(), "numbers of parts; 2 7 24 64 by default")       //
      ("supersteps", po::bool_switch(&settings.prints_supersteps),
       "print what is sent by kind of superstep, too") //
      ("without-comparison", po::bool_switch(&settings.is_without_comparison),
       "do not make the mesh without parts, too, to compare bits") //
      ("memory", po::value(&settings.memory),
       "use so many gigabytes of memory at most, and a scratch file for what is more") //
      ("scratch", po::value(&settings.scratch),
       "folder of the scratch file; the current one by default") //
      ("json", po::value(&settings.json_file), "write the figures to this file, too");
  return options;
}

/// Nothing if the user asked for help.
std::optional<Settings> parse(int argc, char** argv) {
  Settings settings;
  const po::options_description visible = visible_options(settings);
  po::variables_map given;
  if (!parse_options_and_inputs(argc, argv, visible, settings.inputs, given)) return std::nullopt;
  if (settings.inputs.empty()) throw std::invalid_argument("which inputs?");
  if (settings.parts.empty()) settings.parts = {2, 7, 24, 64};
  constexpr std::size_t most_parts = 10000;
  for (const std::size_t parts : settings.parts)
    if (parts < 1 || parts > most_parts)
      throw std::invalid_argument("--parts takes numbers from 1 to " + std::to_string(most_parts));
  for (const std::string& name : settings.inputs) pslg_files::check(name);
  return settings;
}

} // namespace

int main(int argc, char** argv) try {
  const std::optional<Settings> settings = parse(argc, argv);
  if (!settings) return 0;
  std::optional<CGAL::Scratch_memory> memory;
  if (settings->memory > 0)
    memory.emplace(settings->scratch, static_cast<std::size_t>(settings->memory * 0x1p30));
  ordered_json figures = ordered_json::array();
  bool has_other_bits = false;
  for (const std::string& name : settings->inputs) {
    const pslg_inputs::Input input = pslg_files::input_of(name);
    const auto options =
        CGAL::Quality_mesh_options_2().min_angle(settings->min_angle).max_area(input.max_area);
    std::optional<std::uint64_t> expected;
    if (!settings->is_without_comparison)
      expected =
          mesh_digest(CGAL::Quality_mesher_2<Mesh_in_parts::Traits, Concurrency_tag>(options)(input.pslg));
    for (const std::size_t parts : settings->parts) {
      const Mesh_in_parts made = mesh_in_parts<Concurrency_tag>(input.pslg, options, parts);
      if (expected && mesh_digest(made.mesh) != *expected) {
        has_other_bits = true;
        std::cerr << "error: " << name << ": other bits with " << parts << " parts\n";
      }
      figures.push_back(figures_of(made, pslg_files::short_name(name), parts));
    }
  }
  print(figures);
  if (settings->prints_supersteps) print_supersteps(figures);
  constexpr int repetitions = 1;
  if (!settings->json_file.empty()) write_figures(settings->json_file, "parts", figures, repetitions);
  return has_other_bits ? 1 : 0;
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << '\n';
  return 2;
}
