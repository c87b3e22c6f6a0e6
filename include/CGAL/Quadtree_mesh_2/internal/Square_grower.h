// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The linked squares of a quadtree, from the root down.
//
// Computes: from the required squares and where each forces its neighbours, all squares with cross pointers,
//           and the points in each.
// Bound:    O(k) work besides finding which points are in which child; three rounds for each level.
// Source:   Bern, Eppstein, Teng, proof of Theorem 2 (top-down method): the cross pointers of the level above
//           lead to the squares that are forced.
// Deviates: what is forced is known beforehand (forcing.h), so that a level is finished before the next one is
//           begun, and without coordinates: squares of any depth cost the same. Points ride down with their
//           squares, so that none has to be located.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARE_GROWER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARE_GROWER_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/Linked_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/Required_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/forcing.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel.h>
#include <CGAL/assertions.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Framework, class Concurrency_tag>
class Square_grower {
public:
  using Squares = Linked_squares<typename Framework::Word>;

  /// \param forced for each required square the directions in which it forces its neighbours; what is forced
  ///        together with what is required must be balanced.
  Square_grower(const Framework& framework, const Required_squares& required,
                const Uninitialized_vector<Direction_set>& forced)
      : framework_(framework), required_(required), forced_(forced), depth_(framework.grid().depth()) {
    squares_.depth_ = depth_;
  }

  /// Returns the squares of the quadtree.
  Squares grow() {
    squares_.reserve(2 * required_.size());
    begin_with_root();
    while (grow_level()) {
    }
    squares_.template number_leaves<Concurrency_tag>();
    return std::move(squares_);
  }

private:
  using Grid_point = typename Framework::Grid_point;
  using Level = typename Squares::Level;
  static constexpr std::size_t families_in_block_ = default_block / 8;

  /// What is known of a family of the last level but no longer afterwards.
  struct Growth {
    std::uint32_t required;  ///< the number of the required square, or none
    std::uint32_t point_end; ///< behind the last point
  };

  void begin_with_root() {
    squares_.resize(required_.size() == 0 ? 0 : 1);
    squares_.point_begin_[0] = 0;
    if (required_.size() == 0) return;
    squares_.level_begin_.push_back(1);
    growth_.resize(1);
    const std::uint32_t points = static_cast<std::uint32_t>(framework_.number_of_points());
    squares_.neighbors_[0].fill(Node_index().value());
    make_family(0, 0, 0, Growth{0, points}, growth_[0]);
  }

  /// Splits the squares of the next level that have to be; returns whether there are any.
  bool grow_level() {
    if (squares_.number_of_split_levels() == 0) return false;
    const int level = squares_.number_of_split_levels(); // of the children
    const std::uint32_t first = squares_.level_begin(level - 1), last = squares_.level_begin(level);
    Marks marks(4 * std::size_t(last - first));
    for_each_index<Concurrency_tag>(
        last - first, [&](std::size_t i) { mark_children(first + static_cast<std::uint32_t>(i), first, marks); },
        families_in_block_);

    std::vector<std::size_t> place = count_marks(marks);
    const std::size_t families = last + place.back();
    if (families == last) {
      leave_children(first, last);
      return false;
    }
    squares_.resize(families);
    squares_.level_begin_.push_back(static_cast<std::uint32_t>(families));
    Uninitialized_vector<Growth> grown(families - last);
    for_each_block<Concurrency_tag>(
        marks.size(), 4 * families_in_block_, [&](std::size_t b, std::size_t begin, std::size_t end) {
          std::uint32_t next = last + static_cast<std::uint32_t>(place[b]);
          for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t node = 4 * first + 1 + static_cast<std::uint32_t>(i);
            if (marks[i].load(std::memory_order_relaxed) == 0) {
              squares_.leaf_or_family_[node] = Squares::leaf_flag;
              continue;
            }
            make_family(next, node, level, growth_of_child(node, first), grown[next - last]);
            ++next;
          }
        });
    growth_.swap(grown);
    return true;
  }

  /// One for each child of the families of a level; set by several threads, always to the same value.
  using Marks = std::vector<std::atomic<std::uint8_t>>;

  /// Marks the children of a family that have to be split, and the neighbours that they force.
  void mark_children(std::uint32_t family, std::uint32_t first_family, Marks& marks) const {
    const std::uint32_t square = growth_[family - first_family].required;
    if (square == Required_squares::none || required_.children[square] == 0) return;
    const std::size_t first_node = 4 * std::size_t(first_family) + 1;
    const auto mark = [&](Node_index v) {
      CGAL_assertion(std::size_t(v) >= first_node);
      marks[std::size_t(v) - first_node].store(1, std::memory_order_relaxed);
    };
    for (int q = 0; q < 4; ++q) {
      const std::uint32_t child = required_.child(square, q);
      if (child == Required_squares::none) continue;
      const Node_index v = Squares::member(family, q);
      mark(v);
      for (Direction_set set = forced_[child]; set != 0; set = static_cast<Direction_set>(set & (set - 1))) {
        const Node_index n = squares_.neighbor(v, static_cast<Direction>(lowest_bit(std::uint32_t(set))));
        if (n.is_valid()) mark(n);
      }
    }
  }

  /// Returns how many marks there are before each block, and in all.
  std::vector<std::size_t> count_marks(const Marks& marks) const {
    const std::size_t block = 4 * families_in_block_;
    std::vector<std::size_t> place((marks.size() + block - 1) / block + 1, 0);
    for_each_block<Concurrency_tag>(marks.size(), block,
                                    [&](std::size_t b, std::size_t begin, std::size_t end) {
                                      std::size_t sum = 0;
                                      for (std::size_t i = begin; i < end; ++i)
                                        sum += marks[i].load(std::memory_order_relaxed);
                                      place[b] = sum;
                                    });
    scan_exclusively(place.data(), place.size(), std::size_t(0));
    return place;
  }

  void leave_children(std::uint32_t first, std::uint32_t last) {
    for_each_index<Concurrency_tag>(4 * std::size_t(last - first), [&](std::size_t i) {
      squares_.leaf_or_family_[4 * std::size_t(first) + 1 + i] = Squares::leaf_flag;
    });
  }

  Growth growth_of_child(std::uint32_t node, std::uint32_t first_family) const {
    const std::uint32_t family = Squares::family_of(Node_index(node));
    const int q = Squares::member_of(Node_index(node));
    const Growth& parent = growth_[family - first_family];
    return {parent.required == Required_squares::none ? Required_squares::none
                                                      : required_.child(parent.required, q),
            q < 3 ? squares_.point_begin_[node + 1] : parent.point_end};
  }

  /// Makes the family of the split square `node`.
  void make_family(std::uint32_t family, std::uint32_t node, int level, const Growth& growth, Growth& grown) {
    grown = growth;
    squares_.leaf_or_family_[node] = family;
    squares_.node_[family] = node;
    squares_.family_level_[family] = static_cast<Level>(level);
    if constexpr (Squares::are_corners_stored)
      squares_.corner_[family] = node == 0 ? Grid_point{0, 0} : squares_.corner(Node_index(node));
    if (node != 0)
      for (Direction d : all_directions())
        squares_.neighbors_[family][std::size_t(d)] = squares_.neighbor(Node_index(node), d).value();
    distribute_points(family, level, squares_.point_begin_[node], growth.point_end);
  }

  /// Finds where the points of each child begin. They are in shuffle order, so children have intervals.
  void distribute_points(std::uint32_t family, int level, std::uint32_t begin, std::uint32_t end) {
    std::uint32_t* const child_begin = &squares_.point_begin_[4 * std::size_t(family) + 1];
    child_begin[0] = begin;
    if (begin == end) {
      child_begin[1] = child_begin[2] = child_begin[3] = end;
      return;
    }
    const int first = child_of_point(begin, level);
    const int last = end - begin == 1 ? first : child_of_point(end - 1, level);
    for (int q = 1; q < 4; ++q)
      child_begin[q] = q <= first  ? begin
                       : q > last  ? end
                                   : first_point_from(q, level, child_begin[q - 1], end);
  }

  int child_of_point(std::uint32_t rank, int level) const {
    return quadrant(framework_.grid_point(typename Framework::Point_rank(rank)), level, depth_);
  }

  /// The first point from `begin` on in child `q` or a later one. Takes steps of growing length from the
  /// beginning, so that few points cost little.
  std::uint32_t first_point_from(int q, int level, std::uint32_t begin, std::uint32_t end) const {
    std::uint32_t step = 1;
    while (step < end - begin && child_of_point(begin + step - 1, level) < q) {
      begin += step;
      step *= 2;
    }
    end = step < end - begin ? begin + step : end;
    while (begin < end) {
      const std::uint32_t middle = begin + (end - begin) / 2;
      if (child_of_point(middle, level) < q)
        begin = middle + 1;
      else
        end = middle;
    }
    return begin;
  }

  const Framework& framework_;
  const Required_squares& required_;
  const Uninitialized_vector<Direction_set>& forced_;
  int depth_;

  Squares squares_;
  Uninitialized_vector<Growth> growth_; // by family of the last level
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARE_GROWER_H
