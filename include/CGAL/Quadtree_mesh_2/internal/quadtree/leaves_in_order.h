// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Joins lists of leaves that blocks made to one list.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LEAVES_IN_ORDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LEAVES_IN_ORDER_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Returns the leaves of all lists in order, each once.
template <class ConcurrencyTag>
std::vector<Leaf_index> in_order(const std::vector<std::vector<Leaf_index>>& lists,
                                 std::size_t number_of_leaves) {
  Indexed_vector<Leaf_index, std::uint8_t> is_wanted(number_of_leaves, 0);
  for (const auto& leaves : lists)
    for (const Leaf_index l : leaves) is_wanted[l] = 1;
  return pack_values<ConcurrencyTag, Leaf_index>(
      number_of_leaves, [&](std::size_t l) { return is_wanted[Leaf_index(l)] != 0; },
      [](std::size_t l) { return Leaf_index(l); });
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LEAVES_IN_ORDER_H
