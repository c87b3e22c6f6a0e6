// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// How the blocks of each round are cut. The mesh alone decides, not threads or parts.
//
// The first round takes the blocks of vertices. Round r takes the zone around what waits, by squares that are shifted
// in every other round. From the fourth on, they hold four times as many triangles as in the round before. O(n) for n
// triangles.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_ROUND_CUTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_ROUND_CUTS_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Block_cut.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Place_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Vertex_blocks.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How a mesh is cut for the first round, in brief: enough to tell the blocks of the triangles that one has.
struct First_cut {
  /// Of the triangles in blocks, those with which blocks begin, and how many there are.
  std::vector<std::size_t> first;
  /// The least `position_word()` of each block; none if it is by vertices.
  std::vector<std::uint64_t> first_words;

  std::size_t size() const { return first.size() - 1; }
};

template <class ConcurrencyTag, class Geometry>
class Round_cuts {
public:
  static constexpr std::size_t block_size = Block_sizes<ConcurrencyTag>::triangles;
  /// Smaller than in the first round: the zone is small, and a thin network, so seams through it are short.
  static constexpr std::size_t zone_block_size = block_size / 4;

  explicit Round_cuts(const Meshing_state<Geometry>& whole) : whole_(whole) {}

  /// Smaller meshes are not worth cutting.
  bool is_worth_cutting() const {
    return whole_.mesh.number_of_triangles() - whole_.bulk.number_of_triangles() >= 2 * block_size;
  }

  Block_cut first() const {
    const auto& mesh = whole_.mesh;
    if (!is_first_by_vertices())
      return cut_by_position<ConcurrencyTag>(mesh, triangles_outside_bulk(), block_size, key_);
    return cut_by_vertices<ConcurrencyTag>(mesh, whole_.problem.vertex_blocks, numbers_in(mesh));
  }

  /// The same cut, without its triangles.
  First_cut first_in_few_words() const {
    if (is_first_by_vertices()) return {first_of_blocks_by_vertices(), {}};
    const Block_cut cut = first();
    First_cut words{cut.first, {}};
    for (std::size_t b = 0; b < cut.size(); ++b)
      words.first_words.push_back(position_word(whole_.mesh, *cut[b].begin(), key_));
    return words;
  }

  /// The block of a triangle, if it is in one.
  /// \param mesh which has the triangle and its vertices
  Block_id block_of(const First_cut& cut, const Kernel_mesh<Geometry>& mesh, Triangle_id t) const {
    if (is_first_by_vertices())
      return block_by_vertices(mesh, t, whole_.problem.vertex_blocks, numbers_in(mesh));
    if (is_within_bulk(mesh, t)) return {};
    const auto& words = cut.first_words;
    const auto behind = std::upper_bound(words.begin(), words.end(), position_word(mesh, t, key_));
    return static_cast<Block_id>(static_cast<std::size_t>(behind - words.begin()) - 1);
  }

  /// Some blocks of the cut, in the order of `first()`, from the triangles of a mesh that are here.
  /// \pre all that are in the blocks are here
  template <class Is_here>
  Block_cut blocks_between(const First_cut& cut, std::size_t begin, std::size_t end,
                           const Kernel_mesh<Geometry>& mesh, const Is_here& is_here) const {
    Block_cut blocks =
        group_in_order<ConcurrencyTag, Triangle_id>(mesh.triangles.size(), end - begin, [&](std::size_t i) {
          const Triangle_id t = static_cast<Triangle_id>(i);
          const Block_id b = is_here(t) ? block_of(cut, mesh, t) : Block_id();
          return b.is_valid() && begin <= b.value() && b.value() < end ? b.value() - begin : end - begin;
        });
    if (!is_first_by_vertices()) {
      const auto is_before = [&](Triangle_id t, Triangle_id u) {
        return position_word(mesh, t, key_) < position_word(mesh, u, key_);
      };
      for_each_index<ConcurrencyTag>(
          blocks.size(),
          [&](std::size_t b) {
            std::sort(blocks.members.begin() + std::ptrdiff_t(blocks.first[b]),
                      blocks.members.begin() + std::ptrdiff_t(blocks.first[b + 1]), is_before);
          },
          1);
    }
    return blocks;
  }

  /// How many rings of triangles are around the seeds of a zone.
  static int rings_of_zone(int round) {
    constexpr int most_rings = 8;
    return std::max(2, std::min(round - 1, most_rings));
  }

  /// \param triangles a vector
  template <class Triangles>
  Block_cut of_zone(const Triangles& triangles, int round) const {
    const int doublings = std::min(2 * std::max(0, round - 3), 24);
    return cut_by_position<ConcurrencyTag>(whole_.mesh, triangles, zone_block_size << doublings,
                                           round % 2 == 0 ? shifted_key_ : key_);
  }

private:
  const Meshing_state<Geometry>& whole_;
  Place_keys<Geometry> key_{whole_.problem.input_places()};
  Place_keys<Geometry> shifted_key_ = key_.shifted();

  /// Whether a triangle's vertices alone tell its block of the first round, and not their places.
  bool is_first_by_vertices() const { return !whole_.has_placed_vertices; }

  /// What vertices of input and edges are cut by.
  auto numbers_in(const Kernel_mesh<Geometry>& mesh) const {
    const auto end_of_input = static_cast<Vertex_id>(whole_.problem.number_of_input_points());
    return [this, &mesh, end_of_input](Vertex_id v) {
      return v < end_of_input ? v : whole_.edges[mesh.edge(v)].a;
    };
  }

  std::vector<std::size_t> first_of_blocks_by_vertices() const {
    const auto& mesh = whole_.mesh;
    std::vector<std::size_t> first(whole_.problem.vertex_blocks.size() + 1, 0);
    for (const Triangle_id t : mesh.triangles.ids())
      if (mesh.is_alive(t))
        ++first[block_by_vertices(mesh, t, whole_.problem.vertex_blocks, numbers_in(mesh)).value() + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
  }

  /// Whether a triangle meets all bounds as part of the bulk, and is not near its border.
  bool is_within_bulk(const Kernel_mesh<Geometry>& mesh, Triangle_id t) const {
    const auto& v = mesh.triangle(t).v;
    const auto& bulk = whole_.bulk;
    return bulk.has_within(v[0]) && bulk.has_within(v[1]) && bulk.has_within(v[2]);
  }

  /// All triangles but those within the bulk.
  std::vector<Triangle_id> triangles_outside_bulk() const {
    const Kernel_mesh<Geometry>& mesh = whole_.mesh;
    return pack_values<ConcurrencyTag, Triangle_id>(
        mesh.triangles.size(),
        [&](std::size_t i) {
          const Triangle_id t = static_cast<Triangle_id>(i);
          return mesh.is_alive(t) && !is_within_bulk(mesh, t);
        },
        [](std::size_t i) { return static_cast<Triangle_id>(i); });
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_ROUND_CUTS_H
