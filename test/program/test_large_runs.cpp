// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The command-line program with little memory, and interrupted: the same files, and clear errors.

#ifdef QUADTREE_MESH_PROGRAM
#ifdef __linux__

#include "catch.h"
#include "pslg_inputs.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Folder_lock.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace test_large_runs {

using namespace program_test;

namespace {

namespace fs = std::filesystem;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

/// In quotes for the shell.
std::string quoted(const std::string& name) { return "'" + name + "'"; }

const std::string norway = quoted(QUADTREE_MESH_TEST_DATA_DIR "/gshhg_norway_f.poly.gz");
const std::string aegean = quoted(QUADTREE_MESH_TEST_DATA_DIR "/gshhg_aegean_h.poly.gz"); // of two blocks

void check_same(const Scratch_folder& folder, const std::string& a, const std::string& b) {
  for (const char* ending : {".node", ".ele", ".poly"})
    CHECK(content(folder.file(a + ending)) == content(folder.file(b + ending)));
}

} // namespace

TEST_CASE("The program writes the same files with little memory", "[program][scratch]") {
  const Scratch_folder folder;
  const std::string coast = is_full_run() ? norway : aegean;
  REQUIRE(run(coast + " --quiet -o " + quoted(folder.file("all.ele"))).status == 0);
  const Run little = run(coast + " --memory 100M -o " + quoted(folder.file("little.ele")));
  CAPTURE(little.err);
  CHECK(little.status == 0);
  CHECK(contains(little.out, "scratch folder " + folder.file("little.ele.scratch")));
  check_same(folder, "all", "little");
  CHECK(folder.number_of_files() == 6); // the scratch folder is gone
  CHECK(run(coast + " --quiet --threads 1 --memory 0.1G --scratch " +
            quoted(folder.file("mine/of/this/run")) + " -o " + quoted(folder.file("one.ele")))
            .status == 0);
  check_same(folder, "all", "one");
  CHECK(folder.number_of_files() == 9); // and so is each that was made for one
}

TEST_CASE("The program goes on where it was killed", "[program][scratch]") {
  const Scratch_folder folder;
  REQUIRE(run(norway + " --quiet -o " + quoted(folder.file("all.ele"))).status == 0);
  const std::string state = folder.file("killed.ele.scratch/quadtree_mesh_2.state");
  const std::string work = norway + " --resume -o " + quoted(folder.file("killed.ele"));
  for (const std::string signal : {"KILL", "TERM"}) {
    CAPTURE(signal);
    // Killed a moment after it has left a state, if it is not done by then.
    const std::string command = "'" QUADTREE_MESH_PROGRAM "' " + work + " >/dev/null 2>" +
                                quoted(folder.file("err")) + " & p=$!; while [ ! -s " + quoted(state) +
                                " ] && kill -0 $p 2>/dev/null; do sleep 0.01; done; sleep 0.05; "
                                "kill -" +
                                signal + " $p 2>/dev/null; wait $p 2>/dev/null; true";
    CHECK(std::system(command.c_str()) != -1);
    if (signal == "TERM" && fs::exists(state))
      CHECK(contains(content(folder.file("err")), "--resume goes on from there"));
    const Run resumed = run(work);
    CAPTURE(resumed.err);
    CHECK(resumed.status == 0);
    check_same(folder, "all", "killed");
    CHECK_FALSE(fs::exists(state));
    fs::remove(folder.file("killed.ele"));
  }
}

TEST_CASE("The program refuses a state of another input, and begins anew if it is not to go on",
          "[program][scratch]") {
  const Scratch_folder folder;
  const std::string scratch = folder.file("scratch"), output = " -o " + quoted(folder.file("mesh.ele"));
  fs::create_directory(scratch);
  folder.write("scratch/quadtree_mesh_2.state", "no state at all");
  const std::string coast = is_full_run() ? norway : aegean;
  const Run refused = run(coast + " --resume --scratch " + quoted(scratch) + output);
  CHECK(refused.status == 2);
  CHECK(contains(refused.err, folder.file("scratch/quadtree_mesh_2.state")));
  CHECK(content(folder.file("scratch/quadtree_mesh_2.state")) == "no state at all");
  CHECK_FALSE(fs::exists(folder.file("mesh.ele")));
  const Run foreign = run(coast + " --memory 1G --scratch " + quoted(scratch) + output);
  CHECK(foreign.status == 2); // what is no state stays
  CHECK(contains(foreign.err, folder.file("scratch/quadtree_mesh_2.state")));
  CHECK(content(folder.file("scratch/quadtree_mesh_2.state")) == "no state at all");
  fs::remove(folder.file("scratch/quadtree_mesh_2.state"));
  CHECK(run(coast + " --quiet --memory 1G --scratch " + quoted(scratch) + output).status == 0);
  CHECK(fs::exists(scratch)); // the user's
  CHECK(fs::is_empty(scratch));
}

TEST_CASE("A state is of one input, whatever its scale, and of one file of sizes", "[program][scratch]") {
  const Scratch_folder folder;
  const auto coast = [&](const std::string& name, double scale) {
    CGAL::Pslg_2<Point> pslg = pslg_inputs::by_name(is_full_run() ? "coast:6e4" : "coast:3e4").pslg;
    for (Point& p : pslg.vertices) p = Point(scale * p.x(), scale * p.y());
    CGAL::IO::write_triangle_poly(folder.file(name), pslg);
    return quoted(folder.file(name));
  };
  const std::string once = coast("once.poly", 1), twice = coast("twice.poly", 2);
  const std::string fine = " --size-points " + quoted(folder.write("fine.xy", "0.5 0.5 0.01\n")),
                    rough = " --size-points " + quoted(folder.write("rough.xy", "0.5 0.5 0.02\n"));
  const std::string grid =
      " --size-grid " + quoted(folder.write("fine.asc", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\n"
                                                        "cellsize 1\n0.05\n"));
  const std::string scratch = folder.file("scratch"), state = scratch + "/quadtree_mesh_2.state";
  const std::string options = " --max-edge 0.05 --resume --quiet --scratch " + quoted(scratch) + " -o " +
                              quoted(folder.file("mesh.vtu"));
  fs::create_symlink("/dev/full", folder.file("mesh.vtu")); // nothing can be written, so states stay
  CHECK(run(once + options + fine).status == 2);
  REQUIRE(fs::exists(state));
  const std::string before = content(state);
  for (const std::string& other :
       {twice + options + fine, once + options + rough, once + options + fine + grid, once + options}) {
    const Run refused = run(other);
    CAPTURE(other, refused.err);
    CHECK(refused.status == 2);
    CHECK(contains(refused.err, "another input"));
  }
  CHECK(content(state) == before);
}

TEST_CASE("Two runs do not share a scratch folder", "[program][scratch]") {
  const Scratch_folder folder;
  const std::string scratch = folder.file("scratch");
  fs::create_directory(scratch);
  const CGAL::Quadtree_mesh_2::internal::Folder_lock lock(scratch);
  const Run refused =
      run(norway + " --memory 1G --scratch " + quoted(scratch) + " -o " + quoted(folder.file("mesh.ele")));
  CHECK(refused.status == 2);
  CHECK(contains(refused.err, "another program is at work"));
}

TEST_CASE("Refused runs leave no folder, and files of the user stay", "[program][scratch]") {
  const Scratch_folder folder;
  const std::string output = " -o " + quoted(folder.file("mesh.ele"));
  CHECK(run(quoted(folder.file("none.poly")) + " --memory 1G" + output).status == 2);
  CHECK(folder.number_of_files() == 0);
  const std::string file = quoted(folder.write("file", "mine")), mesh = quoted(folder.file("mesh.ele"));
  CHECK(contains(run(norway + " --memory 1G --scratch " + file + output).err, "--scratch"));
  CHECK(contains(run(norway + " --memory 1G --scratch " + mesh + output).err, "names a folder"));
  const std::string state = quoted(folder.file("quadtree_mesh_2.state")), here = quoted(folder.file(""));
  fs::copy_file(QUADTREE_MESH_TEST_DATA_DIR "/gshhg_norway_f.poly.gz", folder.file("quadtree_mesh_2.state"));
  CHECK(run(state + " --memory 1G --scratch " + here + output).status == 2);
  CHECK(run(norway + " --memory 1G --scratch " + here + output + " --report " + state).status == 2);
  CHECK(folder.number_of_files() == 2);
}

TEST_CASE("Options of large runs are refused where they make no sense", "[program]") {
  const Scratch_folder folder;
  const std::string output = " -o " + quoted(folder.file("mesh.ele"));
  for (const std::string bad : {"many", "0", "-1G", "10", "63M", "1X", "1GG", "G", "nan", "inf", "1e40"}) {
    const Run r = run(norway + " --memory " + quoted(bad) + output);
    CAPTURE(bad, r.err);
    CHECK(r.status == 2);
    CHECK(contains(r.err, "--memory has to be a number of bytes"));
  }
  const auto error = [&](const std::string& arguments) { return run(norway + arguments).err; };
  CHECK(contains(error(" --scratch x" + output), "--scratch has a meaning with --memory or --resume only"));
  CHECK(contains(error(" --memory 1G"), "--memory needs a scratch folder"));
  CHECK(contains(error(" --resume"), "--resume needs a scratch folder"));
  CHECK(contains(error(" --resume --kernel exact" + output), "--resume has a meaning with"));
  CHECK(contains(error(" --resume --mode points" + output), "--resume has a meaning with"));
  CHECK(contains(error(" --memory 1G --scratch /proc/nowhere" + output), "/proc/nowhere"));
  CHECK(folder.number_of_files() == 0);
}

} // namespace test_large_runs

#endif // __linux__
#endif // QUADTREE_MESH_PROGRAM
