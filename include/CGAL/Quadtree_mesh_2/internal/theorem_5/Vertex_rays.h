// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The edges around a vertex, and what the rule for vertices amid equal leaves drops there.
//
// Computes: the directions of the edges, counterclockwise, and how far the rule reaches along each of them.
// Bound:    O(d log d) for d edges.
// Source:   ours: Vertex_placement.h.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_VERTEX_RAYS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_VERTEX_RAYS_H

#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Vertex_placement.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Vertex_window.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_problem.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// An edge as it leaves a vertex.
struct Vertex_ray {
  double angle; ///< of the direction, in radians
  Window_point direction;
  Edge_id edge;
  int lines; ///< the window ends at this grid line ahead
};

/// The edges of a vertex, counterclockwise.
template <class Geometry>
class Vertex_rays {
public:
  Vertex_rays(const Meshing_problem<Geometry>& problem, Vertex_id v) : vertex_(v) {
    for (const auto [neighbor, edge] : problem.edges.at(v)) {
      const Vector d = Geometry::difference(problem.input_point(neighbor), problem.input_point(v));
      const double length = std::sqrt(squared_length(d));
      const Window_point direction{d.x / length, d.y / length};
      rays_.push_back({std::atan2(direction.y, direction.x), direction, edge, few_lines_});
    }
    std::sort(rays_.begin(), rays_.end(),
              [](const Vertex_ray& p, const Vertex_ray& q) { return p.angle < q.angle; });
    for (std::size_t i = 0; i < rays_.size(); ++i)
      if (sector(i) < wide_sector_) rays_[i].lines = rays_[next(i)].lines = many_lines_;
  }

  Vertex_id vertex() const { return vertex_; }
  bool empty() const { return rays_.empty(); }
  std::size_t size() const { return rays_.size(); }
  const Vertex_ray& operator[](std::size_t i) const { return rays_[i]; }
  auto begin() const { return rays_.begin(); }
  auto end() const { return rays_.end(); }
  std::size_t next(std::size_t i) const { return (i + 1) % rays_.size(); }

  /// Degrees from a ray counterclockwise to the next one.
  double sector(std::size_t i) const {
    const double angle = rays_[next(i)].angle - rays_[i].angle;
    return (next(i) == 0 ? angle + 2 * CGAL_PI : angle) * degrees_per_radian;
  }

  /// Whether the sector in which a direction lies is wide enough for the rule.
  bool is_proven(Vector direction) const {
    const double angle = std::atan2(direction.y, direction.x);
    for (std::size_t i = 0; i < rays_.size(); ++i)
      if (is_between(i, angle)) return sector(i) >= least_sector;
    return true;
  }

private:
  static constexpr int few_lines_ = 4, many_lines_ = 6;
  static constexpr double wide_sector_ = 60;

  Vertex_id vertex_;
  std::vector<Vertex_ray> rays_;

  bool is_between(std::size_t i, double angle) const {
    const double first = rays_[i].angle, second = rays_[next(i)].angle;
    return next(i) == 0 ? angle >= first || angle <= second : angle >= first && angle <= second;
  }
};

/// Calls `f(point)` for the corners that are dropped at a vertex amid equal leaves, sector by sector.
template <class Word, class Geometry, class F>
void for_each_dropped_corner(const Vertex_placement<Word>& placement, const Vertex_rays<Geometry>& rays,
                             const F& f) {
  if (rays.empty()) return placement.for_each_corner_at_lone_vertex(f);
  for (const Vertex_ray& r : rays) placement.for_each_corner_on_edge(r.direction, f);
  for (std::size_t i = 0; i < rays.size(); ++i)
    placement.for_each_dropped_corner(rays[i].direction, rays[rays.next(i)].direction, f);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_VERTEX_RAYS_H
