// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Refinement and guarded removal by blocks, in parallel.
//
// 1. The mesh is cut into blocks (Mesh_blocks.h). Each is refined (Refiner.h) and coarsened (Remover.h) on
//    its own. Bad triangles that need something beyond a seam wait, and so do vertices at seams.
// 2. The surroundings of the seams and of waiting triangles are cut into blocks once more, with squares
//    shifted, and treated in the same way.
//
// What is left then lies near seams of both rounds. The caller finishes it in the whole mesh. Blocks are the
// same for any number of threads, and so is the result. O(n) work in addition to refinement. The two rounds
// do all but a few hundredths of it.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_BLOCK_REFINEMENT_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_BLOCK_REFINEMENT_H

#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/finish_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Mesh_blocks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Geometry>
class Block_refinement {
public:
  using Block = Mesh_block<Geometry>;
  using Blocks = Mesh_blocks<ConcurrencyTag, Geometry>;
  using Corners = Acute_corners<Geometry>;
  using Leg = typename Corners::Leg;
  using Sector = typename Corners::Sector;
  using Corner = typename Corners::Corner;
  using Corners_of_blocks = Indexed_vector<Block_id, std::vector<Corner_id>>;

  static constexpr std::size_t block_size = Block_sizes<ConcurrencyTag>::triangles;
  /// The zone is a network, of which squares cut little; and it is small.
  static constexpr std::size_t zone_block_size = block_size / 6;

  Block_refinement(Meshing_state<Geometry>& whole, const Finishing& finishing, std::size_t vertex_budget)
      : whole_(whole), finishing_(finishing), vertex_budget_(vertex_budget) {}

  /// Works off what can be done in blocks; the rest is left on the worklist of the whole mesh. `shall_go_on()` may be
  /// called by several threads at once.
  /// \returns false if the mesh is too small for blocks, and nothing was done.
  template <class Continue>
  bool run(const Continue& shall_go_on) {
    if (whole_.mesh.number_of_triangles() - whole_.bulk.number_of_triangles() < 2 * block_size) return false;
    {
      Blocks blocks(whole_.mesh, first_cut());
      work(blocks, shall_go_on);
    }
    std::vector<Triangle_id> zone = zone_of_seams();
    if (zone.empty()) return true;
    Blocks blocks(whole_.mesh, cut_by_position<ConcurrencyTag>(whole_.mesh, std::move(zone), zone_block_size,
                                                               Square_shift::THIRD_OF_ROOT));
    work(blocks, shall_go_on);
    return true;
  }

private:
  /// How far from a seam triangles are worked on again, in triangles.
  static constexpr int rings_of_zone = 2;

  Meshing_state<Geometry>& whole_;
  Finishing finishing_;
  std::size_t vertex_budget_;
  std::vector<Triangle_id> near_seams_;

  Block_cut first_cut() const {
    if (whole_.bulk.has_border)
      return cut_by_position<ConcurrencyTag>(whole_.mesh, triangles_outside_bulk(), block_size,
                                             Square_shift::NONE);
    return cut_by_input_order<ConcurrencyTag>(whole_.mesh, whole_.problem.input_points.size(), block_size,
                                              [&](Edge_id e) { return whole_.edges[e].a; });
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

  template <class Continue>
  void work(Blocks& blocks, const Continue& shall_go_on) {
    const Corners_of_blocks owned = corners_by_block(blocks);
    Indexed_vector<Block_id, std::vector<Triangle_id>> left(blocks.size());
    const std::size_t room = vertex_budget_ - std::min(vertex_budget_, whole_.mesh.number_of_vertices());
    blocks.for_each(
        [&](Block& block) {
          const Block_id b = block.id();
          left[b] = work(block, owned[b], room / blocks.size(), shall_go_on);
        },
        [&](const Block& block) {
          const Block_id b = block.id();
          name_corner_vertices(owned[b], [&](Vertex_id v) { return block.whole_vertex(v); });
          for (Triangle_id& t : left[b]) t = block.whole_triangle(t);
        });
    blocks.put_together();
    near_seams_.clear();
    for (const auto& triangles : left)
      for (const Triangle_id t : triangles) {
        if (!whole_.mesh.is_alive(t)) continue;
        whole_.push(t);
        near_seams_.push_back(t);
      }
    for (const Side s : blocks.seam_sides())
      near_seams_.push_back(s.triangle()), near_seams_.push_back(whole_.mesh.across(s).triangle());
    whole_.doubtful_sides = blocks.sides_to_flip();
    whole_.legalize();
  }

  /// Refines a block and thins it out; returns the triangles left.
  template <class Continue>
  std::vector<Triangle_id> work(Block& block, const std::vector<Corner_id>& owned, std::size_t room,
                                const Continue& shall_go_on) {
    name_corner_vertices(owned, [&](Vertex_id v) { return block.vertex_in_block(v); });
    Meshing_state<Geometry> state(whole_.problem, owned);
    std::swap(state.mesh, block.mesh);
    Splitter<Geometry> splitter(state);
    Refiner<Geometry> refiner(state, splitter);
    refiner.push_all();
    refiner.run({state.mesh.number_of_vertices() + room}, shall_go_on);
    finish_mesh(state, finishing_, shall_go_on);
    std::swap(state.mesh, block.mesh);
    std::vector<Triangle_id> left = std::move(state.deferred);
    while (!state.worklist.is_empty()) left.push_back(state.worklist.pop());
    return left;
  }

  // ---- corners

  /// For each block the acute corners it owns: all pieces of their legs within the ring and all locked chords have
  /// both their triangles in the block, and so have the Steiner vertices on the legs all of theirs.
  Corners_of_blocks corners_by_block(const Blocks& blocks) const {
    const auto& corners = whole_.corners.corners;
    Indexed_vector<Corner_id, Block_id> owner(corners.size());
    for_each_index<ConcurrencyTag>(
        corners.size(),
        [&](std::size_t i) {
          const Corner_id c = static_cast<Corner_id>(i);
          owner[c] = owner_of(corners[c], blocks);
        },
        64);
    Corners_of_blocks owned(blocks.size());
    for (const Corner_id c : owner.ids())
      if (owner[c].is_valid()) owned[owner[c]].push_back(c);
    return owned;
  }

  Block_id owner_of(const Corner& corner, const Blocks& blocks) const {
    Block_id owner = unknown;
    for (const Leg_id l : corner.legs) {
      const Leg& leg = whole_.corners.leg(l);
      Vertex_id before = leg.apex_vertex;
      for (const auto& [radius, v] : leg.shells) {
        static_cast<void>(radius);
        if (!whole_.mesh.is_used(v)) continue;
        own_side(before, v, blocks, owner);
        if (!whole_.mesh.is_input(v)) own_star(v, blocks, owner);
        before = v;
      }
      if (before == leg.apex_vertex) return {}; // a leg that could not be cut: nothing can be said
    }
    for (const Sector_id s : corner.sectors) own_chord(whole_.corners.sector(s), blocks, owner);
    return owner == unknown ? Block_id() : owner;
  }

  static constexpr Block_id unknown{0xfffffffeu};

  /// Makes the block of t the owner, or nobody if another one is.
  static void own(Triangle_id t, const Blocks& blocks, Block_id& owner) {
    const Block_id b = blocks.block_of(t);
    owner = owner == unknown || owner == b ? b : Block_id();
  }
  void own_side(Vertex_id x, Vertex_id y, const Blocks& blocks, Block_id& owner) const {
    const Side s = whole_.side_between(x, y);
    if (s.is_border()) {
      owner = {};
      return;
    }
    own(s.triangle(), blocks, owner);
    const Side o = whole_.mesh.across(s);
    if (!o.is_border()) own(o.triangle(), blocks, owner);
  }
  void own_star(Vertex_id v, const Blocks& blocks, Block_id& owner) const {
    whole_.mesh.for_each_triangle_at(v, [&](Triangle_id t, int) { own(t, blocks, owner); });
  }
  void own_chord(const Sector& sector, const Blocks& blocks, Block_id& owner) const {
    if (sector.lock_radius <= 0) return;
    constexpr double same_radius = 1e-9; // of the radius: shells of other radii are much further apart
    const auto at_lock = [&](Leg_id l) {
      using std::fabs;
      for (const auto& [radius, v] : whole_.corners.leg(l).shells)
        if (fabs(radius - sector.lock_radius) <= same_radius * sector.lock_radius) return v;
      return whole_.corners.leg(l).ring;
    };
    const Vertex_id x = at_lock(sector.right), y = at_lock(sector.left);
    if (x.is_valid() && y.is_valid() && x != y) own_side(x, y, blocks, owner);
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

  // ---- the zone of the second round

  std::vector<Triangle_id> zone_of_seams() const {
    const Kernel_mesh<Geometry>& mesh = whole_.mesh;
    Indexed_vector<Triangle_id, char> is_in_zone(mesh.triangles.size(), 0);
    std::vector<Triangle_id> zone;
    const auto add = [&](Triangle_id t) {
      if (!t.is_valid() || is_in_zone[t] != 0 || !mesh.is_alive(t)) return;
      is_in_zone[t] = 1;
      zone.push_back(t);
    };
    for (const Triangle_id t : near_seams_) add(t);
    std::size_t begin = 0;
    for (int ring = 0; ring < rings_of_zone; ++ring) {
      const std::size_t end = zone.size();
      for (; begin < end; ++begin)
        for (const Side o : mesh.triangle(zone[begin]).side)
          if (!o.is_border()) add(o.triangle());
    }
    return zone;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_BLOCK_REFINEMENT_H
