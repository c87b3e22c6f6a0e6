// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Point location by visibility walks in the kernel's triangulation.
//
// A walk goes through any side that has the query strictly behind it. In a Delaunay triangulation it cannot
// cycle, in others it ends with probability 1 if the side tried first is drawn by lot in each triangle (Devillers,
// Pion, Teillaud, "Walking in a triangulation", 2002). Sides that are crossed in sight of the query are Delaunay but
// for those at the seams of blocks: there a walk longer than the caller allows is broken off where it is. Walks
// across constrained sides, which need not be Delaunay, draw lots, the same in each run.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_WALK_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_WALK_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <cstddef>
#include <cstdint>

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

/// The slots that a walk tries first, drawn by a linear congruential generator (Knuth, "The Art of Computer
/// Programming", volume 2, section 3.3.4). Slots in turn would be a period that a cycle of triangles can share.
class Slot_lots {
public:
  int draw() {
    state_ = 1664525 * state_ + 1013904223;
    return static_cast<int>((std::uint64_t(3) * state_) >> 32);
  }

private:
  std::uint32_t state_ = 0;
};

/// The slot of a side of t that has q strictly behind it, -1 if there is none. Decided exactly.
/// \param first the slot tried first
/// \param from the triangle that the walk comes from, which is not behind
template <class Geometry>
int exit_toward(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& q,
                int first, Triangle_id from) {
  const auto& r = mesh.triangle(t);
  int k = first;
  for (int tried = 0; tried < 3; ++tried, k = next_slot[k]) {
    if (!r.side[k].is_border() && r.side[k].triangle() == from) continue;
    if (Geometry::orientation(mesh.point(r.v[next_slot[k]]), mesh.point(r.v[previous_slot[k]]), q) < 0)
      return k;
  }
  return -1;
}

/// Walks across every side but the border.
template <class Geometry>
Walk_end locate_exactly(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& q) {
  Triangle_id from;
  for (Slot_lots lots;;) {
    const int exit = exit_toward(mesh, t, q, lots.draw(), from);
    if (exit < 0) return {t, -1};
    const Side side = mesh.triangle(t).side[exit];
    if (side.is_border()) return {t, exit};
    from = t;
    t = side.triangle();
  }
}

/// Walks from t toward q in sight of it: stops at constrained sides, and after `most_steps`.
template <class Geometry>
Walk_end walk_in_sight(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& q,
                       std::size_t most_steps) {
  Triangle_id from;
  for (std::size_t step = 0; step < most_steps; ++step) {
    const int exit = exit_toward(mesh, t, q, static_cast<int>(step & 1), from);
    if (exit < 0) return {t, -1};
    const Side side = mesh.triangle(t).side[exit];
    if (side.is_constrained()) return {t, exit};
    from = t;
    t = side.triangle();
  }
  return {t, -1, true};
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_WALK_H
