// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_INTEGER_MESH_H
#define QUADTREE_MESH_2_TEST_INTEGER_MESH_H

// Triangles with integer coordinates, and what can be said of them exactly.

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

using Integer_point = std::array<std::int64_t, 2>;
using Integer_edge = std::pair<int, int>;

/// Coordinates below 2^19 in absolute value.
struct Integer_mesh {
  std::vector<Integer_point> points;
  std::vector<std::array<int, 3>> triangles;

  /// By the tables' types; some of the places in the arrays may be unused.
  template <class Vertices, class Triangles>
  static Integer_mesh of(const Vertices& vertices, int n, const Triangles& triangles, int t) {
    Integer_mesh mesh;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
      mesh.points.push_back({vertices[i][0], vertices[i][1]});
    for (std::size_t i = 0; i < static_cast<std::size_t>(t); ++i)
      mesh.triangles.push_back({triangles[i][0], triangles[i][1], triangles[i][2]});
    return mesh;
  }

  const Integer_point& point(int i) const { return points[static_cast<std::size_t>(i)]; }
};

inline std::int64_t cross(const Integer_point& p, const Integer_point& q, const Integer_point& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}
inline std::int64_t dot(const Integer_point& p, const Integer_point& q, const Integer_point& r) {
  return (q[0] - p[0]) * (r[0] - p[0]) + (q[1] - p[1]) * (r[1] - p[1]);
}

/// An open range of angles, given by bounds for the cotangent in units of 1/`units`, rounded to the safe side: an
/// angle with a cotangent between the two bounds is in the range. (The last unit is far more than the error of
/// `std::tan`.)
struct Cotangent_range {
  static constexpr std::int64_t units = 1 << 18;
  std::int64_t least, greatest;

  Cotangent_range(double least_degrees, double greatest_degrees)
      : least(static_cast<std::int64_t>(std::floor(cotangent(greatest_degrees))) + 2),
        greatest(static_cast<std::int64_t>(std::floor(cotangent(least_degrees))) - 1) {}

private:
  static double cotangent(double degrees) {
    return static_cast<double>(units) / std::tan(degrees * CGAL_PI / 180);
  }
};

/// Whether all triangles are counterclockwise with angles in the range. Since the range ends below 180 degrees,
/// an angle in it is counterclockwise.
inline bool has_angles_within(const Integer_mesh& mesh, const Cotangent_range& range) {
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Integer_point &p = mesh.point(t[i]), &q = mesh.point(t[(i + 1) % 3]),
                          &r = mesh.point(t[(i + 2) % 3]);
      const std::int64_t c = cross(p, q, r), d = dot(p, q, r) * Cotangent_range::units;
      if (c <= 0 || d <= range.least * c || d >= range.greatest * c) return false;
    }
  return true;
}

/// Whether all triangles are counterclockwise with angles below 90 degrees.
inline bool is_strictly_acute(const Integer_mesh& mesh) {
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Integer_point &p = mesh.point(t[i]), &q = mesh.point(t[(i + 1) % 3]),
                          &r = mesh.point(t[(i + 2) % 3]);
      if (cross(p, q, r) <= 0 || dot(p, q, r) <= 0) return false;
    }
  return true;
}

inline std::int64_t doubled_area(const Integer_mesh& mesh) {
  std::int64_t area = 0;
  for (const auto& t : mesh.triangles) area += cross(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]));
  return area;
}

/// The sides of triangles, directed, that no other triangle has in the opposite direction, sorted.
inline std::vector<Integer_edge> unmatched_edges(const Integer_mesh& mesh) {
  std::vector<Integer_edge> edges, unmatched;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(t[i], t[(i + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  for (const Integer_edge& e : edges)
    if (!std::binary_search(edges.begin(), edges.end(), Integer_edge(e.second, e.first)))
      unmatched.push_back(e);
  return unmatched;
}

/// Whether two triangles have the same side in the same direction, or some point is in no triangle.
inline bool has_repeated_sides_or_unused_points(const Integer_mesh& mesh) {
  std::vector<Integer_edge> edges;
  std::vector<bool> is_used(mesh.points.size());
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      edges.emplace_back(t[i], t[(i + 1) % 3]);
      is_used[static_cast<std::size_t>(t[i])] = true;
    }
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) != edges.end() ||
         std::find(is_used.begin(), is_used.end(), false) != is_used.end();
}

/// Whether these are counterclockwise triangles that cover the region whose boundary are the given directed
/// edges, with the region on their left, without overlap: points not on edges are covered as often as the
/// boundary winds around them. The boundary must consist of simple polygons. `boundary` must be sorted.
inline bool is_triangulation_within(const Integer_mesh& mesh, const std::vector<Integer_edge>& boundary) {
  for (const auto& t : mesh.triangles)
    if (cross(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])) <= 0) return false;
  return !has_repeated_sides_or_unused_points(mesh) && unmatched_edges(mesh) == boundary;
}

/// Equal points, with different indices or not, become one.
inline Integer_mesh merge_equal_points(const Integer_mesh& mesh) {
  Integer_mesh merged;
  merged.points = mesh.points;
  std::sort(merged.points.begin(), merged.points.end());
  merged.points.erase(std::unique(merged.points.begin(), merged.points.end()), merged.points.end());
  for (const auto& t : mesh.triangles) {
    std::array<int, 3> triangle{};
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i] =
          static_cast<int>(std::lower_bound(merged.points.begin(), merged.points.end(), mesh.point(t[i])) -
                           merged.points.begin());
    merged.triangles.push_back(triangle);
  }
  return merged;
}

#endif // QUADTREE_MESH_2_TEST_INTEGER_MESH_H
