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
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
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

  /// Builds and assigns until every site has a vertex. With more tiles than `most_tiles` they are filled in runs
  /// of about so many, if no site has a block; then the mesh is that of the last run.
  /// \throws Tile_level_error if a site gets none at any level, std::length_error if there are too many vertices
  void fill(std::size_t most_tiles = std::numeric_limits<std::size_t>::max()) {
    for (;;) {
      ++filling_.number_of_rounds;
      filling_.mesh = Tile_mesh(); // lest there are two at a time
      builder_.reset();
      builder_.emplace(filling_.sites);
      cut(most_tiles);
      std::vector<std::uint32_t> failing;
      for (std::size_t r = 0; r < runs_.size(); ++r) {
        const std::vector<std::uint32_t> more = fill_run(r);
        failing.insert(failing.end(), more.begin(), more.end());
      }
      if (failing.empty()) break;
      for (const std::uint32_t i : failing) split(i);
    }
    if (runs_.size() == 1) builder_.reset();
  }

  /// \name Runs of leaves
  /// Each begins with the same place, as often as tiles are filled.
  /// @{

  std::size_t number_of_runs() const { return runs_.size(); }
  const std::vector<std::uint32_t>& sites_of_run(std::size_t r) const { return runs_[r].sites; }
  /// Two numbers that grow when anything in the run changes: leaves are only ever split.
  std::array<std::size_t, 2> state_of_run(std::size_t r) const {
    std::size_t bits = 0;
    const Leaf_run& leaves = runs_[r].leaves;
    for (std::size_t k = leaves.begin; k < leaves.end; ++k) {
      const unsigned b = builder_->corner_bits_of_leaf(k);
      bits += (b & 1) + (b >> 1 & 1) + (b >> 2 & 1) + (b >> 3 & 1);
    }
    return {leaves.size(), bits};
  }

  /// Makes the mesh of a run, by whose sites it is numbered. Returns the sites that get no vertex there, or no block.
  std::vector<std::uint32_t> fill_run(std::size_t r) {
    filling_.mesh = Tile_mesh();
    const std::vector<std::uint32_t>& numbers = runs_[r].sites;
    filling_.mesh = builder_->build(runs_[r].leaves, numbers);
    const bool is_whole = runs_.size() == 1;
    const Tile_sites part = is_whole ? Tile_sites() : picked(numbers);
    std::vector<std::uint32_t> failing =
        Site_assignment<ConcurrencyTag>(is_whole ? filling_.sites : part, options_.spacing, filling_.mesh)
            .assign();
    const auto& broken = filling_.mesh.broken_blocks;
    failing.insert(failing.end(), broken.begin(), broken.end());
    for (std::uint32_t& i : failing) i = numbers[i];
    return failing;
  }

  /// @}

  /// Asks for a smaller leaf of a site, when tiles are filled again.
  void split(std::size_t site) {
    const int level = leaf_levels_[site];
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
  void let_go_of_mesh() { filling_.mesh = Tile_mesh(); }
  /// No run can be made any more.
  void let_go_of_leaves() {
    let_go_of_mesh();
    builder_.reset();
  }
  Tile_filling result() { return std::move(filling_); }

private:
  /// Where leaves of sites are larger than this times the distance to a near neighbor, there is hardly a
  /// vertex for both.
  static constexpr double hopeless_ = 2;
  static constexpr double certified_sides_per_distance_ = 0.1178; // 1 / (6 sqrt(2))

  struct Run {
    Leaf_run leaves;
    std::vector<std::uint32_t> sites;
  };

  /// Cuts the leaves into runs, where they were cut before; and finds what runs and levels sites are in.
  void cut(std::size_t most_tiles) {
    const std::size_t n = builder_->number_of_leaves();
    if (filling_.number_of_rounds == 1) {
      const std::size_t count = n / most_tiles + 1;
      for (std::size_t r = 1; r < count; ++r) cuts_.push_back(builder_->corner_of_leaf(n * r / count));
    }
    if (!filling_.sites.kinds.empty()) cuts_.clear();
    std::vector<std::size_t> ends;
    for (const Tile_place& p : cuts_) ends.push_back(builder_->leaf_at(p));
    ends.push_back(n);
    runs_.assign(ends.size(), {});
    for (std::size_t r = 0; r < ends.size(); ++r) runs_[r].leaves = {r == 0 ? 0 : ends[r - 1], ends[r]};
    leaf_levels_.resize(filling_.sites.size());
    for (std::size_t i = 0; i < filling_.sites.size(); ++i) {
      const std::size_t leaf = builder_->leaf_of_site(i);
      leaf_levels_[i] = static_cast<std::uint8_t>(builder_->level_of_leaf(leaf));
      const auto end = std::upper_bound(ends.begin(), ends.end(), leaf);
      runs_[static_cast<std::size_t>(end - ends.begin())].sites.push_back(static_cast<std::uint32_t>(i));
    }
  }

  Tile_sites picked(const std::vector<std::uint32_t>& numbers) const {
    Tile_sites result;
    result.window = filling_.sites.window;
    for (const std::uint32_t i : numbers) result.places.push_back(filling_.sites.places[i]);
    return result;
  }

  void raise(std::size_t site, int level) {
    filling_.sites.levels[site] = std::max(filling_.sites.levels[site], level);
  }

  int level_for(std::size_t site, double sides_per_distance) const {
    const double side = sides_per_distance * distances_[site];
    return side < 1 ? Tile_traits::depth : level_of_side(side);
  }

  Tile_options options_;
  Tile_filling filling_;
  std::optional<Tile_mesh_builder<ConcurrencyTag>> builder_; // as long as there are runs to be made
  std::vector<Tile_place> cuts_;                             // where runs begin but the first
  std::vector<Run> runs_;
  std::vector<std::uint8_t> leaf_levels_; // by site
  std::vector<double> distances_;         // by site
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
