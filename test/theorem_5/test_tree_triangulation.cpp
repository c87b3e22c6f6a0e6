// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Triangulations of placed vertices: what gives way where they coincide, and what the domain is.

#include "catch.h"
#include "separation_test_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Tree_triangulation.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_tree_triangulation {

namespace {

using namespace separation_test;
using Prepared = Prepared_graph<CGAL::Filtered_quadtree_traits_2<>>;
using Geometry = Prepared::Geometry;
using Point = Geometry::Point;
using Placed = internal::Placed_vertices<Geometry>;
using Mesh = internal::Kernel_mesh<Geometry>;
using internal::Vertex_id;

/// The unit square with a segment in it, from vertex 4 to vertex 5.
Prepared::Pslg square_with_segment() {
  return pslg_test::make_pslg<double>({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {.25, .5}, {.75, .5}},
                                      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}});
}

/// The vertices of a graph, and its edges as they are.
Placed placed_vertices(const Prepared& graph) {
  Placed placed(graph.problem().input_points);
  for (std::size_t e = 0; e < graph.problem().edges.size(); ++e) {
    const auto& edge = graph.problem().edges[internal::Edge_id(e)];
    placed.segments.push_back({edge.a, edge.b});
  }
  return placed;
}

/// A point of the graph's coordinates, in the kernel's.
Point kernel_point(const Prepared& graph, double x, double y) { return graph.map().to_kernel({x, y}); }

/// Puts a vertex at a place of the graph's coordinates.
void add_vertex(const Prepared& graph, Placed& placed, double x, double y, internal::Vertex_role role) {
  placed.points.push_back(kernel_point(graph, x, y));
  placed.role_of.push_back(role);
}

bool triangulate(const Prepared& graph, const Placed& placed, Mesh& mesh) {
  const std::vector<char> is_merged(graph.problem().input_points.size(), 0);
  internal::Tree_triangulation<CGAL::Sequential_tag, Geometry> triangulation(
      placed, is_merged, graph.problem().edges, graph.sides());
  return triangulation.run(
      [&graph](const Point& p) {
        const auto place = graph.map().place(p);
        return CGAL::Quadtree_mesh_2::Grid_point_2<std::uint64_t>{std::uint64_t((place[0] + 1) * 0x1p40),
                                                                  std::uint64_t((place[1] + 1) * 0x1p40)};
      },
      mesh);
}

/// The area of the mesh in the graph's coordinates.
double area(const Prepared& graph, const Mesh& mesh) {
  const double unit = kernel_point(graph, 1, 0).x;
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += mesh.shape(t).area2 / 2 / (unit * unit);
  return sum;
}

} // namespace

TEST_CASE("Corners at the place of vertices, or on edges, are left out", "[mesher][theorem5]") {
  const Prepared graph(square_with_segment());
  Placed placed = placed_vertices(graph);
  for (const Point& p : {Point{.25, .5}, Point{.5, .5}, Point{0, .5}, Point{.5, .25}, Point{.5, .25}})
    add_vertex(graph, placed, p.x, p.y, internal::free_vertex);
  Mesh mesh;
  REQUIRE(triangulate(graph, placed, mesh));
  for (const int v : {0, 1, 2, 3, 4, 5}) CHECK(mesh.is_used(Vertex_id(v)));
  for (const int v : {6, 7, 8}) CHECK_FALSE(mesh.is_used(Vertex_id(v)));
  CHECK(mesh.is_used(Vertex_id(9)) != mesh.is_used(Vertex_id(10)));
  CHECK(area(graph, mesh) == Approx(1));
  for (const auto& t : mesh.triangles) CHECK(mesh.orientation(t.v[0], t.v[1], t.v[2]) > 0);
}

TEST_CASE("Pieces of edges that cross, or meet, are no mesh", "[mesher][theorem5]") {
  const Prepared graph(square_with_segment());
  for (const double y : {-.5, 0.}) {
    Placed placed = placed_vertices(graph);
    const internal::Edge_id e = graph.problem().edges.between(Vertex_id(4), Vertex_id(5));
    add_vertex(graph, placed, .5, y, e); // on or beyond the lower side of the square
    placed.segments[std::size_t(e)] = {graph.problem().edges[e].a, Vertex_id(6)};
    placed.segments.push_back({Vertex_id(6), graph.problem().edges[e].b});
    Mesh mesh;
    CHECK_FALSE(triangulate(graph, placed, mesh));
    CHECK(mesh.triangles.empty());
  }
}

TEST_CASE("Components are known by the sides of their edges", "[mesher][theorem5]") {
  // A frame. The vertices on the inner edges are so far inside that the point of the hole is no longer in it.
  auto pslg = pslg_test::make_pslg<double>(
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {.25, .25}, {.75, .25}, {.75, .75}, {.25, .75}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}});
  pslg.holes.push_back({.5, .26});
  const Prepared graph(pslg);
  Placed placed = placed_vertices(graph);
  const std::size_t edges = graph.problem().edges.size();
  for (std::size_t e = 0; e < edges; ++e) {
    const auto& edge = graph.problem().edges[internal::Edge_id(e)];
    if (edge.a < Vertex_id(4)) continue;
    const auto middle = graph.map().place(
        Geometry::between(graph.problem().input_point(edge.a), graph.problem().input_point(edge.b), .5));
    add_vertex(graph, placed, middle[0] * .9 + .05, middle[1] * .9 + .05, internal::Edge_id(e));
    const Vertex_id v = Vertex_id(placed.points.size() - 1);
    placed.segments[e] = {edge.a, v};
    placed.segments.push_back({v, edge.b});
  }
  Mesh mesh;
  REQUIRE(triangulate(graph, placed, mesh));
  CHECK(area(graph, mesh) == Approx(1 - (.25 - 4 * .5 * .025 / 2)));
}

} // namespace test_tree_triangulation
