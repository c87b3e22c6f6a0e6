// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Sorting of keys of one or more 64-bit words by their digits.
//
// Computes: the stable order of (key, index) pairs, or plain keys in order.
// Bound:    O(n w) for keys of w words; random keys take two or three passes whatever their length.
// Method:   A range of keys is sorted by a window of about log2(n) + 2 bits below the longest common prefix,
// least
//           significant digit first, digits that are equal in all keys skipped. Runs that agree in their
//           window are sorted on their own: small ones by comparison, large ones the same way, further down
//           the key. The recursion is as deep as there are windows in a key, a small constant. Runs are
//           independent of each other.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_RADIX_SORT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_RADIX_SORT_H

#include <CGAL/Quadtree_mesh_2/internal/bits.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// One word of a key and the index of what it belongs to.
struct Keyed_index {
  std::uint64_t key;
  std::uint32_t index;
};

inline std::uint64_t key_word(const Keyed_index& item) { return item.key; }
inline std::uint64_t key_word(std::uint64_t key) { return key; }

/// Sorts records by their key word, then by the further words of their keys.
/// \tparam Record has an overload of `key_word()`.
/// \tparam Next_word resolves ties of the present word, see `Words_of_index` and `No_more_words`.
template <class Record, class Next_word>
class Radix_sorter {
public:
  Radix_sorter(Record* buffer, const Next_word& next_word) : buffer_(buffer), next_word_(next_word) {}

  /// Sorts `[first, first + n)`, whose members hold the given word of their keys and agree in all words
  /// before.
  void sort(Record* first, std::size_t n, int word) {
    if (n <= small_) {
      std::sort(first, first + n,
                [&](const Record& a, const Record& b) { return next_word_.less(a, b, word); });
      return;
    }
    std::uint64_t varying = 0;
    for (std::size_t i = 1; i < n; ++i) varying |= key_word(first[i]) ^ key_word(first[0]);
    const int width = bit_width(varying);
    if (width == 0) {
      descend(first, n, word);
      return;
    }
    const int window = std::min(width, bit_width(n) + 2);
    const int shift = width - window;
    sort_window(first, n, shift, window);
    sort_runs(first, n, shift, word);
  }

private:
  static constexpr std::size_t small_ = 512;
  static constexpr int max_digit_ = 11;
  static constexpr int max_passes_ = 4;
  using Counts = std::array<std::uint32_t, std::size_t(1) << max_digit_>;

  /// Sorts by the `window` bits from bit `shift` on, least significant digit first.
  void sort_window(Record* first, std::size_t n, int shift, int window) {
    const int passes = (window + max_digit_ - 1) / max_digit_;
    const int digit = (window + passes - 1) / passes;
    const std::uint64_t mask = (std::uint64_t(1) << digit) - 1;
    std::array<Counts, max_passes_> counts;
    for (int p = 0; p < passes; ++p) counts[std::size_t(p)].fill(0);
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint64_t key = key_word(first[i]) >> shift;
      for (int p = 0; p < passes; ++p) ++counts[std::size_t(p)][(key >> (p * digit)) & mask];
    }
    Record* from = first;
    Record* to = buffer_;
    for (int p = 0; p < passes; ++p) {
      Counts& count = counts[std::size_t(p)];
      const int at = shift + p * digit;
      if (count[(key_word(from[0]) >> at) & mask] == n) continue; // the digit is the same in all keys
      to_offsets(count);
      for (std::size_t i = 0; i < n; ++i) to[count[(key_word(from[i]) >> at) & mask]++] = from[i];
      std::swap(from, to);
    }
    if (from != first) std::copy(from, from + n, first);
  }

  static void to_offsets(Counts& counts) {
    std::uint32_t sum = 0;
    for (std::uint32_t& c : counts) {
      const std::uint32_t count = c;
      c = sum;
      sum += count;
    }
  }

  /// Sorts the runs of records that agree in the bits from `shift` on.
  void sort_runs(Record* first, std::size_t n, int shift, int word) {
    if (shift == 0 && next_word_.is_last(word)) return;
    std::size_t begin = 0;
    while (begin < n) {
      const std::uint64_t key = key_word(first[begin]) >> shift;
      std::size_t end = begin + 1;
      while (end < n && (key_word(first[end]) >> shift) == key) ++end;
      if (end - begin > 1) sort(first + begin, end - begin, word);
      begin = end;
    }
  }

  /// Sorts records that agree in this word by the next one.
  void descend(Record* first, std::size_t n, int word) {
    if (next_word_.is_last(word)) return;
    next_word_.load(first, n, word + 1);
    sort(first, n, word + 1);
  }

  Record* buffer_;
  const Next_word& next_word_;
};

/// Further words of the keys of `Keyed_index` records, computed when they are asked for.
template <class Word_of>
struct Words_of_index {
  int number_of_words;
  Word_of word_of;

  bool is_last(int word) const { return word + 1 == number_of_words; }
  void load(Keyed_index* first, std::size_t n, int word) const {
    for (std::size_t i = 0; i < n; ++i) first[i].key = word_of(first[i].index, word);
  }
  bool less(const Keyed_index& a, const Keyed_index& b, int word) const {
    if (a.key != b.key) return a.key < b.key;
    for (int w = word + 1; w < number_of_words; ++w) {
      const std::uint64_t key_a = word_of(a.index, w);
      const std::uint64_t key_b = word_of(b.index, w);
      if (key_a != key_b) return key_a < key_b;
    }
    return a.index < b.index;
  }
};

/// Keys that are one word.
struct No_more_words {
  bool is_last(int) const { return true; }
  void load(std::uint64_t*, std::size_t, int) const {}
  bool less(std::uint64_t a, std::uint64_t b, int) const { return a < b; }
};

/// Sorts `items`, whose keys are the first words of longer keys, by whole keys and then by index.
/// The `key` members are unspecified afterwards.
/// \param items records with increasing indices and `key == word_of(index, 0)`.
/// \param number_of_words length of a key in words.
/// \param word_of called as `word_of(index, i)`, returns word i of a key, the most significant one first.
template <class Word_of>
void radix_sort(std::vector<Keyed_index>& items, int number_of_words, const Word_of& word_of) {
  std::vector<Keyed_index> buffer(items.size());
  const Words_of_index<Word_of> words{number_of_words, word_of};
  Radix_sorter<Keyed_index, Words_of_index<Word_of>>(buffer.data(), words)
      .sort(items.data(), items.size(), 0);
}

/// Sorts one-word keys.
inline void radix_sort(std::vector<std::uint64_t>& keys) {
  std::vector<std::uint64_t> buffer(keys.size());
  const No_more_words words;
  Radix_sorter<std::uint64_t, No_more_words>(buffer.data(), words).sort(keys.data(), keys.size(), 0);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_RADIX_SORT_H
