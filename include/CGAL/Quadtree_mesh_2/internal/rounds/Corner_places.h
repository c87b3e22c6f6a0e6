// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where an acute corner lies in the mesh, and in which block: its shells and locks belong to the block that has all of
// it. O(pieces of its legs) for a corner, and the stars of the vertices on them.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_CORNER_PLACES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_CORNER_PLACES_H

#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Mesh_block.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A visit to all triangles of a corner.
/// \tparam Look_up finds a side between two vertices, of a triangle that can be read, or the border if there is none;
///         and calls a function for the triangles at a vertex
template <class Geometry, class Look_up>
struct Corner_visit {
  using Corners = Acute_corners<Geometry>;

  const Meshing_state<Geometry>& whole;
  Look_up look_up;

  /// Calls `f(t)` for the triangles of a corner until it returns false.
  /// \returns false then, and where a leg could not be cut, of which nothing can be said
  template <class Function>
  bool run(const typename Corners::Corner& corner, const Function& f) const {
    for (const Leg_id l : corner.legs) {
      const auto& leg = whole.corners.leg(l);
      if (whole.problem.is_kept(leg.edge)) continue; // it is never cut
      Vertex_id before = leg.apex_vertex;
      for (const auto& [radius, v] : leg.shells) {
        static_cast<void>(radius);
        if (!whole.mesh.is_used(v)) continue;
        if (!visit_side(before, v, f) || (!whole.mesh.is_input(v) && !visit_star(v, f))) return false;
        before = v;
      }
      if (before == leg.apex_vertex) return false;
    }
    return std::all_of(corner.sectors.begin(), corner.sectors.end(),
                       [&](Sector_id s) { return visit_chord(whole.corners.sector(s), f); });
  }

private:
  template <class Function>
  bool visit_side(Vertex_id x, Vertex_id y, const Function& f) const {
    const Side s = look_up.side_between(x, y);
    if (s.is_border()) return false;
    const Side o = whole.mesh.across(s);
    return f(s.triangle()) && (o.is_border() || f(o.triangle()));
  }

  template <class Function>
  bool visit_star(Vertex_id v, const Function& f) const {
    bool shall_go_on = true;
    look_up.for_each_triangle_at(v, [&](Triangle_id t) { shall_go_on = shall_go_on && f(t); });
    return shall_go_on;
  }

  template <class Function>
  bool visit_chord(const typename Corners::Sector& sector, const Function& f) const {
    if (sector.lock_radius <= 0) return true;
    const Vertex_id x = whole.corners.vertex_at(whole.mesh, sector.right, sector.lock_radius),
                    y = whole.corners.vertex_at(whole.mesh, sector.left, sector.lock_radius);
    return !x.is_valid() || !y.is_valid() || x == y || visit_side(x, y, f);
  }
};

template <class ConcurrencyTag, class Geometry>
class Corner_places {
public:
  using Corners = Acute_corners<Geometry>;
  using Corners_of_blocks = Indexed_vector<Block_id, std::vector<Corner_id>>;

  explicit Corner_places(const Meshing_state<Geometry>& whole) : whole_(whole), corners_(whole.corners) {}

  /// For each block the corners it owns: all pieces of their legs within the ring and all locked chords have both their
  /// triangles in the block, and so have the Steiner vertices on the legs all of theirs.
  /// \param blocks how many there are
  /// \param block_of the block of a triangle that is alive, if it is in one
  template <class Block_of>
  Corners_of_blocks by_block(std::size_t blocks, const Block_of& block_of) const {
    Indexed_vector<Corner_id, Block_id> owner(corners_.corners.size());
    for_each_index<ConcurrencyTag>(
        owner.size(),
        [&](std::size_t i) {
          const Corner_id c = static_cast<Corner_id>(i);
          owner[c] = owner_of(corners_.corner(c), block_of);
        },
        64);
    Corners_of_blocks owned(blocks);
    for (const Corner_id c : owner.ids())
      if (owner[c].is_valid()) owned[owner[c]].push_back(c);
    return owned;
  }

  /// The corners for which some triangles may wait: those on whose legs they have a vertex.
  std::vector<Corner_id> corners_of(const std::vector<Triangle_id>& waiting) const {
    return corners_at(vertices_on_legs(waiting));
  }

  /// The triangles of a corner, as far as its legs are cut; some more than once.
  std::vector<Triangle_id> triangles_of(Corner_id c) const {
    std::vector<Triangle_id> triangles;
    visit(corners_.corner(c), [&](Triangle_id t) {
      triangles.push_back(t);
      return true;
    });
    return triangles;
  }

private:
  using Corner = typename Corners::Corner;

  const Meshing_state<Geometry>& whole_;
  const Corners& corners_;

  template <class Block_of>
  Block_id owner_of(const Corner& corner, const Block_of& block_of) const {
    Block_id owner;
    const auto is_owned = [&](Triangle_id t) {
      const Block_id b = block_of(t);
      if (!owner.is_valid()) owner = b;
      return b.is_valid() && b == owner;
    };
    return visit(corner, is_owned) ? owner : Block_id();
  }

  // Each once: a corner may have as many legs, and a vertex as many triangles, as the graph has edges.

  std::vector<Vertex_id> vertices_on_legs(const std::vector<Triangle_id>& triangles) const {
    std::vector<Vertex_id> vertices;
    append_by_blocks<ConcurrencyTag>(vertices, triangles.size(),
                                     [&](std::size_t begin, std::size_t end, std::vector<Vertex_id>& found) {
                                       for (std::size_t i = begin; i < end; ++i)
                                         if (whole_.mesh.is_alive(triangles[i]))
                                           for (const Vertex_id v : whole_.mesh.triangle(triangles[i]).v)
                                             if (corners_.is_on_leg(whole_.mesh, v)) found.push_back(v);
                                     });
    sort_and_drop_equal(vertices);
    return vertices;
  }

  /// The corners with a leg on which one of the vertices lies.
  std::vector<Corner_id> corners_at(const std::vector<Vertex_id>& vertices) const {
    std::vector<Corner_id> found;
    const auto look_at = [&](Edge_id e) {
      for (const Leg_id l : corners_.legs_of_edge[e])
        if (l.is_valid()) found.push_back(corners_.leg(l).corner);
    };
    for (const Vertex_id v : vertices) {
      if (!whole_.mesh.is_input(v)) {
        look_at(whole_.mesh.edge(v));
        continue;
      }
      const Vertex_id number = whole_.mesh.input_number(v);
      for (auto [l, end] = corners_.legs_to(number); l != end; ++l) found.push_back(corners_.leg(*l).corner);
      for (auto [c, end] = corners_.corners_at(number); c != end; ++c)
        found.push_back(corners_.leg(c->legs.front()).corner);
    }
    sort_and_drop_equal(found);
    return found;
  }

  /// Looks up sides and stars in a mesh that is all here.
  struct Look_up {
    const Meshing_state<Geometry>& whole;

    Side side_between(Vertex_id x, Vertex_id y) const { return whole.side_between(x, y); }
    template <class Function>
    void for_each_triangle_at(Vertex_id v, const Function& f) const {
      whole.mesh.for_each_triangle_at(v, [&](Triangle_id t, int) { f(t); });
    }
  };

  template <class Function>
  bool visit(const Corner& corner, const Function& f) const {
    return Corner_visit<Geometry, Look_up>{whole_, {whole_}}.run(corner, f);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ROUNDS_CORNER_PLACES_H
