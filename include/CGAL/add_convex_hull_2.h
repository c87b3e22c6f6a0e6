// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_ADD_CONVEX_HULL_2_H
#define CGAL_ADD_CONVEX_HULL_2_H

/// \file
/// Adds the border of the convex hull to a graph, so that all of the hull is its domain.

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/Hull_pieces.h>

#include <cstddef>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Data
/// Adds the border of the convex hull of the vertices to a graph as segments, as Triangle's `-c` does. Meshers then
/// mesh all of the hull but the holes of the graph. The graph may have no segments before.
///
/// Vertices on the border divide it into segments. Where segments of the graph lie on it already, none are added.
/// New segments have the marker 0 if others have markers. Nothing is added if all vertices are on a line.
/// O(n log n + m) for n vertices and m segments. All is decided exactly.
///
/// Segments of the graph that come near to the hull may make thin angles with it, and many triangles there.
/// \returns how many segments are added
/// \tparam Point of a kernel with exact predicates
/// Source: Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information Processing Letters 9,
/// 1979.
template <class Point>
std::size_t add_convex_hull_2(Pslg_2<Point>& pslg) {
  const auto pieces = Quadtree_mesh_2::internal::Hull_pieces<Point>(pslg).missing();
  for (const auto& piece : pieces) {
    pslg.add_segment(piece[0], piece[1]);
    if (!pslg.segment_markers.empty()) pslg.segment_markers.push_back(0);
  }
  return pieces.size();
}

} // namespace CGAL

#endif // CGAL_ADD_CONVEX_HULL_2_H
