// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_BORDER_WINDING_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_BORDER_WINDING_H

#include <CGAL/Constrained_triangulation_2.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Indexed_cdt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// How often the border of a mesh winds around each point of the plane. If all triangles are
/// counterclockwise, this is how many of them cover the point. Computed exactly, by a constrained
/// triangulation of the border; O(b log b) in practice.
template <class Kernel>
class Border_winding {
public:
  using Point = typename Kernel::Point_2;
  using Edge = std::array<std::uint32_t, 2>;

  /// \param edges the border, with the mesh on the left of each edge; its vertices are at different places
  Border_winding(const std::vector<Point>& points, const std::vector<Edge>& edges)
      : cdt_(points, vertices_of(edges)), edges_(edges) {}

  /// Whether border edges meet in common ends only, and no point is covered twice.
  bool is_simple() {
    for (const auto& [a, b] : edges_) cdt_.count_segment(a, b);
    for (const auto& [a, b] : edges_)
      if (!cdt_.has_crossings()) cdt_.insert_segment(a, b);
    if (cdt_.has_crossings()) return false;
    return std::all_of(edges_.begin(), edges_.end(), [&](const Edge& e) { return note_steps(e); }) &&
           is_covered_once_at_most();
  }

private:
  struct Face_info {
    std::array<int, 3> step{0, 0, 0}; // how much more often the face across each side is covered
    std::optional<int> winding;
  };
  using Triangulation =
      Indexed_cdt<Kernel, Face_info, No_constraint_intersection_requiring_constructions_tag>;
  using Face_handle = typename Triangulation::Face_handle;

  static std::vector<std::size_t> vertices_of(const std::vector<Edge>& edges) {
    std::vector<std::size_t> vertices;
    for (const Edge& e : edges) vertices.insert(vertices.end(), e.begin(), e.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  /// \returns false if a vertex is on the edge.
  bool note_steps(const Edge& e) {
    int pieces = 0;
    const bool is_reversed = cdt_.is_reversed(e[0], e[1]);
    cdt_.walk_segment(e[0], e[1], [&](Face_handle f, int i, bool is_left_of_walk) {
      ++pieces;
      const Face_handle g = f->neighbor(i);
      const int more = is_left_of_walk != is_reversed ? -1 : 1; // the mesh is on the left
      f->info().step[std::size_t(i)] += more;
      g->info().step[std::size_t(cdt_.cdt().mirror_index(f, i))] -= more;
    });
    return pieces == 1;
  }

  bool is_covered_once_at_most() {
    if (cdt_.cdt().dimension() < 2) return edges_.empty();
    std::vector<Face_handle> stack{cdt_.cdt().infinite_face()};
    stack.back()->info().winding = 0;
    while (!stack.empty()) {
      const Face_handle f = stack.back();
      stack.pop_back();
      const int winding = *f->info().winding;
      if (winding < 0 || winding > 1) return false;
      for (int i = 0; i < 3; ++i) {
        const Face_handle g = f->neighbor(i);
        if (g->info().winding) continue;
        g->info().winding = winding + f->info().step[std::size_t(i)];
        stack.push_back(g);
      }
    }
    return true;
  }

  Triangulation cdt_;
  const std::vector<Edge>& edges_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_BORDER_WINDING_H
