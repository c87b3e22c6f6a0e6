// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Point location by visibility walks in the kernel's triangulation.
//
// A walk goes through any side that has the query strictly behind it. In a Delaunay triangulation it cannot
// cycle (Devillers, Pion, Teillaud, "Walking in a triangulation", 2002). In other triangulations the side
// tried first changes from step to step, and a walk longer than the caller allows is broken off where it is.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_WALK_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_WALK_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Where a walk ended.
struct Walk_end {
  Triangle_id triangle;
  /// The slot of the constrained (or border) side that stopped the walk; -1 when the triangle holds the
  /// query.
  int blocked_slot;
  bool is_broken_off = false; ///< after as many steps as the caller wanted
  bool is_blocked() const { return blocked_slot >= 0; }
};

/// Walks across every side but the border; each step is decided exactly.
template <class Geometry>
Walk_end locate_exactly(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& q) {
  Triangle_id from;
  for (unsigned step = 0;; ++step) {
    const auto& r = mesh.triangle(t);
    int exit = -1;
    for (unsigned j = 0; j < 3; ++j) {
      const int k = static_cast<int>((j + (step & 1u)) % 3u);
      if (!r.side[k].is_border() && r.side[k].triangle() == from) continue;
      if (Geometry::orientation(mesh.point(r.v[next_slot[k]]), mesh.point(r.v[previous_slot[k]]), q) < 0) {
        exit = k;
        break;
      }
    }
    if (exit < 0) return {t, -1};
    if (r.side[exit].is_border()) return {t, exit};
    from = t;
    t = r.side[exit].triangle();
  }
}

/// Walks from t toward q in sight of it: stops at constrained sides, and after `most_steps`. Each step is decided
/// exactly.
template <class Geometry>
Walk_end walk_in_sight(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& q,
                       std::size_t most_steps) {
  Triangle_id from;
  for (std::size_t step = 0; step < most_steps; ++step) {
    const auto& r = mesh.triangle(t);
    int exit = -1;
    for (unsigned j = 0; j < 3; ++j) {
      const int k = static_cast<int>((j + static_cast<unsigned>(step & 1)) % 3u);
      if (!r.side[k].is_border() && r.side[k].triangle() == from) continue;
      if (Geometry::orientation(mesh.point(r.v[next_slot[k]]), mesh.point(r.v[previous_slot[k]]), q) < 0) {
        exit = k;
        break;
      }
    }
    if (exit < 0) return {t, -1};
    if (r.side[exit].is_constrained()) return {t, exit};
    from = t;
    t = r.side[exit].triangle();
  }
  return {t, -1, true};
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_WALK_H
