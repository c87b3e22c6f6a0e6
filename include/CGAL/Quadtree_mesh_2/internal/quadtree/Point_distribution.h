// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_POINT_DISTRIBUTION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_POINT_DISTRIBUTION_H

#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>

#include <array>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Finds which points of a square are in which child. Points are in shuffle order, so children have intervals
/// (Lemma 1). Takes O(1) time if one child has all points, otherwise O(log n).
template <class Framework>
class Point_distribution {
public:
  explicit Point_distribution(const Framework& framework)
      : framework_(framework), depth_(framework.grid().depth()) {}

  /// Returns where the points of each child begin, for a square of level `level` with the points from `begin`
  /// to `end`.
  std::array<std::uint32_t, 4> child_begins(int level, std::uint32_t begin, std::uint32_t end) const {
    if (begin == end) return {{begin, end, end, end}};
    const int first = child(begin, level);
    const int last = end - begin == 1 ? first : child(end - 1, level);
    std::array<std::uint32_t, 4> result{{begin, 0, 0, 0}};
    for (int q = 1; q < 4; ++q) {
      std::uint32_t& child_begin = result[std::size_t(q)];
      if (q <= first)
        child_begin = begin;
      else if (q > last)
        child_begin = end;
      else
        child_begin = first_point_from(q, level, result[std::size_t(q) - 1], end);
    }
    return result;
  }

private:
  int child(std::uint32_t rank, int level) const {
    return quadrant(framework_.grid_point(typename Framework::Point_rank(rank)), level, depth_);
  }

  /// The first point from `begin` on in child `q` or a later one. Takes steps of growing length from the
  /// beginning, so that few points cost little.
  std::uint32_t first_point_from(int q, int level, std::uint32_t begin, std::uint32_t end) const {
    std::uint32_t step = 1;
    while (step < end - begin && child(begin + step - 1, level) < q) {
      begin += step;
      step *= 2;
    }
    end = step < end - begin ? begin + step : end;
    while (begin < end) {
      const std::uint32_t middle = begin + (end - begin) / 2;
      if (child(middle, level) < q)
        begin = middle + 1;
      else
        end = middle;
    }
    return begin;
  }

  const Framework& framework_;
  int depth_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_POINT_DISTRIBUTION_H
