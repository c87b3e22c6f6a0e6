// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_BITS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_BITS_H

#include <cstdint>

#if defined(_MSC_VER)
#include <intrin.h>
#endif

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Returns the number of bits needed to write `v`: one more than the position of its highest bit, 0 for 0.
/// This is the paper's highest-order-bit operation.
inline int bit_width(std::uint64_t v) {
#if defined(_MSC_VER)
  unsigned long position = 0;
  return _BitScanReverse64(&position, v) ? static_cast<int>(position) + 1 : 0;
#else
  return v == 0 ? 0 : 64 - __builtin_clzll(v);
#endif
}

/// Returns the position of the lowest bit that is set.
/// \pre `v != 0`
inline int lowest_bit(std::uint32_t v) {
#if defined(_MSC_VER)
  unsigned long position = 0;
  _BitScanForward(&position, v);
  return static_cast<int>(position);
#else
  return __builtin_ctz(v);
#endif
}

/// The same for 64 bits.
/// \pre `v != 0`
inline int lowest_bit(std::uint64_t v) {
#if defined(_MSC_VER)
  unsigned long position = 0;
  _BitScanForward64(&position, v);
  return static_cast<int>(position);
#else
  return __builtin_ctzll(v);
#endif
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_BITS_H
