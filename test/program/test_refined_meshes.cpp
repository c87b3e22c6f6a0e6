// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The program with a mesh to refine, as with Triangle's -r.

#include "adapt_tools.h"
#include "catch.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <CGAL/IO/read_triangle_files.h>
#include <CGAL/IO/write_triangle_files.h>

#include <cstddef>
#include <string>

namespace test_refined_meshes {

using namespace program_test;

namespace {

using namespace adapt_test;

/// A mesh in files of a folder.
struct Files {
  Scratch_folder folder;
  Mesh mesh = fresh_mesh(frame(), Options().max_area(0.1));

  Files() { CGAL::IO::write_triangle_files(mesh, frame(), folder.file("m.1")); }
  Mesh refined() const {
    Mesh result;
    CGAL::IO::read_triangle_files(folder.file("m.2"), result);
    return result;
  }
  Run run_with(const std::string& options) const {
    return run("'" + folder.file("m.1.ele") + "' -o '" + folder.file("m.2.ele") + "' --quiet " + options);
  }
};

} // namespace

TEST_CASE("A mesh is refined by bounds, and keeps its vertices in front", "[program]") {
  const Files files;
  REQUIRE(files.run_with("--max-area 0.01").status == 0);
  const Mesh refined = files.refined();
  REQUIRE(refined.points.size() > files.mesh.points.size());
  for (std::size_t v = 0; v < files.mesh.points.size(); ++v)
    CHECK(have_same_bits(refined.points[v], files.mesh.points[v]));
  for (std::size_t t = 0; t < refined.triangles.size(); ++t) CHECK(area(refined, t) <= 0.01);
  check_valid(refined, frame(),
              CGAL::Mesh_quality_options_2().min_angle(20.7).check_arrays(
                  CGAL::Mesh_quality_options_2::Arrays::POINTS_AND_TRIANGLES));
  REQUIRE(files.run_with("").status == 0);
  CHECK(files.refined().points.size() == files.mesh.points.size());
}

TEST_CASE("A mesh is refined by areas of its triangles", "[program]") {
  const Files files;
  std::string text = std::to_string(files.mesh.triangles.size()) + '\n';
  for (std::size_t t = 0; t < files.mesh.triangles.size(); ++t)
    text += std::to_string(t) + (t == 5 ? " 0.002\n" : " -1\n");
  const std::string name = files.folder.write("m.1.area", text);
  REQUIRE(files.run_with("--area-file '" + name + "'").status == 0);
  const Mesh refined = files.refined();
  CHECK(refined.triangles.size() > files.mesh.triangles.size() + 8);
  CHECK(refined.triangles.size() < 2 * files.mesh.triangles.size() + 200);

  // Tiny areas are refused before memory ends, and the one that asks for most is named.
  std::string tiny = std::to_string(files.mesh.triangles.size()) + '\n';
  for (std::size_t t = 0; t < files.mesh.triangles.size(); ++t)
    tiny += std::to_string(t) + (t == 4 ? " 1e-12\n" : t == 7 ? " 1e-15\n" : " -1\n");
  files.folder.write("m.1.area", tiny);
  const Run refused = files.run_with("--area-file '" + name + "'");
  CHECK(refused.status == 2);
  CHECK(contains(refused.err, "the mesh would need "));
  CHECK(contains(refused.err,
                 " for the areas of triangles, most of all for that of triangle 7, 1e-15; raise these"));
  CHECK(files.run_with("--max-steiner 10 --area-file '" + name + "'").status == 1);

  files.folder.write("m.1.area", "2\n0 1\n1 1\n");
  const Run wrong = files.run_with("--area-file '" + name + "'");
  CHECK(wrong.status == 2);
  CHECK(contains(wrong.err,
                 "m.1.area:1: there are 2 areas for " + std::to_string(files.mesh.triangles.size())));
}

TEST_CASE("What has no meaning for a mesh to refine is refused by name", "[program]") {
  const Files files;
  for (const char* option :
       {"--hull", "--repair", "--project none", "--size-from-features 1 1", "--domain marked",
        "--kernel exact", "--separation theorem-5", "--compare", "--memory 2G"}) {
    const Run refused = files.run_with(option);
    CHECK(refused.status == 2);
    CHECK(contains(refused.err, " has no meaning for a mesh to refine (.ele)"));
  }
  const Run wrong = run("'" + test_data("hard_box.poly") + "' -o /dev/null.vtu --area-file x.area");
  CHECK(wrong.status == 2);
  CHECK(contains(wrong.err, "--area-file has a meaning for a mesh to refine only, an input .ele"));
  const Run over = run("'" + files.folder.file("m.1.ele") + "' -o '" + files.folder.file("m.1.poly") + "'");
  CHECK(over.status == 2);
  CHECK(contains(over.err, "would overwrite"));
}

TEST_CASE("A mesh of six nodes for each triangle is refined from its corners", "[program]") {
  const Files files;
  const std::string six = files.folder.file("six.ele");
  REQUIRE(run("'" + files.folder.file("m.1.ele") + "' --second-order -o '" + six + "' --quiet").status == 0);
  REQUIRE(run("'" + six + "' -o '" + files.folder.file("m.2.ele") + "' --quiet").status == 0);
  CHECK(have_same_bits(files.refined(), files.mesh));
}

TEST_CASE("A mesh with sharp corners that meets the bounds comes back as it is", "[program]") {
  const Scratch_folder folder;
  for (const char* name : {"syn_wedge_0.01deg.poly", "syn_fan_1deg.poly", "hard_tips_of_legs.poly"}) {
    CAPTURE(name);
    const std::string first = folder.file("m.0.ele"), second = folder.file("m.1.ele");
    REQUIRE(run("'" + test_data(name) + "' -o '" + first + "' --quiet").status == 0);
    REQUIRE(run("'" + first + "' -o '" + second + "' --quiet").status == 0);
    for (const char* ending : {".node", ".ele"})
      CHECK(content(folder.file(std::string("m.0") + ending)) ==
            content(folder.file(std::string("m.1") + ending)));
  }
}

TEST_CASE("Bad meshes are refused, and the triangle is named", "[program]") {
  const Scratch_folder folder;
  folder.write("a.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n");
  folder.write("a.ele", "2 3 0\n1 1 2 3\n2 1 4 3\n");
  const Run clockwise = run("'" + folder.file("a.ele") + "' -o '" + folder.file("b.vtu") + "'");
  CHECK(clockwise.status == 2);
  CHECK(contains(clockwise.err, "triangle 2 (1 4 3) is clockwise"));
}

} // namespace test_refined_meshes
