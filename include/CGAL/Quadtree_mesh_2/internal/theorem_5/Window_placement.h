// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What is placed in the windows of vertices (Vertex_windows.h).
//
// Computes: the points of an edge on the ring of its end and halfway to the first crossing that is used; which
//           corners of the leaves of windows are kept.
// Bound:    O(1) for each window and edge of its vertex, O(degree) for each corner on a grid line far ahead.
// Source:   ours: Column_rule.h, Vertex_placement.h.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_WINDOW_PLACEMENT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_WINDOW_PLACEMENT_H

#include <CGAL/Quadtree_mesh_2/internal/columns/Column_rule.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Vertex_placement.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Tree_corners.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Placed_vertices.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Separation_trees.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Vertex_rays.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Vertex_windows.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Traits, class ConcurrencyTag>
class Window_placement {
public:
  using Trees = Separation_trees<Traits, ConcurrencyTag>;
  using Geometry = typename Trees::Geometry;
  using Problem = Meshing_problem<Geometry>;
  using Tree = typename Trees::Tree;
  using Corners = Tree_corners<Tree>;
  using Vertex = Point_on_edge<Geometry>;

  Window_placement(const Problem& problem, const Trees& trees)
      : problem_(problem), trees_(trees), tree_(trees.tree()), windows_(trees.windows()) {}

  bool is_at(Vertex_id v) const { return windows_.at(v) != Windows::none; }
  bool has(Leaf_index l) const { return windows_.of(l) != Windows::none; }

  bool empty() const { return windows_.empty(); }

  /// Shares of an edge, from an end with a window on. No crossing is used before the first; all that are between them
  /// are.
  struct Shares {
    double first, last;
  };
  /// \param end of the edge, by number
  Shares crossings_at(Edge_id e, std::size_t end) const {
    const Vertex_id v = vertex(e, end);
    const Edge_start s = start(e, end);
    const auto& rays = windows_[windows_.at(v)];
    const auto ray = std::find_if(rays.begin(), rays.end(), [&](const Vertex_ray& r) { return r.edge == e; });
    const Edge_axis axis = Edge_axis::of(ray->direction);
    const double step = 1 / std::abs(axis.along(ray->direction)); // from one grid line to the next
    const double unit = side(v) / length(e);
    const int lines = std::abs(axis.line(ray->lines) - s.first_line);
    return {(s.first_crossing - 0.25) * unit, (s.first_crossing + lines * step + 0.25) * unit};
  }

  /// The points on the ring, and halfway from there to a crossing, from the end on.
  std::array<Vertex, 2> points_at(Edge_id e, std::size_t end) const {
    const Edge_start s = start(e, end);
    std::array<Vertex, 2> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double share = s.distances[i] * side(vertex(e, end)) / length(e);
      const auto place = Geometry::between(problem_.input_point(vertex(e, end)),
                                           problem_.input_point(vertex(e, 1 - end)), share);
      points[i] = end == 0 ? Vertex{share, 1 - share, place} : Vertex{1 - share, share, place};
    }
    return points;
  }

  /// The window whose rule decides on a corner; or `none`.
  std::uint32_t window_at(const typename Corners::Leaves& leaves) const {
    for (const Leaf_index l : leaves)
      if (l.is_valid() && has(l)) return windows_.of(l);
    return none;
  }
  static constexpr std::uint32_t none = Vertex_windows<Tree, Geometry>::none;

  /// Whether a corner is clear of the edges on whose grid lines it is far ahead. The others are looked at by sectors.
  bool is_clear_far_ahead(std::uint32_t w, const typename Trees::Grid_point& corner) const {
    const auto& rays = windows_[w];
    const Leaf_index own = trees_.leaf(rays.vertex());
    const auto s = tree_.square(own);
    const double side = trees_.side(own);
    const Vector p = Geometry::difference(trees_.kernel_point(corner), problem_.input_point(rays.vertex()));
    const Vector c = Geometry::difference(trees_.kernel_point(corner), trees_.kernel_point({s.x, s.y}));
    const Window_point place{std::round(c.x / side), std::round(c.y / side)};
    return std::none_of(rays.begin(), rays.end(), [&](const Vertex_ray& r) {
      const Window_point& d = r.direction;
      return Edge_axis::of(d).is_far(place) && p.x * d.x + p.y * d.y > 0 &&
             std::abs(d.x * p.y - d.y * p.x) < equal_leaves_threshold * side;
    });
  }

  /// Drops the corners that vertices of windows drop, sector by sector.
  /// \param is_kept by name of a corner
  void drop_corners(const Corners& corners, std::vector<char>& is_kept) const {
    constexpr std::size_t block = 16;
    std::vector<std::vector<typename Corners::Name>> found((windows_.size() + block - 1) / block);
    for_each_block<ConcurrencyTag>(windows_.size(), block,
                                   [&](std::size_t b, std::size_t begin, std::size_t end) {
                                     for (std::size_t w = begin; w < end; ++w)
                                       if (is_at(windows_[w].vertex())) find_corners(w, corners, found[b]);
                                   });
    for (const auto& names : found)
      for (const auto c : names) is_kept[c] = 0;
  }

private:
  using Windows = Vertex_windows<Tree, Geometry>;

  const Problem& problem_;
  const Trees& trees_;
  const Tree& tree_;
  const Windows& windows_;

  double side(Vertex_id v) const { return trees_.side(trees_.leaf(v)); }
  Vertex_id vertex(Edge_id e, std::size_t end) const {
    return end == 0 ? problem_.edges[e].a : problem_.edges[e].b;
  }
  Vector way(Edge_id e, std::size_t end) const {
    return Geometry::difference(problem_.input_point(vertex(e, 1 - end)),
                                problem_.input_point(vertex(e, end)));
  }
  double length(Edge_id e) const { return std::sqrt(squared_length(way(e, 0))); }

  Edge_start start(Edge_id e, std::size_t end) const {
    const Vector d = way(e, end);
    const double length = std::sqrt(squared_length(d));
    const Window_point direction{d.x / length, d.y / length};
    return trees_.placement_at(vertex(e, end)).start_of_edge(direction, Edge_axis::of(direction));
  }

  void find_corners(std::size_t w, const Corners& corners, std::vector<typename Corners::Name>& names) const {
    const auto& rays = windows_[w];
    for_each_dropped_corner(trees_.placement_at(rays.vertex()), rays,
                            [&](const typename Trees::Grid_point& p) {
                              const auto c = corners.name(p);
                              if (c != Corners::none) names.push_back(c);
                            });
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_WINDOW_PLACEMENT_H
