// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_CAVITY_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_CAVITY_H

#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The triangles whose circles hold a place, and from which constrained edges do not hide it: a vertex there would be
/// joined with their corners.
template <class Geometry>
class Cavity {
public:
  using Point = typename Geometry::Point;

  explicit Cavity(const Kernel_mesh<Geometry>& mesh) : mesh_(mesh) {}

  /// Calls `f(side)` for all sides of all of them, until it returns false.
  /// \param holders the triangle with q in it, or both with q on their side; invalid handles do not count
  /// \returns false then
  template <class Function>
  bool visit_sides(std::initializer_list<Triangle_id> holders, const Point& q, const Function& f) {
    triangles_.clear();
    for (const Triangle_id t : holders)
      if (t.is_valid()) triangles_.push_back(t);
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const Side s(triangles_[i], k), o = mesh_.across(s);
        if (!f(s)) return false;
        if (!o.is_constrained() && !has(o.triangle()) && is_in_circle(o.triangle(), q))
          triangles_.push_back(o.triangle());
      }
    return true;
  }

private:
  const Kernel_mesh<Geometry>& mesh_;
  std::vector<Triangle_id> triangles_;

  bool has(Triangle_id t) const {
    return std::find(triangles_.begin(), triangles_.end(), t) != triangles_.end();
  }

  bool is_in_circle(Triangle_id t, const Point& q) const {
    const auto& v = mesh_.triangle(t).v;
    return Basic_in_circle<typename Geometry::Number>(Geometry::scaled_difference(mesh_.point(v[0]), q),
                                                      Geometry::scaled_difference(mesh_.point(v[1]), q),
                                                      Geometry::scaled_difference(mesh_.point(v[2]), q))
        .is_positive();
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_CAVITY_H
