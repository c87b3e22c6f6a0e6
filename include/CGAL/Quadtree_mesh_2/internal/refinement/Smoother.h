// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Smoothing. Moves every Steiner vertex once to where the least angle of its star is greatest ("optimal"
// smoothing, Freitag, Jones and Plassmann, 1995, here by pattern search), with flips. It gives up no bound
// that is met. It makes room for guarded removal, and also makes angles better. O(n).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SMOOTHER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SMOOTHER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Progress.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Relocator.h>

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
    for (const Vertex_id v : mesh_.points.ids()) {
      if (is_time_to_ask(std::size_t(v)) && !shall_go_on()) return;
      if (!mesh_.is_input(v) && mesh_.is_used(v)) relocator_.improve(v);
    }
  }

private:
  Kernel_mesh<Geometry>& mesh_;
  Relocator<Geometry> relocator_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SMOOTHER_H
