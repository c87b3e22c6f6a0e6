// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TRIANGULATE_DOMAIN_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TRIANGULATE_DOMAIN_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Edge_sides.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_problem.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Returns the constrained Delaunay triangulation of a problem's edges, restricted to the domain: the mesh from which
/// refinement begins.
/// \param points those of the input, or the first of them if no edge has others
/// \param sides where the domain is
template <class ConcurrencyTag, class Geometry, class Points>
Kernel_mesh<Geometry> triangulate_domain(const Meshing_problem<Geometry>& problem, const Points& points,
                                         const Edge_sides& sides) {
  using First = First_triangulation<ConcurrencyTag, Geometry>;
  std::vector<typename First::Segment> segments(problem.edges.size());
  for_each_index<ConcurrencyTag>(segments.size(), [&](std::size_t i) {
    const Input_edge& e = problem.edges[static_cast<Edge_id>(i)];
    segments[i] = {e.a, e.b};
  });
  Kernel_mesh<Geometry> mesh;
  First(mesh, points, problem.vertex_blocks).run(std::move(segments)); // which do not cross
  sides.restrict(mesh, problem.edges, First::number_of_auxiliary_vertices);
  return mesh;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_TRIANGULATE_DOMAIN_H
