// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Points and squares of all parts, one part after the other, are those of one part: order, duplicates, errors, the
// squares of the framework (Theorem 1), and leaves without balance.

#include "catch.h"
#include "sliced_points.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Quadtree_framework.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Deep_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Framework_part.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Point_order.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Separating_leaves.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace test_framework_part {

namespace {

using namespace CGAL::Quadtree_mesh_2::internal;
using namespace sliced_points;
using CGAL::Quadtree_mesh_2::Distributed_duplicate_point;
using CGAL::Quadtree_mesh_2::Distributed_framework_square;
using CGAL::Quadtree_mesh_2::Distributed_point_error;
using CGAL::Quadtree_mesh_2::Node_index;
using CGAL::Quadtree_mesh_2::Point_error;
using CGAL::Quadtree_mesh_2::Point_index;
using CGAL::Quadtree_mesh_2::Point_rank;
using Framework = CGAL::Quadtree_framework<Traits>;
using Exchange = In_memory_exchange;

/// What all parts have, one after the other.
struct Of_all_parts {
  std::vector<Placed_point> points;
  std::vector<Distributed_duplicate_point> duplicates;
  std::vector<Distributed_framework_square> squares;
  std::vector<Coarse_square> leaves;
  std::vector<std::size_t> points_of_part;
  std::vector<Exchange_traffic> traffic;
};

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

Of_all_parts of_all_parts(const Points& points, Cuts cuts, int parts, std::size_t most) {
  std::map<int, Of_all_parts> of_part;
  std::mutex mutex;
  Of_all_parts all;
  all.traffic = Exchange::run(parts, [&](Exchange& exchange) {
    const Points own = slice(points, cuts, exchange.rank(), parts);
    const Traits traits;
    Of_all_parts result;
    Ordered_points<Traits> order = Point_sorter<Traits, Exchange>(exchange, traits).sort(own);
    result.points = order.points;
    result.duplicates = order.duplicates;
    result.squares = Framework_part_finder<Traits, Exchange>(exchange, order).find();
    result.leaves = Separating_leaves<Traits, Exchange>(exchange, order, most).leaves();
    for (std::size_t i = 1; i < order.points.size(); ++i) // points have moved to leaves
      if (!less_shuffle(order.points[i - 1].place, order.points[i].place)) result.leaves.clear();
    const std::lock_guard<std::mutex> lock(mutex);
    of_part[exchange.rank()] = std::move(result);
  });
  for (const auto& [part, own] : of_part) {
    append(all.points, own.points), append(all.duplicates, own.duplicates);
    append(all.squares, own.squares), append(all.leaves, own.leaves);
    all.points_of_part.push_back(own.points.size());
  }
  return all;
}

int wrong_points(const Framework& framework, const Of_all_parts& all) {
  if (all.points.size() != framework.number_of_points()) return 1;
  int wrong = 0;
  for (std::size_t r = 0; r < all.points.size(); ++r)
    wrong += all.points[r].place != framework.grid_point(Point_rank(r)) ||
             all.points[r].index != framework.input_point(Point_rank(r)).value();
  return wrong;
}

bool are_duplicates_same(const Framework& framework, const Of_all_parts& all) {
  std::map<std::int64_t, std::int64_t> expected, kept_of;
  for (const auto& d : framework.duplicates()) expected[d.duplicate.value()] = d.kept.value();
  for (const auto& d : all.duplicates) kept_of[d.duplicate] = d.kept;
  return expected == kept_of && all.duplicates.size() == expected.size();
}

int wrong_squares(const Framework& framework, const Of_all_parts& all) {
  if (all.squares.size() != framework.number_of_nodes()) return 1;
  int wrong = 0;
  for (std::size_t i = 0; i < all.squares.size(); ++i) {
    const Distributed_framework_square& s = all.squares[i];
    const Node_index v(i);
    wrong += s.square != framework.square(v) || s.begin != framework.points(v).begin.value() ||
             s.end != framework.points(v).end.value() || s.level_of_parent != framework.level_of_parent(v);
  }
  return wrong;
}

/// The leaves without balance, larger squares in place of those below level 29.
std::vector<Fine_square> expected_leaves(const Points& points, std::size_t most) {
  const CGAL::Balanced_quadtree<Traits> tree(
      points,
      CGAL::Quadtree_options().max_points_per_leaf(most).balance(CGAL::Quadtree_mesh_2::Balance::NONE));
  std::vector<Fine_square> leaves;
  for (std::size_t l = 0; l < tree.number_of_leaves(); ++l) {
    Fine_square s = tree.square(CGAL::Quadtree_mesh_2::Leaf_index(l));
    const int level = std::min(s.level, last_coarse_level);
    const auto corner = corner_of_square(Framework::Grid_point{s.x, s.y}, level, fine_depth);
    s = {corner.x, corner.y, level};
    if (leaves.empty() || leaves.back() != s) leaves.push_back(s);
  }
  return leaves;
}

std::vector<Fine_square> fine(const std::vector<Coarse_square>& squares) {
  std::vector<Fine_square> result;
  for (const Coarse_square& s : squares) result.push_back(fine_square(s));
  return result;
}

void check_same(const Points& points, Cuts cuts, int parts, std::size_t most) {
  const Framework framework(points);
  const Of_all_parts all = of_all_parts(points, cuts, parts, most);
  CHECK(wrong_points(framework, all) == 0);
  CHECK(are_duplicates_same(framework, all));
  CHECK(wrong_squares(framework, all) == 0);
  CHECK(fine(all.leaves) == expected_leaves(points, most));
}

/// The error of one part, and of several.
template <class Error, class Work>
std::string error_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST_CASE("parts have the framework and the leaves of one part: all cuts", "[distributed]") {
  const int parts = GENERATE(1, 2, 3, 7);
  const Cuts cuts = GENERATE(Cuts::EVEN, Cuts::ALL_AT_THE_LAST, Cuts::RANDOM);
  for (const Named_points& input : small_inputs()) {
    INFO(input.name << ", " << parts << " parts");
    for (const std::size_t most : {1u, 7u, 1000u}) check_same(input.points, cuts, parts, most);
    if (is_full_run()) check_same(input.points, cuts, parts, 2);
  }
}

TEST_CASE("parts have the framework and the leaves of one part: many parts", "[distributed]") {
  const int parts = GENERATE(16, is_full_run() ? 64 : 32);
  for (const Named_points& input : small_inputs()) {
    INFO(input.name << ", " << parts << " parts");
    check_same(input.points, Cuts::EVEN, parts, 1);
    check_same(input.points, Cuts::RANDOM, parts, 3);
  }
}

TEST_CASE("parts have the framework and the leaves of one part: maps", "[distributed]") {
  for (const char* const name :
       {"us_states_10m.poly.gz", "syn_holes_400.poly.gz", "star_of_72_spikes.poly"}) {
    INFO(name);
    const Points points = vertices_of(name);
    check_same(points, Cuts::EVEN, 5, 1);
    check_same(points, Cuts::ALL_AT_THE_LAST, 64, 10);
  }
}

TEST_CASE("parts get about as many points each", "[distributed]") {
  const Points points = quadtree_test::make_points<Traits>(quadtree_test::uniform(20000, 9));
  for (const Cuts cuts : {Cuts::EVEN, Cuts::RANDOM}) {
    const Of_all_parts all = of_all_parts(points, cuts, 8, 1);
    const auto most = *std::max_element(all.points_of_part.begin(), all.points_of_part.end());
    CHECK(most <= 20000 / 8 + 20000 / 64);
  }
}

TEST_CASE("parts tell only neighbors what they have to", "[distributed]") {
  // In order already: a part keeps its points, but for those next to a boundary.
  Points points = quadtree_test::make_points<Traits>(quadtree_test::uniform(6400, 11));
  const Framework framework(points);
  Points in_order;
  for (std::size_t r = 0; r < points.size(); ++r)
    in_order.push_back(points[std::size_t(framework.input_point(Point_rank(r)))]);
  const int parts = 64;
  const Of_all_parts all = of_all_parts(in_order, Cuts::EVEN, parts, 1);
  for (const Exchange_traffic& traffic : all.traffic) {
    CHECK(traffic.messages <= 6 + 2 + 2 + 1 + 1 + 2); // chains, points twice, ends, windows
    CHECK(traffic.bytes <= 62 * 16 * 7 + 2 * 100 * 24);
  }
}

TEST_CASE("bad points are the same error for any number of parts", "[distributed]") {
  const int parts = GENERATE(1, 2, 5, 16);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Points points = quadtree_test::make_points<Traits>(quadtree_test::uniform(40, 1));
  const auto same_error = [&] {
    const std::string expected = error_of<Point_error>([&] { Framework framework(points); });
    CHECK(expected != "no error");
    for (const Cuts cuts : {Cuts::EVEN, Cuts::ALL_AT_THE_LAST, Cuts::RANDOM})
      CHECK(error_of<Distributed_point_error>([&] { of_all_parts(points, cuts, parts, 1); }) == expected);
  };
  SECTION("not finite") {
    points[31] = Point_2(0, nan), points[17] = Point_2(std::numeric_limits<double>::infinity(), 0);
    same_error();
  }
  SECTION("out of range") {
    points[39] = Point_2(0, nan), points[3] = Point_2(0, 0x1p1001);
    same_error();
  }
  SECTION("indistinguishable, at one place or two") {
    for (int i = 0; i < 6; ++i) {
      points[static_cast<std::size_t>(5 + 6 * i)] = Point_2(std::ldexp(1 + i % 3, -70 - 40 * (i % 2)), 0);
      points[static_cast<std::size_t>(7 + 6 * i)] = Point_2(std::ldexp(1 + i % 3, -70), 0x1p-60);
    }
    same_error();
  }
}

} // namespace test_framework_part
