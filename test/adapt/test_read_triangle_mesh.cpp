// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "adapt_tools.h"
#include "mutate_text.h"
#include "scratch_folder.h"

#include <CGAL/IO/read_triangle_mesh.h>
#include <CGAL/IO/write_triangle_files.h>
#include <CGAL/refine_mesh_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_read_triangle_mesh {

namespace {

using namespace adapt_test;
using pslg_test::error_of;

const std::string nodes = "4 2 1 1\n1 0 0 0.5 7\n2 1 0 1.5 0\n3 1 1 2.5 0\n4 0 1 3.5 0\n";
const std::string triangles = "2 3 1\n1 1 2 3 5\n2 1 3 4 6\n";

struct Files {
  Scratch_folder folder;

  Files(const std::string& node, const std::string& ele, const std::string& poly = "") {
    folder.write("m.node", node), folder.write("m.ele", ele);
    if (!poly.empty()) folder.write("m.poly", poly);
  }
  std::string name() const { return folder.file("m.ele"); }
  bool is_read() const {
    Mesh mesh;
    Pslg pslg;
    CGAL::IO::read_triangle_mesh(name(), mesh, pslg);
    check_valid(mesh, pslg);
    return mesh.points.size() == 4;
  }
  std::string refusal() const {
    Mesh mesh;
    Pslg pslg;
    const std::string text = error_of([&] { CGAL::IO::read_triangle_mesh(name(), mesh, pslg); });
    CHECK(mesh.points.empty());
    CHECK(pslg.vertices.empty());
    return text;
  }
};

} // namespace

TEST_CASE("A mesh is read from its files, with attributes, markers and segments", "[adapt]") {
  const Files files(nodes, triangles, "0 2 0 1\n2 1\n1 2 3 8\n2 3 1 9\n0\n");
  Mesh mesh;
  Pslg pslg;
  CGAL::IO::read_triangle_mesh(files.name(), mesh, pslg);
  CHECK(mesh.triangles.size() == 2);
  CHECK(pslg.first_number == 1);
  CHECK(pslg.vertices.size() == 4);
  CHECK(pslg.vertex_markers == std::vector<int>{7, 0, 0, 0});
  CHECK(pslg.vertex_attributes == std::vector<double>{0.5, 1.5, 2.5, 3.5});
  REQUIRE(pslg.segments.size() == 5);
  for (std::size_t s = 0; s < 5; ++s) {
    const auto& [a, b] = pslg.segments[s];
    const bool is_diagonal = a.value() + b.value() == 2 && a.value() * b.value() == 0;
    const bool is_right = a.value() + b.value() == 3 && a.value() * b.value() == 2;
    CHECK(pslg.segment_markers[s] == (is_diagonal ? 9 : is_right ? 8 : 0));
  }
  REQUIRE(pslg.regions.size() == 2);
  CHECK(pslg.regions[0].attribute == 5);
  CHECK(pslg.regions[1].attribute == 6);
  check_valid(mesh, pslg);
}

TEST_CASE("A written mesh is read again and refined, with holes", "[adapt]") {
  const Scratch_folder folder;
  const Pslg graph = frame();
  const Mesh made = fresh_mesh(graph, Options().max_area(0.1));
  CGAL::IO::write_triangle_files(made, graph, folder.file("m"));
  Mesh mesh;
  Pslg pslg;
  CGAL::IO::read_triangle_mesh(folder.file("m.ele"), mesh, pslg);
  CHECK(have_same_bits(mesh, made));
  CHECK(pslg.holes.size() == 1);
  check_valid(mesh, pslg);
  const auto refined = CGAL::refine_mesh_2(mesh, pslg, Options().max_area(0.02));
  check_transfer(refined, mesh);
  check_valid(refined.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7).max_area(0.02));
  check_valid(refined.mesh, graph,
              CGAL::Mesh_quality_options_2().check_arrays(
                  CGAL::Mesh_quality_options_2::Arrays::POINTS_AND_TRIANGLES));
}

TEST_CASE("Of six nodes for each triangle the corners are read", "[adapt]") {
  const Scratch_folder folder;
  const Pslg graph = frame();
  const Mesh made = fresh_mesh(graph, Options().max_area(0.1));
  CGAL::Quadtree_mesh_2::internal::Replaced_files files;
  CGAL::Quadtree_mesh_2::internal::add_triangle_files(files, made, graph, folder.file("m"),
                                                      CGAL::IO::Element_order::SECOND);
  files.commit();
  Mesh mesh;
  Pslg pslg;
  CGAL::IO::read_triangle_mesh(folder.file("m.ele"), mesh, pslg);
  CHECK(mesh.points.size() == made.points.size());
  CHECK(have_same_bits(mesh, made));
  CHECK(mesh.vertex_markers == made.vertex_markers);
  check_valid(mesh, pslg);

  // A middle node in front, one that is a corner elsewhere, and a vertex of no triangle.
  const Files mixed("8 2 1 1\n1 0.5 0.5 9 9\n2 0 0 2 0\n3 1 0 3 0\n4 1 1 4 0\n5 0 1 5 0\n6 1 0.5 6 6\n7 9 9 "
                    "7 0\n8 2 0.5 8 0\n",
                    "3 6 0\n1 2 3 4 6 1 6\n2 2 4 5 1 1 1\n3 3 8 6 1 1 1\n", "0 2 0 1\n1 1\n1 2 3 5\n0\n");
  std::string text = error_of([&] { CGAL::IO::read_triangle_mesh(mixed.name(), mesh, pslg); });
  CHECK(text == "");
  CHECK(mesh.points.size() == 7);
  CHECK(pslg.vertex_attributes == std::vector<double>{2, 3, 4, 5, 6, 7, 8});
  const Files wrong("5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 0.5\n", "1 6 0\n1 1 2 3 5 5 5\n",
                    "0 2 0 0\n1 0\n7 1 5\n0\n");
  CHECK(pslg_test::has_text(wrong.refusal(),
                            "m.poly: segment 1 ends at vertex 5, which is in the middle of an edge"));
}

TEST_CASE("Coordinates out of range are named, as in a graph", "[adapt]") {
  const auto refusal = [](const std::string& size) {
    return Files("4 2 0 0\n0 0 0\n1 " + size + " 0\n2 " + size + ' ' + size + "\n3 0 " + size + "\n",
                 "2 3 0\n0 0 1 2\n1 0 2 3\n")
        .refusal();
  };
  CHECK(pslg_test::has_text(refusal("1e308"), "vertex 1 (1e+308, 0) has a coordinate that is too large"));
  for (const char* size : {"1e-308", "5e-324", "1e-200", "1e200", "1e300"}) {
    CAPTURE(size);
    const Files files("4 2 0 0\n0 0 0\n1 " + std::string(size) + " 0\n2 " + size + ' ' + size + "\n3 0 " +
                          size + "\n",
                      "2 3 0\n0 0 1 2\n1 0 2 3\n");
    REQUIRE(files.is_read());
    Mesh mesh;
    Pslg pslg;
    CGAL::IO::read_triangle_mesh(files.name(), mesh, pslg);
    const std::string text = error_of([&] {
      const auto made = CGAL::refine_mesh_2(mesh, pslg, Options());
      CHECK(made.mesh.triangles == mesh.triangles);
    });
    CHECK(text == "");
  }
}

TEST_CASE("Files of a mesh that do not fit are refused, with the culprit by its number", "[adapt]") {
  CHECK(pslg_test::has_text(Files(nodes, "1 3 0\n1 1 2 9\n").refusal(),
                            "m.ele:2: a node of triangle 1: there is no vertex 9, the vertices are 1 to 4"));
  CHECK(Files(nodes, "2 3 0\n1 1 2 3\n2 3 1 4\n").refusal() == "triangle 2 (3 1 4) is clockwise");
  CHECK(
      Files("4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0.9 0.5\n", "2 3 0\n0 0 1 2\n1 0 1 3\n").refusal() ==
      "triangle 0 (0 1 2) and triangle 1 (0 1 3) are on the same side of the edge from vertex 0 to vertex 1");
  CHECK(Files(nodes, triangles, "0 2 0 0\n1 0\n1 2 4\n0\n").refusal() ==
        "segment 1 from vertex 2 to vertex 4 is not an edge of a triangle");
  CHECK(pslg_test::has_text(Files(nodes, "2 4 0\n").refusal(), "triangles have 4 nodes instead of 3 or 6"));
  CHECK(pslg_test::has_text(
      Files(nodes, triangles, "4 2 0 0\n1 0 0\n2 1 0\n3 1 1.5\n4 0 1\n0 0\n0\n").refusal(),
      "m.poly:4: vertex 3 is elsewhere in "));
  CHECK(pslg_test::has_text(Files(nodes, triangles, "3 2 0 0\n1 0 0\n2 1 0\n3 1 1\n0 0\n0\n").refusal(),
                            "m.poly:1: there are 3 vertices, but 4 in "));
  CHECK(Files(nodes, triangles, "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n0 0\n0\n").is_read());
  const Scratch_folder folder;
  folder.write("x.ele", triangles);
  Mesh mesh;
  Pslg pslg;
  CHECK(pslg_test::has_text(error_of([&] { CGAL::IO::read_triangle_mesh(folder.file("x.ele"), mesh, pslg); }),
                            "there is no file"));
}

TEST_CASE("Areas are read for as many triangles as there are", "[adapt]") {
  const Scratch_folder folder;
  Mesh mesh;
  mesh.triangles.resize(3);
  CHECK(CGAL::IO::read_triangle_area(folder.write("a.area", "3\n1 0.5\n2 -1\n3 2e-3 # small\n"), mesh, 1) ==
        std::vector<double>{0.5, -1, 0.002});
  const auto refusal = [&](const std::string& text) {
    return error_of([&] { CGAL::IO::read_triangle_area(folder.write("a.area", text), mesh, 1); });
  };
  CHECK(pslg_test::has_text(refusal("2\n1 1\n2 1\n"), "a.area:1: there are 2 areas for 3 triangles"));
  CHECK(pslg_test::has_text(refusal("3\n1 1\n2 1\n"), "the area of triangle 3"));
  CHECK(pslg_test::has_text(refusal("3\n1 1\n2 x\n3 1\n"), "a.area:3: the area of triangle 2"));
  CHECK(pslg_test::has_text(refusal("3\n1 1\n2 1\n3 1\n4 1\n"), "a.area:5: nothing more is expected"));
}

TEST_CASE("Pieces of a triangle of a file have its bound of area, and a segment along it has theirs",
          "[adapt]") {
  const Scratch_folder folder;
  folder.write("t.node", "5 2 0 0\n0 0 0\n1 2 0\n2 1 3\n3 1 0\n4 1 -3\n");
  folder.write("t.ele", "3 3 0\n0 0 1 2\n1 0 4 3\n2 3 4 1\n");
  folder.write("t.poly", "0 2 0 0\n1 1\n0 1 0 7\n0\n");
  Mesh mesh;
  Pslg pslg;
  std::vector<Triangle_index> given_triangle;
  CGAL::IO::read_triangle_mesh(folder.file("t.ele"), mesh, pslg, given_triangle);
  check_valid(mesh, pslg);
  CHECK(given_triangle == std::vector<Triangle_index>{Triangle_index(0), Triangle_index(1), Triangle_index(2),
                                                      Triangle_index(0)});
  CHECK(std::count(pslg.segment_markers.begin(), pslg.segment_markers.end(), 7) == 2);
  const std::vector<double> areas =
      CGAL::IO::read_triangle_area(folder.write("t.area", "3\n0 0.01\n1 -1\n2 -1\n"), given_triangle);
  CHECK(areas == std::vector<double>{0.01, -1, -1, 0.01});
  const auto made = CGAL::refine_mesh_2(mesh, pslg, areas, Options());
  check_valid(made.mesh, pslg);
  check_transfer(made, mesh);
  double largest_above = 0, largest_below = 0;
  for (std::size_t t = 0; t < made.mesh.triangles.size(); ++t) {
    double& largest = centroid(made.mesh, t).y() > 0 ? largest_above : largest_below;
    largest = std::max(largest, area(made.mesh, t));
  }
  CHECK(largest_above <= 0.01);
  CHECK(largest_below > 0.01);
}

TEST_CASE("Mutated files of a mesh give a mesh that can be refined, or an error", "[adapt][mutated]") {
  const std::string poly = "0 2 0 1\n2 1\n1 2 3 8\n2 3 1 9\n0\n";
  std::size_t read = 0, refused = 0;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    Text_mutator mutate(i);
    const Files files(i % 3 == 0 ? mutate(nodes) : nodes, i % 3 == 1 ? mutate(triangles) : triangles,
                      i % 3 == 2 ? mutate(poly) : poly);
    Mesh mesh;
    Pslg pslg;
    try {
      CGAL::IO::read_triangle_mesh(files.name(), mesh, pslg);
    } catch (const CGAL::Pslg_error_2& error) {
      CHECK(std::string(error.what()).size() > 10);
      ++refused;
      continue;
    }
    CAPTURE(i);
    ++read;
    check_valid(mesh, pslg);
  }
  CHECK(read > 100);
  CHECK(refused > 100);
}

} // namespace test_read_triangle_mesh
