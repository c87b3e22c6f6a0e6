// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_POINT_SET_MESH_OPTIONS_2_H
#define CGAL_POINT_SET_MESH_OPTIONS_2_H

#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// What `Point_set_mesher_2` shall make. Every field has its default; set fields directly or by chained calls:
/// `Point_set_mesh_options_2().bounded_angles(36, 80).effort(1)`.
struct Point_set_mesh_options_2 {
  /// Which triangulation is wanted.
  enum class Mode {
    /// All angles in a range, [36, 80] degrees or what is asked for, down to [37.5, 78.6] (Theorem 3).
    BOUNDED_ANGLES,
    /// All angles less than 90 degrees, by O(n) triangles however near to each other points are (Theorem 4).
    ACUTE,
    /// All angles at least 20.7 degrees, with the fewest triangles we know how to make.
    LEAST_ANGLE,
    /// The classical construction: corners of quadtree squares are moved to the points. Angles in [22.47, 112.63].
    WARPED_SQUARES
  };
  /// What is triangulated. (LEAST_ANGLE fills a box that is a little larger than the points' bounding box, and
  /// WARPED_SQUARES a square, whatever this says.)
  enum class Domain {
    /// With BOUNDED_ANGLES a row of squares along the points' diameter, as in the paper, twice as high as the points
    /// at least; so edges have a total length within a constant factor of the least. With ACUTE the square.
    ROW,
    /// The root of a quadtree parallel to the axes: a square with a power of two as side and the points in its middle
    /// half.
    SQUARE
  };

  Mode mode = Mode::BOUNDED_ANGLES; ///< which triangulation
  /// In degrees; of BOUNDED_ANGLES in [0, 37.5] and [78.6, 89.5]; with ACUTE largest angles up to 89.5 are sought,
  /// and only what surrounds clusters of points comes nearer to 90.
  double least_angle_in_degrees = 36;
  double largest_angle_in_degrees = 80; ///< as the least
  Domain domain = Domain::ROW;          ///< what is triangulated
  /// How hard it is tried to do without vertices: 0 not at all, 1 in the neighbourhood of one ring mostly, 2 well, 3 for
  /// some percent more. All angles are the same promise at any effort.
  int coarsening_effort = 2;
  /// At most about this many vertices are tried to be removed, each some ten microseconds of work; 0 for no bound.
  std::size_t removal_budget = 0;
  /// Points that are this many times nearer to each other than to any other point are meshed by a quadtree of their own
  /// with ACUTE; at least 2248. Clusters save time before the mesh is coarsened, and triangles beyond about a million.
  double cluster_gap = 0x1p20;
  /// Called now and then with the share of work done, in [0, 1], by any thread, one at a time; after false no more
  /// vertices are removed, so that the mesh is valid but larger.
  std::function<bool(double)> callback;

  /// \name Setters
  /// @{

  /// Each sets what its name says and returns the options, so that calls can be chained.
  Point_set_mesh_options_2& bounded_angles(double least = 36, double largest = 80) {
    mode = Mode::BOUNDED_ANGLES;
    least_angle_in_degrees = least;
    largest_angle_in_degrees = largest;
    return *this;
  }
  Point_set_mesh_options_2& acute() { return mode = Mode::ACUTE, *this; }
  Point_set_mesh_options_2& least_angle() { return mode = Mode::LEAST_ANGLE, *this; }
  Point_set_mesh_options_2& warped_squares() { return mode = Mode::WARPED_SQUARES, *this; }
  Point_set_mesh_options_2& mesh_domain(Domain d) { return domain = d, *this; }
  Point_set_mesh_options_2& effort(int e) { return coarsening_effort = e, *this; }
  Point_set_mesh_options_2& max_removals(std::size_t n) { return removal_budget = n, *this; }
  Point_set_mesh_options_2& clusters(double gap) { return cluster_gap = gap, *this; }
  Point_set_mesh_options_2& progress(std::function<bool(double)> f) { return callback = std::move(f), *this; }
  /// @}
};

} // namespace CGAL

#endif // CGAL_POINT_SET_MESH_OPTIONS_2_H
