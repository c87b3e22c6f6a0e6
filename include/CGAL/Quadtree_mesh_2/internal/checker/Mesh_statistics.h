// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_MESH_STATISTICS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_MESH_STATISTICS_H

#include <CGAL/Quadtree_mesh_2/internal/checker/Loops.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Mesh_checker.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Scaled_sides.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Angles, lengths and areas of a checked mesh, and the triangles that miss a bound.
///
/// Below the angle bound, a triangle is *exempt* only in an acute wedge. Two input segments meet there at an input
/// vertex, which may be an end of either or of none, at an angle phi < 60 degrees. All three vertices of the triangle
/// lie on these two segments, and its least angle is at least 0.9 phi. Both angles are known to 1e-11 of themselves,
/// however small. Takes linear time, except that exempt triangles search among the segments at their apex.
class Mesh_statistics {
public:
  using Point = Mesh_checker::Point;

  Mesh_statistics(const Mesh_checker::Mesh& mesh, const Mesh_checker::Pslg& pslg, const Mesh_checker& checker,
                  const Mesh_quality_options_2& options)
      : mesh_(mesh), pslg_(pslg), checker_(checker), options_(options) {}

  void compute(const Loops& loops, Mesh_quality_2& quality) const {
    quality.triangles = mesh_.triangles.size();
    loops.for_ranges<Mesh_quality_2>(
        mesh_.triangles.size(),
        [this](std::size_t begin, std::size_t end, Mesh_quality_2& range) {
          for (std::size_t t = begin; t < end; ++t) {
            measure_edges_of(static_cast<std::uint32_t>(t), range);
            measure_triangle(static_cast<std::uint32_t>(t), range);
          }
        },
        [&quality](const Mesh_quality_2& range) { add(quality, range); });
  }

private:
  using Sides = Scaled_sides<Point>;
  static constexpr double tolerance_ = 1e-7; // degrees, for comparisons of angles with the bound
  static constexpr double relative_tolerance_ = 1e-11;

  static void add(Mesh_quality_2& all, const Mesh_quality_2& range) {
    all.edges += range.edges;
    all.border_edges += range.border_edges;
    all.area += range.area;
    all.shortest_edge = std::min(all.shortest_edge, range.shortest_edge);
    all.longest_edge = std::max(all.longest_edge, range.longest_edge);
    all.largest_area = std::max(all.largest_area, range.largest_area);
    all.total_length += range.total_length;
    all.min_angle = std::min(all.min_angle, range.min_angle);
    all.max_angle = std::max(all.max_angle, range.max_angle);
    all.min_new_angle = std::min(all.min_new_angle, range.min_new_angle);
    all.exempt_triangles += range.exempt_triangles;
    all.unmet_triangles.insert(all.unmet_triangles.end(), range.unmet_triangles.begin(),
                               range.unmet_triangles.end());
    for (std::size_t i = 0; i < all.angle_histogram.size(); ++i)
      all.angle_histogram[i] += range.angle_histogram[i];
  }

  /// Those that no triangle before it has.
  void measure_edges_of(std::uint32_t t, Mesh_quality_2& quality) const {
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const std::uint32_t opposite = checker_.opposites()[h];
      if (opposite != Half_edges::none && opposite < h) continue;
      const double length = distance(checker_.half_edges().origin(h), checker_.half_edges().target(h));
      ++quality.edges;
      quality.border_edges += opposite == Half_edges::none;
      quality.total_length += length;
      quality.shortest_edge = std::min(quality.shortest_edge, length);
      quality.longest_edge = std::max(quality.longest_edge, length);
    }
  }

  double distance(std::uint32_t v, std::uint32_t w) const {
    const Point &p = mesh_.points[v], &q = mesh_.points[w];
    return std::hypot(q.x() - p.x(), q.y() - p.y());
  }

  void measure_triangle(std::uint32_t t, Mesh_quality_2& quality) const {
    const Sides sides(corner(t, 0), corner(t, 1), corner(t, 2));
    double least = 180, greatest = 0;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const double angle = sides.angle(k);
      least = std::min(least, angle);
      greatest = std::max(greatest, angle);
      if (!is_input_angle(t, k)) quality.min_new_angle = std::min(quality.min_new_angle, angle);
      ++quality.angle_histogram[std::min<std::size_t>(17, std::size_t(angle / 10))];
    }
    const double area = sides.area();
    quality.min_angle = std::min(quality.min_angle, least);
    quality.max_angle = std::max(quality.max_angle, greatest);
    quality.area += area;
    quality.largest_area = std::max(quality.largest_area, area);
    const Angles angles{least, greatest};
    using Bound = Mesh_quality_2::Bound;
    if (options_.max_edge() > 0 && sides.longest() > options_.max_edge() * (1 + relative_tolerance_))
      add_unmet(t, Bound::EDGE_LENGTH, angles, quality);
    if (area > max_area(t) * (1 + relative_tolerance_)) add_unmet(t, Bound::AREA, angles, quality);
    compare_with_angles(t, angles, quality);
  }

  const Point& corner(std::uint32_t t, std::uint32_t k) const { return mesh_.point(mesh_.triangles[t][k]); }

  bool is_input_angle(std::uint32_t t, std::uint32_t k) const {
    const std::uint32_t h = 3 * t;
    return std::size_t(mesh_.triangles[t][k]) < pslg_.vertices.size() &&
           checker_.constrained()[h + (k + 1) % 3] != 0 && checker_.constrained()[h + (k + 2) % 3] != 0;
  }

  /// The least and the greatest angle of a triangle, in degrees.
  struct Angles {
    double least, greatest;
  };

  void compare_with_angles(std::uint32_t t, Angles angles, Mesh_quality_2& quality) const {
    const bool is_sharp = angles.least < std::min(options_.min_angle(), 90.) - tolerance_;
    const bool is_wide = options_.max_angle() > 0 && angles.greatest > options_.max_angle() + tolerance_;
    if (!is_sharp && !is_wide) return;
    using Bound = Mesh_quality_2::Bound;
    if (is_exempt(t, angles.least))
      ++quality.exempt_triangles;
    else
      add_unmet(t, is_sharp ? Bound::ANGLE : Bound::GREATEST_ANGLE, angles, quality);
  }

  /// Of the options and of the triangle's region.
  double max_area(std::uint32_t t) const {
    double area = std::numeric_limits<double>::infinity();
    if (options_.max_area() > 0) area = options_.max_area();
    if (t >= mesh_.region_of_triangle.size() || mesh_.region_of_triangle[t] < 0) return area;
    const std::size_t r = std::size_t(mesh_.region_of_triangle[t]);
    return r < pslg_.regions.size() && pslg_.regions[r].max_area > 0
               ? std::min(area, pslg_.regions[r].max_area)
               : area;
  }

  void add_unmet(std::uint32_t t, Mesh_quality_2::Bound bound, Angles angles, Mesh_quality_2& quality) const {
    const Point &p = corner(t, 0), &q = corner(t, 1), &r = corner(t, 2);
    const std::array<double, 2> centroid{p.x() / 3 + q.x() / 3 + r.x() / 3,
                                         p.y() / 3 + q.y() / 3 + r.y() / 3};
    quality.unmet_triangles.push_back({Triangle_index(t), bound, centroid, angles.least, angles.greatest});
  }

  // --- wedges ---

  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  /// The range of the pairs that begin with a number. \pre they are in the order of these
  static auto range_of(const Pairs& all, std::uint32_t number) {
    const auto is_less = [](const auto& pair, std::uint32_t n) { return pair.first < n; };
    const auto first = std::lower_bound(all.begin(), all.end(), number, is_less);
    return std::make_pair(first, std::lower_bound(first, all.end(), number + 1, is_less));
  }
  auto segments_through(std::uint32_t v) const { return range_of(checker_.segments_through(), v); }
  bool is_through(std::uint32_t v, std::uint32_t segment) const {
    const auto& all = checker_.segments_through();
    return std::binary_search(all.begin(), all.end(), std::make_pair(v, segment));
  }

  bool is_exempt(std::uint32_t t, double least) const {
    std::array<std::uint32_t, 3> v{mesh_.triangles[t][0].value(), mesh_.triangles[t][1].value(),
                                   mesh_.triangles[t][2].value()};
    const auto number = [&](std::uint32_t w) {
      const auto range = segments_through(w);
      return range.second - range.first;
    };
    std::sort(v.begin(), v.end(), [&](std::uint32_t a, std::uint32_t b) { return number(a) < number(b); });
    const auto range = segments_through(v[0]);
    // The most segments, of which a vertex of huge degree has very many, are looked at only if the others say nothing.
    for (const bool is_through_second : {false, true})
      for (auto s = range.first; s != range.second; ++s)
        if (is_through(v[1], s->second) == is_through_second && is_in_wedge(v, s->second, least)) return true;
    return false;
  }

  /// Whether `v`, on segment `s` with its first vertex, is in a wedge of `s` and another segment that excuses
  /// the angle.
  bool is_in_wedge(const std::array<std::uint32_t, 3>& v, std::uint32_t s, double least) const {
    for (std::size_t k :
         {1u, 2u}) { // a vertex of the triangle that is not on s has to be on the other segment
      if (is_through(v[k], s)) continue;
      const auto range = segments_through(v[k]);
      for (auto other = range.first; other != range.second; ++other) {
        const std::uint32_t s2 = other->second;
        if (!is_through(v[3 - k], s) && !is_through(v[3 - k], s2)) continue;
        for (const Point& apex : meeting_points(s, s2)) {
          const Point &a = leg_end(s, apex, v), &b = leg_end(s2, apex, v);
          if (a == apex || b == apex) continue;
          const double phi = Sides(apex, a, b).angle(0);
          if (phi < 60 && least >= 0.9 * phi * (1 - relative_tolerance_)) return true;
        }
      }
      return false;
    }
    return false;
  }

  const Point& end_of(std::uint32_t segment, std::size_t end) const {
    return pslg_.point(pslg_.segments[segment][end]);
  }

  /// The input vertices in which two segments meet, exactly: ends of one that lie on the other, and those inside both.
  std::vector<Point> meeting_points(std::uint32_t s, std::uint32_t s2) const {
    std::vector<Point> points;
    for (std::size_t end : {0u, 1u}) {
      if (is_on(end_of(s, end), s2)) points.push_back(end_of(s, end));
      if (is_on(end_of(s2, end), s)) points.push_back(end_of(s2, end));
    }
    if (points.empty()) add_crossing(s, s2, points);
    return points;
  }

  /// Adds the vertex inside both segments, if there is one.
  void add_crossing(std::uint32_t s, std::uint32_t s2, std::vector<Point>& points) const {
    const auto side = [&](const Point& p) { return CGAL::orientation(end_of(s2, 0), end_of(s2, 1), p); };
    const Orientation before = side(end_of(s, 0));
    if (before == COLLINEAR || side(end_of(s, 1)) != -before) return;
    const auto [first, last] = range_of(checker_.vertices_inside(), s); // in their order along s
    const auto crossing = std::partition_point(
        first, last, [&](const auto& v) { return side(pslg_.vertices[v.second]) == before; });
    if (crossing != last && is_on(pslg_.vertices[crossing->second], s2))
      points.push_back(pslg_.vertices[crossing->second]);
  }

  bool is_on(const Point& p, std::uint32_t segment) const {
    const Point &a = end_of(segment, 0), &b = end_of(segment, 1);
    return p == a || p == b ||
           (CGAL::collinear(a, b, p) && CGAL::collinear_are_strictly_ordered_along_line(a, p, b));
  }

  /// Where the leg of a wedge along a segment leads to. This is the segment's other end or, if the segment
  /// goes through the apex, its end on the triangle's side. The triangle's vertex on the leg may be too near
  /// to tell the direction.
  const Point& leg_end(std::uint32_t segment, const Point& apex,
                       const std::array<std::uint32_t, 3>& v) const {
    if (end_of(segment, 0) == apex) return end_of(segment, 1);
    if (end_of(segment, 1) == apex) return end_of(segment, 0);
    for (std::uint32_t w : v)
      if (is_through(w, segment) && mesh_.points[w] != apex)
        return end_of(segment, CGAL::angle(end_of(segment, 0), apex, mesh_.points[w]) == ACUTE ? 0 : 1);
    return apex;
  }

  const Mesh_checker::Mesh& mesh_;
  const Mesh_checker::Pslg& pslg_;
  const Mesh_checker& checker_;
  const Mesh_quality_options_2& options_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_CHECKER_MESH_STATISTICS_H
