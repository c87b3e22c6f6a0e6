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
// Bound:    O(n + k) work for k squares; O(1) rounds over blocks of points, and a pass over the numbers of
//           squares that each block has on each level.
// Source:   Bern, Eppstein, Teng, section 2, Theorem 1: each edge of the framework is a path of squares, for
//           which room is allocated after counting.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_REQUIRED_SQUARES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_REQUIRED_SQUARES_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

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

  std::size_t size() const { return children.size(); }
  int number_of_levels() const { return static_cast<int>(level_begin.size()) - 1; }

  /// Child q of a square, or `none` if it is not split.
  std::uint32_t child(std::uint32_t i, int q) const {
    const unsigned all = children[i];
    if ((all >> q & 1) == 0) return none;
    return first_child[i] + number_of_children(all & ((1u << q) - 1));
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
    const std::size_t n = framework_.number_of_points();
    std::vector<std::vector<std::uint32_t>> places((n + block_length_ - 1) / block_length_);
    for_each_block<ConcurrencyTag>(n, block_length_, [&](std::size_t b, std::size_t begin, std::size_t end) {
      count_squares(begin, end, places[b]);
    });
    Required_squares squares;
    allocate(places, squares);
    for_each_block<ConcurrencyTag>(n, block_length_, [&](std::size_t b, std::size_t begin, std::size_t end) {
      fill_squares(begin, end, places[b], squares);
    });
    squares.template link_children<ConcurrencyTag>();
    return squares;
  }

private:
  using Node_index = typename Framework::Node_index;
  using Point_rank = typename Framework::Point_rank;
  static constexpr std::size_t block_length_ = default_block;

  /// The squares of levels `first` to `last` that contain the same points; none if `last < first`.
  struct Path {
    int first;
    int last;
  };

  /// The required squares with the points of `v` but not all of its parent's, whose level is `above`.
  Path path(Node_index v, int above) const {
    if (framework_.points(v).size() > max_points_) return {above + 1, framework_.level(v)};
    if (desired_level_.empty()) return {above + 1, above};
    return {above + 1, std::min(framework_.level(v), desired_level_[v] - 1)};
  }

  /// The required squares with no point but `r`, whose smallest node has level `above`.
  Path path(Point_rank r, int above) const { return {above + 1, framework_.desired_level(r) - 1}; }

  /// The greatest annotation in each node, from the children up.
  void find_desired_levels() {
    desired_level_.assign(framework_.number_of_nodes(), 0);
    for (std::size_t i = framework_.number_of_nodes(); i-- > 0;) {
      int& level = desired_level_[Node_index(i)];
      framework_.for_each_child(
          Node_index(i), [&](Node_index child) { level = std::max(level, desired_level_[child]); },
          [&](Point_rank r) { level = std::max(level, framework_.desired_level(r)); });
    }
  }

  /// Calls `on_path(path, p, v)` for the nodes v and points p that begin in a range of points and have a path,
  /// in shuffle order, larger squares first; v is invalid for the path of a point.
  template <class On_path>
  void for_each_path(std::size_t begin, std::size_t end, const On_path& on_path) const {
    std::size_t v = first_node_from(begin);
    for (std::size_t p = begin; p < end; ++p) {
      for (; v < framework_.number_of_nodes() && framework_.points(Node_index(v)).begin.value() == p; ++v) {
        const Path squares = path(Node_index(v), framework_.level_of_parent(Node_index(v)));
        if (squares.first <= squares.last) on_path(squares, p, Node_index(v));
      }
      if (!framework_.has_annotations()) continue;
      const Path squares = path(Point_rank(p), framework_.level_of_node(Point_rank(p)));
      if (squares.first <= squares.last) on_path(squares, p, Node_index());
    }
  }

  /// The first node whose points begin at `p` or later.
  std::size_t first_node_from(std::size_t p) const {
    std::size_t low = 0, high = framework_.number_of_nodes();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (framework_.points(Node_index(middle)).begin.value() < p)
        low = middle + 1;
      else
        high = middle;
    }
    return low;
  }

  void count_squares(std::size_t begin, std::size_t end, std::vector<std::uint32_t>& count) const {
    for_each_path(begin, end, [&](const Path& squares, std::size_t, Node_index) {
      if (count.size() <= std::size_t(squares.last)) count.resize(std::size_t(squares.last) + 1, 0);
      for (int level = squares.first; level <= squares.last; ++level) ++count[std::size_t(level)];
    });
  }

  /// Turns the numbers of squares of each block on each level into their places.
  void allocate(std::vector<std::vector<std::uint32_t>>& places, Required_squares& squares) const {
    std::size_t levels = 0;
    for (const auto& block : places) levels = std::max(levels, block.size());
    std::size_t sum = 0;
    squares.level_begin.reserve(levels + 1);
    for (std::size_t level = 0; level < levels; ++level) {
      for (auto& block : places) {
        if (block.size() <= level) continue;
        const std::uint32_t count = block[level];
        block[level] = static_cast<std::uint32_t>(sum);
        sum += count;
      }
      if (sum >= Required_squares::none) throw std::length_error("Balanced_quadtree: too many squares");
      squares.level_begin.push_back(static_cast<std::uint32_t>(sum));
    }
    squares.children.resize(sum);
    squares.point_begin.resize(sum);
  }

  /// What is known of the children of a square.
  struct Children {
    unsigned split; ///< bit q for child q
    std::array<std::uint32_t, 4> point_begin;
  };

  void fill_squares(std::size_t begin, std::size_t end, std::vector<std::uint32_t>& next,
                    Required_squares& squares) const {
    for_each_path(begin, end, [&](const Path& path, std::size_t p, Node_index v) {
      const auto fill = [&](int level, unsigned split, const Children& children) {
        const std::uint32_t i = next[std::size_t(level)]++;
        squares.children[i] = static_cast<std::uint8_t>(split);
        squares.point_begin[i] = children.point_begin;
      };
      const std::uint32_t points_end =
          v.is_valid() ? framework_.points(v).end.value() : static_cast<std::uint32_t>(p + 1);
      for (int level = path.first; level < path.last; ++level) {
        const Children children = only_child(level, static_cast<std::uint32_t>(p), points_end);
        fill(level, children.split, children);
      }
      if (v.is_valid() && path.last == framework_.level(v)) {
        const Children children = children_of_node(v);
        fill(path.last, children.split, children);
      } else { // the path ends before a node for lack of points
        fill(path.last, 0, only_child(path.last, static_cast<std::uint32_t>(p), points_end));
      }
    });
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
    const auto add = [&](const Path& path, Point_rank first) {
      const unsigned q = child_of_point(first.value(), level);
      for (; known <= q; ++known) children.point_begin[known] = first.value();
      if (path.first <= path.last) children.split |= 1u << q;
    };
    framework_.for_each_child(
        v, [&](Node_index child) { add(path(child, level), framework_.points(child).begin); },
        [&](Point_rank r) { add(path(r, level), r); });
    for (; known < 4; ++known) children.point_begin[known] = framework_.points(v).end.value();
    return children;
  }

  unsigned child_of_point(std::uint32_t rank, int level) const {
    return static_cast<unsigned>(quadrant(framework_.grid_point(Point_rank(rank)), level, depth_));
  }

  const Framework& framework_;
  std::size_t max_points_;
  int depth_;
  Indexed_vector<Node_index, int> desired_level_; // if annotations and nodes with few points meet
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_REQUIRED_SQUARES_H
