// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The exact flips (Exact_legalizer.h) that a part makes alone in a mesh that parts hold, and how it takes them back.
//
// Computes: flips from sides, one after the other, each as far as it leads, among triangles whose vertices no other
//           part has. Sides from where flips would go farther are left. So is every later side whose flips reach what
//           such a side has read.
// Bound:    O(r log r) for the r vertices that flips read, with as much memory, and O(r) more for each time that flips
//           are undone. A bit for each vertex of the whole mesh.
// Method:   a flip from a side reads and writes nothing but triangles and vertices that it notes. So flips from two
//           sides that have none of them in common may be made in any order. Where all parts later reach a place at
//           which this part has made a flip that comes after theirs in the order of one memory, that flip is undone,
//           with all flips that depend on it.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_LONE_FLIPS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_LONE_FLIPS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Id_set.h>
#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Exact_legalizer.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// In the order in which one memory takes sides up.
struct Side_is_before {
  bool operator()(Side a, Side b) const {
    return a.triangle() != b.triangle() ? a.triangle() < b.triangle() : a.slot() < b.slot();
  }
};

template <class ConcurrencyTag, class Held, class Geometry>
class Lone_flips {
public:
  using Legalizer = Exact_legalizer<ConcurrencyTag, Geometry>;

  /// \param account of this part's triangles
  Lone_flips(const Held& held, Meshing_state<Geometry>& whole, Legalizer& legalizer,
             Triangle_account& account)
      : held_(held), whole_(whole), mesh_(whole.mesh), legalizer_(legalizer), account_(account),
        is_taboo_(mesh_.number_of_vertices()), is_met_(mesh_.number_of_vertices()) {}

  /// Nothing is read that has these vertices.
  void forbid(const std::vector<Vertex_id>& vertices) {
    for (const Vertex_id v : vertices) is_taboo_.add(v);
  }

  /// Makes the flips from sides, in order. \returns the sides that are left
  std::vector<Side> run(const std::vector<Side>& doubtful) {
    std::vector<Side> left;
    for (const Side s : doubtful) {
      Tries tries{*this, {s, {}, {}}};
      const bool is_done = legalizer_.flip_from(s, account_, tries);
      sort_and_drop_equal(tries.flips.read);
      if (is_done) {
        done_.push_back(std::move(tries.flips));
      } else {
        take_back(tries.flips);
        forbid(tries.flips.read); // all parts will flip there later
        left.push_back(s);
      }
    }
    return left;
  }

  /// Undoes the flips from sides after `after`, or from all if that is null, that have read one of these vertices, and
  /// those that depend on them. \returns their sides
  std::vector<Side> take_back_at(const std::vector<Vertex_id>& vertices, const Side* after) {
    const auto is_before = [](Side s, const Flips& f) { return Side_is_before()(s, f.from); };
    const auto first =
        after == nullptr ? done_.begin() : std::upper_bound(done_.begin(), done_.end(), *after, is_before);
    std::vector<Flips> stay, gone;
    std::vector<Vertex_id> met = vertices;
    for (const Vertex_id v : met) is_met_.add(v);
    for (auto f = first; f != done_.end(); ++f) {
      const bool is_gone =
          std::any_of(f->read.begin(), f->read.end(), [this](Vertex_id v) { return is_met_.has(v); });
      if (is_gone) {
        for (const Vertex_id v : f->read) is_met_.add(v);
        met.insert(met.end(), f->read.begin(), f->read.end());
      }
      (is_gone ? gone : stay).push_back(std::move(*f));
    }
    for (const Vertex_id v : met) is_met_.remove(v);
    done_.erase(std::move(stay.begin(), stay.end(), first), done_.end());
    std::vector<Side> sides;
    for (auto f = gone.rbegin(); f != gone.rend(); ++f) {
      take_back(*f);
      sides.push_back(f->from);
    }
    return sides;
  }

private:
  using Mesh = Kernel_mesh<Geometry>;

  /// What a flip writes, as it was before.
  struct Flip {
    std::array<Triangle_id, 2> flipped;
    std::vector<std::pair<Triangle_id, typename Mesh::Triangle>> triangles;
    std::vector<std::pair<Vertex_id, Triangle_id>> triangle_of;
  };
  struct Flips {
    Side from;
    std::vector<Flip> flips;
    std::vector<Vertex_id> read; ///< those of all triangles that were read
  };

  /// Watches the flips from a side (Any_flips).
  struct Tries {
    Lone_flips& lone;
    Flips flips;

    bool may_look(Side s) {
      if (!may_read(s.triangle())) return false;
      const Side o = lone.mesh_.across(s);
      return o.is_border() || may_read(o.triangle());
    }
    void will_flip(Side s) { flips.flips.push_back(lone.before_flip(s)); }
    /// What may be bad has to go on the worklists of all parts, so all of them make it.
    bool may_make(Triangle_id t, const typename Mesh::Shape& shape) {
      return !lone.whole_.misses_bound(t, shape);
    }

    bool may_read(Triangle_id t) {
      if (!lone.held_.is_private(t)) return false;
      const auto& v = lone.mesh_.triangle(t).v;
      flips.read.insert(flips.read.end(), std::begin(v), std::end(v));
      return std::none_of(std::begin(v), std::end(v), [this](Vertex_id w) { return lone.is_taboo_.has(w); });
    }
  };

  const Held& held_;
  Meshing_state<Geometry>& whole_;
  Mesh& mesh_;
  Legalizer& legalizer_;
  Triangle_account& account_;
  Id_set<Vertex_id> is_taboo_;
  Id_set<Vertex_id> is_met_; // by what all parts share; empty between calls
  std::vector<Flips> done_;  // in order

  Flip before_flip(Side s) const {
    Flip flip{{s.triangle(), mesh_.across(s).triangle()}, {}, {}};
    const auto save = [&](Triangle_id t) { flip.triangles.emplace_back(t, mesh_.triangle(t)); };
    for (const Triangle_id t : flip.flipped) {
      save(t);
      for (const Side o : mesh_.triangle(t).side)
        if (!o.is_border()) save(o.triangle());
      for (const Vertex_id v : mesh_.triangle(t).v)
        flip.triangle_of.emplace_back(v, mesh_.incident_triangle(v));
    }
    return flip;
  }

  void take_back(const Flips& flips) {
    const auto add_shapes = [&](const Flip& f, auto add) {
      for (const Triangle_id t : f.flipped) add(mesh_.shape(mesh_.triangle(t)));
    };
    for (auto f = flips.flips.rbegin(); f != flips.flips.rend(); ++f) {
      add_shapes(*f, [&](const auto& shape) { account_.angles.take(shape); });
      for (const auto& [t, triangle] : f->triangles) mesh_.triangle(t) = triangle;
      for (const auto& [v, t] : f->triangle_of) mesh_.triangle_of[v] = t;
      add_shapes(*f, [&](const auto& shape) { account_.angles.add(shape); });
    }
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_LONE_FLIPS_H
