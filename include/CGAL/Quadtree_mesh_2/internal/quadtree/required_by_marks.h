// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_REQUIRED_BY_MARKS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_REQUIRED_BY_MARKS_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/quadtree/Required_squares.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Returns the squares of a quadtree that are split already or are marked leaves.
/// \param is_marked called as `is_marked(Node_index)` for leaves, twice or more.
template <class ConcurrencyTag, class Linked_squares, class Is_marked>
Required_squares required_by_marks(const Linked_squares& tree, const Is_marked& is_marked) {
  const auto is_required = [&](std::size_t i) {
    return !tree.is_leaf(Node_index(i)) || is_marked(Node_index(i));
  };
  const std::vector<std::uint32_t> nodes = pack<ConcurrencyTag>(tree.number_of_nodes(), is_required);
  Required_squares squares;
  squares.children.resize(nodes.size());
  for_each_index<ConcurrencyTag>(nodes.size(), [&](std::size_t i) {
    const Node_index v(nodes[i]);
    unsigned split = 0;
    if (!tree.is_leaf(v))
      for (int q = 0; q < 4; ++q)
        if (is_required(std::size_t(tree.child(v, q)))) split |= 1u << q;
    squares.children[i] = static_cast<std::uint8_t>(split);
  });
  for (std::size_t i = 0; i < nodes.size(); ++i) // nodes are numbered level by level
    if (i + 1 == nodes.size() || tree.level(Node_index(nodes[i])) != tree.level(Node_index(nodes[i + 1])))
      squares.level_begin.push_back(static_cast<std::uint32_t>(i + 1));
  squares.template link_children<ConcurrencyTag>();
  return squares;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_REQUIRED_BY_MARKS_H
