// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The list of bad triangles against a set of what stands in it: all come out, the sharpest or the shortest first.

#include "catch.h"
#include "random_pslg.h"

#include <CGAL/Quadtree_mesh_2/internal/refinement/Worklist.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace test_worklist {

namespace {

using CGAL::Quadtree_mesh_2::internal::Triangle_id;
using CGAL::Quadtree_mesh_2::internal::Worklist;

/// A level has squared sines that differ by less than a factor of 1.5, down to 2^-126 of the bound's.
bool is_sharpest(double share, const std::map<Triangle_id, double>& others) {
  return std::all_of(others.begin(), others.end(), [share](const auto& other) {
    constexpr double factor_of_level = 1.5, least = 0x1p-126;
    return share <= std::max(factor_of_level * other.second, least) || (share >= 1 && other.second >= 1);
  });
}

} // namespace

TEST_CASE("Each triangle on the worklist comes out once, after all that are sharper", "[refiner]") {
  const std::uint64_t seed = GENERATE(0u, 1u, 2u, 3u);
  random_pslg::Random random(seed);
  Worklist list;
  std::map<Triangle_id, double> expected;
  for (int step = 0; step < 20000; ++step) {
    if (random.integer(0, 2) < 2) {
      const Triangle_id t(random.integer(0, 2000));
      const double share = std::exp2(random.between(seed < 2 ? -4 : -150, 1));
      list.push(t, share);
      expected.insert({t, share}); // if it stands there already, it stays where it is
    } else if (!list.is_empty()) {
      const Triangle_id t = list.pop();
      REQUIRE(expected.count(t) == 1);
      const double share = expected[t];
      expected.erase(t);
      CHECK(is_sharpest(share, expected));
    }
    REQUIRE(list.is_empty() == expected.empty());
  }
  for (; !expected.empty(); expected.erase(list.pop())) REQUIRE(!list.is_empty());
  CHECK(list.is_empty());
}

TEST_CASE("Triangles without an area are the sharpest", "[refiner]") {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double flat = GENERATE(0., -1., 0x1p-1070, -infinite, std::numeric_limits<double>::quiet_NaN());
  Worklist list;
  const double shares[] = {0.5, flat, 0x1p-30, infinite};
  for (const int t : {0, 1, 2, 3}) list.push(Triangle_id(t), shares[t]);
  std::vector<std::uint32_t> order;
  while (!list.is_empty()) order.push_back(list.pop().value());
  CHECK(order == std::vector<std::uint32_t>{1, 2, 0, 3});
}

TEST_CASE("By length, the triangle with the shortest edge comes first, and of alike ones that pushed first",
          "[refiner]") {
  const std::uint64_t seed = GENERATE(0u, 1u, 2u);
  random_pslg::Random random(seed);
  Worklist list;
  struct Entry {
    Triangle_id triangle;
    double length2;
  };
  std::vector<Entry> expected; // as they were pushed
  for (int step = 0; step < 2000; ++step) {
    if (random.integer(0, 2) < 2) {
      expected.push_back(
          {Triangle_id(random.integer(0, 200)), std::exp2(random.between(seed == 0 ? 0 : -300, 8))});
      list.push_by_length(expected.back().triangle, expected.back().length2);
    } else if (!list.is_empty()) {
      const auto first =
          std::min_element(expected.begin(), expected.end(), [](const Entry& a, const Entry& b) {
            return std::ilogb(a.length2) < std::ilogb(b.length2); // the first one of the least
          });
      CHECK(list.pop() == first->triangle);
      CHECK_FALSE(list.is_outdated(first->length2));
      CHECK(list.is_outdated(4 * first->length2));
      expected.erase(first);
    }
    REQUIRE(list.is_empty() == expected.empty());
  }
}

} // namespace test_worklist
