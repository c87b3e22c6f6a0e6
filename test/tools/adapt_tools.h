// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What must hold for every mesh made of another one.

#ifndef QUADTREE_MESH_2_TEST_ADAPT_TOOLS_H
#define QUADTREE_MESH_2_TEST_ADAPT_TOOLS_H

#include "catch.h"
#include "pslg_test_tools.h"

#include <CGAL/Adapted_mesh_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/renumber_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

namespace adapt_test {

using pslg_test::Point;
using pslg_test::Pslg;
using pslg_test::Vertex_index;
using Mesh = CGAL::Indexed_mesh_2<Point>;
using Options = CGAL::Quality_mesh_options_2;
using CGAL::Quadtree_mesh_2::Triangle_index;

inline Mesh fresh_mesh(const Pslg& pslg, const Options& options) {
  return CGAL::Quality_mesher_2<>(options)(pslg);
}

inline bool have_same_bits(const Point& p, const Point& q) {
  const double a[] = {p.x(), p.y()}, b[] = {q.x(), q.y()};
  return std::memcmp(a, b, sizeof a) == 0;
}

inline bool have_same_bits(const Mesh& a, const Mesh& b) {
  return a.triangles == b.triangles &&
         std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                    [](const Point& p, const Point& q) { return have_same_bits(p, q); });
}

inline CGAL::Mesh_quality_2 quality(Mesh mesh, const Pslg& pslg,
                                    CGAL::Mesh_quality_options_2 options = CGAL::Mesh_quality_options_2()) {
  CGAL::renumber_by_input(mesh);
  return CGAL::mesh_quality_2(mesh, pslg, options);
}

inline void check_valid(const Mesh& mesh, const Pslg& pslg,
                        CGAL::Mesh_quality_options_2 options = CGAL::Mesh_quality_options_2()) {
  const auto result = quality(mesh, pslg, options);
  for (const std::string& error : result.errors) UNSCOPED_INFO(error);
  CHECK(result.is_valid());
}

/// Vertices that stay have their bits and their order, and come first; the others are in the triangles named.
inline void check_transfer(const CGAL::Adapted_mesh_2& made, const Mesh& old) {
  const auto& transfer = made.transfer;
  REQUIRE(transfer.old_vertex.size() == made.mesh.points.size());
  REQUIRE(transfer.places.size() == made.mesh.points.size());
  const auto first_new = std::find(transfer.old_vertex.begin(), transfer.old_vertex.end(), Vertex_index());
  CHECK(std::all_of(first_new, transfer.old_vertex.end(), [](Vertex_index v) { return !v.is_valid(); }));
  CHECK(std::is_sorted(transfer.old_vertex.begin(), first_new));
  CHECK(std::adjacent_find(transfer.old_vertex.begin(), first_new) == first_new);
  std::size_t moved = 0, misplaced = 0;
  for (std::size_t v = 0; v < made.mesh.points.size(); ++v) {
    const auto& [triangle, weights] = transfer.places[v];
    const Vertex_index before = transfer.old_vertex[v];
    if (before.is_valid() && !have_same_bits(old.point(before), made.mesh.points[v])) ++moved;
    if (!triangle.is_valid()) {
      if (!before.is_valid()) ++misplaced;
      continue;
    }
    const auto& corners = old.triangles[std::size_t(triangle)];
    double x = 0, y = 0, sum = 0, reach = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = old.point(corners[k]);
      x += weights[k] * p.x(), y += weights[k] * p.y(), sum += weights[k];
      reach = std::max({reach, std::abs(p.x()), std::abs(p.y())});
      if (weights[k] < 0 || (before.is_valid() && weights[k] != (corners[k] == before ? 1 : 0))) ++misplaced;
    }
    const Point& p = made.mesh.points[v];
    if (std::hypot(x - p.x(), y - p.y()) > 1e-12 * reach || std::abs(sum - 1) > 1e-14) ++misplaced;
  }
  CHECK(moved == 0);
  CHECK(misplaced == 0);
}

inline double area(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  return CGAL::area(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
}

inline double longest_edge(const Mesh& mesh, std::size_t t) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &a = mesh.point(mesh.triangles[t][k]), &b = mesh.point(mesh.triangles[t][(k + 1) % 3]);
    longest = std::max(longest, std::hypot(a.x() - b.x(), a.y() - b.y()));
  }
  return longest;
}

inline Point centroid(const Mesh& mesh, std::size_t t) {
  double x = 0, y = 0;
  for (const auto v : mesh.triangles[t]) x += mesh.point(v).x() / 3, y += mesh.point(v).y() / 3;
  return Point(x, y);
}

/// A square with a square hole.
inline Pslg frame() {
  Pslg pslg = pslg_test::make_pslg<double>({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {3, 3}, {1, 3}},
                                           {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}});
  pslg.holes.push_back(Point(2, 2));
  return pslg;
}

} // namespace adapt_test

#endif // QUADTREE_MESH_2_TEST_ADAPT_TOOLS_H
