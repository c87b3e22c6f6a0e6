// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The meshing kernel's points on an axis-parallel grid of 2^62 units to a side, and places of the grid as
// points. For double and for integer coordinates (for exact ones: exact_axis_parallel_grid.h).
//
// The root is the smallest square with a power of two as its side that has the points in its middle half. In
// each coordinate, points go to the grid line at or next below them. Grid points go back to the point there
// if there is one, otherwise to the nearest. Rotations make places between and beside grid points; these are
// given as fractions.
//
// Over integers the root may exceed the range of words. It is in the range for points in the middle half of
// that range.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_AXIS_PARALLEL_GRID_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_AXIS_PARALLEL_GRID_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/Gaussian_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/double_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Wide_grid_point = Grid_point_2<std::uint64_t>;

/// An integer and a part of one, with 0 <= remainder < divisor < 2^58.
struct Wide_fraction {
  Wide_integer integer = 0;
  std::int64_t remainder = 0, divisor = 1;

  static Wide_fraction of(Wide_integer numerator, std::int64_t divisor) {
    Wide_integer quotient = numerator / divisor, remainder = numerator % divisor;
    if (remainder < 0) remainder += divisor, --quotient;
    return {quotient, static_cast<std::int64_t>(remainder), divisor};
  }
  Wide_integer nearest() const { return integer + (remainder >= divisor - remainder ? 1 : 0); }
};

/// Low and high ends of coordinates, of which `double` and `std::int64_t` are types.
template <class Coordinate>
struct Place_ranges {
  Coordinate low_x = std::numeric_limits<Coordinate>::max(),
             high_x = std::numeric_limits<Coordinate>::lowest();
  Coordinate low_y = low_x, high_y = high_x;

  void add(Coordinate x, Coordinate y) {
    low_x = std::min(low_x, x), high_x = std::max(high_x, x);
    low_y = std::min(low_y, y), high_y = std::max(high_y, y);
  }
  static Place_ranges combine(Place_ranges a, const Place_ranges& b) {
    a.low_x = std::min(a.low_x, b.low_x), a.high_x = std::max(a.high_x, b.high_x);
    a.low_y = std::min(a.low_y, b.low_y), a.high_y = std::max(a.high_y, b.high_y);
    return a;
  }
  /// \pre there is a point
  Coordinate extent() const { return std::max(high_x - low_x, high_y - low_y); }
  bool is_empty() const { return high_x < low_x; }
};

/// The ranges of n places; `place(i, ranges)` adds that of index i.
template <class ConcurrencyTag, class Coordinate, class Add>
Place_ranges<Coordinate> ranges_of_places(std::size_t n, const Add& add) {
  return reduce<ConcurrencyTag>(
      n, Place_ranges<Coordinate>(),
      [&](std::size_t begin, std::size_t end) {
        Place_ranges<Coordinate> ranges;
        for (std::size_t i = begin; i < end; ++i) add(i, ranges);
        return ranges;
      },
      Place_ranges<Coordinate>::combine);
}

/// One coordinate of a grid over doubles, with places beside the grid, too.
class Rounding_axis {
public:
  Rounding_axis() : Rounding_axis(Root_side(0, 0), 0) {}
  Rounding_axis(const Root_side& root, double low)
      : axis_(root, low), origin_(root.origin(low)), exponent_(std::ilogb(root.unit())) {}

  std::uint64_t to_grid(double v) const { return axis_.to_grid(v); }
  double to_double(std::uint64_t g) const { return axis_.to_double(g); }

  /// The nearest double, or one next to it where the origin is far away.
  double to_double(const Wide_fraction& g) const {
    const double units = std::ldexp(origin_, -exponent_);
    if (std::fabs(units) > 0x1p63) return origin_ + std::ldexp(static_cast<double>(g.nearest()), exponent_);
    constexpr int bits = 60;
    const Wide_integer one = Wide_integer(1) << bits;
    const Wide_integer part = (g.remainder * one) / g.divisor;
    const Wide_integer sum = (static_cast<Wide_integer>(units) + g.integer) * one + part;
    return std::ldexp(static_cast<double>(sum), exponent_ - bits);
  }

  double origin() const { return origin_; }
  /// The unit is this power of 2.
  int exponent() const { return exponent_; }

private:
  Double_axis axis_;
  double origin_;
  int exponent_;
};

template <class Geometry>
class Axis_parallel_grid;

/// Over doubles.
template <class Kernel>
class Axis_parallel_grid<Double_geometry_2<Kernel>> {
public:
  using Point = typename Double_geometry_2<Kernel>::Point;

  /// \param points with finite coordinates below 2^1000; for none the root has side 1
  template <class ConcurrencyTag>
  static Axis_parallel_grid of(const std::vector<Point>& points) {
    const auto ranges = ranges_of_places<ConcurrencyTag, double>(
        points.size(), [&](std::size_t i, Place_ranges<double>& r) { r.add(points[i].x, points[i].y); });
    return ranges.is_empty() ? Axis_parallel_grid() : Axis_parallel_grid(ranges);
  }

  Wide_grid_point to_grid(Point p) const { return {x_.to_grid(p.x), y_.to_grid(p.y)}; }
  Point to_point(const Wide_grid_point& g) const { return {x_.to_double(g.x), y_.to_double(g.y)}; }
  Point to_point(const Wide_fraction& x, const Wide_fraction& y) const {
    return {x_.to_double(x), y_.to_double(y)};
  }

private:
  Rounding_axis x_, y_;

  Axis_parallel_grid() = default;
  explicit Axis_parallel_grid(const Place_ranges<double>& r) {
    const double extent = r.extent();
    const double magnitude =
        std::max({std::fabs(r.low_x), std::fabs(r.high_x), std::fabs(r.low_y), std::fabs(r.high_y)});
    // The difference may have been rounded down; the next double never is too small.
    const Root_side root(extent > 0 ? std::nextafter(extent, 2 * extent) : 0, magnitude);
    x_ = Rounding_axis(root, r.low_x);
    y_ = Rounding_axis(root, r.low_y);
  }
};

/// One coordinate of a grid over integers.
class Integer_axis {
public:
  /// For a root with side 2^exponent, for coordinates from `low` to `high`.
  Integer_axis(int exponent, std::int64_t low, std::int64_t high) : shift_(62 - exponent) {
    const std::int64_t quarter = std::int64_t(1) << (exponent - 2);
    origin_ = low - quarter;
    // In the range of words if the coordinates stay in the middle half.
    constexpr std::int64_t end = std::int64_t(1) << 62;
    if (exponent <= 62) origin_ = std::min(origin_, end - 4 * quarter);
    if (high - origin_ >= 3 * quarter) origin_ = low - quarter;
  }

  std::uint64_t to_grid(std::int64_t v) const {
    const std::uint64_t w = static_cast<std::uint64_t>(v) - static_cast<std::uint64_t>(origin_);
    return shift_ >= 0 ? w << shift_ : w >> -shift_;
  }
  std::int64_t to_integer(const Wide_fraction& g) const {
    if (shift_ <= 0) return static_cast<std::int64_t>(origin_ + g.nearest() * (Wide_integer(1) << -shift_));
    const Wide_integer unit = Wide_integer(1) << shift_;
    return static_cast<std::int64_t>(origin_ +
                                     Wide_fraction::of(g.integer + unit / 2, std::int64_t(unit)).integer);
  }

private:
  int shift_;
  std::int64_t origin_;
};

/// Over words, in signed ones: of extents up to 2^62.
template <class Word>
class Axis_parallel_grid<Integer_geometry_2<Word>> {
public:
  using Point = typename Integer_geometry_2<Word>::Point;

  /// \param points with coordinates from 0 to 2^62; for none the root has the least side
  template <class ConcurrencyTag>
  static Axis_parallel_grid of(const std::vector<Point>& points) {
    auto ranges = ranges_of_places<ConcurrencyTag, std::int64_t>(
        points.size(),
        [&](std::size_t i, Place_ranges<std::int64_t>& r) { r.add(points[i].x, points[i].y); });
    if (ranges.is_empty()) ranges.add(least_side / 4, least_side / 4);
    return Axis_parallel_grid(ranges);
  }

  Wide_grid_point to_grid(Point p) const { return {x_.to_grid(p.x), y_.to_grid(p.y)}; }
  Point to_point(const Wide_grid_point& g) const {
    return to_point(Wide_fraction{Wide_integer(g.x)}, Wide_fraction{Wide_integer(g.y)});
  }
  Point to_point(const Wide_fraction& x, const Wide_fraction& y) const {
    return {x_.to_integer(x), y_.to_integer(y)};
  }

private:
  /// So that there is room between few points, too.
  static constexpr int least_exponent = 16;
  static constexpr std::int64_t least_side = std::int64_t(1) << least_exponent;

  Integer_axis x_, y_;

  explicit Axis_parallel_grid(const Place_ranges<std::int64_t>& r)
      : x_(exponent_for(r.extent()), r.low_x, r.high_x), y_(exponent_for(r.extent()), r.low_y, r.high_y) {}

  static int exponent_for(std::int64_t extent) {
    int exponent = least_exponent;
    while (extent >= std::int64_t(1) << (exponent - 1)) ++exponent;
    return exponent;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_AXIS_PARALLEL_GRID_H
