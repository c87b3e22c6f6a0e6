// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Axis-parallel rays from the vertices of a graph and single segments: whether and where they meet.
//
// Computes: whether a ray meets a segment that is not incident to its vertex, at what distance, and which of
//           two such distances is less.
// Bound:    O(1) predicates each.
// Method:   Exact predicates decide whether they meet. Distances are compared as intervals, and as rational
//           numbers where these overlap.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_AXIS_RAYS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_AXIS_RAYS_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Point_arithmetic.h>
#include <CGAL/Quadtree_mesh_2/vertex_edge_neighbor_types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Graph>
class Axis_rays {
  using Point = typename Graph::Point_2;
  using Arithmetic = Point_arithmetic<Point>;
  using Exact = typename Arithmetic::Exact;

public:
  struct Ray {
    Vertex_index vertex;
    Direction direction;

    int axis() const { return step_y(direction) == 0 ? 0 : 1; }
    int sign() const { return step_x(direction) + step_y(direction); }
  };

  /// A segment that a ray hits, at a distance in an interval.
  struct Hit {
    Segment_index segment;
    Interval distance = Interval(0);
  };

  explicit Axis_rays(const Graph& graph) : graph_(graph) {}

  const Graph& graph() const { return graph_; }

  /// The hit of a segment, or of none.
  /// \pre the ray hits the segment beyond its vertex if it is valid
  Hit hit_ahead(const Ray& ray, Segment_index s) const {
    Hit result;
    result.segment = s;
    if (s.is_valid()) result.distance = distance_ahead(ray, ends(ray, s));
    return result;
  }

  /// The sign of the difference of the distances of two hits of rays from the same vertex; exact.
  int compare(const Ray& r, const Hit& a, const Ray& q, const Hit& b) const {
    return compare_filtered(a.distance, b.distance, [&] {
      const Exact d = exact_distance(r, a.segment), e = exact_distance(q, b.segment);
      return d < e ? -1 : e < d ? 1 : 0;
    });
  }

  /// The distance of a hit, rounded.
  double rounded_distance(const Ray& ray, const Hit& hit) const {
    if (!hit.segment.is_valid()) return std::numeric_limits<double>::infinity();
    const Interval& d = hit.distance;
    if (d.is_point()) return d.inf();
    return is_narrow(d) ? d.inf() + (d.sup() - d.inf()) / 2
                        : CGAL::to_double(exact_distance(ray, hit.segment));
  }

  /// Where the ends of a segment are, seen from the ray: signs of the distance across it, and along it.
  struct Ends {
    const Point &a, &b;
    int across_a, across_b, along_a, along_b;
  };

  Ends ends(const Ray& ray, Segment_index s) const {
    const Point& v = graph_.point(ray.vertex);
    const auto& segment = graph_.segment(s);
    const Point &a = graph_.point(segment[0]), &b = graph_.point(segment[1]);
    const int axis = ray.axis();
    return {a,
            b,
            Arithmetic::compare(a, v, 1 - axis),
            Arithmetic::compare(b, v, 1 - axis),
            ray.sign() * Arithmetic::compare(a, v, axis),
            ray.sign() * Arithmetic::compare(b, v, axis)};
  }

  enum class Meeting { NONE, AT_VERTEX, AHEAD };

  Meeting meeting(const Ray& ray, const Ends& e) const {
    if (e.across_a * e.across_b > 0 || (e.along_a < 0 && e.along_b < 0)) return Meeting::NONE;
    const bool is_incident = (e.across_a == 0 && e.along_a == 0) || (e.across_b == 0 && e.along_b == 0);
    if (is_incident) return Meeting::NONE;
    if (e.across_a == 0 && e.across_b == 0)
      return e.along_a * e.along_b < 0 ? Meeting::AT_VERTEX : Meeting::AHEAD;
    if (e.across_a == 0) return e.along_a > 0 ? Meeting::AHEAD : Meeting::NONE;
    if (e.across_b == 0) return e.along_b > 0 ? Meeting::AHEAD : Meeting::NONE;
    const int turn = Arithmetic::orientation(e.a, e.b, graph_.point(ray.vertex));
    // A segment upwards has the vertex to the left if it crosses the line to the east; one to the right has
    // it to the left if it crosses below.
    const int side = turn * e.across_b * ray.sign() * (ray.axis() == 0 ? 1 : -1);
    return side > 0 ? Meeting::AHEAD : side == 0 ? Meeting::AT_VERTEX : Meeting::NONE;
  }

  /// The distance of a segment that the ray hits beyond its vertex, as an interval.
  Interval distance_ahead(const Ray& ray, const Ends& e) const {
    Interval::Protector protector;
    return distance_ahead<Interval>(ray, e);
  }

private:
  /// The distance of a segment that the ray hits.
  Exact exact_distance(const Ray& ray, Segment_index s) const {
    const Ends e = ends(ray, s);
    return meeting(ray, e) == Meeting::AT_VERTEX ? Exact(0) : distance_ahead<Exact>(ray, e);
  }

  template <class Number>
  Number distance_ahead(const Ray& ray, const Ends& e) const {
    const Point& v = graph_.point(ray.vertex);
    const int axis = ray.axis();
    const auto to_end = [&](const Point& end) {
      return Number(CGAL::abs(Arithmetic::template difference<Number>(end, v, axis)));
    };
    if (e.across_a == 0 && e.across_b == 0) return least(to_end(e.a), to_end(e.b));
    if (e.across_a == 0) return to_end(e.a);
    if (e.across_b == 0) return to_end(e.b);
    const auto from_vertex = [&](const Point& end, int i) {
      return Arithmetic::template difference<Number>(end, v, i);
    };
    const Number ax = from_vertex(e.a, 0), ay = from_vertex(e.a, 1), bx = from_vertex(e.b, 0),
                 by = from_vertex(e.b, 1);
    const Number height = Arithmetic::template difference<Number>(e.b, e.a, 1 - axis);
    return Number(CGAL::abs(Number((ax * by - ay * bx) / height)));
  }

  const Graph& graph_;
};

/// The first hits of the four rays from a vertex; `nearest` is the index of one of them.
struct Vertex_edge_hits {
  std::array<Vertex_edge_neighbor_2, 4> first;
  std::uint8_t nearest = 0;
};

/// Collects the hits of a vertex, where `first_hit(ray)` finds the first one of a ray.
template <class Rays, class First_hit>
Vertex_edge_hits vertex_edge_hits(const Rays& rays, Vertex_index v, const First_hit& first_hit) {
  using Ray = typename Rays::Ray;
  Vertex_edge_hits result;
  typename Rays::Hit nearest;
  for (int i = 0; i < 4; ++i) {
    const Ray ray{v, static_cast<Direction>(2 * i)};
    const typename Rays::Hit hit = first_hit(ray);
    result.first[std::size_t(i)] = {hit.segment, rays.rounded_distance(ray, hit)};
    if (!hit.segment.is_valid()) continue;
    const Ray nearest_ray{v, static_cast<Direction>(2 * result.nearest)};
    const int c = nearest.segment.is_valid() ? rays.compare(ray, hit, nearest_ray, nearest) : -1;
    if (c > 0 || (c == 0 && !(hit.segment < nearest.segment))) continue;
    nearest = hit;
    result.nearest = static_cast<std::uint8_t>(i);
  }
  return result;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_AXIS_RAYS_H
