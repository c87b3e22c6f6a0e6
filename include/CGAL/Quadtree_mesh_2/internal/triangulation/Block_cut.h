// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Which triangles make a block of a mesh.
//
// Refinement begins at the shortest edges of triangles. So it is their places that count, however long the rest of a
// triangle is. Rounds take the blocks of vertices in their turn first, and then squares of triangles that are
// shifted by a third of the root in every other round. So what is near a seam of one round is well inside a block of
// the next: of a quadtree and its shifted copies, one has any given disc within a square not much larger (Chan,
// "Approximate nearest neighbor queries revisited", 1998). The mesh alone determines how blocks are cut, and what
// changes in one place cuts no blocks in another. O(n) for n triangles.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_BLOCK_CUT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_BLOCK_CUT_H

#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/cut_by_squares.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/radix_sort.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Place_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Vertex_blocks.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Triangles by block.
using Block_cut = Groups<Triangle_id>;

/// What stands for the place of a triangle.
template <class Geometry>
typename Geometry::Point middle_of_shortest_edge(const Kernel_mesh<Geometry>& mesh, Triangle_id t) {
  const auto& r = mesh.triangle(t);
  const int k = mesh.shape(r).slot_of_shortest();
  const auto &a = mesh.point(r.v[next_slot[k]]), &b = mesh.point(r.v[previous_slot[k]]);
  return Geometry::translate(a, 0.5 * Geometry::difference(b, a));
}

/// The order of triangles by place: the key of the place, and the handle.
template <class Geometry>
std::uint64_t position_word(const Kernel_mesh<Geometry>& mesh, Triangle_id t,
                            const Place_keys<Geometry>& key) {
  return key(middle_of_shortest_edge(mesh, t)) << 32 | t.value();
}

/// Cuts the given triangles, a vector, into squares with at most `most` each, by the middles of their shortest edges.
/// What the squares of the grid do not tell apart is cut by number.
template <class ConcurrencyTag, class Geometry, class Triangles>
Block_cut cut_by_position(const Kernel_mesh<Geometry>& mesh, const Triangles& triangles, std::size_t most,
                          const Place_keys<Geometry>& key) {
  const std::size_t n = triangles.size();
  Uninitialized_vector<std::uint64_t> words(n);
  for_each_index<ConcurrencyTag>(n,
                                 [&](std::size_t i) { words[i] = position_word(mesh, triangles[i], key); });
  sort_words<ConcurrencyTag>(words.data(), uncleared_words(n).get(), n, true);

  Block_cut cut;
  cut.members.resize(n);
  for_each_index<ConcurrencyTag>(
      n, [&](std::size_t i) { cut.members[i] = Triangle_id(static_cast<std::uint32_t>(words[i])); });
  cut.first = cut_by_squares(n, most, [&](std::size_t i, std::size_t k) {
    return (bit_width((words[i] ^ words[k]) >> 32) + 1) / 2;
  });
  return cut;
}

/// The block of a triangle of a mesh without free vertices, by those of its vertices. `number_of(v)` is the number of
/// an input vertex, and for a vertex on an edge that of a vertex of the edge.
template <class Geometry, class Number_of>
Block_id block_by_vertices(const Kernel_mesh<Geometry>& mesh, Triangle_id t, const Vertex_blocks& blocks,
                           const Number_of& number_of) {
  const auto& v = mesh.triangle(t).v;
  return blocks.of_triangle(number_of(v[0]), number_of(v[1]), number_of(v[2]));
}

/// Cuts all triangles of a mesh without free vertices into the blocks of its vertices, by `block_by_vertices()`.
template <class ConcurrencyTag, class Geometry, class Number_of>
Block_cut cut_by_vertices(const Kernel_mesh<Geometry>& mesh, const Vertex_blocks& blocks,
                          const Number_of& number_of) {
  return group_in_order<ConcurrencyTag, Triangle_id>(
      mesh.triangles.size(), blocks.size(), [&](std::size_t i) -> std::size_t {
        const Triangle_id t = static_cast<Triangle_id>(i);
        return mesh.is_alive(t) ? block_by_vertices(mesh, t, blocks, number_of).value() : blocks.size();
      });
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_BLOCK_CUT_H
