// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The paper's way to find which leaf of a quadtree contains each of its points.
//
// Computes: for each point of a quadtree's framework the leaf that contains it, from the squares of the tree
//           and the grid points alone.
// Bound:    O(n + k) work for n points and k squares, not counting sorting. O(log n) rounds for each block of
//           n squares. The blocks are independent, but are treated one after another here to save memory.
// Source:   Bern, Eppstein, Teng, section 4, Lemma 4 and Corollary 1. On some levels, about log2 n apart,
//           there are only O(k / log n) squares, S. In blocks of n squares of S, the points have a framework,
//           together with the lower left corner b(s) and the center c(s) of each square s. So s is a node of
//           it. From the squares of S one goes down through the tree, to the next of these levels. On the way
//           one carries the smallest framework square that contains the square reached. At a leaf, the point
//           is among the descendants of that one.
// Deviates: Lemma 4 says that these descendants are O(1). This holds for those in the leaf s: b(s), c(s), and
//           the points of the leaf. Corners and centers of larger squares may coincide with b(s), but with
//           nothing else in s. The framework square itself may be larger than the leaf and hold many points
//           outside. So only its child toward the leaf is taken.
//           Unit squares have no center on the grid. They are leaves. Their level is never in S, and they are
//           reached from above. The root is always in S, because what is above the first level belongs to no
//           other square. The node of a square of S is found by bisection, O(log n) for each of O(k / log n)
//           squares.
//
// This header is here to be compared with. By default points ride down with their squares while the tree
// grows, and there is nothing to locate. It was measured with 10^5 and 10^6 uniform points on one thread. It
// takes 1.0 to 1.2 times as long as growing the whole balanced tree from its framework, points included. It
// takes 4 and 1 to 1.6 times as long as descents from the root (locate_all.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LOCATE_BY_FRAMEWORK_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LOCATE_BY_FRAMEWORK_H

#include <CGAL/Quadtree_framework.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/spaced_levels.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Quadtrees of points that are grid points already. A model of `QuadtreeTraits_2` whose depth is given.
template <class Word_>
class Grid_point_traits_2 {
public:
  using Word = Word_;
  using Grid_point = Grid_point_2<Word>;
  using Point_2 = Grid_point;
  class Meshing_geometry_2;

  /// The identity.
  class Grid_2 {
  public:
    explicit Grid_2(int depth = 1) : depth_(depth) {}
    int depth() const { return depth_; }
    bool refine() { return false; }
    bool is_in_root(const Point_2& p) const { return (p.x >> depth_) == 0 && (p.y >> depth_) == 0; }
    const Grid_point& grid_point(const Point_2& p) const { return p; }
    const Point_2& point(const Grid_point& g) const { return g; }

  private:
    int depth_;
  };

  struct Construct_grid_2 {
    int depth;

    template <class PointRange>
    Grid_2 operator()(const PointRange&) const {
      return Grid_2(depth);
    }
  };

  explicit Grid_point_traits_2(int depth = 1) : depth_(depth) {}
  Construct_grid_2 construct_grid_2_object() const { return {depth_}; }

private:
  int depth_;
};

/// Which levels of a quadtree the squares belong to from which one goes down.
template <class Quadtree>
class Spaced_levels {
public:
  /// Levels `spacing` apart, from the offset with the fewest squares.
  Spaced_levels(const Quadtree& tree, int spacing)
      : spacing_(spacing), grid_depth_(tree.framework().grid().depth()) {
    count_squares(tree);
    offset_ = offset_of_spaced_levels<Sequential_tag>(begin_, spacing);
  }

  bool contains(int level) const {
    return level == 0 || (level % spacing_ == offset_ && level < grid_depth_);
  }

  /// The squares on these levels.
  std::vector<Node_index> squares() const {
    std::vector<Node_index> result;
    for (int level = 0; level < number_of_levels(); ++level)
      if (contains(level))
        for (std::size_t v = begin(level); v < begin(level + 1); ++v) result.push_back(Node_index(v));
    return result;
  }

private:
  int number_of_levels() const { return static_cast<int>(begin_.size()) - 1; }
  std::size_t begin(int level) const { return begin_[std::size_t(level)]; }

  /// Nodes are numbered level by level.
  void count_squares(const Quadtree& tree) {
    const auto is_up_to = [&](std::size_t v, int level) { return tree.level(Node_index(v)) <= level; };
    begin_.push_back(0);
    for (int level = 0; level <= tree.depth(); ++level) {
      std::size_t low = begin_.back(), high = tree.number_of_nodes();
      // Growing steps, so that many small levels cost little.
      for (std::size_t step = 1; step < high - low; step *= 2) {
        if (is_up_to(low + step - 1, level))
          low += step;
        else
          high = low + step - 1;
      }
      while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (is_up_to(middle, level))
          low = middle + 1;
        else
          high = middle;
      }
      begin_.push_back(low);
    }
  }

  int spacing_;
  int grid_depth_;
  int offset_ = 0;
  std::vector<std::size_t> begin_; // the first square of each level
};

/// Locates the points of a quadtree in blocks of squares; see the head of this file.
template <class Quadtree, class ConcurrencyTag>
class Framework_locator {
public:
  explicit Framework_locator(const Quadtree& tree)
      : tree_(tree), depth_(tree.framework().grid().depth()),
        number_of_points_(tree.framework().number_of_points()),
        levels_(tree, spacing_of_levels(number_of_points_)) {}

  /// Returns the leaf of each point, by rank.
  std::vector<Leaf_index> locate() {
    leaves_.assign(number_of_points_, Leaf_index());
    if (number_of_points_ == 0) return std::move(leaves_);
    const std::vector<Node_index> squares = levels_.squares();
    for (std::size_t begin = 0; begin < squares.size(); begin += number_of_points_)
      locate_in_block(&squares[begin], std::min(number_of_points_, squares.size() - begin));
    return std::move(leaves_);
  }

private:
  using Word = typename Quadtree::Word;
  using Grid_point = Grid_point_2<Word>;
  using Traits = Grid_point_traits_2<Word>;
  using Framework = Quadtree_framework<Traits, ConcurrencyTag>;

  /// A square of the tree and the smallest square of the framework that contains it.
  struct Visit {
    Node_index square;
    Node_index around;
  };
  using Visits = Uninitialized_vector<Visit>;
  static constexpr std::size_t visits_in_block_ = default_block / 8;

  void locate_in_block(const Node_index* squares, std::size_t n) {
    const Framework framework(points_and_corners(squares, n), Traits(depth_));
    Visits visits(n);
    for_each_index<ConcurrencyTag>(
        n,
        [&](std::size_t i) {
          const Point_rank corner = framework.rank(Point_index(number_of_points_ + 2 * i));
          visits[i] = {squares[i], node_of_square(framework, corner, tree_.level(squares[i]))};
        },
        visits_in_block_);
    while (!visits.empty()) visits = go_down(framework, visits);
  }

  /// The points by rank, then b(s) and c(s) of each square s.
  std::vector<Grid_point> points_and_corners(const Node_index* squares, std::size_t n) const {
    std::vector<Grid_point> result(number_of_points_ + 2 * n);
    for_each_index<ConcurrencyTag>(
        number_of_points_, [&](std::size_t i) { result[i] = tree_.framework().grid_point(Point_rank(i)); });
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      const auto square = tree_.square(squares[i]);
      const Word half = Word_operations<Word>::power_of_two(depth_ - square.level - 1);
      result[number_of_points_ + 2 * i] = {square.x, square.y};
      result[number_of_points_ + 2 * i + 1] = {static_cast<Word>(square.x + half),
                                               static_cast<Word>(square.y + half)};
    });
    return result;
  }

  /// The node of level `level` whose first point is `first`. Nodes in preorder are sorted by their first
  /// points and then by level.
  static Node_index node_of_square(const Framework& framework, Point_rank first, int level) {
    std::size_t low = 0, high = framework.number_of_nodes();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      const Point_rank begin = framework.points(Node_index(middle)).begin;
      if (begin < first || (begin == first && framework.level(Node_index(middle)) < level))
        low = middle + 1;
      else
        high = middle;
    }
    CGAL_assertion(framework.points(Node_index(low)).begin == first);
    CGAL_assertion(framework.level(Node_index(low)) == level);
    return Node_index(low);
  }

  /// Reads off the points of leaves; returns the children of the others but those from which one has begun.
  Visits go_down(const Framework& framework, const Visits& visits) {
    for_each_index<ConcurrencyTag>(
        visits.size(),
        [&](std::size_t i) {
          if (tree_.is_leaf(visits[i].square)) read_off_points(framework, visits[i]);
        },
        visits_in_block_);
    const std::vector<std::uint32_t> split = pack<ConcurrencyTag>(visits.size(), [&](std::size_t i) {
      const Node_index v = visits[i].square;
      return !tree_.is_leaf(v) && !levels_.contains(tree_.level(v) + 1);
    });
    Visits next(4 * split.size());
    for_each_index<ConcurrencyTag>(
        split.size(),
        [&](std::size_t i) {
          for (int q = 0; q < 4; ++q)
            next[4 * i + std::size_t(q)] = visit_child(framework, visits[split[i]], q);
        },
        visits_in_block_);
    return next;
  }

  /// The smallest framework square around a child is the child itself or the one around the parent.
  Visit visit_child(const Framework& framework, const Visit& parent, int q) const {
    const Node_index child = tree_.child(parent.square, q);
    const auto square = tree_.square(child);
    Visit result{child, parent.around};
    framework.for_each_child(
        parent.around,
        [&](Node_index v) {
          if (framework.level(v) == square.level && contains(square, first_point(framework, v)))
            result.around = v;
        },
        [](Point_rank) {});
    return result;
  }

  /// Lemma 4. What the leaf holds of the framework is the square around it or a child of that one.
  void read_off_points(const Framework& framework, const Visit& leaf) {
    const auto square = tree_.square(leaf.square);
    const auto read_off = [&](Point_rank begin, Point_rank end) {
      for (Point_rank r = begin; r < end; ++r) {
        const Point_index i = framework.input_point(r);
        if (i.value() < number_of_points_) leaves_[i.value()] = tree_.leaf(leaf.square);
      }
    };
    const auto read_off_node = [&](Node_index v) {
      const Rank_interval inside = framework.points(v);
      CGAL_assertion(inside.size() <= 2 + tree_.points(leaf.square).size()); // b(s), c(s)
      read_off(inside.begin, inside.end);
    };
    if (framework.level(leaf.around) == square.level) return read_off_node(leaf.around);
    framework.for_each_child(
        leaf.around,
        [&](Node_index v) {
          if (framework.level(v) > square.level && contains(square, first_point(framework, v)))
            read_off_node(v);
        },
        [&](Point_rank r) {
          if (contains(square, framework.grid_point(r))) read_off(r, Point_rank(r.value() + std::size_t(1)));
        });
  }

  static const Grid_point& first_point(const Framework& framework, Node_index v) {
    return framework.grid_point(framework.points(v).begin);
  }

  bool contains(const Quadtree_square_2<Word>& square, const Grid_point& p) const {
    return corner_of_square(p, square.level, depth_) == Grid_point{square.x, square.y};
  }

  const Quadtree& tree_;
  int depth_;
  std::size_t number_of_points_;
  Spaced_levels<Quadtree> levels_;
  std::vector<Leaf_index> leaves_; // by rank
};

/// Returns the leaf of each point of a quadtree, by rank: the same as its `leaf(Point_rank)`.
template <class ConcurrencyTag, class Quadtree>
std::vector<Leaf_index> locate_by_framework(const Quadtree& tree) {
  return Framework_locator<Quadtree, ConcurrencyTag>(tree).locate();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LOCATE_BY_FRAMEWORK_H
