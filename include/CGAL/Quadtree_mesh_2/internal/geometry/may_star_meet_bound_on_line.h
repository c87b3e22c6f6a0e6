// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Whether a vertex that moves along a line may come to a place where its star meets a bound on angles.
//
// Computes: what is left of the line. A triangle of the star meets the bound where the vertex is to the left of two
//           rays, from the ends of its edge in the link, and within a circle through these ends. So each triangle
//           leaves a piece of the line, and all of them the piece that they have in common.
// Bound:    O(k) for k triangles; mostly fewer are looked at, because nothing is left.
// Accuracy: with much to spare, so rounding does not matter. If nothing is left, no place will do.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_MAY_STAR_MEET_BOUND_ON_LINE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_MAY_STAR_MEET_BOUND_ON_LINE_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What is left of a line through the origin, from `low` to `high` along its direction.
struct Piece_of_line {
  using Vector = Basic_vector<double>;

  Vector direction; ///< of length 1
  double low = -std::numeric_limits<double>::infinity(), high = -low;

  /// False if nothing of the line is within the circle.
  bool cut_by_circle(Vector center, double radius2) {
    const double distance = cross(direction, center), half2 = radius2 - distance * distance;
    if (half2 < 0) return false;
    const double middle = dot(direction, center), half = std::sqrt(half2);
    low = std::max(low, middle - half), high = std::min(high, middle + half);
    return true;
  }

  /// To what is left of a ray. One that is nearly parallel to the line cuts nothing.
  void cut_by_ray(Vector from, Vector ray, double squared_length_of_ray) {
    constexpr double least_sin2 = 1e-6;
    const double slope = cross(ray, direction);
    if (slope * slope < least_sin2 * squared_length_of_ray) return;
    const double place = cross(ray, from) / slope;
    if (slope > 0)
      low = std::max(low, place);
    else
      high = std::min(high, place);
  }
};

/// \param link    `size` + 1 places around the vertex, counterclockwise, relative to it, none farther than 2
/// \param sin2    the squared sine of the bound, not 0
inline bool may_star_meet_bound_on_line(const Basic_vector<double>* link, int size,
                                        Basic_vector<double> direction, double sin2) {
  constexpr double to_spare = 1e-6;
  constexpr double least_length2 = 1e-12; // of an edge; shorter ones are rounded too much to count
  const double sine = std::sqrt(sin2), cosine = std::sqrt(1 - sin2);
  Piece_of_line piece{direction};
  for (int i = 0; i < size && piece.low <= piece.high + to_spare; ++i) {
    const auto edge = link[i + 1] - link[i];
    const double length2 = squared_length(edge);
    if (length2 < least_length2) continue;
    const Basic_vector<double> left{-edge.y, edge.x};
    const auto center = 0.5 * (link[i] + link[i + 1] + (cosine / sine) * left);
    if (!piece.cut_by_circle(center, (1 + to_spare) * length2 / (4 * sin2))) return false;
    piece.cut_by_ray(link[i], cosine * edge + sine * left, length2);
    piece.cut_by_ray(link[i + 1], cosine * edge - sine * left, length2);
  }
  return piece.low <= piece.high + to_spare;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_MAY_STAR_MEET_BOUND_ON_LINE_H
