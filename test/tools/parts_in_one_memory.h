// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_PARTS_IN_ONE_MEMORY_H
#define QUADTREE_MESH_2_TEST_PARTS_IN_ONE_MEMORY_H

// Checks by all parts, which are threads. What is wrong is told as a text, so that no part ends before the others.

#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>

#include <cstddef>
#include <string>
#include <vector>

namespace parts_in_one_memory {

using CGAL::Quadtree_mesh_2::internal::In_memory_exchange;

/// Runs `check(exchange)` as each of so many parts. \returns what all say is wrong
template <class Check>
std::string wrong_at_parts(int parts, const Check& check) {
  std::vector<std::string> wrong(static_cast<std::size_t>(parts));
  In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
    wrong[static_cast<std::size_t>(exchange.rank())] = check(exchange);
  });
  std::string all;
  for (const std::string& of_part : wrong) all += of_part;
  return all;
}

} // namespace parts_in_one_memory

#endif // QUADTREE_MESH_2_TEST_PARTS_IN_ONE_MEMORY_H
