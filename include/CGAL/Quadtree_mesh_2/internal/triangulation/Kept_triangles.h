// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Drops the triangles of a mesh that are not kept, and gives the others the handles that their vertices determine.
//
// Computes: the mesh of the triangles kept. Each begins with its least vertex. They are in the order of that and of their
//           next vertex. A vertex knows the first triangle that begins with it, or the first at it if none does.
// Bound:    O(n) for n triangles, in parallel: sorting by digits.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KEPT_TRIANGLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KEPT_TRIANGLES_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/radix_sort.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Mesh>
class Kept_triangles {
public:
  /// \pre around each vertex the triangles of the mesh make one fan, of which some may be kept and others not
  Kept_triangles(Mesh& mesh, const Indexed_vector<Triangle_id, char>& is_kept)
      : mesh_(mesh), is_kept_(is_kept) {
    sort();
    name();
  }

  /// Drops all other triangles, and the vertices from the given one on.
  void keep(Vertex_id end_of_vertices) {
    auto triangle_of = first_triangles(end_of_vertices);
    mesh_.points.truncate(end_of_vertices), mesh_.role_of.truncate(end_of_vertices);
    mesh_.is_dirty.truncate(end_of_vertices);
    mesh_.triangle_of = std::move(triangle_of);
    decltype(mesh_.region_of) region_of(mesh_.region_of.empty() ? 0 : order_.size());
    for_each_index<Chosen_tag>(region_of.size(), [&](std::size_t i) {
      region_of[static_cast<Triangle_id>(i)] = mesh_.region(triangle_before(i));
    });
    mesh_.region_of = std::move(region_of);
    mesh_.triangles = renamed_triangles();
  }

private:
  using Triangle = typename Mesh::Triangle;

  Mesh& mesh_;
  const Indexed_vector<Triangle_id, char>& is_kept_;
  std::vector<std::uint64_t> order_; // the triangles kept: least vertex, handle
  // The side opposite the least vertex, with the new handle; the border for triangles that are not kept.
  Uninitialized_indexed_vector<Triangle_id, Side> new_side_;

  Vertex_id least_vertex(std::size_t i) const { return Vertex_id(order_[i] >> 32); }
  Triangle_id triangle_before(std::size_t i) const { return triangle_of(order_[i]); }
  static Triangle_id triangle_of(std::uint64_t word) { return Triangle_id(static_cast<std::uint32_t>(word)); }
  /// Whether the triangle is the first one with its least vertex.
  bool is_first(std::size_t i) const { return i == 0 || least_vertex(i - 1) != least_vertex(i); }

  Vertex_id next_vertex(std::uint64_t word) const {
    const Triangle& r = mesh_.triangle(triangle_of(word));
    return r.v[next_slot[Mesh::slot_of_least(r)]];
  }

  void sort() {
    order_ = pack_values<Chosen_tag, std::uint64_t>(
        mesh_.triangles.size(), [&](std::size_t i) { return is_kept_[static_cast<Triangle_id>(i)] != 0; },
        [&](std::size_t i) {
          const Triangle& r = mesh_.triangle(static_cast<Triangle_id>(i));
          return std::uint64_t(r.v[Mesh::slot_of_least(r)].value()) << 32 | i;
        });
    const std::size_t n = order_.size();
    sort_words<Chosen_tag>(order_.data(), uncleared_words(n).get(), n, true);
    for_each_block<Chosen_tag>(n, default_block, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (is_first(i)) sort_run(i);
    });
  }

  /// Sorts the triangles with one least vertex, of which this is the first, by their next vertex.
  void sort_run(std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < order_.size() && least_vertex(end) == least_vertex(begin)) ++end;
    const auto is_before = [this](std::uint64_t a, std::uint64_t b) {
      return next_vertex(a) < next_vertex(b);
    };
    if (end == begin + 2) { // frequent, and std::sort() is long
      if (is_before(order_[begin + 1], order_[begin])) std::swap(order_[begin], order_[begin + 1]);
    } else if (end > begin + 2) {
      std::sort(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                order_.begin() + static_cast<std::ptrdiff_t>(end), is_before);
    }
  }

  void name() {
    new_side_.resize(mesh_.triangles.size());
    for_each_index<Chosen_tag>(new_side_.size(), [&](std::size_t i) {
      if (is_kept_[static_cast<Triangle_id>(i)] == 0) new_side_[static_cast<Triangle_id>(i)] = Side::border();
    });
    for_each_index<Chosen_tag>(order_.size(), [&](std::size_t i) {
      const Triangle_id t = triangle_before(i);
      new_side_[t] = Side(static_cast<Triangle_id>(i), Mesh::slot_of_least(mesh_.triangle(t)));
    });
  }

  /// The triangles that vertices know.
  auto first_triangles(Vertex_id end_of_vertices) const {
    decltype(mesh_.triangle_of) first{std::size_t(end_of_vertices)};
    for_each_index<Chosen_tag>(first.size(), [&](std::size_t v) { first[static_cast<Vertex_id>(v)] = {}; });
    for_each_index<Chosen_tag>(order_.size(), [&](std::size_t i) {
      if (is_first(i)) first[least_vertex(i)] = static_cast<Triangle_id>(i);
    });
    for_each_index<Chosen_tag>(first.size(), [&](std::size_t i) {
      const Vertex_id v = static_cast<Vertex_id>(i);
      if (first[v].is_valid() || !mesh_.is_used(v)) return;
      mesh_.for_each_triangle_at(v, [&](Triangle_id t, int) { // none is greater than any
        if (is_kept_[t] != 0) first[v] = std::min(first[v], new_side_[t].triangle());
      });
    });
    return first;
  }

  auto renamed_triangles() const {
    decltype(mesh_.triangles) triangles;
    triangles.reserve(order_.size() + order_.size() / 8); // acute corners are cut soon
    triangles.resize(order_.size());
    for_each_index<Chosen_tag>(order_.size(), [&](std::size_t i) {
      const Triangle& before = mesh_.triangle(triangle_before(i));
      Triangle& r = triangles[static_cast<Triangle_id>(i)];
      int from = Mesh::slot_of_least(before);
      for (int k = 0; k < 3; ++k, from = next_slot[from]) {
        r.v[k] = before.v[from];
        r.side[k] = renamed(before.side[from]);
      }
    });
    return triangles;
  }

  Side renamed(Side o) const {
    if (o.is_border() || new_side_[o.triangle()].is_border()) return Side::border();
    const Side first = new_side_[o.triangle()];
    const int slot = o.slot() - first.slot();
    return Side(first.triangle(), slot < 0 ? slot + 3 : slot, o.is_constrained());
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_KEPT_TRIANGLES_H
