// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Whether a mesh needs nothing, because it meets all bounds as it is.
//
// Such a mesh stays, with its vertices and triangles in their order. The mesher would keep its vertices as well. But
// it cuts sharp corners anew, and it would take as long as for a mesh that needs much.
//
// Computes: whether all vertices in the domain are used, and all triangles are constrained Delaunay and meet the
//           bounds, or are excused by a corner: all their vertices are on two segments that meet there, and no angle is
//           below 0.9 of the corner's. Angles that are compared with a corner's are exact up to their last rounding,
//           however small. For bounds on how edges grow the answer is no, as only the mesher can tell.
// Bound:    O(k) time for k triangles; O(log k) for each unused vertex; for each sharp triangle in addition the number
//           of segments at its vertices, without the vertex that has most of them, unless it is not excused.
// Source:   ours; the rule for corners is that of Acute_corners.h.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_SUFFICIENT_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_SUFFICIENT_MESH_H

#include <CGAL/MP_Float.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Given_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Sharp_corner_finder.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Triangle_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/group_in_order.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The angle at o from p to q, both in any case, in radians.
inline double exact_angle(const Triangle_tree::Point& o, const Triangle_tree::Point& p,
                          const Triangle_tree::Point& q) {
  const auto difference = [](double a, double b) { return MP_Float(a) - MP_Float(b); };
  const MP_Float ux = difference(p.x(), o.x()), uy = difference(p.y(), o.y());
  const MP_Float vx = difference(q.x(), o.x()), vy = difference(q.y(), o.y());
  return std::fabs(std::atan2(CGAL::to_double(ux * vy - uy * vx), CGAL::to_double(ux * vx + uy * vy)));
}

/// \tparam Is_constrained called with two vertices, whether the edge between them is
template <class Is_constrained>
class Sufficient_mesh {
public:
  using Point = Triangle_tree::Point;
  using Mesh = Given_mesh::Mesh;
  using Pslg = Pslg_2<Point>;
  using Options = Quality_mesh_options_2;

  Sufficient_mesh(const Given_mesh& given, const Pslg& pslg, const Options& options,
                  const Is_constrained& is_constrained)
      : given_(given), mesh_(given.mesh()), pslg_(pslg), options_(options), is_constrained_(is_constrained),
        bound_(options.min_angle() * radians_per_degree),
        widest_(options.max_angle() > 0 ? options.max_angle() * radians_per_degree : pi),
        exponent_(exponent_of(magnitude_of(given.mesh().points))) {}

  /// \param[out] report its triangles, if the answer is yes
  bool is_one(Quality_mesh_report_2& report) {
    if (options_.gradation() > 0 || options_.max_edge_ratio() > 0 || has_unused_vertex()) return false;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (!is_delaunay(t) || is_large(t)) return false;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (!has_good_angles(t, report)) return false;
    report.triangles = mesh_.triangles.size();
    return true;
  }

private:
  const Given_mesh& given_;
  const Mesh& mesh_;
  const Pslg& pslg_;
  const Options& options_;
  const Is_constrained& is_constrained_;
  double bound_, widest_;
  int exponent_; // of the largest coordinate
  std::vector<std::vector<Segment_index>>
      segments_at_;                           // per vertex of the graph; made for the first sharp triangle
  std::vector<Vertex_index> vertex_of_input_; // of the mesh

  /// Products of coordinates may be beyond doubles.
  Point scaled(const Point& p) const {
    return Point(std::ldexp(p.x(), -exponent_), std::ldexp(p.y(), -exponent_));
  }
  Triangle_tree::Corners scaled_corners(std::size_t t) const {
    const auto p = given_.corners(t);
    return {scaled(p[0]), scaled(p[1]), scaled(p[2])};
  }

  /// Whether a place in the domain has a vertex, but none that is one of a triangle.
  bool has_unused_vertex() const {
    std::vector<char> is_used(mesh_.points.size(), 0);
    for (const auto& t : mesh_.triangles)
      for (const Vertex_index v : t) is_used[std::size_t(v)] = 1;
    for (std::size_t v = 0; v < is_used.size(); ++v) {
      if (is_used[v] != 0) continue;
      const Point& p = mesh_.points[v];
      const auto nearest = given_.tree().nearest(p);
      const auto around = given_.corners(std::size_t(nearest.triangle));
      if (nearest.distance == 0 && std::find(around.begin(), around.end(), p) == around.end()) return true;
    }
    return false;
  }

  /// By its sides to neighbors of a greater index, and those on segments if they have to be, too.
  bool is_delaunay(std::size_t t) const {
    const Triangle_tree::Kernel kernel;
    const auto& v = mesh_.triangles[t];
    const bool has_to_conform = options_.conform() == Options::Conforming::DELAUNAY;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex_index a = v[(k + 1) % 3], b = v[(k + 2) % 3];
      const Triangle_index n = given_.neighbors()[t][k];
      if (is_constrained_(a, b)) {
        if (has_to_conform &&
            kernel.angle_2_object()(mesh_.point(a), mesh_.point(v[k]), mesh_.point(b)) == OBTUSE)
          return false;
      } else if (std::size_t(n) > t) {
        const auto& w = mesh_.triangles[std::size_t(n)];
        const Vertex_index across =
            *std::find_if(w.begin(), w.end(), [&](Vertex_index x) { return x != a && x != b; });
        if (kernel.side_of_oriented_circle_2_object()(mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]),
                                                      mesh_.point(across)) == ON_POSITIVE_SIDE)
          return false;
      }
    }
    return true;
  }

  /// Whether it misses a bound of size, or the user refuses it.
  bool is_large(std::size_t t) const {
    const auto p = given_.corners(t);
    const auto small = scaled_corners(t);
    double scaled_area = double_area(small) / 2;
    if (!(scaled_area > 0))
      scaled_area = exact_area2_from(small[0], small[1], small[2]) / 2; // doubles cannot tell
    const double area = std::ldexp(scaled_area, 2 * exponent_);
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, std::hypot(p[k].x() - p[(k + 1) % 3].x(), p[k].y() - p[(k + 1) % 3].y()));
    if (options_.max_area() > 0 && area > options_.max_area()) return true;
    if (options_.max_edge() > 0 && longest > options_.max_edge()) return true;
    if (!mesh_.region_of_triangle.empty() && mesh_.region_of_triangle[t] >= 0) {
      const double largest = pslg_.regions[std::size_t(mesh_.region_of_triangle[t])].max_area;
      if (largest > 0 && area > largest) return true;
    }
    const Point center = centroid(p);
    if (options_.size() && longest > options_.size()(center.x(), center.y())) return true;
    return options_.refine_where() &&
           options_.refine_where()({{{p[0].x(), p[0].y()}, {p[1].x(), p[1].y()}, {p[2].x(), p[2].y()}}});
  }

  bool has_good_angles(std::size_t t, Quality_mesh_report_2& report) {
    const auto p = scaled_corners(t);
    std::array<double, 3> angles;
    for (std::size_t k = 0; k < 3; ++k) angles[k] = angle(p[k], p[(k + 1) % 3], p[(k + 2) % 3]);
    const auto [least, greatest] = std::minmax_element(angles.begin(), angles.end());
    if (*least < bound_ || *greatest > widest_) {
      const Vertex_index corner = excusing_corner(t);
      if (!corner.is_valid()) return false;
      report.exempt_triangles.push_back({Triangle_index(t), corner});
    }
    constexpr double most_of_least = 59, most_of_greatest = 119;
    ++report.least_angle_histogram[std::size_t(std::min(most_of_least, *least * degrees_per_radian))];
    ++report.largest_angle_histogram[std::size_t(
        std::min(most_of_greatest, std::max(0., *greatest * degrees_per_radian - 60)))];
    return true;
  }

  /// Of a counterclockwise triangle, which may be so flat that doubles cannot tell.
  static double angle(const Point& o, const Point& p, const Point& q) {
    const double ux = p.x() - o.x(), uy = p.y() - o.y(), vx = q.x() - o.x(), vy = q.y() - o.y();
    return std::fabs(std::atan2(ux * vy - uy * vx, ux * vx + uy * vy));
  }

  /// The vertex in which two segments meet that have all vertices of a triangle on them, and excuse its least angle.
  Vertex_index excusing_corner(std::size_t t) {
    if (mesh_.segment_of_vertex.empty()) return {};
    find_segments_at_vertices();
    const auto& v = mesh_.triangles[t];
    const auto p = scaled_corners(t);
    double least = pi;
    for (std::size_t k = 0; k < 3; ++k)
      least = std::min(least, exact_angle(p[k], p[(k + 1) % 3], p[(k + 2) % 3]));
    std::array<Span<Segment_index>, 3> through{segments_through(v[0]), segments_through(v[1]),
                                               segments_through(v[2])};
    std::sort(through.begin(), through.end(),
              [](const auto& a, const auto& b) { return a.size() < b.size(); });
    // The most segments, of which a vertex of huge degree has very many, are looked at only if the others say nothing.
    for (const bool is_through_second : {false, true})
      for (const Segment_index s : through[0]) {
        if (has(through[1], s) != is_through_second) continue;
        const bool is_through_third = has(through[2], s);
        for (const Segment_index r : is_through_second ? through[2] : through[1]) {
          if (!is_through_second && !is_through_third && !has(through[2], r)) continue;
          const Vertex_index apex = common_end(s, r);
          if (apex.is_valid() && excuses(apex, s, r, least)) return vertex_of_input_[std::size_t(apex)];
        }
      }
    return {};
  }

  /// Lists of segments are in their order.
  static bool has(Span<Segment_index> segments, Segment_index s) {
    return std::binary_search(segments.begin(), segments.end(), s);
  }

  /// The end that two segments have in common; invalid if there is none, or they are the same.
  Vertex_index common_end(Segment_index s, Segment_index r) const {
    const auto &a = pslg_.segment(s), &b = pslg_.segment(r);
    if (s == r) return {};
    return a[0] == b[0] || a[0] == b[1] ? a[0] : a[1] == b[0] || a[1] == b[1] ? a[1] : Vertex_index();
  }

  bool excuses(Vertex_index apex, Segment_index s, Segment_index r, double least) const {
    constexpr double greatest_corner = 60 * radians_per_degree, share_kept = 0.9, margin = 1e-11;
    const auto far_end = [&](Segment_index segment) {
      const auto& ends = pslg_.segment(segment);
      return scaled(pslg_.point(ends[ends[0] == apex ? 1 : 0]));
    };
    const double phi = exact_angle(scaled(pslg_.point(apex)), far_end(s), far_end(r));
    return phi < greatest_corner && least >= share_kept * phi * (1 - margin);
  }

  Span<Segment_index> segments_through(Vertex_index v) const {
    const Segment_index* const own = &mesh_.segment_of_vertex[std::size_t(v)];
    if (own->is_valid()) return {own, own + 1};
    const Vertex_index i = input_index_of(mesh_, pslg_, v);
    if (!i.is_valid()) return {own, own};
    const std::vector<Segment_index>& at = segments_at_[std::size_t(i)];
    return {at.data(), at.data() + at.size()};
  }

  /// And what vertices of the graph are called in the mesh.
  void find_segments_at_vertices() {
    if (!segments_at_.empty()) return;
    segments_at_.resize(pslg_.vertices.size());
    for (std::size_t s = 0; s < pslg_.segments.size(); ++s)
      for (const Vertex_index v : pslg_.segments[s]) segments_at_[std::size_t(v)].push_back(Segment_index(s));
    vertex_of_input_.resize(pslg_.vertices.size());
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      if (const Vertex_index i = input_index_of(mesh_, pslg_, Vertex_index(v)); i.is_valid())
        vertex_of_input_[std::size_t(i)] = Vertex_index(v);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_ADAPTATION_SUFFICIENT_MESH_H
