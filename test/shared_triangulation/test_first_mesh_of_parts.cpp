// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Domains triangulated by parts: the triangles, edges and regions of one memory.

#include "catch.h"
#include "first_meshes.h"
#include "pslg_inputs.h"
#include "random_pslg_shapes.h"

#include <CGAL/IO/read_triangle_files.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace test_first_mesh_of_parts {

namespace {

using namespace first_meshes;

enum class Wanted { MADE, ANYTHING };

template <class Tag = Tiny_blocks_tag>
void check(const Pslg& pslg, Rule domain = Rule::ENCLOSED, Wanted wanted = Wanted::MADE,
           const std::vector<int>& numbers = {1, 2, 3, 5, 8}) {
  const Sorted_graph graph(pslg, domain);
  const Domain_mesh expected = in_one_memory(graph, Block_sizes<Tag>::vertices);
  for (const int parts : numbers) {
    CAPTURE(parts);
    const Domain_mesh made = by_parts<Tag>(graph, parts);
    if (wanted == Wanted::MADE) CHECK(made.is_made);
    if (!made.is_made) continue;
    CHECK(expected.is_made);
    CHECK(difference(made, expected) == "");
  }
}

Pslg named(const char* name) { return pslg_inputs::by_name(name).pslg; }

void add_segment(Pslg& pslg, std::size_t a, std::size_t b) {
  pslg.add_segment(CGAL::Quadtree_mesh_2::Vertex_index(a), CGAL::Quadtree_mesh_2::Vertex_index(b));
}

/// Closed polygons one in the other, as squares around the origin with sides cut by vertices.
Pslg nested_squares(int squares, int cuts) {
  Pslg pslg;
  for (int i = 1; i <= squares; ++i) {
    const std::size_t first = pslg.number_of_vertices();
    for (int side = 0; side < 4; ++side)
      for (int k = 0; k < cuts; ++k) {
        const double along = i * (2.0 * k / cuts - 1);
        const double x[4] = {along, double(i), -along, double(-i)},
                     y[4] = {double(-i), along, double(i), -along};
        pslg.add_vertex(Point_2(x[side], y[side]));
      }
    const std::size_t n = pslg.number_of_vertices() - first;
    for (std::size_t k = 0; k < n; ++k) add_segment(pslg, first + k, first + (k + 1) % n);
  }
  return pslg;
}

/// All points of a lattice, and a segment along each row, which all its vertices are on, twice in every other row.
Pslg lattice(int side) {
  Pslg pslg;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) pslg.add_vertex(Point_2(x, y));
  const auto at = [side](int x, int y) { return static_cast<std::size_t>(y * side + x); };
  for (int y = 0; y < side; ++y) {
    add_segment(pslg, at(0, y), at(side - 1, y));
    if (y % 2 == 0) add_segment(pslg, at(1, y), at(side - 2, y)), add_segment(pslg, at(3, y), at(2, y));
  }
  add_segment(pslg, at(0, 0), at(0, side - 1)), add_segment(pslg, at(side - 1, 0), at(side - 1, side - 1));
  return pslg;
}

} // namespace

TEST_CASE("Parts triangulate the domains of random graphs", "[parts][distributed]") {
  for (const auto& family : random_pslg::all_families())
    for (unsigned seed = 0; seed < (is_full_run() ? 8 : 3); ++seed) {
      CAPTURE(family.name, seed);
      check(family.make(seed));
    }
}

TEST_CASE("Parts with several threads triangulate the domain of one thread",
          "[parts][distributed][threads]") {
  const Threads_for_tiny_blocks threads;
  for (const auto& family : random_pslg::all_families()) {
    CAPTURE(family.name);
    check(family.make(3));
  }
}

TEST_CASE("Parts triangulate named graphs, with blocks of some hundred vertices", "[parts][distributed]") {
  std::vector<const char*> names{"coast:5e3", "segments:1e3", "holes:250", "stars:1e3",
                                 "koch:768",  "fan:1",        "comb:300"};
  if (is_full_run())
    names = {"coast:2e4", "segments:3e3", "holes:1e3", "stars:3e3", "koch:3e3", "fan:1", "comb:1e3"};
  for (const char* name : names) {
    CAPTURE(name);
    check<Small_blocks_tag>(named(name));
  }
  Pslg aegean;
  CGAL::IO::read_triangle_poly(QUADTREE_MESH_TEST_DATA_DIR "/gshhg_aegean_h.poly.gz", aegean);
  check<Small_blocks_tag>(aegean, Rule::ENCLOSED, Wanted::MADE,
                          is_full_run() ? std::vector<int>{1, 2, 3, 5, 8} : std::vector<int>{3});
}

TEST_CASE("Parts leave to one memory what would take them long", "[parts][distributed]") {
  for (const char* name : {"circle:1e4", "blob:2e4", "parabola:1e4", "line:1e4"}) {
    CAPTURE(name);
    check<Small_blocks_tag>(named(name), Rule::ENCLOSED, Wanted::ANYTHING,
                            is_full_run() ? std::vector<int>{1, 2, 3, 5, 8} : std::vector<int>{1, 3});
  }
}

TEST_CASE("Parts have the levels, holes and regions of one memory", "[parts][distributed]") {
  Pslg pslg = nested_squares(9, 16);
  for (const Rule rule : {Rule::ENCLOSED, Rule::NESTING_PARITY}) check(pslg, rule);
  for (const int i : {2, 5, 4}) pslg.regions.push_back({Point_2(0.3, i - 0.45), double(i), 0});
  pslg.regions.push_back({Point_2(0.3, 4.9), 10.0, 0}); // a second one in one component
  pslg.regions.push_back({Point_2(1e3, 1e4), 11.0, 0}); // beyond all triangles
  pslg.regions.push_back({Point_2(9.5, 9.5), 12.0, 0}); // outside
  for (const Rule rule : {Rule::ENCLOSED, Rule::NESTING_PARITY, Rule::MARKED}) check(pslg, rule);
  for (const int i : {1, 5, 7}) pslg.holes.push_back(Point_2(-0.3, 0.45 - i));
  for (const Rule rule : {Rule::ENCLOSED, Rule::NESTING_PARITY, Rule::MARKED}) check(pslg, rule);
}

TEST_CASE("Parts leave ambiguous seeds and crossings to one memory", "[parts][distributed]") {
  const Pslg squares = nested_squares(9, 16);
  const auto is_made = [](const Pslg& pslg) {
    return by_parts<Tiny_blocks_tag>(Sorted_graph(pslg, Rule::ENCLOSED), 3).is_made;
  };
  CHECK(is_made(squares));
  Pslg seeds = squares;
  seeds.holes.push_back(Point_2(0.3, 5)); // on a segment
  CHECK_FALSE(is_made(seeds));
  seeds.holes.clear(), seeds.regions.push_back({Point_2(5, 5), 1.0, 0}); // on a vertex
  CHECK_FALSE(is_made(seeds));
  Pslg crossing = squares;
  const auto a = crossing.add_vertex(Point_2(0.1, 0.2)), b = crossing.add_vertex(Point_2(0.1, 7.2));
  crossing.add_segment(a, b);
  CHECK_FALSE(is_made(crossing));
}

TEST_CASE("Parts make edges of segments that run through vertices, and along others",
          "[parts][distributed]") {
  check(lattice(12));
  check(lattice(12), Rule::NESTING_PARITY);
  check<Small_blocks_tag>(lattice(40));
}

TEST_CASE("Parts merge vertices at one place", "[parts][distributed]") {
  Pslg pslg = nested_squares(9, 16);
  const std::size_t n = pslg.number_of_vertices();
  for (std::size_t v = 0; v < n; v += 3) {
    const auto twin = pslg.add_vertex(pslg.vertices[v]);
    add_segment(pslg, std::size_t(twin), (v / 64) * 64 + (v + 1) % 64); // along another one
    if (v % 2 == 0) pslg.add_vertex(pslg.vertices[v]);
    if (v % 4 == 0) add_segment(pslg, std::size_t(twin), v); // of no length
  }
  check(pslg);
}

TEST_CASE("Parts flip flat triangles outside as one memory does", "[parts][distributed]") {
  // Sides of squares whose vertices are units in the last place off their lines.
  for (const double off : {1e-9, 1e-12, 1e-15}) {
    CAPTURE(off);
    Pslg pslg = nested_squares(6, 24);
    random_pslg::Random random(5);
    for (auto& p : pslg.vertices)
      p = Point_2(p.x() + random.between(-off, off), p.y() + random.between(-off, off));
    pslg.holes.push_back(Point_2(0.1, 0.1)), pslg.holes.push_back(Point_2(0.1, 3.5));
    check(pslg);
    check(pslg, Rule::NESTING_PARITY);
  }
}

TEST_CASE("Parts agree on places so near to each other that products underflow", "[parts][distributed]") {
  constexpr double tiny = 1e-115, extent = 0x1p199;
  for (unsigned seed = 0; seed < 6; ++seed) {
    CAPTURE(seed);
    random_pslg::Random random(seed);
    Pslg pslg;
    for (int i = random.integer(4, 60); i > 0; --i)
      pslg.add_vertex(Point_2(random.between(-extent, extent), random.between(-extent, extent)));
    const std::size_t first = pslg.number_of_vertices();
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
      pslg.add_vertex(Point_2(x * extent, y * extent));
    for (std::size_t k = 0; k < 4; ++k) add_segment(pslg, first + k, first + (k + 1) % 4);
    const int side = random.integer(6, 10);
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j)
        pslg.add_vertex(
            Point_2(tiny * (1000 * i + random.integer(0, 998)), tiny * (1000 * j + random.integer(0, 998))));
    check(pslg, Rule::ENCLOSED, Wanted::ANYTHING);
  }
}

TEST_CASE("Segments that meet in a vertex between their ends are no error of parts", "[parts][distributed]") {
  Pslg pslg = nested_squares(1, 50);
  const auto center = pslg.add_vertex(Point_2(0, 0));
  for (std::size_t v = 0; v < 100; v += 4) add_segment(pslg, v, v + 100);
  static_cast<void>(center);
  check(pslg, Rule::ENCLOSED, Wanted::ANYTHING);
}

TEST_CASE("Parts cut the spokes of a hub", "[parts][distributed]") {
  constexpr int spokes = 300;
  Pslg pslg;
  pslg.add_vertex(Point_2(0, 0));
  for (int i = 0; i < spokes; ++i)
    for (const double r : {1.0, 2.0}) // by powers of two, so that vertices are on segments exactly
      pslg.add_vertex(Point_2(r * (i - spokes / 2), r * spokes));
  for (std::size_t i = 0; i < spokes; ++i) add_segment(pslg, 0, 2 * i + 2);
  check<Small_blocks_tag>(pslg, Rule::ENCLOSED, Wanted::ANYTHING);
}

} // namespace test_first_mesh_of_parts
