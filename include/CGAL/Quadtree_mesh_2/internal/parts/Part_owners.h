// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Which part of a mesh has which triangles.
//
// Parts are consecutive blocks of the first round, with about as many triangles each before they are refined. What is
// in no block then, in the bulk of squares, goes with the block before it in the order of places. A triangle
// has one owner. A part holds all vertices of its triangles, of which it owns those that no lower part holds.
//
// O(n) for n triangles and vertices, to divide them or to count what the parts hold.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARTS_PART_OWNERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARTS_PART_OWNERS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parts/Part_records.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Block_cut.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What a part has of the mesh.
struct Part_holding {
  std::size_t triangles = 0;
  std::size_t vertices = 0;     ///< of its triangles
  std::size_t own_vertices = 0; ///< those that no lower part holds
};

class Part_owners {
public:
  using Holdings = Indexed_vector<Part_id, Part_holding>;

  Part_id operator[](Triangle_id t) const { return owner_[t]; }
  void give(Triangle_id t, Part_id p) { owner_[t] = p; }
  /// Makes room for new triangles, which nobody owns yet.
  void cover(std::size_t triangles) { owner_.resize(triangles); }

  /// Divides the mesh by the blocks of the first round.
  template <class Geometry, class Blocks>
  void divide(const Meshing_state<Geometry>& whole, const Blocks& blocks, std::size_t parts) {
    const auto block_of = blocks_of_triangles(whole, blocks);
    std::vector<std::size_t> triangles(blocks.size());
    for (const Block_id b : block_of)
      if (b.is_valid()) ++triangles[b.value()];
    const std::vector<Part_id> part_of_block = parts_of_blocks(triangles, parts);
    cover(block_of.size());
    for (const Triangle_id t : block_of.ids())
      if (block_of[t].is_valid()) owner_[t] = part_of_block[block_of[t].value()];
  }

  template <class Geometry>
  Holdings holdings(const Kernel_mesh<Geometry>& mesh, std::size_t parts) const {
    const auto by_part = group_in_order<Sequential_tag, Triangle_id>(
        mesh.triangles.size(), parts, [&](std::size_t i) -> std::size_t {
          const Triangle_id t = static_cast<Triangle_id>(i);
          return mesh.is_alive(t) ? owner_[t].value() : parts;
        });
    Holdings holdings(parts);
    Indexed_vector<Vertex_id, Part_id> last_holder(mesh.number_of_vertices());
    for (const Part_id p : holdings.ids()) {
      Part_holding& held = holdings[p];
      held.triangles = by_part[p.value()].size();
      for (const Triangle_id t : by_part[p.value()])
        for (const Vertex_id v : mesh.triangle(t).v) {
          if (last_holder[v] == p) continue;
          ++held.vertices;
          if (!last_holder[v].is_valid()) ++held.own_vertices;
          last_holder[v] = p;
        }
    }
    return holdings;
  }

private:
  Indexed_vector<Triangle_id, Part_id> owner_;

  /// The block of each triangle alive, in which or after which it is.
  template <class Geometry, class Blocks>
  static Indexed_vector<Triangle_id, Block_id> blocks_of_triangles(const Meshing_state<Geometry>& whole,
                                                                   const Blocks& blocks) {
    const Kernel_mesh<Geometry>& mesh = whole.mesh;
    const Place_keys<Geometry> key(whole.problem.input_places());
    const auto key_of = [&](Triangle_id t) { return key(middle_of_shortest_edge(mesh, t)); };
    // Nothing follows on a block without triangles, as none lies between its key and the next one's.
    std::vector<std::uint64_t> first_key(blocks.size());
    std::uint64_t next_key = std::numeric_limits<std::uint64_t>::max();
    for (std::size_t b = blocks.size(); b-- > 0;) {
      if (blocks.cut()[b].size() > 0) next_key = key_of(blocks.cut()[b][0]);
      first_key[b] = next_key;
    }
    Indexed_vector<Triangle_id, Block_id> block_of(mesh.triangles.size());
    for (const Triangle_id t : mesh.triangles.ids()) {
      if (!mesh.is_alive(t)) continue;
      block_of[t] = blocks.block_of(t);
      if (block_of[t].is_valid()) continue;
      const auto after = std::upper_bound(first_key.begin(), first_key.end(), key_of(t));
      block_of[t] = static_cast<Block_id>(std::max<std::ptrdiff_t>(after - first_key.begin(), 1) - 1);
    }
    return block_of;
  }

  /// Each block goes where its middle triangle would go if all parts had the same number.
  static std::vector<Part_id> parts_of_blocks(const std::vector<std::size_t>& triangles, std::size_t parts) {
    std::size_t all = 0, before = 0;
    for (const std::size_t n : triangles) all += n;
    std::vector<Part_id> part;
    for (const std::size_t n : triangles) {
      const std::size_t p = all == 0 ? 0 : (2 * before + n) * parts / (2 * all);
      part.push_back(static_cast<Part_id>(std::min(p, parts - 1)));
      before += n;
    }
    return part;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARTS_PART_OWNERS_H
