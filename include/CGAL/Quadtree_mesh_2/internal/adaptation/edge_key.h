// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Edges as keys of unordered containers.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_EDGE_KEY_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_EDGE_KEY_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <algorithm>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The ends of an edge in one number, whatever their order.
inline std::uint64_t edge_key(Vertex_index a, Vertex_index b) {
  const auto [least, other] = std::minmax({a.value(), b.value()});
  return std::uint64_t(least) << 32 | other;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_EDGE_KEY_H
