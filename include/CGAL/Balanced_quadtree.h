// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The quadtree of a set of points, balanced and cross-linked.
//
// Computes: the smallest quadtree with three properties. No leaf holds more than m points. No leaf is larger
//           than a size function or the points' annotations ask for. Neighboring leaves differ by at most a
//           factor of two. Also cross pointers, and the leaf of every point.
// Bound:    O(n + k) work for n points and k squares, not counting sorting. There are as many rounds as levels, or
//           O(log n) with spaced levels, by O(n log n + k) work.
// Source:   Bern, Eppstein, Teng, Theorems 1 and 2, section 3 (forced squares, cross pointers), Corollary 1
//           (points to leaves).
// Deviates: squares that balance forces are known as a set of directions for each required square, from the
//           deepest level up (forcing.h) or in a closed form (closed_forced_directions.h). This gives the smallest
//           balanced tree, whose O(log n) rounds the paper asks for; its own tree is up to four times as large.
//           Points move down with their squares instead of being located afterward.

#ifndef CGAL_BALANCED_QUADTREE_H
#define CGAL_BALANCED_QUADTREE_H

#include <CGAL/Quadtree_framework.h>
#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/Leaf_neighbors.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Linked_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Required_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Spaced_levels_grower.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Square_grower.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/forcing.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/locate_all.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/near_neighbors.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/required_by_marks.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/required_by_size.h>
#include <CGAL/Quadtree_options.h>
#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {

namespace Quadtree_mesh_2 {

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Leaves that follow each other in shuffle order.
struct Leaf_interval {
  Leaf_index begin; ///< the first leaf
  Leaf_index end;   ///< one past the last

  /// The number of leaves.
  std::size_t size() const { return end.value() - begin.value(); }
};

} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// The smallest quadtree that separates points and is balanced (Theorems 1 and 2).
///
/// Nodes are squares, either split or leaves. They are numbered level by level, in shuffle order within a
/// level. Node 0 is the root, and four siblings follow each other. Child `2 i + j` of a node has x offset `i`
/// and y offset `j`. Leaves are numbered in shuffle order over all levels. So the leaves below a node, and
/// the points in it, are intervals.
///
/// Takes O(n + k) time for n points and k squares, not counting sorting, and about 25 bytes per square besides
/// those of the framework. The result is the same for any number of threads.
/// \tparam Traits_ a model of `QuadtreeTraits_2`.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`.
template <class Traits_, class ConcurrencyTag = Sequential_tag>
class Balanced_quadtree {
public:
  /// \name Types
  /// @{

  /// The traits.
  using Traits = Traits_;
  /// The framework from which the tree is made.
  using Framework = Quadtree_framework<Traits, ConcurrencyTag>;
  /// A point of the input.
  using Point_2 = typename Traits::Point_2;
  /// A grid coordinate.
  using Word = typename Traits::Word;
  /// A point of the grid.
  using Grid_point = Quadtree_mesh_2::Grid_point_2<Word>;
  /// A square of the grid.
  using Square = Quadtree_mesh_2::Quadtree_square_2<Word>;
  /// A side or a corner of a square.
  using Direction = Quadtree_mesh_2::Direction;
  /// Names a square, be it a leaf or split.
  using Node_index = Quadtree_mesh_2::Node_index;
  /// Names a leaf, in shuffle order.
  using Leaf_index = Quadtree_mesh_2::Leaf_index;
  /// Names a point, in the order of the input.
  using Point_index = Quadtree_mesh_2::Point_index;
  /// Names a point, in shuffle order.
  using Point_rank = Quadtree_mesh_2::Point_rank;
  /// The points of a square, which follow each other in shuffle order.
  using Rank_interval = Quadtree_mesh_2::Rank_interval;
  /// Leaves that follow each other in shuffle order.
  using Leaf_interval = Quadtree_mesh_2::Leaf_interval;
  /// The leaves around a leaf.
  using Leaf_neighbors = Quadtree_mesh_2::Leaf_neighbors;
  /// @}

  /// The quadtree of no points: its root is its only leaf.
  Balanced_quadtree() : Balanced_quadtree(Framework()) {}

  /// Builds the quadtree of `points`. Equal points count once. Takes O(log n) rounds with
  /// `Balance_schedule::SPACED_LEVELS`.
  /// \tparam PointRange a random access range with value type `Point_2`; several threads may read it.
  /// \throws Quadtree_mesh_2::Point_error as the framework does.
  /// \throws std::length_error if there are too many points or squares for 32-bit indices.
  template <class PointRange, class = decltype(std::declval<const PointRange&>().begin())>
  explicit Balanced_quadtree(const PointRange& points, const Quadtree_options& options = Quadtree_options(),
                             const Traits& traits = Traits())
      : Balanced_quadtree(Framework(points, traits), options) {}

  /// Builds the quadtree of the points of a framework, and keeps the framework. Follows the annotations of
  /// points.
  explicit Balanced_quadtree(Framework framework, const Quadtree_options& options = Quadtree_options())
      : framework_(std::move(framework)), options_(options) {
    CGAL_precondition(options.max_points_per_leaf() >= 1);
    namespace internal = Quadtree_mesh_2::internal;
    const Required_squares required = internal::Required_squares_finder<Framework, ConcurrencyTag>(
                                          framework_, options.max_points_per_leaf())
                                          .find();
    if (options.schedule() == Quadtree_mesh_2::Balance_schedule::SPACED_LEVELS &&
        options.balance() != Quadtree_mesh_2::Balance::NONE)
      squares_ =
          internal::Spaced_levels_grower<Framework, ConcurrencyTag>(framework_, required, options.balance())
              .grow();
    else
      squares_ = smallest_squares(required);
  }

  /// Builds a quadtree whose leaves are as small as a predicate wants them, and balances it. Always works
  /// level by level, whatever the options say.
  /// \tparam Must_split called as `must_split(lower_left, upper_right)` with the corners of a square, two
  /// `Point_2`. Returns whether to split the square. It is called for the root and for the children of all
  /// squares that have to be split, maybe by several threads at the same time. A square of one grid unit is
  /// never split.
  template <class Must_split, class = decltype(bool(std::declval<const Must_split&>()(
                                  std::declval<const Point_2&>(), std::declval<const Point_2&>())))>
  Balanced_quadtree(Framework framework, const Quadtree_options& options, const Must_split& must_split)
      : framework_(std::move(framework)), options_(options) {
    CGAL_precondition(options.max_points_per_leaf() >= 1);
    squares_ = smallest_squares(
        Quadtree_mesh_2::internal::Sized_squares_finder<Framework, Must_split, ConcurrencyTag>(
            framework_, options.max_points_per_leaf(), must_split)
            .find());
  }

  /// \cond SKIP_IN_MANUAL
  /// Builds the smallest balanced quadtree in which given squares are split. Always works level by level. Its squares
  /// may be larger than the points and the options of the framework want them.
  Balanced_quadtree(Framework framework, const Quadtree_options& options,
                    const Quadtree_mesh_2::internal::Required_squares& required)
      : framework_(std::move(framework)), options_(options), squares_(smallest_squares(required)) {}
  /// \endcond

  /// Builds the quadtree of points with leaves as small as a predicate wants them.
  template <class PointRange, class Must_split, class = decltype(std::declval<const PointRange&>().begin()),
            class = decltype(bool(std::declval<const Must_split&>()(std::declval<const Point_2&>(),
                                                                    std::declval<const Point_2&>())))>
  Balanced_quadtree(const PointRange& points, const Quadtree_options& options, const Must_split& must_split,
                    const Traits& traits = Traits())
      : Balanced_quadtree(Framework(points, traits), options, must_split) {}

  /// The framework of the points.
  const Framework& framework() const { return framework_; }
  /// The options it was built with.
  const Quadtree_options& options() const { return options_; }

  /// \name Changes
  /// @{

  /// Splits leaves and restores balance, with as few further splits as possible. All nodes and leaves are
  /// numbered anew. Takes O(n + k) time however few leaves are split, so collect them. Always works level by
  /// level, whatever the options say.
  /// \tparam LeafRange a range with value type `Leaf_index`; repetitions count once.
  /// \pre no leaf is a square of one grid unit
  template <class LeafRange>
  void refine(const LeafRange& leaves) {
    std::vector<bool> is_marked(number_of_leaves(), false);
    for (const Leaf_index l : leaves) {
      CGAL_precondition(level(l) < framework_.grid().depth());
      is_marked[std::size_t(l)] = true;
    }
    squares_ = smallest_squares(Quadtree_mesh_2::internal::required_by_marks<ConcurrencyTag>(
        squares_, [&](Node_index v) { return is_marked[std::size_t(leaf(v))]; }));
  }

  /// @}

  /// \name Nodes
  /// @{

  /// The number of squares: split ones and leaves.
  std::size_t number_of_nodes() const { return squares_.number_of_nodes(); }
  /// The root, node 0.
  Node_index root() const { return Node_index(0); }
  /// The level of the smallest squares; 0 if the root is a leaf.
  int depth() const { return squares_.number_of_split_levels(); }

  /// Whether `v` is not split.
  bool is_leaf(Node_index v) const { return squares_.is_leaf(v); }
  /// The parent of `v`; invalid for the root.
  Node_index parent(Node_index v) const { return squares_.parent(v); }
  /// Child `i` of `v`.
  /// \pre `!is_leaf(v)` and 0 <= `i` < 4
  Node_index child(Node_index v, int i) const {
    CGAL_precondition(!is_leaf(v) && 0 <= i && i < 4);
    return squares_.child(v, i);
  }
  /// The level of `v`, 0 for the root.
  int level(Node_index v) const { return squares_.level(v); }
  /// The square of `v` in the grid.
  Square square(Node_index v) const {
    const Grid_point corner = squares_.corner(v);
    return {corner.x, corner.y, squares_.level(v)};
  }
  /// The lower left, lower right, upper right and upper left corners of the square. They are rounded only if
  /// `Point_2` cannot represent them.
  std::array<Point_2, 4> corners(Node_index v) const {
    const Grid_point c = squares_.corner(v);
    const Word side =
        Quadtree_mesh_2::internal::Word_operations<Word>::power_of_two(framework_.grid().depth() - level(v));
    const Word right = static_cast<Word>(c.x + side), top = static_cast<Word>(c.y + side);
    const auto& grid = framework_.grid();
    return {
        {grid.point({c.x, c.y}), grid.point({right, c.y}), grid.point({right, top}), grid.point({c.x, top})}};
  }

  /// Returns the cross pointer of `v`: the node of the same size across a side or a corner. If there is none,
  /// it is the larger leaf in its place. Invalid outside the root. Takes O(1) time.
  Node_index neighbor(Node_index v, Direction d) const { return squares_.neighbor(v, d); }

  /// The leaves in the square of `v`.
  Leaf_interval leaves(Node_index v) const {
    return {Leaf_index(squares_.first_leaf(v)), Leaf_index(squares_.last_leaf(v) + std::size_t(1))};
  }
  /// The points in the square of `v`.
  Rank_interval points(Node_index v) const {
    return {Point_rank(squares_.point_begin(v)), Point_rank(point_end(squares_.last_leaf(v)))};
  }

  /// Calls `visit(v)` for the nodes of the subtree of `top` in preorder, children in shuffle order. Continues
  /// with the children of a node if `visit` returns `true`.
  template <class Visit>
  void traverse(Visit visit, Node_index top) const {
    std::vector<Node_index> open(1, top);
    while (!open.empty()) {
      const Node_index v = open.back();
      open.pop_back();
      if (!visit(v) || is_leaf(v)) continue;
      for (int q = 4; q-- > 0;) open.push_back(child(v, q));
    }
  }
  /// Traverses the whole tree.
  template <class Visit>
  void traverse(Visit visit) const {
    traverse(visit, root());
  }

  /// @}

  /// \name Leaves
  /// @{

  /// The number of leaves.
  std::size_t number_of_leaves() const { return squares_.number_of_leaves(); }
  /// The node of a leaf.
  Node_index node(Leaf_index l) const { return squares_.node_of_leaf(l.value()); }
  /// The leaf of a node.
  /// \pre `is_leaf(v)`
  Leaf_index leaf(Node_index v) const {
    CGAL_precondition(is_leaf(v));
    return Leaf_index(squares_.leaf(v));
  }
  /// The square of a leaf in the grid.
  Square square(Leaf_index l) const { return square(node(l)); }
  /// The level of a leaf.
  int level(Leaf_index l) const { return level(node(l)); }
  /// The corners of a leaf, in the order of `corners(Node_index)`.
  std::array<Point_2, 4> corners(Leaf_index l) const { return corners(node(l)); }
  /// The points in a leaf; `framework().input_point()` gives their indices in the input.
  Rank_interval points(Leaf_index l) const {
    return {Point_rank(squares_.point_begin(node(l))), Point_rank(point_end(l.value()))};
  }

  /// The leaf that contains an input point.
  Leaf_index leaf(Point_index i) const { return leaf(framework_.rank(i)); }
  /// The leaf that contains the point of rank `r`.
  Leaf_index leaf(Point_rank r) const { return Leaf_index(squares_.leaf_of_point(r.value())); }

  /// Returns the leaves that share a side or a corner with `l`, counterclockwise, each once. There are at
  /// most twelve. Takes O(1) time if the quadtree is balanced across corners.
  /// \pre the quadtree is balanced
  Leaf_neighbors neighbors(Leaf_index l) const {
    CGAL_precondition(options_.balance() != Quadtree_mesh_2::Balance::NONE);
    Leaf_neighbors result;
    for (Direction d : Quadtree_mesh_2::all_directions()) {
      const Node_index n = neighbor(node(l), d);
      if (n.is_valid()) append_touching(n, d, result);
    }
    result.close();
    return result;
  }

  /// @}

  /// \name Location and near neighbors
  /// @{

  /// Returns the leaf that contains `p`, invalid if `p` is outside the root. Takes O(depth) time.
  Leaf_index locate(const Point_2& p) const {
    return framework_.grid().is_in_root(p) ? locate(framework_.grid().grid_point(p)) : Leaf_index();
  }

  /// Returns the leaf that contains a grid point.
  /// \pre coordinates are less than 2^depth
  Leaf_index locate(const Grid_point& p) const {
    Node_index v = root();
    for (int level = 0; !is_leaf(v); ++level)
      v = squares_.child(v, Quadtree_mesh_2::internal::quadrant(p, level, framework_.grid().depth()));
    return leaf(v);
  }

  /// Returns the leaf of each of many points; invalid for points outside the root. Takes O(depth) time for
  /// each.
  /// \tparam PointRange a random access range with value type `Point_2`; several threads may read it.
  template <class PointRange>
  std::vector<Leaf_index> locate_all(const PointRange& queries) const {
    return Quadtree_mesh_2::internal::locate_all<ConcurrencyTag>(*this, queries);
  }

  /// Returns a point at most 1.6284 times as far from the point of rank `r` as its nearest neighbor. It
  /// searches O(1) squares around the point. Invalid if there is no other point. Distances are those of grid
  /// points. If the traits round points to the grid, the distance may be larger by a few grid units.
  /// \pre the quadtree is balanced across sides and corners
  Point_rank near_neighbor(Point_rank r) const {
    CGAL_precondition(options_.balance() == Quadtree_mesh_2::Balance::SIDES_AND_CORNERS);
    return Quadtree_mesh_2::internal::near_neighbor(*this, r);
  }
  /// Returns a near neighbor of each point, by rank.
  /// \pre the quadtree is balanced across sides and corners
  std::vector<Point_rank> near_neighbors() const {
    CGAL_precondition(options_.balance() == Quadtree_mesh_2::Balance::SIDES_AND_CORNERS);
    return Quadtree_mesh_2::internal::near_neighbors<ConcurrencyTag>(*this);
  }

  /// @}

  /// Checks the links between nodes, that neighboring leaves differ by at most a factor of two, and that
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
      if (level(n) > level(v) || (is_balanced_across(d) && level(n) < level(v) - 1)) return false;
      if (level(n) == level(v) && neighbor(n, opposite(d)) != v) return false;
    }
    if (is_leaf(v)) return node(leaf(v)) == v;
    for (int q = 0; q < 4; ++q)
      if (parent(child(v, q)) != v) return false;
    return true;
  }

  bool is_balanced_across(Direction d) const {
    using Quadtree_mesh_2::Balance;
    return options_.balance() == Balance::SIDES_AND_CORNERS ||
           (options_.balance() == Balance::SIDES && !Quadtree_mesh_2::is_diagonal(d));
  }

  using Linked_squares = Quadtree_mesh_2::internal::Linked_squares<Word>;
  using Required_squares = Quadtree_mesh_2::internal::Required_squares;

  /// The smallest balanced quadtree with the required squares.
  Linked_squares smallest_squares(const Required_squares& required) const {
    namespace internal = Quadtree_mesh_2::internal;
    const auto forced = internal::least_forced_directions<ConcurrencyTag>(required, options_.balance());
    return internal::Square_grower<Framework, ConcurrencyTag>(framework_, required, forced).grow();
  }

  /// Leaves are in shuffle order, so the points of the next leaf follow.
  std::size_t point_end(std::uint32_t leaf) const {
    const std::uint32_t next = leaf + 1;
    return next < number_of_leaves() ? squares_.point_begin(squares_.node_of_leaf(next))
                                     : framework_.number_of_points();
  }

  bool contains(const Square& s, const Grid_point& p) const {
    return Quadtree_mesh_2::internal::level_of_derived_square(p, {s.x, s.y}, framework_.grid().depth()) >=
           s.level;
  }

  /// Appends the leaves in `v` that touch its neighbor in direction `opposite(d)`, counterclockwise around
  /// that neighbor.
  void append_touching(Node_index v, Direction d, Leaf_neighbors& result) const {
    if (is_leaf(v)) return result.append(leaf(v));
    // Across a side two children touch, across a corner one.
    static constexpr std::array<std::array<int, 2>, 8> touching{
        {{{0, 1}}, {{0, 0}}, {{2, 0}}, {{2, 2}}, {{3, 2}}, {{3, 3}}, {{1, 3}}, {{1, 1}}}};
    append_touching(child(v, touching[std::size_t(d)][0]), d, result);
    if (!is_diagonal(d)) append_touching(child(v, touching[std::size_t(d)][1]), d, result);
  }

  Framework framework_;
  Quadtree_options options_;
  Linked_squares squares_;
};

} // namespace CGAL

#endif // CGAL_BALANCED_QUADTREE_H
