// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Vertices of a mesh that is to be made of the leaves of a quadtree, and the pieces of edges between them.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PLACED_VERTICES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PLACED_VERTICES_H

#include <CGAL/Quadtree_mesh_2/internal/Input_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A vertex on an edge.
template <class Geometry>
struct Edge_crossing {
  Edge_id edge;
  typename Geometry::Point point;
};

template <class Geometry>
struct Placed_vertices {
  std::vector<typename Geometry::Point> points; ///< first the input's, then those on edges, then corners
  std::vector<Edge_id> edge_of;                 ///< as `Kernel_mesh::edge_of`
  std::vector<std::array<Vertex_id, 2>> segments;

  explicit Placed_vertices(const std::vector<typename Geometry::Point>& input)
      : points(input), edge_of(input.size()) {
    for (std::size_t v = 0; v < input.size(); ++v) edge_of[v] = input_vertex(static_cast<Vertex_id>(v));
  }

  /// \param cut called as `cut(e, crossings)`, maybe for several edges at the same time; appends the vertices on
  ///        edge e, from its first end to its second
  template <class Concurrency_tag, class Cut>
  void append_vertices_of_edges(const Input_edges& edges, const Cut& cut) {
    constexpr std::size_t block = 256;
    std::vector<std::vector<Edge_crossing<Geometry>>> found((edges.size() + block - 1) / block);
    for_each_block<Concurrency_tag>(edges.size(), block,
                                    [&](std::size_t b, std::size_t begin, std::size_t end) {
                                      for (std::size_t e = begin; e < end; ++e)
                                        cut(static_cast<Edge_id>(e), found[b]);
                                    });
    Edge_id e = 0;
    for (const auto& crossings : found)
      for (const auto& c : crossings) {
        while (e < c.edge) close_edge(edges, e++);
        append(edges, c);
      }
    while (e < static_cast<Edge_id>(edges.size())) close_edge(edges, e++);
  }

  /// Appends the corners of leaves that are kept, by name.
  template <class Concurrency_tag, class Trees, class Corners>
  void append_corners(const Trees& trees, const Corners& corners, const std::vector<char>& is_kept) {
    const auto names = pack_values<Concurrency_tag, typename Corners::Name>(
        is_kept.size(), [&](std::size_t c) { return is_kept[c] != 0; }, [](std::size_t c) { return c; });
    const std::size_t first = points.size();
    points.resize(first + names.size());
    edge_of.resize(first + names.size(), free_vertex);
    for_each_index<Concurrency_tag>(names.size(), [&](std::size_t i) {
      points[first + i] = trees.kernel_point(corners.place(names[i]));
    });
  }

private:
  /// Joins the last vertex on an edge to its end.
  void close_edge(const Input_edges& edges, Edge_id e) {
    const Vertex_id last = edge_of.back() == e ? static_cast<Vertex_id>(points.size()) - 1 : edges[e].a;
    segments.push_back({last, edges[e].b});
  }
  void append(const Input_edges& edges, const Edge_crossing<Geometry>& c) {
    const Vertex_id v = static_cast<Vertex_id>(points.size());
    segments.push_back({edge_of.back() == c.edge ? v - 1 : edges[c.edge].a, v});
    points.push_back(c.point);
    edge_of.push_back(c.edge);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PLACED_VERTICES_H
