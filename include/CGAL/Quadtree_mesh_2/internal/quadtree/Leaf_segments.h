// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The segments that meet each leaf of a quadtree.
//
// Computes: for each leaf the segments that meet it, by increasing index, and maybe some that pass it within
//           a unit of the grid.
// Bound:    O(n + m + c) work, not counting sorting, for n points, m segments and c pairs of a leaf and a
//           segment that meets it. The leaves that a segment meets pay for its climb, because leaves are
//           balanced.
// Source:   Bern, Eppstein, Teng, section 7: "we can simply walk from one end of each edge to the other,
//           keeping track of the crossed squares".
// Deviates: segments are independent of each other, so all walk at the same time, and twice: to count and to
//           place. A segment does not go from leaf to leaf. By cross pointers it visits the at most four
//           squares around one of its ends that are no smaller than itself, and goes down into the leaves
//           that it meets. That needs no leaving point, so corners and sides of squares are no special cases.
//
// Everything happens on the grid. An input point is less than one unit above and to the right of its grid
// point. So if a point of the segment lies in a square [x, x') x [y, y'), the segment between the grid points
// meets the open rectangle (x - 1, x') x (y - 1, y').

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LEAF_SEGMENTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LEAF_SEGMENTS_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Wide_integer.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/radix_sort.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Signed integers for coordinates of squares, and for products of two of them.
template <class Word, bool = std::is_integral<Word>::value>
struct Signed_grid {
  using Coordinate = std::int64_t;
  using Product = Wide_integer;
};
template <class Word>
struct Signed_grid<Word, false> {
  using Coordinate = Word;
  using Product = Word;
};

/// A segment between the grid points of its ends.
template <class Word>
class Grid_segment {
public:
  using Coordinate = typename Signed_grid<Word>::Coordinate;
  using Product = typename Signed_grid<Word>::Product;

  Grid_segment(const Grid_point_2<Word>& a, const Grid_point_2<Word>& b)
      : a_{{Coordinate(a.x), Coordinate(a.y)}}, b_{{Coordinate(b.x), Coordinate(b.y)}} {}

  Coordinate low(std::size_t axis) const { return std::min(a_[axis], b_[axis]); }
  Coordinate high(std::size_t axis) const { return std::max(a_[axis], b_[axis]); }

  /// Whether the segment between the input points may meet a square.
  bool may_meet(const Grid_point_2<Word>& corner, const Coordinate& side) const {
    const Coordinate x = Coordinate(corner.x), y = Coordinate(corner.y);
    if (high(0) < x || low(0) >= x + side || high(1) < y || low(1) >= y + side) return false;
    const Coordinate dx = b_[0] - a_[0], dy = b_[1] - a_[1];
    if (dx == 0 || dy == 0) return true;
    // The corners furthest to either side of the line, relative to an end.
    const Coordinate left = x - 1 - a_[0], right = x + side - a_[0], bottom = y - 1 - a_[1],
                     top = y + side - a_[1];
    const Coordinate &x_of_most = dy > 0 ? left : right, &x_of_least = dy > 0 ? right : left;
    const Coordinate &y_of_most = dx > 0 ? top : bottom, &y_of_least = dx > 0 ? bottom : top;
    return Product(dx) * y_of_most > Product(dy) * x_of_most &&
           Product(dx) * y_of_least < Product(dy) * x_of_least;
  }

private:
  std::array<Coordinate, 2> a_, b_;
};

/// Lists of segments, leaf by leaf.
class Leaf_segments {
public:
  struct Range {
    const Segment_index* first;
    const Segment_index* last;
    const Segment_index* begin() const { return first; }
    const Segment_index* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };

  /// Of no leaves.
  Leaf_segments() : begin_(1) {}

  Range operator[](Leaf_index l) const {
    return {segments_.data() + begin_[l.value()], segments_.data() + begin_[l.value() + std::size_t(1)]};
  }
  /// The sum of the lengths of the lists.
  std::size_t size() const { return segments_.size(); }

  /// Lists the segments of a graph whose vertices are the points of a tree.
  /// \throws std::length_error if the lists have 2^32 members or more in all.
  template <class ConcurrencyTag, class Tree, class Segments>
  static Leaf_segments of(const Tree& tree, const Segments& segments) {
    using Key = std::uint64_t;
    std::vector<Key> keys; // the leaf, then the segment
    count_allocate_and_place<ConcurrencyTag>(
        segments.size(),
        [&](std::size_t begin, std::size_t end) {
          std::size_t n = 0;
          for (std::size_t s = begin; s < end; ++s)
            for_each_leaf(tree, segments[s], [&](Leaf_index) { ++n; });
          return n;
        },
        [&](std::size_t n) {
          if (n >= std::size_t(0xffffffffu)) throw std::length_error("too many segments in quadtree leaves");
          keys.resize(n);
        },
        [&](std::size_t begin, std::size_t end, std::size_t place) {
          for (std::size_t s = begin; s < end; ++s)
            for_each_leaf(tree, segments[s],
                          [&](Leaf_index l) { keys[place++] = Key(l.value()) << 32 | Key(s); });
        },
        block_of_segments);
    sort_words<ConcurrencyTag>(keys.data(), uncleared_words(keys.size()).get(), keys.size(), true);
    return Leaf_segments(ConcurrencyTag(), keys, tree.number_of_leaves());
  }

private:
  static constexpr std::size_t block_of_segments = 256;

  template <class ConcurrencyTag>
  Leaf_segments(ConcurrencyTag, const std::vector<std::uint64_t>& keys, std::size_t number_of_leaves)
      : begin_(number_of_leaves + 1), segments_(keys.size()) {
    const std::size_t n = keys.size();
    for_each_index<ConcurrencyTag>(
        n, [&](std::size_t i) { segments_[i] = Segment_index(keys[i] & 0xffffffffu); });
    // The lists of all leaves after the one of key i - 1, up to that of key i, begin at i.
    for_each_index<ConcurrencyTag>(n + 1, [&](std::size_t i) {
      const std::size_t first = i == 0 ? 0 : static_cast<std::size_t>(keys[i - 1] >> 32) + 1;
      const std::size_t last = i == n ? number_of_leaves : static_cast<std::size_t>(keys[i] >> 32);
      for (std::size_t l = first; l <= last; ++l) begin_[l] = static_cast<std::uint32_t>(i);
    });
  }

  /// Calls `f(leaf)` for each leaf that the segment may meet, once.
  template <class Tree, class Segment, class F>
  static void for_each_leaf(const Tree& tree, const Segment& ends, const F& f) {
    const auto& framework = tree.framework();
    const auto rank = framework.rank(Point_index(ends[0].value()));
    const Grid_segment<typename Tree::Word> segment(
        framework.grid_point(rank), framework.grid_point(framework.rank(Point_index(ends[1].value()))));
    Walk<Tree, F> walk{tree, segment, f};
    walk.run(tree.node(tree.leaf(rank)));
  }

  template <class Tree, class F>
  struct Walk {
    using Word = typename Tree::Word;
    using Coordinate = typename Grid_segment<Word>::Coordinate;

    const Tree& tree;
    const Grid_segment<Word>& segment;
    const F& f;

    Coordinate side(int level) const {
      return Coordinate(Word_operations<Word>::power_of_two(tree.framework().grid().depth() - level));
    }

    /// \param v a leaf with an end of the segment.
    void run(Node_index v) const {
      const Coordinate x = segment.high(0) - segment.low(0), y = segment.high(1) - segment.low(1);
      const Coordinate extent = std::max(x, y);
      while (v != tree.root() && side(tree.level(v)) <= extent + 1) v = tree.parent(v);
      const auto s = tree.square(v);
      const Coordinate a = side(s.level);
      const std::array<Coordinate, 2> low{{Coordinate(s.x), Coordinate(s.y)}};
      std::array<Node_index, 4> starts;
      std::size_t n = 0;
      for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy) {
          if (!reaches(0, dx, low[0], a) || !reaches(1, dy, low[1], a)) continue;
          const Node_index w = dx == 0 && dy == 0 ? v : tree.neighbor(v, direction(dx, dy));
          // A larger leaf may be in the place of several squares.
          if (!w.is_valid() || std::find(starts.begin(), starts.begin() + n, w) != starts.begin() + n)
            continue;
          starts[n++] = w;
        }
      for (std::size_t i = 0; i < n; ++i) {
        const auto t = tree.square(starts[i]);
        descend(starts[i], {t.x, t.y}, t.level);
      }
    }

    /// Whether the segment may have points below, in or above the interval of side `a` from `low` on.
    bool reaches(std::size_t axis, int step, const Coordinate& low, const Coordinate& a) const {
      return step < 0 ? segment.low(axis) < low : step > 0 ? segment.high(axis) + 1 >= low + a : true;
    }

    void descend(Node_index v, Grid_point_2<Word> corner, int level) const {
      if (!segment.may_meet(corner, side(level))) return;
      if (tree.is_leaf(v)) return f(tree.leaf(v));
      const int log_side = tree.framework().grid().depth() - level - 1;
      for (int q = 0; q < 4; ++q) {
        Grid_point_2<Word> c = corner;
        move_to_child(c, q, log_side);
        descend(tree.child(v, q), c, level + 1);
      }
    }
  };

  std::vector<std::uint32_t> begin_; // for each leaf, and the end
  std::vector<Segment_index> segments_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LEAF_SEGMENTS_H
