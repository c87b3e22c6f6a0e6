// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The constrained Delaunay triangulation of placed vertices, restricted to the domain.
//
// Computes: a mesh of the kernel in which input vertices have their numbers as handles.
// Bound:    as First_triangulation.h: O(k) expected for k vertices, besides sorting.
// Source:   Bern, Eppstein, Teng, section 6; "constrained Delaunay" where the paper triangulates each leaf.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TREE_TRIANGULATION_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TREE_TRIANGULATION_H

#include <CGAL/Quadtree_mesh_2/internal/First_triangulation.h>
#include <CGAL/Quadtree_mesh_2/internal/Kernel_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/Tree_placement.h>
#include <CGAL/Quadtree_mesh_2/internal/domain.h>
#include <CGAL/Quadtree_mesh_2/internal/morton.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What of the plane is meshed.
template <class Geometry>
struct Domain_rule {
  Quality_mesh_options_2::Domain rule = Quality_mesh_options_2::Domain::ENCLOSED;
  std::vector<typename Geometry::Point> holes, regions;

  template <class Mesh>
  void apply(Mesh& mesh, std::size_t number_of_auxiliary_vertices) const {
    Domain_finder<Geometry>(mesh, number_of_auxiliary_vertices).run(rule, holes, regions);
  }
};

/// \param is_merged for each input vertex whether another one stands for it
/// \param grid_point gives the grid point of a point
/// \returns false if pieces of edges cross or nothing is left: coordinates do not suffice. The mesh is as it was
/// then.
template <class Concurrency_tag, class Geometry, class To_grid>
bool triangulate_placed_vertices(const Placed_vertices<Geometry>& placed, const std::vector<char>& is_merged,
                                 const Domain_rule<Geometry>& domain, const To_grid& to_grid,
                                 Kernel_mesh<Geometry>& mesh) {
  using First = First_triangulation<Concurrency_tag, Geometry>;
  const std::vector<std::uint32_t> used = pack<Concurrency_tag>(
      placed.points.size(), [&](std::size_t v) { return v >= is_merged.size() || is_merged[v] == 0; });
  std::vector<std::decay_t<decltype(to_grid(placed.points[0]))>> grid_points(used.size());
  for_each_index<Concurrency_tag>(used.size(),
                                  [&](std::size_t i) { grid_points[i] = to_grid(placed.points[used[i]]); });
  Order order = shuffle_order<Concurrency_tag>(grid_points);
  std::vector<typename Geometry::Point> points(used.size());
  std::vector<Vertex_id> place(placed.points.size(), -1);
  for_each_index<Concurrency_tag>(used.size(), [&](std::size_t i) {
    order[i] = used[order[i]];
    points[i] = placed.points[order[i]];
    place[order[i]] = static_cast<Vertex_id>(i);
  });
  std::vector<typename First::Segment> segments(placed.segments.size());
  for_each_index<Concurrency_tag>(segments.size(), [&](std::size_t s) {
    const auto [a, b] = placed.segments[s];
    segments[s] = {place[std::size_t(a)], place[std::size_t(b)]};
  });
  Kernel_mesh<Geometry> sorted;
  if (First(sorted, points).run(segments)) return false;
  domain.apply(sorted, First::number_of_auxiliary_vertices);
  if (sorted.triangles.empty()) return false;

  mesh = Kernel_mesh<Geometry>();
  mesh.resize(placed.points.size(), 0);
  mesh.points = placed.points, mesh.edge_of = placed.edge_of;
  mesh.triangles = std::move(sorted.triangles), mesh.region_of = std::move(sorted.region_of);
  for_each_index<Concurrency_tag>(mesh.triangles.size(), [&](std::size_t t) {
    for (Vertex_id& v : mesh.triangles[t].v) v = static_cast<Vertex_id>(order[std::size_t(v)]);
  });
  for_each_index<Concurrency_tag>(order.size(),
                                  [&](std::size_t i) { mesh.triangle_of[order[i]] = sorted.triangle_of[i]; });
  return true;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TREE_TRIANGULATION_H
