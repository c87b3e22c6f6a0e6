// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "mesh_from_cdt.h"

#include <CGAL/indexed_mesh_to_triangulation_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>
#include <set>
#include <vector>

namespace test_indexed_mesh_to_triangulation_2 {

using namespace test_meshes;

namespace {

Info_cdt convert(const Mesh& mesh, const Pslg& pslg) {
  Info_cdt cdt;
  CGAL::indexed_mesh_to_constrained_Delaunay_triangulation_2(mesh, pslg, cdt);
  REQUIRE(cdt.is_valid());
  return cdt;
}

template <class Triangulation>
std::size_t number_of_constrained_edges(const Triangulation& cdt) {
  return std::size_t(std::distance(cdt.constrained_edges_begin(), cdt.constrained_edges_end()));
}

template <class Triangulation>
std::size_t number_in_domain(const Triangulation& cdt) {
  std::size_t n = 0;
  for (auto f : cdt.finite_face_handles()) n += f->is_in_domain();
  return n;
}

/// The edges as pairs of points.
template <class Triangulation>
std::set<std::pair<Point, Point>> edges(const Triangulation& cdt, bool only_constrained) {
  std::set<std::pair<Point, Point>> result;
  for (auto e : cdt.finite_edges()) {
    const Point p = e.first->vertex(cdt.cw(e.second))->point(),
                q = e.first->vertex(cdt.ccw(e.second))->point();
    if (!only_constrained || cdt.is_constrained(e)) result.insert(std::minmax(p, q));
  }
  return result;
}

/// Meshes the input by CGAL, converts to arrays and back, and compares with what CGAL had.
void require_round_trip(const Pslg& pslg, double size) {
  const Cdt expected = triangulate(pslg, size);
  const Mesh mesh = mesh_from_cdt(expected, pslg);
  const auto quality = CGAL::mesh_quality_2(mesh, pslg);
  INFO(quality);
  REQUIRE(quality.is_valid());
  Info_cdt cdt = convert(mesh, pslg);
  CHECK(number_in_domain(cdt) == number_in_domain(expected));
  // Mesh_2 splits segments outside the domain as well, which we leave in one piece.
  std::set<Point> ours, theirs;
  for (auto v : cdt.finite_vertex_handles()) ours.insert(v->point());
  for (auto v : expected.finite_vertex_handles()) theirs.insert(v->point());
  CHECK(std::includes(theirs.begin(), theirs.end(), ours.begin(), ours.end()));
  if (ours == theirs) {
    CHECK(cdt.number_of_faces() == expected.number_of_faces());
    CHECK((edges(cdt, true) == edges(expected, true)));
  } else {
    CHECK(size > 0);
    CHECK(number_of_constrained_edges(cdt) ==
          number_of_constrained_edges(expected) - (theirs.size() - ours.size()));
  }
  for (auto v : cdt.finite_vertex_handles()) CHECK(mesh.point(v->info()) == v->point());
  cdt.insert(Point(0.0123, 0.0456)); // it is a triangulation like any other
  CHECK(cdt.is_valid());
}

} // namespace

TEST_CASE("one triangle becomes a triangulation", "[indexed_mesh_to_triangulation_2]") {
  Pslg pslg;
  add_polygon(pslg, {Point(0, 0), Point(1, 0), Point(0, 1)});
  const Info_cdt cdt = convert(mesh_of(pslg), pslg);
  CHECK(cdt.number_of_vertices() == 3);
  CHECK(cdt.number_of_faces() == 1);
  CHECK(number_of_constrained_edges(cdt) == 3);
  require_round_trip(pslg, 0.2);
}

TEST_CASE("holes, islands, pockets, dangling segments and isolated vertices",
          "[indexed_mesh_to_triangulation_2]") {
  Pslg pslg;
  add_polygon(pslg, {Point(-5, -4), Point(4, -4.5), Point(0.5, 3), Point(4, 5), Point(-4, 4)});
  add_polygon(pslg, square(-1, -1, 1.5));
  add_polygon(pslg, square(-1, -1, 0.5));
  pslg.holes.push_back(Point(-2, -1));
  SECTION("plain") {}
  SECTION("an isolated vertex in the hole") { pslg.add_vertex(Point(-2.1, -0.9)); }
  SECTION("a segment in the hole and one across it") {
    pslg.add_vertex(Point(-2.1, -0.9));
    pslg.add_vertex(Point(-1.9, -0.9));
    add_segment(pslg, 13, 14);
    add_segment(pslg, 6, 10);
  }
  SECTION("a segment in the domain and an isolated vertex") {
    pslg.add_vertex(Point(-3, 0));
    pslg.add_vertex(Point(-3.5, 2));
    add_segment(pslg, 13, 14);
    pslg.add_vertex(Point(-3.5, -3));
  }
  SECTION("vertices and segments far outside, one from the hull to there") {
    pslg.add_vertex(Point(8, 8));
    pslg.add_vertex(Point(9, -8));
    add_segment(pslg, 13, 14);
    add_segment(pslg, 1, 14);
  }
  SECTION("a segment from outside that goes on inside") {
    pslg.add_vertex(Point(-7, 0));
    pslg.add_vertex(Point(-3, 0));
    const double y = 0; // the border is x = -4.5 there
    pslg.add_vertex(Point(-4.5, y));
    pslg.segments[4] = {Vertex_index(4), Vertex_index(15)};
    add_segment(pslg, 15, 0);
    add_segment(pslg, 13, 14);
  }
  SECTION("duplicates and overlaps") {
    pslg.add_vertex(Point(-5, -4));
    pslg.add_vertex(Point(-2.5, -2.5));
    add_segment(pslg, 13, 1);
    add_segment(pslg, 14, 6);
    pslg.add_vertex(Point(-2, -1.25));
    pslg.add_vertex(Point(-2, -1.25));
  }
  for (double size : {0., 0.6}) require_round_trip(pslg, size);
}

TEST_CASE("components that touch in a vertex or are apart", "[indexed_mesh_to_triangulation_2]") {
  Pslg pslg;
  add_polygon(pslg, square(-1, -1, 1));
  for (const Point& p : {Point(2, 0), Point(2, 2), Point(0, 2)}) pslg.add_vertex(p);
  for (auto e : {std::array<std::size_t, 2>{2, 4}, {4, 5}, {5, 6}, {6, 2}}) add_segment(pslg, e[0], e[1]);
  add_polygon(pslg, square(7, 3, 1));
  add_polygon(pslg, {Point(7, 3), Point(7.5, 3), Point(7.25, 3.5)}); // a hole ...
  add_polygon(
      pslg, {Point(7, 3), Point(6.5, 3), Point(6.75, 2.5)}); // ... that touches another in a duplicate vertex
  pslg.holes = {Point(7.25, 3.1), Point(6.75, 2.9)};
  for (double size : {0., 0.4}) require_round_trip(pslg, size);
}

TEST_CASE("border vertices an ulp off a slanted hull edge", "[indexed_mesh_to_triangulation_2]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int round = 0; round < 20; ++round) {
    Pslg pslg;
    std::vector<Point> corners;
    while (corners.size() < 3 || CGAL::orientation(corners[0], corners[1], corners[2]) != CGAL::LEFT_TURN) {
      corners.clear();
      for (int i = 0; i < 3; ++i) corners.emplace_back(coordinate(random), coordinate(random));
    }
    add_polygon(pslg, corners);
    // Vertices along the border, rounded to doubles: some inside the straight line, some outside it.
    const Point center = CGAL::centroid(corners[0], corners[1], corners[2]);
    Pslg rounded;
    std::vector<Point> ring;
    const std::size_t pieces = 6;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < pieces; ++j) {
        const Point &p = corners[i], &q = corners[(i + 1) % 3];
        const double t = double(j) / double(pieces);
        ring.emplace_back(j == 0 ? p.x() : p.x() + t * (q.x() - p.x()),
                          j == 0 ? p.y() : p.y() + t * (q.y() - p.y()));
      }
    add_polygon(rounded, ring);
    rounded.add_vertex(center);
    Mesh mesh = mesh_of(rounded);
    mesh.number_of_input_vertices = 3;
    const auto place = [&](std::size_t v) {
      return v == 18 ? 18 : v % pieces == 0 ? v / pieces : v - v / pieces + 2;
    };
    std::vector<Point> points(mesh.points.size());
    for (std::size_t v = 0; v < points.size(); ++v) points[place(v)] = mesh.points[v];
    mesh.points = points;
    for (auto& t : mesh.triangles)
      for (auto& v : t) v = Vertex_index(place(std::size_t(v)));
    mesh.segment_of_vertex.assign(mesh.points.size(), Segment_index());
    for (auto& e : mesh.constrained_edges) {
      e.segment = Segment_index(std::size_t(e.segment) / pieces);
      for (auto& v : e.vertices) {
        v = Vertex_index(place(std::size_t(v)));
        if (std::size_t(v) >= 3) mesh.segment_of_vertex[std::size_t(v)] = e.segment;
      }
    }
    const auto quality = CGAL::mesh_quality_2(mesh, pslg);
    INFO(quality);
    CHECK(quality.is_valid());
    const Info_cdt cdt = convert(mesh, pslg);
    CHECK(number_in_domain(cdt) == mesh.triangles.size());
    CHECK(cdt.number_of_faces() >= mesh.triangles.size());
    CHECK(number_of_constrained_edges(cdt) == 3 * pieces);
  }
}

TEST_CASE("segments of components that are not meshed", "[indexed_mesh_to_triangulation_2]") {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 4));
  for (const Point& p :
       {Point(0, -4), Point(0, 4), Point(-4, 1), Point(-2, 1), Point(0, 1), Point(2, 1), Point(3, 1)})
    pslg.add_vertex(p);
  add_segment(pslg, 4, 5);  // halves the square
  add_segment(pslg, 6, 9);  // goes through both halves
  add_segment(pslg, 9, 10); // is in the right half
  for (const bool is_left : {true, false}) {
    // the mesh of one half, in the indices of the whole
    Pslg half = pslg;
    half.holes.push_back(is_left ? Point(1, 0) : Point(-1, 0));
    const Mesh mesh = mesh_of(half, 0.7);
    const Info_cdt cdt = convert(mesh, pslg); // which knows nothing of the hole
    CHECK(number_in_domain(cdt) == mesh.triangles.size());
    double length = 0;
    for (auto e : cdt.constrained_edges()) length += std::sqrt(cdt.segment(e).squared_length());
    CHECK(length == Approx(32 + 8 + 6 + 1));
  }
}

TEST_CASE("inputs without a domain", "[indexed_mesh_to_triangulation_2]") {
  Pslg pslg;
  CHECK(convert(Mesh(), pslg).number_of_vertices() == 0);
  for (double x : {0., 1., 3., 1.}) pslg.add_vertex(Point(x, 2 * x));
  add_segment(pslg, 0, 2);
  Mesh mesh;
  mesh.number_of_input_vertices = 4;
  mesh.points = pslg.vertices;
  CHECK(convert(mesh, pslg).number_of_vertices() == 3);
  pslg.add_vertex(Point(1, 0));
  mesh.points = pslg.vertices;
  const Info_cdt cdt = convert(mesh, pslg);
  CHECK(cdt.number_of_vertices() == 4);
  CHECK(number_in_domain(cdt) == 0);
  CHECK(number_of_constrained_edges(cdt) == 2);
}

TEST_CASE("vertices without info and a triangulation that was in use", "[indexed_mesh_to_triangulation_2]") {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 1));
  Cdt cdt = triangulate(pslg, 0.1);
  const Mesh mesh = mesh_of(pslg, 0.5);
  CGAL::indexed_mesh_to_constrained_Delaunay_triangulation_2(mesh, pslg, cdt);
  CHECK(cdt.is_valid());
  CHECK(cdt.number_of_faces() == mesh.triangles.size());
}

TEST_CASE("a triangulation becomes a graph", "[indexed_mesh_to_triangulation_2]") {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 2));
  add_polygon(pslg, square(0, 0, 1));
  pslg.add_vertex(Point(1.5, 0));
  pslg.holes.push_back(Point(0, 0));
  const Cdt cdt = triangulate(pslg);
  const Pslg again = CGAL::pslg_from_triangulation_2(cdt, pslg.holes);
  CHECK(again.vertices.size() == 9);
  CHECK(again.segments.size() == 8);
  CHECK(again.holes == pslg.holes);
  CHECK(edges(triangulate(again), true) == edges(cdt, true));
  CHECK(CGAL::pslg_from_triangulation_2(cdt).holes.empty());
}

} // namespace test_indexed_mesh_to_triangulation_2
