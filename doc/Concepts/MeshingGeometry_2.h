// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

/// \ingroup PkgQuadtreeMesh2Concepts
/// \cgalConcept
///
/// The concept `MeshingGeometry_2` describes the arithmetic of the meshers: which coordinates there are, how they are
/// rounded, and which predicates they have. Traits name a model as `QuadtreeTraits_2::Meshing_geometry_2`.
///
/// The package has a geometry for each kind of coordinates. Traits of your own may name one of these if their `Point_2`
/// has what is asked for here:
///
/// | coordinates | geometry | besides `x()` and `y()`, `Point_2` can be made from |
/// |---|---|---|
/// | `double` | `CGAL::Filtered_quadtree_traits_2<Kernel>::Meshing_geometry_2` | two doubles: `Point_2(x, y)` |
/// | words | `CGAL::Fixed_point_quadtree_traits_2<Word>::Meshing_geometry_2` | two words: `Point_2{x, y}` |
/// | exact | `CGAL::Exact_quadtree_traits_2<Kernel>::Meshing_geometry_2` | `Point_2` is that of the kernel |
///
/// Or they name a geometry of your own, with all that is listed below. It is for coordinates that are rounded, such as
/// numbers of single or double precision, or integers. For exact numbers take the package's. `Quality_mesher_2` meshes
/// over any model, with all its options; `Point_set_mesher_2` only over the package's geometries. If a part is missing,
/// the compiler names it.
///
/// In any case, `Point_2` is default constructible, copyable and equality comparable.
///
/// All functions are static. With `CGAL::Parallel_tag` several threads call them at once. Everything that a mesh is
/// (which side, inside which circle) is decided by the predicates, so they have to be exact. Everything that is only
/// better or worse (angles, places for vertices) is computed in doubles from differences.
///
/// The meshers multiply four lengths with each other. Such products, and their inverses, have to be doubles for all
/// lengths from `least_length` up to four times the extent of the input: for lengths from 2^-220 to 2^220 they are.
/// Coordinates have to reach further than the input: its box, three times as wide and high to all sides.
///
/// \ref page_user_manual_a_geometry_of_your_own "The manual" has a geometry of floats, and `examples/own_geometry.cpp`
/// the traits that name it, too.
///
/// \sa `QuadtreeTraits_2`
/// \sa `QuadtreeGrid_2`
class MeshingGeometry_2 {
public:
  /// \name Types
  /// @{

  /// A coordinate: default constructible, copyable, and compared by `<` and `==`.
  typedef unspecified_type Coordinate;

  /// The place of a vertex, as the mesher keeps it, with members `x` and `y` that are a `Coordinate`. It is default
  /// constructible, trivially copyable, and equality comparable by `==`.
  typedef unspecified_type Point;

  /// A difference of points: made by `Vector{x, y}` of two doubles, its members `x` and `y`. It needs no operators.
  typedef unspecified_type Vector;

  /// The map between `QuadtreeTraits_2::Point_2` and `Point`: copies of a mesh in the user's coordinates and in the
  /// mesher's, which may be scaled. A map has
  ///
  /// - `Coordinate_map(const std::vector<Point_2>& points)`: the map for these points, which are not all of those that
  ///   will be mapped. There is at least one. If the grid of the traits refuses points, it does so afterward: until
  ///   then coordinates may be anything, such as infinite.
  /// - `Point to_mesher(const Point_2& p) const`: the mesher's point for a point of the input, or a corner of a square
  ///   of a quadtree. It keeps order along the axes.
  /// - `Point_2 from_mesher(const Point& p) const`: the user's point for a vertex. It keeps order along the axes, too,
  ///   and `from_mesher(to_mesher(p)) == p` for points of the input.
  /// - `double scale() const`: how long the mesher takes a length of 1 for, a power of two.
  ///
  /// The simplest map is that of coordinates that stay what they are. Vertices of the input that do not come back are
  /// an error (`Pslg_error_2::Kind::OUT_OF_RANGE`), and so are triangles that do not come back counterclockwise
  /// (`Pslg_error_2::Kind::ROUNDING`).
  typedef unspecified_type Coordinate_map;

  /// @}

  /// \name Constants
  /// @{

  /// Vertices nearer to each other, or to a segment, are an error (`Pslg_error_2::Kind::TOO_NEAR`). 0 if there cannot
  /// be any so near that products of four lengths are no doubles, as with integers. A constant expression.
  static constexpr double least_length;

  /// @}

  /// \name Predicates
  /// These are exact.
  /// @{

  /// Returns the sign of the turn at `b` of the way from `a` to `c`: positive to the left, negative to the right, 0 if
  /// there is none.
  static int orientation(Point a, Point b, Point c);

  /// Returns a positive number if `d` lies inside the circle through `a`, `b` and `c`, 0 if on it, a negative one if
  /// outside.
  /// \pre `a`, `b` and `c` are counterclockwise
  static int side_of_circle(Point a, Point b, Point c, Point d);

  /// @}

  /// \name Measures
  /// @{

  /// Returns `p - q`. Each component is rounded once, to the nearest double.
  static Vector difference(Point p, Point q);

  /// Returns twice the signed area of the triangle `a`, `b`, `c`, with a relative error below 10^-4 however flat it is.
  /// The mesher asks for it only where `difference()` does not tell.
  static double doubled_area(Point a, Point b, Point c);

  /// Returns how far the coordinates next to one of this magnitude are from each other, a power of two: 1 for integers,
  /// the unit in the last place for floating-point numbers.
  static double spacing(Coordinate c);

  /// @}

  /// \name Constructions
  /// These round each coordinate to one of the two that are next to the exact result.
  /// @{

  /// Returns the point `p + v`.
  static Point translate(Point p, Vector v);

  /// Returns the corner next to `p` of the squares of a quadtree with this side: each coordinate is the multiple of
  /// `side` that is nearest to that of `p`.
  /// \pre `side` is a power of two. It may be less than the spacing: then the corner is `p`, or next to it.
  static Point nearest_corner(Point p, double side);

  /// @}
};
