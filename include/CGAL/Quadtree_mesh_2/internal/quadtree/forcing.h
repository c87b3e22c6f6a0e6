// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Which squares of its own size a required square forces to be split, because of the required squares inside
// it.
//
// Computes: for each required square the set of its eight neighbors of the same size that balance splits
//           because of the squares inside it.
// Bound:    O(1) for each required square; one round for each level, from the deepest up.
// Source:   Bern, Eppstein, Teng, section 3, forced squares.
// Method:   A split square forces the squares of twice its size that touch it, and these in turn force
//           others. Everything that a square forces on an upper level lies within one step of the square
//           there that contains it: on each level the chain gets nearer than a side to that square, and no
//           farther. So what the inside of a square forces on its own level is a set of directions. A table
//           gives the set from the sets of its children. A square is in the smallest balanced quadtree just
//           if it is required, or if a required neighbor's set has it. That needs no coordinates, and no
//           square is made that would have to be removed.
// Deviates: the paper sorts the forced squares of all levels, or makes them top-down, and splits all squares
//           once more. That tree is up to four times as large as the smallest one.
// See also: closed_forced_directions.h for the same sets without a round for each level.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_FORCING_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_FORCING_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Required_squares.h>
#include <CGAL/Quadtree_options.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A set of directions, bit d for direction number d.
using Direction_set = std::uint8_t;

/// Returns the half of `v`, rounded down, for v from -2 to 3.
constexpr int floor_half(int v) { return (v + 2) / 2 - 1; }

/// Returns where the square at (x, y), in units of its side from its grandparent's child's corner, forces
/// squares of twice its size, as seen from the square of that size at (0, 0).
constexpr Direction_set forced_by_square(int x, int y, bool across_corners) {
  Direction_set forced = 0;
  for (int dx = -1; dx <= 1; ++dx)
    for (int dy = -1; dy <= 1; ++dy) {
      if (dx != 0 && dy != 0 && !across_corners) continue;
      const int px = floor_half(x + dx), py = floor_half(y + dy);
      if (px != 0 || py != 0)
        forced = static_cast<Direction_set>(forced | 1u << static_cast<int>(direction(px, py)));
    }
  return forced;
}

/// What is forced around a square, by the split child and the set that the child forces around itself.
/// Compilers compute it for whoever includes this file, and clang++ would take most of a second. So the entry of each
/// set is made from that of the set without its last direction, as directions come in the order of their bits.
class Forcing_table {
public:
  constexpr explicit Forcing_table(bool across_corners) {
    for (int q = 0; q < 4; ++q) {
      auto& entries = entries_[static_cast<std::size_t>(q)];
      entries[0] = forced_by_square(q / 2, q % 2, across_corners);
      for (Direction d : all_directions()) {
        const Direction_set by_direction =
            forced_by_square(q / 2 + step_x(d), q % 2 + step_y(d), across_corners);
        const std::size_t bit = std::size_t(1) << static_cast<int>(d);
        for (std::size_t set = bit; set < 2 * bit; ++set)
          entries[set] = static_cast<Direction_set>(entries[set - bit] | by_direction);
      }
    }
  }

  constexpr Direction_set forced(int child, Direction_set by_child) const {
    return entries_[static_cast<std::size_t>(child)][by_child];
  }

private:
  std::array<std::array<Direction_set, 256>, 4> entries_{};
};

/// Returns for each required square where it forces squares of its size, in the smallest balanced quadtree.
template <class ConcurrencyTag>
Uninitialized_vector<Direction_set> least_forced_directions(const Required_squares& squares,
                                                            Balance balance) {
  static constexpr Forcing_table across_sides(false), across_corners(true);
  Uninitialized_vector<Direction_set> forced(squares.size());
  const Forcing_table& table = balance == Balance::SIDES ? across_sides : across_corners;
  for (int level = squares.number_of_levels(); level-- > 0;) {
    const std::uint32_t first = squares.level_begin[std::size_t(level)];
    const std::uint32_t last = squares.level_begin[std::size_t(level) + 1];
    for_each_index<ConcurrencyTag>(last - first, [&](std::size_t i) {
      const std::size_t s = first + i;
      Direction_set set = 0;
      std::uint32_t child = squares.first_child[s];
      for (int q = 0; q < 4; ++q)
        if ((squares.children[s] >> q & 1) != 0)
          set = static_cast<Direction_set>(set | table.forced(q, forced[child++]));
      forced[s] = balance == Balance::NONE ? Direction_set(0) : set;
    });
  }
  return forced;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_FORCING_H
