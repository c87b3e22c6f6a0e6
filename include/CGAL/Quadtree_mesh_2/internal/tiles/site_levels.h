// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Levels at which the leaves of sites hold few of them, or are small compared with distances.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TILES_SITE_LEVELS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TILES_SITE_LEVELS_H

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/tiles/Tile_sites.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The distances that `near_distances()` finds are not greater than this times those of nearest neighbors.
constexpr double near_distance_factor = 1.6284;

/// Returns for each site the level of its leaf in the unbalanced quadtree whose leaves hold at most
/// `max_points` sites.
template <class ConcurrencyTag>
std::vector<int> levels_with_few_sites(const std::vector<Tile_site>& places, std::size_t max_points) {
  using Quadtree = Balanced_quadtree<Tile_traits, ConcurrencyTag>;
  const Quadtree tree(places, Quadtree_options().max_points_per_leaf(max_points).balance(Balance::NONE));
  std::vector<int> levels(places.size());
  for_each_index<ConcurrencyTag>(places.size(),
                                 [&](std::size_t i) { levels[i] = tree.level(tree.leaf(Point_index(i))); });
  return levels;
}

/// Returns for each site the distance in grid units to a near neighbor, infinity if there is no other site.
template <class ConcurrencyTag>
std::vector<double> near_distances(const std::vector<Tile_site>& places) {
  using Quadtree = Balanced_quadtree<Tile_traits, ConcurrencyTag>;
  const Quadtree tree(places);
  const auto neighbors = tree.near_neighbors();
  std::vector<double> distances(places.size(), std::numeric_limits<double>::infinity());
  for_each_index<ConcurrencyTag>(places.size(), [&](std::size_t i) {
    const auto neighbor = neighbors[tree.framework().rank(Point_index(i)).value()];
    if (!neighbor.is_valid()) return;
    const Tile_place q = tree.framework().grid_point(neighbor);
    const auto difference = [](std::uint64_t a, std::uint64_t b) {
      return static_cast<double>(a < b ? b - a : a - b);
    };
    distances[i] = std::hypot(difference(places[i].x(), q.x), difference(places[i].y(), q.y));
  });
  return distances;
}

/// Returns the least level at which squares have at most a side, in grid units.
/// \pre `side` >= 1
inline int level_of_side(double side) {
  return side >= std::ldexp(1.0, Tile_traits::depth) ? 0 : Tile_traits::depth - std::ilogb(side);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TILES_SITE_LEVELS_H
