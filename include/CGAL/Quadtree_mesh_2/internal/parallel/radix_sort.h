// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Sorting of 64-bit words by their digits.
//
// Computes: the words in order.
// Bound:    O(n) work. A constant number of rounds of tasks of bounded length, and that again for each long run
//           of words that agree in a digit. Random words move two or three times.
// Method:   A long range is split by the highest digit that varies. Blocks count their digits. The counts are
//           summed up in the order of digits and then of blocks. Blocks then scatter their members. Runs that
//           agree in the digit are short as a rule. They are sorted independently of each other, in cache, by
//           a window of about log2(n) + 2 bits, least significant digit first. Runs that agree in their
//           window are treated likewise. Runs that are still long are split one after another.
//           Equal words cannot be told apart. So results are the same bits for any number of threads.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_RADIX_SORT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_RADIX_SORT_H

#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What is longer is split by parallel tasks, what is not is sorted by one.
constexpr std::size_t longest_short_range = std::size_t(1) << 16;

/// Memory for `n` words, without the time to clear it.
inline std::unique_ptr<std::uint64_t[]> uncleared_words(std::size_t n) {
  return std::unique_ptr<std::uint64_t[]>(new std::uint64_t[n]);
}

/// Counts digits by block, and tells where each block puts its members so that they come into the order of digits,
/// stably.
template <class ConcurrencyTag>
class Digit_counts {
public:
  Digit_counts(std::size_t n, std::size_t block, std::size_t digits)
      : n_(n), block_(block), digits_(digits), blocks_((n + block - 1) / block),
        counts_(new std::uint32_t[blocks_ * digits]) {}

  /// \tparam Digit_at returns the digit of a member.
  template <class Digit_at>
  void count(const Digit_at& digit_at) {
    for_each_block<ConcurrencyTag>(n_, block_, [&](std::size_t block, std::size_t begin, std::size_t end) {
      std::uint32_t* const count = places(block);
      std::fill(count, count + digits_, 0u);
      for (std::size_t i = begin; i < end; ++i) ++count[digit_at(i)];
    });
  }

  /// Makes places of counts. Returns the places where the runs of equal digits begin, and `n`.
  std::vector<std::size_t> place_runs() {
    std::vector<std::size_t> begin_of_run(digits_ + 1);
    for_each_block<ConcurrencyTag>(digits_, 128, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t block = 0; block < blocks_; ++block)
        for (std::size_t d = begin; d < end; ++d) {
          std::uint32_t& count = places(block)[d];
          const std::uint32_t before = static_cast<std::uint32_t>(begin_of_run[d]);
          begin_of_run[d] += count;
          count = before;
        }
    });
    scan_exclusively(begin_of_run.data(), digits_ + 1, std::size_t(0));
    for_each_block<ConcurrencyTag>(blocks_, 16, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t block = begin; block < end; ++block)
        for (std::size_t d = 0; d < digits_; ++d)
          places(block)[d] += static_cast<std::uint32_t>(begin_of_run[d]);
    });
    return begin_of_run;
  }

  /// By digit, where the next member of a block goes.
  std::uint32_t* places(std::size_t block) { return counts_.get() + block * digits_; }

private:
  std::size_t n_;
  std::size_t block_;
  std::size_t digits_;
  std::size_t blocks_;
  std::unique_ptr<std::uint32_t[]> counts_;
};

/// Sorts words: see `sort_words()`.
template <class ConcurrencyTag>
class Word_sorter {
public:
  static void sort(std::uint64_t* from, std::uint64_t* to, std::size_t n, bool in_place) {
    if (n <= longest_short_range)
      sort_short(from, to, n, in_place);
    else
      sort_long(from, to, n, in_place);
  }

private:
  using Word = std::uint64_t;

  /// With so few bits the counts of a digit fit into the first level of cache, and the lines that a pass writes
  /// to into the second.
  static constexpr int max_digit_ = 11;
  static constexpr std::size_t digits_ = std::size_t(1) << max_digit_;
  static constexpr std::size_t small_ = 48;

  /// Returns the number of bits up to the highest one in which words differ.
  static int width_of_differences(const Word* words, std::size_t n) {
    Word varying = 0;
    for (std::size_t i = 1; i < n; ++i) varying |= words[i] ^ words[0];
    return bit_width(varying);
  }

  static void put(Word* from, Word* to, std::size_t n, bool in_place) {
    if (!in_place) std::copy(from, from + n, to);
  }

  static void sort_short(Word* from, Word* to, std::size_t n, bool in_place) {
    if (n <= small_) {
      sort_by_insertion(from, n);
      put(from, to, n, in_place);
      return;
    }
    const int width = width_of_differences(from, n);
    const int window = std::min(width, bit_width(n) + 2);
    const int shift = width - window;
    Word* const sorted = sort_window(from, to, n, shift, window);
    Word* const wanted = in_place ? from : to;
    if (sorted != wanted) std::copy(sorted, sorted + n, wanted);
    if (shift > 0) sort_runs(wanted, in_place ? to : from, n, shift);
  }

  static void sort_by_insertion(Word* words, std::size_t n) {
    for (std::size_t i = 1; i < n; ++i) {
      const Word word = words[i];
      std::size_t j = i;
      for (; j > 0 && word < words[j - 1]; --j) words[j] = words[j - 1];
      words[j] = word;
    }
  }

  /// Sorts by the `window` bits from bit `shift` on, least significant digit first. Returns where the result
  /// is.
  static Word* sort_window(Word* from, Word* to, std::size_t n, int shift, int window) {
    const int passes = (window + max_digit_ - 1) / max_digit_;
    for (int p = 0; p < passes; ++p) {
      const int begin = window * p / passes, end = window * (p + 1) / passes;
      if (sort_digit(from, to, n, shift + begin, end - begin)) std::swap(from, to);
    }
    return from;
  }

  /// Moves words into the order of one digit, unless it is the same in all of them. Returns whether they moved.
  static bool sort_digit(const Word* from, Word* to, std::size_t n, int shift, int width) {
    std::array<std::uint32_t, digits_> place; // only a digit's part of it is touched
    const std::size_t size = std::size_t(1) << width;
    const Word mask = size - 1;
    std::fill(place.begin(), place.begin() + static_cast<std::ptrdiff_t>(size), 0u);
    for (std::size_t i = 0; i < n; ++i) ++place[(from[i] >> shift) & mask];
    if (place[(from[0] >> shift) & mask] == n) return false;
    scan_exclusively(place.data(), size, std::uint32_t(0));
    for (std::size_t i = 0; i < n; ++i) to[place[(from[i] >> shift) & mask]++] = from[i];
    return true;
  }

  /// Sorts the runs of words that agree in the bits from `shift` on. Only runs with a descent need it; most
  /// words are passed without a branch that could go either way.
  static void sort_runs(Word* words, Word* buffer, std::size_t n, int shift) {
    for (std::size_t i = 1; i < n; ++i) {
      if (words[i - 1] <= words[i]) continue;
      const Word run = words[i] >> shift;
      std::size_t begin = i - 1, end = i + 1;
      while (begin > 0 && words[begin - 1] >> shift == run) --begin;
      while (end < n && words[end] >> shift == run) ++end;
      sort_short(words + begin, buffer + begin, end - begin, true);
      i = end;
    }
  }

  static constexpr std::size_t block_ = std::size_t(1) << 15;

  static void sort_long(Word* from, Word* to, std::size_t n, bool in_place) {
    const int width = bit_width(reduce<ConcurrencyTag>(
        n, Word(0),
        [&](std::size_t begin, std::size_t end) {
          Word varying = 0;
          for (std::size_t i = begin; i < end; ++i) varying |= from[i] ^ from[0];
          return varying;
        },
        [](Word a, Word b) { return a | b; }));
    // Runs should have some hundred words. Fewer digits would not fill tasks, more would not fill cache lines.
    const int digit = std::min({width, max_digit_, bit_width(n) - 8});
    if (width == 0) {
      for_each_block<ConcurrencyTag>(n, block_, [&](std::size_t, std::size_t begin, std::size_t end) {
        put(from + begin, to + begin, end - begin, in_place);
      });
      return;
    }
    const std::vector<std::size_t> begin_of_run = scatter(from, to, n, width - digit, digit);
    sort_scattered(from, to, begin_of_run, in_place);
  }

  /// Moves words into the order of a digit, stably. Returns the places where the runs begin, and `n`.
  static std::vector<std::size_t> scatter(const Word* from, Word* to, std::size_t n, int shift, int digit) {
    const std::size_t digits = std::size_t(1) << digit;
    const Word mask = digits - 1;
    Digit_counts<ConcurrencyTag> counts(n, block_, digits);
    counts.count([=](std::size_t i) { return (from[i] >> shift) & mask; });
    const std::vector<std::size_t> begin_of_run = counts.place_runs();
    for_each_block<ConcurrencyTag>(n, block_, [&](std::size_t block, std::size_t begin, std::size_t end) {
      std::uint32_t* const place = counts.places(block);
      for (std::size_t i = begin; i < end; ++i) to[place[(from[i] >> shift) & mask]++] = from[i];
    });
    return begin_of_run;
  }

  /// Sorts runs, whose words are at `to`.
  static void sort_scattered(Word* from, Word* to, const std::vector<std::size_t>& begin_of_run,
                             bool in_place) {
    const std::size_t n = begin_of_run.back();
    const std::size_t runs = begin_of_run.size() - 1;
    const auto length = [&](std::size_t run) { return begin_of_run[run + 1] - begin_of_run[run]; };
    for_each_block<ConcurrencyTag>(n, block_, [&](std::size_t, std::size_t begin, std::size_t end) {
      const auto first = std::lower_bound(begin_of_run.begin(), begin_of_run.end(), begin);
      for (std::size_t r = static_cast<std::size_t>(first - begin_of_run.begin()); begin_of_run[r] < end; ++r)
        if (length(r) <= longest_short_range)
          sort_short(to + begin_of_run[r], from + begin_of_run[r], length(r), !in_place);
    });
    for (std::size_t r = 0; r < runs; ++r)
      if (length(r) > longest_short_range)
        sort_long(to + begin_of_run[r], from + begin_of_run[r], length(r), !in_place);
  }
};

/// Sorts words in parallel, from `from` on to `from` if `in_place`, otherwise to `to`. Both ranges are written to.
template <class ConcurrencyTag>
void sort_words(std::uint64_t* from, std::uint64_t* to, std::size_t n, bool in_place) {
  const Concurrency_scope scope{ConcurrencyTag()};
  Word_sorter<Inner_tag<ConcurrencyTag>>::sort(from, to, n, in_place);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_RADIX_SORT_H
