// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The linked squares of a quadtree.
//
// Holds:    all squares with parents, children, cross pointers and intervals of points.
// Source:   Bern, Eppstein, Teng, section 3: the cross pointers of a square follow from those of its parent.
// Layout:   A family is a split square and its four children. Families are numbered level by level, in
//           shuffle order within a level. Node 0 is the root, and nodes 4 f + 1 to 4 f + 4 are the children
//           of family f. So nodes are in the same order, and siblings follow each other. Most data of a node
//           is stored once, with its family. Only split squares store cross pointers; those of leaves follow
//           from their parents'.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LINKED_SQUARES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LINKED_SQUARES_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How to step from a child to its neighbors.
struct Sibling_steps {
  /// The directions of the parent's neighbors that the child touches: across the side in x, the side in y and
  /// the corner.
  std::array<std::uint8_t, 3> outward{};
  /// By direction: in what the neighbor is, 0 for the parent and i + 1 for the parent's neighbor
  /// `outward[i]`; and which child of it.
  std::array<std::uint8_t, 8> around{};
  std::array<std::uint8_t, 8> child{};
};

/// The steps from each child. Child 2 i + j has x offset i and y offset j.
constexpr std::array<Sibling_steps, 4> make_sibling_steps() {
  std::array<Sibling_steps, 4> all{};
  for (int q = 0; q < 4; ++q) {
    Sibling_steps& steps = all[std::size_t(q)];
    const int out_x = q / 2 == 0 ? -1 : 1, out_y = q % 2 == 0 ? -1 : 1;
    steps.outward = {{static_cast<std::uint8_t>(direction(out_x, 0)),
                      static_cast<std::uint8_t>(direction(0, out_y)),
                      static_cast<std::uint8_t>(direction(out_x, out_y))}};
    for (Direction d : all_directions()) {
      const bool leaves_x = step_x(d) == out_x, leaves_y = step_y(d) == out_y;
      steps.around[std::size_t(d)] = static_cast<std::uint8_t>(leaves_x && leaves_y ? 3
                                                               : leaves_y           ? 2
                                                               : leaves_x           ? 1
                                                                                    : 0);
      steps.child[std::size_t(d)] =
          static_cast<std::uint8_t>(q ^ (step_x(d) != 0 ? 2 : 0) ^ (step_y(d) != 0 ? 1 : 0));
    }
  }
  return all;
}

template <class Word>
class Linked_squares {
public:
  using Grid_point = Grid_point_2<Word>;

  std::size_t number_of_nodes() const { return leaf_or_family_.size(); }
  std::size_t number_of_families() const { return node_.size(); }
  std::size_t number_of_leaves() const { return node_of_leaf_.size(); }

  bool is_leaf(Node_index v) const { return (leaf_or_family_[v.value()] & leaf_flag) != 0; }
  /// \pre `is_leaf(v)`
  std::uint32_t leaf(Node_index v) const { return leaf_or_family_[v.value()] & ~leaf_flag; }
  /// \pre `!is_leaf(v)`
  std::uint32_t family(Node_index v) const { return leaf_or_family_[v.value()]; }
  Node_index node_of_leaf(std::uint32_t leaf) const { return Node_index(node_of_leaf_[leaf]); }
  std::uint32_t leaf_of_point(std::uint32_t rank) const { return leaf_of_point_[rank]; }

  /// \pre `!is_leaf(v)`
  Node_index child(Node_index v, int q) const { return member(family(v), q); }
  Node_index parent(Node_index v) const {
    return v.value() == 0 ? Node_index() : Node_index(node_[family_of(v)]);
  }

  int level(Node_index v) const {
    return v.value() == 0 ? 0 : static_cast<int>(family_level_[family_of(v)]) + 1;
  }
  /// The lower left corner in grid units. Takes O(1) time if corners are stored, otherwise O(depth) time.
  Grid_point corner(Node_index v) const {
    if (v.value() == 0) return {0, 0};
    const std::uint32_t f = family_of(v);
    Grid_point c = corner_of_family(f);
    move_to_child(c, member_of(v), depth_ - static_cast<int>(family_level_[f]) - 1);
    return c;
  }

  /// The square of the same size across a side or corner, or the leaf that contains it; invalid outside the
  /// root.
  Node_index neighbor(Node_index v, Direction d) const {
    if (v.value() == 0) return Node_index();
    const std::uint32_t f = family_of(v);
    const Sibling_steps& steps = sibling_steps_[std::size_t(member_of(v))];
    const std::size_t around = steps.around[std::size_t(d)];
    const int q = steps.child[std::size_t(d)];
    if (around == 0) return member(f, q);
    const Node_index n(neighbors_[f][steps.outward[around - 1]]);
    return !n.is_valid() || is_leaf(n) ? n : child(n, q);
  }

  /// All neighbors of a square but the root, in order of their directions; the number of an invalid index
  /// outside the root.
  std::array<std::uint32_t, 8> neighbors(Node_index v) const {
    // A child meets itself and its siblings, two children of a neighbor of its parent across either side, and
    // one across the corner between. What is there may be a leaf in their stead.
    const std::uint32_t f = family_of(v);
    const unsigned q = static_cast<unsigned>(member_of(v));
    const Sibling_steps& steps = sibling_steps_[q];
    std::array<std::uint32_t, 4> first_child{{member(f, 0).value(), 0, 0, 0}};
    std::array<std::uint32_t, 4> is_split{{3, 0, 0, 0}};
    for (std::size_t i = 1; i < 4; ++i) {
      const std::uint32_t n = neighbors_[f][steps.outward[i - 1]];
      const std::uint32_t below = n == Node_index().value() ? leaf_flag : leaf_or_family_[n];
      first_child[i] = (below & leaf_flag) != 0 ? n : 4 * below + 1;
      is_split[i] = (below & leaf_flag) != 0 ? 0 : 3;
    }
    std::array<std::uint32_t, 8> result;
    for (std::size_t d = 0; d < 8; ++d) {
      const std::size_t i = steps.around[d];
      result[d] = first_child[i] + (steps.child[d] & is_split[i]);
    }
    return result;
  }

  /// The leaves below a split square, in shuffle order, are those from `first_leaf()` to `last_leaf()`.
  std::uint32_t first_leaf(Node_index v) const { return is_leaf(v) ? leaf(v) : first_leaf_[family(v)]; }
  std::uint32_t last_leaf(Node_index v) const { return is_leaf(v) ? leaf(v) : last_leaf_[family(v)]; }

  /// The rank of the first point in the square of `v`, or where it would be.
  std::uint32_t point_begin(Node_index v) const { return point_begin_[v.value()]; }

  /// The number of levels that have split squares.
  int number_of_split_levels() const { return static_cast<int>(level_begin_.size()) - 1; }
  /// The families of the split squares of level `l` are those from `level_begin(l)` to `level_begin(l + 1)`.
  std::uint32_t level_begin(int l) const { return level_begin_[std::size_t(l)]; }

private:
  template <class, class>
  friend class Square_grower;
  template <class, class>
  friend class Spaced_levels_grower;
  template <class, class>
  friend class Band_leaves;

  static constexpr std::uint32_t leaf_flag = 0x80000000u;
  static constexpr std::size_t max_families = std::size_t(1) << 29; // leaves must stay below the flag
  using Level = typename Word_operations<Word>::Level;
  static constexpr bool are_corners_stored = Word_operations<Word>::are_corners_stored;

  static std::uint32_t family_of(Node_index v) { return (v.value() - 1) / 4; }
  static int member_of(Node_index v) { return static_cast<int>((v.value() - 1) % 4); }
  static Node_index member(std::uint32_t f, int q) {
    return Node_index(4 * std::size_t(f) + 1 + std::size_t(q));
  }

  Grid_point corner_of_family(std::uint32_t f) const {
    if constexpr (are_corners_stored) {
      return corner_[f];
    } else {
      Grid_point c{0, 0};
      for (Node_index v(node_[f]); v.value() != 0; v = parent(v))
        move_to_child(c, member_of(v), depth_ - static_cast<int>(family_level_[family_of(v)]) - 1);
      return c;
    }
  }

  /// Makes room for `n` families and their children.
  void resize(std::size_t n) {
    if (n >= max_families) throw std::length_error("Balanced_quadtree: too many squares");
    leaf_or_family_.resize(4 * n + 1);
    point_begin_.resize(4 * n + 1);
    node_.resize(n);
    if (are_corners_stored) corner_.resize(n);
    family_level_.resize(n);
    neighbors_.resize(n);
  }

  void reserve(std::size_t n) {
    leaf_or_family_.reserve(4 * n + 1);
    point_begin_.reserve(4 * n + 1);
    node_.reserve(n);
    if (are_corners_stored) corner_.reserve(n);
    family_level_.reserve(n);
    neighbors_.reserve(n);
  }

  /// Numbers the leaves in shuffle order and finds the leaves of points, which are as many as `points`: counts
  /// leaves from the deepest level up, places them from the root down.
  template <class ConcurrencyTag>
  void number_leaves(std::size_t points) {
    const std::size_t n = number_of_families();
    resize_to_write(first_leaf_, n);
    resize_to_write(last_leaf_, n);
    node_of_leaf_.resize(number_of_nodes() - n);
    leaf_of_point_.resize(points);
    if (n == 0) {
      place_leaf(0, 0, 0, static_cast<std::uint32_t>(points));
      return;
    }
    auto& count = last_leaf_; // until the place is known
    for (int l = number_of_split_levels(); l-- > 0;)
      for_each_family_of_level<ConcurrencyTag>(l, [&](std::uint32_t f) {
        count[f] = 0;
        for (int q = 0; q < 4; ++q) {
          const Node_index v = member(f, q);
          count[f] += is_leaf(v) ? 1 : count[family(v)];
        }
      });
    Uninitialized_vector<std::uint32_t> point_end;
    resize_to_write(point_end, n);
    first_leaf_[0] = 0;
    point_end[0] = static_cast<std::uint32_t>(points);
    for (int l = 0; l < number_of_split_levels(); ++l)
      for_each_family_of_level<ConcurrencyTag>(l, [&](std::uint32_t f) {
        std::uint32_t next = first_leaf_[f];
        for (int q = 0; q < 4; ++q) {
          const std::uint32_t v = member(f, q).value();
          const std::uint32_t end = q < 3 ? point_begin_[v + 1] : point_end[f];
          if (is_leaf(Node_index(v))) {
            place_leaf(next++, v, point_begin_[v], end);
          } else {
            const std::uint32_t below = family(Node_index(v));
            first_leaf_[below] = next;
            point_end[below] = end;
            next += count[below];
          }
        }
        last_leaf_[f] = next - 1;
      });
  }

  void place_leaf(std::uint32_t leaf, std::uint32_t node, std::uint32_t point_begin,
                  std::uint32_t point_end) {
    leaf_or_family_[node] = leaf_flag | leaf;
    node_of_leaf_[leaf] = node;
    for (std::uint32_t r = point_begin; r < point_end; ++r) leaf_of_point_[r] = leaf;
  }

  template <class ConcurrencyTag, class F>
  void for_each_family_of_level(int l, const F& f) const {
    const std::uint32_t first = level_begin(l);
    for_each_index<ConcurrencyTag>(
        level_begin(l + 1) - first, [&](std::size_t i) { f(first + static_cast<std::uint32_t>(i)); },
        default_block / 4);
  }

  static constexpr std::array<Sibling_steps, 4> sibling_steps_ = make_sibling_steps();

  int depth_ = 0;

  // By node: the leaf with the flag, or the family; the first point.
  Uninitialized_vector<std::uint32_t> leaf_or_family_;
  Uninitialized_vector<std::uint32_t> point_begin_;

  // By family; of the split square.
  Uninitialized_vector<std::uint32_t> node_;
  Uninitialized_vector<Grid_point> corner_; // or empty
  Uninitialized_vector<Level> family_level_;
  Uninitialized_vector<std::array<std::uint32_t, 8>> neighbors_;
  Uninitialized_vector<std::uint32_t> first_leaf_;
  Uninitialized_vector<std::uint32_t> last_leaf_;

  // By level of split squares.
  std::vector<std::uint32_t> level_begin_{0};

  // By leaf; by rank of a point.
  Uninitialized_vector<std::uint32_t> node_of_leaf_;
  Uninitialized_vector<std::uint32_t> leaf_of_point_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_LINKED_SQUARES_H
