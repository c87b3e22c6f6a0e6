// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The pieces of segments in the leaves of quadtrees: by walking, by centroid trees and by brute force.

#include "catch.h"
#include "edge_pieces_brute_force.h"
#include "quadtree_rounds.h"
#include "quadtree_test_inputs.h"
#include "random_pslg_shapes.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Centroid_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Edge_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/subdivide_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/walk_edges.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_edge_pieces {

using namespace edge_pieces_test;
using namespace quadtree_test;
using CGAL::Balanced_quadtree;
using CGAL::Quadtree_options;
using CGAL::Quadtree_mesh_2::Balance;
using CGAL::Quadtree_mesh_2::Vertex_index;
using CGAL::Quadtree_mesh_2::internal::all_leaves;
using CGAL::Quadtree_mesh_2::internal::Centroid_node;
using CGAL::Quadtree_mesh_2::internal::centroid_tree;
using CGAL::Quadtree_mesh_2::internal::Centroid_tree;
using CGAL::Quadtree_mesh_2::internal::Edge_piece;
using CGAL::Quadtree_mesh_2::internal::Leaf_pieces;
using CGAL::Quadtree_mesh_2::internal::subdivide_edges;
using CGAL::Quadtree_mesh_2::internal::Subdivision_rounds;
using CGAL::Quadtree_mesh_2::internal::walk_edges;

namespace {

using Segments = std::vector<std::array<Vertex_index, 2>>;

/// Segments between points that may cross: for the pieces of one the others do not matter.
struct Case {
  Input input;
  Segments segments;
};

void add(Segments& segments, std::size_t a, std::size_t b) {
  segments.push_back({{Vertex_index(a), Vertex_index(b)}});
}

/// Each point with some others, among them itself.
Case with_random_segments(const Input& input, std::uint64_t seed) {
  random_pslg::Random random(seed);
  Case c{input, {}};
  const int n = static_cast<int>(input.points.size());
  for (int i = 0; i < std::min(n, 40); ++i)
    add(c.segments, std::size_t(random.integer(0, n - 1)), std::size_t(random.integer(0, n - 1)));
  if (n > 0) add(c.segments, 0, 0);
  return c;
}

/// Maps a graph to raw points.
Case with_segments_of(const random_pslg::Pslg& pslg, const std::string& name) {
  Case c{{name, {}}, pslg.segments};
  double most = 1e-300;
  for (const auto& p : pslg.vertices) most = std::max({most, std::abs(p.x()), std::abs(p.y())});
  const auto raw = [most](double v) { return static_cast<std::uint64_t>(std::ldexp(v / most + 1, 60)); };
  for (const auto& p : pslg.vertices) c.input.points.push_back({raw(p.x()), raw(p.y())});
  return c;
}

/// A fan along sides, diagonals and everything between, around the middle of the root or of other squares.
Case fan(std::uint64_t x, std::uint64_t y, std::uint64_t radius) {
  Case c{{"fan", {{x, y}}}, {}};
  const auto shifted = [radius](std::uint64_t center, double factor) {
    return static_cast<std::uint64_t>(
        static_cast<std::int64_t>(center) +
        static_cast<std::int64_t>(std::llround(factor * static_cast<double>(radius))));
  };
  for (int i = 0; i < 360; ++i) {
    const double angle = i * CGAL_PI / 180;
    c.input.points.push_back({shifted(x, std::cos(angle)), shifted(y, std::sin(angle))});
    add(c.segments, i % 2 == 0 ? 0 : std::size_t(i + 1), i % 2 == 0 ? std::size_t(i + 1) : 0);
  }
  return c;
}

/// All pairs of points of a lattice whose lines are sides of squares: along sides and through corners.
Case all_pairs(int n, int log_spacing) {
  Case c{{"all pairs", {}}, {}};
  for (int i = 0; i < n * n; ++i)
    c.input.points.push_back(
        {std::uint64_t(i / n + 1) << log_spacing, std::uint64_t(i % n + 1) << log_spacing});
  for (int i = 0; i < n * n; ++i)
    for (int j = 0; j < n * n; ++j) add(c.segments, std::size_t(i), std::size_t(j));
  return c;
}

std::vector<Case> nasty_cases() {
  std::vector<Case> cases;
  for (const Input& input : all_inputs())
    if (input.points.size() <= 400) cases.push_back(with_random_segments(input, 1));
  const std::uint64_t one = 1;
  cases.push_back(fan(one << 61, one << 61, one << 60));
  cases.push_back(fan(one << 60, one << 60, one << 59));
  cases.push_back(fan((one << 61) + 12345678901, (one << 61) - 98765432109, one << 59));
  cases.push_back(all_pairs(4, 59));
  cases.push_back(all_pairs(3, 60));
  return cases;
}

std::vector<Case> random_cases(std::uint64_t seeds, std::size_t most_segments) {
  std::vector<Case> cases;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      Case c = with_segments_of(family.make(seed), family.name);
      if (c.segments.size() > most_segments) c.segments.resize(most_segments);
      cases.push_back(c);
    }
  return cases;
}

/// Splits every third leaf with a piece, some times.
template <class Tree>
void refine(Tree& tree, const Segments& segments, int times, std::size_t most_leaves) {
  for (; times > 0 && tree.number_of_leaves() < most_leaves; --times) {
    const Edge_pieces pieces = walk_edges<CGAL::Sequential_tag>(tree, segments);
    std::vector<Leaf_index> split;
    for (std::size_t i = 0; i < pieces.size(); i += 3)
      if (tree.level(pieces.leaf(i)) < tree.framework().grid().depth()) split.push_back(pieces.leaf(i));
    tree.refine(split);
  }
}

/// Calls `f(tree, segments)` for a case with trees of several kinds.
template <class Traits, class F>
void for_each_tree(const Case& c, std::size_t most_leaves, const F& f) {
  const auto points = make_points<Traits>(c.input);
  for (const Balance balance : {Balance::SIDES_AND_CORNERS, Balance::SIDES, Balance::NONE}) {
    Balanced_quadtree<Traits> tree(points, Quadtree_options().balance(balance));
    CAPTURE(c.input.name, static_cast<int>(balance), tree.number_of_leaves());
    f(tree, c.segments);
    if (balance == Balance::NONE) continue;
    refine(tree, c.segments, 3, most_leaves);
    f(tree, c.segments);
  }
}

template <class Traits>
void check_by_brute_force(const std::vector<Case>& cases, std::size_t most_pairs) {
  for (const Case& c : cases)
    for_each_tree<Traits>(c, 200, [&](const auto& tree, const Segments& all) {
      Segments segments = all;
      if (segments.size() * tree.number_of_leaves() > most_pairs)
        segments.resize(most_pairs / tree.number_of_leaves() + 1);
      const Edge_pieces walked = walk_edges<CGAL::Sequential_tag>(tree, segments);
      REQUIRE(walked == pieces_by_brute_force(tree, segments));
    });
}

/// Whether a leaf is in a square.
template <class Tree>
bool is_in(const Tree& tree, Leaf_index l, const typename Tree::Square& square) {
  const auto leaf = tree.square(l);
  return leaf.level >= square.level &&
         CGAL::Quadtree_mesh_2::internal::corner_of_square(typename Tree::Grid_point{leaf.x, leaf.y},
                                                           square.level, tree.framework().grid().depth()) ==
             typename Tree::Grid_point{square.x, square.y};
}

/// Checks the tree of a part: that leaves are on the right side of every split, and that no split has too many
/// on either side. Returns the leaves below a node, in order.
template <class Tree>
std::vector<Leaf_index> check_centroids(const Tree& tree, const Centroid_tree<typename Tree::Word>& centroids,
                                        Centroid_node v, const typename Tree::Square& square,
                                        int height_left) {
  REQUIRE(height_left >= 0);
  if (v.is_leaf()) {
    REQUIRE(is_in(tree, v.leaf(), square));
    return {v.leaf()};
  }
  const auto& split = centroids.split(v);
  std::vector<Leaf_index> all = check_centroids(tree, centroids, split.outside, square, height_left - 1);
  REQUIRE(std::none_of(all.begin(), all.end(), [&](Leaf_index l) { return is_in(tree, l, split.square); }));
  const std::vector<Leaf_index> inside =
      check_centroids(tree, centroids, split.inside, split.square, height_left - 1);
  all.insert(all.end(), inside.begin(), inside.end());
  REQUIRE(5 * inside.size() > all.size());
  REQUIRE(5 * inside.size() <= 4 * all.size());
  return all;
}

/// Whether two centroid trees have the same splits below their nodes.
template <class Word>
bool are_equal(const Centroid_tree<Word>& a, Centroid_node v, const Centroid_tree<Word>& b, Centroid_node w) {
  if (v.is_leaf() || w.is_leaf()) return v.is_leaf() && w.is_leaf() && v.leaf() == w.leaf();
  const auto &s = a.split(v), &t = b.split(w);
  return s.square.x == t.square.x && s.square.y == t.square.y && s.square.level == t.square.level &&
         are_equal(a, s.inside, b, t.inside) && are_equal(a, s.outside, b, t.outside);
}

/// Two points next to each other, deep in the tree in the middle of the shuffle order: squares with half of the leaves
/// are many levels above the leaf in the middle.
Case deep_in_the_middle() {
  const std::uint64_t middle = 0x1555555555555555;
  return {{"deep in the middle", {{middle, middle}, {middle + 2, middle}}}, {}};
}

template <class Tree>
void check_centroid_tree(const Tree& tree, std::size_t leaves_per_part) {
  const auto centroids = centroid_tree<CGAL::Sequential_tag>(tree, leaves_per_part);
  const bool has_parts = leaves_per_part < tree.number_of_leaves();
  REQUIRE((centroids.parts().size() > 1) == has_parts);
  std::vector<Leaf_index> all;
  for (const auto& part : centroids.parts()) {
    const auto leaves = check_centroids(tree, centroids, part.root, part.square, centroids.height());
    REQUIRE(leaves.size() <= leaves_per_part);
    REQUIRE((!has_parts || 5 * leaves.size() > leaves_per_part));
    all.insert(all.end(), leaves.begin(), leaves.end());
  }
  REQUIRE(all.size() == tree.number_of_leaves());
  std::sort(all.begin(), all.end());
  REQUIRE(std::unique(all.begin(), all.end()) == all.end());
  REQUIRE(centroids.height() <=
          Centroid_tree<std::uint32_t>::height_bound(std::min(leaves_per_part, tree.number_of_leaves())));
}

/// Checks all ways to subdivide against walking.
template <class Tree>
void check_subdivisions(const Tree& tree, const Segments& segments) {
  const Edge_pieces walked = walk_edges<CGAL::Sequential_tag>(tree, segments);
  REQUIRE(subdivide_edges<CGAL::Sequential_tag>(tree, segments) == walked);
  for (const std::size_t leaves_per_part : {std::size_t(1), std::size_t(10), all_leaves}) {
    if (leaves_per_part < 10 && tree.number_of_leaves() * segments.size() > 20000) continue; // too many pairs
    const auto centroids = centroid_tree<CGAL::Sequential_tag>(tree, leaves_per_part);
    REQUIRE(subdivide_edges<CGAL::Sequential_tag>(tree, centroids, segments) == walked);
  }
}

template <class Traits>
void check_subdivisions(const std::vector<Case>& cases, std::size_t most_leaves) {
  for (const Case& c : cases)
    for_each_tree<Traits>(c, most_leaves, [](const auto& tree, const Segments& segments) {
      check_subdivisions(tree, segments);
    });
}

} // namespace

TEST_CASE("centroid trees split evenly and hold all leaves", "[edge_pieces]") {
  for (const Case& c : nasty_cases())
    for_each_tree<Filtered_traits>(c, 1000, [](const auto& tree, const Segments&) {
      for (const std::size_t leaves_per_part : {std::size_t(1), std::size_t(7), std::size_t(100)})
        check_centroid_tree(tree, leaves_per_part);
      check_centroid_tree(tree, all_leaves);
    });
  for_each_tree<Fixed_64_traits>(deep_in_the_middle(), 1000, [](const auto& tree, const Segments&) {
    REQUIRE(tree.depth() >= 55);
    check_centroid_tree(tree, all_leaves);
    check_centroid_tree(tree, 50);
  });
}

TEST_CASE("centroid trees take logarithmically many steps", "[edge_pieces]") {
  for (std::size_t n = 256; n <= (is_full_run() ? 262144u : 65536u); n *= 4) {
    const Balanced_quadtree<Fixed_64_traits> tree(make_points<Fixed_64_traits>(uniform(n, 1)));
    for (const std::size_t leaves_per_part : {all_leaves, 5 * n, 5 * n / 16}) {
      const std::size_t steps =
          Round_counter::instance().count([&] { centroid_tree<Counted_tag>(tree, leaves_per_part); }).steps;
      const double log_k = std::log2(static_cast<double>(tree.number_of_leaves()));
      CAPTURE(n, tree.number_of_leaves(), leaves_per_part, steps);
      CHECK(static_cast<double>(steps) <= 10 * log_k);
    }
  }
}

TEST_CASE("pieces by centroid trees are those by walking", "[edge_pieces]") {
  const std::size_t most_segments = is_full_run() ? 300 : 80;
  check_subdivisions<Filtered_traits>(nasty_cases(), is_full_run() ? 1000 : 500);
  check_subdivisions<Fixed_32_traits>(random_cases(1, most_segments), 1000);
  check_subdivisions<Fixed_64_traits>(random_cases(1, most_segments), 1000);
  check_subdivisions<Exact_traits>(random_cases(1, 20), 200);
}

TEST_CASE("pieces by centroid trees are those by walking: sweep", "[edge_pieces][.slow]") {
  check_subdivisions<Filtered_traits>(random_cases(100, 1000), 20000);
  check_subdivisions<Fixed_32_traits>(nasty_cases(), 20000);
  check_subdivisions<Exact_traits>(nasty_cases(), 500);
}

TEST_CASE("subdivision takes logarithmically many rounds", "[edge_pieces]") {
  for (std::size_t n = 4; n <= 4096; n *= 4) {
    const Case c = with_random_segments(uniform(n, 1), 1);
    Segments segments = c.segments;
    for (std::size_t i = 0; i + 1 < n; ++i) add(segments, i, i + 1);
    segments.resize(n);
    Balanced_quadtree<Filtered_traits> tree(make_points<Filtered_traits>(c.input));
    Subdivision_rounds rounds;
    const Edge_pieces pieces = subdivide_edges<CGAL::Sequential_tag>(tree, segments, &rounds);
    const double log_n = std::log2(static_cast<double>(n));
    CAPTURE(n, tree.number_of_leaves(), pieces.size(), rounds.parts, rounds.height, rounds.rounds);
    CHECK(rounds.parts <= 1 + tree.number_of_leaves() / n);
    CHECK(rounds.height <= 2 * log_n + 5);
    CHECK(rounds.rounds <= static_cast<std::size_t>(rounds.height) + 2);
    CHECK(rounds.tests_of_largest_round <= pieces.size() + rounds.parts * n);
  }
}

TEST_CASE("pieces by walking are those of brute force", "[edge_pieces]") {
  const bool is_large = is_full_run();
  check_by_brute_force<Filtered_traits>(nasty_cases(), is_large ? 1000 : 300);
  check_by_brute_force<Fixed_64_traits>(nasty_cases(), is_large ? 400 : 200);
  check_by_brute_force<Fixed_32_traits>(random_cases(1, is_large ? 50 : 20), 400);
  check_by_brute_force<Exact_traits>(random_cases(1, is_large ? 50 : 20), 200);
}

TEST_CASE("pieces by walking are those of brute force: sweep", "[edge_pieces][.slow]") {
  check_by_brute_force<Filtered_traits>(nasty_cases(), 200000);
  check_by_brute_force<Filtered_traits>(random_cases(10, 1000), 20000);
  check_by_brute_force<Fixed_32_traits>(nasty_cases(), 20000);
  check_by_brute_force<Exact_traits>(nasty_cases(), 10000);
}

TEST_CASE("pieces of no segments", "[edge_pieces]") {
  const Balanced_quadtree<Filtered_traits> empty;
  const Edge_pieces pieces = walk_edges<CGAL::Sequential_tag>(empty, Segments());
  REQUIRE(pieces.size() == 0);
  REQUIRE(pieces.number_of_segments() == 0);
  const Leaf_pieces by_leaf = Leaf_pieces::of<CGAL::Sequential_tag>(pieces, empty.number_of_leaves());
  REQUIRE(by_leaf[Leaf_index(0)].empty());
}

TEST_CASE("a segment in the only leaf", "[edge_pieces]") {
  const Balanced_quadtree<Filtered_traits> tree(
      make_points<Filtered_traits>({"two points", {{0, 0}, {1u << 31, 0}}}),
      Quadtree_options().max_points_per_leaf(2));
  Segments segments;
  add(segments, 1, 0);
  add(segments, 1, 1);
  REQUIRE(walk_edges<CGAL::Sequential_tag>(tree, segments) ==
          Edge_pieces({0, 1, 2}, {tree.leaf(CGAL::Quadtree_mesh_2::Point_index(0)),
                                  tree.leaf(CGAL::Quadtree_mesh_2::Point_index(0))}));
}

TEST_CASE("pieces by leaf are the same pieces", "[edge_pieces]") {
  for (const Case& c : nasty_cases())
    for_each_tree<Filtered_traits>(c, 2000, [](const auto& tree, const Segments& segments) {
      const Edge_pieces pieces = walk_edges<CGAL::Sequential_tag>(tree, segments);
      const Leaf_pieces by_leaf = Leaf_pieces::of<CGAL::Sequential_tag>(pieces, tree.number_of_leaves());
      std::vector<std::vector<Edge_piece>> expected(tree.number_of_leaves());
      for (std::size_t s = 0; s < segments.size(); ++s)
        for (std::size_t i = 0; i < pieces[Segment_index(s)].size(); ++i)
          expected[std::size_t(pieces[Segment_index(s)][i])].push_back(
              {Segment_index(s), static_cast<std::uint32_t>(i)});
      REQUIRE(by_leaf.size() == pieces.size());
      for (std::size_t l = 0; l < expected.size(); ++l) {
        const auto range = by_leaf[Leaf_index(l)];
        REQUIRE(std::vector<Edge_piece>(range.begin(), range.end()) == expected[l]);
      }
    });
}

TEST_CASE("pieces are the same for any number of threads", "[edge_pieces]") {
#ifdef CGAL_LINKED_WITH_TBB
  const Case c = with_random_segments(uniform(10000, 7), 3);
  Case many = c;
  for (std::size_t i = 0; i + 1 < c.input.points.size(); ++i) add(many.segments, i, i + 1);
  many.segments.resize(1000);
  const Balanced_quadtree<Fixed_64_traits> tree(make_points<Fixed_64_traits>(c.input));
  const Edge_pieces expected = walk_edges<CGAL::Sequential_tag>(tree, many.segments);
  for (const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    REQUIRE(walk_edges<CGAL::Parallel_tag>(tree, many.segments) == expected);
    REQUIRE(subdivide_edges<CGAL::Parallel_tag>(tree, many.segments) == expected);
    const auto all = centroid_tree<CGAL::Parallel_tag>(tree, all_leaves);
    REQUIRE(tree.number_of_leaves() > 20000); // more than a block
    const auto by_one = centroid_tree<CGAL::Sequential_tag>(tree, all_leaves);
    REQUIRE(all.height() == by_one.height());
    REQUIRE(are_equal(all, all.parts()[0].root, by_one, by_one.parts()[0].root));
    REQUIRE(subdivide_edges<CGAL::Parallel_tag>(tree, all, many.segments) == expected);
  }
#endif
}

} // namespace test_edge_pieces
