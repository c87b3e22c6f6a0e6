// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The edges of the Delaunay triangulation of points by increasing length. Among them are the edges of the
// minimum spanning tree (Kruskal) and those to nearest neighbors.
//
// CGAL's triangulation uses the predicates of a meshing geometry. They are exact for doubles, for integers
// and for numbers of exact fields. Lengths are doubles, correct up to a relative 2^-51. After the points'
// spatial sort it takes O(n log n) in practice.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_DELAUNAY_EDGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_DELAUNAY_EDGES_H

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/meshing_geometry.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/enum.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The length of a vector, also where its square is beyond the range of doubles; the same on every machine.
inline double length_of(Vector v) {
  const double largest = std::max(std::fabs(v.x), std::fabs(v.y));
  if (!(largest > 0)) return 0;
  const int exponent = std::ilogb(largest);
  const Vector scaled{std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent)};
  return std::ldexp(std::sqrt(squared_length(scaled)), exponent);
}

/// Points, given by where they are stored, for CGAL's Delaunay triangulation: a model of
/// `DelaunayTriangulationTraits_2` but for what concerns duals.
template <class Geometry>
struct Indirect_delaunay_traits_2 {
  struct Point_2 {
    const typename Geometry::Point* place = nullptr;
    std::uint32_t index = 0;

    friend bool operator==(const Point_2& p, const Point_2& q) { return *p.place == *q.place; }
    friend bool operator!=(const Point_2& p, const Point_2& q) { return !(p == q); }
  };
  // Named by the triangulation, though not used.
  struct Segment_2 {};
  struct Triangle_2 {};
  struct Construct_segment_2 {};
  struct Construct_triangle_2 {};
  /// A triangulation's points are these.
  struct Construct_point_2 {
    const Point_2& operator()(const Point_2& p) const { return p; }
  };

  struct Less_x_2 {
    bool operator()(const Point_2& p, const Point_2& q) const { return p.place->x < q.place->x; }
  };
  struct Less_y_2 {
    bool operator()(const Point_2& p, const Point_2& q) const { return p.place->y < q.place->y; }
  };
  struct Compare_x_2 {
    Comparison_result operator()(const Point_2& p, const Point_2& q) const {
      return p.place->x == q.place->x ? EQUAL : p.place->x < q.place->x ? SMALLER : LARGER;
    }
  };
  struct Compare_y_2 {
    Comparison_result operator()(const Point_2& p, const Point_2& q) const {
      return p.place->y == q.place->y ? EQUAL : p.place->y < q.place->y ? SMALLER : LARGER;
    }
  };
  struct Compare_xy_2 {
    Comparison_result operator()(const Point_2& p, const Point_2& q) const {
      const Comparison_result by_x = Compare_x_2()(p, q);
      return by_x == EQUAL ? Compare_y_2()(p, q) : by_x;
    }
  };
  struct Orientation_2 {
    Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const {
      return static_cast<Orientation>(Geometry::orientation(*p.place, *q.place, *r.place));
    }
  };
  /// Points on a circle count as outside: any of the Delaunay triangulations will do.
  struct Side_of_oriented_circle_2 {
    Oriented_side operator()(const Point_2& p, const Point_2& q, const Point_2& r, const Point_2& s) const {
      return Geometry::is_in_circle(*p.place, *q.place, *r.place, *s.place) ? ON_POSITIVE_SIDE
                                                                            : ON_NEGATIVE_SIDE;
    }
  };

  Less_x_2 less_x_2_object() const { return {}; }
  Less_y_2 less_y_2_object() const { return {}; }
  Compare_x_2 compare_x_2_object() const { return {}; }
  Compare_y_2 compare_y_2_object() const { return {}; }
  Compare_xy_2 compare_xy_2_object() const { return {}; }
  Orientation_2 orientation_2_object() const { return {}; }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }
  Construct_point_2 construct_point_2_object() const { return {}; }
  Construct_segment_2 construct_segment_2_object() const { return {}; }
  Construct_triangle_2 construct_triangle_2_object() const { return {}; }
};

/// An edge between two points; `a < b`.
struct Measured_edge {
  double length;
  std::uint32_t a, b;

  friend bool operator<(const Measured_edge& e, const Measured_edge& f) {
    return std::tie(e.length, e.a, e.b) < std::tie(f.length, f.a, f.b);
  }
};

template <class Geometry>
class Delaunay_edges {
public:
  using Point = typename Geometry::Point;

  explicit Delaunay_edges(const std::vector<Point>& points) : points_(points) {}

  std::vector<Measured_edge> run() {
    edges_.reserve(3 * points_.size());
    std::vector<Site> order(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) order[i] = {&points_[i], static_cast<std::uint32_t>(i)};
    const std::size_t apex = index_off_line();
    if (apex < points_.size())
      add_edges_of_triangulation(std::move(order), apex);
    else
      add_edges_on_line(std::move(order));
    std::sort(edges_.begin(), edges_.end());
    return std::move(edges_);
  }

private:
  using Traits = Indirect_delaunay_traits_2<Geometry>;
  using Site = typename Traits::Point_2;
  using Triangulation = Delaunay_triangulation_2<Traits>;

  const std::vector<Point>& points_;
  std::vector<Measured_edge> edges_;

  void add(const Site& p, const Site& q) {
    edges_.push_back({length_of(Geometry::difference(*q.place, *p.place)), std::min(p.index, q.index),
                      std::max(p.index, q.index)});
  }

  /// The first point that is not on the line through the first two; the number of points if there is none.
  std::size_t index_off_line() const {
    std::size_t i = 2;
    while (i < points_.size() && Geometry::orientation(points_[0], points_[1], points_[i]) == 0) ++i;
    return i;
  }

  /// CGAL finds places on a line by going along it, which would take O(n^2).
  void add_edges_on_line(std::vector<Site> order) {
    std::sort(order.begin(), order.end(), [](const Site& p, const Site& q) {
      return p.place->x == q.place->x ? p.place->y < q.place->y : p.place->x < q.place->x;
    });
    for (std::size_t i = 1; i < order.size(); ++i) add(order[i - 1], order[i]);
  }

  /// A triangle comes first, so that there is never a line.
  void add_edges_of_triangulation(std::vector<Site> order, std::size_t apex) {
    Triangulation triangulation;
    typename Triangulation::Face_handle hint;
    for (std::size_t i : {std::size_t(0), std::size_t(1), apex})
      hint = triangulation.insert(order[i], hint)->face();
    spatial_sort(order.begin(), order.end(), Traits());
    for (const Site& p : order) hint = triangulation.insert(p, hint)->face();
    for (auto e = triangulation.finite_edges_begin(); e != triangulation.finite_edges_end(); ++e)
      add(e->first->vertex(Triangulation::cw(e->second))->point(),
          e->first->vertex(Triangulation::ccw(e->second))->point());
  }
};

/// \pre the points are distinct
template <class Geometry>
std::vector<Measured_edge> sorted_delaunay_edges(const std::vector<typename Geometry::Point>& points) {
  return Delaunay_edges<Geometry>(points).run();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CLUSTERS_DELAUNAY_EDGES_H
