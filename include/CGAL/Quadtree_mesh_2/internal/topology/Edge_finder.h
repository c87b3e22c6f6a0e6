// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The edges of a mesh, numbered.
//
// Computes: each edge once, in the order of its first triangle and of the sides there, with its marker; and the edge of
//           each side.
// Bound:    O(k) work for k triangles with neighbors; the time of finding these where there are none. Markers take
//           O(e) expected time for e constrained edges, on one thread.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TOPOLOGY_EDGE_FINDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TOPOLOGY_EDGE_FINDER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/triangle_neighbors.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Which side of a triangle is between two of its vertices.
inline std::size_t side_between(const std::array<Vertex_index, 3>& triangle,
                                const std::array<Vertex_index, 2>& ends) {
  std::size_t k = 0;
  while (triangle[k] == ends[0] || triangle[k] == ends[1]) ++k;
  return k;
}

template <class ConcurrencyTag, class Point>
class Edge_finder {
public:
  using Triangle_neighbors = std::vector<std::array<Triangle_index, 3>>;

  explicit Edge_finder(const Indexed_mesh_2<Point>& mesh) : mesh_(mesh) {
    if (mesh.neighbors.size() != mesh.triangles.size())
      found_ = triangle_neighbors<ConcurrencyTag>(mesh.triangles, mesh.points.size());
    find_edges();
    set_markers();
  }

  /// Of the mesh, or found where it has none.
  const Triangle_neighbors& neighbors() const { return found_.empty() ? mesh_.neighbors : found_; }
  const std::vector<Mesh_edge_2>& edges() const { return edges_; }
  std::vector<Mesh_edge_2> take_edges() { return std::move(edges_); }

  /// Per triangle, the edges that its sides are.
  std::vector<std::array<std::uint32_t, 3>> edges_of_triangles() const {
    std::vector<std::array<std::uint32_t, 3>> result(mesh_.triangles.size());
    for_each_index<ConcurrencyTag>(edges_.size(), [&](std::size_t e) {
      for (const Triangle_index t : edges_[e].triangles)
        if (t.is_valid())
          result[std::size_t(t)][side_between(mesh_.triangles[std::size_t(t)], edges_[e].vertices)] =
              static_cast<std::uint32_t>(e);
    });
    return result;
  }

private:
  const Indexed_mesh_2<Point>& mesh_;
  Triangle_neighbors found_;
  std::vector<Mesh_edge_2> edges_;

  /// Whether a side is where its edge is counted.
  bool is_first(std::size_t t, std::size_t k) const {
    const Triangle_index other = neighbors()[t][k];
    return !other.is_valid() || t < std::size_t(other);
  }

  void find_edges() {
    count_allocate_and_place<ConcurrencyTag>(
        mesh_.triangles.size(),
        [this](std::size_t begin, std::size_t end) {
          std::size_t n = 0;
          for (std::size_t t = begin; t < end; ++t)
            for (std::size_t k = 0; k < 3; ++k) n += is_first(t, k) ? 1 : 0;
          return n;
        },
        [this](std::size_t n) { edges_.resize(n); },
        [this](std::size_t begin, std::size_t end, std::size_t next) {
          for (std::size_t t = begin; t < end; ++t)
            for (std::size_t k = 0; k < 3; ++k)
              if (is_first(t, k)) {
                const Triangle_index other = neighbors()[t][k];
                edges_[next++] = {{mesh_.triangles[t][(k + 1) % 3], mesh_.triangles[t][(k + 2) % 3]},
                                  {Triangle_index(t), other},
                                  other.is_valid() ? 0 : 1};
              }
        });
  }

  void set_markers() {
    const auto key = [](const std::array<Vertex_index, 2>& ends) {
      const auto [a, b] = std::minmax({ends[0].value(), ends[1].value()});
      return std::uint64_t(a) << 32 | b;
    };
    std::unordered_map<std::uint64_t, int> marker_of;
    for (const auto& e : mesh_.constrained_edges)
      if (e.marker != 0) marker_of.emplace(key(e.vertices), e.marker);
    if (marker_of.empty()) return;
    for_each_index<ConcurrencyTag>(edges_.size(), [&](std::size_t e) {
      const auto found = marker_of.find(key(edges_[e].vertices));
      if (found != marker_of.end()) edges_[e].marker = found->second;
    });
  }
};

template <class ConcurrencyTag, class Point>
Second_order_nodes_2 second_order_nodes(const Indexed_mesh_2<Point>& mesh) {
  const auto as_double = [](const auto& x) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(x)>>)
      return static_cast<double>(x);
    else
      return CGAL::to_double(x);
  };
  Edge_finder<ConcurrencyTag, Point> finder(mesh);
  Second_order_nodes_2 result;
  result.first_node = mesh.points.size();
  result.nodes_of_triangle.resize(mesh.triangles.size());
  const auto edges_of = finder.edges_of_triangles();
  for_each_index<ConcurrencyTag>(mesh.triangles.size(), [&](std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k)
      result.nodes_of_triangle[t][k] = Vertex_index(result.first_node + edges_of[t][k]);
  });
  result.edges = finder.take_edges();
  result.points.resize(result.edges.size());
  for_each_index<ConcurrencyTag>(result.edges.size(), [&](std::size_t e) {
    const auto& [a, b] = result.edges[e].vertices;
    const Point &p = mesh.point(a), &q = mesh.point(b);
    result.points[e] = {0.5 * as_double(p.x()) + 0.5 * as_double(q.x()),
                        0.5 * as_double(p.y()) + 0.5 * as_double(q.y())};
  });
  return result;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TOPOLOGY_EDGE_FINDER_H
