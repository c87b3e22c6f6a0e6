// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The work on one block: it is refined, then coarsened. All it reads and writes is the block's own, and the records of
// the acute corners that the block owns. So blocks may be worked on at once, in any order, and in any memory.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_BLOCK_WORK_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_BLOCK_WORK_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/finish_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/thin_out.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Mesh_block.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Block_work {
public:
  using Block = Mesh_block<Geometry>;
  using Leg = typename Acute_corners<Geometry>::Leg;

  /// \param thinnings how many times blocks are thinned out and refined
  Block_work(Meshing_problem<Geometry>& problem, const Finishing& finishing, int thinnings)
      : problem_(problem), finishing_(finishing), thinnings_(thinnings) {}

  /// Refines a block and thins it out; returns the triangles left, by the handles of the block. The corners have the
  /// block's handles then.
  /// \param owned the corners of the block
  /// \param room how many vertices it may get
  template <class Continue>
  std::vector<Triangle_id> run(Block& block, const std::vector<Corner_id>& owned, std::size_t room,
                               const Continue& shall_go_on) const {
    name_corner_vertices(owned, [&](Vertex_id v) { return block.vertex_in_block(v); });
    Meshing_state<Geometry> state(problem_, owned);
    std::swap(state.mesh, block.mesh);
    const Mesh_limit limit{state.mesh.number_of_vertices() + room};
    for (int i = 0; i < thinnings_; ++i) {
      thin_out(state, shall_go_on);
      refine(state, limit, shall_go_on);
    }
    if (thinnings_ == 0) refine(state, limit, shall_go_on);
    std::swap(state.mesh, block.mesh);
    std::vector<Triangle_id> left = std::move(state.deferred);
    while (!state.worklist.is_empty()) left.push_back(state.worklist.pop());
    left.erase(
        std::remove_if(left.begin(), left.end(), [&](Triangle_id t) { return !block.mesh.is_alive(t); }),
        left.end());
    block.name_first(triangles_for_others(block.mesh, left));
    return left;
  }

  /// Gives the corners the handles of the whole mesh. \pre what is new in the block has its names
  void name_in_whole(const Block& block, const std::vector<Corner_id>& owned) const {
    name_corner_vertices(owned, [&](Vertex_id v) { return block.whole_vertex(v); });
  }

private:
  Meshing_problem<Geometry>& problem_;
  Finishing finishing_;
  int thinnings_;

  /// How far from seams, and from what is left, the second round's zone may come: it has two rings, the next one is
  /// looked at, and flips at seams may lead a little farther.
  static constexpr int rings_for_others = 6;

  /// What other parts may need of a block: the triangles at seams, those that are left, and rings around them.
  static std::vector<Triangle_id> triangles_for_others(const Kernel_mesh<Geometry>& mesh,
                                                       const std::vector<Triangle_id>& left) {
    std::vector<Triangle_id> found;
    Indexed_vector<Triangle_id, char> is_found(mesh.triangles.size(), 0);
    const auto add = [&](Triangle_id t) {
      if (std::exchange(is_found[t], 1) == 0) found.push_back(t);
    };
    for (const Triangle_id t : mesh.triangles.ids())
      if (mesh.is_alive(t))
        for (const Side s : mesh.triangle(t).side)
          if (s.is_seam()) add(t);
    for (const Triangle_id t : left) add(t);
    std::size_t next = 0;
    for (int ring = 0; ring < rings_for_others; ++ring)
      for (const std::size_t end = found.size(); next < end; ++next)
        for (const Side s : mesh.triangle(found[next]).side)
          if (!s.is_border()) add(s.triangle());
    return found;
  }

  /// Refines all that is bad, then removes what can be spared.
  template <class Continue>
  void refine(Meshing_state<Geometry>& state, Mesh_limit limit, const Continue& shall_go_on) const {
    state.deferred.clear();
    Splitter<Geometry> splitter(state);
    Refiner<Geometry> refiner(state, splitter);
    refiner.push_all();
    refiner.run(limit, shall_go_on);
    refiner.push_rest();
    finish_mesh(state, finishing_, shall_go_on);
  }

  /// Renames the vertices of the corners; shells that are gone (none) are forgotten.
  template <class Name>
  void name_corner_vertices(const std::vector<Corner_id>& corners, const Name& name) const {
    for (const Corner_id c : corners)
      for (const Leg_id l : problem_.corners.corner(c).legs) {
        Leg& leg = problem_.corners.leg(l);
        leg.apex_vertex = name(leg.apex_vertex);
        if (leg.ring.is_valid()) leg.ring = name(leg.ring);
        leg.shells.rename(name);
      }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_BLOCK_WORK_H
