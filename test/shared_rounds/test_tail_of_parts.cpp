// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What follows on the rounds, done by all parts, so that nobody has the whole mesh: the mesh, its order and the report
// of one memory, for meshes that are large enough.

#include "catch.h"
#include "meshes_by_all_parts.h"
#include "pslg_inputs.h"
#include "pslg_test_tools.h"
#include "random_pslg_shapes.h"

#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Handle_owners.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Key_ranker.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace test_tail_of_parts {

namespace {

using namespace meshes_by_all_parts;
using namespace CGAL::Quadtree_mesh_2::internal;

/// A graph n x n times, beside each other: all that it has, too.
Pslg copies(const Pslg& one, int n) {
  if (one.vertices.empty()) return one;
  const auto box = Coordinate_ranges<double>::of(one.vertices);
  const double step = 1.25 * std::max(box.extent(), 1e-3);
  Pslg all;
  all.region_names = one.region_names, all.marker_names = one.marker_names;
  for (int i = 0; i < n * n; ++i) {
    const auto moved = [&](const Point& p) { return Point(p.x() + step * (i % n), p.y() + step * (i / n)); };
    const std::size_t first = all.vertices.size();
    for (const Point& p : one.vertices) all.add_vertex(moved(p));
    for (const auto& [a, b] : one.segments)
      all.add_segment(Vertex_index(first + std::size_t(a)), Vertex_index(first + std::size_t(b)));
    for (const Point& p : one.holes) all.holes.push_back(moved(p));
    for (const auto& r : one.regions) all.regions.push_back({moved(r.point), r.attribute, r.max_area});
    all.vertex_markers.insert(all.vertex_markers.end(), one.vertex_markers.begin(), one.vertex_markers.end());
    all.segment_markers.insert(all.segment_markers.end(), one.segment_markers.begin(),
                               one.segment_markers.end());
  }
  return all;
}

/// Whether parts finish a mesh themselves, and what is wrong with it.
struct Outcome {
  bool is_in_parts = false;
  std::string wrong;
};

template <class Tag>
Outcome mesh_by_parts(int parts, const Result& expected, const Pslg& pslg, const Options& options) {
  std::atomic<int> in_parts{0}, other_parts{0};
  bool is_same_report = false;
  In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
    const bool is_first = exchange.rank() == 0;
    Mesher_with<Tag> mesher(options);
    CGAL::Quadtree_mesh_2::internal::Mesh_in_parts<Point> part;
    Report report;
    Mesh whole;
    CGAL::Quadtree_mesh_2::internal::Stowable_graph<Point> stowable(Pslg{pslg});
    if (is_first)
      whole = lead(exchange, mesher, stowable, report, part);
    else
      part = Helper_of_first_part<Traits, Inner_tag<Tag>, In_memory_exchange>(exchange, options).run();
    in_parts += part ? 1 : 0;
    if (is_first) is_same_report = is_same(report, expected.report);
    const Pslg& graph = is_first ? pslg : Pslg();
    if (part)
      complete_part(exchange, *part);
    else
      part = distribute_mesh(exchange, whole, graph, 0);
    const Part right = distribute_mesh(exchange, is_first ? expected.mesh : Mesh(), graph, 0);
    other_parts += bytes_of_mesh(*part) == bytes_of_mesh(right) ? 0 : 1;
  });
  std::string wrong;
  if (!is_same_report) wrong += "the report is another one; ";
  if (other_parts > 0) wrong += "parts are other ones; ";
  return {in_parts == parts, wrong};
}

/// Where bounds of size may have flips make bad triangles, the first part may go on.
enum class Finisher { PARTS, ANYBODY };

template <class Tag>
void check(const std::vector<int>& numbers, const Pslg& pslg, const Options& options,
           Finisher finisher = Finisher::PARTS) {
  const Result expected = in_one_memory<Tag>(pslg, options);
  if (options.mesh_domain() == Options::Domain::ENCLOSED) CHECK(is_valid(expected.mesh, pslg));
  for (const int parts : numbers) {
    CAPTURE(parts);
    const Outcome outcome = mesh_by_parts<Tag>(parts, expected, pslg, options);
    CHECK(outcome.wrong == "");
    if (finisher == Finisher::PARTS) CHECK(outcome.is_in_parts);
  }
}

/// Stars of a few segments at angles down to 10^-6, each in a unit square of n x n.
Pslg needles(int n, std::uint64_t seed) {
  random_pslg::Random random(seed);
  Pslg pslg = pslg_test::make_pslg<double>(
      {{-1, -1}, {double(n), -1}, {double(n), double(n)}, {-1, double(n)}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  for (int i = 0; i < n * n; ++i) {
    const double x = i % n, y = i / n, turn = random.between(0, 7);
    const double angle = std::pow(10, random.between(-6, -1));
    const Vertex_index center = pslg.add_vertex(Point(x, y));
    for (int k = random.integer(2, 6); k > 0; --k) {
      const double direction = turn + k * angle;
      pslg.add_segment(center,
                       pslg.add_vertex(Point(x + 0.4 * std::cos(direction), y + 0.4 * std::sin(direction))));
    }
  }
  return pslg;
}

Pslg named(const char* name) { return pslg_inputs::by_name(name).pslg; }

} // namespace

TEST_CASE("Parts finish a mesh without having all of it", "[parts][distributed]") {
  const bool is_large = is_full_run();
  const Pslg coast = named(is_large ? "coast:2000" : "coast:1000");
  check<Tiny_blocks_tag>({2, 7}, coast, Options());
  check<Tiny_blocks_tag>({4}, coast, Options().min_angle(28));
  check<Tiny_blocks_tag>({3}, coast, sizes_in_halves(coast), Finisher::ANYBODY);
  check<Tiny_blocks_tag>({2}, named("holes:600"), Options());
  check<Tiny_blocks_tag>({5}, named(is_large ? "segments:400" : "segments:200"), Options());
  check<Small_blocks_tag>({3}, named(is_large ? "stars:8000" : "stars:800"), Options(), Finisher::ANYBODY);
}

TEST_CASE("Parts unlock sectors next to triangles that were in no block", "[parts][distributed]") {
  for (std::uint64_t seed = 1; seed <= (is_full_run() ? 20 : 1); ++seed) {
    CAPTURE(seed);
    check<Small_blocks_tag>({2, 4}, needles(12, seed), Options().max_edge(0.1), Finisher::ANYBODY);
  }
}

TEST_CASE("Parts finish a mesh with markers, regions, and segments outside", "[parts][distributed]") {
  Pslg one = with_all().pslg;
  check<Tiny_blocks_tag>({3}, copies(one, 6), Options(), Finisher::ANYBODY);
  for (auto& region : one.regions) region.max_area = 0;
  const Pslg all = copies(one, 12);
  check<Tiny_blocks_tag>({7}, all, Options());
  check<Small_blocks_tag>({2}, all, Options());
  check<Small_blocks_tag>({3}, all, Options().mesh_domain(Options::Domain::NESTING_PARITY));
}

TEST_CASE("Parts finish the mesh of a map", "[parts][distributed]") {
  Pslg states;
  CGAL::IO::read_triangle_poly(QUADTREE_MESH_TEST_DATA_DIR "/us_states_10m.poly.gz", states);
  check<Small_blocks_tag>(is_full_run() ? std::vector<int>{2, 3, 4, 7} : std::vector<int>{3}, states,
                          Options());
}

TEST_CASE("Parts make many copies of random graphs as one memory does", "[parts][distributed]") {
  int in_parts = 0, all = 0;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 1; seed <= (is_full_run() ? 8 : 1); ++seed) {
      CAPTURE(family.name, seed);
      const Pslg one = family.make(seed), pslg = copies(one, one.vertices.size() < 40 ? 6
                                                             : is_full_run()          ? 3
                                                                                      : 2);
      std::optional<Result> expected;
      try {
        expected = in_one_memory<Tiny_blocks_tag>(pslg, Options());
      } catch (const CGAL::Pslg_error_2&) {
        continue; // moved vertices are rounded
      }
      if (expected->report.triangles > 20000) continue;
      const Outcome outcome = mesh_by_parts<Tiny_blocks_tag>(2 + int(seed % 4), *expected, pslg, Options());
      CHECK(outcome.wrong == "");
      in_parts += outcome.is_in_parts ? 1 : 0, ++all;
    }
  CAPTURE(in_parts, all);
  CHECK(5 * in_parts > all); // others are small, or have something left
}

TEST_CASE("What more follows on the rounds is done by the first part", "[parts][distributed]") {
  const Pslg coast = named("coast:2000");
  for (const Options& options : {Options().thin(1), Options().conform(Options::Conforming::DELAUNAY),
                                 Options().keep_borders(Options::Keep_borders::ALL)}) {
    const Result expected = in_one_memory<Tiny_blocks_tag>(coast, options);
    const Outcome outcome = mesh_by_parts<Tiny_blocks_tag>(3, expected, coast, options);
    CHECK(outcome.wrong == "");
    CHECK_FALSE(outcome.is_in_parts);
  }
}

TEST_CASE("Handles have one owner and one place", "[parts]") {
  for (const int parts : {1, 2, 3, 7}) {
    const Handle_owners owners(parts);
    const std::size_t n = 50000;
    std::set<std::size_t> seen;
    for (std::size_t h = 0; h < n; ++h) {
      const int owner = owners.owner(h);
      const std::size_t place = owners.place(h);
      CHECK((owner >= 0 && owner < parts && place < owners.places(n)));
      REQUIRE(owners.handle(owner, place) == h);
      seen.insert(place * std::size_t(parts) + std::size_t(owner));
    }
    CHECK(seen.size() == n);
  }
}

TEST_CASE("Keys of parts have the positions that they have in one memory", "[parts]") {
  for (const int parts : {1, 2, 5}) {
    random_pslg::Random random(std::uint64_t(40) + std::uint64_t(parts));
    constexpr std::uint64_t range = 3000;
    std::set<std::uint64_t> keys;
    while (keys.size() < 5000) keys.insert(random.bits() % range << 32 | random.bits() % 1000);
    const std::vector<std::uint64_t> sorted(keys.begin(), keys.end());
    std::vector<Uninitialized_vector<std::uint64_t>> of_part(static_cast<std::size_t>(parts));
    for (const std::uint64_t key : sorted) {
      auto& own = of_part[std::size_t(random.integer(0, parts - 1))];
      own.insert(own.begin() + random.integer(0, int(own.size())), key);
    }
    if (parts == 5) of_part[0].clear(), of_part[1].clear();
    std::vector<std::uint64_t> all;
    for (const auto& own : of_part) all.insert(all.end(), own.begin(), own.end());
    std::sort(all.begin(), all.end());
    for (const std::size_t at_a_time : {10000u, 300u, 1u}) {
      CAPTURE(parts, at_a_time);
      std::atomic<int> faults{0};
      In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
        const auto& own = of_part[std::size_t(exchange.rank())];
        Key_ranker<In_memory_exchange> ranker(exchange, range, at_a_time);
        const Key_positions positions = ranker.positions_of(own);
        for (std::size_t i = 0; i < own.size(); ++i) faults += all[positions[i]] == own[i] ? 0 : 1;
      });
      CHECK(faults == 0);
    }
  }
}

} // namespace test_tail_of_parts
