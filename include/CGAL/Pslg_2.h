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
#include <string>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// A planar straight-line graph: vertices, segments between them, and points that mark holes and regions.
///
/// This is a plain container in structure-of-arrays form. All indices are 0-based. The comment of each array
/// states its requirements, and `check_pslg_structure()` checks them. The graph need not be planar:
/// `find_pslg_defects()` lists where it is not, and `repair_pslg_2()` makes it planar.
/// `IO::read_triangle_poly()` reads a graph from a file.
///
/// By the rule of Triangle and Mesh_2, the domain is everything that segments separate from infinity, except
/// the components with the point of a hole. `Quality_mesh_options_2::Domain` has other rules.
/// \tparam Point a point type with members `x()` and `y()`: a CGAL kernel's `Point_2` or
/// `Fixed_point_2<Word>`.
template <class Point>
class Pslg_2 {
public:
  /// \name Types
  /// @{

  /// A point of the kernel, the place of a vertex.
  using Point_2 = Point;
  /// Names a vertex by its place in the array.
  using Vertex_index = Quadtree_mesh_2::Vertex_index;
  /// Names a segment of the input by its place in the array.
  using Segment_index = Quadtree_mesh_2::Segment_index;
  /// The two ends of a segment.
  using Segment = std::array<Vertex_index, 2>;
  /// @}

  /// A point that gives its component of the domain an attribute. If its area is positive, it also bounds the
  /// area of triangles there, in addition to the bound of the options.
  struct Region {
    Point_2 point;        ///< in the interior of the component
    double attribute = 0; ///< free to use
    double max_area = 0;  ///< 0 for no bound
  };

  /// The places of the vertices: finite, and not all on a line. Vertices at the same place count as one.
  std::vector<Point_2> vertices;
  /// Markers of the vertices, free to use, 0 for none. Empty, or one for each vertex.
  std::vector<int> vertex_markers;
  /// The number of attributes that each vertex has in addition to its coordinates.
  std::size_t number_of_vertex_attributes = 0;
  /// The attributes of vertex 0, then those of vertex 1, and so on.
  std::vector<double> vertex_attributes;

  /// The segments: pairs of indices of vertices.
  std::vector<Segment> segments;
  /// Markers of the segments, free to use, 0 for none. Empty, or one for each segment.
  std::vector<int> segment_markers;

  /// One point inside each hole.
  std::vector<Point_2> holes;
  /// The regions. The first one in a component counts. With `Quality_mesh_options_2::Domain::MARKED` they
  /// also determine the domain.
  std::vector<Region> regions;

  /// Names of the markers 1, 2, ... of segments, from the file that the graph was read from; empty if markers are
  /// numbers only.
  std::vector<std::string> marker_names;
  /// Names of the attributes 1, 2, ... of regions; empty if attributes are numbers only.
  std::vector<std::string> region_names;

  /// What messages and written files count vertices, segments, holes and regions from: 1 if the file that the
  /// graph was read from does. Indices count from 0 all the same.
  std::size_t first_number = 0;

  /// Appends a vertex. If there are markers or attributes, the caller appends those.
  Vertex_index add_vertex(const Point_2& p) {
    vertices.push_back(p);
    return Vertex_index(vertices.size() - 1);
  }
  /// Appends a segment. If there are markers, the caller appends one.
  Segment_index add_segment(Vertex_index a, Vertex_index b) {
    segments.push_back({a, b});
    return Segment_index(segments.size() - 1);
  }

  /// The place of a vertex.
  const Point_2& point(Vertex_index v) const { return vertices[std::size_t(v)]; }
  /// The ends of a segment.
  const Segment& segment(Segment_index s) const { return segments[std::size_t(s)]; }
  /// The number of vertices.
  std::size_t number_of_vertices() const { return vertices.size(); }
  /// The number of segments.
  std::size_t number_of_segments() const { return segments.size(); }
};

} // namespace CGAL

#endif // CGAL_PSLG_2_H
