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

/// Whether the query is strictly behind side k of a triangle; exact.
template <class Geometry>
bool is_behind_side(const Kernel_mesh<Geometry>& mesh, const typename Kernel_mesh<Geometry>::Triangle& r,
                    int k, const typename Geometry::Point& q) {
  return Geometry::orientation(mesh.point(r.v[next_slot[k]]), mesh.point(r.v[previous_slot[k]]), q) < 0;
}

/// The side by which a walk leaves the triangle it begins in; -1 if that holds the query.
template <class Geometry>
int first_exit(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& q) {
  for (int k = 0; k < 3; ++k)
    if (is_behind_side(mesh, mesh.triangle(t), k, q)) return k;
  return -1;
}

/// The same for a triangle that a walk has come into by side `entry`. Both other sides are looked at, and the choice is
/// no branch, for it would be taken at random.
template <class Geometry>
int next_exit(const Kernel_mesh<Geometry>& mesh, Side entry, bool is_odd_step,
              const typename Geometry::Point& q) {
  constexpr signed char first_by_entry[2][3] = {{1, 0, 0}, {1, 2, 1}};
  const int first = first_by_entry[is_odd_step ? 1 : 0][entry.slot()], second = 3 - first - entry.slot();
  const auto& r = mesh.triangle(entry.triangle());
  const int is_first = is_behind_side(mesh, r, first, q) ? 1 : 0;
  const int is_second = is_behind_side(mesh, r, second, q) ? 1 : 0;
  return (is_first | is_second) == 0 ? -1 : second + is_first * (first - second);
}

/// Walks across the sides that do not stop it, each step decided exactly, and no more than the given number of them.
template <class Geometry, class Stops>
Walk_end walk(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& q,
              std::size_t most_steps, const Stops& stops) {
  int exit = first_exit(mesh, t, q);
  for (std::size_t step = 1;; ++step) {
    if (exit < 0) return {t, -1};
    const Side entry = mesh.triangle(t).side[exit];
    if (stops(entry)) return {t, exit};
    t = entry.triangle();
    if (step == most_steps) return {t, -1, true};
    exit = next_exit(mesh, entry, step % 2 != 0, q);
  }
}

/// Walks across every side but the border.
template <class Geometry>
Walk_end locate_exactly(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& q) {
  return walk(mesh, t, q, std::numeric_limits<std::size_t>::max(), [](Side s) { return s.is_border(); });
}

/// Walks from t toward q in sight of it: stops at constrained sides, and after `most_steps`.
template <class Geometry>
Walk_end walk_in_sight(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const typename Geometry::Point& q,
                       std::size_t most_steps) {
  return walk(mesh, t, q, most_steps, [](Side s) { return s.is_constrained(); });
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_WALK_H
