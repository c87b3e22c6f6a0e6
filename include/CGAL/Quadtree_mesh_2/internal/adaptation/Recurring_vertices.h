// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Vertices that were left out, and that the mesher has made again at the same place.
//
// They get their numbers back: a mesh begins with the vertices of the old one that it has, in their order. Expected
// linear time.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_RECURRING_VERTICES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_RECURRING_VERTICES_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
class Recurring_vertices {
public:
  using Mesh = Indexed_mesh_2<Point>;

  /// Finds them.
  /// \param[in,out] old_vertex that of the old mesh for the first vertices of the new one; in the end for all, invalid
  /// for those that are new
  Recurring_vertices(const Mesh& old_mesh, const Mesh& mesh, std::vector<Vertex_index>& old_vertex)
      : old_vertex_(old_vertex) {
    std::vector<char> has(old_mesh.points.size(), 0);
    for (const Vertex_index v : old_vertex) has[std::size_t(v)] = 1;
    const auto hash = [](const Place& p) { return std::hash<double>()(p.x) * 31 + std::hash<double>()(p.y); };
    std::unordered_map<Place, Vertex_index, decltype(hash)> left_out(8, hash);
    for (std::size_t v = 0; v < has.size(); ++v)
      if (has[v] == 0)
        left_out.emplace(Place{old_mesh.points[v].x(), old_mesh.points[v].y()}, Vertex_index(v));
    const std::size_t kept = old_vertex.size();
    old_vertex.resize(mesh.points.size());
    for (std::size_t v = kept; v < mesh.points.size() && !left_out.empty(); ++v) {
      const auto found = left_out.find({mesh.points[v].x(), mesh.points[v].y()});
      if (found != left_out.end()) old_vertex[v] = found->second;
    }
  }

  /// Puts the vertices into their order: those of the old mesh in its order, then the new ones.
  /// \returns per vertex before, its index now; empty if nothing was to do
  std::vector<Vertex_index> sort(Mesh& mesh) {
    std::vector<Vertex_index> order(mesh.points.size());
    for (std::size_t v = 0; v < order.size(); ++v) order[v] = Vertex_index(v);
    // Those that are new have the greatest index, the invalid one.
    const auto is_before = [&](Vertex_index a, Vertex_index b) {
      return old_vertex_[std::size_t(a)] < old_vertex_[std::size_t(b)];
    };
    if (std::is_sorted(order.begin(), order.end(), is_before)) return {};
    std::stable_sort(order.begin(), order.end(), is_before);
    std::vector<Vertex_index> new_index(order.size());
    for (std::size_t v = 0; v < order.size(); ++v) new_index[std::size_t(order[v])] = Vertex_index(v);
    permute(old_vertex_, order);
    permute(mesh.points, order);
    permute(mesh.segment_of_vertex, order);
    permute(mesh.vertex_markers, order);
    const auto rename = [&](Vertex_index& v) {
      if (v.is_valid()) v = new_index[std::size_t(v)];
    };
    for (auto& t : mesh.triangles)
      for (Vertex_index& v : t) rename(v);
    for (auto& e : mesh.constrained_edges)
      rename(e.vertices[0]), rename(e.vertices[1]), rename(e.outer_vertex);
    return new_index;
  }

private:
  struct Place {
    double x, y;
    friend bool operator==(const Place& a, const Place& b) { return a.x == b.x && a.y == b.y; }
  };

  std::vector<Vertex_index>& old_vertex_;

  template <class T>
  static void permute(std::vector<T>& values, const std::vector<Vertex_index>& order) {
    std::vector<T> result;
    result.reserve(values.size());
    for (const Vertex_index v : order) result.push_back(values[std::size_t(v)]);
    values = std::move(result);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_RECURRING_VERTICES_H
