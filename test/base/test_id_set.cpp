// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Id_set.h>

#include <cstddef>
#include <set>

namespace test_id_set {

using Leaf = CGAL::Quadtree_mesh_2::Leaf_index;
using Set = CGAL::Quadtree_mesh_2::internal::Id_set<Leaf>;

TEST_CASE("A set of handles has what was added and not removed", "[id_set]") {
  constexpr std::size_t n = 300;
  Set set(n);
  std::set<std::size_t> expected;
  for (std::size_t i = 0; i < n; i += 7) set.add(Leaf(i)), expected.insert(i);
  for (std::size_t i = 0; i < n; i += 21) set.remove(Leaf(i)), expected.erase(i);
  for (std::size_t i = 0; i < n; ++i) CHECK(set.has(Leaf(i)) == (expected.count(i) == 1));
}

TEST_CASE("A range of handles is added without its end", "[id_set]") {
  constexpr std::size_t n = 260;
  for (const std::size_t begin : {0, 1, 63, 64, 65, 127, 128, 200})
    for (const std::size_t end : {0, 1, 63, 64, 65, 128, 192, 199, 259}) {
      Set set(n);
      set.add(Leaf(begin), Leaf(end));
      bool is_range = true;
      for (std::size_t i = 0; i < n; ++i) is_range = is_range && set.has(Leaf(i)) == (begin <= i && i < end);
      CAPTURE(begin, end);
      CHECK(is_range);
    }
}

} // namespace test_id_set
