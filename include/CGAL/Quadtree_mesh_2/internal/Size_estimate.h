// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// How many triangles a mesh will need, from the constrained Delaunay triangulation of its domain alone.
//
// The number of triangles of any mesh with a bound on the least angle is, up to constants, the integral of
// 1/lfs^2 over the domain, lfs the local feature size (Ruppert, 1995). Three kinds of places make it large,
// and each shows in the triangulation:
//  - each triangle with longest edge L and height h over it asks for about log(L/h) layers, for points as in
//    Bern, Eppstein and Gilbert (1994);
//  - two constrained edges that face each other across a gap g over a length l ask for about l/g triangles.
//    Such a pair meets at some vertex's fan: one is at the vertex (the first or last edge of a sector of its
//    triangles) and the other closes a triangle of the sector, or two consecutive ones close triangles of it;
//  - bounds of size ask for area over the area of one triangle.
// Edges that share a vertex are not counted as facing: wedges are cut off by rings (Acute_corners.h), whose
// number grows with the logarithm only.
//
// O(n), and at most about `field_samples` calls of the size field. The constants are measured, so that
// the estimate is within a factor of 4 of the true number on maps, on the hard families of the tests and for
// bounds of size (test_size_estimate.cpp).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SIZE_ESTIMATE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SIZE_ESTIMATE_H

#include <CGAL/Quadtree_mesh_2/internal/Meshing_state.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Geometry>
class Size_estimate {
public:
  using Point = typename Geometry::Point;

  /// Two constrained edges that face each other, by their ends, and what they ask for.
  struct Pair {
    Vertex_id a[2] = {-1, -1}, b[2] = {-1, -1};
    double triangles = 0;
  };

  /// \pre the mesh is the first triangulation, restricted to the domain.
  explicit Size_estimate(const Meshing_state<Geometry>& state)
      : state_(state), mesh_(state.mesh), least_(std::sqrt(state.bounds.least_squared_length)) {
    for (const auto& r : mesh_.triangles) total_area2_ += mesh_.shape(r).area2;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) add_triangle(static_cast<Triangle_id>(t));
    add_facing_edges();
  }

  double triangles() const { return of_shapes_ + of_pairs_ + of_sizes_; }
  /// What bounds of size ask for alone.
  double triangles_of_sizes() const { return of_sizes_; }
  /// The pair that asks for most.
  const Pair& worst_pair() const { return worst_; }

private:
  static constexpr double per_triangle = 1.5;
  static constexpr double per_layer = 0.7;
  static constexpr double per_gap = 2;
  /// The area of a triangle that a bound on areas leads to, as a share of the bound.
  static constexpr double share_of_area = 0.55;
  /// The same for a bound h on edges, as a share of h^2.
  static constexpr double share_of_squared_edge = 0.28;
  static constexpr double field_samples = 20000;

  const Meshing_state<Geometry>& state_;
  const Kernel_mesh<Geometry>& mesh_;
  double least_;
  double total_area2_ = 0;
  double of_shapes_ = 0, of_pairs_ = 0, of_sizes_ = 0;
  Pair worst_;

  void add_triangle(Triangle_id t) {
    const auto& r = mesh_.triangle(t);
    const Shape s = mesh_.shape(r);
    int constrained = 0;
    for (const Side o : r.side) constrained += o.is_constrained() ? 1 : 0;
    double aspect = s.longest() / s.area2;
    if (least_ > 0) aspect = std::min(aspect, std::sqrt(s.longest()) / least_);
    of_shapes_ += per_triangle;
    if (constrained < 2 && aspect > 2) of_shapes_ += per_layer * std::log2(aspect / 2);
    add_sizes(t, s);
  }

  void add_sizes(Triangle_id t, const Shape& s) {
    const Bounds<Geometry>& bounds = state_.bounds;
    if (!bounds.is_size_bounded()) return;
    double area2 = bounds.area2;
    if (!bounds.area2_of_region.empty() && mesh_.region(t) >= 0)
      area2 = std::min(area2, bounds.area2_of_region[std::size_t(mesh_.region(t))]);
    double per_area2 = std::max(1 / (share_of_area * area2),
                                0.5 / (share_of_squared_edge * bounds.squared_length));
    if (bounds.squared_length_at) per_area2 = std::max(per_area2, field_density(t, s));
    const double finest = least_ > 0 ? 0.5 / (share_of_squared_edge * least_ * least_) : per_area2;
    of_sizes_ += s.area2 * std::min(per_area2, finest);
  }

  /// The mean of the density that the size field asks for in t, at the centres of k^2 parts of equal area.
  double field_density(Triangle_id t, const Shape& s) const {
    const auto& r = mesh_.triangle(t);
    const Point& a = mesh_.point(r.v[0]);
    const Vector ab = Geometry::difference(mesh_.point(r.v[1]), a),
                 ac = Geometry::difference(mesh_.point(r.v[2]), a);
    const int k = static_cast<int>(std::ceil(std::sqrt(field_samples * s.area2 / total_area2_)));
    double sum = 0;
    for (int i = 0; i < k; ++i)
      for (int j = 0; i + j < k; ++j)
        for (const double third : {1. / 3, 2. / 3}) {
          if (third > 0.5 && i + j + 1 == k) continue; // no second part at the border
          const Point p = Geometry::translate(a, ((i + third) / k) * ab + ((j + third) / k) * ac);
          sum += 0.5 / (share_of_squared_edge * state_.bounds.squared_length_at(p));
        }
    return sum / (static_cast<double>(k) * k);
  }

  // ---- edges that face each other

  /// Visits each sector of triangles at each vertex, from one constrained side to the next, once.
  void add_facing_edges() {
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const Triangle_id t = static_cast<Triangle_id>(i);
        const auto& r = mesh_.triangle(t);
        if (r.side[previous_slot[k]].is_constrained())
          add_sector(t, k);
        else if (mesh_.incident_triangle(r.v[k]) == t)
          add_whole_star(t, k);
      }
  }

  /// The sector that begins at the side from v[k] to v[k + 1] of t.
  void add_sector(Triangle_id t, int k) {
    const Vertex_id apex = mesh_.triangle(t).v[k];
    const Vertex_id first[2] = {apex, mesh_.triangle(t).v[next_slot[k]]};
    Facing facing;
    std::vector<Side>& opposite = opposite_;
    opposite.clear();
    for (;;) {
      const auto& r = mesh_.triangle(t);
      if (r.side[k].is_constrained()) opposite.push_back(Side(t, k));
      const Side next = r.side[next_slot[k]];
      if (next.is_constrained()) break;
      t = next.triangle();
      k = next_slot[next.slot()];
    }
    const Vertex_id last[2] = {apex, mesh_.triangle(t).v[previous_slot[k]]};
    for (const Side s : opposite) {
      add_pair(first, s);
      if (last[1] != first[1]) add_pair(last, s);
    }
    add_consecutive();
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SIZE_ESTIMATE_H
