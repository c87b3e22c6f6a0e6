// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The squares that a quadtree has to split.
//
// Computes: from a framework, the squares with more than m points, level by level; and their closure under
// balance: the
//           split squares of the smallest quadtree in which leaves that share a side or a corner differ by at
//           most a factor of two.
// Bound:    O(k) for k split squares, in one round per level; the deepest levels of very deep trees are
// sorted, not
//           marked, which takes O(k) too for words of constant length.
// Source:   Bern, Eppstein, Teng, section 3: a square forces the squares adjacent to it and its parent. Only
// split
//           squares are kept here: if a square is split, its eight neighbours exist, hence their parents are
//           split.
// Deviates: the paper's Theorem 2 splits all squares once more and so pays a factor of up to four; the
// closure, deepest
//           level first, adds nothing that balance does not force.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SPLIT_SQUARES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SPLIT_SQUARES_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Square_collector.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The split squares of a quadtree, for each level in shuffle order. A square is given by its lower left
/// corner in units of its side.
template <class Word>
using Split_squares = std::vector<std::vector<Grid_point_2<Word>>>;

/// Returns the squares with more than `max_points` points.
template <class Framework>
Split_squares<typename Framework::Word> crowded_squares(const Framework& framework, std::size_t max_points) {
  using Node = typename Framework::Node_index;
  Split_squares<typename Framework::Word> levels;
  for (std::size_t i = 0; i < framework.number_of_nodes(); ++i) {
    const Node v(i);
    if (framework.points(v).size() <= max_points) continue;
    // The path from the parent, exclusive, down to v: all its squares have the points of v.
    const auto square = framework.square(v);
    const int first = framework.parent(v).is_valid() ? framework.level(framework.parent(v)) + 1 : 0;
    if (levels.size() <= std::size_t(square.level)) levels.resize(std::size_t(square.level) + 1);
    for (int level = first; level <= square.level; ++level) {
      const int shift = Framework::Traits::depth - level;
      levels[std::size_t(level)].push_back({square.x >> shift, square.y >> shift});
    }
  }
  return levels;
}

/// For each set of split siblings, the directions from their parent to the squares that they force, as bits
/// 3 (dy + 1) + dx + 1; the parent itself is bit 4. Sibling 2 i + j has x offset i and y offset j.
inline std::vector<unsigned> forced_directions() {
  std::vector<unsigned> forced(16, 0);
  for (unsigned siblings = 0; siblings < 16; ++siblings)
    for (unsigned q = 0; q < 4; ++q) {
      if ((siblings >> q & 1) == 0) continue;
      const unsigned x = q / 2 * 2, y = q % 2 * 2; // where the sibling lies on the 3 by 3 squares, 0 or 2
      forced[siblings] |= 1u << 4 | 1u << (3 + x) | 1u << (3 * y + 1) | 1u << (3 * y + x);
    }
  return forced;
}

/// Calls `on_parent(parent, siblings)` for each parent of the squares of a level, with the bit set of its
/// split children.
template <class Word, class On_parent>
void for_each_parent(const std::vector<Grid_point_2<Word>>& squares, On_parent on_parent) {
  for (std::size_t i = 0; i < squares.size();) {
    const Grid_point_2<Word> parent{squares[i].x >> 1, squares[i].y >> 1};
    unsigned siblings = 0;
    for (; i < squares.size() && squares[i].x >> 1 == parent.x && squares[i].y >> 1 == parent.y; ++i)
      siblings |= 1u << ((squares[i].x & 1) * 2 + (squares[i].y & 1));
    on_parent(parent, siblings);
  }
}

/// Adds the squares that balance forces, so that the tree becomes the smallest balanced one.
template <class Word>
void close_under_balance(Split_squares<Word>& levels) {
  const std::vector<unsigned> forced = forced_directions();
  for (std::size_t level = levels.size(); level-- > 1;) {
    const Word side = Word(1) << (level - 1); // of the root, in squares of the level above
    Square_collector<Word> above(static_cast<int>(level - 1),
                                 levels[level].size() + levels[level - 1].size());
    for (const auto& square : levels[level - 1]) above.insert(square);
    for_each_parent(levels[level], [&](const Grid_point_2<Word>& parent, unsigned siblings) {
      for (unsigned d = 0; d < 9; ++d) {
        if ((forced[siblings] >> d & 1) == 0) continue;
        const Grid_point_2<Word> square{static_cast<Word>(parent.x + d % 3 - 1),
                                        static_cast<Word>(parent.y + d / 3 - 1)};
        if (square.x < side && square.y < side) above.insert(square); // -1 wraps to the greatest number
      }
    });
    levels[level - 1] = above.take_sorted();
  }
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SPLIT_SQUARES_H
