// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_POINT_SET_MESHER_2_H
#define CGAL_POINT_SET_MESHER_2_H

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Point_set_mesh_options_2.h>
#include <CGAL/Point_set_mesh_report_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Point_set_pipeline.h>
#include <CGAL/tags.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Triangulates a set of points, with Steiner points, so that all angles are in a range or all are acute.
///
/// Every input point is a vertex of the mesh, with its coordinates bit for bit. Equal points are merged. The
/// mesh covers a square, a row of squares or a box around the points: see `Point_set_mesh_options_2`. Meshes
/// with BOUNDED_ANGLES or ACUTE are acute, and therefore Delaunay.
///
/// The method is that of Bern, Eppstein, Teng, "Parallel construction of quadtrees and quality
/// triangulations", section 5 (Theorems 3 and 4). Tiles fill a balanced quadtree, and the tile vertices
/// nearest to the points move to them. The paper separates points by squares small enough for any case. Here
/// squares are split only where relaxation of the mesh fails. At the paper's size of squares, angles are
/// certified to be in [37.5, 78.6]. Guarded removal then takes out vertices that are not needed. Expected O(n
/// log n + k) time for a quadtree of k squares; k = O(n) with ACUTE.
/// \tparam Traits a model of `QuadtreeTraits_2` that names a meshing geometry.
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the mesh is the same for any number of threads.
template <class Traits = Filtered_quadtree_traits_2<>, class ConcurrencyTag = Sequential_tag>
class Point_set_mesher_2 {
public:
  /// \name Types
  /// @{

  /// The traits.
  using Geom_traits = Traits;
  /// A point of the input and of the mesh.
  using Point_2 = typename Traits::Point_2;
  /// The result.
  using Mesh = Indexed_mesh_2<Point_2>;
  /// @}

  /// A mesher with these options.
  /// \throws std::invalid_argument if an option is out of its range.
  explicit Point_set_mesher_2(Point_set_mesh_options_2 options = {}, const Traits& traits = Traits())
      : options_(std::move(options)), traits_(traits) {
    using Mode = Point_set_mesh_options_2::Mode;
    const double least = options_.least_angle_in_degrees(), largest = options_.largest_angle_in_degrees();
    if (options_.mode() == Mode::BOUNDED_ANGLES && !(least >= 0 && least <= 37.5))
      throw std::invalid_argument("the least angle must be between 0 and 37.5 degrees");
    if (options_.mode() == Mode::BOUNDED_ANGLES && !(largest >= 78.6 && largest <= 89.5))
      throw std::invalid_argument("the largest angle must be between 78.6 and 89.5 degrees");
    if (options_.effort() < 0 || options_.effort() > 3)
      throw std::invalid_argument("the effort must be 0, 1, 2 or 3");
    if (!(options_.clusters() >= Quadtree_mesh_2::internal::least_cluster_gap))
      throw std::invalid_argument("the gap around clusters must be at least 2248 times their width");
  }

  /// Returns the mesh of points.
  /// \throws Quadtree_mesh_2::Point_error if a coordinate is not a finite number, or if two distinct points
  /// are too near to each other for a quadtree. The error names the points.
  Mesh operator()(const std::vector<Point_2>& points);

  /// What the last run reached.
  const Point_set_mesh_report_2& report() const { return report_; }
  /// The options of this mesher.
  const Point_set_mesh_options_2& options() const { return options_; }

private:
  Point_set_mesh_options_2 options_;
  Traits traits_;
  Point_set_mesh_report_2 report_;
};

// Defined outside the class, so not inline: a compiled library spares the compiler the body.
template <class Traits, class ConcurrencyTag>
typename Point_set_mesher_2<Traits, ConcurrencyTag>::Mesh
Point_set_mesher_2<Traits, ConcurrencyTag>::operator()(const std::vector<Point_2>& points) {
  using Pipeline =
      Quadtree_mesh_2::internal::Point_set_pipeline<Traits,
                                                    Quadtree_mesh_2::internal::Inner_tag<ConcurrencyTag>>;
  const Quadtree_mesh_2::internal::Concurrency_scope scope{ConcurrencyTag()};
  report_ = Point_set_mesh_report_2();
  return Pipeline(points, options_, traits_, report_).run();
}

} // namespace CGAL

#define CGAL_QUADTREE_MESH_2_HAS_POINT_SET_MESHER
#include <CGAL/Quadtree_mesh_2/compiled_meshers.h>

#endif // CGAL_POINT_SET_MESHER_2_H
