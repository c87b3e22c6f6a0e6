// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Graphs over exact numbers from files and families to meshes.

#include "end_to_end.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>

namespace test_end_to_end_exact {

using namespace end_to_end;

namespace {

using Traits = CGAL::Exact_quadtree_traits_2<>;

/// Three quarters, so that doubles have the lattices exactly, and the checker sees vertices of segments on them.
CGAL::Pslg_2<Traits::Point_2> three_quarters(const Pslg& pslg) {
  const auto smaller = [](const auto& p) {
    const Traits::Point_2 q(3 * CGAL::Epeck::FT(p.x()) / 4, 3 * CGAL::Epeck::FT(p.y()) / 4);
    CGAL::exact(q); // the arithmetic is done here, not in the mesher
    return q;
  };
  CGAL::Pslg_2<Traits::Point_2> graph;
  for (const auto& p : pslg.vertices) graph.vertices.push_back(smaller(p));
  for (const auto& p : pslg.holes) graph.holes.push_back(smaller(p));
  graph.segments = pslg.segments;
  return graph;
}

} // namespace

TEST_CASE("Graphs of rational numbers are meshed", "[end_to_end]") { check_graphs<Traits>(three_quarters); }

TEST_CASE("A graph of rational numbers is meshed on threads", "[end_to_end][threads]") {
  const auto graph = three_quarters(mesher_test::read("syn_wedge_10deg.poly"));
  check_graph<Traits>(graph, Options().max_area(1e-3));
  check_graph<Traits>(graph, Options().separate(Options::Separation::THEOREM_5));
}

} // namespace test_end_to_end_exact
