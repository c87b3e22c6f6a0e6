// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Points with exact coordinates on a grid of 2^62 units to a side (see Axis_parallel_grid.h).
//
// Points go to the grid lines at or next below them, without rounding. Places of the grid go to points
// exactly. Fractions of units are rounded to 2^-20. So all coordinates but the user's have at most 106 bits.
// Two doubles hold these, and none needs long numbers.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_EXACT_AXIS_PARALLEL_GRID_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_EXACT_AXIS_PARALLEL_GRID_H

#include <CGAL/Quadtree_mesh_2/internal/frame/Axis_parallel_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/exact_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/exact_grid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// One coordinate.
template <class Field>
class Exact_axis {
public:
  using Coordinate = Exact_coordinate<Field>;

  Exact_axis() : Exact_axis(Root_side(0, 0), 0) {}
  Exact_axis(const Root_side& root, double low) : axis_(root, low), floor_(-axis_.exponent()) {}

  std::uint64_t to_grid(const Coordinate& c) const {
    if (c.is_double()) return axis_.to_grid(c.high());
    return static_cast<std::uint64_t>(floor_(Field(c.exact() - Field(axis_.origin()))));
  }

  Coordinate to_coordinate(std::uint64_t g) const {
    const double nearest = axis_.to_double(g);
    // Doubles that are coarser than the grid are grid lines: the nearest one is this line or another.
    if (axis_.to_grid(nearest) == g) return Coordinate(nearest);
    return to_coordinate(Wide_fraction{Wide_integer(g)});
  }
  /// Rounded to a share of the unit that is far below all angles, and leaves coordinates the sum of two doubles.
  Coordinate to_coordinate(const Wide_fraction& g) const {
    constexpr int bits = 20;
    const Wide_integer one = Wide_integer(1) << bits;
    const Wide_integer units = g.integer * one + (g.remainder * one + g.divisor / 2) / g.divisor;
    const double most = static_cast<double>(units);
    const double rest = static_cast<double>(units - static_cast<Wide_integer>(most));
    const int exponent = axis_.exponent() - bits;
    return Coordinate::of_parts(axis_.origin(), std::ldexp(most, exponent), std::ldexp(rest, exponent));
  }

private:
  Rounding_axis axis_;
  Floor_of_scaled<Field> floor_;
};

template <class Kernel>
class Axis_parallel_grid<Exact_geometry_2<Kernel>> {
  using Field = typename Exact_geometry_2<Kernel>::Field;

public:
  using Point = typename Exact_geometry_2<Kernel>::Point;

  template <class ConcurrencyTag>
  static Axis_parallel_grid of(const std::vector<Point>& points) {
    const auto ranges =
        ranges_of_places<ConcurrencyTag, double>(points.size(), [&](std::size_t i, Place_ranges<double>& r) {
          r.add(points[i].x.high(), points[i].y.high());
        });
    return ranges.is_empty() ? Axis_parallel_grid() : Axis_parallel_grid(ranges);
  }

  Wide_grid_point to_grid(const Point& p) const { return {x_.to_grid(p.x), y_.to_grid(p.y)}; }
  Point to_point(const Wide_grid_point& g) const { return {x_.to_coordinate(g.x), y_.to_coordinate(g.y)}; }
  Point to_point(const Wide_fraction& x, const Wide_fraction& y) const {
    return {x_.to_coordinate(x), y_.to_coordinate(y)};
  }

private:
  Exact_axis<Field> x_, y_;

  Axis_parallel_grid() = default;
  /// The ranges are those of the nearest doubles, so all coordinates are between the doubles beside them.
  explicit Axis_parallel_grid(const Place_ranges<double>& r) {
    const auto below = [](double v) { return std::nextafter(v, std::numeric_limits<double>::lowest()); };
    const double magnitude =
        std::max({std::fabs(r.low_x), std::fabs(r.high_x), std::fabs(r.low_y), std::fabs(r.high_y)});
    const double extent = r.extent() + 4 * (std::nextafter(magnitude, 2 * magnitude + 1) - magnitude);
    const Root_side root(r.extent() > 0 ? extent : 0, magnitude);
    x_ = Exact_axis<Field>(root, below(r.low_x));
    y_ = Exact_axis<Field>(root, below(r.low_y));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_EXACT_AXIS_PARALLEL_GRID_H
