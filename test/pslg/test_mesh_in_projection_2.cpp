// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Graphs in degrees meshed in projections. Angles on the ground are those of spherical triangles, from vectors in space
// and not from any projection.

#include "catch.h"
#include "numbers_of_threads.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_in_projection_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_mesh_in_projection_2 {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point>;
using Mesh = CGAL::Indexed_mesh_2<Point>;
using Projection = CGAL::Conformal_projection_2;
using Vector = std::array<double, 3>;
constexpr double degree = 3.14159265358979323846 / 180;

Vector on_sphere(const Point& p) {
  return {std::cos(p.y() * degree) * std::cos(p.x() * degree),
          std::cos(p.y() * degree) * std::sin(p.x() * degree), std::sin(p.y() * degree)};
}

/// Of the great circles from `a` to `b` and to `c`, by the tangents there. Differences are exact enough for short ones.
double spherical_angle(const Vector& a, const Vector& b, const Vector& c) {
  const auto tangent = [&a](const Vector& p) {
    Vector d{p[0] - a[0], p[1] - a[1], p[2] - a[2]};
    const double along = d[0] * a[0] + d[1] * a[1] + d[2] * a[2];
    for (std::size_t i = 0; i < 3; ++i) d[i] -= along * a[i];
    return d;
  };
  const Vector u = tangent(b), v = tangent(c);
  const double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
  return std::atan2(std::hypot(x, y, z), u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) / degree;
}

/// Triangles below a bound on the ground.
std::set<std::size_t> below(const Mesh& mesh, double bound) {
  std::set<std::size_t> result;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = [&](std::size_t i) {
        return on_sphere(mesh.point(mesh.triangles[t][(k + i) % 3]));
      };
      if (spherical_angle(corner(0), corner(1), corner(2)) < bound) result.insert(t);
    }
  return result;
}

Pslg great_lakes() {
  Pslg meters, result;
  CGAL::IO::read_triangle_poly(QUADTREE_MESH_SOURCE_DIR "/examples/data/great_lakes.poly.gz", meters);
  result = meters;
  // Lambert's azimuthal projection by examples/data/make_great_lakes.py, backwards.
  const double lat0 = 45 * degree, lon0 = -84.5 * degree, radius = 6371007.2;
  const auto back = [&](const Point& p) {
    const double r = std::hypot(p.x(), p.y()), c = 2 * std::asin(r / (2 * radius));
    if (r == 0) return Point(lon0 / degree, lat0 / degree);
    const double lat = std::asin(std::cos(c) * std::sin(lat0) + p.y() * std::sin(c) * std::cos(lat0) / r);
    const double lon = lon0 + std::atan2(p.x() * std::sin(c), r * std::cos(lat0) * std::cos(c) -
                                                                  p.y() * std::sin(lat0) * std::sin(c));
    return Point(lon / degree, lat / degree);
  };
  for (Point& p : result.vertices) p = back(p);
  for (Point& p : result.holes) p = back(p);
  return result;
}

/// A coast about 60 degrees north: Koch's curve around a triangle some degrees wide.
Pslg koch(int depth) {
  std::vector<Point> ring{Point(5, 59), Point(11, 59), Point(8, 61.6)};
  for (int i = 0; i < depth; ++i) {
    std::vector<Point> finer;
    for (std::size_t v = 0; v < ring.size(); ++v) {
      const Point a = ring[v], b = ring[(v + 1) % ring.size()];
      const double x = (b.x() - a.x()) / 3, y = (b.y() - a.y()) / 3;
      // Outward and flat, in a plane of degrees half as wide as high.
      finer.insert(finer.end(), {a, Point(a.x() + x, a.y() + y),
                                 Point(a.x() + 1.5 * x + 1.5 * y, a.y() + 1.5 * y - 0.4 * x),
                                 Point(a.x() + 2 * x, a.y() + 2 * y)});
    }
    ring = finer;
  }
  Pslg result;
  for (const Point& p : ring) result.add_vertex(p);
  for (std::size_t v = 0; v < ring.size(); ++v)
    result.add_segment(Pslg::Vertex_index(v), Pslg::Vertex_index((v + 1) % ring.size()));
  return result;
}

template <class Tag = CGAL::Sequential_tag>
Mesh mesh_degrees(const Pslg& graph, const Projection& projection, CGAL::Projected_mesh_2<Point>& report,
                  double min_angle = 20.7) {
  using Traits = CGAL::Filtered_quadtree_traits_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
  return CGAL::mesh_in_projection_2(
      graph, projection,
      [&](const Pslg& meters) {
        CGAL::Quality_mesher_2<Traits, Tag> mesher(
            CGAL::Quality_mesh_options_2().min_angle(min_angle == 20.7 ? 20.704 : min_angle));
        return mesher(meters);
      },
      min_angle, report);
}

/// The mesh is one of the graph in degrees; its triangles below the bound are exempt, by the checker in the plane.
void check(const Pslg& graph, const Mesh& mesh, const CGAL::Projected_mesh_2<Point>& report) {
  const auto in_degrees = CGAL::mesh_quality_2(mesh, graph, CGAL::Mesh_quality_options_2().min_angle(0));
  CAPTURE(in_degrees.errors);
  CHECK(in_degrees.is_valid());
  const auto in_plane =
      CGAL::mesh_quality_2(report.mesh, report.graph, CGAL::Mesh_quality_options_2().min_angle(20.7));
  CAPTURE(in_plane.errors);
  CHECK(in_plane.is_valid());
  CHECK(in_plane.unmet_triangles.empty());
  CHECK(report.bent_triangles == 0);
  // Spherical triangles have larger angles than plane ones, if only by their excess.
  CHECK(below(mesh, 20.7 - 1e-6).size() <= in_plane.exempt_triangles);
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) REQUIRE(mesh.points[v] == graph.vertices[v]);
}

TEST_CASE("the Great Lakes in degrees keep the bound on the ground", "[mesh_in_projection_2]") {
  const Pslg graph = great_lakes();
  CGAL::Projected_mesh_2<Point> report;
  const Mesh mesh = mesh_degrees(graph, Projection::for_box(CGAL::box_in_degrees(graph)), report);
  check(graph, mesh, report);
  CHECK(mesh.triangles.size() > 15000);
}

TEST_CASE("a coast at 60 degrees keeps the bound on the ground", "[mesh_in_projection_2]") {
  const Pslg graph = koch(4);
  const auto box = CGAL::box_in_degrees(graph);
  for (const Projection& projection :
       {Projection::for_box(box), Projection::mercator(box), Projection::stereographic(8, 60)}) {
    CGAL::Projected_mesh_2<Point> report;
    const Mesh mesh = mesh_degrees(graph, projection, report);
    check(graph, mesh, report);
  }
}

TEST_CASE("vertices and holes that a long segment bends over stay on their side", "[mesh_in_projection_2]") {
  // A box 40 degrees wide, whose parallel at 60 degrees bends by 100 km and more in Lambert's projection. Vertices,
  // segments and a hole are just beside it.
  Pslg graph;
  for (const auto& [x, y] : std::vector<std::pair<double, double>>{{0, 50},
                                                                   {40, 50},
                                                                   {40, 60},
                                                                   {0, 60},
                                                                   {10, 59.9999},
                                                                   {30, 59.999},
                                                                   {20.3, 59.9},
                                                                   {11, 59.9},
                                                                   {10, 59.95}})
    graph.add_vertex(Point(x, y));
  const std::vector<std::pair<unsigned, unsigned>> segments{{0, 1}, {1, 2}, {2, 3}, {3, 0},
                                                            {4, 7}, {7, 8}, {8, 4}};
  for (const auto& [a, b] : segments) graph.add_segment(Pslg::Vertex_index(a), Pslg::Vertex_index(b));
  graph.holes.emplace_back(10.2, 59.93);
  CGAL::Projected_mesh_2<Point> report;
  const Mesh mesh = mesh_degrees(graph, Projection::for_box(CGAL::box_in_degrees(graph)), report);
  CHECK(report.split_vertices > 0);
  check(graph, mesh, report);
}

TEST_CASE("graphs in degrees with vertices on segments, twice or beside the domain are meshed",
          "[mesh_in_projection_2]") {
  Pslg graph = koch(2);
  graph.vertex_markers.assign(graph.vertices.size(), 3);
  const auto v = graph.add_vertex(Point(7.1, 60)), w = graph.add_vertex(Point(8.1, 60)),
             u = graph.add_vertex(Point(7.6, 60)), again = graph.add_vertex(Point(7.6, 60)),
             top = graph.add_vertex(Point(7.5, 60.5));
  const auto far = graph.add_vertex(Point(30, 62)), farther = graph.add_vertex(Point(50, 64));
  graph.add_segment(v, w), graph.add_segment(again, top), graph.add_segment(v, u),
      graph.add_segment(far, farther);
  graph.vertex_markers.resize(graph.vertices.size(), 0);
  CGAL::Projected_mesh_2<Point> report;
  const Mesh mesh = mesh_degrees(graph, Projection::for_box(CGAL::box_in_degrees(graph)), report);
  check(graph, mesh, report);
}

TEST_CASE("meshes in degrees have the same bits for any number of threads", "[mesh_in_projection_2]") {
  const Pslg graph = koch(4);
  const Projection projection = Projection::for_box(CGAL::box_in_degrees(graph));
  CGAL::Projected_mesh_2<Point> report;
  const Mesh one = mesh_degrees(graph, projection, report);
  for_numbers_of_threads([&] {
    const Mesh mesh = mesh_degrees<CGAL::Parallel_tag>(graph, projection, report);
    CHECK(mesh.points == one.points);
    CHECK(mesh.triangles == one.triangles);
  });
}

TEST_CASE("graphs that are none in degrees are refused by name", "[mesh_in_projection_2]") {
  const auto message = [](std::vector<Point> points) {
    Pslg graph;
    for (const Point& p : points) graph.add_vertex(p);
    for (std::size_t i = 0; i < points.size(); ++i)
      graph.add_segment(Pslg::Vertex_index(i), Pslg::Vertex_index((i + 1) % points.size()));
    try {
      CGAL::box_in_degrees(graph);
    } catch (const CGAL::Pslg_error_2& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(message({Point(0, 0), Point(1, 0), Point(0, 90)}).find("vertex 2") == 0);
  CHECK(message({Point(179, 0), Point(-179, 0), Point(-179, 1)}).find("segment 0") == 0);
  CHECK(message({Point(0, 0), Point(150, 0), Point(300, 1), Point(370, 1)})
            .find("vertex 0 (0, 0) and vertex 3") == 0);
  CHECK(message({Point(179, 0), Point(181, 0), Point(181, 1)}).empty());
}

} // namespace test_mesh_in_projection_2
