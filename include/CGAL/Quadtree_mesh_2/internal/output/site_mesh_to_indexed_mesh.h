// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Converts a mesh of sites to the user's flat arrays, and checks every triangle on the way. O(k).

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_SITE_MESH_TO_INDEXED_MESH_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_SITE_MESH_TO_INDEXED_MESH_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Point_set_mesh_report_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/angle_units.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/Distinct_points.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/angles_of_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/coordinate_map.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Site_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/topology/triangle_neighbors.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The least and the largest angle of a mesh.
class Angle_extremes {
public:
  template <class ConcurrencyTag, class Geometry, class Triangles, class Points>
  void add_all(const Triangles& triangles, const Points& points) {
    *this = reduce<ConcurrencyTag>(
        triangles.size(), *this,
        [&](std::size_t begin, std::size_t end) {
          Angle_extremes part;
          for (std::size_t t = begin; t < end; ++t) {
            const auto p = [&](std::size_t k) { return points[std::size_t(triangles[t][k])]; };
            part.add(Cotangents::of<Geometry>(p(0), p(1), p(2)));
          }
          return part;
        },
        [](Angle_extremes a, const Angle_extremes& b) {
          a.add({b.least_cot_, b.greatest_cot_});
          return a;
        });
  }
  void add(Cotangents c) {
    least_cot_ = std::min(least_cot_, c.least);
    greatest_cot_ = std::max(greatest_cot_, c.greatest);
  }

  /// In degrees.
  double least_angle() const { return angle(greatest_cot_); }
  double largest_angle() const { return angle(least_cot_); }

private:
  double least_cot_ = std::numeric_limits<double>::infinity(), greatest_cot_ = -least_cot_;

  static double angle(double cot) { return std::atan2(1, cot) * 180 / pi; }
};

/// The triangles with an angle outside a range.
template <class Geometry>
class Range_check {
public:
  /// In degrees; `least` may be 0, for no lower bound.
  Range_check(double least, double largest)
      : least_cot_(cot(largest)),
        greatest_cot_(least > 0 ? cot(least) : std::numeric_limits<double>::infinity()) {}

  template <class ConcurrencyTag, class Triangles, class Points>
  std::vector<std::uint32_t> outside(const Triangles& triangles, const Points& points) const {
    return pack<ConcurrencyTag>(triangles.size(), [&](std::size_t t) {
      const auto p = [&](std::size_t k) { return points[std::size_t(triangles[t][k])]; };
      const Cotangents c = Cotangents::of<Geometry>(p(0), p(1), p(2));
      return c.least < least_cot_ || c.greatest > greatest_cot_ || c.greatest < 0;
    });
  }

private:
  double least_cot_, greatest_cot_;

  static double cot(double degrees) {
    const double radians = degrees * pi / 180;
    return std::cos(radians) / std::sin(radians);
  }
};

/// The centroid of a triangle in the user's coordinates, rounded.
template <class Map, class Point>
std::array<double, 2> centroid_of(const Map& map, const Point& a, const Point& b, const Point& c) {
  std::array<double, 2> sum{};
  for (const Point* corner : {&a, &b, &c}) {
    const std::array<double, 2> p = map.place(*corner);
    sum[0] += p[0] / 3, sum[1] += p[1] / 3;
  }
  return sum;
}

/// Makes the flat arrays: the vertices of the input first, in its order.
template <class Traits, class ConcurrencyTag>
class Point_mesh_builder {
public:
  using Geometry = typename Traits::Meshing_geometry_2;
  using Point_2 = typename Traits::Point_2;
  using Mesh = Indexed_mesh_2<Point_2>;
  using Map = Coordinate_map<Traits, Geometry>;
  using Distinct = Distinct_points<ConcurrencyTag, Geometry>;

  /// \param vertex_of_point by distinct point.
  Point_mesh_builder(const std::vector<Point_2>& input, const Distinct& distinct, const Map& map,
                     const std::vector<Ring_vertex>& vertex_of_point)
      : input_(input), distinct_(distinct), map_(map), vertex_of_point_(vertex_of_point) {}

  /// Numbers vertices 0 to n - 1, those in use.
  template <class Is_used>
  void number_vertices(std::size_t n, const Is_used& is_used) {
    constexpr std::uint32_t unknown = std::uint32_t(-1);
    new_vertex_.assign(n, unknown);
    for (std::size_t i = 0; i < vertex_of_point_.size(); ++i)
      new_vertex_[std::size_t(vertex_of_point_[i])] = distinct_.input_point(i);
    const auto is_new = [&](std::size_t v) { return new_vertex_[v] == unknown && is_used(v); };
    steiner_ = pack<ConcurrencyTag>(n, is_new);
    for_each_index<ConcurrencyTag>(steiner_.size(), [&](std::size_t i) {
      new_vertex_[steiner_[i]] = static_cast<std::uint32_t>(input_.size() + i);
    });
  }

  /// \tparam Triangles of vertices as they were numbered before.
  template <class Points, class Triangles>
  Mesh mesh_of(const Points& points, const Triangles& triangles) const {
    Mesh mesh;
    mesh.number_of_input_vertices = input_.size();
    mesh.points.reserve(input_.size() + steiner_.size());
    mesh.points = input_;
    mesh.points.resize(input_.size() + steiner_.size());
    for_each_index<ConcurrencyTag>(steiner_.size(), [&](std::size_t i) {
      mesh.points[input_.size() + i] = map_.to_user(points[steiner_[i]]);
    });
    mesh.segment_of_vertex.resize(mesh.points.size());
    mesh.triangles.resize(triangles.size());
    for_each_index<ConcurrencyTag>(triangles.size(), [&](std::size_t t) {
      for (std::size_t k = 0; k < 3; ++k)
        mesh.triangles[t][k] = Vertex_index(new_vertex_[std::size_t(triangles[t][k])]);
    });
    mesh.neighbors = triangle_neighbors<ConcurrencyTag>(mesh.triangles, mesh.points.size());
    mark_border(mesh);
    return mesh;
  }

private:
  const std::vector<Point_2>& input_;
  const Distinct& distinct_;
  const Map& map_;
  const std::vector<Ring_vertex>& vertex_of_point_;
  std::vector<std::uint32_t> new_vertex_; // by vertex
  std::vector<std::uint32_t> steiner_;    // those that are not of the input

  static void mark_border(Mesh& mesh) {
    mesh.vertex_markers.assign(mesh.points.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        if (mesh.neighbors[t][k].is_valid()) continue;
        mesh.vertex_markers[std::size_t(mesh.triangles[t][(k + 1) % 3])] = 1;
        mesh.vertex_markers[std::size_t(mesh.triangles[t][(k + 2) % 3])] = 1;
      }
  }
};

template <class Traits, class ConcurrencyTag>
class Site_mesh_converter {
public:
  using Builder = Point_mesh_builder<Traits, ConcurrencyTag>;
  using Geometry = typename Builder::Geometry;
  using Mesh = typename Builder::Mesh;

  /// The angles, in degrees, are those that were asked for; if `is_acute` what is below 90 is still good.
  Site_mesh_converter(const Site_mesh<Geometry>& mesh, const std::vector<typename Builder::Point_2>& input,
                      const typename Builder::Distinct& distinct, const typename Builder::Map& map,
                      double least_angle, double largest_angle, bool is_acute,
                      Point_set_mesh_report_2& report)
      : mesh_(mesh), builder_(input, distinct, map, mesh.vertex_of_site), map_(map), least_(least_angle),
        largest_(largest_angle), is_acute_(is_acute), report_(report) {}

  Mesh run() {
    const auto& rings = mesh_.mesh;
    builder_.number_vertices(rings.number_of_vertices(),
                             [&](std::size_t v) { return rings.is_alive(Ring_vertex(v)); });
    list_triangles();
    check_angles();
    Mesh result = builder_.mesh_of(rings.points.values(), triangles_);
    report_.triangles = result.number_of_triangles();
    report_.vertices = result.number_of_vertices() - report_.merged_points;
    return result;
  }

private:
  const Site_mesh<Geometry>& mesh_;
  Builder builder_;
  const typename Builder::Map& map_;
  double least_, largest_;
  bool is_acute_;
  Point_set_mesh_report_2& report_;
  std::vector<std::array<Ring_vertex, 3>> triangles_;

  void list_triangles() {
    const auto& mesh = mesh_.mesh;
    count_allocate_and_place<ConcurrencyTag>(
        mesh.number_of_vertices(),
        [&](std::size_t begin, std::size_t end) {
          std::size_t sum = 0;
          for (const Ring_vertex v : Id_range<Ring_vertex>(begin, end))
            mesh.for_each_triangle_of(v, [&](Ring_vertex, Ring_vertex, Ring_vertex) { ++sum; });
          return sum;
        },
        [&](std::size_t sum) { triangles_.resize(sum); },
        [&](std::size_t begin, std::size_t end, std::size_t first) {
          for (const Ring_vertex v : Id_range<Ring_vertex>(begin, end))
            mesh.for_each_triangle_of(v, [&](Ring_vertex a, Ring_vertex b, Ring_vertex c) {
              triangles_[first++] = {a, b, c};
            });
        });
  }

  const typename Geometry::Point& point(std::size_t t, std::size_t k) const {
    return mesh_.mesh.point(triangles_[t][k]);
  }

  void check_angles() {
    Angle_extremes extremes;
    extremes.add_all<ConcurrencyTag, Geometry>(triangles_, mesh_.mesh.points.values());
    report_.least_angle = extremes.least_angle();
    report_.largest_angle = extremes.largest_angle();
    const std::vector<std::uint32_t> outside =
        Range_check<Geometry>(least_, largest_)
            .template outside<ConcurrencyTag>(triangles_, mesh_.mesh.points.values());
    for (const std::uint32_t t : outside)
      if (is_acute_ && is_acute<Geometry>(point(t, 0), point(t, 1), point(t, 2)))
        ++report_.thin_triangles;
      else
        report_.unmet_triangles.push_back(
            {Triangle_index(t), centroid_of(map_, point(t, 0), point(t, 1), point(t, 2))});
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_OUTPUT_SITE_MESH_TO_INDEXED_MESH_H
