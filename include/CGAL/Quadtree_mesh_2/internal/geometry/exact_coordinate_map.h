// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The points of an exact kernel, of any scale and anywhere, to the meshing kernel's points and back, exactly.
// The meshing kernel's coordinates are of the order of 1.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_EXACT_COORDINATE_MAP_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_EXACT_COORDINATE_MAP_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/exact_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Scaled_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/exact_grid.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The input is scaled by the power of two with which its extent is about 1. What lies further than 2^20 extents
/// from 0 is moved, too, by a multiple of the extent's power of two; nearer to 0 it is not, so that doubles stay
/// doubles.
template <class Traits, class Kernel>
class Coordinate_map<Traits, Exact_geometry_2<Kernel>> {
  using Geometry = Exact_geometry_2<Kernel>;
  using Coordinate = typename Geometry::Coordinate;
  using Field = typename Geometry::Field;
  using FT = typename Kernel::FT;

public:
  using Point_2 = typename Traits::Point_2;
  using Point = typename Geometry::Point;
  static constexpr bool may_lose_points = false;

  template <class PointRange>
  explicit Coordinate_map(const PointRange& points, const std::vector<Point_2>& = {}) {
    if (points.empty()) return;
    std::array<Field, 2> low{exact(points[0], 0), exact(points[0], 1)}, high = low;
    for (const Point_2& p : points)
      for (int axis = 0; axis < 2; ++axis) {
        const Field c = exact(p, axis);
        if (c < low[std::size_t(axis)]) low[std::size_t(axis)] = c;
        if (high[std::size_t(axis)] < c) high[std::size_t(axis)] = c;
      }
    const Field width = high[0] - low[0], height = high[1] - low[1];
    const Field& extent = width < height ? height : width;
    if (!CGAL::is_zero(extent)) exponent_ = floor_of_logarithm(extent);
    unit_ = power_of_two<Field>(exponent_), inverse_unit_ = power_of_two<Field>(-exponent_);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      origin_integer_[axis] = origin_for(low[axis]);
      origin_[axis] = origin_integer_[axis].to_exact(unit_);
    }
  }

  Point to_kernel(const Point_2& p) const { return {to_kernel(p, 0), to_kernel(p, 1)}; }
  /// The kernel's point at a grid point, by integers alone.
  template <class Grid>
  Point to_kernel(const Grid& grid, const typename Traits::Grid_point& g) const {
    const std::array<Scaled_integer, 2> place = grid.place(g);
    return {to_kernel(place[0], 0), to_kernel(place[1], 1)};
  }
  Point_2 to_user(const Point& p) const { return Point_2(to_user(p.x, 0), to_user(p.y, 1)); }

  /// The place in the user's coordinates, rounded; infinite where that is beyond doubles.
  std::array<double, 2> place(const Point& p) const { return {place(p.x, 0), place(p.y, 1)}; }

  /// Lengths are doubles and stay such: those of extents that no doubles have are not meaningful.
  double length_to_kernel(double length) const {
    return std::ldexp(length, -std::min(std::max(exponent_, -1022), 1022));
  }
  bool is_in_range() const { return true; }

private:
  int exponent_ = 0;
  Field unit_ = Field(1), inverse_unit_ = Field(1); // 2^exponent_ and its inverse
  std::array<Scaled_integer, 2> origin_integer_;
  std::array<Field, 2> origin_{Field(0), Field(0)}; // the same

  static Field exact(const Point_2& p, int axis) { return Coordinate_reader<Kernel>::exact(p, axis); }

  Scaled_integer origin_for(const Field& low) const {
    const Field magnitude = CGAL::is_negative(low) ? Field(-low) : low;
    if (magnitude < power_of_two<Field>(20) * unit_) return {0, exponent_};
    return {Floor_of_scaled<Field>(-exponent_)(low), exponent_};
  }

  bool is_moved(int axis) const { return !CGAL::is_zero(origin_[std::size_t(axis)]); }

  Coordinate to_kernel(const Point_2& p, int axis) const {
    const std::pair<double, double> v = Coordinate_reader<Kernel>::interval(p, axis);
    if (v.first == v.second && !is_moved(axis) && is_scaled_exactly(v.first, -exponent_))
      return Coordinate(std::ldexp(v.first, -exponent_));
    return Coordinate(Field((exact(p, axis) - origin_[std::size_t(axis)]) * inverse_unit_));
  }

  Coordinate to_kernel(const Scaled_integer& v, int axis) const {
    Scaled_integer moved = is_moved(axis) ? v - origin_integer_[std::size_t(axis)] : v;
    moved.exponent -= exponent_;
    return Coordinate(moved);
  }

  FT to_user(const Coordinate& c, int axis) const {
    if (c.is_double() && !is_moved(axis) && is_scaled_exactly(c.high(), exponent_))
      return FT(std::ldexp(c.high(), exponent_));
    return FT(Field(c.exact() * unit_ + origin_[std::size_t(axis)]));
  }

  double place(const Coordinate& c, int axis) const {
    return std::ldexp(c.high(), exponent_) + CGAL::to_double(origin_[std::size_t(axis)]);
  }

  static bool is_scaled_exactly(double v, int exponent) {
    const double scaled = std::ldexp(v, exponent);
    return std::isfinite(scaled) && (v == 0 || std::fabs(scaled) > 1e-300);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_EXACT_COORDINATE_MAP_H
