// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Meshes larger than memory, and work that goes on after an interruption: the same bits, whatever happens on the way.

#include "catch.h"
#include "mesher_test_tools.h"
#include "pslg_inputs.h"
#include "random_pslg_shapes.h"
#include "scratch_folder.h"
#include "tiny_blocks.h"

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/Scratch_memory.h>
#include <CGAL/Streaming_quality_mesher_2.h>
#include <CGAL/bounding_box.h>
#include <CGAL/renumber_mesh_2.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_large_meshes {

namespace {

using namespace mesher_test;

using Filtered_traits = CGAL::Filtered_quadtree_traits_2<>;
template <class Tag>
using Mesher_of = CGAL::Quality_mesher_2<Filtered_traits, Tag>;

bool are_same(const Mesh& a, const Mesh& b) {
  return a.points == b.points && a.triangles == b.triangles && a.neighbors == b.neighbors &&
         a.segment_of_vertex == b.segment_of_vertex;
}

struct Interruption {};

/// Meshes with checkpoints in a folder, and is interrupted when it has asked so many times whether to go on.
template <class Tag>
Mesh mesh_until(int questions, const Pslg& pslg, Options options, const std::string& folder) {
  std::atomic<int> left{questions};
  options.checkpoints(folder).progress([&left](double) {
    if (--left < 0) throw Interruption();
    return true;
  });
  return Mesher_of<Tag>(options)(pslg);
}

bool has_state(const Scratch_folder& folder) {
  return std::filesystem::exists(folder.file("quadtree_mesh_2.state"));
}

/// Interrupts the work again and again, later each time, until it comes to its end. \returns how often it went on
template <class Tag>
int check_interruptions(const Pslg& pslg, const Options& options, int first_question, int factor) {
  const Mesh expected = Mesher_of<Tag>(options)(pslg);
  const Scratch_folder folder;
  int went_on = 0;
  for (int questions = first_question;; questions *= factor) {
    went_on += has_state(folder) ? 1 : 0;
    try {
      const Mesh mesh = mesh_until<Tag>(questions, pslg, options, folder.file(""));
      CHECK(are_same(mesh, expected));
      return went_on;
    } catch (const Interruption&) {
    }
  }
}

std::string error_of_run(const Pslg& pslg, const Options& options) {
  try {
    Mesher_of<Tiny_blocks_tag> mesher(options);
    mesher(pslg);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("Interrupted meshes in tiny blocks come out the same", "[mesher][checkpoint]") {
  int went_on = 0;
  const std::vector<std::string> names =
      is_full_run() ? std::vector<std::string>{"comb:1000", "fan:0.1",    "stars:1500", "segments:500",
                                               "holes:200", "coast:3000", "koch:3072"}
                    : std::vector<std::string>{"comb:500", "fan:0.3",    "stars:500", "segments:200",
                                               "holes:60", "coast:1500", "koch:768"};
  for (const std::string& name : names) {
    CAPTURE(name);
    const Pslg pslg = pslg_inputs::by_name(name).pslg;
    for (const double angle : {20.7, 28.0})
      went_on += check_interruptions<Tiny_blocks_tag>(pslg, Options().min_angle(angle), 100, 2);
    went_on += check_interruptions<Tiny_blocks_tag>(pslg, Options().smooth(1).thin(1), 200, 3);
  }
  CHECK(went_on > 50);
}

TEST_CASE("An interrupted mesh of a map comes out the same", "[mesher][checkpoint][parallel]") {
  CHECK(check_interruptions<CGAL::Parallel_tag>(read("gshhg_norway_f.poly.gz"), Options(), 100, 2) > 0);
}

TEST_CASE("A bulk of squares goes on after an interruption", "[mesher][checkpoint]") {
  const Pslg pslg = read("gshhg_norway_f.poly.gz");
  const auto box = CGAL::bounding_box(pslg.vertices.begin(), pslg.vertices.end());
  const Options options = Options().max_area((box.xmax() - box.xmin()) * (box.ymax() - box.ymin()) / 1e5);
  CHECK(check_interruptions<CGAL::Parallel_tag>(pslg, options, 200, 2) > 0);
}

TEST_CASE("A state belongs to its input and options", "[mesher][checkpoint]") {
  const Pslg pslg = pslg_inputs::by_name("coast:3000").pslg, other = pslg_inputs::by_name("stars:1500").pslg;
  const Scratch_folder folder;
  CHECK_THROWS_AS(mesh_until<Tiny_blocks_tag>(500, pslg, Options(), folder.file("")), Interruption);
  REQUIRE(has_state(folder));
  const std::string before = content(folder.file("quadtree_mesh_2.state"));
  const Options options = Options().checkpoints(folder.file(""));
  CHECK(error_of_run(other, options).find("another input") != std::string::npos);
  CHECK(error_of_run(pslg, Options(options).min_angle(25)).find("another input") != std::string::npos);
  CHECK(content(folder.file("quadtree_mesh_2.state")) == before);
  folder.write("quadtree_mesh_2.state", before.substr(0, before.size() / 2));
  CHECK(error_of_run(pslg, options).find("damaged") != std::string::npos);
}

TEST_CASE("Small meshes and those of quadtrees leave no state", "[mesher][checkpoint]") {
  const Scratch_folder folder;
  const Pslg pslg = random_pslg::all_families().front().make(5);
  const Options options = Options().checkpoints(folder.file(""));
  CHECK(are_same(CGAL::Quality_mesher_2<>(options)(pslg), CGAL::Quality_mesher_2<>()(pslg)));
  Options by_trees = options;
  by_trees.separate(Options::Separation::THEOREM_5);
  CGAL::Quality_mesher_2<> mesher(by_trees);
  mesher(pslg);
  CHECK(folder.number_of_files() == 0);
}

#ifdef __linux__

TEST_CASE("Meshes in scratch files have the same bits", "[mesher][scratch]") {
  constexpr std::size_t any_memory = std::size_t(1) << 40;
  const Scratch_folder folder;
  for (const auto& family : random_pslg::all_families()) {
    CAPTURE(family.name);
    const Pslg pslg = family.make(11);
    const Mesh expected = Mesher_of<Tiny_blocks_tag>(Options().min_angle(25))(pslg);
    Mesh found;
    {
      const CGAL::Scratch_memory memory(folder.file(""), any_memory, 256);
      found = Mesher_of<Tiny_blocks_tag>(Options().min_angle(25))(pslg);
    }
    CHECK(are_same(found, expected));
  }
}

TEST_CASE("A mesh is streamed from file to file as it is made in memory", "[mesher][scratch][checkpoint]") {
  const Scratch_folder folder;
  const std::string input = QUADTREE_MESH_TEST_DATA_DIR "/gshhg_norway_f.poly.gz",
                    scratch = folder.file("scratch");
  const Pslg pslg = read("gshhg_norway_f.poly.gz");
  CGAL::IO::write_triangle_files(CGAL::Quality_mesher_2<>()(pslg), pslg, folder.file("memory"));
  CGAL::Streaming_quality_mesher_2<Filtered_traits, CGAL::Parallel_tag> mesher(
      Options(), {scratch, std::size_t(1) << 28});
  CHECK(mesher(input, folder.file("streamed.ele")).is_met());
  for (const char* ending : {".node", ".ele", ".poly"})
    CHECK(content(folder.file("streamed") + ending) == content(folder.file("memory") + ending));
  CHECK(std::filesystem::is_empty(scratch));

  int questions = 0;
  CGAL::Streaming_quality_mesher_2<> interrupted(
      Options().progress([&questions](double) { return ++questions < 60 ? true : throw Interruption(); }),
      {scratch, std::size_t(1) << 28});
  CHECK_THROWS_AS(interrupted(input, folder.file("again.ele")), Interruption);
  CHECK(std::filesystem::exists(scratch + "/quadtree_mesh_2.state"));
  CHECK(mesher(input, folder.file("again.ele")).is_met());
  CHECK(content(folder.file("again.ele")) == content(folder.file("memory.ele")));
  CHECK(std::filesystem::is_empty(scratch));

  CHECK_THROWS_AS(mesher(input, folder.file("mesh.png")), std::invalid_argument);
  CHECK_THROWS_AS(mesher(input, folder.file("no/folder/mesh.ele")), std::invalid_argument);
  CHECK_THROWS_AS(mesher(folder.file("again.poly"), folder.file("again.ele")), std::invalid_argument);
  CHECK_THROWS_AS(CGAL::Streaming_quality_mesher_2<>(Options(), {}), std::invalid_argument);
}

TEST_CASE("Streamed files in the order of places are those made in memory", "[mesher][scratch][renumber]") {
  const Scratch_folder folder;
  const std::string input = QUADTREE_MESH_TEST_DATA_DIR "/gshhg_aegean_h.poly.gz";
  const Pslg pslg = read("gshhg_aegean_h.poly.gz");
  Mesh mesh = CGAL::Quality_mesher_2<>()(pslg);
  CGAL::renumber_by_place(mesh);
  CGAL::Streaming_options_2 streaming;
  streaming.scratch_folder = folder.file("scratch"), streaming.memory = std::size_t(1) << 28;
  streaming.is_renumbered = true, streaming.pieces = 2;
  CGAL::Streaming_quality_mesher_2<Filtered_traits, CGAL::Parallel_tag> mesher(Options(), streaming);
  CGAL::IO::write_triangle_files(mesh, pslg, folder.file("memory"));
  CHECK(mesher(input, folder.file("stream.ele")).is_met());
  CGAL::IO::write_PVTU(folder.file("memory.pvtu"), mesh, pslg, 2);
  CHECK(mesher(input, folder.file("stream.pvtu")).is_met());
  CGAL::IO::write_MSH_parts(folder.file("memory.msh"), mesh, pslg, 2);
  CHECK(mesher(input, folder.file("stream.msh")).is_met());
  std::vector<std::string> files{".node", ".ele", ".poly", "_1.vtu", "_2.vtu", "_1.msh", "_2.msh"};
#ifdef CGAL_LINKED_WITH_HDF5
  CGAL::IO::write_HDF5(folder.file("graph.h5"), pslg);
  CGAL::IO::write_VTKHDF(folder.file("memory.vtkhdf"), mesh, pslg);
  CHECK(mesher(folder.file("graph.h5"), folder.file("stream.vtkhdf")).is_met());
  CGAL::IO::write_XDMF(folder.file("memory.xdmf"), mesh, pslg);
  CHECK(mesher(folder.file("graph.h5"), folder.file("stream.xdmf")).is_met());
  CHECK_THROWS_AS(mesher(folder.file("graph.h5"), folder.file("graph.xdmf")), std::invalid_argument);
  files.push_back(".vtkhdf"), files.push_back(".h5");
#endif
  for (const std::string& file : files) {
    CAPTURE(file);
    CHECK(content(folder.file("stream" + file)) == content(folder.file("memory" + file)));
  }
}

#endif // __linux__

} // namespace test_large_meshes
