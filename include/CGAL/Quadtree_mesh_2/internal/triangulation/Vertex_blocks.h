// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The blocks of a graph's mesh: runs of its vertices in shuffle order.
//
// Computes: leaves of the quadtree of the vertices with so many in each at most (cut_by_squares.h), and which of them a
//           triangle belongs to. The middle one of a triangle's three numbers is one of the two that are close to each
//           other, those of its shortest edge as a rule. Refinement begins at these edges, however long the rest of
//           the triangle is.
// Bound:    O(n) for n vertices; O(1) for a triangle, where blocks have some 100 vertices or more.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_VERTEX_BLOCKS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_VERTEX_BLOCKS_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/cut_by_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Mesh_block.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How much makes a block: large enough that seams are few, small enough that a refined block stays in the cache and
/// that there are blocks for many threads. Less than two blocks are not worth cutting. Specialized by tests, so
/// that small inputs are cut too.
template <class ConcurrencyTag>
struct Block_sizes {
  static constexpr std::size_t vertices = 12288;  ///< of the input, at most
  static constexpr std::size_t triangles = 24576; ///< before they are refined
};

class Vertex_blocks {
public:
  /// A single block.
  Vertex_blocks() = default;
  /// Blocks that begin at these numbers, of which the last is the number of vertices.
  explicit Vertex_blocks(std::vector<std::size_t> first) : first_(std::move(first)) {
    if (size() < 2) return;
    for (std::size_t v = 0, b = 0; v < first_.back(); v += run_) {
      while (!(v < first_[b + 1])) ++b;
      block_of_run_.push_back(static_cast<Block_id>(b));
    }
  }

  /// Writes or reads them (Checkpoint_file.h).
  template <class Archive>
  void transfer(Archive& archive) {
    archive(first_);
    if (Archive::is_reading) *this = Vertex_blocks(std::move(first_));
  }

  std::size_t size() const { return first_.size() - 1; }

  /// How many vertices there are in the largest block.
  std::size_t largest() const {
    std::size_t most = 0;
    for (std::size_t b = 0; b < size(); ++b) most = std::max(most, first_[b + 1] - first_[b]);
    return most;
  }

  /// Runs of these blocks with at most so many vertices, or of one block.
  Vertex_blocks put_together(std::size_t most) const {
    std::vector<std::size_t> first{first_.front()};
    for (std::size_t b = 1; b < size(); ++b)
      if (first_[b + 1] - first.back() > most) first.push_back(first_[b]);
    first.push_back(first_.back());
    return Vertex_blocks(std::move(first));
  }

  /// The block of a triangle, by the numbers of its vertices. Numbers beyond those of the input count as its last.
  Block_id of_triangle(Vertex_id a, Vertex_id b, Vertex_id c) const {
    if (size() < 2) return Block_id(0);
    const Vertex_id middle = greater(lesser(a, b), lesser(greater(a, b), c));
    return block_of(std::min(std::size_t(middle), first_.back() - 1));
  }

private:
  /// Few enough vertices that most runs lie in one block, and enough that the table of runs is in the cache.
  static constexpr std::size_t run_ = 256;

  std::vector<std::size_t> first_ = {0, 0};
  std::vector<Block_id> block_of_run_; // that of its first vertex, if there are several blocks

  Block_id block_of(std::size_t vertex) const {
    std::size_t b = block_of_run_[vertex / run_].value();
    while (!(vertex < first_[b + 1])) ++b;
    return static_cast<Block_id>(b);
  }
};

/// The blocks of vertices in shuffle order, by `level` as of `cut_by_squares()`. Less than one and a half blocks are
/// not worth cutting.
template <class Level>
Vertex_blocks blocks_by_levels(std::size_t number_of_vertices, std::size_t most, const Level& level) {
  if (2 * number_of_vertices < 3 * most) return {};
  return Vertex_blocks(cut_by_squares(number_of_vertices, most, level));
}

/// The blocks of vertices whose grid points are given, called by their number in shuffle order as `point_at(i)`.
template <class Point_at>
Vertex_blocks blocks_by_squares(std::size_t number_of_vertices, std::size_t most, const Point_at& point_at) {
  return blocks_by_levels(number_of_vertices, most, [&](std::size_t i, std::size_t k) {
    const auto &p = point_at(i), &q = point_at(k);
    using Operations = Word_operations<std::decay_t<decltype(p.x)>>;
    return std::max(Operations::width_of_difference(p.x, q.x), Operations::width_of_difference(p.y, q.y));
  });
}

/// The blocks of vertices whose squares are not known: of about one size.
inline Vertex_blocks blocks_by_number(std::size_t number_of_vertices, std::size_t most) {
  return blocks_by_levels(number_of_vertices, most, [](std::size_t, std::size_t) { return 0; });
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_VERTEX_BLOCKS_H
