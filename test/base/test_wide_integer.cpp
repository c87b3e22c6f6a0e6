// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Integers of two words against those of the compiler: the same bits, for numbers of all lengths.

#include "catch.h"

#include <CGAL/Quadtree_mesh_2/internal/base/Wide_integer.h>

#include <cstdint>
#include <random>
#include <vector>

#ifdef __SIZEOF_INT128__

namespace test_wide_integer {

using CGAL::Quadtree_mesh_2::internal::Product_of_words;
using CGAL::Quadtree_mesh_2::internal::Two_word_integer;
__extension__ typedef __int128 Wide;
__extension__ typedef unsigned __int128 Unsigned;

Two_word_integer two_words(Wide v) {
  return (Two_word_integer(static_cast<std::int64_t>(v >> 64)) << 64) +
         Two_word_integer(static_cast<std::uint64_t>(v));
}

bool are_equal(Wide v, Two_word_integer w) {
  return static_cast<std::uint64_t>(v) == static_cast<std::uint64_t>(w) &&
         static_cast<std::uint64_t>(v >> 64) == static_cast<std::uint64_t>(w >> 64);
}

/// Numbers around all powers of two, the least and the greatest one, and random ones of all lengths.
std::vector<Wide> numbers() {
  const auto greatest = static_cast<Wide>(~Unsigned(0) >> 1);
  std::vector<Wide> result{greatest, -greatest - 1};
  std::mt19937_64 random(1);
  for (int i = 0; i < 127; ++i) {
    const Wide power = Wide(1) << i;
    for (const Wide v : {power - 1, power, power + 1}) result.push_back(v), result.push_back(-v);
    const auto v = static_cast<Wide>((Unsigned(random()) << 64 | random()) >> (127 - i));
    result.push_back(v), result.push_back(-v);
  }
  return result;
}

/// As the processor does it, without the undefined behavior of overflow.
Wide wrapped(Unsigned v) { return static_cast<Wide>(v); }

TEST_CASE("Integers of two words are those of the compiler", "[wide_integer]") {
  const auto all = numbers();
  const Wide least = all[1];
  // With each number every fifth one, others from number to number.
  const std::size_t step = is_full_run() ? 1 : 5;
  for (std::size_t i_of_a = 0; i_of_a < all.size(); ++i_of_a) {
    const Wide a = all[i_of_a];
    const Two_word_integer x = two_words(a);
    REQUIRE(are_equal(a, x));
    CHECK(static_cast<std::int64_t>(a) == static_cast<std::int64_t>(x));
    CHECK(static_cast<double>(a) == static_cast<double>(x));
    CHECK((a != 0) == static_cast<bool>(x));
    CHECK(are_equal(~a, ~x));
    CHECK(are_equal(wrapped(-Unsigned(a)), -x));
    for (int i = 0; i < 128; ++i) {
      REQUIRE(are_equal(a >> i, x >> i));
      REQUIRE(are_equal(wrapped(Unsigned(a) << i), x << i));
    }
    for (std::size_t j = i_of_a % step; j < all.size(); j += step) {
      const Wide b = all[j];
      const Two_word_integer y = two_words(b);
      REQUIRE(are_equal(wrapped(Unsigned(a) + Unsigned(b)), x + y));
      REQUIRE(are_equal(wrapped(Unsigned(a) - Unsigned(b)), x - y));
      REQUIRE(are_equal(wrapped(Unsigned(a) * Unsigned(b)), x * y));
      REQUIRE(are_equal(a & b, x & y));
      REQUIRE((a < b) == (x < y));
      REQUIRE((a > b) == (x > y));
      REQUIRE((a <= b) == (x <= y));
      REQUIRE((a >= b) == (x >= y));
      REQUIRE((a == b) == (x == y));
      REQUIRE((a != b) == (x != y));
      if (b == 0 || (a == least && b == -1)) continue;
      REQUIRE(are_equal(a / b, x / y));
      REQUIRE(are_equal(a % b, x % y));
    }
  }
}

TEST_CASE("Doubles become integers of two words as they become those of the compiler", "[wide_integer]") {
  for (const Wide a : numbers()) {
    const double v = static_cast<double>(a);
    if (v >= 0x1p127 || v <= -0x1p127) continue;
    for (const double w : {v, v * 0.75, v + 0.5})
      CHECK(are_equal(static_cast<Wide>(w), static_cast<Two_word_integer>(w)));
  }
}

TEST_CASE("Products of words are those of the compiler", "[wide_integer]") {
  for (const Wide a : numbers()) {
    for (const Wide b : numbers()) {
      const auto x = static_cast<std::uint64_t>(a), y = static_cast<std::uint64_t>(b);
      const Unsigned product = Unsigned(x) * y;
      const Product_of_words words = CGAL::Quadtree_mesh_2::internal::product_of_words(x, y);
      REQUIRE(words == Product_of_words{static_cast<std::uint64_t>(product >> 64),
                                        static_cast<std::uint64_t>(product)});
    }
  }
}

} // namespace test_wide_integer

#endif
