// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Checks of meshes of rings, and meshes to check.

#ifndef QUADTREE_MESH_2_TEST_RING_MESH_CHECKS_H
#define QUADTREE_MESH_2_TEST_RING_MESH_CHECKS_H

#include "catch.h"
#include "random_numbers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Ring_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/fill_tiles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace ring_test {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using internal::Mobility;
using internal::Ring;
using internal::Ring_mesh;
using internal::Ring_vertex;
using internal::Vector;
using Doubles = internal::Double_geometry_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Integers = internal::Integer_geometry_2<std::uint64_t>;

using Triangle = std::array<Ring_vertex, 3>;
using Triangle_set = std::set<Triangle>;

/// The same triangle, its least vertex first.
inline Triangle canonical(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

template <class Geometry>
Triangle_set triangles_of(const Ring_mesh<Geometry>& mesh) {
  Triangle_set result;
  std::size_t count = 0;
  mesh.for_each_triangle([&](Ring_vertex a, Ring_vertex b, Ring_vertex c) {
    if (b < a || c < a) FAIL("a triangle does not begin with its least vertex");
    result.insert({a, b, c});
    ++count;
  });
  if (count != result.size()) FAIL("a triangle is there twice");
  if (count != mesh.number_of_triangles()) FAIL("triangles are counted wrongly");
  return result;
}

/// Whether some rings that are read in the order of triangles say that b, c is a side of the ring of a.
template <class Geometry>
bool has_triangle(const Ring_mesh<Geometry>& mesh, Ring_vertex a, Ring_vertex b, Ring_vertex c) {
  const Ring& r = mesh.ring(a);
  for (int k = 0; k < r.number_of_triangles(); ++k)
    if (r[k] == b && r.next(k) == c) return true;
  return false;
}

/// The rings are those of a triangulation of a disk: the rings of the three vertices of each triangle agree, sides on
/// the border form one cycle, and Euler's formula holds.
template <class Geometry>
void check_disk(const Ring_mesh<Geometry>& mesh) {
  long vertices = 0, edge_ends = 0, corners = 0;
  std::map<Ring_vertex, Ring_vertex> next_on_border;
  for (const Ring_vertex i : mesh.rings.ids()) {
    const Ring_vertex v = Ring_vertex(i);
    if (!mesh.is_alive(v)) continue;
    const Ring& r = mesh.ring(v);
    if (r.size < (r.is_open ? 2 : 3) || r.size > Ring::max_size)
      FAIL("a ring of " << int(r.size) << " members");
    ++vertices;
    edge_ends += r.size;
    corners += r.number_of_triangles();
    for (int k = 0; k < r.size; ++k) {
      if (!r[k].is_valid() || std::size_t(r[k]) >= mesh.number_of_vertices() || r[k] == v)
        FAIL("no such neighbor");
      if (!mesh.is_alive(r[k]) || !mesh.ring(r[k]).contains(v)) FAIL("neighbors do not agree");
      for (int j = 0; j < k; ++j)
        if (r[j] == r[k]) FAIL("a neighbor is there twice");
    }
    for (int k = 0; k < r.number_of_triangles(); ++k)
      if (!has_triangle(mesh, r[k], r.next(k), v) || !has_triangle(mesh, r.next(k), v, r[k]))
        FAIL("the rings of a triangle's vertices do not agree");
    if (r.is_open) next_on_border[v] = r[0];
  }
  if (vertices == 0) FAIL("no vertex");
  if (edge_ends % 2 != 0 || corners % 3 != 0) FAIL("half an edge or a third of a triangle");
  if (vertices - edge_ends / 2 + corners / 3 != 1) FAIL("not a disk");
  if (next_on_border.empty()) FAIL("no border");
  std::size_t length = 0;
  Ring_vertex v = next_on_border.begin()->first;
  do {
    if (next_on_border.count(v) == 0) FAIL("the border leads to an inner vertex");
    v = next_on_border[v];
    ++length;
  } while (v != next_on_border.begin()->first && length <= next_on_border.size());
  if (length != next_on_border.size()) FAIL("the border is not one cycle");
}

/// Twice the area of the triangles, signed, and that within the border.
inline std::pair<std::int64_t, std::int64_t> doubled_areas(const Ring_mesh<Integers>& mesh) {
  std::int64_t area = 0, area_in_border = 0;
  mesh.for_each_triangle([&](Ring_vertex a, Ring_vertex b, Ring_vertex c) {
    const auto &p = mesh.point(a), &q = mesh.point(b), &r = mesh.point(c);
    area += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  });
  for (const Ring_vertex v : mesh.rings.ids()) {
    if (!mesh.is_alive(v) || !mesh.rings[v].is_open) continue;
    const auto &p = mesh.points[v], &q = mesh.point(mesh.rings[v][0]);
    area_in_border += p.x * q.y - p.y * q.x;
  }
  return {area, area_in_border};
}

constexpr double degree = CGAL_PI / 180;

/// In degrees.
template <class Geometry>
std::array<double, 3> angles_of(const Ring_mesh<Geometry>& mesh, const Triangle& t) {
  std::array<double, 3> angles;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& p = mesh.point(t[i]);
    const Vector u = Geometry::difference(mesh.point(t[(i + 1) % 3]), p),
                 v = Geometry::difference(mesh.point(t[(i + 2) % 3]), p);
    angles[i] = std::atan2(cross(u, v), dot(u, v)) / degree;
  }
  return angles;
}

/// Degrees that angles are to keep.
struct Bounds {
  double low, high;
};

struct Angle_extremes {
  double least = 180, greatest = -180;

  void add(const std::array<double, 3>& angles) {
    least = std::min(least, *std::min_element(angles.begin(), angles.end()));
    greatest = std::max(greatest, *std::max_element(angles.begin(), angles.end()));
  }
};

/// Of all triangles; or of those for which `is_asked(triangle)`.
template <class Geometry, class Is_asked>
Angle_extremes angle_extremes(const Ring_mesh<Geometry>& mesh, const Is_asked& is_asked) {
  Angle_extremes result;
  mesh.for_each_triangle([&](Ring_vertex a, Ring_vertex b, Ring_vertex c) {
    if (is_asked(Triangle{a, b, c})) result.add(angles_of(mesh, {a, b, c}));
  });
  return result;
}
template <class Geometry>
Angle_extremes angle_extremes(const Ring_mesh<Geometry>& mesh) {
  return angle_extremes(mesh, [](const Triangle&) { return true; });
}

/// Whether nothing is asked of a triangle.
template <class Geometry>
bool are_rigid(const Ring_mesh<Geometry>& mesh, const Triangle& t) {
  return std::all_of(t.begin(), t.end(),
                     [&](Ring_vertex v) { return mesh.ring(v).mobility == Mobility::RIGID; });
}

static_assert(sizeof(Ring) == 64, "compared as bytes, so without gaps");

inline bool are_same_bits(const Ring& a, const Ring& b) { return std::memcmp(&a, &b, sizeof(Ring)) == 0; }
template <class Geometry>
bool are_same_bits(const Ring_mesh<Geometry>& a, const Ring_mesh<Geometry>& b) {
  return a.points == b.points && std::equal(a.rings.begin(), a.rings.end(), b.rings.begin(), b.rings.end(),
                                            [](const Ring& r, const Ring& s) { return are_same_bits(r, s); });
}

/// A mesh of nearly equilateral triangles with side 1 that fills a rectangle; its left and right sides cut triangles
/// in half. Vertices of the border slide, its corners are fixed.
inline Ring_mesh<Doubles> lattice(int columns, int rows) {
  Ring_mesh<Doubles> mesh;
  std::vector<Triangle> triangles;
  // even rows have columns + 1 vertices; odd ones one more, at half places but for both ends
  std::vector<Ring_vertex> first;
  for (int j = 0; j <= rows; ++j) {
    first.push_back(Ring_vertex(mesh.points.size()));
    const int n = j % 2 == 0 ? columns + 1 : columns + 2;
    for (int i = 0; i < n; ++i) {
      const double x = j % 2 == 0 ? i : std::min(std::max(i - 0.5, 0.), double(columns));
      mesh.points.push_back({x, j * std::sqrt(0.75)});
    }
  }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const auto at = [&](int row, int column) {
        return Ring_vertex(first[std::size_t(row)].value() + unsigned(column));
      };
      const bool is_up = j % 2 == 0; // the even row is below
      const int even_row = is_up ? j : j + 1, odd_row = is_up ? j + 1 : j;
      const Ring_vertex even = at(even_row, i), next_even = at(even_row, i + 1), odd = at(odd_row, i),
                        next_odd = at(odd_row, i + 1);
      triangles.push_back(is_up ? Triangle{even, next_odd, odd} : Triangle{even, odd, next_odd});
      if (i < columns)
        triangles.push_back(is_up ? Triangle{even, next_even, next_odd}
                                  : Triangle{next_even, even, next_odd});
    }
  mesh.set_triangles(triangles);
  for (const Ring_vertex v : mesh.points.ids()) {
    const bool is_on_side = mesh.points[v].x == 0 || mesh.points[v].x == columns,
               is_on_row = mesh.points[v].y == 0 || mesh.points[v].y == mesh.points.back().y;
    if (is_on_side && is_on_row)
      mesh.rings[v].mobility = Mobility::FIXED;
    else if (is_on_side)
      mesh.rings[v].mobility = Mobility::SLIDES_ACROSS;
    else if (is_on_row)
      mesh.rings[v].mobility = Mobility::SLIDES_ALONG;
  }
  return mesh;
}

/// Tiles that fill equal squares with side 1, 4^level in all, with angles in [43.4, 72.7] degrees. Vertices of the
/// border slide, its corners are fixed.
inline Ring_mesh<Doubles> equal_tiles(int level) {
  internal::Tile_sites sites;
  const int log_side = internal::tile_log_side(level);
  for (std::uint64_t i = 0; i < std::uint64_t(1) << level; ++i)
    for (std::uint64_t j = 0; j < std::uint64_t(1) << level; ++j)
      sites.places.push_back({(4 * i + 1) << (log_side - 2), (4 * j + 1) << (log_side - 2)});
  sites.levels.assign(sites.size(), level);
  const internal::Tile_mesh tiles = internal::fill_tiles(sites).mesh;
  Ring_mesh<Doubles> mesh;
  for (const auto& p : tiles.places)
    mesh.points.push_back({std::ldexp(double(p.x), -log_side), std::ldexp(double(p.y), -log_side)});
  mesh.set_triangles(tiles.triangles);
  for (const Ring_vertex v : mesh.points.ids()) {
    const auto sides = tiles.sides[v.value()];
    const bool is_on_side = (sides & (internal::left_side | internal::right_side)) != 0,
               is_on_row = (sides & (internal::bottom_side | internal::top_side)) != 0;
    mesh.rings[v].mobility = is_on_side && is_on_row ? Mobility::FIXED
                             : is_on_side            ? Mobility::SLIDES_ACROSS
                             : is_on_row             ? Mobility::SLIDES_ALONG
                                                     : Mobility::FREE;
  }
  return mesh;
}

/// Appends vertices that are not in use, for insertions.
template <class Geometry>
std::vector<Ring_vertex> append_spare(Ring_mesh<Geometry>& mesh, std::size_t n) {
  std::vector<Ring_vertex> spare;
  Ring unused{};
  unused.mobility = Mobility::REMOVED;
  for (; n > 0; --n) {
    spare.push_back(Ring_vertex(mesh.points.size()));
    mesh.points.emplace_back();
    mesh.rings.push_back(unused);
  }
  return spare;
}

} // namespace ring_test

#endif // QUADTREE_MESH_2_TEST_RING_MESH_CHECKS_H
