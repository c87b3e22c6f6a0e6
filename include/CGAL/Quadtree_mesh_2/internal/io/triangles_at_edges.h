// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_TRIANGLES_AT_EDGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_TRIANGLES_AT_EDGES_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

constexpr std::size_t no_triangle = std::numeric_limits<std::size_t>::max();

/// Constrained edges by their ends.
template <class Point>
class Edges_by_ends {
public:
  explicit Edges_by_ends(const Indexed_mesh_2<Point>& mesh)
      : end_of_run_(mesh.points.size(), 0), edges_(mesh.constrained_edges.size()) {
    const auto& edges = mesh.constrained_edges;
    for (const auto& e : edges) ++end_of_run_[lesser_end(e.vertices)];
    std::size_t end = 0; // first of the run before; each edge that is placed moves it on
    for (std::size_t& run : end_of_run_) run = std::exchange(end, end + run);
    for (std::size_t e = 0; e < edges.size(); ++e)
      edges_[end_of_run_[lesser_end(edges[e].vertices)]++] = {greater_end(edges[e].vertices), e};
    for (const Vertex_index v : end_of_run_.ids()) std::sort(begin_of_run(v), end_of_run(v));
  }

  /// Calls `f(e)` for the edges between two vertices, in order. O(log d) for d edges at the lesser one.
  template <class Function>
  void for_each_between(Vertex_index a, Vertex_index b, const Function& f) const {
    const Vertex_index v = std::min(a, b), w = std::max(a, b);
    const auto begin = begin_of_run(v), end = end_of_run(v);
    if (begin == end) return;
    for (auto e = std::lower_bound(begin, end, std::pair(w, std::size_t(0))); e != end && e->first == w; ++e)
      f(e->second);
  }

private:
  using Ends = std::array<Vertex_index, 2>;
  using Edges = std::vector<std::pair<Vertex_index, std::size_t>>; // the greater end, and the edge

  Indexed_vector<Vertex_index, std::size_t> end_of_run_; // of edges with this lesser end
  Edges edges_;

  static Vertex_index lesser_end(const Ends& ends) { return std::min(ends[0], ends[1]); }
  static Vertex_index greater_end(const Ends& ends) { return std::max(ends[0], ends[1]); }

  std::ptrdiff_t begin_index(Vertex_index v) const {
    return v.value() == 0 ? 0 : end_index(Vertex_index(v.value() - 1));
  }
  std::ptrdiff_t end_index(Vertex_index v) const { return static_cast<std::ptrdiff_t>(end_of_run_[v]); }
  typename Edges::iterator begin_of_run(Vertex_index v) { return edges_.begin() + begin_index(v); }
  typename Edges::iterator end_of_run(Vertex_index v) { return edges_.begin() + end_index(v); }
  typename Edges::const_iterator begin_of_run(Vertex_index v) const {
    return edges_.begin() + begin_index(v);
  }
  typename Edges::const_iterator end_of_run(Vertex_index v) const { return edges_.begin() + end_index(v); }
};

/// Per constrained edge, the triangles beside it in their order; `no_triangle` where there is none. From the vertices
/// alone, as meshes made by hand have no neighbors. O(T log d + V + e log d) for T triangles, V vertices, and e edges
/// of which at most d have one lesser end.
template <class Point>
std::vector<std::array<std::size_t, 2>> triangles_at_edges(const Indexed_mesh_2<Point>& mesh) {
  const Edges_by_ends<Point> edges(mesh);
  std::vector<std::array<std::size_t, 2>> result(mesh.constrained_edges.size(), {no_triangle, no_triangle});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      edges.for_each_between(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3], [&](std::size_t e) {
        auto& at = result[e];
        at[at[0] == no_triangle ? 0 : 1] = t;
      });
  return result;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_TRIANGLES_AT_EDGES_H
