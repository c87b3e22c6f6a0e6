// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_RESERVE_IN_PARALLEL_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_RESERVE_IN_PARALLEL_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Does what `values.reserve(capacity)` does. The values are moved by all threads, which touch the pages that they
/// write.
/// \tparam Vector one whose `resize()` does not write
template <class Vector>
void reserve_in_parallel(Vector& values, std::size_t capacity) {
  if (capacity <= values.capacity()) return;
  Vector larger;
  larger.reserve(capacity);
  larger.resize(values.size());
  for_each_block<Chosen_tag>(values.size(), default_block,
                             [&](std::size_t, std::size_t begin, std::size_t end) {
                               std::move(values.data() + begin, values.data() + end, larger.data() + begin);
                             });
  values = std::move(larger);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_RESERVE_IN_PARALLEL_H
