// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_LEAF_NEIGHBORS_H
#define CGAL_QUADTREE_MESH_2_LEAF_NEIGHBORS_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// The leaves around a leaf of a balanced quadtree, counterclockwise from the east. The range allocates no
/// memory.
class Leaf_neighbors {
public:
  /// \name Types
  /// @{

  /// What the range has.
  using value_type = Leaf_index;
  /// Goes through the leaves.
  using const_iterator = const Leaf_index*;
  /// @}

  /// \name Access
  /// @{

  /// The first leaf.
  const_iterator begin() const { return leaves_.data(); }
  /// Behind the last leaf.
  const_iterator end() const { return leaves_.data() + size_; }
  /// The number of leaves.
  std::size_t size() const { return size_; }
  /// The leaf of this place in the range.
  Leaf_index operator[](std::size_t i) const { return leaves_[i]; }
  /// @}

  /// Appends a leaf unless it equals the last one: a large leaf occurs in several consecutive directions.
  void append(Leaf_index l) {
    if (size_ == 0 || leaves_[size_ - 1] != l) leaves_[size_++] = l;
  }
  /// Removes the last leaf if it equals the first one.
  void close() {
    if (size_ > 1 && leaves_[size_ - 1] == leaves_[0]) --size_;
  }

private:
  std::array<Leaf_index, 13> leaves_{}; // two for each side, one for each corner, and one to close
  std::size_t size_ = 0;
};

} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_LEAF_NEIGHBORS_H
