// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Runs of items by squares: none too long, none to be put together, each a set of whole squares, and cuts that stay
// where they are when something changes far away.

#include "catch.h"

#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/cut_by_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <vector>

namespace test_cut_by_squares {

namespace {

using namespace CGAL::Quadtree_mesh_2::internal;
using Keys = std::vector<std::uint64_t>;

std::vector<std::size_t> cuts_of(const Keys& keys, std::size_t most) {
  return cut_by_squares(keys.size(), most, [&](std::size_t i, std::size_t k) {
    REQUIRE(i < k);
    return (bit_width(keys[i] ^ keys[k]) + 1) / 2;
  });
}

/// Keys of points that crowd in some squares of all sizes.
Keys random_keys(std::mt19937& random, std::size_t n) {
  Keys keys;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t mask = 0xffffffffu >> (random() % 4 == 0 ? random() % 32 : 0);
    keys.push_back(
        interleave(static_cast<std::uint32_t>(random()) & mask, static_cast<std::uint32_t>(random()) & mask));
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// Whether a cut before item i is at a corner of a square that is split: the smallest square with both items beside the
/// cut has more than `most`.
bool is_between_children(const Keys& keys, std::size_t i, std::size_t most) {
  const int bits = (bit_width(keys[i - 1] ^ keys[i]) + 1) / 2 * 2;
  const auto is_with = [&](std::uint64_t key) { return bits == 64 || key >> bits == keys[i] >> bits; };
  return static_cast<std::size_t>(std::count_if(keys.begin(), keys.end(), is_with)) > most;
}

} // namespace

TEST_CASE("Runs by squares are as long as they may be", "[grid]") {
  std::mt19937 random(1);
  for (const std::size_t n : {0u, 1u, 2u, 7u, 100u, 1000u})
    for (const std::size_t most : {1u, 2u, 5u, 24u, 100u, 5000u}) {
      const Keys keys = random_keys(random, n);
      CAPTURE(n, most);
      const std::vector<std::size_t> first = cuts_of(keys, most);
      REQUIRE(std::is_sorted(first.begin(), first.end()));
      CHECK(first.back() == n);
      if (n > 0) CHECK(first.front() == 0);
      for (std::size_t r = 0; r + 1 < first.size(); ++r) {
        CHECK(first[r] < first[r + 1]);
        CHECK(first[r + 1] - first[r] <= most);
        if (r + 2 < first.size()) CHECK(first[r + 2] - first[r] > most);
        if (r > 0 && keys[first[r] - 1] != keys[first[r]]) CHECK(is_between_children(keys, first[r], most));
      }
    }
}

TEST_CASE("Items that no square tells apart are cut by number", "[grid]") {
  const Keys keys(100, 42);
  CHECK(cuts_of(keys, 30) == std::vector<std::size_t>{0, 25, 50, 75, 100});
}

TEST_CASE("Cuts stay where they are if something changes far away", "[grid]") {
  std::mt19937 random(2);
  for (int run = 0; run < 50; ++run) {
    // The first quarter of the root changes. In the others cuts are between the same keys as before.
    const std::size_t most = 1 + random() % 40;
    Keys before = random_keys(random, 600), after;
    for (const std::uint64_t key : before)
      if (key >> 62 != 0) after.push_back(key);
    for (const std::uint64_t key : random_keys(random, 200)) after.push_back(key >> 2);
    std::sort(after.begin(), after.end());
    const auto cuts = [&](const Keys& keys) {
      std::vector<std::uint64_t> found;
      for (const std::size_t i : cuts_of(keys, most))
        if (i < keys.size() && keys[i] >> 62 != 0) found.push_back(keys[i]);
      return found;
    };
    const auto cuts_before = cuts(before), cuts_after = cuts(after);
    // The first runs beyond the quarter may be put together with its last one.
    std::vector<std::uint64_t> both;
    std::set_intersection(cuts_before.begin(), cuts_before.end(), cuts_after.begin(), cuts_after.end(),
                          std::back_inserter(both));
    CHECK(both.size() + 4 >= std::max(cuts_before.size(), cuts_after.size()));
  }
}

} // namespace test_cut_by_squares
