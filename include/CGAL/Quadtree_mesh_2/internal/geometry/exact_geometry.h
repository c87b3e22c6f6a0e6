// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The arithmetic of the meshing kernel over an exact field.
//
// Points between others (`between()`) are exact, so what is made on an input edge lies on it. Points that may
// be anywhere (`translate()`, `nearest_corner()`) are multiples of a power of two near the length of the way
// to them. So they have few bits, mostly those of a double, and no history. Predicates are exact. They use
// differences rounded to doubles if these make the sign certain, and the field if not. Differences are
// rounded once, up to a relative 2^-60, as the filters of the kernel's in-circle test want.
//
// Coordinates are of the order of 1 (exact_coordinate_map.h), but their differences may be of any size.
// Refinement computes with `scaled_difference()`, whose products neither overflow nor underflow
// (Scaled_double.h). The construction by quadtrees and meshes of points compute with `difference()`, in
// doubles. Products of four of these underflow below 2^-255. So the construction refuses vertices nearer to
// each other than `least_length`.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_EXACT_GEOMETRY_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_EXACT_GEOMETRY_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Exact_coordinate.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Scaled_double.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/exact_grid.h>
#include <CGAL/enum.h>
#include <CGAL/predicates/kernel_ftC2.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The quotient as a double; of magnitudes that doubles do not have the largest one, or 0.
inline double ratio(const Scaled_double& a, const Scaled_double& b) {
  constexpr double most = 0x1p1000;
  const double quotient = (a / b).to_double();
  return quotient > most ? most : quotient < -most ? -most : quotient;
}
inline Scaled_double power_of_two_at_most(const Scaled_double& x) {
  return Scaled_double::scaled(1, ilogb(x));
}

/// Points with coordinates of the exact field of a CGAL kernel.
template <class Kernel>
struct Exact_geometry_2 {
  using Field = typename Exact_field<typename Kernel::FT>::Type;
  using Coordinate = Exact_coordinate<Field>;
  static constexpr bool has_unlimited_coordinates = true;
  /// Lengths of anything in a mesh, and products of four of them.
  using Number = Scaled_double;
  using Scaled_vector = Basic_vector<Number>;
  /// Vertices nearer to each other, or to a segment, are not meshed by quadtrees.
  static constexpr double least_length = 0x1p-128;
  struct Point {
    Coordinate x, y;

    bool is_double() const { return x.is_double() && y.is_double(); }
    friend bool operator==(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }
  };

  static Vector difference(const Point& p, const Point& q) {
    return {Coordinate::difference(p.x, q.x), Coordinate::difference(p.y, q.y)};
  }

  static Scaled_vector scaled_difference(const Point& p, const Point& q) {
    return {Coordinate::scaled_difference(p.x, q.x), Coordinate::scaled_difference(p.y, q.y)};
  }

  /// Of the triangle a, b, c, with u = b - a and v = c - b; to a relative 1e-4 however flat the triangle is.
  static Number doubled_area(const Scaled_vector& u, const Scaled_vector& v, const Point& a, const Point& b,
                             const Point& c) {
    const Number l = u.x * v.y, r = u.y * v.x;
    if (fabs(l - r) > 1e-11 * (fabs(l) + fabs(r))) return l - r;
    return Number::of(exact_doubled_area(a, b, c));
  }
  static Number doubled_area_of_flat(const Scaled_vector& u, const Scaled_vector& v, const Point& a,
                                     const Point& b, const Point& c) {
    return doubled_area(u, v, a, b, c);
  }

  /// Whether there are places for a vertex at this squared distance from p: there always are.
  static bool is_resolved(const Point&, const Number&) { return true; }

  static bool is_certainly_in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
    return is_in_circle(a, b, c, d);
  }

  /// A place near p + v: next to it in the grid with the unit 2^-30 of v, so beside p where p is not on that grid.
  static Point translate(const Point& p, const Scaled_vector& v) {
    const Number length = std::max(fabs(v.x), fabs(v.y));
    if (!(length > 0 && length < infinite_length)) return p;
    const int exponent = ilogb(length) - bits_of_translation;
    return {Coordinate::nearest_multiple(p.x, v.x, exponent),
            Coordinate::nearest_multiple(p.y, v.y, exponent)};
  }
  static Point translate(const Point& p, Vector v) { return translate(p, Scaled_vector{v.x, v.y}); }

  /// The point at the given share of the way from p to q, exactly.
  static Point between(const Point& p, const Point& q, const Number& share) {
    return {Coordinate::between(p.x, q.x, share), Coordinate::between(p.y, q.y, share)};
  }
  /// How far coordinates are from the next ones.
  static double spacing(const Point&) { return 0; }
  /// What is made between points of a line is on it.
  static const Point& back_to_line(const Point&, const Point&, const Point& m) { return m; }
  static double short_share(double share) { return 0x1p-10 * std::floor(0x1p10 * share + 0.5); }

  /// Sign of the turn a, b, c; exact. Doubles decide mostly, longer ones where products of doubles underflow.
  static int orientation(const Point& a, const Point& b, const Point& c) {
    if (const int sign = certain_sign(difference(b, a), difference(c, a), least_product)) return sign;
    if (const int sign = certain_sign(scaled_difference(b, a), scaled_difference(c, a), Number(0)))
      return sign;
    if (a.is_double() && b.is_double() && c.is_double())
      return Doubles::orientation(double_point(a), double_point(b), double_point(c));
    return static_cast<int>(CGAL::sign(exact_doubled_area(a, b, c)));
  }

  /// 1 if d lies inside the circle through a, b, c (counterclockwise), 0 if on it, else -1; exact.
  static int side_of_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
    const In_circle by_doubles(difference(a, d), difference(b, d), difference(c, d));
    if (by_doubles.is_certain()) return by_doubles.is_positive() ? 1 : -1;
    const Basic_in_circle<Number> test(scaled_difference(a, d), scaled_difference(b, d),
                                       scaled_difference(c, d));
    if (test.is_certain()) return test.is_positive() ? 1 : -1;
    if (a.is_double() && b.is_double() && c.is_double() && d.is_double())
      return Doubles::side_of_circle(double_point(a), double_point(b), double_point(c), double_point(d));
    const auto x = [&](const Point& p) { return Coordinate::exact_difference(p.x, d.x); };
    const auto y = [&](const Point& p) { return Coordinate::exact_difference(p.y, d.y); };
    return static_cast<int>(
        CGAL::side_of_oriented_circleC2(x(a), y(a), x(b), y(b), x(c), y(c), Field(0), Field(0)));
  }
  /// Whether d lies strictly inside the circle through a, b, c (counterclockwise); exact.
  static bool is_in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
    return side_of_circle(a, b, c, d) > 0;
  }

  /// The corner, next to p, of the quadtree's cells with the given side, a power of two.
  static Point nearest_corner(const Point& p, const Number& side) {
    const int exponent = ilogb(side);
    return {Coordinate::nearest_multiple(p.x, 0, exponent), Coordinate::nearest_multiple(p.y, 0, exponent)};
  }

private:
  static constexpr int bits_of_translation = 30;
  static constexpr double infinite_length = 0x1p1000; // coordinates are of the order of 1
  /// Differences and products of doubles that underflow are off by less.
  static constexpr double least_product = 1e-290;

  /// Sign of the cross product of differences that were rounded once; 0 if that is not certain.
  template <class N>
  static int certain_sign(const Basic_vector<N>& u, const Basic_vector<N>& v, const N& underflow) {
    using std::fabs;
    const N l = u.x * v.y, r = u.y * v.x, d = l - r;
    return fabs(d) > 3.5e-16 * (fabs(l) + fabs(r)) + underflow ? (d > N(0) ? 1 : -1) : 0;
  }

  static Field exact_doubled_area(const Point& a, const Point& b, const Point& c) {
    const auto x = [&](const Point& p) { return Coordinate::exact_difference(p.x, a.x); };
    const auto y = [&](const Point& p) { return Coordinate::exact_difference(p.y, a.y); };
    return x(b) * y(c) - y(b) * x(c);
  }

  using Doubles = Double_geometry_2<Exact_predicates_inexact_constructions_kernel>;
  static typename Doubles::Point double_point(const Point& p) { return {p.x.high(), p.y.high()}; }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_EXACT_GEOMETRY_H
