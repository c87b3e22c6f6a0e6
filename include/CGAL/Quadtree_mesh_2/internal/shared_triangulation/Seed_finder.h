// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Finds which of a part's own triangles (Own_triangles.h) hold points of holes and regions.
//
// Each part walks to all points, in shuffle order, through the triangulation that it has. Where it has stars of others,
// walks may end in a triangle that is none of the whole triangulation; but then the point is in no triangle of this
// part, or on a side of one. So it may be that no part finds a point on a free side at a seam.
// O(1) steps for each point on average.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_SEED_FINDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_SEED_FINDER_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Own_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Place_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/walk.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A triangle of a part that holds the point of a hole or region.
struct Seed_holder {
  std::uint32_t number; ///< of the point in its list
  std::uint32_t place;  ///< of the triangle in the part
};

/// What a part finds of some points.
struct Seeds_found {
  std::vector<Seed_holder> held;
  std::vector<char> is_beyond;  ///< for each point, whether it is in no triangle of any part
  bool is_any_doubtful = false; ///< whether one is on a segment or a vertex, as far as this part can tell
};

template <class Geometry>
class Seed_finder {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Point = typename Geometry::Point;

  Seed_finder(const Mesh& mesh, const Own_triangles<Geometry>& own) : mesh_(mesh), own_(own) {}

  Seeds_found find(const std::vector<Point>& points) const {
    Seeds_found found;
    found.is_beyond.resize(points.size(), 0);
    if (points.empty()) return found;
    const Place_keys<Geometry> key(mesh_.points.values());
    const auto order = radix_order<Chosen_tag>(points.size(), [&](std::size_t p) { return key(points[p]); });
    Triangle_id hint(0);
    for (const std::uint32_t p : order) {
      const Walk_end end = locate_exactly(mesh_, hint, points[p]);
      hint = end.triangle;
      if (end.is_blocked()) {
        found.is_beyond[p] = 1;
        continue;
      }
      found.is_any_doubtful = found.is_any_doubtful || is_doubtful(end.triangle, points[p]);
      if (own_.has(end.triangle))
        found.held.push_back({p, static_cast<std::uint32_t>(own_.place(end.triangle))});
    }
    return found;
  }

private:
  const Mesh& mesh_;
  const Own_triangles<Geometry>& own_;

  bool is_doubtful(Triangle_id t, const Point& p) const {
    const auto& r = mesh_.triangle(t);
    int on_sides = 0;
    bool is_on_segment = false;
    for (int k = 0; k < 3; ++k) {
      if (Geometry::orientation(mesh_.point(r.v[next_slot[k]]), mesh_.point(r.v[previous_slot[k]]), p) != 0)
        continue;
      ++on_sides;
      is_on_segment = is_on_segment || r.side[k].is_constrained();
    }
    return on_sides == 2 || is_on_segment;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_SEED_FINDER_H
