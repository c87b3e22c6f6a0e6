// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The triangles below the bound in a mesh of placed vertices, and what cures them without other leaves.
//
// Computes: a vertex of such a triangle is left out, or moved, if the bound is met around it then. If none of them can
//           be, one is added, if that does it (Vertex_adder.h).
// Bound:    O(1) for each triangle; a few passes over them, one after the other.
// Source:   Bern, Eppstein, Teng, section 6, warp vertices of leaves. Removal and relocation are those of refinement.
// Deviates: the paper warps by rule. Here a place is searched for, and only where the rule misses the bound.
//
// Each triangle made is tested, so no cure makes another triangle miss the bound.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_LOCAL_CURES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_LOCAL_CURES_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Relocator.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Remover.h>
#include <CGAL/Quadtree_mesh_2/internal/theorem_5/Vertex_adder.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Whether a triangle is below the bound of angles, and no acute corner excuses it.
template <class Geometry>
bool is_missed(const Meshing_state<Geometry>& state, Triangle_id t) {
  if (!state.mesh.is_alive(t)) return false;
  const auto& r = state.mesh.triangle(t);
  return state.bounds.is_sharp(state.mesh.shape(r)) && !state.is_exempt(r.v[0], r.v[1], r.v[2]);
}

/// All such triangles, in order.
template <class ConcurrencyTag, class Geometry>
std::vector<Triangle_id> missed_triangles(const Meshing_state<Geometry>& state) {
  return pack_values<ConcurrencyTag, Triangle_id>(
      state.mesh.triangles.size(),
      [&](std::size_t t) { return is_missed(state, static_cast<Triangle_id>(t)); },
      [](std::size_t t) { return static_cast<Triangle_id>(t); });
}

template <class Geometry>
class Local_cures {
public:
  Local_cures(Meshing_state<Geometry>& state, Tree_separation_report_2& report)
      : state_(state), mesh_(state.mesh), report_(report), remover_(state), relocator_(state), adder_(state) {
  }

  /// Cures what can be cured; returns the triangles that are left.
  /// \param missed all triangles below the bound
  std::vector<Triangle_id> run(std::vector<Triangle_id> missed) {
    state_.leg_rule = Leg_rule::FREE; // there are no shells yet
    for (const Triangle_id t : missed)
      if (is_missed(state_, t)) leave_out_vertex_of(t);
    for (int pass = 0; pass < passes_ && !missed.empty(); ++pass) {
      drop_cured(missed);
      for (const Triangle_id t : missed)
        if (is_missed(state_, t) && !move_vertex_of(t)) leave_out_vertex_of(t);
    }
    drop_cured(missed);
    for (const Triangle_id t : missed)
      if (is_missed(state_, t) && adder_.insert_for(t)) ++report_.added;
    state_.leg_rule = Leg_rule::SHELLS;
    drop_cured(missed);
    return missed;
  }

private:
  /// What moves may make room for another move.
  static constexpr int passes_ = 2;

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Tree_separation_report_2& report_;
  Remover<Geometry> remover_;
  Relocator<Geometry> relocator_;
  Vertex_adder<Geometry> adder_;

  /// No cure makes a triangle miss the bound, so those that do are among those that did.
  void drop_cured(std::vector<Triangle_id>& missed) const {
    missed.erase(
        std::remove_if(missed.begin(), missed.end(), [this](Triangle_id t) { return !is_missed(state_, t); }),
        missed.end());
  }

  void leave_out_vertex_of(Triangle_id t) {
    if (try_vertices_of(t, [this](Vertex_id v) { return remover_.remove(v); })) ++report_.left_out;
  }

  bool move_vertex_of(Triangle_id t) {
    const bool is_cured = try_vertices_of(
        t, [this](Vertex_id v) { return !mesh_.is_input(v) && mesh_.is_used(v) && relocator_.relocate(v); });
    report_.relocated += is_cured ? 1 : 0;
    return is_cured;
  }

  template <class Cure>
  bool try_vertices_of(Triangle_id t, const Cure& cure) {
    const auto r = mesh_.triangle(t); // which changes
    return std::any_of(std::begin(r.v), std::end(r.v), cure);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_LOCAL_CURES_H
