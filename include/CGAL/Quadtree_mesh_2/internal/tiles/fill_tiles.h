// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The mesh of tiles in which every site has a vertex.
//
// Computes: levels of leaves, the mesh of tiles that they make, and a vertex for each site.
// Bound:    O(n + k) work for n sites and k squares in each round, not counting sorting. At most as many
//           rounds as there are levels; a few in practice, because the first levels separate sites.
// Method:   Leaves start with few sites, and small compared with the distance to a near neighbor. Sites that
//           get no vertex get smaller leaves, until all have one: half as large, and at once about as small
//           as the distance to a near neighbor, because before that there is no vertex for both.
// Source:   Bern, Eppstein, Teng, section 5, Theorem 3, where each point gets squares so small that there is
//           room for its warp.
// Deviates: leaves are split on demand. The result is smaller by an order of magnitude. But vertices on the
//           way to their sites may meet, and the code that moves them has to check.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TILES_FILL_TILES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TILES_FILL_TILES_H

#include <CGAL/Quadtree_mesh_2/internal/tiles/Site_assignment.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_mesh_builder.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_sites.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/site_levels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How tiles are made for sites.
struct Tile_options {
  std::size_t max_points_per_leaf = 1;
  Spacing spacing = Spacing::NO_NEIGHBORS;
  /// The largest leaf of a site to begin with, in distances to a near neighbor; or infinity.
  double sides_per_distance = std::numeric_limits<double>::infinity();
};

/// A mesh of tiles with a vertex for each site, and how it came about.
struct Tile_filling {
  Tile_sites sites; ///< with the levels that they got
  Tile_mesh mesh;
  int number_of_rounds = 0;
};

/// Fills tiles, and again with smaller leaves for those sites that turn out to need them.
template <class ConcurrencyTag = Sequential_tag>
class Tile_filler {
public:
  Tile_filler(Tile_sites sites, const Tile_options& options) : options_(options) {
    filling_.sites = std::move(sites);
    distances_ = near_distances<ConcurrencyTag>(filling_.sites.places);
  }

  /// Starts with the levels that separate sites, and not less than the given one.
  void set_first_levels(int least_level = 0) {
    filling_.sites.levels.resize(filling_.sites.size(), 0);
    const std::vector<int> few =
        levels_with_few_sites<ConcurrencyTag>(filling_.sites.places, options_.max_points_per_leaf);
    for_each_index<ConcurrencyTag>(filling_.sites.size(), [&](std::size_t i) {
      if (filling_.sites.kind(i) != Site_kind::ON_DEMAND) return;
      raise(i, std::max(least_level, few[i]));
      raise(i, level_for(i, options_.sides_per_distance));
    });
  }

  /// Builds and assigns until every site has a vertex.
  /// \throws std::length_error if a site gets none at any level
  void fill() {
    for (;;) {
      ++filling_.number_of_rounds;
      filling_.mesh = Tile_mesh(); // lest there are two at a time
      filling_.mesh = Tile_mesh_builder<ConcurrencyTag>(filling_.sites).build();
      const std::vector<std::uint32_t> without_vertex =
          Site_assignment<ConcurrencyTag>(filling_.sites, options_.spacing, filling_.mesh).assign();
      if (without_vertex.empty() && filling_.mesh.broken_blocks.empty()) return;
      for (const std::uint32_t i : without_vertex) split(i);
      for (const std::uint32_t i : filling_.mesh.broken_blocks) split(i);
    }
  }

  /// Asks for a smaller leaf of a site, when tiles are filled again.
  void split(std::size_t site) {
    const auto& mesh = filling_.mesh;
    const int level = mesh.leaves[static_cast<std::size_t>(mesh.leaf_of_site[site])].level;
    const bool has_block = filling_.sites.kind(site) != Site_kind::ON_DEMAND;
    raise(site, has_block ? std::max(filling_.sites.levels[site] + 1, level) : level + 1);
    raise(site, level_for(site, hopeless_));
  }

  /// Makes a site a star, with the given level. To be called before `set_first_levels()`.
  void reserve_star(std::size_t site, int level) {
    filling_.sites.kinds.resize(filling_.sites.size(), Site_kind::ON_DEMAND);
    filling_.sites.levels.resize(filling_.sites.size(), 0);
    filling_.sites.kinds[site] = Site_kind::STAR;
    filling_.sites.levels[site] = level;
  }

  /// Asks for a block of equal leaves around a site, small enough that it is in nobody's way: its triangles have
  /// angles in [37.5, 78.6] degrees then (warp_table.h), whatever others do.
  void certify(std::size_t site) {
    if (filling_.sites.kinds.empty())
      filling_.sites.kinds.resize(filling_.sites.size(), Site_kind::ON_DEMAND);
    filling_.sites.kinds[site] = Site_kind::WARPED;
    raise(site, level_for(site, certified_sides_per_distance_ / near_distance_factor));
  }
  bool is_certified(std::size_t site) const { return filling_.sites.kind(site) == Site_kind::WARPED; }

  const Tile_filling& filling() const { return filling_; }
  /// Lets go of the mesh but for what `split()` looks at.
  void let_go_of_mesh() { filling_.mesh.keep_leaves(); }
  Tile_filling result() { return std::move(filling_); }

private:
  /// Where leaves of sites are larger than this times the distance to a near neighbor, there is hardly a
  /// vertex for both.
  static constexpr double hopeless_ = 2;
  static constexpr double certified_sides_per_distance_ = 0.1178; // 1 / (6 sqrt(2))

  void raise(std::size_t site, int level) {
    filling_.sites.levels[site] = std::max(filling_.sites.levels[site], level);
  }

  int level_for(std::size_t site, double sides_per_distance) const {
    const double side = sides_per_distance * distances_[site];
    return side < 1 ? Tile_traits::depth : level_of_side(side);
  }

  Tile_options options_;
  Tile_filling filling_;
  std::vector<double> distances_; // by site
};

/// Makes a mesh of tiles with a vertex for each site. The levels of warped and star sites are kept where their
/// blocks have room.
template <class ConcurrencyTag = Sequential_tag>
Tile_filling fill_tiles(Tile_sites sites, const Tile_options& options = Tile_options()) {
  Tile_filler<ConcurrencyTag> filler(std::move(sites), options);
  filler.set_first_levels();
  filler.fill();
  return filler.result();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TILES_FILL_TILES_H
