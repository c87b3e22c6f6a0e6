// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_MESH_RENUMBERER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_MESH_RENUMBERER_H

// Puts the arrays of a mesh into another order.
//
// Computes: the vertices in shuffle order, or with those of the input in front; then triangles and constrained edges,
//           each from its least vertex on, by their least vertex and the one behind it.
// Bound:    O(n) work by digits (sort_by_keys.h); one array is copied at a time.
// Source:   the shuffle order of Bern, Eppstein, Teng (grid/morton.h).
// Deviates: places whose squares of 2^-62 times the whole are the same are compared by x, then y, then index, so that
//           the order depends on places and the input's indices alone.

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Place_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Tag, class Point>
class Mesh_renumberer {
public:
  explicit Mesh_renumberer(Indexed_mesh_2<Point>& mesh) : mesh_(mesh) {}

  /// Vertices, triangles and constrained edges by their places.
  void by_place() {
    fill_input_index();
    apply_to_vertices(order_by_place());
    begin_triangles_at_least_vertices();
    apply_to_triangles();
    apply_to_edges();
  }

  /// Vertices alone: those of the input in front.
  void by_input() {
    if (mesh_.input_index.empty()) return;
    const std::vector<Vertex_index>& input = mesh_.input_index;
    const std::size_t n = input.size();
    Order order(n);
    std::size_t next = mesh_.number_of_input_vertices;
    for (std::size_t v = 0; v < n; ++v)
      order[input[v].is_valid() ? std::size_t(input[v]) : next++] = static_cast<std::uint32_t>(v);
    apply_to_vertices(order);
    free_arrays(mesh_.input_index);
  }

  /// Per vertex and triangle before, its index now; that of triangles is empty if they stay.
  std::vector<Vertex_index> take_new_vertex() { return std::move(new_vertex_); }
  std::vector<Triangle_index> take_new_triangle() { return std::move(new_triangle_); }

private:
  void fill_input_index() {
    if (!mesh_.input_index.empty()) return;
    mesh_.input_index.resize(mesh_.points.size());
    for_each_index<Tag>(mesh_.number_of_input_vertices,
                        [this](std::size_t v) { mesh_.input_index[v] = Vertex_index(v); });
  }

  Order order_by_place() const {
    const Place_grid grid(box_of_points());
    const auto square_at = [this, &grid](std::size_t v) {
      return grid(as_double(mesh_.points[v].x()), as_double(mesh_.points[v].y()));
    };
    const auto less = [this](std::uint32_t v, std::uint32_t w) { return is_before_in_square(v, w); };
    return std::move(sorted_by_place<Tag>(mesh_.points.size(), square_at, less).order);
  }

  Double_box box_of_points() const {
    return reduce<Tag>(
        mesh_.points.size(), Double_box(),
        [this](std::size_t begin, std::size_t end) {
          Double_box box;
          for (std::size_t v = begin; v < end; ++v)
            box.add(as_double(mesh_.points[v].x()), as_double(mesh_.points[v].y()));
          return box;
        },
        [](Double_box a, const Double_box& b) {
          a.merge(b);
          return a;
        });
  }

  bool is_before_in_square(std::uint32_t v, std::uint32_t w) const {
    const Point &p = mesh_.points[v], &q = mesh_.points[w];
    if (p.x() != q.x()) return p.x() < q.x();
    if (p.y() != q.y()) return p.y() < q.y();
    if (mesh_.input_index[v] != mesh_.input_index[w]) return mesh_.input_index[v] < mesh_.input_index[w];
    return v < w;
  }

  void apply_to_vertices(const Order& order) {
    new_vertex_ = inverse_of<Vertex_index>(order);
    permute(mesh_.points, order);
    permute(mesh_.segment_of_vertex, order);
    permute(mesh_.vertex_markers, order);
    permute(mesh_.input_index, order);
    for_each_index<Tag>(mesh_.triangles.size(), [this](std::size_t t) {
      for (Vertex_index& v : mesh_.triangles[t]) v = new_index(v);
    });
    for_each_index<Tag>(mesh_.constrained_edges.size(), [this](std::size_t e) {
      auto& edge = mesh_.constrained_edges[e];
      for (Vertex_index& v : edge.vertices) v = new_index(v);
      if (edge.outer_vertex.is_valid()) edge.outer_vertex = new_index(edge.outer_vertex);
    });
  }
  Vertex_index new_index(Vertex_index v) const { return new_vertex_[std::size_t(v)]; }

  void begin_triangles_at_least_vertices() {
    for_each_index<Tag>(mesh_.triangles.size(), [this](std::size_t t) {
      auto& triangle = mesh_.triangles[t];
      const auto first = std::min_element(triangle.begin(), triangle.end()) - triangle.begin();
      std::rotate(triangle.begin(), triangle.begin() + first, triangle.end());
      if (mesh_.neighbors.empty()) return;
      auto& neighbors = mesh_.neighbors[t];
      std::rotate(neighbors.begin(), neighbors.begin() + first, neighbors.end());
    });
  }

  void apply_to_triangles() {
    const Order order = radix_order<Tag>(mesh_.triangles.size(), [this](std::size_t t) {
      return key_of(mesh_.triangles[t][0], mesh_.triangles[t][1]);
    });
    new_triangle_ = inverse_of<Triangle_index>(order);
    permute(mesh_.triangles, order);
    permute(mesh_.region_of_triangle, order);
    permute(mesh_.neighbors, order);
    for_each_index<Tag>(mesh_.neighbors.size(), [this](std::size_t t) {
      for (Triangle_index& u : mesh_.neighbors[t])
        if (u.is_valid()) u = new_triangle_[std::size_t(u)];
    });
  }

  void apply_to_edges() {
    permute(mesh_.constrained_edges, radix_order<Tag>(mesh_.constrained_edges.size(), [this](std::size_t e) {
              const auto& [a, b] = mesh_.constrained_edges[e].vertices;
              return key_of(std::min(a, b), std::max(a, b));
            }));
  }

  static std::uint64_t key_of(Vertex_index a, Vertex_index b) {
    return std::uint64_t(a.value()) << 32 | b.value();
  }

  template <class Id>
  static std::vector<Id> inverse_of(const Order& order) {
    std::vector<Id> inverse(order.size());
    for_each_index<Tag>(order.size(), [&](std::size_t i) { inverse[order[i]] = Id(i); });
    return inverse;
  }

  /// Arrays that the mesh has not stay empty.
  template <class T>
  static void permute(std::vector<T>& values, const Order& order) {
    if (values.empty()) return;
    std::vector<T> result(values.size());
    for_each_index<Tag>(values.size(), [&](std::size_t i) { result[i] = std::move(values[order[i]]); });
    values = std::move(result);
  }

  Indexed_mesh_2<Point>& mesh_;
  std::vector<Vertex_index> new_vertex_;
  std::vector<Triangle_index> new_triangle_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_MESH_RENUMBERER_H
