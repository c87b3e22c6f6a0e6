// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The command-line program: what it refuses, and how it says so.

#ifdef QUADTREE_MESH_PROGRAM

#include "catch.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <filesystem>
#include <string>
#include <vector>

namespace test_quality_mesh_errors {

using namespace program_test;

namespace {

namespace fs = std::filesystem;

} // namespace

TEST_CASE("the program refuses holes on segments with the numbers of the input", "[program]") {
  const std::string kernel = GENERATE("filtered", "fixed", "exact");
  const Run on_segment = run(test_data("hole_on_segment.poly") + " --kernel " + kernel);
  CAPTURE(kernel, on_segment.err);
  CHECK(on_segment.status == 2);
  CHECK(contains(on_segment.err,
                 "the point of hole 0 (4, 0.5) lies on segment 4 from vertex 4 (6, 1) to vertex 5 (2, 0)"));
  const Run on_vertex = run(test_data("hole_on_vertex.poly") + " --kernel " + kernel);
  CAPTURE(on_vertex.err);
  CHECK(on_vertex.status == 2);
  CHECK(contains(on_vertex.err, "the point of hole 0 (4, 3) lies on vertex 0 (4, 3)"));
}

TEST_CASE("bad usage names the culprit and writes nothing", "[program]") {
  const Scratch_folder folder;
  const Scratch_folder inputs;
  const std::string square = test_data("syn_square.poly");
  struct Case {
    std::string arguments, culprit;
  };
  const std::vector<Case> cases = {
      {"", "no input"},
      {square + " " + square, "one input"},
      {square + " -o x.xyz", "x.xyz"},
      {square + " -o " + folder.file("none/x.ele"), "none"},
      {square + " --min-angle 35", "--min-angle"},
      {square + " --min-angle nan", "--min-angle"},
      {square + " --min-angle two", "two"},
      {square + " --max-edge 0", "--max-edge"},
      {square + " --max-area -1", "--max-area"},
      {square + " --min-edge 0", "--min-edge"},
      {square + " --domain all", "all"},
      {square + " --size-points " + folder.file("none"), "none"},
      {square + " --threads 0", "--threads"},
      {square + " --threads 1.5", "--threads has to be a whole number from 1 to "},
      {square + " --max-vertices 2.5", "--max-vertices has to be a whole number"},
      {square + " --max-vertices 0", "--max-vertices has to be a whole number from 1 to 2^53"},
      {square + " --max-vertices inf", "--max-vertices has to be a whole number"},
      {square + " --max-edge 0,1", "'0,1') for option '--max-edge' is invalid: it has to be a number"},
      {square + " --smooth -1", "--smooth"},
      {square + " --thin -1", "--thin"},
      {square + " --thin 1 --no-coarsening", "--no-coarsening"},
      {square + " --separation theorem-6", "theorem-6"},
      {square + " --neighbors quadtree", "--neighbors"},
      {square + " --subdivision walking", "--subdivision"},
      {square + " --placement by-rule", "--placement"},
      {square + " --separation theorem-5 --placement at-random", "at-random"},
      {square + " --separation theorem-5 --neighbors kd-tree", "kd-tree"},
      {square + " --separation theorem-5 --subdivision never", "never"},
      {square + " --separation theorem-5 --min-edge 1", "--min-edge"},
      {square + " --kernel round", "round"},
      {square + " --mode square", "square"},
      {square + " --color red", "red"},
      {square + " --color angle", "--color needs an output .svg or .html"},
      {square + " --color size -o " + folder.file("a.svg"), "--color size has a meaning for .html only"},
      {square + " --msh-version 2.2", "--msh-version needs an output .msh"},
      {square + " --msh-version 3 -o " + folder.file("a.msh"), "--msh-version"},
      {square + " --msh-version 2.2 --pieces 2 -o " + folder.file("a.msh"),
       "--pieces writes .msh in version 4.1 only"},
      {square + " --show-quadtree",
       "--show-quadtree needs an output .svg, .html, .vtu, .pvtu, .vtkhdf or .xdmf"},
      {square + " --region-property depth", "--region-property"},
      {test_data("island.geojson") + " --region-property height", "height"},
      {square + " --project utm", "--project"},
      {square + " --project auto --compare", "--compare"},
      {square + " --project auto --min-angle 0", "--min-angle"},
      {inputs.write("pole.wkt", "POLYGON((0 0, 1 0, 0 90, 0 0))") + " --project auto", "vertex 2"},
      {inputs.write("wide.wkt", "POLYGON((179 0, -179 0, -179 1, 179 0))") + " --project auto",
       "antimeridian"},
      {test_data("README.md"), "README.md"},
      {square + " --no-such-option", "unrecognized option '--no-such-option'"},
      {folder.file("missing.poly"), "missing.poly"}};
  for (const Case& c : cases) {
    const Run r = run(c.arguments + " -o " + folder.file("mesh.ele"));
    CAPTURE(c.arguments, r.err);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    CHECK(contains(r.err, c.culprit));
    CHECK(folder.number_of_files() == 0);
  }
}

TEST_CASE("bad input names the place and writes nothing", "[program]") {
  const std::string kernel = GENERATE("filtered", "fixed", "exact");
  CAPTURE(kernel);
  const Scratch_folder folder;
  struct Case {
    std::string text, culprit;
  };
  // Four corners of a square, then what goes wrong.
  const std::string corners = "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n";
  const std::vector<Case> cases = {
      {"", "in.poly"},
      {"4 2 0 0\n0 0 0\n1 1 0\n", "in.poly"},
      {"3 2 0 0\n0 0 0\n1 nan 0\n2 0 1\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n", "vertex 1"},
      {"3 2 0 0\n0 0 0\n1 1 inf\n2 0 1\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n", "vertex 1"},
      {corners + "1 0\n0 0 7\n0\n", "segment 0"},
      {corners + "2 0\n0 0 2\n1 1 3\n0\n", "segment"},
      {"4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n2 0\n1 1 3\n2 2 4\n0\n", "segment 2 from vertex 2 (1, 0)"},
      {corners + "1 0\n0 0 1\n0\n", ""},
      {"3 2 0 0\n0 0 0\n1 1 1\n2 2 2\n2 0\n0 0 1\n1 1 2\n0\n", ""},
      {"1 2 0 0\n0 0 0\n0 0\n0\n", ""}};
  for (const Case& c : cases) {
    folder.write("in.poly", c.text);
    const Run r = run(folder.file("in.poly") + " --kernel " + kernel + " -o " + folder.file("mesh.ele"));
    CAPTURE(c.text, r.err);
    CHECK(r.status == 2);
    CHECK(contains(r.err, c.culprit));
    CHECK(r.err.size() > 20);
    CHECK(folder.number_of_files() == 1);
  }
}

TEST_CASE("messages about graphs say what the user can do", "[program]") {
  const Scratch_folder folder;
  struct Case {
    std::string text, arguments, advice;
  };
  const std::string box = "0 -9 -9\n1 9 -9\n2 9 9\n3 -9 9\n", sides = "0 0 1\n1 1 2\n2 2 3\n3 3 0\n",
                    corners = "4 2 0 0\n" + box, square = corners + "4 0\n" + sides + "0\n";
  const std::string parallels =
      "8 2 0 0\n" + box + "4 -1 0\n5 1 0\n6 -1 1e-9\n7 1 1e-9\n6 0\n" + sides + "4 4 5\n5 6 7\n0\n";
  const std::string pair = "6 2 0 0\n" + box + "4 0 0\n5 0 1e-300\n4 0\n" + sides + "0\n";
  const std::string open = corners + "3 0\n0 0 1\n1 1 2\n2 2 3\n0\n";
  const std::vector<Case> cases = {
      {corners + "0 0\n0\n", "", "use --mode points"},
      {open, "--kernel fixed", "vertex 0 (-9, -9) is an end of one segment only"},
      {open, "",
       "vertex 0 (-9, -9) is an end of one segment only, the nearest other such end is vertex 3 (-9, 9); "
       "close the "
       "border"},
      {square, "--domain marked", "--domain enclosed"},
      {corners + "2 0\n0 0 2\n1 1 3\n0\n", "", "give both a vertex where they cross"},
      {square, "--max-area 1e-300", "for the bounds of size; raise these"},
      {parallels, "", "pass over it by --min-edge"},
      {parallels, "--max-vertices 1000", "--max-vertices"},
      {parallels, "--separation theorem-5", "widen or remove what is so narrow"},
      {pair, "--kernel fixed", "merge what is so near, or use --kernel exact"},
      {pair, "--separation theorem-5", "or use --kernel exact with --separation on-demand"},
      {"3 2 0 0\n0 0 0\n1 1e308 0\n2 0 1e308\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n", "", "or use --kernel exact"}};
  for (const Case& c : cases) {
    const Run r = run(folder.write("in.poly", c.text) + ' ' + c.arguments);
    CAPTURE(c.text, c.arguments, r.err);
    CHECK(r.status == 2);
    CHECK(contains(r.err, c.advice));
  }
}

TEST_CASE("exact meshes whose angles doubles would spoil are refused, with what is too near", "[program]") {
  const std::string separation = GENERATE("on-demand", "theorem-5");
  for (const std::string name :
       {"hard_exact_rounding.poly", "hard_cgal781_tiny_edge.poly", "hard_near_pair_2e-40.poly"}) {
    CAPTURE(name, separation);
    const Scratch_folder folder;
    const Run r = run(test_data(name) + " --kernel exact --separation " + separation + " -o " +
                      folder.file("mesh.ele"));
    CAPTURE(r.err);
    CHECK((name == "hard_near_pair_2e-40.poly" ? r.status == 0 : r.status == 2));
    if (r.status == 0) continue;
    CHECK(contains(r.err, "vertex "));
    CHECK(contains(r.err, "merge what is so near"));
    CHECK(folder.number_of_files() == 0);
  }
}

TEST_CASE("an output may not overwrite the input", "[program]") {
  const Scratch_folder folder;
  fs::copy(test_data("syn_square.poly"), folder.file("in.poly"));
  const Run r = run(folder.file("in.poly") + " -o " + folder.file("in.ele"));
  CHECK(r.status == 2);
  CHECK(contains(r.err, "overwrite"));
  CHECK(content(folder.file("in.poly")) == content(test_data("syn_square.poly")));
}

TEST_CASE("outputs with a file in common are refused by what the user wrote", "[program]") {
  const Scratch_folder folder;
  const Run r =
      run(test_data("syn_square.poly") + " -o " + folder.file("a.ele") + " -o " + folder.file("a.node"));
  CAPTURE(r.err);
  CHECK(r.status == 2);
  CHECK(contains(r.err, "of output '" + folder.file("a.ele") + "'"));
  CHECK(contains(r.err, "output '" + folder.file("a.node") + "'"));
}

TEST_CASE("a run that is out of vertices says why and which option sets how many", "[program]") {
  const Run r = run(test_data("us_states_10m.poly.gz") + " --max-vertices 12000");
  CAPTURE(r.out, r.err);
  CHECK(r.status == 1);
  CHECK(contains(r.out, "unmet: reason for "));
  CHECK(contains(r.out, "--max-vertices"));
}

} // namespace test_quality_mesh_errors

#endif // QUADTREE_MESH_PROGRAM
