// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Cuts items in shuffle order into runs of bounded length, by the squares in which they lie.
//
// Computes: the leaves of the quadtree whose squares are split while they hold more than so many items. Runs that meet
//           where two squares of one parent do are put together if they are not too long then. So two neighbors among
//           all runs have more than that many items between them.
// Bound:    at most 2 n / most + 1 runs, in O(log n) for each square that is split.
// Source:   ours.
//
// A cut depends on the items in the squares about it alone. What is added or moved elsewhere leaves it where it is.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GRID_CUT_BY_SQUARES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GRID_CUT_BY_SQUARES_H

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Level>
class Square_cutter {
public:
  Square_cutter(std::size_t most, const Level& level) : most_(most), level_(level) {}

  /// Appends the runs of [begin, end), a square.
  void cut(std::size_t begin, std::size_t end) {
    const int level = end - begin <= most_ ? 0 : level_(begin, end - 1);
    if (level == 0) return cut_evenly(begin, end);
    const std::size_t first_run = first_.size();
    for (std::size_t child = begin; child < end;) {
      const std::size_t end_of_child = end_of_square(child, end, level), run = first_.size();
      cut(child, end_of_child);
      if (run > first_run) put_together(run, end_of_child);
      child = end_of_child;
    }
  }

  /// Where runs begin.
  std::vector<std::size_t> take() { return std::move(first_); }

private:
  std::size_t most_;
  const Level& level_;
  std::vector<std::size_t> first_;

  /// What no square tells apart, or need not be told apart.
  void cut_evenly(std::size_t begin, std::size_t end) {
    const std::size_t n = end - begin, runs = n / most_ + (n % most_ == 0 ? 0 : 1);
    for (std::size_t r = 0; r < runs; ++r) first_.push_back(begin + n * r / runs);
  }

  /// Where the child of a square ends in which an item lies.
  std::size_t end_of_square(std::size_t item, std::size_t end, int level_of_parent) const {
    std::size_t inside = item;
    while (end - inside > 1) {
      const std::size_t middle = inside + (end - inside) / 2;
      (level_(item, middle) < level_of_parent ? inside : end) = middle;
    }
    return end;
  }

  /// Makes one run of the given one and that before it, unless it is too long.
  void put_together(std::size_t run, std::size_t end_of_runs) {
    const std::size_t end = run + 1 < first_.size() ? first_[run + 1] : end_of_runs;
    if (end - first_[run - 1] <= most_) first_.erase(first_.begin() + static_cast<std::ptrdiff_t>(run));
  }
};

/// Cuts n items into runs of at most `most`.
/// \param level tells, as `level(i, k)`, how large the smallest square is that holds the items i < k: by a number that
///        grows with the square, and is 0 if items are not told apart
/// \returns where the runs begin, and `n`
template <class Level>
std::vector<std::size_t> cut_by_squares(std::size_t n, std::size_t most, const Level& level) {
  Square_cutter<Level> cutter(most, level);
  if (n > 0) cutter.cut(0, n);
  std::vector<std::size_t> first = cutter.take();
  first.push_back(n);
  return first;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GRID_CUT_BY_SQUARES_H
