// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_INDEXED_MESH_2_H
#define CGAL_INDEXED_MESH_2_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// A triangle mesh in flat arrays: what `Quality_mesher_2` makes, before it becomes a CGAL triangulation,
/// matrices or a file.
///
/// The first `number_of_input_vertices` vertices are the vertices of the input, in their order and with their
/// coordinates bit for bit, whether a triangle uses them or not (a vertex outside the domain is kept, so that
/// indices stay what they were). Triangles are counterclockwise. Side `k` of a triangle is the one opposite
/// its vertex `k`.
/// \tparam Point point type with members `x()` and `y()`.
template <class Point>
class Indexed_mesh_2 {
public:
  /// \name Types
  /// @{

  /// That of the template argument, and the indices of what the arrays hold.
  using Point_2 = Point;
  using Vertex_index = Quadtree_mesh_2::Vertex_index;
  using Triangle_index = Quadtree_mesh_2::Triangle_index;
  using Segment_index = Quadtree_mesh_2::Segment_index;
  /// @}

  /// A piece of an input segment that is an edge of the mesh.
  struct Constrained_edge {
    std::array<Vertex_index, 2> vertices; ///< its ends
    Segment_index segment; ///< the input segment it is part of (the first one where segments overlap)
    int marker = 0;        ///< that of the segment; 0 where segments have none
  };

  /// How many of the points are those of the input: the first ones.
  std::size_t number_of_input_vertices = 0;
  /// The places of the vertices: those of the input, then Steiner points.
  std::vector<Point_2> points;
  /// The vertices of each triangle, counterclockwise.
  std::vector<std::array<Vertex_index, 3>> triangles;
  /// `neighbors[t][k]`: the triangle across side `k` of `t`; invalid on the border of the domain.
  std::vector<std::array<Triangle_index, 3>> neighbors;
  /// Every mesh edge that lies on an input segment, once.
  std::vector<Constrained_edge> constrained_edges;
  /// Per triangle, the position in `Pslg_2::regions` of its region (the first with its point in the same
  /// component), -1 where none; empty if the input has no regions.
  std::vector<int> region_of_triangle;
  /// Per vertex, the input segment in whose interior a Steiner vertex lies; invalid for all others.
  std::vector<Segment_index> segment_of_vertex;
  /// Per vertex, by Triangle's rule: an input vertex keeps its marker; a vertex without one (0) gets the
  /// first that is not 0 of the constrained edges at it; one still without, on the border of the domain, gets
  /// 1. Empty (in meshes made by hand): all are 0.
  std::vector<int> vertex_markers;

  /// The place of a vertex.
  const Point_2& point(Vertex_index v) const { return points[std::size_t(v)]; }
  /// The marker of a vertex, 0 where there are none.
  int marker(Vertex_index v) const { return vertex_markers.empty() ? 0 : vertex_markers[std::size_t(v)]; }
  /// The number of vertices, those that no triangle uses included.
  std::size_t number_of_vertices() const { return points.size(); }
  /// The number of triangles.
  std::size_t number_of_triangles() const { return triangles.size(); }
};

} // namespace CGAL

#endif // CGAL_INDEXED_MESH_2_H
