// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "adapt_tools.h"
#include "random_pslg_shapes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Given_mesh_checker.h>
#include <CGAL/Quadtree_mesh_2/internal/base/compat.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/triangle_neighbors.h>
#include <CGAL/intersections.h>
#include <CGAL/pslg_from_mesh_2.h>
#include <CGAL/refine_mesh_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_pslg_from_mesh_2 {

namespace {

using namespace adapt_test;
using pslg_test::error_of;
using Details = CGAL::Given_mesh_details_2;

Mesh triangles_alone(const Mesh& mesh) {
  Mesh alone;
  alone.points = mesh.points, alone.triangles = mesh.triangles;
  return alone;
}

Mesh make_mesh(std::vector<Point> points, const std::vector<std::array<int, 3>>& triangles) {
  Mesh mesh;
  mesh.points = std::move(points);
  for (const auto& t : triangles)
    mesh.triangles.push_back({Vertex_index(t[0]), Vertex_index(t[1]), Vertex_index(t[2])});
  return mesh;
}

/// Two triangles of the unit square.
Mesh square() {
  return make_mesh({Point(0, 0), Point(1, 0), Point(1, 1), Point(0, 1)}, {{0, 1, 2}, {0, 2, 3}});
}

std::string refusal(Mesh mesh, const Details& details = {}) {
  const Mesh before = mesh;
  const std::string text = error_of([&] { CGAL::pslg_from_mesh_2(mesh, details); });
  CHECK(have_same_bits(before, mesh));
  CHECK(mesh.neighbors.empty());
  return text;
}

double area_of(const Mesh& mesh, const std::array<Vertex_index, 3>& t) {
  return CGAL::area(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]));
}

/// By the intersections of all pairs.
bool do_any_overlap(const Mesh& mesh) {
  using CGAL::Quadtree_mesh_2::internal::held_in;
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  std::vector<Kernel::Triangle_2> triangles;
  const auto exact = [&mesh](Vertex_index v) {
    return Kernel::Point_2(mesh.point(v).x(), mesh.point(v).y());
  };
  for (const auto& t : mesh.triangles) triangles.emplace_back(exact(t[0]), exact(t[1]), exact(t[2]));
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const auto common = CGAL::intersection(triangles[i], triangles[j]))
        if (held_in<Kernel::Triangle_2>(*common) != nullptr ||
            held_in<std::vector<Kernel::Point_2>>(*common) != nullptr)
          return true;
  return false;
}

/// Of the checker alone.
CGAL::Quadtree_mesh_2::internal::Border_touches touches_of(const Mesh& mesh) {
  namespace internal = CGAL::Quadtree_mesh_2::internal;
  const internal::Given_mesh_checker checker(mesh, 0);
  checker.check();
  return checker.touches(
      internal::Triangle_tree(mesh.points, mesh.triangles),
      internal::triangle_neighbors<CGAL::Sequential_tag>(mesh.triangles, mesh.points.size()));
}

/// Triangles over a lattice with two vertices at each place, so that some meet that have no vertex in common.
class Random_soups {
public:
  Random_soups() {
    for (int i = 0; i < 2 * places_; ++i) points_.emplace_back(i % places_ % width_, i % places_ / width_);
  }

  Mesh next() {
    Mesh mesh;
    mesh.points = points_;
    std::set<std::pair<Vertex_index, Vertex_index>> sides;
    for (int i = 0; i < 3 + number_ % 8; ++i) {
      std::array<Vertex_index, 3> t;
      for (Vertex_index& v : t) v = Vertex_index(below(2 * places_));
      const auto may_be = [&] {
        return CGAL::orientation(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])) == CGAL::LEFT_TURN &&
               sides.count({t[0], t[1]}) + sides.count({t[1], t[2]}) + sides.count({t[2], t[0]}) == 0;
      };
      if (!may_be()) continue;
      // Most soups would overlap: small triangles more often do not.
      if (area_of(mesh, t) > 1 && below(4) > 0) continue;
      mesh.triangles.push_back(t);
      for (std::size_t k = 0; k < 3; ++k) sides.insert({t[k], t[(k + 1) % 3]});
    }
    ++number_;
    return mesh;
  }

  int below(int n) { return int(random_() % unsigned(n)); }

private:
  static constexpr int width_ = 4, places_ = width_ * width_;
  std::vector<Point> points_;
  std::mt19937 random_{27};
  int number_ = 0;
};

/// Without the vertices that no triangle uses.
Mesh compacted(const Mesh& mesh) {
  Mesh result;
  std::map<Vertex_index, Vertex_index> new_index;
  for (const auto& t : mesh.triangles) {
    result.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [place, is_new] = new_index.emplace(t[k], Vertex_index(result.points.size()));
      if (is_new) result.points.push_back(mesh.point(t[k]));
      result.triangles.back()[k] = place->second;
    }
  }
  return result;
}

double covered_area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += area_of(mesh, t);
  return sum;
}

/// By all pairs: whether a vertex of a triangle is in the middle of a side, or at the place of another one.
bool do_any_touch(const Mesh& mesh) {
  std::set<Vertex_index> used;
  for (const auto& t : mesh.triangles) used.insert(t.begin(), t.end());
  for (const Vertex_index v : used)
    for (const auto& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Point &p = mesh.point(v), &a = mesh.point(t[k]), &b = mesh.point(t[(k + 1) % 3]);
        if (p == a ? v != t[k] : CGAL::are_strictly_ordered_along_line(a, p, b)) return true;
      }
  return false;
}

/// Adapted with vertices that may be left out.
void check_adapted(Mesh mesh) {
  const double covered = covered_area(mesh);
  Details details;
  details.vertices = Details::Vertices::FREE_INSIDE;
  const Pslg graph = CGAL::pslg_from_mesh_2(mesh, details);
  const auto made = CGAL::adapt_mesh_2(mesh, graph, Options());
  check_valid(made.mesh, graph);
  check_transfer(made, mesh);
  CHECK(made.report.is_met());
  CHECK(std::abs(covered_area(made.mesh) - covered) < 1e-12);
}

/// Whether the edge from a to b is a segment of the mesh.
bool is_constrained(const Mesh& mesh, int a, int b) {
  const auto ends = std::minmax(Vertex_index(a), Vertex_index(b));
  return std::any_of(mesh.constrained_edges.begin(), mesh.constrained_edges.end(),
                     [&](const auto& e) { return std::minmax(e.vertices[0], e.vertices[1]) == ends; });
}

} // namespace

TEST_CASE("Triangles become a mesh of the graph of their border", "[adapt]") {
  for (const auto& family : random_pslg::all_families()) {
    const Pslg pslg = family.make(3);
    if (pslg.vertices.size() > 400) continue;
    CAPTURE(family.name);
    const Mesh original = fresh_mesh(pslg, Options());
    for (const auto vertices : {Details::Vertices::INPUT, Details::Vertices::FREE_INSIDE}) {
      Mesh mesh = triangles_alone(original);
      Details details;
      details.vertices = vertices;
      const Pslg graph = CGAL::pslg_from_mesh_2(mesh, details);
      CHECK(have_same_bits(mesh, original));
      CHECK(mesh.neighbors == original.neighbors);
      if (vertices == Details::Vertices::INPUT)
        for (std::size_t v = 0; v < mesh.points.size(); ++v)
          CHECK((mesh.input_index.empty() || mesh.input_index[v].is_valid() ||
                 mesh.segment_of_vertex[v].is_valid()));
      check_valid(mesh, graph);
    }
  }
}

TEST_CASE("Only corners, and vertices on bent segments, are input of a mesh with free vertices", "[adapt]") {
  Mesh mesh = triangles_alone(fresh_mesh(frame(), Options().max_area(0.05)));
  Details details;
  details.vertices = Details::Vertices::FREE_INSIDE;
  const Pslg graph = CGAL::pslg_from_mesh_2(mesh, details);
  CHECK(graph.vertices.size() == 8);
  CHECK(graph.segments.size() == 8);
  CHECK(graph.holes.size() == 1);
  CHECK(mesh.number_of_input_vertices == 8);
  check_valid(mesh, graph);
  const auto coarse = CGAL::adapt_mesh_2(mesh, graph, Options());
  check_valid(coarse.mesh, graph);
  check_transfer(coarse, mesh);
  CHECK(coarse.mesh.triangles.size() < mesh.triangles.size() / 4);
}

TEST_CASE("Vertices that no triangle uses are input, and so is what is at their place", "[adapt]") {
  Mesh mesh = triangles_alone(fresh_mesh(frame(), Options().max_area(0.05)));
  const auto inside = std::find_if(mesh.points.begin(), mesh.points.end(), [](const Point& p) {
    return p.x() > 0 && p.x() < 4 && p.y() > 0 && p.y() < 1;
  });
  REQUIRE(inside != mesh.points.end());
  const Point place = *inside;
  mesh.points.push_back(place);
  mesh.points.emplace_back(2, 2); // in the hole
  Details details;
  details.vertices = Details::Vertices::FREE_INSIDE;
  const Pslg graph = CGAL::pslg_from_mesh_2(mesh, details);
  CHECK(graph.vertices.size() == 11);
  check_valid(mesh, graph);
  const auto coarse = CGAL::adapt_mesh_2(mesh, graph, Options());
  check_valid(coarse.mesh, graph);
  CHECK(std::count(coarse.mesh.points.begin(), coarse.mesh.points.end(), place) == 2);
}

TEST_CASE("Edges between attributes and named edges are segments", "[adapt]") {
  Mesh mesh = square();
  Details details;
  details.attributes = {3, 5};
  Pslg graph = CGAL::pslg_from_mesh_2(mesh, details);
  CHECK(graph.segments.size() == 5);
  REQUIRE(graph.regions.size() == 2);
  CHECK(graph.regions[0].attribute == 3);
  CHECK(graph.regions[1].attribute == 5);
  CHECK(mesh.region_of_triangle == std::vector<int>{0, 1});
  check_valid(mesh, graph);

  details.attributes = {5, 5};
  mesh = square();
  graph = CGAL::pslg_from_mesh_2(mesh, details);
  CHECK(graph.segments.size() == 4);
  CHECK(graph.regions.size() == 1);

  details = Details();
  details.segments = {{Vertex_index(2), Vertex_index(0)}, {Vertex_index(0), Vertex_index(1)}};
  details.segment_markers = {7, 8};
  mesh = square();
  graph = CGAL::pslg_from_mesh_2(mesh, details);
  REQUIRE(graph.segments.size() == 5);
  CHECK(graph.regions.empty());
  std::vector<int> markers = graph.segment_markers;
  std::sort(markers.begin(), markers.end());
  CHECK(markers == std::vector<int>{0, 0, 0, 7, 8});
  check_valid(mesh, graph);
}

TEST_CASE("What is no mesh is refused, and the triangles at fault are named", "[adapt]") {
  CHECK(refusal(Mesh()) == "the mesh has no triangles");

  Mesh mesh = square();
  mesh.triangles[1][2] = Vertex_index(4);
  CHECK(refusal(mesh) == "triangle 1 (0 2 4) names vertex 4, but there are 4 vertices");

  mesh = square();
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  CHECK(refusal(mesh) == "triangle 1 (2 0 3) is clockwise");
  Details from_1;
  from_1.first_number = 1;
  CHECK(refusal(mesh, from_1) == "triangle 2 (3 1 4) is clockwise");

  mesh = square();
  mesh.points[3] = Point(0.5, 0.5);
  CHECK(refusal(mesh) == "triangle 1 (0 2 3) has its vertices on a line");
  mesh.points[3] = Point(0, std::numeric_limits<double>::quiet_NaN());
  CHECK(refusal(mesh) == "vertex 3 of the mesh has a coordinate that is not a finite number");

  mesh = square();
  mesh.points.emplace_back(0.5, 2);
  mesh.triangles.push_back({Vertex_index(0), Vertex_index(2), Vertex_index(4)});
  CHECK(refusal(mesh) ==
        "triangle 1 (0 2 3) and triangle 2 (0 2 4) are on the same side of the edge from vertex 0 "
        "to vertex 2");

  // They have no edge in common.
  mesh = make_mesh({Point(0, 0), Point(1, 0), Point(0, 1), Point(0.25, 0.25), Point(2, 0.25), Point(2, 1)},
                   {{0, 1, 2}, {3, 4, 5}});
  CHECK(refusal(mesh) == "triangle 0 (0 1 2) and triangle 1 (3 4 5) overlap");
  // One in the other, without a crossing.
  mesh = make_mesh({Point(0, 0), Point(8, 0), Point(0, 8), Point(1, 1), Point(2, 1), Point(1, 2)},
                   {{0, 1, 2}, {3, 4, 5}});
  CHECK(refusal(mesh) == "triangle 0 (0 1 2) and triangle 1 (3 4 5) overlap");
  // The same triangle over other vertices.
  mesh = make_mesh({Point(0, 0), Point(1, 0), Point(0, 1), Point(0, 0), Point(1, 0), Point(0, 1)},
                   {{0, 1, 2}, {4, 5, 3}});
  CHECK(refusal(mesh) == "triangle 0 (0 1 2) and triangle 1 (4 5 3) overlap");
  // A fan that goes around its vertex twice.
  std::vector<Point> points{Point(0, 0)};
  std::vector<std::array<int, 3>> fan;
  for (int i = 0; i < 14; ++i) points.emplace_back(std::cos(i), std::sin(i));
  for (int i = 1; i < 14; ++i) fan.push_back({0, i, i + 1});
  CHECK(pslg_test::has_text(refusal(make_mesh(points, fan)), " overlap"));
}

TEST_CASE("Triangles are refused for an overlap if the interiors of two of them meet", "[adapt]") {
  Random_soups soups;
  int overlapping = 0, apart = 0;
  for (int soup = 0; soup < (is_full_run() ? 20000 : 2000); ++soup) {
    const Mesh mesh = soups.next();
    if (mesh.triangles.empty()) continue;
    const bool do_overlap = do_any_overlap(mesh);
    ++(do_overlap ? overlapping : apart);
    CAPTURE(soup);
    CHECK(pslg_test::has_text(error_of([&] { touches_of(mesh); }), " overlap") == do_overlap);
  }
  CHECK(overlapping > 100);
  CHECK(apart > 100);
}

TEST_CASE("Triangles that only touch are a mesh", "[adapt]") {
  // At a vertex; along a border with a vertex inside.
  for (Mesh mesh :
       {make_mesh({Point(0, 0), Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1)},
                  {{0, 1, 2}, {0, 3, 4}}),
        make_mesh({Point(0, 0), Point(2, 0), Point(1, 2), Point(1, 0), Point(0, -2), Point(2, -2)},
                  {{0, 1, 2}, {0, 4, 3}, {4, 5, 3}, {5, 1, 3}})}) {
    const Pslg graph = CGAL::pslg_from_mesh_2(mesh);
    const auto refined = CGAL::refine_mesh_2(mesh, graph, Options().max_area(0.1));
    check_valid(refined.mesh, graph);
    CHECK(refined.report.is_met());
  }
}

TEST_CASE("Triangles that meet anyhow without an overlap become a mesh of what they cover", "[adapt]") {
  Random_soups soups;
  int touching = 0;
  for (int soup = 0; soup < (is_full_run() ? 20000 : 2000); ++soup) {
    Mesh mesh = compacted(soups.next());
    if (mesh.triangles.empty() || do_any_overlap(mesh)) continue;
    CAPTURE(soup);
    const bool do_touch = do_any_touch(mesh);
    CHECK(touches_of(mesh).are_none() == !do_touch);
    if (do_touch) ++touching;
    const Mesh given = mesh;
    std::vector<Triangle_index> given_triangle;
    Pslg graph;
    try {
      graph = CGAL::pslg_from_mesh_2(mesh, Details(), given_triangle);
    } catch (const CGAL::Pslg_error_2& error) {
      FAIL(error.what());
    }
    CHECK_FALSE(do_any_touch(mesh));
    check_valid(mesh, graph);
    REQUIRE(given_triangle.size() == mesh.triangles.size());
    std::vector<double> area_of_pieces(given.triangles.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (t < given.triangles.size()) CHECK(given_triangle[t] == Triangle_index(t));
      area_of_pieces[std::size_t(given_triangle[t])] += area_of(mesh, mesh.triangles[t]);
    }
    for (std::size_t t = 0; t < given.triangles.size(); ++t)
      CHECK(area_of_pieces[t] == area_of(given, given.triangles[t]));
    const auto made = CGAL::refine_mesh_2(mesh, graph, Options().max_area(soup % 2 == 0 ? 0 : 0.3));
    check_valid(made.mesh, graph);
    check_transfer(made, mesh);
    CHECK(made.report.is_met());
    CHECK(std::abs(covered_area(made.mesh) - covered_area(given)) < 1e-12);
    if (soup % 4 == 0) check_adapted(given);
  }
  CHECK(touching > 100);
}

TEST_CASE("Triangles that nest in one corner, and many vertices on one side, take no quadratic time",
          "[adapt]") {
  const int n = is_full_run() ? 200000 : 10000;
  const auto on_circle = [n](int i, double radius) {
    return Point(radius * std::cos(0.5 * i / n), radius * std::sin(0.5 * i / n));
  };
  std::vector<Point> points{Point(0, 0)};
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < n; ++i) {
    points.push_back(on_circle(2 * i, 1 + 0.1 * (i % 7))), points.push_back(on_circle(2 * i + 1, 1));
    triangles.push_back({0, 2 * i + 1, 2 * i + 2});
  }
  Mesh fan = make_mesh(std::move(points), triangles);
  const Mesh given = fan;
  CHECK(CGAL::pslg_from_mesh_2(fan).vertices.size() == fan.points.size());
  CHECK(have_same_bits(fan, given));

  points = {Point(0, 0), Point(n, 0), Point(0, n), Point(n, -n)}, triangles = {{0, 1, 2}};
  for (int i = 1, last = 0; i <= n; last = i + 3, ++i) {
    if (i < n) points.emplace_back(i, 0);
    triangles.push_back({3, i < n ? i + 3 : 1, last});
  }
  Mesh hanging = make_mesh(std::move(points), triangles);
  CGAL::pslg_from_mesh_2(hanging);
  CHECK(hanging.triangles.size() == 2 * std::size_t(n));
}

TEST_CASE("Meshes side by side are one, with segments where they meet", "[adapt]") {
  // Two squares with two vertices each at both ends of the side between them; at the right of it two triangles less.
  Mesh mesh = make_mesh({Point(0, 0), Point(2, 0), Point(2, 2), Point(0, 2), Point(2, 0), Point(4, 0),
                         Point(4, 2), Point(2, 2), Point(2, 1)},
                        {{0, 1, 2}, {0, 2, 3}, {4, 5, 8}, {5, 6, 8}, {6, 7, 8}});
  Details details;
  details.segments = {{Vertex_index(2), Vertex_index(1)}, {Vertex_index(5), Vertex_index(6)}};
  details.segment_markers = {7, 8};
  details.attributes = {1, 1, 2, 2, 2};
  std::vector<Triangle_index> given_triangle;
  const Pslg graph = CGAL::pslg_from_mesh_2(mesh, details, given_triangle);
  check_valid(mesh, graph);
  CHECK(mesh.triangles.size() == 6);
  CHECK(given_triangle.back() == Triangle_index(0));
  CHECK(is_constrained(mesh, 1, 8));
  CHECK(is_constrained(mesh, 8, 2));
  CHECK_FALSE(is_constrained(mesh, 0, 8));
  CHECK(std::count_if(mesh.constrained_edges.begin(), mesh.constrained_edges.end(),
                      [](const auto& e) { return e.marker == 7; }) == 2);
  CHECK(graph.regions.size() == 2);
  CHECK(graph.holes.empty());
  const auto made = CGAL::refine_mesh_2(mesh, graph, Options().max_area(0.1));
  check_valid(made.mesh, graph);
  CHECK(std::abs(covered_area(made.mesh) - 8) < 1e-12);
}

TEST_CASE("A crack within a mesh is a segment, and so are both sides of a vertex in the middle of one",
          "[adapt]") {
  // Around the vertex 4, from which a crack leads to the vertices 1 and 5.
  Mesh crack = make_mesh({Point(0, 0), Point(2, 0), Point(2, 2), Point(0, 2), Point(1, 1), Point(2, 0)},
                         {{0, 1, 4}, {5, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  Pslg graph = CGAL::pslg_from_mesh_2(crack);
  CHECK(graph.segments.size() == 5);
  CHECK(is_constrained(crack, 1, 4));
  CHECK(crack.triangles[1][0] == Vertex_index(1));
  check_valid(crack, graph);
  auto made = CGAL::refine_mesh_2(crack, graph, Options());
  CHECK(have_same_bits(made.mesh, crack)); // it meets the bounds
  CHECK(made.report.is_met());

  Mesh hanging = make_mesh({Point(0, 0), Point(2, 0), Point(1, 3), Point(1, 0), Point(1, -3)},
                           {{0, 1, 2}, {0, 4, 3}, {3, 4, 1}});
  graph = CGAL::pslg_from_mesh_2(hanging);
  CHECK(hanging.triangles.size() == 4);
  CHECK(is_constrained(hanging, 0, 3));
  CHECK(is_constrained(hanging, 3, 1));
  CHECK(graph.segments.size() == 6);
  made = CGAL::refine_mesh_2(hanging, graph, Options());
  check_valid(made.mesh, graph);
}

TEST_CASE("Arrays of a wrong length, and segments that are no edges, are named", "[adapt]") {
  Details details;
  details.attributes = {1};
  CHECK(refusal(square(), details) == "there are 1 attributes for 2 triangles");
  details.attributes = {1, std::nan("")};
  CHECK(refusal(square(), details) == "the attribute of triangle 1 is not a finite number");
  details = Details();
  details.segment_markers = {1};
  CHECK(refusal(square(), details) == "there are 1 markers for 0 segments");
  Mesh mesh = square();
  mesh.vertex_markers = {1, 2, 3};
  CHECK(refusal(mesh) == "there are 3 markers for 4 vertices");
  details = Details();
  details.segments = {{Vertex_index(0), Vertex_index(2)}, {Vertex_index(1), Vertex_index(3)}};
  CHECK(refusal(square(), details) == "segment 1 from vertex 1 to vertex 3 is not an edge of a triangle");
  details.segments = {{Vertex_index(0), Vertex_index(99)}};
  CHECK(refusal(square(), details) == "segment 0 from vertex 0 to vertex 99 is not an edge of a triangle");
}

} // namespace test_pslg_from_mesh_2
