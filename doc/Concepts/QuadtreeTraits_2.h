// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

/// \ingroup PkgQuadtreeMesh2Concepts
/// \cgalConcept
///
/// The concept `QuadtreeTraits_2` describes what quadtrees need to know about points: a grid of integers, the
/// map from points to the grid, and the map from corners of squares back to points.
///
/// The root of all quadtrees is the square [0, 2^B) x [0, 2^B) of grid units, where B is
/// the depth of the grid. A square of level l has side 2^(B-l) and corners at multiples of
/// its side. Quadtrees make all decisions on grid coordinates, which are integers. So all decisions are exact.
///
/// If distinct points fall on one grid point, quadtrees ask for a finer grid of the same root and map all
/// points again. Models whose words have a fixed length refuse that, and the points are an error.
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Filtered_quadtree_traits_2<Kernel>}
/// \cgalHasModels{CGAL::Fixed_point_quadtree_traits_2<Word>}
/// \cgalHasModels{CGAL::Exact_quadtree_traits_2<Kernel>}
/// \cgalHasModelsEnd
///
/// \sa `QuadtreeGrid_2`
/// \sa `MeshingGeometry_2`
/// \sa `CGAL::Quadtree_framework<Traits>`
/// \sa `CGAL::Balanced_quadtree<Traits>`
class QuadtreeTraits_2 {
public:
  /// \name Types
  /// @{

  /// The type of input points; copyable and equality comparable.
  typedef unspecified_type Point_2;

  /// The type of grid coordinates: `std::uint32_t` or `std::uint64_t`, or
  /// `boost::multiprecision::cpp_int`, an integer type of unlimited length. Its values are never negative.
  typedef unspecified_type Word;

  /// `CGAL::Quadtree_mesh_2::Grid_point_2<Word>`, with members `x` and `y`.
  typedef unspecified_type Grid_point;

  /// The map between points and the grid: a model of `QuadtreeGrid_2`.
  typedef unspecified_type Grid_2;

  /// A function object that makes the grid of a set of points, by
  /// `Grid_2 operator()(const PointRange& points) const`, where `PointRange` is a range with value type
  /// `Point_2`.
  ///
  /// All points lie in the root of the result. If the points' type does not fix the grid, the points lie in the
  /// middle half of the root, the root's side is a power of two, and its origin is a multiple of a power of
  /// two.
  ///
  /// If a point cannot be mapped, it throws `CGAL::Quadtree_mesh_2::Point_error`, which names the point. It may
  /// map distinct points to the same grid point. Quadtrees notice that and refine the grid, or throw if the grid
  /// refuses.
  typedef unspecified_type Construct_grid_2;

  /// The arithmetic of the meshers on these points: a model of `MeshingGeometry_2`. Quadtrees do not use it, so an
  /// incomplete type suffices for them.
  typedef unspecified_type Meshing_geometry_2;

  /// @}

  /// \name Operations
  /// @{

  /// Returns the function object that makes grids.
  Construct_grid_2 construct_grid_2_object() const;

  /// @}
};
