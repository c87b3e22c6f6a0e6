// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_ADAPTED_MESH_2_H
#define CGAL_ADAPTED_MESH_2_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Where the vertices of a new mesh are in the old one, so that values can be carried over.
struct Mesh_transfer_2 {
  /// A place in a triangle of the old mesh.
  struct Place {
    /// The triangle; invalid for a vertex that no triangle of the old mesh uses.
    Quadtree_mesh_2::Triangle_index triangle;
    /// Barycentric coordinates in it: not negative, with the sum 1 up to rounding. They are exactly 1, 0 and 0 at a
    /// vertex of the old mesh.
    std::array<double, 3> weights{};
  };

  /// Per vertex of the new mesh, the vertex of the old mesh that it is, with the same coordinates bit for bit; invalid
  /// for one that is new.
  std::vector<Quadtree_mesh_2::Vertex_index> old_vertex;
  /// Per vertex of the new mesh, its place in the old one. A new vertex on the border, which is rounded, may be a
  /// rounding outside; it has the weights of the nearest place.
  std::vector<Place> places;

  /// Values for the new mesh, linear in each triangle of the old one. A vertex of the old mesh keeps its value, bit for
  /// bit.
  /// \param old_mesh the old mesh
  /// \param values one for each vertex of the old mesh
  template <class Mesh>
  std::vector<double> carry_over(const Mesh& old_mesh, const std::vector<double>& values) const {
    std::vector<double> result(places.size());
    for (std::size_t v = 0; v < places.size(); ++v) {
      if (old_vertex[v].is_valid()) {
        result[v] = values[std::size_t(old_vertex[v])];
        continue;
      }
      const auto& corners = old_mesh.triangles[std::size_t(places[v].triangle)];
      for (std::size_t k = 0; k < 3; ++k) result[v] += places[v].weights[k] * values[std::size_t(corners[k])];
    }
    return result;
  }
};

/// \ingroup PkgQuadtreeMesh2Meshers
/// What `refine_mesh_2()` and `adapt_mesh_2()` make.
struct Adapted_mesh_2 {
  /// The new mesh, of the same graph as the old one. It begins with the vertices of the old mesh that it has, in their
  /// order. Segments and regions are those of the graph.
  Indexed_mesh_2<Exact_predicates_inexact_constructions_kernel::Point_2> mesh;
  /// What was reached. Vertices of the old mesh count as input.
  Quality_mesh_report_2 report;
  /// Where its vertices are in the old mesh.
  Mesh_transfer_2 transfer;
};

} // namespace CGAL

#endif // CGAL_ADAPTED_MESH_2_H
