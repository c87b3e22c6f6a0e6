// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_POINT_SET_MESH_REPORT_2_H
#define CGAL_POINT_SET_MESH_REPORT_2_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// What `Point_set_mesher_2` reached, and how.
struct Point_set_mesh_report_2 {
  /// A triangle with an angle outside the range. There is none unless points are so near to each other that
  /// coordinates have no room for good angles between them.
  struct Unmet_triangle {
    Quadtree_mesh_2::Triangle_index triangle; ///< its index in the mesh
    std::array<double, 2> centroid;           ///< where it is
  };
  /// Seconds by phase.
  struct Seconds {
    double quadtree = 0; ///< including the tiles
    double separate = 0; ///< vertices moved to the points, relaxation and repair; the tiles of parts
    double coarsen = 0;  ///< vertices removed
    double convert = 0;  ///< to Indexed_mesh_2
  };

  std::size_t input_points = 0;  ///< all points given
  std::size_t merged_points = 0; ///< points at the place of an earlier one
  std::size_t vertices = 0;      ///< vertices that a triangle uses
  std::size_t triangles = 0;     ///< of the mesh
  /// The number of triangles before coarsening. Equals `triangles` if no vertex is removed, and with
  /// LEAST_ANGLE.
  std::size_t triangles_before_coarsening = 0;
  std::size_t clusters = 0;         ///< clusters that got a quadtree of their own
  std::size_t certified_points = 0; ///< points with squares so small that separation alone proves the range
  /// With ACUTE, triangles around clusters with an angle between 89.5 and 90 degrees. That it is below 90 is
  /// decided exactly.
  std::size_t thin_triangles = 0;
  std::size_t rounds = 0; ///< rounds of filling the quadtree with tiles
  /// The least angle of all triangles, in degrees, rounded.
  double least_angle = 180;
  double largest_angle = 0;                    ///< the largest angle of all triangles, likewise
  std::vector<Unmet_triangle> unmet_triangles; ///< those with an angle outside the range
  bool is_cancelled = false;                   ///< whether the callback stopped coarsening
  Seconds seconds;                             ///< of processors
  Seconds wall_seconds;                        ///< by the clock

  /// Whether all angles are in the range.
  bool is_met() const { return unmet_triangles.empty(); }
};

} // namespace CGAL

#endif // CGAL_POINT_SET_MESH_REPORT_2_H
