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
// Each corner has one name (Named_border.h), found in O(1).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_SQUARES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_SQUARES_H

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Id_set.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Named_border.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Square_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Wanted_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/required_by_wanted.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/square_templates.h>

#include <array>
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
  using Node_index = typename Tree::Node_index;

  enum class Halved_sides { WITHOUT_CENTER, WITH_CENTER };

  Bulk_squares(const Wanted_squares<Geometry>& wanted, Halved_sides rule)
      : tree_(typename Tree::Framework(), Quadtree_options(), required_by_wanted<ConcurrencyTag>(wanted)),
        inside_(tree_.number_of_leaves()), with_center_(tree_.number_of_leaves()),
        form_(tree_.number_of_leaves()) {
    mark_inside(wanted, tree_.root(), 0);
    find_halved_sides(rule);
  }

  std::size_t number_of_leaves() const { return tree_.number_of_leaves(); }
  bool is_bulk(Leaf_index l) const { return inside_.has(l); }
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

  /// A leaf with the cross pointers that lead to what is around it, but for three of its corners.
  struct Surroundings {
    Leaf_index leaf;
    int child_of_parent; ///< 2 i + j with x offset i and y offset j
    int level;
    std::array<Node_index, 4> across; ///< by side
    Node_index across_upper_right;
  };

  Surroundings surroundings(Leaf_index l) const {
    const Node_index v = tree_.node(l);
    Surroundings s{l, child_of_parent(v), tree_.level(v), {}, tree_.neighbor(v, Direction::NORTH_EAST)};
    for (std::size_t side = 0; side < 4; ++side) s.across[side] = tree_.neighbor(v, outward[side]);
    return s;
  }

  /// The names of a square's corners.
  std::array<Corner_name, 4> names_of_corners(const Surroundings& s) const {
    return {{{s.leaf, Square_place::LOWER_LEFT},
             name_across(s, s.across[right], Direction::EAST, 0),
             name_across(s, s.across_upper_right, Direction::NORTH_EAST, 0),
             name_across(s, s.across[upper], Direction::NORTH, 0)}};
  }

  /// The name of the middle of a side that is halved.
  Corner_name name_of_middle(const Surroundings& s, int side) const {
    return side == lower   ? Corner_name{s.leaf, Square_place::ON_LOWER_SIDE}
           : side == left  ? Corner_name{s.leaf, Square_place::ON_LEFT_SIDE}
           : side == right ? name_across(s, s.across[right], Direction::EAST, 1)
                           : name_across(s, s.across[upper], Direction::NORTH, 2);
  }

  /// The name of vertex i (as in `Square_template`) of a leaf, which has it.
  Corner_name name(const Surroundings& s, int i) const {
    return i < 4 ? names_of_corners(s)[std::size_t(i)] : name_of_middle(s, i - 4);
  }

  /// Calls `visit(piece, other)` for the pieces of a bulk square's border, and those of other squares that they are.
  template <class Visit>
  void for_each_piece_across(const Surroundings& s, const Visit& visit) const {
    for (int side = 0; side < 4; ++side) {
      const Node_index n = s.across[std::size_t(side)];
      if (!n.is_valid()) continue;
      const int opposite_side = (side + 2) % 4;
      if (tree_.is_leaf(n)) {
        const Leaf_index other = tree_.leaf(n);
        if (is_bulk(other))
          visit(2 * side,
                Square_piece{other, 2 * opposite_side + (is_second_half(s, n, opposite_side) ? 1 : 0)});
        continue;
      }
      for (int part = 0; part < 2; ++part) {
        const Leaf_index other = leaf_at(n, side, part);
        if (is_bulk(other)) visit(2 * side + part, Square_piece{other, 2 * opposite_side});
      }
    }
  }

private:
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
  Id_set<Leaf_index> inside_, with_center_;
  Uninitialized_indexed_vector<Leaf_index, Square_form> form_; // of those inside
  std::vector<Square_piece> border_;
  std::size_t squares_ = 0, triangles_ = 0;

  void mark_inside(const Wanted_squares<Geometry>& wanted, Node_index v, std::size_t i) {
    const auto& node = wanted.node(i);
    if (node.first_child >= 0) {
      for (int c = 0; c < 4; ++c)
        mark_inside(wanted, tree_.child(v, c), std::size_t(node.first_child) + std::size_t(c));
      return;
    }
    if (node.kind != Square_kind::INSIDE) return;
    const Leaf_interval leaves = tree_.leaves(v);
    inside_.add(leaves.begin, leaves.end);
    if (!node.has_center) return;
    for (const Leaf_index l : Id_range<Leaf_index>(leaves.begin, leaves.end))
      if (tree_.level(l) == node.level) with_center_.add(l);
  }

  /// The child of the neighbor across side i that piece `part` of the side touches, the neighbor being
  /// split.
  Leaf_index leaf_at(Node_index neighbor, int side, int part) const {
    return tree_.leaf(tree_.child(neighbor, children_at_side[(side + 2) % 4][1 - part]));
  }

  void find_halved_sides(Halved_sides rule) {
    const std::size_t n = form_.size();
    std::vector<Part> parts((n + default_block - 1) / default_block);
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
      for (const Leaf_index l : Id_range<Leaf_index>(begin, end))
        if (is_bulk(l)) form_[l] = look_around(l, rule, parts[b]);
    });
    for (const Part& part : parts) squares_ += part.squares, triangles_ += part.triangles;
    append_all<ConcurrencyTag>(
        border_, parts, [](const Part& part) -> const std::vector<Square_piece>& { return part.border; });
  }

  /// The form of a bulk square with what its sides add to it.
  Square_form look_around(Leaf_index l, Halved_sides rule, Part& part) const {
    const Surroundings s = surroundings(l);
    unsigned bits = 0;
    for (int side = 0; side < 4; ++side)
      if (look_across(s, side, part.border)) bits |= 1u << side;
    if (with_center_.has(l) || (bits != 0 && rule == Halved_sides::WITH_CENTER))
      bits |= Square_form::with_center;
    const Square_form form{static_cast<std::uint8_t>(bits)};
    ++part.squares;
    part.triangles += std::size_t(square_template(form).size);
    return form;
  }

  /// Whether the side is halved; appends those of its pieces that are the border of the bulk.
  bool look_across(const Surroundings& s, int side, std::vector<Square_piece>& border) const {
    const Node_index n = s.across[std::size_t(side)];
    if (!n.is_valid() || tree_.is_leaf(n)) {
      if (!n.is_valid() || !is_bulk(tree_.leaf(n))) border.push_back({s.leaf, 2 * side});
      return false;
    }
    const bool is_first = is_bulk(leaf_at(n, side, 0)), is_second = is_bulk(leaf_at(n, side, 1));
    if (!is_first) border.push_back({s.leaf, 2 * side});
    if (!is_second && is_first) border.push_back({s.leaf, 2 * side + 1});
    return is_first || is_second;
  }

  /// The name of the corner in direction d, where the neighbor is n; or of the middle of that side, which is the lower
  /// left corner of the neighbor's given child.
  Corner_name name_across(const Surroundings& s, Node_index n, Direction d, int child) const {
    if (tree_.level(n) != s.level) return name_in_larger(s, d, tree_.leaf(n));
    if (!tree_.is_leaf(n)) n = tree_.child(n, child);
    while (!tree_.is_leaf(n)) n = tree_.child(n, 0);
    return {tree_.leaf(n), Square_place::LOWER_LEFT};
  }

  /// The corner in direction d of a square of which the neighbor there is twice as large.
  static Corner_name name_in_larger(const Surroundings& s, Direction d, Leaf_index larger) {
    const bool is_right = is_in_right_half(s), is_upper = is_in_upper_half(s);
    if (step_y(d) > 0 ? !is_upper : is_upper) return {larger, Square_place::ON_LEFT_SIDE};
    if (step_x(d) > 0 ? !is_right : is_right) return {larger, Square_place::ON_LOWER_SIDE};
    return {larger, Square_place::LOWER_LEFT};
  }

  /// Whether a square touches the second half of the given side of its neighbor, which is twice as large. The right
  /// side's pieces go up, the upper side's to the left.
  bool is_second_half(const Surroundings& s, Node_index neighbor, int side) const {
    if (tree_.level(neighbor) == s.level) return false;
    return side == lower   ? is_in_right_half(s)
           : side == right ? is_in_upper_half(s)
           : side == upper ? !is_in_right_half(s)
                           : !is_in_upper_half(s);
  }

  static bool is_in_right_half(const Surroundings& s) { return s.child_of_parent >= 2; }
  static bool is_in_upper_half(const Surroundings& s) { return s.child_of_parent % 2 != 0; }
  static int child_of_parent(Node_index v) {
    return v == Node_index(0) ? 0 : static_cast<int>((v.value() - 1) % 4);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_BULK_SQUARES_H
