// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_MESHING_PROBLEM_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_MESHING_PROBLEM_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Acute_corners.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Bounds.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What is the same for the whole mesh and all its blocks.
template <class Geometry>
struct Meshing_problem {
  std::vector<typename Geometry::Point> input_points; ///< by input number
  Input_edges edges;
  Acute_corners<Geometry> corners;
  Bounds<Geometry> bounds;
  /// Features of the input nearer to a vertex than this share of an edge at it are none that legs are cut for.
  typename Geometry::Number least_share_of_leg = 0;

  const typename Geometry::Point& input_point(Vertex_id number) const {
    return input_points[std::size_t(number)];
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_MESHING_PROBLEM_H
