// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Vertices on a leg of an acute corner, none of them much farther from the apex than the one before.
//
// Computes: from the vertices that leaves place on the leg those that are used, and more between them. Each is
//           at most 1.85 times as far from the apex as the one before. So is the far end, unless there is no
//           room before it. The first one is left out if the second is too far for that, and still next to the
//           apex.
// Bound:    O(1) for each vertex; log(L/s) / log(1.85) vertices are added on a leg of length L that begins amid
//           leaves of side s.
// Source:   Acute_corners.h: with a ratio of up to 1.9 the triangles of a trapezoid between two legs have angles
//           of at least min(0.9 phi, 20.7 degrees), where phi is the angle between the legs.
//
// Legs of a narrow sector pass through the same leaves, but for a few places. What is done depends on shares of the leg
// alone. So it is the same on both of them, and the trapezoids match.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_LEG_SPACING_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_LEG_SPACING_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_problem.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_vertices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Leg_spacing {
public:
  using Problem = Meshing_problem<Geometry>;
  using Vertex = Point_on_edge<Geometry>;
  using Vertices = std::vector<Vertex>;

  explicit Leg_spacing(const Problem& problem) : problem_(problem) {}

  /// Whether an edge has a lopped sector beside it, at one of its ends.
  bool is_leg(Edge_id e) const { return is_leg_at(e, 0) || is_leg_at(e, 1); }
  bool is_leg_at(Edge_id e, std::size_t end) const {
    const auto& corners = problem_.corners;
    const Leg_id l = corners.legs_of_edge[e][end];
    return l.is_valid() && (corners.leg(l).before.is_valid() || corners.leg(l).after.is_valid());
  }

  /// How far along the leg from the apex, as shares of it.
  struct Limits {
    double most_of_first; ///< the first vertex is not left out if the next one is beyond this
    double most_of_added; ///< no vertex is added beyond this
  };

  /// \param vertices on the edge, from its first end to its second
  /// \pre there is a leg at that end
  void space_out(Edge_id e, std::size_t end, const Limits& limits, Vertices& vertices) const {
    if (end == 1) std::reverse(vertices.begin(), vertices.end());
    if (vertices.size() > 1 && share(vertices[1], end) > most_ratio_ * share(vertices[0], end) &&
        share(vertices[1], end) <= limits.most_of_first)
      vertices.erase(vertices.begin());
    add_between(e, end, limits.most_of_added, vertices);
    if (end == 1) std::reverse(vertices.begin(), vertices.end());
  }

private:
  static constexpr double most_ratio_ = 1.85;

  const Problem& problem_;

  /// Of the way from an end.
  static double share(const Vertex& v, std::size_t end) { return end == 0 ? v.share : v.rest; }

  void add_between(Edge_id e, std::size_t end, double most, Vertices& vertices) const {
    if (vertices.empty()) return;
    Vertices all;
    for (auto v = vertices.begin(); v != vertices.end(); ++v) {
      all.push_back(*v);
      const auto next = v + 1;
      const double from = share(*v, end), ratio = (next == vertices.end() ? 1 : share(*next, end)) / from;
      const double steps = std::ceil(std::log(ratio) / std::log(most_ratio_));
      for (double step = 1; step < steps; ++step) {
        const double way = from * std::pow(ratio, step / steps);
        if (way <= most) all.push_back(vertex_at(e, end, way));
      }
    }
    vertices = std::move(all);
  }

  Vertex vertex_at(Edge_id e, std::size_t end, double way) const {
    const Input_edge& edge = problem_.edges[e];
    const auto &a = problem_.input_point(edge.a), &b = problem_.input_point(edge.b);
    return end == 0 ? Vertex{way, 1 - way, Geometry::between(a, b, way)}
                    : Vertex{1 - way, way, Geometry::between(b, a, way)};
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_LEG_SPACING_H
