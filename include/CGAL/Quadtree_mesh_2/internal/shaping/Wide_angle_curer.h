// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Cures triangles whose greatest angle is above a bound.
//
// Computes: in rounds, for each such triangle, and for those that acute corners excuse from 150 degrees on, another place for one of its vertices. If
//           there is none, one more vertex: the circumcenter, or a point that splits the segment in its way. Refinement
//           then restores all other bounds. What is too wide after that is for the next round.
// Bound:    a constant number of rounds. Each makes at most one vertex for a triangle, and what refinement makes for the
//           least angle. So the work ends as refinement does, whatever the bound is.
// Source:   Chew, "Guaranteed-quality mesh generation for curved surfaces" (1993). A triangle with an angle above 120
//           degrees has another one below 30, and its circumradius is at least its shortest side. So circumcenters make
//           no shorter edges. Below 120 degrees they may, and rounds are what ends the work.
// Deviates: rounds end early where several have left no fewer such triangles.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHAPING_WIDE_ANGLE_CURER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHAPING_WIDE_ANGLE_CURER_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Exact_legalizer.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Wide_angle_curer {
public:
  /// \param most_vertices at which no vertex is made any more
  Wide_angle_curer(Meshing_state<Geometry>& state, Refiner<Geometry>& refiner, std::size_t most_vertices)
      : state_(state), mesh_(state.mesh), refiner_(refiner), most_vertices_(most_vertices) {}

  /// \param account of the mesh as it is
  /// \param refine works off the worklist and makes the mesh what it has to be at the end; \returns its account
  /// \param is_stopped whether the user or a budget ends the work
  template <class Refine, class Is_stopped>
  Triangle_account run(Triangle_account account, Refine&& refine, Is_stopped&& is_stopped) {
    std::size_t least = mesh_.triangles.size() + 1;
    int rounds_in_vain = 0;
    for (int round = 0; round < most_rounds && !is_stopped(); ++round) {
      const std::vector<Triangle_id> wide = wide_among(account.suspects);
      if (wide.empty()) break;
      rounds_in_vain = wide.size() < least ? 0 : rounds_in_vain + 1;
      if (rounds_in_vain == most_rounds_in_vain) break;
      least = wide.size() < least ? wide.size() : least;
      for (const Triangle_id t : wide)
        if (mesh_.number_of_vertices() < most_vertices_ && is_wide(t)) refiner_.cure_wide(t);
      account = refine();
    }
    return account;
  }

private:
  static constexpr int most_rounds = 40;
  /// Of the greatest angle wanted of exempt triangles, 150 degrees.
  static constexpr double cosine2_of_widest_exempt = 0.75;
  /// After so many rounds that left no fewer such triangles than one before did, more are of no use.
  static constexpr int most_rounds_in_vain = 4;

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Refiner<Geometry>& refiner_;
  std::size_t most_vertices_;

  bool is_wide(Triangle_id t) const {
    if (!mesh_.is_alive(t)) return false;
    const auto& r = mesh_.triangle(t);
    const auto s = mesh_.shape(r);
    return state_.bounds.is_wide(s) &&
           (s.is_wider(cosine2_of_widest_exempt) || !state_.is_exempt(r.v[0], r.v[1], r.v[2]));
  }

  std::vector<Triangle_id> wide_among(const std::vector<Triangle_id>& suspects) const {
    std::vector<Triangle_id> wide;
    for (const Triangle_id t : suspects)
      if (is_wide(t)) wide.push_back(t);
    return wide;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHAPING_WIDE_ANGLE_CURER_H
