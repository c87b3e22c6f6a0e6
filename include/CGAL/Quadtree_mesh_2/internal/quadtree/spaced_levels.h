// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_SPACED_LEVELS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_SPACED_LEVELS_H

#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Returns the distance of spaced levels for `n` points: the logarithm, rounded up. It is 3 at least, so that cross
/// pointers between spaced levels do not depend on those two levels above (Spaced_levels_grower.h).
inline int spacing_of_levels(std::size_t n) {
  return std::max(3, bit_width(std::uint64_t(std::max<std::size_t>(n, 1) - 1)));
}

/// Returns the offset below `spacing` of the levels, `spacing` apart, that have the fewest squares (Theorem 2:
/// at most one square in `spacing` is on them). Level l has `level_begin[l + 1] - level_begin[l]` squares.
template <class ConcurrencyTag, class Count>
int offset_of_spaced_levels(const std::vector<Count>& level_begin, int spacing) {
  const std::size_t n = static_cast<std::size_t>(spacing);
  using Sums = std::vector<std::size_t>; // by offset
  const Sums squares = reduce<ConcurrencyTag>(
      level_begin.size() - 1, Sums(n, 0),
      [&](std::size_t begin, std::size_t end) {
        Sums sums(n, 0);
        for (std::size_t l = begin; l < end; ++l) sums[l % n] += level_begin[l + 1] - level_begin[l];
        return sums;
      },
      [n](Sums a, const Sums& b) {
        for (std::size_t i = 0; i < n; ++i) a[i] += b[i];
        return a;
      });
  return static_cast<int>(std::min_element(squares.begin(), squares.end()) - squares.begin());
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_SPACED_LEVELS_H
