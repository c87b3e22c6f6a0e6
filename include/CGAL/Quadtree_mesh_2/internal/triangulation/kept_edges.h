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

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// For each edge that gets no vertices the first segment for which it is so, for others none; empty if all may get
/// some.
using Kept_edges = Indexed_vector<Edge_id, Segment_index>;

/// The edges along which a segment runs that is to be kept; none if the domain has to be known for that.
/// \param edges with the first segments found there
/// \param repeated what other segments run along
template <class Point>
Kept_edges kept_edges_of(const Quality_mesh_options_2& options, const Pslg_2<Point>& pslg,
                         const Input_edges& edges, const Input_edge_list& repeated) {
  using Wish = Quality_mesh_options_2::Keep_borders;
  const bool is_all = options.keep_borders() == Wish::ALL;
  if (!is_all && (options.keep_borders() != Wish::MARKED || pslg.segment_markers.empty())) return {};
  Kept_edges kept(edges.size(), Segment_index());
  const auto keep = [&](Edge_id e, Segment_index s) {
    if (is_all || pslg.segment_markers[std::size_t(s)] != 0)
      kept[e] = std::min(kept[e], s); // none is the greatest
  };
  for (const Edge_id e : edges.ids()) keep(e, edges[e].segment);
  for (const Input_edge& r : repeated) keep(edges.between(r.a, r.b), r.segment);
  return kept;
}

/// Keeps the edges with the domain on one side only, if that is the wish.
/// \pre the mesh is the first triangulation, restricted to the domain
template <class Geometry>
void keep_boundary(const Quality_mesh_options_2& options, const Kernel_mesh<Geometry>& mesh,
                   const Input_edges& edges, Kept_edges& kept) {
  if (options.keep_borders() != Quality_mesh_options_2::Keep_borders::BOUNDARY) return;
  kept.assign(edges.size(), Segment_index());
  for (const Triangle_id t : mesh.triangles.ids())
    for (int k = 0; k < 3 && mesh.is_alive(t); ++k) {
      if (!mesh.triangle(t).side[k].is_border()) continue;
      const Edge_id e = edges.between(mesh.source(Side(t, k)), mesh.target(Side(t, k)));
      kept[e] = edges[e].segment;
    }
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KEPT_EDGES_H
