// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The linked squares of a balanced quadtree, without points.
//
// Computes: from the split squares of each level, all squares with parents, children and cross pointers.
// Bound:    O(k), top-down, one round per level.
// Source:   Bern, Eppstein, Teng, section 3: the cross pointers of a square follow from those of its parent.
//
// Layout.   A family is a split square and its four children. Families are numbered level by level, in
// shuffle order within
//           a level; node 0 is the root and nodes 4 f + 1 to 4 f + 4 are the children of family f. So nodes
//           are in the same order, siblings follow each other, and most of what is known of a node is kept
//           once, with its family. In a balanced tree the eight neighbours of a split square are squares of
//           the same size (or outside the root). Only these are stored; the neighbours of leaves follow from
//           those of their parents.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_LINKED_SQUARES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_LINKED_SQUARES_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/split_squares.h>
#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How to step from a child to a neighbour: in which direction the parent has to step first, if at all, and
/// which child of the square reached there is the neighbour.
struct Sibling_step {
  bool leaves_parent = false;
  Direction parent_step = Direction::EAST;
  int child = 0;
};

/// The steps from each child in each direction. Child 2 i + j has x offset i and y offset j.
constexpr std::array<std::array<Sibling_step, 8>, 4> make_sibling_steps() {
  std::array<std::array<Sibling_step, 8>, 4> steps{};
  for (int q = 0; q < 4; ++q)
    for (Direction d : all_directions()) {
      const int x = q / 2 + step_x(d), y = q % 2 + step_y(d);
      const int dx = x < 0 ? -1 : x / 2, dy = y < 0 ? -1 : y / 2;
      Sibling_step& step = steps[std::size_t(q)][std::size_t(d)];
      step.leaves_parent = dx != 0 || dy != 0;
      if (step.leaves_parent) step.parent_step = direction(dx, dy);
      step.child = 2 * (x & 1) + (y & 1);
    }
  return steps;
}

template <class Word>
class Linked_squares {
public:
  using Grid_point = Grid_point_2<Word>;

  Linked_squares() : leaf_or_family_(1, leaf_flag_), level_begin_(1, 0) {}

  /// Links the squares of a tree whose root has side `2^depth`.
  /// \pre `levels` is closed under balance
  /// \throws std::length_error if there are 2^29 split squares or more.
  Linked_squares(const Split_squares<Word>& levels, int depth) : depth_(depth), level_begin_(1, 0) {
    std::size_t families = 0;
    for (const auto& level : levels) families += level.size();
    if (families >= max_families_) throw std::length_error("Balanced_quadtree: too many squares");
    leaf_or_family_.assign(4 * families + 1, leaf_flag_);
    node_.reserve(families);
    corner_.reserve(families);
    neighbors_.reserve(families);
    for (const auto& level : levels) {
      append_level(level);
      link_level();
    }
    number_leaves();
  }

  std::size_t number_of_nodes() const { return leaf_or_family_.size(); }
  std::size_t number_of_families() const { return node_.size(); }
  std::size_t number_of_leaves() const { return number_of_nodes() - number_of_families(); }

  bool is_leaf(Node_index v) const { return (leaf_or_family_[std::size_t(v)] & leaf_flag_) != 0; }
  /// \pre `is_leaf(v)`
  std::uint32_t leaf(Node_index v) const { return leaf_or_family_[std::size_t(v)] & ~leaf_flag_; }
  /// \pre `!is_leaf(v)`
  std::uint32_t family(Node_index v) const { return leaf_or_family_[std::size_t(v)]; }

  /// \pre `!is_leaf(v)`
  Node_index child(Node_index v, int q) const { return member(family(v), q); }
  Node_index parent(Node_index v) const {
    return v.value() == 0 ? Node_index() : Node_index(node_[family_of(v)]);
  }

  int level(Node_index v) const { return v.value() == 0 ? 0 : family_level_[family_of(v)] + 1; }
  /// The lower left corner in grid units.
  Grid_point corner(Node_index v) const {
    if (v.value() == 0) return {0, 0};
    const std::uint32_t f = family_of(v);
    const int shift = depth_ - family_level_[f] - 1;
    const Word q = static_cast<Word>(member_of(v));
    return {static_cast<Word>(corner_[f].x + ((q >> 1) << shift)),
            static_cast<Word>(corner_[f].y + ((q & 1) << shift))};
  }

  /// The square of the same size across a side or corner, or the leaf that contains it; invalid outside the
  /// root.
  Node_index neighbor(Node_index v, Direction d) const {
    if (v.value() == 0) return Node_index();
    const std::uint32_t f = family_of(v);
    const Sibling_step step = steps_[std::size_t(member_of(v))][std::size_t(d)];
    if (!step.leaves_parent) return member(f, step.child);
    const Node_index n(neighbors_[f][std::size_t(step.parent_step)]);
    return !n.is_valid() || is_leaf(n) ? n : child(n, step.child);
  }

  /// The leaves below a split square, in shuffle order, are those from `first_leaf()` to `last_leaf()`.
  std::uint32_t first_leaf(Node_index v) const { return is_leaf(v) ? leaf(v) : first_leaf_[family(v)]; }
  std::uint32_t last_leaf(Node_index v) const { return is_leaf(v) ? leaf(v) : last_leaf_[family(v)]; }

  /// The number of levels that have split squares.
  int number_of_split_levels() const { return static_cast<int>(level_begin_.size()) - 1; }
  /// The families of the split squares of level `l` are those from `level_begin(l)` to `level_begin(l + 1)`.
  std::uint32_t level_begin(int l) const { return level_begin_[std::size_t(l)]; }

private:
  static constexpr std::uint32_t leaf_flag_ = 0x80000000u;
  static constexpr std::size_t max_families_ = std::size_t(1) << 29; // leaves must stay below the flag

  static std::uint32_t family_of(Node_index v) { return (v.value() - 1) / 4; }
  static int member_of(Node_index v) { return static_cast<int>((v.value() - 1) % 4); }
  static Node_index member(std::uint32_t f, int q) {
    return Node_index(4 * std::size_t(f) + 1 + std::size_t(q));
  }

  /// Appends the families of the split squares of the next level.
  void append_level(const std::vector<Grid_point>& squares) {
    const int level = number_of_split_levels();
    const int shift = depth_ - level;
    std::uint32_t parent = level == 0 ? 0 : level_begin_[std::size_t(level) - 1];
    for (const Grid_point& s : squares) {
      const Grid_point corner{static_cast<Word>(s.x << shift), static_cast<Word>(s.y << shift)};
      std::uint32_t node = 0;
      if (level > 0) {
        while (corner_[parent].x >> (shift + 1) != s.x >> 1 || corner_[parent].y >> (shift + 1) != s.y >> 1)
          ++parent;
        node = member(parent, static_cast<int>(2 * (s.x & 1) + (s.y & 1))).value();
      }
      leaf_or_family_[node] = static_cast<std::uint32_t>(node_.size());
      node_.push_back(node);
      corner_.push_back(corner);
      family_level_.push_back(static_cast<std::uint8_t>(level));
    }
    level_begin_.push_back(static_cast<std::uint32_t>(node_.size()));
  }

  /// Links the families of the last level to their neighbours, which the level above knows.
  void link_level() {
    for (std::uint32_t f = level_begin_[level_begin_.size() - 2]; f < level_begin_.back(); ++f) {
      neighbors_.emplace_back();
      for (Direction d : all_directions()) {
        const Node_index n = neighbor(Node_index(node_[f]), d);
        CGAL_assertion(!n.is_valid() || n.value() > 4 * std::size_t(level_begin_[level_begin_.size() - 3]));
        neighbors_[f][std::size_t(d)] = n.value();
      }
    }
  }

  /// Numbers the leaves in shuffle order: counts bottom-up, places top-down.
  void number_leaves() {
    const std::size_t n = node_.size();
    std::vector<std::uint32_t> count(n, 0);
    first_leaf_.assign(n, 0);
    last_leaf_.assign(n, 0);
    for (std::size_t f = n; f-- > 0;)
      for (int q = 0; q < 4; ++q) {
        const Node_index v = member(static_cast<std::uint32_t>(f), q);
        count[f] += is_leaf(v) ? 1 : count[family(v)];
      }
    for (std::size_t f = 0; f < n; ++f) {
      std::uint32_t next = first_leaf_[f];
      for (int q = 0; q < 4; ++q) {
        const Node_index v = member(static_cast<std::uint32_t>(f), q);
        if (is_leaf(v)) {
          leaf_or_family_[std::size_t(v)] = leaf_flag_ | next++;
        } else {
          first_leaf_[family(v)] = next;
          next += count[family(v)];
        }
      }
      last_leaf_[f] = next - 1;
    }
  }

  static constexpr std::array<std::array<Sibling_step, 8>, 4> steps_ = make_sibling_steps();

  int depth_ = 0;

  // By node: the leaf with the flag, or the family.
  std::vector<std::uint32_t> leaf_or_family_;

  // By family; of the split square.
  std::vector<std::uint32_t> node_;
  std::vector<Grid_point> corner_;
  std::vector<std::uint8_t> family_level_;
  std::vector<std::array<std::uint32_t, 8>> neighbors_;
  std::vector<std::uint32_t> first_leaf_;
  std::vector<std::uint32_t> last_leaf_;

  // By level of split squares.
  std::vector<std::uint32_t> level_begin_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_LINKED_SQUARES_H
