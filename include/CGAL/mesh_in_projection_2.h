// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_MESH_IN_PROJECTION_2_H
#define CGAL_MESH_IN_PROJECTION_2_H

#include <CGAL/Conformal_projection_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Projected_graph.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Projected_mesh.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// The longitudes and latitudes of a graph's vertices, for the choice of a projection.
/// \throws Pslg_error_2 if `check_pslg_structure()` does, or if a vertex is on a pole or beyond, a segment spans more
/// than 180 degrees of longitude, or all vertices more than 360: the vertex, the segment, or two vertices. Longitudes
/// are taken as they are: where a border crosses the antimeridian they have to go on beyond 180 degrees.
template <class Point>
Conformal_projection_2::Box box_in_degrees(const Pslg_2<Point>& degrees) {
  return Quadtree_mesh_2::internal::checked_box_in_degrees(degrees);
}

/// \ingroup PkgQuadtreeMesh2Data
/// What `mesh_in_projection_2()` did, and the mesh in the plane of the projection.
template <class Point>
struct Projected_mesh_2 {
  /// The graph in meters: the vertices of the input, then those that split segments; pieces of segments.
  Pslg_2<Point> graph;
  /// The mesh of that graph, as it was made. Triangles have the numbers that they have in degrees, vertices may not.
  Indexed_mesh_2<Point> mesh;
  /// For its vertices, the images of their places in degrees. Those of new vertices on segments depart a little.
  std::vector<Point> images;
  std::size_t split_vertices =
      0;                  ///< placed on segments before meshing, so that these bend less in the projection
  std::size_t rounds = 0; ///< how often the graph was meshed
  std::size_t bent_triangles = 0; ///< still below the bound because a segment bends
};

/// \ingroup PkgQuadtreeMesh2Meshers
/// Options for the plane of a projection, so that the bounds still hold where segments are bent back: angles a few
/// thousandths of a degree larger, lengths and areas one or two percent smaller.
/// \throws std::invalid_argument if borders are to be kept: segments that bend are split before they are meshed
inline Quality_mesh_options_2 options_in_projection_2(Quality_mesh_options_2 options) {
  if (options.keep_borders() != Quality_mesh_options_2::Keep_borders::NONE)
    throw std::invalid_argument("in a projection long segments are split, so borders cannot be kept");
  const double angle = options.min_angle();
  if (angle <= 20.7) options.min_angle(angle + 0.004); // quadtrees go up to 20.7048 degrees
  if (angle > 20.71) options.min_angle(std::min(Quality_mesh_options_2::greatest_min_angle, angle + 0.01));
  return options.max_edge(0.99 * options.max_edge()).max_area(0.98 * options.max_area());
}

/// \ingroup PkgQuadtreeMesh2Meshers
/// Meshes a graph given in degrees of longitude and latitude in a conformal projection, where angles are those on the
/// ground, and gives the mesh back in degrees.
///
/// Segments are straight in degrees and bend in the projection. So long ones are split before: none departs from its
/// image by more than a thousandth of its length, nor by more than `tolerance`. Where pieces cross in the plane that
/// do not cross in degrees, they are split further. A new vertex on a segment is placed by its parameter on the
/// segment in degrees. So it is on the segment up to rounding, and moves a little from where it was meshed. Where that
/// puts an angle below `min_angle`, or a triangle on its other side, the segment keeps its vertices from the start
/// and the graph is meshed again, up to eight times.
///
/// Guarantees: vertices of the input are kept bit for bit, in their order. Segments are chains of edges up to the
/// rounding of vertices on them. All triangles are counterclockwise in degrees, by exact predicates.
/// Takes O(n log n) time for the graph, and that of the mesher in each round.
/// \param degrees the graph, x longitudes and y latitudes; bounds of areas of regions are in square meters
/// \param projection of its places
/// \param mesher makes an `Indexed_mesh_2<Point>` of a `Pslg_2<Point>` in meters, by `options_in_projection_2()`
/// \param min_angle least angle in degrees
/// \param report what was done
/// \param tolerance in meters, for bounds of size: a thousandth of the size wanted
/// \tparam Point a CGAL point over double
/// \throws Pslg_error_2 as `box_in_degrees()` does; if segments cross in degrees; if two vertices have one place in the
/// projection. Whatever the mesher throws, about parts of the graph in meters.
/// \throws std::runtime_error if a triangle is still on its other side in the end
template <class Point, class Mesher>
Indexed_mesh_2<Point> mesh_in_projection_2(const Pslg_2<Point>& degrees,
                                           const Conformal_projection_2& projection, Mesher mesher,
                                           double min_angle, Projected_mesh_2<Point>& report,
                                           double tolerance = std::numeric_limits<double>::infinity()) {
  namespace internal = Quadtree_mesh_2::internal;
  constexpr std::size_t most_rounds = 8;
  internal::Projected_graph<Point> graph(degrees, projection, tolerance);
  for (std::size_t round = 1;; ++round) {
    graph.separate();
    report.graph = graph.pslg();
    report.split_vertices = graph.number_of_splits();
    report.rounds = round;
    internal::Projected_mesh<Point> mesh(graph, mesher(graph.pslg()));
    const auto defects = mesh.find_defects(min_angle);
    report.bent_triangles = defects.bent;
    const bool is_last = round == most_rounds || defects.places.empty();
    if (!is_last) {
      graph.split(defects.places);
      continue;
    }
    if (defects.inverted > 0)
      throw std::runtime_error("the mesh has triangles on their other side in degrees, the first one at " +
                               internal::place_text(defects.first_inverted) +
                               ": split the long segments there");
    report.mesh = mesh.in_plane();
    report.images = mesh.images();
    return mesh.in_degrees();
  }
}

} // namespace CGAL

#endif // CGAL_MESH_IN_PROJECTION_2_H
