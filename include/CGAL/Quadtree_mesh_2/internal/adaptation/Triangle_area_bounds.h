// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_TRIANGLE_AREA_BOUNDS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_TRIANGLE_AREA_BOUNDS_H

#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Triangle_tree.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Bounds of area by the triangles of a given mesh: each holds for new triangles with their centroid in it. Several
/// threads may ask at once.
class Triangle_area_bounds {
public:
  /// \param areas one for each triangle of the tree; those that are not positive are no bounds
  /// \param first_number what messages count from
  /// \throws Pslg_error_2 if there are more or less areas than triangles, or one is not a number
  Triangle_area_bounds(const Triangle_tree& tree, const std::vector<double>& areas,
                       std::size_t number_of_triangles, std::size_t first_number)
      : tree_(tree), areas_(areas) {
    using Kind = Pslg_error_2::Kind;
    if (areas.size() != number_of_triangles)
      throw Pslg_error_2(Kind::ARRAY_LENGTH, "there are " + std::to_string(areas.size()) + " areas for " +
                                                 std::to_string(number_of_triangles) + " triangles");
    for (std::size_t t = 0; t < areas.size(); ++t)
      if (std::isnan(areas[t]))
        throw Pslg_error_2(Kind::NOT_FINITE,
                           "the area of triangle " + std::to_string(first_number + t) + " is not a number",
                           Pslg_parts_2().triangle(Triangle_index(t)));
  }

  /// Whether a triangle is larger than it may be.
  bool operator()(const Quality_mesh_options_2::Corners& t) const {
    const double ux = t[1][0] - t[0][0], uy = t[1][1] - t[0][1];
    const double vx = t[2][0] - t[0][0], vy = t[2][1] - t[0][1];
    const Triangle_tree::Point centroid((t[0][0] + t[1][0] + t[2][0]) / 3, (t[0][1] + t[1][1] + t[2][1]) / 3);
    const double bound = areas_[std::size_t(tree_.nearest(centroid).triangle)];
    return bound > 0 && (ux * vy - uy * vx) / 2 > bound * (1 - margin_);
  }

private:
  static constexpr double margin_ = 2e-9; // so that rounding cannot pass the bound

  const Triangle_tree& tree_;
  const std::vector<double>& areas_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_TRIANGLE_AREA_BOUNDS_H
