// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The options of the command-line program that stand for Triangle's switches, by what Triangle's manual says of these.

#ifdef QUADTREE_MESH_PROGRAM

#include "catch.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_triangle_switches {

using namespace program_test;

namespace {

namespace fs = std::filesystem;

/// Numbered from 1, as Triangle's own examples are.
const char* const square =
    "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 5\n2 2 3 0\n3 3 4 0\n4 4 1 0\n0\n";

/// The numbers in the first line of a file.
std::vector<double> head(const std::string& text) {
  std::istringstream line(text.substr(0, text.find('\n')));
  std::vector<double> numbers;
  for (double x; line >> x;) numbers.push_back(x);
  return numbers;
}

} // namespace

TEST_CASE("Triangle's -e, -n, -v and -o2 are outputs of the program", "[program]") {
  const Scratch_folder folder;
  const std::string in = folder.write("in.poly", square), x = folder.file("x");
  REQUIRE(run(in + " --quiet --max-area 0.1 --second-order -o " + x + ".ele -o " + x + ".edge -o " + x +
              ".neigh -o " + x + ".v.node")
              .status == 0);
  for (const char* ending : {".node", ".ele", ".poly", ".edge", ".neigh", ".v.node", ".v.edge"}) {
    CAPTURE(ending);
    CHECK(fs::exists(x + ending));
  }
  const double nodes = head(content(x + ".node"))[0], triangles = head(content(x + ".ele"))[0],
               edges = head(content(x + ".edge"))[0];
  CHECK(head(content(x + ".ele"))[1] == 6);
  CHECK(nodes - edges - edges + triangles == 1); // nodes are vertices and one for each edge
  CHECK(head(content(x + ".neigh")) == std::vector<double>{triangles, 3});
  CHECK(head(content(x + ".v.node")) == std::vector<double>{triangles, 2, 0, 0});
  CHECK(head(content(x + ".v.edge")) == std::vector<double>{edges, 0});
  CHECK(contains(content(x + ".edge"), " 5\n")); // the marker of the first segment
}

TEST_CASE("cells are written, of a mesh in degrees with areas on the ground", "[program]") {
  const Scratch_folder folder;
  const std::string in = folder.write("in.poly", square);
  REQUIRE(run(in + " --quiet --max-area 0.1 -o " + folder.file("a.cells.geojson") + " -o " +
              folder.file("a.cells.wkt"))
              .status == 0);
  REQUIRE(run(in + " --quiet --max-area 0.1 --cells median -o " + folder.file("b.cells.geojson")).status ==
          0);
  CHECK(content(folder.file("a.cells.wkt")).rfind("POLYGON ((0 0,", 0) == 0);
  const auto area_in = [&](const std::string& name) {
    double sum = 0;
    const auto json = nlohmann::json::parse(content(folder.file(name)));
    for (const auto& feature : json["features"]) sum += feature["properties"]["area"].get<double>();
    return sum;
  };
  CHECK(area_in("a.cells.geojson") == Approx(1));
  CHECK(area_in("b.cells.geojson") == Approx(1));
  CHECK(content(folder.file("a.cells.geojson")) != content(folder.file("b.cells.geojson")));
  // A square of a degree at 60 degrees north is half as wide.
  const std::string north = folder.write(
      "north.geojson",
      R"({"type": "Polygon", "coordinates": [[[10, 59.5], [11, 59.5], [11, 60.5], [10, 60.5], [10, 59.5]]]})");
  REQUIRE(run(north + " --quiet --max-edge 5000 -o " + folder.file("n.cells.geojson")).status == 0);
  const double degree = 6371e3 * 3.14159265358979 / 180;
  CHECK(area_in("n.cells.geojson") == Approx(degree * degree / 2).epsilon(0.003));
  CHECK(contains(content(folder.file("n.cells.geojson")), "[[[10,59.5],"));
  CHECK(run(north + " --quiet -o " + folder.file("n.v.node")).status == 2);
}

TEST_CASE("Triangle's -c, -D and -S are options of the program", "[program]") {
  const Scratch_folder folder;
  const std::string x = folder.file("x"), json = folder.file("x.json");
  const auto report = [&] { return nlohmann::json::parse(content(json)); };
  // Points alone, of which the hull is meshed, with the numbers of the file.
  const std::string points = folder.write("in.node", "5 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 2 1\n");
  CHECK(contains(run(points).err, "--hull"));
  REQUIRE(run(points + " --quiet --hull -o " + x + ".ele --report " + json).status == 0);
  CHECK(report()["input_segments"] == 4);
  CHECK(head(content(x + ".ele"))[0] >= 4);
  CHECK(run(folder.write("in.xy", "0 0\n1 0\n0 1\n") + " --quiet --hull -o " + x + ".off").status == 0);
  // A graph without the border of its hull; with it there are pockets to mesh, and the hole stays.
  const std::string cross =
      folder.write("cross.poly", "6 2 0 0\n0 0 0\n1 6 0\n2 6 6\n3 0 6\n4 2 3\n5 4 3\n2 0\n0 4 5\n1 0 4\n0\n");
  CHECK(run(cross + " --quiet").status == 2);
  CHECK(run(cross + " --quiet --hull").status == 0);
  // A segment that sees vertices under obtuse angles.
  const std::string graph =
      folder.write("graph.poly", "8 2 0 0\n0 0 0\n1 9 0\n2 9 9\n3 0 9\n4 1 4\n5 8 4.2\n6 3 4.5\n7 6 4.6\n"
                                 "5 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 4 5\n0\n");
  REQUIRE(run(graph + " --quiet --report " + json).status == 0);
  const std::size_t before = report()["triangles"];
  REQUIRE(run(graph + " --quiet --conforming --report " + json).status == 0);
  CHECK(report()["triangles"] > before);
  CHECK(report()["encroached_edges"] == 0);
  // A limit, also of 0, is kept, and what is left is reported.
  for (const int most : {0, 1, 3}) {
    const Run r = run(graph + " --max-edge 1 --max-steiner " + std::to_string(most) + " --report " + json);
    CHECK(r.status == 1);
    CHECK(report()["vertices"] == 8 + most);
    CHECK(contains(r.out, "the budget of new vertices is used up; --max-steiner sets another"));
  }
  const Run r = run(graph + " --conforming --max-steiner 0 --report " + json);
  CHECK(r.status == 1);
  CHECK(report()["encroached_edges"] > 0);
  CHECK(contains(r.out, "not Delaunay"));
  for (const char* option :
       {"--max-steiner -1", "--max-steiner 0.5", "--max-steiner x", "--hull --mode acute",
        "--conforming --mode points", "--conforming --project auto"})
    CHECK(run(graph + ' ' + option).status == 2);
}

TEST_CASE("Triangle's -Y and -YY are an option of the program", "[program]") {
  const Scratch_folder folder;
  const std::string x = folder.file("x"), json = folder.file("x.json");
  const std::string graph =
      folder.write("graph.poly", "6 2 0 0\n0 0 0\n1 9 0\n2 9 9\n3 0 9\n4 4 1\n5 4 8\n"
                                 "5 1\n0 0 1 0\n1 1 2 0\n2 2 3 0\n3 3 0 0\n4 4 5 7\n0\n");
  for (const auto& [keep, kept] :
       {std::pair{"none", std::set<int>{}}, std::pair{"boundary", std::set<int>{0, 1, 2, 3}},
        std::pair{"marked", std::set<int>{4}}, std::pair{"all", std::set<int>{0, 1, 2, 3, 4}}}) {
    const Run r = run(graph + " --max-edge 1 --keep-borders " + keep + " -o " + x + ".ele --report " + json);
    CAPTURE(keep, r.out, r.err);
    CHECK(r.status == (kept.empty() ? 0 : 1));
    CHECK(contains(r.out, "--keep-borders") == !kept.empty());
    const auto report = nlohmann::json::parse(content(json));
    if (!kept.empty())
      for (const auto& left : report["left"]) {
        CHECK(left["reason"] == "kept_segment");
        CHECK(kept.count(left["segment"].get<int>()) == 1);
      }
  }
  for (const char* option : {"--keep-borders some", "--keep-borders all --separation theorem-5",
                             "--keep-borders all --project auto", "--keep-borders all --mode points"})
    CHECK(run(graph + ' ' + option).status == 2);
}

TEST_CASE("options of files want a file that they are for", "[program]") {
  const Scratch_folder folder;
  const std::string in = folder.write("in.poly", square) + " -o ";
  for (const auto& [arguments, culprit] :
       {std::pair{in + folder.file("x.off") + " --second-order", "--second-order"},
        std::pair{in + folder.file("x.msh") + " --second-order --pieces 2", "--second-order"},
        std::pair{in + folder.file("x.geojson"), ".cells.geojson"},
        std::pair{in + folder.file("x.wkt"), ".cells.wkt"},
        std::pair{in + folder.file("x.vtu") + " --cells median", "--cells"},
        std::pair{in + folder.file("x.cells.wkt") + " --cells square", "--cells"}}) {
    const Run r = run(arguments);
    CAPTURE(arguments, r.err);
    CHECK(r.status == 2);
    CHECK(contains(r.err, culprit));
  }
  CHECK(run(in + folder.file("x.v.node") + " -o " + folder.file("x.v.edge")).status ==
        2); // one is the other's
}

} // namespace test_triangle_switches

#endif
