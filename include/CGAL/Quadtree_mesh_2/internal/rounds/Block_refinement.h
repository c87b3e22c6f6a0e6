// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Refinement and guarded removal by rounds of blocks, in parallel.
//
// Round 1   cuts the mesh into the blocks of its vertices (Vertex_blocks.h). Each is refined (Refiner.h) and coarsened
//           (Remover.h) on its own. Bad triangles that need something beyond a seam wait, and so do vertices at seams.
// Round 2   cuts the surroundings of the seams and of waiting triangles, by squares that are shifted, and treats these
//           blocks in the same way.
// Round r   takes the triangles that still wait, with r - 1 rings around them, eight at most, and the whole of the
//           acute corners that they may wait for. From the fourth on, blocks are four times as large as in the round
//           before. So in the end there is one.
//
// Rounds end when nothing waits, or when some in a row do not help: of one block each, or through much of a large mesh
// (Block_rounds.h). What waits then has no room, or is at an acute corner of which a leg could not be cut, or that
// reaches through most of the mesh. A budget of vertices, a limit on rounds and the user may end them before. The
// caller decides what is left, in the whole mesh.
//
// How blocks are cut does not depend on the number of threads, and neither does the result. In addition to refinement,
// a round takes work in proportion to its zone, one look at each vertex of the mesh, and some bytes for each triangle.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_BLOCK_REFINEMENT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_BLOCK_REFINEMENT_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Block_rounds.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Block_work.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Corner_places.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Round_cuts.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Mesh_blocks.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Triangle_zone.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Who watches the rounds, which know nothing of it. This one does not look; Part_ledger.h has one that does. Each
/// round calls all but the first and `is_flipped()` once, in this order, unless there is nothing to do in it.
struct Unwatched_rounds {
  /// In rounds after the first: the triangles that are worked on, ring by ring.
  template <class State, class Zone>
  void zone_is_found(const State&, const Zone&, const std::vector<Triangle_id>& /* waiting */) const {}
  template <class State, class Blocks>
  void blocks_are_cut(const State&, const Blocks&, int /* round */) const {}
  /// For each block, maybe by several threads at once. It knows its handles in the whole mesh.
  template <class Block>
  void is_written(const Block&) const {}
  /// Before blocks are put together: all are written, and remember their seams.
  template <class State, class Blocks>
  void are_written(const State&, const Blocks&) const {}
  /// For each flip that follows from sides at seams.
  template <class State>
  void is_flipped(const State&, Triangle_id, Triangle_id) const {}
  template <class State>
  void round_is_over(const State&) const {}
};

template <class ConcurrencyTag, class Geometry, class Watch = Unwatched_rounds>
class Block_refinement {
public:
  using Block = Mesh_block<Geometry>;
  using Blocks = Mesh_blocks<ConcurrencyTag, Geometry>;
  using Cuts = Round_cuts<ConcurrencyTag, Geometry>;

  /// \param rounds those that have been done, with whose results the work goes on
  Block_refinement(Meshing_state<Geometry>& whole, const Finishing& finishing, std::size_t vertex_budget,
                   Block_rounds& rounds, Watch& watch)
      : whole_(whole), finishing_(finishing), vertex_budget_(vertex_budget), rounds_(rounds), watch_(watch) {}

  /// Works off what can be done in blocks; the rest is left on the worklist of the whole mesh. `shall_go_on()` may be
  /// called by several threads at once.
  /// \returns false if the mesh is too small for blocks, and nothing was done.
  /// \param between_rounds called before the first round and after each; all there is to do is then in the state of the
  ///        whole mesh and in `rounds`
  template <class Continue, class Between_rounds>
  bool run(const Continue& shall_go_on, const Between_rounds& between_rounds) {
    if (rounds_.number == 0 && !cuts_.is_worth_cutting()) return false;
    whole_.clear_worklist(); // blocks look at all triangles
    between_rounds();
    while (is_round_wanted(shall_go_on)) {
      const std::size_t before = rounds_.waiting.size();
      ++rounds_.number;
      Block_cut cut = rounds_.number == 1 ? cuts_.first() : cut_of_zone(rounds_.number);
      const Round_extent extent{cut.size(), cut.members.size(), whole_.mesh.triangles.size()};
      work(std::move(cut), shall_go_on);
      rounds_.note(before, extent);
      between_rounds();
    }
    for (const Triangle_id t : rounds_.waiting) whole_.push(t);
    return true;
  }

  /// Of the work of all rounds. Any thread may ask.
  double share_done() const {
    const double share = triangles_of_round_ == 0 ? 0
                                                  : static_cast<double>(triangles_done_) /
                                                        static_cast<double>(triangles_of_round_);
    return rounds_.share_done(share);
  }

private:
  Meshing_state<Geometry>& whole_;
  Finishing finishing_;
  std::size_t vertex_budget_;
  Corner_places<ConcurrencyTag, Geometry> corner_places_{whole_};
  Cuts cuts_{whole_};
  Block_assignment assignment_;
  std::size_t triangles_of_round_ = 0; // before they are refined
  std::atomic<std::size_t> triangles_done_{0};
  Block_rounds& rounds_;
  Watch& watch_;

  template <class Continue>
  bool is_round_wanted(const Continue& shall_go_on) const {
    return rounds_.number < 2 || (rounds_.may_go_on() && has_room() && shall_go_on());
  }

  bool has_room() const { return whole_.mesh.number_of_vertices() < vertex_budget_; }

  /// What is worked on in a round: the surroundings of waiting triangles, and of seams in the second.
  Block_cut cut_of_zone(int round) const {
    Triangle_zone<ConcurrencyTag, Geometry> zone(whole_.mesh);
    zone.add(rounds_.waiting);
    for (const Corner_id c : corner_places_.corners_of(rounds_.waiting))
      zone.add(corner_places_.triangles_of(c));
    if (round == 2) zone.add(rounds_.at_seams);
    zone.grow(Cuts::rings_of_zone(round));
    watch_.zone_is_found(whole_, zone, rounds_.waiting);
    return cuts_.of_zone(zone.triangles(), round);
  }

  template <class Continue>
  void work(Block_cut cut, const Continue& shall_go_on) {
    if (cut.members.empty()) return;
    triangles_done_ = 0, triangles_of_round_ = cut.members.size();
    Blocks blocks(whole_.mesh, assignment_, std::move(cut));
    whole_.bulk.forget_handles();
    watch_.blocks_are_cut(whole_, blocks, rounds_.number);
    const auto owned =
        corner_places_.by_block(blocks.size(), [&](Triangle_id t) { return blocks.block_of(t); });
    Indexed_vector<Block_id, std::vector<Triangle_id>> left(blocks.size());
    const Block_work<Geometry> work(whole_.problem, finishing_,
                                    rounds_.number == 1 ? finishing_.thinnings_of_blocks : 0);
    const std::size_t room = vertex_budget_ - std::min(vertex_budget_, whole_.mesh.number_of_vertices());
    blocks.for_each(
        [&](Block& block) {
          const Block_id b = block.id();
          const std::size_t triangles = block.mesh.number_of_triangles();
          left[b] = work.run(block, owned[b], room / blocks.size(), shall_go_on);
          triangles_done_ += triangles;
        },
        [&](const Block& block) {
          const Block_id b = block.id();
          work.name_in_whole(block, owned[b]);
          for (Triangle_id& t : left[b]) t = block.whole_triangle(t);
          watch_.is_written(block);
        });
    watch_.are_written(whole_, blocks);
    blocks.put_together();
    rounds_.waiting.clear();
    for (const auto& triangles : left)
      rounds_.waiting.insert(rounds_.waiting.end(), triangles.begin(), triangles.end());
    rounds_.at_seams = triangles_at<ConcurrencyTag>(whole_.mesh, blocks.seam_sides());
    std::vector<Side> doubtful = blocks.sides_to_flip();
    whole_.mesh.make_Delaunay(doubtful, [this](Triangle_id t, Triangle_id u) {
      for (const Triangle_id flipped : {t, u})
        if (whole_.is_suspect(flipped)) rounds_.waiting.push_back(flipped);
      watch_.is_flipped(whole_, t, u);
    });
    watch_.round_is_over(whole_);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_BLOCK_REFINEMENT_H
