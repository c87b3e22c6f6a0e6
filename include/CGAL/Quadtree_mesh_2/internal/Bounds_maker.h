// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BOUNDS_MAKER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BOUNDS_MAKER_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Adapted_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/grading/Grader.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Bounds.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/finish_mesh.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How fast edges may grow; nothing if there is no bound on that.
inline std::optional<Growth> growth_wanted(const Quality_mesh_options_2& options) {
  if (options.gradation() == 0 && options.max_edge_ratio() == 0) return std::nullopt;
  return Growth{options.gradation() > 0 ? options.gradation() : Quality_mesh_options_2::steepest_gradation,
                std::max(options.max_edge_ratio(), Quality_mesh_options_2::least_max_edge_ratio)};
}

/// What is done to a mesh that meets the bounds.
inline Finishing finishing_wanted(const Quality_mesh_options_2& options) {
  Finishing finishing;
  if (options.coarsen() == Quality_mesh_options_2::Coarsening::NONE) finishing.removal = Removal::NONE;
  finishing.smoothing_rounds = options.smooth();
  finishing.thinning_rounds = options.thin();
  return finishing;
}

/// The user's bounds in the coordinates of the kernel. Options and map have to outlive them.
template <class Traits>
class Bounds_maker {
public:
  using Geometry = Mesher_geometry<Traits>;
  using Map = Coordinate_map<Traits, Geometry>;
  using Point_2 = typename Traits::Point_2;

  Bounds_maker(const Quality_mesh_options_2& options, const Map& map)
      : options_(options), map_(map), scale_(map.length_to_kernel(1.0)) {}

  Bounds<Geometry> run(const Pslg_2<Point_2>& pslg) const {
    Bounds<Geometry> bounds(options_.min_angle() * radians_per_degree, options_.max_area() * scale_ * scale_,
                            scale_ * options_.max_edge());
    if (options_.max_angle() > 0) bounds.set_widest(options_.max_angle() * radians_per_degree);
    const double least_length = scale_ * options_.min_edge();
    bounds.least_squared_length = least_length * least_length;
    if (std::any_of(pslg.regions.begin(), pslg.regions.end(),
                    [](const auto& region) { return region.max_area > 0; }))
      for (const auto& region : pslg.regions)
        bounds.area2_of_region.push_back(region.max_area > 0 ? 2 * (scale_ * region.max_area) * scale_ *
                                                                   (1 - Bounds<Geometry>::margin)
                                                             : std::numeric_limits<double>::infinity());
    set_functions(bounds);
    return bounds;
  }

private:
  const Quality_mesh_options_2& options_;
  const Map& map_;
  double scale_;

  void set_functions(Bounds<Geometry>& bounds) const {
    if (options_.refine_where())
      bounds.is_refused = [&options = options_, &map = map_](const auto& a, const auto& b, const auto& c) {
        return options.refine_where()({map.place(a), map.place(b), map.place(c)});
      };
    if (options_.size())
      bounds.squared_length_at = [&options = options_, &map = map_,
                                  scale = scale_](const typename Geometry::Point& p) {
        const auto [x, y] = map.place(p);
        const double size = scale * options.size()(x, y);
        return size * size;
      };
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BOUNDS_MAKER_H
