// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Which leaves of a quadtree have passed which tests, while the tree is refined.
//
// Computes: the leaves for which a test has to be made. One that looks at a leaf alone, or at the graph around it
//           whatever leaves there are, has the same answer until the leaf is split. One that looks at the leaves next
//           to it, too, has the same answer until one of these is split.
// Bound:    O(k) work for a tree of k leaves each time it is refined, whatever the length of its coordinates.
//           If a tree gets k leaves in any number of rounds, O(k) tests are made of leaves alone.
// Method:   leaf_succession.h tells which leaves are still there, and which are in the place of another.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PASSED_LEAVES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PASSED_LEAVES_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/leaf_succession.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What a test of a leaf looks at; one bit each.
enum class Leaf_test : std::uint8_t { OF_LEAF_ALONE = 1, OF_LEAF_AND_NEIGHBORS = 2, OF_GRAPH_AROUND = 4 };

class Passed_leaves {
public:
  bool has_passed(Leaf_index l, Leaf_test test) const {
    return (passed_[l] & static_cast<std::uint8_t>(test)) != 0;
  }
  /// Several threads may tell of different leaves at once.
  void pass(Leaf_index l, Leaf_test test) { passed_[l] |= static_cast<std::uint8_t>(test); }

  /// Follows a tree, of which nothing was known, or all leaves of which are the same as before or were split.
  template <class Tree>
  void follow(const Tree& tree) {
    std::vector<int> levels = levels_of_leaves(tree);
    Indexed_vector<Leaf_index, std::uint8_t> passed(levels.size(), 0);
    std::vector<Leaf_index> fresh;
    for_each_successor(
        levels_, levels, [&](Leaf_index old, Leaf_index now) { passed[now] = passed_[old]; },
        [&](Leaf_index l) { fresh.push_back(l); });
    levels_ = std::move(levels);
    passed_ = std::move(passed);
    for (const Leaf_index l : fresh)
      for (const Leaf_index n : tree.neighbors(l))
        passed_[n] &= static_cast<std::uint8_t>(~static_cast<unsigned>(Leaf_test::OF_LEAF_AND_NEIGHBORS));
  }

private:
  std::vector<int> levels_;
  Indexed_vector<Leaf_index, std::uint8_t> passed_; // a set of `Leaf_test`
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_PASSED_LEAVES_H
