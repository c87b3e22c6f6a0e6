// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What is proven here, in exact arithmetic:
// - each of the sixteen tiles is a triangulation of the square with angles in the stated range, and tiles are
//   images of each other in the symmetries of the square if their bits are (the plain tile in half of them);
// - the vertices within a side depend on the bits at its ends only, as stated, and therefore tiles of leaves that
//   are balanced over corners fit together (and they do in random quadtrees);
// - the collar is an acute triangulation of the octagon without the window, and the window's border is LL
//   (and in random quadtrees whose squares are split in the middle cell it is that of the tiles, too);
// - the ring of 16 triangles between the octagon and the spokes is acute for every 0 < rho <= 1/5.
// The ranges of angles of warped blocks are proven in test_tile_certificates.cpp.

#include "catch.h"
#include "integer_mesh.h"

#include <CGAL/Quadtree_mesh_2/internal/tables/collar_table.h>
#include <CGAL/Quadtree_mesh_2/internal/tables/star_table.h>
#include <CGAL/Quadtree_mesh_2/internal/tables/tile_tables.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_tile_tables {

namespace {

using CGAL::Quadtree_mesh_2::internal::Collar;
using CGAL::Quadtree_mesh_2::internal::collar;
using CGAL::Quadtree_mesh_2::internal::Octagon;
using CGAL::Quadtree_mesh_2::internal::star;
using CGAL::Quadtree_mesh_2::internal::Tile;
using CGAL::Quadtree_mesh_2::internal::tile;

using Rational = boost::multiprecision::cpp_rational;

Integer_mesh mesh_of(const Tile& t) {
  return Integer_mesh::of(t.vertices, t.number_of_vertices, t.triangles, t.number_of_triangles);
}

/// The directed edges of the polygon of vertices first, .., first + n - 1, sorted.
std::vector<Integer_edge> polygon(int first, int n) {
  std::vector<Integer_edge> edges;
  for (int i = 0; i < n; ++i) edges.emplace_back(first + i, first + (i + 1) % n);
  return edges;
}

/// The point at distance `along` from corner `side` on the side of the square that starts there.
Integer_point on_side(unsigned side, std::int64_t along) {
  switch (side) {
  case 0:
    return {along, 0};
  case 1:
    return {Tile::units, along};
  case 2:
    return {Tile::units - along, Tile::units};
  default:
    return {0, Tile::units - along};
  }
}

/// Where the vertices within a side are, by the bits at its start and its end.
std::vector<std::int64_t> side_pattern(bool is_small_at_start, bool is_small_at_end) {
  if (is_small_at_start && is_small_at_end) return {256, 512, 768};
  if (is_small_at_start) return {17 * 16, 9 * 64};
  if (is_small_at_end) return {7 * 64, 47 * 16};
  return {512};
}

bool bit(unsigned bits, unsigned i) { return (bits >> i % 4 & 1u) != 0; }

/// The eight symmetries of the square, of points and of bits, without the tables' own code.
Integer_point after_symmetry(unsigned symmetry, Integer_point p) {
  if (symmetry & 1u) p[0] = Tile::units - p[0];
  if (symmetry & 2u) p[1] = Tile::units - p[1];
  if (symmetry & 4u) std::swap(p[0], p[1]);
  return p;
}

unsigned bits_after_symmetry(unsigned symmetry, unsigned bits) {
  unsigned result = 0;
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned j = 0; j < 4; ++j)
      if (bit(bits, i) && after_symmetry(symmetry, on_side(i, 0)) == on_side(j, 0)) result |= 1u << j;
  return result;
}

using Triangle_points = std::array<Integer_point, 3>;

/// Triangles as sets of points, without orientation.
std::set<Triangle_points> triangles_after_symmetry(unsigned symmetry, const Integer_mesh& mesh) {
  std::set<Triangle_points> result;
  for (const auto& t : mesh.triangles) {
    Triangle_points points{};
    for (std::size_t i = 0; i < 3; ++i) points[i] = after_symmetry(symmetry, mesh.point(t[i]));
    std::sort(points.begin(), points.end());
    result.insert(points);
  }
  return result;
}

} // namespace

TEST_CASE("Tiles are triangulations of the square", "[tiles]") {
  for (unsigned bits = 0; bits < 16; ++bits) {
    CAPTURE(bits);
    const Tile& t = tile(bits);
    const Integer_mesh mesh = mesh_of(t);
    CHECK(doubled_area(mesh) == 2 * Tile::units * Tile::units);
    CHECK(is_triangulation_within(mesh, polygon(0, t.number_of_boundary_vertices)));
    CHECK(t.number_of_triangles == 2 * t.number_of_vertices - t.number_of_boundary_vertices - 2);
    for (int i = t.number_of_boundary_vertices; i < t.number_of_vertices; ++i)
      for (const std::int64_t x : mesh.point(i)) CHECK((x > 0 && x < Tile::units));
  }
}

TEST_CASE("Vertices in the sides of tiles depend on the bits at the ends", "[tiles]") {
  for (unsigned bits = 0; bits < 16; ++bits) {
    CAPTURE(bits);
    const Integer_mesh mesh = mesh_of(tile(bits));
    std::vector<Integer_point> expected;
    for (unsigned side = 0; side < 4; ++side) {
      expected.push_back(on_side(side, 0));
      for (const std::int64_t x : side_pattern(bit(bits, side), bit(bits, side + 1)))
        expected.push_back(on_side(side, x));
    }
    REQUIRE(tile(bits).number_of_boundary_vertices == static_cast<int>(expected.size()));
    CHECK(std::equal(expected.begin(), expected.end(), mesh.points.begin()));
  }
}

TEST_CASE("Side patterns fit together", "[tiles]") {
  for (const bool start : {false, true})
    for (const bool end : {false, true}) {
      // The same from the other end.
      std::vector<std::int64_t> reversed = side_pattern(end, start);
      std::reverse(reversed.begin(), reversed.end());
      for (std::int64_t& x : reversed) x = Tile::units - x;
      CHECK(reversed == side_pattern(start, end));
    }
  const std::int64_t half = side_pattern(false, false)[0];
  CHECK(side_pattern(true, true) == std::vector<std::int64_t>{half / 2, 512, 512 + half / 2});
}

TEST_CASE("Tiles are acute, with angles in the stated ranges", "[tiles]") {
  for (unsigned bits = 0; bits < 16; ++bits) {
    CAPTURE(bits);
    CHECK(is_strictly_acute(mesh_of(tile(bits))));
    CHECK(has_angles_within(mesh_of(tile(bits)), Cotangent_range(43.44, 72.66)));
  }
  const auto is_within = [](unsigned bits, double least, double greatest) {
    return has_angles_within(mesh_of(tile(bits)), Cotangent_range(least, greatest));
  };
  CHECK(is_within(0, 44.999, 72.134));
  CHECK(is_within(1, 43.442, 72.641));
  CHECK(is_within(3, 43.505, 72.652));
  CHECK(is_within(5, 44.454, 72.073));
  CHECK(is_within(11, 43.539, 72.573));
  CHECK(is_within(15, 44.050, 72.223));
  CHECK_FALSE(is_within(1, 43.45, 72.65));
  CHECK_FALSE(is_within(1, 43.44, 72.63));
}

TEST_CASE("Tiles are images of each other in the symmetries of the square", "[tiles]") {
  for (unsigned bits = 0; bits < 16; ++bits)
    for (unsigned symmetry = 0; symmetry < 8; ++symmetry) {
      CAPTURE(bits, symmetry);
      // The plain tile has half the symmetry of its bits: none that takes one diagonal to the other.
      const bool keeps_diagonals = bits_after_symmetry(symmetry, 5) == 5;
      if (bits == 0 && !keeps_diagonals) continue;
      CHECK(triangles_after_symmetry(symmetry, mesh_of(tile(bits))) ==
            triangles_after_symmetry(0, mesh_of(tile(bits_after_symmetry(symmetry, bits)))));
    }
}

namespace {

/// A quadtree over 128 x 128 units that is balanced over corners, in the simplest way: for each level, from the
/// root, which squares are there.
class Small_quadtree {
public:
  static constexpr int levels = 8;

  Small_quadtree() { exists_[0] = {true}; }

  /// Splits the squares of level `level` - 1 around, so that (i, j) is there.
  void require(int level, int i, int j) {
    if (i < 0 || j < 0 || i >= 1 << level || j >= 1 << level || exists(level, i, j)) return;
    // The parent is split: its eight neighbors must be there.
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y) require(level - 1, i / 2 + x, j / 2 + y);
    for (int x = 0; x < 2; ++x)
      for (int y = 0; y < 2; ++y)
        exists_[level_index(level)][index(level, i / 2 * 2 + x, j / 2 * 2 + y)] = true;
  }

  bool exists(int level, int i, int j) const {
    return level < levels && i >= 0 && j >= 0 && i < 1 << level && j < 1 << level &&
           exists_[level_index(level)][index(level, i, j)];
  }
  bool is_leaf(int level, int i, int j) const {
    return exists(level, i, j) && !exists(level + 1, 2 * i, 2 * j);
  }

  /// Whether a leaf smaller than this one touches its corner.
  unsigned corner_bits(int level, int i, int j) const {
    unsigned bits = 0;
    for (unsigned corner = 0; corner < 4; ++corner) {
      const int x = 2 * (i + (corner == 1 || corner == 2)), y = 2 * (j + (corner >= 2));
      for (int k = 0; k < 4; ++k)
        if (exists(level + 1, x - k % 2, y - k / 2)) bits |= 1u << corner;
    }
    return bits;
  }

private:
  static std::size_t level_index(int level) { return static_cast<std::size_t>(level); }
  static std::size_t index(int level, int i, int j) { return static_cast<std::size_t>((i << level) + j); }

  std::array<std::array<bool, 1 << 2 * (levels - 1)>, levels> exists_{};
};

Integer_mesh mesh_of(const Small_quadtree& tree, std::set<unsigned>& bits_seen) {
  Integer_mesh mesh;
  for (int level = 0; level < Small_quadtree::levels; ++level)
    for (int i = 0; i < 1 << level; ++i)
      for (int j = 0; j < 1 << level; ++j) {
        if (!tree.is_leaf(level, i, j)) continue;
        const unsigned bits = tree.corner_bits(level, i, j);
        bits_seen.insert(bits);
        const Integer_mesh t = mesh_of(tile(bits));
        const int first = static_cast<int>(mesh.points.size());
        const std::int64_t side = std::int64_t(1) << (Small_quadtree::levels - 1 - level);
        for (const Integer_point& p : t.points)
          mesh.points.push_back({side * (Tile::units * i + p[0]), side * (Tile::units * j + p[1])});
        for (const auto& v : t.triangles)
          mesh.triangles.push_back({first + v[0], first + v[1], first + v[2]});
      }
  return merge_equal_points(mesh);
}

} // namespace

TEST_CASE("Tiles of random quadtrees fit together", "[tiles]") {
  std::mt19937 random(1);
  std::set<unsigned> bits_seen;
  for (int round = 0; round < 60; ++round) {
    Small_quadtree tree;
    for (int i = 0; i < 1 + round % 12; ++i) {
      const int level = 2 + static_cast<int>(random() % 4);
      const auto coordinate = [&] { return static_cast<int>(random() % (1u << level)); };
      const int x = coordinate();
      tree.require(level, x, coordinate());
    }
    const Integer_mesh mesh = mesh_of(tree, bits_seen);
    CAPTURE(round);
    CHECK(is_strictly_acute(mesh));
    CHECK_FALSE(has_repeated_sides_or_unused_points(mesh));
    const std::int64_t side = Tile::units << (Small_quadtree::levels - 1);
    CHECK(doubled_area(mesh) == 2 * side * side);
    for (const Integer_edge& e : unmatched_edges(mesh)) {
      const Integer_point &p = mesh.point(e.first), &q = mesh.point(e.second);
      const bool is_on_boundary =
          (p[0] == q[0] && (p[0] == 0 || p[0] == side)) || (p[1] == q[1] && (p[1] == 0 || p[1] == side));
      CHECK(is_on_boundary);
    }
  }
  CHECK(bits_seen.size() == 16);
}

TEST_CASE("The border of the window is LL if squares are split in the middle cell only", "[tiles]") {
  std::mt19937 random(2);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    Small_quadtree tree;
    const int cells = 3; // their level
    for (int i = 0; i < 1 << cells; ++i)
      for (int j = 0; j < 1 << cells; ++j) tree.require(cells, i, j);
    // The window is [2, 7) x [2, 7); all of the middle cell is fine in the first rounds, else some of it.
    for (int level = cells + 1; level < Small_quadtree::levels; ++level) {
      const int n = 1 << (level - cells);
      for (int i = 0; i < n * n; ++i)
        if (round < Small_quadtree::levels - cells ? level <= cells + round : random() % 8 == 0)
          tree.require(level, 4 * n + i % n, 4 * n + i / n);
    }
    for (int i = 2; i < 7; ++i)
      for (int j = 2; j < 7; ++j) {
        if (std::max(std::abs(i - 4), std::abs(j - 4)) < 2) continue;
        CHECK(tree.is_leaf(cells, i, j));
        for (unsigned corner = 0; corner < 4; ++corner) {
          const int x = i + (corner == 1 || corner == 2), y = j + (corner >= 2);
          if (x == 2 || x == 7 || y == 2 || y == 7) CHECK_FALSE(bit(tree.corner_bits(cells, i, j), corner));
        }
      }
  }
}

TEST_CASE("The collar is an acute triangulation between the octagon and the window", "[tiles]") {
  const Collar& c = collar();
  const Integer_mesh mesh =
      Integer_mesh::of(c.vertices, Collar::number_of_vertices, c.triangles, Collar::number_of_triangles);
  const std::int64_t r = Collar::octagon_radius, h = Collar::octagon_half_side;
  const std::vector<Integer_point> octagon{{r, -h}, {r, h},   {h, r},   {-h, r},
                                           {-r, h}, {-r, -h}, {-h, -r}, {h, -r}};
  CHECK(std::equal(octagon.begin(), octagon.end(), mesh.points.begin()));
  CHECK(static_cast<double>(r) == Octagon::radius_in_cells * Collar::units);
  CHECK(static_cast<double>(h) == Octagon::t * static_cast<double>(r));

  // The window's border is LL.
  const std::int64_t side = Collar::cells_per_side * Collar::units, half = side / 2;
  const Integer_point corners[] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  const Integer_point steps[] = {{512, 0}, {0, 512}, {-512, 0}, {0, -512}};
  for (int i = 0; i < Collar::number_of_window_vertices; ++i) {
    const Integer_point &corner = corners[i / 10], &step = steps[i / 10];
    CHECK(mesh.point(8 + i) == Integer_point{corner[0] + i % 10 * step[0], corner[1] + i % 10 * step[1]});
  }

  std::vector<Integer_edge> boundary = polygon(0, Collar::number_of_octagon_vertices);
  for (const Integer_edge& e : polygon(8, Collar::number_of_window_vertices))
    boundary.emplace_back(e.second, e.first);
  std::sort(boundary.begin(), boundary.end());
  CHECK(is_triangulation_within(mesh, boundary));
  // The square around the octagon without its four corners, and without the window.
  CHECK(doubled_area(mesh) == 2 * (4 * r * r - 2 * (r - h) * (r - h) - side * side));
  CHECK(is_strictly_acute(mesh));
  CHECK(has_angles_within(mesh, Cotangent_range(17.36, 81.39)));
}

namespace {

/// c[0] + c[1] rho + c[2] rho^2
using Polynomial = std::array<Rational, 3>;

/// a + b rho
struct Affine {
  Rational a, b;
  friend Affine operator-(const Affine& l, const Affine& r) { return {l.a - r.a, l.b - r.b}; }
};

void add_product(Polynomial& sum, const Affine& l, const Affine& r) {
  sum[0] += l.a * r.a;
  sum[1] += l.a * r.b + l.b * r.a;
  sum[2] += l.b * r.b;
}

using Moving_point = std::array<Affine, 2>;

/// The product of two edges at p.
Polynomial dot(const Moving_point& p, const Moving_point& q, const Moving_point& r) {
  Polynomial sum{};
  for (std::size_t i = 0; i < 2; ++i) add_product(sum, q[i] - p[i], r[i] - p[i]);
  return sum;
}

Polynomial cross(const Moving_point& p, const Moving_point& q, const Moving_point& r) {
  Polynomial sum{};
  add_product(sum, q[0] - p[0], r[1] - p[1]);
  add_product(sum, q[1] - p[1], p[0] - r[0]);
  return sum;
}

/// Whether the polynomial is positive for 0 < rho <= top, by its coefficients in Bernstein form. The greatest
/// power of rho that divides it is taken out first.
bool is_positive_up_to(Polynomial p, const Rational& top) {
  if (p == Polynomial{}) return false;
  while (p[0] == 0) p = {p[1], p[2], Rational(0)};
  const Rational middle = p[0] + p[1] * top / 2, last = p[0] + p[1] * top + p[2] * top * top;
  return p[0] > 0 && middle >= 0 && last > 0;
}

Rational value(const Polynomial& p, const Rational& rho) { return p[0] + rho * (p[1] + rho * p[2]); }

/// The triangles between octagon and spokes, in sides of a leaf.
std::vector<std::array<Moving_point, 3>> ring() {
  const Rational t(Collar::octagon_half_side, Collar::octagon_radius);
  const Rational unit[8][2] = {{1, -t}, {1, t}, {t, 1}, {-t, 1}, {-1, t}, {-1, -t}, {-t, -1}, {t, -1}};
  const auto octagon = [&](std::size_t i) {
    return Moving_point{Affine{0, unit[i % 8][0]}, Affine{0, unit[i % 8][1]}};
  };
  const auto spoke = [](std::size_t i) {
    const auto& s = star().spokes[i % 8];
    return Moving_point{Affine{Rational(s[0], Tile::units), 0}, Affine{Rational(s[1], Tile::units), 0}};
  };
  std::vector<std::array<Moving_point, 3>> triangles;
  for (std::size_t i = 0; i < 8; ++i) {
    triangles.push_back({octagon(i), spoke(i), octagon(i + 1)});
    triangles.push_back({octagon(i + 1), spoke(i), spoke(i + 1)});
  }
  return triangles;
}

} // namespace

TEST_CASE("The ring between octagon and spokes is acute for every size of the octagon", "[tiles]") {
  const Rational top(1, 5);
  CHECK(static_cast<double>(top) == Octagon::max_radius_in_leaf_sides);
  std::vector<Rational> samples{top, Rational(1, 8)};
  for (int level = 4; level <= 40; ++level) samples.push_back(Rational(1, std::int64_t(1) << level));
  for (int level = 6; level <= 40; ++level) samples.push_back(Rational(173, std::int64_t(16) << level));
  for (const auto& t : ring())
    for (std::size_t i = 0; i < 3; ++i) {
      const Polynomial d = dot(t[i], t[(i + 1) % 3], t[(i + 2) % 3]);
      const Polynomial c = cross(t[i], t[(i + 1) % 3], t[(i + 2) % 3]);
      CHECK(is_positive_up_to(d, top));
      CHECK(is_positive_up_to(c, top));
      for (const Rational& rho : samples) CHECK((value(d, rho) > 0 && value(c, rho) > 0));
    }
}

} // namespace test_tile_tables
