// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The modes of the command-line program for points alone.

#ifdef QUADTREE_MESH_PROGRAM

#include "catch.h"
#include "random_numbers.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/mesh_quality_2.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace test_quality_mesh_points {

using namespace program_test;

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

/// Points of the unit square, a third of them in clusters that get smaller and smaller; the last one is there twice.
std::vector<Point> some_points(std::size_t n) {
  Random_numbers random(17);
  std::vector<Point> points;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double x = random(), y = random();
    const double scale = i % 3 == 0 ? std::pow(0.1, double(i % 7)) : 1;
    points.emplace_back(scale == 1 ? x : 0.5 + scale * x, scale == 1 ? y : 0.5 + scale * y);
  }
  points.push_back(points.front());
  return points;
}

/// Lines of `before each point`, `x` `between` `y`, with all digits.
std::string text_of(const std::vector<Point>& points, const std::string& between) {
  std::ostringstream out;
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (const Point& p : points) out << p.x() << between << p.y() << '\n';
  return out.str();
}

/// `before` x `between` y `after`, with commas between points.
std::string joined(const std::vector<Point>& points, const std::string& between, const std::string& before,
                   const std::string& after) {
  std::string text;
  for (const Point& p : points) {
    const std::string line = text_of({p}, between);
    text += (text.empty() ? "" : ", ") + before + line.substr(0, line.size() - 1) + after;
  }
  return text;
}

std::string node_text_of(const std::vector<Point>& points) {
  std::ostringstream out;
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  out << points.size() << " 2 0 0\n";
  for (std::size_t i = 0; i < points.size(); ++i)
    out << i << ' ' << points[i].x() << ' ' << points[i].y() << '\n';
  return out.str();
}

nlohmann::json json_in(const std::string& file_name) { return nlohmann::json::parse(content(file_name)); }

/// What the checker says of the mesh in `stem.node` and `stem.ele`.
CGAL::Mesh_quality_2 quality_of_files(const std::string& stem, const std::vector<Point>& points) {
  CGAL::Indexed_mesh_2<Point> mesh;
  CGAL::IO::read_triangle_files(stem, mesh);
  mesh.number_of_input_vertices = points.size();
  CGAL::Pslg_2<Point> graph;
  graph.vertices = points;
  using Options = CGAL::Mesh_quality_options_2;
  return CGAL::mesh_quality_2(
      mesh, graph,
      Options().check_domain(Options::Domain::ANY).check_arrays(Options::Arrays::POINTS_AND_TRIANGLES));
}

} // namespace

TEST_CASE("points ulps apart are refused by name where exact meshes cannot be doubles", "[program][points]") {
  const std::string mode = GENERATE("points", "bounded", "acute", "warped");
  const Scratch_folder folder;
  const Run r = run("--mode " + mode + " " + test_data("hard_points_ulps_apart.xy") + " --kernel exact -o " +
                    folder.file("out.ele"));
  CAPTURE(mode, r.out, r.err);
  CHECK(r.status == 2);
  CHECK(contains(r.err, "point"));
  if (mode == "bounded" || mode == "acute") // before they are meshed
    CHECK(contains(r.err, "units in the last place apart"));
  CHECK(folder.number_of_files() == 0);
}

TEST_CASE("clusters of points a few hundred ulps wide are meshed to the bound in doubles or refused by name",
          "[program][points]") {
  const std::string kernel = GENERATE("filtered", "fixed", "exact");
  if (kernel == "exact" && !is_full_run()) return; // which takes as long as all else of this file
  const Scratch_folder folder;
  const std::string effort = kernel == "filtered" || is_full_run() ? "" : " --effort 0";
  const Run r = run("--mode bounded " + test_data("points_clusters_1e-12.xy") + " --kernel " + kernel +
                    effort + " -o " + folder.file("out.ele"));
  CAPTURE(kernel, r.out, r.err);
  CHECK((r.status == 0 || (r.status == 2 && contains(r.err, "point") && folder.number_of_files() == 0)));
}

TEST_CASE("the program meshes points in every mode with every kernel", "[program][points]") {
  struct Case {
    std::string mode;
    double least, largest;
    std::string domain;
  };
  const auto c =
      GENERATE(Case{"points", 20.7, 180, "box"}, Case{"bounded", 36, 80, "row"},
               Case{"bounded --square", 36, 80, "square"}, Case{"bounded --angles 30 85", 30, 85, "row"},
               Case{"acute", 0, 90, "square"}, Case{"warped", 22.47, 112.63, "square"});
  const std::string kernel = GENERATE("filtered", "fixed", "exact");
  const Scratch_folder folder;
  const std::vector<Point> points = some_points(is_full_run() ? 60 : 15);
  const std::string input = folder.write("in.xy", text_of(points, " "));
  const Run r = run("--mode " + c.mode + " " + input + " --kernel " + kernel + " -o " +
                    folder.file("out.ele") + " --report " + folder.file("r.json"));
  CAPTURE(c.mode, kernel, r.out, r.err);
  REQUIRE(r.status == 0);
  CHECK(r.err.empty());

  const CGAL::Mesh_quality_2 quality = quality_of_files(folder.file("out"), points);
  CAPTURE(quality.errors);
  CHECK(quality.is_valid());
  // Over other numbers the bounds hold before the mesh is rounded to doubles.
  const double rounding = kernel == "filtered" ? 1e-13 : 1e-10;
  CHECK(quality.min_angle >= c.least - rounding);
  CHECK(quality.max_angle < c.largest + (c.largest == 90 ? 0 : rounding));

  const auto json = json_in(folder.file("r.json"));
  CHECK(json.at("mode") == c.mode.substr(0, c.mode.find(' ')));
  CHECK(json.at("domain") == c.domain);
  CHECK(json.at("input_points") == points.size());
  CHECK(json.at("merged_points") == 1);
  CHECK(json.at("triangles") == quality.triangles);
  CHECK(json.at("vertices") == quality.vertices);
  CHECK(json.at("triangles_per_point").get<double>() ==
        Approx(double(quality.triangles) / double(points.size() - 1)));
  CHECK(json.at("min_angle").get<double>() == Approx(quality.min_angle));
  CHECK(json.at("max_angle").get<double>() == Approx(quality.max_angle));
  CHECK(json.at("unmet_triangles") == 0);
  for (const char* name : {"clusters", "certified_points", "rounds", "threads", "thin_triangles"})
    CHECK(json.at(name).is_number());
  for (const char* name : {"read", "quadtree", "separate", "coarsen", "convert", "write", "mesh", "total"}) {
    CHECK(json.at("seconds").at(name).is_number());
    CHECK(json.at("wall_seconds").at(name) >= 0);
  }
  CHECK(contains(r.out, "triangles per point"));
  CHECK(contains(r.out, c.domain));
}

TEST_CASE("the program reads points in every format", "[program][points]") {
  const Scratch_folder folder;
  const std::vector<Point> points = some_points(20);
  const std::string report = folder.file("r.json");
  const std::vector<std::string> inputs = {
      folder.write("a.xy", "# points\n\n" + text_of(points, " \t") + "  # the end\n"),
      folder.write("b.csv", text_of(points, ",")),
      folder.write("c.txt", text_of(points, " , ")),
      folder.write("g.csv", "x;y;name\n" + text_of(points, ";")),
      folder.write("d.node", node_text_of(points)),
      folder.write("e.poly", node_text_of(points) + "0 0\n0\n"),
      folder.write("f.poly", "0 2 0 0\n0 0\n0\n"), // the points are in f.node
  };
  folder.write("f.node", node_text_of(points));
  CHECK(run(inputs[0] + " --mode points --quiet --report " + report).status == 0);
  const auto triangles = json_in(report).at("triangles");
  for (const std::string& input : inputs) {
    const Run r = run(input + " --mode points --quiet --report " + report);
    CAPTURE(input, r.err);
    CHECK(r.status == 0);
    CHECK(r.out.empty());
    CHECK(json_in(report).at("triangles") == triangles);
  }
}

TEST_CASE("the program reads points of GeoJSON and WKT", "[program][points]") {
  const Scratch_folder folder;
  std::vector<Point> points = some_points(20);
  points.pop_back(); // vertices of graphs are merged as they are read
  const std::string output = " --mode points -o " + folder.file("mesh.node");
  CHECK(run(folder.write("a.xy", text_of(points, " ")) + output).status == 0);
  const std::string mesh = content(folder.file("mesh.node"));
  CHECK(run(folder.write("b.wkt", "MULTIPOINT(" + joined(points, " ", "", "") + ")") + output).status == 0);
  CHECK(content(folder.file("mesh.node")) == mesh);
  const std::string places = joined(points, ", ", "[", "]");
  CHECK(run(folder.write("c.geojson", R"({"type": "MultiPoint", "coordinates": [)" + places + "]}") + output)
            .status == 0);
  CHECK(content(folder.file("mesh.node")) == mesh);
}

TEST_CASE("the program writes meshes of points in each format", "[program][points]") {
  const std::string mode = GENERATE("points", "bounded", "acute", "warped");
  CAPTURE(mode);
  const Scratch_folder folder;
  const std::string input = folder.write("in.txt", text_of(some_points(30), " "));
  const Run r = run(input + " --mode " + mode + " -o " + folder.file("a.ele") + " -o " +
                    folder.file("b.vtu") + " -o " + folder.file("c.svg") + " -o " + folder.file("d.html"));
  CAPTURE(r.out, r.err);
  CHECK(r.status == 0);
  CHECK(folder.number_of_files() == 7);
  CHECK(content(folder.file("a.poly")) == "0 2 0 1\n0 0\n0\n"); // no segments
  CHECK(contains(content(folder.file("b.vtu")).substr(0, 200), "VTKFile"));
  CHECK(contains(content(folder.file("c.svg")), " angle</text>"));
  const std::string color = mode == "acute" ? "largest_angle" : "least_angle";
  CHECK(contains(content(folder.file("d.html")), "\"color\":\"" + color + '"'));
}

TEST_CASE("the program tells lengths, and what Mesh_2 makes of points", "[program][points]") {
  const Scratch_folder folder;
  const std::string input = folder.write("in.xy", text_of(some_points(50), " "));
  const Run r = run(input + " --mode points --lengths --compare --report " + folder.file("r.json"));
  CAPTURE(r.out, r.err);
  CHECK(r.status == 0);
  CHECK(contains(r.out, "spanning tree"));
  CHECK(contains(r.out, "CGAL Mesh_2"));
  const auto json = json_in(folder.file("r.json"));
  CHECK(json.at("mesh_2").at("min_angle").get<double>() > 20.69);
  CHECK(json.at("triangles") < json.at("mesh_2").at("triangles"));
  const auto& lengths = json.at("lengths");
  CHECK(lengths.at("mesh") > lengths.at("delaunay"));
  CHECK(lengths.at("delaunay") > lengths.at("least"));
  CHECK(lengths.at("least") >= lengths.at("hull"));
  CHECK(lengths.at("ratio").get<double>() > 1);

  const Run one =
      run(folder.write("one.xy", "3 4\n") + " --mode acute --lengths --report " + folder.file("r.json"));
  CHECK(one.status == 0);
  CHECK(json_in(folder.file("r.json")).at("lengths").at("ratio").is_null());
}

TEST_CASE("efforts, budgets and threads", "[program][points]") {
  const Scratch_folder folder;
  const std::string input = folder.write("in.xy", text_of(some_points(100), " ")) +
                            " --mode acute --quiet -o " + folder.file("out.ele") + " --report " +
                            folder.file("r.json") + ' ';
  const auto triangles = [&](const std::string& arguments) {
    const Run r = run(input + arguments);
    CAPTURE(arguments, r.err);
    CHECK(r.status == 0);
    return json_in(folder.file("r.json")).at("triangles").get<int>();
  };
  const int not_coarsened = triangles("--effort 0"), coarsened = triangles("--threads 1");
  const std::string mesh = content(folder.file("out.ele")) + content(folder.file("out.node"));
  CHECK(coarsened < not_coarsened / 2);
  CHECK(triangles("--budget 20") > coarsened);
  CHECK(triangles("--threads 3") == coarsened);
  CHECK(content(folder.file("out.ele")) + content(folder.file("out.node")) == mesh);
}

TEST_CASE("bad usage of the modes for points names the option", "[program][points]") {
  const Scratch_folder folder;
  const std::string points = folder.write("in.xy", "0 0\n1 0\n0 1\n");
  const std::string graph = test_data("syn_square.poly");
  struct Case {
    std::string arguments, culprit;
  };
  std::vector<Case> cases = {{points, "--mode"},
                             {folder.write("in.node", node_text_of(some_points(3))), "--mode"},
                             {points + " --mode squares", "squares"},
                             {points + " --mode points --min-angle 25", "--min-angle"},
                             {points + " --mode bounded --angles 36", "--angles"},
                             {points + " --mode bounded --angles 38 80", "--angles"},
                             {points + " --mode bounded --angles 36 78", "--angles"},
                             {points + " --mode bounded --angles 36 90", "--angles"},
                             {points + " --mode bounded --angles nan 80", "--angles"},
                             {points + " --mode acute --effort 4", "--effort"},
                             {points + " --mode acute --effort -1", "--effort"},
                             {points + " --mode acute --budget 0", "--budget"},
                             {points + " --mode acute --budget -5", "--budget"},
                             {points + " --mode bounded --separation theorem-5", "--separation"},
                             {graph + " --mode acute", "--mode pslg"},
                             {folder.file("missing.xy") + " --mode acute", "missing.xy"},
                             {folder.write("in.dat", "0 0\n") + " --mode acute", "in.dat"}};
  for (const char* option :
       {"--max-edge 1", "--max-area 1", "--min-edge 1", "--size-points x", "--size-grid x", "--domain marked",
        "--smooth 1", "--no-coarsening", "--separation on-demand", "--thin 1"})
    for (const char* mode : {"points", "bounded", "acute", "warped"})
      cases.push_back({points + " --mode " + mode + ' ' + option, std::string(option).substr(0, 5)});
  for (const char* option : {"--min-angle 20", "--compare", "--square"})
    for (const char* mode : {"acute", "warped"})
      cases.push_back({points + " --mode " + mode + ' ' + option, std::string(option).substr(0, 5)});
  for (const char* option : {"--angles 36 80", "--square", "--effort 1", "--budget 9", "--lengths"})
    cases.push_back({graph + ' ' + option, std::string(option).substr(0, 5)});
  for (const char* options :
       {"warped --effort 1", "warped --budget 9", "points --budget 9", "acute --angles 36 80"})
    cases.push_back(
        {points + " --mode " + options, std::string(options).substr(std::string(options).find("--"), 5)});
  const std::size_t files = folder.number_of_files();
  for (const Case& c : cases) {
    const Run r = run(c.arguments + " -o " + folder.file("mesh.ele"));
    CAPTURE(c.arguments, r.err);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    CHECK(contains(r.err, c.culprit));
    CHECK(folder.number_of_files() == files);
  }
}

TEST_CASE("bad points name their line", "[program][points]") {
  const Scratch_folder folder;
  struct Case {
    std::string text, culprit;
  };
  const std::vector<Case> cases = {{"", "no points"},
                                   {"# nothing\n\n", "no points"},
                                   {"1 2\n# more\n3 x\n", "in.csv:3: y: 'x'"},
                                   {"1 2\n3\n", "in.csv:2"},
                                   {"1,,2\n", "in.csv:1"},
                                   {",1 2\n", "in.csv:1"},
                                   {"1 2,\n", "in.csv:1"},
                                   {"x,y\n1;2\n3,x\n", "in.csv:3: y: 'x'"},
                                   {"1,5;2,5\n", "in.csv:1: "},
                                   {"1 2\n1 nan\n", "in.csv:2: y: 'nan' is not finite"},
                                   {"1 2\ninf 1\n", "in.csv:2: x"},
                                   {"1e999 2\n", "in.csv:1: x"}};
  for (const Case& c : cases) {
    const Run r = run(folder.write("in.csv", c.text) + " --mode points -o " + folder.file("mesh.ele"));
    CAPTURE(c.text, r.err);
    CHECK(r.status == 2);
    CHECK(contains(r.err, c.culprit));
    CHECK(folder.number_of_files() == 1);
  }
  const Run r = run(folder.write("none.node", "0 2 0 0\n") + " --mode points");
  CHECK(r.status == 2);
  CHECK(contains(r.err, "no points"));
}

TEST_CASE("points whose mesh leaves the numbers there are, are refused by name", "[program][points]") {
  const std::string mode = GENERATE("points", "bounded", "acute", "warped");
  const std::string kernel = GENERATE("filtered", "fixed", "exact");
  const Scratch_folder folder;
  const Run r = run(test_data("points_at_1e308.xy") + " --mode " + mode + " --kernel " + kernel + " -o " +
                    folder.file("out.ele"));
  CAPTURE(mode, kernel, r.err);
  CHECK(r.status == 2);
  CHECK(contains(r.err, "point 1 (1e+308, 1e+308)"));
  CHECK(contains(r.err, "scale or move the input"));
  CHECK(folder.number_of_files() == 0);
}

TEST_CASE("words have room for a row along the diagonal of a square", "[program][points]") {
  const Scratch_folder folder;
  const Run r =
      run(folder.write("in.xy", "0 0\n1 0\n1 1\n0 1\n0.5 0.5\n") + " --mode bounded --kernel fixed");
  CAPTURE(r.err);
  CHECK(r.status == 0);
}

TEST_CASE("points that words cannot tell are refused", "[program][points]") {
  const Scratch_folder folder;
  const Run r = run(folder.write("in.xy", "0 0\n1e-30 0\n1 1\n") + " --mode acute --kernel fixed");
  CHECK(r.status == 2);
  CHECK(contains(r.err, "points 0 (0, 0) and 1 (1e-30, 0)"));
  CHECK(contains(r.err, "--kernel exact"));
}

TEST_CASE("one point, at the origin or far from it, is meshed in every mode by every kernel",
          "[program][points]") {
  const std::string place = GENERATE("0 0\n", "0.1 -7\n", "1e9 3\n");
  const std::string mode = GENERATE("points", "bounded", "acute", "warped");
  const std::string kernel = GENERATE("filtered", "fixed", "exact");
  const Scratch_folder folder;
  const Run r = run(folder.write("in.xy", place) + " --mode " + mode + " --kernel " + kernel);
  CAPTURE(place, mode, kernel, r.err);
  CHECK(r.status == 0);
}

} // namespace test_quality_mesh_points

#endif // QUADTREE_MESH_PROGRAM
