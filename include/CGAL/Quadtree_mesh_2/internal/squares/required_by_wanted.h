// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_REQUIRED_BY_WANTED_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_REQUIRED_BY_WANTED_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Required_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Wanted_squares.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Returns the squares to be split for leaves as small as wanted. Goes down level by level, and takes along in which of
/// the wanted squares each square lies. O(1) for each square, in two rounds for each level.
template <class ConcurrencyTag, class Geometry>
Required_squares required_by_wanted(const Wanted_squares<Geometry>& wanted) {
  Required_squares squares;
  Uninitialized_vector<std::uint32_t> nodes, nodes_below; // of the split squares of a level, and of the next
  if (wanted.must_split(0, 0)) nodes.push_back(0);
  for (int level = 0; !nodes.empty(); ++level) {
    const std::size_t first_square = squares.size();
    squares.children.resize(first_square + nodes.size());
    squares.level_begin.push_back(static_cast<std::uint32_t>(squares.size()));
    count_allocate_and_place<ConcurrencyTag>(
        nodes.size(),
        [&](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for (std::size_t i = begin; i < end; ++i) {
            unsigned split = 0;
            for (int c = 0; c < 4; ++c)
              if (wanted.must_split(wanted.child(nodes[i], c), level + 1)) split |= 1u << c;
            squares.children[first_square + i] = static_cast<std::uint8_t>(split);
            sum += number_of_children(split);
          }
          return sum;
        },
        [&](std::size_t sum) { resize_to_write(nodes_below, sum); },
        [&](std::size_t begin, std::size_t end, std::size_t next) {
          for (std::size_t i = begin; i < end; ++i)
            for (int c = 0; c < 4; ++c)
              if ((squares.children[first_square + i] >> c & 1) != 0)
                nodes_below[next++] = static_cast<std::uint32_t>(wanted.child(nodes[i], c));
        });
    nodes.swap(nodes_below);
  }
  squares.template link_children<ConcurrencyTag>();
  return squares;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SQUARES_REQUIRED_BY_WANTED_H
