// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Values that are set for few handles, against a map.

#include "catch.h"

#include <CGAL/Quadtree_mesh_2/internal/base/Sparse_values.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_handles.h>

#include <cstddef>
#include <map>
#include <random>

namespace test_sparse_values {

using CGAL::Quadtree_mesh_2::internal::Sparse_values;
using CGAL::Quadtree_mesh_2::internal::Triangle_id;

TEST_CASE("Values that are not set are the default", "[base]") {
  const Sparse_values<Triangle_id, int> none;
  CHECK_FALSE(none.has(Triangle_id(0)));
  std::mt19937 random(7);
  for (const std::size_t n : {1u, 15u, 16u, 17u, 1000u}) {
    Sparse_values<Triangle_id, int> values(n);
    std::map<std::size_t, int> expected;
    for (std::size_t i = 0; i < n / 3; ++i) {
      const std::size_t id = random() % n;
      expected[id] = values.at(Triangle_id(id)) = static_cast<int>(i) + 1;
    }
    CHECK(values.has(Triangle_id(n - 1)));
    CHECK_FALSE(values.has(Triangle_id(n + 16)));
    std::size_t wrong = 0;
    for (std::size_t id = 0; id < n; ++id) {
      const auto found = expected.find(id);
      wrong += values[Triangle_id(id)] == (found == expected.end() ? 0 : found->second) ? 0 : 1;
    }
    CHECK(wrong == 0);
  }
}

} // namespace test_sparse_values
