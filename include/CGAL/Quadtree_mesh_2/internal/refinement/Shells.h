// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The shell vertices of a leg: at which radii it is cut, and by which vertices.
//
// O(log n) for a query by radius or by vertex, for n vertices on the leg; O(log n) for an insertion of a vertex
// with a greater handle than all before it, as new vertices have.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SHELLS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SHELLS_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <map>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Pairs of a radius and a vertex, by increasing radius.
template <class Number>
class Shells {
  using By_radius = std::map<Number, Vertex_id>;

public:
  using const_iterator = typename By_radius::const_iterator;

  const_iterator begin() const { return by_radius_.begin(); }
  const_iterator end() const { return by_radius_.end(); }
  /// The first one at least as far as a radius.
  const_iterator from(const Number& radius) const { return by_radius_.lower_bound(radius); }

  /// The radius of a vertex, -1 if it is none of these.
  Number radius_of(Vertex_id v) const {
    const auto place = std::lower_bound(by_vertex_.begin(), by_vertex_.end(), v, is_before);
    return place != by_vertex_.end() && place->vertex == v ? place->radius : Number(-1);
  }

  struct Shell_vertex {
    Number radius;
    Vertex_id vertex;
  };
  struct Interval {
    Shell_vertex below, above;
  };
  /// The alive ones around a radius; the apex below the first, none above the last.
  template <class Is_alive>
  Interval around(const Number& radius, Vertex_id apex, const Is_alive& is_alive) const {
    const auto next = by_radius_.upper_bound(radius);
    Interval i{{0, apex}, {0, Vertex_id()}};
    for (auto s = next; s != end() && !i.above.vertex.is_valid(); ++s)
      if (is_alive(s->second)) i.above = {s->first, s->second};
    for (auto s = next; s != begin() && i.below.vertex == apex;)
      if (is_alive((--s)->second)) i.below = {s->first, s->second};
    return i;
  }

  /// Takes the place of a vertex at the same radius, which is then removed from the mesh.
  void insert(const Number& radius, Vertex_id v) {
    by_radius_.insert_or_assign(radius, v);
    by_vertex_.insert(std::lower_bound(by_vertex_.begin(), by_vertex_.end(), v, is_before), {radius, v});
  }

  /// Writes or reads them (Checkpoint_file.h).
  template <class Archive>
  void transfer(Archive& archive) {
    std::vector<Shell_vertex> by_radius;
    for (const auto& [radius, v] : by_radius_) by_radius.push_back({radius, v});
    archive(by_radius, by_vertex_);
    if (!Archive::is_reading) return;
    by_radius_.clear();
    for (const Shell_vertex& s : by_radius) by_radius_.emplace_hint(by_radius_.end(), s.radius, s.vertex);
  }

  void clear() { by_radius_.clear(), by_vertex_.clear(); }

  /// Gives each vertex the handle `name(v)`; forgets it if that is none.
  template <class Name>
  void rename(const Name& name) {
    by_vertex_.clear();
    for (auto s = by_radius_.begin(); s != by_radius_.end();) {
      s->second = name(s->second);
      if (!s->second.is_valid()) {
        s = by_radius_.erase(s);
      } else {
        by_vertex_.push_back({s->first, s->second});
        ++s;
      }
    }
    std::sort(by_vertex_.begin(), by_vertex_.end(),
              [](const Shell_vertex& a, const Shell_vertex& b) { return a.vertex < b.vertex; });
  }

private:
  By_radius by_radius_;
  std::vector<Shell_vertex> by_vertex_;

  static bool is_before(const Shell_vertex& e, Vertex_id v) { return e.vertex < v; }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_SHELLS_H
