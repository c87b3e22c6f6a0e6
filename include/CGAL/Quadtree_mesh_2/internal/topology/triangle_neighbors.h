// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Which triangles of a mesh are next to each other.
//
// Computes: the neighbors of each triangle of a conforming mesh.
// Bound:    O(k log d) work for k triangles, where d is the largest degree; O(k) if degrees are bounded.
// Method:   Each side goes to the lesser of its two vertices. At a vertex, sides are sorted by their other
//           vertex, so the two sides of an edge meet.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TOPOLOGY_TRIANGLE_NEIGHBORS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TOPOLOGY_TRIANGLE_NEIGHBORS_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Neighbor `k` of a triangle is across the side that faces its vertex `k`; invalid on the border.
/// \pre no edge is a side of more than two triangles.
template <class ConcurrencyTag>
std::vector<std::array<Triangle_index, 3>>
triangle_neighbors(const std::vector<std::array<Vertex_index, 3>>& triangles,
                   std::size_t number_of_vertices) {
  struct Sorted_side {
    std::uint32_t other_vertex, side; // side k of triangle t is 3 t + k
    bool operator<(const Sorted_side& s) const {
      return std::pair(other_vertex, side) < std::pair(s.other_vertex, s.side);
    }
  };
  const auto ends = [&](std::size_t t, std::size_t k) {
    return std::minmax({triangles[t][(k + 1) % 3].value(), triangles[t][(k + 2) % 3].value()});
  };
  std::vector<std::uint32_t> first(number_of_vertices + 1, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) ++first[std::size_t(ends(t, k).first) + 1];
  for (std::size_t v = 0; v < number_of_vertices; ++v) first[v + 1] += first[v];

  std::vector<Sorted_side> sides(3 * triangles.size());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [least, other] = ends(t, k);
      sides[next[least]++] = {other, static_cast<std::uint32_t>(3 * t + k)};
    }

  std::vector<std::array<Triangle_index, 3>> neighbors(triangles.size());
  for_each_index<ConcurrencyTag>(number_of_vertices, [&](std::size_t v) {
    std::sort(sides.begin() + first[v], sides.begin() + first[v + 1]);
    for (std::uint32_t i = first[v]; i + 1 < first[v + 1]; ++i) {
      if (sides[i].other_vertex != sides[i + 1].other_vertex) continue;
      const std::uint32_t a = sides[i].side, b = sides[i + 1].side;
      neighbors[a / 3][a % 3] = Triangle_index(b / 3);
      neighbors[b / 3][b % 3] = Triangle_index(a / 3);
    }
  });
  return neighbors;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TOPOLOGY_TRIANGLE_NEIGHBORS_H
