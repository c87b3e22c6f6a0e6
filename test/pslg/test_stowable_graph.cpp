// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A graph that is stowed comes out as it was, whatever its segments are.

#include "catch.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Stowable_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace test_stowable_graph {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point>;
using Stowable_graph = CGAL::Quadtree_mesh_2::internal::Stowable_graph<Point>;

Pslg graph_with(std::size_t vertices) {
  Pslg graph;
  for (std::size_t v = 0; v < vertices; ++v) graph.add_vertex(Point(double(v), -0.0));
  graph.vertex_markers.assign(vertices, 3);
  graph.holes.push_back(Point(1, 2));
  return graph;
}

Pslg chain(std::size_t vertices) {
  Pslg graph = graph_with(vertices);
  for (std::size_t v = 0; v < vertices; ++v)
    graph.add_segment(Pslg::Vertex_index(v), Pslg::Vertex_index((v + 1) % vertices));
  return graph;
}

Pslg random_segments(std::size_t vertices, std::size_t segments, std::mt19937& random) {
  Pslg graph = graph_with(vertices);
  const auto any = [&] { return Pslg::Vertex_index(random() % vertices); };
  for (std::size_t s = 0; s < segments; ++s) {
    const auto a = any(), b = any();
    graph.add_segment(a, b);
  }
  return graph;
}

bool is_same(const Pslg& a, const Pslg& b) {
  const auto bits = [](const Pslg& graph) {
    std::vector<std::pair<double, bool>> found;
    for (const Point& p : graph.vertices)
      found.push_back({p.x(), std::signbit(p.x())}), found.push_back({p.y(), std::signbit(p.y())});
    return found;
  };
  return bits(a) == bits(b) && a.segments == b.segments && a.vertex_markers == b.vertex_markers &&
         a.holes == b.holes;
}

void check(const Pslg& graph, std::mt19937& random) {
  std::vector<std::uint32_t> order(graph.number_of_vertices());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), random);
  const auto place_of = [&](std::size_t i) { return graph.vertices[order[i]]; };
  Stowable_graph stowable(Pslg{graph});
  for (int time = 0; time < 2; ++time) {
    CHECK(is_same(stowable.graph(), graph));
    CHECK(stowable.segments() == graph.segments);
    stowable.stow(), stowable.stow();
    CHECK(stowable.is_stowed());
    CHECK(stowable.segments() == graph.segments);
    CHECK(stowable.graph().vertices.capacity() == 0);
    CHECK(stowable.graph().segments.capacity() == 0);
    CHECK(stowable.graph().vertex_markers == graph.vertex_markers);
    stowable.take_out(order, place_of), stowable.take_out(order, place_of);
    CHECK_FALSE(stowable.is_stowed());
  }
  CHECK(is_same(stowable.graph(), graph));
}

} // namespace

TEST_CASE("A graph comes out as it was stowed", "[pslg]") {
  std::mt19937 random(1);
  check(Pslg(), random);
  check(graph_with(3), random);
  check(chain(1000), random);
  check(random_segments(1, 5, random), random); // of length 0
  check(random_segments(70000, 3000, random), random);
}

TEST_CASE("Segments between the first and the last vertex that there can be are stowed", "[pslg]") {
  Pslg graph;
  const std::size_t last = 0xfffffffe;
  for (const std::size_t v : {std::size_t(0), last, std::size_t(0), last, last, std::size_t(1)})
    graph.add_segment(Pslg::Vertex_index(v), Pslg::Vertex_index(last - v));
  Stowable_graph stowable(Pslg{graph});
  stowable.stow();
  CHECK(stowable.segments() == graph.segments);
}

TEST_CASE("A graph of somebody else is not stowed", "[pslg]") {
  const Pslg graph = chain(10);
  Stowable_graph stowable(graph);
  stowable.stow();
  CHECK_FALSE(stowable.is_stowed());
  CHECK(&stowable.graph() == &graph);
  CHECK(is_same(graph, chain(10)));
  CHECK(stowable.segments() == graph.segments);
}

} // namespace test_stowable_graph
