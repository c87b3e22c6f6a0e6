// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A small mesh, of at most 1000 triangles, can afford more than guarded removal.
//
// 1. Its graph is refined by another rule, too, and the smaller mesh is kept (Second_refinement.h).
// 2. Pairs of vertices are merged (Pair_merger.h). That is cheap, and done in meshes of twice the size, too. Then the
//    mesh is smoothed, which makes room elsewhere: vertices are removed, and pairs merged, once more. This goes on
//    while it helps, at most four times.
// 3. It is thinned star by star (Star_thinner.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_THIN_SMALL_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_THIN_SMALL_MESH_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Remover.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Smoother.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Pair_merger.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Second_refinement.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Star_thinner.h>

#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Merges pairs where they are. In a small mesh, also where smoothing brings them.
template <class Geometry, class Continue>
void merge_pairs(Meshing_state<Geometry>& state, Continue& shall_go_on) {
  if (state.mesh.number_of_triangles() > Meshing_state<Geometry>::most_triangles_to_merge_pairs) return;
  Pair_merger<Geometry>(state).run(shall_go_on);
  constexpr int most_rounds = 4;
  for (int round = 0; round < most_rounds && state.is_small_mesh() && shall_go_on(); ++round) {
    const std::size_t before = state.mesh.number_of_triangles();
    Smoother<Geometry>(state).run(shall_go_on);
    Remover<Geometry>(state).run(shall_go_on);
    Pair_merger<Geometry>(state).run(shall_go_on);
    if (state.mesh.number_of_triangles() == before) return;
  }
}

/// Returns whether the mesh is another one now, with other handles.
/// \pre no triangle of the mesh is bad, and no sector is locked
/// \param second of the same state
template <class Geometry, class Continue>
bool thin_small_mesh(Meshing_state<Geometry>& state, Second_refinement<Geometry>& second,
                     Continue&& shall_go_on) {
  state.leg_rule = Leg_rule::FREE;
  const bool is_other = second.run(shall_go_on);
  merge_pairs(state, shall_go_on);
  if (state.is_small_mesh() && shall_go_on()) Star_thinner<Geometry>(state).run(shall_go_on);
  state.leg_rule = Leg_rule::SHELLS;
  return is_other;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_THIN_SMALL_MESH_H
