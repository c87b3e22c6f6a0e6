// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "meshers_in_words32.h"

namespace CGAL {
CGAL_QUADTREE_MESH_2_INSTANTIATE(, Quality_mesher_2, Fixed_point_quadtree_traits_2<std::uint32_t>);
CGAL_QUADTREE_MESH_2_INSTANTIATE(, Point_set_mesher_2, Fixed_point_quadtree_traits_2<std::uint32_t>);
} // namespace CGAL
