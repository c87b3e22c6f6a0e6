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
/// A triangle mesh in flat arrays. The meshers make it, and it can become a CGAL triangulation, matrices or a
/// file.
///
/// The first `number_of_input_vertices` vertices are the vertices of the input, in their order and with their
/// coordinates bit for bit. Vertices that no triangle uses are kept, so that indices stay the same. Triangles
/// are counterclockwise. Side `k` of a triangle is opposite its vertex `k`.
///
/// After `renumber_by_place()` vertices of the input are anywhere, and `input_index` tells which they are. All writers
/// of files take such meshes. What needs the input in front, checkers and converters to triangulations, does after
/// `renumber_by_input()`.
/// \tparam Point point type with members `x()` and `y()`.
template <class Point>
class Indexed_mesh_2 {
public:
  /// \name Types
  /// @{

  /// A point of the kernel, the place of a vertex.
  using Point_2 = Point;
  /// Names a vertex by its place in the array.
  using Vertex_index = Quadtree_mesh_2::Vertex_index;
  /// Names a triangle by its place in the array.
  using Triangle_index = Quadtree_mesh_2::Triangle_index;
  /// Names a segment of the input by its place in the array.
  using Segment_index = Quadtree_mesh_2::Segment_index;
  /// @}

  /// A piece of an input segment that is an edge of the mesh.
  struct Constrained_edge {
    std::array<Vertex_index, 2> vertices; ///< its ends; on the border the domain is on the left of these
    Segment_index segment; ///< the input segment it is part of (the first one where segments overlap)
    int marker = 0;        ///< the marker of the segment; 0 if segments have none
    /// On the border, the input vertex that faces the edge from the outside: that of the triangle there in a
    /// constrained triangulation of the input. Invalid inside, where there is none, and in meshes made by
    /// hand.
    Vertex_index outer_vertex = {};
  };

  /// The number of input vertices, which are the first points unless the mesh is renumbered.
  std::size_t number_of_input_vertices = 0;
  /// The places of the vertices: those of the input, then Steiner points.
  std::vector<Point_2> points;
  /// The vertices of each triangle, counterclockwise.
  std::vector<std::array<Vertex_index, 3>> triangles;
  /// `neighbors[t][k]`: the triangle across side `k` of `t`, which is across from its vertex `k`; invalid on the border
  /// of the domain.
  std::vector<std::array<Triangle_index, 3>> neighbors;
  /// Every mesh edge that lies on an input segment, once.
  std::vector<Constrained_edge> constrained_edges;
  /// Per triangle, the position of its region in `Pslg_2::regions`; -1 if it has none. The region of a
  /// component is the first with its point in it. Empty if the input has no regions.
  std::vector<int> region_of_triangle;
  /// Per vertex, the input segment in whose interior a Steiner vertex lies. Invalid for all other vertices.
  std::vector<Segment_index> segment_of_vertex;
  /// Per vertex, its marker by Triangle's rule. An input vertex keeps its marker. A vertex without one (0)
  /// gets the first nonzero marker of the constrained edges at it. If there is none, it gets 1 on the border
  /// of the domain. Empty (in meshes made by hand) if all are 0.
  std::vector<int> vertex_markers;
  /// Per vertex, its index in the input; invalid for Steiner vertices. Empty if the input's vertices are the first in
  /// their order, as meshers make it.
  std::vector<Vertex_index> input_index;

  /// The place of a vertex.
  const Point_2& point(Vertex_index v) const { return points[std::size_t(v)]; }
  /// The marker of a vertex, 0 where there are none.
  int marker(Vertex_index v) const { return vertex_markers.empty() ? 0 : vertex_markers[std::size_t(v)]; }
  /// The number of vertices, including those that no triangle uses.
  std::size_t number_of_vertices() const { return points.size(); }
  /// The number of triangles.
  std::size_t number_of_triangles() const { return triangles.size(); }
};

} // namespace CGAL

#endif // CGAL_INDEXED_MESH_2_H
