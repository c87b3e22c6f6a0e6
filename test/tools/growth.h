// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_GROWTH_H
#define QUADTREE_MESH_2_TEST_GROWTH_H

#include <algorithm>
#include <cstddef>
#include <vector>

/// How what a theorem bounds grows with its input.
namespace growth {

/// Whether values for sizes that grow by 4 from one to the next, from 100 or less on, stay within a constant: those of
/// the later half are not above the earlier by more than 40 %. A logarithm of these sizes is: by 46 % and more.
/// \pre there are four values or more
inline bool is_bounded(const std::vector<double>& values) {
  constexpr double slack = 1.4;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  return *std::max_element(middle, values.end()) <= slack * *std::max_element(values.begin(), middle);
}

} // namespace growth

#endif // QUADTREE_MESH_2_TEST_GROWTH_H
