// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The triangles beside the edges of a graph, in its constrained Delaunay triangulation.
//
// Computes: for each edge the sides of the two triangles that have it, as far as they are in the domain. So it also
//           tells on which sides of an edge the domain is.
// Bound:    O(n) for n triangles, all at the same time.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_EDGE_TRIANGLES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_EDGE_TRIANGLES_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Input_edges.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Edge_triangles {
public:
  using Mesh = Kernel_mesh<Geometry>;

  /// The sides on an edge of the triangles on the left and on the right of it, where there are such; else the border.
  struct Pair {
    Side left = Side::border(), right = Side::border();

    bool is_any() const { return !left.is_border() || !right.is_border(); }
    /// That of the left triangle, or of the right one where there is none.
    Side any() const { return left.is_border() ? right : left; }
  };

  /// \param mesh the constrained Delaunay triangulation of the graph, in which no edge is cut. It may be restricted to
  ///        the domain, and may have vertices besides those of the graph. It is kept by reference.
  template <class ConcurrencyTag>
  static Edge_triangles of(const Mesh& mesh, const Input_edges& edges, std::size_t number_of_input_vertices) {
    Edge_triangles result(mesh, edges.size());
    for_each_index<ConcurrencyTag>(mesh.triangles.size(), [&](std::size_t i) {
      const Triangle_id t(i);
      for (int k = 0; k < 3 && mesh.is_alive(t); ++k) {
        const Side s(t, k);
        const Vertex_id a = mesh.source(s), b = mesh.target(s);
        if (!mesh.across(s).is_constrained() ||
            std::max(std::size_t(a), std::size_t(b)) >= number_of_input_vertices)
          continue;
        const Edge_id e = edges.between(a, b);
        if (e.is_valid()) (edges[e].a == a ? result.pairs_[e].left : result.pairs_[e].right) = s;
      }
    });
    return result;
  }

  const Mesh& mesh() const { return *mesh_; }
  const Pair& operator[](Edge_id e) const { return pairs_[e]; }
  /// The vertex opposite a side of a pair.
  const typename Geometry::Point& apex(Side s) const { return mesh_->point(mesh_->opposite(s)); }

private:
  const Mesh* mesh_;
  Indexed_vector<Edge_id, Pair> pairs_;

  Edge_triangles(const Mesh& mesh, std::size_t number_of_edges) : mesh_(&mesh), pairs_(number_of_edges) {}
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_THEOREM_5_EDGE_TRIANGLES_H
