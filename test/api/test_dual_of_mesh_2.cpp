// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Cells around vertices: what they are is judged by distances and sight alone, at places anywhere in the domain.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "random_pslg.h"
#include "random_pslg_shapes.h"

#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/dual_of_mesh_2.h>
#include <CGAL/edges_of_mesh_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace test_dual_of_mesh_2 {

using namespace test_meshes;
using Dual = CGAL::Mesh_dual_2;
using Kind = Dual::Kind;

namespace {

/// Without neighbors, which the function then has to find.
Mesh mesh_by_hand(const std::vector<Point>& points, const std::vector<std::array<int, 3>>& triangles) {
  Mesh mesh;
  mesh.points = points;
  mesh.number_of_input_vertices = points.size();
  for (const auto& [a, b, c] : triangles)
    mesh.triangles.push_back({Vertex_index(a), Vertex_index(b), Vertex_index(c)});
  return mesh;
}

/// A square of four triangles, whose corner triangles are obtuse or right.
Mesh square_with_center(double x, double y) {
  return mesh_by_hand({Point(0, 0), Point(4, 0), Point(4, 4), Point(0, 4), Point(x, y)},
                      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
}

double area_of_domain(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) sum += CGAL::area(mesh.point(a), mesh.point(b), mesh.point(c));
  return sum;
}

double extent(const Mesh& mesh) {
  double most = 0;
  for (const auto& t : mesh.triangles)
    for (const Vertex_index v : t)
      most = std::max({most, std::abs(mesh.point(v).x()), std::abs(mesh.point(v).y())});
  return most;
}

std::vector<std::vector<Point>> polygons(const Dual& dual, std::size_t v) {
  std::vector<std::vector<Point>> result;
  dual.for_each_polygon(Vertex_index(v), [&](const auto* begin, const auto* end) {
    result.emplace_back();
    for (; begin != end; ++begin) result.back().emplace_back(dual.points[*begin][0], dual.points[*begin][1]);
  });
  return result;
}

double area_of(const std::vector<Point>& polygon) {
  double area = 0;
  CGAL::area_2(polygon.begin(), polygon.end(), area, Kernel());
  return area;
}

/// What blocks the sight: borders, and sides with the vertex beyond in the circle, decided exactly.
std::vector<std::array<Vertex_index, 2>> walls_of(const Mesh& mesh) {
  std::vector<std::array<Vertex_index, 2>> walls;
  for (const auto& e : CGAL::edges_of_mesh_2(mesh)) {
    if (e.is_on_border()) {
      walls.push_back(e.vertices);
      continue;
    }
    const auto apex = [&](Triangle_index t) {
      for (const Vertex_index v : mesh.triangles[std::size_t(t)])
        if (v != e.vertices[0] && v != e.vertices[1]) return mesh.point(v);
      throw std::logic_error("no apex");
    };
    if (CGAL::side_of_oriented_circle(mesh.point(e.vertices[0]), mesh.point(e.vertices[1]),
                                      apex(e.triangles[0]), apex(e.triangles[1])) == CGAL::ON_POSITIVE_SIDE)
      walls.push_back(e.vertices);
  }
  return walls;
}

/// The vertex nearest to a place, of those in sight, and by how much the next one is farther.
std::pair<Vertex_index, double>
nearest_in_sight(const Mesh& mesh, const std::vector<std::array<Vertex_index, 2>>& walls, const Point& p) {
  const auto is_in_sight = [&](Vertex_index v) {
    return std::none_of(walls.begin(), walls.end(), [&](const auto& wall) {
      if (wall[0] == v || wall[1] == v) return false;
      return CGAL::do_intersect(Kernel::Segment_2(p, mesh.point(v)),
                                Kernel::Segment_2(mesh.point(wall[0]), mesh.point(wall[1])));
    });
  };
  std::set<Vertex_index> used;
  for (const auto& t : mesh.triangles) used.insert(t.begin(), t.end());
  std::vector<std::pair<double, Vertex_index>> by_distance;
  for (const Vertex_index v : used)
    by_distance.push_back({std::sqrt(CGAL::squared_distance(p, mesh.point(v))), v});
  std::sort(by_distance.begin(), by_distance.end());
  Vertex_index nearest;
  double distance = 0;
  for (const auto& [d, v] : by_distance) {
    if (!is_in_sight(v)) continue;
    if (nearest.is_valid()) return {nearest, d - distance};
    nearest = v, distance = d;
  }
  return {nearest, std::numeric_limits<double>::infinity()};
}

bool is_in(const Dual& dual, Vertex_index v, const Point& p) {
  const auto all = polygons(dual, std::size_t(v));
  return std::any_of(all.begin(), all.end(), [&](const auto& polygon) {
    return CGAL::bounded_side_2(polygon.begin(), polygon.end(), p, Kernel()) != CGAL::ON_UNBOUNDED_SIDE;
  });
}

/// \returns at how many places the cell was asked for
std::size_t check_cells_at_places(const Mesh& mesh, std::size_t places, std::uint64_t seed) {
  const Dual dual = CGAL::dual_of_mesh_2(mesh);
  const auto walls = walls_of(mesh);
  random_pslg::Random random(seed);
  std::size_t checked = 0;
  for (std::size_t i = 0; i < places; ++i) {
    const auto& [a, b, c] = mesh.triangles[random.bits() % mesh.triangles.size()];
    double s = random.between(0, 1), t = random.between(0, 1);
    if (s + t > 1) s = 1 - s, t = 1 - t;
    const Point p = mesh.point(a) + s * (mesh.point(b) - mesh.point(a)) + t * (mesh.point(c) - mesh.point(a));
    const auto [v, margin] = nearest_in_sight(mesh, walls, p);
    if (!v.is_valid() || margin < 1e-9 * extent(mesh)) continue;
    CAPTURE(p, v, mesh.point(v));
    CHECK(is_in(dual, v, p));
    ++checked;
  }
  return checked;
}

void check_areas(const Mesh& mesh, Kind kind) {
  const Dual dual = CGAL::dual_of_mesh_2(mesh, kind);
  const double total = area_of_domain(mesh), tolerance = 1e-12 * extent(mesh) * extent(mesh);
  REQUIRE(dual.number_of_cells() == mesh.points.size());
  CHECK(std::accumulate(dual.areas.begin(), dual.areas.end(), 0.) == Approx(total).epsilon(1e-9));
  for (std::size_t v = 0; v < dual.areas.size(); ++v) {
    double sum = 0;
    for (const auto& polygon : polygons(dual, v)) {
      const double area = area_of(polygon);
      CHECK(area > -tolerance);
      sum += area;
    }
    CHECK(std::abs(sum - dual.areas[v]) <= tolerance);
  }
}

/// The length of what the polygons of two vertices have in common, by the pairs of vertices.
std::map<std::set<Vertex_index>, double> common_lengths(const Dual& dual) {
  std::map<std::set<std::uint32_t>, std::vector<Vertex_index>> cells_at;
  for (std::size_t v = 0; v < dual.number_of_cells(); ++v)
    dual.for_each_polygon(Vertex_index(v), [&](const auto* begin, const auto* end) {
      for (const auto* c = begin; c != end; ++c)
        cells_at[{*c, c + 1 == end ? *begin : c[1]}].push_back(Vertex_index(v));
    });
  std::map<std::set<Vertex_index>, double> lengths;
  for (const auto& [ends, cells] : cells_at) {
    if (cells.size() < 2) continue;
    REQUIRE(cells.size() == 2);
    const auto &p = dual.points[*ends.begin()], &q = dual.points[*ends.rbegin()];
    lengths[{cells[0], cells[1]}] += std::hypot(p[0] - q[0], p[1] - q[1]);
  }
  return lengths;
}

void check_lengths(const Mesh& mesh, Kind kind) {
  const Dual dual = CGAL::dual_of_mesh_2(mesh, kind);
  auto common = common_lengths(dual);
  REQUIRE(dual.lengths.size() == dual.edges.size());
  for (std::size_t e = 0; e < dual.edges.size(); ++e) {
    const auto& [a, b] = dual.edges[e].vertices;
    CAPTURE(a, b);
    CHECK(std::abs(common[{a, b}] - dual.lengths[e]) <= 1e-9 * extent(mesh));
    common.erase({a, b});
  }
  for (const auto& [cells, length] : common) CHECK(length <= 1e-9 * extent(mesh));
}

} // namespace

TEST_CASE("edges are found once each, with Triangle's markers", "[dual]") {
  Mesh mesh = square_with_center(2, 2);
  mesh.constrained_edges.push_back({{Vertex_index(1), Vertex_index(0)}, Segment_index(0), 7});
  mesh.constrained_edges.push_back({{Vertex_index(4), Vertex_index(2)}, Segment_index(1), -3});
  mesh.constrained_edges.push_back({{Vertex_index(3), Vertex_index(0)}, Segment_index(2), 0});
  const auto edges = CGAL::edges_of_mesh_2(mesh);
  REQUIRE(edges.size() == 8);
  std::set<std::array<std::size_t, 2>> seen;
  for (const auto& e : edges) {
    const auto [a, b] = std::minmax({std::size_t(e.vertices[0]), std::size_t(e.vertices[1])});
    CHECK(seen.insert({a, b}).second);
    CHECK(e.is_on_border() == (b != 4));
    const int marker = a == 0 && b == 1 ? 7 : a == 2 && b == 4 ? -3 : b == 4 ? 0 : 1;
    CHECK(e.marker == marker);
    CHECK((!e.triangles[1].is_valid() || e.triangles[0] < e.triangles[1]));
    const auto& t = mesh.triangles[std::size_t(e.triangles[0])];
    const auto at = std::find(t.begin(), t.end(), e.vertices[0]);
    REQUIRE(at != t.end());
    CHECK(t[std::size_t(at - t.begin() + 1) % 3] == e.vertices[1]);
  }
  CHECK(edges[0].vertices == std::array{Vertex_index(1), Vertex_index(4)}); // opposite the first vertex
}

TEST_CASE("second-order nodes are in the middle of the sides opposite the corners", "[dual]") {
  const Mesh mesh = mesh_of(random_pslg::shape_families()[0].make(3));
  const auto nodes = CGAL::second_order_nodes_2(mesh);
  const std::size_t n = mesh.points.size();
  REQUIRE(nodes.first_node == n);
  REQUIRE(nodes.points.size() == nodes.edges.size());
  REQUIRE(nodes.nodes_of_triangle.size() == mesh.triangles.size());
  std::vector<int> uses(nodes.points.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t node = std::size_t(nodes.nodes_of_triangle[t][k]) - n;
      const Point middle = CGAL::midpoint(mesh.point(mesh.triangles[t][(k + 1) % 3]),
                                          mesh.point(mesh.triangles[t][(k + 2) % 3]));
      CHECK(nodes.points[node][0] == Approx(middle.x()));
      CHECK(nodes.points[node][1] == Approx(middle.y()));
      ++uses[node];
    }
  for (std::size_t e = 0; e < uses.size(); ++e) CHECK(uses[e] == (nodes.edges[e].is_on_border() ? 1 : 2));
}

TEST_CASE("the Voronoi cells of an obtuse triangle end at its longest side", "[dual]") {
  const Mesh mesh = mesh_by_hand({Point(0, 0), Point(8, 0), Point(4, 2), Point(9, 9)}, {{0, 1, 2}});
  const Dual dual = CGAL::dual_of_mesh_2(mesh);
  CHECK(dual.points[0][0] == Approx(4)); // the circumcenter is out of sight
  CHECK(dual.points[0][1] == Approx(-3));
  // The bisectors of the short sides meet the long one at 2.5 and 5.5.
  CHECK(dual.areas[0] == Approx(0.5 * 2.5 * 1));
  CHECK(dual.areas[1] == Approx(0.5 * 2.5 * 1));
  CHECK(dual.areas[2] == Approx(8 - 2.5));
  CHECK(dual.areas[3] == 0);
  CHECK(polygons(dual, 2).front().size() == 5);
  CHECK(polygons(dual, 3).empty());
  for (std::size_t e = 0; e < 3; ++e) {
    const bool is_long =
        dual.edges[e].vertices[0] != Vertex_index(2) && dual.edges[e].vertices[1] != Vertex_index(2);
    CHECK(dual.lengths[e] == Approx(is_long ? 0 : std::hypot(0.5, 1)));
  }
}

TEST_CASE("cells of a square cut by both diagonals have one corner where rounding makes four", "[dual]") {
  const Dual dual = CGAL::dual_of_mesh_2(square_with_center(2, 2));
  for (std::size_t v = 0; v < 4; ++v) {
    CHECK(dual.areas[v] == Approx(2));
    CHECK(polygons(dual, v).front().size() == 3); // the middles of borders are circumcenters
  }
  CHECK(polygons(dual, 4).front().size() == 4);
  Mesh two = mesh_by_hand({Point(0.1, 0.1), Point(0.4, 0.2), Point(0.3, 0.5), Point(0, 0.4)},
                          {{0, 1, 2}, {0, 2, 3}});
  const Dual of_two = CGAL::dual_of_mesh_2(two);
  for (std::size_t v = 0; v < 4; ++v) {
    CHECK(of_two.areas[v] == Approx(0.025));
    CHECK(polygons(of_two, v).front().size() == 4);
  }
}

TEST_CASE("where the border touches itself, a cell is a polygon for each fan", "[dual]") {
  const Mesh mesh = mesh_by_hand({Point(0, 0), Point(2, -1), Point(2, 1), Point(-2, 1), Point(-2, -1)},
                                 {{0, 1, 2}, {0, 3, 4}});
  for (const Kind kind : {Kind::CIRCUMCENTRIC, Kind::BARYCENTRIC}) {
    const Dual dual = CGAL::dual_of_mesh_2(mesh, kind);
    CHECK(polygons(dual, 0).size() == 2);
    check_areas(mesh, kind);
  }
}

TEST_CASE("the cells of any mesh cover its domain", "[dual]") {
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 1; seed <= (is_full_run() ? 2 : 1); ++seed) {
      CAPTURE(family.name, seed);
      const Pslg pslg = family.make(seed);
      const Mesh mesh = mesh_of(pslg);
      if (mesh.triangles.empty()) continue;
      for (const Kind kind : {Kind::CIRCUMCENTRIC, Kind::BARYCENTRIC}) check_areas(mesh, kind);
      check_lengths(mesh, Kind::BARYCENTRIC);
    }
}

TEST_CASE("a place is in the Voronoi cell of the nearest vertex in sight", "[dual]") {
  std::size_t checked = 0;
  for (const auto& family : random_pslg::all_families()) {
    CAPTURE(family.name);
    const Mesh mesh = mesh_of(family.make(5));
    if (mesh.triangles.empty() || mesh.points.size() > 1000) continue;
    checked += check_cells_at_places(mesh, 100, 17);
  }
  CHECK(checked > 500);
  Mesh refined = mesh_of(random_pslg::shape_families()[0].make(2), 0.1);
  check_cells_at_places(refined, 100, 18);
  SECTION("also in a mesh that is not Delaunay") {
    const Mesh mesh =
        mesh_by_hand({Point(0, 0), Point(6, 1), Point(0, 2), Point(-6, 1)}, {{0, 1, 3}, {1, 2, 3}});
    CHECK(walls_of(mesh).size() == 5);
    check_cells_at_places(mesh, 200, 19);
    check_areas(mesh, Kind::CIRCUMCENTRIC);
  }
}

TEST_CASE("lengths are those of what cells have in common", "[dual]") {
  for (const Mesh& mesh : {square_with_center(2, 2), square_with_center(1, 2.5), square_with_center(0.5, 0.4),
                           mesh_of(random_pslg::shape_families()[0].make(4), 0.2)}) {
    check_lengths(mesh, Kind::CIRCUMCENTRIC);
    check_lengths(mesh, Kind::BARYCENTRIC);
  }
}

TEST_CASE("a median cell has a third of each triangle", "[dual]") {
  const Mesh mesh = mesh_of(random_pslg::shape_families()[7].make(2), 0.2);
  std::vector<double> wanted(mesh.points.size(), 0);
  for (const auto& t : mesh.triangles)
    for (const Vertex_index v : t)
      wanted[std::size_t(v)] += CGAL::area(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])) / 3;
  const Dual dual = CGAL::dual_of_mesh_2(mesh, Kind::BARYCENTRIC);
  for (std::size_t v = 0; v < wanted.size(); ++v)
    CHECK(std::abs(dual.areas[v] - wanted[v]) <= 1e-12 * extent(mesh) * extent(mesh));
}

TEST_CASE("threads make the same cells", "[dual]") {
  const Mesh mesh = mesh_of(random_pslg::shape_families()[0].make(4), 0.02);
  for (const Kind kind : {Kind::CIRCUMCENTRIC, Kind::BARYCENTRIC}) {
    const Dual one = CGAL::dual_of_mesh_2(mesh, kind),
               all = CGAL::dual_of_mesh_2<CGAL::Parallel_tag>(mesh, kind);
    CHECK(one.points == all.points);
    CHECK(one.corners == all.corners);
    CHECK(one.first_corner == all.first_corner);
    CHECK(one.first_polygon == all.first_polygon);
    CHECK(one.areas == all.areas);
    CHECK(one.lengths == all.lengths);
  }
}

} // namespace test_dual_of_mesh_2
