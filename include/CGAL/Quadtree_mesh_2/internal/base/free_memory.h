// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_FREE_MEMORY_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_FREE_MEMORY_H

#include <cstddef>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Calls `f(begin, end)` for the maximal runs of needless indices below `size`, given as `Id`.
template <class Id, class Is_needless, class Function>
void for_each_needless_run(std::size_t size, const Is_needless& is_needless, const Function& f) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= size; ++i) {
    if (i < size && is_needless(Id(i))) continue;
    if (begin < i) f(begin, i);
    begin = i + 1;
  }
}

/// Frees the memory of arrays. To assign `{}` would leave that of a vector as it is.
template <class... Arrays>
void free_arrays(Arrays&... arrays) {
  ((arrays = Arrays()), ...);
}

/// Gives the system back what was allocated in small pieces and is free again. glibc keeps it otherwise.
inline void give_back_free_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_FREE_MEMORY_H
