// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The vertices of the mesh on an edge, and the corners of leaves beside it that are not vertices, by
// Column_rule.h.
//
// Computes: the crossings of the edge with the grid lines between its columns, and the dropped corners on
//           these lines.
// Bound:    O(1) for each column. Columns, and edges, are independent of each other.
// Source:   ours; see Column_rule.h.
//
// The rule at vertices also applies to corners near the ends of an edge.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_COLUMN_PLACEMENT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_COLUMN_PLACEMENT_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Column_rule.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Column_window.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Edge_columns.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Which thresholds are used at changes of sizes.
enum class Transition_rule {
  ONE_FOR_ALL,  ///< 21.5 degrees
  BETTER_OF_TWO ///< 26.3 degrees
};

/// The vertices beside one edge.
/// \pre the edge passes the tree in columns, as Column_closure.h checks
template <class Tree>
class Column_placement {
public:
  using Word = typename Tree::Word;
  using Grid_point = Grid_point_2<Word>;
  using Column = Edge_column<Word>;
  using Line = Edge_line<Word>;
  using Product = typename Line::Product;

  /// The grid lines from which on this rule decides: the rule at vertices does before.
  struct End {
    Product crossings, corners;
  };

  /// \param columns those of the edge, by `columns_along()`
  /// \param ends the one with less u, and the other one
  Column_placement(const Tree& tree, const Line& line, const std::vector<Column>& columns,
                   Transition_rule rule, const std::array<End, 2>& ends)
      : tree_(tree), line_(line), columns_(columns), rule_(rule), ends_(ends), slope_(line.slope()),
        length_(std::sqrt(1 + slope_ * slope_)) {}
  /// By this rule all along the edge.
  Column_placement(const Tree& tree, const Line& line, const std::vector<Column>& columns,
                   Transition_rule rule)
      : Column_placement(tree, line, columns, rule,
                         {End{Product(line.first_u()), Product(line.first_u())},
                          End{Product(line.last_u()), Product(line.last_u())}}) {}

  /// Calls `f(u)` for the grid lines that cross the edge, ends excluded, from the left to the right. `Edge_line`
  /// has the other coordinate of the crossing.
  template <class F>
  void for_each_crossing(const F& f) const {
    for (std::size_t i = 1; i < columns_.size(); ++i)
      if (is_crossing(i) && is_between(i, ends_[0].crossings, ends_[1].crossings)) f(columns_[i].u);
  }

  /// Calls `f(point)` for the corners that are dropped because of the edge, on the grid lines that cross it.
  /// Corners on the edge are among them: a crossing takes their place.
  template <class F>
  void for_each_dropped_corner(const F& f) const {
    for (std::size_t i = 1; i < columns_.size(); ++i)
      if (is_crossing(i) && is_between(i, ends_[0].corners, ends_[1].corners)) for_each_dropped_corner(i, f);
  }

private:
  /// Corners at least so many widths of wider columns from the edge, in v, are kept: sqrt(2) times thresholds.
  static constexpr int reach_ = 3;
  /// How many grid lines on each side of a change of widths have thresholds of their own.
  static constexpr std::size_t lines_near_change_ = 2;

  /// A change of widths, as a grid line sees it.
  struct Change {
    std::size_t line; ///< before this column
    int fine_widths;  ///< the grid line's distance, in widths of the narrower columns; negative in wider ones
    Fine_side fine;   ///< where the narrower columns are
    std::array<Transition_thresholds, 2> thresholds; ///< above and below the edge
  };

  bool is_crossing(std::size_t i) const {
    using Coordinate = typename Line::Coordinate;
    return Coordinate(columns_[i].u) > line_.first_u() && Coordinate(columns_[i].u) < line_.last_u();
  }
  bool is_between(std::size_t i, const Product& first, const Product& last) const {
    return Product(columns_[i].u) >= first && Product(columns_[i].u) <= last;
  }
  bool is_change(std::size_t i) const { return columns_[i - 1].level != columns_[i].level; }
  Word width(std::size_t i) const { return width_of(tree_, columns_[i]); }
  Word wider(std::size_t i) const { return std::max(width(i - 1), width(i)); }
  Word narrower(std::size_t i) const { return std::min(width(i - 1), width(i)); }

  /// The change of widths that matters for grid line `i`, if there is one: `line` is 0 if not.
  Change change_near(std::size_t i) const {
    const std::size_t first = i <= lines_near_change_ ? 1 : i - lines_near_change_;
    const std::size_t last = std::min(columns_.size() - 1, i + lines_near_change_);
    for (std::size_t j = first; j <= last; ++j) {
      if (!is_change(j)) continue;
      const Fine_side fine = columns_[j].level > columns_[j - 1].level ? Fine_side::GREATER : Fine_side::LESS;
      const int distance = i < j ? static_cast<int>(j - i) : static_cast<int>(i - j);
      const bool is_on_fine_side = (fine == Fine_side::GREATER) == (i > j);
      const int fine_widths = is_on_fine_side ? distance : -2 * distance;
      if (fine_widths >= -2) return {j, fine_widths, fine, thresholds_at(j, fine)};
    }
    return {0, 0, Fine_side::GREATER, {one_rule, one_rule}};
  }

  std::array<Transition_thresholds, 2> thresholds_at(std::size_t j, Fine_side fine) const {
    if (rule_ == Transition_rule::ONE_FOR_ALL) return {one_rule, one_rule};
    const Product u(columns_[j].u), side(wider(j)), v = line_.floor_of_v(u);
    const double height = line_.v_from(u, v - v % side) / static_cast<double>(side);
    const auto better = [&](Edge_side edge_side) {
      const Window_line w = window_line(slope_, height, fine, edge_side);
      return better_of(rule_b, rule_c, w.slope, w.offset);
    };
    return {better(Edge_side::ABOVE), better(Edge_side::BELOW)};
  }

  /// Above the edge a corner has positive height; both in widths of some columns.
  double height(const Product& u, const Product& v, const Word& unit) const {
    return -line_.v_from(u, v) / static_cast<double>(unit);
  }

  template <class F>
  void for_each_dropped_corner(std::size_t i, const F& f) const {
    const Change change = change_near(i);
    const Product u(columns_[i].u), step(narrower(i)), v_of_edge = line_.floor_of_v(u);
    const Product reach = reach_ * Product(wider(change.line == 0 ? i : change.line));
    const Product lowest = v_of_edge < reach ? Product(0) : v_of_edge - reach;
    for (Product v = lowest - lowest % step; v <= v_of_edge + reach; v += step)
      if (!is_kept_corner(i, change, u, v)) f(line_.point(columns_[i].u, static_cast<Word>(v)));
  }

  bool is_kept_corner(std::size_t i, const Change& change, const Product& u, const Product& v) const {
    if (change.line == 0)
      return is_kept(std::abs(height(u, v, width(i))) / length_, Column_place::EQUAL_LEAVES, one_rule);
    const Word side = wider(change.line);
    const double h = height(u, v, side);
    const Transition_thresholds& thresholds = change.thresholds[h > 0 ? 0 : 1];
    const Column_corner corner =
        v % Product(side) == 0 ? Column_corner::OF_COARSE_LEAF : Column_corner::OF_FINE_LEAVES;
    const Column_place place = column_place(change.fine_widths, corner);
    const Opposite_corners opposite = place == Column_place::HANGING
                                          ? opposite_corners(change, thresholds, u, v, h)
                                          : Opposite_corners::BOTH_KEPT;
    return is_kept(std::abs(h) / length_, place, thresholds, opposite);
  }

  /// What happens to the other side of the coarse leaf whose side has the hanging node (u, v) at height `h`.
  Opposite_corners opposite_corners(const Change& change, const Transition_thresholds& thresholds,
                                    const Product& u, const Product& v, double h) const {
    const Word width = wider(change.line);
    const Product side(width);
    const Product other = change.fine == Fine_side::GREATER ? Product(u - side) : Product(u + side);
    const Product low = v - v % side;
    const auto is_opposite_kept = [&](const Product& w) {
      const double g = height(other, w, width);
      return (g > 0) == (h > 0) && is_kept(std::abs(g) / length_, Column_place::BEFORE, thresholds);
    };
    return is_opposite_kept(low) && is_opposite_kept(low + side) ? Opposite_corners::BOTH_KEPT
                                                                 : Opposite_corners::NOT_BOTH_KEPT;
  }

  const Tree& tree_;
  const Line& line_;
  const std::vector<Column>& columns_;
  Transition_rule rule_;
  std::array<End, 2> ends_;
  double slope_, length_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_COLUMN_PLACEMENT_H
