// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

/// \ingroup PkgQuadtreeMesh2Concepts
/// \cgalConcept
///
/// The concept `QuadtreeGrid_2` describes the map between points and the integer grid on which a quadtree lives.
///
/// The root of the quadtree is the square [0, 2^B) x [0, 2^B) of grid units, where B is the depth of the grid. A grid
/// is default constructible and copyable. Several threads may call its `const` members at once if they may read the
/// points.
///
/// The meshers ask for more than quadtrees do. Over doubles, exact numbers and coordinates of your own the root's side
/// is a power of two, its origin is a multiple of a power of two, and the points lie in its middle half. Over words the
/// grid is that of the integers, as in `CGAL::Fixed_point_quadtree_traits_2`.
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Filtered_quadtree_traits_2::Grid_2}
/// \cgalHasModels{CGAL::Fixed_point_quadtree_traits_2::Grid_2}
/// \cgalHasModels{CGAL::Exact_quadtree_traits_2::Grid_2}
/// \cgalHasModelsEnd
///
/// \sa `QuadtreeTraits_2`
class QuadtreeGrid_2 {
public:
  /// \name Types
  /// @{

  /// A point that the grid maps: `QuadtreeTraits_2::Point_2`.
  typedef unspecified_type Point_2;

  /// A pair of grid coordinates: `QuadtreeTraits_2::Grid_point`.
  typedef unspecified_type Grid_point;

  /// @}

  /// \name Operations
  /// @{

  /// Returns the logarithm B of the root's side in grid units. If words have a fixed length, it is less than the
  /// number of their bits, so that upper corners are representable.
  int depth() const;

  /// Makes the unit of the grid finer by a power of two, and thus the depth greater. It neither moves nor resizes the
  /// root, and returns `true`. If words cannot be longer, it leaves the grid unchanged and returns `false`. If it never
  /// returns `false`, it tells any two distinct points apart after finitely many calls.
  bool refine();

  /// Returns whether `p` lies in the root.
  bool is_in_root(const Point_2& p) const;

  /// Returns the lower left corner of the unit square of the grid that contains `p`, without rounding.
  /// \pre `is_in_root(p)`
  Grid_point grid_point(const Point_2& p) const;

  /// Returns the point at the crossing of two grid lines, including coordinates 2^B. It is exact whenever the type of
  /// points can represent it.
  Point_2 point(const Grid_point& g) const;

  /// @}
};
