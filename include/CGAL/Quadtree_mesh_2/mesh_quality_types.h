// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_MESH_QUALITY_TYPES_H
#define CGAL_QUADTREE_MESH_2_MESH_QUALITY_TYPES_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// Options of `mesh_quality_2()`: what it checks, and against which bounds. Each option is set by the
/// function of its name, which returns the options, so that calls can be chained. Without an argument the
/// function returns the value.
class Mesh_quality_options_2 {
public:
  /// What the mesh has to cover.
  enum class Domain {
    ENCLOSED_BY_SEGMENTS, ///< everything not connected to infinity, except the components of hole points
    MARKED_BY_REGIONS,    ///< of these, only the components of region points
    NESTING_PARITY, ///< of these, only components that an odd number of segments, at the least, separate from
                    ///< infinity
    ANY ///< not checked except for overlaps (meshes of points); the mesh must have all input vertices and segments
  };
  /// Which arrays of the mesh are checked.
  enum class Arrays {
    ALL,                 ///< all that a mesher fills
    POINTS_AND_TRIANGLES ///< for meshes from files without the rest; edges along segments are searched for
  };

  /// Least angle in degrees; 0, the default, means no bound.
  Mesh_quality_options_2& min_angle(double value) { return min_angle_ = value, *this; }
  double min_angle() const { return min_angle_; } ///< the value set

  /// Greatest angle in degrees; 0, the default, means no bound.
  Mesh_quality_options_2& max_angle(double value) { return max_angle_ = value, *this; }
  double max_angle() const { return max_angle_; } ///< the value set

  /// Longest edge; 0, the default, means no bound.
  Mesh_quality_options_2& max_edge(double value) { return max_edge_ = value, *this; }
  double max_edge() const { return max_edge_; } ///< the value set

  /// Largest area of a triangle; 0, the default, means no bound. The bounds of regions are checked, too.
  Mesh_quality_options_2& max_area(double value) { return max_area_ = value, *this; }
  double max_area() const { return max_area_; } ///< the value set

  /// The unit of the mesh's coordinates, if it is coarser than that of doubles: the last decimal of a file,
  /// or the grid of fixed-point words. 0, the default, means none. If the words themselves are checked, 1 is
  /// taken automatically.
  ///
  /// Vertices on segments are rounded. A vertex counts as on its segment if some point of the segment's line
  /// is within four units of it along each axis. Along an axis, the unit is this one, or that in the last
  /// place of the larger coordinate of the segment's two ends. It is never a share of the extent.
  ///
  /// A mesher over doubles can promise four units, and little less. The place at a share t of the way from p
  /// to q is computed as p + t (q - p). The difference, which may be twice as large as the coordinates, the
  /// product and the sum are rounded. So the place is wrong by up to two and a half units. A vertex between
  /// two vertices of a segment inherits their errors, and its own error is known only to three units. A
  /// coordinate that happens to be near 0 has as large an error as any other.
  ///
  /// However near other features are, the vertices of a segment follow each other along it. The chain neither
  /// passes over an input vertex nor crosses another segment. That is decided exactly.
  Mesh_quality_options_2& coordinate_unit(double value) { return coordinate_unit_ = value, *this; }
  double coordinate_unit() const { return coordinate_unit_; } ///< the value set

  /// At most this many errors are written out, 20 by default; all are counted.
  Mesh_quality_options_2& max_errors(std::size_t value) { return max_errors_ = value, *this; }
  std::size_t max_errors() const { return max_errors_; } ///< the value set

  /// What the mesh has to cover; ENCLOSED_BY_SEGMENTS by default.
  Mesh_quality_options_2& check_domain(Domain value) { return check_domain_ = value, *this; }
  Domain check_domain() const { return check_domain_; } ///< the value set

  /// Which arrays are checked; ALL by default.
  Mesh_quality_options_2& check_arrays(Arrays value) { return check_arrays_ = value, *this; }
  Arrays check_arrays() const { return check_arrays_; } ///< the value set

private:
  double min_angle_ = 0;
  double max_angle_ = 0;
  double max_edge_ = 0;
  double max_area_ = 0;
  double coordinate_unit_ = 0;
  std::size_t max_errors_ = 20;
  Domain check_domain_ = Domain::ENCLOSED_BY_SEGMENTS;
  Arrays check_arrays_ = Arrays::ALL;
};

/// \ingroup PkgQuadtreeMesh2Data
/// What `mesh_quality_2()` found: the errors that make a mesh invalid, and the statistics of its triangles.
///
/// If the arrays of a mesh do not fit together, which the first errors say, it has no statistics.
struct Mesh_quality_2 {
  /// What a triangle may miss.
  enum class Bound {
    ANGLE,         ///< the least angle
    EDGE_LENGTH,   ///< the longest edge
    AREA,          ///< the largest area
    GREATEST_ANGLE ///< the greatest angle
  };

  /// A triangle that misses a bound. For angles, only if no wedge of two input segments excuses it.
  struct Unmet_triangle {
    Quadtree_mesh_2::Triangle_index triangle; ///< its index in the mesh
    Bound bound;                              ///< the bound that it misses
    std::array<double, 2> centroid;           ///< where it is
    double least_angle;                       ///< degrees
    double greatest_angle;                    ///< in degrees, too
  };

  /// One line per error, the first `Mesh_quality_options_2::max_errors()` of them.
  std::vector<std::string> errors;
  std::size_t number_of_errors = 0; ///< including errors not written out

  std::size_t vertices = 0;     ///< vertices that a triangle uses
  std::size_t edges = 0;        ///< each counted once
  std::size_t border_edges = 0; ///< edges of one triangle only
  std::size_t triangles = 0;    ///< all triangles of the mesh
  double area = 0;              ///< sum over all triangles
  /// Area of the domain, by a constrained Delaunay triangulation of the input; 0 if the domain is not
  /// checked.
  double domain_area = 0;
  double shortest_edge =
      std::numeric_limits<double>::infinity(); ///< its length; infinity in a mesh without edges
  double longest_edge = 0;                     ///< its length; 0 in a mesh without edges
  double largest_area = 0;                     ///< of a triangle
  double total_length = 0;                     ///< of all edges
  double min_angle = 180;                      ///< degrees, as all angles here
  double max_angle = 0;                        ///< degrees
  /// Least angle that is not between two pieces of input segments at an input vertex.
  double min_new_angle = 180;
  /// `angle_histogram[i]` angles are in [10 i, 10 (i + 1)) degrees.
  std::array<std::size_t, 18> angle_histogram{};
  /// Triangles below the bound of the least angle, or above that of the greatest one, that a wedge of two input
  /// segments excuses.
  std::size_t exempt_triangles = 0;
  /// Triangles that miss a bound without such an excuse.
  std::vector<Unmet_triangle> unmet_triangles;

  /// Whether there are no errors.
  bool is_valid() const { return number_of_errors == 0; }
  /// Whether every triangle keeps every bound or is exempt from it.
  bool is_met() const { return unmet_triangles.empty(); }
};

} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_MESH_QUALITY_TYPES_H
