// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Follows the rounds of Block_refinement.h, and counts what they would send if each of P parts of the mesh were in a
// memory of its own. Parts have no influence on the mesh, whatever their number.
//
// What belongs to whom: Part_owners.h. The record of an acute corner is where the triangle is that the mesh knows at
// its apex. In a round after the first, superstep by superstep:
//
//   corner requests   each part asks for the corners for which its triangles may wait
//   corner marks      who has the corner's record marks its triangles
//   marks             for each ring of the zone, the last one too: a triangle in the zone marks what is beyond its
//                     sides, unless that is known to have been marked in an earlier ring
//   sum of squares    how many squares the zone is cut into, which share the budget
//   square counts     who has triangles in a square tells the lowest part that has some
//   square workers    that part answers who works on it: who has most of its triangles; of several, the lowest part
//   future owners     who is to send a triangle tells its neighbors where it goes
//   triangles         go to the worker, with each vertex once for each sender and square, with who will be their
//                     neighbors, and with the corners whose records are there. They stay with the worker, and so do
//                     those that it makes of them.
//   seams             halves of seams, both ways where two blocks meet. Beyond others nothing was worked on. That
//                     triangle's half goes the other way: it has been marked as if there were one more ring.
//   flips             of two triangles on whose common side a flip is due, that of the higher part goes to the lower,
//                     with its apex. Those that have another neighbor then are told. Flips that follow from others
//                     are counted in the same superstep. Corners follow their apex's triangle.
//   names             a scan of what is new, of triangles and vertices, and the sum of what waits
//
// The first round needs none of these before the seams.
//
// These are the messages of the rounds alone. Not modeled are: the first triangulation, the domain, the search for
// corners, the bulk of squares, and what follows on the rounds in the whole mesh, of which a distributed mesher needs
// other forms; how parts find out on which side of a square's border others have triangles, and so where squares end;
// how they find the part with a corner's record, and the triangles of a corner which that does not have; the records
// of input edges, whose ends a worker needs; and more supersteps where one flip follows from another.
//
// O(n) time for each round with n triangles, all by one thread.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARTS_PART_LEDGER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARTS_PART_LEDGER_H

#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/parts/Counted_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/parts/Part_owners.h>
#include <CGAL/Quadtree_mesh_2/internal/parts/Part_records.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Corner_places.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// For `Block_refinement`, whose rounds it has to see from the first one on.
class Part_ledger {
public:
  using Holdings = Part_owners::Holdings;

  /// What is of interest in a round that is over.
  struct Round {
    std::size_t blocks = 0;
    std::size_t triangles_worked_on = 0;
    Holdings before_work, after; ///< with what was received
  };

  /// \pre there is at least one part
  explicit Part_ledger(std::size_t parts) : exchange_(parts) {}

  const Counted_exchange& exchange() const { return exchange_; }
  const Part_owners& owners() const { return owners_; }
  const std::vector<Round>& rounds() const { return rounds_; }

  // ---- what the rounds call

  template <class Geometry, class Zone>
  void zone_is_found(const Meshing_state<Geometry>& whole, const Zone& zone,
                     const std::vector<Triangle_id>& waiting) {
    const int round = static_cast<int>(rounds_.size()) + 1;
    ask_for_corners(whole, waiting, round);
    mark_rings(whole.mesh, zone, round);
  }

  template <class Geometry, class Blocks>
  void blocks_are_cut(const Meshing_state<Geometry>& whole, const Blocks& blocks, int round) {
    rounds_.resize(static_cast<std::size_t>(round));
    now().blocks = blocks.size();
    now().triangles_worked_on = blocks.cut().members.size();
    if (round == 1) begin(whole, blocks);
    new_of_block_.assign(blocks.size(), {});
    worker_.resize(blocks.size());
    for (const Block_id b : worker_.ids()) { // there are blocks without triangles, in which nothing is done
      const auto triangles = blocks.cut()[b.value()];
      worker_[b] = triangles.size() == 0 ? Part_id(0) : owners_[triangles[0]];
    }
    if (round > 1) {
      exchange_.sum(round, Superstep_kind::SUM_OF_SQUARES, 1);
      choose_workers(blocks.cut());
      tell_future_owners(whole.mesh, blocks.cut());
      send_triangles(whole, blocks);
    }
    now().before_work = owners_.holdings(whole.mesh, exchange_.number_of_parts());
  }

  template <class Block>
  void is_written(const Block& block) {
    const std::size_t n = block.number_of_new_triangles();
    if (n == 0) return;
    new_of_block_[block.id()] = {block.first_new_triangle(), n};
  }

  template <class Geometry, class Blocks>
  void are_written(const Meshing_state<Geometry>& whole, const Blocks& blocks) {
    owners_.cover(whole.mesh.triangles.size());
    for (const Block_id b : worker_.ids())
      for (std::size_t i = 0; i < new_of_block_[b].number; ++i)
        owners_.give(static_cast<Triangle_id>(new_of_block_[b].first.value() + i), worker_[b]);
    for (const Block_id b : worker_.ids())
      for (const auto& seam : blocks.seams_of(b)) {
        const Triangle_id beyond = seam.beyond.triangle();
        exchange_.send<Seam_half>(worker_[b], owners_[beyond]);
        if (!blocks.block_of(beyond).is_valid()) exchange_.send<Seam_half>(owners_[beyond], worker_[b]);
      }
    end_superstep(Superstep_kind::SEAMS);
  }

  /// \pre t = (a, b, d) and u = (a, d, c) were (a, b, c) and (b, d, c), or the like
  template <class Geometry>
  void is_flipped(const Meshing_state<Geometry>& whole, Triangle_id t, Triangle_id u) {
    const Part_id p = owners_[t], q = owners_[u], flips = std::min(p, q), gives = std::max(p, q);
    send_triangle(whole.mesh, p == gives ? t : u, flips);
    exchange_.send<Vertex_record>(gives, flips);
    owners_.give(t, flips), owners_.give(u, flips);
    for (const Side s : {Side(t, 0), Side(t, 2), Side(u, 0), Side(u, 1)}) {
      const Side o = whole.mesh.across(s);
      if (!o.is_border()) exchange_.send<New_link>(flips, owners_[o.triangle()]);
    }
  }

  template <class Geometry>
  void round_is_over(const Meshing_state<Geometry>& whole) {
    move_corners(whole, [&](Triangle_id t) { return owners_[t]; });
    end_superstep(Superstep_kind::FLIPS);
    constexpr std::size_t numbers = 3;
    exchange_.sum(round(), Superstep_kind::NAMES, numbers);
    now().after = owners_.holdings(whole.mesh, exchange_.number_of_parts());
  }

private:
  struct New_triangles {
    Triangle_id first;
    std::size_t number = 0;
  };

  Counted_exchange exchange_;
  Part_owners owners_;
  std::vector<Round> rounds_;
  Indexed_vector<Corner_id, Part_id> holder_; // of the record
  Indexed_vector<Block_id, Part_id> worker_;  // of this round's blocks
  Indexed_vector<Block_id, New_triangles> new_of_block_;

  Round& now() { return rounds_.back(); }
  int round() const { return static_cast<int>(rounds_.size()); }
  void end_superstep(Superstep_kind kind) { exchange_.end_superstep(round(), kind); }

  template <class Geometry, class Blocks>
  void begin(const Meshing_state<Geometry>& whole, const Blocks& blocks) {
    owners_.divide(whole, blocks, exchange_.number_of_parts());
    holder_.resize(whole.corners.corners.size());
    for (const Corner_id c : holder_.ids()) {
      const Triangle_id t = triangle_at_apex(whole, c);
      holder_[c] = t.is_valid() ? owners_[t] : Part_id(0);
    }
  }

  /// The one that the mesh knows there, if there is one.
  template <class Geometry>
  static Triangle_id triangle_at_apex(const Meshing_state<Geometry>& whole, Corner_id c) {
    return whole.mesh.incident_triangle(whole.corners.corner(c).apex);
  }

  template <class Geometry>
  void ask_for_corners(const Meshing_state<Geometry>& whole, const std::vector<Triangle_id>& waiting,
                       int round) {
    const Corner_places<Sequential_tag, Geometry> places(whole);
    Indexed_vector<Part_id, std::vector<Triangle_id>> waiting_of(exchange_.number_of_parts());
    for (const Triangle_id t : waiting) waiting_of[owners_[t]].push_back(t);
    std::vector<Corner_id> asked_for;
    for (const Part_id p : waiting_of.ids())
      for (const Corner_id c : places.corners_of(waiting_of[p])) {
        exchange_.send<Corner_request>(p, holder_[c]);
        asked_for.push_back(c);
      }
    exchange_.end_superstep(round, Superstep_kind::CORNER_REQUESTS);
    sort_and_drop_equal(asked_for);
    for (const Corner_id c : asked_for) {
      std::vector<Triangle_id> triangles = places.triangles_of(c);
      sort_and_drop_equal(triangles);
      for (const Triangle_id t : triangles) exchange_.send<Zone_mark>(holder_[c], owners_[t]);
    }
    exchange_.end_superstep(round, Superstep_kind::CORNER_MARKS);
  }

  template <class Geometry, class Zone>
  void mark_rings(const Kernel_mesh<Geometry>& mesh, const Zone& zone, int round) {
    using Ring = std::uint8_t; // one for each triangle of the mesh
    const auto outside = static_cast<Ring>(zone.number_of_rings());
    Indexed_vector<Triangle_id, Ring> ring_of(mesh.triangles.size(), outside);
    for (Ring r = 0; r < outside; ++r)
      for (const Triangle_id t : zone.ring(r)) ring_of[t] = r;
    for (Ring r = 0; r < outside; ++r) {
      for (const Triangle_id t : zone.ring(r))
        for (const Side o : mesh.triangle(t).side)
          if (!o.is_border() && ring_of[o.triangle()] >= r)
            exchange_.send<Zone_mark>(owners_[t], owners_[o.triangle()]);
      exchange_.end_superstep(round, Superstep_kind::MARKS);
    }
  }

  void choose_workers(const Block_cut& cut) {
    std::map<Part_id, std::size_t> triangles_of;
    std::vector<std::pair<Part_id, Part_id>> asked; // and who asks
    for (const Block_id b : worker_.ids()) {
      triangles_of.clear();
      for (const Triangle_id t : cut[b.value()]) ++triangles_of[owners_[t]];
      if (triangles_of.empty()) continue;
      const Part_id lowest = triangles_of.begin()->first;
      worker_[b] = lowest;
      for (const auto& [p, n] : triangles_of) {
        if (n > triangles_of[worker_[b]]) worker_[b] = p;
        if (p == lowest) continue;
        exchange_.send<Square_count>(p, lowest);
        asked.emplace_back(lowest, p);
      }
    }
    end_superstep(Superstep_kind::SQUARE_COUNTS);
    for (const auto& [lowest, p] : asked) exchange_.send<Square_worker>(lowest, p);
    end_superstep(Superstep_kind::SQUARE_WORKERS);
  }

  template <class Geometry>
  void tell_future_owners(const Kernel_mesh<Geometry>& mesh, const Block_cut& cut) {
    for (const Block_id b : worker_.ids())
      for (const Triangle_id t : cut[b.value()]) {
        if (owners_[t] == worker_[b]) continue;
        for (const Side o : mesh.triangle(t).side)
          if (!o.is_border()) exchange_.send<Future_owner>(owners_[t], owners_[o.triangle()]);
      }
    end_superstep(Superstep_kind::FUTURE_OWNERS);
  }

  template <class Blocks>
  Part_id future_owner(const Blocks& blocks, Triangle_id t) const {
    const Block_id b = blocks.block_of(t);
    return b.is_valid() ? worker_[b] : owners_[t];
  }

  template <class Geometry>
  void send_triangle(const Kernel_mesh<Geometry>& mesh, Triangle_id t, Part_id to) {
    exchange_.send<Triangle_record>(owners_[t], to);
    if (!mesh.region_of.empty()) exchange_.send<Region_record>(owners_[t], to);
  }

  template <class Geometry, class Blocks>
  void send_triangles(const Meshing_state<Geometry>& whole, const Blocks& blocks) {
    for (const Block_id b : worker_.ids()) {
      std::vector<std::pair<Part_id, Vertex_id>> vertices;
      for (const Triangle_id t : blocks.cut()[b.value()]) {
        if (owners_[t] == worker_[b]) continue;
        send_triangle(whole.mesh, t, worker_[b]);
        for (const Side o : whole.mesh.triangle(t).side) {
          if (o.is_border() || blocks.block_of(o.triangle()) == b) continue;
          const Part_id beyond = future_owner(blocks, o.triangle());
          if (beyond != owners_[t] && beyond != worker_[b])
            exchange_.send<Owner_beyond>(owners_[t], worker_[b]);
        }
        for (const Vertex_id v : whole.mesh.triangle(t).v) vertices.emplace_back(owners_[t], v);
      }
      sort_and_drop_equal(vertices);
      for (const auto& [p, v] : vertices) exchange_.send<Vertex_record>(p, worker_[b]);
    }
    move_corners(whole, [&](Triangle_id t) { return future_owner(blocks, t); });
    end_superstep(Superstep_kind::TRIANGLES);
    for (const Block_id b : worker_.ids())
      for (const Triangle_id t : blocks.cut()[b.value()]) owners_.give(t, worker_[b]);
  }

  /// Sends corners to where the triangles at their apexes are.
  template <class Geometry, class Part_of>
  void move_corners(const Meshing_state<Geometry>& whole, const Part_of& part_of) {
    for (const Corner_id c : holder_.ids()) {
      const Triangle_id t = triangle_at_apex(whole, c);
      if (!t.is_valid()) continue;
      const Part_id from = std::exchange(holder_[c], part_of(t));
      if (from != holder_[c]) send_corner(whole.corners, c, from);
    }
  }

  template <class Geometry>
  void send_corner(const Acute_corners<Geometry>& corners, Corner_id c, Part_id from) {
    const auto& corner = corners.corner(c);
    const Part_id to = holder_[c];
    exchange_.send<Corner_record>(from, to);
    exchange_.send<Leg_record>(from, to, corner.legs.size());
    exchange_.send<Sector_record>(from, to, corner.sectors.size());
    for (const Leg_id l : corner.legs) {
      const auto& shells = corners.leg(l).shells;
      exchange_.send<Shell_record>(from, to,
                                   static_cast<std::size_t>(std::distance(shells.begin(), shells.end())));
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARTS_PART_LEDGER_H
