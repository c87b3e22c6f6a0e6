// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The corners of leaves: their names, places and leaves against the set of all corners of all leaves.

#include "catch.h"
#include "quadtree_test_inputs.h"
#include "random_pslg.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Tree_corners.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_tree_corners {

namespace {

using namespace quadtree_test;
using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::internal::Leaf_corner;
using CGAL::Quadtree_mesh_2::internal::Tree_corners;
using CGAL::Quadtree_mesh_2::internal::Word_operations;

constexpr std::array<Leaf_corner, 4> all_corners{
    {Leaf_corner::LOWER_LEFT, Leaf_corner::LOWER_RIGHT, Leaf_corner::UPPER_LEFT, Leaf_corner::UPPER_RIGHT}};

template <class Tree>
class Corner_check {
public:
  explicit Corner_check(const Tree& tree)
      : tree_(tree), corners_(tree), depth_(tree.framework().grid().depth()) {
    find_corners();
  }

  void run() {
    check_names_of_corners();
    check_corners_of_names();
    check_places_between();
    CHECK(wrong_ == 0);
  }

private:
  using Word = typename Tree::Word;
  using Grid_point = typename Tree::Grid_point;
  using Corners = Tree_corners<Tree>;
  using Name = typename Corners::Name;

  const Tree& tree_;
  Corners corners_;
  int depth_;
  std::map<std::pair<Word, Word>, std::size_t> found_; // the times that a leaf has a corner there
  std::size_t wrong_ = 0;

  void expect(bool is_right) { wrong_ += is_right ? 0 : 1; }

  Word side(int level) const { return Word_operations<Word>::power_of_two(depth_ - level); }

  Grid_point corner(Leaf_index l, Leaf_corner which) const {
    const auto s = tree_.square(l);
    const Word a = side(s.level);
    const auto i = static_cast<unsigned>(which);
    return {static_cast<Word>((i & 1) != 0 ? s.x + a : s.x), static_cast<Word>((i & 2) != 0 ? s.y + a : s.y)};
  }

  bool is_on_far_side(const Grid_point& p) const { return p.x == side(0) || p.y == side(0); }

  void find_corners() {
    for (std::size_t l = 0; l < tree_.number_of_leaves(); ++l)
      for (const Leaf_corner c : all_corners) {
        const Grid_point p = corner(Leaf_index(l), c);
        if (!is_on_far_side(p)) ++found_[{p.x, p.y}];
      }
  }

  void check_names_of_corners() {
    for (const auto& [place, times] : found_) {
      const Grid_point p{place.first, place.second};
      const Name c = corners_.name(p);
      expect(c < corners_.number_of_names() && corners_.exists(c) && corners_.place(c) == p);
      expect(times <= 4);
    }
    for (std::size_t l = 0; l < tree_.number_of_leaves(); ++l)
      for (const Leaf_corner c : all_corners) {
        const Grid_point p = corner(Leaf_index(l), c);
        const Name name = corners_.name(Leaf_index(l), c);
        expect(name == (is_on_far_side(p) ? Corners::none : corners_.name(p)));
        if (is_on_far_side(p)) expect(corners_.name(p) == Corners::none);
      }
  }

  void check_corners_of_names() {
    std::size_t number = 0;
    for (Name c = 0; c < corners_.number_of_names(); ++c) {
      if (!corners_.exists(c)) continue;
      ++number;
      const Grid_point p = corners_.place(c);
      expect(found_.count({p.x, p.y}) == 1 && corners_.name(p) == c);
      check_leaves_around(c, p);
    }
    CHECK(number == found_.size());
  }

  /// The leaf in one of the quadrants around a corner.
  Leaf_index leaf_at(const Grid_point& p, int left, int below) const {
    if ((left == 1 && p.x == 0) || (below == 1 && p.y == 0)) return Leaf_index();
    return tree_.locate(Grid_point{static_cast<Word>(p.x - static_cast<Word>(left)),
                                   static_cast<Word>(p.y - static_cast<Word>(below))});
  }

  void check_leaves_around(Name c, const Grid_point& p) {
    const auto leaves = corners_.leaves_around(c);
    int level = 0;
    for (int i = 0; i < 4; ++i) {
      const Leaf_index l = leaf_at(p, i % 2, i / 2);
      expect(leaves[std::size_t(i)].is_valid() == l.is_valid());
      if (!l.is_valid()) continue;
      expect(leaves[std::size_t(i)] == l);
      level = std::max(level, tree_.level(l));
    }
    expect(corners_.level(leaves) == level);
  }

  /// Centers of leaves and of their sides: a corner may hang in these, but nowhere else.
  void check_places_between() {
    for (std::size_t l = 0; l < tree_.number_of_leaves(); ++l) {
      const auto s = tree_.square(Leaf_index(l));
      if (s.level == depth_) continue;
      const Word h = side(s.level + 1);
      const Grid_point low{static_cast<Word>(s.x + h), s.y}, left{s.x, static_cast<Word>(s.y + h)},
          center{static_cast<Word>(s.x + h), static_cast<Word>(s.y + h)};
      expect(corners_.name(center) == Corners::none);
      for (const Grid_point& p : {low, left})
        expect((corners_.name(p) == Corners::none) == (found_.count({p.x, p.y}) == 0));
    }
  }
};

template <class Tree>
void check(const Tree& tree) {
  Corner_check<Tree>(tree).run();
}

/// Splits a quarter of the leaves.
template <class Tree>
void refine_somewhere(Tree& tree, random_pslg::Random& random) {
  std::vector<Leaf_index> leaves;
  for (std::size_t l = 0; l < tree.number_of_leaves(); ++l)
    if (random.integer(0, 3) == 0 && tree.level(Leaf_index(l)) < tree.framework().grid().depth())
      leaves.push_back(Leaf_index(l));
  tree.refine(leaves);
}

} // namespace

TEMPLATE_TEST_CASE("Corners of leaves by name and by place", "[quadtree][trees]", Filtered_traits,
                   Fixed_32_traits, Fixed_64_traits, Exact_traits) {
  for (const Input& input : all_inputs()) {
    CAPTURE(input.name);
    check(CGAL::Balanced_quadtree<TestType>(make_points<TestType>(input)));
  }
}

TEMPLATE_TEST_CASE("Corners of leaves of random quadtrees", "[quadtree][trees]", Fixed_32_traits,
                   Exact_traits) {
  const unsigned seeds = is_full_run() ? 300 : std::is_same_v<TestType, Exact_traits> ? 4 : 12;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    random_pslg::Random random(seed);
    CGAL::Balanced_quadtree<TestType> tree(make_points<TestType>(small_random(seed)));
    for (int round = 0; round < 3 && tree.number_of_leaves() < 3000; ++round) {
      refine_somewhere(tree, random);
      check(tree);
    }
  }
}

TEST_CASE("Corners of the smallest leaves", "[quadtree][trees]") {
  // Neighbors on the grid: leaves of one unit.
  std::vector<Fixed_32_traits::Point_2> points;
  for (std::uint32_t i = 0; i < 3; ++i)
    for (std::uint32_t j = 0; j < 3; ++j) points.push_back({i, j});
  CGAL::Balanced_quadtree<Fixed_32_traits> tree(points);
  CHECK(tree.depth() == tree.framework().grid().depth());
  check(tree);
}

TEST_CASE("The root has one corner", "[quadtree][trees]") {
  const CGAL::Balanced_quadtree<Fixed_32_traits> tree;
  const Tree_corners<CGAL::Balanced_quadtree<Fixed_32_traits>> corners(tree);
  CHECK(corners.exists(0));
  CHECK_FALSE(corners.exists(1));
  CHECK_FALSE(corners.exists(2));
  const auto leaves = corners.leaves_around(0);
  CHECK(leaves[0] == Leaf_index(0));
  for (std::size_t i = 1; i < 4; ++i) CHECK_FALSE(leaves[i].is_valid());
}

} // namespace test_tree_corners
