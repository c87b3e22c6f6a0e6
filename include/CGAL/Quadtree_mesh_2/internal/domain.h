// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Restricts the first triangulation to the domain: everything that constrained edges separate from infinity,
// less the components with a hole's point. O(n), and a walk for each hole.
//
// From here on the mesh is the domain alone, and no walk leaves it: features behind an outside gap, however
// thin, are not seen and force nothing (distances are geodesic).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DOMAIN_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DOMAIN_H

#include <CGAL/Quadtree_mesh_2/internal/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/walk.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Marks what is reached from the marked triangles on the stack without crossing a constrained side.
template <class Geometry>
void flood(const Kernel_mesh<Geometry>& mesh, std::vector<Triangle_id>& stack, std::vector<char>& is_marked) {
  while (!stack.empty()) {
    const Triangle_id t = stack.back();
    stack.pop_back();
    for (const Side o : mesh.triangle(t).side) {
      if (o.is_constrained() || is_marked[std::size_t(o.triangle())] != 0) continue;
      is_marked[std::size_t(o.triangle())] = 1;
      stack.push_back(o.triangle());
    }
  }
}

/// Drops the marked triangles and the last `number_of_auxiliary_vertices` vertices; keeps the order of the
/// others.
template <class Geometry>
void drop_marked(Kernel_mesh<Geometry>& mesh, const std::vector<char>& is_marked,
                 std::size_t number_of_auxiliary_vertices) {
  std::vector<Triangle_id> new_id(mesh.triangles.size(), -1);
  Triangle_id kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (is_marked[t] == 0) new_id[t] = kept++;

  const std::size_t n = mesh.points.size() - number_of_auxiliary_vertices;
  mesh.points.resize(n), mesh.edge_of.resize(n), mesh.is_dirty.resize(n);
  mesh.triangle_of.assign(n, -1);
  for (std::size_t t = 0; t < new_id.size(); ++t) {
    if (new_id[t] < 0) continue;
    auto r = mesh.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const Side o = r.side[k];
      const Triangle_id u = o.is_border() ? -1 : new_id[std::size_t(o.triangle())];
      r.side[k] = u < 0 ? Side::border() : Side(u, o.slot(), o.is_constrained());
      mesh.triangle_of[std::size_t(r.v[k])] = new_id[t];
    }
    mesh.triangle(new_id[t]) = r;
  }
  mesh.triangles.resize(std::size_t(kept));
}

/// Keeps the domain only; the mesh is empty afterwards if no constrained edges enclose anything.
template <class Geometry>
void keep_domain(Kernel_mesh<Geometry>& mesh, const std::vector<typename Geometry::Point>& holes,
                 std::size_t number_of_auxiliary_vertices) {
  std::vector<char> is_outside(mesh.triangles.size(), 0);
  std::vector<Triangle_id> stack;
  const auto mark = [&](Triangle_id t) {
    if (is_outside[std::size_t(t)] != 0) return;
    is_outside[std::size_t(t)] = 1;
    stack.push_back(t);
  };
  const Vertex_id auxiliary = static_cast<Vertex_id>(mesh.points.size() - number_of_auxiliary_vertices);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const Vertex_id v : mesh.triangles[t].v)
      if (v >= auxiliary) mark(static_cast<Triangle_id>(t));
  for (const auto& hole : holes) {
    const Walk_end end = locate_exactly(mesh, Triangle_id(0), hole);
    if (!end.is_blocked()) mark(end.triangle);
  }
  flood(mesh, stack, is_outside);
  drop_marked(mesh, is_outside, number_of_auxiliary_vertices);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DOMAIN_H
