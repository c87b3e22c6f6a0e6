// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Whether the angles of triangles are in a range, decided on coordinates.
//
// Dot and cross products of differences of coordinates, in doubles, decide all triangles except nearly
// right-angled or nearly flat ones. For these, rational arithmetic decides the sign of a dot product.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_ANGLES_OF_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_ANGLES_OF_MESH_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Coordinate>
auto exact_difference(const Coordinate& a, const Coordinate& b) {
  if constexpr (std::is_floating_point<Coordinate>::value)
    return Exact_rational(Exact_rational(a) - Exact_rational(b));
  else if constexpr (std::is_integral<Coordinate>::value)
    return boost::multiprecision::cpp_int(a - b);
  else
    return typename std::decay<decltype(a.exact())>::type(a.exact() - b.exact());
}

/// Whether the angle b, a, c is less than 90 degrees; exact.
template <class Geometry>
bool is_acute_at(const typename Geometry::Point& a, const typename Geometry::Point& b,
                 const typename Geometry::Point& c) {
  const Vector u = Geometry::difference(b, a), v = Geometry::difference(c, a);
  const double d = dot(u, v), magnitude = std::fabs(u.x * v.x) + std::fabs(u.y * v.y);
  if (std::fabs(d) > 1e-15 * magnitude && magnitude > 1e-280) return d > 0;
  const auto ux = exact_difference(b.x, a.x), uy = exact_difference(b.y, a.y),
             vx = exact_difference(c.x, a.x), vy = exact_difference(c.y, a.y);
  return ux * vx + uy * vy > 0;
}

/// Whether all angles of a triangle are less than 90 degrees and it is counterclockwise; exact.
template <class Geometry>
bool is_acute(const typename Geometry::Point& a, const typename Geometry::Point& b,
              const typename Geometry::Point& c) {
  return Geometry::orientation(a, b, c) > 0 && is_acute_at<Geometry>(a, b, c) &&
         is_acute_at<Geometry>(b, c, a) && is_acute_at<Geometry>(c, a, b);
}

/// The least and the greatest cotangent of the angles of a triangle, as seen by doubles; (0, -1) for one that is not
/// counterclockwise.
struct Cotangents {
  double least, greatest;

  template <class Geometry>
  static Cotangents of(const typename Geometry::Point& a, const typename Geometry::Point& b,
                       const typename Geometry::Point& c) {
    const Vector ab = Geometry::difference(b, a), ac = Geometry::difference(c, a),
                 bc = Geometry::difference(c, b);
    const double area2 = doubled_area(ab, ac, bc);
    constexpr double least_certain_area = 1e-280; // products of smaller vectors underflow
    if (area2 > least_certain_area) return of_vectors(ab, ac, bc, area2);
    const double scale = std::max({std::fabs(ab.x), std::fabs(ab.y), std::fabs(ac.x), std::fabs(ac.y)});
    if (!(scale > 0 && scale < 1e-120)) return area2 > 0 ? of_vectors(ab, ac, bc, area2) : Cotangents{0, -1};
    const auto scaled = [&](Vector v) { return Vector{v.x / scale, v.y / scale}; };
    const double scaled_area = doubled_area(scaled(ab), scaled(ac), scaled(bc));
    if (!(scaled_area > 0)) return {0, -1};
    return of_vectors(scaled(ab), scaled(ac), scaled(bc), scaled_area);
  }

private:
  /// By the two shorter sides: the products of two long ones at a small angle would cancel each other.
  static double doubled_area(Vector ab, Vector ac, Vector bc) {
    const double c = squared_length(ab), b = squared_length(ac), a = squared_length(bc);
    if (a >= b && a >= c) return cross(ab, ac);
    return b >= c ? cross(ab, bc) : cross(ac, bc);
  }

  static Cotangents of_vectors(Vector ab, Vector ac, Vector bc, double area2) {
    const double at_a = dot(ab, ac) / area2, at_b = -dot(ab, bc) / area2, at_c = dot(ac, bc) / area2;
    return {std::min({at_a, at_b, at_c}), std::max({at_a, at_b, at_c})};
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_ANGLES_OF_MESH_H
