// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "tile_mesh_checks.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_tile_mesh {

using namespace tile_test;

namespace {

const Tile_options sparse; // as for angles from 36 to 80 degrees
const Tile_options dense{3, Spacing::DISTINCT,
                         std::numeric_limits<double>::infinity()}; // as for acute meshes

Tile_sites on_demand(const std::vector<Tile_site>& places, const Tile_window& window = Tile_window()) {
  return {places, {}, {}, window};
}

/// Sites of one kind, so far apart that their blocks have room.
Tile_sites separated(const std::vector<Tile_site>& places, Site_kind kind, double separation,
                     int least_level = 3) {
  return {places, separating_levels(places, separation, least_level),
          std::vector<Site_kind>(places.size(), kind), Tile_window()};
}

/// Squares of a window around the middle of the root.
Tile_window window_in_the_middle(int level, std::uint64_t columns, std::uint64_t rows) {
  const std::uint64_t middle = std::uint64_t(1) << (level - 1);
  return {level, middle - columns / 2, middle - columns / 2 + columns, middle - rows / 2,
          middle - rows / 2 + rows};
}

/// Only corners of cells and middles between them are vertices on the window's sides.
void check_halved_sides(const Tile_mesh& mesh, const Tile_window& window) {
  const std::uint64_t half_cell = std::uint64_t(1) << (tile_log_side(window.level) - 1);
  std::size_t on_sides = 0;
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    if (mesh.sides[v] == 0) continue;
    ++on_sides;
    REQUIRE(((mesh.places[v].x | mesh.places[v].y) & (half_cell - 1)) == 0);
  }
  CHECK(on_sides == 4 * (window.x1 - window.x0 + window.y1 - window.y0));
}

} // namespace

TEST_CASE("Tiles of no site fill the root", "[tile_mesh]") {
  const Tile_filling f = check_filling({}, sparse);
  CHECK(f.mesh.number_of_leaves() == 1);
  CHECK(f.mesh.number_of_triangles() == 14);
  CHECK(f.number_of_rounds == 1);
  CHECK(is_acute(f.mesh));
}

TEST_CASE("Tiles fit together and every site has a vertex", "[tile_mesh]") {
  for (unsigned seed = 0; seed < (is_full_run() ? 5u : 2u); ++seed)
    for (const Tile_options& options : {sparse, dense}) {
      CAPTURE(seed, options.max_points_per_leaf);
      for (const auto& places : {uniform_sites(1, seed), uniform_sites(2, seed), uniform_sites(100, seed),
                                 clustered_sites(10, seed), sites_on_corners_and_sides(seed)}) {
        const Tile_filling f = check_filling(on_demand(places), options);
        REQUIRE(is_acute(f.mesh));
        const Least_and_greatest_angle range = angles(f.mesh);
        CHECK(range.least > 43.4);
        CHECK(range.greatest < 72.7);
      }
    }
}

TEST_CASE("Leaves of sites shrink with the distance to a near neighbor", "[tile_mesh]") {
  const auto places = clustered_sites(15, 4);
  const auto distances = near_distances<CGAL::Sequential_tag>(places);
  for (double beta : {0.6, 1.0, 2.0}) {
    const Tile_filling f = check_filling(on_demand(places), {1, Spacing::NO_NEIGHBORS, beta});
    for (std::size_t i = 0; i < places.size(); ++i) {
      const int level = f.mesh.leaves[static_cast<std::size_t>(f.mesh.leaf_of_site[i])].level;
      CHECK(std::ldexp(1.0, tile_log_side(level)) <= beta * distances[i]);
    }
  }
}

TEST_CASE("Sites very near each other take few rounds", "[tile_mesh]") {
  for (unsigned seed = 0; seed < (is_full_run() ? 5u : 2u); ++seed) {
    std::vector<Tile_site> places = uniform_sites(60, seed);
    const std::uint64_t middle = 2 * quarter, near = 1 << 14;
    places.push_back({middle - near, middle + near}); // on either side of lines of the largest squares
    places.push_back({middle + near, middle + near});
    for (std::size_t i = 0; i < 15; ++i) {
      const auto pair =
          sites_in_square(1, places[i].x(), places[i].y(), 33, seed * 100 + static_cast<unsigned>(i));
      places.push_back(pair[0]);
    }
    CHECK(check_filling(on_demand(places), sparse).number_of_rounds <= 6);
    CHECK(check_filling(on_demand(places), {3, Spacing::NO_NEIGHBORS, sparse.sides_per_distance})
              .number_of_rounds <= 6);
  }
}

TEST_CASE("Sites that are too near are refused by name", "[tile_mesh]") {
  const std::vector<Tile_site> places{
      {quarter, quarter}, {2 * quarter, 3 * quarter}, {2 * quarter, 3 * quarter + 1}};
  try {
    fill_tiles(on_demand(places), sparse);
    FAIL("no exception");
  } catch (const std::length_error& e) {
    CHECK(std::string(e.what()).find("point 1 ") != std::string::npos);
  }
  // As near as leaves allow.
  check_filling(on_demand({{quarter, quarter}, {quarter + (1 << 14), quarter}}), sparse);
}

TEST_CASE("Windows are filled as if nothing were outside", "[tile_mesh]") {
  for (unsigned seed = 0; seed < (is_full_run() ? 6u : 3u); ++seed) {
    const Tile_window row = window_in_the_middle(5, 9, 1);
    std::vector<Tile_site> places;
    for (std::uint64_t x = row.x0; x < row.x1; ++x) {
      const auto few = sites_in_square(2, x << 57, row.y0 << 57, 57, seed * 100 + static_cast<unsigned>(x));
      places.insert(places.end(), few.begin(), few.end());
    }
    CHECK(is_acute(check_filling(on_demand(places, row), sparse).mesh));
    CHECK(is_acute(check_filling(on_demand({}, row), sparse).mesh));
    CHECK(is_acute(check_filling(on_demand(places, row), dense).mesh));
  }
}

TEST_CASE("Sites in the middle cell of five by five do not reach the window's sides", "[tile_mesh]") {
  const Tile_window cells = window_in_the_middle(6, 5, 5);
  const int log_cell = tile_log_side(6);
  const std::uint64_t x = (cells.x0 + 2) << log_cell, y = (cells.y0 + 2) << log_cell;
  const std::uint64_t last = (std::uint64_t(1) << log_cell) - 1;
  for (unsigned seed = 0; seed < (is_full_run() ? 30u : 10u); ++seed) {
    CAPTURE(seed);
    std::vector<Tile_site> places;
    for (int i = 0; i < 5; ++i) { // near the corners of the middle cell, and all over it
      const int log_side = log_cell - i * static_cast<int>(1 + seed % 7);
      const auto few = sites_in_square(1 + seed % 9, x, y, log_side, seed * 10 + static_cast<unsigned>(i));
      places.insert(places.end(), few.begin(), few.end());
    }
    places.push_back({x + last, y + last});
    places.push_back({x + last, y});
    places.push_back({x + last - (std::uint64_t(1) << (30 - static_cast<int>(seed % 10))), y});
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    for (const Tile_options& options : {sparse, dense}) {
      const Tile_filling f = check_filling(on_demand(places, cells), options);
      CHECK(is_acute(f.mesh));
      check_halved_sides(f.mesh, cells);
    }
  }
}

TEST_CASE("Warped sites and stars in the middle cell of five by five do not reach the window's sides",
          "[tile_mesh]") {
  const Tile_window cells = window_in_the_middle(4, 5, 5);
  const int log_cell = tile_log_side(4);
  for (unsigned seed = 0; seed < (is_full_run() ? 30u : 10u); ++seed)
    for (const Site_kind kind : {Site_kind::WARPED, Site_kind::STAR}) {
      CAPTURE(seed, int(kind));
      std::vector<Tile_site> places;
      for (int i = 0; i < 3; ++i) {
        const auto few = sites_in_square(1 + seed % 5, (cells.x0 + 2) << log_cell, (cells.y0 + 2) << log_cell,
                                         log_cell - i * static_cast<int>(1 + seed % 5),
                                         seed * 10 + static_cast<unsigned>(i));
        places.insert(places.end(), few.begin(), few.end());
      }
      Tile_sites sites = separated(places, kind, 7, cells.level + 3);
      sites.window = cells;
      const Tile_filling f = check_filling(sites, sparse);
      CHECK(f.number_of_rounds == 1);
      check_halved_sides(f.mesh, cells);
    }
}

TEST_CASE("Leaves of sites are split when asked for", "[tile_mesh]") {
  Tile_filler<> filler(on_demand(uniform_sites(50, 3)), sparse);
  filler.set_first_levels();
  filler.fill();
  for (int i = 0; i < (is_full_run() ? 10 : 4); ++i) {
    const Tile_mesh& mesh = filler.filling().mesh;
    const int before = mesh.leaves[static_cast<std::size_t>(mesh.leaf_of_site[7])].level;
    filler.split(7);
    filler.fill();
    CHECK(mesh.leaves[static_cast<std::size_t>(mesh.leaf_of_site[7])].level > before);
    check_conformity(mesh, filler.filling().sites.window);
    check_vertices_of_sites(mesh, filler.filling().sites, Spacing::NO_NEIGHBORS);
  }
}

TEST_CASE("Warps of separated sites keep angles between 36 and 80 degrees", "[tile_mesh]") {
  for (unsigned seed = 0; seed < (is_full_run() ? 5u : 2u); ++seed) {
    CAPTURE(seed);
    for (const auto& places : {uniform_sites(1, seed), uniform_sites(2, seed), uniform_sites(30, seed),
                               clustered_sites(3, seed), sites_on_corners_and_sides(seed)}) {
      const Tile_sites sites = separated(places, Site_kind::WARPED, 6);
      const Tile_filling f = check_filling(sites, sparse);
      CHECK(f.number_of_rounds == 1);
      CHECK(f.sites.levels == sites.levels);
      const Least_and_greatest_angle range = angles(f.mesh);
      CHECK(range.least >= 37.5);
      CHECK(range.greatest <= 78.6);
    }
  }
}

TEST_CASE("A site in the middle of a square or in a corner is warped", "[tile_mesh]") {
  const std::uint64_t side = std::uint64_t(1) << 50, half = side / 2;
  for (const Tile_site& p : {Tile_site{quarter + half, quarter + half}, Tile_site{quarter, quarter},
                             Tile_site{quarter, quarter + half}, Tile_site{quarter + side - 1, quarter}}) {
    const Tile_sites sites{{p}, {12}, {Site_kind::WARPED}, Tile_window()};
    const Tile_filling f = check_filling(sites, sparse);
    CHECK(f.number_of_rounds == 1);
    std::size_t frozen = 0;
    for (const auto bit : f.mesh.is_frozen) frozen += bit;
    CHECK(frozen == 52);
    CHECK(angles(f.mesh).least >= 37.5);
  }
}

TEST_CASE("Stars move with their spokes and keep angles bounded", "[tile_mesh]") {
  for (unsigned seed = 0; seed < (is_full_run() ? 5u : 2u); ++seed) {
    CAPTURE(seed);
    for (const auto& places : {uniform_sites(1, seed), uniform_sites(2, seed), uniform_sites(30, seed),
                               clustered_sites(3, seed), sites_on_corners_and_sides(seed)}) {
      const Tile_sites sites = separated(places, Site_kind::STAR, 7);
      const Tile_filling f = check_filling(sites, sparse);
      CHECK(f.number_of_rounds == 1);
      REQUIRE(f.mesh.stars.size() == places.size());
      for (std::size_t i = 0; i < places.size(); ++i) {
        const Star_spokes& star = f.mesh.stars[i];
        REQUIRE(star.site == i);
        const std::int64_t side = std::int64_t(1) << tile_log_side(sites.levels[i]);
        const std::array<std::array<int, 2>, 8> ways{
            {{512, 0}, {339, 339}, {0, 512}, {-386, 386}, {-512, 0}, {-339, -339}, {0, -512}, {386, -386}}};
        for (std::size_t k = 0; k < 8; ++k) {
          const Difference d = difference({places[i].x(), places[i].y()}, place(f.mesh, star.vertices[k]));
          REQUIRE((d.x == side / 1024 * ways[k][0] && d.y == side / 1024 * ways[k][1]));
        }
      }
      const Least_and_greatest_angle range = angles(f.mesh);
      CHECK(range.least >= 18.3);
      CHECK(range.greatest <= 87.5);
    }
  }
}

TEST_CASE("Blocks without room are moved to smaller leaves", "[tile_mesh]") {
  for (unsigned seed = 0; seed < (is_full_run() ? 5u : 2u); ++seed) {
    CAPTURE(seed);
    for (const auto& places : {uniform_sites(40, seed), clustered_sites(4, seed)}) {
      Tile_sites sites = on_demand(places);
      for (std::size_t i = 0; i < places.size(); ++i)
        sites.kinds.push_back(i % 3 == 0   ? Site_kind::ON_DEMAND
                              : i % 3 == 1 ? Site_kind::WARPED
                                           : Site_kind::STAR);
      sites.levels.assign(places.size(), 2);
      const Tile_filling f = check_filling(sites, sparse);
      CHECK(f.mesh.broken_blocks.empty());
      CHECK(f.number_of_rounds <= 25);
    }
  }
}

TEST_CASE("Blocks that overlap or leave the window are broken", "[tile_mesh]") {
  const std::uint64_t side = std::uint64_t(1) << 52; // of level 10
  const auto broken = [](const Tile_sites& sites) {
    return Tile_mesh_builder<>(sites).build().broken_blocks;
  };
  using Sites = std::vector<std::uint32_t>;
  const std::vector<Site_kind> warped(2, Site_kind::WARPED);
  CHECK(broken({{{quarter, quarter}, {quarter + 2 * side, quarter}}, {10, 10}, warped, Tile_window()}) ==
        Sites{0, 1});
  CHECK(
      broken({{{quarter, quarter}, {quarter + 3 * side, quarter}}, {10, 10}, warped, Tile_window()}).empty());
  CHECK(broken({{{quarter, quarter}, {quarter + 3 * side, quarter}}, {10, 11}, warped, Tile_window()}) ==
        Sites{0});
  CHECK(broken({{{quarter, quarter}, {3 * side, side / 2}}, {10, 10}, warped, Tile_window()}) == Sites{1});
}

TEST_CASE("Many sites", "[tile_mesh]") {
  const Tile_filling f = check_filling(on_demand(uniform_sites(3000, 5)), sparse);
  CHECK(is_acute(f.mesh));
  CHECK(f.mesh.number_of_triangles() < 85 * 3000);
  CHECK(check_filling(on_demand(uniform_sites(3000, 5)), dense).mesh.number_of_triangles() < 20 * 3000);
}

} // namespace test_tile_mesh
