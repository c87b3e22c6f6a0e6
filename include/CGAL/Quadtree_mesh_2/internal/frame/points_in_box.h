// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Points in a box, as a planar straight-line graph.
//
// Computes: for points alone a domain to mesh, a rectangle around them. The points come first, in their
//           order. The rectangle's corners, counterclockwise from the lower left one, and its sides come
//           last.
// Bound:    O(n) work.
//
// How far the box is from the points. If a side is nearer to the outermost points than these are to each
// other, it makes features smaller than those of the points, and triangles to fill them. If it is farther
// away, the space between has to be filled, too. The best distance is the mean spacing of points that fill
// the box evenly, its extent over sqrt(n). With it, uniform points and grids of 3 to 10^4 points need the
// fewest triangles, within 1 percent. Sets of other kinds (clusters, lines, spirals) change by no more than 2
// percent, unless they are tiny. The distance is the power of two next to that, and the same on all four
// sides, so that the corners have few bits.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_POINTS_IN_BOX_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_POINTS_IN_BOX_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/exact_grid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Opposite corners of a rectangle with sides parallel to the axes.
template <class Point>
struct Box_corners {
  Point low, high;
};

/// The power of two next to `extent / sqrt(n)`, up to a factor of sqrt(2).
/// \pre `extent` is positive, and `n`, too
inline double nearest_power_to_spacing(double extent, std::size_t n) {
  const int exponent = std::ilogb(extent);
  const double share = std::ldexp(extent, -exponent); // in [1, 2)
  const int squared = std::ilogb(2 * share * share / static_cast<double>(n));
  return std::ldexp(1.0, exponent + (squared >= 0 ? squared / 2 : -((1 - squared) / 2)));
}

/// How far a box is from points with doubles as coordinates: at least so many of the coordinates' units that there
/// is room for vertices between, and 1 for points all in one place.
struct Double_box_sides {
  static constexpr double least_units = 256;

  template <class Ranges>
  static double margin(const Ranges& r, std::size_t n) {
    const double extent = r.extent();
    const double magnitude =
        std::max({std::fabs(r.low_x), std::fabs(r.high_x), std::fabs(r.low_y), std::fabs(r.high_y)});
    if (!std::isfinite(extent) || !std::isfinite(magnitude)) return 0; // the mesher names the culprit
    const double spacing = extent > 0 ? nearest_power_to_spacing(extent, n) : 1;
    const double unit = magnitude > 0 ? std::ldexp(1.0, std::max(std::ilogb(magnitude) - 52, -1074)) : 0;
    return std::max(spacing, least_units * unit);
  }
  /// The sides of the box along one axis.
  static std::pair<double, double> sides(double low, double high, double margin) {
    return {low - margin, high + margin};
  }
};

/// For words: a box within the root of quadtrees, and with an extent that the mesher takes (2^61) if the points have
/// such. So it may be nearer to the points, or touch them, at the ends of the range.
template <class Word>
struct Word_box_sides {
  static constexpr bool is_short = std::is_same<Word, std::uint32_t>::value;
  static constexpr Word end = static_cast<Word>(Word(1) << (is_short ? 31 : 62));
  static constexpr Word greatest_extent = is_short ? end - 1 : end / 2;
  static constexpr Word least_margin = 256;

  template <class Ranges>
  static Word margin(const Ranges& r, std::size_t n) {
    const Word extent = r.extent();
    if (extent == 0) return least_margin;
    return std::max(least_margin,
                    static_cast<Word>(nearest_power_to_spacing(static_cast<double>(extent), n)));
  }
  static std::pair<Word, Word> sides(Word low, Word high, Word margin) {
    const Word extent = static_cast<Word>(high - low);
    const Word room = extent < greatest_extent ? static_cast<Word>(greatest_extent - extent) : Word(0);
    const Word below = std::min({margin, low, static_cast<Word>(room / 2)});
    const Word to_end = high < end - 1 ? static_cast<Word>(end - 1 - high) : Word(0);
    const Word above = std::min({margin, to_end, static_cast<Word>(room - below)});
    return {static_cast<Word>(low - below), static_cast<Word>(high + above)};
  }
};

/// For exact fields: nothing is rounded.
template <class FT>
struct Exact_box_sides {
  template <class Ranges>
  static FT margin(const Ranges& r, std::size_t n) {
    const FT extent = r.extent();
    if (CGAL::is_zero(extent)) return FT(1);
    const int exponent = floor_of_logarithm(extent);
    const double share = CGAL::to_double(FT(extent * power_of_two<FT>(-exponent)));
    return FT(nearest_power_to_spacing(share, n)) * power_of_two<FT>(exponent);
  }
  static std::pair<FT, FT> sides(const FT& low, const FT& high, const FT& margin) {
    return {FT(low - margin), FT(high + margin)};
  }
};

template <class Coordinate>
using Box_sides = std::conditional_t<
    std::is_floating_point<Coordinate>::value, Double_box_sides,
    typename std::conditional_t<
        std::is_integral<Coordinate>::value,
        Word_box_sides<std::conditional_t<std::is_integral<Coordinate>::value, Coordinate, std::uint64_t>>,
        Exact_box_sides<Coordinate>>>;

/// The rectangle around points that their mesh fills, by the rule above; for no points that around the origin.
template <class Point>
Box_corners<Point> box_of_points(const std::vector<Point>& points) {
  if (points.empty()) return box_of_points(std::vector<Point>{Point{0, 0}});
  using Coordinate = std::decay_t<decltype(points[0].x())>;
  using Sides = Box_sides<Coordinate>;
  const auto ranges = Coordinate_ranges<Coordinate>::of(points);
  const auto margin = Sides::margin(ranges, points.size());
  const auto [west, east] = Sides::sides(ranges.low_x, ranges.high_x, margin);
  const auto [south, north] = Sides::sides(ranges.low_y, ranges.high_y, margin);
  return {Point{west, south}, Point{east, north}};
}

/// The graph of points and the sides of a box with them inside or on its border.
template <class Point>
Pslg_2<Point> points_in_box(std::vector<Point> points, const Box_corners<Point>& box) {
  using Vertex_index = typename Pslg_2<Point>::Vertex_index;
  Pslg_2<Point> pslg;
  const std::size_t n = points.size();
  pslg.vertices = std::move(points);
  pslg.vertices.reserve(n + 4);
  pslg.add_vertex(box.low);
  pslg.add_vertex(Point{box.high.x(), box.low.y()});
  pslg.add_vertex(box.high);
  pslg.add_vertex(Point{box.low.x(), box.high.y()});
  for (std::size_t i = 0; i < 4; ++i) pslg.add_segment(Vertex_index(n + i), Vertex_index(n + (i + 1) % 4));
  return pslg;
}

/// The same with the box by the rule above.
template <class Point>
Pslg_2<Point> points_in_box(std::vector<Point> points) {
  const Box_corners<Point> box = box_of_points(points);
  return points_in_box(std::move(points), box);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_POINTS_IN_BOX_H
