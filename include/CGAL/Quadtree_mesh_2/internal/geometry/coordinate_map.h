// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The user's points to the meshing kernel's and back, without loss, or so that the loss is found.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_COORDINATE_MAP_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_COORDINATE_MAP_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Model_requirements.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The lower and upper ends of the coordinates of some points.
template <class Coordinate>
struct Coordinate_ranges {
  Coordinate low_x, high_x, low_y, high_y;

  template <class Point>
  explicit Coordinate_ranges(const Point& p) : low_x(p.x()), high_x(low_x), low_y(p.y()), high_y(low_y) {}

  /// Of a vector of points. O(n), in parallel. \pre there is a point
  template <class Points>
  static Coordinate_ranges of(const Points& points) {
    return reduce<Chosen_tag>(
        points.size(), Coordinate_ranges(points[0]),
        [&](std::size_t begin, std::size_t end) {
          Coordinate_ranges ranges(points[begin]);
          for (std::size_t i = begin + 1; i < end; ++i) ranges.add(Coordinate_ranges(points[i]));
          return ranges;
        },
        [](Coordinate_ranges a, const Coordinate_ranges& b) {
          a.add(b);
          return a;
        });
  }

  void add(const Coordinate_ranges& other) {
    low_x = std::min(low_x, other.low_x), high_x = std::max(high_x, other.high_x);
    low_y = std::min(low_y, other.low_y), high_y = std::max(high_y, other.high_y);
  }
  Coordinate extent() const { return std::max(high_x - low_x, high_y - low_y); }
  Coordinate largest() const { return std::max(high_x, high_y); }
};

/// Whether a map keeps all points of a vector.
template <class Map, class Points>
bool all_are_kept(const Map& map, const Points& points) {
  return reduce<Chosen_tag>(
      points.size(), true,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          if (!map.is_kept(points[i])) return false;
        return true;
      },
      [](bool a, bool b) { return a && b; });
}

template <class Traits, class Geometry>
class Coordinate_map;

/// Over doubles: the input is scaled by a power of two so that its extent is about 2^200. Then products of four
/// differences do not overflow, nor underflow down to features of 2^-442 of the extent; and coordinates are scaled
/// upwards, which does not round subnormal ones, unless the extent is greater yet. Points all in one place have no
/// extent. Their root has the side 1 (`Root_side`), so they are scaled until doubles have room for vertices in it.
template <class Traits, class Kernel>
class Coordinate_map<Traits, Double_geometry_2<Kernel>> {
public:
  using Point_2 = typename Traits::Point_2;
  using Point = typename Double_geometry_2<Kernel>::Point;
  /// Whether points may be other ones when they come back.
  static constexpr bool may_lose_points = true;
  static constexpr const char
      *least_distance = "2^-420 of the extent",
      *loss_of_point = "too near to 0, or too far from it, for doubles beside the extent; move it",
      *loss_of_mesh = "the coordinates are next to the least doubles, which cannot hold the mesh: "
                      "multiply them by a power of two";

  /// \param seeds points that do not count for the extent, but keep their coordinates too
  template <class PointRange>
  explicit Coordinate_map(const PointRange& points, const std::vector<Point_2>& seeds = {}) {
    const auto ranges = Coordinate_ranges<double>::of(points);
    const double extent = ranges.extent();
    if (extent == 0)
      exponent_ = exponent_of_place(std::max(std::fabs(ranges.low_x), std::fabs(ranges.low_y)));
    else
      exponent_ =
          std::max((std::isfinite(extent) ? std::ilogb(extent) : 0) - kernel_exponent_, least_exponent_);
    per_unit_ = std::ldexp(1.0, -exponent_), unit_ = std::ldexp(1.0, exponent_);
    least_far_from_limits_ = std::ldexp(1.0, exponent_ - 900);
    largest_far_from_limits_ = std::ldexp(1.0, exponent_ + 900);
    are_kept_ = all_are_kept(*this, points) && all_are_kept(*this, seeds);
  }

  Point to_kernel(const Point_2& p) const { return {per_unit_ * p.x(), per_unit_ * p.y()}; }
  /// The kernel's point at a grid point.
  template <class Grid>
  Point to_kernel(const Grid& grid, const typename Traits::Grid_point& g) const {
    return to_kernel(grid.point(g));
  }
  Point_2 to_user(const Point& p) const { return Point_2(unit_ * p.x, unit_ * p.y); }
  /// The place in the user's coordinates, rounded.
  std::array<double, 2> place(const Point& p) const { return {unit_ * p.x, unit_ * p.y}; }
  double length_to_kernel(double length) const { return per_unit_ * length; }
  bool is_in_range() const { return true; }

  /// Whether p is as it was when scaled to the kernel and back.
  bool is_kept(const Point_2& p) const { return is_kept(p.x()) && is_kept(p.y()); }
  /// Whether all points and seeds are.
  bool are_kept() const { return are_kept_; }
  /// Whether vertices of the mesh may be rounded on their way back by more than a trifle of their distances.
  /// This happens next to the least doubles.
  bool may_round_mesh() const { return exponent_ < -700; }

private:
  static constexpr int kernel_exponent_ = 200, least_exponent_ = -1000, greatest_exponent_of_place_ = 32;
  int exponent_ = 0;
  double per_unit_, unit_; // 2^-exponent and its inverse, which doubles have
  double least_far_from_limits_, largest_far_from_limits_;
  bool are_kept_ = true;

  /// Leaves coordinates of one place below 2^33, where a square of side 1 has a million steps.
  static int exponent_of_place(double magnitude) {
    if (!(magnitude > 0 && std::isfinite(magnitude))) return 0;
    return std::max(0, std::ilogb(magnitude) - greatest_exponent_of_place_);
  }

  bool is_kept(double c) const {
    const double magnitude = std::fabs(c);
    const bool is_far_from_limits =
        magnitude >= least_far_from_limits_ && magnitude <= largest_far_from_limits_;
    return is_far_from_limits || c == 0 || unit_ * (per_unit_ * c) == c;
  }
};

/// Over words: the same integers, signed.
template <class Traits, class Word>
class Coordinate_map<Traits, Integer_geometry_2<Word>> {
public:
  using Point_2 = typename Traits::Point_2;
  using Point = typename Integer_geometry_2<Word>::Point;
  static constexpr bool may_lose_points = false;

  template <class PointRange>
  explicit Coordinate_map(const PointRange& points, const std::vector<Point_2>& = {}) {
    const auto ranges = Coordinate_ranges<Word>::of(points);
    // differences with the auxiliary vertices of the first triangulation, three extents apart, must fit
    // signed words
    constexpr std::uint64_t largest_extent = std::uint64_t(1) << 61;
    is_in_range_ = ranges.extent() <= largest_extent && ranges.largest() < 2 * largest_extent;
  }

  Point to_kernel(const Point_2& p) const { return {std::int64_t(p.x()), std::int64_t(p.y())}; }
  /// The kernel's point at a grid point.
  template <class Grid>
  Point to_kernel(const Grid& grid, const typename Traits::Grid_point& g) const {
    return to_kernel(grid.point(g));
  }
  Point_2 to_user(const Point& p) const { return Point_2{Word(p.x), Word(p.y)}; }
  std::array<double, 2> place(const Point& p) const {
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
  }
  double length_to_kernel(double length) const { return length; }
  bool is_in_range() const { return is_in_range_; }

private:
  bool is_in_range_ = true;
};

/// Over a geometry of the user's: by its own map.
template <class Traits, class Model>
class Coordinate_map<Traits, Adapted_geometry<Model>> {
public:
  using Point_2 = typename Traits::Point_2;
  using Point = typename Model::Point;
  static_assert(
      has_map<Model, Point_2>,
      "MeshingGeometry_2: there is no `Coordinate_map`, made of a vector of `Point_2`, with `scale()`, "
      "`to_mesher(Point_2)` and `from_mesher(Point)`");
  static constexpr bool may_lose_points = true;
  static constexpr const char *least_distance = "the least length of the geometry",
                              *loss_of_point = "the map of the geometry gives back another point",
                              *loss_of_mesh =
                                  "the map of the geometry gives back a mesh with a triangle that is "
                                  "not counterclockwise any more";

  explicit Coordinate_map(const std::vector<Point_2>& points, const std::vector<Point_2>& seeds = {})
      : map_(points) {
    are_kept_ = all_are_kept(*this, points) && all_are_kept(*this, seeds);
  }

  Point to_kernel(const Point_2& p) const { return map_.to_mesher(p); }
  /// The kernel's point at a grid point.
  template <class Grid>
  Point to_kernel(const Grid& grid, const typename Traits::Grid_point& g) const {
    return to_kernel(grid.point(g));
  }
  Point_2 to_user(const Point& p) const { return map_.from_mesher(p); }
  std::array<double, 2> place(const Point& p) const {
    const Point_2 q = to_user(p);
    return {as_double(q.x()), as_double(q.y())};
  }
  double length_to_kernel(double length) const { return map_.scale() * length; }
  bool is_in_range() const { return true; }

  /// Whether p is as it was when mapped there and back.
  bool is_kept(const Point_2& p) const { return to_user(to_kernel(p)) == p; }
  bool are_kept() const { return are_kept_; }
  bool may_round_mesh() const { return true; }

private:
  typename Model::Coordinate_map map_;
  bool are_kept_ = true;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_COORDINATE_MAP_H
