// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The triangles of the leaves of a quadtree, with the data needed to move their vertices to sites.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_MESH_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_sites.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The sides of the window, as bits: a vertex may lie on two.
constexpr std::uint8_t left_side = 1, right_side = 2, bottom_side = 4, top_side = 8;

/// The vertices that move along with a star site, without change of shape.
struct Star_spokes {
  std::uint32_t site;
  std::array<std::int32_t, 8> vertices; ///< the neighbors of its vertex, counterclockwise from the east
};

/// A mesh of tiles. Leaves are in shuffle order; vertices are in the shuffle order of the places that the tiles
/// give them.
struct Tile_mesh {
  /// \name By vertex
  /// @{
  Uninitialized_vector<Tile_place> places;  ///< those in blocks are moved already
  Uninitialized_vector<std::uint8_t> sides; ///< on which it lies, as bits
  /// 1 for interior vertices of blocks of warped and star sites, and for those on the rim of a run of leaves
  Uninitialized_vector<std::uint8_t> is_frozen;
  /// The instances of vertex v, its places in `leaf_vertices`, are those from `first_instance[v]` on.
  Uninitialized_vector<std::uint32_t> first_instance;
  Uninitialized_vector<std::uint32_t> instances;
  /// @}

  /// Counterclockwise, those of a leaf together, in the order of leaves and of the tiles' triangles.
  Uninitialized_vector<std::array<std::int32_t, 3>> triangles;

  /// \name By leaf
  /// @{
  Uninitialized_vector<Tile_square> leaves;
  Uninitialized_vector<std::uint8_t> corner_bits;     ///< of its tile
  Uninitialized_vector<std::uint32_t> first_triangle; ///< and one past the last
  Uninitialized_vector<std::uint32_t> first_vertex;   ///< where its vertices begin in `leaf_vertices`
  Uninitialized_vector<std::int32_t> leaf_vertices;   ///< in the order of the tile
  /// @}

  /// \name By site
  /// @{
  std::vector<std::int32_t> leaf_of_site;
  /// -1 for sites without vertex. The vertices of warped and star sites lie at them.
  std::vector<std::int32_t> vertex_of_site;
  /// @}
  std::vector<Star_spokes> stars; ///< by increasing site
  /// The warped and star sites without vertex, because their blocks leave the window, are not made of equal
  /// leaves of the level asked for, or overlap.
  std::vector<std::uint32_t> broken_blocks;

  std::size_t number_of_vertices() const { return places.size(); }
  std::size_t number_of_triangles() const { return triangles.size(); }
  std::size_t number_of_leaves() const { return leaves.size(); }

  /// The leaf to which an instance of a vertex belongs. Takes O(log k) time for k leaves.
  std::size_t leaf_of_instance(std::uint32_t instance) const {
    return static_cast<std::size_t>(std::upper_bound(first_vertex.begin(), first_vertex.end(), instance) -
                                    first_vertex.begin()) -
           1;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TILES_TILE_MESH_H
