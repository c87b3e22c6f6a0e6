// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A range of angles, and how far triangles are from it.
//
// The energy of a triangle is a sum over its angles a: the squared violation of the range, narrowed by a
// margin,
//   sin^2(high) max(0, cot(high - margin) - cot a)  and  sin^2(low) max(0, cot a - cot(low + margin)).
// These are radians to the first order, so no trigonometry is needed. A flat or inverted triangle counts 1000
// and more, and more the worse it is. Energies are compared only with each other. Whether a triangle is in
// the range itself is a separate test, with the range narrowed by what rounding may hide.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_ANGLE_RANGE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_ANGLE_RANGE_H

#include <CGAL/Quadtree_mesh_2/internal/base/Float_lanes.h>
#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>

#include <cmath>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

class Angle_range {
public:
  /// In degrees; `low` may be 0, for no lower bound.
  Angle_range(double low, double high, double margin = 1) {
    const auto cot = [](double degrees) {
      return std::cos(degrees * radians_per_degree) / std::sin(degrees * radians_per_degree);
    };
    const auto squared_sine = [](double degrees) {
      return std::sin(degrees * radians_per_degree) * std::sin(degrees * radians_per_degree);
    };
    least_cot = static_cast<float>(cot(high - margin));
    high_weight = static_cast<float>(squared_sine(high));
    allowed_least_cot = static_cast<float>(cot(high) + rounding);
    if (low <= 0) return;
    greatest_cot = static_cast<float>(cot(low + margin));
    low_weight = static_cast<float>(squared_sine(low));
    allowed_greatest_cot = static_cast<float>(cot(low) - rounding * (1 + cot(low) * cot(low)));
  }

  float least_cot, high_weight;
  float greatest_cot = 1e9f, low_weight = 0;
  /// Of angles in the range, for certain.
  float allowed_least_cot, allowed_greatest_cot = 1e9f;

  /// The doubled area that a triangle has at least of the sum of its squared sides, lest it counts as flat.
  static constexpr float least_area_share = 1e-4f;
  static constexpr float energy_of_flat = 1000;

private:
  static constexpr double rounding = 1e-5;
};

/// Four triangles with the corners 0, b, c. The dot products and the cross product tell all: the cotangents of the
/// angles are the former over the latter.
struct Triangle_lanes {
  Float_lanes bb, cc, bc, cross;

  Triangle_lanes(Float_lanes bx, Float_lanes by, Float_lanes cx, Float_lanes cy)
      : bb(bx * bx + by * by), cc(cx * cx + cy * cy), bc(bx * cx + by * cy), cross(bx * cy - by * cx) {}

  Float_lanes sum_of_squares() const { return (bb + cc - bc) * Float_lanes(2); }
  Float_lanes squared_opposite_side() const { return bb + cc - (bc + bc); }
};

/// The cotangents of four triangles, and their violations of a range.
struct Range_lanes {
  Float_lanes cot[3];       ///< at 0, b, c
  Float_lanes too_large[3]; ///< violations, in radians; of every angle one of the two is 0
  Float_lanes too_small[3];
  Float_lanes energy;
  Float_lanes floor;   ///< a triangle is flat unless floor < cross
  Float_lanes inverse; ///< of `cross`; of `floor` if the triangle is flat

  Range_lanes(const Triangle_lanes& t, const Angle_range& range)
      : floor(t.sum_of_squares() * Float_lanes(Angle_range::least_area_share)) {
    const Float_lanes zero(0);
    inverse = Float_lanes(1) / max(t.cross, floor);
    cot[0] = t.bc * inverse;
    cot[1] = (t.bb - t.bc) * inverse;
    cot[2] = (t.cc - t.bc) * inverse;
    Float_lanes e(0);
    for (int i = 0; i < 3; ++i) {
      too_large[i] = max(zero, (Float_lanes(range.least_cot) - cot[i]) * Float_lanes(range.high_weight));
      too_small[i] = max(zero, (cot[i] - Float_lanes(range.greatest_cot)) * Float_lanes(range.low_weight));
      const Float_lanes r = too_large[i] + too_small[i];
      e = e + r * r;
    }
    constexpr float flat = Angle_range::energy_of_flat, share = Angle_range::least_area_share;
    energy = select_where_less(floor, t.cross, e,
                               Float_lanes(flat) - Float_lanes(flat * share) * (t.cross * inverse));
  }

  /// Per lane, negative where an angle is not in the range for certain.
  Float_lanes slack(const Triangle_lanes& t, const Angle_range& range) const {
    const Float_lanes least = min(cot[0], min(cot[1], cot[2])), greatest = max(cot[0], max(cot[1], cot[2]));
    const Float_lanes s =
        min(least - Float_lanes(range.allowed_least_cot), Float_lanes(range.allowed_greatest_cot) - greatest);
    return select_where_less(floor, t.cross, s, Float_lanes(-1));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_ANGLE_RANGE_H
