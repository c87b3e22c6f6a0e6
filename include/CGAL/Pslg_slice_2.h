// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_PSLG_SLICE_2_H
#define CGAL_PSLG_SLICE_2_H

#include <CGAL/Pslg_2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Distributed
/// What one rank has of a planar straight-line graph: a run of its vertices, one of its segments, and so on. One rank
/// after the other, they are those of `Pslg_2`. Numbers over all ranks have 64 bits.
/// \tparam Point_2 as for `Pslg_2`.
template <class Point_2>
struct Pslg_slice_2 {
  /// A region, as in `Pslg_2`.
  using Region = typename Pslg_2<Point_2>::Region;

  /// \name Vertices
  /// @{
  std::vector<Point_2> vertices;               ///< those of this rank
  std::int64_t first_vertex = 0;               ///< the number of the first one, counted over all ranks
  std::int64_t number_of_vertices = 0;         ///< how many all ranks have
  std::vector<double> vertex_attributes;       ///< those of this rank's vertices, one vertex after the other
  std::size_t number_of_vertex_attributes = 0; ///< how many each vertex has
  std::vector<int> vertex_markers;             ///< those of this rank's vertices, or none
  /// @}

  /// \name Segments
  /// @{
  std::vector<std::array<std::int64_t, 2>>
      segments;                        ///< those of this rank; their ends are counted over all ranks
  std::int64_t first_segment = 0;      ///< the number of the first segment, over all ranks
  std::int64_t number_of_segments = 0; ///< how many segments all ranks have
  std::vector<int> segment_markers;    ///< those of this rank's segments, or none
  /// @}

  /// \name Components
  /// @{
  std::vector<Point_2> holes;  ///< points in holes that this rank has read
  std::vector<Region> regions; ///< those that this rank has read
  /// @}

  std::size_t first_number = 0; ///< from where the file counts, 0 or 1
};

} // namespace CGAL

#endif // CGAL_PSLG_SLICE_2_H
