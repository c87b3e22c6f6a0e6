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
// Rounds end when nothing waits, or when some rounds in a row hardly help though each works on one block or on most of
// the mesh. What waits then has no room, or is at an acute corner of which a leg could not be cut, or that reaches
// through most of the mesh. A budget of vertices, a limit on rounds and the user may end them before. The caller
// decides what is left, in the whole mesh.
//
// How blocks are cut does not depend on the number of threads, and neither does the result. In addition to refinement,
// a round takes work in proportion to its zone, one look at each vertex of the mesh, and some bytes for each triangle.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_BLOCK_REFINEMENT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_BLOCK_REFINEMENT_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Corner_places.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/finish_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/thin_out.h>
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

/// What there is between two rounds, besides the mesh.
struct Block_rounds {
  int number = 0;                   ///< of rounds that are done
  int fruitless = 0;                ///< those at the end that cost much and left nearly as much as there was
  std::vector<Triangle_id> waiting; ///< bad triangles
  Uninitialized_vector<Triangle_id> at_seams; ///< of the last round

  bool are_over = false; ///< and all that follows on them is done

  /// Writes or reads it (Checkpoint_file.h).
  template <class Archive>
  void transfer(Archive& archive) {
    archive(number, fruitless, waiting, at_seams, are_over);
  }
};

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
  using Leg = typename Acute_corners<Geometry>::Leg;

  static constexpr std::size_t block_size = Block_sizes<ConcurrencyTag>::triangles;
  /// Smaller than in the first round: the zone is small, and a thin network, so seams through it are short.
  static constexpr std::size_t zone_block_size = block_size / 4;

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
    if (rounds_.number == 0 &&
        whole_.mesh.number_of_triangles() - whole_.bulk.number_of_triangles() < 2 * block_size)
      return false;
    whole_.clear_worklist(); // blocks look at all triangles
    between_rounds();
    while (is_round_wanted(shall_go_on)) {
      const std::size_t before = rounds_.waiting.size();
      ++rounds_.number;
      Block_cut cut = rounds_.number == 1 ? first_cut() : cut_of_zone(rounds_.number);
      const bool shall_help = is_help_expected(cut);
      work(std::move(cut), shall_go_on);
      if (shall_help) rounds_.fruitless = has_helped(before) ? 0 : rounds_.fruitless + 1;
      between_rounds();
    }
    for (const Triangle_id t : rounds_.waiting) whole_.push(t);
    return true;
  }

  /// Of the work of all rounds, most of which is in the first. Any thread may ask.
  double share_done() const {
    const double share = triangles_of_round_ == 0 ? 0
                                                  : static_cast<double>(triangles_done_) /
                                                        static_cast<double>(triangles_of_round_);
    double begin = 0, end = share_of_first_round;
    for (int round = 1; round < rounds_.number; ++round) begin = end, end = (1 + end) / 2;
    return begin + (end - begin) * share;
  }

private:
  static constexpr double share_of_first_round = 0.8;
  static constexpr int most_fruitless_rounds = 3;
  static constexpr int most_rounds = 40;

  Meshing_state<Geometry>& whole_;
  Finishing finishing_;
  std::size_t vertex_budget_;
  Corner_places<ConcurrencyTag, Geometry> corner_places_{whole_};
  Place_keys<Geometry> key_{whole_.problem.input_points.values()};
  Place_keys<Geometry> shifted_key_ = key_.shifted();
  Block_assignment assignment_;
  std::size_t triangles_of_round_ = 0; // before they are refined
  std::atomic<std::size_t> triangles_done_{0};
  Block_rounds& rounds_;
  Watch& watch_;

  template <class Continue>
  bool is_round_wanted(const Continue& shall_go_on) const {
    if (rounds_.number < 2) return true;
    return !rounds_.waiting.empty() && rounds_.fruitless < most_fruitless_rounds &&
           rounds_.number < most_rounds && has_room() && shall_go_on();
  }

  /// Whether the whole mesh does better if this round does not help. Several blocks that are a small part of the mesh
  /// cost little, and less may wait once they have grown.
  bool is_help_expected(const Block_cut& cut) const {
    return rounds_.number > 2 &&
           (cut.size() == 1 || 2 * cut.members.size() > whole_.mesh.number_of_triangles());
  }
  /// Whether an eighth of what waited before the round does not wait any more; of a few triangles, one.
  bool has_helped(std::size_t before) const { return rounds_.waiting.size() < before - before / 8; }

  bool has_room() const { return whole_.mesh.number_of_vertices() < vertex_budget_; }

  Block_cut first_cut() const {
    const auto& mesh = whole_.mesh;
    if (whole_.has_placed_vertices)
      return cut_by_position<ConcurrencyTag>(mesh, triangles_outside_bulk(), block_size, key_);
    const Vertex_id end_of_input = whole_.problem.input_points.end_id();
    return cut_by_vertices<ConcurrencyTag>(mesh, whole_.problem.vertex_blocks, [&](Vertex_id v) {
      return v < end_of_input ? v : whole_.edges[mesh.edge(v)].a;
    });
  }

  /// All triangles but those within the bulk, which meet all bounds and are not near its border.
  std::vector<Triangle_id> triangles_outside_bulk() const {
    const Kernel_mesh<Geometry>& mesh = whole_.mesh;
    const auto& bulk = whole_.bulk;
    return pack_values<ConcurrencyTag, Triangle_id>(
        mesh.triangles.size(),
        [&](std::size_t i) {
          const auto& v = mesh.triangle(static_cast<Triangle_id>(i)).v;
          return v[0].is_valid() &&
                 !(bulk.has_within(v[0]) && bulk.has_within(v[1]) && bulk.has_within(v[2]));
        },
        [](std::size_t i) { return static_cast<Triangle_id>(i); });
  }

  Uninitialized_vector<Triangle_id> triangles_at(const std::vector<Side>& sides) const {
    Uninitialized_vector<Triangle_id> triangles(2 * sides.size());
    for_each_index<ConcurrencyTag>(sides.size(), [&](std::size_t i) {
      triangles[2 * i] = sides[i].triangle();
      triangles[2 * i + 1] = whole_.mesh.across(sides[i]).triangle();
    });
    return triangles;
  }

  /// What is worked on in a round: the surroundings of waiting triangles, and of seams in the second.
  Block_cut cut_of_zone(int round) const {
    Triangle_zone<ConcurrencyTag, Geometry> zone(whole_.mesh);
    zone.add(rounds_.waiting);
    for (const Corner_id c : corner_places_.corners_of(rounds_.waiting))
      zone.add(corner_places_.triangles_of(c));
    if (round == 2) zone.add(rounds_.at_seams);
    constexpr int most_rings = 8;
    zone.grow(std::max(2, std::min(round - 1, most_rings)));
    watch_.zone_is_found(whole_, zone, rounds_.waiting);
    const int doublings = std::min(2 * std::max(0, round - 3), 24);
    return cut_by_position<ConcurrencyTag>(whole_.mesh, zone.triangles(), zone_block_size << doublings,
                                           round % 2 == 0 ? shifted_key_ : key_);
  }

  template <class Continue>
  void work(Block_cut cut, const Continue& shall_go_on) {
    if (cut.members.empty()) return;
    triangles_done_ = 0, triangles_of_round_ = cut.members.size();
    Blocks blocks(whole_.mesh, assignment_, std::move(cut));
    watch_.blocks_are_cut(whole_, blocks, rounds_.number);
    const auto owned = corner_places_.by_block(blocks);
    Indexed_vector<Block_id, std::vector<Triangle_id>> left(blocks.size());
    const std::size_t room = vertex_budget_ - std::min(vertex_budget_, whole_.mesh.number_of_vertices());
    blocks.for_each(
        [&](Block& block) {
          const Block_id b = block.id();
          const std::size_t triangles = block.mesh.number_of_triangles();
          left[b] = work(block, owned[b], room / blocks.size(), shall_go_on);
          triangles_done_ += triangles;
        },
        [&](const Block& block) {
          const Block_id b = block.id();
          name_corner_vertices(owned[b], [&](Vertex_id v) { return block.whole_vertex(v); });
          for (Triangle_id& t : left[b]) t = block.whole_triangle(t);
          watch_.is_written(block);
        });
    watch_.are_written(whole_, blocks);
    blocks.put_together();
    rounds_.waiting.clear();
    for (const auto& triangles : left)
      for (const Triangle_id t : triangles)
        if (whole_.mesh.is_alive(t)) rounds_.waiting.push_back(t);
    rounds_.at_seams = triangles_at(blocks.seam_sides());
    std::vector<Side> doubtful = blocks.sides_to_flip();
    whole_.mesh.make_Delaunay(doubtful, [this](Triangle_id t, Triangle_id u) {
      for (const Triangle_id flipped : {t, u})
        if (whole_.is_suspect(flipped)) rounds_.waiting.push_back(flipped);
      watch_.is_flipped(whole_, t, u);
    });
    watch_.round_is_over(whole_);
  }

  /// Refines a block and thins it out; returns the triangles left.
  template <class Continue>
  std::vector<Triangle_id> work(Block& block, const std::vector<Corner_id>& owned, std::size_t room,
                                const Continue& shall_go_on) {
    name_corner_vertices(owned, [&](Vertex_id v) { return block.vertex_in_block(v); });
    Meshing_state<Geometry> state(whole_.problem, owned);
    std::swap(state.mesh, block.mesh);
    const Mesh_limit limit{state.mesh.number_of_vertices() + room};
    const int thinnings = rounds_.number == 1 ? finishing_.thinnings_of_blocks : 0;
    for (int i = 0; i < thinnings; ++i) {
      thin_out(state, shall_go_on);
      refine(state, limit, shall_go_on);
    }
    if (thinnings == 0) refine(state, limit, shall_go_on);
    std::swap(state.mesh, block.mesh);
    std::vector<Triangle_id> left = std::move(state.deferred);
    while (!state.worklist.is_empty()) left.push_back(state.worklist.pop());
    return left;
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
  void name_corner_vertices(const std::vector<Corner_id>& corners, const Name& name) {
    for (const Corner_id c : corners)
      for (const Leg_id l : whole_.corners.corner(c).legs) {
        Leg& leg = whole_.corners.leg(l);
        leg.apex_vertex = name(leg.apex_vertex);
        if (leg.ring.is_valid()) leg.ring = name(leg.ring);
        leg.shells.rename(name);
      }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_BLOCK_REFINEMENT_H
