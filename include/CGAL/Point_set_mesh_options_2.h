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
/// Options of `Point_set_mesher_2`. Each option is set by the function of its name, which returns the
/// options, so that calls can be chained. Without an argument the function returns the value:
/// `Point_set_mesh_options_2().bounded_angles(36, 80).effort(1)`.
class Point_set_mesh_options_2 {
public:
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

  using Callback = std::function<bool(double)>; ///< of the share of work done

  /// Chooses BOUNDED_ANGLES, the default, with angles in degrees.
  /// \param least the least angle, in [0, 37.5]
  /// \param largest the largest angle, in [78.6, 89.5]
  Point_set_mesh_options_2& bounded_angles(double least = 36, double largest = 80) {
    least_angle_in_degrees_ = least;
    largest_angle_in_degrees_ = largest;
    return choose(Mode::BOUNDED_ANGLES);
  }
  /// Chooses ACUTE. It seeks largest angles up to 89.5 degrees, and only triangles around clusters of points
  /// come nearer to 90.
  Point_set_mesh_options_2& acute() { return choose(Mode::ACUTE); }
  /// Chooses LEAST_ANGLE.
  Point_set_mesh_options_2& least_angle() { return choose(Mode::LEAST_ANGLE); }
  /// Chooses WARPED_SQUARES.
  Point_set_mesh_options_2& warped_squares() { return choose(Mode::WARPED_SQUARES); }
  Mode mode() const { return mode_; } ///< the one chosen last
  /// The least angle that BOUNDED_ANGLES was chosen with last.
  double least_angle_in_degrees() const { return least_angle_in_degrees_; }
  /// The largest angle that BOUNDED_ANGLES was chosen with last.
  double largest_angle_in_degrees() const { return largest_angle_in_degrees_; }

  /// What the mesh covers; ROW by default.
  Point_set_mesh_options_2& mesh_domain(Domain value) { return mesh_domain_ = value, *this; }
  Domain mesh_domain() const { return mesh_domain_; } ///< the value set

  /// How much effort to spend on removing vertices. 0: none. 1: mostly in the neighborhood of one ring. 2,
  /// the default: well. 3: for some percent more. The promised angles are the same at any effort.
  Point_set_mesh_options_2& effort(int value) { return effort_ = value, *this; }
  int effort() const { return effort_; } ///< the value set

  /// An upper bound, roughly, on how many vertices the mesher tries to remove. Each takes some ten
  /// microseconds. 0, the default, means no bound.
  Point_set_mesh_options_2& max_removals(std::size_t value) { return max_removals_ = value, *this; }
  std::size_t max_removals() const { return max_removals_; } ///< the value set

  /// With ACUTE, points that are this many times nearer to each other than to any other point get a quadtree
  /// of their own. At least 2248; 2^20 by default. Clusters save time before coarsening, and save triangles
  /// beyond about a million.
  Point_set_mesh_options_2& clusters(double value) { return clusters_ = value, *this; }
  double clusters() const { return clusters_; } ///< the value set

  /// Called now and then with the share of work done, in [0, 1], by any thread, one at a time. After it
  /// returns false no more vertices are removed. The mesh is then valid but larger. An empty function, the
  /// default, is not called.
  Point_set_mesh_options_2& progress(Callback value) { return progress_ = std::move(value), *this; }
  const Callback& progress() const { return progress_; } ///< the value set

private:
  Domain mesh_domain_ = Domain::ROW;
  int effort_ = 2;
  std::size_t max_removals_ = 0;
  double clusters_ = 0x1p20;
  Callback progress_;
  Mode mode_ = Mode::BOUNDED_ANGLES;
  double least_angle_in_degrees_ = 36;
  double largest_angle_in_degrees_ = 80;

  Point_set_mesh_options_2& choose(Mode value) { return mode_ = value, *this; }
};

} // namespace CGAL

#endif // CGAL_POINT_SET_MESH_OPTIONS_2_H
