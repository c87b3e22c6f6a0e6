// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "point_sets.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/Triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/indexed_mesh_to_triangulation_2.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_point_mesh_to_triangulation {

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Indexed_mesh_2<Epick::Point_2>;
using Options = CGAL::Point_set_mesh_options_2;
using Domain = Options::Domain;
using CGAL::Quadtree_mesh_2::Vertex_index;

template <class Kernel, class Info>
using Tds_with_info =
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<Info, Kernel>>;

Mesh mesh_of(const point_sets::Points& points, const Options& options) {
  return CGAL::Point_set_mesher_2<>(Options(options).effort(1))(points);
}

/// With the same coordinates.
CGAL::Indexed_mesh_2<Epeck::Point_2> exact(const Mesh& mesh) {
  CGAL::Indexed_mesh_2<Epeck::Point_2> result;
  result.number_of_input_vertices = mesh.number_of_input_vertices;
  for (const auto& p : mesh.points) result.points.emplace_back(p.x(), p.y());
  result.triangles = mesh.triangles;
  result.neighbors = mesh.neighbors;
  result.segment_of_vertex = mesh.segment_of_vertex;
  return result;
}

template <class Mesh>
std::size_t number_of_used_vertices(const Mesh& mesh) {
  std::vector<char> is_used(mesh.points.size(), 0);
  for (const auto& t : mesh.triangles)
    for (const auto v : t) is_used[std::size_t(v)] = 1;
  std::size_t n = 0;
  for (const char u : is_used) n += u != 0 ? 1 : 0;
  return n;
}

/// The number of faces that are no triangles of the mesh, after a check that those of the mesh are there.
template <class Triangulation, class Mesh>
std::size_t number_of_pockets(const Triangulation& triangulation, const Mesh& mesh) {
  CHECK(triangulation.is_valid());
  CHECK(triangulation.number_of_vertices() == number_of_used_vertices(mesh));
  REQUIRE(triangulation.number_of_faces() >= mesh.triangles.size());
  std::size_t t = 0, wrong = 0;
  for (const auto f : triangulation.finite_face_handles()) {
    if (t == mesh.triangles.size()) break;
    for (int k = 0; k < 3; ++k)
      wrong += f->vertex(k)->point() == mesh.point(mesh.triangles[t][std::size_t(k)]) ? 0 : 1;
    ++t;
  }
  CHECK(wrong == 0);
  return triangulation.number_of_faces() - mesh.triangles.size();
}

template <class Triangulation, class Mesh>
std::size_t convert(const Mesh& mesh) {
  Triangulation triangulation;
  triangulation.insert(typename Triangulation::Point(3, 4)); // to be forgotten
  CGAL::indexed_mesh_to_triangulation_2(mesh, triangulation);
  return number_of_pockets(triangulation, mesh);
}

template <class Triangulation, class Mesh>
void require_indices(const Mesh& mesh) {
  Triangulation triangulation;
  CGAL::indexed_mesh_to_triangulation_2(mesh, triangulation);
  for (const auto v : triangulation.finite_vertex_handles())
    REQUIRE(mesh.points[std::size_t(v->info())] == v->point());
}

std::vector<point_sets::Named_points> inputs() {
  return {{"one", {{0.25, 4}}},
          {"uniform", quadtree_inputs::uniform(40, 1)},
          {"line", quadtree_inputs::line(60, 2)},
          {"duplicates", point_sets::duplicates(40, 3)},
          {"circle", point_sets::circle(40)},
          {"far from the origin", point_sets::moved(quadtree_inputs::uniform(30, 4), 1e-3, 1e6, -1e6)}};
}

} // namespace

TEST_CASE("Meshes of points become Delaunay triangulations", "[indexed_mesh_to_triangulation_2]") {
  std::size_t pockets = 0;
  for (const auto& input : inputs())
    for (const Options& options : {Options().bounded_angles(), Options().acute(),
                                   Options().bounded_angles().mesh_domain(Domain::SQUARE)}) {
      CAPTURE(input.name);
      const Mesh mesh = mesh_of(input.points, options);
      const std::size_t n = convert<CGAL::Delaunay_triangulation_2<Epick>>(mesh);
      CHECK(convert<CGAL::Triangulation_2<Epick>>(mesh) == n);
      CHECK(convert<CGAL::Delaunay_triangulation_2<Epeck>>(exact(mesh)) == n);
      const bool is_row =
          options.mode() == Options::Mode::BOUNDED_ANGLES && options.mesh_domain() == Domain::ROW;
      if (!is_row) CHECK(n == 0);
      pockets += n;
    }
  CHECK(pockets > 0); // rows of doubles have some
}

TEST_CASE("Meshes of points with blunt angles become triangulations", "[indexed_mesh_to_triangulation_2]") {
  for (const auto& input : inputs()) {
    CAPTURE(input.name);
    CHECK(convert<CGAL::Triangulation_2<Epick>>(mesh_of(input.points, Options().least_angle())) == 0);
    const Mesh warped = mesh_of(input.points, Options().warped_squares());
    CHECK(convert<CGAL::Triangulation_2<Epick>>(warped) == 0);
    CHECK(convert<CGAL::Triangulation_2<Epeck>>(exact(warped)) == 0);
  }
}

TEST_CASE("Vertices of triangulations know their indices in meshes", "[indexed_mesh_to_triangulation_2]") {
  for (const auto& input : inputs()) {
    const Mesh mesh = mesh_of(input.points, Options().bounded_angles());
    require_indices<CGAL::Delaunay_triangulation_2<Epick, Tds_with_info<Epick, std::uint32_t>>>(mesh);
    require_indices<CGAL::Triangulation_2<Epick, Tds_with_info<Epick, Vertex_index>>>(mesh);
    require_indices<CGAL::Delaunay_triangulation_2<Epeck, Tds_with_info<Epeck, Vertex_index>>>(exact(mesh));
  }
}

TEST_CASE("Triangulations of meshes of points are like any other", "[indexed_mesh_to_triangulation_2]") {
  const Mesh mesh = mesh_of(quadtree_inputs::uniform(40, 1), Options().bounded_angles());
  CGAL::Delaunay_triangulation_2<Epick> triangulation;
  CGAL::indexed_mesh_to_triangulation_2(mesh, triangulation);
  for (const auto& p : quadtree_inputs::uniform(30, 5)) triangulation.insert(p);
  triangulation.insert(Epick::Point_2(100, 100));
  CHECK(triangulation.is_valid());
  CHECK(triangulation.locate(Epick::Point_2(0.5, 0.5)) != nullptr);
  CGAL::indexed_mesh_to_triangulation_2(Mesh(), triangulation);
  CHECK(triangulation.number_of_vertices() == 0);
  CHECK(triangulation.is_valid());
  triangulation.insert(Epick::Point_2(1, 1));
  CHECK(triangulation.number_of_vertices() == 1);
}

TEST_CASE("Pockets along a border that is straight up to rounding are filled",
          "[indexed_mesh_to_triangulation_2]") {
  // A fan of acute triangles around the origin, with vertices on the way from corner to corner.
  Mesh mesh;
  const point_sets::Points ring{{1, 0},     {0.9, 0.5}, {0.45, 0.95}, {0, 1},     {-0x1p-1, 0.875 - 0x1p-40},
                                {-1, 0.75}, {-1, -0.5}, {-0.3, -1},   {0.5, -0.8}};
  mesh.points = ring;
  mesh.points.emplace_back(0, 0);
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    mesh.triangles.push_back({Vertex_index(i), Vertex_index((i + 1) % n), Vertex_index(n)});
    using CGAL::Quadtree_mesh_2::Triangle_index;
    mesh.neighbors.push_back(
        {Triangle_index((i + 1) % n), Triangle_index((i + n - 1) % n), Triangle_index()});
  }
  CHECK(convert<CGAL::Delaunay_triangulation_2<Epick>>(mesh) == 1);
  CHECK(convert<CGAL::Delaunay_triangulation_2<Epeck>>(exact(mesh)) == 1);
}

} // namespace test_point_mesh_to_triangulation
