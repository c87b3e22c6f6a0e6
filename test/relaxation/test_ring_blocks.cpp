// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Blocks of meshes of rings: what they renumber and own.

#include "catch.h"
#include "site_mesh_tools.h"

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Ring_blocks.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test_ring_blocks {

using namespace site_mesh_test;

TEST_CASE("Blocks renumber vertices and own what is inside", "[site_mesh]") {
  using Blocks = internal::Ring_blocks<Tiny_rings_tag, Doubles>;
  Site_mesh<Doubles> site_mesh = filled<CGAL::Sequential_tag>(uniform(30, 5));
  Ring_mesh<Doubles>& mesh = site_mesh.mesh;
  std::uint8_t count = 0;
  for (Ring& r : mesh.rings) r.tried_rings = ++count;
  Blocks blocks(mesh);
  for (int pass = 0; pass <= Blocks::number_of_passes; ++pass) {
    CAPTURE(pass);
    const Ring_mesh<Doubles> old = mesh;
    if (pass < Blocks::number_of_passes)
      blocks.cut(pass);
    else
      blocks.join();
    check_disk(mesh);
    // a bijection of the vertices in use, which keeps all but numbers
    std::set<Ring_vertex> numbers;
    std::size_t alive = 0;
    for (const Ring_vertex i : old.rings.ids()) {
      if (!old.is_alive(i)) continue;
      ++alive;
      const Ring_vertex v = blocks.new_number(i);
      REQUIRE(numbers.insert(v).second);
      const Ring &r = old.rings[i], &s = mesh.ring(v);
      REQUIRE(old.points[i] == mesh.point(v));
      REQUIRE((r.size == s.size && r.is_open == s.is_open && r.mobility == s.mobility &&
               r.tried_rings == s.tried_rings));
      for (int k = 0; k < r.size; ++k) REQUIRE(blocks.new_number(r[k]) == s[k]);
    }
    std::size_t alive_now = 0, visited = 0, owned = 0;
    for (const Ring_vertex v : mesh.rings.ids()) alive_now += mesh.is_alive(v) ? 1 : 0;
    REQUIRE(alive == alive_now);
    // blocks, one after the other
    Ring_vertex begin(0);
    std::int32_t number = 0;
    blocks.for_each_block([&](const Ring_block& block, const auto& marks) {
      REQUIRE(marks.size() == mesh.number_of_vertices());
      REQUIRE(block.number == number++);
      REQUIRE(block.begin == begin);
      REQUIRE(block.begin < block.end);
      REQUIRE(block.spare_end.value() >= block.end.value() + 16);
      begin = block.spare_end;
      for (const Ring_vertex v : internal::Id_range<Ring_vertex>(block.begin, block.end)) {
        REQUIRE(mesh.is_alive(v));
        ++visited;
        const Ring& r = mesh.ring(v);
        bool is_inside = true;
        for (int k = 0; k < r.size; ++k) is_inside = is_inside && !(r[k] < block.begin) && r[k] < block.end;
        REQUIRE(r.block == (is_inside ? block.number : -1));
        owned += is_inside ? 1 : 0;
      }
      for (const Ring_vertex v : internal::Id_range<Ring_vertex>(block.end, block.spare_end))
        REQUIRE_FALSE(mesh.is_alive(v));
    });
    REQUIRE(std::size_t(begin) == mesh.number_of_vertices());
    REQUIRE(visited == alive);
    REQUIRE(std::size_t(number) == blocks.number_of_blocks());
    REQUIRE(blocks.is_whole() == (pass == Blocks::number_of_passes));
    if (blocks.is_whole()) REQUIRE(owned == alive);
    REQUIRE(owned > alive / 3);
  }
}

TEST_CASE("Seams of different passes are in different places", "[site_mesh]") {
  Site_mesh<Doubles> site_mesh = filled<CGAL::Sequential_tag>(uniform(60, 6));
  Ring_mesh<Doubles>& mesh = site_mesh.mesh;
  using Blocks = internal::Ring_blocks<Tiny_rings_tag, Doubles>;
  Blocks blocks(mesh);
  std::map<std::pair<double, double>, int> times_owned;
  for (int pass = 0; pass < Blocks::number_of_passes; ++pass) {
    blocks.cut(pass);
    for (const Ring_vertex v : mesh.rings.ids())
      if (mesh.is_alive(v))
        times_owned[{mesh.points[v].x, mesh.points[v].y}] += mesh.rings[v].block >= 0 ? 1 : 0;
  }
  std::size_t never = 0;
  for (const auto& t : times_owned) never += t.second == 0 ? 1 : 0;
  CHECK(never < times_owned.size() / 20);
}

} // namespace test_ring_blocks
