// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The arithmetic of the meshing kernel, over double and over integer coordinates (over exact ones:
// exact_geometry.h).
//
// A geometry gives points, their differences, an exact orientation, an exact in-circle test, and the corners
// of the quadtree's cells. Differences are vectors of doubles, and vectors of numbers of any size. The two
// are the same if coordinates are limited. Everything that is certain (which side, inside which circle) is
// decided on the points. Everything that is only better or worse (angles, places of new points) is decided on
// vectors of doubles. Their components are correct to half a unit in the last place. What is below a rounding
// error there is not a share of any length: a triangle may be as small as coordinates can tell.
//
// Double coordinates are of the order of 2^200 (coordinate_map.h). Angles and circles are compared by
// products of four differences. These products keep their bits down to differences of 2^-242. Vertices nearer
// to each other than 2^-220 are refused, so there is room for the triangles around them.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_MESHING_GEOMETRY_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_MESHING_GEOMETRY_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Wide_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry_fwd.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A difference of two points.
template <class Number>
struct Basic_vector {
  Number x = 0, y = 0;

  friend Basic_vector operator+(Basic_vector a, Basic_vector b) { return {a.x + b.x, a.y + b.y}; }
  friend Basic_vector operator-(Basic_vector a, Basic_vector b) { return {a.x - b.x, a.y - b.y}; }
  friend Basic_vector operator*(Number s, Basic_vector a) { return {s * a.x, s * a.y}; }
};
using Vector = Basic_vector<double>;

template <class Number>
Number dot(const Basic_vector<Number>& a, const Basic_vector<Number>& b) {
  return a.x * b.x + a.y * b.y;
}
template <class Number>
Number cross(const Basic_vector<Number>& a, const Basic_vector<Number>& b) {
  return a.x * b.y - a.y * b.x;
}
template <class Number>
Number squared_length(const Basic_vector<Number>& a) {
  return dot(a, a);
}
template <class Number>
Number length(const Basic_vector<Number>& a) {
  using std::sqrt;
  return sqrt(squared_length(a));
}

/// a / b as a double: of lengths, which as such may be of any size.
inline double ratio(double a, double b) { return a / b; }

/// The lesser and the greater of two lengths. By value: of references g++ makes branches, which are taken at random.
template <class Number>
Number lesser(Number a, Number b) {
  return b < a ? b : a;
}
template <class Number>
Number greater(Number a, Number b) {
  return a < b ? b : a;
}

/// The greatest power of two that is at most x, positive; the same on every machine.
inline double power_of_two_at_most(double x) {
  constexpr std::uint64_t bits_of_exponent = 0x7ff0000000000000u;
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits &= bits_of_exponent;
  if (bits == 0 || bits == bits_of_exponent)
    return std::ldexp(1.0, std::ilogb(x)); // below the normal numbers, or none
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}

/// Squared side lengths of a triangle (`l[k]` opposite vertex k) and its doubled signed area.
template <class Number>
struct Basic_shape {
  Number l[3];
  Number area2;

  Number shortest() const { return lesser(l[0], lesser(l[1], l[2])); }
  Number longest() const { return greater(l[0], greater(l[1], l[2])); }

  /// Whether the area is positive for certain, if it was computed from differences of coordinates that were
  /// rounded once. Their cross product is then correct to 5 half units in the last place of the sum of its
  /// two products. That sum is at most the longest squared side.
  bool is_certainly_counterclockwise() const { return area2 > 1e-15 * longest(); }

  /// Whether the angle at vertex k is certainly below, or above, 90 degrees, on the same condition: each squared side
  /// is correct to 4 half units in its last place.
  bool is_certainly_acute(int k) const { return twice_dot(k) > error_of_twice_dot(); }
  bool is_certainly_obtuse(int k) const { return twice_dot(k) < -error_of_twice_dot(); }

  /// Whether the angle at vertex k is below 60 degrees, or so near that it cannot be told.
  bool may_be_below_60_degrees(int k) const {
    const Number c = twice_dot(k) + error_of_twice_dot();
    const bool is_acute = c > 0,
               is_sharp = c * c > (1 - 1e-9) * (l[k == 2 ? 0 : k + 1] * l[k == 0 ? 2 : k - 1]);
    return is_acute & is_sharp;
  }

  /// Slot of the vertex opposite the shortest side.
  int slot_of_shortest() const { return l[0] <= l[1] && l[0] <= l[2] ? 0 : l[1] <= l[2] ? 1 : 2; }

  /// Slot of the vertex opposite the longest side, another one than `slot_of_shortest()`; and the slot of neither.
  int slot_of_longest() const {
    const int k = slot_of_shortest(), i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
    return l[i] < l[j] ? j : i;
  }
  int slot_of_middle() const { return 3 - slot_of_shortest() - slot_of_longest(); }

  /// The product of the two longer squared sides, of which the least angle is between. No product of three: it would
  /// underflow too soon.
  Number product_of_longer() const {
    return greater<Number>(l[0] * l[1], greater<Number>(l[1] * l[2], l[2] * l[0]));
  }

  /// Whether the least angle's squared sine is below `sin2`.
  bool is_below(Number sin2) const { return area2 * area2 < sin2 * product_of_longer(); }

  /// Whether the greatest angle is above the obtuse one whose squared cosine is `cosine2`.
  bool is_wider(Number cosine2) const {
    const Number longest = this->longest(), others = (l[0] + l[1] + l[2]) - longest,
                 excess = longest - others;
    if (!(excess > 0)) return false; // not obtuse
    const Number product = l[0] == longest ? l[1] * l[2] : l[1] == longest ? l[2] * l[0] : l[0] * l[1];
    return excess * excess > 4 * cosine2 * product;
  }

  /// The squared sine of the least angle.
  double sin2_of_least_angle() const { return ratio(area2 * area2, product_of_longer()); }

private:
  /// Twice the scalar product of the sides at vertex k.
  Number twice_dot(int k) const { return l[k == 2 ? 0 : k + 1] + l[k == 0 ? 2 : k - 1] - l[k]; }
  Number error_of_twice_dot() const {
    constexpr double least = std::is_same<Number, double>::value ? 1e-280 : 0; // of products that underflow
    return 1e-14 * longest() + least;
  }
};
using Shape = Basic_shape<double>;

/// The in-circle determinant of a, b, c (counterclockwise) given relative to the query, and the sum of the
/// magnitudes it is made of; that is worked out only where the determinant's sign leaves a doubt.
template <class Number>
class Basic_in_circle {
  using Vector = Basic_vector<Number>;

public:
  Basic_in_circle(Vector a, Vector b, Vector c)
      : al(squared_length(a)), bl(squared_length(b)), cl(squared_length(c)), p1(b.x * c.y), p2(c.x * b.y),
        p3(c.x * a.y), p4(a.x * c.y), p5(a.x * b.y), p6(b.x * a.y),
        determinant_(al * (p1 - p2) + bl * (p3 - p4) + cl * (p5 - p6)) {}

  bool is_positive() const { return determinant_ > 0; }
  /// Whether a, b, c are nearly collinear, seen from the query, or so near to each other that products underflow.
  bool is_flat() const { return (p1 - p2) + (p3 - p4) + (p5 - p6) < 1e-10 * (al + bl + cl) + least_area; }
  /// Whether a positive sign is certain.
  bool is_certainly_inside() const { return determinant_ > 0 && determinant_ > least_certain(); }
  bool is_certain() const {
    using std::fabs;
    return fabs(determinant_) > least_certain();
  }

private:
  /// Shewchuk's bound for differences rounded once is (10 + 96 eps) eps < 1.12e-15.
  static constexpr double error_bound = 1.2e-15;
  /// Products of doubles that underflow are off by less than 1e-323; those of numbers without limits never do.
  static constexpr bool is_limited = std::is_same<Number, double>::value;
  static constexpr double least_product = is_limited ? 1e-300 : 0, least_area = is_limited ? 1e-140 : 0;

  Number al, bl, cl, p1, p2, p3, p4, p5, p6;
  Number determinant_;

  Number least_certain() const {
    using std::fabs;
    return error_bound *
               (al * (fabs(p1) + fabs(p2)) + bl * (fabs(p3) + fabs(p4)) + cl * (fabs(p5) + fabs(p6))) +
           least_product * (al + bl + cl + 1);
  }
};
using In_circle = Basic_in_circle<double>;

/// Whether a, b, c and d are, in some order, the corners of a rectangle with sides parallel to the axes. Such
/// ties are frequent where squares fill the bulk of a mesh, and dear to find by arithmetic.
template <class Point>
bool are_corners_of_rectangle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto is_split = [](auto p, auto q, auto r, auto s) { return p == q && r == s; };
  const bool xab = is_split(a.x, b.x, c.x, d.x), xac = is_split(a.x, c.x, b.x, d.x);
  const bool xad = is_split(a.x, d.x, b.x, c.x);
  if (!xab && !xac && !xad) return false;
  const bool yab = is_split(a.y, b.y, c.y, d.y), yac = is_split(a.y, c.y, b.y, d.y);
  const bool yad = is_split(a.y, d.y, b.y, c.y);
  return (xab && (yac || yad)) || (xac && (yab || yad)) || (xad && (yab || yac));
}

/// What geometries with rounded coordinates decide by vectors of doubles; those with exact ones by the points.
template <class Geometry>
struct Rounded_geometry {
  /// Lengths of anything in a mesh, and products of four of them.
  using Number = double;
  /// The same as `Geometry::difference()`, which suits all lengths.
  template <class Point>
  static Vector scaled_difference(const Point& p, const Point& q) {
    return Geometry::difference(p, q);
  }
  /// Of the triangle a, b, c, with u = b - a and v = c - b.
  template <class Point>
  static double doubled_area(Vector u, Vector v, const Point&, const Point&, const Point&) {
    return cross(u, v);
  }
  /// Whether d lies strictly inside the circle through a, b, c (counterclockwise); exact.
  template <class Point>
  static bool is_in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
    return Geometry::side_of_circle(a, b, c, d) > 0;
  }
  /// For flips that have to end whatever the rounding: ties and near-ties are left as they are; but not those of
  /// triangles that are nearly flat, whose circle says nothing in doubles: they are decided exactly.
  template <class Point>
  static bool is_certainly_in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
    const In_circle test(Geometry::difference(a, d), Geometry::difference(b, d), Geometry::difference(c, d));
    return test.is_flat() ? Geometry::is_in_circle(a, b, c, d) : test.is_certainly_inside();
  }
  /// The same, to a relative 1e-4 however flat the triangle is.
  template <class Point>
  static double doubled_area_of_flat(Vector u, Vector v, const Point& a, const Point& b, const Point& c) {
    const double l = u.x * v.y, r = u.y * v.x;
    if (std::fabs(l - r) > 1e-11 * (std::fabs(l) + std::fabs(r))) return l - r;
    return Geometry::exact_doubled_area(a, b, c);
  }
  /// The point at the given share of the way from p to q, rounded.
  template <class Point>
  static Point between(const Point& p, const Point& q, double share) {
    return Geometry::translate(p, share * Geometry::difference(q, p));
  }
  /// A point m that is meant to lie on the line through p and q, brought back to it where that is off by more than a
  /// unit in the last place of the larger coordinates along the axes.
  template <class Point>
  static Point back_to_line(const Point& p, const Point& q, const Point& m) {
    constexpr double unit = 0x1p-53; // of a number just below a power of two, the least
    const Vector d = Geometry::difference(q, p), from_p = Geometry::difference(m, p),
                 from_q = Geometry::difference(m, q);
    const double off = cross(d, squared_length(from_p) <= squared_length(from_q) ? from_p : from_q);
    const auto larger = [](auto a, auto b) {
      return static_cast<double>(std::max(a < 0 ? -a : a, b < 0 ? -b : b));
    };
    const double reach = std::fabs(d.x) * larger(p.y, q.y) + std::fabs(d.y) * larger(p.x, q.x);
    if (std::fabs(off) <= unit * reach) return m;
    return Geometry::translate(m, (off / squared_length(d)) * Vector{d.y, -d.x});
  }
  /// A share, about the given one, for which the coordinates of a point between others do not become long.
  static double short_share(double share) { return share; }
};

/// Points with double coordinates, predicates decided by the filtered kernel `Kernel`.
template <class Kernel>
struct Double_geometry_2 : Rounded_geometry<Double_geometry_2<Kernel>> {
  using Coordinate = double;
  static constexpr bool has_unlimited_coordinates = false;
  /// Vertices nearer to each other, or to a segment, are not meshed.
  static constexpr double least_length = 0x1p-220;
  struct Point {
    double x = 0, y = 0;
    friend bool operator==(Point a, Point b) { return a.x == b.x && a.y == b.y; }
  };

  static Vector difference(Point p, Point q) { return {p.x - q.x, p.y - q.y}; }
  static Point translate(Point p, Vector v) { return {p.x + v.x, p.y + v.y}; }
  /// How far coordinates as large as this one are from the next ones.
  static double spacing(double x) {
    return x == 0 ? 0 : std::numeric_limits<double>::epsilon() * power_of_two_at_most(std::fabs(x));
  }
  static double spacing(Point p) { return std::max(spacing(p.x), spacing(p.y)); }

  /// Whether there are places for a vertex at this squared distance from p: within one or two units in the last place
  /// there are none.
  static bool is_resolved(Point p, double squared_distance) {
    constexpr double least = 0x1p-17 * least_length;
    const double units = std::max(least, 0x1p-52 * std::max(std::fabs(p.x), std::fabs(p.y)));
    return squared_distance >= units * units;
  }

  static double exact_doubled_area(Point a, Point b, Point c) {
    const Exact_rational ax(a.x), ay(a.y);
    return CGAL::to_double(Exact_rational((Exact_rational(b.x) - ax) * (Exact_rational(c.y) - ay) -
                                          (Exact_rational(b.y) - ay) * (Exact_rational(c.x) - ax)));
  }

  /// Sign of the turn a, b, c; exact. The filter is Shewchuk's ccwerrboundA; products that underflow go to
  /// the kernel.
  static int orientation(Point a, Point b, Point c) {
    const double l = (b.x - a.x) * (c.y - a.y), r = (b.y - a.y) * (c.x - a.x);
    const double d = l - r, magnitude = std::fabs(l) + std::fabs(r);
    if (std::fabs(d) > 3.4e-16 * magnitude && magnitude > 1e-280) return d > 0 ? 1 : -1;
    return orientation_by_kernel(a, b, c);
  }

  /// 1 if d lies inside the circle through a, b, c (counterclockwise), 0 if on it, else -1; exact.
  static int side_of_circle(Point a, Point b, Point c, Point d) {
    const In_circle test(difference(a, d), difference(b, d), difference(c, d));
    if (test.is_certain()) return test.is_positive() ? 1 : -1;
    return side_of_circle_by_kernel(a, b, c, d);
  }

  /// The corner, next to p, of the quadtree's cells with the given side, a power of two.
  static Point nearest_corner(Point p, double side) {
    return {side * std::floor(p.x / side + 0.5), side * std::floor(p.y / side + 0.5)};
  }

private:
  static typename Kernel::Point_2 kernel_point(Point p) { return typename Kernel::Point_2(p.x, p.y); }

  // Rare, and apart, so that compilers inline what is frequent.
  static BOOST_NOINLINE int orientation_by_kernel(Point a, Point b, Point c) {
    return static_cast<int>(
        typename Kernel::Orientation_2()(kernel_point(a), kernel_point(b), kernel_point(c)));
  }
  static BOOST_NOINLINE int side_of_circle_by_kernel(Point a, Point b, Point c, Point d) {
    if (are_corners_of_rectangle(a, b, c, d)) return 0;
    return static_cast<int>(typename Kernel::Side_of_oriented_circle_2()(kernel_point(a), kernel_point(b),
                                                                         kernel_point(c), kernel_point(d)));
  }
};

/// Points with integer coordinates below 2^62 (2^31 for 32-bit words); all predicates in integers.
template <class Word>
struct Integer_geometry_2 : Rounded_geometry<Integer_geometry_2<Word>> {
  using Coordinate = std::int64_t;
  static constexpr bool has_unlimited_coordinates = false;
  /// Distinct vertices are never too near.
  static constexpr double least_length = 0;
  struct Point {
    std::int64_t x = 0, y = 0;
    friend bool operator==(Point a, Point b) { return a.x == b.x && a.y == b.y; }
  };

  static Vector difference(Point p, Point q) {
    return {static_cast<double>(p.x - q.x), static_cast<double>(p.y - q.y)};
  }
  static Point translate(Point p, Vector v) { return {p.x + std::llround(v.x), p.y + std::llround(v.y)}; }
  /// How far coordinates are from the next ones.
  static double spacing(std::int64_t) { return 1; }
  static double spacing(const Point&) { return 1; }

  /// Whether there are places for a vertex at this squared distance from p.
  static bool is_resolved(Point, double squared_distance) { return squared_distance >= 4; }

  static int orientation(Point a, Point b, Point c) {
    const Wide_integer d = wide_doubled_area(a, b, c);
    return d > 0 ? 1 : d < 0 ? -1 : 0;
  }
  static double exact_doubled_area(Point a, Point b, Point c) {
    return static_cast<double>(wide_doubled_area(a, b, c));
  }

  /// 1 if d lies inside the circle through a, b, c (counterclockwise), 0 if on it, else -1; exact.
  static int side_of_circle(Point a, Point b, Point c, Point d) {
    const In_circle test(difference(a, d), difference(b, d), difference(c, d));
    if (test.is_certain()) return test.is_positive() ? 1 : -1;
    return are_corners_of_rectangle(a, b, c, d) ? 0 : exact_side_of_circle(a, b, c, d);
  }

  static Point nearest_corner(Point p, double side) {
    const std::int64_t h = side < 1 ? 1 : static_cast<std::int64_t>(side);
    return {round_to_multiple(p.x, h), round_to_multiple(p.y, h)};
  }

private:
  using Widest = boost::multiprecision::int512_t;

  static Wide_integer wide_doubled_area(Point a, Point b, Point c) {
    return Wide_integer(b.x - a.x) * (c.y - a.y) - Wide_integer(b.y - a.y) * (c.x - a.x);
  }

  /// The nearest multiple of h, a power of two.
  static std::int64_t round_to_multiple(std::int64_t x, std::int64_t h) { return (x + h / 2) & ~(h - 1); }

  static int exact_side_of_circle(Point a, Point b, Point c, Point d) {
    const Widest ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x,
                 cy = c.y - d.y;
    const Widest al = ax * ax + ay * ay, bl = bx * bx + by * by, cl = cx * cx + cy * cy;
    const Widest determinant = al * (bx * cy - cx * by) + bl * (cx * ay - ax * cy) + cl * (ax * by - bx * ay);
    return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_MESHING_GEOMETRY_H
