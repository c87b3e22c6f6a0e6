// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_JOINED_SLICES_H
#define QUADTREE_MESH_2_TEST_JOINED_SLICES_H

// Slices of a graph, one after the other, as the graph.

#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_slice_2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace joined_slices {

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// How much is wrong with the numbers of slices, which are all of a graph.
template <class Point>
int wrong_numbers(const std::vector<CGAL::Pslg_slice_2<Point>>& slices) {
  int wrong = 0;
  std::int64_t vertices = 0, segments = 0;
  for (const auto& slice : slices) {
    wrong += slice.first_vertex != vertices || slice.first_segment != segments;
    vertices += static_cast<std::int64_t>(slice.vertices.size());
    segments += static_cast<std::int64_t>(slice.segments.size());
  }
  for (const auto& slice : slices)
    wrong += slice.number_of_vertices != vertices || slice.number_of_segments != segments;
  return wrong;
}

template <class Point>
CGAL::Pslg_2<Point> joined(const std::vector<CGAL::Pslg_slice_2<Point>>& slices) {
  CGAL::Pslg_2<Point> graph;
  for (const auto& slice : slices) {
    append(graph.vertices, slice.vertices), append(graph.vertex_attributes, slice.vertex_attributes);
    append(graph.vertex_markers, slice.vertex_markers), append(graph.segment_markers, slice.segment_markers);
    append(graph.holes, slice.holes), append(graph.regions, slice.regions);
    for (const std::array<std::int64_t, 2>& s : slice.segments)
      graph.segments.push_back(
          {CGAL::Quadtree_mesh_2::Vertex_index(s[0]), CGAL::Quadtree_mesh_2::Vertex_index(s[1])});
    graph.number_of_vertex_attributes = slice.number_of_vertex_attributes;
    graph.first_number = slice.first_number;
  }
  return graph;
}

template <class Point>
bool are_same(const CGAL::Pslg_2<Point>& a, const CGAL::Pslg_2<Point>& b) {
  if (a.regions.size() != b.regions.size()) return false;
  for (std::size_t i = 0; i < a.regions.size(); ++i)
    if (a.regions[i].point != b.regions[i].point || a.regions[i].attribute != b.regions[i].attribute ||
        a.regions[i].max_area != b.regions[i].max_area)
      return false;
  return a.vertices == b.vertices && a.vertex_attributes == b.vertex_attributes &&
         a.number_of_vertex_attributes == b.number_of_vertex_attributes &&
         a.vertex_markers == b.vertex_markers && a.segments == b.segments &&
         a.segment_markers == b.segment_markers && a.holes == b.holes && a.first_number == b.first_number;
}

} // namespace joined_slices

#endif // QUADTREE_MESH_2_TEST_JOINED_SLICES_H
