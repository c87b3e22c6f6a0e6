// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PREFETCH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PREFETCH_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>

#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Has the processor fetch a value into its cache that is read soon. There need not be one.
inline void prefetch(const void* value) {
#if defined(__GNUC__)
  __builtin_prefetch(value);
  __asm__ volatile(""); // an effect: g++ drops calls of functions that do nothing but prefetch
#else
  static_cast<void>(value);
#endif
}

/// Calls `visit(i)` for handles in their order, and `fetch(i)` some handles before that, to prefetch what the visit
/// reads.
template <class Id, class Fetch, class Visit>
void visit_with_foresight(Id_range<Id> range, const Fetch& fetch, const Visit& visit) {
  constexpr std::size_t ahead = 12;
  const auto end = static_cast<std::size_t>(*range.end());
  for (const Id i : range) {
    const std::size_t later = static_cast<std::size_t>(i) + ahead;
    if (later < end) fetch(static_cast<Id>(later));
    visit(i);
  }
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PREFETCH_H
