// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_SCHEDULE_OF_THREADS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_SCHEDULE_OF_THREADS_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_options.h>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Returns the schedule for constructions whose rounds count: that of O(log n) rounds, or on one thread that of the
/// least work. Both give the same tree.
template <class ConcurrencyTag>
Balance_schedule schedule_of_threads() {
  return is_sequential<ConcurrencyTag>() ? Balance_schedule::LEVEL_BY_LEVEL : Balance_schedule::SPACED_LEVELS;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_SCHEDULE_OF_THREADS_H
