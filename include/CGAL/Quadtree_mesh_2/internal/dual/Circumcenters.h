// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The circumcenters of a mesh, and which of them are out of sight.
//
// Computes: the circumcenters; walls, which are the sides on the border and those that are not Delaunay; the wall that
//           each circumcenter is beyond, if any; and which circumcenters are one place up to rounding.
// Bound:    O(1) for each triangle, and for each obtuse one the triangles between it and its circumcenter.
// Method:   A circumcenter is beyond at most one side of its triangle, that opposite an obtuse angle. If it is beyond
//           another side of the triangle behind that one, so is the circumcenter of that triangle: it is farther out on
//           the same bisector. So the way to a circumcenter leads through sides opposite obtuse angles alone. The first
//           wall on it is the one that hides the circumcenter.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DUAL_CIRCUMCENTERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DUAL_CIRCUMCENTERS_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/Edge_finder.h>
#include <CGAL/Quadtree_mesh_2/mesh_edges_types.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Dual_place = std::array<double, 2>;

inline double distance_between(const Dual_place& p, const Dual_place& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1]);
}
/// Positive if the angle between the vectors from `o` to `p` and to `q` is counterclockwise.
inline double cross_at(const Dual_place& o, const Dual_place& p, const Dual_place& q) {
  return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
}

/// The circumcenter of a triangle; the midpoint of its longest side if doubles cannot tell it from a flat one.
inline Dual_place circumcenter_of(const Dual_place& a, const Dual_place& b, const Dual_place& c) {
  const double extent = std::max({std::abs(b[0] - a[0]), std::abs(b[1] - a[1]), std::abs(c[0] - a[0]),
                                  std::abs(c[1] - a[1]), std::numeric_limits<double>::min()});
  const double bx = (b[0] - a[0]) / extent, by = (b[1] - a[1]) / extent, cx = (c[0] - a[0]) / extent,
               cy = (c[1] - a[1]) / extent;
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy, f = 0.5 / (bx * cy - by * cx);
  const Dual_place center{a[0] + extent * (f * (cy * b2 - by * c2)),
                          a[1] + extent * (f * (bx * c2 - cx * b2))};
  if (std::isfinite(center[0]) && std::isfinite(center[1])) return center;
  const double bc2 = (bx - cx) * (bx - cx) + (by - cy) * (by - cy);
  const Dual_place &p = c2 >= b2 || bc2 >= b2 ? c : b, &q = bc2 >= std::max(b2, c2) ? b : a;
  return {0.5 * p[0] + 0.5 * q[0], 0.5 * p[1] + 0.5 * q[1]};
}

/// A mesh as its circumcenters see it. Sides are numbered: side `k` of triangle `t` is `3 t + k`.
template <class ConcurrencyTag, class Point>
class Circumcenters {
public:
  using Side_number = std::uint32_t;
  static constexpr Side_number no_side = std::numeric_limits<Side_number>::max();

  /// Keeps references.
  Circumcenters(const Indexed_mesh_2<Point>& mesh,
                const std::vector<std::array<Triangle_index, 3>>& neighbors,
                const std::vector<Mesh_edge_2>& edges)
      : mesh_(mesh), neighbors_(neighbors), edges_(edges) {
    find_centers();
    find_walls();
    find_hidden();
    merge();
  }

  bool is_wall(std::size_t edge) const { return is_wall_[edge] != 0; }
  /// The wall that a circumcenter is beyond, as the side that is seen from within; `no_side` if it is in sight.
  Side_number wall_before(Triangle_index t) const { return wall_before_[std::size_t(t)]; }
  /// The first triangle with this circumcenter, up to rounding.
  std::uint32_t representative(Triangle_index t) const {
    return representative_.empty() ? t.value() : representative_[std::size_t(t)];
  }
  /// Whether a place is a circumcenter, up to rounding.
  bool is_center(const Dual_place& p, Triangle_index t) const {
    const std::size_t r = representative(t);
    return distance_between(centers_[r], p) <= tolerance(r, place(vertex(t, 0)));
  }
  const Dual_place& center(Triangle_index t) const { return centers_[std::size_t(t)]; }
  /// The side of triangle `t` that an edge is.
  Side_number side_at(Triangle_index t, const Mesh_edge_2& e) const {
    return 3 * t.value() +
           static_cast<Side_number>(side_between(mesh_.triangles[std::size_t(t)], e.vertices));
  }
  Dual_place place(Vertex_index v) const {
    return {as_double(mesh_.point(v).x()), as_double(mesh_.point(v).y())};
  }
  /// The ends of a side, the triangle on the left.
  std::array<Dual_place, 2> ends(Side_number s) const {
    const Triangle_index t(s / 3);
    return {place(vertex(t, (s + 1) % 3)), place(vertex(t, (s + 2) % 3))};
  }

private:
  const Indexed_mesh_2<Point>& mesh_;
  const std::vector<std::array<Triangle_index, 3>>& neighbors_;
  const std::vector<Mesh_edge_2>& edges_;
  std::vector<Dual_place> centers_;
  std::vector<char> is_wall_;                 // per edge
  std::vector<char> is_wall_at_;              // per side
  std::vector<Side_number> wall_before_;      // per triangle
  std::vector<std::uint32_t> coincident_;     // edges between triangles with one circumcenter
  std::vector<std::uint32_t> representative_; // per triangle; empty if each is its own

  Vertex_index vertex(Triangle_index t, std::uint32_t k) const {
    return mesh_.triangles[std::size_t(t)][k % 3];
  }

  void find_centers() {
    centers_.resize(mesh_.triangles.size());
    for_each_index<ConcurrencyTag>(centers_.size(), [this](std::size_t t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      centers_[t] = circumcenter_of(place(a), place(b), place(c));
    });
  }

  /// Within which circumcenters are taken for one: what rounding may do to them, and a little more.
  double tolerance(std::size_t t, const Dual_place& vertex) const {
    constexpr double of_radius = 0x1p-40, of_coordinates = 0x1p-50;
    return of_radius * distance_between(centers_[t], vertex) +
           of_coordinates * std::max(std::abs(vertex[0]), std::abs(vertex[1]));
  }

  /// On the bisector of an edge that is Delaunay, the circumcenters of its triangles are in the order of these.
  void find_walls() {
    enum : char { NO_WALL, WALL, COINCIDENT };
    is_wall_.resize(edges_.size());
    for_each_index<ConcurrencyTag>(edges_.size(), [&](std::size_t i) {
      const Mesh_edge_2& e = edges_[i];
      if (e.is_on_border()) return static_cast<void>(is_wall_[i] = WALL);
      const std::size_t t(e.triangles[0]), u(e.triangles[1]);
      const Dual_place a = place(e.vertices[0]), b = place(e.vertices[1]);
      const double x = centers_[u][0] - centers_[t][0], y = centers_[u][1] - centers_[t][1];
      if (std::hypot(x, y) <= tolerance(t, a) + tolerance(u, a))
        is_wall_[i] = COINCIDENT;
      else // t is on the left, and the way to u leads to the right
        is_wall_[i] = (b[1] - a[1]) * x - (b[0] - a[0]) * y > 0 ? NO_WALL : WALL;
    });
    coincident_ =
        pack<ConcurrencyTag>(edges_.size(), [this](std::size_t i) { return is_wall_[i] == COINCIDENT; });
    for (const std::uint32_t i : coincident_) is_wall_[i] = NO_WALL;
    is_wall_at_.assign(3 * mesh_.triangles.size(), 0);
    for_each_index<ConcurrencyTag>(edges_.size(), [this](std::size_t i) {
      if (is_wall_[i] != 0)
        for (const Triangle_index t : edges_[i].triangles)
          if (t.is_valid()) is_wall_at_[side_at(t, edges_[i])] = 1;
    });
  }

  void find_hidden() {
    wall_before_.resize(mesh_.triangles.size());
    for_each_index<ConcurrencyTag>(wall_before_.size(),
                                   [this](std::size_t t) { wall_before_[t] = find_wall_before(t); });
  }

  Side_number find_wall_before(std::size_t t) const {
    const Dual_place& center = centers_[t];
    Triangle_index at(t);
    for (std::size_t step = 0; step < centers_.size(); ++step) { // rounding could lead in circles
      const Side_number s = side_opposite_obtuse_angle(at);
      if (s == no_side) return no_side;
      const auto [a, b] = ends(s);
      if (cross_at(a, b, center) >= -tolerance(t, a) * distance_between(a, b)) return no_side;
      if (is_wall_at_[s] != 0) return s;
      at = neighbors_[std::size_t(at)][s % 3];
    }
    return no_side;
  }

  Side_number side_opposite_obtuse_angle(Triangle_index t) const {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Dual_place o = place(vertex(t, k)), p = place(vertex(t, k + 1)), q = place(vertex(t, k + 2));
      if ((p[0] - o[0]) * (q[0] - o[0]) + (p[1] - o[1]) * (q[1] - o[1]) < 0) return 3 * t.value() + k;
    }
    return no_side;
  }

  /// Makes circumcenters that rounding alone keeps apart one, which is in sight or not.
  void merge() {
    if (coincident_.empty()) return;
    const std::size_t n = mesh_.triangles.size();
    std::vector<std::uint32_t> parent(n), rank(n, 0), least(n);
    for (std::size_t t = 0; t < n; ++t) parent[t] = least[t] = static_cast<std::uint32_t>(t);
    boost::disjoint_sets<std::uint32_t*, std::uint32_t*> sets(rank.data(), parent.data());
    for (const std::uint32_t i : coincident_)
      sets.union_set(edges_[i].triangles[0].value(), edges_[i].triangles[1].value());
    for (std::size_t t = n; t-- > 0;)
      least[sets.find_set(static_cast<std::uint32_t>(t))] = static_cast<std::uint32_t>(t);
    representative_.resize(n);
    for (std::size_t t = 0; t < n; ++t)
      representative_[t] = least[sets.find_set(static_cast<std::uint32_t>(t))];
    for (std::size_t t = 0; t < n; ++t) wall_before_[t] = wall_before_[representative_[t]];
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DUAL_CIRCUMCENTERS_H
