// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where rounded points may stand for points on the edges of a graph.
//
// Computes: for each edge the rooms on both sides of it (Edge_room.h). Edges whose vertices are rounded within their
//           rooms neither cross nor touch, and no vertex gets to the other side of one.
// Bound:    O(n) to make from the triangulation of the domain, else that of First_triangulation.h; O(1) for a point.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_EDGE_ROOMS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_EDGE_ROOMS_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Edge_sides.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Edge_room.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/First_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Edge_rooms {
public:
  using Point = typename Geometry::Point;

  template <class ConcurrencyTag>
  static Edge_rooms of(const Meshing_problem<Geometry>& problem) {
    Edge_rooms rooms(problem, nullptr);
    if constexpr (!Geometry::has_unlimited_coordinates) rooms.template triangulate<ConcurrencyTag>();
    return rooms;
  }

  /// Of the edges at the domain: the problem knows what is beyond its border.
  /// \param first the constrained Delaunay triangulation of the graph, restricted to the domain
  template <class ConcurrencyTag>
  static Edge_rooms in_domain(const Meshing_problem<Geometry>& problem, const Edge_sides& sides,
                              const Kernel_mesh<Geometry>& first) {
    Edge_rooms rooms(problem, &sides);
    if constexpr (!Geometry::has_unlimited_coordinates) rooms.template take_from<ConcurrencyTag>(first);
    return rooms;
  }

  /// Whether an edge may get vertices.
  bool has_rooms(Edge_id e) const {
    return !sides_ || sides_->is_domain_on_left(e) || sides_->is_domain_on_right(e);
  }

  /// Whether p lies between `last` and the edge's second end, so far from both that rounding turns no piece
  /// of the edge much. Here `last` is the vertex before p, or the edge's first end.
  bool is_in_order(Edge_id e, const Point& last, const Point& p) const {
    const Vector d = direction(e), before = Geometry::difference(p, last),
                 behind = Geometry::difference(problem_.input_point(problem_.edges[e].b), p);
    const double least = least_distance_ * Geometry::spacing(p);
    for (const double distance : {along(d, before), along(d, behind)})
      if (!(distance > 0 && distance >= least)) return false;
    return true;
  }

  /// The place in the room of an edge that is p or next to it, if there is one.
  /// \pre p is a point of the edge, rounded
  std::optional<Point> place_next_to(Edge_id e, const Point& p) const {
    if (is_in_room(e, p)) return p;
    if constexpr (!Geometry::has_unlimited_coordinates) {
      // On the edge, if that were possible, and to either side of it, no further than how p was rounded.
      const Vector d = direction(e),
                   from_a = Geometry::difference(p, problem_.input_point(problem_.edges[e].a));
      const bool is_steep = std::fabs(d.y) > std::fabs(d.x);
      const double way = cross(d, from_a) / (is_steep ? d.y : -d.x);
      const double spacing = Geometry::spacing(is_steep ? p.x : p.y),
                   rounding = std::numeric_limits<double>::epsilon() * std::fabs(along(d, from_a));
      const auto beside = [&](double f) {
        return Geometry::translate(p, is_steep ? Vector{way + f, 0} : Vector{0, way + f});
      };
      if (const Point q = beside(0); is_in_room(e, q)) return q;
      for (double step = spacing; step < 2 * std::max(spacing, rounding); step *= 2)
        for (const double f : {step, -step})
          if (const Point q = beside(f); is_in_room(e, q)) return q;
    }
    return std::nullopt;
  }

private:
  /// Of neighbors on an edge, in units of the coordinates.
  static constexpr double least_distance_ = 8;
  static constexpr std::size_t left_ = 0, right_ = 1;

  using Room = Edge_room<Geometry>;

  const Meshing_problem<Geometry>& problem_;
  const Edge_sides* sides_;                                             // null: there are rooms on all sides
  Indexed_vector<Edge_id, std::array<std::optional<Point>, 2>> apexes_; // of the triangles beside edges

  Edge_rooms(const Meshing_problem<Geometry>& problem, const Edge_sides* sides)
      : problem_(problem), sides_(sides) {}

  Vector direction(Edge_id e) const {
    return Geometry::difference(problem_.input_point(problem_.edges[e].b),
                                problem_.input_point(problem_.edges[e].a));
  }
  /// How far a way goes on in x, or in y where d is steep.
  static double along(Vector d, Vector way) {
    return std::fabs(d.y) > std::fabs(d.x) ? std::copysign(1.0, d.y) * way.y
                                           : std::copysign(1.0, d.x) * way.x;
  }

  bool is_in_room(Edge_id e, const Point& p) const {
    if (apexes_.empty()) return true; // coordinates are unlimited, so it is on the edge
    const Point &a = problem_.input_point(problem_.edges[e].a),
                &b = problem_.input_point(problem_.edges[e].b);
    const int side = Geometry::orientation(a, b, p);
    if (side == 0) return true;
    if (sides_ && !(side > 0 ? sides_->is_domain_on_left(e) : sides_->is_domain_on_right(e)))
      return problem_.is_clear_of_outside(e, p);
    return side > 0 ? room(a, b, apexes_[e][left_]).has(a, b, p)
                    : room(b, a, apexes_[e][right_]).has(b, a, p);
  }

  static Room room(const Point& a, const Point& b, const std::optional<Point>& apex) {
    return apex ? Room(a, b, *apex) : Room();
  }

  template <class ConcurrencyTag>
  void triangulate() {
    using First = First_triangulation<ConcurrencyTag, Geometry>;
    Kernel_mesh<Geometry> mesh;
    First first(mesh, problem_.input_points.values());
    std::vector<typename First::Segment> segments;
    segments.reserve(problem_.edges.size());
    for (const Edge_id e : problem_.edges.ids())
      segments.push_back({problem_.edges[e].a, problem_.edges[e].b});
    first.run(segments);
    take_from<ConcurrencyTag>(mesh);
  }

  /// The rooms in the triangles of a triangulation, in which no edge is cut.
  template <class ConcurrencyTag>
  void take_from(const Kernel_mesh<Geometry>& mesh) {
    apexes_.resize(problem_.edges.size());
    for_each_index<ConcurrencyTag>(mesh.triangles.size(), [&](std::size_t i) {
      const Triangle_id t(i);
      for (int k = 0; k < 3 && mesh.is_alive(t); ++k) {
        const Side s(t, k);
        if (mesh.across(s).is_constrained()) take_apex(mesh, s);
      }
    });
  }

  void take_apex(const Kernel_mesh<Geometry>& mesh, Side s) {
    const Vertex_id a = mesh.source(s), b = mesh.target(s);
    if (std::max(std::size_t(a), std::size_t(b)) >= problem_.input_points.size())
      return; // auxiliary vertices
    const Edge_id e = problem_.edges.between(a, b);
    apexes_[e][problem_.edges[e].a == a ? left_ : right_] = mesh.point(mesh.opposite(s));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_EDGE_ROOMS_H
