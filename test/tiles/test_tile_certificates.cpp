// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What is proven here, in exact arithmetic:
// - for every point p of a closed square in the middle of 3 x 3 plain tiles, each vertex v of the middle tile that
//   is nearest to p is at most 0.281 sides away, and the warp of v with d = p - v leaves a triangulation of the
//   block with all angles between 37.5 and 78.6 degrees;
// - for every p within half a side of a corner of 4 x 4 plain tiles, in either coordinate, the warp of the star
//   leaves a triangulation of the block with all angles between 18.3 and 87.5 degrees, and translates the spokes.
// "Every" is meant: points are not sampled.
//
// How: coordinates of warped vertices are affine in d. An angle with product `dot` and area `cross` of its
// two edges is in the range if C cross > dot > c cross for certain rational numbers C and c, which lie on the
// safe side of the cotangents of the bounds. These are quadratic polynomials in d with integer coefficients;
// such a polynomial is positive in a box if its nine coefficients in Bernstein form are. The square is
// divided into boxes until they are, for each vertex that is nearest to some point of the box; a vertex is
// left out only if another one is nearer to all four corners, and so to all points, of the box. Both
// inequalities together say that the triangle is counterclockwise, and as the boundary of the block stays
// where it is, the triangles cover the block without overlap.

#include "catch.h"
#include "integer_mesh.h"
#include "moving_triangles.h"

#include <CGAL/Quadtree_mesh_2/internal/tables/star_table.h>
#include <CGAL/Quadtree_mesh_2/internal/tables/tile_tables.h>
#include <CGAL/Quadtree_mesh_2/internal/tables/warp_table.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

namespace test_tile_certificates {

namespace {

using CGAL::Quadtree_mesh_2::internal::star;
using CGAL::Quadtree_mesh_2::internal::Tile;
using CGAL::Quadtree_mesh_2::internal::tile;
using CGAL::Quadtree_mesh_2::internal::warp;
using CGAL::Quadtree_mesh_2::internal::Warped_vertex;

constexpr std::int64_t units = Tile::units;
/// Boxes have corners at multiples of 1/`grid` of a side.
constexpr std::int64_t fine = 64, grid = fine * units;

using Box = Parameter_box;

/// In units of 1/(`grid` `units`), for d in units of 1/`grid` of a side.
Moving_point unmoved(const Integer_point& p) {
  return {Affine{grid * p[0], 0, 0}, Affine{grid * p[1], 0, 0}};
}
Moving_point moving(const Warped_vertex& v) {
  return {Affine{grid * (v.base_x + v.offset_x), v.xx, v.xy},
          Affine{grid * (v.base_y + v.offset_y), v.yx, v.yy}};
}

/// Squares of plain tiles, whose lower left one is at (first, first), in a row of `n`, in n rows.
Integer_mesh block_of_tiles(std::int64_t first, std::int64_t n) {
  const Tile& t = tile(0);
  Integer_mesh mesh;
  for (std::int64_t i = first; i < first + n; ++i)
    for (std::int64_t j = first; j < first + n; ++j) {
      const int before = static_cast<int>(mesh.points.size());
      for (std::size_t k = 0; k < static_cast<std::size_t>(t.number_of_vertices); ++k)
        mesh.points.push_back({units * i + t.vertices[k][0], units * j + t.vertices[k][1]});
      for (std::size_t k = 0; k < static_cast<std::size_t>(t.number_of_triangles); ++k) {
        const auto& v = t.triangles[k];
        mesh.triangles.push_back({before + v[0], before + v[1], before + v[2]});
      }
    }
  return merge_equal_points(mesh);
}

bool is_within(const Integer_point& p, std::int64_t low, std::int64_t high) {
  return p[0] > low && p[0] < high && p[1] > low && p[1] < high;
}

/// The triangles of the block that move. Checks that the table has each vertex within the block once, and no
/// other.
template <class Table>
std::vector<Moving_triangle> moving_triangles(const Table& table, std::int64_t first, std::int64_t n) {
  const Integer_mesh mesh = block_of_tiles(first, n);
  std::map<Integer_point, Moving_point> where;
  for (const Integer_point& p : mesh.points)
    if (!is_within(p, units * first, units * (first + n))) where[p] = unmoved(p);
  const std::size_t on_boundary = where.size();
  REQUIRE(on_boundary == static_cast<std::size_t>(8 * n)); // corners and middles of sides
  for (const Warped_vertex& v : table) where[{v.base_x, v.base_y}] = moving(v);
  REQUIRE(where.size() == on_boundary + table.size());
  REQUIRE(where.size() == mesh.points.size());
  for (const Integer_point& p : mesh.points) REQUIRE(where.count(p) == 1);

  std::vector<Moving_triangle> triangles;
  for (const auto& t : mesh.triangles)
    triangles.push_back({where[mesh.point(t[0])], where[mesh.point(t[1])], where[mesh.point(t[2])]});
  return triangles;
}

/// Those of the triangles for which nothing is certain in this box of d.
std::vector<Moving_triangle> uncertain(const Cotangent_range& range,
                                       const std::vector<Moving_triangle>& triangles, const Box& d) {
  std::vector<Moving_triangle> result;
  for (const Moving_triangle& t : triangles)
    if (!has_angles_within(range, t, d)) result.push_back(t);
  return result;
}

struct Candidate {
  Integer_point vertex;
  std::vector<Moving_triangle> triangles;
};

std::int64_t squared_distance(const Integer_point& p, const Integer_point& q) { return dot(p, q, q); }

/// Whether some other candidate is nearer to all points of the box, as it is if it is nearer to the corners: the
/// difference of the squared distances is affine.
bool is_never_nearest(const Integer_point& v, const std::vector<Candidate>& candidates, const Box& box) {
  const auto corners = box.corners();
  return std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& other) {
    return std::all_of(corners.begin(), corners.end(), [&](const Integer_point& p) {
      return squared_distance(p, other.vertex) < squared_distance(p, v);
    });
  });
}

/// Whether for each p in the box and each vertex nearest to it, the angles of the triangles of that vertex are in
/// the range. `all` are all vertices, `left` those that can be nearest, with the triangles not certain yet.
bool is_certain(const Cotangent_range& range, const std::vector<Candidate>& all,
                const std::vector<Candidate>& left, const Box& box) {
  std::vector<Candidate> still_left;
  for (const Candidate& c : left) {
    if (is_never_nearest(c.vertex, all, box)) continue;
    const Box d{box.x - c.vertex[0], box.y - c.vertex[1], box.side};
    std::vector<Moving_triangle> triangles = uncertain(range, c.triangles, d);
    if (!triangles.empty()) still_left.push_back({c.vertex, std::move(triangles)});
  }
  if (still_left.empty()) return true;
  if (box.side == 1) return false;
  const auto quarters = box.quarters();
  return std::all_of(quarters.begin(), quarters.end(),
                     [&](const Box& quarter) { return is_certain(range, all, still_left, quarter); });
}

std::vector<Candidate> vertices_of_plain_tile() {
  std::vector<Candidate> candidates;
  for (int i = 0; i < tile(0).number_of_vertices; ++i) {
    const auto& v = tile(0).vertices[static_cast<std::size_t>(i)];
    candidates.push_back({{fine * v[0], fine * v[1]}, moving_triangles(warp(i).vertices, -1, 3)});
  }
  return candidates;
}

bool is_certain_for_warps(const Cotangent_range& range) {
  const std::vector<Candidate> candidates = vertices_of_plain_tile();
  return is_certain(range, candidates, candidates, Box{0, 0, grid});
}

bool is_certain_for_star(const Cotangent_range& range) {
  const std::vector<Candidate> candidates{{{0, 0}, moving_triangles(star().vertices, -2, 4)}};
  return is_certain(range, candidates, candidates, Box{-grid / 2, -grid / 2, grid});
}

/// Whether each point of the box is at most 0.281 sides from some vertex.
bool is_near_to_all_points(const std::vector<Candidate>& candidates, const Box& box) {
  const auto corners = box.corners();
  const auto is_near_to_box = [&](const Candidate& c) {
    return std::all_of(corners.begin(), corners.end(), [&](const Integer_point& p) {
      return 1000000 * squared_distance(p, c.vertex) <= 281 * 281 * grid * grid;
    });
  };
  if (std::any_of(candidates.begin(), candidates.end(), is_near_to_box)) return true;
  if (box.side == 1) return false;
  const auto quarters = box.quarters();
  return std::all_of(quarters.begin(), quarters.end(),
                     [&](const Box& quarter) { return is_near_to_all_points(candidates, quarter); });
}

bool is_translated(const Warped_vertex& v) {
  return v.offset_x == 0 && v.offset_y == 0 && v.xx == units && v.xy == 0 && v.yx == 0 && v.yy == units;
}

/// How the table moves the vertex at p.
template <class Table>
const Warped_vertex& find(const Table& table, const Integer_point& p) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Warped_vertex& v) {
    return v.base_x == p[0] && v.base_y == p[1];
  });
  REQUIRE(found != table.end());
  return *found;
}

} // namespace

TEST_CASE("Warps take their vertex to the point", "[tiles]") {
  for (int i = 0; i < tile(0).number_of_vertices; ++i) {
    CAPTURE(i);
    const auto& v = tile(0).vertices[static_cast<std::size_t>(i)];
    CHECK(warp(i).center == i);
    CHECK(is_translated(find(warp(i).vertices, {v[0], v[1]})));
  }
}

TEST_CASE("The star translates the corner and its eight neighbors", "[tiles]") {
  CHECK(is_translated(find(star().vertices, {0, 0})));
  const Integer_mesh block = block_of_tiles(-2, 4);
  std::vector<Integer_point> neighbors, spokes;
  for (const auto& t : block.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (block.point(t[i]) == Integer_point{0, 0}) neighbors.push_back(block.point(t[(i + 1) % 3]));
  // In the compass directions.
  const int directions[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  for (std::size_t i = 0; i < 8; ++i) {
    const auto& s = star().spokes[i];
    const std::int64_t length = std::max(std::abs(s[0]), std::abs(s[1]));
    CHECK((s[0] == length * directions[i][0] && s[1] == length * directions[i][1]));
    CHECK(is_translated(find(star().vertices, {s[0], s[1]})));
    spokes.push_back({s[0], s[1]});
  }
  CHECK(std::is_permutation(spokes.begin(), spokes.end(), neighbors.begin(), neighbors.end()));
}

TEST_CASE("Some vertex of the plain tile is near to each point", "[tiles]") {
  CHECK(is_near_to_all_points(vertices_of_plain_tile(), Box{0, 0, grid}));
}

TEST_CASE("Warped blocks have angles between 37.5 and 78.6 degrees for every point", "[tiles]") {
  CHECK(is_certain_for_warps(Cotangent_range(37.5, 78.6)));
}

TEST_CASE("Stars have angles between 18.3 and 87.5 degrees for every point", "[tiles]") {
  CHECK(is_certain_for_star(Cotangent_range(18.3, 87.5)));
}

TEST_CASE("Certificates fail where some angle is outside the range", "[tiles]") {
  CHECK_FALSE(is_certain_for_warps(Cotangent_range(37.6, 80)));
  CHECK_FALSE(is_certain_for_warps(Cotangent_range(36, 78.5)));
  CHECK_FALSE(is_certain_for_star(Cotangent_range(18.5, 89)));
  CHECK_FALSE(is_certain_for_star(Cotangent_range(18, 87.3)));
}

} // namespace test_tile_certificates
