// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_OPTIONS_H
#define CGAL_QUADTREE_OPTIONS_H

#include <cstddef>

namespace CGAL {

namespace Quadtree_mesh_2 {

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Which pairs of leaves of a quadtree may differ in size by at most a factor of two.
enum class Balance {
  /// Any leaves may differ: the unbalanced quadtree of Theorem 1.
  NONE,
  /// Leaves that share a part of a side.
  SIDES,
  /// Leaves that share a part of a side or a corner; what meshes need.
  SIDES_AND_CORNERS
};

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// The order in which a quadtree is balanced. Both give the same tree, the smallest balanced one, with the same
/// numbers.
enum class Balance_schedule {
  /// Level by level, in as many parallel rounds as there are levels and O(n + k) work for n points and k squares.
  LEVEL_BY_LEVEL,
  /// Theorem 2, but with the fewest squares: O(log n) parallel rounds, whatever the depth, and O(n log n + k) work.
  /// What is split on levels about log2 n apart follows from the points alone. The levels between them are filled
  /// at the same time. For balanced trees of points and annotations. Unbalanced trees, size functions and
  /// `Balanced_quadtree::refine()` work level by level.
  SPACED_LEVELS
};

} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// Options of `Balanced_quadtree`. Each option is set by the function of its name, which returns the options,
/// so that calls can be chained. Without an argument the function returns the value.
class Quadtree_options {
public:
  /// \name Types
  /// @{

  /// Which neighbors are balanced.
  using Balance = Quadtree_mesh_2::Balance;
  /// How balance is reached.
  using Balance_schedule = Quadtree_mesh_2::Balance_schedule;
  /// @}

  /// The most points that a leaf may hold, at least 1; 1 by default.
  Quadtree_options& max_points_per_leaf(std::size_t value) { return max_points_per_leaf_ = value, *this; }
  std::size_t max_points_per_leaf() const { return max_points_per_leaf_; } ///< the value set

  /// Which neighbors are balanced, `Balance::SIDES_AND_CORNERS` by default.
  Quadtree_options& balance(Balance value) { return balance_ = value, *this; }
  Balance balance() const { return balance_; } ///< the value set

  /// How balance is reached, `Balance_schedule::LEVEL_BY_LEVEL` by default.
  Quadtree_options& schedule(Balance_schedule value) { return schedule_ = value, *this; }
  Balance_schedule schedule() const { return schedule_; } ///< the value set

private:
  std::size_t max_points_per_leaf_ = 1;
  Balance balance_ = Balance::SIDES_AND_CORNERS;
  Balance_schedule schedule_ = Balance_schedule::LEVEL_BY_LEVEL;
};

} // namespace CGAL

#endif // CGAL_QUADTREE_OPTIONS_H
