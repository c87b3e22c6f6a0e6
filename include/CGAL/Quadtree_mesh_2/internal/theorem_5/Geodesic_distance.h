// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// How far a vertex of a graph is from what it sees in the domain.
//
// Computes: the distance to the nearest vertex that the vertex sees, or to the nearest of the edges opposite it in its
//           triangles, if that is less. Features beyond a gap outside the domain do not count.
// Bound:    O(d) for the d triangles of the vertex.
// Source:   the nearest vertex in sight is a neighbor in the constrained Delaunay triangulation. If the nearest edge in
//           sight is not opposite the vertex, then another vertex is, whose triangle's circle passes between the two.
//           Balance then makes leaves small around that one.
// Deviates: Bern, Eppstein and Teng have the near vertex of the quadtree and the edges that axis-parallel rays hit
//           first (Lemma 5), which see across the outside as well.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_GEODESIC_DISTANCE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_GEODESIC_DISTANCE_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Geodesic_distance {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Number = typename Geometry::Number;

  /// \pre the mesh is the constrained Delaunay triangulation of the graph, restricted to its domain
  explicit Geodesic_distance(const Mesh& mesh) : mesh_(mesh) {}

  /// In the kernel's coordinates; infinite if the vertex is in no triangle.
  double operator()(Vertex_id v) const {
    if (!mesh_.incident_triangle(v).is_valid()) return std::numeric_limits<double>::infinity();
    Fan_walk<Mesh> fan(mesh_, v);
    Number least = squared_distance_in(fan.triangle(), fan.slot());
    while (fan.advance()) least = std::min(least, squared_distance_in(fan.triangle(), fan.slot()));
    return std::sqrt(ratio(least, 1));
  }

private:
  const Mesh& mesh_;

  /// From vertex k of a triangle to the others, and to the side opposite it if that is an edge of the graph.
  Number squared_distance_in(Triangle_id t, int k) const {
    const auto& r = mesh_.triangle(t);
    auto s = mesh_.shape(r);
    const int i = next_slot[k], j = previous_slot[k];
    const Number to_vertex = std::min(s.l[i], s.l[j]);
    const bool is_foot_between = s.l[i] + s.l[k] > s.l[j] && s.l[j] + s.l[k] > s.l[i];
    if (!r.side[k].is_constrained() || !is_foot_between) return to_vertex;
    if (!s.is_certainly_counterclockwise()) s = mesh_.shape_of_flat(r.v[0], r.v[1], r.v[2]);
    return std::min(to_vertex, Number(s.area2 * s.area2 / s.l[k]));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_GEODESIC_DISTANCE_H
