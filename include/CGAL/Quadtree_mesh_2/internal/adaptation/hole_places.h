// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A place in each hole of a mesh.
//
// Computes: a place in each bounded component of the plane that the mesh does not cover.
// Bound:    O(b log b + h log k) expected time for b edges on the border, h components and k triangles.
// Method:   A constrained triangulation of the border edges, whose components are asked for.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_HOLE_PLACES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_HOLE_PLACES_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Given_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/mesh_2/mark_domain.h>

#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// \throws Pslg_error_2 if coordinates have no room for a place in one
inline std::vector<Triangle_tree::Point> hole_places(const Given_mesh& given) {
  using Cdt = Constrained_Delaunay_triangulation_2<Triangle_tree::Kernel>;
  using Face_handle = Cdt::Face_handle;
  const auto& mesh = given.mesh();
  std::vector<std::pair<Triangle_tree::Point, Triangle_tree::Point>> border;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (!given.neighbors()[t][k].is_valid())
        border.emplace_back(mesh.point(mesh.triangles[t][(k + 1) % 3]),
                            mesh.point(mesh.triangles[t][(k + 2) % 3]));
  Cdt cdt;
  for (const auto& [a, b] : border) cdt.insert_constraint(a, b);

  std::unordered_set<const Cdt::Face*> reached;
  const auto visit = [&](Face_handle f) { return reached.insert(&*f).second; };
  flood_component<Cdt>(cdt.infinite_face(), visit, [](Face_handle) {});
  std::vector<Triangle_tree::Point> places;
  for (const Face_handle first : cdt.finite_face_handles()) {
    if (reached.count(&*first) > 0) continue;
    Inner_place place;
    flood_component<Cdt>(
        first,
        [&](Face_handle f) {
          if (!visit(f)) return false;
          place.offer({f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()});
          return true;
        },
        [](Face_handle) {});
    const auto inside = place.get();
    if (!inside)
      throw Pslg_error_2(Pslg_error_2::Kind::ROUNDING,
                         "a hole of the mesh is too thin: the coordinates have no room for a point in it");
    if (given.tree().nearest(*inside).squared_distance > 0) places.push_back(*inside);
  }
  return places;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_HOLE_PLACES_H
