// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The connected components of a mesh.
//
// Computes: for each triangle its component. Triangles with a common side are in one component, be the side constrained
//           or not. Components that touch in a vertex are two.
// Bound:    O(n) for n triangles.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_MESH_COMPONENTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_MESH_COMPONENTS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Mesh_component_id = Index<struct Mesh_component_tag>;

/// They are numbered in the order of their first triangles.
class Mesh_components {
public:
  template <class Geometry>
  explicit Mesh_components(const Kernel_mesh<Geometry>& mesh) : component_of_(mesh.triangles.size()) {
    std::vector<Triangle_id> stack;
    for (const Triangle_id first : mesh.triangles.ids()) {
      if (!mesh.is_alive(first) || component_of_[first].is_valid()) continue;
      const Mesh_component_id component(first_.size());
      first_.push_back(members_.size());
      component_of_[first] = component;
      stack.push_back(first);
      while (!stack.empty()) {
        const Triangle_id t = stack.back();
        stack.pop_back();
        members_.push_back(t);
        for (const Side o : mesh.triangle(t).side) {
          if (o.is_border() || component_of_[o.triangle()].is_valid()) continue;
          component_of_[o.triangle()] = component;
          stack.push_back(o.triangle());
        }
      }
    }
    first_.push_back(members_.size());
  }

  std::size_t size() const { return first_.size() - 1; }
  Id_range<Mesh_component_id> ids() const { return Id_range<Mesh_component_id>(0, size()); }
  /// None where the triangle is not alive.
  Mesh_component_id component_of(Triangle_id t) const { return component_of_[t]; }
  Span<Triangle_id> triangles_of(Mesh_component_id c) const {
    const std::size_t i(c);
    return {members_.data() + first_[i], members_.data() + first_[i + 1]};
  }

private:
  Indexed_vector<Triangle_id, Mesh_component_id> component_of_;
  std::vector<std::size_t> first_; // in `members_`, by component
  std::vector<Triangle_id> members_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ISLANDS_MESH_COMPONENTS_H
