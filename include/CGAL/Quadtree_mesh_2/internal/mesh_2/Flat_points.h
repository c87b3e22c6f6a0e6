// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Converts the points of a triangulation to the mesher's points in the plane, and back.
//
// Kernels over double, filtered or not, are meshed with the points of one filtered kernel, because only the
// mesher's own predicates matter. Kernels with exact numbers are meshed in their own points. Traits that
// project points of space (`Projection_traits_xy_3` and its like) are meshed in the plane of projection. A
// new vertex is lifted back to the surface of the original triangulation.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_FLAT_POINTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_FLAT_POINTS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Projection_traits_xy_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point, class = void>
struct Is_point_of_space : std::false_type {};
template <class Point>
struct Is_point_of_space<Point, std::void_t<decltype(std::declval<const Point&>().z())>> : std::true_type {};

/// For triangulations of points of the plane.
template <class Cdt, class = void>
class Flat_points {
  using User_point = typename Cdt::Point;
  using User_kernel = typename Kernel_traits<User_point>::Kernel;
  static constexpr bool is_over_double = std::is_same_v<typename User_kernel::FT, double>;

public:
  using Kernel =
      std::conditional_t<is_over_double, Exact_predicates_inexact_constructions_kernel, User_kernel>;
  using Traits = std::conditional_t<is_over_double, Filtered_quadtree_traits_2<Kernel>,
                                    Exact_quadtree_traits_2<User_kernel>>;
  using Point = typename Kernel::Point_2;

  explicit Flat_points(const Cdt&) {}

  Point operator()(const User_point& p) const {
    if constexpr (std::is_same_v<Point, User_point>)
      return p;
    else
      return Point(p.x(), p.y());
  }
  User_point lift(const Point& p) const {
    if constexpr (std::is_same_v<Point, User_point>)
      return p;
    else
      return User_point(p.x(), p.y());
  }
  User_point lift_to_segment(const Point& p, const User_point&, const User_point&) const { return lift(p); }
};

/// The axes of a plane of projection, the third across it, each with the length 1.
struct Projection_axes {
  std::array<std::array<double, 3>, 3> axis;
};

template <class R>
constexpr std::array<int, 3> coordinates_of(const CGAL::internal::Projection_traits_3<R, 2>*) {
  return {0, 1, 2};
}
template <class R>
constexpr std::array<int, 3> coordinates_of(const CGAL::internal::Projection_traits_3<R, 1>*) {
  return {0, 2, 1};
}
template <class R>
constexpr std::array<int, 3> coordinates_of(const CGAL::internal::Projection_traits_3<R, 0>*) {
  return {1, 2, 0};
}

/// Coordinates of the plane are coordinates of space where the projection is along an axis.
template <class R, int dim>
Projection_axes axes_of(const CGAL::internal::Projection_traits_3<R, dim>& traits) {
  const std::array<int, 3> coordinates = coordinates_of(&traits);
  Projection_axes result{};
  for (std::size_t i = 0; i < 3; ++i) result.axis[i][std::size_t(coordinates[i])] = 1;
  return result;
}

/// Any others, along the traits' `normal()`: right-handed, as seen against the normal.
template <class Traits>
auto axes_of(const Traits& traits) -> decltype(traits.normal(), Projection_axes()) {
  const auto n = traits.normal();
  std::array<double, 3> up{CGAL::to_double(n.x()), CGAL::to_double(n.y()), CGAL::to_double(n.z())};
  const double length = std::hypot(up[0], up[1], up[2]);
  std::size_t least = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    up[i] /= length;
    if (std::fabs(up[i]) < std::fabs(up[least])) least = i;
  }
  const auto cross = [](const auto& a, const auto& b) {
    return std::array<double, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                 a[0] * b[1] - a[1] * b[0]};
  };
  std::array<double, 3> first{};
  first[least] = 1;
  for (std::size_t i = 0; i < 3; ++i) first[i] -= up[least] * up[i];
  const double first_length = std::hypot(first[0], first[1], first[2]);
  for (double& c : first) c /= first_length;
  return {{first, cross(up, first), up}};
}

/// For triangulations of points of space that are projected to a plane. Keeps a copy of the triangulation: the
/// surface.
template <class Cdt>
class Flat_points<Cdt, std::enable_if_t<Is_point_of_space<typename Cdt::Point>::value>> {
  using User_point = typename Cdt::Point;
  static_assert(std::is_same_v<typename Kernel_traits<User_point>::Kernel::FT, double>,
                "points of space to be projected must have double coordinates");

public:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Traits = Filtered_quadtree_traits_2<Kernel>;
  using Point = typename Kernel::Point_2;

  explicit Flat_points(const Cdt& cdt) : surface_(cdt), axes_(axes_of(cdt.geom_traits())) {}

  Point operator()(const User_point& p) const { return Point(along(p, 0), along(p, 1)); }

  /// The point of the surface above `p`; beside the surface, of the edge next to it.
  User_point lift(const Point& p) const {
    const User_point q = at(p, 0);
    if (surface_.dimension() < 2) return q;
    hint_ = surface_.locate(q, hint_);
    if (!surface_.is_infinite(hint_)) return at(p, height_in(hint_, p));
    const int i = hint_->index(surface_.infinite_vertex());
    return lift_to_segment(p, hint_->vertex(Cdt::ccw(i))->point(), hint_->vertex(Cdt::cw(i))->point());
  }

  /// The point above `p` of the segment from a to b.
  User_point lift_to_segment(const Point& p, const User_point& a, const User_point& b) const {
    const double ux = along(b, 0) - along(a, 0), uy = along(b, 1) - along(a, 1);
    const double t = ((p.x() - along(a, 0)) * ux + (p.y() - along(a, 1)) * uy) / (ux * ux + uy * uy);
    return at(p, along(a, 2) + std::min(1.0, std::max(0.0, t)) * (along(b, 2) - along(a, 2)));
  }

private:
  Cdt surface_;
  Projection_axes axes_;
  mutable typename Cdt::Face_handle hint_;

  double along(const User_point& p, std::size_t i) const {
    const auto& a = axes_.axis[i];
    return a[0] * p.x() + a[1] * p.y() + a[2] * p.z();
  }
  User_point at(const Point& p, double height) const {
    const auto c = [&](std::size_t i) {
      return axes_.axis[0][i] * p.x() + axes_.axis[1][i] * p.y() + axes_.axis[2][i] * height;
    };
    return User_point(c(0), c(1), c(2));
  }
  double height_in(typename Cdt::Face_handle f, const Point& p) const {
    const User_point &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
    const double ux = along(b, 0) - along(a, 0), uy = along(b, 1) - along(a, 1);
    const double vx = along(c, 0) - along(a, 0), vy = along(c, 1) - along(a, 1);
    const double px = p.x() - along(a, 0), py = p.y() - along(a, 1), area = ux * vy - uy * vx;
    const double s = area == 0 ? 0 : (px * vy - py * vx) / area,
                 t = area == 0 ? 0 : (ux * py - uy * px) / area;
    return along(a, 2) + s * (along(b, 2) - along(a, 2)) + t * (along(c, 2) - along(a, 2));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_FLAT_POINTS_H
