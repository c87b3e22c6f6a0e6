// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_ROUND_MESH_2_H
#define CGAL_ROUND_MESH_2_H

/// \file
/// Turns a mesh over exact numbers or words into one over doubles in which all triangles are
/// counterclockwise.
///
/// Computes: every vertex at its nearest double. If triangles then are flat or clockwise, or pieces of a
///           segment go back or reach into a gap outside that is too narrow for them, it tries other doubles nearby,
///           other diagonals, or fewer Steiner vertices, until none does.
/// Bound: O(n), plus time by the degrees of nearby vertices for each triangle at fault. It ends because each
///        step leaves fewer triangles at fault, or fewer vertices.
/// Source: the idea of snap rounding, that vertices at one place become one vertex (Hobby, Computational
///         Geometry 13, 1999).
/// Deviates: vertices are snapped to doubles, not to a uniform grid. Input vertices stay as and where they
///           are, and segments are not drawn to nearby vertices. So there may be no mesh over doubles, and
///           then none is returned.

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Point_set_mesh_report_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/exact_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/internal/output/Rounded_mesh_repairer.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// Doubles cannot express the mesh. `what()` names a place and its vertices.
class Mesh_rounding_error_2 : public Pslg_error_2 {
public:
  /// The error of vertices that have no room.
  /// \param text the text of `what()`
  /// \param parts the vertices of the graph that it names
  Mesh_rounding_error_2(const std::string& text, Pslg_parts_2 parts)
      : Pslg_error_2(Kind::ROUNDING, text, std::move(parts)) {}
};

/// \ingroup PkgQuadtreeMesh2Data
/// The result of `round_mesh_2()`.
template <class Point>
struct Rounded_mesh_2 {
  Indexed_mesh_2<Point> mesh;      ///< all triangles are counterclockwise, exactly
  std::size_t moved_vertices = 0;  ///< Steiner vertices that are not at their nearest doubles
  std::size_t merged_vertices = 0; ///< Steiner vertices merged with a neighbor
  std::size_t flipped_edges = 0;   ///< edges that became the other diagonal of their quadrilateral
  /// Per triangle of the original mesh, its new index; invalid for triangles that merging removed.
  std::vector<Quadtree_mesh_2::Triangle_index> new_triangle;

  /// Whether rounding to the nearest doubles was enough.
  bool is_as_it_was() const { return moved_vertices + merged_vertices + flipped_edges == 0; }

  /// Renumbers the triangles in a mesher's report for this mesh, and drops those that no longer exist. Angles
  /// in the report stay those before rounding.
  void renumber(Quality_mesh_report_2& report) const {
    renumber_list(report.exempt_triangles);
    renumber_rest(report);
  }
  /// The same for a mesh of points.
  void renumber(Point_set_mesh_report_2& report) const { renumber_rest(report); }

private:
  template <class Report>
  void renumber_rest(Report& report) const {
    renumber_list(report.unmet_triangles);
    report.triangles = mesh.triangles.size();
    report.vertices -= merged_vertices;
  }
  template <class Entry>
  void renumber_list(std::vector<Entry>& list) const {
    std::size_t kept = 0;
    for (Entry entry : list) {
      entry.triangle = new_triangle[std::size_t(entry.triangle)];
      if (entry.triangle.is_valid()) list[kept++] = entry;
    }
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(kept), list.end());
  }
};

namespace Quadtree_mesh_2 {
namespace internal {

/// The double nearest to an exact number. A plain conversion of lazy or long numbers may be off by more.
template <class FT>
double nearest_double(const FT& v) {
  if constexpr (std::is_arithmetic<FT>::value) {
    return static_cast<double>(v);
  } else {
    using Field = typename Exact_field<FT>::Type;
    const Field value(CGAL::exact(v));
    const double head = CGAL::to_double(value);
    if (!std::isfinite(head)) return head;
    return head + CGAL::to_double(Field(value - Field(head)));
  }
}

/// Copies everything but the points.
template <class Point, class Other_point>
Indexed_mesh_2<Point> mesh_without_points(Indexed_mesh_2<Other_point>&& other) {
  Indexed_mesh_2<Point> mesh;
  mesh.number_of_input_vertices = other.number_of_input_vertices;
  mesh.triangles = std::move(other.triangles);
  mesh.neighbors = std::move(other.neighbors);
  mesh.constrained_edges.reserve(other.constrained_edges.size());
  for (const auto& e : other.constrained_edges)
    mesh.constrained_edges.push_back({e.vertices, e.segment, e.marker, e.outer_vertex});
  mesh.region_of_triangle = std::move(other.region_of_triangle);
  mesh.segment_of_vertex = std::move(other.segment_of_vertex);
  mesh.vertex_markers = std::move(other.vertex_markers);
  return mesh;
}

template <class Point>
Mesh_rounding_error_2 make_rounding_error(const Indexed_mesh_2<Point>& mesh, Triangle_index t) {
  std::string text = "doubles cannot express the mesh: the triangle of";
  Pslg_parts_2 parts;
  for (const Vertex_index v : mesh.triangles[std::size_t(t)]) {
    const bool is_of_input = std::size_t(v) < mesh.number_of_input_vertices;
    if (is_of_input) parts.vertex(v);
    // By its place alone: owners of graphs may number from 1.
    text += (is_of_input ? " the input's vertex at " : " a Steiner vertex at ") +
            coordinates_text(mesh.point(v)) + ',';
  }
  text +=
      " counterclockwise before rounding, would be flat or clockwise, go back along a segment, or reach "
      "across a gap outside of the domain; features of the input are as "
      "small as the last digit of its coordinates: move it nearer to the origin, or merge what is so near";
  return {text, std::move(parts)};
}

} // namespace internal
} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Data
/// Returns the mesh over doubles. It is valid as before: all triangles are counterclockwise, segments are
/// chains of edges, and edges on both sides of a gap outside of the domain do not cross.
///
/// Input vertices are at the given doubles, and Steiner vertices normally at the nearest ones. If triangles
/// would be flat or clockwise, some Steiner vertices move to other doubles nearby, edges are flipped, and
/// vertices without a double between them are merged. Angles near such places may then be below the bound;
/// `mesh_quality_2()` tells. A Steiner vertex in a segment is next to the segment, as always over doubles. It
/// merges only with other vertices in that segment or with its ends.
///
/// \param mesh with all its arrays, over a kernel with exact numbers or over words; gaps outside are known by
///        `Constrained_edge::outer_vertex`, which meshers set
/// \param input_points the doubles of the input vertices
/// \param to_double the nearest place of a Steiner vertex, a `Point`
/// \throws Mesh_rounding_error_2 if there is a triangle that none of this makes counterclockwise
template <class Point, class Other_point, class To_double>
Rounded_mesh_2<Point> round_mesh_2(Indexed_mesh_2<Other_point> mesh, const std::vector<Point>& input_points,
                                   const To_double& to_double) {
  CGAL_precondition(input_points.size() == mesh.number_of_input_vertices);
  CGAL_precondition(mesh.neighbors.size() == mesh.triangles.size());
  Rounded_mesh_2<Point> result;
  std::vector<Point> points = input_points;
  points.reserve(mesh.points.size());
  for (std::size_t v = points.size(); v < mesh.points.size(); ++v)
    points.push_back(to_double(mesh.points[v]));
  result.mesh = Quadtree_mesh_2::internal::mesh_without_points<Point>(std::move(mesh));
  result.mesh.points = std::move(points);
  Quadtree_mesh_2::internal::Rounded_mesh_repairer<Point> repairer(result.mesh);
  const Quadtree_mesh_2::Triangle_index left = repairer.run();
  if (left.is_valid()) throw Quadtree_mesh_2::internal::make_rounding_error(result.mesh, left);
  result.moved_vertices = repairer.number_of_moved();
  result.new_triangle = repairer.compress();
  result.merged_vertices = repairer.number_of_merged();
  result.flipped_edges = repairer.number_of_flipped();
  return result;
}

/// \ingroup PkgQuadtreeMesh2Data
/// The same. All vertices that are not of the input go to the doubles nearest to the exact numbers.
template <class Point, class Other_point>
Rounded_mesh_2<Point> round_mesh_2(Indexed_mesh_2<Other_point> mesh, const std::vector<Point>& input_points) {
  return round_mesh_2<Point>(std::move(mesh), input_points, [](const Other_point& p) {
    using Quadtree_mesh_2::internal::nearest_double;
    return Point(nearest_double(p.x()), nearest_double(p.y()));
  });
}

/// \ingroup PkgQuadtreeMesh2Data
/// The same. Input vertices go to the nearest doubles, too.
template <class Point, class Other_point>
Rounded_mesh_2<Point> round_mesh_2(Indexed_mesh_2<Other_point> mesh) {
  using Quadtree_mesh_2::internal::nearest_double;
  std::vector<Point> input_points;
  input_points.reserve(mesh.number_of_input_vertices);
  for (std::size_t v = 0; v < mesh.number_of_input_vertices; ++v)
    input_points.emplace_back(nearest_double(mesh.points[v].x()), nearest_double(mesh.points[v].y()));
  return round_mesh_2<Point>(std::move(mesh), input_points);
}

} // namespace CGAL

#endif // CGAL_ROUND_MESH_2_H
