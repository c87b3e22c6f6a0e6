// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where rounded vertices of a mesh's border may be without meeting the border across what is outside.
//
// Computes: whether the Steiner vertices of a border piece are in the room of its chain (Edge_room.h), which is in the
//           triangle outside of the chain, or on its inner side.
// Bound:    O(1) for a piece.
// Source:   ours.
//
// No triangle of the mesh is outside, so the mesh alone does not tell when two parts of the border cross over a gap
// between them. If all triangles are counterclockwise, all pieces go ahead and all are in their rooms, no two edges
// cross or touch: each place is covered by as many triangles as the border winds around it. Before rounding that is
// at most once. Rooms are disjoint and outside, so what chains add in them is at most one, where there was none; what
// they add on their inner sides is negative.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_OUTER_ROOMS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_OUTER_ROOMS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/output/Segment_chains.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Edge_room.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Doubles of any size, as users have them.
struct User_geometry {
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;

  static Vector difference(const Point& p, const Point& q) { return {p.x() - q.x(), p.y() - q.y()}; }
  /// The point itself if the sum is not finite: a room with such a tip is none.
  static Point translate(const Point& p, Vector v) {
    const Point sum(p.x() + v.x, p.y() + v.y);
    return std::isfinite(sum.x()) && std::isfinite(sum.y()) ? sum : p;
  }
  static int orientation(const Point& a, const Point& b, const Point& c) {
    return Kernel::Orientation_2()(a, b, c);
  }
};

template <class Point>
class Outer_rooms {
public:
  Outer_rooms(const Indexed_mesh_2<Point>& mesh, const Segment_chains<Point>& chains)
      : mesh_(mesh), chains_(chains) {}

  /// How many Steiner vertices of a piece are not clear of what is outside.
  std::size_t number_of_vertices_beyond(std::size_t piece) const {
    const auto& edge = mesh_.constrained_edges[piece];
    if (!edge.outer_vertex.is_valid() || (is_input(edge.vertices[0]) && is_input(edge.vertices[1]))) return 0;
    auto [b, a] = chains_.ends_of_chain(piece);
    if (!a.is_valid()) return 0;
    // The domain is on the left of the edge, so the outside is on the left of the opposite direction.
    if (chains_.ends_of_piece(piece)[0] != edge.vertices[0]) std::swap(a, b);
    const Place from = place(a), to = place(b);
    const Edge_room<User_geometry> room(from, to, place(edge.outer_vertex));
    // A vertex that is tried at an end of its chain is as good as merged with it.
    return static_cast<std::size_t>(
        std::count_if(edge.vertices.begin(), edge.vertices.end(), [&](Vertex_index v) {
          const Place p = place(v);
          return p != from && p != to && !room.has(from, to, p);
        }));
  }

private:
  using Place = User_geometry::Point;

  const Indexed_mesh_2<Point>& mesh_;
  const Segment_chains<Point>& chains_;

  bool is_input(Vertex_index v) const { return std::size_t(v) < mesh_.number_of_input_vertices; }
  Place place(Vertex_index v) const { return Place(mesh_.point(v).x(), mesh_.point(v).y()); }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_OUTER_ROOMS_H
