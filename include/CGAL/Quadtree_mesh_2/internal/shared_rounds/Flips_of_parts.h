// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Makes a mesh that parts hold exactly constrained Delaunay.
//
// Computes: the same bits as in one memory (Exact_legalizer.h), for any number of parts, and for each part the account
//           of its triangles.
// Bound:    O(n + c log c) for the n handles of the whole mesh and the c triangles that flips read. What is shared are
//           the triangles at which parts meet, and those that flips from there come to.
// Method:   most flips are single ones, far from what others have. Each part makes these by itself (Lone_flips.h). The
//           others are made by all parts, in the order of one memory. Before a triangle is read that is not shared, all
//           share it; its part first undoes its own flips there that come later in that order, and leaves them to all.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_FLIPS_OF_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_FLIPS_OF_PARTS_H

#include <CGAL/Quadtree_mesh_2/internal/distributed/tell_all.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Exact_legalizer.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Held_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Lone_flips.h>

#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Exchange, class Geometry>
class Flips_of_parts {
public:
  using Held = Held_mesh<Exchange, Geometry>;

  Flips_of_parts(Exchange& exchange, Held& held, Meshing_state<Geometry>& whole)
      : exchange_(exchange), held_(held), mesh_(whole.mesh), legalizer_(whole),
        lone_(held, whole, legalizer_, account_) {}

  /// All parts call it. Triangles that flips make suspect are on the worklists of all then.
  /// \returns the account of the triangles that this part speaks for: the sum over all parts is that of the mesh.
  /// Counts of angles may be negative at one part, which unsigned ones are by modulus.
  Triangle_account run() {
    held_.unshare();
    share_front();
    auto found = legalizer_.find([this](Triangle_id t) { return held_.speaks_for(t); });
    account_ = std::move(found.account);
    lone_.forbid(vertices_of_several());
    add_to_pending(lone_.run(found.doubtful));
    flip_pending();
    legalizer_.drop_cured(account_.suspects);
    return std::move(account_);
  }

private:
  /// How many rings are shared around sides that all parts flip, and around triangles that flips come to from there.
  static constexpr int rings_of_flips = 1, rings_of_spread = 3;

  /// Watches the flips that all parts make (Any_flips). What a flip writes beside its two triangles has two of their
  /// vertices. So a part has undone its own flips there by then.
  struct Shared_flips : Any_flips {
    Flips_of_parts& parts;
    Side from;

    Shared_flips(Flips_of_parts& p, Side s) : parts(p), from(s) {}
    bool may_look(Side s) {
      parts.share_both_sides(s, from);
      return true;
    }
  };

  Exchange& exchange_;
  Held& held_;
  Kernel_mesh<Geometry>& mesh_;
  Exact_legalizer<ConcurrencyTag, Geometry> legalizer_;
  Triangle_account account_;
  Lone_flips<ConcurrencyTag, Held, Geometry> lone_;
  std::set<Side, Side_is_before> pending_; // for all parts to flip; the same at all

  /// Whoever speaks for a triangle holds those next to it then. \pre nothing is shared
  void share_front() {
    std::vector<Triangle_id> front;
    for (const Triangle_id t : mesh_.triangles.ids())
      if (held_.is_private(t))
        for (const Side o : mesh_.triangle(t).side)
          if (!o.is_border() && !held_.is_held(o.triangle())) front.push_back(t);
    held_.publish(front);
  }

  /// Those that other parts may have: at shared triangles, or where two pieces of the domain merely touch. Some of the
  /// latter are elsewhere.
  std::vector<Vertex_id> vertices_of_several() {
    std::vector<Vertex_id> vertices = tell_all(exchange_, held_.common_vertices());
    for (const Triangle_id t : mesh_.triangles.ids())
      if (held_.is_shared(t))
        vertices.insert(vertices.end(), std::begin(mesh_.triangle(t).v), std::end(mesh_.triangle(t).v));
    return vertices;
  }

  /// Each part has others to add. All parts call it.
  void add_to_pending(const std::vector<Side>& sides) {
    for (const Side s : tell_all(exchange_, sides)) pending_.insert(s);
  }

  /// All parts flip the same sides, in the order of one memory.
  void flip_pending() {
    while (publish_around(held_at_pending(), rings_of_flips, nullptr) > 0) {
    }
    Triangle_account of_flips;
    for (auto next = pending_.begin(); next != pending_.end();) {
      const Side from = *next;
      Shared_flips shared(*this, from);
      legalizer_.flip_from(from, of_flips, shared);
      next = pending_.upper_bound(from);
    }
    if (exchange_.rank() == 0) account_.angles.add(of_flips.angles);
    for (const Triangle_id t : of_flips.suspects)
      if (held_.speaks_for(t)) account_.suspects.push_back(t);
  }

  /// The triangles on both sides of those that are pending, as far as they are held.
  std::vector<Triangle_id> held_at_pending() const {
    std::vector<Triangle_id> triangles;
    for (const Side s : pending_) {
      if (!held_.is_held(s.triangle())) continue;
      triangles.push_back(s.triangle());
      const Side o = mesh_.across(s);
      if (!o.is_border() && held_.is_held(o.triangle())) triangles.push_back(o.triangle());
    }
    return triangles;
  }

  /// \param from the pending side that is worked on, the same at all parts
  void share_both_sides(Side s, Side from) {
    share(s.triangle(), from);
    const Side o = mesh_.across(s);
    if (!o.is_border()) share(o.triangle(), from);
  }
  void share(Triangle_id t, Side from) {
    if (!held_.is_shared(t)) publish_around({t}, rings_of_spread, &from);
  }

  /// Shares the private ones of some triangles and of rings around them, after undoing this part's own flips there from
  /// sides after `after`, or from any if that is null. Such sides are pending then.
  /// \returns how many all parts have shared
  std::size_t publish_around(const std::vector<Triangle_id>& triangles, int rings, const Side* after) {
    std::vector<Triangle_id> around;
    std::vector<Side> taken_back;
    for (bool is_done = false; !is_done;) {
      around = held_.private_around(triangles, rings);
      std::vector<Vertex_id> vertices;
      for (const Triangle_id t : around)
        vertices.insert(vertices.end(), std::begin(mesh_.triangle(t).v), std::end(mesh_.triangle(t).v));
      const std::vector<Side> sides = lone_.take_back_at(vertices, after);
      taken_back.insert(taken_back.end(), sides.begin(), sides.end());
      is_done = sides.empty();
    }
    add_to_pending(taken_back);
    return held_.publish(around);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_FLIPS_OF_PARTS_H
