// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_MESH_SNAPSHOT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_MESH_SNAPSHOT_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The mesh of a state, and what goes with it, to come back to if what is tried does not help.
template <class Geometry>
class Mesh_snapshot {
public:
  explicit Mesh_snapshot(const Meshing_state<Geometry>& state)
      : mesh_(state.mesh), corners_(state.corners), bulk_(state.bulk) {}

  std::size_t number_of_triangles() const { return mesh_.number_of_triangles(); }

  /// Puts it back, with nothing on the worklist; what was in the state is lost, and the snapshot with it.
  void restore(Meshing_state<Geometry>& state) && {
    state.clear_worklist();
    state.doubtful_sides.clear();
    state.mesh = std::move(mesh_);
    state.corners = std::move(corners_);
    state.bulk = bulk_;
  }

private:
  Kernel_mesh<Geometry> mesh_;
  Acute_corners<Geometry> corners_; // their shells name vertices of the mesh
  typename Meshing_state<Geometry>::Bulk bulk_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_MESH_SNAPSHOT_H
