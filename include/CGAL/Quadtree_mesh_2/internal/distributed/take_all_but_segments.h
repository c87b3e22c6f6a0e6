// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_TAKE_ALL_BUT_SEGMENTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_TAKE_ALL_BUT_SEGMENTS_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_slice_2.h>

#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Moves what readers of slices have put into a graph to the slice, whose segments have longer numbers.
template <class Point>
void take_all_but_segments(Pslg_2<Point>& graph, Pslg_slice_2<Point>& slice) {
  slice.vertices = std::move(graph.vertices);
  slice.vertex_attributes = std::move(graph.vertex_attributes);
  slice.number_of_vertex_attributes = graph.number_of_vertex_attributes;
  slice.vertex_markers = std::move(graph.vertex_markers);
  slice.segment_markers = std::move(graph.segment_markers);
  slice.holes = std::move(graph.holes);
  slice.regions = std::move(graph.regions);
  slice.first_number = graph.first_number;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_TAKE_ALL_BUT_SEGMENTS_H
