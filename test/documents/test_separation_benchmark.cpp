// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The benchmark of separations runs, finds no fault, and counts rounds.

#ifdef QUADTREE_MESH_SEPARATION_BENCHMARK

#include "catch.h"
#include "scratch_folder.h"

#include <nlohmann/json.hpp>

#include <sys/wait.h>

#include <cstdlib>
#include <string>

namespace test_separation_benchmark {

TEST_CASE("The benchmark of separations runs", "[benchmark][program]") {
  const Scratch_folder folder;
  const std::string json_file = folder.file("json");
  const auto status_of = [&folder](const std::string& arguments) {
    const int status = std::system(("'" QUADTREE_MESH_SEPARATION_BENCHMARK "' " + arguments + " >'" +
                                    folder.file("out") + "' 2>/dev/null")
                                       .c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  REQUIRE(status_of("coast:300 wedge:1 --repeat 1 --json '" + json_file + "'") == 0);
  const auto comparisons = nlohmann::json::parse(content(json_file)).at("comparisons");
  REQUIRE(comparisons.size() == 2);
  for (const auto& comparison : comparisons) {
    REQUIRE(comparison.at("outcomes").size() == 6);
    for (const auto& outcome : comparison.at("outcomes")) {
      CHECK(outcome.at("below_bound") == 0);
      CHECK(outcome.at("triangles_without_removal") >= outcome.at("triangles"));
      CHECK(outcome.contains("trees") ==
            (outcome.at("separation").get<std::string>().substr(0, 7) == "Theorem"));
    }
  }
  CHECK(content(folder.file("out")).find("| coast:300 | ") != std::string::npos);

  REQUIRE(status_of("--rounds --families blob --sizes 100 200 --json '" + json_file + "'") == 0);
  const auto rounds = nlohmann::json::parse(content(json_file)).at("rounds");
  REQUIRE(rounds.size() == 2);
  for (const auto& row : rounds) {
    for (const char* stage : {"of_points", "of_neighbors", "subdivisions", "placings", "of_input", "of_trees",
                              "of_placing", "of_cure", "of_output"})
      CHECK(row.at(stage) > 0);
    CHECK(row.at("all") > row.at("subdivisions"));
    CHECK(row.at("steps") > row.at("of_placing"));
  }
  CHECK(status_of("--help") == 0);
  for (const char* arguments :
       {"no_such_file.poly", "square:x", "--rounds wedge:1", "--rounds --sizes many", "--nothing"})
    CHECK(status_of(arguments) == 2);
}

} // namespace test_separation_benchmark

#endif // QUADTREE_MESH_SEPARATION_BENCHMARK
