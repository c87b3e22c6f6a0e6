// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Sorting of keys of one or more 64-bit words by their digits.
//
// Computes: the stable order of items by keys of several words.
// Bound:    O(n w) work for keys of w words. A constant number of rounds of tasks of bounded length, and that
//           again for each long run of keys that agree in a digit. Random keys move two or three times,
//           whatever their length.
// Method:   A long range is split by the highest digit that varies. Blocks count their digits. The counts are
//           summed up in the order of digits and then of blocks. Blocks then scatter their members. Runs that
//           agree in the digit are short as a rule. They are sorted independently of each other, in cache, by
//           a window of about log2(n) + 2 bits, least significant digit first. Runs that agree in their
//           window are treated likewise. Runs that are still long are split one after another.
//           For longer keys, 32 bits and the index of the item make the word that is sorted. So a pass moves
//           8 bytes for each item. Runs that agree in the 32 bits load the next bits that vary. The recursion
//           is as deep as there are digits in a key, a small constant.
//           Blocks depend on lengths alone, and equal words cannot be told apart. So results are the same
//           bits for any number of threads.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_RADIX_SORT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_RADIX_SORT_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <CGAL/tags.h>

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
    // Runs shall have some hundred words. Fewer digits would not fill tasks, more would not fill cache lines.
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
    const std::size_t blocks = (n + block_ - 1) / block_;
    // Words with a digit in a block, then the number of such words in the blocks before.
    std::unique_ptr<std::uint32_t[]> counts(new std::uint32_t[blocks * digits]);
    for_each_block<ConcurrencyTag>(n, block_, [&](std::size_t block, std::size_t begin, std::size_t end) {
      std::uint32_t* const count = counts.get() + block * digits;
      std::fill(count, count + digits, 0u);
      for (std::size_t i = begin; i < end; ++i) ++count[(from[i] >> shift) & mask];
    });
    std::vector<std::size_t> begin_of_run(digits + 1);
    for_each_block<ConcurrencyTag>(digits, 128, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t block = 0; block < blocks; ++block)
        for (std::size_t d = begin; d < end; ++d) {
          std::uint32_t& count = counts[block * digits + d];
          const std::uint32_t before = static_cast<std::uint32_t>(begin_of_run[d]);
          begin_of_run[d] += count;
          count = before;
        }
    });
    scan_exclusively(begin_of_run.data(), digits + 1, std::size_t(0));
    for_each_block<ConcurrencyTag>(n, block_, [&](std::size_t block, std::size_t begin, std::size_t end) {
      std::uint32_t* const place = counts.get() + block * digits;
      for (std::size_t d = 0; d < digits; ++d) place[d] += static_cast<std::uint32_t>(begin_of_run[d]);
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

/// Words of keys by the address of the function that computes them. What sorts by keys is instantiated for this one
/// type instead of for every kind of keys.
class Erased_keys {
public:
  /// \param word_of see `radix_order()`
  template <class Word_of>
  explicit Erased_keys(const Word_of& word_of) : word_of_(&word_of), load_(load_words<Word_of>) {}

  /// Puts the words `word` of the keys of `n` items to `words`. The low half of an item is an index.
  void load(const std::uint64_t* items, std::size_t n, int word, std::uint64_t* words) const {
    load_(word_of_, items, n, word, words);
  }

private:
  template <class Word_of>
  static void load_words(const void* keys, const std::uint64_t* items, std::size_t n, int word,
                         std::uint64_t* words) {
    const Word_of& word_of = *static_cast<const Word_of*>(keys);
    for (std::size_t i = 0; i < n; ++i) words[i] = word_of(static_cast<std::uint32_t>(items[i]), word);
  }

  const void* word_of_;
  void (*load_)(const void*, const std::uint64_t*, std::size_t, int, std::uint64_t*);
};

/// Sorts indices by keys of several words.
template <class ConcurrencyTag>
class Key_sorter {
public:
  Key_sorter(int number_of_words, const Erased_keys& keys, std::uint64_t* items, std::uint64_t* buffer)
      : number_of_words_(number_of_words), keys_(keys), items_(items), buffer_(buffer) {}

  /// Sorts the indices 0 to `n - 1`.
  void sort(std::size_t n) {
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) { items_[i] = i; });
    sort_range(0, n, 0);
  }

  /// Returns the index in place `i`.
  std::uint32_t index(std::size_t i) const { return static_cast<std::uint32_t>(items_[i]); }

private:
  using Word = std::uint64_t;

  /// Sorts the items of a range, which agree in all words before `word`. Calls itself for runs that agree in
  /// the 32 bits that are sorted by.
  void sort_range(std::size_t begin, std::size_t n, int word) {
    Word* const items = items_ + begin;
    Word* const buffer = buffer_ + begin;
    int width = 0;
    for (;; ++word) {
      if (word == number_of_words_) {
        // All keys are equal. Indices increase, because items have been sorted with them.
        for_each_index<ConcurrencyTag>(n, [&](std::size_t i) { items[i] = index(begin + i); });
        return;
      }
      Word first = 0;
      keys_.load(items, 1, word, &first);
      width = bit_width(reduce<ConcurrencyTag>(
          n, Word(0),
          [&](std::size_t b, std::size_t e) {
            keys_.load(items + b, e - b, word, buffer + b);
            Word varying = 0;
            for (std::size_t i = b; i < e; ++i) varying |= buffer[i] ^ first;
            return varying;
          },
          [](Word a, Word b) { return a | b; }));
      if (width > 0) break;
    }
    const int shift = std::max(0, width - 32);
    for_each_index<ConcurrencyTag>(
        n, [&](std::size_t i) { buffer[i] = (buffer[i] >> shift << 32) | index(begin + i); });
    Word_sorter<ConcurrencyTag>::sort(buffer, items, n, false);
    if (shift > 0 || word + 1 < number_of_words_) sort_runs(begin, n, shift > 0 ? word : word + 1);
  }

  /// Sorts the runs of items that agree in what they have been sorted by, by the words from `word` on.
  void sort_runs(std::size_t begin, std::size_t n, int word) {
    const std::size_t end = begin + n;
    if (n <= longest_short_range) {
      for_each_run(begin, end,
                   [&](std::size_t run, std::size_t length) { sort_short_range(run, length, word); });
      return;
    }
    // A task sorts the runs that begin in its block. Where these begin is found before any run is sorted, which
    // changes the words that tell runs apart.
    const std::size_t blocks = (n + default_block - 1) / default_block;
    std::vector<std::size_t> first_run(blocks + 1, end);
    for_each_block<ConcurrencyTag>(n, default_block, [&](std::size_t block, std::size_t b, std::size_t) {
      first_run[block] = b == 0 ? begin : end_of_run(begin + b - 1, end);
    });
    std::vector<std::vector<std::pair<std::size_t, std::size_t>>> long_runs(blocks);
    Executor<ConcurrencyTag>::run(blocks, [&](std::size_t block) {
      for_each_run(first_run[block], first_run[block + 1], [&](std::size_t run, std::size_t length) {
        if (length > longest_short_range)
          long_runs[block].emplace_back(run, length);
        else
          sort_short_range(run, length, word);
      });
    });
    for (const auto& runs : long_runs)
      for (const auto& run : runs) sort_range(run.first, run.second, word);
  }

  /// Short ranges are tasks of a parallel loop already, and are not split further.
  void sort_short_range(std::size_t begin, std::size_t n, int word) {
    const Concurrency_scope scope{Sequential_tag()};
    Key_sorter<Chosen_tag>(number_of_words_, keys_, items_, buffer_).sort_range(begin, n, word);
  }

  /// Calls `f(run, length)` for each run of at least two items in a range, which are `length` items from `run`
  /// on.
  template <class F>
  void for_each_run(std::size_t begin, std::size_t end, const F& f) const {
    for (std::size_t i = begin; i + 1 < end;) {
      if (items_[i] >> 32 != items_[i + 1] >> 32) {
        ++i;
        continue;
      }
      const std::size_t run = i;
      i = end_of_run(i, end);
      f(run, i - run);
    }
  }

  /// Returns where the run around place `i` of a sorted range ends, by steps that grow.
  std::size_t end_of_run(std::size_t i, std::size_t end) const {
    const Word run = items_[i] >> 32;
    std::size_t step = 1;
    while (step < end - i && items_[i + step] >> 32 == run) {
      i += step;
      step *= 2;
    }
    const Word* const first = items_ + i;
    const Word* const last = items_ + std::min(end, i + step);
    const auto is_in_run = [run](Word item) { return item >> 32 == run; };
    return i + static_cast<std::size_t>(std::partition_point(first, last, is_in_run) - first);
  }

  template <class>
  friend class Key_sorter;

  int number_of_words_;
  Erased_keys keys_;
  Word* items_;
  Word* buffer_;
};

/// Indices in some order.
using Order = Uninitialized_vector<std::uint32_t>;

/// Returns the indices below `n` sorted by their keys, equal keys by index.
/// Takes 16 bytes of scratch memory for each index.
/// \param number_of_words length of a key in words.
/// \param word_of called as `word_of(index, i)`, by several threads at once, returns word i of a key, the most
/// significant one first.
/// \pre `n <= 2^32`
template <class ConcurrencyTag = Sequential_tag, class Word_of>
Order radix_order(std::size_t n, int number_of_words, const Word_of& word_of) {
  Order order(n);
  if (n == 0) return order;
  const auto items = uncleared_words(n), buffer = uncleared_words(n);
  const Concurrency_scope scope{ConcurrencyTag()};
  Key_sorter<Inner_tag<ConcurrencyTag>> sorter(number_of_words, Erased_keys(word_of), items.get(),
                                               buffer.get());
  sorter.sort(n);
  for_each_index<ConcurrencyTag>(n, [&](std::size_t i) { order[i] = sorter.index(i); });
  return order;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_RADIX_SORT_H
