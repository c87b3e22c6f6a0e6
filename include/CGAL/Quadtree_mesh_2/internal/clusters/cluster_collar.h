// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The triangles between the mesh around a cluster and that of its window.
//
// The mesh of a cluster's parent has a vertex in the place of the cluster, with eight neighbors in the
// compass directions, the spokes. The vertex and its eight triangles are removed. 16 triangles join the
// spokes to the octagon, and 176 join the octagon to the border of the window (collar_table.h): 8 + 64 new
// vertices, and 40 of the window.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_CLUSTER_COLLAR_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_CLUSTER_COLLAR_H

#include <CGAL/Quadtree_mesh_2/internal/clusters/Cluster_frame.h>
#include <CGAL/Quadtree_mesh_2/internal/tables/collar_table.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Indexed_triangle = std::array<std::int32_t, 3>;
using Octagon_vertices = std::array<std::int32_t, Collar::number_of_octagon_vertices>;
using Window_vertices = std::array<std::int32_t, Collar::number_of_window_vertices>;

constexpr int number_of_octagon_triangles = 16;

/// The triangles around an octagon, counterclockwise.
/// \param octagon its vertices, \param spokes those around it; both in the order of `Cluster_frame`.
inline std::array<Indexed_triangle, number_of_octagon_triangles>
octagon_triangles(const Octagon_vertices& octagon, const std::array<std::int32_t, 8>& spokes) {
  std::array<Indexed_triangle, number_of_octagon_triangles> triangles;
  for (std::size_t k = 0; k < 8; ++k) {
    const std::size_t next = (k + 1) % 8;
    triangles[2 * k] = {octagon[k], spokes[k], octagon[next]};
    triangles[2 * k + 1] = {octagon[next], spokes[k], spokes[next]};
  }
  return triangles;
}

/// Appends the vertices of an octagon.
template <class Geometry>
Octagon_vertices append_octagon(const Cluster_frame<Geometry>& frame,
                                std::vector<typename Geometry::Point>& points) {
  Octagon_vertices octagon;
  for (int k = 0; k < Collar::number_of_octagon_vertices; ++k) {
    octagon[std::size_t(k)] = static_cast<std::int32_t>(points.size());
    points.push_back(frame.octagon_vertex(k));
  }
  return octagon;
}

/// Appends the vertices and triangles between an octagon and a window.
/// \param window the vertices of the window, in the order of `Cluster_frame::window_boundary()`.
template <class Geometry>
void append_collar(const Cluster_frame<Geometry>& frame, const Octagon_vertices& octagon,
                   const Window_vertices& window, std::vector<typename Geometry::Point>& points,
                   std::vector<Indexed_triangle>& triangles) {
  std::array<std::int32_t, Collar::number_of_vertices> vertices;
  auto end = std::copy(octagon.begin(), octagon.end(), vertices.begin());
  end = std::copy(window.begin(), window.end(), end);
  for (; end != vertices.end(); ++end) {
    *end = static_cast<std::int32_t>(points.size());
    points.push_back(frame.collar_vertex(static_cast<int>(end - vertices.begin())));
  }
  for (const auto& t : collar().triangles)
    triangles.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
}

/// The position of a place in the order of `Cluster_frame::window_boundary()`, or -1 if it is none of these.
inline int position_in_window_boundary(const Grid_point_2<std::uint64_t>& place) {
  // in units of half a cell from the lower left corner
  constexpr int log_unit = 58, size = 2 * Collar::cells_per_side;
  constexpr std::uint64_t corner = std::uint64_t(1) << 59, rest = (std::uint64_t(1) << log_unit) - 1;
  if ((place.x & rest) != 0 || (place.y & rest) != 0 || place.x < corner || place.y < corner) return -1;
  const std::uint64_t x = (place.x - corner) >> log_unit, y = (place.y - corner) >> log_unit;
  if (x > size || y > size) return -1;
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  if (j == 0) return i;
  if (i == size) return size + j;
  if (j == size) return 3 * size - i;
  return i == 0 ? 4 * size - j : -1;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_CLUSTER_COLLAR_H
