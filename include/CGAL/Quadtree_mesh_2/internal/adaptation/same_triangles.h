// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Whether two meshes of the same vertices have the same triangles, in whatever order.
//
// Computes: per triangle of the one mesh, the same triangle of the other.
// Bound:    O(k log k) time for k triangles.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_SAME_TRIANGLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_SAME_TRIANGLES_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// \returns per triangle, that of the others with the same vertices; empty if there is one without, or of the others
inline std::vector<Triangle_index> same_triangles(const std::vector<std::array<Vertex_index, 3>>& triangles,
                                                  const std::vector<std::array<Vertex_index, 3>>& others) {
  if (triangles.size() != others.size()) return {};
  using Entry = std::pair<std::array<Vertex_index, 3>, std::size_t>;
  const auto sorted = [](const std::vector<std::array<Vertex_index, 3>>& some) {
    std::vector<Entry> entries;
    entries.reserve(some.size());
    for (std::size_t t = 0; t < some.size(); ++t) {
      entries.emplace_back(some[t], t);
      std::sort(entries.back().first.begin(), entries.back().first.end());
    }
    std::sort(entries.begin(), entries.end());
    return entries;
  };
  const std::vector<Entry> own = sorted(triangles), other = sorted(others);
  std::vector<Triangle_index> same(triangles.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].first != other[i].first) return {};
    same[own[i].second] = Triangle_index(other[i].second);
  }
  return same;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_SAME_TRIANGLES_H
