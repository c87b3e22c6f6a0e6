// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The leaves around a leaf, by their definition.

#include "catch.h"
#include "quadtree_inputs.h"
#include "quadtree_test_inputs.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/leaves_around.h>

#include <cstddef>
#include <cstdint>
#include <set>

namespace test_leaves_around {

using CGAL::Quadtree_mesh_2::Leaf_index;
using Tree = CGAL::Balanced_quadtree<quadtree_test::Filtered_traits>;

/// Whether a leaf is, along an axis, less than some sides of leaf l away.
bool is_around(const Tree& tree, Leaf_index l, Leaf_index other, int sides) {
  const auto side = [&tree](const Tree::Square& s) {
    return double(std::uint64_t(1) << (tree.framework().grid().depth() - s.level));
  };
  const auto s = tree.square(l), t = tree.square(other);
  const double far = sides * side(s);
  const auto is_near = [&](double a, double b) { return a < b + side(t) + far && b < a + side(s) + far; };
  return is_near(double(s.x), double(t.x)) && is_near(double(s.y), double(t.y));
}

TEST_CASE("Leaves around a leaf are all that meet a square", "[quadtree]") {
  for (const auto& points : {quadtree_inputs::uniform(40, 1), quadtree_inputs::line(30, 2),
                             quadtree_inputs::uniform(1, 3), quadtree_inputs::uniform(2, 4)}) {
    const Tree tree(points);
    for (const int sides : {1, 2, 3, 4}) {
      std::size_t wrong = 0;
      for (std::size_t l = 0; l < tree.number_of_leaves(); ++l) {
        std::set<std::size_t> found, expected;
        CGAL::Quadtree_mesh_2::internal::for_each_leaf_around(
            tree, Leaf_index(l), sides, [&](Leaf_index around) { found.insert(std::size_t(around)); });
        for (std::size_t m = 0; m < tree.number_of_leaves(); ++m)
          if (is_around(tree, Leaf_index(l), Leaf_index(m), sides)) expected.insert(m);
        wrong += found == expected ? 0 : 1;
      }
      CAPTURE(sides, tree.number_of_leaves());
      CHECK(wrong == 0);
    }
  }
}

} // namespace test_leaves_around
