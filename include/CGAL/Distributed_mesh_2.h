// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_DISTRIBUTED_MESH_2_H
#define CGAL_DISTRIBUTED_MESH_2_H

#include <CGAL/Pslg_2.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Distributed
/// What one rank of an MPI communicator holds of a triangle mesh, in flat arrays.
///
/// Each vertex and each triangle is owned by one rank. Both have numbers of 64 bits in the whole mesh, and those of a
/// rank follow each other, in the order of ranks. A rank knows, too:
/// - its ghosts: the triangles of other ranks that have a vertex with a triangle of its own in common
/// - foreign vertices: those of its triangles, ghosts and edges that others own
///
/// Triangles are in the order of their least vertices, and cut into runs of the same length. A rank owns the vertices
/// up to the last one that is the least of an own triangle, but for those of ranks before. So it may own vertices at
/// which it has no triangle, and need not know all triangles at an own vertex: it knows all at the vertices of its own
/// triangles. To assemble, add what own triangles contribute, and send the owners what that is at foreign vertices:
/// see `Vertex_scatter_2`.
///
/// The arrays are arguments of `DMPlexCreateFromCellListParallelPetsc()` of PETSc and `create_mesh()` of dolfinx: the
/// first `number_of_own_triangles()` triangles, and the first `number_of_own_vertices()` points.
///
/// Invariants, checked over all ranks by `defect_of_distributed_mesh_2()`:
/// - `first_vertex`, `first_triangle` and what is said to be the same at all ranks is so.
/// - Foreign vertices are those that are used here, without others, in their order. All that is known of them is what
///   their owners know.
/// - Ghosts are all there are, without others, in their order, and are what their owners have.
/// - Neighbors are mutual, and have the side in common.
/// - Each constrained edge is at the rank that owns the first triangle beside it, in the order of numbers, and each
///   number is there once. Edges without a triangle, and what is outside of the mesh, are at the last rank with
///   triangles.
///
/// A rank without triangles is allowed: there may be more ranks than triangles.
/// \tparam Point point type with members `x()` and `y()`, which are arithmetic.
template <class Point>
class Distributed_mesh_2 {
public:
  /// \name Types
  /// @{

  /// A point of the kernel, the place of a vertex.
  using Point_2 = Point;
  /// Names a vertex, triangle, constrained edge, or segment of the input in the whole mesh; -1 for none.
  using Number = std::int64_t;
  /// @}

  /// A piece of an input segment that is an edge of the mesh, as in `Indexed_mesh_2`.
  struct Constrained_edge {
    Number number;                  ///< its place among the constrained edges of the whole mesh
    std::array<Number, 2> vertices; ///< its ends; on the border the domain is on the left of these
    Number segment;                 ///< the input segment it is part of
    Number outer_vertex;            ///< on the border, the input vertex that faces the edge from the outside
    std::int64_t marker;            ///< the marker of the segment; 0 if segments have none
  };
  /// An input segment of which nothing is in the mesh.
  struct Outside_segment {
    std::array<Number, 2> vertices; ///< its ends
    Number segment;                 ///< of the input
    std::int64_t marker;            ///< its marker; 0 for none
  };

  /// \name The whole mesh: the same at all ranks
  /// @{

  /// Per rank, the number of its first vertex; then the number of all vertices.
  std::vector<Number> first_vertex{0, 0};
  /// Per rank, the number of its first triangle; then the number of all triangles.
  std::vector<Number> first_triangle{0, 0};
  /// The number of constrained edges of the whole mesh.
  Number number_of_constrained_edges = 0;
  /// The number of input segments of which nothing is in the mesh.
  Number number_of_outside_segments = 0;
  /// The number of input vertices.
  Number number_of_input_vertices = 0;
  /// Whether triangles have regions.
  bool has_regions = false;
  /// Whether vertices have markers.
  bool has_vertex_markers = false;
  /// Whether vertices have `input_index`. If they have not, those of the input are the first ones.
  bool has_input_index = false;
  /// Whether triangles have `neighbors`.
  bool has_neighbors = false;
  /// Whether vertices have `segment_of_vertex`.
  bool has_segment_of_vertex = false;
  /// The regions of the graph that the mesh was made from, and its names of regions and markers. It has nothing else.
  Pslg_2<Point> legend;
  /// @}

  /// \name What this rank has
  /// @{

  int rank = 0; ///< which rank this is
  /// The numbers of the foreign vertices, ascending: so those of one owner follow each other, and so do owners.
  std::vector<Number> foreign_vertices;
  /// The numbers of the ghosts, ascending.
  std::vector<Number> ghost_triangles;

  /// The places of the own vertices, then of the foreign ones. So it is with all arrays of vertices.
  std::vector<Point_2> points;
  /// Per vertex its marker, if `has_vertex_markers`.
  std::vector<int> vertex_markers;
  /// Per vertex, its index in the input; -1 for Steiner vertices.
  std::vector<Number> input_index;
  /// Per vertex, the input segment in whose interior a Steiner vertex lies; -1 for others.
  std::vector<Number> segment_of_vertex;

  /// The numbers of the vertices of the own triangles, counterclockwise; then of the ghosts.
  std::vector<std::array<Number, 3>> triangles;
  /// Per own triangle and ghost, the position of its region in `Pslg_2::regions`; -1 for none.
  std::vector<int> region_of_triangle;
  /// Per own triangle, the number of the triangle across each side, which this rank knows; -1 on the border of the
  /// domain. Side k is the one across from vertex k of the triangle.
  std::vector<std::array<Number, 3>> neighbors;

  /// In the order of their numbers.
  std::vector<Constrained_edge> constrained_edges;
  /// At the last rank with triangles.
  std::vector<Outside_segment> outside_segments;
  /// @}

  /// \name Numbers
  /// @{

  /// The number of ranks.
  int number_of_ranks() const { return static_cast<int>(first_vertex.size()) - 1; }
  /// The number of ranks up to the last one with triangles, at least 1: so many files a mesh has.
  int number_of_parts() const {
    int parts = number_of_ranks();
    while (parts > 1 && first_triangle[std::size_t(parts)] == first_triangle[std::size_t(parts) - 1]) --parts;
    return parts;
  }
  /// The number of vertices of the whole mesh.
  Number number_of_vertices() const { return first_vertex.back(); }
  /// The number of triangles of the whole mesh.
  Number number_of_triangles() const { return first_triangle.back(); }
  /// The number of vertices that this rank owns.
  std::size_t number_of_own_vertices() const { return number_of_own(first_vertex); }
  /// The number of triangles that this rank owns.
  std::size_t number_of_own_triangles() const { return number_of_own(first_triangle); }

  /// The rank that owns a vertex. O(log P) for P ranks, as for the next function.
  int owner_of_vertex(Number v) const { return owner(first_vertex, v); }
  /// The rank that owns a triangle.
  int owner_of_triangle(Number t) const { return owner(first_triangle, t); }
  /// Whether this rank owns a vertex.
  bool is_own_vertex(Number v) const {
    return v >= first_vertex[std::size_t(rank)] && v < first_vertex[std::size_t(rank) + 1];
  }
  /// Whether this rank owns a triangle.
  bool is_own_triangle(Number t) const {
    return t >= first_triangle[std::size_t(rank)] && t < first_triangle[std::size_t(rank) + 1];
  }
  /// Whether this rank knows a vertex: an own or a foreign one. O(log f) for f foreign vertices.
  bool knows_vertex(Number v) const {
    return is_own_vertex(v) || std::binary_search(foreign_vertices.begin(), foreign_vertices.end(), v);
  }
  /// Whether this rank knows a triangle: an own one or a ghost. O(log g) for g ghosts.
  bool knows_triangle(Number t) const {
    return is_own_triangle(t) || std::binary_search(ghost_triangles.begin(), ghost_triangles.end(), t);
  }
  /// The place of a vertex in the arrays. O(1) for own vertices, O(log f) for f foreign ones.
  /// \pre this rank knows it
  std::size_t index_of_vertex(Number v) const {
    if (is_own_vertex(v)) return static_cast<std::size_t>(v - first_vertex[std::size_t(rank)]);
    return number_of_own_vertices() + place_of(foreign_vertices, v);
  }
  /// The place of a triangle in the arrays. O(1) for own triangles, O(log g) for g ghosts.
  /// \pre this rank knows it
  std::size_t index_of_triangle(Number t) const {
    if (is_own_triangle(t)) return static_cast<std::size_t>(t - first_triangle[std::size_t(rank)]);
    return number_of_own_triangles() + place_of(ghost_triangles, t);
  }
  /// The number of a vertex from its place in the arrays.
  Number number_of_vertex(std::size_t i) const {
    const std::size_t own = number_of_own_vertices();
    return i < own ? first_vertex[std::size_t(rank)] + static_cast<Number>(i) : foreign_vertices[i - own];
  }
  /// The number of a triangle from its place in the arrays.
  Number number_of_triangle(std::size_t i) const {
    const std::size_t own = number_of_own_triangles();
    return i < own ? first_triangle[std::size_t(rank)] + static_cast<Number>(i) : ghost_triangles[i - own];
  }
  /// @}

private:
  std::size_t number_of_own(const std::vector<Number>& first) const {
    return static_cast<std::size_t>(first[std::size_t(rank) + 1] - first[std::size_t(rank)]);
  }
  static std::size_t place_of(const std::vector<Number>& ascending, Number i) {
    const auto found = std::lower_bound(ascending.begin(), ascending.end(), i);
    CGAL_precondition(found != ascending.end() && *found == i);
    return static_cast<std::size_t>(found - ascending.begin());
  }
  static int owner(const std::vector<Number>& first, Number i) {
    return static_cast<int>(std::upper_bound(first.begin(), first.end(), i) - first.begin()) - 1;
  }
};

} // namespace CGAL

#endif // CGAL_DISTRIBUTED_MESH_2_H
