// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The linked squares of a quadtree, from the root down.
//
// Computes: all squares with cross pointers, and the points in each, from the required squares and the
//           directions in which each forces its neighbors.
// Bound:    O(k) work, not counting which points are in which child; three rounds for each level.
// Source:   Bern, Eppstein, Teng, proof of Theorem 2 (top-down method): the cross pointers of the level above
//           lead to the squares that are forced.
// Deviates: forced squares are known in advance (forcing.h). So a level is finished before the next one
//           begins, and without coordinates: squares of any depth cost the same. Points move down with their
//           squares, so none has to be located.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_SQUARE_GROWER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_SQUARE_GROWER_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/base/huge_pages.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Linked_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Point_distribution.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Required_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/forcing.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Framework, class ConcurrencyTag>
class Square_grower {
public:
  using Squares = Linked_squares<typename Framework::Word>;

  /// \param forced for each required square the directions in which it forces its neighbors; what is forced
  ///        together with what is required must be balanced.
  Square_grower(const Framework& framework, const Required_squares& required,
                const Uninitialized_vector<Direction_set>& forced)
      : framework_(framework), points_(framework), required_(required), forced_(forced) {
    squares_.depth_ = framework.grid().depth();
  }

  /// Returns the squares of the quadtree.
  Squares grow() {
    reserve(required_.size());
    begin_with_root();
    if (required_.size() > 0) grow_levels();
    make_room_for_leaves();
    squares_.template number_leaves<ConcurrencyTag>(framework_.number_of_points());
    return std::move(squares_);
  }

private:
  template <class, class>
  friend class Spaced_levels_grower;

  using Grid_point = typename Framework::Grid_point;
  using Level = typename Squares::Level;
  static constexpr std::size_t families_in_block_ = default_block / 8;

  /// Set by several threads, always to the same value.
  using Mark = std::atomic<std::uint8_t>;

  /// What is known of a family of the last level but no longer afterward.
  struct Growth {
    std::uint32_t required;  ///< the number of the required square, or none
    std::uint32_t point_end; ///< behind the last point
  };

  /// Makes room for the squares that `required` ones lead to. Random points make 1.6 times as many split
  /// squares as are required, points on a line 3.4 times. Memory that is never written to costs addresses only,
  /// and to move large arrays to larger ones is serial work.
  void reserve(std::size_t required) {
    try {
      squares_.reserve(4 * required);
    } catch (const std::bad_alloc&) { // there may be enough for what is needed
    }
  }

  void begin_with_root() {
    squares_.resize(required_.size() == 0 ? 0 : 1);
    squares_.point_begin_[0] = 0;
    if (required_.size() == 0) return;
    squares_.level_begin_.push_back(1);
    growth_.resize(1);
    const std::uint32_t points = static_cast<std::uint32_t>(framework_.number_of_points());
    make_family(0, 0, 0, Growth{0, points}, growth_[0]);
  }

  /// Makes all levels below the last one.
  void grow_levels() {
    for (mark_children(); number_of_marks() > 0; mark_children()) split_marked_children();
    for_each_child([](std::uint32_t, std::size_t) {});
  }

  /// Frees what levels needed: most memory is in use when leaves are numbered.
  void make_room_for_leaves() {
    Uninitialized_vector<Growth>().swap(growth_);
    Uninitialized_vector<Growth>().swap(grown_);
    marks_.reset();
    room_for_marks_ = 0;
  }

  /// Finds the children of the last level that have to be split.
  void mark_children() {
    const std::uint32_t first = first_family(), last = end_family();
    clear_marks(4 * std::size_t(last - first));
    for_each_index<ConcurrencyTag>(
        last - first, [&](std::size_t i) { mark_children_of(first + static_cast<std::uint32_t>(i)); },
        families_in_block_);
    count_marks();
  }

  std::size_t number_of_marks() const { return marks_before_block_.back(); }

  /// Makes a level of the marked children.
  void split_marked_children() {
    const std::uint32_t first = first_family(), last = end_family();
    const int level = level_of_children();
    squares_.resize(last + number_of_marks());
    grown_.resize(number_of_marks());
    for_each_child([&](std::uint32_t node, std::size_t mark) {
      const std::uint32_t family = last + static_cast<std::uint32_t>(mark);
      make_family(family, node, level, growth_of_child(node, first), grown_[mark]);
    });
    squares_.level_begin_.push_back(static_cast<std::uint32_t>(last + number_of_marks()));
    growth_.swap(grown_);
  }

  /// Makes leaves of the children that are not marked and calls `on_marked(node, i)` for the marked ones, i
  /// counting them in order.
  template <class On_marked>
  void for_each_child(const On_marked& on_marked) {
    const std::size_t first_node = 4 * std::size_t(first_family()) + 1;
    for_each_block<ConcurrencyTag>(number_of_children_, 4 * families_in_block_,
                                   [&](std::size_t b, std::size_t begin, std::size_t end) {
                                     std::size_t next = marks_before_block_[b];
                                     for (std::size_t i = begin; i < end; ++i)
                                       if (marks_[i].load(std::memory_order_relaxed) != 0)
                                         on_marked(static_cast<std::uint32_t>(first_node + i), next++);
                                       else
                                         squares_.leaf_or_family_[first_node + i] = Squares::leaf_flag;
                                   });
  }

  // The families of the last level, and the level of their children.
  std::uint32_t first_family() const { return squares_.level_begin(squares_.number_of_split_levels() - 1); }
  std::uint32_t end_family() const { return squares_.level_begin(squares_.number_of_split_levels()); }
  int level_of_children() const { return squares_.number_of_split_levels() + level_offset_; }

  /// Marks the children of a family that have to be split, and the neighbors that they force.
  void mark_children_of(std::uint32_t family) {
    const std::uint32_t square = growth_[family - first_family()].required;
    if (square == Required_squares::none) return;
    const std::size_t first_node = 4 * std::size_t(first_family()) + 1;
    const auto mark = [&](std::size_t v) {
      CGAL_assertion(v >= first_node);
      marks_[v - first_node].store(1, std::memory_order_relaxed);
    };
    std::uint32_t child = required_.first_child[square];
    for (unsigned split = required_.children[square]; split != 0; split &= split - 1, ++child) {
      const Node_index v = Squares::member(family, lowest_bit(split));
      mark(v.value());
      const Direction_set forced = forced_[child];
      if (forced == 0) continue;
      const std::array<std::uint32_t, 8> neighbors = squares_.neighbors(v);
      for (std::size_t d = 0; d < 8; ++d)
        if ((forced >> d & 1) != 0 && neighbors[d] != Node_index().value()) mark(neighbors[d]);
    }
  }

  void clear_marks(std::size_t n) {
    if (n > room_for_marks_) {
      room_for_marks_ = std::max(n, 2 * room_for_marks_);
      marks_.reset(new Mark[room_for_marks_]);
      if (n < least_in_huge_pages) ask_for_pages(marks_.get(), n);
    }
    number_of_children_ = n;
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) { marks_[i].store(0, std::memory_order_relaxed); });
  }

  /// Counts the marks before each block, and all.
  void count_marks() {
    const std::size_t block = 4 * families_in_block_;
    marks_before_block_.assign((number_of_children_ + block - 1) / block + 1, 0);
    for_each_block<ConcurrencyTag>(number_of_children_, block,
                                   [&](std::size_t b, std::size_t begin, std::size_t end) {
                                     std::size_t sum = 0;
                                     for (std::size_t i = begin; i < end; ++i)
                                       sum += marks_[i].load(std::memory_order_relaxed);
                                     marks_before_block_[b] = sum;
                                   });
    scan_exclusively(marks_before_block_.data(), marks_before_block_.size(), std::size_t(0));
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
    if constexpr (Squares::are_corners_stored) squares_.corner_[family] = squares_.corner(Node_index(node));
    if (node == 0)
      squares_.neighbors_[family].fill(Node_index().value());
    else
      squares_.neighbors_[family] = squares_.neighbors(Node_index(node));
    const bool is_known = growth.required != Required_squares::none && !required_.point_begin.empty();
    const auto begins = is_known ? required_.point_begin[growth.required]
                                 : points_.child_begins(level, squares_.point_begin_[node], growth.point_end);
    std::copy(begins.begin(), begins.end(), &squares_.point_begin_[4 * std::size_t(family) + 1]);
  }

  const Framework& framework_;
  Point_distribution<Framework> points_;
  const Required_squares& required_;
  const Uninitialized_vector<Direction_set>& forced_;

  Squares squares_;
  int level_offset_ = 0; // of the first level here, if the levels above are elsewhere

  // By family of the last level.
  Uninitialized_vector<Growth> growth_;
  Uninitialized_vector<Growth> grown_; // of the level being made
  // By child of the last level; and by block of children.
  std::unique_ptr<Mark[]> marks_;
  std::size_t number_of_children_ = 0;
  std::size_t room_for_marks_ = 0;
  std::vector<std::size_t> marks_before_block_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_SQUARE_GROWER_H
