// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The shuffle order (Morton order, z-order) of grid points. Every square of a quadtree holds an interval of
// it.
//
// Computes: `less_shuffle(p, q)` in O(1) without making the shuffle; keys with interleaved bits;
//           `shuffle_order(points)`, the permutation that sorts points. It is stable: equal points keep their
//           order.
// Bound:    For words of 32 or 64 bits O(n) work, in a constant number of rounds, and that again for each
//           long run of points that agree in some digits. For other words O(n log n) comparisons
//           (parallel_sort.h).
// Source:   Bern, Eppstein, Teng, "Parallel Construction of Quadtrees and Quality Triangulations", section 2
//           (the shuffle Sh(x, y), x before y, represented implicitly); T. M. Chan, "Closest-point problems
//           simplified on the RAM", for the comparison by exclusive or.
// Deviates: the paper sorts by comparisons only. Here words of 32 or 64 bits are shuffled explicitly and
//           sorted by digits (sort_by_keys.h). A comparison takes O(1) operations on words. So words longer
//           than the machine's take time in proportion to their length.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GRID_MORTON_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GRID_MORTON_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel_sort.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Returns whether the highest bit of `a` is lower than that of `b`, without finding either.
template <class Word>
constexpr bool less_highest_bit(const Word& a, const Word& b) {
  return a < b && a < (a ^ b);
}

/// Returns whether `p` precedes `q` in shuffle order. At each bit, x counts before y.
template <class Word>
constexpr bool less_shuffle(const Grid_point_2<Word>& p, const Grid_point_2<Word>& q) {
  if constexpr (std::is_integral<Word>::value) {
    return less_highest_bit<Word>(p.x ^ q.x, p.y ^ q.y) ? p.y < q.y : p.x < q.x;
  } else { // the widths of differences are found without making the differences
    using Operations = Word_operations<Word>;
    return Operations::width_of_difference(p.x, q.x) < Operations::width_of_difference(p.y, q.y) ? p.y < q.y
                                                                                                 : p.x < q.x;
  }
}

/// Function object form of `less_shuffle()`.
struct Less_shuffle {
  template <class Word>
  constexpr bool operator()(const Grid_point_2<Word>& p, const Grid_point_2<Word>& q) const {
    return less_shuffle(p, q);
  }
};

/// Returns the bits of `v`, each moved from position i to position 2 i.
constexpr std::uint64_t spread_bits(std::uint32_t v) {
  std::uint64_t x = v;
  x = (x | (x << 16)) & 0x0000ffff0000ffffu;
  x = (x | (x << 8)) & 0x00ff00ff00ff00ffu;
  x = (x | (x << 4)) & 0x0f0f0f0f0f0f0f0fu;
  x = (x | (x << 2)) & 0x3333333333333333u;
  x = (x | (x << 1)) & 0x5555555555555555u;
  return x;
}

/// Returns the shuffle of two 32-bit numbers, bits of `x` before bits of `y`.
constexpr std::uint64_t interleave(std::uint32_t x, std::uint32_t y) {
  return (spread_bits(x) << 1) | spread_bits(y);
}

/// The shuffle of a grid point as words of 64 bits, the most significant word first. There are none for words
/// of other lengths, which are compared.
template <>
struct Radix_key<Grid_point_2<std::uint32_t>> {
  using Key = Grid_point_2<std::uint32_t>;
  static constexpr int number_of_words = 1;
  static constexpr std::uint64_t word(const Key& p, int) { return interleave(p.x, p.y); }
  static constexpr void add_differences(const Key& p, const Key& q, Key& differences) {
    differences.x |= p.x ^ q.x;
    differences.y |= p.y ^ q.y;
  }
};

template <>
struct Radix_key<Grid_point_2<std::uint64_t>> {
  using Key = Grid_point_2<std::uint64_t>;
  static constexpr int number_of_words = 2;
  static constexpr std::uint64_t word(const Key& p, int i) {
    const int shift = i == 0 ? 32 : 0;
    return interleave(static_cast<std::uint32_t>(p.x >> shift), static_cast<std::uint32_t>(p.y >> shift));
  }
  static constexpr void add_differences(const Key& p, const Key& q, Key& differences) {
    differences.x |= p.x ^ q.x;
    differences.y |= p.y ^ q.y;
  }
};

/// Returns `n` grid points in shuffle order, with their order; equal points keep theirs.
/// \tparam Point_at called as `point_at(i)`, several times for each and by several threads at once, returns a
///         grid point with unsigned words of any length, of which all bits count. `std::uint32_t` and
///         `std::uint64_t` take O(n) time; others are compared.
/// \pre `n < 2^32`
template <class ConcurrencyTag = Sequential_tag, class Point_at>
auto shuffled(std::size_t n, const Point_at& point_at) {
  using Point = std::decay_t<decltype(point_at(n))>;
  if constexpr (Radix_key<Point>::number_of_words > 0) {
    return sort_by_keys<ConcurrencyTag>(n, point_at);
  } else {
    Uninitialized_vector<Point> points(n);
    Sorted_keys<Point> sorted;
    sorted.keys.resize(n);
    sorted.order.resize(n);
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      points[i] = point_at(i);
      sorted.order[i] = static_cast<std::uint32_t>(i);
    });
    sort<ConcurrencyTag>(
        sorted.order.begin(), sorted.order.end(),
        [&points](std::uint32_t i, std::uint32_t j) { return less_shuffle(points[i], points[j]); });
    for_each_index<ConcurrencyTag>(
        n, [&](std::size_t k) { sorted.keys[k] = std::move(points[sorted.order[k]]); });
    return sorted;
  }
}

/// Returns the indices of `points` sorted by the shuffle of the points; equal points keep their order. For points of
/// which most are distinct; `shuffled()` is for those that are not, and for who needs the points in order.
template <class ConcurrencyTag = Sequential_tag, class Word, class Allocator>
Order shuffle_order(const std::vector<Grid_point_2<Word>, Allocator>& points) {
  const auto point_at = [&points](std::size_t i) { return points[i]; };
  if constexpr (Radix_key<Grid_point_2<Word>>::number_of_words > 0)
    return radix_order<ConcurrencyTag>(points.size(), point_at);
  else
    return std::move(shuffled<ConcurrencyTag>(points.size(), point_at).order);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GRID_MORTON_H
