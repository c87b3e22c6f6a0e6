// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_GRID_SIZING_FIELD_2_H
#define CGAL_GRID_SIZING_FIELD_2_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// A sizing field from sizes on a regular grid, bilinear between them, for `Quality_mesh_options_2::size()`.
///
/// Outside the grid the size is that of the nearest place in it. Copies are deep. Several threads may call it
/// at once. O(1) time per call.
/// \cgalModels{SizingField_2}
class Grid_sizing_field_2 {
public:
  /// \param origin the place of the first size.
  /// \param spacing the distances of neighbors in x and y; positive.
  /// \param columns, rows the numbers of sizes in x and y; at least one.
  /// \param sizes positive, row by row: the size at `origin + (i * spacing[0], j * spacing[1])` is
  /// `sizes[j * columns + i]`.
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

  /// The size at (x, y).
  double operator()(double x, double y) const {
    const Cell i = cell(x, 0), j = cell(y, 1);
    const auto in_row = [&](std::size_t row) {
      const double* sizes = sizes_.data() + row * count_[0];
      return (1 - i.share) * sizes[i.low] + i.share * sizes[i.high];
    };
    return (1 - j.share) * in_row(j.low) + j.share * in_row(j.high);
  }

private:
  std::array<double, 2> origin_, spacing_;
  std::array<std::size_t, 2> count_;
  std::vector<double> sizes_;

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
};

} // namespace CGAL

#endif // CGAL_GRID_SIZING_FIELD_2_H
