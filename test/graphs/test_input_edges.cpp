// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The edges of the input: their order, those at a vertex, and those between two, by brute force; and how they are told
// while most segments are one edge.

#include "catch.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Segment_inserter.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_input_edges {

namespace {

using namespace CGAL::Quadtree_mesh_2::internal;
using CGAL::Quadtree_mesh_2::Segment_index;
using Ends = std::pair<std::size_t, std::size_t>;
using Geometry = Double_geometry_2<CGAL::Exact_predicates_inexact_constructions_kernel>;

/// Some pairs of vertices in any order, with a vertex that has many edges.
std::vector<Ends> random_pairs(std::size_t vertices, std::size_t pairs, std::mt19937& random) {
  std::set<Ends> found;
  for (std::size_t i = 0; i < pairs; ++i) {
    const std::size_t a = i % 3 == 0 ? vertices / 2 : random() % vertices, b = random() % vertices;
    if (a != b) found.insert({std::min(a, b), std::max(a, b)});
  }
  std::vector<Ends> shuffled(found.begin(), found.end());
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  for (Ends& p : shuffled)
    if (random() % 2 == 0) std::swap(p.first, p.second);
  return shuffled;
}

void check(std::size_t vertices, const std::vector<Ends>& pairs) {
  Input_edge_list list;
  std::map<Ends, std::size_t> segment_of;
  for (std::size_t s = 0; s < pairs.size(); ++s) {
    const auto [a, b] = pairs[s];
    list.push_back({Vertex_id(a), Vertex_id(b), Segment_index(s)});
    segment_of[{std::min(a, b), std::max(a, b)}] = s;
  }
  Input_edges edges(list, vertices);
  edges.list_by_vertices();
  REQUIRE(edges.size() == segment_of.size());

  // In the order of the ends, of which the lesser one comes first.
  std::vector<std::vector<Ends>> at(vertices); // (neighbor, edge)
  std::size_t e = 0, wrong = 0;
  for (const auto& [ends, s] : segment_of) {
    const Input_edge& edge = edges[Edge_id(e)];
    wrong += std::size_t(edge.a) != ends.first || std::size_t(edge.b) != ends.second ||
                     std::size_t(edge.segment) != s
                 ? 1
                 : 0;
    at[ends.first].push_back({ends.second, e}), at[ends.second].push_back({ends.first, e});
    ++e;
  }
  CHECK(wrong == 0);
  for (std::size_t v = 0; v < vertices; ++v) {
    std::sort(at[v].begin(), at[v].end());
    std::vector<Ends> found;
    for (const auto incidence : edges.at(Vertex_id(v)))
      found.push_back({std::size_t(incidence.neighbor), incidence.edge.value()});
    CHECK(edges.at(Vertex_id(v)).size() == at[v].size());
    CHECK(found == at[v]);
    for (std::size_t w = 0; w < vertices; ++w) {
      const Edge_id between = edges.between(Vertex_id(v), Vertex_id(w));
      const auto expected =
          std::find_if(at[v].begin(), at[v].end(), [w](const Ends& i) { return i.first == w; });
      if (between.is_valid() != (expected != at[v].end()) ||
          (between.is_valid() && between.value() != expected->second))
        ++wrong;
    }
  }
  CHECK(wrong == 0);
}

bool is_same(const Input_edge& e, const Input_edge& f) {
  return e.a == f.a && e.b == f.b && e.segment == f.segment;
}

/// Vertices (0, 0), (4, 0), (4, 4), (0, 4) and (2, 0), triangulated.
Kernel_mesh<Geometry> square_with_middle() {
  const std::vector<Geometry::Point> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}};
  Kernel_mesh<Geometry> mesh;
  First_triangulation<CGAL::Sequential_tag, Geometry>(mesh, points).run({});
  return mesh;
}

} // namespace

TEST_CASE("Segments of one edge are told by their ends, others by their edges", "[refiner]") {
  Edges_of_segments edges;
  const auto v = [](std::size_t i) { return Vertex_id(i); };
  edges.segments = {{v(4), v(1)}, {}, {v(0), v(2)}, {v(1), v(4)}};
  edges.others.push_back({v(2), v(3), Segment_index(1)}),
      edges.others.push_back({v(3), v(0), Segment_index(1)});
  CHECK(edges.find(v(1), v(4)) == Segment_index(0));
  CHECK(edges.find(v(0), v(3)) == Segment_index(1));
  CHECK(edges.find(v(2), v(0)) == Segment_index(2));
  CHECK_FALSE(edges.find(v(2), v(4)).is_valid());
  edges.list_between(v(1), v(4));
  CHECK_FALSE((edges.segments[0][0].is_valid() || edges.segments[3][0].is_valid()));
  REQUIRE(edges.others.size() == 4);
  CHECK(is_same(edges.others[2], {v(4), v(1), Segment_index(0)}));
  CHECK(is_same(edges.others[3], {v(1), v(4), Segment_index(3)}));
  edges.others.pop_back(); // the mesher tells a repeated edge elsewhere

  Input_edge_list list;
  list.push_back({v(0), v(2), Segment_index(2)});
  list.insert(list.end(), edges.others.begin(), edges.others.end());
  const Input_edges one(edges, 5), other(list, 5);
  REQUIRE(one.size() == other.size());
  for (const Edge_id e : one.ids()) CHECK(is_same(one[e], other[e]));
}

TEST_CASE("A segment keeps its ends if it becomes one edge, and no other does", "[refiner]") {
  auto mesh = square_with_middle();
  Segment_inserter<Geometry> inserter(mesh);
  const auto insert = [&](std::size_t a, std::size_t b, std::size_t s) {
    Segment_ends ends{Vertex_id(a), Vertex_id(b)};
    CHECK(inserter.insert_whole(ends[0], ends[1], Segment_index(s), ends).is_empty());
    return ends;
  };
  CHECK(insert(2, 0, 0) == Segment_ends{Vertex_id(2), Vertex_id(0)}); // perhaps after flips
  CHECK(insert(2, 3, 1) == Segment_ends{Vertex_id(2), Vertex_id(3)});
  CHECK(insert(0, 1, 2) == Segment_ends{}); // by way of vertex 4
  CHECK(insert(4, 1, 3) == Segment_ends{}); // which is there
  CHECK(insert(3, 3, 4) == Segment_ends{}); // which is none
  const Segments_made made = inserter.take();
  REQUIRE(made.edges.size() == 2);
  for (const Input_edge& e : made.edges)
    CHECK((e.segment == Segment_index(2) && (e.a.value() == 4 || e.b.value() == 4)));
  REQUIRE(made.repeated_edges.size() == 1);
  CHECK(made.repeated_edges.front().segment == Segment_index(3));
  CHECK(made.vertices_on_segments == 1);
}

TEST_CASE("The segment that is crossed is one that was made", "[refiner]") {
  // Of the segments 0-1, 3-4 and 0-2 the first runs by way of vertex 2, the second crosses it, and the third is not
  // reached.
  const std::vector<Geometry::Point> points{{0, 0}, {4, 0}, {2, 0}, {1, -1}, {1, 1}, {0, 3}};
  const auto v = [](std::size_t i) { return Vertex_id(i); };
  Kernel_mesh<Geometry> mesh;
  First_triangulation<CGAL::Sequential_tag, Geometry> first(mesh, points);
  const auto crossing = first.run({{v(0), v(1)}, {v(3), v(4)}, {v(0), v(2)}});
  REQUIRE(crossing);
  CHECK(crossing->segment == Segment_index(1));
  CHECK(first.edges().find(crossing->a, crossing->b) == Segment_index(0));
}

TEST_CASE("Edges of the input are listed at both ends", "[refiner]") {
  check(0, {});
  check(1, {});
  check(2, {{1, 0}});
  std::mt19937 random(11);
  for (const std::size_t vertices : {2u, 3u, 10u, 60u})
    for (const std::size_t pairs : {1u, 5u, 200u}) {
      CAPTURE(vertices, pairs);
      check(vertices, random_pairs(vertices, pairs, random));
    }
}

} // namespace test_input_edges
