// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The command-line program with files of large meshes: numbered by place, in pieces and parts, in HDF5.

#ifdef QUADTREE_MESH_PROGRAM

#include "catch.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Triangle_files.h>
#ifdef CGAL_LINKED_WITH_HDF5
#include <CGAL/IO/HDF5.h>
#endif

#include <sys/stat.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_files_of_large_meshes {

using namespace program_test;

namespace {

namespace fs = std::filesystem;
using Pslg = CGAL::Pslg_2<CGAL::Exact_predicates_inexact_constructions_kernel::Point_2>;

std::string quoted(const std::string& name) { return "'" + name + "'"; }

const std::string lakes = quoted(QUADTREE_MESH_SOURCE_DIR "/examples/data/great_lakes.poly.gz");
const std::string norway = quoted(QUADTREE_MESH_TEST_DATA_DIR "/gshhg_norway_f.poly.gz");
const std::string aegean = quoted(QUADTREE_MESH_TEST_DATA_DIR "/gshhg_aegean_h.poly.gz"); // of two blocks

/// All that there is in a format for large meshes.
std::vector<std::string> outputs() {
  std::vector<std::string> endings{"ele", "vtu", "pvtu", "msh"};
#ifdef CGAL_LINKED_WITH_HDF5
  endings.push_back("vtkhdf"), endings.push_back("xdmf");
#endif
  return endings;
}

std::string output_options(const Scratch_folder& folder, const std::string& stem) {
  std::string options;
  for (const std::string& ending : outputs()) options += " -o " + quoted(folder.file(stem + '.' + ending));
  return options;
}

/// What is in the files of one stem, by the rest of their names. Names of other files in them are the same, too.
std::map<std::string, std::string> contents(const Scratch_folder& folder, const std::string& stem) {
  std::map<std::string, std::string> result;
  for (const auto& entry : fs::directory_iterator(folder.file(""))) {
    const std::string name = entry.path().filename().string();
    if (name.rfind(stem, 0) != 0) continue;
    std::string text = content(entry.path().string());
    if (name.find(".pvtu") != std::string::npos || name.find(".xdmf") != std::string::npos)
      for (std::size_t at; (at = text.find(stem)) != std::string::npos;)
        text.replace(at, stem.size(), "STEM");
    result[name.substr(stem.size())] = std::move(text);
  }
  return result;
}

} // namespace

TEST_CASE("renumbered files have the same bytes, whatever the run", "[program][renumber][scratch]") {
  const Scratch_folder folder;
  const std::string options = (is_full_run() ? norway : aegean) + " --quiet --renumber --pieces 3";
  REQUIRE(run(options + output_options(folder, "first")).status == 0);
  const auto expected = contents(folder, "first");
  CHECK(expected.count("_3.vtu") == 1);
  CHECK(expected.count("_3.msh") == 1);
  CHECK(expected.count(".msh") == 0);
  std::string way = " --threads 1";
#ifdef __linux__
  way += " --memory 100M";
#endif
  REQUIRE(run(options + way + output_options(folder, "other")).status == 0);
  const auto found = contents(folder, "other");
  REQUIRE(found.size() == expected.size());
  for (const auto& [name, text] : expected) {
    CAPTURE(name);
    CHECK((found.count(name) == 1 && found.at(name) == text));
  }
}

TEST_CASE("renumbered .node files have the numbers of the input", "[program][renumber]") {
  const Scratch_folder folder;
  for (const char* const mode : {"pslg", "points"}) {
    const std::string input = mode == std::string("pslg")
                                  ? folder.write("in.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n"
                                                            "4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n")
                                  : folder.write("in.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n");
    REQUIRE(
        run(input + " --quiet --renumber --mode " + mode + " -o " + quoted(folder.file("out.ele"))).status ==
        0);
    Pslg in, out;
    CGAL::IO::read_triangle_node(folder.write("vertices.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n"), in);
    CGAL::IO::read_triangle_node(folder.file("out.node"), out);
    REQUIRE(out.number_of_vertex_attributes == 1);
    CHECK(out.first_number == 1);
    std::set<double> numbers;
    for (std::size_t v = 0; v < out.vertices.size(); ++v) {
      const double number = out.vertex_attributes[v];
      if (number == -1) continue;
      CHECK(numbers.insert(number).second);
      CHECK(out.vertices[v] == in.vertices[std::size_t(number) - 1]);
    }
    CHECK(numbers == std::set<double>{1, 2, 3, 4});
  }
}

TEST_CASE("pieces are where they destroy nothing", "[program]") {
  const Scratch_folder folder;
  const std::string mesh = quoted(folder.file("mesh.pvtu"));
  const auto error = [&](const std::string& options) {
    const Run r = run(lakes + " --quiet " + options);
    CHECK(r.status == 2);
    CHECK(folder.number_of_files() == 0);
    return r.err;
  };
  CHECK(
      contains(error("-o " + mesh + " -o " + quoted(folder.file("mesh_07.vtu"))), "would overwrite output"));
  CHECK(contains(
      error("--pieces 2 -o " + quoted(folder.file("a.msh")) + " -o " + quoted(folder.file("a_1.msh"))),
      "would overwrite output"));
  CHECK(contains(error("--pieces 2 -o " + quoted(folder.file("a.vtu"))),
                 "--pieces needs an output .pvtu or .msh"));
  for (const char* const bad : {"0", "-1", "1.5", "1e9", "nan"})
    CHECK(contains(error("-o " + mesh + " --pieces " + bad), "--pieces has to be a whole number"));
  REQUIRE(run(lakes + " --quiet -o " + mesh + " -o " + quoted(folder.file("mesh_a.vtu")) + " -o " +
              quoted(folder.file("mesh_1.msh")))
              .status == 0);
  CHECK(folder.number_of_files() == 4);
}

TEST_CASE("pieces that cannot be written leave the older ones", "[program]") {
  const Scratch_folder folder;
  folder.write("mesh_1.vtu", "old");
  fs::create_directory(folder.file("mesh_2.vtu"));
  const Run r = run(lakes + " --quiet --pieces 2 -o " + quoted(folder.file("mesh.pvtu")));
  CHECK(r.status == 2);
  CHECK(contains(r.err, "mesh_2.vtu: cannot be written"));
  CHECK(content(folder.file("mesh_1.vtu")) == "old");
  CHECK(folder.number_of_files() == 2);
}

#ifdef CGAL_LINKED_WITH_HDF5
TEST_CASE("a graph in HDF5 gives the mesh of the same graph in text", "[program][HDF5]") {
  const Scratch_folder folder;
  Pslg pslg;
  CGAL::IO::read_triangle_poly(QUADTREE_MESH_SOURCE_DIR "/examples/data/great_lakes.poly.gz", pslg);
  pslg.first_number = 0;
  CGAL::IO::write_triangle_poly(folder.file("in.poly"), pslg);
  CGAL::IO::write_HDF5(folder.file("in.h5"), pslg);
  for (const char* const kernel : {"filtered", "fixed"}) {
    for (const char* const input : {"in.poly", "in.h5"})
      REQUIRE(run(quoted(folder.file(input)) + " --quiet --kernel " + kernel + " -o " +
                  quoted(folder.file(std::string("of_") + input + ".ele")))
                  .status == 0);
    for (const char* const ending : {".node", ".ele", ".poly"})
      CHECK(content(folder.file(std::string("of_in.poly") + ending)) ==
            content(folder.file(std::string("of_in.h5") + ending)));
  }
  CHECK(contains(run(quoted(folder.file("in.h5")) + " --mode points").err, "has segments"));
  pslg.segments.clear(), pslg.segment_markers.clear(), pslg.holes.clear();
  CGAL::IO::write_HDF5(folder.file("in.h5"), pslg);
  CHECK(run(quoted(folder.file("in.h5")) + " --quiet --mode points").status == 0);
}

TEST_CASE("files of HDF5 are refused where they cannot be", "[program][HDF5]") {
  const Scratch_folder folder;
  CGAL::IO::write_HDF5(folder.file("mesh.h5"), Pslg());
  const auto error = [&](const std::string& arguments) {
    const Run r = run(arguments);
    CHECK(r.status == 2);
    return r.err;
  };
  const std::string h5 = quoted(folder.file("mesh.h5"));
  CHECK(contains(error(h5 + " -o " + quoted(folder.file("mesh.xdmf"))), "would overwrite the input"));
  CHECK(contains(error(lakes + " -o " + h5 + " -o " + quoted(folder.file("mesh.xdmf"))), "would overwrite"));
  CHECK(contains(error(quoted(folder.file("none.h5"))), "none.h5: No such file"));
  CHECK(contains(error(quoted(folder.write("text.h5", "no"))), "text.h5: is no file of HDF5"));
  REQUIRE(mkfifo(folder.file("pipe.vtkhdf").c_str(), 0600) == 0);
  CHECK(contains(error(lakes + " -o " + quoted(folder.file("pipe.vtkhdf"))), "HDF5 needs a regular file"));
  CHECK(contains(error(lakes + " -o /dev/full.vtkhdf --report " + folder.file("x")), "/dev"));
}

TEST_CASE("a full disk leaves no halves of files of HDF5", "[program][HDF5]") {
  const Scratch_folder folder;
  for (const char* const name : {"mesh.vtkhdf", "mesh.h5"}) {
    folder.write("mesh.vtkhdf", "old"), folder.write("mesh.h5", "older");
    // A file may have 300 blocks of 512 or 1024 bytes, and the mesh needs more.
    const std::string command = "ulimit -f 300; '" QUADTREE_MESH_PROGRAM "' " + lakes + " --quiet -o " +
                                quoted(folder.file(name)) + " 2>" + quoted(folder.file("err"));
    CHECK(std::system(command.c_str()) != 0);
    CHECK(contains(content(folder.file("err")), std::string(name) + ": cannot be written: File too large"));
    CHECK(content(folder.file("mesh.vtkhdf")) == "old");
    CHECK(content(folder.file("mesh.h5")) == "older");
    CHECK(folder.number_of_files() == 3);
  }
}
#else
TEST_CASE("without HDF5 its files are refused by name", "[program][HDF5]") {
  for (const char* const arguments : {"x.h5", "x.poly -o x.vtkhdf", "x.poly -o x.xdmf"})
    CHECK(contains(run(arguments).err, "is a file of HDF5, without which this program was built"));
}
#endif

} // namespace test_files_of_large_meshes

#endif // QUADTREE_MESH_PROGRAM
