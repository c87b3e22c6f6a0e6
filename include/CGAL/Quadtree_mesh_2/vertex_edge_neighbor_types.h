// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_VERTEX_EDGE_NEIGHBOR_TYPES_H
#define CGAL_QUADTREE_MESH_2_VERTEX_EDGE_NEIGHBOR_TYPES_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <cstddef>
#include <limits>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Neighbors
/// The answer of models of `VertexEdgeNeighbors_2`: a segment of a graph, and its distance from a vertex.
struct Vertex_edge_neighbor_2 {
  /// The segment; invalid if there is none.
  Quadtree_mesh_2::Segment_index segment;
  /// The distance in the unit of coordinates, with a relative error below 2^-40; infinite if there is none.
  double distance = std::numeric_limits<double>::infinity();

  /// Whether there is a neighbor.
  bool exists() const { return segment.is_valid(); }
};

/// \ingroup PkgQuadtreeMesh2Neighbors
/// The nearest vertex or segment in a sector at a vertex. One of the indices is valid, or none if the sector
/// is empty.
struct Sector_neighbor_2 {
  Quadtree_mesh_2::Vertex_index vertex;   ///< valid if a vertex is nearest
  Quadtree_mesh_2::Segment_index segment; ///< valid if a segment is
  /// The distance, as for `Vertex_edge_neighbor_2`.
  double distance = std::numeric_limits<double>::infinity();

  /// Whether there is a neighbor.
  bool exists() const { return vertex.is_valid() || segment.is_valid(); }
};

/// \ingroup PkgQuadtreeMesh2Neighbors
/// Options of `Quadtree_vertex_edge_neighbors_2`. They change the time of queries, never the answers. Each
/// option is set by the function of its name, which returns the options, so that calls can be chained.
/// Without an argument the function returns the value.
class Vertex_edge_neighbors_options_2 {
public:
  /// A leaf is split while more segments than this meet it without ending in it; 64 by default.
  Vertex_edge_neighbors_options_2& max_segments_per_leaf(std::size_t value) {
    return max_segments_per_leaf_ = value, *this;
  }
  std::size_t max_segments_per_leaf() const { return max_segments_per_leaf_; } ///< the value set

  /// The most times that leaves are halved for `max_segments_per_leaf()`, 0 by default: halving did not pay
  /// on any input measured (doc/quadtrees.md). Each time may double the total length of the lists.
  Vertex_edge_neighbors_options_2& max_refinements(int value) { return max_refinements_ = value, *this; }
  int max_refinements() const { return max_refinements_; } ///< the value set

private:
  std::size_t max_segments_per_leaf_ = 64;
  int max_refinements_ = 0;
};

} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_VERTEX_EDGE_NEIGHBOR_TYPES_H
