// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What parts of a mesh would send each other: parts leave no trace in the mesh, each triangle has one owner, and
// messages are counted as by brute force, seen from who receives them.

#include "catch.h"
#include "mesh_digest.h"
#include "mesh_in_parts.h"
#include "mesher_test_tools.h"
#include "pslg_inputs.h"
#include "random_pslg_shapes.h"
#include "recounted_ledger.h"
#include "tiny_blocks.h"

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/bounding_box.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace test_part_ledger {

namespace {

using namespace mesher_test;
using CGAL::Quadtree_mesh_2::internal::Counted_exchange;
using CGAL::Quadtree_mesh_2::internal::Mesh_pipeline;
using CGAL::Quadtree_mesh_2::internal::Superstep_kind;
using CGAL::Quadtree_mesh_2::internal::Traffic;
using pslg_test::Point;
using Traits = Mesh_in_parts::Traits;

Traffic sum_of(const Counted_exchange::Traffic_of_parts& traffic) {
  Traffic sum;
  for (const Traffic& t : traffic) sum += t;
  return sum;
}

void check_that_all_is_received(const Counted_exchange& exchange) {
  for (const auto& step : exchange.supersteps()) {
    const Traffic sent = sum_of(step.sent), received = sum_of(step.received);
    CHECK(sent.bytes == received.bytes);
    CHECK(sent.messages == received.messages);
    CHECK(sent.messages > 0);
  }
}

/// \returns how many rounds there were
template <class Tag>
std::size_t check_digests(const Pslg& pslg, const Options& options) {
  const std::uint64_t expected = mesh_digest(CGAL::Quality_mesher_2<Traits, Tag>(options)(pslg));
  std::size_t rounds = 0;
  for (const std::size_t parts :
       is_full_run() ? std::vector<std::size_t>{1, 2, 3, 7, 64} : std::vector<std::size_t>{1, 3, 64}) {
    CAPTURE(parts);
    const Mesh_in_parts made = mesh_in_parts<Tag>(pslg, options, parts);
    CHECK(mesh_digest(made.mesh) == expected);
    check_that_all_is_received(made.ledger.exchange());
    if (parts == 1) CHECK(made.ledger.exchange().supersteps().empty());
    rounds = made.ledger.rounds().size();
  }
  return rounds;
}

/// A lattice of points in a box that they fill.
Pslg lattice(int side) {
  Pslg pslg;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) pslg.add_vertex(Point(i, j));
  const auto corner = [side](int i, int j) {
    return pslg_test::Vertex_index(std::size_t(i * (side - 1) * side + j * (side - 1)));
  };
  pslg.add_segment(corner(0, 0), corner(0, 1)), pslg.add_segment(corner(0, 1), corner(1, 1));
  pslg.add_segment(corner(1, 1), corner(1, 0)), pslg.add_segment(corner(1, 0), corner(0, 0));
  return pslg;
}

/// Half as long in the right half of the box as in the left one.
Options sizes_in_halves(const Pslg& pslg) {
  const auto box = CGAL::bounding_box(pslg.vertices.begin(), pslg.vertices.end());
  const double middle = (box.xmin() + box.xmax()) / 2, extent = box.xmax() - box.xmin();
  return Options().size([=](double x, double) { return extent / (x < middle ? 60 : 120); });
}

/// Meshes in tiny blocks, recounting all that is sent. \returns the supersteps that were recounted
std::size_t recount(const Pslg& pslg, const Options& options, std::size_t parts) {
  using CGAL::Quadtree_mesh_2::internal::Inner_tag;
  const Traits traits;
  CGAL::Quality_mesh_report_2 report;
  Mesh_pipeline<Traits, Tiny_blocks_tag, Recounted_ledger> pipeline(pslg, options, traits, nullptr, report,
                                                                    Recounted_ledger(parts));
  pipeline.run();
  return pipeline.watch().number_recounted();
}

constexpr int all_rounds = 1000;

/// What a part sends on average in blocks of 256, up to the given round.
double mean_bytes_in_small_blocks(const std::string& input, std::size_t parts, int last_round) {
  const auto made = mesh_in_parts<Small_blocks_tag>(pslg_inputs::by_name(input).pslg, Options(), parts);
  std::size_t bytes = 0;
  for (const auto& step : made.ledger.exchange().supersteps())
    if (step.round <= last_round) bytes += sum_of(step.sent).bytes;
  return static_cast<double>(bytes) / static_cast<double>(parts);
}

} // namespace

TEST_CASE("Meshes in tiny blocks have the same bits for any number of parts", "[parts]") {
  const bool is_large = is_full_run();
  const Pslg map = is_large ? read("us_states_10m.poly.gz") : pslg_inputs::by_name("coast:1e3").pslg;
  const Pslg holes = is_large ? read("syn_holes_400.poly.gz") : pslg_inputs::by_name("holes:40").pslg;
  const Pslg stars = pslg_inputs::by_name(is_large ? "stars:1e3" : "stars:150").pslg;
  for (const Pslg& pslg : {map, holes, stars, lattice(is_large ? 30 : 16)})
    CHECK(check_digests<Tiny_blocks_tag>(pslg, Options()) > 1);
  const auto square = pslg_inputs::by_name(is_large ? "square:1e-3" : "square:4e-3");
  check_digests<Tiny_blocks_tag>(square.pslg, Options().max_area(square.max_area));
  CHECK(check_digests<Tiny_blocks_tag>(map, sizes_in_halves(map)) > 1);
}

TEST_CASE("Meshes have the same bits for any number of parts", "[parts][.slow]") {
  CHECK(check_digests<CGAL::Parallel_tag>(read("gshhg_norway_f.poly.gz"), Options()) > 1);
  check_digests<CGAL::Parallel_tag>(read("us_states_10m.poly.gz"), Options());
  check_digests<CGAL::Parallel_tag>(read("gshhg_aegean_h.poly.gz"), Options());
  CHECK(check_digests<CGAL::Parallel_tag>(pslg_inputs::by_name("stars:3e4").pslg, Options()) > 1);
  CHECK(check_digests<CGAL::Parallel_tag>(pslg_inputs::by_name("holes:2e4").pslg, Options()) > 1);
  CHECK(check_digests<CGAL::Parallel_tag>(lattice(200), Options()) > 1);
  const auto square = pslg_inputs::by_name("square:1e-5");
  check_digests<CGAL::Parallel_tag>(square.pslg, Options().max_area(square.max_area));
  const Pslg norway = read("gshhg_norway_f.poly.gz");
  CHECK(check_digests<CGAL::Parallel_tag>(norway, sizes_in_halves(norway)) > 1);
}

TEST_CASE("Messages are counted as by brute force, and each triangle has one owner", "[parts]") {
  const std::uint64_t seeds = is_full_run() ? 50 : 1;
  std::size_t recounted = 0;
  for (const random_pslg::Family& family : random_pslg::all_families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed)
      for (const std::size_t parts :
           is_full_run() ? std::vector<std::size_t>{2, 5} : std::vector<std::size_t>{5}) {
        CAPTURE(family.name, seed, parts);
        recounted += recount(family.make(seed), Options(), parts);
      }
  CHECK(recounted > 50);
  CHECK(recount(read("star_of_72_spikes.poly"), Options().max_area(0.01), 3) > 0);
  const Pslg map = is_full_run() ? read("us_states_10m.poly.gz") : pslg_inputs::by_name("coast:500").pslg;
  if (is_full_run()) CHECK(recount(map, Options(), 3) > 0);
  CHECK(recount(map, sizes_in_halves(map), 7) > 0); // with a bulk
}

TEST_CASE("What is sent grows as the square root of the triangles", "[parts]") {
  // Of fewer holes parts would have too few blocks.
  for (const std::size_t parts :
       is_full_run() ? std::vector<std::size_t>{4, 7, 16} : std::vector<std::size_t>{16}) {
    const double growth = mean_bytes_in_small_blocks("holes:3.2e4", parts, all_rounds) /
                          mean_bytes_in_small_blocks("holes:2e3", parts, all_rounds);
    CAPTURE(parts);
    CHECK(growth > 4 / 1.3);
    CHECK(growth < 4 * 1.3);
  }
}

// Where much waits after that, squares that are as large as parts are, or larger, are sent as a whole.
TEST_CASE("What is sent for a coast grows so in rounds whose squares do not grow", "[parts]") {
  const double growth = mean_bytes_in_small_blocks(is_full_run() ? "coast:1.6e5" : "coast:8e4", 7, 3) /
                        mean_bytes_in_small_blocks(is_full_run() ? "coast:1e4" : "coast:5e3", 7, 3);
  CHECK(growth > 4 / 1.4);
  CHECK(growth < 4 * 1.3);
}

TEST_CASE("Parts of a coast send little", "[parts][.slow]") {
  const auto made = mesh_in_parts<CGAL::Parallel_tag>(pslg_inputs::by_name("coast:3e5").pslg, Options(), 24);
  const Part_counts counts = counts_of(made.ledger);
  CHECK(counts.mean_bytes < 265e3);
  CHECK(counts.mean_messages < 155);
  CHECK(counts.share_worked_on_again < 0.1);
}

TEST_CASE("A sum over parts goes up a tree and down again", "[parts]") {
  for (const auto& [parts, messages] :
       {std::pair<std::size_t, std::size_t>{1, 0}, {2, 2}, {3, 4}, {8, 6}, {9, 8}}) {
    Counted_exchange exchange(parts);
    constexpr std::size_t numbers = 3;
    exchange.sum(1, Superstep_kind::NAMES, numbers);
    for (const Traffic& sent : exchange.sent()) {
      CHECK(sent.messages == messages);
      CHECK(sent.bytes == 8 * numbers * messages);
    }
  }
}

} // namespace test_part_ledger
