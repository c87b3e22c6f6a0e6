// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Removal of a vertex, whatever that does to angles, from a triangulation that is made constrained Delaunay around it.
//
// Computes: the triangulation without a vertex that is free or on an edge, whose two parts there become one.
// Bound:    O(d^2) for a vertex of degree d, and the flips that follow.
// Source:   Devillers, "On deletion in Delaunay triangulations" (2002): ears are cut off one after the other.
// Deviates: ears are cut off by flips in any order; the usual flips then make what is left Delaunay.
//
// An ear of the polygon around a vertex can be cut off by a flip if the vertex is strictly on the other side of it. A
// triangulation of a polygon has two ears at least, and the vertex is in one of them at most, or on the diagonal that
// both share. So flips go on until three triangles are left, or four with the vertex on a diagonal. Where the vertex is
// on an edge, this goes for each side of it until two triangles are left, as long as rounding has not put the vertex so
// far from the edge that other vertices are between.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_DELAUNAY_REMOVER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_DELAUNAY_REMOVER_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Delaunay_remover {
public:
  using Mesh = Kernel_mesh<Geometry>;

  explicit Delaunay_remover(Mesh& mesh) : mesh_(mesh) {}

  /// \returns false if the vertex is still there, which happens only on edges where rounding leaves no way
  /// \pre v is used, and not one of the input; it is not at a seam
  bool remove(Vertex_id v) {
    doubtful_.clear();
    const bool is_removed = mesh_.is_free(v) ? remove_free(v) : remove_on_edge(v);
    mesh_.make_Delaunay(doubtful_);
    return is_removed;
  }

private:
  /// Triangles that follow each other around v, counterclockwise: triangle i is v, link i, link i + 1.
  struct Fan {
    std::vector<Vertex_id> link;
    std::vector<Triangle_id> triangles;

    std::size_t size() const { return triangles.size(); }
  };

  Mesh& mesh_;
  std::vector<Side> doubtful_;

  bool remove_free(Vertex_id v) {
    Fan fan = fan_from(v, mesh_.incident_triangle(v));
    if (fan.link.front() != fan.link.back()) return false;
    while (fan.size() > 3 && cut_ear(v, fan, 0)) {
    }
    if (fan.size() > 4) return false;
    mark_as_changed(fan.link);
    if (fan.size() == 3) {
      merge_three(v, fan);
    } else {
      const std::size_t first = is_on_diagonal(v, fan, 0) ? 0 : 1; // it is on one of them
      rotate(fan, first);
      const Triangle_id t = merge_two(v, fan, 0), u = merge_two(v, fan, 2);
      mesh_.link(t, 1, Side(u, 1));
      doubtful_.push_back(Side(t, 1));
    }
    mesh_.triangle_of[v] = {};
    return true;
  }

  bool remove_on_edge(Vertex_id v) {
    Fan left = fan_from(v, clockwise_most(v)), right;
    const bool is_closed = left.link.front() == left.link.back();
    if (is_closed && !split_at_edge(v, left, right)) return false;
    for (Fan* half : {&left, &right}) {
      if (half == &right && !is_closed) break;
      while (half->size() > 2 && cut_ear(v, *half, 1)) {
      }
      if (half->size() != 2 || mesh_.orientation(half->link[0], half->link[1], half->link[2]) <= 0)
        return false;
    }
    mark_as_changed(left.link), mark_as_changed(right.link);
    const Triangle_id t = merge_two(v, left, 0);
    mesh_.triangle(t).side[1] = Side::border();
    if (is_closed) mesh_.link(t, 1, Side(merge_two(v, right, 0), 1, true));
    mesh_.triangle_of[v] = {};
    return true;
  }

  /// The triangles around v from one of them on, to the border or all around.
  Fan fan_from(Vertex_id v, Triangle_id first) const {
    Fan fan;
    for (Triangle_id t = first;;) {
      const auto& r = mesh_.triangle(t);
      const Side here(t, Mesh::slot_of(r, v));
      if (fan.link.empty()) fan.link.push_back(r.v[here.slot_after()]);
      fan.link.push_back(r.v[here.slot_before()]);
      fan.triangles.push_back(t);
      const Side next = r.side[here.slot_after()];
      if (next.is_border() || next.triangle() == first) return fan;
      t = next.triangle();
    }
  }

  /// Clockwise from the triangle that is stored to the border; that triangle, if there is none.
  Triangle_id clockwise_most(Vertex_id v) const {
    const Triangle_id start = mesh_.incident_triangle(v);
    for (Triangle_id t = start;;) {
      const auto& r = mesh_.triangle(t);
      const Side before = r.side[previous_slot[Mesh::slot_of(r, v)]];
      if (before.is_border() || before.triangle() == start) return before.is_border() ? t : start;
      t = before.triangle();
    }
  }

  /// Splits the fan all around v into those of both sides of its edge.
  /// \returns false if not just two sides at v are constrained
  bool split_at_edge(Vertex_id v, Fan& all, Fan& right) const {
    std::vector<std::size_t> spokes; // i: from v to link i
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto& r = mesh_.triangle(all.triangles[i]);
      if (r.side[previous_slot[Mesh::slot_of(r, v)]].is_constrained()) spokes.push_back(i);
    }
    if (spokes.size() != 2) return false;
    rotate(all, spokes[0]);
    const auto middle = static_cast<std::ptrdiff_t>(spokes[1] - spokes[0]);
    right.link.assign(all.link.begin() + middle, all.link.end());
    right.triangles.assign(all.triangles.begin() + middle, all.triangles.end());
    all.link.resize(static_cast<std::size_t>(middle) + 1);
    all.triangles.resize(static_cast<std::size_t>(middle));
    return true;
  }

  /// Makes a closed fan begin with another of its triangles.
  static void rotate(Fan& fan, std::size_t first) {
    const auto by = static_cast<std::ptrdiff_t>(first);
    fan.link.pop_back();
    std::rotate(fan.link.begin(), fan.link.begin() + by, fan.link.end());
    std::rotate(fan.triangles.begin(), fan.triangles.begin() + by, fan.triangles.end());
    fan.link.push_back(fan.link.front());
  }

  /// Cuts off one ear by a flip. \returns false if none can be
  /// \param first the first member of the link that may be at the tip of one; of a closed fan 0
  bool cut_ear(Vertex_id v, Fan& fan, std::size_t first) {
    for (std::size_t i = first; i < fan.size(); ++i) {
      const std::size_t before = i == 0 ? fan.size() - 1 : i - 1;
      const Vertex_id a = fan.link[before], tip = fan.link[i], b = fan.link[i + 1];
      if (mesh_.orientation(a, tip, b) <= 0 || mesh_.orientation(v, a, b) <= 0) continue;
      const Triangle_id ear = fan.triangles[before];
      const int slot = Mesh::slot_of(mesh_.triangle(ear), a);
      if (mesh_.triangle(ear).side[slot].is_constrained()) continue;
      mesh_.flip(ear, slot); // which is a, tip, b now
      for (int k = 0; k < 3; ++k) doubtful_.push_back(Side(ear, k));
      fan.triangles[before] = fan.triangles[i];
      fan.triangles.erase(fan.triangles.begin() + static_cast<std::ptrdiff_t>(i));
      fan.link.erase(fan.link.begin() + static_cast<std::ptrdiff_t>(i));
      if (i == 0) fan.link.back() = fan.link.front();
      return true;
    }
    return false;
  }

  /// Whether v is on the diagonal from link i to link i + 2 of a closed fan of four.
  bool is_on_diagonal(Vertex_id v, const Fan& fan, std::size_t i) const {
    return mesh_.orientation(v, fan.link[i], fan.link[i + 2]) == 0;
  }

  /// What lies across the side that is opposite v.
  Side beyond(Vertex_id v, Triangle_id t) const {
    const auto& r = mesh_.triangle(t);
    return r.side[Mesh::slot_of(r, v)];
  }

  /// Makes one triangle of those from link i to link i + 2; its side 1 is open.
  Triangle_id merge_two(Vertex_id v, const Fan& fan, std::size_t i) {
    const Triangle_id t = fan.triangles[i], u = fan.triangles[i + 1];
    const Side first = beyond(v, t), second = beyond(v, u);
    put(t, fan.link[i], fan.link[i + 1], fan.link[i + 2]);
    mesh_.kill(u);
    join(t, 2, first), join(t, 0, second);
    return t;
  }

  void merge_three(Vertex_id v, const Fan& fan) {
    Side across[3];
    for (std::size_t i = 0; i < 3; ++i) across[i] = beyond(v, fan.triangles[i]);
    const Triangle_id t = fan.triangles[0];
    put(t, fan.link[0], fan.link[1], fan.link[2]);
    mesh_.kill(fan.triangles[1]), mesh_.kill(fan.triangles[2]);
    join(t, 2, across[0]), join(t, 0, across[1]), join(t, 1, across[2]);
  }

  void put(Triangle_id t, Vertex_id a, Vertex_id b, Vertex_id c) {
    auto& r = mesh_.triangle(t);
    r.v[0] = a, r.v[1] = b, r.v[2] = c;
    mesh_.triangle_of[a] = mesh_.triangle_of[b] = mesh_.triangle_of[c] = t;
  }

  void join(Triangle_id t, int slot, Side other) {
    mesh_.link(t, slot, other);
    doubtful_.push_back(Side(t, slot));
  }

  void mark_as_changed(const std::vector<Vertex_id>& vertices) {
    for (const Vertex_id v : vertices) mesh_.is_dirty[v] = 1;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REFINEMENT_DELAUNAY_REMOVER_H
