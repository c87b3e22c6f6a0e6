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

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How far the first segments are that a vertex sees to the east, north, west and south; infinite where there is none.
using Axis_distances = std::array<double, 4>;
constexpr std::array<Direction, 4> directions_of_axes{
    {Direction::EAST, Direction::NORTH, Direction::WEST, Direction::SOUTH}};

/// These distances of each vertex of a graph.
template <class Pslg>
using Find_nearest_hits = std::vector<Axis_distances> (*)(const Pslg& graph);

/// \param n the number of vertices
template <class ConcurrencyTag, class Neighbors>
std::vector<Axis_distances> nearest_hit_distances(const Neighbors& neighbors, std::size_t n) {
  std::vector<Axis_distances> distances(n);
  for_each_index<ConcurrencyTag>(distances.size(), [&](std::size_t v) {
    for (std::size_t d = 0; d < directions_of_axes.size(); ++d)
      distances[v][d] = neighbors.first_hit(Vertex_index(v), directions_of_axes[d]).distance;
  });
  return distances;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_NEAREST_HITS_H
