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
/// Options of `Point_set_mesher_2`. Every field has a default. Set fields directly or by chained calls:
/// `Point_set_mesh_options_2().bounded_angles(36, 80).effort(1)`.
struct Point_set_mesh_options_2 {
  /// Which triangulation is wanted.
  enum class Mode {
    /// All angles in a range: [36, 80] degrees by default, at the tightest [37.5, 78.6] (Theorem 3).
    BOUNDED_ANGLES,
    /// All angles less than 90 degrees, with O(n) triangles however small clusters of points are (Theorem 4).
    ACUTE,
    /// All angles at least 20.7 degrees, with the fewest triangles we know how to make.
    LEAST_ANGLE,
    /// The classical construction, which moves corners of quadtree squares to the points. All angles in
    /// [22.47, 112.63].
    WARPED_SQUARES
  };
  /// What the mesh covers. LEAST_ANGLE ignores this and fills a box that is a little larger than the points'
  /// bounding box. WARPED_SQUARES ignores it and fills a square.
  enum class Domain {
    /// With BOUNDED_ANGLES a row of squares along the points' diameter, as in the paper, at least twice as
    /// high as the points. The total length of edges is then within a constant factor of the least. With
    /// ACUTE the square.
    ROW,
    /// The root of an axis-parallel quadtree: a square with a power of two as its side and the points in its
    /// middle half.
    SQUARE
  };

  Mode mode = Mode::BOUNDED_ANGLES; ///< which triangulation
  /// The least angle in degrees with BOUNDED_ANGLES, in [0, 37.5]. The largest is in [78.6, 89.5]. ACUTE
  /// ignores both: it seeks largest angles up to 89.5, and only triangles around clusters of points come
  /// nearer to 90.
  double least_angle_in_degrees = 36;
  double largest_angle_in_degrees = 80; ///< the largest angle in degrees
  Domain domain = Domain::ROW;          ///< what the mesh covers
  /// How much effort to spend on removing vertices. 0: none. 1: mostly in the neighborhood of one ring. 2:
  /// well. 3: for some percent more. The promised angles are the same at any effort.
  int coarsening_effort = 2;
  /// An upper bound, roughly, on how many vertices the mesher tries to remove. Each takes some ten
  /// microseconds. 0 means no bound.
  std::size_t removal_budget = 0;
  /// With ACUTE, points that are this many times nearer to each other than to any other point get a quadtree
  /// of their own. At least 2248. Clusters save time before coarsening, and save triangles beyond about a
  /// million.
  double cluster_gap = 0x1p20;
  /// Called now and then with the share of work done, in [0, 1], by any thread, one at a time. After it
  /// returns false no more vertices are removed. The mesh is then valid but larger.
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
