// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A small mesh can afford more than guarded removal.
//
// 1. Its graph is refined by another rule, too, and the smaller mesh is kept (Second_refinement.h).
// 2. It is thinned as a whole (Thinner.h), with a share of the bound that small meshes gain most by, while that helps.
//    Then it is smoothed, which makes room elsewhere, and thinned again. Whenever one of the two helps, this goes on.
//    Each trial costs as much as refinement. There are at most 28, and 2 where nothing helps.
// 3. It is thinned star by star (Star_thinner.h).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_THIN_SMALL_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_THIN_SMALL_MESH_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Remover.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Smoother.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Second_refinement.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Star_thinner.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Thinner.h>

#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The share of the bound that removal keeps to where a small mesh is thinned as a whole.
constexpr double thinning_share_of_small = 0.65;

template <class Geometry, class Continue>
void thin_small_mesh_as_a_whole(Meshing_state<Geometry>& state, Continue& shall_go_on) {
  constexpr int most_trials = 28;
  bool is_to_be_smoothed = false;
  for (int i = 0; i < most_trials && state.is_small() && shall_go_on(); ++i) {
    const std::size_t before = state.mesh.number_of_triangles();
    if (is_to_be_smoothed) {
      Smoother<Geometry>(state).run(shall_go_on);
      Remover<Geometry>(state).run(shall_go_on);
    }
    // more vertices than this, and the mesh will hardly end with fewer than before
    const Mesh_limit limit{state.mesh.number_of_vertices() + before / 2};
    const bool is_thinner = Thinner<Geometry>(state, thinning_share_of_small).run(limit, shall_go_on);
    if (is_to_be_smoothed && state.mesh.number_of_triangles() == before) break;
    is_to_be_smoothed = !is_thinner; // smoothing alone may have made room, but none for a trial without it
  }
}

/// Returns whether the mesh is another one now, with other handles.
/// \pre as of `Thinner`
/// \param second of the same state
template <class Geometry, class Continue>
bool thin_small_mesh(Meshing_state<Geometry>& state, Second_refinement<Geometry>& second,
                     Continue&& shall_go_on) {
  state.leg_rule = Leg_rule::FREE;
  const bool is_other = second.run(shall_go_on);
  thin_small_mesh_as_a_whole(state, shall_go_on);
  if (state.is_small() && shall_go_on()) Star_thinner<Geometry>(state).run(shall_go_on);
  state.leg_rule = Leg_rule::SHELLS;
  return is_other;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_THIN_SMALL_MESH_H
