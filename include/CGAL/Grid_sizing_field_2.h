// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_GRID_SIZING_FIELD_2_H
#define CGAL_GRID_SIZING_FIELD_2_H

#include <CGAL/Points_sizing_field_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// A sizing field from sizes on a regular grid, bilinear between them, for `Quality_mesh_options_2::size()`.
///
/// Outside the grid the size is that of the nearest place in it. An infinite size on the grid means that there
/// is no bound around it: the size is infinite where such a place is the nearest of the grid, and elsewhere
/// infinite sizes do not count among the four that the size is between. Copies are deep. Several threads may
/// call it at once. O(1) time per call.
/// \cgalModels{SizingField_2}
class Grid_sizing_field_2 {
public:
  /// A field of the sizes of a grid.
  /// \param origin the place of the first size.
  /// \param spacing the distances of neighbors in x and y; positive.
  /// \param columns, rows the numbers of sizes in x and y; at least one.
  /// \param sizes positive, row by row: the size at `origin + (i * spacing[0], j * spacing[1])` is
  /// `sizes[j * columns + i]`. Infinity means no bound.
  /// \throws std::invalid_argument if an argument violates these requirements.
  Grid_sizing_field_2(const std::array<double, 2>& origin, const std::array<double, 2>& spacing,
                      std::size_t columns, std::size_t rows, std::vector<double> sizes)
      : origin_(origin), spacing_(spacing), count_{columns, rows}, sizes_(std::move(sizes)) {
    if (columns == 0 || rows == 0 || sizes_.size() / columns != rows || sizes_.size() % columns != 0)
      throw std::invalid_argument("a sizing grid needs columns times rows sizes");
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (!std::isfinite(origin[axis]) || !(spacing[axis] > 0) || !std::isfinite(spacing[axis]))
        throw std::invalid_argument("the spacing of a sizing grid has to be positive");
    for (const double size : sizes_)
      if (!(size > 0)) throw std::invalid_argument("the sizes of a sizing grid have to be positive");
  }

  /// The size at (x, y); infinite if there is no bound.
  double operator()(double x, double y) const {
    const Cell i = cell(x, 0), j = cell(y, 1);
    const double low = between(size(i.low, j.low), size(i.high, j.low), i.share);
    const double high = between(size(i.low, j.high), size(i.high, j.high), i.share);
    const double result = between(low, high, j.share);
    return std::isfinite(result) ? result : among_finite(i, j);
  }

  /// Makes sizes smaller, so that they grow by at most `gradient` over a unit of length: the size at each place
  /// p of the grid becomes the least of `size at q + gradient * |p - q|` over all places q of the grid.
  ///
  /// These are the largest sizes h, none above those before, with |h(p) - h(q)| <= gradient * |p - q| for any
  /// two places of the grid. For any two places of the plane |h(p) - h(q)| <= sqrt(2) * gradient * |p - q|,
  /// without the root for a grid of one row or column. For on a side of a cell h grows by no more than
  /// `gradient`, and between sides its partial derivatives are means of those on them. Infinite sizes
  /// become finite, unless all are infinite. By a k-d tree: O(n log n) time where sizes grow no faster than the
  /// gradient nearly everywhere, O(n) memory.
  /// \param gradient at least 0. A mesh follows up to about 1; 0.1 to 0.3 is usual for flow.
  /// \throws std::invalid_argument if the gradient is negative or not finite; sizes are then unchanged.
  Grid_sizing_field_2& limit_gradient(double gradient) {
    if (!(gradient >= 0) || !std::isfinite(gradient))
      throw std::invalid_argument("the gradient of a sizing grid must not be negative");
    std::vector<Points_sizing_field_2::Sized_point> sources;
    for_each_place([&](double x, double y, double& size) {
      if (std::isfinite(size)) sources.push_back({x, y, size});
    });
    if (sources.empty()) return *this;
    const Points_sizing_field_2 limited(std::move(sources), gradient);
    for_each_place([&](double x, double y, double& size) { size = limited(x, y); });
    return *this;
  }

private:
  std::array<double, 2> origin_, spacing_;
  std::array<std::size_t, 2> count_;
  std::vector<double> sizes_;

  double size(std::size_t column, std::size_t row) const { return sizes_[row * count_[0] + column]; }
  static double between(double low, double high, double share) { return (1 - share) * low + share * high; }

  /// Calls `visit(x, y, size)` for all places of the grid, from its origin: so no digits are lost far away.
  template <class Visit>
  void for_each_place(Visit visit) {
    for (std::size_t j = 0; j < count_[1]; ++j)
      for (std::size_t i = 0; i < count_[0]; ++i)
        visit(static_cast<double>(i) * spacing_[0], static_cast<double>(j) * spacing_[1],
              sizes_[j * count_[0] + i]);
  }

  struct Cell {
    std::size_t low, high;
    double share; ///< of the way from low to high
  };
  Cell cell(double coordinate, std::size_t axis) const {
    const std::size_t last = count_[axis] - 1;
    const double place =
        std::min(std::max((coordinate - origin_[axis]) / spacing_[axis], 0.0), static_cast<double>(last));
    const std::size_t low = std::min(static_cast<std::size_t>(place), last);
    return {low, std::min(low + 1, last), place - static_cast<double>(low)};
  }

  /// The mean of the finite sizes around a place, by their shares; infinite if the nearest one is.
  double among_finite(const Cell& i, const Cell& j) const {
    if (!std::isfinite(size(i.share < 0.5 ? i.low : i.high, j.share < 0.5 ? j.low : j.high)))
      return std::numeric_limits<double>::infinity();
    double sum = 0, weight = 0;
    const auto add = [&](double size, double share) {
      if (std::isfinite(size)) sum += share * size, weight += share;
    };
    add(size(i.low, j.low), (1 - i.share) * (1 - j.share)), add(size(i.high, j.low), i.share * (1 - j.share));
    add(size(i.low, j.high), (1 - i.share) * j.share), add(size(i.high, j.high), i.share * j.share);
    return sum / weight;
  }
};

} // namespace CGAL

#endif // CGAL_GRID_SIZING_FIELD_2_H
