// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Blocks of equal leaves around sites, and where their vertices move.
//
// Computes: for a site and a level, the 3 x 3 or 4 x 4 squares around it; the vertex that each entry of a
//           table moves, and its square; the places they move to, rounded to the grid.
// Bound:    O(1) for each vertex.
// Source:   Bern, Eppstein, Teng, section 5, Theorem 3: local warping of the squares around each point, which
//           moves a vertex to it.
// Deviates: the paper cites the warping. Here tables define it: places are affine functions of the
//           displacement of the vertex (warp_table.h, star_table.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_BLOCKS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_BLOCKS_H

#include <CGAL/Quadtree_mesh_2/internal/tables/star_table.h>
#include <CGAL/Quadtree_mesh_2/internal/tables/tile_tables.h>
#include <CGAL/Quadtree_mesh_2/internal/tables/warp_table.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_sites.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A place in a square, from its lower left corner on, in units of 2^-30 of the side, and rounded down to them
/// where they are not finer than the grid's. Squares of distances fit a word.
struct Place_in_square {
  std::int64_t x;
  std::int64_t y;
};

constexpr int log_units_of_place_in_square = 30;

inline Place_in_square place_in_square(const Tile_site& p, const Tile_square& s) {
  const int shift = tile_log_side(s.level) - log_units_of_place_in_square;
  const auto scaled = [shift](std::uint64_t d) {
    return static_cast<std::int64_t>(shift >= 0 ? d >> shift : d << -shift);
  };
  return {scaled(p.x() - s.x), scaled(p.y() - s.y)};
}

/// The square of the distance from a place to a vertex of the square's tile.
inline std::uint64_t squared_distance(const Place_in_square& p, const std::array<std::int16_t, 2>& vertex) {
  constexpr std::int64_t unit = (std::int64_t(1) << log_units_of_place_in_square) / Tile::units;
  const std::int64_t dx = p.x - unit * vertex[0], dy = p.y - unit * vertex[1];
  return static_cast<std::uint64_t>(dx * dx + dy * dy);
}

/// The squares of level `level` that the kind of a site asks for.
/// \pre the kind is `warped` or `star`
inline Tile_block tile_block(const Tile_site& p, Site_kind kind, int level) {
  CGAL_precondition(kind != Site_kind::ON_DEMAND);
  const int shift = tile_log_side(level);
  const std::int64_t column = static_cast<std::int64_t>(p.x() >> shift);
  const std::int64_t row = static_cast<std::int64_t>(p.y() >> shift);
  if (kind == Site_kind::WARPED) return {column - 1, row - 1, 3, level};
  // The nearest corner has two columns to its left and two rows below.
  const auto half = [shift](std::uint64_t v) { return static_cast<std::int64_t>(v >> (shift - 1) & 1); };
  return {column - 2 + half(p.x()), row - 2 + half(p.y()), 4, level};
}

/// The tables of moves, with their vertices found in the tiles of blocks.
class Block_moves {
public:
  /// How one vertex of a block moves.
  struct Move {
    int square; ///< of the block
    int vertex; ///< of the square's tile
    int spoke;  ///< 0 to 7 for the spokes of a star, counterclockwise from the east; otherwise -1
    Warped_vertex table;
  };
  using Moves = std::vector<Move>;

  /// Where a block's vertices move.
  struct Target {
    const Moves* moves;
    std::int64_t x, y;   ///< the origin of the table's coordinates
    std::int64_t dx, dy; ///< the way of the vertex that moves to the site
    Tile_place vertex;   ///< where it is before
  };

  Block_moves() {
    const Tile& t = tile(0);
    for (int v = 0; v < t.number_of_vertices; ++v) warps_.push_back(located(warp(v).vertices, 1, 3));
    star_ = located(star().vertices, 2, 4);
    for (Move& move : star_) move.spoke = spoke(move.table);
  }

  /// How the vertices of the block of a site move.
  Target target(const Tile_site& p, Site_kind kind, const Tile_block& block) const {
    Target t{};
    const std::int64_t unit = std::int64_t(1) << (tile_log_side(block.level) - 10);
    const std::int64_t side = unit * Tile::units;
    const int before = kind == Site_kind::WARPED ? 1 : 2; // squares between the block's corner and the origin
    t.x = (block.column + before) * side;
    t.y = (block.row + before) * side;
    std::int64_t vx = t.x, vy = t.y;
    t.moves = &star_;
    if (kind == Site_kind::WARPED) {
      const std::size_t v = nearest_vertex(place_in_square(p, block.square(4)));
      vx += unit * tile(0).vertices[v][0];
      vy += unit * tile(0).vertices[v][1];
      t.moves = &warps_[v];
    }
    t.vertex = {static_cast<std::uint64_t>(vx), static_cast<std::uint64_t>(vy)};
    t.dx = static_cast<std::int64_t>(p.x()) - vx;
    t.dy = static_cast<std::int64_t>(p.y()) - vy;
    return t;
  }

  /// Where one of them moves, rounded to the grid.
  static Tile_place moved(const Target& t, const Move& move, int level) {
    const std::int64_t unit = std::int64_t(1) << (tile_log_side(level) - 10);
    const Warped_vertex& w = move.table;
    const std::int64_t x = t.x + unit * (w.base_x + w.offset_x) + product(w.xx, w.xy, t);
    const std::int64_t y = t.y + unit * (w.base_y + w.offset_y) + product(w.yx, w.yy, t);
    return {static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y)};
  }

private:
  /// Returns (a dx + b dy) / 1024, rounded to an integer; whole and remaining parts apart, which avoids overflow.
  static std::int64_t product(std::int64_t a, std::int64_t b, const Target& t) {
    const std::int64_t dx = floor_of_quotient(t.dx), dy = floor_of_quotient(t.dy);
    return a * dx + b * dy +
           floor_of_quotient(a * (t.dx - dx * Tile::units) + b * (t.dy - dy * Tile::units) + Tile::units / 2);
  }

  static std::int64_t floor_of_quotient(std::int64_t d) {
    const std::int64_t q = d / Tile::units;
    return q * Tile::units > d ? q - 1 : q;
  }

  static std::size_t nearest_vertex(const Place_in_square& p) {
    const Tile& t = tile(0);
    std::size_t best = 0;
    for (std::size_t v = 1; v < static_cast<std::size_t>(t.number_of_vertices); ++v)
      if (squared_distance(p, t.vertices[v]) < squared_distance(p, t.vertices[best])) best = v;
    return best;
  }

  static int spoke(const Warped_vertex& w) {
    const auto& spokes = star().spokes;
    const std::array<std::int16_t, 2> base{{w.base_x, w.base_y}};
    const auto found = std::find(spokes.begin(), spokes.end(), base);
    return found == spokes.end() ? -1 : static_cast<int>(found - spokes.begin());
  }

  /// Finds the vertices of a table, whose coordinates have their origin `before` squares from the corner of a
  /// block of `size` by `size` squares.
  template <class Table>
  static Moves located(const Table& table, int before, int size) {
    Moves moves;
    const Tile& t = tile(0);
    for (const Warped_vertex& w : table) {
      const int x = w.base_x + before * Tile::units, y = w.base_y + before * Tile::units;
      const int column = x / Tile::units, row = y / Tile::units;
      int v = 0;
      while (t.vertices[std::size_t(v)][0] != x % Tile::units ||
             t.vertices[std::size_t(v)][1] != y % Tile::units)
        ++v;
      moves.push_back({row * size + column, v, -1, w});
    }
    return moves;
  }

  std::vector<Moves> warps_; // by vertex of the middle tile
  Moves star_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_BLOCKS_H
