// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The sixteen tiles: how a leaf of a quadtree is cut into acute triangles.
//
// The quadtree must be balanced across corners: leaves that touch, even if only at a corner, differ in size
// by at most a factor of two. Each corner of a leaf has one bit. It is S if a leaf smaller than this one
// touches the corner, and L if not. The four bits determine the tile. Six tiles are written out; the others
// are turned or mirrored. The vertices inside a side depend only on the bits at its ends. As fractions of the
// side, from the corner of the first letter, they are
//   LL: 1/2    SL: 17/64, 9/16    LS: 7/16, 47/64    SS: 1/4, 1/2, 3/4
// So tiles fit together. Equal leaves see the same bits at both ends of their common side. A side toward a
// larger leaf is LL. A side toward two smaller leaves is SS, which is twice LL at half the size.
//
// Bound:    All angles are between 43.4 and 72.7 degrees, and a leaf has at most 40 triangles.
// Source:   Bern, Eppstein, Teng, section 5, Theorem 3: tiles with angles from 36 to 80 degrees. These were
//           found by optimization and have room for moving vertices (warp_table.h). Balance across corners is
//           the strong balance condition of the paper. There are always vertices inside sides: otherwise four
//           sides would need more base angle than the four corners have.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TABLES_TILE_TABLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TABLES_TILE_TABLES_H

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// One of the sixteen tiles. Coordinates are in units of 1/1024 of the side of the square, from its lower left
/// corner.
struct Tile {
  static constexpr int units = 1024, max_vertices = 29, max_triangles = 40;
  using Vertex = std::array<std::int16_t, 2>;
  using Triangle = std::array<std::uint8_t, 3>;

  int number_of_vertices = 0, number_of_boundary_vertices = 0, number_of_triangles = 0;
  /// Those on the boundary first, counterclockwise from the lower left corner.
  std::array<Vertex, max_vertices> vertices{};
  std::array<Triangle, max_triangles> triangles{}; ///< counterclockwise
};

namespace tile_tables {

struct Base_tile {
  unsigned corner_bits;
  Tile tile;
};

// clang-format off
constexpr std::array<Base_tile, 6> base_tiles{{
    // Smaller leaves at no corner.
    {0u,
     {12, 8, 14,
      {{{0, 0}, {512, 0}, {1024, 0}, {1024, 512}, {1024, 1024}, {512, 1024}, {0, 1024}, {0, 512},
       {685, 685}, {339, 339}, {638, 386}, {386, 638}}},
      {{{7, 0, 9}, {7, 9, 11}, {7, 11, 6}, {6, 11, 5}, {5, 11, 8}, {5, 8, 4}, {4, 8, 3}, {3, 8, 10},
       {3, 10, 2}, {2, 10, 1}, {1, 10, 9}, {1, 9, 0}, {9, 10, 11}, {11, 10, 8}}}}},
    // Smaller leaves at the lower left corner.
    {1u,
     {17, 10, 22,
      {{{0, 0}, {272, 0}, {576, 0}, {1024, 0}, {1024, 512}, {1024, 1024}, {512, 1024}, {0, 1024}, {0, 576},
       {0, 272}, {322, 684}, {684, 322}, {219, 406}, {406, 219}, {634, 634}, {446, 446}, {179, 179}}},
      {{{9, 0, 16}, {9, 16, 12}, {9, 12, 8}, {8, 12, 10}, {8, 10, 7}, {7, 10, 6}, {6, 10, 14}, {6, 14, 5},
       {5, 14, 4}, {4, 14, 11}, {4, 11, 3}, {3, 11, 2}, {2, 11, 13}, {2, 13, 1}, {1, 13, 16}, {1, 16, 0},
       {16, 13, 12}, {12, 13, 15}, {12, 15, 10}, {10, 15, 14}, {14, 15, 11}, {11, 15, 13}}}}},
    // Smaller leaves at both lower corners.
    {3u,
     {21, 12, 28,
      {{{0, 0}, {256, 0}, {512, 0}, {768, 0}, {1024, 0}, {1024, 272}, {1024, 576}, {1024, 1024},
       {512, 1024}, {0, 1024}, {0, 576}, {0, 272}, {600, 198}, {424, 198}, {181, 172}, {843, 172},
       {670, 688}, {354, 688}, {223, 381}, {801, 381}, {512, 387}}},
      {{{11, 0, 14}, {11, 14, 18}, {11, 18, 10}, {10, 18, 17}, {10, 17, 9}, {9, 17, 8}, {8, 17, 16},
       {8, 16, 7}, {7, 16, 6}, {6, 16, 19}, {6, 19, 5}, {5, 19, 15}, {5, 15, 4}, {4, 15, 3}, {3, 15, 12},
       {3, 12, 2}, {2, 12, 13}, {2, 13, 1}, {1, 13, 14}, {1, 14, 0}, {14, 13, 18}, {18, 13, 20},
       {18, 20, 17}, {17, 20, 16}, {16, 20, 19}, {19, 20, 12}, {19, 12, 15}, {12, 20, 13}}}}},
    // Smaller leaves at the lower left and the upper right corner.
    {5u,
     {21, 12, 28,
      {{{0, 0}, {272, 0}, {576, 0}, {1024, 0}, {1024, 448}, {1024, 752}, {1024, 1024}, {752, 1024},
       {448, 1024}, {0, 1024}, {0, 576}, {0, 272}, {844, 844}, {180, 180}, {727, 297}, {297, 727},
       {435, 221}, {221, 435}, {803, 589}, {589, 803}, {512, 512}}},
      {{{11, 0, 13}, {11, 13, 17}, {11, 17, 10}, {10, 17, 15}, {10, 15, 9}, {9, 15, 8}, {8, 15, 19},
       {8, 19, 7}, {7, 19, 12}, {7, 12, 6}, {6, 12, 5}, {5, 12, 18}, {5, 18, 4}, {4, 18, 14}, {4, 14, 3},
       {3, 14, 2}, {2, 14, 16}, {2, 16, 1}, {1, 16, 13}, {1, 13, 0}, {13, 16, 17}, {17, 16, 20},
       {17, 20, 15}, {15, 20, 19}, {19, 20, 18}, {19, 18, 12}, {18, 20, 14}, {14, 20, 16}}}}},
    // Smaller leaves at all corners but the upper right one.
    {11u,
     {25, 14, 34,
      {{{0, 0}, {256, 0}, {512, 0}, {768, 0}, {1024, 0}, {1024, 272}, {1024, 576}, {1024, 1024},
       {576, 1024}, {272, 1024}, {0, 1024}, {0, 768}, {0, 512}, {0, 256}, {202, 375}, {375, 202},
       {413, 794}, {794, 413}, {193, 644}, {644, 193}, {843, 172}, {172, 843}, {701, 701}, {470, 470},
       {170, 170}}},
      {{{13, 0, 24}, {13, 24, 14}, {13, 14, 12}, {12, 14, 18}, {12, 18, 11}, {11, 18, 21}, {11, 21, 10},
       {10, 21, 9}, {9, 21, 16}, {9, 16, 8}, {8, 16, 22}, {8, 22, 7}, {7, 22, 6}, {6, 22, 17}, {6, 17, 5},
       {5, 17, 20}, {5, 20, 4}, {4, 20, 3}, {3, 20, 19}, {3, 19, 2}, {2, 19, 15}, {2, 15, 1}, {1, 15, 24},
       {1, 24, 0}, {24, 15, 14}, {14, 15, 23}, {14, 23, 18}, {18, 23, 16}, {18, 16, 21}, {16, 23, 22},
       {22, 23, 17}, {17, 23, 19}, {17, 19, 20}, {19, 23, 15}}}}},
    // Smaller leaves at all corners.
    {15u,
     {29, 16, 40,
      {{{0, 0}, {256, 0}, {512, 0}, {768, 0}, {1024, 0}, {1024, 256}, {1024, 512}, {1024, 768},
       {1024, 1024}, {768, 1024}, {512, 1024}, {256, 1024}, {0, 1024}, {0, 768}, {0, 512}, {0, 256},
       {381, 821}, {643, 821}, {381, 203}, {643, 203}, {821, 381}, {203, 643}, {203, 381}, {821, 643},
       {854, 854}, {170, 854}, {854, 170}, {170, 170}, {512, 512}}},
      {{{15, 0, 27}, {15, 27, 22}, {15, 22, 14}, {14, 22, 21}, {14, 21, 13}, {13, 21, 25}, {13, 25, 12},
       {12, 25, 11}, {11, 25, 16}, {11, 16, 10}, {10, 16, 17}, {10, 17, 9}, {9, 17, 24}, {9, 24, 8},
       {8, 24, 7}, {7, 24, 23}, {7, 23, 6}, {6, 23, 20}, {6, 20, 5}, {5, 20, 26}, {5, 26, 4}, {4, 26, 3},
       {3, 26, 19}, {3, 19, 2}, {2, 19, 18}, {2, 18, 1}, {1, 18, 27}, {1, 27, 0}, {27, 18, 22},
       {22, 18, 28}, {22, 28, 21}, {21, 28, 16}, {21, 16, 25}, {16, 28, 17}, {17, 28, 23}, {17, 23, 24},
       {23, 28, 20}, {20, 28, 19}, {20, 19, 26}, {19, 28, 18}}}}},
}};
// clang-format on

/// Mirrors at the diagonal through the lower left corner if so wanted; then turns to the left.
struct Symmetry {
  bool is_mirrored;
  unsigned quarter_turns;
};

constexpr unsigned corner_bits_after(Symmetry symmetry, unsigned bits) {
  unsigned result = 0;
  for (unsigned corner = 0; corner < 4; ++corner)
    if (bits >> corner & 1u)
      result |= 1u << ((symmetry.is_mirrored ? 4 - corner : corner) + symmetry.quarter_turns) % 4;
  return result;
}

constexpr Tile::Vertex vertex_after(Symmetry symmetry, Tile::Vertex v) {
  if (symmetry.is_mirrored) v = {v[1], v[0]};
  for (unsigned i = 0; i < symmetry.quarter_turns; ++i)
    v = {static_cast<std::int16_t>(Tile::units - v[1]), v[0]};
  return v;
}

/// The vertices on the boundary begin at the lower left corner and go counterclockwise again.
constexpr Tile tile_after(Symmetry symmetry, const Tile& tile) {
  const int b = tile.number_of_boundary_vertices;
  int first = 0;
  for (int i = 0; i < b; ++i) {
    const Tile::Vertex v = vertex_after(symmetry, tile.vertices[static_cast<std::size_t>(i)]);
    if (v[0] == 0 && v[1] == 0) first = i;
  }
  Tile result;
  result.number_of_vertices = tile.number_of_vertices;
  result.number_of_boundary_vertices = b;
  result.number_of_triangles = tile.number_of_triangles;
  std::array<std::uint8_t, Tile::max_vertices> new_index{};
  for (int i = 0; i < tile.number_of_vertices; ++i) {
    const int steps = symmetry.is_mirrored ? first - i : i - first;
    const int j = i < b ? (steps + b) % b : i;
    new_index[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(j);
    result.vertices[static_cast<std::size_t>(j)] =
        vertex_after(symmetry, tile.vertices[static_cast<std::size_t>(i)]);
  }
  for (std::size_t t = 0; t < static_cast<std::size_t>(tile.number_of_triangles); ++t) {
    const Tile::Triangle& old = tile.triangles[t];
    const std::uint8_t u = new_index[old[0]], v = new_index[old[1]], w = new_index[old[2]];
    result.triangles[t] = symmetry.is_mirrored ? Tile::Triangle{u, w, v} : Tile::Triangle{u, v, w};
  }
  return result;
}

/// A base tile with these bits after some symmetry, and that symmetry.
constexpr Tile make_tile(unsigned corner_bits) {
  for (const Base_tile& base : base_tiles)
    for (unsigned i = 0; i < 8; ++i) {
      const Symmetry symmetry{i >= 4, i % 4};
      if (corner_bits_after(symmetry, base.corner_bits) == corner_bits)
        return tile_after(symmetry, base.tile);
    }
  return Tile();
}

constexpr std::array<Tile, 16> make_tiles() {
  std::array<Tile, 16> tiles{};
  for (unsigned bits = 0; bits < 16; ++bits) tiles[bits] = make_tile(bits);
  return tiles;
}

inline constexpr std::array<Tile, 16> tiles = make_tiles();

} // namespace tile_tables

/// Bit i of `corner_bits`: a leaf smaller than the square touches its corner i (0 lower left, 1 lower right,
/// 2 upper right, 3 upper left).
inline constexpr const Tile& tile(unsigned corner_bits) { return tile_tables::tiles[corner_bits]; }

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TABLES_TILE_TABLES_H
