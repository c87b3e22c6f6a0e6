// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Rays from the vertices of a graph to the first segment that they hit.
//
// Computes: the first segment, not incident to its vertex, that an axis-parallel ray hits, and the distance.
// Bound:    O(1) for each leaf on the way and for each segment listed there. Neither is bounded by a
//           constant: a ray may pass many leaves before it hits, and long segments may be listed in many of
//           them.
// Method:   The ray goes from leaf to leaf by cross pointers, in the row (or column) of its grid points,
//           which are known without rounding. A hit point lies in a leaf on the way, and its segment is
//           listed there. So the walk ends with the first leaf that certainly has a hit before its far side.
//           If that is uncertain, the walk goes on, which costs time and changes nothing.
//
// Exact predicates decide whether a ray hits. Intervals decide which hit is nearer, and rational numbers
// where these overlap.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_AXIS_RAY_CASTER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_AXIS_RAY_CASTER_H

#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Point_arithmetic.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Axis_rays.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Leaf_segments.h>
#include <CGAL/Quadtree_mesh_2/vertex_edge_neighbor_types.h>
#include <CGAL/assertions.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Tree, class Graph>
class Axis_ray_caster {
  using Point = typename Tree::Point_2;
  using Arithmetic = Point_arithmetic<Point>;
  using Grid_point = typename Tree::Grid_point;

public:
  using Rays = Axis_rays<Graph>;
  using Ray = typename Rays::Ray;

  /// A segment that a ray hits, at a distance in an interval.
  struct Hit : Rays::Hit {
    double reach = 0; ///< the coordinate along the ray where that ends, or one beyond
  };

  Axis_ray_caster(const Tree& tree, const Leaf_segments& lists, const Graph& graph)
      : tree_(tree), lists_(lists), graph_(graph), rays_(graph) {}

  const Rays& rays() const { return rays_; }

  /// The first hit; that of the least index if there are several at the same distance; none if there is none.
  Hit first_hit(const Ray& ray) const {
    const auto rank = tree_.framework().rank(Point_index(ray.vertex.value()));
    const Grid_point& g = tree_.framework().grid_point(rank);
    Hit best;
    for (Node_index v = tree_.node(tree_.leaf(rank)); v.is_valid(); v = next_leaf(v, g, ray)) {
      for (const Segment_index s : lists_[tree_.leaf(v)]) try_segment(ray, s, best);
      if (best.segment.is_valid() && is_before_far_side(ray, best, v)) break;
    }
    return best;
  }

private:
  const Tree& tree_;
  const Leaf_segments& lists_;
  const Graph& graph_;
  Rays rays_;

  using Meeting = typename Rays::Meeting;

  void try_segment(const Ray& ray, Segment_index s, Hit& best) const {
    if (s == best.segment) return;
    if (best.segment.is_valid() && is_beyond(ray, s, best.reach)) return;
    const auto ends = rays_.ends(ray, s);
    const Meeting m = rays_.meeting(ray, ends);
    if (m == Meeting::NONE) return;
    Hit hit;
    hit.segment = s;
    if (m == Meeting::AHEAD) hit.distance = rays_.distance_ahead(ray, ends);
    const int c = best.segment.is_valid() ? rays_.compare(ray, hit, ray, best) : -1;
    if (c > 0 || (c == 0 && !(s < best.segment))) return;
    best = hit;
    const std::pair<double, double> from = Arithmetic::bounds(graph_.point(ray.vertex), ray.axis());
    best.reach =
        ray.sign() > 0 ? after(from.second + hit.distance.sup()) : before(from.first - hit.distance.sup());
  }

  /// Whether both ends of a segment are further along than a coordinate: what most segments of a long list
  /// need not be asked more than.
  bool is_beyond(const Ray& ray, Segment_index s, double coordinate) const {
    const auto& segment = graph_.segment(s);
    const std::pair<double, double> a = Arithmetic::bounds(graph_.point(segment[0]), ray.axis());
    const std::pair<double, double> b = Arithmetic::bounds(graph_.point(segment[1]), ray.axis());
    return ray.sign() > 0 ? a.first > coordinate && b.first > coordinate
                          : a.second < coordinate && b.second < coordinate;
  }

  /// Whether the hit certainly lies before the side by which the ray leaves a leaf.
  bool is_before_far_side(const Ray& ray, const Hit& hit, Node_index leaf) const {
    if (hit.distance.sup() == 0) return true;
    const std::pair<double, double> from = Arithmetic::bounds(graph_.point(ray.vertex), ray.axis());
    const auto corners = tree_.corners(leaf);
    const std::pair<double, double> side = Arithmetic::bounds(corners[ray.sign() > 0 ? 2 : 0], ray.axis());
    // The corner may have been rounded, and the difference is.
    const double least_side =
        ray.sign() > 0 ? before(before(side.first) - from.second) : before(from.first - after(side.second));
    return hit.distance.sup() < least_side;
  }
  static double before(double v) { return std::nextafter(v, -std::numeric_limits<double>::infinity()); }
  static double after(double v) { return std::nextafter(v, std::numeric_limits<double>::infinity()); }

  /// The leaf after `leaf` in the row or column of `g`, invalid outside the root.
  Node_index next_leaf(Node_index leaf, const Grid_point& g, const Ray& ray) const {
    Node_index v = tree_.neighbor(leaf, ray.direction);
    if (!v.is_valid() || tree_.is_leaf(v)) return v;
    using Operations = Word_operations<typename Tree::Word>;
    const int depth = tree_.framework().grid().depth();
    for (int bit = depth - 1 - tree_.level(v); !tree_.is_leaf(v); --bit) {
      const int near = ray.sign() > 0 ? 0 : 1;
      v = ray.axis() == 0 ? tree_.child(v, 2 * near + Operations::bit(g.y, bit))
                          : tree_.child(v, 2 * Operations::bit(g.x, bit) + near);
    }
    return v;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_AXIS_RAY_CASTER_H
