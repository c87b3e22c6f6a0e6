// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The vertices of a mesh that a sharp corner of its graph has placed.
//
// Between two segments at a sharp corner the mesher makes triangles with angles below the bound, all their vertices on
// the two, and places these vertices together. It excuses such triangles because it knows both segments as a whole. It
// would not know the pieces between vertices that are input: they would only be two near lines. So these vertices are
// left to the mesher. O(k) time.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_SHARP_CORNER_FINDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_SHARP_CORNER_FINDER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
double least_angle_in_radians(const Indexed_mesh_2<Point>& mesh, const std::array<Vertex_index, 3>& t) {
  double least = pi;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &a = mesh.point(t[k]), &b = mesh.point(t[(k + 1) % 3]), &c = mesh.point(t[(k + 2) % 3]);
    const double ux = b.x() - a.x(), uy = b.y() - a.y(), vx = c.x() - a.x(), vy = c.y() - a.y();
    least = std::min(least, std::atan2(ux * vy - uy * vx, ux * vx + uy * vy));
  }
  return least;
}

/// The index in the graph of a vertex of its mesh; invalid if it is none of the graph's.
template <class Point>
Vertex_index input_index_of(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg, Vertex_index v) {
  if (!mesh.input_index.empty()) return mesh.input_index[std::size_t(v)];
  return std::size_t(v) < pslg.vertices.size() ? v : Vertex_index();
}

template <class Point>
class Sharp_corner_finder {
public:
  /// \param min_angle the bound, in degrees
  Sharp_corner_finder(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg, double min_angle)
      : mesh_(mesh), pslg_(pslg), bound_(min_angle * radians_per_degree) {}

  /// Per vertex, whether it is inside of a segment and in a triangle between two segments that meet, with an angle
  /// below the bound.
  std::vector<char> vertices() const {
    std::vector<char> result(mesh_.points.size(), 0);
    if (mesh_.segment_of_vertex.empty()) return result;
    for (const auto& t : mesh_.triangles)
      if (is_between_segments(t) && least_angle_in_radians(mesh_, t) < bound_)
        for (const Vertex_index v : t) result[std::size_t(v)] = segment(v).is_valid();
    return result;
  }

private:
  const Indexed_mesh_2<Point>& mesh_;
  const Pslg_2<Point>& pslg_;
  double bound_;

  Segment_index segment(Vertex_index v) const { return mesh_.segment_of_vertex[std::size_t(v)]; }

  /// Whether all vertices are on one or two segments that meet, not all of them at ends.
  bool is_between_segments(const std::array<Vertex_index, 3>& t) const {
    std::array<Segment_index, 2> at;
    for (const Vertex_index v : t) {
      const Segment_index s = segment(v);
      if (!s.is_valid() || s == at[0] || s == at[1]) continue;
      if (at[1].is_valid()) return false;
      at[at[0].is_valid() ? 1 : 0] = s;
    }
    if (!at[0].is_valid() || (at[1].is_valid() && !meet(at[0], at[1]))) return false;
    return std::all_of(t.begin(), t.end(), [&](Vertex_index v) {
      // With one segment alone, the other one has only ends of it in the triangle.
      const bool is_at_end = !at[1].is_valid() || is_end(v, at[0]) || is_end(v, at[1]);
      return segment(v).is_valid() || (is_input(v) && is_at_end);
    });
  }

  bool is_input(Vertex_index v) const { return input_index_of(mesh_, pslg_, v).is_valid(); }
  bool is_end(Vertex_index v, Segment_index s) const {
    const auto& ends = pslg_.segment(s);
    const Vertex_index i = input_index_of(mesh_, pslg_, v);
    return i == ends[0] || i == ends[1];
  }
  bool meet(Segment_index s, Segment_index r) const {
    const auto &a = pslg_.segment(s), &b = pslg_.segment(r);
    return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_SHARP_CORNER_FINDER_H
