// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Sorting of items by keys of one or more 64-bit words, with their keys.
//
// Computes: the keys of n items in order, and the stable order of the items.
// Bound:    O(n w) work for keys of w words. A constant number of rounds of tasks of bounded length, and that
//           again for each long run of keys that agree in a digit. A key of 64 random bits moves once between
//           the caches and once in them.
// Floor:    To read all keys once and then to read and write them and their order twice takes 2 to 4.5 ns a point
//           of 16 bytes, and the scatter alone 2 to 7.5, from 10^5 to 10^7 points (EPYC of the fourth
//           generation). The sort takes 16 to 24, most of it for shuffling bits.
// Method:   Keys move, not only what refers to them: to read a key where its item has it costs a miss of the
//           cache for each item, and that again for each further word. A long range is split by a digit. Blocks
//           count their digits. The counts are summed up in the order of digits and then of blocks. Blocks then
//           scatter their keys and indices to where the result will be. Runs that agree in the digit are short
//           as a rule. They are sorted independently of each other, in cache: the bits from the highest one on
//           that varies and the place in the run make one word for each key, the words are sorted
//           (radix_sort.h), and keys and indices are put into their order. Keys of a run that agree in those
//           bits load the next bits that vary. A run that is longer is copied and split in turn.
//           A sample tells where most keys lie. The digit is the place in that range; what is outside has two
//           digits of its own. So keys that crowd somewhere are not split again and again for a few far away.
//           Who needs the order alone has first words carried, not keys.
//           Places in a block and a run are in the order of items, and words hold places, so that none are
//           equal. So the order is stable, and unique: results are the same bits for any number of threads.
// Source:   P. M. McIlroy, K. Bostic, M. D. McIlroy, "Engineering Radix Sort", for the most significant digit
//           first; O. Polychroniou, K. A. Ross, "A Comprehensive Study of Main-Memory Partitioning and its
//           Application to Large-Scale Comparison- and Radix-Sort", for how many digits caches bear.
// Deviates: from both, digits are places in a range and not bits of the key.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_SORT_BY_KEYS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_SORT_BY_KEYS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/radix_sort.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How keys of a type are read as words, the most significant one first. Types without words are compared.
template <class Key>
struct Radix_key {
  static constexpr int number_of_words = 0;
};

template <>
struct Radix_key<std::uint64_t> {
  static constexpr int number_of_words = 1;
  static constexpr std::uint64_t word(std::uint64_t key, int) { return key; }
  /// Adds the bits in which two keys differ.
  static constexpr void add_differences(std::uint64_t a, std::uint64_t b, std::uint64_t& differences) {
    differences |= a ^ b;
  }
};

template <std::size_t n>
struct Radix_key<std::array<std::uint64_t, n>> {
  using Key = std::array<std::uint64_t, n>;
  static constexpr int number_of_words = static_cast<int>(n);
  static constexpr std::uint64_t word(const Key& key, int i) { return key[static_cast<std::size_t>(i)]; }
  static constexpr void add_differences(const Key& a, const Key& b, Key& differences) {
    for (std::size_t i = 0; i < n; ++i) differences[i] |= a[i] ^ b[i];
  }
};

/// Indices in some order.
using Order = Uninitialized_vector<std::uint32_t>;

/// Keys in order, equal ones by the index of their item.
template <class Key>
struct Sorted_keys {
  Uninitialized_vector<Key> keys;
  Order order; ///< the items that the keys belong to
};

/// Bits of keys: the highest ones that vary in a range.
struct Varying_bits {
  int word;
  int width; ///< up to the highest bit that varies; 0 if all keys are equal

  /// The highest bits that vary, of a set of bits given as a key.
  template <class Key>
  static Varying_bits highest(const Key& differences) {
    for (int i = 0; i < Radix_key<Key>::number_of_words; ++i) {
      const int width = bit_width(Radix_key<Key>::word(differences, i));
      if (width > 0) return {i, width};
    }
    return {0, 0};
  }
};

/// A digit of one word of keys: its place in a range, in steps of a power of two. What is below the range has the
/// first digit, what is above the last.
class Range_digit {
public:
  Range_digit(int word, std::uint64_t low, std::uint64_t high, int digit_width)
      : word_(word), first_(low), shift_(std::max(0, bit_width(high - low) - digit_width)),
        inside_(((high - low) >> shift_) + 1) {}

  /// The range where most of the words of a sample lie, or all if that is not much longer.
  static Range_digit of_sample(std::vector<std::uint64_t> sample, int digit_width) {
    constexpr int wasted_bits = 4; // with more of them, runs would have to be split again
    std::sort(sample.begin(), sample.end());
    const std::size_t eighth = sample.size() / 8;
    const std::uint64_t low = sample[eighth], high = sample[sample.size() - 1 - eighth];
    if (bit_width(high - low) + wasted_bits < bit_width(sample.back() - sample.front()))
      return Range_digit(0, low, high, digit_width);
    return Range_digit(0, sample.front(), sample.back(), digit_width);
  }

  std::size_t number_of_digits() const { return static_cast<std::size_t>(inside_ + 2); }

  template <class Key>
  std::size_t operator()(const Key& key) const {
    const std::uint64_t word = Radix_key<Key>::word(key, word_);
    const std::uint64_t digit = std::min((word - first_) >> shift_, inside_) + 1;
    return static_cast<std::size_t>(word < first_ ? 0 : digit);
  }

private:
  int word_;
  std::uint64_t first_;
  int shift_;
  std::uint64_t inside_;
};

/// The items of an array by their places. Code that sorts arrays is instantiated for this one type, and not for a
/// lambda of each caller.
template <class Item>
struct Item_at {
  const Item* items;

  Item operator()(std::size_t i) const { return items[i]; }
};

/// Sorts ranges of keys that fit into the cache. Has the memory for that.
template <class Key>
class Short_range_sorter {
public:
  static constexpr int place_bits = 15;
  static constexpr std::size_t longest = std::size_t(1) << place_bits;

  /// \param longest_here no longer range will be sorted
  explicit Short_range_sorter(std::size_t longest_here)
      : items_(uncleared_words(longest_here)), buffer_(uncleared_words(longest_here)), keys_(longest_here),
        indices_(longest_here) {}

  /// Sorts `n` keys and with them their indices.
  void sort(Key* keys, std::uint32_t* indices, std::size_t n) {
    if (n < 2) return;
    all_ = keys;
    if (!sort_items(0, n, [](std::size_t i) { return i; })) return;
    std::copy(keys, keys + n, keys_.begin());
    std::copy(indices, indices + n, indices_.begin());
    for (std::size_t i = 0; i < n; ++i) {
      keys[i] = keys_[place(i)];
      indices[i] = indices_[place(i)];
    }
  }

private:
  using Word = std::uint64_t;
  using Radix = Radix_key<Key>;
  static constexpr int bits_in_item_ = 64 - place_bits;

  std::size_t place(std::size_t i) const { return static_cast<std::size_t>(items_[i] & (longest - 1)); }

  /// Sorts the items of a range of places. Calls itself for runs that agree in the bits that are sorted by.
  /// Returns false, and leaves items as they are, if the keys are all equal.
  /// \tparam Place_at returns which key is in a place before.
  template <class Place_at>
  bool sort_items(std::size_t begin, std::size_t n, const Place_at& place_at) {
    const Key first = all_[place_at(begin)];
    Key differences{};
    for (std::size_t i = begin; i < begin + n; ++i)
      Radix::add_differences(all_[place_at(i)], first, differences);
    const Varying_bits varying = Varying_bits::highest(differences);
    if (varying.width == 0) return false;
    // What all keys have in common is shifted out.
    const int shift = std::max(0, varying.width - bits_in_item_);
    for (std::size_t i = begin; i < begin + n; ++i) {
      const std::size_t p = place_at(i);
      items_[i] = Radix::word(all_[p], varying.word) >> shift << place_bits | p;
    }
    Word_sorter<Sequential_tag>::sort(items_.get() + begin, buffer_.get() + begin, n, true);
    if (shift > 0 || varying.word + 1 < Radix::number_of_words) sort_runs(begin, n);
    return true;
  }

  /// Sorts the runs of items that agree in what they have been sorted by.
  void sort_runs(std::size_t begin, std::size_t n) {
    const std::size_t end = begin + n;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const Word run = items_[i - 1] >> place_bits;
      if (items_[i] >> place_bits != run) continue;
      const std::size_t first = i - 1;
      while (i < end && items_[i] >> place_bits == run) ++i;
      sort_items(first, i - first, [this](std::size_t k) { return place(k); });
    }
  }

  std::unique_ptr<Word[]> items_, buffer_;
  Uninitialized_vector<Key> keys_;
  Uninitialized_vector<std::uint32_t> indices_;
  const Key* all_ = nullptr;
};

/// Sorts keys of items, see the head of this file.
template <class Key>
class Key_sorter {
public:
  /// \param key_at called as `key_at(i)`, twice or more and by several threads at once.
  template <class ConcurrencyTag, class Key_at>
  static Sorted_keys<Key> sort(std::size_t n, const Key_at& key_at) {
    Sorted_keys<Key> sorted;
    sorted.keys.resize(n);
    sorted.order.resize(n);
    Key_sorter sorter{sorted.keys.data(), sorted.order.data()};
    const auto index_at = [](std::size_t i) { return static_cast<std::uint32_t>(i); };
    if (n <= Short_range_sorter<Key>::longest) {
      sorter.template take<ConcurrencyTag>(n, key_at, index_at);
      Short_range_sorter<Key>(n).sort(sorted.keys.data(), sorted.order.data(), n);
    } else if (const auto digit = varying_digit<ConcurrencyTag>(n, Digit_choice::BY_SAMPLE, key_at)) {
      sorter.template split<ConcurrencyTag>(0, n, *digit, key_at, index_at);
    } else {
      sorter.template take<ConcurrencyTag>(n, key_at, index_at);
    }
    return sorted;
  }

private:
  using Radix = Radix_key<Key>;

  /// With so few bits the lines that a pass writes to fit into the second level of cache.
  static constexpr int max_digit_ = 11;
  static constexpr std::size_t block_ = std::size_t(1) << 15;
  static constexpr std::size_t sample_size_ = 256;
  /// What is longer is split by parallel tasks, what is not by one.
  static constexpr std::size_t longest_of_task_ = std::size_t(1) << 17;

  Key_sorter(Key* keys, std::uint32_t* order) : keys_(keys), order_(order) {}

  template <class Tag, class Key_at, class Index_at>
  void take(std::size_t n, const Key_at& key_at, const Index_at& index_at) {
    for_each_index<Tag>(n, [&](std::size_t i) {
      keys_[i] = key_at(i);
      order_[i] = index_at(i);
    });
  }

  /// What says where the digit is that a range is split by: some of the keys, which may have outliers, or all.
  enum class Digit_choice { BY_SAMPLE, BY_ALL_KEYS };

  /// A digit that is not the same in all of `n` keys, if there is one.
  template <class Tag, class Key_at>
  static std::optional<Range_digit> varying_digit(std::size_t n, Digit_choice choice, const Key_at& key_at) {
    // Runs shall fit into the first or second level of cache. More would not fill cache lines.
    const int digit_width = std::min(max_digit_, bit_width(n) - 10);
    if (choice == Digit_choice::BY_SAMPLE) {
      std::vector<std::uint64_t> sample;
      for (std::size_t i = 0; i < sample_size_; ++i)
        sample.push_back(Radix::word(key_at(n / sample_size_ * i), 0));
      const auto is_first = [&sample](std::uint64_t word) { return word == sample.front(); };
      if (!std::all_of(sample.begin(), sample.end(), is_first))
        return Range_digit::of_sample(std::move(sample), digit_width);
    }
    const Key first = key_at(0);
    const Varying_bits varying = Varying_bits::highest(differences_to<Tag>(first, n, key_at));
    if (varying.width == 0) return std::nullopt;
    const std::uint64_t bits = ~std::uint64_t(0) >> (64 - varying.width);
    const std::uint64_t word = Radix::word(first, varying.word);
    return Range_digit(varying.word, word & ~bits, word | bits, digit_width);
  }

  template <class Tag, class Key_at>
  static Key differences_to(const Key& key, std::size_t n, const Key_at& key_at) {
    return reduce<Tag>(
        n, Key{},
        [&](std::size_t begin, std::size_t end) {
          Key differences{};
          for (std::size_t i = begin; i < end; ++i) Radix::add_differences(key_at(i), key, differences);
          return differences;
        },
        [](Key a, const Key& b) {
          Radix::add_differences(b, Key{}, a);
          return a;
        });
  }

  /// Puts `n` keys, which are elsewhere, in order into the places from `begin` on.
  template <class Tag, class Key_at, class Index_at>
  void split(std::size_t begin, std::size_t n, const Range_digit& digit, const Key_at& key_at,
             const Index_at& index_at) {
    sort_runs<Tag>(begin, scatter<Tag>(begin, n, digit, key_at, index_at));
  }

  /// Moves keys into the order of a digit, stably. Returns the places where the runs begin, and `n`.
  template <class Tag, class Key_at, class Index_at>
  std::vector<std::size_t> scatter(std::size_t begin, std::size_t n, const Range_digit& digit,
                                   const Key_at& key_at, const Index_at& index_at) {
    Uninitialized_vector<std::uint16_t> digits(n); // takes less time than to find them twice
    Digit_counts<Tag> counts(n, block_, digit.number_of_digits());
    counts.count([&](std::size_t i) { return digits[i] = static_cast<std::uint16_t>(digit(key_at(i))); });
    const std::vector<std::size_t> begin_of_run = counts.place_runs();
    for_each_block<Tag>(n, block_, [&](std::size_t block, std::size_t b, std::size_t e) {
      std::uint32_t* const place = counts.places(block);
      for (std::size_t i = b; i < e; ++i) {
        const std::size_t k = begin + place[digits[i]]++;
        keys_[k] = key_at(i);
        order_[k] = index_at(i);
      }
    });
    return begin_of_run;
  }

  /// Sorts the runs of the places from `begin` on.
  template <class Tag>
  void sort_runs(std::size_t begin, const std::vector<std::size_t>& begin_of_run) {
    const std::size_t n = begin_of_run.back();
    const auto length = [&](std::size_t run) { return begin_of_run[run + 1] - begin_of_run[run]; };
    for_each_block<Tag>(n, block_, [&](std::size_t, std::size_t b, std::size_t e) {
      const auto first = std::lower_bound(begin_of_run.begin(), begin_of_run.end(), b);
      const std::size_t first_run = static_cast<std::size_t>(first - begin_of_run.begin());
      std::size_t longest = 0;
      for (std::size_t r = first_run; begin_of_run[r] < e; ++r) longest = std::max(longest, length(r));
      Short_range_sorter<Key> sorter(std::min(longest, Short_range_sorter<Key>::longest));
      for (std::size_t r = first_run; begin_of_run[r] < e; ++r)
        if (length(r) <= Short_range_sorter<Key>::longest)
          sorter.sort(keys_ + begin + begin_of_run[r], order_ + begin + begin_of_run[r], length(r));
        else if (length(r) <= longest_of_task_)
          split_copy_in_task<Tag>(begin + begin_of_run[r], length(r), next_digit(length(r), n));
    });
    for (std::size_t r = 0; r + 1 < begin_of_run.size(); ++r)
      if (length(r) > longest_of_task_)
        split_copy<Tag>(begin + begin_of_run[r], length(r), next_digit(length(r), n));
  }

  /// A sample that has not made runs short does not choose the digit again. So keys are split at most as often
  /// as they have digits and n can be halved.
  static Digit_choice next_digit(std::size_t length, std::size_t n) {
    return length > n / 2 ? Digit_choice::BY_ALL_KEYS : Digit_choice::BY_SAMPLE;
  }

  /// By the functions that the longest runs take: those of `Sequential_tag` would have to be compiled, too.
  template <class Tag>
  void split_copy_in_task(std::size_t begin, std::size_t n, Digit_choice choice) {
    const Concurrency_scope scope{Sequential_tag()};
    split_copy<Tag>(begin, n, choice);
  }

  /// Sorts a long run.
  template <class Tag>
  void split_copy(std::size_t begin, std::size_t n, Digit_choice choice) {
    const auto digit = varying_digit<Tag>(n, choice, Item_at<Key>{keys_ + begin});
    if (!digit) return; // indices increase
    Uninitialized_vector<Key> keys(n);
    Order indices(n);
    for_each_index<Tag>(n, [&](std::size_t i) {
      keys[i] = keys_[begin + i];
      indices[i] = order_[begin + i];
    });
    split<Tag>(begin, n, *digit, Item_at<Key>{keys.data()}, Item_at<std::uint32_t>{indices.data()});
  }

  Key* keys_;
  std::uint32_t* order_;
};

/// Returns the keys of the items below `n` in order, equal keys by index. Takes at most as much scratch memory
/// as the result, and little if few keys agree in their first digits.
/// \param key_at called as `key_at(index)`, several times for each and by several threads at once, returns the
/// key of an item.
/// \pre `n <= 2^32`
template <class ConcurrencyTag = Sequential_tag, class Key_at>
auto sort_by_keys(std::size_t n, const Key_at& key_at) {
  using Key = std::decay_t<decltype(key_at(n))>;
  return Key_sorter<Key>::template sort<ConcurrencyTag>(n, key_at);
}

/// Sorts items whose keys agree in the first word by the other words.
template <class Key>
class Tie_sorter {
public:
  /// \param words the first words of the keys, in order
  /// \param order the items that they belong to, those with the same word by index
  template <class ConcurrencyTag, class Key_at>
  static void sort(const Uninitialized_vector<std::uint64_t>& words, Order& order, const Key_at& key_at) {
    std::vector<std::vector<std::size_t>> long_ties((words.size() + block_ - 1) / block_);
    for_each_block<ConcurrencyTag>(words.size(), block_,
                                   [&](std::size_t block, std::size_t b, std::size_t e) {
                                     std::optional<Short_ties> short_ties;
                                     for_each_tie(words, b, e, [&](std::size_t first, std::size_t n) {
                                       if (n > Short_range_sorter<Key>::longest) {
                                         long_ties[block].push_back(first);
                                       } else {
                                         if (!short_ties) short_ties.emplace(block_);
                                         short_ties->sort(order.data() + first, n, key_at);
                                       }
                                     });
                                   });
    for (const auto& ties : long_ties)
      for (const std::size_t first : ties)
        sort_long<ConcurrencyTag>(order.data() + first, end_of_tie(words, first) - first, key_at);
  }

private:
  static constexpr std::size_t block_ = Short_range_sorter<Key>::longest;

  /// Memory for keys that are looked up, and for their sort.
  struct Short_ties {
    Uninitialized_vector<Key> keys;
    Short_range_sorter<Key> sorter;

    explicit Short_ties(std::size_t longest) : keys(longest), sorter(longest) {}

    template <class Key_at>
    void sort(std::uint32_t* items, std::size_t n, const Key_at& key_at) {
      for (std::size_t i = 0; i < n; ++i) keys[i] = key_at(items[i]);
      sorter.sort(keys.data(), items, n);
    }
  };

  /// Calls `f(first, n)` for each run of several equal words that begins in a range of places.
  template <class F>
  static void for_each_tie(const Uninitialized_vector<std::uint64_t>& words, std::size_t begin,
                           std::size_t end, const F& f) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i + 1 == words.size() || words[i] != words[i + 1]) continue;
      const std::size_t first = i;
      i = end_of_tie(words, first) - 1;
      if (first == 0 || words[first - 1] != words[first]) f(first, i + 1 - first);
    }
  }

  static std::size_t end_of_tie(const Uninitialized_vector<std::uint64_t>& words, std::size_t first) {
    return static_cast<std::size_t>(
        std::upper_bound(words.begin() + static_cast<std::ptrdiff_t>(first), words.end(), words[first]) -
        words.begin());
  }

  template <class ConcurrencyTag, class Key_at>
  static void sort_long(std::uint32_t* items, std::size_t n, const Key_at& key_at) {
    Order order = Key_sorter<Key>::template sort<ConcurrencyTag>(n, [&](std::size_t i) {
                    return key_at(items[i]);
                  }).order;
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) { order[i] = items[order[i]]; });
    std::copy(order.begin(), order.end(), items);
  }
};

/// Returns the indices below `n` sorted by their keys, equal keys by index. First words are sorted with the
/// indices; keys are looked up where these agree. So it moves less than `sort_by_keys()` and finds words once, but
/// costs a miss of the cache for each key that agrees with another in the first word.
/// \param key_at as for `sort_by_keys()`.
template <class ConcurrencyTag = Sequential_tag, class Key_at>
Order radix_order(std::size_t n, const Key_at& key_at) {
  using Key = std::decay_t<decltype(key_at(n))>;
  using Radix = Radix_key<Key>;
  Uninitialized_vector<std::uint64_t> words(n);
  for_each_index<ConcurrencyTag>(n, [&](std::size_t i) { words[i] = Radix::word(key_at(i), 0); });
  Sorted_keys<std::uint64_t> sorted = sort_by_keys<ConcurrencyTag>(n, Item_at<std::uint64_t>{words.data()});
  if constexpr (Radix::number_of_words > 1)
    Tie_sorter<Key>::template sort<ConcurrencyTag>(sorted.keys, sorted.order, key_at);
  return std::move(sorted.order);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_SORT_BY_KEYS_H
