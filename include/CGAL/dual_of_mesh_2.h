// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_DUAL_OF_MESH_2_H
#define CGAL_DUAL_OF_MESH_2_H

/// \file
/// The cells around the vertices of a mesh, Voronoi or median ones, for finite volumes.

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/dual/Dual_builder.h>
#include <CGAL/Quadtree_mesh_2/mesh_dual_types.h>

#include <CGAL/tags.h>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// Returns the cells around the vertices of a mesh.
///
/// Coordinates are rounded to doubles, and so are those of the cells. Corners that rounding alone keeps apart, as the
/// circumcenters of a square cut by its diagonal, are one corner. Any mesh will do: of a graph or of points, Delaunay
/// or not, with `neighbors` or without. O(n log d) for n triangles and at most d of them at a vertex, in parallel but
/// for what looks at each triangle once. (In a mesh of obtuse triangles, a circumcenter may be as many triangles away
/// as there are.)
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the result is the same
/// \pre triangles are counterclockwise, and sides are between at most two
/// Source: the bounded Voronoi diagram, which is dual to the constrained Delaunay triangulation (Lee, Lin, "Generalized
/// Delaunay triangulation for planar graphs", Discrete & Computational Geometry 1, 1986).
template <class ConcurrencyTag = Sequential_tag, class Point>
Mesh_dual_2 dual_of_mesh_2(const Indexed_mesh_2<Point>& mesh,
                           Mesh_dual_2::Kind kind = Mesh_dual_2::Kind::CIRCUMCENTRIC) {
  return Quadtree_mesh_2::internal::Dual_builder<ConcurrencyTag, Point>(mesh, kind).run();
}

} // namespace CGAL

#endif // CGAL_DUAL_OF_MESH_2_H
