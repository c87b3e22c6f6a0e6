// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The rounds of blocks (rounds/Block_refinement.h) of a mesh that parts hold.
//
// Computes: the same bits as in one memory, for any number of parts: handles, records, what waits.
// Bound:    each part holds its own blocks of the first round, and the zones of all later ones, with what is around
//           them. In the first round it works on its blocks before the first of them is written. A part sends to all
//           others what it makes of its blocks in a zone. It has a byte for each triangle of the whole mesh while a
//           zone is found, and 4 bytes for each one that waits or is at a seam. The records of all acute corners are at
//           all parts.
// Method:   the first part has the whole mesh at first. Parts get runs of blocks with about as many triangles, refine
//           them, and tell each other how many triangles and vertices are new in each block, from which all know the
//           handles of theirs. What is at seams is shared then (Held_mesh.h). Zones are shared before they are cut.
//           So all parts find the same zone, cut it alike, link the same seams and flip the same sides, and each works
//           on its run of the blocks.
//
// The problem (points, edges, corners, bounds) is the same at all parts. What is thrown while one of them works on its
// blocks, all throw; an error between, such as no memory left, is not told to others.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_ROUNDS_OF_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_ROUNDS_OF_PARTS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Sparse_values.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/tell_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Block_rounds.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Block_work.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Corner_places.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Round_cuts.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Corners_of_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Held_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Mesh_blocks.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Triangle_zone.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Exchange, class Geometry>
class Rounds_of_parts {
public:
  using Block = Mesh_block<Geometry>;
  using Held = Held_mesh<Exchange, Geometry>;

  /// \param whole with the mesh at part 0; its mesh at other parts is thrown away
  /// \param rounds none that have been done
  Rounds_of_parts(Exchange& exchange, Meshing_state<Geometry>& whole, const Finishing& finishing,
                  std::size_t vertex_budget, Block_rounds& rounds)
      : exchange_(exchange), whole_(whole), finishing_(finishing), vertex_budget_(vertex_budget),
        rounds_(rounds) {}

  /// What `Block_refinement::run()` does, but that what waits is left in `rounds` alone. All parts call it.
  /// \returns false if the mesh is too small for blocks; then part 0 has it still.
  template <class Continue>
  bool run(const Continue& shall_go_on) {
    if (exchange_.rank() != 0) whole_.mesh = Kernel_mesh<Geometry>();
    if (exchange_.max(exchange_.rank() == 0 && cuts_.is_worth_cutting() ? 1 : 0) == 0) return false;
    whole_.clear_worklist();
    do {
      const std::size_t before = rounds_.waiting.size();
      const bool is_first = ++rounds_.number == 1;
      const Shared_work work = is_first ? first_work() : work_in_zone();
      const Round_extent extent{work.number_of_blocks, work.number_in_blocks, whole_.mesh.triangles.size()};
      if (work.number_in_blocks > 0) this->work(work, shall_go_on);
      give_back_free_memory();
      rounds_.note(before, extent);
    } while (is_round_wanted(shall_go_on));
    return true;
  }

  /// Part 0 gets the whole mesh, with the bits that one memory has; all else is at all parts. All parts call it, after
  /// rounds.
  void gather() {
    held_.gather();
    const std::vector<Triangle_id>& dead = whole_.mesh.dead_triangles();
    const auto rest = dead.begin() + static_cast<std::ptrdiff_t>(own_dead_);
    std::vector<Triangle_id> all = tell_all(exchange_, std::vector<Triangle_id>(dead.begin(), rest));
    all.insert(all.end(), rest, dead.end());
    if (exchange_.rank() == 0) whole_.mesh.set_dead_triangles(std::move(all));
  }

  /// Of the work of all rounds, as far as this part can tell. Any thread may ask.
  double share_done() const {
    const double share = triangles_of_round_ == 0 ? 0
                                                  : static_cast<double>(triangles_done_) /
                                                        static_cast<double>(triangles_of_round_);
    return rounds_.share_done(share);
  }

  const Held& held() const { return held_; }
  Held& held() { return held_; }
  Corners_of_parts<Exchange, Geometry>& corners() { return corners_; }
  /// Of the whole mesh. All parts call it.
  std::size_t number_of_triangles() {
    const std::size_t of_all = whole_.mesh.dead_triangles().size() - own_dead_;
    const auto own = static_cast<std::size_t>(exchange_.sum(static_cast<std::int64_t>(own_dead_)));
    return whole_.mesh.triangles.size() - own - of_all;
  }
  /// How many of the dead triangles are this part's alone, the first ones in its list. The lists of all parts up to
  /// there, and then the rest of one, are the list that one memory has.
  std::size_t number_of_own_dead() const { return own_dead_; }

private:
  /// A round's blocks, as far as this part has to know them.
  struct Shared_work {
    std::size_t number_of_blocks = 0, number_in_blocks = 0; ///< of all parts, and of triangles in them
    std::size_t begin = 0;                                  ///< its own first block
    Block_cut own;                                          ///< from that one on
    std::vector<std::vector<Corner_id>> owned;              ///< the corners of these
  };

  /// What is new in a block.
  struct Growth {
    std::uint32_t triangles, vertices;
  };

  /// What blocks have made, by handles of the whole mesh.
  struct Made {
    std::vector<Triangle_id> triangles;
    std::vector<Vertex_id> vertices;

    void add(const Block& block) {
      for (const Triangle_id t : block.mesh.triangles.ids())
        if (block.mesh.is_alive(t)) triangles.push_back(block.whole_triangle(t));
      for (const Vertex_id v : block.mesh.points.ids())
        if (block.whole_vertex(v).is_valid()) vertices.push_back(block.whole_vertex(v));
    }
  };

  using Corners_of_blocks = typename Corner_places<ConcurrencyTag, Geometry>::Corners_of_blocks;
  using Fan = typename Block::Fan;

  /// How many rings around a triangle are shared at once where flips come to one that is not.
  static constexpr int rings_for_flips = 4;

  Exchange& exchange_;
  Meshing_state<Geometry>& whole_;
  Finishing finishing_;
  std::size_t vertex_budget_;
  Block_rounds& rounds_;
  Round_cuts<ConcurrencyTag, Geometry> cuts_{whole_};
  Corner_places<ConcurrencyTag, Geometry> corner_places_{whole_};
  Held held_{exchange_, whole_.mesh};
  Corners_of_parts<Exchange, Geometry> corners_{exchange_, held_, whole_};
  std::size_t own_dead_ = 0;
  std::size_t triangles_of_round_ = 0; // in this part's blocks, before they are refined
  std::atomic<std::size_t> triangles_done_{0};

  bool is_first_round() const { return rounds_.number == 1; }

  template <class Continue>
  bool is_round_wanted(const Continue& shall_go_on) {
    if (rounds_.number < 2) return true;
    const bool has_room = whole_.mesh.number_of_vertices() < vertex_budget_;
    return rounds_.may_go_on() && has_room && exchange_.min(shall_go_on() ? 1 : 0) == 1;
  }

  // ---- who works on what

  /// The part that works on a block: runs with about as many triangles each.
  std::size_t part_of_block(const std::vector<std::size_t>& first, std::size_t b) const {
    const auto parts = static_cast<std::size_t>(exchange_.size());
    return first.back() == 0 ? 0 : std::min(parts - 1, (first[b] + first[b + 1]) / 2 * parts / first.back());
  }
  /// The first block of each part, and how many blocks there are.
  std::vector<std::size_t> first_blocks(const std::vector<std::size_t>& first) const {
    std::vector<std::size_t> first_of_part(static_cast<std::size_t>(exchange_.size()) + 1, first.size() - 1);
    for (std::size_t b = first.size() - 1; b-- > 0;) first_of_part[part_of_block(first, b)] = b;
    for (std::size_t p = first_of_part.size() - 1; p-- > 0;)
      first_of_part[p] = std::min(first_of_part[p], first_of_part[p + 1]);
    first_of_part[0] = 0;
    return first_of_part;
  }

  /// Part 0 tells how the mesh is cut, and gives each part what is in its blocks. Triangles in no block go in runs of
  /// handles. Parts find their blocks in what they get, as part 0 is short of memory while it has the whole mesh.
  Shared_work first_work() {
    const auto parts = static_cast<std::size_t>(exchange_.size());
    const First_cut cut = tell_first_cut();
    const std::vector<std::size_t> first_of_part = first_blocks(cut.first);
    Indexed_vector<Block_id, int> part_of_block;
    for (std::size_t p = 0; p < parts; ++p) part_of_block.resize(first_of_part[p + 1], static_cast<int>(p));
    const auto rank = static_cast<std::size_t>(exchange_.rank());
    Shared_work work;
    work.number_of_blocks = cut.size(), work.number_in_blocks = cut.first.back();
    work.begin = first_of_part[rank];
    const std::size_t end = first_of_part[rank + 1];
    work.owned = corners_of_blocks(cut, first_of_part);
    const auto part_of = [&](const Kernel_mesh<Geometry>& mesh, Triangle_id t) {
      const Block_id b = cuts_.block_of(cut, mesh, t);
      return b.is_valid() ? part_of_block[b] : static_cast<int>(t.value() * parts / mesh.triangles.size());
    };
    // All know the points of the input, and from now on have them in the mesh alone.
    const std::size_t known = whole_.problem.number_of_input_points();
    if (exchange_.rank() != 0) whole_.mesh.points = std::move(whole_.problem.input_points);
    whole_.problem.borrow_points(whole_.mesh.points, known);
    held_.scatter(part_of, exchange_.rank() == 0 ? corners_.vertices() : std::vector<Vertex_id>(),
                  vertex_budget_, known);
    work.own = cuts_.blocks_between(cut, work.begin, end, whole_.mesh,
                                    [this](Triangle_id t) { return held_.is_private(t); });
    return work;
  }

  First_cut tell_first_cut() {
    Archive_writer written;
    if (exchange_.rank() == 0) {
      const First_cut cut = cuts_.first_in_few_words();
      written(cut.first), written(cut.first_words);
    }
    exchange_.broadcast(written.bytes, 0);
    Archive_reader archive(written.bytes);
    First_cut cut;
    archive(cut.first), archive(cut.first_words);
    return cut;
  }

  /// The corners that this part's blocks own, as part 0 finds.
  std::vector<std::vector<Corner_id>> corners_of_blocks(const First_cut& cut,
                                                        const std::vector<std::size_t>& first_of_part) {
    Parcels outbox;
    if (exchange_.rank() == 0) {
      const Corners_of_blocks owned = corner_places_.by_block(
          cut.size(), [&](Triangle_id t) { return cuts_.block_of(cut, whole_.mesh, t); });
      for (std::size_t p = 0; p + 1 < first_of_part.size(); ++p) {
        Archive_writer archive;
        for (std::size_t b = first_of_part[p]; b < first_of_part[p + 1]; ++b)
          archive(owned[static_cast<Block_id>(b)]);
        outbox.push_back({static_cast<int>(p), std::move(archive.bytes)});
      }
    }
    std::vector<std::vector<Corner_id>> own;
    for (const Parcel& parcel : exchange_.exchange(std::move(outbox)))
      for (Archive_reader archive(parcel.bytes); !archive.is_at_end();) archive(own.emplace_back());
    return own;
  }

  /// The zone around what waits, and around seams in the second round, shared and cut by all parts alike.
  Shared_work work_in_zone() {
    const int round = rounds_.number;
    Triangle_zone<ConcurrencyTag, Geometry> zone(whole_.mesh);
    held_.require(rounds_.waiting, 1);
    zone.add(rounds_.waiting);
    const std::vector<Triangle_id> of_corners =
        corners_.triangles_of(corner_places_.corners_of(rounds_.waiting));
    held_.require(of_corners, 1);
    zone.add(of_corners);
    if (round == 2) zone.add(rounds_.at_seams);
    zone.grow(cuts_.rings_of_zone(round), [this](Span<Triangle_id> ring) {
      held_.require({ring.begin(), ring.end()}, 1);
    });
    held_.require(zone.triangles(), 1);

    const Block_cut cut = cuts_.of_zone(zone.triangles(), round);
    Shared_work work;
    work.number_of_blocks = cut.size(), work.number_in_blocks = cut.members.size();
    const std::vector<std::size_t> first_of_part = first_blocks(cut.first);
    const auto rank = static_cast<std::size_t>(exchange_.rank());
    work.begin = first_of_part[rank];
    const std::size_t end = first_of_part[rank + 1];
    work.owned.resize(end - work.begin);
    share_out_corners(cut, work);
    for (std::size_t b = work.begin; b <= end; ++b)
      work.own.first.push_back(cut.first[b] - cut.first[work.begin]);
    work.own.members.assign(cut.members.begin() + std::ptrdiff_t(cut.first[work.begin]),
                            cut.members.begin() + std::ptrdiff_t(cut.first[end]));
    return work;
  }

  /// The corners that this part's blocks of the zone own. Only corners with their apex in the zone can have an owner.
  void share_out_corners(const Block_cut& cut, Shared_work& work) {
    Sparse_values<Triangle_id, Block_id> block_of(whole_.mesh.triangles.size());
    std::vector<Vertex_id> in_zone;
    for (std::size_t b = 0; b < cut.size(); ++b)
      for (const Triangle_id t : cut[b]) {
        block_of.at(t) = static_cast<Block_id>(b);
        for (const Vertex_id v : whole_.mesh.triangle(t).v)
          if (whole_.mesh.is_input(v)) in_zone.push_back(v);
      }
    std::sort(in_zone.begin(), in_zone.end());
    std::vector<Corner_id> candidates;
    for (const Corner_id c : whole_.corners.corners.ids()) {
      const auto& legs = whole_.corners.corner(c).legs;
      if (!legs.empty() &&
          std::binary_search(in_zone.begin(), in_zone.end(), whole_.corners.leg(legs.front()).apex_vertex))
        candidates.push_back(c);
    }
    const std::vector<Block_id> owners =
        corners_.owners(candidates, [&](Triangle_id t) { return block_of[t]; });
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (!owners[i].is_valid()) continue;
      const std::size_t b = owners[i].value();
      if (b >= work.begin && b < work.begin + work.owned.size())
        work.owned[b - work.begin].push_back(candidates[i]);
    }
  }

  // ---- the work of a round

  template <class Continue>
  void work(const Shared_work& round, const Continue& shall_go_on) {
    const std::size_t n = round.own.size();
    const Block_work<Geometry> work(whole_.problem, finishing_,
                                    is_first_round() ? finishing_.thinnings_of_blocks : 0);
    const std::size_t room = vertex_budget_ - std::min(vertex_budget_, whole_.mesh.number_of_vertices());
    Block_assignment assignment = assignment_of(round);
    whole_.bulk.forget_handles();
    std::vector<std::unique_ptr<Block>> blocks(n);
    std::vector<std::vector<Triangle_id>> left(n);
    triangles_done_ = 0, triangles_of_round_ = round.own.members.size();
    agree_on_work(exchange_, [&] { // the user's functions may throw
      Executor<ConcurrencyTag>::run(n, [&](std::size_t b) {
        blocks[b] = std::make_unique<Block>(whole_.mesh, assignment, static_cast<Block_id>(round.begin + b),
                                            round.own[b], Kernel_mesh<Geometry>());
        left[b] = work.run(*blocks[b], round.owned[b], room / round.number_of_blocks, shall_go_on);
        auto& mesh = blocks[b]->mesh;
        mesh = Kernel_mesh<Geometry>(std::as_const(mesh)); // without room, as all blocks are kept
        triangles_done_ += round.own[b].size();
      });
    });
    name_new(round, blocks);
    std::vector<Corner_id> corners;
    std::vector<Triangle_id> left_by_all;
    Made made;
    for (std::size_t b = 0; b < n; ++b) {
      Block& block = *blocks[b];
      block.write(whole_.mesh);
      work.name_in_whole(block, round.owned[b]);
      corners.insert(corners.end(), round.owned[b].begin(), round.owned[b].end());
      for (const Triangle_id t : left[b]) left_by_all.push_back(block.whole_triangle(t));
      if (is_first_round())
        keep(block);
      else
        made.add(block);
      block.release();
    }
    if (!is_first_round()) tell(made);
    give_back_free_memory(); // that of blocks
    corners_.tell(corners);
    tell_fans_and_dead(blocks);
    rounds_.waiting = tell_all(exchange_, left_by_all);
    put_together(blocks);
  }

  /// Of what is in this part's blocks.
  Block_assignment assignment_of(const Shared_work& round) const {
    Block_assignment assignment = Block_assignment::for_few(whole_.mesh);
    for (std::size_t b = 0; b < round.own.size(); ++b) {
      const Span<Triangle_id> triangles = round.own[b];
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        assignment.set(triangles[i], {static_cast<Block_id>(round.begin + b), static_cast<Triangle_id>(i)});
        for (const Vertex_id v : whole_.mesh.triangle(triangles[i]).v) assignment.vertex_in_block(v) = {};
      }
    }
    return assignment;
  }

  /// Blocks get their handles in the order of all blocks.
  void name_new(const Shared_work& round, const std::vector<std::unique_ptr<Block>>& blocks) {
    std::vector<Growth> own;
    for (const auto& block : blocks)
      own.push_back({static_cast<std::uint32_t>(block->number_of_new_triangles()),
                     static_cast<std::uint32_t>(block->number_of_new_vertices())});
    std::size_t triangles = whole_.mesh.triangles.size(), vertices = whole_.mesh.number_of_vertices();
    std::size_t b = 0;
    for (const Growth& growth : tell_all(exchange_, own)) {
      if (b >= round.begin && b < round.begin + blocks.size())
        blocks[b - round.begin]->name_new(static_cast<Triangle_id>(triangles),
                                          static_cast<Vertex_id>(vertices));
      triangles += growth.triangles, vertices += growth.vertices, ++b;
    }
    held_.resize(vertices, triangles);
  }

  /// After the first round: what a part has made is its own.
  void keep(const Block& block) {
    for (const Triangle_id t : block.mesh.triangles.ids())
      if (block.mesh.is_alive(t))
        held_.set_private(block.whole_triangle(t));
      else if (block.whole_triangle(t).is_valid())
        held_.set_absent(block.whole_triangle(t));
    for (const Vertex_id v : block.mesh.points.ids())
      if (block.whole_vertex(v).is_valid()) held_.set_has(block.whole_vertex(v));
  }

  /// In a zone: all get what a part has made of its blocks.
  void tell(const Made& made) {
    for (const Vertex_id v : made.vertices) held_.set_has(v);
    held_.tell(made.triangles, made.vertices);
  }

  /// What several blocks may write: the last of them decides.
  void tell_fans_and_dead(const std::vector<std::unique_ptr<Block>>& blocks) {
    std::vector<Fan> fans;
    std::vector<Triangle_id> dead;
    for (const auto& block : blocks) {
      fans.insert(fans.end(), block->fans().begin(), block->fans().end());
      dead.insert(dead.end(), block->dead().begin(), block->dead().end());
    }
    const auto write = [this](const std::vector<Fan>& all) {
      for (const Fan& f : all) whole_.mesh.triangle_of[f.vertex] = f.triangle;
    };
    if (is_first_round()) {
      write(fans);
      fans = last_fans_of_common_vertices(fans);
    } else {
      dead = tell_all(exchange_, dead);
    }
    write(tell_all(exchange_, fans));
    for (const Triangle_id t : dead) held_.set_absent(t), whole_.mesh.kill(t);
    if (!is_first_round()) return;
    own_dead_ = whole_.mesh.dead_triangles().size();
    std::vector<Vertex_id> of_corners;
    for (const Vertex_id v : corners_.vertices())
      if (held_.has(v)) of_corners.push_back(v);
    held_.tell({}, of_corners);
  }

  /// One for each vertex that others have too, if a block of this part has one. What the whole mesh knew before may be
  /// a triangle that is another part's now.
  /// \param fans of this part's blocks, which are written
  std::vector<Fan> last_fans_of_common_vertices(const std::vector<Fan>& fans) const {
    std::vector<Vertex_id> in_blocks;
    for (const Fan& f : fans) in_blocks.push_back(f.vertex);
    std::sort(in_blocks.begin(), in_blocks.end());
    std::vector<Fan> found;
    for (const Vertex_id v : held_.common_vertices())
      if (std::binary_search(in_blocks.begin(), in_blocks.end(), v))
        found.push_back({v, whole_.mesh.incident_triangle(v)});
    return found;
  }

  /// The triangles at seams, and those beyond that were in no block. With them goes what will be in the second zone.
  void share_both_sides_of(const std::vector<Seam>& halves) {
    const auto word = [](Side s) { return 4 * std::int64_t(s.triangle().value()) + s.slot(); };
    std::vector<std::int64_t> here;
    std::vector<Triangle_id> at_seams;
    for (const Seam& seam : halves) here.push_back(word(seam.here)), at_seams.push_back(seam.now.triangle());
    std::sort(here.begin(), here.end());
    for (const auto& [side, beyond, now] : halves) {
      if (std::binary_search(here.begin(), here.end(), word(beyond))) continue;
      at_seams.push_back(beyond.triangle());
      // It is about to be linked. Until then it names a triangle that may be elsewhere in the block by now.
      if (held_.is_held(beyond.triangle()))
        whole_.mesh.triangle(beyond.triangle()).side[beyond.slot()] = Side::border();
    }
    at_seams.insert(at_seams.end(), rounds_.waiting.begin(), rounds_.waiting.end());
    held_.publish(held_.private_around(at_seams, is_first_round() ? 2 : 1));
  }

  /// All parts link the same seams, and flip the same sides.
  void put_together(const std::vector<std::unique_ptr<Block>>& blocks) {
    std::vector<Seam> own;
    for (const auto& block : blocks) own.insert(own.end(), block->seams().begin(), block->seams().end());
    const std::vector<Seam> halves = tell_all(exchange_, own);
    share_both_sides_of(halves);
    auto& mesh = whole_.mesh;
    const std::vector<Side> sides = link_seams<ConcurrencyTag>(mesh, halves);
    rounds_.at_seams = triangles_at<ConcurrencyTag>(mesh, sides);
    std::vector<Side> doubtful = sides_to_flip<ConcurrencyTag>(mesh, sides);
    mesh.make_Delaunay(
        doubtful,
        [this](Triangle_id t, Triangle_id u) {
          for (const Triangle_id flipped : {t, u})
            if (whole_.is_suspect(flipped)) rounds_.waiting.push_back(flipped);
        },
        [&](Side s) {
          const Side o = mesh.across(s);
          if (!o.is_border()) held_.require({o.triangle()}, rings_for_flips);
        });
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_ROUNDS_OF_PARTS_H
