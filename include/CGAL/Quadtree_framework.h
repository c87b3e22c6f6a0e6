// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The framework of a set of points: the quadtree without empty leaves and without paths of single children.
//
// Computes: the points in shuffle order; all squares of which more than one child holds points, with their
// nesting. Bound:    O(n) for words of constant length, whatever the depth: n distinct points have at most n
// - 1 squares. Source:   Bern, Eppstein, Teng, section 2, Lemmas 1-3 and the first half of Theorem 1. A
// square is derived from each
//           pair of neighbours in the order; its parent is the smaller of the nearest larger squares to
//           either side.
// Deviates: sequential, so the nearest larger squares come from a stack; squares derived more than once are
// merged on
//           the stack. Equal points, which the paper excludes, are merged and reported.

#ifndef CGAL_QUADTREE_FRAMEWORK_H
#define CGAL_QUADTREE_FRAMEWORK_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/nesting.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {

namespace Quadtree_mesh_2 {

struct Rank_tag {};
/// Place of a point in the shuffle order of the distinct points.
using Point_rank = Index<Rank_tag>;

/// Points that follow each other in shuffle order.
struct Rank_interval {
  Point_rank begin;
  Point_rank end; ///< one past the last

  std::size_t size() const { return end.value() - begin.value(); }
  friend bool operator==(const Rank_interval& a, const Rank_interval& b) {
    return a.begin == b.begin && a.end == b.end;
  }
};

/// A point of the input that equals an earlier one and was merged with it.
struct Duplicate_point {
  Point_index kept;
  Point_index duplicate;
};

} // namespace Quadtree_mesh_2

/// The framework \f$ T_F \f$ of a set of points (Theorem 1).
///
/// Nodes are the squares that have at least two nonempty children, in preorder with children in shuffle
/// order; the root of the framework is the smallest square that contains all points. A child is a node or,
/// where it holds a single point, that point. Every node holds an interval of the points in shuffle order
/// (Lemma 1).
///
/// Takes O(n) time for n points, independent of the depth; about 50 bytes per point.
/// \tparam Traits_ a model of `QuadtreeTraits_2`.
template <class Traits_>
class Quadtree_framework {
public:
  using Traits = Traits_;
  using Point_2 = typename Traits::Point_2;
  using Grid_2 = typename Traits::Grid_2;
  using Word = typename Traits::Word;
  using Grid_point = Quadtree_mesh_2::Grid_point_2<Word>;
  using Square = Quadtree_mesh_2::Quadtree_square_2<Word>;
  using Node_index = Quadtree_mesh_2::Node_index;
  using Point_index = Quadtree_mesh_2::Point_index;
  using Point_rank = Quadtree_mesh_2::Point_rank;
  using Rank_interval = Quadtree_mesh_2::Rank_interval;
  using Duplicate_point = Quadtree_mesh_2::Duplicate_point;

  /// The framework of no points.
  Quadtree_framework() = default;

  /// Builds the framework of `points`.
  /// \tparam PointRange a random access range with value type `Point_2`.
  /// \throws Quadtree_mesh_2::Point_error if the traits cannot map a point to the grid, or map two distinct
  /// ones to
  ///         the same grid point.
  /// \throws std::length_error if there are \f$ 2^{32} - 1 \f$ points or more.
  template <class PointRange>
  explicit Quadtree_framework(const PointRange& points, const Traits& traits = Traits())
      : grid_(traits.construct_grid_2_object()(points)) {
    sort_points(points);
    build_nodes();
    hang_points();
  }

  /// The map between points and the grid.
  const Grid_2& grid() const { return grid_; }

  /// \name Points
  /// @{

  std::size_t number_of_input_points() const { return rank_.size(); }
  /// The number of distinct points.
  std::size_t number_of_points() const { return points_.size(); }
  /// The points that were merged with an earlier one, in shuffle order and by increasing index.
  const std::vector<Duplicate_point>& duplicates() const { return duplicates_; }

  const Grid_point& grid_point(Point_rank r) const { return points_[std::size_t(r)]; }
  /// The input point of rank `r`, the first one given if there are several equal ones.
  Point_index input_point(Point_rank r) const { return Point_index(input_[std::size_t(r)]); }
  /// The rank of an input point; equal points have the same rank.
  Point_rank rank(Point_index i) const { return Point_rank(rank_[std::size_t(i)]); }
  /// The smallest node that contains the point; invalid if there is only one point.
  Node_index node(Point_rank r) const { return Node_index(node_of_point_[std::size_t(r)]); }

  /// @}

  /// \name Nodes
  /// @{

  std::size_t number_of_nodes() const { return level_.size(); }
  /// The smallest square that contains all points; invalid if there are fewer than two points.
  Node_index root() const { return level_.empty() ? Node_index() : Node_index(0); }

  Square square(Node_index v) const {
    const std::size_t i(v);
    return {corner_[i].x, corner_[i].y, level_[i]};
  }
  int level(Node_index v) const { return level_[std::size_t(v)]; }
  /// The smallest node that properly contains `v`; invalid for the root.
  Node_index parent(Node_index v) const { return Node_index(parent_[std::size_t(v)]); }
  /// The points in the square of `v`, at least two.
  Rank_interval points(Node_index v) const {
    return {Point_rank(begin_[std::size_t(v)]), Point_rank(end_[std::size_t(v)])};
  }
  /// The first node after the descendants of `v`: these are the nodes between `v` and it.
  Node_index subtree_end(Node_index v) const { return Node_index(subtree_end_[std::size_t(v)]); }

  /// Calls `on_node(Node_index)` and `on_point(Point_rank)` for the two to four children of `v` in shuffle
  /// order.
  template <class On_node, class On_point>
  void for_each_child(Node_index v, On_node on_node, On_point on_point) const {
    std::uint32_t p = begin_[std::size_t(v)];
    std::uint32_t child = v.value() + 1;
    while (child < subtree_end_[std::size_t(v)]) {
      for (; p < begin_[child]; ++p) on_point(Point_rank(p));
      on_node(Node_index(child));
      p = end_[child];
      child = subtree_end_[child];
    }
    for (; p < end_[std::size_t(v)]; ++p) on_point(Point_rank(p));
  }

  /// @}

  /// Checks that points are in strict shuffle order, that every square is derived from two of its points and
  /// properly contained in its parent. Takes O(n) time.
  bool is_valid() const {
    for (std::size_t r = 1; r < number_of_points(); ++r)
      if (!Quadtree_mesh_2::internal::less_shuffle(points_[r - 1], points_[r])) return false;
    for (std::size_t v = 0; v < number_of_nodes(); ++v)
      if (!is_valid(Node_index(v))) return false;
    return true;
  }

private:
  bool is_valid(Node_index v) const {
    const Rank_interval inside = points(v);
    const Grid_point& first = grid_point(inside.begin);
    if (level_of_derived_square(first, points_[inside.end.value() - 1]) != level(v)) return false;
    if (corner(first, level(v)) != corner_[std::size_t(v)]) return false;
    if (!parent(v).is_valid()) return v == root();
    const Rank_interval around = points(parent(v));
    return level(parent(v)) < level(v) && !(inside.begin < around.begin) && !(around.end < inside.end);
  }

  static constexpr std::uint32_t none_ = std::numeric_limits<std::uint32_t>::max();

  /// Fills the arrays of points: sorted, equal ones merged.
  template <class PointRange>
  void sort_points(const PointRange& points) {
    const auto first = std::begin(points);
    const std::size_t n = static_cast<std::size_t>(std::distance(first, std::end(points)));
    if (n >= none_) throw std::length_error("Quadtree_framework: 2^32 - 1 points or more");
    std::vector<Grid_point> grid_points(n);
    for (std::size_t i = 0; i < n; ++i) grid_points[i] = grid_.grid_point(at(first, i));
    input_ = Quadtree_mesh_2::internal::shuffle_order(grid_points);

    rank_.resize(n);
    points_.reserve(n);
    std::size_t distinct = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t i = input_[k];
      if (distinct > 0 && grid_points[i] == points_[distinct - 1]) {
        merge(first, Point_index(input_[distinct - 1]), Point_index(i));
      } else {
        points_.push_back(grid_points[i]);
        input_[distinct++] = i;
      }
      rank_[i] = static_cast<std::uint32_t>(distinct - 1);
    }
    input_.resize(distinct);
  }

  template <class Iterator>
  static decltype(auto) at(Iterator first, std::size_t i) {
    return first[static_cast<typename std::iterator_traits<Iterator>::difference_type>(i)];
  }

  /// Records that `duplicate` equals `kept`, or throws if only their grid points are equal.
  template <class Iterator>
  void merge(Iterator first, Point_index kept, Point_index duplicate) {
    using Quadtree_mesh_2::Point_error;
    if (!(at(first, std::size_t(kept)) == at(first, std::size_t(duplicate))))
      throw Point_error(Point_error::Kind::INDISTINGUISHABLE, kept, duplicate);
    duplicates_.push_back({kept, duplicate});
  }

  /// The level of the smallest square that contains both points.
  static int level_of_derived_square(const Grid_point& p, const Grid_point& q) {
    return Traits::depth - Quadtree_mesh_2::internal::bit_width((p.x ^ q.x) | (p.y ^ q.y));
  }

  /// Fills the arrays of nodes from the squares derived from neighbours in the order.
  void build_nodes() {
    if (points_.size() < 2) return;
    std::vector<std::uint8_t> derived(points_.size() - 1);
    for (std::size_t i = 0; i < derived.size(); ++i)
      derived[i] = static_cast<std::uint8_t>(level_of_derived_square(points_[i], points_[i + 1]));
    const auto nested = Quadtree_mesh_2::internal::nested_intervals(derived);
    const std::size_t m = nested.size();
    level_.resize(m);
    corner_.resize(m);
    begin_.resize(m);
    end_.resize(m);
    for (std::size_t v = 0; v < m; ++v) {
      level_[v] = nested[v].level;
      begin_[v] = nested[v].begin;
      end_[v] = nested[v].end;
      corner_[v] = corner(points_[nested[v].begin], nested[v].level);
    }
    Quadtree_mesh_2::internal::link_nested_intervals(begin_, end_, parent_, subtree_end_);
  }

  /// The lower left corner of the square of the given level that contains `p`.
  static Grid_point corner(const Grid_point& p, int level) {
    const Word mask = static_cast<Word>(~((Word(1) << (Traits::depth - level)) - 1));
    return {p.x & mask, p.y & mask};
  }

  /// Finds the smallest node of every point.
  void hang_points() {
    node_of_point_.assign(points_.size(), none_);
    for (std::size_t v = 0; v < number_of_nodes(); ++v)
      for_each_child(
          Node_index(v), [](Node_index) {},
          [this, v](Point_rank r) { node_of_point_[std::size_t(r)] = static_cast<std::uint32_t>(v); });
  }

  Grid_2 grid_;

  // By rank.
  std::vector<Grid_point> points_;
  std::vector<std::uint32_t> input_;
  std::vector<std::uint32_t> node_of_point_;
  // By input index.
  std::vector<std::uint32_t> rank_;
  std::vector<Duplicate_point> duplicates_;

  // By node, in preorder.
  std::vector<Grid_point> corner_;
  std::vector<std::uint8_t> level_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> end_;
  std::vector<std::uint32_t> subtree_end_;
};

} // namespace CGAL

#endif // CGAL_QUADTREE_FRAMEWORK_H
