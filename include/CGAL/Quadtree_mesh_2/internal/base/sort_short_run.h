// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SORT_SHORT_RUN_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SORT_SHORT_RUN_H

#include <algorithm>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// std::sort() for one of many runs, most of which have one or two values: it takes long to find that out.
template <class T, class Is_before>
void sort_short_run(T* begin, T* end, const Is_before& is_before) {
  if (end - begin > 2)
    std::sort(begin, end, is_before);
  else if (end - begin == 2 && is_before(begin[1], begin[0]))
    std::iter_swap(begin, begin + 1);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_SORT_SHORT_RUN_H
