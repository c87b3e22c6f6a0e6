// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The command-line program: its outputs, its report and its exit statuses.

#ifdef QUADTREE_MESH_PROGRAM

#include "catch.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_quality_mesh_program {

using namespace program_test;

namespace {

namespace fs = std::filesystem;

} // namespace

TEST_CASE("the program writes each format by its ending", "[program]") {
  const Scratch_folder folder;
  const std::vector<std::string> names{"b.vtu", "c.svg", "d.off", "e.obj",  "f.msh", "g.mesh",
                                       "h.2dm", "i.gr3", "j.14",  "k.html", "a.ele"};
  std::string outputs;
  for (const std::string& name : names) outputs += " -o " + folder.file(name);
  const Run r = run(test_data(is_full_run() ? "us_states_10m.poly.gz" : "syn_holes_400.poly.gz") + outputs);
  CAPTURE(r.out, r.err);
  CHECK(r.status == 0);
  CHECK(r.err.empty());
  for (const char* name : {"a.node", "a.ele", "a.poly", "b.vtu", "c.svg", "d.off", "e.obj", "f.msh", "g.mesh",
                           "h.2dm", "i.gr3", "j.14", "k.html"})
    CHECK(fs::file_size(folder.file(name)) > 1000);
  CHECK(folder.number_of_files() == 13);
  const auto begin_of = [&](const char* name) { return content(folder.file(name)).substr(0, 200); };
  CHECK(contains(begin_of("b.vtu"), "VTKFile"));
  CHECK(contains(begin_of("c.svg"), "<svg"));
  CHECK(begin_of("k.html").rfind("<!DOCTYPE html>\n", 0) == 0);
  CHECK(begin_of("d.off").rfind("OFF\n", 0) == 0);
  CHECK(begin_of("e.obj").rfind("v ", 0) == 0);
  CHECK(begin_of("f.msh").rfind("$MeshFormat\n4.1 0 8\n", 0) == 0);
  CHECK(begin_of("g.mesh").rfind("MeshVersionFormatted 2\n", 0) == 0);
  CHECK(begin_of("h.2dm").rfind("MESH2D\n", 0) == 0);
  for (const char* name : {"i.gr3", "j.14"}) CHECK(begin_of(name).rfind("quadtree_mesh_2\n", 0) == 0);
}

TEST_CASE("the program prints the angles of meshes of any scale", "[program]") {
  const Scratch_folder folder;
  for (const std::string side : {"1e-302", "1e300"}) {
    folder.write("square.poly", "4 2 0 0\n0 0 0\n1 " + side + " 0\n2 " + side + ' ' + side + "\n3 0 " + side +
                                    "\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
    const Run r = run(folder.file("square.poly"));
    CAPTURE(side, r.out, r.err);
    CHECK(r.status == 0);
    CHECK(contains(r.out, "45.00"));
    CHECK(contains(r.out, "90.00"));
  }
}

TEST_CASE("the program reads GeoJSON and WKT", "[program]") {
  const Scratch_folder folder;
  const auto figures = [&](const std::string& arguments) {
    const Run r = run(arguments + " --quiet --report " + folder.file("r.json"));
    CAPTURE(arguments, r.err);
    CHECK(r.status == 0);
    const auto json = nlohmann::json::parse(content(folder.file("r.json")));
    return std::vector<int>{json.at("input_vertices"), json.at("input_segments"), json.at("triangles")};
  };
  const auto from_json = figures(test_data("island.geojson") + " --project none");
  CHECK(from_json == figures(test_data("island.wkt")));
  CHECK(from_json[0] == 30);
  fs::copy(test_data("island.geojson"), folder.file("copy.json"));
  CHECK(from_json == figures(folder.file("copy.json") + " --project none"));

  const std::string outputs = " -o " + folder.file("mesh.ele") + " -o " + folder.file("mesh.svg") + " -o " +
                              folder.file("mesh.vtu") + " -o " + folder.file("mesh.msh");
  const Run r =
      run(test_data("island.geojson") + " --region-property depth --color region --show-quadtree" + outputs);
  CAPTURE(r.err);
  CHECK(r.status == 0);
  CHECK(contains(content(folder.file("mesh.ele")), " -1\n"));
  CHECK(contains(content(folder.file("mesh.msh")), "attribute 2.5\""));
  CHECK(contains(content(folder.file("mesh.vtu")), "quadtree_level"));
  CHECK(contains(content(folder.file("mesh.svg")), ">region</text>"));
  CHECK(contains(content(folder.file("mesh.svg")), "#c51b7d"));
  CHECK(run(test_data("island.wkt") + " --color angle -o " + folder.file("mesh.svg")).status == 0);
  CHECK(contains(content(folder.file("mesh.svg")), ">least angle</text>"));

  folder.write("bad.geojson", "{\"type\": \"Polygon\",\n\"coordinates\": [[[0, 0], [1, 0], [1, 1]]]}");
  const Run bad = run(folder.file("bad.geojson") + " -o " + folder.file("none.ele"));
  CHECK(bad.status == 2);
  CHECK(contains(bad.err, "bad.geojson:2: the geometry, ring 0 is not closed"));
}

TEST_CASE("the program reports in JSON", "[program]") {
  const Scratch_folder folder;
  const std::string kernel = GENERATE("filtered", "fixed", "exact");
  const bool is_large = is_full_run();
  const Run r = run(test_data(is_large ? "us_states_10m.poly.gz" : "syn_holes_400.poly.gz") +
                    " --quiet --compare --kernel " + kernel + " --report " + folder.file("r.json"));
  CAPTURE(r.err, kernel);
  CHECK(r.status == 0);
  CHECK(r.out.empty());
  CHECK(r.err.empty());
  const auto json = nlohmann::json::parse(content(folder.file("r.json")));
  CHECK(json.at("input_vertices") == (is_large ? 11308 : 2404));
  CHECK(json.at("unmet_triangles") == 0);
  CHECK(json.at("threads") >= 1);
  CHECK(json.at("triangles") > json.at("vertices"));
  CHECK(json.at("triangles") < json.at("mesh_2").at("triangles"));
  for (const char* name : {"input_segments", "min_angle", "max_angle", "min_new_angle", "exempt_triangles",
                           "rounds", "peak_memory_mb"})
    CHECK(json.at(name).is_number());
  for (const char* name :
       {"read", "quadtree", "first_mesh", "refine", "coarsen", "convert", "write", "mesh", "total"}) {
    CHECK(json.at("seconds").at(name).is_number());
    CHECK(json.at("wall_seconds").at(name) >= 0);
  }
}

TEST_CASE("the program keeps bounds of edges and areas", "[program]") {
  const Scratch_folder folder;
  const std::string kernel = GENERATE("filtered", "fixed", "exact");
  const std::string input =
      test_data("syn_square.poly") + " --quiet --kernel " + kernel + " --report " + folder.file("r.json");
  const auto triangles = [&] {
    return nlohmann::json::parse(content(folder.file("r.json"))).at("triangles").get<int>();
  };
  CHECK(run(input + " --max-edge 0.1").status == 0);
  CHECK(triangles() > 200); // an equilateral triangle with that edge has area 0.0043
  CHECK(run(input + " --max-area 0.01").status == 0);
  CHECK(triangles() >= 100);
  CHECK(triangles() < 400);
}

TEST_CASE("the program meshes by rules of domain and with the bounds of regions", "[program]") {
  const Scratch_folder folder;
  const std::string kernel = GENERATE("filtered", "fixed", "exact");
  // A square in a square in a square, with a region in the ring between the outer two.
  std::string text = "12 2 0 0\n", segments = "12 1\n";
  for (int i = 0; i < 12; ++i) {
    const int half = 3 - i / 4, x = i % 4 == 0 || i % 4 == 3 ? -half : half, y = i % 4 < 2 ? -half : half;
    text += std::to_string(i) + ' ' + std::to_string(x) + ' ' + std::to_string(y) + '\n';
    segments += std::to_string(i) + ' ' + std::to_string(i) + ' ' +
                std::to_string(i % 4 == 3 ? i - 3 : i + 1) + ' ' + std::to_string(7 + i / 4) + '\n';
  }
  folder.write("in.poly", text + segments + "0\n1\n0 0 2.5 5 0.01\n");
  const auto triangles = [&](const std::string& arguments) {
    const Run r = run(folder.file("in.poly") + " --kernel " + kernel + " --report " + folder.file("r.json") +
                      " -o " + folder.file("out.ele") + ' ' + arguments);
    CAPTURE(arguments, r.out, r.err);
    CHECK(r.status == 0);
    CHECK(r.err.empty());
    return nlohmann::json::parse(content(folder.file("r.json"))).at("triangles").get<int>();
  };
  const int marked = triangles("--domain marked"); // the ring alone, of area 20
  CHECK(marked > 2000);
  CHECK(marked < 5000);
  CHECK(contains(content(folder.file("out.ele")), " 5\n"));  // the region's attribute
  CHECK(contains(content(folder.file("out.node")), " 7\n")); // a segment's marker
  CHECK(triangles("--domain parity") > marked);
  CHECK(triangles("") > triangles("--domain parity"));

  folder.write("sizes", "# near the origin\n0 0 0.002\n\n2 2 0.5 # and a corner\n");
  CHECK(triangles("--size-points " + folder.file("sizes")) > triangles("") + 100);
  folder.write("sizes", "0 0 0.01\n2 2\n");
  CHECK(contains(run(folder.file("in.poly") + " --size-points " + folder.file("sizes")).err, "sizes:2"));

  // Small in the southwest: where one place of the grid is the nearest, or more and more toward it.
  const std::string grid = folder.file("sizes.asc"), by_grid = "--size-grid " + grid;
  folder.write("sizes.asc",
               "ncols 2\nnrows 2\nxllcorner -2\nyllcorner -2\ncellsize 4\nNODATA_value 0\n0 0\n0.1 0\n");
  const int around_one = triangles(by_grid);
  CHECK(around_one > triangles("") + 100);
  CHECK(triangles(by_grid + " --gradation 0.2") > triangles("") + 100);
  CHECK(triangles(by_grid + " --gradation 0.1") > triangles(by_grid + " --gradation 0.2"));
  folder.write("sizes", "2 2 0.01\n");
  CHECK(triangles(by_grid + " --size-points " + folder.file("sizes")) > around_one); // the least of both
  folder.write("sizes.asc", "ncols 2\nnrows 2\nxllcorner -2\nyllcorner -2\ncellsize 4\n1 1\n1 -1\n");
  CHECK(
      contains(run(folder.file("in.poly") + ' ' + by_grid).err, "sizes.asc:7: size 4: '-1' is not above 0"));
}

TEST_CASE("the program keeps a least edge and says what is left for it", "[program]") {
  const Scratch_folder folder;
  const std::string kernel = GENERATE("filtered", "fixed", "exact");
  const Run r = run(test_data("syn_parallel_0.001.poly") + " --kernel " + kernel +
                    " --min-edge 0.05 --report " + folder.file("r.json"));
  CHECK(r.status == 1);
  const auto json = nlohmann::json::parse(content(folder.file("r.json")));
  CHECK(json.at("triangles") < 500); // else thousands
  CHECK(json.at("left").at(0).at("reason") == "min_edge");
}

TEST_CASE("the program prints no angle where there is none", "[program]") {
  const Run r = run(test_data("syn_sliver_1deg.poly")); // one triangle, exempt
  CHECK(contains(r.out, "least angle above the bound              -\n"));
}

TEST_CASE("whole numbers may be written with an exponent", "[program]") {
  const std::string states = test_data("us_states_10m.poly.gz"),
                    points = test_data("points_clusters_1e-12.xy");
  CHECK(contains(run(states + " --max-vertices 1.2e4").out, "--max-vertices"));
  for (const std::string& arguments :
       {states + " --max-vertices 1e6 --smooth 1e0 --threads 1e0", states + " --max-vertices 1e15",
        points + " --mode acute --budget 1e3 --effort 1e0"}) {
    const Run r = run(arguments);
    CAPTURE(arguments, r.err);
    CHECK(r.status == 0);
  }
}

TEST_CASE("the program splits crossings on request", "[program]") {
  const Scratch_folder folder;
  // Two squares that overlap in one.
  const std::string input =
      folder.write("in.wkt", "MULTIPOLYGON(((0 0, 4 0, 4 4, 0 4)), ((2 2, 6 2, 6 6, 2 6)))") + " --report " +
      folder.file("r.json") + " --kernel " + GENERATE("filtered", "fixed", "exact");
  const Run refused = run(input);
  CHECK(refused.status == 2);
  CHECK(contains(refused.err, "use --repair"));
  const Run r = run(input + " --repair");
  CAPTURE(r.out, r.err);
  CHECK(r.status == 0);
  CHECK(contains(r.out, "repaired: crossings: 2, "));
  const auto json = nlohmann::json::parse(content(folder.file("r.json")));
  CHECK(json.at("repair").at("crossings") == 2);
  CHECK(json.at("repair").at("split_segments") == 4);
  CHECK(json.at("input_vertices") == 10);
  CHECK(json.at("unmet_triangles") == 0);
}

TEST_CASE("the program projects what is in degrees and warns of what may be", "[program]") {
  const Scratch_folder folder;
  const auto json = [&](const std::string& file, const std::string& corner) {
    return folder.write(file,
                        R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], )" + corner + ", [0, 0]]]}");
  };
  const std::string degrees = json("degrees.geojson", "[1, 60]"),
                    report = " --report " + folder.file("r.json");
  const auto projection = [&](const std::string& arguments) {
    const Run r = run(arguments + report);
    CAPTURE(arguments, r.out, r.err);
    CHECK(r.status == 0);
    return nlohmann::json::parse(content(folder.file("r.json"))).at("projection");
  };
  CHECK(projection(degrees).at("name") == "lambert");
  CHECK(projection(degrees + " --project mercator").at("name") == "mercator");
  CHECK(projection(degrees + " --project none").is_null());
  CHECK(projection(degrees + " --compare").is_null());
  CHECK(projection(json("meters.geojson", "[1, 91]")).is_null());
  const std::string wkt = folder.write("in.wkt", "POLYGON((8 60, 9 60, 9 61, 8 61, 8 60))");
  CHECK(projection(wkt).is_null());
  CHECK(contains(run(wkt).out, "use --project auto"));
  CHECK_FALSE(contains(run(wkt + " --project none").out, "--project"));
  CHECK_FALSE(contains(run(test_data("island.wkt")).out, "--project"));

  // Sizes are meters, of points and grids, too. The square has some 6e9 square meters.
  const std::string sizes = folder.write("sizes.xy", "8.5 60.5 5000\n");
  const std::string grid =
      folder.write("sizes.asc", "ncols 2\nnrows 2\nxllcorner 7\nyllcorner 59\ncellsize 2\n"
                                "5000 5000\n5000 5000\n");
  for (const std::string& arguments :
       std::vector<std::string>{" --max-edge 5000", " --max-area 1e7", " --kernel fixed --max-edge 5000",
                                " --kernel exact --max-edge 5000", " --size-grid " + std::string(grid)}) {
    CHECK(projection(wkt + " --project auto" + arguments).at("name") == "lambert");
    const auto figures = nlohmann::json::parse(content(folder.file("r.json")));
    CAPTURE(arguments);
    CHECK(figures.at("triangles") > 600);
    CHECK(figures.at("triangles") < 2500);
    CHECK(figures.at("unmet_triangles") == 0);
  }
  CHECK(projection(wkt + " --project auto --size-points " + sizes).at("scale_range").size() == 2);
}

TEST_CASE("the program separates by quadtrees and says what they did", "[program]") {
  const Scratch_folder folder;
  const std::string kernel = GENERATE("filtered", "fixed", "exact");
  const auto report_of = [&](const std::string& arguments) {
    const Run r = run(test_data("syn_wedge_1deg.poly") + " --kernel " + kernel + " --report " +
                      folder.file("r.json") + " -o " + folder.file("out.ele") + ' ' + arguments);
    CAPTURE(arguments, r.out, r.err);
    CHECK(r.status == 0);
    CHECK(contains(r.out, "leaves of T_B*") == contains(arguments, "theorem-5"));
    return nlohmann::json::parse(content(folder.file("r.json")));
  };
  CHECK(report_of("--separation on-demand").at("trees").is_null());

  const auto json = report_of("--separation theorem-5"), trees = json.at("trees");
  const std::string mesh = content(folder.file("out.ele")) + content(folder.file("out.node"));
  CHECK(json.at("unmet_triangles") == 0);
  CHECK(trees.at("leaves_of_points") == 0);   // the triangulation tells distances
  CHECK(trees.at("leaves_of_vertices") >= 1); // of which some may have several vertices
  CHECK(trees.at("leaves_of_pieces") >= trees.at("leaves_of_vertices"));
  CHECK(trees.at("leaves_of_edges") >= trees.at("leaves_of_pieces"));
  CHECK(trees.at("rounds") >= 1);
  CHECK(trees.at("triangles") > json.at("triangles"));
  CHECK(trees.at("missed_by_rule") >= trees.at("missed"));
  CHECK((trees.at("end") == "done" || trees.at("end") == "rounds"));
  CHECK(trees.at("placed") >= trees.at("kept"));
  CHECK(trees.at("has_taken_over") == false);
  CHECK(trees.at("islands") == 0);
  CHECK(trees.at("handed_over") == 0);
  CHECK(trees.at("left_out").is_number());
  for (const char* name : {"trees", "construct"}) CHECK(json.at("seconds").at(name).is_number());

  // However neighbors are found and edges are cut.
  const auto made_with = [&](const std::string& how) {
    const auto report = report_of("--separation theorem-5 " + how).at("trees");
    return std::make_pair(report, content(folder.file("out.ele")) + content(folder.file("out.node")));
  };
  CHECK(made_with("--subdivision centroid-tree --threads 1") == std::make_pair(trees, mesh));
  const auto of_theorem = made_with("--tree-rounds 0");
  CHECK(of_theorem.first.at("leaves_of_points") >= 7);
  CHECK(made_with("--tree-rounds 0 --neighbors quadtree") == of_theorem);
}

TEST_CASE("the program thins out", "[program]") {
  const Scratch_folder folder;
  const auto triangles = [&](const std::string& arguments) {
    const Run r =
        run(test_data("us_states_10m.poly.gz") + " --quiet --report " + folder.file("r.json") + arguments);
    CHECK(r.status == 0);
    return nlohmann::json::parse(content(folder.file("r.json"))).at("triangles").get<int>();
  };
  CHECK(triangles(" --thin 1") < 0.98 * triangles(" --thin 0"));
}

TEST_CASE("points all in one place are meshed", "[program][points]") {
  const std::string mode = GENERATE("points", "bounded", "acute", "warped");
  const std::string kernel = GENERATE("filtered", "fixed", "exact");
  const Run r = run(test_data("one_place_ten_times.xy") + " --mode " + mode + " --kernel " + kernel);
  CAPTURE(mode, kernel, r.out, r.err);
  CHECK(r.status == 0);
}

TEST_CASE("the program compares both separations and Mesh_2", "[program]") {
  const Scratch_folder folder;
  const std::string input = test_data("syn_holes_400.poly.gz");
  const auto report = [&](const std::string& options) {
    const Run r = run(input + " --report " + folder.file("r.json") + options);
    CAPTURE(options, r.err);
    CHECK(r.status == 0);
    return std::pair(nlohmann::json::parse(content(folder.file("r.json"))), r.out);
  };
  const auto on_demand = report("").first, by_quadtrees = report(" --separation theorem-5").first;
  CHECK(on_demand.at("triangles") != by_quadtrees.at("triangles"));
  const auto [both, table] = report(" --compare");
  const auto [other, other_table] = report(" --compare --separation theorem-5");
  const auto check_is = [](const auto& figures, const auto& mesh) {
    for (const char* name : {"vertices", "triangles"}) CHECK(figures.at(name) == mesh.at(name));
    for (const char* name : {"min_angle", "max_angle"})
      CHECK(std::abs(figures.at(name).template get<double>() - mesh.at(name).template get<double>()) < 1e-9);
  };
  check_is(both, on_demand), check_is(both.at("other_separation"), by_quadtrees);
  check_is(other, by_quadtrees), check_is(other.at("other_separation"), on_demand);
  CHECK(both.at("mesh_2").at("triangles") == other.at("mesh_2").at("triangles"));

  std::istringstream lines(table);
  std::vector<std::string> numbers;
  for (std::string line, word; std::getline(lines, line);) {
    if (contains(line, "on demand")) CHECK(line.find("by quadtrees") < line.find("CGAL Mesh_2"));
    if (line.rfind("triangles  ", 0) != 0) continue;
    std::istringstream words(line);
    for (words >> word; words >> word;) numbers.push_back(word);
  }
  const auto count = [](const auto& json) {
    return std::to_string(json.at("triangles").template get<int>());
  };
  CHECK(numbers == std::vector<std::string>{count(on_demand), count(by_quadtrees), count(both.at("mesh_2"))});
  CHECK(other_table.find("by quadtrees") < other_table.find("on demand")); // what is written comes first

  const auto [limited, limited_table] = report(" --compare --min-edge 1e-9");
  CHECK(limited.at("other_separation").is_null());
  CHECK(contains(limited_table, "no mesh by quadtrees: --min-edge has no meaning"));
}

TEST_CASE("help and version", "[program]") {
  CHECK(run("--version").out.rfind("quality_mesh ", 0) == 0);
  const Run all = run("--help-all");
  CHECK(all.status == 0);
  for (const char* option :
       {"--output",      "--min-angle",     "--max-edge",       "--max-area",        "--min-edge",
        "--size-points", "--domain",        "--kernel",         "--smooth",          "--threads",
        "--mode",        "--separation",    "--neighbors",      "--subdivision",     "--placement",
        "--thin",        "--no-coarsening", "--compare",        "--report",          "--quiet",
        "--version",     "--angles",        "--square",         "--effort",          "--budget",
        "--lengths",     "--color",         "--show-quadtree",  "--region-property", "--size-grid",
        "--gradation",   "--project",       "--max-edge-ratio", "--max-angle"})
    CHECK(contains(all.out, option));
}

TEST_CASE("help is a screen of options that there are, and three examples", "[program]") {
  const Run help = run("--help");
  const std::string all = run("--help-all").out;
  CAPTURE(help.out);
  CHECK(help.status == 0);
  CHECK(run("-h").out == help.out);
  std::istringstream lines(help.out);
  std::size_t number = 0, examples = 0;
  for (std::string line; std::getline(lines, line); ++number) {
    CHECK(line.size() <= 88);
    if (line.rfind("  quality_mesh ", 0) == 0) ++examples;
  }
  CHECK(number <= 40);
  CHECK(examples == 3);
  std::size_t options = 0;
  for (std::size_t at = 0; (at = help.out.find("--", at)) != std::string::npos; ++options) {
    const std::size_t end = help.out.find_first_of(" ,\n", at);
    CHECK(contains(all, help.out.substr(at, end - at) + ' '));
    at = end;
  }
  CHECK(options > 15);
  CHECK(!contains(help.out, "--subdivision"));
}

TEST_CASE("examples of the help run", "[program]") {
  const Scratch_folder folder;
  folder.write("lakes.geojson", R"({"type": "Polygon",
    "coordinates": [[[10, 60], [10.02, 60], [10.02, 60.01], [10, 60.01], [10, 60]]]})");
  folder.write("plate.poly", "4 2 0 0\n0 0 0\n1 2 0\n2 2 1\n3 0 1\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
  folder.write("wells.csv", "x,y\n1,1\n2,1\n2,3\n");
  std::istringstream lines(run("--help").out);
  const std::string program = "  quality_mesh ";
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(program, 0) != 0) continue;
    line = line.substr(program.size(), line.find("  ", program.size()) - program.size());
    std::istringstream words(line);
    std::string arguments;
    for (std::string word; words >> word;) { // of files only
      const bool is_file = contains(word, ".") && word.front() != '-';
      arguments += ' ' + (is_file ? folder.file(word) : word);
    }
    const Run r = run(arguments);
    CAPTURE(arguments, r.out, r.err);
    CHECK(r.status == 0);
  }
  for (const char* name : {"lakes.2dm", "plate.msh", "plate.svg", "wells.svg"})
    CHECK(fs::file_size(folder.file(name)) > 300);
}

} // namespace test_quality_mesh_program

#endif // QUADTREE_MESH_PROGRAM
