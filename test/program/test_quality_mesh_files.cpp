// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The command-line program: that it writes all its files or none, destroys no input, and refuses what makes no sense.

#ifdef QUADTREE_MESH_PROGRAM

#include "catch.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace test_quality_mesh_files {

using namespace program_test;

namespace {

namespace fs = std::filesystem;

const char* const square = "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n";

/// A folder, its files and what is in them; nothing for what cannot be read to an end.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    files[entry.path().filename().string()] = entry.is_regular_file() ? content(entry.path().string()) : "";
  return files;
}

struct Case {
  std::string arguments, culprit;
};

/// That each command line ends with status 2 and a message, and changes nothing.
void check_refused(const Scratch_folder& folder, const std::vector<Case>& cases) {
  const auto before = files_in(folder.file(""));
  for (const Case& c : cases) {
    const Run r = run(c.arguments);
    CAPTURE(c.arguments, r.err);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    CHECK(contains(r.err, c.culprit));
    CHECK(files_in(folder.file("")) == before);
  }
}

/// Runs the program, waits until a file is there, sends it a signal and returns the status with which it ends.
int status_after_signal(const std::vector<std::string>& arguments, const std::string& file, int signal) {
  const pid_t child = fork();
  if (child == 0) {
    std::vector<char*> words{const_cast<char*>(QUADTREE_MESH_PROGRAM)};
    for (const std::string& a : arguments) words.push_back(const_cast<char*>(a.c_str()));
    words.push_back(nullptr);
    execv(QUADTREE_MESH_PROGRAM, words.data());
    _exit(127);
  }
  constexpr int most = 3000;
  for (int i = 0; i < most && !fs::exists(file); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  int status = -1;
  for (int i = 0; i < most; ++i) { // again and again: the first may come before the program waits
    kill(child, signal);
    if (waitpid(child, &status, WNOHANG) == child) return status;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(child, SIGKILL);
  waitpid(child, &status, 0);
  return -1;
}

} // namespace

TEST_CASE("an output that is an input or another output is refused", "[program]") {
  const Scratch_folder folder;
  const std::string in = folder.write("in.poly", square), sizes = folder.write("sizes.off", "0 0 0.5\n");
  folder.write("there.off", "old");
  fs::create_symlink("there.off", folder.file("link.off"));
  fs::create_hard_link(folder.file("there.off"), folder.file("hard.off"));
  fs::create_symlink(in, folder.file("link.poly"));
  fs::create_symlink(folder.file(""), folder.file("same"));
  folder.write("bare.poly", "0 2 0 0\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
  fs::rename(folder.file("bare.poly"), folder.file("bare"));
  folder.write("bare.node", "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n");
  const auto f = [&](const char* name) { return ' ' + folder.file(name); };
  const std::string o = " -o", report = " --report";
  check_refused(folder,
                {{in + o + f("in.ele"), "overwrite the input"},
                 {in + o + f("same/in.ele"), "overwrite the input"},
                 {in + o + f("x.off") + report + f("in.poly"), "--report"},
                 {in + o + f("link.poly"), "overwrite the input"},
                 {in + " --size-points " + sizes + o + ' ' + sizes, "--size-points"},
                 {in + " --size-points " + sizes + report + ' ' + sizes, "--size-points"},
                 {in + " --size-grid " + sizes + o + ' ' + sizes, "--size-grid"},
                 {in + o + f("x.off") + o + f("x.off"), "x.off"},
                 {in + o + f("x.off") + o + f("./x.off"), "x.off"},
                 {in + o + f("x.off") + o + f("same/x.off"), "x.off"},
                 {in + o + f("x.off") + report + f("x.off"), "--report"},
                 {in + o + f("x.ele") + o + f("x.node"), "x.node"},
                 {in + o + f("x.ele") + report + f("x.poly"), "--report"},
                 {in + o + f("there.off") + o + f("link.off"), "link.off"},
                 {in + o + f("there.off") + o + f("hard.off"), "hard.off"},
                 {in + report + " /dev/stdout" + o + f("same") + "/../x.off" + o + f("none/x.off"), "none"},
                 {folder.file("bare") + o + f("bare.ele"), "bare.node"}});
  CHECK(run(in + " --quiet -o " + folder.file("link.off")).status == 0); // through the link
  CHECK(fs::is_symlink(folder.file("link.off")));
  CHECK(content(folder.file("there.off")).rfind("OFF", 0) == 0);
  // A .node file that the input does not need may be of an earlier run.
  fs::rename(in, folder.file("in"));
  for (int i = 0; i < 2; ++i)
    CHECK(run(folder.file("in") + " --quiet -o " + folder.file("in.ele")).status == 0);
}

TEST_CASE("options out of range are refused by name", "[program]") {
  const Scratch_folder folder;
  const std::string in = folder.write("in.poly", square) + " -o " + folder.file("x.off") + ' ',
                    points = folder.write("in.xy", "0 0\n1 0\n0 1\n") + " -o " + folder.file("x.off") + ' ';
  std::vector<Case> cases{{in + "--threads 5000", "--threads"},
                          {in + "--threads -1", "--threads"},
                          {in + "--smooth 2000000000", "--smooth"},
                          {in + "--thin 2000000000", "--thin"},
                          {in + "--thin 99999999999999999999", "--thin"},
                          {in + "--min-edge 2 --max-edge 1", "--min-edge"},
                          {in + "--report ''", "--report"},
                          {in + "--report /", "/"},
                          {in + "--size-points ''", "--size-points"},
                          {in + "--size-points .", "folder"},
                          {in + "--size-grid ''", "--size-grid"},
                          {in + "--size-grid .", "folder"},
                          {in + "--gradation 1.5", "--gradation has to be at most 1"},
                          {in + "--max-edge-ratio 2", "--max-edge-ratio has to be at least 3"},
                          {in + "--max-angle 104", "--max-angle has to be at least 105"},
                          {in + "--max-angle 180", "--max-angle has to be at least 105 and below 180"},
                          {in + "--size-from-features 0 1", "--size-from-features has to be a size above 0"},
                          {in + "--size-from-features 1 -1", "a growth of at least 0"},
                          {in + "--size-grid x.asc.tif", "x.asc.tif"},
                          {in + "--gradation 0 --size-grid x.asc", "--gradation has to be a number above 0"},
                          {in + "--region-property ''", "--region-property"},
                          {in + "--min-angle 20 --min-angle 25", "--min-angle"},
                          {in + "--quiet --quiet", "--quiet"},
                          {in + "-o ''", "''"},
                          {points + "--mode bounded --angles 36 80 --angles 30 85", "--angles"},
                          {points + "--mode acute --budget 99999999999999999999", "--budget"},
                          {points + "--mode acute --effort 99999999999", "--effort"}};
  for (const char* const option : {"--min-angle", "--max-angle", "--max-edge", "--max-area", "--min-edge",
                                   "--threads", "--smooth", "--thin"})
    for (const char* const value : {"nan", "inf", "-inf", "1e999", "-5", "''", "x", "5x"})
      cases.push_back({in + option + ' ' + value, option});
  check_refused(folder, cases);
  CHECK(run(in + "--quiet --threads 256").status == 0);
}

TEST_CASE("what is no file of text is refused", "[program]") {
  const Scratch_folder folder;
  const std::string out = " -o " + folder.file("x.off");
  fs::create_directory(folder.file("folder.poly"));
  std::vector<Case> cases{{folder.file("folder.poly") + out, "folder"},
                          {"/dev/null" + out, "the number of vertices"},
                          {folder.write("empty.poly", "") + out, "empty.poly:1"},
                          {folder.write("empty.geojson", "") + out, "empty.geojson:1"},
                          {folder.write("utf16.poly", "\xff\xfe"
                                                      "4") +
                               out,
                           "UTF-16"},
                          {folder.write("packed.poly.gz", "\x1f\x8b") + out, "gzip"}};
  const std::string secret = folder.write("secret.poly", square);
  fs::permissions(secret, fs::perms::none);
  if (geteuid() != 0) cases.push_back({secret + out, "Permission denied"});
  check_refused(folder, cases);
  fs::permissions(secret, fs::perms::owner_all);
  CHECK(run("--quiet " + folder.write("bom.poly", std::string("\xef\xbb\xbf") + square) + out).status == 0);
}

TEST_CASE("what cannot be written stops all files", "[program]") {
  const Scratch_folder folder;
  const std::string in = folder.write("in.poly", square), a = folder.write("a.off", "old");
  fs::create_symlink("/dev/full", folder.file("full.json"));
  fs::create_symlink("/dev/full", folder.file("full.obj"));
  const std::string out = in + " -o " + a + " -o " + folder.file("b.vtu");
  const auto before = files_in(folder.file(""));
  for (const std::string& arguments : std::vector<std::string>{
           out + " --report " + folder.file("full.json"), out + " -o " + folder.file("full.obj"),
           out + " --report /dev/full", out + " >/dev/full 2>/dev/null #"}) {
    const Run r = run(arguments);
    CAPTURE(arguments, r.err);
    CHECK(r.status == 2);
    CHECK(files_in(folder.file("")) == before);
  }
  CHECK(run(out).status == 0);
}

TEST_CASE("a signal ends the program and leaves no files", "[program]") {
  const int signal = GENERATE(SIGINT, SIGTERM, SIGHUP);
  const Scratch_folder folder;
  const std::string in = folder.write("in.poly", square), a = folder.write("a.off", "old"),
                    pipe = folder.file("pipe.obj"); // nobody reads it
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  std::vector<std::string> arguments{
      in, "--quiet", "--pieces", "2", "-o", a, "-o", folder.file("b.pvtu"), "-o", folder.file("b.msh")};
#ifdef CGAL_LINKED_WITH_HDF5
  for (const char* const name : {"b.vtkhdf", "b.xdmf"})
    arguments.push_back("-o"), arguments.push_back(folder.file(name));
#endif
  for (const std::string& last : {folder.file("b.vtu"), pipe})
    arguments.push_back("-o"), arguments.push_back(last);
  const int status = status_after_signal(arguments, folder.file("b.vtu.part0"), signal);
  CHECK(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == signal);
  CHECK(content(a) == "old");
  CHECK(folder.number_of_files() == 3);
}

TEST_CASE("points that are too near to each other are named with their coordinates", "[program][points]") {
  const Scratch_folder folder;
  for (const char* const mode : {"bounded", "warped"})
    for (const char* const kernel : {"filtered", "exact"}) {
      const Run r =
          run(folder.write("in.xy", "1 1\n0 0\n0 1\n1e-30 0\n") + " --mode " + mode + " --kernel " + kernel);
      CAPTURE(mode, kernel, r.err);
      CHECK(r.status == 2);
      CHECK(contains(r.err, "points 1 (0, 0) and 3 ("));
    }
}

} // namespace test_quality_mesh_files

#endif // QUADTREE_MESH_PROGRAM
