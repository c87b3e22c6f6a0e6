// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// An order of points in which neighbors are near each other, however much their distances differ.
//
// Computes: the shuffle order of the squares of a grid with 2^32 to a side around the points. Points that share a
//           square are put in the order of a grid around them, and so on.
// Bound:    O(n) work in O(1) rounds, and that again for the points of shared squares. Each time their extent is at
//           least 2^31 times smaller. So doubles take 70 grids at most, and mostly one.
// Source:   the shuffle order of Bern, Eppstein, Teng, section 2.
// Deviates: squares of a grid are not those of the one before. What reads the order wants short ways, not a quadtree.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_ORDER_OF_PLACES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_ORDER_OF_PLACES_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/place_box.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Place_sorter {
public:
  using Point = typename Geometry::Point;

  explicit Place_sorter(const std::vector<Point>& points) : points_(points), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
  }

  Order run() {
    sort_run({0, order_.size()});
    return std::move(order_);
  }

private:
  /// Points in consecutive places of the order, as a range of these.
  struct Run {
    std::size_t begin, end;
    std::size_t size() const { return end - begin; }
  };

  /// So few points need no order.
  static constexpr std::size_t most_in_a_square_ = 8;
  static constexpr double last_square_ = 4294967295.0;

  const std::vector<Point>& points_;
  Order order_;

  void sort_run(Run run) {
    if (run.size() <= most_in_a_square_) return;
    std::vector<Point> places(run.size());
    for_each_index<ConcurrencyTag>(run.size(),
                                   [&](std::size_t i) { places[i] = points_[order_[run.begin + i]]; });
    const auto box = place_box<ConcurrencyTag>(places);
    const Vector size = Geometry::difference(box.high, box.low);
    const double side = std::max(size.x, size.y);
    if (!(side > 0)) return; // what doubles do not tell apart
    const auto sorted = sort_by_keys<ConcurrencyTag>(run.size(), [&](std::size_t i) {
      const Vector d = Geometry::difference(places[i], box.low);
      // the quotient first: its reciprocal may be beyond the doubles
      return interleave(static_cast<std::uint32_t>(d.x / side * last_square_),
                        static_cast<std::uint32_t>(d.y / side * last_square_));
    });
    const Order before(order_.begin() + static_cast<std::ptrdiff_t>(run.begin),
                       order_.begin() + static_cast<std::ptrdiff_t>(run.end));
    for_each_index<ConcurrencyTag>(run.size(),
                                   [&](std::size_t i) { order_[run.begin + i] = before[sorted.order[i]]; });
    const std::vector<Run> crowds = crowded_squares(sorted.keys);
    for_each_index<ConcurrencyTag>(
        crowds.size(),
        [&](std::size_t k) {
          sort_run({run.begin + crowds[k].begin, run.begin + crowds[k].end});
        },
        1);
  }

  /// The squares with too many points, by the places of these. The points are not all in one square: those with the
  /// least and the greatest coordinate are not.
  static std::vector<Run> crowded_squares(const Uninitialized_vector<std::uint64_t>& keys) {
    const std::size_t n = keys.size();
    const auto end_of_square = [&](std::size_t i) {
      return static_cast<std::size_t>(
          std::upper_bound(keys.begin() + static_cast<std::ptrdiff_t>(i), keys.end(), keys[i]) -
          keys.begin());
    };
    return pack_values<ConcurrencyTag, Run>(
        n,
        [&](std::size_t i) {
          return (i == 0 || keys[i - 1] != keys[i]) && i + most_in_a_square_ < n &&
                 keys[i + most_in_a_square_] == keys[i];
        },
        [&](std::size_t i) {
          return Run{i, end_of_square(i)};
        });
  }
};

/// Returns the indices of points, all of them different, in such an order.
template <class ConcurrencyTag, class Geometry>
Order order_of_places(const std::vector<typename Geometry::Point>& points) {
  return Place_sorter<ConcurrencyTag, Geometry>(points).run();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_ORDER_OF_PLACES_H
