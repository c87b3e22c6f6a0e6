// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Gives edges of the border that are nearly on a line their share of the free space outside.
//
// Computes: flips of the triangulation outside. Between two edges whose common end is nearly on the line through the
//           others there is a flat triangle of the Delaunay triangulation, as high as rounding has made it, though
//           nothing is behind it. The rooms in it (Edge_room.h) would be that high, too, and have no place for
//           rounded vertices. A flip of its longest side, if that is free, makes triangles of the edges and what is
//           across that side.
// Bound:    O(n): each flip leaves fewer flat triangles, and looks again at four.
// Source:   ours.
//
// Any triangulation of the outside has disjoint rooms; it need not be Delaunay. What is found flat by mistake costs a
// flip and no more. Orientation is exact.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_FLAT_TRIANGLE_FLIPPER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_FLAT_TRIANGLE_FLIPPER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Flat_triangle_flipper {
public:
  using Mesh = Kernel_mesh<Geometry>;

  /// Triangles are outside that are not kept. Vertices from `first_auxiliary` on are no input.
  Flat_triangle_flipper(Mesh& mesh, const Indexed_vector<Triangle_id, char>& is_kept,
                        Vertex_id first_auxiliary)
      : mesh_(mesh), is_kept_(is_kept), first_auxiliary_(first_auxiliary) {}

  /// Whether a triangle with this shape is flat.
  static bool is_flat(const typename Mesh::Shape& shape) { return is_below(flat_, shape); }

  /// The triangulation alone, and no handle of a triangle, decides what becomes of it.
  void run() {
    append_by_blocks<Chosen_tag>(stack_, mesh_.triangles.size(),
                                 [this](std::size_t begin, std::size_t end, std::vector<Triangle_id>& found) {
                                   for (const Triangle_id t : Id_range<Triangle_id>(begin, end))
                                     if (is_flat_outside(t)) found.push_back(t);
                                 });
    std::sort(stack_.begin(), stack_.end(),
              [this](Triangle_id t, Triangle_id u) { return from_least(t) < from_least(u); });
    while (!stack_.empty()) {
      const Triangle_id t = stack_.back();
      stack_.pop_back();
      if (is_flat(mesh_.triangle(t).v)) flip_longest_side_of(t);
    }
  }

private:
  using Vertices = Vertex_id[3];

  /// Below this sine of the angle between their shortest and longest sides, triangles are flat. Thin triangles with a
  /// short side are not: the room at that side is as wide as it.
  static constexpr double flat_ = 0x1p-20;
  /// There are no rooms in triangles of auxiliary vertices, which therefore have to be wide.
  static constexpr double wide_ = 0.25;

  Mesh& mesh_;
  const Indexed_vector<Triangle_id, char>& is_kept_;
  Vertex_id first_auxiliary_;
  std::vector<Triangle_id> stack_;

  static bool is_below(double sine, const typename Mesh::Shape& s) {
    return !(s.area2 > 0 && s.area2 * s.area2 >= sine * sine * (s.longest() * s.shortest()));
  }
  bool is_flat(const Vertices& v) const { return is_flat(shape(v)); }
  typename Mesh::Shape shape(const Vertices& v) const { return mesh_.shape(v[0], v[1], v[2]); }
  bool is_input(Vertex_id v) const { return v < first_auxiliary_; }
  bool are_input(const Vertices& v) const { return is_input(v[0]) && is_input(v[1]) && is_input(v[2]); }

  bool is_flat_outside(Triangle_id t) const {
    return is_kept_[t] == 0 && mesh_.is_alive(t) && is_flat(mesh_.triangle(t).v);
  }

  /// The vertices of a triangle from the least one on.
  std::array<Vertex_id, 3> from_least(Triangle_id t) const {
    const auto& r = mesh_.triangle(t);
    const int k = Mesh::slot_of_least(r);
    return {r.v[k], r.v[next_slot[k]], r.v[previous_slot[k]]};
  }

  void flip_longest_side_of(Triangle_id t) {
    const auto& r = mesh_.triangle(t);
    const auto s = mesh_.shape(r);
    int k = Mesh::slot_of_least(r);
    while (s.l[k] < s.longest()) k = next_slot[k];
    const Side o = r.side[k];
    if (o.is_constrained()) return;
    const Triangle_id u = o.triangle();
    const Vertex_id b = r.v[k], c = r.v[next_slot[k]], a = r.v[previous_slot[k]], d = mesh_.opposite(o);
    if (!is_worth_making({a, b, d}) || !is_worth_making({b, c, d})) return;
    mesh_.flip(t, k);
    for (const Triangle_id changed : {t, u})
      for (const Side outer : mesh_.triangle(changed).side)
        if (!outer.is_constrained() && is_flat_outside(outer.triangle())) stack_.push_back(outer.triangle());
  }

  bool is_worth_making(const Vertices& v) const {
    return mesh_.orientation(v[0], v[1], v[2]) > 0 && !is_below(are_input(v) ? flat_ : wide_, shape(v));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_FLAT_TRIANGLE_FLIPPER_H
