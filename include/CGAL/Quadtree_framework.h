// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The framework of a set of points: the quadtree without empty leaves and without paths of single children.
//
// Computes: the points in shuffle order; all squares of which more than one child holds points, with their
//           nesting; and the size of square that each point is annotated with.
// Bound:    O(n) work, not counting sorting, whatever the depth: n distinct points have at most n - 1 squares.
// Source:   Bern, Eppstein, Teng, section 2, Lemmas 1-3 and the first half of Theorem 1. Each pair of
//           neighbors in the order gives a square. Its parent is the smaller of the nearest larger squares to
//           either side. Annotations: section 5.
// Deviates: squares derived more than once are merged while the nearest larger ones are found (Nesting_finder.h).
//           Equal points, which the paper excludes, are merged and reported.

#ifndef CGAL_QUADTREE_FRAMEWORK_H
#define CGAL_QUADTREE_FRAMEWORK_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Nesting_finder.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

namespace Quadtree_mesh_2 {

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Distinguishes ranks of points.
struct Rank_tag {};
/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Place of a point in the shuffle order of the distinct points.
using Point_rank = Index<Rank_tag>;

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Points that follow each other in shuffle order.
struct Rank_interval {
  Point_rank begin; ///< the first point
  Point_rank end;   ///< one past the last

  /// The number of points.
  std::size_t size() const { return end.value() - begin.value(); }
  /// Whether these are the same points.
  friend bool operator==(const Rank_interval& a, const Rank_interval& b) {
    return a.begin == b.begin && a.end == b.end;
  }
};

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// An input point that equals an earlier one and was merged with it.
struct Duplicate_point {
  Point_index kept;      ///< the earlier one
  Point_index duplicate; ///< the one that equals it
};

} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// The framework T_F of a set of points (Theorem 1).
///
/// Nodes are the squares that have at least two nonempty children, in preorder with children in shuffle
/// order. The root of the framework is the smallest square that contains all points. A child is a node, or a
/// single point. Every node holds an interval of the points in shuffle order (Lemma 1).
///
/// Takes O(n) time for n points with words of constant length, and O(n log n) comparisons otherwise. Neither
/// depends on the depth. Takes about 40 bytes per point besides the grid points. The result is the same for
/// any number of threads.
/// \tparam Traits_ a model of `QuadtreeTraits_2`.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`.
template <class Traits_, class ConcurrencyTag = Sequential_tag>
class Quadtree_framework {
public:
  /// \name Types
  /// @{

  /// The traits.
  using Traits = Traits_;
  /// A point of the input.
  using Point_2 = typename Traits::Point_2;
  /// Maps points to the grid and back.
  using Grid_2 = typename Traits::Grid_2;
  /// A grid coordinate.
  using Word = typename Traits::Word;
  /// A point of the grid.
  using Grid_point = Quadtree_mesh_2::Grid_point_2<Word>;
  /// A square of the grid.
  using Square = Quadtree_mesh_2::Quadtree_square_2<Word>;
  /// Names a square, be it a leaf or split.
  using Node_index = Quadtree_mesh_2::Node_index;
  /// Names a point, in the order of the input.
  using Point_index = Quadtree_mesh_2::Point_index;
  /// Names a point, in shuffle order.
  using Point_rank = Quadtree_mesh_2::Point_rank;
  /// The points of a square, which follow each other in shuffle order.
  using Rank_interval = Quadtree_mesh_2::Rank_interval;
  /// Two equal points of the input.
  using Duplicate_point = Quadtree_mesh_2::Duplicate_point;
  /// @}

  /// The framework of no points.
  Quadtree_framework() = default;

  /// Builds the framework of `points`.
  /// \tparam PointRange a random access range with value type `Point_2`; several threads may read it.
  /// \throws Quadtree_mesh_2::Point_error if the traits cannot map a point to the grid, or map two distinct
  /// points to the same grid point.
  /// \throws std::length_error if there are 2^32 - 1 points or more.
  template <class PointRange, class = decltype(std::declval<const PointRange&>().begin())>
  explicit Quadtree_framework(const PointRange& points, const Traits& traits = Traits())
      : grid_(traits.construct_grid_2_object()(points)) {
    const auto first = std::begin(points);
    const std::size_t n = static_cast<std::size_t>(std::distance(first, std::end(points)));
    if (n >= none_) throw std::length_error("Quadtree_framework: 2^32 - 1 points or more");
    while (!sort_points(first, n)) {
    }
    find_nodes();
  }

  /// The map between points and the grid.
  const Grid_2& grid() const { return grid_; }

  /// \name Points
  /// @{

  /// The number of points given, including equal ones.
  std::size_t number_of_input_points() const { return rank_.size(); }
  /// The number of distinct points.
  std::size_t number_of_points() const { return points_.size(); }
  /// The points merged with an earlier one, in shuffle order and by increasing index.
  const std::vector<Duplicate_point>& duplicates() const { return duplicates_; }

  /// The place of the point of rank `r` on the grid.
  const Grid_point& grid_point(Point_rank r) const { return points_[std::size_t(r)]; }
  /// The input point of rank `r`: the first of several equal points.
  Point_index input_point(Point_rank r) const { return Point_index(input_[std::size_t(r)]); }
  /// The rank of an input point; equal points have the same rank.
  Point_rank rank(Point_index i) const { return Point_rank(rank_[std::size_t(i)]); }
  /// The smallest node that contains the point; invalid if there is only one point.
  Node_index node(Point_rank r) const { return node_of_deeper_gap(r.value(), r.value() + 1); }
  /// The level of the smallest node that contains the point; -1 if there is only one point.
  int level_of_node(Point_rank r) const {
    return std::max(level_of_gap_before(r.value()), level_of_gap_before(r.value() + 1));
  }

  /// @}

  /// \name Nodes
  /// @{

  /// The number of squares; less than the number of points.
  std::size_t number_of_nodes() const { return nodes_.size(); }
  /// The smallest square that contains all points; invalid if there are fewer than two points.
  Node_index root() const { return nodes_.size() == 0 ? Node_index() : Node_index(0); }

  /// The square of `v` in the grid.
  Square square(Node_index v) const {
    const Grid_point c =
        Quadtree_mesh_2::internal::corner_of_square(grid_point(points(v).begin), level(v), grid_.depth());
    return {c.x, c.y, level(v)};
  }
  /// The level of `v`; that of the root square of the grid is 0.
  int level(Node_index v) const { return static_cast<int>(nodes_.level[std::size_t(v)]); }
  /// The smallest node that properly contains `v`; invalid for the root.
  Node_index parent(Node_index v) const {
    return node_of_deeper_gap(nodes_.begin[std::size_t(v)], nodes_.end[std::size_t(v)]);
  }
  /// The level of the parent; -1 for the root.
  int level_of_parent(Node_index v) const {
    return std::max(level_of_gap_before(nodes_.begin[std::size_t(v)]),
                    level_of_gap_before(nodes_.end[std::size_t(v)]));
  }
  /// The points in the square of `v`, at least two.
  Rank_interval points(Node_index v) const {
    return {Point_rank(nodes_.begin[std::size_t(v)]), Point_rank(nodes_.end[std::size_t(v)])};
  }
  /// The first node after the descendants of `v`, which are the nodes between `v` and it.
  Node_index subtree_end(Node_index v) const { return Node_index(nodes_.subtree_end[std::size_t(v)]); }

  /// Calls `on_node(Node_index)` and `on_point(Point_rank)` for the two to four children of `v` in shuffle
  /// order.
  template <class On_node, class On_point>
  void for_each_child(Node_index v, On_node on_node, On_point on_point) const {
    std::uint32_t p = nodes_.begin[std::size_t(v)];
    std::uint32_t child = v.value() + 1;
    while (child < nodes_.subtree_end[std::size_t(v)]) {
      for (; p < nodes_.begin[child]; ++p) on_point(Point_rank(p));
      on_node(Node_index(child));
      p = nodes_.end[child];
      child = nodes_.subtree_end[child];
    }
    for (; p < nodes_.end[std::size_t(v)]; ++p) on_point(Point_rank(p));
  }

  /// @}

  /// \name Annotations
  /// Every point may be annotated with the least level that its leaf should have. Squares of level `l` have the
  /// root's side times 2^-l. Quadtrees made from the framework follow the annotations.
  /// @{

  /// Annotates each point, by rank, with a level. Replaces earlier annotations; no levels remove them.
  /// \pre `levels` is empty, or has a level for each point, from 0 to `grid().depth()`
  void annotate(const std::vector<int>& levels) {
    CGAL_precondition(levels.empty() || levels.size() == number_of_points());
    desired_level_.resize(levels.size());
    for (std::size_t r = 0; r < levels.size(); ++r) {
      CGAL_precondition(0 <= levels[r] && levels[r] <= grid_.depth());
      desired_level_[r] = static_cast<Level>(levels[r]);
    }
  }
  /// Whether `annotate()` was called with levels.
  bool has_annotations() const { return !desired_level_.empty(); }
  /// The least level of the leaf of a point; 0 if there are no annotations.
  int desired_level(Point_rank r) const {
    return desired_level_.empty() ? 0 : static_cast<int>(desired_level_[std::size_t(r)]);
  }

  /// @}

  /// Checks that points are in strict shuffle order, and that every square is derived from two of its points
  /// and properly contained in its parent. Takes O(n) time.
  bool is_valid() const {
    for (std::size_t r = 1; r < number_of_points(); ++r)
      if (!Quadtree_mesh_2::internal::less_shuffle(points_[r - 1], points_[r])) return false;
    for (std::size_t v = 0; v < number_of_nodes(); ++v)
      if (!is_valid(Node_index(v))) return false;
    return true;
  }

private:
  using Level = typename Quadtree_mesh_2::internal::Word_operations<Word>::Level;
  static constexpr std::uint32_t none_ = std::numeric_limits<std::uint32_t>::max();

  bool is_valid(Node_index v) const {
    const Rank_interval inside = points(v);
    if (level_of_derived_square(inside.begin.value(), inside.end.value() - 1) != level(v)) return false;
    if (!parent(v).is_valid()) return v == root();
    const Rank_interval around = points(parent(v));
    return level(parent(v)) < level(v) && !(inside.begin < around.begin) && !(around.end < inside.end);
  }

  /// The level of the smallest square that contains the points of ranks `p` and `q`.
  int level_of_derived_square(std::size_t p, std::size_t q) const {
    return Quadtree_mesh_2::internal::level_of_derived_square(points_[p], points_[q], grid_.depth());
  }

  /// Lemma 3: the smallest node around the points from `begin` to `end` is derived from the last point before
  /// them or the first one after them. Invalid if they are all points.
  Node_index node_of_deeper_gap(std::uint32_t begin, std::uint32_t end) const {
    const int left = level_of_gap_before(begin), right = level_of_gap_before(end);
    if (left < 0 && right < 0) return Node_index();
    return Node_index(nodes_.of_gap[(left < right ? end : begin) - 1]);
  }

  /// The level of the square derived from the point of rank `r` and the one before; -1 if one does not exist.
  int level_of_gap_before(std::uint32_t r) const {
    return r == 0 || r == points_.size() ? -1 : static_cast<int>(nodes_.gap_level[r - 1]);
  }

  template <class Iterator>
  static decltype(auto) at(Iterator first, std::size_t i) {
    return first[static_cast<typename std::iterator_traits<Iterator>::difference_type>(i)];
  }

  /// Fills the arrays of points, sorted and with equal points merged. Returns false if the grid was too
  /// coarse and has been refined.
  template <class Iterator>
  bool sort_points(Iterator first, std::size_t n) {
    using namespace Quadtree_mesh_2::internal;
    arrange_points(first, n);
    const Level greatest = static_cast<Level>(grid_.depth()); // of equal points
    const auto begin = nodes_.gap_level.begin();
    const std::size_t repeated = reduce<ConcurrencyTag>(
        nodes_.gap_level.size(), std::size_t(0),
        [&](std::size_t from, std::size_t to) {
          return static_cast<std::size_t>(std::count(begin + static_cast<std::ptrdiff_t>(from),
                                                     begin + static_cast<std::ptrdiff_t>(to), greatest));
        },
        [](std::size_t a, std::size_t b) { return a + b; });
    if (repeated == 0) return true;
    if (!list_duplicates(first)) return false;
    merge_duplicates();
    return true;
  }

  /// Sorts and ranks points and finds the levels of the gaps between them, as if they were distinct.
  template <class Iterator>
  void arrange_points(Iterator first, std::size_t n) {
    using namespace Quadtree_mesh_2::internal;
    auto sorted = shuffled<ConcurrencyTag>(n, [&](std::size_t i) { return grid_.grid_point(at(first, i)); });
    points_ = std::move(sorted.keys);
    input_ = std::move(sorted.order);
    rank_.resize(n);
    nodes_.gap_level.resize(n == 0 ? 0 : n - 1);
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) rank_[input_[k]] = static_cast<std::uint32_t>(k);
      for (std::size_t k = begin + 1; k < end; ++k) find_gap_level(k - 1);
    });
    for (std::size_t k = default_block; k < n; k += default_block) find_gap_level(k - 1);
  }

  void find_gap_level(std::size_t gap) {
    nodes_.gap_level[gap] = static_cast<Level>(level_of_derived_square(gap, gap + 1));
  }

  bool is_repeated(std::size_t k) const { return k > 0 && points_[k] == points_[k - 1]; }

  /// Lists repeated points. Returns false if some are distinct and the grid could be refined to tell them
  /// apart.
  template <class Iterator>
  bool list_duplicates(Iterator first) {
    using Quadtree_mesh_2::Point_error;
    duplicates_.clear();
    Point_index kept;
    for (const std::uint32_t k : Quadtree_mesh_2::internal::pack<ConcurrencyTag>(
             points_.size(), [&](std::size_t i) { return is_repeated(i); })) {
      if (!is_repeated(k - 1)) kept = Point_index(input_[k - 1]);
      const Point_index i(input_[k]);
      if (at(first, std::size_t(kept)) == at(first, std::size_t(i)))
        duplicates_.push_back({kept, i});
      else if (grid_.refine())
        return false;
      else
        throw Point_error(Point_error::Kind::INDISTINGUISHABLE, kept, i);
    }
    return true;
  }

  /// Keeps the first of equal points, and ranks all points by the kept ones.
  void merge_duplicates() {
    using namespace Quadtree_mesh_2::internal;
    Uninitialized_vector<Grid_point> points;
    Order input;
    count_allocate_and_place<ConcurrencyTag>(
        points_.size(),
        [&](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for (std::size_t k = begin; k < end; ++k) sum += is_repeated(k) ? 0 : 1;
          return sum;
        },
        [&](std::size_t distinct) {
          points.resize(distinct);
          input.resize(distinct);
          nodes_.gap_level.resize(distinct - 1);
        },
        [&](std::size_t begin, std::size_t end, std::size_t distinct) {
          for (std::size_t k = begin; k < end; ++k) {
            if (!is_repeated(k)) {
              points[distinct] = points_[k];
              input[distinct++] = input_[k];
            }
            rank_[input_[k]] = static_cast<std::uint32_t>(distinct - 1);
          }
        });
    points_.swap(points);
    input_.swap(input);
    for_each_index<ConcurrencyTag>(points_.size() - 1, [&](std::size_t i) { find_gap_level(i); });
  }

  /// Finds the squares derived from neighbors in the order, and their nesting.
  void find_nodes() {
    if (points_.size() < 2) return;
    nodes_ =
        Quadtree_mesh_2::internal::Nesting_finder<ConcurrencyTag, Level>(std::move(nodes_.gap_level)).find();
  }

  Grid_2 grid_;

  // By rank.
  Quadtree_mesh_2::internal::Uninitialized_vector<Grid_point> points_;
  Quadtree_mesh_2::internal::Order input_;
  std::vector<Level> desired_level_; // or empty
  // By input index.
  Quadtree_mesh_2::internal::Uninitialized_vector<std::uint32_t> rank_;
  std::vector<Duplicate_point> duplicates_;

  Quadtree_mesh_2::internal::Nested_intervals<Level> nodes_;
};

} // namespace CGAL

#endif // CGAL_QUADTREE_FRAMEWORK_H
