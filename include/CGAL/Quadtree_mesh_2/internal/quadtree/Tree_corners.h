// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The corners of the leaves of a balanced quadtree, each once.
//
// Computes: names for the corners of leaves, and the leaves around each of them.
// Bound:    O(1) for each question, by cross pointers; nothing is stored.
// Source:   Bern, Eppstein, Teng, section 3, for the cross pointers.
//
// A corner belongs to the leaf whose lower left corner it is. A corner in the middle of a left or lower side
// is the lower left corner of no leaf. It belongs to the leaf to the left, as its lower right corner, or to
// the leaf below, as its upper left one. So a leaf has up to three corners. Those on the upper and right side
// of the root are left out.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_TREE_CORNERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_TREE_CORNERS_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

enum class Leaf_corner { LOWER_LEFT, LOWER_RIGHT, UPPER_LEFT, UPPER_RIGHT };

/// \tparam Tree a `Balanced_quadtree`, balanced across sides and corners, that stays as it is.
template <class Tree>
class Tree_corners {
public:
  using Word = typename Tree::Word;
  using Grid_point = typename Tree::Grid_point;
  /// Names are below `number_of_names()`; not each of them is one.
  using Name = std::size_t;
  static constexpr Name none = Name(-1);
  static constexpr std::size_t names_of_leaf = 3;

  /// The leaves around a corner: to the upper right, upper left, lower right and lower left. A leaf in whose
  /// side the corner hangs stands twice.
  using Leaves = std::array<Leaf_index, 4>;

  explicit Tree_corners(const Tree& tree) : tree_(tree) {}

  std::size_t number_of_names() const { return names_of_leaf * tree_.number_of_leaves(); }

  /// Whether a name stands for a corner.
  bool exists(Name c) const {
    const Node_index v = tree_.node(leaf_of(c));
    const std::size_t i = c % names_of_leaf;
    return i == 0 || (i == 1 ? hangs(v, Direction::EAST) : hangs(v, Direction::NORTH));
  }

  /// The leaf that a corner belongs to.
  static Leaf_index leaf_of(Name c) { return Leaf_index(c / names_of_leaf); }

  /// \pre `exists(c)`
  Grid_point place(Name c) const {
    const auto s = tree_.square(leaf_of(c));
    return place({s.x, s.y}, s.level, static_cast<Leaf_corner>(c % names_of_leaf));
  }

  /// \pre `exists(c)`
  Leaves leaves_around(Name c) const {
    const Leaf_index l = leaf_of(c);
    const Node_index v = tree_.node(l);
    switch (static_cast<Leaf_corner>(c % names_of_leaf)) {
    case Leaf_corner::LOWER_LEFT:
      return {l, touching(v, Direction::WEST, 2), touching(v, Direction::SOUTH, 1),
              touching(v, Direction::SOUTH_WEST, 3)};
    case Leaf_corner::LOWER_RIGHT: {
      const Leaf_index east = tree_.leaf(tree_.neighbor(v, Direction::EAST));
      return {east, l, east, touching(v, Direction::SOUTH, 3)};
    }
    default: {
      const Leaf_index north = tree_.leaf(tree_.neighbor(v, Direction::NORTH));
      return {north, north, l, touching(v, Direction::WEST, 3)};
    }
    }
  }

  /// The level of the smallest leaf around a corner.
  int level(const Leaves& leaves) const {
    int level = 0;
    for (const Leaf_index l : leaves)
      if (l.is_valid()) level = std::max(level, tree_.level(l));
    return level;
  }

  /// The name of a corner of a leaf; `none` on the upper and right side of the root.
  Name name(Leaf_index l, Leaf_corner which) const {
    if (which == Leaf_corner::LOWER_LEFT) return names_of_leaf * l.value();
    const auto s = tree_.square(l);
    return name(place({s.x, s.y}, s.level, which));
  }

  /// The name of the corner at a grid point; `none` if no leaf has a corner there. Takes O(depth) time.
  Name name(const Grid_point& p) const {
    const Word end = Word_operations<Word>::power_of_two(tree_.framework().grid().depth());
    if (!(p.x < end) || !(p.y < end)) return none;
    const Leaf_index l = tree_.locate(p);
    const auto s = tree_.square(l);
    if (s.x == p.x && s.y == p.y) return names_of_leaf * l.value();
    const Node_index v = tree_.node(l);
    if (s.x == p.x) return hanging_name(v, Direction::WEST, p);
    if (s.y == p.y) return hanging_name(v, Direction::SOUTH, p);
    return none;
  }

private:
  const Tree& tree_;

  Word side(int level) const {
    return Word_operations<Word>::power_of_two(tree_.framework().grid().depth() - level);
  }

  Grid_point place(const Grid_point& low, int level, Leaf_corner which) const {
    const Word a = side(level);
    const bool is_right = which == Leaf_corner::LOWER_RIGHT || which == Leaf_corner::UPPER_RIGHT;
    const bool is_upper = which == Leaf_corner::UPPER_LEFT || which == Leaf_corner::UPPER_RIGHT;
    return {static_cast<Word>(is_right ? low.x + a : low.x), static_cast<Word>(is_upper ? low.y + a : low.y)};
  }

  /// Whether the lower right corner of a leaf hangs in the side of the one to the east, or its upper left one in
  /// that of the one to the north.
  bool hangs(Node_index v, Direction d) const {
    const Node_index n = tree_.neighbor(v, d);
    if (!n.is_valid() || tree_.level(n) >= tree_.level(v)) return false;
    const auto s = tree_.square(v), t = tree_.square(n);
    return d == Direction::EAST ? !(s.y == t.y) : !(s.x == t.x);
  }

  /// The leaf in direction `d` that touches a corner of v: if there is none of v's size or larger, the one in the
  /// given child, again and again.
  Leaf_index touching(Node_index v, Direction d, int child) const {
    Node_index n = tree_.neighbor(v, d);
    if (!n.is_valid()) return Leaf_index();
    while (!tree_.is_leaf(n)) n = tree_.child(n, child);
    return tree_.leaf(n);
  }

  /// The name of a point on the side of leaf v in direction `d`, if a corner hangs there: the last child of the
  /// split node beyond is the upper or right one at that side, and begins there.
  Name hanging_name(Node_index v, Direction d, const Grid_point& p) const {
    const Node_index n = tree_.neighbor(v, d);
    if (!n.is_valid() || tree_.is_leaf(n)) return none;
    const Node_index beyond = tree_.child(n, 3);
    if (!tree_.is_leaf(beyond)) return none;
    const auto s = tree_.square(beyond);
    const Name first = names_of_leaf * tree_.leaf(beyond).value();
    if (d == Direction::WEST) return s.y == p.y ? first + 1 : none;
    return s.x == p.x ? first + 2 : none;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_TREE_CORNERS_H
