// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Rounds of blocks of a mesh in several memories: the bits of one memory for any number of parts, none of which has
// all.

#include "catch.h"
#include "mesher_test_tools.h"
#include "pslg_inputs.h"
#include "random_pslg_shapes.h"
#include "rounds_of_parts_checks.h"
#include "tiny_blocks.h"

#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace test_rounds_of_parts {

namespace {

using namespace rounds_of_parts_checks;
using mesher_test::Pslg;

struct Comparisons {
  std::vector<Comparison> of_parts;
  std::vector<Exchange_traffic> traffic; ///< of the comparison, too
};

template <class Tag, class Change>
Comparisons comparisons_of(const One_memory<Tag>& expected, const Pslg& pslg, int parts,
                           const Change& change) {
  Comparisons comparisons;
  comparisons.of_parts.resize(std::size_t(parts));
  comparisons.traffic = In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
    comparisons.of_parts[std::size_t(exchange.rank())] =
        compare_with_one_memory(exchange, expected, pslg, change);
  });
  return comparisons;
}

/// \returns for how many numbers of parts there were blocks
template <class Tag, class Change>
int check_all_parts(const Pslg& pslg, const Change& change) {
  const One_memory<Tag> expected(pslg, change);
  int cut = 0;
  for (const int parts : {1, 2, 3, 7}) {
    CAPTURE(parts);
    const Comparison comparison = comparisons_of(expected, pslg, parts, change).of_parts.front();
    CHECK(comparison.faults == 0);
    if (comparison.has_blocks) ++cut;
  }
  return cut;
}
template <class Tag>
int check_all_parts(const Pslg& pslg) {
  return check_all_parts<Tag>(pslg, [](Prepared&) {});
}

/// The same graph with its vertices in the order of places, as the mesher has them.
Pslg in_order_of_places(const Pslg& pslg) {
  std::vector<Geometry::Point> points;
  for (const auto& p : pslg.vertices) points.push_back({p.x(), p.y()});
  const Place_keys<Geometry> key(points);
  std::vector<std::size_t> order(points.size()), place(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key(points[a]) < key(points[b]); });
  Pslg sorted;
  for (const std::size_t i : order) place[i] = sorted.vertices.size(), sorted.add_vertex(pslg.vertices[i]);
  for (const auto& [a, b] : pslg.segments)
    sorted.add_segment(CGAL::Quadtree_mesh_2::Vertex_index(place[std::size_t(a)]),
                       CGAL::Quadtree_mesh_2::Vertex_index(place[std::size_t(b)]));
  return sorted;
}

} // namespace

TEST_CASE("Parts of random graphs in tiny blocks have the bits of one memory", "[parts][distributed]") {
  const auto& families = random_pslg::all_families();
  const std::uint64_t seeds = is_full_run() ? 100 : 2;
  int cut = 0;
  for (const auto& family : families)
    for (std::uint64_t seed = 100; seed < 100 + seeds; ++seed) {
      CAPTURE(family.name, seed);
      cut += check_all_parts<Tiny_blocks_tag>(family.make(seed));
    }
  CHECK(cut > 20);
}

TEST_CASE("Parts of graphs with acute corners and holes have the bits of one memory",
          "[parts][distributed]") {
  std::vector<const char*> names{"stars:200", "coast:1000", "holes:50"};
  if (is_full_run()) names = {"stars:600", "coast:2000", "holes:100", "blob:600", "segments:600"};
  for (const char* name : names) {
    CAPTURE(name);
    CHECK(check_all_parts<Tiny_blocks_tag>(pslg_inputs::by_name(name).pslg) == 4);
  }
  CHECK(check_all_parts<Small_blocks_tag>(
            pslg_inputs::by_name(is_full_run() ? "coast:4000" : "coast:3000").pslg) == 4);
  if (!is_full_run()) return;
  const Pslg states = mesher_test::read("us_states_10m.poly.gz");
  CHECK(check_all_parts<Tiny_blocks_tag>(states) == 4);
  CHECK(check_all_parts<Small_blocks_tag>(states) == 4);
}

TEST_CASE("Parts with regions that have bounds of their own have the bits of one memory",
          "[parts][distributed]") {
  const double share = is_full_run() ? 1e-4 : 1e-3;
  const auto change = [share](Prepared& prepared) { bound_every_other_region(prepared, share); };
  const char* const stars = is_full_run() ? "stars:600" : "stars:200";
  CHECK(check_all_parts<Tiny_blocks_tag>(pslg_inputs::by_name(stars).pslg, change) == 4);
  if (is_full_run())
    CHECK(check_all_parts<Small_blocks_tag>(mesher_test::read("us_states_10m.poly.gz"), change) == 4);
}

TEST_CASE("Parts of a coast have its bits, and their share of it and the zones", "[parts][distributed]") {
  const Pslg norway = in_order_of_places(mesher_test::read("gshhg_norway_f.poly.gz"));
  const auto unchanged = [](Prepared&) {};
  const One_memory<CGAL::Parallel_tag> expected(norway, unchanged);
  for (const int parts : is_full_run() ? std::vector<int>{2, 7} : std::vector<int>{2}) {
    CAPTURE(parts);
    const Comparisons comparisons = comparisons_of(expected, norway, parts, unchanged);
    Comparison most = comparisons.of_parts.front();
    CHECK(most.faults == 0);
    CHECK(most.has_blocks);
    for (const Comparison& o : comparisons.of_parts) {
      most.number_private = std::max(most.number_private, o.number_private);
      most.most_held = std::max(most.most_held, o.most_held);
    }
    CHECK(most.number_shared <
          most.triangles * 15 / 100); // what is in zones, 7 percent before they are refined
    CHECK(most.number_private * std::size_t(parts) < most.triangles * 16 / 10); // there are few blocks
    CHECK(most.most_held < most.number_private + most.triangles * 15 / 100);
    CHECK(comparisons.traffic.front().exchanges < 200);
    Exchange_traffic of_rounds; // the first part has sent the mesh, too
    for (std::size_t p = 1; p < std::size_t(parts); ++p) {
      const Exchange_traffic& t = comparisons.traffic[p];
      of_rounds.messages = std::max(of_rounds.messages, t.messages);
      of_rounds.bytes = std::max(of_rounds.bytes, t.bytes);
    }
    if (is_full_run())
      WARN(parts << " parts: " << most.rounds << " rounds, " << most.triangles
                 << " triangles, of which one held " << most.most_held << " at most, " << most.number_private
                 << " of its own, and all " << most.number_shared << "; one sent " << of_rounds.messages
                 << " messages and " << of_rounds.bytes << " bytes at most in "
                 << comparisons.traffic.front().exchanges << " exchanges");
  }
}

} // namespace test_rounds_of_parts
