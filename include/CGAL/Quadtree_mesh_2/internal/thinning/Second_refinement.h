// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Refines the graph of a small mesh a second time, by another rule, and keeps the smaller mesh.
//
// Computes: a mesh of the same graph from its first triangulation, by off-centers where the first one has corners of
//           quadtrees, from the shortest edge on where the first one begins with the sharpest triangle
//           (Refinement_rule), and with all edges split alike. Vertices are removed under guard in both. The second is
//           kept if it meets the bounds and has fewer triangles.
// Gain:     two percent of the triangles of small meshes in the end. Where a mesh grows by powers of ten around a
//           small polygon, the second rule makes rings of like triangles, which take half as many. The first one
//           mixes triangles of unlike sizes, and thinning (thin_small_mesh.h) does not find its way to such rings.
// Bound:    about as much time as the first refinement. It is given up at a quarter more triangles than the first mesh
//           has, and a few. That many are allowed because removal takes some away.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_SECOND_REFINEMENT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_SECOND_REFINEMENT_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Remover.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>
#include <CGAL/Quadtree_mesh_2/internal/thinning/Mesh_snapshot.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Second_refinement {
public:
  explicit Second_refinement(Meshing_state<Geometry>& state) : state_(state) {}

  /// To be called before the first refinement, if there is to be a second one. Keeps the mesh if it is small and some
  /// triangle misses a bound. One that an acute corner excuses counts, too, because that corner is cut.
  void keep_start() {
    if (state_.is_small_mesh() && is_any_suspect()) start_.emplace(state_);
  }

  /// Returns whether the mesh is another one now.
  /// \pre the mesh is refined, no sector is locked, and the rule of legs is `FREE`
  template <class Continue>
  bool run(Continue&& shall_go_on) {
    if (!start_ || !state_.is_small_mesh()) return false;
    Mesh_snapshot<Geometry> first(state_);
    const std::size_t bad_allowed = state_.number_of_bad_allowed();
    std::move(*start_).restore(state_);
    start_.reset();
    state_.refinement_rule = Refinement_rule::OFF_CENTERS;
    const std::size_t before = first.number_of_triangles();
    constexpr std::size_t few = 32;
    const bool is_refined = refine({Mesh_limit::any, before + before / 4 + few}, bad_allowed, shall_go_on);
    state_.clear_worklist();
    state_.refinement_rule = Refinement_rule::CORNERS;
    if (is_refined) {
      Remover<Geometry>(state_).run(shall_go_on);
      if (state_.mesh.number_of_triangles() < before) return true;
    }
    std::move(first).restore(state_);
    state_.push_all_bad();
    return false;
  }

private:
  Meshing_state<Geometry>& state_;
  std::optional<Mesh_snapshot<Geometry>> start_; // the first triangulation

  bool is_any_suspect() const {
    for (const Triangle_id t : state_.mesh.triangles.ids())
      if (state_.mesh.is_alive(t) && state_.is_suspect(t)) return true;
    return false;
  }

  /// Whether no more triangles are bad in the end than is allowed.
  template <class Continue>
  bool refine(Mesh_limit limit, std::size_t bad_allowed, Continue& shall_go_on) {
    Splitter<Geometry> splitter(state_);
    Refiner<Geometry> refiner(state_, splitter);
    refiner.push_all();
    return refiner.run(limit, shall_go_on) == Refinement_end::DONE && state_.number_of_bad() <= bad_allowed;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THINNING_SECOND_REFINEMENT_H
