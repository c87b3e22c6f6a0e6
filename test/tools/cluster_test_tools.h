// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_CLUSTER_TEST_TOOLS_H
#define QUADTREE_MESH_2_TEST_CLUSTER_TEST_TOOLS_H

#include "catch.h"
#include "random_numbers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_frame.h>
#include <CGAL/Quadtree_mesh_2/internal/clusters/cluster_collar.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/exact_dyadic_steps.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/exact_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

/// Inputs with clusters, and the checks of what is around one.
namespace cluster_tests {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using internal::Collar;
using Number = CGAL::Exact_rational;
using Doubles = internal::Double_geometry_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Integers = internal::Integer_geometry_2<std::uint64_t>;
using Exact = internal::Exact_geometry_2<CGAL::Simple_cartesian<Number>>;
using Place = CGAL::Quadtree_mesh_2::Grid_point_2<std::uint64_t>;

template <class Geometry>
using Points = std::vector<typename Geometry::Point>;

using Exact_point = std::array<Number, 2>;

inline Number power(int e) { return internal::power_of_two<Number>(e); }
inline Number to_number(double x) { return Number(x); }
inline Number to_number(std::int64_t x) { return Number(static_cast<long>(x)); }
inline Number to_number(const Exact::Coordinate& x) { return x.exact(); }

template <class Point>
Exact_point exact(const Point& p) {
  return {to_number(p.x), to_number(p.y)};
}

inline Number dot(const Exact_point& a, const Exact_point& b, const Exact_point& c) {
  return (b[0] - a[0]) * (c[0] - a[0]) + (b[1] - a[1]) * (c[1] - a[1]);
}

inline bool is_acute(const Exact_point& a, const Exact_point& b, const Exact_point& c) {
  const Number area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  return area > 0 && dot(a, b, c) > 0 && dot(b, c, a) > 0 && dot(c, a, b) > 0;
}

template <class Point>
void check_offset(const Point& p, const Exact_point& origin, std::array<std::int16_t, 2> steps,
                  int exponent) {
  const Exact_point q = exact(p);
  REQUIRE(q[0] == origin[0] + Number(int(steps[0])) * power(exponent));
  REQUIRE(q[1] == origin[1] + Number(int(steps[1])) * power(exponent));
}

/// Octagon, collar, window and spokes are where they should be, exactly; all triangles between are acute, and each
/// edge has two of them but for those of window and spokes.
template <class Geometry>
void check_ring(const internal::Cluster_frame<Geometry>& frame, int log_leaf) {
  const Exact_point center = exact(frame.center());
  Points<Geometry> points;
  internal::Window_vertices window;
  int k = 0;
  for (const Place& place : frame.window_boundary()) {
    REQUIRE(internal::position_in_window_boundary(place) == k);
    window[std::size_t(k)] = k;
    points.push_back(frame.point_at(place));
    check_offset(points.back(), center, internal::collar().vertices[std::size_t(8 + k)],
                 frame.exponent() - 10);
    ++k;
  }
  std::array<std::int32_t, 8> spokes;
  for (int i = 0; i < 8; ++i) {
    spokes[std::size_t(i)] = std::int32_t(points.size());
    points.push_back(frame.spoke(i, log_leaf));
    check_offset(points.back(), center, internal::star().spokes[std::size_t(i)], log_leaf - 10);
  }
  const internal::Octagon_vertices octagon = internal::append_octagon(frame, points);
  std::vector<internal::Indexed_triangle> triangles;
  for (const auto& t : internal::octagon_triangles(octagon, spokes)) triangles.push_back(t);
  internal::append_collar(frame, octagon, window, points, triangles);
  REQUIRE(triangles.size() == 192);
  REQUIRE(points.size() == std::size_t(Collar::number_of_vertices) + 8);

  std::map<std::pair<std::int32_t, std::int32_t>, int> edges;
  for (const auto& t : triangles) {
    REQUIRE(is_acute(exact(points[std::size_t(t[0])]), exact(points[std::size_t(t[1])]),
                     exact(points[std::size_t(t[2])])));
    for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  }
  std::size_t on_border = 0;
  for (const auto& [edge, count] : edges) {
    REQUIRE(count == 1);
    on_border += edges.count({edge.second, edge.first}) == 0 ? 1 : 0;
  }
  REQUIRE(on_border == 48);
  REQUIRE(edges.count({spokes[0], spokes[1]}) == 1);
  REQUIRE(edges.count({window[1], window[0]}) == 1);
}

/// Few points, with clusters planted whose gaps are about the least, nested and side by side.
inline Points<Doubles> planted(std::size_t n, Random_numbers& random, double least_radius) {
  Points<Doubles> points{{0.1, 0.2}, {0.7, 0.4}, {0.3, 0.9}};
  std::vector<double> radii(points.size(), 0.1);
  while (points.size() < n) {
    const auto i = static_cast<std::size_t>(random() * double(points.size()));
    const double radius = radii[i] * std::exp2(-10 - 3 * random());
    if (radius < least_radius) { // no room: a point for itself
      points.push_back({random(), random()});
      radii.push_back(0.1 / double(points.size()));
      continue;
    }
    const Doubles::Point p = points[i];
    for (int k = 1 + int(random() * 3); k > 0; --k) {
      points.push_back(
          {p.x + radius * (random() - 0.5), p.y + (random() < 0.2 ? 0 : radius * (random() - 0.5))});
      radii.push_back(radius / 4);
    }
    radii[i] = radius / 4;
  }
  return points;
}

template <class Point>
std::vector<Point> distinct(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](const Point& p, const Point& q) { return p.x == q.x ? p.y < q.y : p.x < q.x; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

} // namespace cluster_tests

#endif // QUADTREE_MESH_2_TEST_CLUSTER_TEST_TOOLS_H
