// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_MESHERS_IN_WORDS32_H
#define QUADTREE_MESH_2_TEST_MESHERS_IN_WORDS32_H

// The meshers over 32-bit words. The library has those over 64 bits only; several groups of tests and the soak share
// these, which are compiled once, in meshers_in_words32.cpp.

#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/Quality_mesher_2.h>

#include <cstdint>

namespace CGAL {
CGAL_QUADTREE_MESH_2_INSTANTIATE(extern, Quality_mesher_2, Fixed_point_quadtree_traits_2<std::uint32_t>);
CGAL_QUADTREE_MESH_2_INSTANTIATE(extern, Point_set_mesher_2, Fixed_point_quadtree_traits_2<std::uint32_t>);
} // namespace CGAL

#endif // QUADTREE_MESH_2_TEST_MESHERS_IN_WORDS32_H
