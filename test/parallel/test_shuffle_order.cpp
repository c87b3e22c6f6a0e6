// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "numbers_of_threads.h"

#include <CGAL/Quadtree_mesh_2/internal/base/Long_words.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_shuffle_order {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using CGAL::Quadtree_mesh_2::Grid_point_2;
using internal::Long_word;

enum class Kind { SCATTERED, ALL_EQUAL, DUPLICATES, ONE_WORD, CLUSTERS, FEW_RUNS, MAGNITUDES, LATTICE, END };

template <class Word>
std::vector<Grid_point_2<Word>> points_of_kind(std::size_t n, Kind kind) {
  constexpr int bits = static_cast<int>(8 * sizeof(Word));
  std::mt19937_64 random(n + static_cast<unsigned>(kind));
  const auto coordinate = [&](int length) { return static_cast<Word>(random() >> (64 - length)); };
  const auto point = [&](int length) {
    const Word x = coordinate(length);
    return Grid_point_2<Word>{x, coordinate(length)};
  };
  std::vector<Grid_point_2<Word>> centers(300);
  for (auto& c : centers) c = point(bits);
  const auto near = [&](const Grid_point_2<Word>& c, int length) {
    const Grid_point_2<Word> p = point(length);
    return Grid_point_2<Word>{static_cast<Word>(c.x ^ p.x), static_cast<Word>(c.y ^ p.y)};
  };
  std::vector<Grid_point_2<Word>> points(n);
  for (std::size_t i = 0; i < n; ++i) switch (kind) {
    case Kind::SCATTERED:
      points[i] = point(bits);
      break;
    case Kind::ALL_EQUAL:
      points[i] = centers[0];
      break;
    case Kind::DUPLICATES:
      points[i] = centers[random() % centers.size()];
      break;
    case Kind::ONE_WORD:
      points[i] = near(centers[0], 7);
      break; // differs in the last word alone
    case Kind::CLUSTERS:
      points[i] = near(centers[random() % centers.size()], 10);
      break;
    case Kind::FEW_RUNS:
      points[i] = near(centers[random() % 2], bits / 2 - 2);
      break;
    case Kind::MAGNITUDES:
      points[i] = point(1 + static_cast<int>(random() % std::uint64_t(bits)));
      break;
    default:
      points[i] = {static_cast<Word>(i % 256), static_cast<Word>(Word(i / 256) << (bits / 2))};
    }
  return points;
}

template <class Word>
bool has_bit(const Word& word, int i) {
  if constexpr (std::is_same_v<Word, Long_word>)
    return bit_test(word, static_cast<unsigned>(i)); // without shifting all of it
  else
    return (word >> i & 1) != 0;
}

/// The shuffle by its definition, as characters.
template <class Word>
std::string shuffle_of(const Grid_point_2<Word>& p, int bits) {
  std::string shuffle(2 * static_cast<std::size_t>(bits), '0');
  char* next = shuffle.data();
  for (int i = bits - 1; i >= 0; --i) {
    *next++ = has_bit(p.x, i) ? '1' : '0';
    *next++ = has_bit(p.y, i) ? '1' : '0';
  }
  return shuffle;
}

template <class Word>
internal::Order order_by_definition(const std::vector<Grid_point_2<Word>>& points, int bits) {
  std::vector<std::string> shuffles;
  for (const auto& p : points) shuffles.push_back(shuffle_of(p, bits));
  internal::Order order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return shuffles[i] < shuffles[j]; });
  return order;
}

/// The order of points that are sorted the other way around: equal ones stay in the order of their numbers.
template <class Word>
internal::Order order_of_reversed(const std::vector<Grid_point_2<Word>>& points) {
  internal::Order order;
  for (std::size_t end = points.size(); end > 0;) {
    std::size_t begin = end - 1;
    while (begin > 0 && points[begin - 1] == points[end - 1]) --begin;
    for (std::size_t i = begin; i < end; ++i) order.push_back(static_cast<std::uint32_t>(i));
    end = begin;
  }
  return order;
}

template <class Word>
void check_orders(const std::vector<Grid_point_2<Word>>& points, const internal::Order& expected) {
  REQUIRE(expected.size() == points.size());
  // Vectors are compared in parentheses, lest a failure prints them.
  CHECK((internal::shuffle_order(points) == expected));
  for_numbers_of_threads([&] { CHECK((internal::shuffle_order<CGAL::Parallel_tag>(points) == expected)); });
}

} // namespace

TEMPLATE_TEST_CASE("Shuffle order in parallel agrees with its definition", "[parallel]", std::uint32_t,
                   std::uint64_t) {
  const int bits = static_cast<int>(8 * sizeof(TestType));
  for (int kind = 0; kind < static_cast<int>(Kind::END); ++kind)
    for (std::size_t n : {0u, 1u, 2u, 513u, 8193u, 70000u}) {
      CAPTURE(kind, n);
      auto points = points_of_kind<TestType>(n, static_cast<Kind>(kind));
      const auto order = order_by_definition(points, bits);
      check_orders(points, order);
      if (n < 8193) continue;

      // The same points in order and in reverse.
      const auto unsorted = points;
      for (std::size_t i = 0; i < n; ++i) points[i] = unsorted[order[i]];
      internal::Order in_place(n);
      std::iota(in_place.begin(), in_place.end(), 0u);
      check_orders(points, in_place);
      std::reverse(points.begin(), points.end());
      check_orders(points, order_of_reversed(points));
    }
}

TEST_CASE("Long runs of a shuffle order are sorted in parallel", "[parallel]") {
  const std::size_t n = is_full_run() ? 3000000 : 100000;
  for (int kind = 0; kind < static_cast<int>(Kind::END); ++kind) {
    CAPTURE(kind);
    const auto points = points_of_kind<std::uint64_t>(n, static_cast<Kind>(kind));
    internal::Order expected(n);
    std::iota(expected.begin(), expected.end(), 0u);
    std::stable_sort(expected.begin(), expected.end(), [&](std::uint32_t i, std::uint32_t j) {
      return internal::less_shuffle(points[i], points[j]);
    });
    check_orders(points, expected);
  }
}

TEST_CASE("Shuffle order of words of any length agrees with its definition", "[parallel]") {
  const int bits = 1000;
  std::mt19937_64 random(3);
  const auto coordinate = [&] {
    Long_word c = 0;
    for (int i = 0; i < bits; i += 50) c = c << 50 | random() >> 14;
    return c;
  };
  for (int kind = 0; kind < 4; ++kind)
    for (std::size_t n : {0u, 1u, 2u, 700u, kind == 2 ? 9000u : is_full_run() ? 3000u : 1000u}) {
      CAPTURE(kind, n);
      const Grid_point_2<Long_word> center{coordinate(), coordinate()};
      std::vector<Grid_point_2<Long_word>> points(n);
      for (auto& p : points) {
        // Scattered, of all magnitudes, differing in few bits anywhere (hence often equal), all equal.
        if (kind == 0) p = {coordinate(), coordinate()};
        if (kind == 1) p = {coordinate() >> (random() % bits), coordinate() >> (random() % bits)};
        if (kind > 1) p = center;
        if (kind == 2) {
          bit_flip(p.x, static_cast<unsigned>(random() % 5) * 200);
          bit_flip(p.y, static_cast<unsigned>(random() % 5) * 199);
        }
      }
      const auto expected = order_by_definition(points, bits);
      check_orders(points, expected);
      for (std::size_t i = 1; i < n; ++i)
        REQUIRE(!internal::less_shuffle(points[expected[i]], points[expected[i - 1]]));
    }
}

} // namespace test_shuffle_order
