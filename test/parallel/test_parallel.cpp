// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "numbers_of_threads.h"

#include <CGAL/Quadtree_mesh_2/internal/base/Long_words.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/Run_counters.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel_sort.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/radix_sort.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sums_along_list.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_parallel {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using CGAL::Quadtree_mesh_2::Grid_point_2;
using internal::List_link;
using internal::Long_word;

/// Lengths around those of blocks.
std::vector<std::size_t> lengths(std::size_t block) {
  return {0, 1, 2, block - 1, block, block + 1, 2 * block, 5 * block, 7 * block + 13};
}

std::vector<std::uint64_t> random_values(std::size_t n, std::uint64_t different) {
  std::mt19937_64 random(n + different);
  std::vector<std::uint64_t> values(n);
  for (std::uint64_t& v : values) v = random() % different;
  return values;
}

template <class ConcurrencyTag>
void sort_words(std::vector<std::uint64_t>& words) {
  std::vector<std::uint64_t> buffer(words.size());
  internal::sort_words<ConcurrencyTag>(words.data(), buffer.data(), words.size(), true);
}

template <class Key>
void check_sort_by_keys(const std::vector<Key>& keys) {
  std::vector<std::uint32_t> expected(keys.size());
  std::iota(expected.begin(), expected.end(), 0u);
  std::stable_sort(expected.begin(), expected.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return keys[i] < keys[j]; });
  const auto check = [&](const internal::Sorted_keys<Key>& sorted) {
    CHECK(std::equal(sorted.order.begin(), sorted.order.end(), expected.begin(), expected.end()));
    CHECK(std::equal(sorted.keys.begin(), sorted.keys.end(), expected.begin(), expected.end(),
                     [&](const Key& key, std::uint32_t i) { return key == keys[i]; }));
  };
  const auto key_at = [&](std::size_t i) { return keys[i]; };
  const auto check_order = [&](const internal::Order& order) {
    CHECK(std::equal(order.begin(), order.end(), expected.begin(), expected.end()));
  };
  check(internal::sort_by_keys(keys.size(), key_at));
  check_order(internal::radix_order(keys.size(), key_at));
  for_numbers_of_threads([&] {
    check(internal::sort_by_keys<CGAL::Parallel_tag>(keys.size(), key_at));
    check_order(internal::radix_order<CGAL::Parallel_tag>(keys.size(), key_at));
  });
}

} // namespace

TEMPLATE_TEST_CASE("Blocks make up a range", "[parallel][threads]", CGAL::Sequential_tag,
                   CGAL::Parallel_tag) {
  for (std::size_t n : lengths(100)) {
    CAPTURE(n);
    std::vector<std::size_t> block_of(n, n);
    std::vector<int> visits(n, 0);
    std::atomic<bool> is_wrong(false);
    internal::for_each_block<TestType>(n, 100, [&](std::size_t block, std::size_t begin, std::size_t end) {
      if (begin != 100 * block || end != std::min(n, begin + 100)) is_wrong = true;
      for (std::size_t i = begin; i < end; ++i) block_of[i] = block;
    });
    CHECK(!is_wrong);
    for (std::size_t i = 0; i < n; ++i) REQUIRE(block_of[i] == i / 100);
    internal::for_each_index<TestType>(n, [&](std::size_t i) { ++visits[i]; });
    CHECK((visits == std::vector<int>(n, 1)));
  }
}

TEMPLATE_TEST_CASE("Reductions and scans agree with the standard's", "[parallel][threads]",
                   CGAL::Sequential_tag, CGAL::Parallel_tag) {
  for (std::size_t n : lengths(internal::default_block)) {
    CAPTURE(n);
    const std::vector<std::uint64_t> values = random_values(n, 1000);
    const auto sum_of = [&](std::size_t begin, std::size_t end) {
      std::uint64_t sum = 0;
      for (std::size_t i = begin; i < end; ++i) sum += values[i];
      return sum;
    };
    const std::uint64_t sum = std::accumulate(values.begin(), values.end(), std::uint64_t(0));
    CHECK(internal::reduce<TestType>(n, std::uint64_t(0), sum_of,
                                     [](std::uint64_t a, std::uint64_t b) { return a + b; }) == sum);

    // Neither commutative nor of an identity that could be left out.
    const auto text_of = [&](std::size_t begin, std::size_t end) {
      return std::to_string(sum_of(begin, end));
    };
    std::string text = "sums";
    for (std::size_t b = 0; b < n; b += 64) text += ' ' + text_of(b, std::min(n, b + 64));
    CHECK(internal::reduce<TestType>(
              n, std::string("sums"), text_of,
              [](const std::string& a, const std::string& b) { return a + ' ' + b; }, 64) == text);

    CHECK(internal::reduce<TestType>(
        n, true, [&](std::size_t b, std::size_t e) { return sum_of(b, e) < 1000 * (e - b); },
        [](bool a, bool b) { return a && b; }, 16));

    std::vector<std::uint64_t> scanned = values, expected(n);
    std::exclusive_scan(values.begin(), values.end(), expected.begin(), std::uint64_t(0));
    CHECK(internal::exclusive_scan<TestType>(scanned.data(), n) == sum);
    CHECK((scanned == expected));

    std::vector<std::uint32_t> odd;
    for (std::size_t i = 0; i < n; ++i)
      if (values[i] % 2 == 1) odd.push_back(static_cast<std::uint32_t>(i));
    CHECK((internal::pack<TestType>(n, [&](std::size_t i) { return values[i] % 2 == 1; }) == odd));
    CHECK(internal::pack<TestType>(n, [](std::size_t) { return false; }).empty());
    CHECK(internal::pack<TestType>(n, [](std::size_t) { return true; }).size() == n);

    // Each value repeated as often as it says, modulo 3.
    std::vector<std::uint64_t> repeated, repeated_expected;
    for (std::uint64_t v : values) repeated_expected.insert(repeated_expected.end(), v % 3, v);
    const std::size_t total = internal::count_allocate_and_place<TestType>(
        n,
        [&](std::size_t begin, std::size_t end) {
          std::size_t count = 0;
          for (std::size_t i = begin; i < end; ++i) count += values[i] % 3;
          return count;
        },
        [&](std::size_t count) { repeated.resize(count); },
        [&](std::size_t begin, std::size_t end, std::size_t first) {
          for (std::size_t i = begin; i < end; ++i)
            for (std::uint64_t k = 0; k < values[i] % 3; ++k) repeated[first++] = values[i];
        },
        500);
    CHECK(total == repeated_expected.size());
    CHECK((repeated == repeated_expected));
  }
}

TEST_CASE("An exception in one task leaves loops within others whole", "[parallel][threads]") {
  for (int repeat = 0; repeat < 50; ++repeat) {
    std::atomic<std::size_t> cut_short{0};
    const auto run = [&] {
      internal::Executor<CGAL::Parallel_tag>::run(16, [&](std::size_t task) {
        if (task == 5) throw std::runtime_error("task 5");
        std::atomic<std::size_t> done{0};
        internal::for_each_index<CGAL::Parallel_tag>(
            2000, [&](std::size_t) { ++done; }, 10);
        if (done != 2000) ++cut_short;
      });
    };
    CHECK_THROWS_AS(run(), std::runtime_error);
    CHECK(cut_short == 0);
  }
}

TEMPLATE_TEST_CASE("Exceptions of tasks arrive", "[parallel][threads]", CGAL::Sequential_tag,
                   CGAL::Parallel_tag) {
  const std::size_t n = 10 * internal::default_block;
  const auto fail_at = [](std::size_t i, std::size_t at) {
    if (i == at) throw std::runtime_error("task");
  };
  for (std::size_t at : {std::size_t(0), n / 2, n - 1}) {
    CHECK_THROWS_AS(internal::for_each_index<TestType>(n, [&](std::size_t i) { fail_at(i, at); }),
                    std::runtime_error);
    CHECK_THROWS_AS(internal::pack<TestType>(n, [&](std::size_t i) { return fail_at(i, at), true; }),
                    std::runtime_error);
    std::vector<std::size_t> values(n);
    std::iota(values.begin(), values.end(), std::size_t(0));
    const auto less = [&](std::size_t a, std::size_t b) { return fail_at(a, at), fail_at(b, at), a < b; };
    CHECK_THROWS_AS(internal::sort<TestType>(values.begin(), values.end(), less), std::runtime_error);
    CHECK_THROWS_AS(
        internal::radix_order<TestType>(n, [&](std::size_t i) { return fail_at(i, at), std::uint64_t(i); }),
        std::runtime_error);
  }
}

TEMPLATE_TEST_CASE("Sorting by comparison is stable", "[parallel][threads]", CGAL::Sequential_tag,
                   CGAL::Parallel_tag) {
  using Pair = std::pair<std::uint64_t, std::size_t>;
  const auto less = [](const Pair& a, const Pair& b) { return a.first < b.first; };
  const auto greater = [](const Pair& a, const Pair& b) { return a.first > b.first; };
  for (std::size_t n : lengths(internal::sort_block))
    for (std::uint64_t different : {1u, 2u, 50u, 1000000000u}) {
      CAPTURE(n, different);
      const std::vector<std::uint64_t> keys = random_values(n, different);
      std::vector<Pair> values(n);
      for (std::size_t i = 0; i < n; ++i) values[i] = {keys[i], i};
      std::vector<Pair> expected = values, up = values, down;
      std::stable_sort(expected.begin(), expected.end(), less);
      down = expected;
      std::stable_sort(down.begin(), down.end(), greater);
      for_numbers_of_threads([&] {
        std::vector<Pair> sorted = values;
        internal::sort<TestType>(sorted.begin(), sorted.end(), less);
        CHECK((sorted == expected));
        internal::sort<TestType>(sorted.begin(), sorted.end(), less);
        CHECK((sorted == expected));
        internal::sort<TestType>(sorted.begin(), sorted.end(), greater);
        CHECK((sorted == down));
      });
    }
}

TEMPLATE_TEST_CASE("Values that own memory, or cannot be copied, are sorted", "[parallel][threads]",
                   CGAL::Sequential_tag, CGAL::Parallel_tag) {
  const std::size_t n = 5 * internal::sort_block + 7;
  const std::vector<std::uint64_t> keys = random_values(n, 5000);
  for_numbers_of_threads([&] {
    std::vector<std::unique_ptr<std::uint64_t>> owners;
    std::vector<std::string> strings;
    for (std::uint64_t key : keys) {
      owners.push_back(std::make_unique<std::uint64_t>(key));
      strings.push_back("longer than what is stored in the string itself " + std::to_string(key));
    }
    internal::sort<TestType>(owners.begin(), owners.end(),
                             [](const auto& a, const auto& b) { return *a < *b; });
    CHECK(std::is_sorted(owners.begin(), owners.end(), [](const auto& a, const auto& b) { return *a < *b; }));

    std::vector<std::string> expected = strings;
    std::sort(expected.begin(), expected.end());
    internal::sort<TestType>(strings.begin(), strings.end(), std::less<std::string>());
    CHECK((strings == expected));
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    internal::unique<TestType>(strings);
    CHECK((strings == expected));
  });
}

TEMPLATE_TEST_CASE("Equal neighbors are removed", "[parallel][threads]", CGAL::Sequential_tag,
                   CGAL::Parallel_tag) {
  for (std::size_t n : lengths(internal::default_block))
    for (std::uint64_t different : {1u, 2u, 1000000000u}) {
      CAPTURE(n, different);
      std::vector<std::uint64_t> values = random_values(n, different), expected = values;
      expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
      internal::unique<TestType>(values);
      CHECK((values == expected));
    }
}

TEMPLATE_TEST_CASE("Members come by group, in order", "[parallel][threads]", CGAL::Sequential_tag,
                   CGAL::Parallel_tag) {
  std::mt19937 random(5);
  for (const std::size_t n : {0u, 1u, 1000u, 200000u})
    for (const std::size_t groups : {1u, 7u, 300u}) {
      CAPTURE(n, groups);
      std::vector<std::size_t> group(n);
      for (std::size_t& g : group) g = random() % (groups + 1); // the last is none
      const auto result = internal::group_in_order<TestType, std::uint32_t>(
          n, groups, [&](std::size_t i) { return group[i]; });
      REQUIRE(result.size() == groups);
      for (std::size_t g = 0; g < groups; ++g) {
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = 0; i < n; ++i)
          if (group[i] == g) expected.push_back(i);
        const auto members = result[g];
        REQUIRE(std::vector<std::uint32_t>(members.begin(), members.end()) == expected);
      }
    }
}

TEMPLATE_TEST_CASE("Weights are summed up along a list", "[parallel][threads]", CGAL::Sequential_tag,
                   CGAL::Parallel_tag) {
  std::mt19937 random(8);
  for (std::size_t n : {1u, 2u, 1000u, 8192u, 8193u, 100000u, 1000000u}) {
    CAPTURE(n);
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    if (n != 8193) std::shuffle(order.begin(), order.end(), random);
    CGAL::Quadtree_mesh_2::internal::Uninitialized_vector<List_link> links(n);
    std::vector<std::uint32_t> expected(n);
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      links[order[i]] = {i + 1 < n ? order[i + 1] : List_link::none,
                         static_cast<std::uint32_t>(random() % 1000)};
      expected[order[i]] = sum;
      sum += links[order[i]].weight;
    }
    const auto sums = internal::sums_along_list<TestType>(links, order[0]);
    CHECK(std::equal(sums.begin(), sums.end(), expected.begin(), expected.end()));
  }
}

TEMPLATE_TEST_CASE("Vectors are appended in order", "[parallel][threads]", CGAL::Sequential_tag,
                   CGAL::Parallel_tag) {
  std::vector<std::vector<int>> parts(100);
  std::vector<int> all{-1, -2}, expected = all;
  for (int i = 0; i < 1000; ++i) parts[std::size_t(i % 13 * 7)].push_back(i);
  for (const auto& part : parts) expected.insert(expected.end(), part.begin(), part.end());
  internal::append_all<TestType>(
      all, parts, [](const auto& part) -> const auto& { return part; });
  CHECK(all == expected);
}

TEMPLATE_TEST_CASE("What blocks collect comes in order", "[parallel][threads]", CGAL::Sequential_tag,
                   CGAL::Parallel_tag) {
  constexpr std::size_t block = 64;
  for (const std::size_t n : lengths(block)) {
    CAPTURE(n);
    std::vector<std::size_t> all{7, 7}, expected = all;
    for (std::size_t i = 0; i < n; ++i) expected.insert(expected.end(), i % 3, i);
    internal::append_by_blocks<TestType>(
        all, n,
        [](std::size_t begin, std::size_t end, std::vector<std::size_t>& found) {
          for (std::size_t i = begin; i < end; ++i) found.insert(found.end(), i % 3, i);
        },
        block);
    CHECK(all == expected);
  }
}

TEMPLATE_TEST_CASE("Values are placed in their runs", "[parallel][threads]", CGAL::Sequential_tag,
                   CGAL::Parallel_tag) {
  const internal::Concurrency_scope scope{TestType()};
  for (const std::size_t n : {0u, 1u, 100000u})
    for (const std::size_t runs : {1u, 10u, 30000u}) {
      CAPTURE(n, runs);
      const std::vector<std::uint64_t> run_of = random_values(n, runs);
      internal::Run_counters counters(runs);
      internal::for_each_index<internal::Chosen_tag>(
          n, [&](std::size_t i) { counters.count(run_of[i]); }, 100);
      REQUIRE(counters.begin_placing() == n);
      std::vector<std::size_t> placed(n, n);
      internal::for_each_index<internal::Chosen_tag>(
          n, [&](std::size_t i) { placed[counters.place(run_of[i])] = i; }, 100);
      std::vector<char> is_placed(n, 0);
      for (std::size_t run = 0; run < runs; ++run) {
        REQUIRE(counters.begin(run) == (run == 0 ? 0 : counters.end(run - 1)));
        for (std::size_t k = counters.begin(run); k < counters.end(run); ++k) {
          REQUIRE(run_of[placed[k]] == run);
          is_placed[placed[k]] = 1;
        }
      }
      CHECK(std::count(is_placed.begin(), is_placed.end(), 1) == static_cast<std::ptrdiff_t>(n));
    }
}

TEMPLATE_TEST_CASE("Words are sorted by digits", "[parallel]", CGAL::Sequential_tag, CGAL::Parallel_tag) {
  std::vector<std::size_t> sizes = lengths(internal::longest_short_range);
  for (std::size_t n : {10u, 47u, 48u, 49u, 50u, 700u, 5000u}) sizes.push_back(n);
  for (std::size_t n : sizes)
    for (int shift : {0, 20, 40, 56, 63}) {
      if (n > 2 * internal::longest_short_range && shift != 40 && !is_full_run()) continue;
      CAPTURE(n, shift);
      std::mt19937_64 random(n + static_cast<unsigned>(shift));
      std::vector<std::uint64_t> words(n);
      // Few high bits, all low bits; magnitudes of all sizes; bits in the middle.
      for (int kind = 0; kind < 3; ++kind) {
        for (std::uint64_t& w : words) {
          w = random();
          if (kind == 0) w = (w >> shift << shift) | (random() & 1023);
          if (kind == 1) w = w >> (random() % 64);
          if (kind == 2) w = (w >> shift << (shift / 2)) | std::uint64_t(1) << 63;
        }
        std::vector<std::uint64_t> expected = words, sorted = words;
        std::sort(expected.begin(), expected.end());
        sort_words<TestType>(sorted);
        CHECK((sorted == expected));
        std::reverse(sorted.begin(), sorted.end());
        sort_words<TestType>(sorted);
        CHECK((sorted == expected));
      }
    }
}

TEST_CASE("Keys of several words are sorted by digits, for any number of threads", "[parallel][threads]") {
  // Words from few values, so that runs go on through all words.
  for (std::size_t n : {1u, 2u, 1000u, 40000u, is_full_run() ? 200000u : 70000u})
    for (std::uint64_t different : {1u, 3u, 1000u}) {
      CAPTURE(n, different);
      const std::vector<std::uint64_t> values = random_values(3 * n, different);
      std::vector<std::array<std::uint64_t, 3>> keys(n);
      for (std::size_t i = 0; i < 3 * n; ++i) keys[i / 3][i % 3] = values[i] * 0x9e3779b97f4a7c15u;
      check_sort_by_keys(keys);
    }
}

TEST_CASE("Keys are sorted wherever they lie close together", "[parallel][threads]") {
  for (std::size_t n : {300u, 32768u, 32769u, is_full_run() ? 150000u : 70000u})
    for (int kind = 0; kind < 7; ++kind) {
      CAPTURE(n, kind);
      std::mt19937_64 random(n + static_cast<unsigned>(kind));
      std::vector<std::uint64_t> keys(n);
      for (std::size_t i = 0; i < n; ++i) {
        std::uint64_t& key = keys[i];
        key = random();
        if (kind == 1)
          key = (std::uint64_t(1) << 63) +
                (key >> (1 + random() % 63)) * (key % 2 == 0 ? 1 : ~std::uint64_t(0));
        if (kind == 2) key = (std::uint64_t(1) << 63) - 500 + key % 1000; // around a power of two
        if (kind == 3) key = i % 1000 == 1 ? key : 42;                    // most equal, others anywhere
        if (kind == 4) key = i == n / 2 ? ~std::uint64_t(0) : key >> 40;  // one far from all
        if (kind == 5) key = (key % 30 << 40) * 977 + random() % 3000;    // clusters
        // What a sample at equal distances takes for all, and something else.
        if (kind == 6) key = i % (n / 256) == 0 ? 7 : key;
      }
      check_sort_by_keys(keys);
      std::vector<std::array<std::uint64_t, 2>> pairs(n);
      for (std::size_t i = 0; i < n; ++i) pairs[i] = {{keys[i] >> 32, keys[i] << 32}};
      check_sort_by_keys(pairs);
    }
}

} // namespace test_parallel
