// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The canonical triangulation: exactly Delaunay, ties by handle, and the same bits however it came about.

#include "catch.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Canonical_flipper.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kept_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace test_canonical_triangulation {

namespace {

using namespace CGAL::Quadtree_mesh_2::internal;
using CGAL::Quadtree_mesh_2::Grid_point_2;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Geometry = Double_geometry_2<Kernel>;
using Point = Geometry::Point;
using Mesh = Kernel_mesh<Geometry>;
using First = First_triangulation<CGAL::Parallel_tag, Geometry>;
using Segments = std::vector<First::Segment>;

/// Points with coordinates from 0 to 2^20, in shuffle order, and segments between them.
struct Graph {
  std::vector<Point> points;
  Segments segments;

  void sort() {
    std::vector<Grid_point_2<std::uint32_t>> grid_points;
    for (const Point& p : points)
      grid_points.push_back({static_cast<std::uint32_t>(p.x), static_cast<std::uint32_t>(p.y)});
    const auto order = shuffle_order(grid_points);
    std::vector<Vertex_id> place(points.size());
    std::vector<Point> sorted;
    for (std::size_t i = 0; i < points.size(); ++i) {
      place[order[i]] = Vertex_id(i);
      sorted.push_back(points[order[i]]);
    }
    points = sorted;
    for (auto& s : segments) s = {place[s[0].value()], place[s[1].value()]};
  }
};

Graph lattice(std::size_t side) {
  Graph graph;
  for (std::size_t i = 0; i < side; ++i)
    for (std::size_t j = 0; j < side; ++j) graph.points.push_back({double(i), double(j)});
  for (std::size_t i = 0; i < side; i += 5)
    graph.segments.push_back({Vertex_id(i * side), Vertex_id(i * side + side - 1)});
  graph.sort();
  return graph;
}

/// Vertices of many polygons, each on one circle.
Graph circles() {
  Graph graph;
  constexpr std::array<std::array<int, 2>, 3> triples{{{65, 0}, {39, 52}, {25, 60}}};
  for (int ring = 0; ring < 9; ++ring)
    for (const auto& [x, y] : triples)
      for (const int sx : {-1, 1})
        for (const int sy : {-1, 1}) {
          const double cx = 200.0 * (ring % 3) + 100, cy = 200.0 * (ring / 3) + 100;
          graph.points.push_back({cx + sx * x, cy + sy * y});
          graph.points.push_back({cx + sx * y, cy + sy * x});
        }
  graph.segments.push_back({Vertex_id(0), Vertex_id(9)});
  graph.sort();
  return graph;
}

/// Random points, some at one place, and a polygon through some of them.
Graph random_graph(std::uint32_t seed) {
  std::mt19937 random(seed);
  Graph graph;
  const std::size_t n = 500;
  const std::uint32_t side = seed % 2 == 0 ? 40 : 100000; // with ties, or almost none
  for (std::size_t i = 0; i < n; ++i)
    graph.points.push_back({double(random() % side), double(random() % side)});
  // A star from the center: no two of its edges cross, but some lie on each other, and some run through vertices.
  for (std::size_t i = 0; i < 12; ++i) graph.segments.push_back({Vertex_id(0), Vertex_id(7 * i + 1)});
  graph.sort();
  return graph;
}

struct Triangulated {
  Mesh mesh;
  std::vector<std::array<Vertex_id, 2>> edges;
  std::vector<Vertex_id> representative;
};

Triangulated triangulate(const Graph& graph, std::size_t block_size) {
  Triangulated result;
  First first(result.mesh, graph.points, blocks_by_number(graph.points.size(), block_size));
  REQUIRE_FALSE(first.run(graph.segments));
  if (block_size >= graph.points.size()) Canonical_flipper<CGAL::Parallel_tag, Geometry>(result.mesh).run();
  const Indexed_vector<Triangle_id, char> is_kept(result.mesh.triangles.size(), 1);
  Kept_triangles(result.mesh, is_kept).keep(result.mesh.points.end_id());
  const Input_edges edges(first.take_edges(), graph.points.size());
  for (const Edge_id e : edges.ids()) result.edges.push_back({edges[e].a, edges[e].b});
  for (std::size_t v = 0; v < graph.points.size(); ++v)
    result.representative.push_back(first.representative(Vertex_id(v)));
  return result;
}

bool are_same(const Triangulated& a, const Triangulated& b) {
  if (a.mesh.triangles.size() != b.mesh.triangles.size() || a.edges != b.edges) return false;
  for (const Triangle_id t : a.mesh.triangles.ids())
    for (int k = 0; k < 3; ++k) {
      const auto &r = a.mesh.triangle(t), &s = b.mesh.triangle(t);
      const Side o = r.side[k], p = s.side[k];
      if (r.v[k] != s.v[k] || o.is_border() != p.is_border() || o.is_constrained() != p.is_constrained())
        return false;
      if (!o.is_border() && (o.triangle() != p.triangle() || o.slot() != p.slot())) return false;
    }
  return a.mesh.triangle_of == b.mesh.triangle_of && a.representative == b.representative;
}

std::vector<Graph> graphs() {
  std::vector<Graph> result{lattice(30), circles()};
  for (std::uint32_t seed = 0; seed < 30; ++seed) result.push_back(random_graph(seed));
  return result;
}

} // namespace

TEST_CASE("The first triangulation is the same bits however blocks are cut", "[triangulation]") {
  for (const Graph& graph : graphs()) {
    CAPTURE(graph.points.size());
    const Triangulated whole = triangulate(graph, graph.points.size());
    for (const std::size_t block_size : {24u, 64u, 100u}) {
      CAPTURE(block_size);
      CHECK(are_same(triangulate(graph, block_size), whole));
    }
  }
}

TEST_CASE("The canonical triangulation is Delaunay, and ties go to the least vertex", "[triangulation]") {
  for (const Graph& graph : graphs()) {
    const Mesh mesh = triangulate(graph, 24).mesh;
    for (const Triangle_id t : mesh.triangles.ids()) {
      const auto& v = mesh.triangle(t).v;
      REQUIRE(mesh.orientation(v[0], v[1], v[2]) > 0);
      CHECK((v[0] < v[1] && v[0] < v[2]));
      for (int k = 0; k < 3; ++k) {
        const Side o = mesh.across(Side(t, k));
        if (o.is_border()) continue;
        REQUIRE(mesh.across(o).triangle() == t);
        REQUIRE(mesh.across(o).slot() == k);
        REQUIRE(mesh.source(o) == mesh.target(Side(t, k)));
        if (o.is_constrained()) continue;
        const Vertex_id d = mesh.opposite(o);
        const int side =
            Geometry::side_of_circle(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(d));
        CHECK(side <= 0);
        if (side == 0)
          CHECK(std::min(mesh.source(o), mesh.target(o)) < std::min(mesh.opposite(Side(t, k)), d));
      }
      if (t == Triangle_id(0)) continue;
      const auto& before = mesh.triangle(Triangle_id(t.value() - 1)).v;
      CHECK((before[0] < v[0] || (before[0] == v[0] && before[1] < v[1])));
    }
    for (const Vertex_id v : mesh.points.ids()) {
      if (!mesh.is_used(v)) continue;
      Triangle_id first, first_of_its_own; // none is greater than any
      mesh.for_each_triangle_at(v, [&](Triangle_id t, int slot) {
        first = std::min(first, t);
        if (slot == 0) first_of_its_own = std::min(first_of_its_own, t);
      });
      CHECK(mesh.incident_triangle(v) == (first_of_its_own.is_valid() ? first_of_its_own : first));
    }
  }
}

} // namespace test_canonical_triangulation
