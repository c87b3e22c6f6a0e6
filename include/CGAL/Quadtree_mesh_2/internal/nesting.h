// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The nesting of intervals that a sequence of levels induces.
//
// Computes: given the level between each pair of neighbours of a sequence, the maximal intervals whose inner
// levels are
//           all at least as deep as the least of them, in preorder; and for each its parent and the end of
//           its subtree.
// Bound:    O(n).
// Source:   Bern, Eppstein, Teng, Lemma 3: all nearest larger values; sequentially a stack finds them.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_NESTING_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_NESTING_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The members `begin` to `end` of a sequence, and the least level between two neighbours among them.
struct Nested_interval {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint8_t level;
};

/// Returns the intervals induced by `levels` in preorder, `levels[i]` being between members i and i + 1.
/// Gaps of equal level with no lesser level between them give the same interval, once.
inline std::vector<Nested_interval> nested_intervals(const std::vector<std::uint8_t>& levels) {
  struct Open {
    std::uint32_t end;
    std::uint32_t leftmost_gap;
    std::uint8_t level;
  };
  std::vector<Nested_interval> closed;
  closed.reserve(levels.size());
  std::vector<Open> open; // levels increase towards the top
  const auto close = [&](std::uint32_t begin) {
    closed.push_back({begin, open.back().end, open.back().level});
    open.pop_back();
  };

  // From right to left an interval closes after those inside it, the right ones first: preorder backwards.
  for (std::size_t i = levels.size(); i-- > 0;) {
    const std::uint32_t gap = static_cast<std::uint32_t>(i);
    while (!open.empty() && open.back().level > levels[i]) close(gap + 1);
    if (open.empty())
      open.push_back({static_cast<std::uint32_t>(levels.size() + 1), gap, levels[i]});
    else if (open.back().level < levels[i])
      open.push_back({open.back().leftmost_gap + 1, gap, levels[i]});
    else
      open.back().leftmost_gap = gap;
  }
  while (!open.empty()) close(0);
  std::reverse(closed.begin(), closed.end());
  return closed;
}

/// Finds the parent of each of the intervals `[begin[i], end[i])`, given in preorder, and the first interval
/// after its descendants. Roots get the greatest number as parent.
inline void link_nested_intervals(const std::vector<std::uint32_t>& begin,
                                  const std::vector<std::uint32_t>& end, std::vector<std::uint32_t>& parent,
                                  std::vector<std::uint32_t>& subtree_end) {
  const std::uint32_t n = static_cast<std::uint32_t>(begin.size());
  parent.assign(n, std::numeric_limits<std::uint32_t>::max());
  subtree_end.assign(n, n);
  std::vector<std::uint32_t> ancestors;
  for (std::uint32_t i = 0; i < n; ++i) {
    while (!ancestors.empty() && end[ancestors.back()] <= begin[i]) {
      subtree_end[ancestors.back()] = i;
      ancestors.pop_back();
    }
    if (!ancestors.empty()) parent[i] = ancestors.back();
    ancestors.push_back(i);
  }
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_NESTING_H
