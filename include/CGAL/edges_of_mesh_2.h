// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_EDGES_OF_MESH_2_H
#define CGAL_EDGES_OF_MESH_2_H

/// \file
/// The edges of a mesh, and the nodes that second-order elements have in the middle of these.

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/Edge_finder.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>

#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// Returns the edges of a mesh, each once, as Triangle's `-e` does: in the order of their first triangles, and of the
/// sides there. So edge `i` is the same for all functions of a mesh.
///
/// Works for meshes without `neighbors`, too, which it then finds. O(n log d) for n triangles and at most d of them at
/// a vertex.
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the result is the same
/// \pre sides are between at most two triangles
template <class ConcurrencyTag = Sequential_tag, class Point>
std::vector<Mesh_edge_2> edges_of_mesh_2(const Indexed_mesh_2<Point>& mesh) {
  Quadtree_mesh_2::internal::Edge_finder<ConcurrencyTag, Point> finder(mesh);
  return finder.take_edges();
}

/// \ingroup PkgQuadtreeMesh2Data
/// Returns the nodes of second-order elements of a mesh, as Triangle's `-o2` makes them.
/// Requirements and time as those of `edges_of_mesh_2()`.
template <class ConcurrencyTag = Sequential_tag, class Point>
Second_order_nodes_2 second_order_nodes_2(const Indexed_mesh_2<Point>& mesh) {
  return Quadtree_mesh_2::internal::second_order_nodes<ConcurrencyTag>(mesh);
}

} // namespace CGAL

#endif // CGAL_EDGES_OF_MESH_2_H
