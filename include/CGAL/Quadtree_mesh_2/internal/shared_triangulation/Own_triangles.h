// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The triangles of a triangulation of which one part knows the stars of some vertices (Own_stars.h).
//
// Computes: the triangles whose least vertex is of the part's run, each from that vertex on, in the order of that and
//           of their next vertex. So the triangles of all parts, one part after the other, are those of the whole
//           triangulation in the order of Kept_triangles.h. What is across a side is known but where the triangle there
//           is another part's; such a side is open until that part has told its handle.
// Bound:    O(t) for t triangles, in parallel, and O(d log d) for the d triangles of a vertex.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_OWN_TRIANGLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_OWN_TRIANGLES_H

#include <CGAL/Quadtree_mesh_2/internal/base/sort_short_run.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/Run_counters.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/append_all.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Clear_boxes.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A side of a triangle at the seam of a part.
struct Open_side {
  Vertex_id a, b;         ///< its ends, the lesser one first
  Triangle_id triangle;   ///< in the whole triangulation
  std::uint32_t slot = 0; ///< there

  friend bool operator<(const Open_side& s, const Open_side& t) {
    return s.a < t.a || (s.a == t.a && s.b < t.b);
  }
};

template <class Geometry>
class Own_triangles {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Triangle = typename Mesh::Triangle;
  using Triangles = Uninitialized_vector<Triangle>;

  /// \param mesh in which the stars of the run are right
  Own_triangles(const Mesh& mesh, Vertex_run own)
      : mesh_(mesh), own_(own), own_side_(mesh.triangles.size()), runs_(own.end - own.begin) {
    for_each_index<Chosen_tag>(own_side_.size(), [&](std::size_t t) {
      const Vertex_id v = least_number(static_cast<Triangle_id>(t));
      if (own_.has(v)) runs_.count(std::size_t(v) - own_.begin);
    });
    order_.resize(runs_.begin_placing());
    for_each_index<Chosen_tag>(own_side_.size(), [&](std::size_t i) {
      const Triangle_id t = static_cast<Triangle_id>(i);
      own_side_[t] = Side::border();
      const Vertex_id v = least_number(t);
      if (own_.has(v)) order_[runs_.place(std::size_t(v) - own_.begin)] = t;
    });
    for_each_index<Chosen_tag>(runs_.size(), [this](std::size_t v) { sort_run(v); });
  }

  std::size_t size() const { return order_.size(); }
  /// Whether a triangle of the mesh is one of them, and which.
  bool has(Triangle_id t) const { return !own_side_[t].is_border(); }
  std::size_t place(Triangle_id t) const { return own_side_[t].triangle().value(); }

  /// The triangles, by the numbers of vertices, and handles in the whole triangulation, where the first of them has the
  /// given one. What is across open sides is the border.
  /// \param open gets the open sides, in order
  Triangles named_from(std::size_t first, std::vector<Open_side>& open) const {
    Triangles triangles(size());
    append_by_blocks<Chosen_tag>(open, size(),
                                 [&](std::size_t begin, std::size_t end, std::vector<Open_side>& found) {
                                   for (std::size_t i = begin; i < end; ++i)
                                     triangles[i] = named(i, first, found);
                                 });
    return triangles;
  }

  /// Whether the side of a triangle that is open is constrained.
  bool is_constrained(const Open_side& side, std::size_t first) const {
    const Triangle_id t = order_[side.triangle.value() - first];
    return mesh_.triangle(t).side[(slot_of_least(t) + static_cast<int>(side.slot)) % 3].is_constrained();
  }

private:
  const Mesh& mesh_;
  Vertex_run own_;
  Uninitialized_vector<Triangle_id> order_;
  // The side opposite the least vertex, with the place in the order; none for triangles of others.
  Uninitialized_indexed_vector<Triangle_id, Side> own_side_;
  Run_counters runs_; // of the triangles with one least vertex

  int slot_of_least(Triangle_id t) const {
    const auto& v = mesh_.triangle(t).v;
    const auto number = [&](int k) { return mesh_.input_number(v[k]); };
    const int k = number(1) < number(0) ? 1 : 0;
    return number(2) < number(k) ? 2 : k;
  }
  Vertex_id least_number(Triangle_id t) const {
    return mesh_.input_number(mesh_.triangle(t).v[slot_of_least(t)]);
  }
  Vertex_id next_number(Triangle_id t) const {
    return mesh_.input_number(mesh_.triangle(t).v[next_slot[slot_of_least(t)]]);
  }

  void sort_run(std::size_t v) {
    const std::size_t begin = runs_.begin(v), end = runs_.end(v);
    sort_short_run(order_.data() + begin, order_.data() + end,
                   [this](Triangle_id t, Triangle_id u) { return next_number(t) < next_number(u); });
    for (std::size_t i = begin; i < end; ++i)
      own_side_[order_[i]] = Side(static_cast<Triangle_id>(i), slot_of_least(order_[i]));
  }

  Triangle named(std::size_t i, std::size_t first, std::vector<Open_side>& open) const {
    const Triangle& before = mesh_.triangle(order_[i]);
    const Triangle_id handle(first + i);
    Triangle named;
    for (int k = 0, from = own_side_[order_[i]].slot(); k < 3; ++k, from = next_slot[from]) {
      named.v[k] = mesh_.input_number(before.v[from]);
      const Side o = before.side[from];
      named.side[k] = Side::border();
      if (o.is_border()) continue;
      const Side own = own_side_[o.triangle()];
      if (own.is_border()) {
        const Vertex_id a = mesh_.input_number(before.v[next_slot[from]]),
                        b = mesh_.input_number(before.v[previous_slot[from]]);
        open.push_back({std::min(a, b), std::max(a, b), handle, static_cast<std::uint32_t>(k)});
      } else {
        const int slot = (o.slot() - own.slot() + 3) % 3;
        named.side[k] =
            Side(static_cast<Triangle_id>(first + own.triangle().value()), slot, o.is_constrained());
      }
    }
    return named;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_OWN_TRIANGLES_H
