// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_MESH_FIGURES_H
#define QUADTREE_MESH_2_BENCHMARK_MESH_FIGURES_H

#include "measurement.h"

#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>

#include <algorithm>
#include <cstddef>

/// What two meshers are compared by. The same code makes these figures for both.
struct Mesh_figures {
  Seconds seconds; ///< from points and segments in memory to a mesh in memory
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t below_bound = 0;      ///< triangles with an angle below the bound, whatever the reason
  std::size_t above_bound = 0;      ///< triangles with an angle above that of the greatest one, likewise
  double min_angle = 180;           ///< degrees
  double min_angle_of_others = 180; ///< of the triangles that are not below the bound
  double max_angle = 0;
};

/// Gathers the figures of a mesh, triangle by triangle.
class Mesh_figures_builder {
public:
  /// \param max_angle_in_degrees 0: no bound
  Mesh_figures_builder(Mesh_figures& figures, double min_angle_in_degrees, double max_angle_in_degrees = 0)
      // The bound is met by a triangle that rounding shows a hair beyond it.
      : figures_(figures), least_(min_angle_in_degrees - 1e-9),
        greatest_(max_angle_in_degrees > 0 ? max_angle_in_degrees + 1e-9 : 180) {}

  template <class Point>
  void add_triangle(const Point& a, const Point& b, const Point& c) {
    const CGAL::Quadtree_mesh_2::internal::Scaled_triangle triangle(a, b, c);
    const double least = triangle.least_angle(), greatest = triangle.largest_angle();
    ++figures_.triangles;
    if (least < least_)
      ++figures_.below_bound;
    else
      figures_.min_angle_of_others = (std::min)(figures_.min_angle_of_others, least);
    figures_.min_angle = (std::min)(figures_.min_angle, least);
    figures_.above_bound += greatest > greatest_ ? 1 : 0;
    figures_.max_angle = (std::max)(figures_.max_angle, greatest);
  }

  template <class Mesh>
  void add_triangles_of(const Mesh& mesh) {
    for (const auto& [a, b, c] : mesh.triangles) add_triangle(mesh.point(a), mesh.point(b), mesh.point(c));
  }

private:
  Mesh_figures& figures_;
  double least_, greatest_;
};

#endif // QUADTREE_MESH_2_BENCHMARK_MESH_FIGURES_H
