// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The command-line program in pipes: graphs from standard input, meshes to standard output.

#ifdef QUADTREE_MESH_PROGRAM

#include "catch.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <string>

namespace test_standard_streams {

using namespace program_test;

namespace {

std::string from(const std::string& file) { return " <'" + file + "' "; }

} // namespace

TEST_CASE("standard input is read in each format", "[program]") {
  const Scratch_folder folder;
  const auto has_same_mesh = [&](const std::string& file, const std::string& format, const char* options) {
    const Run by_name = run(test_data(file) + options + " -o " + folder.file("a.off"));
    const Run by_pipe =
        run("-" + from(test_data(file)) + (format.empty() ? format : "--input-format " + format) + options +
            " -o " + folder.file("b.off"));
    CAPTURE(file, by_name.err, by_pipe.err);
    CHECK(by_name.status == 0);
    CHECK(by_pipe.status == 0);
    CHECK(!by_pipe.out.empty());
    CHECK(content(folder.file("a.off")).size() > 40);
    CHECK(content(folder.file("a.off")) == content(folder.file("b.off")));
  };
  has_same_mesh("syn_square.poly", "", "");
  has_same_mesh("syn_holes_400.poly.gz", "poly", ""); // compressed: the content tells
  has_same_mesh("island.geojson", "geojson", "");     // and projected, as GeoJSON is
  has_same_mesh("island.wkt", "wkt", "");
  has_same_mesh("stations.csv", "csv", " --mode acute");
}

TEST_CASE("nothing but the mesh goes to standard output", "[program]") {
  const Scratch_folder folder;
  const std::string input = test_data("island.wkt");
  for (const std::string format : {"off", "obj", "vtu", "svg", "html", "msh", "mesh", "2dm", "gr3", "14"}) {
    const std::string file = folder.file("m." + format);
    CHECK(run(input + " -o " + file).status == 0);
    const Run r = run(input + " -o - --output-format " + format);
    CAPTURE(format, r.err);
    CHECK(r.status == 0);
    CHECK(r.out.size() > 100);
    CHECK(r.out == content(file));
    CHECK(contains(r.err, "least angle")); // what is else on the screen
  }
  const Run quiet = run(input + " --quiet -o - --output-format off -o " + folder.file("m.off") +
                        " --report " + folder.file("r.json"));
  CHECK(quiet.status == 0);
  CHECK(quiet.err.empty());
  CHECK(quiet.out == content(folder.file("m.off")));
  const Run points = run(test_data("stations.csv") + " --mode points -o - --output-format off");
  CHECK(points.out.rfind("OFF\n", 0) == 0);
  CHECK(!contains(points.out, "domain"));
  const Run piped = run("-" + from(test_data("island.geojson")) +
                        "--input-format geojson --project none -o - --output-format off");
  CHECK(piped.out == content(folder.file("m.off")));
}

TEST_CASE("a refused input leaves standard output empty", "[program]") {
  const Scratch_folder folder;
  folder.write("bad.wkt", "POLYGON((0 0, 1 0, 1 1, 0 0))\nPOLYGON((0 0, 1 x))");
  const Run r = run("-" + from(folder.file("bad.wkt")) + "--input-format wkt -o - --output-format off");
  CHECK(r.status == 2);
  CHECK(r.out.empty());
  CHECK(contains(r.err, "standard input:2: "));
  const Run crossing = run("-" + from(folder.write("x.wkt", "LINESTRING(0 0, 2 2, 2 0, 0 2, 0 0)")) +
                           "--input-format wkt -o - --output-format off");
  CHECK(crossing.status == 2);
  CHECK(crossing.out.empty());
  CHECK(contains(crossing.err, "crosses"));
}

TEST_CASE("errors of standard streams", "[program]") {
  const Scratch_folder folder;
  const std::string square = test_data("syn_square.poly");
  const auto error = [](const std::string& arguments) {
    const Run r = run(arguments + " </dev/null");
    CAPTURE(arguments, r.out);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    return r.err;
  };
  CHECK(contains(error(square + " -o -"), "needs a format, such as --output-format off"));
  CHECK(contains(error(square + " --output-format off"), "only, -o -"));
  CHECK(contains(error(square + " --input-format poly"), "only, INPUT -"));
  CHECK(contains(error(square + " -o - --output-format ele"), "--output-format has to be one of vtu, svg"));
  CHECK(contains(error("- --input-format h5"), "--input-format has to be one of poly, geojson"));
  CHECK(contains(error(square + " -o - -o - --output-format off"), "takes one mesh"));
  CHECK(contains(error(square + " -o - --output-format msh --pieces 2"), "--pieces"));
  CHECK(contains(error(square + " -o - --output-format off --memory 1G"), "needs a scratch folder"));
  CHECK(contains(error("-"), "standard input:"));
#ifdef __linux__
  const std::string full = "'" QUADTREE_MESH_PROGRAM "' " + square + " -o - --output-format off 2>'" +
                           folder.file("err") + "' >/dev/full";
  CHECK(std::system(full.c_str()) != 0);
  CHECK(contains(content(folder.file("err")), "standard output: cannot be written: No space left"));
#endif
}

TEST_CASE("a file whose name begins as that of a stream is a file", "[program]") {
  const Scratch_folder folder;
  const std::string command = "cd '" + folder.file("") + "' && cp '" + test_data("island.wkt") +
                              "' ./-.wkt && '" QUADTREE_MESH_PROGRAM "' --quiet -o -.off -- -.wkt";
  CAPTURE(command);
  CHECK(std::system(command.c_str()) == 0);
  CHECK(content(folder.file("-.off")).rfind("OFF\n", 0) == 0);
}

TEST_CASE("the program ends where nobody reads its mesh", "[program]") {
  const std::string command = "bash -c \"'" QUADTREE_MESH_PROGRAM "' '" + test_data("us_states_10m.poly.gz") +
                              "' --quiet -o - --output-format off | head -c 1 >/dev/null; "
                              "exit \\${PIPESTATUS[0]}\"";
  const int status = std::system(command.c_str());
  CAPTURE(command);
  CHECK(WEXITSTATUS(status) == 128 + SIGPIPE);
}

} // namespace test_standard_streams

#endif // QUADTREE_MESH_PROGRAM
