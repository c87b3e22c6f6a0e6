// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where the vertices that a rule places may be others than before, after leaves of a quadtree were split.
//
// Computes: the leaves up to two away from one that was split or that has another label, and all of a label that is
//           among them; the edges with pieces in these leaves.
// Bound:    O(k) work for k leaves, and O(1) for each leaf and each piece of the scope.
// Source:   ours.
//
// A rule that decides about a corner by the leaves around it, and by vertices in leaves next to those, decides as
// before about each corner that no leaf of the scope owns. One that places vertices on an edge by the leaves that it
// passes places the same ones on each edge that is not in the scope.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_PLACEMENT_SCOPE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_PLACEMENT_SCOPE_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Edge_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/leaf_succession.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Leaves of a tree and edges; all of them, if there are no others to be told from.
struct Placement_scope {
  bool is_all = true;
  std::vector<Leaf_index> leaves;             ///< of a part; in order
  std::vector<Segment_index> segments;        ///< of a part; in order
  Indexed_vector<Leaf_index, char> is_inside; ///< of a part

  bool has(Leaf_index l) const { return is_all || is_inside[l] != 0; }
  bool has(Segment_index s) const {
    return is_all || std::binary_search(segments.begin(), segments.end(), s);
  }

  /// How many there are of n, and which.
  std::size_t number_of_leaves(std::size_t n) const { return is_all ? n : leaves.size(); }
  std::size_t number_of_segments(std::size_t n) const { return is_all ? n : segments.size(); }
  Leaf_index leaf(std::size_t i) const { return is_all ? Leaf_index(i) : leaves[i]; }
  Segment_index segment(std::size_t i) const { return is_all ? Segment_index(i) : segments[i]; }

  /// Adds the leaves that are next to those of a part, so many times.
  template <class Tree>
  void grow(const Tree& tree, int times) {
    std::size_t first = 0;
    for (int i = 0; i < times; ++i) {
      const std::size_t last = leaves.size();
      for (; first < last; ++first)
        for (const Leaf_index n : tree.neighbors(leaves[first])) add(n);
    }
    std::sort(leaves.begin(), leaves.end());
  }

  void add(Leaf_index l) {
    if (is_inside[l] != 0) return;
    is_inside[l] = 1;
    leaves.push_back(l);
  }
};

class Placement_scopes {
public:
  static constexpr std::uint32_t no_label = 0xffffffffu;

  /// What has to be placed anew in a tree whose leaves are those of the last call, or were split since. It is all at
  /// the first call, and where a part would be large.
  /// \param label gives what else matters about a leaf, or `no_label`
  template <class Tree, class Label>
  Placement_scope next(const Tree& tree, const Leaf_pieces& pieces, const Label& label) {
    std::vector<int> levels = levels_of_leaves(tree);
    Indexed_vector<Leaf_index, std::uint32_t> labels(levels.size());
    for (const Leaf_index l : labels.ids()) labels[l] = label(l);
    Placement_scope scope;
    if (!levels_.empty()) {
      scope.is_all = false;
      scope.is_inside.resize(levels.size(), 0);
      for_each_successor(
          levels_, levels,
          [&](Leaf_index old, Leaf_index now) {
            if (labels_[old] != labels[now]) scope.add(now);
          },
          [&](Leaf_index l) { scope.add(l); });
      scope.grow(tree, reach_);
      add_labels(labels, scope);
      scope.is_all = scope.leaves.size() > levels.size() / large_part_;
    }
    if (!scope.is_all) add_segments(pieces, scope);
    levels_ = std::move(levels);
    labels_ = std::move(labels);
    return scope;
  }

private:
  static constexpr int reach_ = 2;
  static constexpr std::size_t large_part_ = 8; // to place all is faster then

  std::vector<int> levels_; // of all leaves
  Indexed_vector<Leaf_index, std::uint32_t> labels_;

  static void add_labels(const Indexed_vector<Leaf_index, std::uint32_t>& labels, Placement_scope& scope) {
    std::vector<std::uint32_t> inside;
    for (const Leaf_index l : scope.leaves)
      if (labels[l] != no_label) inside.push_back(labels[l]);
    if (inside.empty()) return;
    sort_and_drop_equal(inside);
    for (const Leaf_index l : labels.ids())
      if (labels[l] != no_label && std::binary_search(inside.begin(), inside.end(), labels[l])) scope.add(l);
    std::sort(scope.leaves.begin(), scope.leaves.end());
  }

  static void add_segments(const Leaf_pieces& pieces, Placement_scope& scope) {
    for (const Leaf_index l : scope.leaves)
      for (const Edge_piece& piece : pieces[l]) scope.segments.push_back(piece.segment);
    sort_and_drop_equal(scope.segments);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_PLACEMENT_SCOPE_H
