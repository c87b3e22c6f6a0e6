// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_VERSION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_VERSION_H

namespace CGAL {
namespace IO {

/// Versions of Gmsh's format MSH. Many solvers read 2.2 only.
enum class Msh_version { V4_1, V2_2 };

} // namespace IO
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_MSH_VERSION_H
