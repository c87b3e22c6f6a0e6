// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The arithmetic of the meshing kernel over a geometry that a user wrote, a model of MeshingGeometry_2.
//
// The model says what is particular to its coordinates: predicates, differences, rounding. All else that the kernel
// asks follows from that, by the rules of other geometries with rounded coordinates. Nothing of the model is used but
// what the concept lists.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_ADAPTED_GEOMETRY_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_ADAPTED_GEOMETRY_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/Model_requirements.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry_fwd.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Model>
struct Adapted_geometry : Model_requirements<Model>, Rounded_geometry<Adapted_geometry<Model>> {
  using Coordinate = typename Model::Coordinate;
  using Point = typename Model::Point;
  static_assert(std::is_trivially_copyable_v<Point>,
                "MeshingGeometry_2: a `Point` cannot be copied as bytes");
  static constexpr bool has_unlimited_coordinates = false;
  static constexpr double least_length = Model::least_length;

  static int orientation(const Point& a, const Point& b, const Point& c) {
    return sign(int(Model::orientation(a, b, c)));
  }
  static int side_of_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
    return sign(int(Model::side_of_circle(a, b, c, d)));
  }
  static double exact_doubled_area(const Point& a, const Point& b, const Point& c) {
    return Model::doubled_area(a, b, c);
  }

  static Vector difference(const Point& p, const Point& q) {
    const auto v = Model::difference(p, q);
    return {v.x, v.y};
  }
  static Point translate(const Point& p, Vector v) {
    return Model::translate(p, typename Model::Vector{v.x, v.y});
  }
  static Point nearest_corner(const Point& p, double side) { return Model::nearest_corner(p, side); }

  /// How far coordinates are from the next ones.
  static double spacing(const Coordinate& c) { return Model::spacing(c); }
  static double spacing(const Point& p) { return std::max(spacing(p.x), spacing(p.y)); }

  /// Whether there are places for a vertex at this squared distance from p: within two units there are none.
  static bool is_resolved(const Point& p, double squared_distance) {
    const double units = std::max(0x1p-17 * least_length, 2 * spacing(p));
    return squared_distance >= units * units;
  }

  /// A point m that is meant to lie on the line through p and q, brought back to it where that is off by more than
  /// half a unit along the axes.
  static Point back_to_line(const Point& p, const Point& q, const Point& m) {
    const Vector d = difference(q, p), from_p = difference(m, p), from_q = difference(m, q);
    const double off = cross(d, squared_length(from_p) <= squared_length(from_q) ? from_p : from_q);
    const double reach = std::fabs(d.x) * std::max(spacing(p.y), spacing(q.y)) +
                         std::fabs(d.y) * std::max(spacing(p.x), spacing(q.x));
    if (std::fabs(off) <= 0.5 * reach) return m;
    return translate(m, (off / squared_length(d)) * Vector{d.y, -d.x});
  }

private:
  static int sign(int s) { return (s > 0 ? 1 : 0) - (s < 0 ? 1 : 0); }
};

/// Whether a geometry is one of the package's, which have all that the kernel asks.
template <class Geometry>
constexpr bool is_kernel_geometry = false;
template <class Kernel>
constexpr bool is_kernel_geometry<Double_geometry_2<Kernel>> = true;
template <class Word>
constexpr bool is_kernel_geometry<Integer_geometry_2<Word>> = true;
template <class Kernel>
constexpr bool is_kernel_geometry<Exact_geometry_2<Kernel>> = true;

/// What the mesher computes with: the geometry that traits name, or the adapted one over it.
template <class Traits>
using Mesher_geometry = std::conditional_t<is_kernel_geometry<typename Traits::Meshing_geometry_2>,
                                           typename Traits::Meshing_geometry_2,
                                           Adapted_geometry<typename Traits::Meshing_geometry_2>>;

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_ADAPTED_GEOMETRY_H
