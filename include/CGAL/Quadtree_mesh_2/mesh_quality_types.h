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
/// Options of `mesh_quality_2()`: what it checks, and against which bounds.
struct Mesh_quality_options_2 {
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
    ALL,
    POINTS_AND_TRIANGLES ///< for meshes from files without the rest; edges along segments are searched for
  };

  /// Least angle in degrees; 0 means no bound.
  double min_angle_in_degrees = 0;
  /// Longest edge; 0 means no bound.
  double max_edge_length = 0;
  /// Largest area of a triangle; 0 means no bound. The bounds of regions are checked, too.
  double max_triangle_area = 0;
  /// The unit of the mesh's coordinates, if it is coarser than that of doubles: the last decimal of a file,
  /// or the grid of fixed-point words. If the words themselves are checked, 1 is taken automatically.
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
  double coordinate_unit = 0;
  /// At most this many errors are written out; all are counted.
  std::size_t max_errors = 20;
  Domain domain = Domain::ENCLOSED_BY_SEGMENTS; ///< what the mesh has to cover
  Arrays arrays = Arrays::ALL;                  ///< which arrays are checked

  /// \name Setters
  /// @{

  /// Each sets what its name says and returns the options, so that calls can be chained.
  Mesh_quality_options_2& min_angle(double degrees) { return min_angle_in_degrees = degrees, *this; }
  Mesh_quality_options_2& max_edge(double length) { return max_edge_length = length, *this; }
  Mesh_quality_options_2& max_area(double area) { return max_triangle_area = area, *this; }
  Mesh_quality_options_2& check_domain(Domain d) { return domain = d, *this; }
  Mesh_quality_options_2& check_arrays(Arrays a) { return arrays = a, *this; }
  /// @}
};

/// \ingroup PkgQuadtreeMesh2Data
/// What `mesh_quality_2()` found: the errors that make a mesh invalid, and the statistics of its triangles.
///
/// If the arrays of a mesh do not fit together, which the first errors say, it has no statistics.
struct Mesh_quality_2 {
  /// What a triangle may miss.
  enum class Bound { ANGLE, EDGE_LENGTH, AREA };

  /// A triangle that misses a bound. For the angle, only if no wedge of two input segments excuses it.
  struct Unmet_triangle {
    Quadtree_mesh_2::Triangle_index triangle; ///< its index in the mesh
    Bound bound;                              ///< the bound that it misses
    std::array<double, 2> centroid;           ///< where it is
    double least_angle;                       ///< degrees
  };

  /// One line per error, the first `Mesh_quality_options_2::max_errors` of them.
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
  double shortest_edge = std::numeric_limits<double>::infinity(); ///< of the mesh
  double longest_edge = 0;                                        ///< of the mesh
  double largest_area = 0;                                        ///< of a triangle
  double total_length = 0;                                        ///< of all edges
  double min_angle = 180;                                         ///< degrees, as all angles here
  double max_angle = 0;                                           ///< degrees
  /// Least angle that is not between two pieces of input segments at an input vertex.
  double min_new_angle = 180;
  /// `angle_histogram[i]` angles are in [10 i, 10 (i + 1)) degrees.
  std::array<std::size_t, 18> angle_histogram{};
  /// Triangles below the angle bound that a wedge of two input segments excuses.
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
