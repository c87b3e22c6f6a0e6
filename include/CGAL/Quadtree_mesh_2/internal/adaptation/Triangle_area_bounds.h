// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_TRIANGLE_AREA_BOUNDS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_TRIANGLE_AREA_BOUNDS_H

#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Triangle_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Size_estimate.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/triangle_budget.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
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
      : tree_(tree), areas_(areas), first_number_(first_number) {
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

  /// Asks for as many triangles as the estimate of the mesher does for other bounds of area, which does not know these.
  /// \param area2 gives twice the area of a triangle by its index
  /// \throws Pslg_error_2 naming the triangle that asks for most, if the mesh would surely be larger than the budget
  template <class Area2>
  void check_size(const Area2& area2, const Quality_mesh_options_2& options) const {
    if (options.max_steiner_vertices()) return; // what it allows is made
    const double least = options.min_edge();
    const double finest =
        0.5 / (share_of_squared_edge * least * least); // per doubled area; infinite without a bound
    double sum = 0, most = 0;
    std::size_t worst = 0;
    for (std::size_t t = 0; t < areas_.size(); ++t) {
      if (!(areas_[t] > 0)) continue;
      const double asked = area2(t) * std::min(0.5 / (share_of_area * areas_[t]), finest);
      sum += asked;
      if (asked > most) most = asked, worst = t;
    }
    Triangle_budget budget = Triangle_budget::of_machine();
    if (options.max_vertices() > 0)
      budget = budget.smaller(Triangle_budget(static_cast<double>(options.max_vertices()),
                                              "the vertex budget allows", Triangle_budget::Unit::VERTICES));
    if (!budget.is_surely_exceeded_by(sum)) return;
    std::ostringstream text;
    text << budget.refusal_of(sum) << " for the areas of triangles, most of all for that of triangle "
         << first_number_ + worst << ", " << areas_[worst];
    throw Pslg_error_2(Pslg_error_2::Kind::TOO_MANY_TRIANGLES, text.str(),
                       Pslg_parts_2().triangle(Triangle_index(worst)));
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
  std::size_t first_number_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_TRIANGLE_AREA_BOUNDS_H
