// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Theorem 2 without additional squares: the quadtree by spaced levels is the smallest one, numbers and pointers
// included, in O(log n) rounds whatever the depth.

#include "catch.h"
#include "quadtree_checks.h"
#include "quadtree_rounds.h"
#include "quadtree_test_inputs.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Long_words.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Required_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/closed_forced_directions.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/combine_points_of_nodes.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/forcing.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <set>
#include <vector>

namespace test_spaced_levels {

using namespace quadtree_test;
using CGAL::Quadtree_options;
using CGAL::Sequential_tag;
using CGAL::Quadtree_mesh_2::Balance_schedule;
using CGAL::Quadtree_mesh_2::internal::Long_word;
namespace internal = CGAL::Quadtree_mesh_2::internal;

namespace {

constexpr std::array<Balance, 2> balances{{Balance::SIDES, Balance::SIDES_AND_CORNERS}};

/// Grid points of any length as points, on a grid of given depth.
class Deep_traits {
public:
  using Word = Long_word;
  using Grid_point = CGAL::Quadtree_mesh_2::Grid_point_2<Word>;
  struct Point_2 {
    Word x, y;
    friend bool operator==(const Point_2& p, const Point_2& q) { return p.x == q.x && p.y == q.y; }
  };
  struct Grid_2 {
    int depth_of_grid = 1;
    int depth() const { return depth_of_grid; }
    bool refine() { return false; }
    bool is_in_root(const Point_2& p) const { return (p.x >> depth()) == 0 && (p.y >> depth()) == 0; }
    Grid_point grid_point(const Point_2& p) const { return {p.x, p.y}; }
    Point_2 point(const Grid_point& p) const { return {p.x, p.y}; }
  };
  struct Construct_grid_2 {
    int depth;
    template <class PointRange>
    Grid_2 operator()(const PointRange&) const {
      return {depth};
    }
  };

  explicit Deep_traits(int depth = 1) : depth_(depth) {}
  Construct_grid_2 construct_grid_2_object() const { return {depth_}; }

private:
  int depth_;
};

/// Points around the middle of the root, from nearly its size down to 2^-depth of it.
std::vector<Deep_traits::Point_2> deep_spiral(std::size_t n, int depth) {
  constexpr int digits = 28;
  const Long_word center = Long_word(1) << (depth + digits + 1);
  std::vector<Deep_traits::Point_2> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double exponent = depth * static_cast<double>(n - 1 - i) / static_cast<double>(n);
    const int shift = static_cast<int>(exponent);
    const double radius = std::exp2(exponent - shift + digits - 1), angle = 0.7 * static_cast<double>(i);
    const auto coordinate = [&](double c) {
      const Long_word distance = Long_word(std::llround(std::fabs(radius * c))) << shift;
      return c < 0 ? Long_word(center - distance) : Long_word(center + distance);
    };
    points.push_back({coordinate(std::cos(angle)), coordinate(std::sin(angle))});
  }
  return points;
}

CGAL::Quadtree_framework<Deep_traits, Counted_tag> deep_framework(std::size_t n, int depth) {
  return CGAL::Quadtree_framework<Deep_traits, Counted_tag>(deep_spiral(n, depth), Deep_traits(depth + 30));
}

/// Pairs of which most are far from all others, the nearer to each other the later they come.
Input isolated_pairs() {
  std::mt19937_64 random(9);
  Input input{"isolated pairs", {}};
  for (int i = 0; i < 40; ++i) {
    const Raw_point p{random() >> 2, random() >> 2};
    input.points.push_back(p);
    input.points.push_back({p.x ^ std::uint64_t(8) << i, p.y ^ (random() & 7) << i});
  }
  return input;
}

/// Clusters in clusters, each 2^-9 as large as the one around it.
Input nested_clusters() {
  std::mt19937_64 random(10);
  Input input{"nested clusters", {}};
  std::uint64_t x = random() >> 3, y = random() >> 3;
  for (int level = 1; level < 6; ++level) {
    const int shift = 9 * level + 2;
    for (int i = 0; i < 25; ++i) input.points.push_back({x + (random() >> shift), y + (random() >> shift)});
    x += random() >> shift;
    y += random() >> shift;
  }
  return input;
}

std::vector<Input> inputs() {
  std::vector<Input> all = all_inputs();
  all.push_back(isolated_pairs());
  all.push_back(nested_clusters());
  all.push_back(
      uniform(is_full_run() ? 20000 : 10000, 6)); // framework squares and lists of more than a block
  for (unsigned seed = 0; seed < (is_full_run() ? 2000 : 100); ++seed) all.push_back(small_random(seed));
  return all;
}

std::vector<int> random_levels(std::size_t n, int depth) {
  std::mt19937_64 random(3);
  std::vector<int> levels(n);
  for (int& l : levels) l = std::min(depth, static_cast<int>(random() % 24));
  return levels;
}

template <class Framework>
void check_schedules(const Framework& framework, const Quadtree_options& options) {
  using Tree = CGAL::Balanced_quadtree<typename Framework::Traits>;
  const Tree tree(framework, options);
  check_same_quadtree(tree,
                      Tree(framework, Quadtree_options(options).schedule(Balance_schedule::SPACED_LEVELS)));
}

/// How far it is from the far side of [d, d + side) to [f, f + width); 0 if the latter contains the former.
int far_distance(int d, int side, int f, int width) {
  if (f <= d && d + side <= f + width) return 0;
  return f > d ? f - d : d + side - (f + width);
}

/// Whether a square forces another one to be split, as doc/quadtrees.md says.
bool does_force(const Key& d, const Key& f, int depth, Balance balance) {
  const int side = 1 << (depth - std::get<0>(d)), width = 1 << (depth - std::get<0>(f));
  const int x = far_distance(int(std::get<1>(d)) * side, side, int(std::get<1>(f)) * width, width);
  const int y = far_distance(int(std::get<2>(d)) * side, side, int(std::get<2>(f)) * width, width);
  return side < width && (balance == Balance::SIDES ? x + y : std::max(x, y)) < width;
}

} // namespace

TEST_CASE("A square forces those to which its far sides are nearer than their own", "[spaced]") {
  constexpr int depth = 5;
  for (Balance balance : balances)
    for (int level = 0; level <= depth; ++level)
      for (std::uint64_t x = 0; x < 1u << level; ++x)
        for (std::uint64_t y = 0; y < 1u << level; ++y) {
          const Key d{level, x, y};
          Naive_tree tree({}, [](const Key&, const std::vector<Key>&) { return false; });
          for (Key k = d;; k = parent_of(k)) {
            tree.split(k);
            if (std::get<0>(k) == 0) break;
          }
          tree.balance(balance);
          std::size_t wrong = 0;
          for (int l = 0; l <= level; ++l)
            for (std::uint64_t i = 0; i < 1u << l; ++i)
              for (std::uint64_t j = 0; j < 1u << l; ++j) {
                const Key f{l, i, j};
                wrong += tree.is_split(f) != (f == d || does_force(d, f, depth, balance)) ? 1 : 0;
              }
          CAPTURE(level, x, y);
          REQUIRE(wrong == 0);
        }
}

TEMPLATE_TEST_CASE("The closed form forces what goes up from level to level", "[spaced]", Filtered_traits,
                   Fixed_32_traits, Fixed_64_traits, Exact_traits) {
  using Framework = CGAL::Quadtree_framework<TestType>;
  for (const Input& input : inputs())
    for (std::size_t max_points : {1u, 3u}) {
      CAPTURE(input.name, max_points);
      const Framework framework(make_points<TestType>(input));
      const auto required =
          internal::Required_squares_finder<Framework, Sequential_tag>(framework, max_points).find();
      for (Balance balance : balances)
        CHECK(internal::closed_forced_directions<Sequential_tag>(framework, required, balance) ==
              internal::least_forced_directions<Sequential_tag>(required, balance));
    }
}

TEMPLATE_TEST_CASE("Spaced levels give the smallest quadtree, bit for bit", "[spaced]", Filtered_traits,
                   Fixed_32_traits, Fixed_64_traits, Exact_traits) {
  for (const Input& input : in_turn<TestType>(inputs()))
    for (std::size_t max_points : is_full_run() ? std::vector{1u, 3u} : std::vector{2u})
      for (Balance balance : balances) {
        CAPTURE(input.name, max_points, int(balance));
        const auto options = Quadtree_options().balance(balance).max_points_per_leaf(max_points);
        CGAL::Quadtree_framework<TestType> framework(make_points<TestType>(input));
        // Of the largest one each balance once, with annotations or without.
        const bool is_checked_once = framework.number_of_points() > 5000 && !is_full_run();
        if (!is_checked_once || balance != Balance::SIDES) check_schedules(framework, options);
        if (is_checked_once && balance != Balance::SIDES) continue;
        framework.annotate(random_levels(framework.number_of_points(), framework.grid().depth()));
        check_schedules(framework, options);
      }
}

TEST_CASE("Spaced levels give the smallest quadtree of any depth", "[spaced]") {
  for (const int depth : {61, 1000, 3000})
    for (const std::size_t n : {2u, 3u, 50u, 2000u})
      for (Balance balance : balances) {
        CAPTURE(depth, n, int(balance));
        const CGAL::Quadtree_framework<Deep_traits> framework(deep_spiral(n, depth), Deep_traits(depth + 30));
        check_schedules(framework, Quadtree_options().balance(balance));
      }
}

TEST_CASE("Rounds by spaced levels grow with log n and not with the depth", "[spaced]") {
  using Tree = CGAL::Balanced_quadtree<Deep_traits, Counted_tag>;
  const auto rounds = [](const Tree::Framework& framework, Balance balance, Balance_schedule schedule) {
    int depth = 0;
    const std::size_t steps =
        Round_counter::instance()
            .count([&] {
              depth = Tree(framework, Quadtree_options().balance(balance).schedule(schedule)).depth();
            })
            .steps;
    if (schedule == Balance_schedule::LEVEL_BY_LEVEL) CHECK(static_cast<int>(steps) > 5 * depth);
    return steps;
  };
  for (const std::size_t n :
       is_full_run() ? std::vector{300u, 1000u, 5000u, 20000u} : std::vector{300u, 1000u, 5000u})
    for (Balance balance : balances) {
      CAPTURE(n, int(balance));
      std::vector<std::size_t> by_depth;
      for (const int depth : {50, 400, 3000}) {
        const Tree::Framework framework = deep_framework(n, depth);
        by_depth.push_back(rounds(framework, balance, Balance_schedule::SPACED_LEVELS));
        if (depth <= 400) rounds(framework, balance, Balance_schedule::LEVEL_BY_LEVEL);
      }
      // Seven for each level of a band; two each for the merges of the tops' sort.
      CHECK(static_cast<double>(by_depth.back()) <= 12 * std::log2(double(n)) + 40);
      for (const std::size_t steps : by_depth)
        CHECK(std::abs(static_cast<int>(steps) - static_cast<int>(by_depth.back())) <= 12);
    }
}

TEST_CASE("Required squares of two points are a path of any length", "[spaced]") {
  using Framework = CGAL::Quadtree_framework<Deep_traits>;
  const int depth = 70000; // more levels than are counted at once
  const Long_word place = (Long_word(1) << depth) / 3;
  const Framework framework(std::vector<Deep_traits::Point_2>{{place, place}, {place ^ 1, place}},
                            Deep_traits(depth));
  const auto required = internal::Required_squares_finder<Framework, Sequential_tag>(framework, 1).find();
  REQUIRE(required.number_of_levels() == depth);
  REQUIRE(required.size() == static_cast<std::size_t>(depth));
  for (int level = 0; level < depth; ++level) {
    const std::size_t i = static_cast<std::size_t>(level);
    REQUIRE(required.level_begin[i] == i);
    REQUIRE(required.children[i] == (level + 1 == depth ? 0 : level % 2 == 0 ? 1u : 8u));
  }
  const auto closed =
      internal::closed_forced_directions<Sequential_tag>(framework, required, Balance::SIDES_AND_CORNERS);
  CHECK(closed == internal::least_forced_directions<Sequential_tag>(required, Balance::SIDES_AND_CORNERS));
  CHECK(internal::closed_forced_directions<Sequential_tag>(framework, required, Balance::SIDES) ==
        internal::least_forced_directions<Sequential_tag>(required, Balance::SIDES));
}

TEST_CASE("Values of points are combined in all framework squares", "[spaced]") {
  for (const Input& input : {uniform(40000, 12), spiral(), nested_clusters()}) {
    const CGAL::Quadtree_framework<Fixed_64_traits> framework(make_points<Fixed_64_traits>(input));
    std::mt19937 random(2);
    std::vector<unsigned> values(framework.number_of_points());
    for (unsigned& v : values) v = static_cast<unsigned>(random());
    const auto greatest = internal::combine_points_of_nodes<unsigned, Sequential_tag>(
        framework, [&](std::size_t p) { return values[p]; },
        [](unsigned a, unsigned b) { return std::max(a, b); });
    for (std::size_t v = 0; v < framework.number_of_nodes(); ++v) {
      const auto points = framework.points(CGAL::Quadtree_mesh_2::Node_index(v));
      REQUIRE(greatest[CGAL::Quadtree_mesh_2::Node_index(v)] ==
              *std::max_element(values.begin() + std::ptrdiff_t(points.begin.value()),
                                values.begin() + std::ptrdiff_t(points.end.value())));
    }
  }
}

} // namespace test_spaced_levels
