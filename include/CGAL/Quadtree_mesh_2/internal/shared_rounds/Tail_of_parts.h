// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What follows on rounds that leave nothing, of a mesh that parts hold: sectors of acute corners are unlocked, vertices
// that rounds had at their seams are removed, and the mesh is made exactly constrained Delaunay.
//
// Computes: the same bits as in one memory (Splitter::unlock_all(), Remover.h, Exact_legalizer.h), for any number of
//           parts, and for each part the account of its triangles.
// Bound:    O(n + c log c) for the n handles of the whole mesh and the c triangles that change, or are next to those
//           that do. These are shared, some thousands at a time, and each part changes all of them. Some messages more
//           for each time that changes come to triangles that are not shared yet.
// Method:   each part finds what has to be looked at among its own triangles, and tells all. Place after place, in the
//           order of one memory, all parts do the same. For that the next places are shared, with a ring around them,
//           and those before are not any more. Before a part reads a triangle that is not shared, all share it.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_TAIL_OF_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_TAIL_OF_PARTS_H

#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/tell_all.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Exact_legalizer.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Remover.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Splitter.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/finish_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Corners_of_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Flips_of_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Held_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class ConcurrencyTag, class Exchange, class Geometry>
class Tail_of_parts {
public:
  using Held = Held_mesh<Exchange, Geometry>;

  Tail_of_parts(Exchange& exchange, Held& held, Corners_of_parts<Exchange, Geometry>& corners,
                Meshing_state<Geometry>& whole)
      : exchange_(exchange), held_(held), corners_(corners), whole_(whole), mesh_(whole.mesh) {}

  /// Whether all parts can do what `run()` does; nothing is changed. All parts call it. They cannot if more would
  /// follow on it: a mesh that is small, or might be in the end, is worth more effort.
  /// \param triangles how many there are
  bool is_possible(std::size_t triangles) {
    // That may go for each vertex that has changed, with what changes next to it. As a rule two go, or none.
    constexpr std::size_t most_for_one = 8;
    const std::size_t least = Meshing_state<Geometry>::most_triangles_to_merge_pairs;
    return triangles > least + most_for_one * number_of_changed() && can_unlock_by_fans();
  }

  /// All parts call it. \pre it is possible
  void run(Removal removal) {
    unlock();
    if (removal == Removal::GUARDED) remove();
    account_ = Flips_of_parts<ConcurrencyTag, Exchange, Geometry>(exchange_, held_, whole_).run();
  }

  /// Whether flips have made bad triangles, which are on the worklist then.
  bool leaves_bad() {
    std::vector<Triangle_id> listed;
    while (!whole_.worklist.is_empty()) listed.push_back(whole_.worklist.pop());
    held_.publish(held_.private_around(listed, 0));
    for (const Triangle_id t : listed)
      if (held_.is_shared(t) && whole_.is_bad(t)) whole_.push(t);
    return whole_.has_bad_on_worklist(); // This reverses their order again, as one memory does once.
  }

  /// Of the triangles that this part accounts for: the sum over all parts is that of the mesh. Counts of angles may be
  /// negative at one part, which unsigned ones are by modulus.
  const Triangle_account& account() const { return account_; }

private:
  /// How many rings are shared around what may change, and, at first, around places that changes come to from there.
  static constexpr int rings_of_change = 1, rings_of_spread = 2;
  /// How often parts meet for such places before they share another ring.
  static constexpr int meetings_for_one_more = 16;
  /// How many stars are shared at a time, at least. There are at most so many times.
  static constexpr std::size_t least_stars = 8192, most_times = 256;

  Exchange& exchange_;
  Held& held_;
  Corners_of_parts<Exchange, Geometry>& corners_;
  Meshing_state<Geometry>& whole_;
  Kernel_mesh<Geometry>& mesh_;
  Triangle_account account_;
  int times_shared_ = 0, more_rings_ = 0; // where changes came to what was not shared

  /// Shares a triangle and some rings around it, and another one each time that parts have had to meet twice as often:
  /// where changes spread, they do not meet for each.
  void share(Triangle_id t) {
    if (held_.is_shared(t)) return;
    held_.require({t}, rings_of_spread + more_rings_);
    if (++times_shared_ >> more_rings_ > meetings_for_one_more) ++more_rings_;
  }

  void share_both_sides(Side s) {
    share(s.triangle());
    const Side o = mesh_.across(s);
    if (!o.is_border()) share(o.triangle());
  }

  /// How many vertices might be removed, at most.
  std::size_t number_of_changed() {
    const Remover<Geometry> remover(whole_);
    std::int64_t own = 0, of_sectors = 0;
    for (const Vertex_id v : mesh_.points.ids())
      own += held_.speaks_for(v) && remover.is_to_be_tried(v) ? 1 : 0;
    for (const auto& s : whole_.corners.sectors) of_sectors += s.lock_radius > 0 ? 2 : 0;
    return static_cast<std::size_t>(exchange_.sum(own) + of_sectors);
  }

  // ---- sectors

  /// Whether all chords that lock sectors are found in the fans at their ends, or nowhere. All of that is shared then,
  /// and so are the triangles at the chords.
  bool can_unlock_by_fans() {
    tell_vertices_of_corners();
    std::vector<std::array<Vertex_id, 2>> chords;
    const auto& corners = whole_.corners;
    for (const auto& s : corners.sectors) {
      if (!(s.lock_radius > 0)) continue;
      const Vertex_id a = corners.vertex_at(mesh_, s.right, s.lock_radius),
                      b = corners.vertex_at(mesh_, s.left, s.lock_radius);
      if (a.is_valid() && b.is_valid()) chords.push_back({a, b});
    }
    const std::vector<Side> sides = corners_.sides_between(chords);
    for (std::size_t i = 0; i < chords.size(); ++i)
      if (sides[i].is_border() && mesh_.is_input(chords[i][0]) && mesh_.is_input(chords[i][1])) return false;
    share_triangles_at(sides);
    return true;
  }

  /// On both sides: what finds a side reads the triangle on one.
  /// \param sides the same at all parts, of triangles that are shared
  void share_triangles_at(const std::vector<Side>& sides) {
    std::vector<Triangle_id> triangles;
    for (const Side s : sides) {
      if (s.is_border()) continue;
      triangles.push_back(s.triangle());
      const Side o = mesh_.across(s);
      if (!o.is_border()) triangles.push_back(o.triangle());
    }
    held_.require(triangles, rings_of_change);
  }

  /// All parts read them.
  void tell_vertices_of_corners() {
    std::vector<Vertex_id> own = corners_.vertices();
    const auto is_of_others = [this](Vertex_id v) { return !held_.speaks_for(v); };
    own.erase(std::remove_if(own.begin(), own.end(), is_of_others), own.end());
    held_.tell({}, own);
  }

  void unlock() {
    Splitter<Geometry>(whole_).unlock_all();
    whole_.legalize([this](Side s) { share_both_sides(s); });
  }

  // ---- vertices

  /// All parts remove the same vertices, in the order of one memory.
  void remove() {
    Remover<Geometry> remover(whole_);
    std::set<Vertex_id> changed = changed_vertices(remover);
    for (int pass = 0; pass < Remover<Geometry>::passes; ++pass) {
      std::size_t shared = 0; // how many of the next ones have their stars shared
      for (auto next = changed.begin(); next != changed.end();) {
        if (shared == 0) shared = share_stars(next, changed.end());
        --shared;
        const Vertex_id v = *next;
        if (remover.is_to_be_tried(v)) try_to_remove(v, remover, changed);
        if (!remover.is_to_be_tried(v)) changed.erase(v);
        next = changed.upper_bound(v);
      }
    }
  }

  /// \param changed gets the vertices around it that may be removed then
  void try_to_remove(Vertex_id v, Remover<Geometry>& remover, std::set<Vertex_id>& changed) {
    const std::vector<Triangle_id> star = shared_star_of(v);
    std::vector<Vertex_id> vertices;
    for (const Triangle_id t : star)
      vertices.insert(vertices.end(), std::begin(mesh_.triangle(t).v), std::end(mesh_.triangle(t).v));
    if (remover.remove_if_changed(v))
      for (const Triangle_id t : star)
        if (!mesh_.is_alive(t)) held_.set_absent(t);
    for (const Vertex_id w : vertices)
      if (remover.is_to_be_tried(w)) changed.insert(w);
  }

  /// The vertices that may be removed, of all parts.
  std::set<Vertex_id> changed_vertices(const Remover<Geometry>& remover) {
    std::vector<Vertex_id> own;
    for (const Vertex_id v : mesh_.points.ids())
      if (held_.speaks_for(v) && remover.is_to_be_tried(v)) own.push_back(v);
    const std::vector<Vertex_id> all = tell_all(exchange_, own);
    return std::set<Vertex_id>(all.begin(), all.end());
  }

  /// Replaces what is shared by the stars of the next vertices.
  /// \returns how many stars
  template <class Iterator>
  std::size_t share_stars(Iterator next, Iterator end) {
    const std::size_t most = std::max(least_stars, mesh_.number_of_vertices() / most_times);
    std::vector<Vertex_id> vertices;
    for (; next != end && vertices.size() < most; ++next) vertices.push_back(*next);
    held_.unshare();
    std::vector<Triangle_id> read;
    do {
      read.clear();
      for (const Vertex_id v : vertices)
        if (held_.has(v)) add_held_star(v, read);
    } while (held_.publish(held_.private_around(read, rings_of_change)) > 0);
    return vertices.size();
  }

  /// Adds the triangles at a vertex, as far as one gets in what is held.
  void add_held_star(Vertex_id v, std::vector<Triangle_id>& stars) const {
    const Triangle_id start = mesh_.incident_triangle(v);
    if (!start.is_valid() || !held_.is_held(start)) return;
    Fan_walk<Kernel_mesh<Geometry>> walk(mesh_, v, start);
    do stars.push_back(walk.triangle());
    while (walk.advance() && held_.is_held(walk.triangle()));
  }

  /// The triangles at a vertex; these, and those next to them, are shared then.
  std::vector<Triangle_id> shared_star_of(Vertex_id v) {
    const Triangle_id start = mesh_.incident_triangle(v);
    share(start);
    std::vector<Triangle_id> star;
    Fan_walk<Kernel_mesh<Geometry>> walk(mesh_, v, start);
    do {
      share(walk.triangle());
      star.push_back(walk.triangle());
    } while (walk.advance());
    for (std::size_t i = 0, size = star.size(); i < size; ++i) {
      const Side o = mesh_.triangle(star[i]).side[Kernel_mesh<Geometry>::slot_of(mesh_.triangle(star[i]), v)];
      if (!o.is_border()) share(o.triangle());
    }
    return star;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_TAIL_OF_PARTS_H
