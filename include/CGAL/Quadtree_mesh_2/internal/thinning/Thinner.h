// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Thins out a mesh beyond what guarded removal can do.
//
// Removal (Remover.h) keeps the bound at each step, so it ends where no single vertex can go. Here a round
// has three parts. It removes vertices with a bound of `thinning_share` of the given one. It refines
// triangles below the given bound (relocation first, Refiner.h). It removes under guard. Where vertices stood
// in each other's way, fewer are put back. On maps 3 to 4 percent of the triangles go in the first round, and
// about one percent in the second. A round that does not come to rest, or ends with more triangles, is
// undone. O(k) expected for k triangles.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_THINNER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_THINNER_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Remover.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Mesh_snapshot.h>

#include <algorithm>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The share of the bound that removal keeps to.
constexpr double thinning_share = 0.72;

/// \pre no triangle of the mesh is bad, and no sector is locked
template <class Geometry>
class Thinner {
public:
  explicit Thinner(Meshing_state<Geometry>& state)
      : state_(state), lower_(state.bounds.with_share_of_angle(thinning_share)) {}

  /// Returns whether the mesh has fewer triangles than before.
  template <class Continue>
  bool run(Mesh_limit limit, Continue&& shall_go_on) {
    Mesh_snapshot<Geometry> before(state_);
    dirty_all();
    if (Remover<Geometry>(state_, lower_).run(shall_go_on) == 0) return false;
    state_.clear_worklist();
    if (refine(limit, shall_go_on)) {
      Remover<Geometry>(state_).run(shall_go_on);
      if (state_.mesh.number_of_triangles() < before.number_of_triangles()) return true;
    }
    std::move(before).restore(state_);
    state_.push_all_bad(); // the last flips before may have left some on the list, which was cleared
    return false;
  }

private:
  Meshing_state<Geometry>& state_;
  Bounds<Geometry> lower_;

  void dirty_all() { std::fill(state_.mesh.is_dirty.begin(), state_.mesh.is_dirty.end(), char(1)); }

  /// Whether no triangle is bad in the end.
  template <class Continue>
  bool refine(Mesh_limit limit, Continue& shall_go_on) {
    constexpr int most_rounds = 5;
    Splitter<Geometry> splitter(state_);
    Refiner<Geometry> refiner(state_, splitter);
    doubt_all_sides();
    state_.legalize();
    refiner.push_all();
    for (int round = 0; round < most_rounds; ++round) {
      if (refiner.run(limit, shall_go_on) != Refinement_end::DONE) return false;
      state_.legalize(); // and what that makes bad is on the list again
      if (state_.worklist.is_empty()) return !state_.is_any_bad();
    }
    return false;
  }

  /// Removal and smoothing leave sides that are not Delaunay. The circumcenter of a triangle next to one may be a
  /// vertex, and then refinement gives the triangle up.
  void doubt_all_sides() {
    for (const Triangle_id t : state_.mesh.triangles.ids())
      for (int k = 0; k < 3 && state_.mesh.is_alive(t); ++k) {
        const Side o = state_.mesh.triangle(t).side[k];
        if (!o.is_constrained() && t < o.triangle()) state_.doubtful_sides.push_back(Side(t, k));
      }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_THINNER_H
