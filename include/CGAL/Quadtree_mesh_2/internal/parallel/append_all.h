// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_APPEND_ALL_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_APPEND_ALL_H

#include <CGAL/Quadtree_mesh_2/internal/base/huge_pages.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Appends the values of the vectors `values_of(part)`, in the order of the parts, to a vector. O(n) work.
/// \tparam Parts a vector
template <class ConcurrencyTag, class Vector, class Parts, class Values_of>
void append_all(Vector& to, const Parts& parts, const Values_of& values_of) {
  std::vector<std::size_t> first;
  first.reserve(parts.size());
  std::size_t size = to.size();
  for (const auto& part : parts) first.push_back(size), size += values_of(part).size();
  if (size > to.capacity()) to.reserve(size + size / 8); // others often follow
  ask_for_pages(to.data() + to.size(), (size - to.size()) * sizeof(*to.data()));
  to.resize(size);
  Executor<ConcurrencyTag>::run(parts.size(), [&](std::size_t i) {
    const auto& values = values_of(parts.data()[i]);
    std::copy(values.begin(), values.end(), to.begin() + static_cast<std::ptrdiff_t>(first[i]));
  });
}

/// Appends what `collect(begin, end, values)` appends to a vector for consecutive blocks of `[0, n)`, in their order.
/// O(n) work besides that of `collect`.
template <class ConcurrencyTag, class Value, class Collect>
void append_by_blocks(std::vector<Value>& to, std::size_t n, const Collect& collect,
                      std::size_t block_length = default_block) {
  if (n <= block_length || is_sequential<ConcurrencyTag>()) return collect(std::size_t(0), n, to);
  std::vector<std::vector<Value>> found((n + block_length - 1) / block_length);
  for_each_block<ConcurrencyTag>(n, block_length, [&](std::size_t b, std::size_t begin, std::size_t end) {
    collect(begin, end, found[b]);
  });
  append_all<ConcurrencyTag>(
      to, found, [](const std::vector<Value>& values) -> const auto& { return values; });
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARALLEL_APPEND_ALL_H
