// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The frame of a quadtree for points: a rotated or axis-parallel grid, and the squares of it that are meshed.
//
// Computes: a map from points to a grid of 2^62 units to a side, the root, and a window. The window is a row
//           of equal squares of the quadtree, or the root alone, with the points well inside. Also the map
//           from places of the grid to points.
// Bound:    O(n) work.
// Source:   Bern, Eppstein, Teng, section 5: the points' rectangle in [1/4, 3/4) x [2^-i, 2^(-i+1)) of the
//           root, with i as large as possible up to log2(n), after a rotation by which the diameter becomes
//           about horizontal.
// Deviates: the row has as many squares as the points need, not all that the root has room for. The points
//           are in the middle half of the row in both directions (along the row in whole squares). So the
//           squares around a point's square are in the row.
//
// Method. Points go to an axis-parallel grid (Axis_parallel_grid.h). Its places, as complex integers, are
// multiplied by the conjugate of the rotation's number z, exactly. The products are shifted right so that
// they fit 62 bits, and moved. This loses less than the unit of either grid. The way back multiplies by z and
// divides by its norm, exactly, and rounds once, to the geometry's numbers. With z = 1 and the root as
// window, the grid is the axis-parallel one itself.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_GRID_FRAME_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_GRID_FRAME_H

#include <CGAL/Quadtree_mesh_2/internal/frame/Axis_parallel_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/Gaussian_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/approximate_diameter.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Which squares of the quadtree are meshed.
enum class Window_shape {
  ROOT, ///< the root
  ROW   ///< a row of squares about twice as high as the points, but not smaller than an n-th of the root
};

/// The squares of a level with columns in [x0, x1) and rows in [y0, y1).
struct Grid_window {
  int level = 0;
  std::uint64_t x0 = 0, x1 = 1, y0 = 0, y1 = 1;
};

template <class Geometry>
class Grid_frame {
public:
  using Point = typename Geometry::Point;
  using Grid_point = Wide_grid_point;
  /// The root has 2^depth units to a side.
  static constexpr int depth = 62;

  /// Parallel to the axes, the window the root.
  template <class ConcurrencyTag>
  static Grid_frame axis_parallel(const std::vector<Point>& points) {
    return Grid_frame(Axis_parallel_grid<Geometry>::template of<ConcurrencyTag>(points));
  }

  /// With the direction of z as that of rows.
  /// \pre z is not 0, and its parts are at most `finest_rotation` in magnitude
  template <class ConcurrencyTag>
  static Grid_frame rotated(const std::vector<Point>& points, Gaussian_integer z, Window_shape shape) {
    Grid_frame frame = axis_parallel<ConcurrencyTag>(points);
    if (points.empty() || (z.is_one() && shape == Window_shape::ROOT)) return frame;
    frame.rotation_ = z;
    frame.template place_window<ConcurrencyTag>(points, shape);
    return frame;
  }

  /// With rows along a segment that is nearly as long as the points' diameter, up to an angle of 1 / n.
  template <class ConcurrencyTag>
  static Grid_frame along_diameter(const std::vector<Point>& points) {
    const Far_pair pair = approximate_diameter<ConcurrencyTag, Geometry>(points);
    if (pair.first == pair.second) return axis_parallel<ConcurrencyTag>(points);
    const Vector v = Geometry::difference(points[pair.second], points[pair.first]);
    return rotated<ConcurrencyTag>(points, rotation_near(v, points.size()), Window_shape::ROW);
  }

  /// The grid point at, or less than a unit and its rotation away from, one of the points of the frame.
  Grid_point to_grid(const Point& p) const {
    if (!is_moved_) return grid_.to_grid(p);
    const Wide_vector v = shifted(p);
    return {static_cast<std::uint64_t>(v.x - origin_.x), static_cast<std::uint64_t>(v.y - origin_.y)};
  }

  /// The point at a place of the grid, or next to it. In frames that are not rotated it is exact if there is
  /// such a point. For exact geometries it is less than 2^-20 of a unit away.
  Point to_point(const Grid_point& g) const {
    if (!is_moved_) return grid_.to_point(g);
    const Wide_integer scale = Wide_integer(1) << shift_;
    const Wide_vector v = turned_to(
        {(Wide_integer(g.x) + origin_.x) * scale, (Wide_integer(g.y) + origin_.y) * scale}, rotation_);
    return grid_.to_point(Wide_fraction::of(v.x, rotation_.norm()), Wide_fraction::of(v.y, rotation_.norm()));
  }

  const Grid_window& window() const { return window_; }
  Gaussian_integer rotation() const { return rotation_; }

private:
  Axis_parallel_grid<Geometry> grid_;
  bool is_moved_ = false; // whether there is anything besides grid_
  Gaussian_integer rotation_;
  int shift_ = 0;
  Wide_vector origin_;
  Grid_window window_;

  explicit Grid_frame(Axis_parallel_grid<Geometry> grid) : grid_(std::move(grid)) {}

  Wide_vector shifted(const Point& p) const {
    const Grid_point g = grid_.to_grid(p);
    const Wide_vector v = turned_from({Wide_integer(g.x), Wide_integer(g.y)}, rotation_);
    return {v.x >> shift_, v.y >> shift_}; // rounds down, also below 0
  }

  /// The turned and shifted points' lower and upper corners.
  struct Ranges {
    Wide_vector low, high;

    static Ranges combine(Ranges a, const Ranges& b) {
      a.low = {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)};
      a.high = {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)};
      return a;
    }
    Wide_integer width() const { return high.x - low.x; }
    Wide_integer height() const { return high.y - low.y; }
  };

  template <class ConcurrencyTag>
  Ranges ranges_of(const std::vector<Point>& points) const {
    const Wide_vector first = shifted(points[0]);
    return reduce<ConcurrencyTag>(
        points.size(), Ranges{first, first},
        [&](std::size_t begin, std::size_t end) {
          const Wide_vector v = shifted(points[begin]);
          Ranges r{v, v};
          for (std::size_t i = begin + 1; i < end; ++i) {
            const Wide_vector w = shifted(points[i]);
            r = Ranges::combine(r, {w, w});
          }
          return r;
        },
        Ranges::combine);
  }

  static Wide_integer floor_to_multiple(Wide_integer v, Wide_integer power) { return v & ~(power - 1); }

  template <class ConcurrencyTag>
  void place_window(const std::vector<Point>& points, Window_shape shape) {
    constexpr Wide_integer root = Wide_integer(1) << depth;
    // A 64-th is for origins that are multiples of it, for the sake of short coordinates.
    const auto fits = [](Wide_integer extent, Wide_integer side) { return extent <= side / 2 - side / 64; };
    is_moved_ = true;
    Ranges r = ranges_of<ConcurrencyTag>(points);
    while (!fits(std::max(r.width(), r.height()) >> shift_, root - 128)) ++shift_;
    r = {{r.low.x >> shift_, r.low.y >> shift_}, {r.high.x >> shift_, r.high.y >> shift_}};

    int level = 0;
    if (shape == Window_shape::ROW)
      while (points.size() >> (level + 1) != 0 && fits(r.height(), root >> (level + 1))) ++level;
    const Wide_integer side = root >> level, row = level > 0 ? 1 : 0;
    origin_.x = floor_to_multiple(r.low.x, root / 64) - root / 4;
    origin_.y = floor_to_multiple(r.low.y, side / 64) - row * side - side / 4;
    const auto column = [&](Wide_integer x) {
      return static_cast<std::uint64_t>((x - origin_.x) >> (depth - level));
    };
    window_.level = level;
    window_.x0 = column(r.low.x - side / 4), window_.x1 = column(r.high.x + side / 4) + 1;
    window_.y0 = static_cast<std::uint64_t>(row), window_.y1 = window_.y0 + 1;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_GRID_FRAME_H
