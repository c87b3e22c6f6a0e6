// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Split squares below the levels that p4est has.
//
// Computes: for points in squares of level 29, the squares that have too many points, and all that balance splits
//           because of them: those of level 29 and below, and those of level 28 that have to be split so that squares
//           of level 29 exist. What is split is the same as in one tree of all levels.
// Bound:    O(k log k) time for k squares.
// Source:   Bern, Eppstein, Teng, section 3: a split square forces the squares of its size around it, so their parents
//           are split. As each split square forces by itself alone, what all of them force is the union. Squares that
//           are forced are next to the square of level 29 that has the points, so parts tell each other once.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_DEEP_SQUARES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_DEEP_SQUARES_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Coarse_square.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Point_order.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_options.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Fine_square = Quadtree_square_2<std::uint64_t>;

constexpr std::uint64_t side_of_level(int level) { return std::uint64_t(1) << (fine_depth - level); }

/// Preorder: a square comes before those inside it.
inline bool less_in_preorder(const Fine_square& a, const Fine_square& b) {
  if (a.x == b.x && a.y == b.y) return a.level < b.level;
  return less_shuffle(Grid_point_2<std::uint64_t>{a.x, a.y}, Grid_point_2<std::uint64_t>{b.x, b.y});
}

inline void sort_and_unify(std::vector<Fine_square>& squares) {
  std::sort(squares.begin(), squares.end(), less_in_preorder);
  squares.erase(std::unique(squares.begin(), squares.end()), squares.end());
}

inline Coarse_code coarse_code(const Fine_square& s) {
  return coarse_code(Grid_point_2<std::uint64_t>{s.x, s.y});
}

inline Fine_square fine_square(const Coarse_square& s) {
  constexpr int shift = fine_depth - coarse_depth;
  return {std::uint64_t(even_bits(s.code >> 1)) << shift, std::uint64_t(even_bits(s.code)) << shift, s.level};
}

/// Finds split squares, see the head of this file.
class Deep_squares_finder {
public:
  Deep_squares_finder(const std::vector<Placed_point>& points, std::size_t most, Balance balance)
      : points_(points), most_(most), balance_(balance), of_level_(fine_depth + 1) {}

  /// Adds a square of level 29 with the points from `first` to `last`.
  void add(std::size_t first, std::size_t last) {
    if (last - first > most_) split(last_coarse_level, first, last);
  }

  /// In preorder.
  std::vector<Fine_square> find() {
    for (int level = fine_depth - 1; level >= last_coarse_level; --level) {
      std::vector<Fine_square>& squares = of_level_[static_cast<std::size_t>(level)];
      sort_and_unify(squares);
      for (const Fine_square& s : squares) force_around(s);
      result_.insert(result_.end(), squares.begin(), squares.end());
      std::vector<Fine_square>().swap(squares);
    }
    std::vector<Fine_square>& coarse = of_level_[last_coarse_level - 1];
    result_.insert(result_.end(), coarse.begin(), coarse.end());
    sort_and_unify(result_);
    return std::move(result_);
  }

private:
  void split(int level, std::size_t first, std::size_t last) {
    const Grid_point_2<std::uint64_t> corner = corner_of_square(points_[first].place, level, fine_depth);
    of_level_[static_cast<std::size_t>(level)].push_back({corner.x, corner.y, level});
    while (first < last) {
      const int q = quadrant(points_[first].place, level, fine_depth);
      std::size_t behind = first + 1;
      while (behind < last && quadrant(points_[behind].place, level, fine_depth) == q) ++behind;
      if (behind - first > most_) split(level + 1, first, behind);
      first = behind;
    }
  }

  void force_around(const Fine_square& s) {
    split_parent(s);
    if (balance_ == Balance::NONE) return;
    const std::uint64_t side = side_of_level(s.level), end = side_of_level(0);
    for (const Direction d : all_directions()) {
      if (balance_ == Balance::SIDES && is_diagonal(d)) continue;
      // Beyond the left and lower sides of the root words wrap around, to what is not less than its side.
      const std::uint64_t x = s.x + static_cast<std::uint64_t>(step_x(d)) * side,
                          y = s.y + static_cast<std::uint64_t>(step_y(d)) * side;
      if (x < end && y < end) split_parent({x, y, s.level});
    }
  }

  void split_parent(const Fine_square& s) {
    const auto corner = corner_of_square(Grid_point_2<std::uint64_t>{s.x, s.y}, s.level - 1, fine_depth);
    of_level_[static_cast<std::size_t>(s.level) - 1].push_back({corner.x, corner.y, s.level - 1});
  }

  const std::vector<Placed_point>& points_;
  std::size_t most_;
  Balance balance_;
  std::vector<std::vector<Fine_square>> of_level_;
  std::vector<Fine_square> result_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_DEEP_SQUARES_H
