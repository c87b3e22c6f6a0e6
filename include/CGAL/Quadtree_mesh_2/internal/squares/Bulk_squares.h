// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The squares of a balanced quadtree that make the bulk of a mesh, and the names of their corners.
//
// Bounds of size ask for leaves of a quadtree (Wanted_squares.h). A leaf belongs to the bulk if it lies
// inside the domain and away from its features. Balance makes leaves differ by at most a factor of two across
// sides and corners, so a side has at most one vertex between its ends. A square gets a vertex in the center
// if it is too large without, or if the wanted angle is above that of squares with halved sides.
//
// The name of a leaf's corner consists of the leaf whose half-open square holds it, and of its place there:
// the lower left corner, or the middle of the left or lower side. So each place has one name, found in O(1).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_SQUARES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_SQUARES_H

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Square_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Wanted_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/square_templates.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A piece of the border of a square, numbered as in `Square_template`.
struct Square_piece {
  Leaf_index square;
  int piece;
};

template <class ConcurrencyTag, class Geometry>
class Bulk_squares {
public:
  using Tree = Balanced_quadtree<Fixed_point_quadtree_traits_2<std::uint32_t>, ConcurrencyTag>;

  enum class Halved_sides { WITHOUT_CENTER, WITH_CENTER };

  Bulk_squares(const Wanted_squares<Geometry>& wanted, Halved_sides rule)
      : tree_(typename Tree::Framework(), Quadtree_options(),
              [&wanted](const Point& low, const Point& high) {
                return wanted.must_split(square_between(low, high));
              }),
        form_(tree_.number_of_leaves(), not_bulk) {
    mark_inside(wanted, tree_.root(), 0);
    find_halved_sides(rule);
  }

  std::size_t number_of_leaves() const { return tree_.number_of_leaves(); }
  bool is_bulk(Leaf_index l) const { return form_[l].bits != not_bulk.bits; }
  /// The template of a bulk square.
  Square_form form(Leaf_index l) const { return form_[l]; }
  std::size_t number_of_squares() const { return squares_; }
  std::size_t number_of_triangles() const { return triangles_; }
  /// The pieces with no bulk on the other side, by square.
  const std::vector<Square_piece>& border() const { return border_; }

  Grid_square square(Leaf_index l) const {
    const auto s = tree_.square(l);
    return {s.x, s.y, s.level};
  }

  /// The triangle of the domain that met the square's surroundings when they were found to be inside.
  Triangle_id triangle_near(const Wanted_squares<Geometry>& wanted, Leaf_index l) const {
    return wanted.node(wanted.node_at(square(l))).triangle;
  }

  /// The name of vertex i (as in `Square_template`) of a leaf: less than three times the number of leaves.
  std::size_t name(Leaf_index l, int i) const {
    const Node_index v = tree_.node(l);
    switch (i) {
    case 0:
      return 3 * std::size_t(l);
    case 1:
      return name_across(v, Direction::EAST, 0);
    case 2:
      return name_across(v, Direction::NORTH_EAST, 0);
    case 3:
      return name_across(v, Direction::NORTH, 0);
    case 4:
      return 3 * std::size_t(l) + on_lower_side;
    case 5:
      return name_across(v, Direction::EAST, 1);
    case 6:
      return name_across(v, Direction::NORTH, 2);
    default:
      return 3 * std::size_t(l) + on_left_side;
    }
  }

  /// The pieces that lie on the other side of the left or lower side of a bulk square, where there is bulk,
  /// and the square's own pieces opposite them: at most two pairs, passed to `visit(own, other)`.
  template <class Visit>
  void for_each_pair_before(Leaf_index l, Visit visit) const {
    const Node_index v = tree_.node(l);
    visit_pairs(l, v, left, Direction::WEST, visit);
    visit_pairs(l, v, lower, Direction::SOUTH, visit);
  }

private:
  using Point = typename Tree::Point_2;
  using Node_index = typename Tree::Node_index;
  static constexpr Square_form not_bulk{0xff};
  static constexpr std::size_t on_left_side = 1, on_lower_side = 2;
  static constexpr int lower = 0, right = 1, upper = 2, left = 3;
  static constexpr Direction outward[4] = {Direction::SOUTH, Direction::EAST, Direction::NORTH,
                                           Direction::WEST};
  /// The children along a side of a square, in the order of its pieces.
  static constexpr int children_at_side[4][2] = {{0, 2}, {2, 3}, {3, 1}, {1, 0}};

  /// What is found in a run of leaves.
  struct Part {
    std::size_t squares = 0, triangles = 0;
    std::vector<Square_piece> border;
  };

  Tree tree_;
  Indexed_vector<Leaf_index, Square_form> form_;
  std::vector<Square_piece> border_;
  std::size_t squares_ = 0, triangles_ = 0;

  static Grid_square square_between(const Point& low, const Point& high) {
    return {low.x(), low.y(), Grid_square::depth - lowest_bit(high.x() - low.x())};
  }

  void mark_inside(const Wanted_squares<Geometry>& wanted, Node_index v, std::size_t i) {
    const auto& node = wanted.node(i);
    if (node.first_child >= 0) {
      for (int c = 0; c < 4; ++c)
        mark_inside(wanted, tree_.child(v, c), std::size_t(node.first_child) + std::size_t(c));
      return;
    }
    if (node.kind != Square_kind::INSIDE) return;
    const Leaf_interval leaves = tree_.leaves(v);
    for (const Leaf_index l : Id_range<Leaf_index>(leaves.begin, leaves.end))
      form_[l].bits = wanted.has_center(i, tree_.level(l)) ? Square_form::with_center : 0;
  }

  /// The child of the neighbor across side i that piece `part` of the side touches, the neighbor being
  /// split.
  Leaf_index leaf_at(Node_index neighbor, int side, int part) const {
    return tree_.leaf(tree_.child(neighbor, children_at_side[(side + 2) % 4][1 - part]));
  }

  void find_halved_sides(Halved_sides rule) {
    const std::size_t n = form_.size();
    Indexed_vector<Leaf_index, std::uint8_t> halved(n);
    std::vector<Part> parts((n + default_block - 1) / default_block);
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      for (const Leaf_index l : Id_range<Leaf_index>(begin, end))
        if (is_bulk(l)) halved[l] = look_around(l, rule, parts[b]);
    });
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      const Leaf_index l(i);
      if (is_bulk(l)) form_[l].bits = static_cast<std::uint8_t>(form_[l].bits | halved[l]);
    });
    for (const Part& part : parts) squares_ += part.squares, triangles_ += part.triangles;
    append_all<ConcurrencyTag>(
        border_, parts, [](const Part& part) -> const std::vector<Square_piece>& { return part.border; });
  }

  /// What the sides of a bulk square add to its form.
  std::uint8_t look_around(Leaf_index l, Halved_sides rule, Part& part) const {
    unsigned halved = 0;
    for (int side = 0; side < 4; ++side)
      if (look_across(l, tree_.node(l), side, part.border)) halved |= 1u << side;
    if (halved != 0 && rule == Halved_sides::WITH_CENTER) halved |= Square_form::with_center;
    const Square_form form{static_cast<std::uint8_t>(form_[l].bits | halved)};
    ++part.squares;
    part.triangles += std::size_t(square_template(form).size);
    return form.bits;
  }

  /// Whether the side is halved; appends those of its pieces that are the border of the bulk.
  bool look_across(Leaf_index l, Node_index v, int side, std::vector<Square_piece>& border) const {
    const Node_index n = tree_.neighbor(v, outward[side]);
    if (!n.is_valid() || tree_.is_leaf(n)) {
      if (!n.is_valid() || !is_bulk(tree_.leaf(n))) border.push_back({l, 2 * side});
      return false;
    }
    const bool is_first = is_bulk(leaf_at(n, side, 0)), is_second = is_bulk(leaf_at(n, side, 1));
    if (!is_first) border.push_back({l, 2 * side});
    if (!is_second && is_first) border.push_back({l, 2 * side + 1});
    return is_first || is_second;
  }

  /// The name of the corner of v in direction d; or of the middle of that side, which is the lower left
  /// corner of the neighbor's given child.
  std::size_t name_across(Node_index v, Direction d, int child) const {
    Node_index n = tree_.neighbor(v, d);
    if (tree_.level(n) == tree_.level(v)) {
      if (!tree_.is_leaf(n)) n = tree_.child(n, child);
      while (!tree_.is_leaf(n)) n = tree_.child(n, 0);
      return 3 * std::size_t(tree_.leaf(n));
    }
    const auto s = tree_.square(v), larger = tree_.square(n);
    const std::uint32_t side = std::uint32_t(1) << (Grid_square::depth - s.level);
    const std::uint32_t x = s.x + (step_x(d) > 0 ? side : 0), y = s.y + (step_y(d) > 0 ? side : 0);
    return 3 * std::size_t(tree_.leaf(n)) + (y != larger.y   ? on_left_side
                                             : x != larger.x ? on_lower_side
                                                             : 0);
  }

  template <class Visit>
  void visit_pairs(Leaf_index l, Node_index v, int side, Direction d, Visit visit) const {
    const Node_index n = tree_.neighbor(v, d);
    if (!n.is_valid()) return;
    const int opposite_side = (side + 2) % 4;
    if (!tree_.is_leaf(n)) {
      for (int part = 0; part < 2; ++part) {
        const Leaf_index other = leaf_at(n, side, part);
        if (is_bulk(other)) visit(Square_piece{l, 2 * side + part}, Square_piece{other, 2 * opposite_side});
      }
      return;
    }
    const Leaf_index other = tree_.leaf(n);
    if (!is_bulk(other)) return;
    int part = 0;
    if (tree_.level(n) != tree_.level(v)) {
      const auto s = tree_.square(v), larger = tree_.square(n);
      // the right side's pieces go up, the upper side's to the left
      part = opposite_side == right ? (s.y != larger.y ? 1 : 0) : (s.x != larger.x ? 0 : 1);
    }
    visit(Square_piece{l, 2 * side}, Square_piece{other, 2 * opposite_side + part});
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_SQUARES_H
