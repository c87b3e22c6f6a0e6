// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Puts values into runs, one run after the other, where the run of a value is a number.
//
// Computes: the place of each value. Threads count the values of each run, then place them as they come. So the order
//           within a run is that of chance: who wants the same bits from any number of threads sorts each run.
// Bound:    O(n) work for n values and runs, in parallel.
// Method:   counting sort by atomic counters. One thread alone does not lock them: that would take as long as all the
//           rest.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_RUN_COUNTERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_RUN_COUNTERS_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Run_counters {
public:
  explicit Run_counters(std::size_t runs) : numbers_(runs), is_alone_(is_sequential<Chosen_tag>()) {}

  std::size_t size() const { return numbers_.size(); }

  /// Counts a value of the run.
  void count(std::size_t run) { add_one(numbers_[run]); }

  /// To be called once all values are counted.
  /// \returns their number
  std::size_t begin_placing() {
    return count_allocate_and_place<Chosen_tag>(
        size(),
        [this](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for (std::size_t run = begin; run < end; ++run) sum += number(run);
          return sum;
        },
        [](std::size_t) {},
        [this](std::size_t begin, std::size_t end, std::size_t first) {
          for (std::size_t run = begin; run < end; ++run) {
            const std::size_t here = number(run);
            numbers_[run].store(static_cast<std::uint32_t>(first), std::memory_order_relaxed);
            first += here;
          }
        });
  }

  /// The place of another value of the run.
  std::size_t place(std::size_t run) { return add_one(numbers_[run]); }

  /// The places of the run. \pre all values are placed
  std::size_t begin(std::size_t run) const { return run == 0 ? 0 : number(run - 1); }
  std::size_t end(std::size_t run) const { return number(run); }

private:
  std::vector<std::atomic<std::uint32_t>> numbers_; // of values; once these are placed, where their runs end
  bool is_alone_;

  std::size_t number(std::size_t run) const { return numbers_[run].load(std::memory_order_relaxed); }

  /// \returns the number as it was
  std::uint32_t add_one(std::atomic<std::uint32_t>& number) const {
    if (!is_alone_) return number.fetch_add(1, std::memory_order_relaxed);
    const std::uint32_t before = number.load(std::memory_order_relaxed);
    number.store(before + 1, std::memory_order_relaxed);
    return before;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_RUN_COUNTERS_H
