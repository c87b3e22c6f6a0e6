// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Thins out a mesh beyond what guarded removal can do.
//
// Removal (Remover.h) keeps the bound at each step, so it ends where no single vertex can go. Here a round
// has three parts. It thins the mesh out (thin_out.h). It refines triangles below the bound (relocation first,
// Refiner.h). It removes under guard. On maps 3 to 4 percent of the triangles go in the first round, and
// about one percent in the second. A round that does not come to rest, or ends with more triangles, is
// undone. O(k) expected for k triangles.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_THINNER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_THINNER_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Remover.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/thin_out.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Mesh_snapshot.h>

#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// \pre no triangle of the mesh is bad, and no sector is locked
template <class Geometry>
class Thinner {
public:
  explicit Thinner(Meshing_state<Geometry>& state) : state_(state) {}

  /// Returns whether the mesh has fewer triangles than before.
  template <class Continue>
  bool run(Mesh_limit limit, Continue&& shall_go_on) {
    Mesh_snapshot<Geometry> before(state_);
    const std::size_t bad_allowed = state_.number_of_bad_allowed();
    if (thin_out(state_, shall_go_on) > 0 && refine(limit, bad_allowed, shall_go_on)) {
      Remover<Geometry>(state_).run(shall_go_on);
      if (state_.mesh.number_of_triangles() < before.number_of_triangles()) return true;
    }
    std::move(before).restore(state_);
    state_.push_all_bad(); // the last flips before may have left some on the list, which was cleared
    return false;
  }

private:
  Meshing_state<Geometry>& state_;

  /// Whether no more triangles are bad in the end than is allowed.
  template <class Continue>
  bool refine(Mesh_limit limit, std::size_t bad_allowed, Continue& shall_go_on) {
    constexpr int most_rounds = 5;
    Splitter<Geometry> splitter(state_);
    Refiner<Geometry> refiner(state_, splitter);
    refiner.push_all();
    for (int round = 0; round < most_rounds; ++round) {
      if (refiner.run(limit, shall_go_on) != Refinement_end::DONE) return false;
      state_.legalize(); // and what that makes bad is on the list again
      if (state_.worklist.is_empty()) return state_.number_of_bad() <= bad_allowed;
    }
    return false;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_THINNER_H
