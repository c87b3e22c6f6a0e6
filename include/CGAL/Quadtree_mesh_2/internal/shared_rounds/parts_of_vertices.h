// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_PARTS_OF_VERTICES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_PARTS_OF_VERTICES_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_handles.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Which parts get a vertex. Most have one.
struct Vertex_parts {
  Indexed_vector<Vertex_id, int> first; ///< part 0 for those without a triangle
  std::vector<std::pair<Vertex_id, int>> others;
};

/// The parts of the triangles of each vertex. O(n), and O(k log k) for k vertices with several.
/// \param part_of `part_of(mesh, t)` is the part of a triangle that is alive in a mesh
template <class Mesh, class Part_of>
Vertex_parts parts_of_vertices(const Mesh& mesh, const Part_of& part_of) {
  constexpr int none = -1;
  Vertex_parts parts;
  parts.first.assign(mesh.number_of_vertices(), none);
  for (const auto t : mesh.triangles.ids()) {
    if (!mesh.is_alive(t)) continue;
    const int part = part_of(mesh, t);
    for (const Vertex_id v : mesh.triangle(t).v) {
      int& first = parts.first[v];
      if (first == none)
        first = part;
      else if (first != part)
        parts.others.emplace_back(v, part);
    }
  }
  std::replace(parts.first.begin(), parts.first.end(), none, 0);
  sort_and_drop_equal(parts.others);
  return parts;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_PARTS_OF_VERTICES_H
