// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Units of angles. Users and tables give and read degrees. Functions of angles are computed in radians.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_ANGLE_UNITS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_ANGLE_UNITS_H

#include <CGAL/number_type_config.h>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

constexpr double pi = CGAL_PI;
constexpr double radians_per_degree = pi / 180;
constexpr double degrees_per_radian = 180 / pi;

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_ANGLE_UNITS_H
