// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The arithmetic of the meshing kernel over an exact field.
//
// Points between others (`between()`) are exact, so what is made on an input edge lies on it. Points that may be
// anywhere (`translate()`, `nearest_corner()`) are multiples of a power of two near the length of the way to
// them, so that they have few bits, mostly those of a double, and no history. Predicates are exact: on differences
// rounded to doubles where the sign is certain, in the field else. Differences are rounded once, up to a relative
// 2^-60, as the filters of the kernel's in-circle test want.
//
// Coordinates are of the order of 1 (exact_coordinate_map.h). Predicates hold for points at any distance; products
// of six differences, by which angles are compared, do not underflow down to differences of 2^-165. Vertices nearer
// than 2^-128 are refused, so that there is room for the triangles around them.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_EXACT_GEOMETRY_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_EXACT_GEOMETRY_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/Exact_coordinate.h>
#include <CGAL/Quadtree_mesh_2/internal/exact_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/meshing_geometry.h>
#include <CGAL/enum.h>
#include <CGAL/predicates/kernel_ftC2.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Points with coordinates of the exact field of a CGAL kernel.
template <class Kernel>
struct Exact_geometry_2 {
  using Field = typename Exact_field<typename Kernel::FT>::Type;
  using Coordinate = Exact_coordinate<Field>;
  static constexpr bool has_unlimited_coordinates = true;
  /// Vertices nearer to each other, or to a segment, are not meshed.
  static constexpr double least_length = 0x1p-128;
  static constexpr double least_share_of_leg = 0x1p-145;
  struct Point {
    Coordinate x, y;

    bool is_double() const { return x.is_double() && y.is_double(); }
    friend bool operator==(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }
  };

  static Vector difference(const Point& p, const Point& q) {
    return {Coordinate::difference(p.x, q.x), Coordinate::difference(p.y, q.y)};
  }

  /// Of the triangle a, b, c, with u = b - a and v = c - b; to a relative 1e-4 however flat the triangle is.
  static double doubled_area(Vector u, Vector v, const Point& a, const Point& b, const Point& c) {
    const double l = u.x * v.y, r = u.y * v.x;
    if (std::fabs(l - r) > 1e-11 * (std::fabs(l) + std::fabs(r))) return l - r;
    const Field ax = a.x.exact(), ay = a.y.exact();
    return CGAL::to_double(
        Field((b.x.exact() - ax) * (c.y.exact() - ay) - (b.y.exact() - ay) * (c.x.exact() - ax)));
  }

  static bool is_certainly_in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
    return is_in_circle(a, b, c, d);
  }
  /// Whether q is to the right of a, b; exact.
  static bool is_beyond(const Point& a, const Point& b, const Point& q, Vector, Vector) {
    return orientation(a, b, q) < 0;
  }
  /// Whether q is to the left of a, b; exact, so that there are no doubts in between.
  static bool is_clearly_left(const Point& a, const Point& b, const Point& q, Vector, Vector) {
    return orientation(a, b, q) > 0;
  }

  /// A place near p + v: next to it in the grid with the unit 2^-30 of v, so beside p where p is not on that grid.
  static Point translate(const Point& p, Vector v) {
    const double length = std::max(std::fabs(v.x), std::fabs(v.y));
    if (!(length > 0 && std::isfinite(length))) return p;
    const int exponent = std::ilogb(length) - bits_of_translation;
    return {Coordinate::nearest_multiple(p.x, v.x, exponent),
            Coordinate::nearest_multiple(p.y, v.y, exponent)};
  }

  /// The point at the given share of the way from p to q, exactly.
  static Point between(const Point& p, const Point& q, double share) {
    return {Coordinate::between(p.x, q.x, share), Coordinate::between(p.y, q.y, share)};
  }
  /// What is made between points of a line is on it.
  static const Point& back_to_line(const Point&, const Point&, const Point& m) { return m; }
  static double short_share(double share) { return 0x1p-10 * std::floor(0x1p10 * share + 0.5); }

  /// Sign of the turn a, b, c; exact.
  static int orientation(const Point& a, const Point& b, const Point& c) {
    const Vector ab = difference(b, a), ac = difference(c, a);
    const double l = ab.x * ac.y, r = ab.y * ac.x;
    const double d = l - r, magnitude = std::fabs(l) + std::fabs(r);
    if (std::fabs(d) > 3.5e-16 * magnitude && magnitude > 1e-280) return d > 0 ? 1 : -1;
    if (a.is_double() && b.is_double() && c.is_double())
      return Doubles::orientation(double_point(a), double_point(b), double_point(c));
    return static_cast<int>(
        CGAL::orientationC2(a.x.exact(), a.y.exact(), b.x.exact(), b.y.exact(), c.x.exact(), c.y.exact()));
  }

  /// Whether d lies strictly inside the circle through a, b, c (counterclockwise); exact.
  static bool is_in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
    const In_circle test(difference(a, d), difference(b, d), difference(c, d));
    if (test.is_certain()) return test.is_positive();
    if (a.is_double() && b.is_double() && c.is_double() && d.is_double())
      return Doubles::is_in_circle(double_point(a), double_point(b), double_point(c), double_point(d));
    return CGAL::side_of_oriented_circleC2(a.x.exact(), a.y.exact(), b.x.exact(), b.y.exact(), c.x.exact(),
                                           c.y.exact(), d.x.exact(), d.y.exact()) == ON_POSITIVE_SIDE;
  }

  /// The corner, next to p, of the quadtree's cells with the given side, a power of two.
  static Point nearest_corner(const Point& p, double side) {
    const int exponent = std::ilogb(side);
    return {Coordinate::nearest_multiple(p.x, 0, exponent), Coordinate::nearest_multiple(p.y, 0, exponent)};
  }

private:
  static constexpr int bits_of_translation = 30;

  using Doubles = Double_geometry_2<Exact_predicates_inexact_constructions_kernel>;
  static typename Doubles::Point double_point(const Point& p) { return {p.x.high(), p.y.high()}; }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_EXACT_GEOMETRY_H
