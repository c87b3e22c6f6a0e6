// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors//
// Graphs meshed by parts in several memories: the mesh and the report of one memory, for all options; the same errors
// at all parts.

#include "catch.h"
#include "meshes_by_all_parts.h"
#include "pslg_inputs.h"
#include "pslg_test_tools.h"
#include "random_pslg_shapes.h"

#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_mesh_by_all_parts {

namespace {

using namespace meshes_by_all_parts;

/// What parts say is wrong, those that say the same once.
template <class Work>
std::string said_by_parts(int parts, const Work& work) {
  std::vector<std::string> said(static_cast<std::size_t>(parts));
  In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
    said[static_cast<std::size_t>(exchange.rank())] = work(exchange);
  });
  std::string all = said.front();
  for (std::size_t p = 1; p < said.size(); ++p)
    if (said[p] != said.front()) all += " | " + said[p];
  return all;
}

template <class Tag>
void check_numbers_of_parts(const std::vector<int>& numbers, const Pslg& pslg, const Options& options) {
  const Result expected = in_one_memory<Tag>(pslg, options);
  CHECK(is_valid(expected.mesh, pslg));
  for (const int parts : numbers) {
    CAPTURE(parts);
    CHECK(said_by_parts(parts, [&](In_memory_exchange& exchange) {
            return check_mesh_of_all<Tag>(exchange, expected, pslg, options);
          }) == "");
  }
}

template <class Tag>
void check_all_numbers_of_parts(const Pslg& pslg, const Options& options) {
  check_numbers_of_parts<Tag>({1, 2, 5}, pslg, options);
}

Pslg named(const char* name) { return pslg_inputs::by_name(name).pslg; }

Options by_quadtrees() { return Options().separate(Options::Separation::THEOREM_5); }

} // namespace

TEST_CASE("All parts make the meshes of random graphs that one memory makes", "[parts][distributed]") {
  for (const auto& family : random_pslg::all_families()) {
    CAPTURE(family.name);
    check_all_numbers_of_parts<Tiny_blocks_tag>(family.make(7), Options());
  }
}

TEST_CASE("Parts with several threads make the mesh of one thread", "[parts][distributed][threads]") {
  for (const auto& family : random_pslg::all_families()) {
    CAPTURE(family.name);
    const Pslg pslg = family.make(11);
    const Result expected = in_one_memory<Tiny_blocks_tag>(pslg, Options());
    const Threads_for_tiny_blocks threads;
    CHECK(said_by_parts(3, [&](In_memory_exchange& exchange) {
            return check_mesh_of_all<Tiny_blocks_tag>(exchange, expected, pslg, Options());
          }) == "");
  }
}

TEST_CASE("All parts make the mesh of one memory with all options", "[parts][distributed]") {
  const bool is_large = is_full_run();
  const Pslg stars = named(is_large ? "stars:600" : "stars:120"),
             coast = named(is_large ? "coast:2000" : "coast:400");
  int parts = 5;
  const auto check = [&](const Pslg& pslg, const Options& options) {
    parts = 7 - parts; // 2 and 5 in turn
    check_numbers_of_parts<Tiny_blocks_tag>(is_large ? std::vector<int>{1, 2, 5} : std::vector<int>{parts},
                                            pslg, options);
  };
  check_all_numbers_of_parts<Tiny_blocks_tag>(coast, Options());
  check(coast, sizes_in_halves(coast));
  check(coast, Options().min_angle(33));
  check(stars, Options());
  check(stars, by_quadtrees());
  check(stars, Options().smooth(1).thin(1));
  check(stars, Options().keep_borders(Options::Keep_borders::ALL));
  check(stars, Options().conform(Options::Conforming::DELAUNAY));
  check(stars, Options().max_steiner_vertices(300));
  const auto square = pslg_inputs::by_name(is_large ? "square:1e-3" : "square:4e-3");
  check(square.pslg, Options().max_area(square.max_area));
}

TEST_CASE("All parts make the mesh of a graph with regions and holes", "[parts][distributed]") {
  Pslg states;
  CGAL::IO::read_triangle_poly(QUADTREE_MESH_TEST_DATA_DIR "/us_states_10m.poly.gz", states);
  const std::vector<int> numbers = is_full_run() ? std::vector<int>{1, 2, 5} : std::vector<int>{3};
  check_numbers_of_parts<Small_blocks_tag>(numbers, states, Options());
  if (is_full_run()) check_numbers_of_parts<Small_blocks_tag>(numbers, states, by_quadtrees());
  const Input all = with_all(); // with fewer triangles than two blocks have
  check_all_numbers_of_parts<Small_blocks_tag>(all.pslg, Options());
  check_all_numbers_of_parts<Tiny_blocks_tag>(all.pslg, Options());
  check_numbers_of_parts<Tiny_blocks_tag>(numbers, all.pslg, by_quadtrees());
}

TEST_CASE("All parts throw what one memory throws", "[parts][distributed]") {
  Pslg crossing = named("coast:2000");
  const auto added = [&](double x, double y) { return crossing.add_vertex(Point(x, y)); };
  const auto a = added(-10, -10), b = added(10, 10), c = added(-10, 10), d = added(10, -10);
  crossing.add_segment(a, b), crossing.add_segment(c, d);
  std::string expected;
  try {
    in_one_memory<Tiny_blocks_tag>(crossing, Options());
  } catch (const CGAL::Pslg_error_2& error) {
    expected = said_by(error);
    REQUIRE(error.parts().segments.size() == 2);
  }
  REQUIRE(expected != "");
  const Pslg coast = named("coast:2000");
  for (const int parts : {1, 3}) {
    CHECK(said_by_parts(parts, [&](In_memory_exchange& exchange) {
            const std::string first = error_of_all<Tiny_blocks_tag>(exchange, crossing, Options());
            return first + error_of_all<Tiny_blocks_tag>(exchange, coast, Options()); // parts can go on
          }) == expected);
    CHECK(said_by_parts(parts, [&](In_memory_exchange& exchange) {
            return error_of_all<Tiny_blocks_tag>(exchange, Pslg(), Options());
          }) == "there are no vertices");
    CHECK(said_by_parts(parts, [&](In_memory_exchange& exchange) {
            const std::string first = error_of_all<Tiny_blocks_tag>(exchange, coast, sizes_that_fail(coast));
            return first + error_of_all<Tiny_blocks_tag>(exchange, coast, Options());
          }) == "no size is known here");
    CHECK(said_by_parts(parts, [&](In_memory_exchange& exchange) {
            return error_of_all<Tiny_blocks_tag>(exchange, coast, Options().checkpoints("folder"));
          }) == "there are no checkpoints of meshes that several ranks make");
  }
  CHECK(said_by_parts(3, [&](In_memory_exchange& exchange) {
          return error_of_all<Tiny_blocks_tag>(exchange, coast, Options().min_angle(20 + exchange.rank()));
        }) == "ranks have different options for one mesh");
}

TEST_CASE("Errors of parts that have let go of the graph name what is at fault", "[parts][distributed]") {
  const auto with_ring = [](double x, double y) { // far from the coast
    Pslg graph = named("coast:2000");
    const auto first = graph.number_of_vertices();
    for (const auto& [dx, dy] : {std::pair(0., 0.), {1., 0.}, {1., 1.}, {0., 1.}})
      graph.add_vertex(Point(x + dx, y + dy));
    for (std::size_t k = 0; k < 4; ++k)
      graph.add_segment(Pslg::Vertex_index(first + k), Pslg::Vertex_index(first + (k + 1) % 4));
    return graph;
  };
  std::vector<Pslg> graphs(3, with_ring(20, 20));
  graphs[0].holes.push_back(graphs[0].vertices.back()); // a border of two components
  graphs[0].add_segment(Pslg::Vertex_index(graphs[0].number_of_vertices() - 1),
                        Pslg::Vertex_index(graphs[0].number_of_vertices() - 3));
  for (std::size_t k = graphs[1].segments.size(); k-- > 0;) // no ring is closed
    if (k % 2 == 0) graphs[1].segments.erase(graphs[1].segments.begin() + std::ptrdiff_t(k));
  for (const double y : {20.5, 20.5 + 1e-9}) { // a gap
    const auto a = graphs[2].add_vertex(Point(20.1, y)), b = graphs[2].add_vertex(Point(20.9, y));
    graphs[2].add_segment(a, b);
  }
  using Kind = CGAL::Pslg_error_2::Kind;
  const Kind kinds[] = {Kind::AMBIGUOUS_SEED, Kind::NO_DOMAIN, Kind::TOO_MANY_TRIANGLES};
  for (std::size_t g = 0; g < graphs.size(); ++g) {
    CAPTURE(g);
    std::string expected;
    try {
      in_one_memory<Tiny_blocks_tag>(graphs[g], Options());
    } catch (const CGAL::Pslg_error_2& error) {
      expected = said_by(error);
      CHECK(error.kind() == kinds[g]);
      CHECK(error.parts().vertices.size() + error.parts().segments.size() > 0);
    }
    REQUIRE(expected != "");
    CHECK(said_by_parts(3, [&](In_memory_exchange& exchange) {
            return error_of_all<Tiny_blocks_tag>(exchange, graphs[g], Options());
          }) == expected);
  }
  check_all_numbers_of_parts<Tiny_blocks_tag>(with_ring(30, -0.0), Options());
}

TEST_CASE("A size field that fails at one part alone ends all", "[parts][distributed]") {
  const Pslg coast = named("coast:2000");
  std::atomic<int> calls{0};
  CHECK(said_by_parts(4, [&](In_memory_exchange& exchange) {
          const bool is_third = exchange.rank() == 2;
          const Options options = Options().size([is_third, &calls](double, double) {
            if (is_third && ++calls > 0) throw std::runtime_error("not at this part");
            return 0.1;
          });
          return error_of_all<Tiny_blocks_tag>(exchange, coast, options);
        }) == "not at this part");
  CHECK(calls > 0);
}

TEST_CASE("The callback of the first part stops all parts, and leaves a valid mesh", "[parts][distributed]") {
  const Pslg coast = named("coast:2000");
  const double stop_at = GENERATE(0.0, 0.2, 0.5, 0.8);
  for (const int parts : {1, 3}) {
    CAPTURE(parts, stop_at);
    Mesh mesh;
    CHECK(said_by_parts(parts, [&](In_memory_exchange& exchange) {
            const Options options = Options().progress([&](double share) { return share < stop_at; });
            Mesher_with<Tiny_blocks_tag> mesher(options);
            Report report;
            const bool is_first = exchange.rank() == 0;
            const Part part = mesh_by_all_parts(exchange, mesher, is_first ? coast : Pslg(), report);
            const Mesh whole = gather_mesh(exchange, part, 0);
            if (is_first) mesh = whole;
            return std::string(report.is_cancelled ? "" : "not cancelled");
          }) == "");
    CHECK(is_valid(mesh, coast));
  }
}

} // namespace test_mesh_by_all_parts
