// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The edges of the input: their order, those at a vertex, and those between two, by brute force.

#include "catch.h"

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>

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

} // namespace

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
