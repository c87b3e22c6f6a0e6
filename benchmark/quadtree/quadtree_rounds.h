// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Steps, work and critical path of our trees: how far they could scale on more cores than there are.

#ifndef QUADTREE_MESH_2_BENCHMARK_QUADTREE_ROUNDS_H
#define QUADTREE_MESH_2_BENCHMARK_QUADTREE_ROUNDS_H

#include "resources.h"

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>

/// Runs parallel algorithms on one thread, and counts what they would do on many.
struct Counted_tag : CGAL::Sequential_tag {};

/// What an algorithm needs with as many cores as it has tasks.
struct Rounds {
  std::size_t steps = 0; ///< calls of `Executor::run()` that have to follow each other
  double work = 0;       ///< seconds of all tasks and of the serial parts
  double path = 0;       ///< seconds of the serial parts and of the longest task of each step
  double serial = 0;     ///< seconds of the serial parts that are in no task

  /// How many cores there is work for.
  double parallelism() const { return work / path; }
  /// How many times as fast as one core `cores` of them are at least, by Brent's theorem.
  double speedup(double cores) const { return work / ((work - path) / cores + path); }
};

/// Takes time between the points where tasks begin and end.
class Round_counter {
public:
  /// The counter of this process, which has one thread.
  static Round_counter& instance() {
    static Round_counter counter;
    return counter;
  }

  /// Calls `f` and returns what it needs.
  template <class F>
  Rounds count(const F& f) {
    rounds_ = Rounds();
    lap_ = now();
    f();
    add_serial_part();
    return rounds_;
  }

  /// What was needed since counting began. To be asked between steps, not within one.
  const Rounds& so_far() {
    add_serial_part();
    return rounds_;
  }

  /// One parallel step. What it costs is that of the longest task; a task's own steps are part of it.
  template <class F>
  void step(std::size_t tasks, const F& f) {
    add_serial_part();
    const Rounds before = rounds_;
    Rounds longest;
    double work = 0;
    for (std::size_t i = 0; i < tasks; ++i) {
      rounds_ = Rounds();
      f(i);
      add_serial_part();
      longest.steps = std::max(longest.steps, rounds_.steps);
      longest.path = std::max(longest.path, rounds_.path);
      work += rounds_.work;
    }
    rounds_.steps = before.steps + 1 + longest.steps;
    rounds_.path = before.path + longest.path;
    rounds_.work = before.work + work;
    rounds_.serial = before.serial;
  }

private:
  /// By the processor's clock, which does not count what other processes do in between; a look at it takes a
  /// fraction of a microsecond.
  static double now() { return cpu_seconds(); }

  /// The time since the last look at the clock is part of what is counted now.
  void add_serial_part() {
    const double time = now(), seconds = time - lap_;
    lap_ = time;
    rounds_.path += seconds;
    rounds_.serial += seconds;
    rounds_.work += seconds;
  }

  Rounds rounds_;
  double lap_ = 0;
};

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <>
struct Executor<Counted_tag> {
  template <class F>
  static void run(std::size_t n, const F& f) {
    Round_counter::instance().step(n, f);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // QUADTREE_MESH_2_BENCHMARK_QUADTREE_ROUNDS_H
