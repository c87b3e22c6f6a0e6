// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The columns of leaves that an edge passes through, and the leaves above and below it in each.
//
// Computes: an edge with |dy| <= |dx| as a function of x, and one with |dy| > |dx| with x and y exchanged.
//           Below, u is the coordinate that changes more, and v the other one. A column is an aligned
//           interval of u. It is as wide as the smallest of the leaves that the edge passes through there.
// Bound:    O(k log k) for an edge that passes through k leaves; O(1) for each leaf in a band of O(1) widths
//           of a column, by cross pointers.
// Source:   ours; see Column_rule.h.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_EDGE_COLUMNS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_EDGE_COLUMNS_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Leaf_segments.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// An edge between grid points as a function v of u, also beyond its ends.
template <class Word>
class Edge_line {
public:
  using Coordinate = typename Signed_grid<Word>::Coordinate;
  using Product = typename Signed_grid<Word>::Product;
  using Grid_point = Grid_point_2<Word>;

  Edge_line(const Grid_point& a, const Grid_point& b) {
    const auto difference = [](const Word& p, const Word& q) { return p < q ? Word(q - p) : Word(p - q); };
    is_steep_ = difference(a.y, b.y) > difference(a.x, b.x);
    const bool is_reversed = u(b) < u(a);
    const Grid_point &left = is_reversed ? b : a, &right = is_reversed ? a : b;
    u_ = Coordinate(u(left));
    v_ = Coordinate(v(left));
    du_ = Coordinate(u(right)) - u_;
    dv_ = Coordinate(v(right)) - v_;
  }

  bool is_steep() const { return is_steep_; }
  const Word& u(const Grid_point& p) const { return is_steep_ ? p.y : p.x; }
  const Word& v(const Grid_point& p) const { return is_steep_ ? p.x : p.y; }
  Grid_point point(const Word& u, const Word& v) const {
    return is_steep_ ? Grid_point{v, u} : Grid_point{u, v};
  }

  const Coordinate& first_u() const { return u_; }
  Coordinate last_u() const { return u_ + du_; }
  /// From -1 to 1.
  double slope() const { return du_ == 0 ? 0 : to_double(Product(dv_)) / to_double(Product(du_)); }

  /// The largest integer not above the line.
  Product floor_of_v(const Product& u) const { return Product(v_) + divide((u - u_) * dv_).first; }
  /// The smallest integer not below the line.
  Product ceiling_of_v(const Product& u) const {
    const auto [floor, remainder] = divide((u - u_) * dv_);
    return Product(v_) + floor + (remainder == 0 ? 0 : 1);
  }
  /// The line's v, less `from`, rounded.
  double v_from(const Product& u, const Product& from) const {
    const auto [floor, remainder] = divide((u - u_) * dv_);
    const double part = remainder == 0 ? 0 : to_double(remainder) / to_double(Product(du_));
    return to_double(v_ + floor - from) + part;
  }

private:
  static double to_double(const Product& p) { return static_cast<double>(p); }

  /// By du, rounded down, and the remainder.
  std::pair<Product, Product> divide(const Product& p) const {
    if (du_ == 0) return {Product(0), Product(0)};
    Product quotient = p / du_, remainder = p % du_;
    if (remainder < 0) {
      --quotient;
      remainder += du_;
    }
    return {quotient, remainder};
  }

  bool is_steep_;
  Coordinate u_, v_, du_, dv_;
};

/// An aligned interval of u, and a leaf that the edge passes there: at least as large as the column is wide.
template <class Word>
struct Edge_column {
  Word u;
  int level;
  Leaf_index leaf;

  Word width(int depth) const { return Word_operations<Word>::power_of_two(depth - level); }
};

template <class Tree>
typename Tree::Word width_of(const Tree& tree, const Edge_column<typename Tree::Word>& c) {
  return c.width(tree.framework().grid().depth());
}

/// Halves a column, and appends the halves that hold a point of the edge.
template <class Tree>
void append_halves(const Tree& tree, const Edge_line<typename Tree::Word>& line,
                   const Edge_column<typename Tree::Word>& c,
                   std::vector<Edge_column<typename Tree::Word>>& to) {
  using Word = typename Tree::Word;
  using Coordinate = typename Edge_line<Word>::Coordinate;
  const Edge_column<Word> left{c.u, c.level + 1, c.leaf};
  const Edge_column<Word> right{Word(c.u + width_of(tree, left)), c.level + 1, c.leaf};
  if (line.first_u() < Coordinate(right.u)) to.push_back(left);
  if (line.last_u() >= Coordinate(right.u)) to.push_back(right);
}

/// Makes columns from the leaves of an edge.
template <class Tree>
class Edge_columns_finder {
public:
  using Word = typename Tree::Word;
  using Column = Edge_column<Word>;
  using Line = Edge_line<Word>;

  Edge_columns_finder(const Tree& tree, const Line& line) : tree_(tree), line_(line) {}

  /// \param leaves all that the edge passes, in any order
  template <class Leaves>
  std::vector<Column> find(const Leaves& leaves) {
    sides_.clear();
    for (const Leaf_index l : leaves) {
      const auto square = tree_.square(l);
      sides_.push_back({line_.u({square.x, square.y}), square.level, l});
    }
    // Intervals before those in them, these from the left to the right.
    std::sort(sides_.begin(), sides_.end(), [](const Column& a, const Column& b) {
      return a.u != b.u ? a.u < b.u : a.level != b.level ? a.level < b.level : a.leaf < b.leaf;
    });
    columns_.clear();
    next_ = 0;
    while (next_ < sides_.size()) append(sides_[next_]);
    return std::move(columns_);
  }

private:
  /// Appends the columns of an interval, from that of the next leaf on.
  void append(Column interval) {
    while (next_ < sides_.size() && sides_[next_].u == interval.u && sides_[next_].level == interval.level)
      interval.leaf = sides_[next_++].leaf;
    if (next_ == sides_.size() || sides_[next_].u >= interval.u + width_of(tree_, interval)) {
      columns_.push_back(interval);
      return;
    }
    std::vector<Column> halves;
    append_halves(tree_, line_, interval, halves);
    for (const Column& half : halves) append(half);
  }

  const Tree& tree_;
  const Line& line_;
  std::vector<Column> sides_, columns_;
  std::size_t next_ = 0;
};

/// The columns of an edge, from the left to the right.
template <class Tree, class Leaves>
std::vector<Edge_column<typename Tree::Word>> columns_along(const Tree& tree, const Leaves& leaves,
                                                            const Edge_line<typename Tree::Word>& line) {
  return Edge_columns_finder<Tree>(tree, line).find(leaves);
}

/// The squares over a column that are not further from the edge, in v, than some distance.
template <class Tree>
class Column_band {
public:
  using Word = typename Tree::Word;
  using Column = Edge_column<Word>;
  using Line = Edge_line<Word>;
  using Product = typename Line::Product;

  Column_band(const Tree& tree, const Line& line) : tree_(tree), line_(line) {}

  /// Calls `visit(v)` for nodes v: for leaves at least as large as the column is wide, and for split squares of
  /// its width, until it returns `false`.
  /// \param widths the distance, in widths of the column
  template <class Visit>
  void visit_nodes(const Column& c, int widths, const Visit& visit) const {
    const Product width = Product(width_of(tree_, c)), left = Product(c.u), right = left + width;
    const Product high = std::max(line_.ceiling_of_v(left), line_.ceiling_of_v(right)) + width * widths;
    const Product low = std::min(line_.floor_of_v(left), line_.floor_of_v(right)) - width * widths;
    const Node_index start = tree_.node(c.leaf);
    for (Node_index v = start; v.is_valid() && begin_of(v) < high; v = next(v, c, Way::UP))
      if (!visit(v)) return;
    for (Node_index v = next(start, c, Way::DOWN); v.is_valid() && end_of(v) > low; v = next(v, c, Way::DOWN))
      if (!visit(v)) return;
  }

private:
  /// To greater or to smaller v.
  enum class Way { UP, DOWN };

  Product begin_of(Node_index v) const {
    const auto square = tree_.square(v);
    return Product(line_.v({square.x, square.y}));
  }
  Product end_of(Node_index v) const {
    return begin_of(v) +
           Product(Word_operations<Word>::power_of_two(tree_.framework().grid().depth() - tree_.level(v)));
  }

  /// The next square over the column.
  Node_index next(Node_index v, const Column& c, Way way) const {
    const bool is_up = way == Way::UP;
    v = tree_.neighbor(v, line_.is_steep() ? (is_up ? Direction::EAST : Direction::WEST)
                                           : (is_up ? Direction::NORTH : Direction::SOUTH));
    while (v.is_valid() && !tree_.is_leaf(v) && tree_.level(v) < c.level) {
      const int half_u =
          Word_operations<Word>::bit(c.u, tree_.framework().grid().depth() - 1 - tree_.level(v));
      const int half_v = is_up ? 0 : 1;
      v = tree_.child(v, line_.is_steep() ? 2 * half_v + half_u : 2 * half_u + half_v);
    }
    return v;
  }

  const Tree& tree_;
  const Line& line_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_COLUMNS_EDGE_COLUMNS_H
