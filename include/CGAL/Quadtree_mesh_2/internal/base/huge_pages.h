// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_HUGE_PAGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_HUGE_PAGES_H

#include <cstddef>
#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Asks the system to put a long array into huge pages: one page fault instead of 512. The array should be about to be
/// written whole. Nothing can fail, because this only asks.
inline void advise_huge_pages(void* begin, std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t huge_page = std::uintptr_t(1) << 21;
  if (bytes < 2 * huge_page) return; // it may not contain a whole one
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + huge_page - 1) & ~(huge_page - 1);
  const auto end = (reinterpret_cast<std::uintptr_t>(begin) + bytes) & ~(huge_page - 1);
  madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#else
  static_cast<void>(begin), static_cast<void>(bytes);
#endif
}

/// Reserves room for `size` values, in huge pages if that is much. One thread can then fill it in little time.
template <class Vector>
void reserve_in_huge_pages(Vector& values, std::size_t size) {
  values.reserve(size);
  advise_huge_pages(values.data(), size * sizeof(typename Vector::value_type));
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_HUGE_PAGES_H
