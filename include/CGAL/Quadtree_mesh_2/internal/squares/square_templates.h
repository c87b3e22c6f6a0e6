// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// How a square of a balanced quadtree is cut into triangles if some of its sides have a vertex in the middle.
//
// Without a center, vertices are corners of squares only. Each triangle is half of a square, or half of a
// rectangle of two to one, or joins vertices in the middle of sides to corners across. The least angle is
// atan(1/2), 26.56 degrees, or 45 if no side is halved. With a center, all pieces of the border are joined to
// it. The least angle is then 45 degrees, and the longest edge is shorter by a factor of sqrt(2). No angle is
// above 90 degrees.
//
// All triangles are Delaunay, also across the sides of squares. Their circles leave the square by less than a
// quarter of the side, or are centered on a side and hold only its ends.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_SQUARE_TEMPLATES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_SQUARE_TEMPLATES_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Counterclockwise: vertex i is the corner from which side i starts, the lower left one first, vertex 4 + i
/// the middle of side i, and vertex 8 the center. Sides are the lower, the right, the upper and the left one.
/// Side i consists of piece 2 i, and of piece 2 i + 1 if it is halved.
struct Square_template {
  static constexpr int number_of_vertices = 9, center = 8;
  static constexpr int number_of_pieces = 8;
  static constexpr int max_size = 8;
  struct Corner {
    int triangle = 0, slot = 0;
  };

  int size = 0;
  std::array<std::array<int, 3>, max_size> triangle{};
  /// What is across each side: a side of another triangle of the template, or else a piece of the square.
  std::array<std::array<Corner, 3>, max_size> across{};
  std::array<std::array<int, 3>, max_size> piece{}; ///< -1 between triangles of the template
  std::array<Corner, number_of_pieces> side_of_piece{};
  std::array<int, number_of_vertices> triangle_at{}; ///< the last one of those at a vertex
};

namespace square_templates {

/// The triangles where the lower side, or those that `mask` says after turning, are halved.
struct Pattern {
  unsigned mask;
  int size;
  int triangle[Square_template::max_size][3];
};

constexpr Pattern patterns[] = {{0, 2, {{0, 1, 2}, {0, 2, 3}}},
                                {1, 3, {{0, 4, 3}, {4, 1, 2}, {4, 2, 3}}},
                                {3, 4, {{0, 4, 3}, {4, 1, 5}, {4, 5, 3}, {5, 2, 3}}},
                                {5, 4, {{0, 4, 6}, {0, 6, 3}, {4, 1, 2}, {4, 2, 6}}},
                                {7, 5, {{4, 1, 5}, {5, 2, 6}, {4, 5, 6}, {0, 4, 6}, {0, 6, 3}}},
                                {15, 6, {{4, 1, 5}, {5, 2, 6}, {6, 3, 7}, {7, 0, 4}, {4, 5, 6}, {4, 6, 7}}}};

/// The halved sides after a turn by `quarters` times 90 degrees.
constexpr unsigned turned_mask(unsigned mask, unsigned quarters) {
  return ((mask << quarters) | (mask >> (4 - quarters))) & 15u;
}
constexpr int turned_vertex(int v, int quarters) { return (v & 4) | ((v + quarters) & 3); }

/// The piece of the square from vertex a to vertex b, -1 if they are not neighbors on its border.
constexpr int piece_between(int a, int b, unsigned mask) {
  if (a == Square_template::center || b == Square_template::center) return -1;
  if (a >= 4) return b == ((a + 1) & 3) ? 2 * (a - 4) + 1 : -1;
  const bool is_halved = (mask >> a & 1u) != 0;
  return b == (is_halved ? 4 + a : (a + 1) & 3) ? 2 * a : -1;
}

constexpr void connect(Square_template& t, unsigned mask) {
  for (int i = 0; i < t.size; ++i)
    for (int k = 0; k < 3; ++k) {
      const int a = t.triangle[std::size_t(i)][std::size_t(next_slot[k])];
      const int b = t.triangle[std::size_t(i)][std::size_t(previous_slot[k])];
      const int piece = piece_between(a, b, mask);
      t.triangle_at[std::size_t(t.triangle[std::size_t(i)][std::size_t(k)])] = i;
      t.piece[std::size_t(i)][std::size_t(k)] = piece;
      if (piece >= 0) {
        t.side_of_piece[std::size_t(piece)].triangle = i;
        t.side_of_piece[std::size_t(piece)].slot = k;
        continue;
      }
      for (int j = 0; j < t.size; ++j)
        for (int l = 0; l < 3; ++l)
          if (t.triangle[std::size_t(j)][std::size_t(next_slot[l])] == b &&
              t.triangle[std::size_t(j)][std::size_t(previous_slot[l])] == a) {
            t.across[std::size_t(i)][std::size_t(k)].triangle = j;
            t.across[std::size_t(i)][std::size_t(k)].slot = l;
          }
    }
}

/// All pieces of the border joined to the center.
constexpr Square_template make_star(unsigned mask) {
  Square_template t;
  for (int i = 0; i < 4; ++i) {
    const bool is_halved = (mask >> i & 1u) != 0;
    const int on_side[3] = {i, is_halved ? 4 + i : (i + 1) & 3, (i + 1) & 3};
    for (int j = 0; j < (is_halved ? 2 : 1); ++j, ++t.size) {
      t.triangle[std::size_t(t.size)][0] = Square_template::center;
      t.triangle[std::size_t(t.size)][1] = on_side[j];
      t.triangle[std::size_t(t.size)][2] = on_side[j + 1];
    }
  }
  connect(t, mask);
  return t;
}

/// By the sides that are halved; from 16 on with centers.
constexpr std::array<Square_template, 32> make_all() {
  std::array<Square_template, 32> all{};
  for (unsigned mask = 0; mask < 16; ++mask) all[mask + 16] = make_star(mask);
  for (const Pattern& p : patterns)
    for (unsigned quarters = 0; quarters < 4; ++quarters) {
      const unsigned mask = turned_mask(p.mask, quarters);
      Square_template& t = all[mask];
      if (t.size > 0) continue; // a turn by less gives the same sides
      t.size = p.size;
      for (int i = 0; i < p.size; ++i)
        for (int k = 0; k < 3; ++k)
          t.triangle[std::size_t(i)][std::size_t(k)] =
              turned_vertex(p.triangle[i][k], static_cast<int>(quarters));
      connect(t, mask);
    }
  return all;
}

constexpr std::array<Square_template, 32> all = make_all();

} // namespace square_templates

/// The places in a half-open square where vertices are, besides its center.
enum class Square_place : std::uint8_t { LOWER_LEFT, ON_LEFT_SIDE, ON_LOWER_SIDE };
constexpr Square_place all_square_places[] = {Square_place::LOWER_LEFT, Square_place::ON_LEFT_SIDE,
                                              Square_place::ON_LOWER_SIDE};
/// The vertex, as in `Square_template`, at a place.
constexpr int vertex_at(Square_place place) {
  return place == Square_place::LOWER_LEFT ? 0 : place == Square_place::ON_LOWER_SIDE ? 4 : 7;
}

/// A set of places in a square.
struct Square_places {
  std::uint8_t bits = 0;

  static constexpr unsigned bit(Square_place place) { return 1u << static_cast<int>(place); }
  bool has(Square_place place) const { return (bits & bit(place)) != 0; }
  void add(Square_place place) { bits = static_cast<std::uint8_t>(bits | bit(place)); }
  std::uint32_t size() const { return (bits & 1u) + (bits >> 1 & 1u) + (bits >> 2 & 1u); }
  Square_places without(Square_places others) const {
    return {static_cast<std::uint8_t>(bits & ~others.bits)};
  }
  /// Those before the given one.
  Square_places before(Square_place place) const {
    return {static_cast<std::uint8_t>(bits & (bit(place) - 1))};
  }
};

/// Which template a square has: bit i says that there is a vertex in the middle of side i.
struct Square_form {
  static constexpr std::uint8_t with_center = 16;
  std::uint8_t bits = 0;

  bool is_halved(int side) const { return (bits >> side & 1u) != 0; }
  bool is_any_halved() const { return (bits & 15u) != 0; }
  bool has_center() const { return (bits & with_center) != 0; }
  /// Whether the template has vertex i.
  bool has_vertex(int i) const { return i < 4 || (bits >> (i - 4) & 1u) != 0; }
  /// The places with vertices.
  Square_places places() const {
    return {static_cast<std::uint8_t>(Square_places::bit(Square_place::LOWER_LEFT) |
                                      (is_halved(3) ? Square_places::bit(Square_place::ON_LEFT_SIDE) : 0) |
                                      (is_halved(0) ? Square_places::bit(Square_place::ON_LOWER_SIDE) : 0))};
  }
};

inline const Square_template& square_template(Square_form form) { return square_templates::all[form.bits]; }

/// The squared sine of the least angle of squares with halved sides and no center.
constexpr double sin2_of_halved_square = 0.2;

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_SQUARE_TEMPLATES_H
