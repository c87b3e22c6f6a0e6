// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Smoothing: moves every Steiner vertex once to where the least angle of its star is greatest ("optimal" smoothing,
// Freitag, Jones and Plassmann, 1995, by pattern search), with flips. No bound that is met is given up. It makes room
// for guarded removal, and better angles besides. O(n).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SMOOTHER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SMOOTHER_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Relocator.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Remover.h>

#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Smoother {
public:
  explicit Smoother(Meshing_state<Geometry>& state) : mesh_(state.mesh), relocator_(state) {}

  /// `shall_go_on()` is asked now and then.
  template <class Continue>
  void run(Continue&& shall_go_on) {
    for (Vertex_id v = 0; v < static_cast<Vertex_id>(mesh_.number_of_vertices()); ++v) {
      if ((v & 4095) == 0 && !shall_go_on()) return;
      if (!mesh_.is_input(v) && mesh_.is_used(v)) relocator_.improve(v);
    }
  }

private:
  Kernel_mesh<Geometry>& mesh_;
  Relocator<Geometry> relocator_;
};

enum class Removal { NONE, GUARDED };

/// What is done to a mesh that meets the bounds.
struct Finishing {
  Removal removal = Removal::GUARDED;
  int smoothing_rounds = 0;
  int thinning_rounds = 0; ///< Thinner.h; of the whole mesh, at last
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

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SMOOTHER_H
