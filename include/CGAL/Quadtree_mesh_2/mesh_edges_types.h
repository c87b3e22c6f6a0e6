// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_MESH_EDGES_TYPES_H
#define CGAL_QUADTREE_MESH_2_MESH_EDGES_TYPES_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// An edge of a mesh, as `edges_of_mesh_2()` returns it.
struct Mesh_edge_2 {
  /// Its ends, in the direction in which its first triangle is on the left.
  std::array<Quadtree_mesh_2::Vertex_index, 2> vertices;
  /// The triangles on its left and on its right, of which the left one comes first in the mesh; the right one is
  /// invalid on the border.
  std::array<Quadtree_mesh_2::Triangle_index, 2> triangles;
  /// The marker by Triangle's rule: that of the constrained edge; if that is 0 or there is none, 1 on the border of the
  /// domain and 0 inside.
  int marker = 0;

  /// Whether there is a triangle on one side only.
  bool is_on_border() const { return !triangles[1].is_valid(); }
};

/// \ingroup PkgQuadtreeMesh2Data
/// What second-order elements have besides the vertices of a mesh: a node in the middle of each edge. Their numbers
/// follow those of the vertices.
struct Second_order_nodes_2 {
  /// The edges; the node of `edges[i]` has the number `first_node + i`.
  std::vector<Mesh_edge_2> edges;
  /// The number of the vertices of the mesh.
  std::size_t first_node = 0;
  /// The places of the nodes, rounded to doubles. The marker of a node is that of its edge.
  std::vector<std::array<double, 2>> points;
  /// Per triangle, the numbers of its nodes: node `k` is on the side opposite the vertex `k`, as in Triangle's files.
  std::vector<std::array<Quadtree_mesh_2::Vertex_index, 3>> nodes_of_triangle;
};

namespace IO {

/// \ingroup PkgQuadtreeMesh2IO
/// How many nodes the elements in a file have.
enum class Element_order {
  FIRST, ///< their corners
  SECOND ///< one in the middle of each side, too: `second_order_nodes_2()`
};

} // namespace IO
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_MESH_EDGES_TYPES_H
