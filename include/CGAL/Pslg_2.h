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

/// \ingroup PkgQuadtreeMesh2Data
/// A planar straight-line graph: vertices, segments between them, and points that mark holes and regions.
///
/// A plain container in structure-of-arrays form; all indices are 0-based. What its arrays have to fulfil is
/// said beside each and checked by `check_pslg_structure()`. It need not be planar: `find_pslg_defects()`
/// lists where it is not, and `repair_pslg_2()` makes it so. `IO::read_triangle_poly()` reads one from a
/// file.
///
/// By the rule of Triangle and Mesh_2, what segments separate from infinity is the domain, except the
/// components with a hole's point in them; `Quality_mesh_options_2::Domain` has other rules.
/// \tparam Point point type with members `x()` and `y()`, a CGAL
/// kernel's `Point_2` or `Fixed_point_2<Word>`.
template <class Point>
class Pslg_2 {
public:
  /// \name Types
  /// @{

  /// That of the template argument, and the indices of what the arrays hold.
  using Point_2 = Point;
  using Vertex_index = Quadtree_mesh_2::Vertex_index;
  using Segment_index = Quadtree_mesh_2::Segment_index;
  using Segment = std::array<Vertex_index, 2>;
  /// @}

  /// A point that gives its component of the domain an attribute and, if positive, a bound on the area of
  /// triangles in it, which holds besides that of the options.
  struct Region {
    Point_2 point;        ///< in the interior of the component
    double attribute = 0; ///< whatever the user likes
    double max_area = 0;  ///< 0 for no bound
  };

  /// Finite; not all on a line. Vertices at the same place count as one.
  std::vector<Point_2> vertices;
  /// What the user calls each vertex, 0 for nothing; empty, or one for each vertex.
  std::vector<int> vertex_markers;
  /// How many numbers each vertex has besides its coordinates.
  std::size_t number_of_vertex_attributes = 0;
  /// The attributes of vertex 0, then those of vertex 1, and so on.
  std::vector<double> vertex_attributes;

  /// Pairs of vertices that exist.
  std::vector<Segment> segments;
  /// What the user calls each segment, 0 for nothing; empty, or one for each segment.
  std::vector<int> segment_markers;

  /// One point inside each hole.
  std::vector<Point_2> holes;
  /// The first one in a component counts. With `Quality_mesh_options_2::Domain::MARKED` they also tell what
  /// the domain is.
  std::vector<Region> regions;

  /// Appends a vertex. Markers and attributes, if there are any, are for the caller to append.
  Vertex_index add_vertex(const Point_2& p) {
    vertices.push_back(p);
    return Vertex_index(vertices.size() - 1);
  }
  /// Appends a segment. Markers, if there are any, are for the caller to append.
  Segment_index add_segment(Vertex_index a, Vertex_index b) {
    segments.push_back({a, b});
    return Segment_index(segments.size() - 1);
  }

  /// The place of a vertex.
  const Point_2& point(Vertex_index v) const { return vertices[std::size_t(v)]; }
  /// The number of vertices.
  std::size_t number_of_vertices() const { return vertices.size(); }
  /// The number of segments.
  std::size_t number_of_segments() const { return segments.size(); }
};

} // namespace CGAL

#endif // CGAL_PSLG_2_H
