// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The balanced quadtree of a set of points.
//
// Computes: the smallest quadtree in which no leaf holds more than m points and leaves that share a side or a
// corner
//           differ by at most a factor of two; with cross pointers, and the leaf of every point.
// Bound:    O(n + k) for n points and k squares and words of constant length; as many rounds as there are
// levels. Source:   Bern, Eppstein, Teng, Theorem 1 (paths of the framework), section 3 (forced squares,
// cross pointers),
//           Corollary 1 (points to leaves).
// Deviates: balance is closed level by level, the deepest first, which gives the smallest balanced tree
// instead of one
//           up to four times as large; the paper leaves open whether that can be had in O(log n) rounds.
//           Points are matched to leaves by one merge of two sequences in shuffle order.

#ifndef CGAL_BALANCED_QUADTREE_H
#define CGAL_BALANCED_QUADTREE_H

#include <CGAL/Quadtree_framework.h>
#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/Leaf_neighbors.h>
#include <CGAL/Quadtree_mesh_2/internal/Linked_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/split_squares.h>
#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {

namespace Quadtree_mesh_2 {

/// Leaves that follow each other in shuffle order.
struct Leaf_interval {
  Leaf_index begin;
  Leaf_index end; ///< one past the last

  std::size_t size() const { return end.value() - begin.value(); }
};

} // namespace Quadtree_mesh_2

/// The smallest quadtree that separates points and is balanced across sides and corners (Theorems 1 and 2).
///
/// Nodes are squares, split ones and leaves. They are numbered level by level, in shuffle order within a
/// level; node 0 is the root and four siblings follow each other. Leaves are numbered in shuffle order over
/// all levels, so that the leaves below a node, and the points in it, are intervals. Child `2 i + j` of a
/// node has x offset `i` and y offset `j`.
///
/// Takes O(n + k) time for n points and k squares; about 25 bytes per square besides those of the framework.
/// \tparam Traits_ a model of `QuadtreeTraits_2`.
template <class Traits_>
class Balanced_quadtree {
public:
  using Traits = Traits_;
  using Framework = Quadtree_framework<Traits>;
  using Point_2 = typename Traits::Point_2;
  using Word = typename Traits::Word;
  using Grid_point = Quadtree_mesh_2::Grid_point_2<Word>;
  using Square = Quadtree_mesh_2::Quadtree_square_2<Word>;
  using Direction = Quadtree_mesh_2::Direction;
  using Node_index = Quadtree_mesh_2::Node_index;
  using Leaf_index = Quadtree_mesh_2::Leaf_index;
  using Point_index = Quadtree_mesh_2::Point_index;
  using Point_rank = Quadtree_mesh_2::Point_rank;
  using Rank_interval = Quadtree_mesh_2::Rank_interval;
  using Leaf_interval = Quadtree_mesh_2::Leaf_interval;
  using Leaf_neighbors = Quadtree_mesh_2::Leaf_neighbors;

  /// The quadtree of no points: its root is its only leaf.
  Balanced_quadtree() : Balanced_quadtree(Framework()) {}

  /// Builds the quadtree of `points`. Equal points count once.
  /// \tparam PointRange a random access range with value type `Point_2`.
  /// \param points the points.
  /// \param max_points_per_leaf at least 1.
  /// \param traits makes the grid.
  /// \throws Quadtree_mesh_2::Point_error as the framework does.
  /// \throws std::length_error if there are too many points or squares for 32-bit indices.
  template <class PointRange, class = decltype(std::declval<const PointRange&>().begin())>
  explicit Balanced_quadtree(const PointRange& points, std::size_t max_points_per_leaf = 1,
                             const Traits& traits = Traits())
      : Balanced_quadtree(Framework(points, traits), max_points_per_leaf) {}

  /// Builds the quadtree of the points of a framework, which it keeps.
  explicit Balanced_quadtree(Framework framework, std::size_t max_points_per_leaf = 1)
      : framework_(std::move(framework)) {
    CGAL_precondition(max_points_per_leaf >= 1);
    auto split = Quadtree_mesh_2::internal::crowded_squares(framework_, max_points_per_leaf);
    Quadtree_mesh_2::internal::close_under_balance(split);
    squares_ = Linked_squares(split, Traits::depth);
    list_leaves();
    place_points();
  }

  const Framework& framework() const { return framework_; }

  /// \name Nodes
  /// @{

  std::size_t number_of_nodes() const { return squares_.number_of_nodes(); }
  Node_index root() const { return Node_index(0); }
  /// The level of the smallest squares; 0 if the root is a leaf.
  int depth() const { return squares_.number_of_split_levels(); }

  bool is_leaf(Node_index v) const { return squares_.is_leaf(v); }
  /// Invalid for the root.
  Node_index parent(Node_index v) const { return squares_.parent(v); }
  /// \pre `!is_leaf(v)` and 0 <= `i` < 4
  Node_index child(Node_index v, int i) const {
    CGAL_precondition(!is_leaf(v) && 0 <= i && i < 4);
    return squares_.child(v, i);
  }
  int level(Node_index v) const { return squares_.level(v); }
  Square square(Node_index v) const {
    const Grid_point corner = squares_.corner(v);
    return {corner.x, corner.y, squares_.level(v)};
  }
  /// The lower left, lower right, upper right and upper left corner of the square, rounded only if `Point_2`
  /// cannot represent them.
  std::array<Point_2, 4> corners(Node_index v) const {
    const Grid_point c = squares_.corner(v);
    const Word side = static_cast<Word>(Word(1) << (Traits::depth - level(v)));
    const Word right = static_cast<Word>(c.x + side), top = static_cast<Word>(c.y + side);
    const auto& grid = framework_.grid();
    return {
        {grid.point({c.x, c.y}), grid.point({right, c.y}), grid.point({right, top}), grid.point({c.x, top})}};
  }

  /// Returns the cross pointer of `v`: the node of the same size across a side or a corner, or if there is
  /// none the larger leaf in its place; invalid outside the root. Takes O(1) time.
  Node_index neighbor(Node_index v, Direction d) const { return squares_.neighbor(v, d); }

  /// The leaves in the square of `v`.
  Leaf_interval leaves(Node_index v) const {
    return {Leaf_index(squares_.first_leaf(v)), Leaf_index(squares_.last_leaf(v) + std::size_t(1))};
  }
  /// The points in the square of `v`.
  Rank_interval points(Node_index v) const {
    return {Point_rank(point_begin_[squares_.first_leaf(v)]),
            Point_rank(point_begin_[squares_.last_leaf(v) + std::size_t(1)])};
  }

  /// @}

  /// \name Leaves
  /// @{

  std::size_t number_of_leaves() const { return node_of_leaf_.size(); }
  Node_index node(Leaf_index l) const { return Node_index(node_of_leaf_[std::size_t(l)]); }
  /// \pre `is_leaf(v)`
  Leaf_index leaf(Node_index v) const {
    CGAL_precondition(is_leaf(v));
    return Leaf_index(squares_.leaf(v));
  }
  Square square(Leaf_index l) const { return square(node(l)); }
  int level(Leaf_index l) const { return level(node(l)); }
  std::array<Point_2, 4> corners(Leaf_index l) const { return corners(node(l)); }
  /// The points in a leaf; `framework().input_point()` gives their places in the input.
  Rank_interval points(Leaf_index l) const {
    return {Point_rank(point_begin_[std::size_t(l)]), Point_rank(point_begin_[std::size_t(l) + 1])};
  }

  /// The leaf that contains an input point.
  Leaf_index leaf(Point_index i) const { return leaf(framework_.rank(i)); }
  Leaf_index leaf(Point_rank r) const { return Leaf_index(leaf_of_point_[std::size_t(r)]); }

  /// Returns the leaves that share a side or a corner with `l`, counterclockwise, each once: at most twelve.
  /// Takes O(1) time.
  Leaf_neighbors neighbors(Leaf_index l) const {
    Leaf_neighbors result;
    for (Direction d : Quadtree_mesh_2::all_directions()) append_neighbors(node(l), d, result);
    result.close();
    return result;
  }

  /// @}

  /// \name Location
  /// @{

  /// Returns the leaf that contains `p`, invalid if `p` is outside the root. Takes O(depth) time.
  Leaf_index locate(const Point_2& p) const {
    return framework_.grid().is_in_root(p) ? locate(framework_.grid().grid_point(p)) : Leaf_index();
  }

  /// Returns the leaf that contains a grid point.
  /// \pre coordinates are less than \f$ 2^{depth} \f$
  Leaf_index locate(const Grid_point& p) const {
    Node_index v = root();
    for (int bit = Traits::depth - 1; !is_leaf(v); --bit)
      v = squares_.child(v, static_cast<int>(2 * (p.x >> bit & 1) + (p.y >> bit & 1)));
    return leaf(v);
  }

  /// @}

  /// Checks the links between nodes, that neighbouring leaves differ by at most a factor of two and that
  /// points are in their leaves. Takes O(n + k) time.
  bool is_valid() const {
    for (std::size_t i = 0; i < number_of_nodes(); ++i)
      if (!is_valid(Node_index(i))) return false;
    for (std::size_t r = 0; r < framework_.number_of_points(); ++r)
      if (!contains(square(leaf(Point_rank(r))), framework_.grid_point(Point_rank(r)))) return false;
    return framework_.is_valid();
  }

private:
  bool is_valid(Node_index v) const {
    for (Direction d : Quadtree_mesh_2::all_directions()) {
      const Node_index n = neighbor(v, d);
      if (!n.is_valid()) continue;
      if (level(v) - level(n) > 1 || level(n) > level(v)) return false;
      if (level(n) == level(v) && neighbor(n, opposite(d)) != v) return false;
    }
    if (is_leaf(v)) return node(leaf(v)) == v;
    for (int q = 0; q < 4; ++q)
      if (parent(child(v, q)) != v) return false;
    return true;
  }

  using Linked_squares = Quadtree_mesh_2::internal::Linked_squares<Word>;

  void list_leaves() {
    node_of_leaf_.resize(squares_.number_of_leaves());
    for (std::size_t i = 0; i < number_of_nodes(); ++i)
      if (is_leaf(Node_index(i))) node_of_leaf_[squares_.leaf(Node_index(i))] = static_cast<std::uint32_t>(i);
  }

  /// Matches points and leaves, both in shuffle order.
  void place_points() {
    const std::size_t n = framework_.number_of_points();
    point_begin_.resize(number_of_leaves() + 1);
    leaf_of_point_.resize(n);
    std::size_t p = 0;
    for (std::size_t l = 0; l < number_of_leaves(); ++l) {
      point_begin_[l] = static_cast<std::uint32_t>(p);
      const Square s = square(Leaf_index(l));
      for (; p < n && contains(s, framework_.grid_point(Point_rank(p))); ++p)
        leaf_of_point_[p] = static_cast<std::uint32_t>(l);
    }
    point_begin_.back() = static_cast<std::uint32_t>(p);
    CGAL_assertion(p == n);
  }

  static bool contains(const Square& s, const Grid_point& p) {
    return ((p.x ^ s.x) | (p.y ^ s.y)) >> (Traits::depth - s.level) == 0;
  }

  /// Appends the leaves that touch `v` in direction `d`, counterclockwise.
  void append_neighbors(Node_index v, Direction d, Leaf_neighbors& result) const {
    // Across a side two children touch, across a corner one (and is listed twice).
    static constexpr std::array<std::array<int, 2>, 8> touching{
        {{{0, 1}}, {{0, 0}}, {{2, 0}}, {{2, 2}}, {{3, 2}}, {{3, 3}}, {{1, 3}}, {{1, 1}}}};
    const Node_index n = neighbor(v, d);
    if (!n.is_valid()) return;
    if (is_leaf(n)) {
      result.append(leaf(n));
    } else {
      for (int q : touching[std::size_t(d)]) result.append(leaf(child(n, q))); // by balance these are leaves
    }
  }

  Framework framework_;
  Linked_squares squares_;

  // By leaf; point_begin_ has one more.
  std::vector<std::uint32_t> node_of_leaf_;
  std::vector<std::uint32_t> point_begin_;
  // By rank.
  std::vector<std::uint32_t> leaf_of_point_;
};

} // namespace CGAL

#endif // CGAL_BALANCED_QUADTREE_H
