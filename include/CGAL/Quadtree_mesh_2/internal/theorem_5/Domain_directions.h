// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// In which directions the domain is, seen from an edge or a vertex of the graph.
//
// Computes: whether a direction leads from there into the domain.
// Bound:    O(1) from an edge, O(degree) from a vertex.
// Source:   ours.
//
// Directions are rounded. One that is nearly that of an edge leads along it, into the domain on either side.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_DOMAIN_DIRECTIONS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_DOMAIN_DIRECTIONS_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Edge_sides.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Domain_directions {
public:
  Domain_directions(const Meshing_problem<Geometry>& problem, const Edge_sides& sides)
      : problem_(problem), sides_(sides) {}

  /// From the interior of an edge.
  bool is_domain(Edge_id e, Vector direction) const {
    const Vector edge = along(e);
    if (are_parallel(edge, direction)) return is_domain_beside(e);
    return cross(edge, direction) > 0 ? sides_.is_domain_on_left(e) : sides_.is_domain_on_right(e);
  }

  /// From a vertex: on the left of the edge clockwise of the direction. What is around a vertex without edges is not
  /// known here, and taken for the domain.
  bool is_domain(Vertex_id v, Vector direction) const {
    const double turned = std::atan2(direction.y, direction.x);
    double least = std::numeric_limits<double>::infinity();
    bool is_domain = true;
    for (const auto [neighbor, edge] : problem_.edges.at(v)) {
      const bool is_first = v < neighbor;
      const Vector d = is_first ? along(edge) : -1.0 * along(edge);
      if (dot(d, direction) > 0 && are_parallel(d, direction)) return is_domain_beside(edge);
      double angle = turned - std::atan2(d.y, d.x);
      if (angle < 0) angle += 2 * CGAL_PI;
      if (angle >= least) continue;
      least = angle;
      is_domain = is_first ? sides_.is_domain_on_left(edge) : sides_.is_domain_on_right(edge);
    }
    return is_domain;
  }

private:
  const Meshing_problem<Geometry>& problem_;
  const Edge_sides& sides_;

  Vector along(Edge_id e) const {
    const Input_edge& edge = problem_.edges[e];
    return Geometry::difference(problem_.input_point(edge.b), problem_.input_point(edge.a));
  }

  static bool are_parallel(Vector edge, Vector direction) {
    constexpr double sine = 1e-9;
    const double turn = cross(edge, direction);
    return turn * turn <= sine * sine * squared_length(edge) * squared_length(direction);
  }

  bool is_domain_beside(Edge_id e) const {
    return sides_.is_domain_on_left(e) || sides_.is_domain_on_right(e);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_DOMAIN_DIRECTIONS_H
