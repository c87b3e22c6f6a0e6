// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Cures triangles whose greatest angle is above a bound.
//
// Computes: in rounds, for each such triangle, and for those that acute corners excuse from 150 degrees on, another
//           place for one of its vertices. If there is none, one more vertex: the circumcenter, or a point that splits
//           the segment in its way. Refinement then restores all other bounds. What is too wide after that is for the
//           next round.
// Bound:    a constant number of rounds. Each takes up a triangle once, and what follows is refinement for the other
//           bounds. So the work ends as that does, whatever the bound is.
// Source:   Chew, "Guaranteed-quality mesh generation for curved surfaces" (1993). A triangle with an angle above 120
//           degrees has another one below 30, and its circumradius is at least its shortest side. So circumcenters make
//           no shorter edges. Below 120 degrees they may, and rounds are what ends the work.
// Deviates: rounds end early where several have left no fewer such triangles. Within fans of sharp sectors, exempt
//           triangles stay as they are.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHAPING_WIDE_ANGLE_CURER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHAPING_WIDE_ANGLE_CURER_H

#include <CGAL/Quadtree_mesh_2/internal/refinement/Exact_legalizer.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>

#include <cstddef>
#include <limits>
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
    for (int round = 0; round < most_rounds && !is_stopped(); ++round) {
      std::vector<Triangle_id> wide = others_.still_wanted(wide_among(account.suspects, Kind::OTHER));
      const auto exempt = exempt_.still_wanted(wide_among(account.suspects, Kind::EXEMPT));
      wide.insert(wide.end(), exempt.begin(), exempt.end());
      if (wide.empty()) break;
      for (const Triangle_id t : wide)
        if (mesh_.number_of_vertices() < most_vertices_ && mesh_.is_alive(t) && kind(t) != Kind::GOOD)
          refiner_.cure_wide(t);
      account = refine();
    }
    return account;
  }

private:
  enum class Kind { GOOD, EXEMPT, OTHER };

  /// Gives up triangles of one kind when several rounds have left no fewer of them, or many more.
  class Patience {
  public:
    explicit Patience(int rounds_in_vain) : rounds_in_vain_(rounds_in_vain), rounds_left_(rounds_in_vain) {}

    /// \returns those given, or none from the time on when they are given up
    std::vector<Triangle_id> still_wanted(std::vector<Triangle_id> wide) {
      constexpr std::size_t few = 10;
      if (wide.size() < least_)
        least_ = wide.size(), rounds_left_ = rounds_left_ > 0 ? rounds_in_vain_ : 0;
      else if (rounds_left_ > 0)
        rounds_left_ = wide.size() > least_ + least_ / 10 + few ? 0 : rounds_left_ - 1;
      if (rounds_left_ == 0) wide.clear();
      return wide;
    }

  private:
    int rounds_in_vain_, rounds_left_;
    std::size_t least_ = std::numeric_limits<std::size_t>::max();
  };

  static constexpr int most_rounds = 40;
  /// Of the greatest angle wanted of exempt triangles, 150 degrees.
  static constexpr double cosine2_of_widest_exempt = 0.75;
  /// In corners sharper than this, squared, doubles have no room for matching vertices on both legs.
  static constexpr double sin2_of_sharpest_tried = 1e-16;

  Meshing_state<Geometry>& state_;
  Kernel_mesh<Geometry>& mesh_;
  Refiner<Geometry>& refiner_;
  std::size_t most_vertices_;
  Patience others_{8};
  Patience exempt_{4};

  /// \pre t is alive
  Kind kind(Triangle_id t) const {
    const auto& r = mesh_.triangle(t);
    const auto s = mesh_.shape(r);
    if (!state_.bounds.is_wide(s)) return Kind::GOOD;
    if (!state_.is_exempt(r.v[0], r.v[1], r.v[2])) return Kind::OTHER;
    const bool is_tried = s.is_wider(cosine2_of_widest_exempt) &&
                          s.sin2_of_least_angle() > sin2_of_sharpest_tried &&
                          !is_within_fan(state_.corners.excusing_sector(mesh_, r.v[0], r.v[1], r.v[2]));
    return is_tried ? Kind::EXEMPT : Kind::GOOD;
  }

  /// Whether there are sharp sectors on both sides of one. A vertex on a leg there makes more exempt triangles in the
  /// sector next to it, and so on.
  bool is_within_fan(Sector_id s) const {
    if (!s.is_valid()) return false;
    const auto& sector = state_.corners.sector(s);
    return state_.corners.leg(sector.right).before.is_valid() &&
           state_.corners.leg(sector.left).after.is_valid();
  }

  std::vector<Triangle_id> wide_among(const std::vector<Triangle_id>& suspects, Kind wanted) const {
    std::vector<Triangle_id> wide;
    for (const Triangle_id t : suspects)
      if (mesh_.is_alive(t) && kind(t) == wanted) wide.push_back(t);
    return wide;
  }
};

/// Makes the end of all work on a mesh, and cures wide angles if there is a bound on them.
/// \param most_vertices at which no vertex is made any more
/// \param finish makes the mesh what it has to be at the end; \returns its account
/// \param work_off has the refiner work off the worklist
template <class Geometry, class Is_stopped, class Finish, class Work_off>
Triangle_account cure_wide_angles(Meshing_state<Geometry>& state, Refiner<Geometry>& refiner,
                                  std::size_t most_vertices, const Is_stopped& is_stopped,
                                  const Finish& finish, const Work_off& work_off) {
  Triangle_account account = finish();
  if (!state.bounds.has_widest()) return account;
  return Wide_angle_curer<Geometry>(state, refiner, most_vertices)
      .run(
          std::move(account), [&] { return work_off(refiner), finish(); }, is_stopped);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHAPING_WIDE_ANGLE_CURER_H
