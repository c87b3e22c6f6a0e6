// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Graphs over exact numbers from files and families to meshes.

#include "end_to_end.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>

using namespace end_to_end;

TEST_CASE("Graphs of rational numbers are meshed", "[end_to_end]") {
  using Traits = CGAL::Exact_quadtree_traits_2<>;
  check_graphs<Traits>([](const Pslg& pslg) {
    const auto third = [](const auto& p) {
      const Traits::Point_2 q(CGAL::Epeck::FT(p.x()) / 3, CGAL::Epeck::FT(p.y()) / 3);
      CGAL::exact(q); // the arithmetic is done here, not in the mesher
      return q;
    };
    CGAL::Pslg_2<Traits::Point_2> graph;
    for (const auto& p : pslg.vertices) graph.vertices.push_back(third(p));
    for (const auto& p : pslg.holes) graph.holes.push_back(third(p));
    graph.segments = pslg.segments;
    return graph;
  });
}
