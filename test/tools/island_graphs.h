// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_ISLAND_GRAPHS_H
#define QUADTREE_MESH_2_TEST_ISLAND_GRAPHS_H

// Components of a domain that refinement takes long for, and others beside them.

#include "pslg_test_tools.h"

#include <cstddef>
#include <vector>

namespace island_graphs {

using pslg_test::Point;
using pslg_test::Pslg;
using pslg_test::Vertex_index;

/// Adds a polygon.
inline void add_polygon(Pslg& pslg, const std::vector<Point>& corners) {
  const std::size_t first = pslg.number_of_vertices(), n = corners.size();
  for (const Point& p : corners) pslg.add_vertex(p);
  for (std::size_t i = 0; i < n; ++i)
    pslg.add_segment(Vertex_index(first + i), Vertex_index(first + (i + 1) % n));
}

/// Adds a square, which needs no Steiner vertex.
inline void add_square(Pslg& pslg, double x, double y, double side) {
  add_polygon(pslg, {Point(x, y), Point(x + side, y), Point(x + side, y + side), Point(x, y + side)});
}

/// Adds a comb with its lower left corner at (x, y) and teeth as far apart as given. Each ends in an edge shorter than
/// a hair, which the estimate of size does not see: it takes more triangles than expected.
inline void add_comb(Pslg& pslg, double x, double y, std::size_t teeth, double distance) {
  const double hair = 1e-9 * distance;
  std::vector<Point> corners{Point(x, y), Point(x + static_cast<double>(teeth) * distance, y)};
  for (std::size_t i = teeth; i-- > 0;) {
    const double left = x + static_cast<double>(i) * distance, middle = left + distance / 2;
    corners.emplace_back(left + distance, y + 2 * distance);
    corners.emplace_back(middle + hair, y + 3 * distance);
    corners.emplace_back(middle, y + 3 * distance);
  }
  corners.emplace_back(x, y + 2 * distance);
  add_polygon(pslg, corners);
}

} // namespace island_graphs

#endif // QUADTREE_MESH_2_TEST_ISLAND_GRAPHS_H
