// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_MESHING_GEOMETRY_FWD_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_MESHING_GEOMETRY_FWD_H

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

// The traits classes name the meshing kernel's geometries; only the mesher needs their definitions.
template <class Kernel>
struct Double_geometry_2;
template <class Word>
struct Integer_geometry_2;
template <class Kernel>
struct Exact_geometry_2;

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_MESHING_GEOMETRY_FWD_H
