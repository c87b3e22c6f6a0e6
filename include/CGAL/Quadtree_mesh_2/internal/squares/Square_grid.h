// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The grid of the squares that fill the bulk of a mesh: where the root square lies and how large it is.
//
// Sides have at most 20 significant bits, and the origin is a multiple of the last of them. So all corners
// down to the finest level are exact coordinates. Squares are exactly square, and their corners are exactly
// cocircular.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_SQUARE_GRID_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_SQUARE_GRID_H

#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A square of the grid: its lower left corner, and its side as a power of two.
struct Grid_square {
  std::uint32_t x = 0, y = 0;
  int level = 0;

  static constexpr int depth = Fixed_point_quadtree_traits_2<std::uint32_t>::depth;
  std::uint32_t side() const { return std::uint32_t(1) << (depth - level); }
  /// Child 2 i + j has x offset i and y offset j.
  Grid_square child(int i) const {
    const std::uint32_t half = side() / 2;
    return {x + ((i & 2) != 0 ? half : 0), y + ((i & 1) != 0 ? half : 0), level + 1};
  }
};

template <class Geometry>
class Square_grid {
public:
  using Point = typename Geometry::Point;

  /// The grid that covers the box from `low` to `high` and has a level with squares of side `side`, or a
  /// little less: a whole number of them then fits the longer side of the box.
  Square_grid(const Point& low, const Point& high, double side) {
    const Vector size = Geometry::difference(high, low);
    extent_ = std::max(size.x, size.y);
    const double number = extent_ / side;
    if (!(number < 0x1p28)) return;
    if (number > least_number_to_fit) side = extent_ / std::ceil(number * (1 - 1e-12));
    const int ulp = std::ilogb(resolution(low, high));
    const int exact_bits = std::ilogb(side) - ulp + 1;
    if (exact_bits < 1) return;
    const int bits =
        std::min(significant_bits, exact_bits > 2 * spare_levels ? exact_bits - spare_levels : exact_bits);
    int exponent = 0;
    const double significand = std::floor(std::ldexp(std::frexp(side, &exponent), bits));
    // Few bits may make it much shorter. Squares of the bulk stay clear of the box by more than a quarter of that.
    const double rounded_side = std::ldexp(significand, exponent - bits);
    while (std::ldexp(rounded_side, given_level_) < extent_ - 0.25 * rounded_side) ++given_level_;
    exponent += given_level_ - bits;
    root_ = std::ldexp(significand, exponent);
    unit_ = std::ldexp(root_, -Grid_square::depth);
    finest_level_ = std::min(finest_possible_level, exponent - ulp);
    origin_ = Geometry::nearest_corner(low, std::ldexp(1.0, exponent - std::max(finest_level_, 0)));
  }

  /// The level of the squares of the side asked for.
  int given_level() const { return given_level_; }
  /// The deepest level with exact corners; below the given one where there is no such grid.
  int finest_level() const { return finest_level_; }
  /// The longer side of the box.
  double extent() const { return extent_; }

  double side(int level) const { return std::ldexp(root_, -level); }
  /// The corner of a square relative to the origin.
  Vector corner(std::uint32_t x, std::uint32_t y) const { return {x * unit_, y * unit_}; }
  Point point(std::uint32_t x, std::uint32_t y) const { return Geometry::translate(origin_, corner(x, y)); }
  Point point(Vector v) const { return Geometry::translate(origin_, v); }
  Vector vector(const Point& p) const { return Geometry::difference(p, origin_); }

private:
  static constexpr int significant_bits = 20;
  /// Finer than the given one, for which coordinates leave room rather than for more significant bits.
  static constexpr int spare_levels = 4;
  static constexpr int finest_possible_level = 28;
  /// Of squares along the box, from which on the side may shrink for a whole number of them to fit.
  static constexpr double least_number_to_fit = 32;

  Point origin_{};
  double root_ = 0, unit_ = 0, extent_ = 0;
  int given_level_ = 0, finest_level_ = -1;

  /// A power of two of which all coordinates near the box are representable multiples.
  static double resolution(const Point& low, const Point& high) {
    if constexpr (Geometry::has_unlimited_coordinates) {
      const Vector l = Geometry::difference(low, Point()), h = Geometry::difference(high, Point());
      const double largest =
          std::max(std::max(std::fabs(l.x), std::fabs(l.y)), std::max(std::fabs(h.x), std::fabs(h.y)));
      return std::ldexp(1.0, std::ilogb(largest) - 51);
    } else {
      // A step further out the spacing may be the next power of two, but for integers.
      constexpr double steps = std::is_integral<typename Geometry::Coordinate>::value ? 1 : 2;
      return steps * std::max(Geometry::spacing(low), Geometry::spacing(high));
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_SQUARE_GRID_H
