// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_HALF_EDGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_HALF_EDGES_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The directed edges of a triangle soup, by the vertex that they leave.
///
/// Half-edge `3 t + k` is side `k` of triangle `t`, directed so that `t` is on its left. Construction is
/// linear. It assumes only that indices are in range, so it can help to find the errors of a mesh.
class Half_edges {
public:
  static constexpr std::uint32_t none = 0xffffffffu;
  using Triangles = std::vector<std::array<Vertex_index, 3>>;

  Half_edges(const Triangles& triangles, std::size_t number_of_vertices)
      : triangles_(&triangles), first_(number_of_vertices + 1, 0), out_(3 * triangles.size()) {
    for (const auto& t : triangles)
      for (Vertex_index v : t) ++first_[std::size_t(v) + 1];
    for (std::size_t v = 0; v < number_of_vertices; ++v) first_[v + 1] += first_[v];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t h = 0; h < out_.size(); ++h) out_[next[origin(h)]++] = {h, target(h), apex(h)};
  }

  std::uint32_t origin(std::uint32_t h) const { return vertex(h, 1); }
  std::uint32_t target(std::uint32_t h) const { return vertex(h, 2); }
  /// The vertex of the triangle that is not on the half-edge.
  std::uint32_t apex(std::uint32_t h) const { return vertex(h, 0); }
  std::size_t degree(std::uint32_t v) const { return first_[v + 1] - first_[v]; }
  bool is_used(std::uint32_t v) const { return degree(v) != 0; }

  struct Found {
    std::uint32_t half_edge = none; ///< one of them
    std::uint32_t count = 0;
  };

  /// The half-edges from `a` to `b`. \complexity the lesser degree, so that the hub of a fan costs nothing.
  Found find(std::uint32_t a, std::uint32_t b) const {
    Found found;
    if (degree(a) <= degree(b)) {
      for (std::uint32_t i = first_[a]; i < first_[a + 1]; ++i)
        if (out_[i].target == b) found = {out_[i].half_edge, found.count + 1};
    } else {
      for (std::uint32_t i = first_[b]; i < first_[b + 1]; ++i)
        if (out_[i].apex == a) found = {previous(out_[i].half_edge), found.count + 1};
    }
    return found;
  }
  bool is_edge(std::uint32_t a, std::uint32_t b) const { return find(a, b).count + find(b, a).count != 0; }

  /// Calls `visit(w)` for the neighbors of `v`, most of them twice.
  template <class Visitor>
  void for_each_neighbor(std::uint32_t v, Visitor visit) const {
    for (std::uint32_t i = first_[v]; i < first_[v + 1]; ++i) {
      visit(out_[i].target);
      visit(out_[i].apex);
    }
  }

private:
  struct Out {
    std::uint32_t half_edge, target, apex; // target and apex are copies that save a look at the triangle
  };

  std::uint32_t vertex(std::uint32_t h, std::uint32_t offset) const {
    return (*triangles_)[h / 3][(h + offset - (h / 3) * 3) % 3].value();
  }
  static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

  const Triangles* triangles_;
  std::vector<std::uint32_t> first_;
  std::vector<Out> out_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_HALF_EDGES_H
