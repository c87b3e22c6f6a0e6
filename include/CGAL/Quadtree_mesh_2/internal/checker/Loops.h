// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_LOOPS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_LOOPS_H

#include <CGAL/tags.h>

// Debian's TBB is not compiled for the thread sanitizer, which takes what it does for races.
#if defined(CGAL_LINKED_WITH_TBB) && !defined(__SANITIZE_THREAD__)
#define CGAL_QUADTREE_MESH_2_CHECKER_USES_TBB
#ifdef __has_feature
#if __has_feature(thread_sanitizer)
#undef CGAL_QUADTREE_MESH_2_CHECKER_USES_TBB
#endif
#endif
#endif

#ifdef CGAL_QUADTREE_MESH_2_CHECKER_USES_TBB
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The loops of the checker, on one thread or on TBB's. What they find is the same: ranges are cut by their length
/// alone, and what is found in them is taken in their order.
///
/// These are not the loops of the meshers, with which a checker shares no code. They run in contexts of their own: an
/// exception in another task of the caller must not end them, as their results are read.
class Loops {
public:
  explicit Loops(Sequential_tag) {}
  /// Those of TBB if the program links it, else one thread.
  explicit Loops(Parallel_tag) : is_parallel_(true) {}

  /// Does two things, maybe at once.
  template <class First, class Second>
  void do_both(const First& first, const Second& second) const {
#ifdef CGAL_QUADTREE_MESH_2_CHECKER_USES_TBB
    if (is_parallel_) {
      tbb::task_group_context context(tbb::task_group_context::isolated);
      return tbb::parallel_invoke(first, second, context);
    }
#endif
    first();
    second();
  }

  /// Calls `look(begin, end, result)` for consecutive ranges of `[0, n)`, maybe for several at once. After that, calls
  /// `take(result)` for each in their order.
  template <class Result, class Look, class Take>
  void for_ranges(std::size_t n, const Look& look, const Take& take) const {
    std::vector<Result> results((n + length_ - 1) / length_);
    const auto look_at = [&](std::size_t i) {
      look(i * length_, std::min(n, (i + 1) * length_), results[i]);
    };
#ifdef CGAL_QUADTREE_MESH_2_CHECKER_USES_TBB
    if (is_parallel_) {
      tbb::task_group_context context(tbb::task_group_context::isolated);
      tbb::parallel_for(std::size_t(0), results.size(), look_at, context);
    } else
#endif
      for (std::size_t i = 0; i < results.size(); ++i) look_at(i);
    for (Result& result : results) take(result);
  }

  /// Calls `is_right(i)` for each i below n, maybe for several at once, and then `report(i)` for those that are not.
  template <class Is_right, class Report>
  void for_each_wrong(std::size_t n, const Is_right& is_right, const Report& report) const {
    using Wrong = std::vector<std::uint32_t>;
    for_ranges<Wrong>(
        n,
        [&](std::size_t begin, std::size_t end, Wrong& wrong) {
          for (std::size_t i = begin; i < end; ++i)
            if (!is_right(static_cast<std::uint32_t>(i))) wrong.push_back(static_cast<std::uint32_t>(i));
        },
        [&](const Wrong& wrong) {
          for (const std::uint32_t i : wrong) report(i);
        });
  }

private:
  static constexpr std::size_t length_ = 1u << 15; // of a range

  [[maybe_unused]] bool is_parallel_ = false;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_LOOPS_H
