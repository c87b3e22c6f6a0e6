// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_MESH_DUAL_TYPES_H
#define CGAL_QUADTREE_MESH_2_MESH_DUAL_TYPES_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// The cells around the vertices of a mesh, in flat arrays, as finite volumes need them. `dual_of_mesh_2()` makes them.
///
/// The cells cover the domain and do not overlap, so their areas add up to that of the domain. A cell is a polygon,
/// except at a vertex where the border of the domain touches itself: there it is one for each fan of triangles. A
/// vertex that no triangle uses has an empty cell.
struct Mesh_dual_2 {
  /// Which cells.
  enum class Kind {
    /// Voronoi cells. The cell of a vertex is what lies nearer to it than to any other vertex, of those in sight. Walls
    /// block the sight: the border of the domain, and edges that are not Delaunay, as constrained ones may be. Cells
    /// meet in perpendicular bisectors. Their corners are circumcenters of triangles, on the border the vertex itself
    /// and the midpoints of the edges at it, and where a circumcenter is beyond a wall, the places where bisectors
    /// meet the wall. Cells of vertices inside may touch the border there.
    ///
    /// No circumcenter is outside if no triangle is obtuse, or with `Quality_mesh_options_2::Conforming::DELAUNAY`.
    CIRCUMCENTRIC,
    /// Median cells. The corners are the centroids of triangles, the midpoints of all edges and, on the border, the
    /// vertex itself. A vertex has a third of each of its triangles.
    BARYCENTRIC
  };

  /// The corners of the cells. The first ones are the circumcenters or centroids of the triangles, in their order, with
  /// those that no cell has because they are beyond a wall, or at the same place as another one up to rounding.
  std::vector<std::array<double, 2>> points;
  /// The polygons of vertex `v` are those from `first_polygon[v]` up to but not `first_polygon[v + 1]`.
  std::vector<std::size_t> first_polygon;
  /// The corners of polygon `i` are `corners[j]` for `j` from `first_corner[i]` up to but not `first_corner[i + 1]`.
  std::vector<std::size_t> first_corner;
  /// The corners of one polygon after the other, counterclockwise, as indices of `points`. On the border the first one
  /// is the vertex itself.
  std::vector<std::uint32_t> corners;
  /// The areas of the cells.
  std::vector<double> areas;

  /// The edges of the mesh, in the order of `edges_of_mesh_2()`. Cells of their ends are neighbors.
  std::vector<Mesh_edge_2> edges;
  /// Per edge, the length of what is between the cells of its ends. At a wall it may be 0.
  std::vector<double> lengths;

  /// The number of cells.
  std::size_t number_of_cells() const { return areas.size(); }
  /// Calls `f(begin, end)` for each polygon of a cell, with pointers to its corners.
  template <class F>
  void for_each_polygon(Quadtree_mesh_2::Vertex_index v, const F& f) const {
    for (std::size_t i = first_polygon[std::size_t(v)]; i < first_polygon[std::size_t(v) + 1]; ++i)
      f(corners.data() + first_corner[i], corners.data() + first_corner[i + 1]);
  }
};

} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_MESH_DUAL_TYPES_H
