// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_FINISH_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_FINISH_MESH_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Remover.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Smoother.h>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

enum class Removal { NONE, GUARDED };

/// What is done to a mesh that meets the bounds.
struct Finishing {
  Removal removal = Removal::GUARDED;
  int smoothing_rounds = 0;
  int thinning_rounds = 0; ///< Thinner.h; of the whole mesh, at last
  /// How many times blocks are thinned out and refined (thin_out.h) in the first round: where there are many more
  /// vertices than the mesh needs.
  int thinnings_of_blocks = 0;
};

/// Removes Steiner vertices and smooths, as is wanted.
template <class Geometry, class Continue>
void finish_mesh(Meshing_state<Geometry>& state, const Finishing& finishing, Continue&& shall_go_on) {
  for (int round = 0; round <= finishing.smoothing_rounds; ++round) {
    if (round > 0) Smoother<Geometry>(state).run(shall_go_on);
    if (finishing.removal == Removal::GUARDED) Remover<Geometry>(state).run(shall_go_on);
  }
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_FINISH_MESH_H
