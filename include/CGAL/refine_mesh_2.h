// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_REFINE_MESH_2_H
#define CGAL_REFINE_MESH_2_H

/// \file
/// Refines and adapts a mesh that exists.
///
/// For all functions here, the mesh is one of the graph: made by `Quality_mesher_2`, by these functions, or by
/// `pslg_from_mesh_2()` from triangles of any origin. The options are those of `Quality_mesher_2`, except that the
/// domain is what the mesh covers. Budgets for vertices count all vertices of the old mesh as input. The mesh is the
/// same for any number of threads.
///
/// Vertices that stay have the same coordinates, bit for bit, and the same order. `refine_mesh_2()` returns a mesh that
/// is constrained Delaunay and meets all bounds as it is, unless there is a bound on how edges grow. Otherwise vertices
/// on two segments at a corner sharper than the bound, in triangles between the two, are placed anew, mostly where they
/// were, if all segments may get vertices. All triangles are made anew: where no vertex is added or left out, those of
/// a constrained Delaunay mesh are the same. The new mesh is constrained Delaunay even if the old one is not.
///
/// All functions throw `Pslg_error_2` with the kind `INVALID_MESH`, naming the triangles or vertices at fault, if
/// indices are out of range, triangles are clockwise, flat or overlap, two triangles are on one side of an edge, an
/// edge of the border is on no segment, or the mesh is not one of the graph. Nor may vertices of triangles be at one
/// place, or in the middle of sides: `pslg_from_mesh_2()` mends that. They throw what the mesher throws, too.

#include <CGAL/Adapted_mesh_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Mesh_adapter.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/tags.h>

#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Inserts vertices into a mesh until its triangles meet the bounds of the options, as Triangle's `-r` does. All
/// vertices of the mesh stay.
///
/// An error estimator refines where `Quality_mesh_options_2::refine_where()` says so, or by the size field. With
/// small angles in the mesh far apart from corners of segments, the bound of angles is met by as many new vertices as
/// it takes. Expected O(n log n + k) time for n vertices and k new triangles.
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the mesh is the same
template <class ConcurrencyTag = Sequential_tag>
Adapted_mesh_2
refine_mesh_2(const Indexed_mesh_2<Exact_predicates_inexact_constructions_kernel::Point_2>& mesh,
              const Pslg_2<Exact_predicates_inexact_constructions_kernel::Point_2>& pslg,
              const Quality_mesh_options_2& options) {
  return Quadtree_mesh_2::internal::Mesh_adapter<ConcurrencyTag>(mesh, pslg, options).refine();
}

/// \ingroup PkgQuadtreeMesh2Meshers
/// The same with bounds of area by triangle, in addition to those of the options, as by Triangle's `-r -a` with a file
/// `.area`. A new triangle with its centroid in a triangle of the mesh is at most as large as that one's bound says.
/// \param areas one for each triangle of the mesh; one that is not positive is no bound
/// \throws Pslg_error_2 also if there are not as many areas as triangles (`ARRAY_LENGTH`), or one is not a number
template <class ConcurrencyTag = Sequential_tag>
Adapted_mesh_2
refine_mesh_2(const Indexed_mesh_2<Exact_predicates_inexact_constructions_kernel::Point_2>& mesh,
              const Pslg_2<Exact_predicates_inexact_constructions_kernel::Point_2>& pslg,
              const std::vector<double>& areas, const Quality_mesh_options_2& options) {
  return Quadtree_mesh_2::internal::Mesh_adapter<ConcurrencyTag>(mesh, pslg, options).refine(areas);
}

/// \ingroup PkgQuadtreeMesh2Meshers
/// Refines a mesh where its triangles miss the bounds of the options, and coarsens it where they are needlessly
/// small.
///
/// Sizes wanted are bounds, usually a field (`Quality_mesh_options_2::size()`), such as a `Mesh_sizing_field_2` of
/// sizes at the vertices of the mesh. A mesh of the same input made afresh tells what the bounds allow and what the
/// input forces. Vertices are left out where all edges at them are shorter than 0.6 times the longest edge there in
/// that mesh: none of the input, and those on segments only if the mesh names the segment (`segment_of_vertex`). Then
/// the mesher fills in what is missing. So the angles are those of its other meshes. Where sizes stay, so does the
/// mesh, also near features that force small triangles. If a budget or the callback stops the fresh mesh, none is
/// left out.
///
/// New vertices on a segment that is not parallel to an axis are rounded. A chain of pieces that is halved, joined and
/// halved again many times may leave the segment by some more units in the last place.
///
/// Expected O(n log n + k) time for n vertices and k triangles of the larger one of both meshes: that of three meshes
/// made afresh, and of the check of the old one, on one thread.
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the mesh is the same
template <class ConcurrencyTag = Sequential_tag>
Adapted_mesh_2
adapt_mesh_2(const Indexed_mesh_2<Exact_predicates_inexact_constructions_kernel::Point_2>& mesh,
             const Pslg_2<Exact_predicates_inexact_constructions_kernel::Point_2>& pslg,
             const Quality_mesh_options_2& options) {
  return Quadtree_mesh_2::internal::Mesh_adapter<ConcurrencyTag>(mesh, pslg, options).adapt();
}

} // namespace CGAL

#endif // CGAL_REFINE_MESH_2_H
