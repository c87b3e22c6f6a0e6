// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Features across a gap outside the domain force nothing: meshes have as many triangles however narrow it is.

#include "catch.h"
#include "theorem_5_tools.h"

#include <CGAL/Quality_mesher_2.h>

#include <array>
#include <cstddef>

namespace test_gaps_outside {

namespace {

using namespace theorem_5_test;
using pslg_test::make_pslg;

/// A ring that is all but closed: a tip of one end is so far from the other end's side.
Pslg tip_before_side(double gap) {
  return make_pslg<double>(
      {{0, 0}, {5, 0}, {5, 5}, {0, 5}, {0, 3}, {3, 3}, {3, 1.5}, {2.1, 1}, {1.13, 3 - gap}, {0.2, 1}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {8, 9}, {9, 0}});
}

/// The same with the tip before another tip.
Pslg tip_before_tip(double gap) {
  return make_pslg<double>(
      {{0, 0},
       {5, 0},
       {5, 5},
       {0, 5},
       {0, 4},
       {1.13, 3},
       {3, 4},
       {3, 1.5},
       {2.1, 1},
       {1.13, 3 - gap},
       {0.2, 1}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {8, 9}, {9, 10}, {10, 0}});
}

/// The tip's gap within the domain, as in a hole's stead there is a region.
Pslg tip_before_side_inside(double gap) {
  Pslg pslg = tip_before_side(gap);
  const auto a = pslg.add_vertex({-1, -1}), b = pslg.add_vertex({6, -1}), c = pslg.add_vertex({6, 6}),
             d = pslg.add_vertex({-1, 6});
  for (const auto& s : {std::array{a, b}, std::array{b, c}, std::array{c, d}, std::array{d, a}})
    pslg.add_segment(s[0], s[1]);
  return pslg;
}

std::size_t number_of_triangles(const Pslg& pslg, const Options& options) {
  return run_to_the_bound(pslg, options).report.triangles;
}

/// Whether narrower gaps make no more triangles than a wide one.
void check_counts(Pslg (*graph)(double gap), const Options& options) {
  const std::size_t wide = number_of_triangles(graph(0.1), options);
  for (const double gap : {1e-2, 1e-4, 1e-6, 1e-9}) {
    const std::size_t narrow = number_of_triangles(graph(gap), options);
    CAPTURE(gap, wide, narrow);
    CHECK(double(narrow) <= 1.1 * double(wide) + 2);
  }
}

} // namespace

TEST_CASE("Features across a gap outside force nothing on demand", "[mesher][theorem5]") {
  for (const auto coarsen : {Options::Coarsening::NONE, Options::Coarsening::GUARDED_REMOVAL}) {
    check_counts(tip_before_side, Options().coarsen(coarsen));
    check_counts(tip_before_tip, Options().coarsen(coarsen));
  }
}

TEST_CASE("Features across a gap outside force nothing by quadtrees", "[mesher][theorem5]") {
  for (const auto coarsen : {Options::Coarsening::NONE, Options::Coarsening::GUARDED_REMOVAL}) {
    check_counts(tip_before_side, Options().separate(Tree_options()).coarsen(coarsen));
    check_counts(tip_before_tip, Options().separate(Tree_options()).coarsen(coarsen));
    // With rays, too. Vertices have leaves of their own then, so that two tips are told apart.
    check_counts(tip_before_side, by_quadtrees().coarsen(coarsen));
    check_counts(tip_before_side, Options().separate(Tree_options::of_paper()).coarsen(coarsen));
  }
}

TEST_CASE("The same gap within the domain forces triangles of its size", "[mesher][theorem5]") {
  for (const Options& options : {Options(), Options().separate(Tree_options()), by_quadtrees()})
    CHECK(number_of_triangles(tip_before_side_inside(1e-9), options) >
          number_of_triangles(tip_before_side_inside(0.1), options) + 50);
}

} // namespace test_gaps_outside
