// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GRADING_GRADED_SIZES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GRADING_GRADED_SIZES_H

#include <CGAL/Points_sizing_field_2.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The greatest lengths of edges at places, and zones without a bound. Several threads may ask at once.
class Graded_sizes {
public:
  using Sized_point = Points_sizing_field_2::Sized_point;
  using Place = std::array<double, 2>;
  using Corners = std::array<Place, 3>;

  /// A disk around a corner, in which lengths have no bound.
  struct Zone {
    Place center;
    double radius;
    bool operator!=(const Zone& z) const { return center != z.center || radius != z.radius; }
    bool operator==(const Zone& z) const { return !(*this != z); }
  };

  explicit Graded_sizes(double gradation) : gradation_(gradation) {}

  void add(std::vector<Sized_point> points) {
    points_.insert(points_.end(), points.begin(), points.end());
    all_.emplace(points_, gradation_);
    last_.emplace(std::move(points), gradation_);
  }

  /// In place of those before.
  void set_zones(const std::vector<Zone>& zones) {
    zones_.reset(), reach_ = 0;
    for (const Zone& z : zones) reach_ = std::max(reach_, 2 * z.radius);
    std::vector<Sized_point> centers; // within a radius the size is then less than the reach
    for (const Zone& z : zones) centers.push_back({z.center[0], z.center[1], reach_ - z.radius});
    if (!zones.empty()) zones_.emplace(std::move(centers), 1.0);
  }

  /// Whether the points added so far allow less at the place of this one.
  bool dominate(const Sized_point& p) const { return all_ && (*all_)(p.x, p.y, p.size) < p.size; }

  /// Whether the points added last allow less than a length at a place, be it in a zone or not.
  bool is_less_by_last(const Place& p, double length) const {
    return last_ && (*last_)(p[0], p[1], length) < length;
  }

  /// The least size at the corners of a triangle, or `most` if that is not more. Most triangles are far smaller than
  /// they may be. With `most` little above their length this is found soon.
  double least(const Corners& corners, double most) const { return all_ ? all_->least(corners, most) : most; }

  bool is_any_in_zone(const Corners& corners) const {
    return zones_ && std::any_of(corners.begin(), corners.end(),
                                 [this](const Place& p) { return (*zones_)(p[0], p[1], reach_) < reach_; });
  }

private:
  double gradation_;
  std::vector<Sized_point> points_;
  std::optional<Points_sizing_field_2> all_, last_; ///< of all points, and of those added last
  std::optional<Points_sizing_field_2> zones_;
  double reach_ = 0;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GRADING_GRADED_SIZES_H
