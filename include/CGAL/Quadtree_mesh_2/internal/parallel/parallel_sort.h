// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Sorting by comparisons, and removing equal neighbors from sorted ranges.
//
// Computes: `sort(first, last, less)`, stable; `unique(values)`, which removes equal neighbors.
// Bound:    O(n log n) comparisons; O(log n) rounds of tasks of bounded length.
// Method:   Merge sort. Blocks are sorted one by one, and neighbors are then merged in rounds. Each merge is
//           cut into tasks of equal output length. Two binary searches find the inputs of a task (merge
//           path). So the last round is as parallel as the first. The order of a stable sort is unique, so
//           results are the same bits for any number of threads.
// Source:   S. Odeh, O. Green, Z. Mwassi, O. Shmueli, Y. Birk, "Merge Path - Parallel Merging Made Simple".
//           The paper of the quadtrees asks for a sort of O(log n) time on O(n) processors (section 2,
//           Cole's).
// Deviates: Cole's sort pipelines its merges. Here there are O(log n) rounds, each with a search of O(log n)
//           steps. This is O(log^2 n) time with as many processors as points, and O(n log n) work.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_PARALLEL_SORT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_PARALLEL_SORT_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The length of blocks that are sorted sequentially, and of the output of tasks that merge.
constexpr std::size_t sort_block = 4096;

/// Returns how many of the first `n` values of the stable merge of `a` and `b` come from `a`. Where values are
/// equivalent, those of `a` come first.
template <class A, class B, class Less>
std::size_t merge_path(A a, std::size_t size_a, B b, std::size_t size_b, std::size_t n, const Less& less) {
  // The answer is the least i for which a[i] does not precede b[n - i - 1].
  std::size_t low = n > size_b ? n - size_b : 0;
  std::size_t high = std::min(n, size_a);
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (less(b[static_cast<typename std::iterator_traits<B>::difference_type>(n - middle - 1)],
             a[static_cast<typename std::iterator_traits<A>::difference_type>(middle)]))
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

/// Members moved out of a range, which lie there until they are moved back or to the next buffer.
template <class T>
class Sort_buffer {
  // Then a buffer is filled by parallel tasks either whole or, for want of memory, not at all.
  static_assert(std::is_nothrow_move_constructible<T>::value, "values to be sorted move without exceptions");

public:
  template <class ConcurrencyTag, class RandomIt>
  Sort_buffer(ConcurrencyTag, RandomIt first, std::size_t n)
      : values_(std::allocator<T>().allocate(n)), n_(n) {
    for_each_block<ConcurrencyTag>(n, sort_block, [&](std::size_t, std::size_t begin, std::size_t end) {
      using Difference = typename std::iterator_traits<RandomIt>::difference_type;
      std::uninitialized_move(first + static_cast<Difference>(begin), first + static_cast<Difference>(end),
                              values_ + begin);
    });
  }
  Sort_buffer(const Sort_buffer&) = delete;
  Sort_buffer& operator=(const Sort_buffer&) = delete;
  ~Sort_buffer() {
    std::destroy(values_, values_ + n_);
    std::allocator<T>().deallocate(values_, n_);
  }

  T* data() { return values_; }

private:
  T* values_;
  std::size_t n_;
};

/// Merges neighboring sorted runs of length `width` of the `n` values from `from` on into runs of twice the
/// length from `to` on.
template <class ConcurrencyTag, class From, class To, class Less>
void merge_runs(From from, To to, std::size_t n, std::size_t width, const Less& less) {
  using From_difference = typename std::iterator_traits<From>::difference_type;
  using To_difference = typename std::iterator_traits<To>::difference_type;
  const auto at = [from](std::size_t i) { return from + static_cast<From_difference>(i); };
  // No block lies in two merges, because `width` is a multiple of the length of blocks.
  const auto begin_of_merge = [width](std::size_t i) { return i / (2 * width) * (2 * width); };
  const auto begin_of_second = [n, width](std::size_t merge) { return std::min(n, merge + width); };
  const auto end_of_merge = [n, width](std::size_t merge) { return std::min(n, merge + 2 * width); };

  // All searches come before all moves, lest a search meets a value that has been moved.
  std::vector<std::size_t> from_first((n + sort_block - 1) / sort_block); // of the values before a block
  for_each_block<ConcurrencyTag>(n, sort_block, [&](std::size_t block, std::size_t begin, std::size_t) {
    const std::size_t merge = begin_of_merge(begin), second = begin_of_second(merge);
    from_first[block] =
        merge_path(at(merge), second - merge, at(second), end_of_merge(merge) - second, begin - merge, less);
  });
  for_each_block<ConcurrencyTag>(n, sort_block, [&](std::size_t block, std::size_t begin, std::size_t end) {
    const std::size_t merge = begin_of_merge(begin), second = begin_of_second(merge);
    const std::size_t before = from_first[block];
    const std::size_t after = end == end_of_merge(merge) ? second - merge : from_first[block + 1];
    const auto moved = [&](std::size_t i) { return std::make_move_iterator(at(i)); };
    std::merge(moved(merge + before), moved(merge + after), moved(second + (begin - merge - before)),
               moved(second + (end - merge - after)), to + static_cast<To_difference>(begin),
               [&less](const auto& p, const auto& q) { return less(p, q); });
  });
}

/// Sorts `[first, last)`; equivalent values keep their order. If `less` throws, the range holds unspecified
/// values.
/// \tparam Less is called by several threads at once.
template <class ConcurrencyTag, class RandomIt, class Less>
void sort(RandomIt first, RandomIt last, Less less) {
  using T = typename std::iterator_traits<RandomIt>::value_type;
  using Difference = typename std::iterator_traits<RandomIt>::difference_type;
  const std::size_t n = static_cast<std::size_t>(last - first);
  if (n <= sort_block || is_sequential<ConcurrencyTag>()) {
    std::stable_sort(first, last, less); // the same result
    return;
  }
  for_each_block<ConcurrencyTag>(n, sort_block, [&](std::size_t, std::size_t begin, std::size_t end) {
    std::stable_sort(first + static_cast<Difference>(begin), first + static_cast<Difference>(end), less);
  });
  Sort_buffer<T> buffer(ConcurrencyTag(), first, n);
  bool is_in_buffer = true;
  for (std::size_t width = sort_block; width < n; width *= 2) {
    if (is_in_buffer)
      merge_runs<ConcurrencyTag>(buffer.data(), first, n, width, less);
    else
      merge_runs<ConcurrencyTag>(first, buffer.data(), n, width, less);
    is_in_buffer = !is_in_buffer;
  }
  if (!is_in_buffer) return;
  for_each_block<ConcurrencyTag>(n, sort_block, [&](std::size_t, std::size_t begin, std::size_t end) {
    std::move(buffer.data() + begin, buffer.data() + end, first + static_cast<Difference>(begin));
  });
}

/// Removes all but the first of consecutive equal values.
/// \tparam T can be default constructed.
template <class ConcurrencyTag, class T>
void unique(std::vector<T>& values) {
  const std::size_t n = values.size();
  if (n <= default_block || is_sequential<ConcurrencyTag>()) {
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return;
  }
  // Copied, not moved: the next block may still compare its first value with the last one of a block.
  values = pack_values<ConcurrencyTag, T>(
      n, [&](std::size_t i) { return i == 0 || !(values[i] == values[i - 1]); },
      [&](std::size_t i) -> const T& { return values[i]; });
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_PARALLEL_SORT_H
