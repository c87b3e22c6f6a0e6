// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_ROOM_IN_DOUBLES_H
#define QUADTREE_MESH_2_EXAMPLES_ROOM_IN_DOUBLES_H

// Points so near to each other that no mesh between them can be written: coordinates in files are doubles.
// Arithmetic that is finer than these would find out only when its mesh is done.

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/part_names.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace room_in_doubles_internal {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

/// The squares of points have at most 8.2 times their distance as side, and tiles in them need 2^7 units.
constexpr double least_units = 15;

inline double largest_coordinate(const Point& p) { return (std::max)(std::fabs(p.x()), std::fabs(p.y())); }

/// The larger of the distances in x and y, in units in the last place of the largest coordinate.
inline double units_between(const Point& p, const Point& q) {
  const double largest = (std::max)(largest_coordinate(p), largest_coordinate(q));
  const double unit = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
  return (std::max)(std::fabs(p.x() - q.x()), std::fabs(p.y() - q.y())) / unit;
}

} // namespace room_in_doubles_internal

/// Points that not even the quadtree can tell are left to the mesher, which has words for them.
/// \throws std::runtime_error naming two points with less than 15 units in the last place between them.
inline void check_room_in_doubles(const CGAL::Pslg_2<room_in_doubles_internal::Point>& input) try {
  using namespace room_in_doubles_internal;
  using CGAL::Quadtree_mesh_2::Point_rank;
  using CGAL::Quadtree_mesh_2::internal::numbered_place;
  using Quadtree = CGAL::Balanced_quadtree<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag>;
  const auto& points = input.vertices;
  if (points.empty()) return;
  const Quadtree tree(points);
  const auto& framework = tree.framework();
  const auto near = tree.near_neighbors();
  for (std::size_t r = 0; r < near.size(); ++r) {
    if (!near[r].is_valid()) continue;
    const auto [a, b] = std::minmax(
        {std::size_t(framework.input_point(Point_rank(r))), std::size_t(framework.input_point(near[r]))});
    if (!(units_between(points[a], points[b]) < least_units)) continue;
    throw std::runtime_error("points " + numbered_place(input, a, points[a]) + " and " +
                             numbered_place(input, b, points[b]) +
                             " are less than 15 units in the last place apart: doubles, which files have, "
                             "leave no room for a mesh between them; merge what is so near, or move the "
                             "input nearer to the origin");
  }
} catch (const CGAL::Quadtree_mesh_2::Point_error&) {
}

#endif // QUADTREE_MESH_2_EXAMPLES_ROOM_IN_DOUBLES_H
