// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The points of an input without repetitions.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_DISTINCT_POINTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_DISTINCT_POINTS_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel_sort.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The first of each set of equal points, in the order of the input, as the geometry's points. O(n log n).
template <class ConcurrencyTag, class Geometry>
class Distinct_points {
public:
  using Point = typename Geometry::Point;

  template <class Points, class Map>
  Distinct_points(const Points& input, const Map& map) {
    std::vector<Point> all(input.size());
    for_each_index<ConcurrencyTag>(input.size(), [&](std::size_t i) { all[i] = map.to_kernel(input[i]); });
    std::vector<std::uint32_t> order = pack<ConcurrencyTag>(input.size(), [](std::size_t) { return true; });
    sort<ConcurrencyTag>(order.begin(), order.end(), [&all](std::uint32_t i, std::uint32_t j) {
      const Point &p = all[i], &q = all[j];
      return p.x < q.x || (!(q.x < p.x) && (p.y < q.y || (!(q.y < p.y) && i < j)));
    });
    std::vector<std::uint8_t> is_first(order.size(), 1);
    for (std::size_t k = 1; k < order.size(); ++k)
      if (all[order[k]] == all[order[k - 1]]) is_first[order[k]] = 0;
    input_points_ = pack<ConcurrencyTag>(input.size(), [&](std::size_t i) { return is_first[i] != 0; });
    points_.resize(input_points_.size());
    for_each_index<ConcurrencyTag>(points_.size(),
                                   [&](std::size_t i) { points_[i] = all[input_points_[i]]; });
  }

  const std::vector<Point>& points() const { return points_; }
  /// The index in the input of point i.
  std::uint32_t input_point(std::size_t i) const { return input_points_[i]; }

private:
  std::vector<Point> points_;
  std::vector<std::uint32_t> input_points_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_DISTINCT_POINTS_H
