// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUALITY_MESH_REPORT_2_H
#define CGAL_QUALITY_MESH_REPORT_2_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {

/// The input cannot be meshed; `what()` names the vertex, segment or line that is to blame.
class Pslg_error_2 : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// What `Quality_mesher_2` reached, what it did not, and where.
struct Quality_mesh_report_2 {
  /// A triangle that misses a bound although no acute input corner excuses it.
  struct Unmet_triangle {
    Quadtree_mesh_2::Triangle_index triangle;
    std::array<double, 2> centroid;
    double least_angle; ///< degrees
  };
  /// Seconds of CPU time by phase.
  struct Seconds {
    double quadtree = 0;   ///< shuffle order
    double first_mesh = 0; ///< constrained Delaunay triangulation of the input, domain, corners
    double refine = 0;
    double coarsen = 0;
    double convert = 0; ///< to Indexed_mesh_2
  };

  std::size_t input_vertices = 0;
  std::size_t input_segments = 0;
  std::size_t vertices = 0; ///< vertices that a triangle uses
  std::size_t triangles = 0;
  std::size_t merged_vertices = 0;      ///< input vertices at the place of an earlier one
  std::size_t vertices_on_segments = 0; ///< input vertices found in the interior of an input segment
  /// Below the bound inside a wedge of two input segments, never under 0.9 of its angle.
  std::size_t exempt_triangles = 0;
  std::vector<Unmet_triangle> unmet_triangles;
  std::size_t rounds = 0;
  bool is_cancelled = false;
  bool is_budget_exhausted = false;
  Seconds seconds;

  bool is_met() const { return unmet_triangles.empty(); }
};

} // namespace CGAL

#endif // CGAL_QUALITY_MESH_REPORT_2_H
