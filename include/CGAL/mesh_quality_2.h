// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_MESH_QUALITY_2_H
#define CGAL_MESH_QUALITY_2_H

/// \file
/// Checks a mesh against its input. Computes its angles, lengths and areas. Works independently of the
/// algorithms that make meshes.
///
/// The input's domain comes from a plain constrained Delaunay triangulation of the input. A mesh covers the
/// domain exactly if its triangles are counterclockwise and its border is that of the domain, edge by edge.
/// Vertices along segments are rounded, so edges along segments have to divide the plane as the segments do.
/// All of that is decided exactly, for coordinates of any size. Takes O(n log n + k) time for n input and k
/// mesh vertices in practice, one to two seconds for 10^6 triangles by one thread.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Loops.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Mesh_checker.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Mesh_statistics.h>
#include <CGAL/Quadtree_mesh_2/mesh_quality_types.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace Quadtree_mesh_2 {
namespace internal {

using Double_point = Exact_predicates_inexact_constructions_kernel::Point_2;

template <class Number>
double to_nearest_double(const Number& x) {
  if constexpr (std::is_arithmetic_v<Number>)
    return static_cast<double>(x);
  else
    return CGAL::to_double(x);
}

template <class Point>
std::vector<Double_point> to_double_points(const std::vector<Point>& points) {
  std::vector<Double_point> result;
  result.reserve(points.size());
  for (const Point& p : points) result.emplace_back(to_nearest_double(p.x()), to_nearest_double(p.y()));
  return result;
}

inline Mesh_quality_2 check_and_measure(const Mesh_checker::Mesh& mesh, const Mesh_checker::Pslg& pslg,
                                        const Mesh_quality_options_2& options, const Loops& loops) {
  Mesh_quality_2 quality;
  Mesh_checker checker(mesh, pslg, options, loops, quality);
  if (!checker.check_arrays()) return quality;
  checker.check();
  Mesh_statistics(mesh, pslg, checker, options).compute(loops, quality);
  return quality;
}

} // namespace internal
} // namespace Quadtree_mesh_2

/// \ingroup PkgQuadtreeMesh2Data
/// Returns the mesh with its coordinates converted to double.
///
/// This is exact for coordinates that doubles represent, such as integers up to 2^53. Others are rounded to
/// nearest. Integer words up to 2^62 move by up to 2^8 units. Points closer than that may end at one place,
/// or on the other side of an edge. So a mesh that is valid in its own coordinates may fail the check of the
/// rounded ones.
/// \tparam Point `x()` and `y()` are arithmetic or have a `CGAL::to_double()`.
template <class Point>
Indexed_mesh_2<Quadtree_mesh_2::internal::Double_point>
convert_to_double_points(const Indexed_mesh_2<Point>& mesh) {
  Indexed_mesh_2<Quadtree_mesh_2::internal::Double_point> result;
  result.number_of_input_vertices = mesh.number_of_input_vertices;
  result.points = Quadtree_mesh_2::internal::to_double_points(mesh.points);
  result.triangles = mesh.triangles;
  result.neighbors = mesh.neighbors;
  for (const auto& e : mesh.constrained_edges)
    result.constrained_edges.push_back({e.vertices, e.segment, e.marker});
  result.region_of_triangle = mesh.region_of_triangle;
  result.segment_of_vertex = mesh.segment_of_vertex;
  result.vertex_markers = mesh.vertex_markers;
  result.input_index = mesh.input_index;
  return result;
}

/// \ingroup PkgQuadtreeMesh2Data
/// Returns the graph with its coordinates converted to double, with the same proviso.
template <class Point>
Pslg_2<Quadtree_mesh_2::internal::Double_point> convert_to_double_points(const Pslg_2<Point>& pslg) {
  Pslg_2<Quadtree_mesh_2::internal::Double_point> result;
  result.vertices = Quadtree_mesh_2::internal::to_double_points(pslg.vertices);
  result.vertex_markers = pslg.vertex_markers;
  result.number_of_vertex_attributes = pslg.number_of_vertex_attributes;
  result.vertex_attributes = pslg.vertex_attributes;
  result.segments = pslg.segments;
  result.first_number = pslg.first_number;
  result.segment_markers = pslg.segment_markers;
  result.holes = Quadtree_mesh_2::internal::to_double_points(pslg.holes);
  for (const auto& r : pslg.regions)
    result.regions.push_back({{Quadtree_mesh_2::internal::to_nearest_double(r.point.x()),
                               Quadtree_mesh_2::internal::to_nearest_double(r.point.y())},
                              r.attribute,
                              r.max_area});
  return result;
}

/// \ingroup PkgQuadtreeMesh2Data
/// Checks `mesh` against `pslg`, and its triangles against the bounds in `options`.
///
/// Never throws because of its input: a mesh or graph that makes no sense has errors. The graph may have
/// duplicate vertices (the mesh may use any one of them), vertices on segments, and overlapping segments. It
/// may not have crossing segments, nor points of holes or regions on segments that separate components.
///
/// The check covers:
///
/// - the indices
/// - the exact orientation of the triangles
/// - every edge is in at most two triangles, in opposite directions
/// - the neighbors
/// - no two used vertices are at one place
/// - input vertices are at their index, bit for bit
/// - there are no unused Steiner vertices
/// - the domain is covered exactly
/// - every input segment with the domain on a side is a chain of edges, within rounding
///   (`Mesh_quality_options_2::coordinate_unit()`)
/// - the constrained edges, the segments of the vertices, and the regions
///
/// Points other than CGAL points over double are first converted by `convert_to_double_points()`.
/// \tparam ConcurrencyTag `Sequential_tag`, or `Parallel_tag` for several threads; what is found is the same
template <class ConcurrencyTag = Sequential_tag, class Point>
Mesh_quality_2 mesh_quality_2(const Indexed_mesh_2<Point>& mesh, const Pslg_2<Point>& pslg,
                              const Mesh_quality_options_2& options = {}) {
  if constexpr (!std::is_same_v<Point, Quadtree_mesh_2::internal::Double_point>) {
    Mesh_quality_options_2 of_doubles = options;
    if (std::is_integral_v<std::decay_t<decltype(std::declval<const Point&>().x())>>)
      of_doubles.coordinate_unit(std::max(1., options.coordinate_unit()));
    return mesh_quality_2<ConcurrencyTag>(convert_to_double_points(mesh), convert_to_double_points(pslg),
                                          of_doubles);
  } else {
    const Quadtree_mesh_2::internal::Loops loops{ConcurrencyTag()};
    return Quadtree_mesh_2::internal::check_and_measure(mesh, pslg, options, loops);
  }
}

/// \ingroup PkgQuadtreeMesh2Data
/// Writes errors and statistics as a table for human readers.
inline std::ostream& operator<<(std::ostream& out, const Mesh_quality_2& q) {
  out << (q.is_valid() ? "valid mesh" : "invalid mesh") << '\n';
  for (const std::string& e : q.errors) out << "  error: " << e << '\n';
  if (q.number_of_errors > q.errors.size())
    out << "  and " << q.number_of_errors - q.errors.size() << " more errors\n";
  out << "  vertices           " << q.vertices << '\n'
      << "  triangles          " << q.triangles << '\n'
      << "  edges              " << q.edges << ", " << q.border_edges << " on the border\n"
      << "  area               " << q.area << '\n'
      << "  edge lengths       " << q.shortest_edge << " .. " << q.longest_edge << ", in all "
      << q.total_length << '\n'
      << "  angles             " << q.min_angle << " .. " << q.max_angle << '\n'
      << "  least new angle    " << q.min_new_angle << '\n'
      << "  exempt triangles   " << q.exempt_triangles << '\n'
      << "  unmet triangles    " << q.unmet_triangles.size() << '\n';
  for (std::size_t i = 0; i < q.angle_histogram.size(); ++i)
    out << "  [" << 10 * i << ", " << 10 * (i + 1) << ")  " << q.angle_histogram[i] << '\n';
  return out;
}

} // namespace CGAL

#define CGAL_QUADTREE_MESH_2_HAS_MESH_QUALITY
#include <CGAL/Quadtree_mesh_2/compiled_meshers.h>

#endif // CGAL_MESH_QUALITY_2_H
