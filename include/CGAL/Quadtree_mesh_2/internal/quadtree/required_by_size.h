// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The split squares of an unbalanced quadtree whose leaves satisfy a predicate.
//
// Computes: the squares that have to be split because a predicate says so or because of their points.
// Bound:    O(k) calls of the predicate; two rounds for each level.
// Source:   the top-down refinement of all quadtree codes; p4est_refine(), CGAL::Orthtree::refine().

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_REQUIRED_BY_SIZE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_REQUIRED_BY_SIZE_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Point_distribution.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Required_squares.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Finds the squares that the points of a framework or a predicate require.
/// \tparam Must_split called as `must_split(lower_left, upper_right)` with the corners of a square, maybe by
///         several threads; squares of one grid unit are never split.
template <class Framework, class Must_split, class ConcurrencyTag>
class Sized_squares_finder {
public:
  Sized_squares_finder(const Framework& framework, std::size_t max_points, const Must_split& must_split)
      : framework_(framework), points_(framework), max_points_(max_points), must_split_(must_split) {}

  Required_squares find() {
    Required_squares squares;
    const Open_square root{{0, 0}, 0, static_cast<std::uint32_t>(framework_.number_of_points())};
    std::vector<Open_square> level_squares;
    if (has_to_be_split(root, 0)) level_squares.push_back(root);
    for (int level = 0; !level_squares.empty(); ++level) {
      append_level(level_squares, level, squares);
      level_squares = split_children(level_squares, level, squares);
    }
    squares.template link_children<ConcurrencyTag>();
    return squares;
  }

private:
  using Grid_point = typename Framework::Grid_point;
  using Word = typename Framework::Word;
  using Point_rank = typename Framework::Point_rank;
  static constexpr std::size_t block_length_ = 256;

  struct Open_square {
    Grid_point corner;
    std::uint32_t point_begin;
    std::uint32_t point_end;
  };

  bool has_to_be_split(const Open_square& s, int level) const {
    if (level == framework_.grid().depth()) return false;
    if (s.point_end - s.point_begin > max_points_) return true;
    for (std::uint32_t r = s.point_begin; r < s.point_end; ++r)
      if (framework_.desired_level(Point_rank(r)) > level) return true;
    const Word side = Word_operations<Word>::power_of_two(framework_.grid().depth() - level);
    const Grid_point opposite{static_cast<Word>(s.corner.x + side), static_cast<Word>(s.corner.y + side)};
    return must_split_(framework_.grid().point(s.corner), framework_.grid().point(opposite));
  }

  /// The children of a square of level `level`.
  std::array<Open_square, 4> children(const Open_square& s, int level) const {
    const auto begins = points_.child_begins(level, s.point_begin, s.point_end);
    std::array<Open_square, 4> result{};
    for (unsigned q = 0; q < 4; ++q) {
      Open_square& child = result[q];
      child.corner = s.corner;
      move_to_child(child.corner, static_cast<int>(q), framework_.grid().depth() - level - 1);
      child.point_begin = begins[q];
      child.point_end = q < 3 ? begins[q + 1] : s.point_end;
    }
    return result;
  }

  void append_level(const std::vector<Open_square>& level_squares, int level,
                    Required_squares& squares) const {
    const std::size_t first = squares.children.size(), last = first + level_squares.size();
    if (last >= Required_squares::none) throw std::length_error("Balanced_quadtree: too many squares");
    squares.children.resize(last);
    squares.level_begin.push_back(static_cast<std::uint32_t>(last));
    for_each_index<ConcurrencyTag>(
        level_squares.size(),
        [&](std::size_t i) {
          unsigned split = 0;
          const auto all = children(level_squares[i], level);
          for (unsigned q = 0; q < 4; ++q)
            if (has_to_be_split(all[q], level + 1)) split |= 1u << q;
          squares.children[first + i] = static_cast<std::uint8_t>(split);
        },
        block_length_);
  }

  std::vector<Open_square> split_children(const std::vector<Open_square>& level_squares, int level,
                                          const Required_squares& squares) const {
    const std::size_t first = squares.level_begin[std::size_t(level)];
    const std::vector<std::size_t> place = place_children(level_squares.size(), first, squares);
    std::vector<Open_square> result(place.back());
    for_each_block<ConcurrencyTag>(level_squares.size(), block_length_,
                                   [&](std::size_t b, std::size_t begin, std::size_t end) {
                                     std::size_t next = place[b];
                                     for (std::size_t i = begin; i < end; ++i) {
                                       const auto all = children(level_squares[i], level);
                                       for (unsigned q = 0; q < 4; ++q)
                                         if ((squares.children[first + i] >> q & 1) != 0)
                                           result[next++] = all[q];
                                     }
                                   });
    return result;
  }

  /// How many split children there are before each block of squares, and in all.
  std::vector<std::size_t> place_children(std::size_t n, std::size_t first,
                                          const Required_squares& squares) const {
    std::vector<std::size_t> place((n + block_length_ - 1) / block_length_ + 1, 0);
    for_each_block<ConcurrencyTag>(n, block_length_, [&](std::size_t b, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) place[b] += number_of_children(squares.children[first + i]);
    });
    scan_exclusively(place.data(), place.size(), std::size_t(0));
    return place;
  }

  const Framework& framework_;
  Point_distribution<Framework> points_;
  std::size_t max_points_;
  const Must_split& must_split_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_REQUIRED_BY_SIZE_H
