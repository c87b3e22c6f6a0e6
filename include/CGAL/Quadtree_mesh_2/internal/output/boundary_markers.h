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

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Fills `vertex_markers`, which is empty or has zeros only, and the markers of the constrained edges. All other arrays
/// of the mesh are there.
/// \param border the ends of the edges with a triangle on one side
template <class Point>
void set_boundary_markers(Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                          const std::vector<std::array<Vertex_index, 2>>& border) {
  mesh.vertex_markers.resize(mesh.points.size(), 0);
  std::copy(pslg.vertex_markers.begin(), pslg.vertex_markers.end(), mesh.vertex_markers.begin());
  const auto offer = [&mesh](const std::array<Vertex_index, 2>& edge, int marker) {
    for (const Vertex_index v : edge)
      if (int& own = mesh.vertex_markers[std::size_t(v)]; own == 0) own = marker;
  };
  if (!pslg.segment_markers.empty())
    for (auto& edge : mesh.constrained_edges) {
      edge.marker = pslg.segment_markers[std::size_t(edge.segment)];
      offer(edge.vertices, edge.marker);
    }
  for (const auto& edge : border) offer(edge, 1);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_BOUNDARY_MARKERS_H
