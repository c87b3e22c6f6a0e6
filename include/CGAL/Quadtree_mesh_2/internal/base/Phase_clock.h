// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PHASE_CLOCK_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PHASE_CLOCK_H

#include <algorithm>
#include <chrono>
#include <ctime>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Is told when a phase ends. Specialized for tags that count.
template <class ConcurrencyTag>
struct Phase_watch {
  template <class Phase>
  static void end(Phase) {}
};

/// Tells the times of the phases of a report that follow each other: the processors' in `seconds`, those by the clock
/// in `wall_seconds`. Asking for processor time takes longer than a phase of a small input, so it is asked for only
/// where a phase ends, and not again within 20 microseconds: until then time by the clock is taken for it.
template <class Report, class ConcurrencyTag = void>
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
    const Time now = this->now();
    if (phase_ != nullptr) {
      Phase_watch<ConcurrencyTag>::end(phase_);
      // what was taken for processor time may have been too much
      report_.seconds.*phase_ += std::max(0.0, now.processors - begin_.processors);
      report_.wall_seconds.*phase_ += Seconds(now.wall - begin_.wall).count();
    }
    phase_ = phase;
    begin_ = now;
  }

private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;
  struct Time {
    double processors = 0; // seconds
    Clock::time_point wall;
  };

  Report& report_;
  Phase phase_ = nullptr;
  Time begin_;
  Time asked_; // when processor time was asked for last

  Time now() {
    constexpr double seconds_between_questions = 20e-6;
    const Clock::time_point wall = Clock::now();
    const double since = Seconds(wall - asked_.wall).count();
    if (phase_ != nullptr && since < seconds_between_questions) return {asked_.processors + since, wall};
    asked_ = {static_cast<double>(std::clock()) / CLOCKS_PER_SEC, wall};
    return asked_;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_PHASE_CLOCK_H
