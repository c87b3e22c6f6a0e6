// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The figures of the documents that do not depend on the machine are those of this program.

#include "catch.h"

#if __has_include(<nlohmann/json.hpp>)

#include "points_ours.h"
#include "pslg_files.h"
#include "quadtree_inputs.h"

#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/Quality_mesher_2.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace test_document_figures {

namespace {

using nlohmann::json;
using Options = CGAL::Quality_mesh_options_2;
const std::string root = QUADTREE_MESH_SOURCE_DIR;

json comparisons_of(const std::string& name) {
  INFO("without them: benchmark/run.sh --docs");
  std::ifstream in(root + "/doc/figures/" + name + ".json");
  REQUIRE(in.good());
  return json::parse(in).at("comparisons");
}

pslg_inputs::Input input_of(const std::string& name) {
  for (const char* folder : {"/examples/data/", "/test/data/"})
    for (const char* ending : {".poly", ".poly.gz"})
      if (const std::string file = root + folder + name + ending; std::filesystem::exists(file))
        return pslg_files::input_of(file);
  return pslg_files::input_of(name);
}

/// Whether there is a mesh, and it takes no more seconds to make than a run has.
bool shall_be_made(const json& figures, double seconds) {
  return figures.contains("triangles") &&
         (is_full_run() || figures.at("cpu_seconds").get<double>() < seconds);
}

/// The report of the mesh made anew, whose triangles are as many as the documents say.
CGAL::Quality_mesh_report_2 mesh_as_documented(const pslg_inputs::Input& input, Options options,
                                               const json& made) {
  CGAL::Quality_mesher_2<> mesher(options.max_area(input.max_area));
  const std::size_t triangles = mesher(input.pslg).number_of_triangles();
  INFO("figures of the documents are of another state: benchmark/run.sh --docs");
  CHECK(triangles == made.at("triangles").get<std::size_t>());
  return mesher.report();
}

using Cells = std::vector<std::string>;

/// The rows of the table in a document below this header, without the spaces that numbers have.
std::vector<Cells> rows_below(const std::string& header, const std::string& document) {
  std::ifstream in(root + "/doc/" + document);
  std::string line;
  while (std::getline(in, line) && line != header) continue;
  std::vector<Cells> rows;
  for (std::getline(in, line); std::getline(in, line) && !line.empty() && line[0] == '|';) {
    line.erase(std::remove(line.begin(), line.end(), ' '), line.end());
    Cells& cells = rows.emplace_back();
    for (std::size_t begin = 1, end; (end = line.find('|', begin)) != std::string::npos; begin = end + 1)
      cells.push_back(line.substr(begin, end - begin));
  }
  return rows;
}

std::size_t number_of_triangles(const std::string& name, const Options& options) {
  return CGAL::Quality_mesher_2<>(options)(input_of(name).pslg).number_of_triangles();
}

} // namespace

TEST_CASE("Numbers of triangles in the text are those of this program", "[documents]") {
  INFO("examples/poisson_eigen prints the table of examples.md, quality_mesh --thin the numbers of "
       "user_manual.md");
  const auto by_bound = rows_below(
      "| bound | least angle | triangles | unknowns | largest eigenvalue | condition |", "examples.md");
  REQUIRE(by_bound.size() == 5);
  for (const Cells& row : by_bound) {
    CAPTURE(row[0]);
    CHECK(number_of_triangles("great_lakes", Options().min_angle(std::stod(row[0])).max_area(5e7)) ==
          std::stoul(row[2]));
  }
  const auto by_rounds = rows_below("| input | 0 | 1 | 2 | 3 |", "user_manual.md");
  REQUIRE(by_rounds.size() == 4);
  for (const Cells& row : by_rounds)
    for (int rounds = 0; rounds <= 3 && (is_full_run() || row[0] == "great_lakes"); ++rounds) {
      CAPTURE(row[0], rounds);
      CHECK(number_of_triangles(row[0], Options().thin(rounds)) == std::stoul(row[std::size_t(rounds) + 1]));
    }
}

TEST_CASE("Numbers of triangles of graphs are those of the documents", "[documents]") {
  for (const char* name : {"maps", "bounds", "synthetic"})
    for (const json& comparison : comparisons_of(name))
      for (const json& made : comparison.at("meshers")) {
        if (made.at("mesher") != "ours" || !shall_be_made(made, 1)) continue;
        CAPTURE(name, comparison.at("input"));
        mesh_as_documented(input_of(comparison.at("input")),
                           Options().min_angle(comparison.at("min_angle_bound")), made);
      }
}

TEST_CASE("Numbers of triangles with a bound on the greatest angle are those of the documents",
          "[documents]") {
  for (const json& comparison : comparisons_of("max_angle"))
    for (const json& made : comparison.at("meshers")) {
      if (made.at("mesher") == "ours" || !shall_be_made(made, 1)) continue;
      CAPTURE(comparison.at("input"));
      const double bound = comparison.at("max_angle_bound");
      const auto report =
          mesh_as_documented(input_of(comparison.at("input")), Options().max_angle(bound), made);
      CHECK(report.unmet_triangles.size() == made.at("above_max_angle").get<std::size_t>());
    }
}

TEST_CASE("What is said of Theorem 5 in the documents is so", "[documents][theorem5]") {
  for (const json& comparison : comparisons_of("separation"))
    for (const json& made : comparison.at("outcomes")) {
      if (!shall_be_made(made, 1)) continue;
      CAPTURE(comparison.at("input"), made.at("separation"));
      const pslg_inputs::Input input = input_of(comparison.at("input"));
      if (made.at("separation") == "on demand, smoothed and thinned")
        mesh_as_documented(input, Options().smooth(2).thin(2), made);
      if (made.at("separation") == "Theorem 5") {
        const auto report =
            mesh_as_documented(input, Options().separate(Options::Separation::THEOREM_5), made);
        INFO("figures of the documents are of another state: benchmark/run.sh --docs");
        CHECK(report.trees.rounds == made.at("trees").at("rounds").get<std::size_t>());
      }
    }
}

TEST_CASE("Numbers of triangles of points are those of the documents", "[documents]") {
  for (const json& comparison : comparisons_of("points_modes"))
    for (const json& made : comparison.at("meshers")) {
      if (!shall_be_made(made, 2)) continue;
      CAPTURE(comparison.at("input"), made.at("mesher"));
      const std::size_t n = comparison.at("points");
      const auto points = quadtree_inputs::by_name(comparison.at("input")).make(n, n);
      CGAL::Point_set_mesher_2<> mesher(points_ours::mode_by_name(made.at("mesher")).options);
      INFO("figures of the documents are of another state: benchmark/run.sh --docs");
      CHECK(mesher(points).number_of_triangles() == made.at("triangles").get<std::size_t>());
    }
}

} // namespace test_document_figures

#endif
