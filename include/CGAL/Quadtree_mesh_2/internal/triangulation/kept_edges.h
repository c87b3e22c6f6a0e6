// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The input edges that get no vertices, as the user wants it. O(n) to find them.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KEPT_EDGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KEPT_EDGES_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Whether an edge gets no vertices; empty if all may get some.
using Kept_edges = Indexed_vector<Edge_id, char>;

/// The edges along which a segment runs that is to be kept; none if the domain has to be known for that.
/// \param edges with the first segments found there
/// \param repeated what other segments run along
template <class Point>
Kept_edges kept_edges_of(const Quality_mesh_options_2& options, const Pslg_2<Point>& pslg,
                         const Input_edges& edges, const Input_edge_list& repeated) {
  using Wish = Quality_mesh_options_2::Keep_borders;
  if (options.keep_borders() == Wish::ALL) return Kept_edges(edges.size(), 1);
  if (options.keep_borders() != Wish::MARKED || pslg.segment_markers.empty()) return {};
  const auto is_marked = [&](const Input_edge& e) {
    return pslg.segment_markers[std::size_t(e.segment)] != 0;
  };
  Kept_edges kept(edges.size(), 0);
  for (const Edge_id e : edges.ids()) kept[e] = is_marked(edges[e]) ? 1 : 0;
  for (const Input_edge& r : repeated)
    if (is_marked(r)) kept[edges.between(r.a, r.b)] = 1;
  return kept;
}

/// Keeps the edges with the domain on one side only, if that is the wish.
/// \pre the mesh is the first triangulation, restricted to the domain
template <class Geometry>
void keep_boundary(const Quality_mesh_options_2& options, const Kernel_mesh<Geometry>& mesh,
                   const Input_edges& edges, Kept_edges& kept) {
  if (options.keep_borders() != Quality_mesh_options_2::Keep_borders::BOUNDARY) return;
  kept.assign(edges.size(), 0);
  for (const Triangle_id t : mesh.triangles.ids())
    for (int k = 0; k < 3 && mesh.is_alive(t); ++k)
      if (mesh.triangle(t).side[k].is_border())
        kept[edges.between(mesh.source(Side(t, k)), mesh.target(Side(t, k)))] = 1;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KEPT_EDGES_H
