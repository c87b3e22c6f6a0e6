// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The pieces of segments in the leaves of a quadtree, by walking along the segments.
//
// Computes: for each segment the leaves that it passes through, in order (Edge_pieces.h).
// Bound:    O(m + k) work for m segments with k pieces, because a cross pointer leads from leaf to leaf if
//           the tree is balanced. One parallel round, as long as the pieces of a block of segments.
// Source:   Bern, Eppstein, Teng, Theorem 6: "simply walk from one end of each edge to the other, keeping
//           track of the crossed squares".
// Deviates: segments are independent of each other, so all walk at the same time.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_WALK_EDGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_WALK_EDGES_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Edge_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Grid_path.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Goes along a path from leaf to leaf.
template <class Tree>
class Path_walker {
public:
  using Word = typename Tree::Word;
  using Path = Grid_path<Word>;
  using Cut = typename Path::Cut;
  using Coordinate = typename Path::Coordinate;

  /// \param start the leaf of the path's first end
  Path_walker(const Tree& tree, const Path& path, Leaf_index start)
      : tree_(tree), path_(path), depth_(tree.framework().grid().depth()), node_(tree.node(start)) {
    const auto square = tree.square(node_);
    corner_ = {square.x, square.y};
    level_ = square.level;
  }

  Leaf_index leaf() const { return tree_.leaf(node_); }

  /// Goes on to the next leaf.
  /// \pre the path does not end in this one
  void step() {
    const Coordinate side = side_of(level_);
    const Cut x = path_.exit(0, Coordinate(corner_.x), side), y = path_.exit(1, Coordinate(corner_.y), side);
    const int order = path_.compare(x, y);
    const int dx = order <= 0 ? path_.step(0) : 0, dy = order >= 0 ? path_.step(1) : 0;
    node_ = tree_.neighbor(node_, direction(dx, dy));
    move(corner_.x, dx);
    move(corner_.y, dy);
    const int level = tree_.level(node_);
    if (level < level_) corner_ = corner_of_square(corner_, level, depth_);
    level_ = level;
    const Cut& entry = order <= 0 ? x : y;
    while (!tree_.is_leaf(node_)) enter_child(entry, dx != 0, dy != 0);
  }

private:
  Coordinate side_of(int level) const {
    return Coordinate(Word_operations<Word>::power_of_two(depth_ - level));
  }

  /// Moves a coordinate by the side of the square.
  void move(Word& coordinate, int step) const {
    if (step > 0) coordinate += Word_operations<Word>::power_of_two(depth_ - level_);
    if (step < 0) coordinate -= Word_operations<Word>::power_of_two(depth_ - level_);
  }

  /// Goes down to the child that the path enters at a cut, on the sides that it has crossed.
  void enter_child(const Cut& entry, bool crosses_x, bool crosses_y) {
    const int q = 2 * half(0, Coordinate(corner_.x), entry, crosses_x) +
                  half(1, Coordinate(corner_.y), entry, crosses_y);
    node_ = tree_.child(node_, q);
    ++level_;
    move_to_child(corner_, q, depth_ - level_);
  }

  /// In which half of a column or row the path is behind a cut, 1 for the right or upper one.
  int half(std::size_t axis, const Coordinate& low, const Cut& entry, bool is_crossed) const {
    const bool is_far =
        !is_crossed && path_.compare(path_.cut(axis, Coordinate(low + side_of(level_ + 1))), entry) <= 0;
    return is_far == path_.is_ascending(axis) ? 1 : 0;
  }

  const Tree& tree_;
  const Path& path_;
  int depth_;
  Node_index node_;
  Grid_point_2<Word> corner_;
  int level_;
};

/// Calls `f(leaf)` for the leaves that a segment passes, from its first end to its second.
template <class Tree, class Segment, class F>
void walk_edge(const Tree& tree, const Segment& ends, const F& f) {
  const auto path = path_of_segment(tree, ends);
  const Leaf_index last = tree.leaf(Point_index(ends[1].value()));
  Path_walker<Tree> walker(tree, path, tree.leaf(Point_index(ends[0].value())));
  for (; walker.leaf() != last; walker.step()) f(walker.leaf());
  f(last);
}

/// Returns the pieces of segments, each given by its two vertices, which are points of the tree.
/// \throws std::length_error if there are 2^32 pieces or more
template <class ConcurrencyTag, class Tree, class Segments>
Edge_pieces walk_edges(const Tree& tree, const Segments& segments) {
  constexpr std::size_t block = 256;
  const std::size_t m = segments.size();
  std::vector<std::uint32_t> begin(m + 1);
  std::vector<Leaf_index> leaves;
  // A block walks once, into a list of its own: a second walk would take longer than copying.
  std::vector<std::vector<Leaf_index>> of_block((m + block - 1) / block);
  const std::size_t sum = count_allocate_and_place<ConcurrencyTag>(
      m,
      [&](std::size_t first, std::size_t last) {
        std::vector<Leaf_index>& list = of_block[first / block];
        for (std::size_t s = first; s < last; ++s) {
          begin[s] = static_cast<std::uint32_t>(list.size());
          walk_edge(tree, segments[s], [&](Leaf_index l) { list.push_back(l); });
        }
        return list.size();
      },
      [&](std::size_t n) {
        if (n > std::size_t(0xffffffffu)) throw std::length_error("too many pieces of segments");
        leaves.resize(n);
      },
      [&](std::size_t first, std::size_t last, std::size_t place) {
        std::vector<Leaf_index> list;
        list.swap(of_block[first / block]);
        std::copy(list.begin(), list.end(), leaves.begin() + static_cast<std::ptrdiff_t>(place));
        for (std::size_t s = first; s < last; ++s) begin[s] += static_cast<std::uint32_t>(place);
      },
      block);
  begin[m] = static_cast<std::uint32_t>(sum);
  return Edge_pieces(std::move(begin), std::move(leaves));
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_WALK_EDGES_H
