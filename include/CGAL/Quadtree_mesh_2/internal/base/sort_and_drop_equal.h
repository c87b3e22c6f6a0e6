// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SORT_AND_DROP_EQUAL_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SORT_AND_DROP_EQUAL_H

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Leaves each value once, in order. O(n log n).
template <class Value>
void sort_and_drop_equal(std::vector<Value>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SORT_AND_DROP_EQUAL_H
