// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A hint to the processor that memory will be read soon. Changes nothing but time.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PREFETCH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PREFETCH_H

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

inline void prefetch(const void* address) {
#if defined(__GNUC__)
  __builtin_prefetch(address);
  __asm__ volatile(""); // else GCC takes a function that only fetches for one without effect, and drops it
#else
  static_cast<void>(address);
#endif
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PREFETCH_H
