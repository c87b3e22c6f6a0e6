// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_MESH_SIZING_FIELD_2_H
#define CGAL_MESH_SIZING_FIELD_2_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Triangle_tree.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// A sizing field from sizes at the vertices of a mesh, for `Quality_mesh_options_2::size()`: linear in each triangle.
/// Outside the mesh the nearest triangle tells.
///
/// Copies are shallow. Several threads may call it at once. O(k log k) time to build for k triangles. A call takes
/// O(log k) in meshes without small angles.
/// \cgalModels{SizingField_2}
class Mesh_sizing_field_2 {
  using Tree = Quadtree_mesh_2::internal::Triangle_tree;

public:
  /// The field of sizes at the vertices of a mesh.
  /// \param mesh whose triangles are counterclockwise
  /// \param sizes for each vertex the longest edge wanted there; positive for vertices that triangles use
  /// \throws std::invalid_argument if the mesh has no triangles, there are not as many sizes as vertices, or one is not
  /// a positive number; the message names the vertex
  Mesh_sizing_field_2(const Indexed_mesh_2<Tree::Point>& mesh, const std::vector<double>& sizes) {
    if (mesh.triangles.empty()) throw std::invalid_argument("a sizing field of a mesh needs a triangle");
    if (sizes.size() != mesh.points.size())
      throw std::invalid_argument("there are " + std::to_string(sizes.size()) + " sizes for " +
                                  std::to_string(mesh.points.size()) + " vertices");
    check(mesh, sizes);
    std::vector<Entry> entries;
    entries.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
      Entry entry;
      for (std::size_t k = 0; k < 3; ++k)
        entry.corners[k] = mesh.point(t[k]), entry.sizes[k] = sizes[std::size_t(t[k])];
      entries.push_back(entry);
    }
    data_ = std::make_shared<const Data>(Data{Tree(mesh.points, mesh.triangles), std::move(entries)});
  }

  /// The size at (x, y).
  double operator()(double x, double y) const {
    const Tree::Point p(x, y);
    const Entry& entry = data_->entries[std::size_t(data_->tree.nearest(p).triangle)];
    const auto weights = Quadtree_mesh_2::internal::corner_weights(entry.corners, p);
    return weights[0] * entry.sizes[0] + weights[1] * entry.sizes[1] + weights[2] * entry.sizes[2];
  }

private:
  struct Entry {
    Tree::Corners corners;
    std::array<double, 3> sizes;
  };
  struct Data {
    Tree tree;
    std::vector<Entry> entries;
  };

  std::shared_ptr<const Data> data_;

  /// \throws std::invalid_argument naming the first vertex of a triangle whose size is no size
  static void check(const Indexed_mesh_2<Tree::Point>& mesh, const std::vector<double>& sizes) {
    std::vector<char> is_used(sizes.size(), 0);
    for (const auto& t : mesh.triangles)
      for (const auto v : t) is_used[std::size_t(v)] = 1;
    for (std::size_t v = 0; v < sizes.size(); ++v)
      if (is_used[v] != 0 && (!(sizes[v] > 0) || !std::isfinite(sizes[v])))
        throw std::invalid_argument("the size at vertex " + std::to_string(v) + " is not a positive number");
  }
};

} // namespace CGAL

#endif // CGAL_MESH_SIZING_FIELD_2_H
