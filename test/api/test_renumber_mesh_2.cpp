// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes in the order of places: the same mesh, in an order that does not depend on the one before.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "pslg_inputs.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/renumber_mesh_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_renumber_mesh_2 {

using namespace test_meshes;

namespace {

struct Example {
  Pslg pslg;
  Mesh mesh;
};

/// With holes, regions, markers, a vertex outside, and two input vertices at one place.
Example example() {
  Example e;
  add_polygon(e.pslg, square(0, 0, 2));
  add_polygon(e.pslg, square(0.1, 0, 1));
  add_polygon(e.pslg, square(7, 0.3, 1));
  e.pslg.holes.push_back(Point(0, 0));
  e.pslg.add_vertex(Point(9, 0.3));
  e.pslg.add_vertex(e.pslg.vertices[2]);
  e.pslg.regions = {{Point(7, 0), 0.1, 0}, {Point(1.5, 1.5), -7, 0}};
  for (std::size_t s = 0; s < e.pslg.segments.size(); ++s) e.pslg.segment_markers.push_back(int(s % 4));
  e.mesh = CGAL::Quality_mesher_2<>(CGAL::Quality_mesh_options_2().max_area(0.02))(e.pslg);
  return e;
}

Example coast() {
  Example e;
  e.pslg = pslg_inputs::by_name("coast:3e4").pslg;
  e.mesh = CGAL::Quality_mesher_2<>()(e.pslg);
  return e;
}

bool are_equal(const Mesh& a, const Mesh& b) {
  const auto is_same_edge = [](const auto& e, const auto& f) {
    return e.vertices == f.vertices && e.segment == f.segment && e.marker == f.marker &&
           e.outer_vertex == f.outer_vertex;
  };
  return a.number_of_input_vertices == b.number_of_input_vertices && a.points == b.points &&
         a.triangles == b.triangles && a.neighbors == b.neighbors &&
         std::equal(a.constrained_edges.begin(), a.constrained_edges.end(), b.constrained_edges.begin(),
                    b.constrained_edges.end(), is_same_edge) &&
         a.region_of_triangle == b.region_of_triangle && a.segment_of_vertex == b.segment_of_vertex &&
         a.vertex_markers == b.vertex_markers && a.input_index == b.input_index;
}

/// The mesh with Steiner vertices, triangles, their first vertices and edges in any order.
Mesh in_other_order(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  const auto permutation = [&](std::size_t first, std::size_t n) { // new numbers; those before the first stay
    std::vector<std::size_t> numbers(n);
    std::iota(numbers.begin(), numbers.end(), std::size_t(0));
    std::shuffle(numbers.begin() + std::ptrdiff_t(first), numbers.end(), random);
    return numbers;
  };
  const auto vertex = permutation(mesh.number_of_input_vertices, mesh.points.size()),
             triangle = permutation(0, mesh.triangles.size());
  const auto new_vertex = [&](Vertex_index v) {
    return v.is_valid() ? Vertex_index(vertex[std::size_t(v)]) : v;
  };
  Mesh result = mesh;
  for (std::size_t v = 0; v < vertex.size(); ++v) {
    result.points[vertex[v]] = mesh.points[v];
    result.segment_of_vertex[vertex[v]] = mesh.segment_of_vertex[v];
    result.vertex_markers[vertex[v]] = mesh.vertex_markers[v];
  }
  for (std::size_t t = 0; t < triangle.size(); ++t) {
    const std::size_t turn = random() % 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle_index across = mesh.neighbors[t][(k + turn) % 3];
      result.triangles[triangle[t]][k] = new_vertex(mesh.triangles[t][(k + turn) % 3]);
      result.neighbors[triangle[t]][k] =
          across.is_valid() ? Triangle_index(triangle[std::size_t(across)]) : across;
    }
    if (!mesh.region_of_triangle.empty()) result.region_of_triangle[triangle[t]] = mesh.region_of_triangle[t];
  }
  for (auto& e : result.constrained_edges) {
    for (Vertex_index& v : e.vertices) v = new_vertex(v);
    e.outer_vertex = new_vertex(e.outer_vertex);
  }
  std::shuffle(result.constrained_edges.begin(), result.constrained_edges.end(), random);
  return result;
}

} // namespace

TEST_CASE("the order of places does not depend on the order before, nor on threads", "[renumber]") {
  for (const Example& e : {example(), coast()}) {
    Mesh mesh = e.mesh;
    CGAL::renumber_by_place(mesh);
    CHECK_FALSE(are_equal(mesh, e.mesh));
    Mesh in_parallel = e.mesh;
    CGAL::renumber_by_place<CGAL::Parallel_tag>(in_parallel);
    CHECK(are_equal(in_parallel, mesh));
    for (const unsigned seed : {1u, 2u, 3u}) {
      Mesh other = in_other_order(e.mesh, seed);
      CGAL::renumber_by_place<CGAL::Parallel_tag>(other);
      CHECK(are_equal(other, mesh));
    }
    Mesh again = mesh;
    CGAL::renumber_by_place(again);
    CHECK(are_equal(again, mesh));
  }
}

TEST_CASE("a renumbered mesh is the same mesh, and says where its input is", "[renumber]") {
  for (const Example& e : {example(), coast()}) {
    Mesh mesh = e.mesh;
    const CGAL::Mesh_renumbering_2 numbers = CGAL::renumber_by_place(mesh);
    REQUIRE(numbers.new_vertex.size() == mesh.points.size());
    REQUIRE(numbers.new_triangle.size() == mesh.triangles.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const auto w = std::size_t(numbers.new_vertex[v]);
      REQUIRE(mesh.points[w] == e.mesh.points[v]);
      REQUIRE(mesh.input_index[w] ==
              (v < e.mesh.number_of_input_vertices ? Vertex_index(v) : Vertex_index()));
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      std::array<Vertex_index, 3> expected = e.mesh.triangles[t];
      for (Vertex_index& v : expected) v = numbers.new_vertex[std::size_t(v)];
      std::rotate(expected.begin(), std::min_element(expected.begin(), expected.end()), expected.end());
      REQUIRE(mesh.triangles[std::size_t(numbers.new_triangle[t])] == expected);
    }
    const auto wrong = CGAL::mesh_quality_2(mesh, e.pslg);
    CHECK_FALSE(wrong.is_valid());
    CHECK(wrong.errors.front().find("renumber_by_input()") != std::string::npos);

    const auto new_vertex = CGAL::renumber_by_input(mesh);
    CHECK(new_vertex.size() == mesh.points.size());
    CHECK(mesh.input_index.empty());
    const auto quality = CGAL::mesh_quality_2(mesh, e.pslg);
    for (const std::string& error : quality.errors) UNSCOPED_INFO(error);
    CHECK(quality.is_valid());
    CHECK(quality.min_angle == Approx(CGAL::mesh_quality_2(e.mesh, e.pslg).min_angle));
    CHECK(CGAL::renumber_by_input(mesh).empty());
  }
}

TEST_CASE("vertices are in shuffle order, triangles and edges by their vertices", "[renumber]") {
  Mesh mesh = coast().mesh;
  CGAL::renumber_by_place(mesh);
  const auto grid = CGAL::Filtered_quadtree_traits_2<>().construct_grid_2_object()(mesh.points);
  for (std::size_t v = 1; v < mesh.points.size(); ++v)
    REQUIRE_FALSE(CGAL::Quadtree_mesh_2::internal::less_shuffle(grid.grid_point(mesh.points[v]),
                                                                grid.grid_point(mesh.points[v - 1])));
  for (const auto& t : mesh.triangles) REQUIRE(*std::min_element(t.begin(), t.end()) == t[0]);
  CHECK(std::is_sorted(mesh.triangles.begin(), mesh.triangles.end()));
  CHECK(std::is_sorted(mesh.constrained_edges.begin(), mesh.constrained_edges.end(),
                       [](const auto& e, const auto& f) {
                         const auto [a, b] = std::minmax(e.vertices[0], e.vertices[1]);
                         const auto [c, d] = std::minmax(f.vertices[0], f.vertices[1]);
                         return std::pair(a.value(), b.value()) < std::pair(c.value(), d.value());
                       }));
}

TEST_CASE("reports follow their triangles", "[renumber]") {
  Example e;
  add_polygon(e.pslg, {Point(0, 0), Point(1, 0), Point(1, 0.01)}); // an acute corner is exempt
  add_polygon(e.pslg, square(3, 3, 1));
  CGAL::Quality_mesher_2<> mesher(CGAL::Quality_mesh_options_2().max_area(0.001).max_vertices(2000));
  Mesh mesh = mesher(e.pslg);
  CGAL::Quality_mesh_report_2 report = mesher.report();
  REQUIRE_FALSE(report.unmet_triangles.empty());
  const Mesh before = mesh;
  const CGAL::Quality_mesh_report_2 report_before = report;
  CGAL::renumber_by_place(mesh).renumber(report);
  const auto place = [](const Mesh& m, Triangle_index index) {
    const auto& t = m.triangles[std::size_t(index)];
    std::array<Point, 3> places{m.point(t[0]), m.point(t[1]), m.point(t[2])};
    std::sort(places.begin(), places.end());
    return places;
  };
  for (std::size_t i = 0; i < report.unmet_triangles.size(); ++i)
    CHECK(place(mesh, report.unmet_triangles[i].triangle) ==
          place(before, report_before.unmet_triangles[i].triangle));
  for (std::size_t i = 0; i < report.exempt_triangles.size(); ++i)
    CHECK(place(mesh, report.exempt_triangles[i].triangle) ==
          place(before, report_before.exempt_triangles[i].triangle));
}

TEST_CASE("places of all kinds can be put in order", "[renumber]") {
  Mesh none;
  CHECK(CGAL::renumber_by_place(none).new_vertex.empty());
  Mesh one;
  one.points = {Point(3, 4)};
  one.number_of_input_vertices = 1;
  CGAL::renumber_by_place(one);
  CHECK(one.input_index == std::vector<Vertex_index>{Vertex_index(0)});

  // Largest, least and equal doubles: whatever the order before, equal ones in that of the input.
  std::vector<Point> points;
  for (const double x : {-1.7e308, -5e-324, 0., 5e-324, 1e-300, 1., 1.7e308})
    for (const double y : {-1e308, 0., 5e-324, 1e308})
      points.push_back(Point(x, y)), points.push_back(Point(x, y));
  Mesh first;
  first.points = points;
  first.number_of_input_vertices = points.size();
  CGAL::renumber_by_place(first);
  for (std::size_t v = 1; v < points.size(); v += 2) {
    CHECK(first.points[v] == first.points[v - 1]);
    CHECK(first.input_index[v - 1] < first.input_index[v]);
  }
  std::mt19937 random(7);
  std::shuffle(points.begin(), points.end(), random);
  Mesh second;
  second.points = points; // Steiner vertices
  CGAL::renumber_by_place(second);
  CHECK(second.points == first.points);
}

TEST_CASE("exact numbers that doubles cannot tell are put in order", "[renumber]") {
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  CGAL::Indexed_mesh_2<Exact::Point_2> mesh;
  const Exact::FT third = Exact::FT(1) / 3, less = third - Exact::FT(1e-40);
  mesh.points = {{third, 1}, {less, 1}, {0, 0}, {third, third}, {third, less}};
  CGAL::renumber_by_place(mesh);
  const auto place_of = [&](const Exact::Point_2& p) {
    return std::find(mesh.points.begin(), mesh.points.end(), p) - mesh.points.begin();
  };
  CHECK(place_of({less, 1}) + 1 == place_of({third, 1}));
  CHECK(place_of({third, less}) + 1 == place_of({third, third}));
}

} // namespace test_renumber_mesh_2
