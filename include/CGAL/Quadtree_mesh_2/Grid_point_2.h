// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_GRID_POINT_2_H
#define CGAL_QUADTREE_MESH_2_GRID_POINT_2_H

#include <ostream>
#include <type_traits>

namespace CGAL {
namespace Quadtree_mesh_2 {

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// A point of the integer grid on which quadtrees live.
/// \tparam Word_ an integer type, unsigned or of unlimited length.
template <class Word_>
struct Grid_point_2 {
  static_assert(!std::is_integral<Word_>::value || std::is_unsigned<Word_>::value,
                "grid coordinates are not negative");
  using Word = Word_; ///< the type of coordinates

  // Not initialized, so that large arrays of points are not cleared before they are filled.
  Word x; ///< from the left side of the root
  Word y; ///< from its lower side

  /// Whether the places are the same.
  friend constexpr bool operator==(const Grid_point_2& a, const Grid_point_2& b) {
    return a.x == b.x && a.y == b.y;
  }
  /// Whether the places differ.
  friend constexpr bool operator!=(const Grid_point_2& a, const Grid_point_2& b) { return !(a == b); }
  /// Writes both coordinates, with a space between them.
  friend std::ostream& operator<<(std::ostream& out, const Grid_point_2& p) {
    return out << p.x << ' ' << p.y;
  }
};

/// \ingroup PkgQuadtreeMesh2Quadtrees
/// The root has level 0. A square of level `l` has side `2^(depth - l)` grid units and corners at multiples
/// of its side; `depth` is that of the grid. A square is half open: of its border it contains only the lower
/// and left sides.
/// \tparam Word_ as for `Grid_point_2`.
template <class Word_>
struct Quadtree_square_2 {
  using Word = Word_; ///< the type of coordinates

  Word x = 0;    ///< where its left side is
  Word y = 0;    ///< where its lower side is
  int level = 0; ///< 0 for the root

  /// Whether places and levels are the same.
  friend constexpr bool operator==(const Quadtree_square_2& a, const Quadtree_square_2& b) {
    return a.x == b.x && a.y == b.y && a.level == b.level;
  }
  /// Whether the squares differ.
  friend constexpr bool operator!=(const Quadtree_square_2& a, const Quadtree_square_2& b) {
    return !(a == b);
  }
  /// Writes the lower left corner and the level.
  friend std::ostream& operator<<(std::ostream& out, const Quadtree_square_2& s) {
    return out << s.x << ' ' << s.y << " level " << s.level;
  }
};

} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_GRID_POINT_2_H
