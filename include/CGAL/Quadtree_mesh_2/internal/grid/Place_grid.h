// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The order of places: the shuffle order on a grid that holds a set of points, all doubles allowed.
//
// Computes: from the box of the points a grid of 2^62 units, and of each point the unit square that it lies in. The
//           same box gives the same grid, wherever it was found. `sorted_by_place()` puts points in order.
// Bound:    O(1) for the grid and each square. O(n) work by digits to sort (sort_by_keys.h), and comparisons of points
//           that share a square.
// Source:   the shuffle order of Bern, Eppstein, Teng (morton.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GRID_PLACE_GRID_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GRID_PLACE_GRID_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/double_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The least box of a set of places; empty at first.
struct Double_box {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> low{infinity, infinity}, high{-infinity, -infinity};

  bool is_empty() const { return low[0] > high[0]; }
  void add(double x, double y) { merge({{x, y}, {x, y}}); }
  void merge(const Double_box& box) {
    for (std::size_t k = 0; k < 2; ++k)
      low[k] = std::min(low[k], box.low[k]), high[k] = std::max(high[k], box.high[k]);
  }
  /// The greatest magnitude of a coordinate.
  double magnitude() const {
    return std::max({std::abs(low[0]), std::abs(low[1]), std::abs(high[0]), std::abs(high[1])});
  }
};

/// The squares of a grid that holds a box.
class Place_grid {
public:
  explicit Place_grid(Double_box box) {
    if (box.is_empty()) box.add(0, 0);
    // So that differences do not overflow. What underflows shares a square with others.
    if (box.magnitude() > greatest_coordinate()) scale_ = 0x1p-64;
    for (std::size_t k = 0; k < 2; ++k) box.low[k] *= scale_, box.high[k] *= scale_;
    const double extent = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
    const Root_side root(extent, box.magnitude());
    x_ = Double_axis(root, box.low[0]), y_ = Double_axis(root, box.low[1]);
  }

  /// \pre the place is in the box
  Grid_point_2<std::uint64_t> operator()(double x, double y) const {
    return {x_.to_grid(x * scale_), y_.to_grid(y * scale_)};
  }

private:
  double scale_ = 1;
  Double_axis x_, y_;
};

/// Returns the squares of items in shuffle order, with the order of the items.
/// \param square_at called as `square_at(i)`, several times for each and by several threads at once, returns the square
///        of an item
/// \param less compares items that share a square
/// \pre `n < 2^32`
template <class ConcurrencyTag = Sequential_tag, class Square_at, class Less>
auto sorted_by_place(std::size_t n, const Square_at& square_at, const Less& less) {
  auto sorted = shuffled<ConcurrencyTag>(n, square_at);
  for_each_index<ConcurrencyTag>(n, [&](std::size_t begin) {
    const auto is_here = [&, &square = sorted.keys[begin]](std::size_t i) {
      return sorted.keys[i] == square;
    };
    if (begin > 0 && is_here(begin - 1)) return;
    std::size_t end = begin + 1;
    while (end < n && is_here(end)) ++end;
    if (end - begin > 1) std::sort(sorted.order.data() + begin, sorted.order.data() + end, less);
  });
  return sorted;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GRID_PLACE_GRID_H
