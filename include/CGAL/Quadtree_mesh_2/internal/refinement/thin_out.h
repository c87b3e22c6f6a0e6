// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Takes vertices out of a mesh beyond what guarded removal can do, at the price of triangles below the bound.
//
// Computes: a mesh in which vertices are removed as long as no angle falls below a share of the bound. Its sides are
//           Delaunay again. What is below the bound now is for the refiner, which relocates vertices first and puts
//           back fewer than went, where they stood in each other's way.
// Bound:    O(k) expected for k triangles.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_THIN_OUT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_THIN_OUT_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Remover.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The share of the bound that removal keeps to.
constexpr double thinning_share = 0.72;

/// Removal and smoothing leave sides that are not Delaunay. The circumcenter of a triangle next to one may be a vertex,
/// and then refinement gives the triangle up.
template <class Geometry>
void doubt_all_sides(Meshing_state<Geometry>& state) {
  for (const Triangle_id t : state.mesh.triangles.ids())
    for (int k = 0; k < 3 && state.mesh.is_alive(t); ++k) {
      const Side o = state.mesh.triangle(t).side[k];
      if (!o.is_constrained() && t < o.triangle()) state.doubtful_sides.push_back(Side(t, k));
    }
}

/// What is on the worklist is forgotten: the refiner is to look at all triangles.
/// \returns how many vertices are gone
template <class Geometry, class Continue>
std::size_t thin_out(Meshing_state<Geometry>& state, Continue&& shall_go_on) {
  auto& is_dirty = state.mesh.is_dirty;
  std::fill(is_dirty.begin(), is_dirty.end(), char(1));
  const std::size_t removed =
      Remover<Geometry>(state, state.bounds.with_share_of_angle(thinning_share)).run(shall_go_on);
  state.clear_worklist();
  if (removed > 0) {
    doubt_all_sides(state);
    state.legalize();
  }
  return removed;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_THIN_OUT_H
