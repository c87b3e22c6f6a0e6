// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Exact predicates on input points, and differences of their coordinates as intervals or exactly.
//
// Distances are first found as intervals, and as rational numbers if intervals cannot tell them apart.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_POINT_ARITHMETIC_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_POINT_ARITHMETIC_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Wide_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/exact_grid.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// An interval of doubles; operations need the rounding mode of `Interval::Protector`.
using Interval = Interval_nt<false>;

inline Interval least(const Interval& a, const Interval& b) {
  return Interval(std::min(a.inf(), b.inf()), std::min(a.sup(), b.sup()));
}
inline Interval greatest(const Interval& a, const Interval& b) {
  return Interval(std::max(a.inf(), b.inf()), std::max(a.sup(), b.sup()));
}
template <class Exact>
Exact least(const Exact& a, const Exact& b) {
  return b < a ? b : a;
}
template <class Exact>
Exact greatest(const Exact& a, const Exact& b) {
  return a < b ? b : a;
}

/// Whether the middle of an interval approximates a positive number with a relative error below 2^-40.
inline bool is_narrow(const Interval& v) { return v.sup() - v.inf() <= 0x1p-41 * v.inf(); }

/// Compares two numbers given by enclosing intervals, and calls `compare_exactly()` if these overlap.
template <class Compare_exactly>
int compare_filtered(const Interval& a, const Interval& b, const Compare_exactly& compare_exactly) {
  if (a.sup() < b.inf()) return -1;
  if (b.sup() < a.inf()) return 1;
  if (a.is_point() && b.is_point()) return 0;
  return compare_exactly();
}

/// The kernel of a point.
template <class Point, class = void>
struct Kernel_of_point {
  using Type = Exact_predicates_inexact_constructions_kernel; // for points of doubles that have none
};
template <class Point>
struct Kernel_of_point<Point, std::void_t<typename Kernel_traits<Point>::Kernel::Point_2>> {
  using Type = typename Kernel_traits<Point>::Kernel;
};

/// Points of a CGAL kernel, or of doubles. Axis 0 is that of x, 1 that of y.
template <class Point,
          bool has_words = std::is_integral_v<std::decay_t<decltype(std::declval<const Point&>().x())>>>
class Point_arithmetic {
  using Kernel = typename Kernel_of_point<Point>::Type;
  using Reader = Coordinate_reader<Kernel>;

public:
  using Exact = typename Reader::Exact;

  /// The sign of the turn p, q, r.
  static int orientation(const Point& p, const Point& q, const Point& r) {
    return static_cast<int>(Kernel().orientation_2_object()(in_kernel(p), in_kernel(q), in_kernel(r)));
  }
  /// The sign of the difference of coordinates.
  static int compare(const Point& p, const Point& q, int axis) {
    return static_cast<int>(axis == 0 ? Kernel().compare_x_2_object()(in_kernel(p), in_kernel(q))
                                      : Kernel().compare_y_2_object()(in_kernel(p), in_kernel(q)));
  }
  /// The coordinate lies between these.
  static std::pair<double, double> bounds(const Point& p, int axis) {
    return Reader::interval(in_kernel(p), axis);
  }
  static Exact coordinate(const Point& p, int axis) { return Reader::exact(in_kernel(p), axis); }

  /// Coordinate of p less that of q.
  template <class Number>
  static Number difference(const Point& p, const Point& q, int axis) {
    if constexpr (std::is_same<Number, Interval>::value)
      return Interval(bounds(p, axis)) - Interval(bounds(q, axis));
    else
      return coordinate(p, axis) - coordinate(q, axis);
  }

private:
  static decltype(auto) in_kernel(const Point& p) {
    if constexpr (std::is_same_v<Point, typename Kernel::Point_2>)
      return (p);
    else
      return typename Kernel::Point_2(p.x(), p.y());
  }
};

/// Points with integer coordinates below 2^62.
template <class Point>
class Point_arithmetic<Point, true> {
public:
  using Exact = Exact_rational;

  static int orientation(const Point& p, const Point& q, const Point& r) {
    const Wide_integer d =
        Wide_integer(minus(q, p, 0)) * minus(r, p, 1) - Wide_integer(minus(q, p, 1)) * minus(r, p, 0);
    return d > 0 ? 1 : d < 0 ? -1 : 0;
  }
  static int compare(const Point& p, const Point& q, int axis) {
    const std::int64_t d = minus(p, q, axis);
    return d > 0 ? 1 : d < 0 ? -1 : 0;
  }
  static std::pair<double, double> bounds(const Point& p, int axis) {
    return around(static_cast<std::int64_t>(axis == 0 ? p.x() : p.y()));
  }
  static Exact coordinate(const Point& p, int axis) {
    return exact(static_cast<std::int64_t>(axis == 0 ? p.x() : p.y()));
  }

  template <class Number>
  static Number difference(const Point& p, const Point& q, int axis) {
    const std::int64_t d = minus(p, q, axis);
    if constexpr (std::is_same<Number, Interval>::value)
      return Interval(around(d));
    else
      return exact(d);
  }

private:
  static std::int64_t minus(const Point& p, const Point& q, int axis) {
    return axis == 0 ? static_cast<std::int64_t>(p.x()) - static_cast<std::int64_t>(q.x())
                     : static_cast<std::int64_t>(p.y()) - static_cast<std::int64_t>(q.y());
  }
  /// In halves, because not every field can be made from 64-bit integers.
  static Exact exact(std::int64_t d) {
    return Exact(static_cast<double>(high(d))) * Exact(0x1p31) + Exact(static_cast<double>(d - low(d)));
  }
  static std::int64_t high(std::int64_t d) { return d / (std::int64_t(1) << 31); }
  static std::int64_t low(std::int64_t d) { return high(d) * (std::int64_t(1) << 31); }

  static std::pair<double, double> around(std::int64_t d) {
    const double v = static_cast<double>(d);
    if (std::fabs(v) < 0x1p53) return {v, v};
    return {std::nextafter(v, -0x1p64), std::nextafter(v, 0x1p64)};
  }
};

/// Returns the square root of an exact number of any size.
/// \pre `v >= 0`
template <class Exact>
double root_of_exact(Exact v) {
  double scale = 1;
  const Exact large(0x1p1000), small(0x1p-1000);
  while (!CGAL::is_zero(v) && CGAL::to_double(v) < 0x1p-900 && scale > 0) {
    v *= large;
    scale *= 0x1p-500;
  }
  while (large < v && std::isfinite(scale)) {
    v *= small;
    scale *= 0x1p500;
  }
  return std::sqrt(CGAL::to_double(v)) * scale;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_POINT_ARITHMETIC_H
