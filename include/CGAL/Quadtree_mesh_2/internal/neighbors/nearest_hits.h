// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The model of VertexEdgeNeighbors_2 that the construction by quadtrees asks, chosen at run time. So the
// mesher need not be compiled with all models. (The one by arrangements costs the compiler as much as the
// mesher itself.)

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_NEAREST_HITS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_NEAREST_HITS_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The distance from each vertex of a graph to the nearest segment that it sees along the axes. It is
/// infinite if there is none.
template <class Pslg>
using Find_nearest_hits = std::vector<double> (*)(const Pslg& graph);

/// \param n the number of vertices
template <class ConcurrencyTag, class Neighbors>
std::vector<double> nearest_hit_distances(const Neighbors& neighbors, std::size_t n) {
  std::vector<double> distances(n);
  for_each_index<ConcurrencyTag>(distances.size(), [&](std::size_t v) {
    distances[v] = neighbors.nearest_hit(Vertex_index(v)).distance;
  });
  return distances;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_NEAREST_HITS_H
