// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PHASE_CLOCK_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PHASE_CLOCK_H

#include <chrono>
#include <ctime>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Tells the times of the phases of a report that follow each other: the processors' in `seconds`, those by the clock
/// in `wall_seconds`. Asking for processor time takes longer than a phase of a small input, so it is asked for only
/// where a phase ends.
template <class Report>
class Phase_clock {
public:
  using Phase = double Report::Seconds::*;

  explicit Phase_clock(Report& report) : report_(report) {}
  ~Phase_clock() { enter(nullptr); }
  Phase_clock(const Phase_clock&) = delete;
  Phase_clock& operator=(const Phase_clock&) = delete;

  /// Ends the phase before, unless it is the same.
  void enter(Phase phase) {
    if (phase == phase_) return;
    const Time now{std::clock(), Clock::now()};
    if (phase_ != nullptr) {
      report_.seconds.*phase_ += static_cast<double>(now.processors - begin_.processors) / CLOCKS_PER_SEC;
      report_.wall_seconds.*phase_ += std::chrono::duration<double>(now.wall - begin_.wall).count();
    }
    phase_ = phase;
    begin_ = now;
  }

private:
  using Clock = std::chrono::steady_clock;
  struct Time {
    std::clock_t processors = 0;
    Clock::time_point wall;
  };

  Report& report_;
  Phase phase_ = nullptr;
  Time begin_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PHASE_CLOCK_H
