// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_CURE_PLACED_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_CURE_PLACED_MESH_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/finish_mesh.h>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Refines what quadtrees missed or left too large, in blocks, which are coarsened on the way, and then what these
/// leave. Of the vertices that quadtrees place most are not needed. Removal alone leaves half of those too many, so
/// blocks are thinned out before and after they are refined. A mesh without blocks is thinned out as a whole.
/// \param finishing what is done in blocks; nothing is thinned out without removal
/// \param work_off_in_blocks called once; returns whether the mesh is large enough for blocks
/// \param refine called once with that; works off what is left, or all
/// \returns whether the mesh should be thinned out as a whole
template <class Geometry, class Work_off_in_blocks, class Refine>
bool cure_placed_mesh(Meshing_state<Geometry>& state, Finishing& finishing,
                      const Work_off_in_blocks& work_off_in_blocks, const Refine& refine) {
  constexpr int thinnings_of_blocks = 2;
  const bool shall_thin = finishing.removal != Removal::NONE;
  finishing.thinnings_of_blocks = shall_thin ? thinnings_of_blocks : 0;
  state.has_placed_vertices = true;
  const bool are_blocks = work_off_in_blocks();
  refine(are_blocks);
  state.legalize();
  return shall_thin && !are_blocks;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_CURE_PLACED_MESH_H
