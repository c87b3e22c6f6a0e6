// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The leaves of all ranks are those of one quadtree in one memory, with the same squares, points and numbers.

#include "catch.h"
#include "sliced_points.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Distributed_quadtree_2.h>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace test_distributed_quadtree_2 {

namespace {

using namespace sliced_points;
using CGAL::Quadtree_options;
using CGAL::Quadtree_mesh_2::Balance;
using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::Node_index;
using CGAL::Quadtree_mesh_2::Point_rank;
using Tree = CGAL::Distributed_quadtree_2<Traits>;
using Whole_tree = CGAL::Balanced_quadtree<Traits>;

int rank() {
  int number = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &number);
  return number;
}
int ranks() {
  int number = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &number);
  return number;
}

std::vector<std::int64_t> gathered(std::int64_t value) {
  std::vector<std::int64_t> all(static_cast<std::size_t>(ranks()));
  MPI_Allgather(&value, 1, MPI_INT64_T, all.data(), 1, MPI_INT64_T, MPI_COMM_WORLD);
  return all;
}

int wrong_leaves(const Whole_tree& whole, const Tree& tree) {
  int wrong = 0;
  for (std::size_t l = 0; l < tree.number_of_leaves(); ++l) {
    const Leaf_index number(static_cast<std::size_t>(tree.first_leaf()) + l);
    wrong += tree.square(l) != whole.square(number) || tree.corners(l) != whole.corners(number);
    const auto points = tree.points(l);
    wrong += points.size() != whole.points(number).size() ||
             (points.size() > 0 && tree.first_point() + static_cast<std::int64_t>(points.begin) !=
                                       whole.points(number).begin.value());
  }
  return wrong;
}

int wrong_points(const Whole_tree& whole, const Tree& tree, const Points& points) {
  int wrong = 0;
  for (std::size_t i = 0; i < tree.number_of_points(); ++i) {
    const Point_rank r(static_cast<std::size_t>(tree.first_point()) + i);
    wrong += tree.grid_point(i) != whole.framework().grid_point(r) ||
             tree.input_index(i) != whole.framework().input_point(r).value() ||
             tree.point(i) != points[static_cast<std::size_t>(tree.input_index(i))];
  }
  return wrong;
}

int wrong_ghosts(const Whole_tree& whole, const Tree& tree) {
  const std::vector<std::int64_t> firsts = gathered(tree.first_leaf());
  const std::int64_t begin = tree.first_leaf(),
                     end = begin + static_cast<std::int64_t>(tree.number_of_leaves());
  std::set<std::int64_t> expected;
  for (std::int64_t l = begin; l < end; ++l)
    for (const Leaf_index n : whole.neighbors(Leaf_index(l)))
      if (n.value() < begin || n.value() >= end) expected.insert(n.value());
  int wrong = 0;
  std::int64_t last = -1;
  for (const Tree::Ghost_leaf& ghost : tree.ghosts()) {
    wrong += ghost.number <= last || expected.erase(ghost.number) == 0;
    last = ghost.number;
    const auto behind = std::upper_bound(firsts.begin(), firsts.end(), ghost.number);
    wrong += ghost.owner != static_cast<int>(behind - firsts.begin()) - 1;
    wrong += ghost.square != whole.square(Leaf_index(ghost.number));
  }
  return wrong + static_cast<int>(expected.size());
}

int wrong_owners(const Tree& tree, const Whole_tree& whole, const Points& places) {
  const std::vector<std::int64_t> firsts = gathered(tree.first_leaf());
  int wrong = 0;
  for (const Point_2& p : places) {
    const Leaf_index leaf = whole.locate(p);
    if (!leaf.is_valid()) {
      wrong += tree.owner(p) != -1;
      continue;
    }
    const auto behind = std::upper_bound(firsts.begin(), firsts.end(), std::int64_t(leaf.value()));
    wrong += tree.owner(p) != static_cast<int>(behind - firsts.begin()) - 1;
    if (tree.is_local(p))
      wrong += tree.first_leaf() + static_cast<std::int64_t>(tree.locate(p)) != leaf.value();
  }
  return wrong;
}

void check_same(const Points& points, Cuts cuts, const Quadtree_options& options) {
  const Whole_tree whole(points, options);
  const Tree tree(MPI_COMM_WORLD, slice(points, cuts, rank(), ranks()), options);
  CHECK(tree.number_of_all_leaves() == static_cast<std::int64_t>(whole.number_of_leaves()));
  CHECK(tree.number_of_all_points() == static_cast<std::int64_t>(whole.framework().number_of_points()));
  CHECK(tree.number_of_input_points() == static_cast<std::int64_t>(points.size()));
  CHECK(tree.depth() == whole.depth());
  CHECK(wrong_leaves(whole, tree) == 0);
  CHECK(wrong_points(whole, tree, points) == 0);
  if (options.balance() != Balance::NONE) CHECK(wrong_ghosts(whole, tree) == 0);
  Points places = points;
  for (int i = -3; i < 12; ++i) places.emplace_back(whole.corners(whole.root())[0].x() + i * 0.37, i * 0.21);
  CHECK(wrong_owners(tree, whole, places) == 0);
  std::int64_t duplicates = 0;
  for (const std::int64_t n : gathered(static_cast<std::int64_t>(tree.duplicates().size()))) duplicates += n;
  CHECK(duplicates == static_cast<std::int64_t>(whole.framework().duplicates().size()));
}

} // namespace

TEST_CASE("ranks have the leaves of one tree: small inputs", "[distributed]") {
  const Cuts cuts = GENERATE(Cuts::EVEN, Cuts::ALL_AT_THE_LAST, Cuts::RANDOM);
  Balance other = Balance::SIDES; // or none, in turn
  for (const Named_points& input : small_inputs()) {
    INFO(input.name);
    for (const std::size_t most : {1u, 3u}) {
      check_same(input.points, cuts, Quadtree_options().max_points_per_leaf(most));
      for (const Balance balance : {Balance::SIDES, Balance::NONE})
        if (balance == other || cuts == Cuts::EVEN || is_full_run())
          check_same(input.points, cuts, Quadtree_options().max_points_per_leaf(most).balance(balance));
      other = other == Balance::SIDES ? Balance::NONE : Balance::SIDES;
    }
  }
}

TEST_CASE("ranks have the leaves of one tree: below the levels of p4est", "[distributed]") {
  for (unsigned seed = 0; seed < (is_full_run() ? 8 : 3); ++seed) {
    const Points pairs = shuffled(deep_pairs(seed), seed), cluster = shuffled(deep_cluster(60, seed), seed);
    for (const Balance balance : {Balance::SIDES_AND_CORNERS, Balance::SIDES, Balance::NONE}) {
      check_same(pairs, Cuts::EVEN, Quadtree_options().balance(balance));
      check_same(cluster, Cuts::EVEN, Quadtree_options().balance(balance).max_points_per_leaf(1 + seed % 3));
    }
  }
}

TEST_CASE("ranks have the leaves of one tree: many points, maps", "[distributed]") {
  check_same(quadtree_test::make_points<Traits>(quadtree_test::uniform(20000, 6)), Cuts::EVEN,
             Quadtree_options());
  check_same(quadtree_test::make_points<Traits>(quadtree_test::uniform(is_full_run() ? 20000 : 9000, 7)),
             Cuts::RANDOM, Quadtree_options().max_points_per_leaf(64));
  for (const char* const name : {"us_states_10m.poly.gz", "syn_holes_400.poly.gz", "hard_tips_of_legs.poly"})
    check_same(vertices_of(name), Cuts::EVEN, Quadtree_options());
}

TEST_CASE("leaves and points are about as many at each rank", "[distributed]") {
  const Points points = quadtree_test::make_points<Traits>(quadtree_test::uniform(20000, 8));
  const Tree tree(MPI_COMM_WORLD, slice(points, Cuts::ALL_AT_THE_LAST, rank(), ranks()));
  const auto all = static_cast<std::size_t>(tree.number_of_all_leaves() + tree.number_of_all_points());
  CHECK(tree.number_of_leaves() + tree.number_of_points() <= all / static_cast<std::size_t>(ranks()) + 20);
}

TEST_CASE("ranks have the squares of the framework of one tree", "[distributed]") {
  for (const Points& points : {shuffled(deep_pairs(1), 1), vertices_of("syn_holes_400.poly.gz"), Points()}) {
    const Whole_tree whole(points);
    Tree tree(MPI_COMM_WORLD, slice(points, Cuts::EVEN, rank(), ranks()));
    const std::vector<Tree::Framework_square> squares = tree.framework();
    std::int64_t first = 0;
    const std::vector<std::int64_t> counts = gathered(static_cast<std::int64_t>(squares.size()));
    for (int r = 0; r < rank(); ++r) first += counts[static_cast<std::size_t>(r)];
    int wrong = 0;
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const Node_index v(static_cast<std::size_t>(first) + i);
      wrong += squares[i].square != whole.framework().square(v) ||
               squares[i].end != whole.framework().points(v).end.value();
    }
    CHECK(wrong == 0);
    if (rank() == ranks() - 1)
      CHECK(static_cast<std::size_t>(first) + squares.size() == whole.framework().number_of_nodes());
  }
}

TEST_CASE("all ranks tell of bad points, and then go on", "[distributed]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Cuts cuts = GENERATE(Cuts::EVEN, Cuts::ALL_AT_THE_LAST, Cuts::RANDOM);
  const Points good = quadtree_test::make_points<Traits>(quadtree_test::uniform(40, 1));
  Points points = good;
  SECTION("not finite, at one rank") { points[33] = Point_2(0, nan); }
  SECTION("not finite, at several ranks") {
    points[38] = Point_2(0, nan), points[19] = Point_2(inf, 0), points[3] = Point_2(0, -inf);
  }
  SECTION("indistinguishable, at one rank") {
    points[2] = Point_2(0x1p-300, 0), points[3] = Point_2(0x1p-301, 0);
  }
  SECTION("indistinguishable, at two ranks") {
    points[2] = Point_2(0x1p-300, 0), points[39] = Point_2(0x1p-301, 0);
  }
  SECTION("both") {
    points[2] = Point_2(0x1p-300, 0), points[3] = Point_2(0x1p-301, 0), points[39] = Point_2(0, nan);
  }
  std::string expected, told;
  try {
    Whole_tree whole(points);
  } catch (const CGAL::Quadtree_mesh_2::Point_error& error) {
    expected = error.what();
  }
  try {
    Tree tree(MPI_COMM_WORLD, slice(points, cuts, rank(), ranks()));
  } catch (const CGAL::Quadtree_mesh_2::Distributed_point_error& error) {
    told = error.what();
  }
  CHECK(!expected.empty());
  CHECK(told == expected);
  check_same(good, cuts, Quadtree_options());
}

} // namespace test_distributed_quadtree_2
