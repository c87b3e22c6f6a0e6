// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Graphs over words from files and families to meshes.

#include "end_to_end.h"

#include <CGAL/Fixed_point_quadtree_traits_2.h>

#include <cstdint>

namespace test_end_to_end_words {

using namespace end_to_end;

TEST_CASE("Graphs of words are meshed", "[end_to_end]") {
  using Traits = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
  check_graphs<Traits>([](const Pslg& pslg) {
    const auto scale = CGAL::Fixed_point_scale_2<std::uint64_t>::of_points(pslg.vertices);
    CGAL::Pslg_2<Traits::Point_2> fixed;
    for (const auto& p : pslg.vertices) fixed.vertices.push_back(scale.to_fixed(p.x(), p.y()));
    for (const auto& p : pslg.holes) fixed.holes.push_back(scale.to_fixed(p.x(), p.y()));
    fixed.segments = pslg.segments;
    return fixed;
  });
}

} // namespace test_end_to_end_words
