// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_PSLG_FROM_MESH_2_H
#define CGAL_PSLG_FROM_MESH_2_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/given_mesh_types.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Mesh_completer.h>

#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// The graph of given triangles, which makes them a mesh for `refine_mesh_2()` and `adapt_mesh_2()`.
///
/// Segments are the edges on the border, between triangles with different attributes, and those named in the details.
/// Edges in a row become one where they are a straight side of a sharp corner (`Given_mesh_details_2::Vertices`).
/// Each component that they separate has a region, if there are attributes. Each hole has a place in it. A vertex that
/// no triangle uses is one of the graph. The domain is `Quality_mesh_options_2::Domain::ENCLOSED`.
///
/// The domain is what the triangles cover, also where they meet without common vertices. Of vertices at one place
/// triangles get the first one. A triangle with a vertex of another one in the middle of a side is cut there: one piece
/// has its number, the others come last. Edges on the border by the vertices' numbers are segments even if triangles
/// are on both sides: cracks, and places where two meshes were put together.
///
/// O(k log k) time for k triangles.
/// \param[in,out] mesh has points, triangles and perhaps markers of vertices; all other arrays are made
/// \param details what is known besides
/// \throws Pslg_error_2 with the kind `INVALID_MESH`, naming the triangles at fault, if the mesh is none (see
/// `refine_mesh_2()`), or a segment is no edge of it; `ARRAY_LENGTH`, `NOT_FINITE` or `ROUNDING` as their names say.
/// The mesh is then unchanged.
inline Pslg_2<Exact_predicates_inexact_constructions_kernel::Point_2>
pslg_from_mesh_2(Indexed_mesh_2<Exact_predicates_inexact_constructions_kernel::Point_2>& mesh,
                 const Given_mesh_details_2& details = {}) {
  return Quadtree_mesh_2::internal::Mesh_completer(mesh, details).complete();
}

/// \ingroup PkgQuadtreeMesh2Data
/// The same, telling what became of triangles.
/// \param[in,out] mesh has points, triangles and perhaps markers of vertices; all other arrays are made
/// \param details what is known besides
/// \param[out] given_triangle per triangle of the mesh, the given one that it is, or is a piece of
inline Pslg_2<Exact_predicates_inexact_constructions_kernel::Point_2>
pslg_from_mesh_2(Indexed_mesh_2<Exact_predicates_inexact_constructions_kernel::Point_2>& mesh,
                 const Given_mesh_details_2& details,
                 std::vector<Quadtree_mesh_2::Triangle_index>& given_triangle) {
  Quadtree_mesh_2::internal::Mesh_completer completer(mesh, details);
  auto pslg = completer.complete();
  given_triangle = completer.given_triangle();
  return pslg;
}

} // namespace CGAL

#endif // CGAL_PSLG_FROM_MESH_2_H
