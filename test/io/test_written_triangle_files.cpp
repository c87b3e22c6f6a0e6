// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "scratch_folder.h"
#include "triangle_files_tools.h"

#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quadtree_mesh_2/internal/output/boundary_markers.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <random>
#include <string>
#include <system_error>

namespace test_written_triangle_files {

using namespace triangle_files_test;
using Mesh = CGAL::Indexed_mesh_2<Point>;
using Triangle_index = CGAL::Quadtree_mesh_2::Triangle_index;

namespace {

/// A square of two triangles with one Steiner vertex on segment 2 and an input vertex that no triangle uses.
struct Small_mesh {
  Pslg pslg = make_pslg<double>({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {9, 9}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  Mesh mesh;

  Small_mesh() {
    mesh.number_of_input_vertices = 5;
    mesh.points = pslg.vertices;
    mesh.points.push_back(Point(0.5, 1));
    mesh.segment_of_vertex.assign(6, Segment_index());
    mesh.segment_of_vertex[5] = Segment_index(2);
    add_triangle({0, 1, 5}, {1, 2, -1});
    add_triangle({1, 2, 5}, {-1, 0, -1});
    add_triangle({0, 5, 3}, {-1, -1, 0});
    const std::size_t edges[5][3] = {{0, 1, 0}, {1, 2, 1}, {2, 5, 2}, {5, 3, 2}, {3, 0, 3}};
    for (const auto& e : edges)
      mesh.constrained_edges.push_back({{Vertex_index(e[0]), Vertex_index(e[1])}, Segment_index(e[2])});
  }

  /// All edges on segments are on the border.
  void set_markers() {
    std::vector<std::array<Vertex_index, 2>> border;
    for (const auto& edge : mesh.constrained_edges) border.push_back(edge.vertices);
    CGAL::Quadtree_mesh_2::internal::set_boundary_markers(mesh, pslg, border);
  }

private:
  void add_triangle(std::array<std::size_t, 3> vertices, std::array<int, 3> neighbors) {
    std::array<Vertex_index, 3> v;
    std::array<Triangle_index, 3> n;
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = Vertex_index(vertices[k]);
      if (neighbors[k] >= 0) n[k] = Triangle_index(static_cast<std::size_t>(neighbors[k]));
    }
    mesh.triangles.push_back(v);
    mesh.neighbors.push_back(n);
  }
};

/// Writes decimal commas and groups digits.
struct Odd_punctuation : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

} // namespace

TEST_CASE("a written graph comes back bit for bit", "[triangle_files]") {
  const Scratch_folder folder;
  const std::string name = folder.file("x.poly");
  Pslg back;
  SECTION("with everything") {
    const Pslg pslg = parse(full_example);
    CGAL::IO::write_triangle_poly(name, pslg);
    CGAL::IO::read_triangle_poly(name, back);
    CHECK(have_same_bits(pslg, back));
    CHECK(back.first_number == pslg.first_number);
    CGAL::IO::write_triangle_node(folder.file("x.node"), pslg);
    CGAL::IO::read_triangle_node(folder.file("x.node"), back);
    CHECK(have_same_bits(pslg.vertices[4].y(), back.vertices[4].y()));
    CHECK(back.vertex_attributes == pslg.vertex_attributes);
    CHECK(back.vertex_markers == pslg.vertex_markers);
    CHECK(back.segments.empty());
  }
  SECTION("with any bits in its coordinates") {
    std::mt19937_64 random(11);
    const auto any_double = [&random] {
      double x;
      do {
        const std::uint64_t bits = random();
        std::memcpy(&x, &bits, sizeof x);
      } while (!std::isfinite(x));
      return x;
    };
    Pslg pslg;
    using Limits = std::numeric_limits<double>;
    for (const double x :
         {-0., Limits::denorm_min(), -Limits::min(), Limits::max(), 0.1, 1e23, 9007199254740993.})
      pslg.add_vertex(Point(x, -x));
    for (int i = 0; i < 20000; ++i) pslg.add_vertex(Point(any_double(), any_double()));
    CGAL::IO::write_triangle_poly(name, pslg);
    CGAL::IO::read_triangle_poly(name, back);
    CHECK(have_same_bits(pslg, back));
  }
}

TEST_CASE("the locale does not matter", "[triangle_files]") {
  const Scratch_folder folder;
  const std::locale odd(std::locale::classic(), new Odd_punctuation);
  const std::locale before = std::locale::global(odd);
  Pslg pslg, back;
  const std::string error = error_of([&] {
    pslg = parse(full_example);
    CGAL::IO::write_triangle_poly(folder.file("x.poly"), pslg);
    CGAL::IO::read_triangle_poly(folder.file("x.poly"), back);
  });
  std::locale::global(before);
  CHECK(error.empty());
  CHECK(pslg.vertices.at(4) == Point(1, 0.5));
  CHECK(have_same_bits(pslg, back));
}

TEST_CASE("a mesh is written as .node, .ele and .poly", "[triangle_files]") {
  const Scratch_folder folder;
  Small_mesh small;
  const std::string stem = folder.file("out");
  SECTION("of a plain graph: 1 marks the border") {
    small.set_markers();
    CGAL::IO::write_triangle_files(small.mesh, small.pslg, stem);
    CHECK(content(stem + ".node") == "6 2 0 1\n0 0 0 1\n1 1 0 1\n2 1 1 1\n3 0 1 1\n4 9 9 0\n5 0.5 1 1\n");
    CHECK(content(stem + ".ele") == "3 3 0\n0 0 1 5\n1 1 2 5\n2 0 5 3\n");
    CHECK(content(stem + ".poly") == "0 2 0 1\n5 0\n0 0 1\n1 1 2\n2 2 5\n3 5 3\n4 3 0\n0\n");
  }
  SECTION("of a graph with markers, holes and regions") {
    small.pslg.vertex_markers = {0, 21, 0, 0, 24};
    small.pslg.segment_markers = {0, 11, 12, 13};
    small.pslg.holes = {Point(5, 0.125)};
    small.pslg.regions = {{Point(0.5, 0.5), 7.5, 0}, {Point(0.25, 0.5), 8, 0.5}};
    small.mesh.region_of_triangle = {0, -1, 1};
    small.set_markers();
    CGAL::IO::write_triangle_files(small.mesh, small.pslg, stem);
    CHECK(content(stem + ".node") ==
          "6 2 0 1\n0 0 0 13\n1 1 0 21\n2 1 1 11\n3 0 1 12\n4 9 9 24\n5 0.5 1 12\n");
    CHECK(content(stem + ".ele") == "3 3 1\n0 0 1 5 7.5\n1 1 2 5 0\n2 0 5 3 8\n");
    CHECK(content(stem + ".poly") == "0 2 0 1\n5 1\n0 0 1 0\n1 1 2 11\n2 2 5 12\n3 5 3 12\n4 3 0 13\n"
                                     "1\n0 5 0.125\n2\n0 0.5 0.5 7.5 -1\n1 0.25 0.5 8 0.5\n");
  }
  SECTION("of a graph whose owner counts from 1") {
    small.pslg.first_number = 1;
    small.pslg.holes = {Point(5, 0.125)};
    small.pslg.regions = {{Point(0.5, 0.5), 7.5, 0}};
    small.set_markers();
    CGAL::IO::write_triangle_files(small.mesh, small.pslg, stem);
    CHECK(content(stem + ".node") == "6 2 0 1\n1 0 0 1\n2 1 0 1\n3 1 1 1\n4 0 1 1\n5 9 9 0\n6 0.5 1 1\n");
    CHECK(content(stem + ".ele") == "3 3 0\n1 1 2 6\n2 2 3 6\n3 1 6 4\n");
    CHECK(content(stem + ".poly") ==
          "0 2 0 1\n5 0\n1 1 2\n2 2 3\n3 3 6\n4 6 4\n5 4 1\n1\n1 5 0.125\n1\n1 0.5 0.5 7.5 -1\n");
    Mesh mesh;
    CGAL::IO::read_triangle_files(stem, mesh);
    CHECK(mesh.triangles == small.mesh.triangles);
    Pslg pslg;
    CGAL::IO::read_triangle_poly(stem + ".poly", pslg);
    CHECK(pslg.first_number == 1);
    CHECK(pslg.segments.front() == small.pslg.segments.front());
  }
  SECTION("and comes back") {
    CGAL::IO::write_triangle_files(small.mesh, small.pslg, stem);
    Mesh mesh;
    CGAL::IO::read_triangle_files(stem, mesh);
    CHECK(mesh.points == small.mesh.points);
    CHECK(mesh.triangles == small.mesh.triangles);
    Pslg pslg;
    CGAL::IO::read_triangle_poly(stem + ".poly", pslg);
    CHECK(pslg.number_of_vertices() == 6);
    CHECK(pslg.number_of_segments() == 5);
    std::ofstream(stem + ".ele") << "1 3 0\n0 0 1 6\n";
    CHECK(has_text(error_of([&] { CGAL::IO::read_triangle_files(stem, mesh); }),
                   "out.ele:2: a node of triangle 0"));
    std::ofstream(stem + ".ele") << "1 6 0\n0 0 1 2 3 4 5\n";
    CHECK(has_text(error_of([&] { CGAL::IO::read_triangle_files(stem, mesh); }), "6 nodes instead of 3"));
    CHECK(mesh.triangles == small.mesh.triangles);
  }
  SECTION("one file at a time") {
    CGAL::IO::write_triangle_node(folder.file("a"), small.mesh);
    CGAL::IO::write_triangle_ele(folder.file("b"), small.mesh, small.pslg);
    CGAL::IO::write_triangle_poly(folder.file("c"), small.mesh, small.pslg);
    CGAL::IO::write_triangle_files(small.mesh, small.pslg, stem);
    CHECK(content(folder.file("a")) == content(stem + ".node"));
    CHECK(content(folder.file("b")) == content(stem + ".ele"));
    CHECK(content(folder.file("c")) == content(stem + ".poly"));
  }
}

TEST_CASE("a write that fails leaves old files and no rubbish", "[triangle_files]") {
  const Scratch_folder folder;
  const Small_mesh small;
  const std::string stem = folder.file("out");
  const auto error = [&](const std::string& name) {
    try {
      CGAL::IO::write_triangle_files(small.mesh, small.pslg, name);
    } catch (const std::system_error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(has_text(error(folder.file("no/such/folder")),
                 folder.file("no/such/folder.node") + ": cannot be written"));

  folder.write("out.node", "old");
  std::filesystem::create_directory(stem + ".ele"); // in the way of the second file
  CHECK(has_text(error(stem), "out.ele: cannot be written"));
  CHECK(content(stem + ".node") == "old");
  CHECK(folder.number_of_files() == 2);

  std::filesystem::remove(stem + ".ele");
  CHECK(error(stem).empty());
  CHECK(content(stem + ".node") != "old");
  CHECK(folder.number_of_files() == 3);

  if (std::filesystem::exists("/dev/full"))
    CHECK_THROWS_AS(CGAL::IO::write_triangle_poly("/dev/full", small.pslg), std::system_error);
}

TEST_CASE("a symbolic link stays one when its file is replaced", "[triangle_files]") {
  const Scratch_folder folder;
  std::error_code error;
  std::filesystem::create_symlink(folder.write("target.poly", "old"), folder.file("link.poly"), error);
  if (error) return; // not every file system has them
  CGAL::IO::write_triangle_poly(folder.file("link.poly"), unit_square());
  CHECK(std::filesystem::is_symlink(folder.file("link.poly")));
  CHECK(content(folder.file("target.poly")).substr(0, 7) == "4 2 0 0");
}

} // namespace test_written_triangle_files
