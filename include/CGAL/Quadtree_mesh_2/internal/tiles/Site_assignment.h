// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Assigns vertices of a mesh of tiles to sites.
//
// Computes: for sites of kind `ON_DEMAND` vertices of their leaves' tiles, all distinct, and on request not
//           neighbors of each other. Also the sites for which none is left.
// Bound:    O(n) work for n sites, not counting the sorting of O(n) pairs.
// Method:   Greedy. All pairs of a site and a vertex near it are sorted by distance, relative to the side of
//           the leaf. A pair is taken if site and vertex are still free.
// Source:   Bern, Eppstein, Teng, section 5, Theorem 3. There squares are split until a point has the
//           vertices around it for itself.
// Deviates: here a point may share them with others.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TILES_SITE_ASSIGNMENT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TILES_SITE_ASSIGNMENT_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_sites.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/tile_blocks.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Which vertices may go to different sites.
enum class Spacing {
  DISTINCT,    ///< any two
  NO_NEIGHBORS ///< two without an edge between them
};

/// A site may be taken by vertices nearer than this times the side of its leaf.
constexpr double reach_of_site = 0.6;

template <class ConcurrencyTag = Sequential_tag>
class Site_assignment {
public:
  Site_assignment(const Tile_sites& sites, Spacing spacing, Tile_mesh& mesh)
      : sites_(sites), spacing_(spacing), mesh_(mesh) {}

  /// Sets the vertices of sites. Returns the sites of kind `ON_DEMAND` that get none, by increasing index.
  std::vector<std::uint32_t> assign() {
    is_free_.assign(mesh_.number_of_vertices(), 1);
    for (const std::int32_t v : mesh_.vertex_of_site)
      if (v >= 0) take(v);
    list_pairs();
    const Order order = radix_order<ConcurrencyTag>(
        pairs_.size(), [this](std::size_t i) { return pairs_[i].squared_distance; });
    for (const std::uint32_t i : order) {
      std::int32_t& vertex = mesh_.vertex_of_site[pairs_[i].site];
      if (vertex >= 0 || is_free_[static_cast<std::size_t>(pairs_[i].vertex)] == 0) continue;
      vertex = pairs_[i].vertex;
      take(vertex);
    }
    return pack<ConcurrencyTag>(sites_.size(), [&](std::size_t i) {
      return mesh_.vertex_of_site[i] < 0 && sites_.kind(i) == Site_kind::ON_DEMAND;
    });
  }

private:
  struct Pair {
    std::uint64_t squared_distance; ///< in units of `Place_in_square`
    std::uint32_t site;
    std::int32_t vertex;
  };

  /// Calls `f(pair)` for the vertices of the leaf of a site that may be moved to it, in the order of the tile.
  template <class F>
  void for_each_pair(std::size_t site, const F& f) const {
    if (sites_.kind(site) != Site_kind::ON_DEMAND) return;
    constexpr double side = double(std::uint64_t(1) << log_units_of_place_in_square);
    constexpr auto limit = static_cast<std::uint64_t>(reach_of_site * reach_of_site * side * side);
    const std::size_t leaf = static_cast<std::size_t>(mesh_.leaf_of_site[site]);
    const Tile& t = tile(mesh_.corner_bits[leaf]);
    const Place_in_square p = place_in_square(sites_.places[site], mesh_.leaves[leaf]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(t.number_of_vertices); ++i) {
      const std::uint64_t d = squared_distance(p, t.vertices[i]);
      if (d >= limit) continue;
      const std::int32_t v = mesh_.leaf_vertices[mesh_.first_vertex[leaf] + i];
      if (mesh_.sides[static_cast<std::size_t>(v)] != 0 || mesh_.is_frozen[static_cast<std::size_t>(v)] != 0)
        continue;
      f(Pair{d, static_cast<std::uint32_t>(site), v});
    }
  }

  void list_pairs() {
    count_allocate_and_place<ConcurrencyTag>(
        sites_.size(),
        [&](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for (std::size_t i = begin; i < end; ++i) for_each_pair(i, [&](const Pair&) { ++sum; });
          return sum;
        },
        [&](std::size_t n) { pairs_.resize(n); },
        [&](std::size_t begin, std::size_t end, std::size_t next) {
          for (std::size_t i = begin; i < end; ++i)
            for_each_pair(i, [&](const Pair& pair) { pairs_[next++] = pair; });
        },
        default_block / 16);
  }

  /// Marks a vertex, and its neighbors if they are not to be taken, too.
  void take(std::int32_t vertex) {
    const std::size_t v = static_cast<std::size_t>(vertex);
    is_free_[v] = 0;
    if (spacing_ == Spacing::DISTINCT) return;
    for (std::uint32_t i = mesh_.first_instance[v]; i < mesh_.first_instance[v + 1]; ++i) {
      const std::uint32_t instance = mesh_.instances[i];
      const std::size_t leaf = mesh_.leaf_of_instance(instance);
      const Tile& t = tile(mesh_.corner_bits[leaf]);
      const std::uint32_t first = mesh_.first_vertex[leaf];
      for (std::size_t k = 0; k < static_cast<std::size_t>(t.number_of_triangles); ++k) {
        const auto& corners = t.triangles[k];
        if (first + corners[0] != instance && first + corners[1] != instance &&
            first + corners[2] != instance)
          continue;
        for (const std::uint8_t corner : corners)
          is_free_[static_cast<std::size_t>(mesh_.leaf_vertices[first + corner])] = 0;
      }
    }
  }

  const Tile_sites& sites_;
  Spacing spacing_;
  Tile_mesh& mesh_;
  std::vector<std::uint8_t> is_free_; // by vertex
  Uninitialized_vector<Pair> pairs_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TILES_SITE_ASSIGNMENT_H
