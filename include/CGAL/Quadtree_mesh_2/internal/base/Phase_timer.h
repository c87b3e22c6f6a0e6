// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PHASE_TIMER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PHASE_TIMER_H

#include <ctime>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Adds the CPU time from its construction to its destruction to a number of seconds.
class Phase_timer {
public:
  explicit Phase_timer(double& seconds) : seconds_(seconds), start_(std::clock()) {}
  ~Phase_timer() { seconds_ += static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }
  Phase_timer(const Phase_timer&) = delete;
  Phase_timer& operator=(const Phase_timer&) = delete;

private:
  double& seconds_;
  std::clock_t start_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PHASE_TIMER_H
