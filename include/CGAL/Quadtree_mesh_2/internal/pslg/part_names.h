// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What messages call the parts of a graph: by the numbers that its owner gave them, and by their places.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_PART_NAMES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_PART_NAMES_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The number of the part with index `i`, as the owner of the graph counts.
template <class Point>
std::string number_of_part(const Pslg_2<Point>& pslg, std::size_t i) {
  return std::to_string(pslg.first_number + i);
}

/// "3 (0.5, 0.25)"
template <class Point>
std::string numbered_place(const Pslg_2<Point>& pslg, std::size_t i, const Point& place) {
  return number_of_part(pslg, i) + ' ' + coordinates_text(place);
}

/// "vertex 3 (0.5, 0.25)"
template <class Point>
std::string vertex_text(const Pslg_2<Point>& pslg, std::size_t v) {
  return "vertex " + numbered_place(pslg, v, pslg.vertices[v]);
}

template <class Point>
std::string hole_text(const Pslg_2<Point>& pslg, std::size_t h) {
  return "hole " + numbered_place(pslg, h, pslg.holes[h]);
}

template <class Point>
std::string region_text(const Pslg_2<Point>& pslg, std::size_t r) {
  return "region " + numbered_place(pslg, r, pslg.regions[r].point);
}

/// "segment 3 from vertex 0 (0, 0) to vertex 1 (1, 0)"
template <class Point>
std::string segment_text(const Pslg_2<Point>& pslg, std::size_t s) {
  return "segment " + number_of_part(pslg, s) + " from " +
         vertex_text(pslg, std::size_t(pslg.segments[s][0])) + " to " +
         vertex_text(pslg, std::size_t(pslg.segments[s][1]));
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_PART_NAMES_H
