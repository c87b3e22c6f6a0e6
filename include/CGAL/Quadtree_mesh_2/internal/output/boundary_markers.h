// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The markers of a mesh's edges and vertices from those of its input, by the rule of Triangle (Indexed_mesh_2
// says it). O(n).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_BOUNDARY_MARKERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_BOUNDARY_MARKERS_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>

#include <CGAL/Quadtree_mesh_2/internal/base/huge_pages.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Fills `vertex_markers` and the markers of the constrained edges; all other arrays of the mesh are there.
template <class Point>
void set_boundary_markers(Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg) {
  reserve_in_huge_pages(mesh.vertex_markers, mesh.points.size());
  mesh.vertex_markers.assign(mesh.points.size(), 0);
  for (std::size_t v = 0; v < pslg.vertex_markers.size(); ++v)
    mesh.vertex_markers[v] = pslg.vertex_markers[v];
  const auto offer = [&mesh](Vertex_index v, int marker) {
    int& own = mesh.vertex_markers[std::size_t(v)];
    if (own == 0) own = marker;
  };
  if (!pslg.segment_markers.empty())
    for (auto& edge : mesh.constrained_edges) {
      edge.marker = pslg.segment_markers[std::size_t(edge.segment)];
      for (const Vertex_index v : edge.vertices) offer(v, edge.marker);
    }
  const auto is_at_border = [&mesh](std::size_t t) {
    const auto& n = mesh.neighbors[t];
    return !(n[0].is_valid() && n[1].is_valid() && n[2].is_valid());
  };
  for (const std::uint32_t t : pack<Chosen_tag>(mesh.neighbors.size(), is_at_border))
    for (std::size_t k = 0; k < 3; ++k) {
      if (mesh.neighbors[t][k].is_valid()) continue;
      offer(mesh.triangles[t][(k + 1) % 3], 1);
      offer(mesh.triangles[t][(k + 2) % 3], 1);
    }
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_BOUNDARY_MARKERS_H
