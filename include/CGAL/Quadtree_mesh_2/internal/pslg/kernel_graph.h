// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The user's graph in the kernel's numbering, which is the shuffle order of the vertices. O(n) for n vertices and
// segments.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_KERNEL_GRAPH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_KERNEL_GRAPH_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/huge_pages.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// \param order the input vertex of each kernel vertex
template <class ConcurrencyTag, class Pslg, class Order>
std::vector<std::array<Vertex_id, 2>> kernel_segments(const Pslg& pslg, const Order& order) {
  Uninitialized_indexed_vector<Vertex_index, Vertex_id> kernel_vertex;
  resize_with_pages(kernel_vertex, order.size());
  for_each_index<ConcurrencyTag>(order.size(), [&](std::size_t i) {
    kernel_vertex[Vertex_index(order[i])] = static_cast<Vertex_id>(i);
  });
  std::vector<std::array<Vertex_id, 2>> segments;
  resize_with_pages(segments, pslg.number_of_segments());
  for_each_index<ConcurrencyTag>(segments.size(), [&](std::size_t s) {
    const auto& [a, b] = pslg.segments[s];
    segments[s] = {kernel_vertex[a], kernel_vertex[b]};
  });
  return segments;
}

/// The input's vertices, and its edges: segments cut where vertices lie on them.
template <class Pslg, class Order>
Pslg graph_of_edges(const Pslg& pslg, const Order& order, const Input_edges& edges) {
  Pslg graph;
  graph.vertices.reserve(order.size());
  for (std::size_t v = 0; v < order.size(); ++v) graph.vertices.push_back(pslg.vertices[order[v]]);
  for (const Edge_id e : edges.ids()) {
    const Input_edge& edge = edges[e];
    graph.add_segment(Vertex_index(std::size_t(edge.a)), Vertex_index(std::size_t(edge.b)));
  }
  return graph;
}

/// Where the holes and the regions are.
template <class Pslg>
auto seeds_of(const Pslg& pslg) {
  auto seeds = pslg.holes;
  for (const auto& region : pslg.regions) seeds.push_back(region.point);
  return seeds;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_KERNEL_GRAPH_H
