// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Rounds of Theorem 5 are few, and no triangle is below the bound in a window of a vertex. Windows are rare with the
// usual options, so most tests make them at the first failure.

#include "numbers_of_threads.h"
#include "separation_test_tools.h"
#include "theorem_5_tools.h"

#include <CGAL/Quality_mesher_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace test_vertex_windows {

namespace {

using namespace theorem_5_test;
using CGAL::Quadtree_mesh_2::Leaf_index;
using CGAL::Quadtree_mesh_2::Point_index;

Tree_options with_windows_after(std::size_t failures) {
  return Tree_options::of_theorem().failures_before_window(failures);
}

/// Features are so near, in sides of leaves, that many vertices fail and get windows at once.
Tree_options with_many_windows() { return with_windows_after(0).distances(0.1, 0.1); }

using Prepared = separation_test::Prepared_graph<CGAL::Filtered_quadtree_traits_2<>>;
using Trees = Prepared::Trees;

/// The square of a vertex's leaf, in units of that: where its lower left corner is, and what the vertex's place is.
struct Leaf_frame {
  double x, y, side;
};

Leaf_frame frame_of(const Trees& trees, std::size_t v) {
  const auto s = trees.tree().square(trees.tree().leaf(Point_index(v)));
  const auto low = trees.kernel_point({s.x, s.y});
  return {double(low.x), double(low.y), trees.side(s.level)};
}

/// Whether a point is nearer to the leaf than so many of its sides, along both axes.
bool is_within(const Leaf_frame& leaf, double x, double y, double sides) {
  const double reach = sides * leaf.side;
  return x > leaf.x - reach && x < leaf.x + leaf.side + reach && y > leaf.y - reach &&
         y < leaf.y + leaf.side + reach;
}

/// All leaves, as boxes of doubles.
std::vector<Leaf_frame> all_leaves(const Trees& trees) {
  std::vector<Leaf_frame> leaves;
  for (std::size_t l = 0; l < trees.tree().number_of_leaves(); ++l) {
    const auto s = trees.tree().square(Leaf_index(l));
    const auto low = trees.kernel_point({s.x, s.y});
    leaves.push_back({double(low.x), double(low.y), trees.side(s.level)});
  }
  return leaves;
}

/// Checks the 7 by 7 squares around the leaf of a vertex by looking at all leaves and vertices.
void check_window(const Trees& trees, const std::vector<Leaf_frame>& leaves, const Pslg& pslg,
                  const Prepared& prepared, std::size_t v) {
  const Leaf_frame own = frame_of(trees, v);
  std::size_t wrong = 0;
  for (const Leaf_frame& l : leaves)
    if (is_within(own, l.x + l.side / 2, l.y + l.side / 2, 3) && l.side != own.side) ++wrong;
  CHECK(wrong == 0);
  for (std::size_t w = 0; w < pslg.number_of_vertices(); ++w) {
    const auto& p = prepared.problem().input_point(static_cast<separation_test::internal::Vertex_id>(w));
    if (w != v && is_within(own, double(p.x), double(p.y), 3)) ++wrong;
  }
  CHECK(wrong == 0);
}

} // namespace

TEST_CASE("Rounds of Theorem 5 are few", "[mesher][theorem5][windows]") {
  for (const std::string name :
       {"syn_square.poly", "syn_sliver_1deg.poly", "syn_wedge_10deg.poly", "syn_wedge_1deg.poly",
        "syn_wedge_0.01deg.poly", "syn_near_1e-06.poly", "syn_near_1e-12.poly", "syn_parallel_0.001.poly",
        "syn_comb.poly", "syn_fan_1deg.poly", "syn_holes_400.poly.gz"}) {
    CAPTURE(name);
    const Run r = run_by_quadtrees(read(name), by_quadtrees());
    CHECK(r.report.trees.rounds <= 3);
    CHECK(r.report.trees.failed_windows == 0);
  }
}

TEST_CASE("Rounds of Theorem 5 are few for random inputs", "[mesher][theorem5][windows]") {
  const std::uint64_t seeds = is_full_run() ? 60 : 4;
  for (const auto& family : random_pslg::all_families()) {
    std::size_t rounds = 0;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      CAPTURE(family.name, seed);
      const Run r = run_by_quadtrees(family.make(seed), by_quadtrees());
      CHECK(r.report.trees.failed_windows == 0);
      CHECK(r.report.trees.rounds <= 3);
      rounds += r.report.trees.rounds;
    }
    CAPTURE(family.name);
    CHECK(rounds <= 2 * seeds);
  }
}

TEST_CASE("No triangle is below the bound in a window", "[mesher][theorem5][windows]") {
  const std::uint64_t seeds = is_full_run() ? 60 : 3;
  std::size_t windows = 0;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      CAPTURE(family.name, seed);
      const Run r = run_by_quadtrees(family.make(seed), Options().separate(with_many_windows()));
      CHECK(r.report.trees.failed_windows == 0);
      windows += r.report.trees.windows;
    }
  CHECK(windows > 10 * seeds);
}

TEST_CASE("Rounds of Theorem 5 are few for a map, and no triangle is below the bound in its windows",
          "[mesher][theorem5][windows][.slow]") {
  const Pslg pslg = read("us_states_10m.poly.gz");
  CHECK(run_by_quadtrees(pslg, by_quadtrees()).report.trees.rounds <= 3);
  const Run r = run_by_quadtrees(pslg, Options().separate(with_many_windows()));
  CHECK(r.report.trees.windows > 50);
  CHECK(r.report.trees.failed_windows == 0);
}

TEST_CASE("Windows are of equal leaves, without other features, and disjoint",
          "[trees][separation][windows]") {
  for (const std::string name : {"syn_holes_400.poly.gz", "syn_fan_1deg.poly", "syn_near_1e-06.poly"}) {
    CAPTURE(name);
    const Pslg pslg = read(name);
    Prepared prepared(pslg);
    const Tree_options options = with_windows_after(0);
    Trees trees = prepared.trees(options);
    std::vector<separation_test::internal::Vertex_id> vertices;
    const std::size_t step = std::max<std::size_t>(1, pslg.number_of_vertices() / 40);
    for (std::size_t v = 0; v < pslg.number_of_vertices(); v += step)
      vertices.push_back(static_cast<separation_test::internal::Vertex_id>(v));
    REQUIRE(trees.refine({}, vertices));
    CHECK(trees.windows().number_settled() == vertices.size());
    const std::vector<Leaf_frame> leaves = all_leaves(trees);
    for (const auto v : vertices) check_window(trees, leaves, pslg, prepared, std::size_t(v));
    for (const auto v : vertices)
      for (const auto w : vertices) {
        if (!(v < w)) continue;
        const Leaf_frame a = frame_of(trees, std::size_t(v)), b = frame_of(trees, std::size_t(w));
        const double reach = 3 * (a.side + b.side);
        CHECK((std::fabs(a.x + a.side / 2 - b.x - b.side / 2) >= reach + (a.side + b.side) / 2 ||
               std::fabs(a.y + a.side / 2 - b.y - b.side / 2) >= reach + (a.side + b.side) / 2));
      }
  }
}

TEST_CASE("Windows are the same for any number of threads", "[mesher][theorem5][windows][parallel]") {
  const Options options = Options().separate(with_many_windows());
  std::size_t windows = 0;
  for (const auto& family : random_pslg::all_families()) {
    const Pslg pslg = family.make(1);
    const Run sequential = run(pslg, options);
    windows += sequential.report.trees.windows;
    for_numbers_of_threads([&] {
      CAPTURE(family.name);
      using Parallel = CGAL::Quality_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag>;
      CHECK(are_same(Parallel(options)(pslg), sequential.mesh));
    });
  }
  CHECK(windows > 20);
}

} // namespace test_vertex_windows
