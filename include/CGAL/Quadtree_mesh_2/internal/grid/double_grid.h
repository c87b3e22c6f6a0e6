// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The exact map between doubles and the grid of a quadtree.
//
// The grid's unit is a power of two, and its origin a multiple of a power of two. So doubles keep their bits.
// The corners of squares are doubles wherever doubles are as fine as the square.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GRID_DOUBLE_GRID_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GRID_DOUBLE_GRID_H

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Coordinates of greater magnitude are refused, so that the root's corners stay finite.
constexpr double greatest_coordinate() { return 0x1p1000; }

/// Returns the largest integer not above `v * inverse_unit`.
/// \pre `inverse_unit` is a power of two and the result fits
inline std::int64_t floor_of_scaled(double v, double inverse_unit) {
  const double scaled = v * inverse_unit; // exact, unless it underflows
  if (scaled == 0 && v < 0) return -1;
  const std::int64_t toward_zero = static_cast<std::int64_t>(scaled); // no call, unlike std::floor()
  return toward_zero - (static_cast<double>(toward_zero) > scaled ? 1 : 0);
}

/// The side of the root square, and the power of two of which its origin is a multiple.
class Root_side {
public:
  static constexpr int depth = 62;

  /// Finds the smallest root for a box of the given extent whose coordinates have magnitudes up to
  /// `magnitude`.
  Root_side(double extent, double magnitude) {
    // Below 2^-960 the inverse of the unit would overflow; a single point gets a root of side 1.
    exponent_ = extent > 0 ? std::max(std::ilogb(extent) + 1, least_exponent_) : 0;
    const double ulp = magnitude > 0 ? std::ldexp(1.0, std::max(std::ilogb(magnitude), -1022) - 52) : 0;
    for (;; ++exponent_) {
      granule_ = std::max(std::ldexp(side(), -6), 4 * ulp);
      if (4 * granule_ <= side() && extent <= side() / 2 - granule_) break;
    }
  }

  double side() const { return std::ldexp(1.0, exponent_); }
  double unit() const { return std::ldexp(1.0, exponent_ - depth); }
  double inverse_unit() const { return std::ldexp(1.0, depth - exponent_); }
  /// The origin, for a box that begins at `low`: puts the box in the middle half of the root.
  double origin(double low) const { return std::floor(low / granule_) * granule_ - side() / 4; }

private:
  static constexpr int least_exponent_ = -960;
  int exponent_ = 0;
  double granule_ = 0;
};

/// One coordinate of the map between doubles and a grid of 2^62 units.
///
/// Where the origin is within reach of 64-bit integers, coordinates are multiples of the unit counted from 0
/// and the origin is subtracted as an integer. Farther away, doubles are coarse and their difference to the
/// origin is exact.
class Double_axis {
public:
  Double_axis() : Double_axis(Root_side(0, 0), 0) {}
  Double_axis(const Root_side& root, double low)
      : origin_(root.origin(low)), end_(origin_ + root.side()), unit_(root.unit()),
        inverse_unit_(root.inverse_unit()), is_near_(-2 * root.side() <= origin_ && origin_ < root.side()),
        integer_origin_(is_near_ ? static_cast<std::int64_t>(origin_ * inverse_unit_) : 0) {}

  bool contains(double v) const { return origin_ <= v && v < end_; }

  /// Returns the grid line at or next below `v`.
  /// \pre `contains(v)`
  std::uint64_t to_grid(double v) const {
    if (!is_near_) return static_cast<std::uint64_t>((v - origin_) * inverse_unit_);
    return static_cast<std::uint64_t>(floor_of_scaled(v, inverse_unit_)) -
           static_cast<std::uint64_t>(integer_origin_);
  }

  /// Returns the double nearest to grid line `g`; it is exact if any double is.
  /// \pre `g <= 2^62`
  double to_double(std::uint64_t g) const {
    if (!is_near_) return origin_ + static_cast<double>(g) * unit_;
    return static_cast<double>(integer_origin_ + static_cast<std::int64_t>(g)) * unit_;
  }

private:
  double origin_;
  double end_;
  double unit_;
  double inverse_unit_;
  bool is_near_;
  std::int64_t integer_origin_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GRID_DOUBLE_GRID_H
