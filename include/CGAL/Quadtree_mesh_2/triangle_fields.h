// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_TRIANGLE_FIELDS_H
#define CGAL_QUADTREE_MESH_2_TRIANGLE_FIELDS_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// A number for each triangle of a mesh, with a name other than `region`, `marker`, `attribute` and
/// `least_angle`.
struct Triangle_field_2 {
  std::string name;           ///< its name in the file
  std::vector<double> values; ///< finite, in the order of the triangles
};
/// Several fields, in the order in which the file has them.
using Triangle_fields_2 = std::vector<Triangle_field_2>;

/// The value of a function of a place, `f(x, y)`, at the centroid of each triangle.
template <class Point, class Function>
Triangle_field_2 field_at_centroids(std::string name, const Indexed_mesh_2<Point>& mesh, const Function& f) {
  using Quadtree_mesh_2::internal::as_double;
  Triangle_field_2 field{std::move(name), {}};
  field.values.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    double x = 0, y = 0;
    for (const auto v : t) {
      x += as_double(mesh.point(v).x()) / 3;
      y += as_double(mesh.point(v).y()) / 3;
    }
    field.values.push_back(f(x, y));
  }
  return field;
}

/// The level of the leaf at the centroid of each triangle, as "quadtree_level"; -1 outside the tree.
/// \tparam Quadtree a `Balanced_quadtree` of points that can be made from two doubles
template <class Point, class Quadtree>
Triangle_field_2 quadtree_level_field(const Indexed_mesh_2<Point>& mesh, const Quadtree& tree) {
  return field_at_centroids("quadtree_level", mesh, [&tree](double x, double y) {
    const auto leaf = tree.locate(typename Quadtree::Point_2(x, y));
    return leaf.is_valid() ? static_cast<double>(tree.level(leaf)) : -1.;
  });
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_TRIANGLE_FIELDS_H
