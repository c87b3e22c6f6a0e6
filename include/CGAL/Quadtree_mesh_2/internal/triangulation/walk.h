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
#include <limits>

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

/// Whether the query is strictly behind side k of a triangle; exact.
template <class Geometry>
bool is_behind_side(const Kernel_mesh<Geometry>& mesh, const typename Kernel_mesh<Geometry>::Triangle& r,
                    int k, const typename Geometry::Point& q) {
  return Geometry::orientation(mesh.point(r.v[next_slot[k]]), mesh.point(r.v[previous_slot[k]]), q) < 0;
}

/// The slot by which a walk leaves the triangle it begins in, trying `first` first; -1 if that holds the query.
template <class Geometry>
int first_exit(const Kernel_mesh<Geometry>& mesh, Triangle_id t, int first,
               const typename Geometry::Point& q) {
  int k = first;
  for (int tried = 0; tried < 3; ++tried, k = next_slot[k])
    if (is_behind_side(mesh, mesh.triangle(t), k, q)) return k;
  return -1;
}

/// The same for a triangle that a walk has come into by side `entry`. Both other sides are looked at, and the choice is
/// no branch, for it would be taken at random.
template <class Geometry>
int next_exit(const Kernel_mesh<Geometry>& mesh, Side entry, int first, const typename Geometry::Point& q) {
  const int one = first == entry.slot() ? entry.slot_after() : first, other = 3 - one - entry.slot();
  const auto& r = mesh.triangle(entry.triangle());
  const int is_one = is_behind_side(mesh, r, one, q) ? 1 : 0;
  const int is_other = is_behind_side(mesh, r, other, q) ? 1 : 0;
  return (is_one | is_other) == 0 ? -1 : other + is_one * (one - other);
}

/// Walks across the sides that do not stop it, no more than the given number of them.
/// \param draw gives the slot to be tried first, for one triangle after the other
template <class Geometry, class Draw, class Stops>
Walk_end walk(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& q,
              std::size_t most_steps, Draw draw, const Stops& stops) {
  int exit = first_exit(mesh, t, draw(), q);
  for (std::size_t step = 1;; ++step) {
    if (exit < 0) return {t, -1};
    const Side entry = mesh.triangle(t).side[exit];
    if (stops(entry)) return {t, exit};
    t = entry.triangle();
    if (step == most_steps) return {t, -1, true};
    exit = next_exit(mesh, entry, draw(), q);
  }
}

/// Walks across every side but the border.
template <class Geometry>
Walk_end locate_exactly(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& q) {
  return walk(
      mesh, t, q, std::numeric_limits<std::size_t>::max(),
      [lots = Slot_lots()]() mutable { return lots.draw(); }, [](Side s) { return s.is_border(); });
}

/// Returns the triangle at v that the ray from v to p begins in, of those connected to a triangle at v; none if the ray
/// begins outside of them.
template <class Geometry>
Triangle_id triangle_toward(const Kernel_mesh<Geometry>& mesh, Vertex_id v, Triangle_id start,
                            const typename Geometry::Point& p) {
  Fan_walk<Kernel_mesh<Geometry>> fan(mesh, v, start);
  do {
    const auto& r = mesh.triangle(fan.triangle());
    if (Geometry::orientation(mesh.point(v), mesh.point(r.v[next_slot[fan.slot()]]), p) >= 0 &&
        Geometry::orientation(mesh.point(v), mesh.point(r.v[previous_slot[fan.slot()]]), p) <= 0)
      return fan.triangle();
  } while (fan.advance());
  return {};
}

/// Walks from a triangle that has `from`, or is next to it, along the segment to q, where that does not meet the
/// border. Where rounding of `from` leaves no such way, the walk goes on as others do.
template <class Geometry>
Walk_end walk_along(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& from,
                    const typename Geometry::Point& q) {
  for (int entry = -1;;) {
    const auto& r = mesh.triangle(t);
    int exit = -1, other = -1, border = -1;
    for (int k = 0; k < 3; ++k) {
      if (k == entry || !is_behind_side(mesh, r, k, q)) continue;
      const bool is_crossed = Geometry::orientation(from, q, mesh.point(r.v[next_slot[k]])) <= 0 &&
                              Geometry::orientation(from, q, mesh.point(r.v[previous_slot[k]])) >= 0;
      (r.side[k].is_border() ? border : is_crossed ? exit : other) = k;
    }
    if (exit < 0 && other >= 0) return locate_exactly(mesh, r.side[other].triangle(), q);
    if (exit < 0) return {t, border};
    entry = r.side[exit].slot();
    t = r.side[exit].triangle();
  }
}

/// Walks from t toward q in sight of it: stops at constrained sides, and after `most_steps`. Slots 0 and 1 are tried
/// first in turn.
template <class Geometry>
Walk_end walk_in_sight(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& q,
                       std::size_t most_steps) {
  return walk(
      mesh, t, q, most_steps, [slot = 1]() mutable { return slot ^= 1; },
      [](Side s) { return s.is_constrained(); });
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_WALK_H
