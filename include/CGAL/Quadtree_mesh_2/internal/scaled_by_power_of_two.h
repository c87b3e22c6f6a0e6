// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes and graphs of extreme extent brought near 1, where products of six lengths neither overflow nor
// vanish, and the measures taken there brought back. Exact but for subnormal numbers.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SCALED_BY_POWER_OF_TWO_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SCALED_BY_POWER_OF_TWO_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/mesh_quality_types.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The exponent of the largest coordinate if squares of squares of lengths would leave the range of doubles;
/// else 0.
template <class Point>
int exponent_of_extreme_extent(const std::vector<Point>& points) {
  constexpr int moderate = 100;
  double largest = 0;
  for (const Point& p : points) largest = std::max({largest, std::fabs(p.x()), std::fabs(p.y())});
  if (!(largest > 0) || !std::isfinite(largest)) return 0;
  const int exponent = std::ilogb(largest);
  return std::abs(exponent) > moderate ? exponent : 0;
}

template <class Point>
void scale_by_power_of_two(std::vector<Point>& points, int exponent) {
  for (Point& p : points) p = Point(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent));
}

template <class Point>
Indexed_mesh_2<Point> scaled_by_power_of_two(Indexed_mesh_2<Point> mesh, int exponent) {
  scale_by_power_of_two(mesh.points, exponent);
  return mesh;
}

template <class Point>
Pslg_2<Point> scaled_by_power_of_two(Pslg_2<Point> pslg, int exponent) {
  scale_by_power_of_two(pslg.vertices, exponent);
  scale_by_power_of_two(pslg.holes, exponent);
  for (auto& r : pslg.regions) {
    r.point = Point(std::ldexp(r.point.x(), exponent), std::ldexp(r.point.y(), exponent));
    r.max_area = std::ldexp(r.max_area, 2 * exponent);
  }
  return pslg;
}

inline Mesh_quality_options_2 scaled_by_power_of_two(Mesh_quality_options_2 options, int exponent) {
  options.max_edge_length = std::ldexp(options.max_edge_length, exponent);
  options.max_triangle_area = std::ldexp(options.max_triangle_area, 2 * exponent);
  return options;
}

/// Lengths, areas and places; angles and counts stay. An area beyond the range of doubles becomes infinite,
/// or 0.
inline Mesh_quality_2 scaled_by_power_of_two(Mesh_quality_2 quality, int exponent) {
  for (double* length : {&quality.shortest_edge, &quality.longest_edge, &quality.total_length})
    *length = std::ldexp(*length, exponent);
  for (double* area : {&quality.area, &quality.domain_area, &quality.largest_area})
    *area = std::ldexp(*area, 2 * exponent);
  for (auto& unmet : quality.unmet_triangles)
    for (double& x : unmet.centroid) x = std::ldexp(x, exponent);
  return quality;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SCALED_BY_POWER_OF_TWO_H
