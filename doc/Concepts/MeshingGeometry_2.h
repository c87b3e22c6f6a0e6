// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

/// \ingroup PkgQuadtreeMesh2Concepts
/// \cgalConcept
///
/// The concept `MeshingGeometry_2` describes the arithmetic of the meshers: which numbers coordinates are, and which
/// predicates and constructions they have. Traits name a model as `QuadtreeTraits_2::Meshing_geometry_2`.
///
/// There is a model for each kind of coordinates. Traits of your own take one of these, and their `Point_2` has what is
/// asked for here:
///
/// | coordinates | model | besides `x()` and `y()`, `Point_2` can be made from |
/// |---|---|---|
/// | `double` | `CGAL::Filtered_quadtree_traits_2<Kernel>::Meshing_geometry_2` | two doubles: `Point_2(x, y)` |
/// | words | `CGAL::Fixed_point_quadtree_traits_2<Word>::Meshing_geometry_2` | two words: `Point_2{x, y}` |
/// | exact | `CGAL::Exact_quadtree_traits_2<Kernel>::Meshing_geometry_2` | `Point_2` is that of the kernel |
///
/// Points are default constructible, copyable and equality comparable, too. The kernel gives exact predicates over
/// doubles; only its orientation and its circle test are used.
///
/// The set of models is closed. What is below is what all models have in common and traits may rely on. Meshers ask
/// for more, by names that are not public and may change:
///
/// - differences as vectors of `Number`, a point moved by a vector, and areas of triangles so flat that differences
///   do not tell them
/// - a circle test that is certain rather than exact, so that flips end whatever is rounded
/// - how far a coordinate is from the next one, at which distance from a point there is no place for another, and the
///   least distance of vertices that is meshed
/// - points brought back to a line from which rounding took them, and shares of a way that keep coordinates short
/// - the map between `Point_2` and `Point`, which scales by powers of two and says what rounding may change. It is
///   chosen by the model, so each model needs one of its own
/// - for `Point_set_mesher_2`, steps of powers of two along coordinates, and how many of them there is room for
///
/// `Number` is `double`, or a number that neither overflows nor underflows: bounds of errors are known for these two.
///
/// \sa `QuadtreeTraits_2`
/// \sa `QuadtreeGrid_2`
class MeshingGeometry_2 {
public:
  /// \name Types
  /// @{

  /// The place of a vertex, as the mesher keeps it.
  typedef unspecified_type Point;

  /// A coordinate of it.
  typedef unspecified_type Coordinate;

  /// Lengths of anything in a mesh, and products of four of them.
  typedef unspecified_type Number;

  /// @}

  /// \name Predicates
  /// These are exact.
  /// @{

  /// Returns the sign of the turn at `b` of the way from `a` to `c`: 1 to the left, -1 to the right, 0 if there is
  /// none.
  static int orientation(Point a, Point b, Point c);

  /// Returns 1 if `d` lies inside the circle through `a`, `b` and `c`, 0 if on it, -1 if outside.
  /// \pre `a`, `b` and `c` are counterclockwise
  static int side_of_circle(Point a, Point b, Point c, Point d);

  /// @}

  /// \name Constructions
  /// These round where `Coordinate` has to.
  /// @{

  /// Returns the point at a share of the way from `p` to `q`.
  static Point between(Point p, Point q, Number share);

  /// Returns the corner next to `p` of the squares of a quadtree with this side, a power of two.
  static Point nearest_corner(Point p, Number side);

  /// @}
};
