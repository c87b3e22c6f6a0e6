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

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Block_cut.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Place_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Vertex_blocks.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

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
    if (whole_.has_placed_vertices)
      return cut_by_position<ConcurrencyTag>(mesh, triangles_outside_bulk(), block_size, key_);
    const Vertex_id end_of_input = whole_.problem.input_points.end_id();
    return cut_by_vertices<ConcurrencyTag>(mesh, whole_.problem.vertex_blocks, [&](Vertex_id v) {
      return v < end_of_input ? v : whole_.edges[mesh.edge(v)].a;
    });
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
  Place_keys<Geometry> key_{whole_.problem.input_points.values()};
  Place_keys<Geometry> shifted_key_ = key_.shifted();

  /// All triangles but those within the bulk, which meet all bounds and are not near its border.
  std::vector<Triangle_id> triangles_outside_bulk() const {
    const Kernel_mesh<Geometry>& mesh = whole_.mesh;
    const auto& bulk = whole_.bulk;
    return pack_values<ConcurrencyTag, Triangle_id>(
        mesh.triangles.size(),
        [&](std::size_t i) {
          const auto& v = mesh.triangle(static_cast<Triangle_id>(i)).v;
          return v[0].is_valid() &&
                 !(bulk.has_within(v[0]) && bulk.has_within(v[1]) && bulk.has_within(v[2]));
        },
        [](std::size_t i) { return static_cast<Triangle_id>(i); });
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_ROUND_CUTS_H
