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
/// What `mesh_quality_2()` checks and against which bounds.
struct Mesh_quality_options_2 {
  /// What the mesh has to cover.
  enum class Domain {
    ENCLOSED_BY_SEGMENTS, ///< everything not connected to infinity, minus the components of the hole points
    MARKED_BY_REGIONS,    ///< of that only the components of the region points
    NESTING_PARITY, ///< of that only what an odd number of segments, counted at their least, separate from
                    ///< infinity
    ANY ///< not checked (meshes of points), but for overlaps; every input vertex and segment has to be in the mesh
  };
  /// Which arrays of the mesh are checked.
  enum class Arrays {
    ALL,
    POINTS_AND_TRIANGLES ///< for meshes read from files that store no more; edges along segments are searched
  };

  /// Least angle in degrees; 0 means no bound.
  double min_angle_in_degrees = 0;
  /// Longest edge; 0 means no bound.
  double max_edge_length = 0;
  /// Largest area of a triangle; 0 means no bound. The bounds of regions are checked besides.
  double max_triangle_area = 0;
  /// The unit of the mesh's coordinates, if that is coarser than a double's: the grid of fixed-point words (1 where the
  /// words themselves are checked, which is taken without saying), the last decimal of a file.
  ///
  /// Vertices on segments are rounded. One counts as on its segment if some point of the segment's line is within four
  /// units of it along each axis. The unit is this one, or that in the last place of the larger of the coordinates of
  /// the segment's two ends along the axis; never a share of the extent. A mesher over doubles can promise that and
  /// little less. The place at a share t of the way from p to q, p + t (q - p), is wrong by up to two and a half such
  /// units, as the difference, which may be twice as large as the coordinates, the product and the sum are rounded; one
  /// between two vertices of a segment inherits what these are off, and how far it is off is itself known to three
  /// units only. And a coordinate that happens to be next to 0 has as large an error as any other. Whatever is near, the
  /// vertices of a segment follow each other along it, and no input vertex and no other segment is passed over or
  /// crossed, which is decided exactly.
  double coordinate_unit = 0;
  /// At most this many errors are written out; all are counted.
  std::size_t max_errors = 20;
  Domain domain = Domain::ENCLOSED_BY_SEGMENTS; ///< what the mesh has to cover
  Arrays arrays = Arrays::ALL;                  ///< what is there to be checked

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
/// A mesh that is invalid because its arrays do not fit together (first errors) has no statistics.
struct Mesh_quality_2 {
  /// What a triangle may miss.
  enum class Bound { ANGLE, EDGE_LENGTH, AREA };

  /// A triangle that misses a bound. For the angle, only where no wedge of two input segments excuses it.
  struct Unmet_triangle {
    Quadtree_mesh_2::Triangle_index triangle; ///< its index in the mesh
    Bound bound;                              ///< what it misses
    std::array<double, 2> centroid;           ///< where it is
    double least_angle;                       ///< degrees
  };

  /// One line per error, the first `Mesh_quality_options_2::max_errors` of them.
  std::vector<std::string> errors;
  std::size_t number_of_errors = 0; ///< of all of them

  std::size_t vertices = 0;     ///< those that a triangle uses
  std::size_t edges = 0;        ///< each counted once
  std::size_t border_edges = 0; ///< edges of one triangle only
  std::size_t triangles = 0;    ///< all of the mesh
  double area = 0;              ///< of all triangles
  /// By a constrained Delaunay triangulation of the input; 0 where the domain is not checked.
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
