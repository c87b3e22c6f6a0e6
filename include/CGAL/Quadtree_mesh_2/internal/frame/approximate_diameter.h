// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Two points about as far apart as any two.
//
// Computes: of n points, a pair whose distance is at least cos(pi / 32) > 0.9951 of the diameter, less 1e-14
//           of it for rounding.
// Bound:    O(n) work, in one pass over blocks.
// Source:   Bern, Eppstein, Teng, section 5: project the points onto O(1) axes. Of the pairs of extreme
//           points, one on each axis, take the longest.
// Deviates: not at all. We use 16 axes. The factor of 0.95 that the paper has in mind needs 5.
//
// Proof of the factor. The axes have the directions 0, pi / 16, ..., 15 pi / 16. Let d be the diameter, the
// distance of points p and q. Without sign, the direction of pq is at most pi / 32 away from that of some
// axis. So the projections of p and q onto this axis are at least d cos(pi / 32) apart. The projections of
// the extreme points are no less far apart, and neither are the points themselves.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_APPROXIMATE_DIAMETER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_APPROXIMATE_DIAMETER_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The distance found is at least this share of the diameter.
constexpr double diameter_factor = 0.9951;

/// Indices of two points; equal if there are no two places.
struct Far_pair {
  std::size_t first = 0, second = 0;
};

/// The lowest and highest projections of points on 16 axes, each with the first point that has it.
class Axis_extremes {
public:
  static constexpr std::size_t number_of_axes = 16;

  void add(Vector v, std::size_t i) {
    for (std::size_t axis = 0; axis < number_of_axes; ++axis) {
      const double projection = dot(direction(axis), v);
      if (projection < low_[axis].value) low_[axis] = {projection, i};
      if (projection > high_[axis].value) high_[axis] = {projection, i};
    }
  }

  /// With those of points of higher indices.
  static Axis_extremes combine(const Axis_extremes& a, const Axis_extremes& b) {
    Axis_extremes result = a;
    for (std::size_t axis = 0; axis < number_of_axes; ++axis) {
      if (b.low_[axis].value < a.low_[axis].value) result.low_[axis] = b.low_[axis];
      if (b.high_[axis].value > a.high_[axis].value) result.high_[axis] = b.high_[axis];
    }
    return result;
  }

  Far_pair pair(std::size_t axis) const { return {low_[axis].point, high_[axis].point}; }

private:
  struct Extreme {
    double value = 0; // of the first point, relative to which all are
    std::size_t point = 0;
  };
  std::array<Extreme, number_of_axes> low_{}, high_{};

  /// The unit vector at the angle axis * pi / 16, the same on every machine.
  static Vector direction(std::size_t axis) {
    constexpr std::array<double, 9> cosines = {1,
                                               0.98078528040323044913,
                                               0.92387953251128675613,
                                               0.83146961230254523708,
                                               0.70710678118654752440,
                                               0.55557023301960222474,
                                               0.38268343236508977173,
                                               0.19509032201612826785,
                                               0};
    return axis <= 8 ? Vector{cosines[axis], cosines[8 - axis]}
                     : Vector{-cosines[16 - axis], cosines[axis - 8]};
  }
};

/// Returns two points that are at least `diameter_factor` times the diameter apart; {0, 0} if all points are in one
/// place, or there are none. Of pairs equally far apart it is always the same one.
/// \tparam Geometry a meshing geometry, of whose differences the squares neither overflow nor vanish
template <class ConcurrencyTag, class Geometry>
Far_pair approximate_diameter(const std::vector<typename Geometry::Point>& points) {
  const auto extremes = reduce<ConcurrencyTag>(
      points.size(), Axis_extremes(),
      [&](std::size_t begin, std::size_t end) {
        Axis_extremes result;
        for (std::size_t i = begin; i < end; ++i) result.add(Geometry::difference(points[i], points[0]), i);
        return result;
      },
      Axis_extremes::combine);
  Far_pair longest;
  double squared = 0;
  for (std::size_t axis = 0; axis < Axis_extremes::number_of_axes; ++axis) {
    const Far_pair pair = extremes.pair(axis);
    if (pair.first == pair.second) continue;
    const double l = squared_length(Geometry::difference(points[pair.second], points[pair.first]));
    if (l > squared) longest = pair, squared = l;
  }
  return longest;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_FRAME_APPROXIMATE_DIAMETER_H
