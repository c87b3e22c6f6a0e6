// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PHASE_TIMER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PHASE_TIMER_H

#include <chrono>
#include <ctime>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Adds the time from its construction to its destruction to a phase of a report: the processors' to `seconds`, that by
/// the clock to `wall_seconds`.
template <class Report>
class Phase_timer {
public:
  Phase_timer(Report& report, double Report::Seconds::*phase) : report_(report), phase_(phase) {}
  ~Phase_timer() {
    report_.seconds.*phase_ += static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
    report_.wall_seconds.*phase_ += std::chrono::duration<double>(Clock::now() - wall_start_).count();
  }
  Phase_timer(const Phase_timer&) = delete;
  Phase_timer& operator=(const Phase_timer&) = delete;

private:
  using Clock = std::chrono::steady_clock;

  Report& report_;
  double Report::Seconds::*phase_;
  std::clock_t start_ = std::clock();
  Clock::time_point wall_start_ = Clock::now();
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PHASE_TIMER_H
