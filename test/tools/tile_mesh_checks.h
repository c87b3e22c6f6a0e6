// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Exact checks of meshes of tiles, and sites to make them of.

#ifndef QUADTREE_MESH_2_TEST_TILE_MESH_CHECKS_H
#define QUADTREE_MESH_2_TEST_TILE_MESH_CHECKS_H

#include "catch.h"

#include <CGAL/Quadtree_mesh_2/internal/tiles/fill_tiles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace tile_test {

using namespace CGAL::Quadtree_mesh_2::internal;

__extension__ typedef __int128 Wide;

struct Difference {
  std::int64_t x, y;
};

inline Difference difference(const Tile_place& a, const Tile_place& b) {
  return {static_cast<std::int64_t>(b.x - a.x), static_cast<std::int64_t>(b.y - a.y)};
}
inline Wide cross(const Difference& u, const Difference& v) { return Wide(u.x) * v.y - Wide(u.y) * v.x; }
inline Wide dot(const Difference& u, const Difference& v) { return Wide(u.x) * v.x + Wide(u.y) * v.y; }

/// The least and the greatest angle in degrees.
struct Least_and_greatest_angle {
  double least = 180, greatest = 0;
};

inline const Tile_place& place(const Tile_mesh& mesh, std::int32_t v) {
  return mesh.places[static_cast<std::size_t>(v)];
}

inline Least_and_greatest_angle angles(const Tile_mesh& mesh) {
  Least_and_greatest_angle range;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Tile_place a = place(mesh, t[i]);
      const Difference u = difference(a, place(mesh, t[(i + 1) % 3])),
                       v = difference(a, place(mesh, t[(i + 2) % 3]));
      const double angle = std::atan2(double(cross(u, v)), double(dot(u, v))) * (180 / CGAL_PI);
      range.least = std::min(range.least, angle);
      range.greatest = std::max(range.greatest, angle);
    }
  return range;
}

/// Whether all angles are strictly acute, exactly.
inline bool is_acute(const Tile_mesh& mesh) {
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Tile_place a = place(mesh, t[i]);
      if (dot(difference(a, place(mesh, t[(i + 1) % 3])), difference(a, place(mesh, t[(i + 2) % 3]))) <= 0)
        return false;
    }
  return true;
}

/// Triangles are counterclockwise, cover the window once and fit together.
inline void check_conformity(const Tile_mesh& mesh, const Tile_window& window) {
  Wide area = 0;
  std::vector<std::size_t> first(mesh.number_of_vertices() + 1, 0); // edges by the vertices where they begin
  for (const auto& t : mesh.triangles) {
    const Tile_place a = place(mesh, t[0]);
    const Wide doubled = cross(difference(a, place(mesh, t[1])), difference(a, place(mesh, t[2])));
    if (doubled <= 0) FAIL("a triangle is not counterclockwise");
    area += doubled;
    for (const std::int32_t v : t) ++first[static_cast<std::size_t>(v) + 1];
  }
  REQUIRE(area == 2 * Wide(window.right() - window.left()) * Wide(window.top() - window.bottom()));
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::size_t> next = first;
  std::vector<std::int32_t> ends(first.back());
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ends[next[static_cast<std::size_t>(t[i])]++] = t[(i + 1) % 3];
  const auto number_of_edges = [&](std::size_t a, std::size_t b) {
    const std::int32_t* const all = ends.data();
    return std::count(all + first[a], all + first[a + 1], static_cast<std::int32_t>(b));
  };
  for (std::size_t a = 0; a < mesh.number_of_vertices(); ++a)
    for (std::size_t i = first[a]; i < first[a + 1]; ++i) {
      const std::size_t b = static_cast<std::size_t>(ends[i]);
      if (number_of_edges(a, b) != 1) FAIL("an edge has two triangles on one side");
      const bool is_twice = number_of_edges(b, a) > 0, is_on_side = (mesh.sides[a] & mesh.sides[b]) != 0;
      if (is_twice == is_on_side) FAIL("triangles do not fit together");
    }
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    const Tile_place p = mesh.places[v];
    const int sides = (p.x == window.left() ? left_side : 0) | (p.x == window.right() ? right_side : 0) |
                      (p.y == window.bottom() ? bottom_side : 0) | (p.y == window.top() ? top_side : 0);
    if (mesh.sides[v] != sides) FAIL("a vertex is on other sides");
  }
}

/// Leaves, their vertices and triangles, and the instances of vertices belong together.
inline void check_leaves(const Tile_mesh& mesh, const Tile_sites& sites) {
  REQUIRE(mesh.first_vertex.size() == mesh.number_of_leaves() + 1);
  REQUIRE(mesh.first_triangle[mesh.number_of_leaves()] == mesh.number_of_triangles());
  for (std::size_t k = 0; k < mesh.number_of_leaves(); ++k) {
    const Tile_square s = mesh.leaves[k];
    if (!sites.window.contains(s.x, s.y)) FAIL("a leaf is outside");
    if (k > 0 && !less_shuffle(Tile_place{mesh.leaves[k - 1].x, mesh.leaves[k - 1].y}, Tile_place{s.x, s.y}))
      FAIL("leaves are not in shuffle order");
    const Tile& t = tile(mesh.corner_bits[k]);
    if (mesh.first_vertex[k + 1] - mesh.first_vertex[k] != static_cast<std::uint32_t>(t.number_of_vertices))
      FAIL("a leaf has not the vertices of its tile");
  }
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    for (std::uint32_t i = mesh.first_instance[v]; i < mesh.first_instance[v + 1]; ++i) {
      const std::uint32_t instance = mesh.instances[i];
      const std::size_t leaf = mesh.leaf_of_instance(instance);
      if (mesh.leaf_vertices[instance] != static_cast<std::int32_t>(v) ||
          instance < mesh.first_vertex[leaf] || instance >= mesh.first_vertex[leaf + 1])
        FAIL("an instance is not of its vertex and leaf");
    }
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const Tile_square s = mesh.leaves[static_cast<std::size_t>(mesh.leaf_of_site[i])];
    const int shift = tile_log_side(s.level);
    REQUIRE(s.x >> shift == sites.places[i].x() >> shift);
    REQUIRE(s.y >> shift == sites.places[i].y() >> shift);
    REQUIRE(s.level >= sites.level(i));
  }
}

/// Every site has a vertex of its own, near it or at it, and as far from those of others as wanted.
inline void check_vertices_of_sites(const Tile_mesh& mesh, const Tile_sites& sites, Spacing spacing) {
  std::vector<bool> is_taken(mesh.number_of_vertices(), false);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    REQUIRE(mesh.vertex_of_site[i] >= 0);
    const std::size_t v = static_cast<std::size_t>(mesh.vertex_of_site[i]);
    REQUIRE_FALSE(is_taken[v]);
    is_taken[v] = true;
    REQUIRE(mesh.sides[v] == 0);
    const Difference d = difference(mesh.places[v], {sites.places[i].x(), sites.places[i].y()});
    if (sites.kind(i) != Site_kind::ON_DEMAND) {
      REQUIRE(mesh.is_frozen[v] == 1);
      REQUIRE((d.x == 0 && d.y == 0));
      continue;
    }
    REQUIRE(mesh.is_frozen[v] == 0);
    const std::size_t leaf = static_cast<std::size_t>(mesh.leaf_of_site[i]);
    const auto begin = mesh.leaf_vertices.begin();
    REQUIRE(std::count(begin + mesh.first_vertex[leaf], begin + mesh.first_vertex[leaf + 1],
                       mesh.vertex_of_site[i]) == 1);
    REQUIRE(std::hypot(double(d.x), double(d.y)) <
            0.6000001 * std::ldexp(1.0, tile_log_side(mesh.leaves[leaf].level)));
  }
  if (spacing == Spacing::DISTINCT) return;
  for (const auto& t : mesh.triangles)
    if (is_taken[static_cast<std::size_t>(t[0])] + is_taken[static_cast<std::size_t>(t[1])] +
            is_taken[static_cast<std::size_t>(t[2])] >
        1)
      FAIL("vertices of sites are neighbors");
}

inline bool is_same(const Tile_mesh& a, const Tile_mesh& b) {
  const auto equal_stars = [](const Star_spokes& s, const Star_spokes& t) {
    return s.site == t.site && s.vertices == t.vertices;
  };
  return a.places == b.places && a.sides == b.sides && a.is_frozen == b.is_frozen &&
         a.triangles == b.triangles && a.first_instance == b.first_instance && a.instances == b.instances &&
         a.leaves == b.leaves && a.corner_bits == b.corner_bits && a.first_triangle == b.first_triangle &&
         a.first_vertex == b.first_vertex && a.leaf_vertices == b.leaf_vertices &&
         a.leaf_of_site == b.leaf_of_site && a.vertex_of_site == b.vertex_of_site &&
         a.broken_blocks == b.broken_blocks &&
         std::equal(a.stars.begin(), a.stars.end(), b.stars.begin(), b.stars.end(), equal_stars);
}

/// All that holds for every filling, with the same result by one thread and by many.
inline Tile_filling check_filling(const Tile_sites& sites, const Tile_options& options) {
  Tile_filling f = fill_tiles<CGAL::Sequential_tag>(sites, options);
  check_conformity(f.mesh, sites.window);
  check_leaves(f.mesh, f.sites);
  check_vertices_of_sites(f.mesh, f.sites, options.spacing);
  std::vector<std::size_t> sites_in_leaf(f.mesh.number_of_leaves(), 0);
  for (std::size_t i = 0; i < sites.size(); ++i)
    if (sites.kind(i) == Site_kind::ON_DEMAND)
      ++sites_in_leaf[static_cast<std::size_t>(f.mesh.leaf_of_site[i])];
  REQUIRE(*std::max_element(sites_in_leaf.begin(), sites_in_leaf.end()) <= options.max_points_per_leaf);
  const Tile_filling g = fill_tiles<CGAL::Parallel_tag>(sites, options);
  REQUIRE(is_same(f.mesh, g.mesh));
  REQUIRE(f.sites.levels == g.sites.levels);
  return f;
}

/// \name Sites
/// @{

constexpr std::uint64_t quarter = std::uint64_t(1) << 60;

/// Sites in the middle half of the root.
inline std::vector<Tile_site> uniform_sites(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<Tile_site> places;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint64_t x = quarter + (random() >> 3), y = quarter + (random() >> 3);
    places.push_back({x, y});
  }
  return places;
}

/// Sites in a square of side 2^`log_side`.
inline std::vector<Tile_site> sites_in_square(std::size_t n, std::uint64_t x, std::uint64_t y, int log_side,
                                              unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<Tile_site> places;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint64_t dx = random() >> (64 - log_side), dy = random() >> (64 - log_side);
    places.push_back({x + dx, y + dy});
  }
  return places;
}

/// Clusters of very different size around uniform sites.
inline std::vector<Tile_site> clustered_sites(std::size_t n, unsigned seed) {
  std::vector<Tile_site> places;
  for (const Tile_site& p : uniform_sites(n, seed)) {
    const int log_side = 58 - static_cast<int>(places.size()) % 30;
    const auto cluster =
        sites_in_square(7, p.x(), p.y(), log_side, seed + static_cast<unsigned>(places.size()));
    places.insert(places.end(), cluster.begin(), cluster.end());
  }
  return places;
}

/// Sites on corners and sides of squares of many sizes.
inline std::vector<Tile_site> sites_on_corners_and_sides(unsigned seed) {
  std::mt19937_64 random(seed);
  std::set<Tile_site> places;
  for (int i = 0; i < 60; ++i) {
    const int x = 48 + static_cast<int>(random() % 13), y = 48 + static_cast<int>(random() % 13);
    const Tile_site p = uniform_sites(1, seed * 1000 + static_cast<unsigned>(i))[0];
    places.insert({p.x() >> x << x, p.y() >> y << y});
  }
  return {places.begin(), places.end()};
}

/// Levels with sides of at most the distance to the nearest neighbor, divided by `separation`.
inline std::vector<int> separating_levels(const std::vector<Tile_site>& places, double separation,
                                          int least = 0) {
  std::vector<int> levels;
  for (const double d : near_distances<CGAL::Sequential_tag>(places))
    levels.push_back(std::max(least, level_of_side(d / (near_distance_factor * separation))));
  return levels;
}

/// @}

} // namespace tile_test

#endif // QUADTREE_MESH_2_TEST_TILE_MESH_CHECKS_H
