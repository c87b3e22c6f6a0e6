// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The input of a mesh of tiles: sites with the levels of their leaves, and the squares to keep.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_SITES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_SITES_H

#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Tile_traits = Fixed_point_quadtree_traits_2<std::uint64_t>;
using Tile_site = Tile_traits::Point_2;
using Tile_place = Tile_traits::Grid_point;
using Tile_square = Quadtree_square_2<std::uint64_t>;

/// The deepest level of leaves with tiles. Vertices of tiles are multiples of 2^-10 of a leaf's side, which
/// leaves two bits below them for vertices that are moved.
constexpr int max_tile_level = 50;

/// Returns the logarithm of the side, in grid units, of squares of level `level`.
constexpr int tile_log_side(int level) { return Tile_traits::depth - level; }

/// The treatment of the leaf of a site.
enum class Site_kind : std::uint8_t {
  ON_DEMAND, ///< its tile, whatever it is
  WARPED, ///< the middle of 3 x 3 equal leaves, of which one vertex is moved to the site, and others after it
  STAR    ///< one of the 4 x 4 equal leaves around its corner nearest to the site, likewise
};

/// Equal squares, as many columns as rows. Columns and rows are counted on their level; some may be outside
/// the root.
struct Tile_block {
  std::int64_t column;
  std::int64_t row;
  int size;
  int level;

  int number_of_squares() const { return size * size; }
  /// Square `i`, counted row by row. \pre it is inside the root
  Tile_square square(int i) const {
    const int shift = tile_log_side(level);
    return {static_cast<std::uint64_t>(column + i % size) << shift,
            static_cast<std::uint64_t>(row + i / size) << shift, level};
  }
};

/// The squares of one level that are kept, an axis-parallel rectangle: columns `x0` to `x1 - 1` and rows `y0`
/// to `y1 - 1`. Leaves in it are not larger than these squares; leaves outside do not count as neighbors.
struct Tile_window {
  int level = 0;
  std::uint64_t x0 = 0;
  std::uint64_t x1 = 1;
  std::uint64_t y0 = 0;
  std::uint64_t y1 = 1;

  bool is_valid() const {
    return 0 <= level && level <= max_tile_level && x0 < x1 && y0 < y1 && x1 <= std::uint64_t(1) << level &&
           y1 <= std::uint64_t(1) << level;
  }

  bool contains(std::uint64_t x, std::uint64_t y) const {
    const int shift = tile_log_side(level);
    return x0 <= x >> shift && x >> shift < x1 && y0 <= y >> shift && y >> shift < y1;
  }

  bool contains_block(const Tile_block& b) const {
    if (b.level < level) return false;
    const auto at = [&](std::uint64_t cell) { return static_cast<std::int64_t>(cell << (b.level - level)); };
    return at(x0) <= b.column && b.column + b.size <= at(x1) && at(y0) <= b.row && b.row + b.size <= at(y1);
  }

  std::uint64_t left() const { return x0 << tile_log_side(level); }
  std::uint64_t right() const { return x1 << tile_log_side(level); }
  std::uint64_t bottom() const { return y0 << tile_log_side(level); }
  std::uint64_t top() const { return y1 << tile_log_side(level); }
};

/// There are no leaves small enough for a site.
class Tile_level_error : public std::length_error {
public:
  explicit Tile_level_error(std::size_t site)
      : std::length_error("mesh of tiles: point " + std::to_string(site) +
                          " is too near another point: its square would be too small"),
        site_(site) {}
  std::size_t site() const { return site_; }

private:
  std::size_t site_;
};

/// Sites for a mesh of tiles.
struct Tile_sites {
  std::vector<Tile_site> places;      ///< distinct, in the window
  std::vector<int> levels;            ///< by site, the least level of its leaf; or empty, for level 0
  std::vector<Site_kind> kinds;       ///< by site; or empty, if all are `ON_DEMAND`
  Tile_window window = Tile_window(); ///< by default the root
  int max_level = max_tile_level;     ///< of the leaves of sites; less if coordinates are coarse

  std::size_t size() const { return places.size(); }
  int level(std::size_t i) const { return levels.empty() ? 0 : levels[i]; }
  Site_kind kind(std::size_t i) const { return kinds.empty() ? Site_kind::ON_DEMAND : kinds[i]; }
};

/// Checks sites.
/// \throws std::length_error if a leaf is to be smaller than leaves with tiles can be.
inline void check_tile_sites(const Tile_sites& sites) {
  CGAL_precondition(sites.levels.empty() || sites.levels.size() == sites.size());
  CGAL_precondition(sites.kinds.empty() || sites.kinds.size() == sites.size());
  CGAL_precondition(sites.window.is_valid());
  CGAL_precondition(sites.max_level <= max_tile_level);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    CGAL_precondition(sites.window.contains(sites.places[i].x(), sites.places[i].y()));
    if (sites.level(i) > sites.max_level) throw Tile_level_error(i);
  }
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_SITES_H
