// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_PSLG_2_H
#define CGAL_PSLG_2_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

/// A planar straight-line graph: vertices, segments between them, and points that mark holes and regions.
///
/// A plain container in structure-of-arrays form; all indices are 0-based. A consistent `Pslg_2` has
/// `vertex_markers` either empty or as long as `vertices`, `vertex_attributes` of length
/// `number_of_vertex_attributes * vertices.size()`, and `segment_markers` either empty or as long as `segments`.
/// \tparam Point point type with members `x()` and `y()`, a CGAL kernel's `Point_2` or `Fixed_point_2<Word>`.
template <class Point>
class Pslg_2 {
public:
  using Point_2 = Point;
  using Vertex_index = Quadtree_mesh_2::Vertex_index;
  using Segment_index = Quadtree_mesh_2::Segment_index;
  using Segment = std::array<Vertex_index, 2>;

  /// A point that gives its component of the domain an attribute and, if positive, an area bound.
  struct Region {
    Point_2 point;
    double attribute = 0;
    double max_area = 0;
  };

  std::vector<Point_2> vertices;
  std::vector<int> vertex_markers;
  std::size_t number_of_vertex_attributes = 0;
  std::vector<double> vertex_attributes;

  std::vector<Segment> segments;
  std::vector<int> segment_markers;

  /// One point inside each hole.
  std::vector<Point_2> holes;
  std::vector<Region> regions;

  Vertex_index add_vertex(const Point_2& p) {
    vertices.push_back(p);
    return Vertex_index(vertices.size() - 1);
  }
  Segment_index add_segment(Vertex_index a, Vertex_index b) {
    segments.push_back({a, b});
    return Segment_index(segments.size() - 1);
  }

  const Point_2& point(Vertex_index v) const { return vertices[std::size_t(v)]; }
  std::size_t number_of_vertices() const { return vertices.size(); }
  std::size_t number_of_segments() const { return segments.size(); }
};

} // namespace CGAL

#endif // CGAL_PSLG_2_H
