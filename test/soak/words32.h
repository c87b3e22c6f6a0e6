// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SOAK_WORDS32_H
#define QUADTREE_MESH_2_TEST_SOAK_WORDS32_H

// The meshers over 32-bit words, for integers in doubles. Compiled by itself: they take the compiler a while.

#include "run_case.h"

#include <vector>

namespace soak {

/// \pre all coordinates are integers of at most 31 bits
Graph_mesh mesh_graph_in_words32(const Pslg& graph, const CGAL::Quality_mesh_options_2& options);
Points_mesh mesh_points_in_words32(const std::vector<Point>& points,
                                   const CGAL::Point_set_mesh_options_2& options);

} // namespace soak

#endif // QUADTREE_MESH_2_TEST_SOAK_WORDS32_H
