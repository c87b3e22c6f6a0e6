// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_TRIANGLES_AT_EDGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_TRIANGLES_AT_EDGES_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

constexpr std::size_t no_triangle = std::numeric_limits<std::size_t>::max();

/// Per constrained edge, the triangles beside it in their order; `no_triangle` where there is none. From the vertices
/// alone, as meshes made by hand have no neighbors. O(T + e log e) for T triangles and e edges: only sides between
/// vertices of constrained edges are looked for.
template <class Point>
std::vector<std::array<std::size_t, 2>> triangles_at_edges(const Indexed_mesh_2<Point>& mesh) {
  using Edge = std::array<std::uint32_t, 2>;
  const auto sorted = [](Vertex_index a, Vertex_index b) {
    return Edge{std::min(a.value(), b.value()), std::max(a.value(), b.value())};
  };
  const std::size_t n = mesh.constrained_edges.size();
  std::vector<std::pair<Edge, std::size_t>> edges;
  Indexed_vector<Vertex_index, char> is_end(mesh.points.size(), 0);
  edges.reserve(n);
  for (std::size_t e = 0; e < n; ++e) {
    const auto& ends = mesh.constrained_edges[e].vertices;
    edges.push_back({sorted(ends[0], ends[1]), e});
    for (const Vertex_index v : ends) is_end[v] = 1;
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<std::size_t, 2>> result(n, {no_triangle, no_triangle});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex_index a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      if (is_end[a] == 0 || is_end[b] == 0) continue;
      const Edge side = sorted(a, b);
      for (auto e = std::lower_bound(edges.begin(), edges.end(), std::pair(side, std::size_t(0)));
           e != edges.end() && e->first == side; ++e) {
        auto& at = result[e->second];
        at[at[0] == no_triangle ? 0 : 1] = t;
      }
    }
  return result;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_TRIANGLES_AT_EDGES_H
