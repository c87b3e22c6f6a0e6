// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The split squares of an unbalanced quadtree.
//
// Computes: the squares that have to be split, whatever balance adds: those that hold more than m points or
//           are larger than a point's annotation asks for. They are listed level by level, in shuffle order
//           within a level. So the split children of a square follow each other, and a bit set and one number
//           link them.
// Bound:    O(n + k) work for k squares, in a constant number of rounds, whatever the depth. A limit of less
//           than n points in a leaf takes log2 n short rounds more if there are annotations.
// Source:   Bern, Eppstein, Teng, section 2, Theorem 1: each edge of the framework is a path of squares, for
//           which room is allocated after counting.
// Method:   Paths are listed in shuffle order, larger squares first, and so are their squares, without regard
//           to where a path ends. The squares are sorted by their levels, stably, by counting.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_REQUIRED_SQUARES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_REQUIRED_SQUARES_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/combine_points_of_nodes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Returns the number of members of a set of children, given as four bits.
constexpr unsigned number_of_children(unsigned children) {
  return (children & 1) + (children >> 1 & 1) + (children >> 2 & 1) + (children >> 3 & 1);
}

/// The split squares of a quadtree, level by level; see the head of this file.
struct Required_squares {
  static constexpr std::uint32_t none = 0xffffffffu;

  /// The squares of level l are those from `level_begin[l]` to `level_begin[l + 1]`.
  std::vector<std::uint32_t> level_begin{0};
  /// Bit q says whether child q is split, too.
  Uninitialized_vector<std::uint8_t> children;
  /// The first split child; where there is none, the first one of the squares that follow.
  Uninitialized_vector<std::uint32_t> first_child;
  /// Where the points of each child begin; only for squares that points require.
  Uninitialized_vector<std::array<std::uint32_t, 4>> point_begin;
  /// The smallest square of the framework with the same points, `none` if there is one point only; only for
  /// squares that points require.
  Uninitialized_vector<std::uint32_t> node;

  std::size_t size() const { return children.size(); }
  int number_of_levels() const { return static_cast<int>(level_begin.size()) - 1; }

  /// Child q of a square, or `none` if it is not split.
  std::uint32_t child(std::uint32_t i, int q) const {
    const unsigned all = children[i];
    if ((all >> q & 1) == 0) return none;
    return first_child[i] + number_of_children(all & ((1u << q) - 1));
  }

  /// Calls `f(i, level)` for all squares.
  template <class ConcurrencyTag, class F>
  void for_each_with_level(const F& f) const {
    for_each_block<ConcurrencyTag>(
        size(), default_block, [&](std::size_t, std::size_t begin, std::size_t end) {
          const auto after = std::upper_bound(level_begin.begin(), level_begin.end(), begin);
          std::size_t level = static_cast<std::size_t>(after - level_begin.begin()) - 1;
          for (std::size_t i = begin; i < end; ++i) {
            while (level_begin[level + 1] <= i) ++level;
            f(i, static_cast<int>(level));
          }
        });
  }

  /// Links the children: the split children of all squares, in order, are all squares but the root.
  template <class ConcurrencyTag>
  void link_children() {
    resize_to_write(first_child, size());
    for_each_index<ConcurrencyTag>(size(),
                                   [&](std::size_t i) { first_child[i] = number_of_children(children[i]); });
    exclusive_scan<ConcurrencyTag>(first_child.data(), size());
    for_each_index<ConcurrencyTag>(size(), [&](std::size_t i) { ++first_child[i]; });
  }
};

/// Finds the squares that the points of a framework require.
template <class Framework, class ConcurrencyTag>
class Required_squares_finder {
public:
  Required_squares_finder(const Framework& framework, std::size_t max_points)
      : framework_(framework), max_points_(max_points), depth_(framework.grid().depth()) {
    if (framework_.has_annotations() && max_points_ > 1) find_desired_levels();
  }

  Required_squares find() {
    list_paths();
    list_squares();
    Required_squares squares;
    const Order order = order_by_level();
    find_levels(order, squares);
    resize_to_write(squares.children, order.size());
    resize_to_write(squares.point_begin, order.size());
    resize_to_write(squares.node, order.size());
    for_each_index<ConcurrencyTag>(order.size(), [&](std::size_t i) {
      fill_square(i, paths_[path_[order[i]]], level_[order[i]], squares);
    });
    squares.template link_children<ConcurrencyTag>();
    return squares;
  }

private:
  using Node_index = typename Framework::Node_index;
  using Point_rank = typename Framework::Point_rank;
  using Order = Uninitialized_vector<std::uint32_t>;
  static constexpr std::size_t block_length_ = default_block;

  /// The squares of levels `first` to `last` that contain the same points; none if `last < first`.
  struct Levels {
    int first;
    int last;

    bool is_empty() const { return last < first; }
  };

  /// Required squares of the same points.
  struct Path {
    Levels levels;
    std::uint32_t point; ///< the first one
    Node_index node;     ///< the smallest node with these points, invalid if there is only one
  };

  /// The required squares with the points of `v` but not all of its parent's, whose level is `above`.
  Levels levels(Node_index v, int above) const {
    if (framework_.points(v).size() > max_points_) return {above + 1, framework_.level(v)};
    if (desired_level_.empty()) return {above + 1, above};
    return {above + 1, std::min(framework_.level(v), desired_level_[v] - 1)};
  }

  /// The required squares with no point but `r`, whose smallest node has level `above`.
  Levels levels(Point_rank r, int above) const { return {above + 1, framework_.desired_level(r) - 1}; }

  /// The greatest annotation in each node.
  void find_desired_levels() {
    desired_level_ = combine_points_of_nodes<int, ConcurrencyTag>(
        framework_, [&](std::size_t r) { return framework_.desired_level(Point_rank(r)); },
        [](int a, int b) { return std::max(a, b); });
  }

  /// Calls `on_path(levels, p, v)` for the nodes v and points p that begin in a range of points and have a
  /// path, in shuffle order, larger squares first; v is invalid for the path of a point.
  template <class On_path>
  void for_each_path(std::size_t begin, std::size_t end, const On_path& on_path) const {
    std::size_t v = first_node_from(framework_, begin);
    for (std::size_t p = begin; p < end; ++p) {
      for (; v < framework_.number_of_nodes() && framework_.points(Node_index(v)).begin.value() == p; ++v) {
        const Levels squares = levels(Node_index(v), framework_.level_of_parent(Node_index(v)));
        if (!squares.is_empty()) on_path(squares, p, Node_index(v));
      }
      if (!framework_.has_annotations()) continue;
      const Levels squares = levels(Point_rank(p), framework_.level_of_node(Point_rank(p)));
      if (!squares.is_empty()) on_path(squares, p, Node_index());
    }
  }

  void list_paths() {
    count_allocate_and_place<ConcurrencyTag>(
        framework_.number_of_points(),
        [&](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for_each_path(begin, end, [&](const Levels&, std::size_t, Node_index) { ++sum; });
          return sum;
        },
        [&](std::size_t sum) { resize_to_write(paths_, sum); },
        [&](std::size_t begin, std::size_t end, std::size_t first) {
          for_each_path(begin, end, [&](const Levels& of_path, std::size_t p, Node_index v) {
            paths_[first++] = {of_path, static_cast<std::uint32_t>(p), v};
          });
        },
        block_length_);
  }

  /// Lists the squares of all paths. A path may be longer than a block.
  void list_squares() {
    Uninitialized_vector<std::size_t> first(paths_.size()); // squares of the paths
    for_each_index<ConcurrencyTag>(paths_.size(), [&](std::size_t i) {
      first[i] = static_cast<std::size_t>(paths_[i].levels.last - paths_[i].levels.first + 1);
    });
    const std::size_t sum = exclusive_scan<ConcurrencyTag>(first.data(), first.size());
    if (sum >= Required_squares::none) throw std::length_error("Balanced_quadtree: too many squares");
    resize_to_write(path_, sum);
    resize_to_write(level_, sum);
    for_each_block<ConcurrencyTag>(sum, block_length_, [&](std::size_t, std::size_t begin, std::size_t end) {
      std::size_t i =
          static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), begin) - first.begin());
      for (std::size_t s = begin; s < end; ++s) {
        while (i < first.size() && first[i] <= s) ++i;
        path_[s] = static_cast<std::uint32_t>(i - 1);
        level_[s] = paths_[i - 1].levels.first + static_cast<int>(s - first[i - 1]);
      }
    });
  }

  /// The squares of paths in the order of their levels, stably. The counts of levels take no more memory than
  /// squares do.
  Order order_by_level() const {
    constexpr int digit = 16; // squares in a block of `group_in_order()`
    const int depth = reduce<ConcurrencyTag>(
        paths_.size(), 0,
        [&](std::size_t begin, std::size_t end) {
          int last = 0;
          for (std::size_t i = begin; i < end; ++i) last = std::max(last, paths_[i].levels.last);
          return last;
        },
        [](int a, int b) { return std::max(a, b); });
    const auto level = [&](std::size_t s) { return static_cast<std::size_t>(level_[s]); };
    if (depth >> digit == 0)
      return group_in_order<ConcurrencyTag, std::uint32_t>(level_.size(), std::size_t(depth) + 1, level)
          .members;
    const Order low = group_in_order<ConcurrencyTag, std::uint32_t>(
                          level_.size(), std::size_t(1) << digit,
                          [&](std::size_t s) { return level(s) & ((std::size_t(1) << digit) - 1); })
                          .members;
    Order order =
        group_in_order<ConcurrencyTag, std::uint32_t>(low.size(), std::size_t(depth >> digit) + 1,
                                                      [&](std::size_t i) { return level(low[i]) >> digit; })
            .members;
    for_each_index<ConcurrencyTag>(order.size(), [&](std::size_t i) { order[i] = low[order[i]]; });
    return order;
  }

  /// Finds where levels begin. None is without squares.
  void find_levels(const Order& order, Required_squares& squares) const {
    if (order.empty()) return;
    squares.level_begin.resize(static_cast<std::size_t>(level_[order.back()]) + 2);
    squares.level_begin.back() = static_cast<std::uint32_t>(order.size());
    for_each_index<ConcurrencyTag>(order.size(), [&](std::size_t i) {
      if (i == 0 || level_[order[i - 1]] != level_[order[i]])
        squares.level_begin[static_cast<std::size_t>(level_[order[i]])] = static_cast<std::uint32_t>(i);
    });
  }

  /// What is known of the children of a square.
  struct Children {
    unsigned split; ///< bit q for child q
    std::array<std::uint32_t, 4> point_begin;
  };

  /// Makes square number `i`, that of level `level` of a path.
  void fill_square(std::size_t i, const Path& path, int level, Required_squares& squares) const {
    const Children children = children_in_path(path, level);
    squares.children[i] = static_cast<std::uint8_t>(children.split);
    squares.point_begin[i] = children.point_begin;
    squares.node[i] = path.node.is_valid() ? path.node.value() : Required_squares::none;
  }

  Children children_in_path(const Path& path, int level) const {
    const Node_index v = path.node;
    if (v.is_valid() && level == framework_.level(v)) return children_of_node(v);
    Children children =
        only_child(level, path.point, v.is_valid() ? framework_.points(v).end.value() : path.point + 1);
    if (level == path.levels.last) children.split = 0; // the path ends before a node for lack of points
    return children;
  }

  /// The children of a square of level `level` whose points, from `begin` to `end`, are all in one child.
  Children only_child(int level, std::uint32_t begin, std::uint32_t end) const {
    const unsigned q = child_of_point(begin, level);
    Children children{1u << q, {{begin, end, end, end}}};
    for (unsigned i = 1; i <= q; ++i) children.point_begin[i] = begin;
    return children;
  }

  /// The children of the square of a node.
  Children children_of_node(Node_index v) const {
    const int level = framework_.level(v);
    Children children{0, {}};
    unsigned known = 0;
    const auto add = [&](const Levels& path, Point_rank first) {
      const unsigned q = child_of_point(first.value(), level);
      for (; known <= q; ++known) children.point_begin[known] = first.value();
      if (!path.is_empty()) children.split |= 1u << q;
    };
    framework_.for_each_child(
        v, [&](Node_index child) { add(levels(child, level), framework_.points(child).begin); },
        [&](Point_rank r) { add(levels(r, level), r); });
    for (; known < 4; ++known) children.point_begin[known] = framework_.points(v).end.value();
    return children;
  }

  unsigned child_of_point(std::uint32_t rank, int level) const {
    return static_cast<unsigned>(quadrant(framework_.grid_point(Point_rank(rank)), level, depth_));
  }

  const Framework& framework_;
  std::size_t max_points_;
  int depth_;
  // If annotations and nodes with few points meet.
  Indexed_vector<Node_index, int, Uninitialized_allocator<int>> desired_level_;

  Uninitialized_vector<Path> paths_; // that are not empty
  // By square, path by path.
  Order path_;
  Uninitialized_vector<int> level_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_REQUIRED_SQUARES_H
