// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Whether a place for a vertex of an edge is within rounding of another edge.
//
// Two edges of the input may run beside each other nearer than coordinates can tell, over any length: what was one
// line before it was rounded. There is no room for triangles between them, and the vertices that these ask for would be
// without end. So nothing is put on an edge for their sake where another one is as near.
//
// From the place one looks straight across its edge, from triangle to triangle, while these are as narrow. O(1) steps
// but for needles side by side.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_EDGE_NEXT_TO_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_EDGE_NEXT_TO_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Kernel_mesh.h>

#include <cmath>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Vertices of an edge are rounded by up to 0.71 units of the coordinates, and those of an input that was turned by a
/// unit more. Edges nearer to each other than this are as good as one.
constexpr double units_of_rounding = 4;

/// Whether a triangle near p is narrower than that.
template <class Geometry>
bool is_within_rounding(const typename Kernel_mesh<Geometry>::Shape& s, const typename Geometry::Point& p) {
  const double reach = units_of_rounding * Geometry::spacing(p);
  return s.area2 * s.area2 < reach * reach * s.longest();
}

template <class Geometry>
class Edge_next_to {
public:
  using Mesh = Kernel_mesh<Geometry>;
  using Point = typename Geometry::Point;
  using Number = typename Geometry::Number;
  using Vector = Basic_vector<Number>;

  Edge_next_to(const Mesh& mesh, const Point& p)
      : mesh_(mesh), p_(p), reach_(units_of_rounding * Geometry::spacing(p)) {}

  /// Looks to the left of the side that p is on. \returns the border if there is nothing
  Side on_left_of(Side s) const {
    const Vector way =
        Geometry::scaled_difference(mesh_.point(mesh_.target(s)), mesh_.point(mesh_.source(s)));
    for (int step = 0; step < most_steps; ++step) {
      const Vector to_apex = Geometry::scaled_difference(mesh_.point(mesh_.opposite(s)), p_);
      const Side next(s.triangle(), dot(to_apex, way) > 0 ? previous_slot[s.slot()] : next_slot[s.slot()]);
      const Side o = mesh_.across(next);
      const Place place = place_beside(next);
      if (place == Place::FAR || o.is_seam()) break;
      if (o.is_constrained()) return place == Place::BESIDE ? next : Side::border();
      s = o;
    }
    return Side::border();
  }

private:
  /// Only rounding could make it go in circles.
  static constexpr int most_steps = 100;

  /// Where p is, as seen from a side. Next to an end of it there are places for vertices.
  enum class Place { FAR, BESIDE, AT_END };

  const Mesh& mesh_;
  const Point& p_;
  double reach_;

  /// Whether p is farther than the reach from the line of x and y = x + d; p = x + e. Most often rounded areas tell,
  /// though their signs may not.
  bool is_off_line(const Vector& d, const Vector& e, const Point& x, const Point& y) const {
    constexpr double share_lost = 0x1p-50, margin = 1e-12;
    const double l = d.x * e.y, r = d.y * e.x, lost = share_lost * (std::fabs(l) + std::fabs(r));
    const double rough = std::fabs(l - r), limit = reach_ * length(d);
    if (rough + lost < (1 - margin) * limit) return false;
    if (rough - lost > (1 + margin) * limit) return true;
    const Number area2 = Geometry::doubled_area_of_flat(d, e - d, x, y, p_);
    return area2 * area2 >= reach_ * reach_ * squared_length(d);
  }

  Place place_beside(Side s) const {
    const Point &x = mesh_.point(mesh_.source(s)), &y = mesh_.point(mesh_.target(s));
    const Vector d = Geometry::scaled_difference(y, x), e = Geometry::scaled_difference(p_, x);
    const Number whole = squared_length(d);
    if (is_off_line(d, e, x, y)) return Place::FAR;
    const Number along = dot(d, e), end = reach_ * length(d);
    return along <= end || along >= whole - end ? Place::AT_END : Place::BESIDE;
  }
};

/// The side of another edge that is within rounding of p, which is on the side s; else the border.
template <class Geometry>
Side edge_next_to(const Kernel_mesh<Geometry>& mesh, Side s, const typename Geometry::Point& p) {
  if constexpr (Geometry::has_unlimited_coordinates) {
    static_cast<void>(mesh), static_cast<void>(s), static_cast<void>(p); // coordinates tell everything
    return Side::border();
  } else {
    const Edge_next_to<Geometry> search(mesh, p);
    const Side o = mesh.across(s), left = search.on_left_of(s);
    return left.is_border() && !o.is_border() ? search.on_left_of(o) : left;
  }
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TRIANGULATION_EDGE_NEXT_TO_H
