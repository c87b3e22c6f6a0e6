// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

/// \ingroup PkgQuadtreeMesh2Concepts
/// \cgalConcept
///
/// The concept `VertexEdgeNeighbors_2` describes classes that know, for each vertex of a planar straight-line
/// graph, which segments the four axis-parallel rays from it hit first. Lemma 5 of Bern, Eppstein and Teng says
/// why that is useful. The nearer of the nearest hit and the nearest vertex is at most sqrt(2) times as
/// far from the vertex as the nearest vertex or segment that is not incident to it.
///
/// Answers are a function of the graph alone, so all models give the same answers:
///
/// - Rays and segments are closed. A ray begins in its vertex v and has no end; a segment contains its
///   ends. Vertices without segments are not hit.
/// - A segment is incident to v if one of its ends lies at the place of v. That end may be
///   v itself or an equal vertex, so equal vertices have the same answers. Incident segments are not hit.
/// - Any other segment is hit if it has a point on the ray, at the distance of the nearest such point. That point
///   is the crossing; or its end, if that is on the ray; or the nearer end, if the segment lies on the ray. If
///   v is in its interior, it is hit at distance 0 in all four directions.
/// - The first hit is the one at the least distance. Among segments at the same distance it is the one with the
///   lowest index. Distances are compared exactly. Crossing and overlapping segments and segments of length 0
///   are no exceptions.
///
/// \cgalHasModelsBegin
/// \cgalHasModels{CGAL::Quadtree_vertex_edge_neighbors_2<Traits,ConcurrencyTag>}
/// \cgalHasModels{CGAL::Trapezoidal_vertex_edge_neighbors_2<Traits,ConcurrencyTag>}
/// \cgalHasModelsEnd
///
/// \sa `CGAL::Pslg_2<Point>`
class VertexEdgeNeighbors_2 {
public:
  /// \name Types
  /// @{

  /// A point of the graph.
  typedef unspecified_type Point_2;

  /// The graph: `CGAL::Pslg_2<Point_2>`.
  typedef unspecified_type Pslg;

  /// @}

  /// \name Creation
  /// @{

  /// Prepares the answers for all vertices of a graph. The graph has to stay where and as it is. It need not be
  /// planar.
  VertexEdgeNeighbors_2(const Pslg& pslg);

  /// @}

  /// \name Queries
  /// These may be called by several threads at once.
  /// @{

  /// The first hit of the ray from `v` in direction `d`, and its distance, rounded with a relative error below
  /// 2^-40. If there is no hit, it is an invalid segment at an infinite distance.
  /// \pre `d` is `EAST`, `NORTH`, `WEST` or `SOUTH`
  CGAL::Vertex_edge_neighbor_2 first_hit(CGAL::Quadtree_mesh_2::Vertex_index v,
                                         CGAL::Quadtree_mesh_2::Direction d) const;

  /// The nearest of the four first hits, by exact comparison. If several are equally near, it is that of the
  /// segment with the lowest index.
  CGAL::Vertex_edge_neighbor_2 nearest_hit(CGAL::Quadtree_mesh_2::Vertex_index v) const;

  /// @}
};
