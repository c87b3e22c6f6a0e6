// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What is valid in truth is called valid, what is not is not: meshes mutated by units in the last place, far from the
// origin, and scaled to the ends of the range of doubles.

#include "catch.h"
#include "mesh_from_cdt.h"

#include <CGAL/Quadtree_mesh_2/internal/checker/Straight_segment.h>
#include <CGAL/mesh_quality_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_mesh_checker {

using namespace test_meshes;
using CGAL::mesh_quality_2;
using CGAL::Quadtree_mesh_2::internal::unit_in_last_place;
using Options = CGAL::Mesh_quality_options_2;

namespace {

const std::array<int, 5> exponents{-960, -500, 0, 500, 960};

Point scaled(const Point& p, int exponent) {
  return Point(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent));
}
Mesh scaled(Mesh mesh, int exponent) {
  for (Point& p : mesh.points) p = scaled(p, exponent);
  return mesh;
}
Pslg scaled(Pslg pslg, int exponent) {
  for (Point& p : pslg.vertices) p = scaled(p, exponent);
  for (Point& p : pslg.holes) p = scaled(p, exponent);
  for (auto& r : pslg.regions) r.point = scaled(r.point, exponent);
  return pslg;
}

/// Whether a mesh is valid, by all its arrays, at every scale.
bool is_valid(const Mesh& mesh, const Pslg& pslg) {
  const bool at_1 = mesh_quality_2(mesh, pslg).is_valid();
  for (int e : exponents) {
    const auto quality = mesh_quality_2(scaled(mesh, e), scaled(pslg, e));
    CAPTURE(e, quality.errors);
    REQUIRE(quality.is_valid() == at_1);
  }
  return at_1;
}

bool is_valid_by_search(const Mesh& mesh, const Pslg& pslg) {
  return mesh_quality_2(mesh, pslg, Options().check_arrays(Options::Arrays::POINTS_AND_TRIANGLES)).is_valid();
}

Point moved(const Point& p, double x, double y) { return Point(p.x() + x, p.y() + y); }

/// A square, a hole with an island, and slanted segments inside, far from the origin.
Pslg far_away(double offset) {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 4));
  add_polygon(pslg, square(-1.5, 0, 2));
  add_polygon(pslg, square(-1.5, 0, 1));
  for (const Point& p : {Point(1, -3), Point(3, 3), Point(3.5, -2)}) pslg.add_vertex(p);
  add_segment(pslg, 12, 13);
  add_segment(pslg, 13, 14);
  pslg.holes.push_back(Point(-3, 0));
  for (Point& p : pslg.vertices) p = moved(p, offset, offset);
  for (Point& p : pslg.holes) p = moved(p, offset, offset);
  return pslg;
}

/// Adds what follows from the triangles.
void complete(Mesh& mesh) {
  std::map<std::pair<Vertex_index, Vertex_index>, std::size_t> triangle_on;
  const auto side = [&](std::size_t t, std::size_t k) {
    return std::pair(mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]);
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) triangle_on[side(t, k)] = t;
  mesh.neighbors.assign(mesh.triangles.size(), {});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = side(t, k);
      const auto across = triangle_on.find({b, a});
      if (across != triangle_on.end()) mesh.neighbors[t][k] = Triangle_index(across->second);
    }
}

Mesh make_mesh(const Pslg& pslg, const std::vector<std::pair<Point, std::size_t>>& on_segments,
               const std::vector<std::array<std::size_t, 3>>& triangles,
               const std::vector<std::array<std::size_t, 3>>& edges) {
  Mesh mesh;
  mesh.points = pslg.vertices;
  mesh.number_of_input_vertices = pslg.vertices.size();
  mesh.segment_of_vertex.resize(pslg.vertices.size());
  for (const auto& [p, segment] : on_segments) {
    mesh.points.push_back(p);
    mesh.segment_of_vertex.push_back(Segment_index(segment));
  }
  for (const auto& t : triangles)
    mesh.triangles.push_back({Vertex_index(t[0]), Vertex_index(t[1]), Vertex_index(t[2])});
  for (const auto& [a, b, s] : edges)
    mesh.constrained_edges.push_back({{Vertex_index(a), Vertex_index(b)}, Segment_index(s)});
  complete(mesh);
  return mesh;
}

} // namespace

TEST_CASE("Meshes of CGAL are valid wherever they are, and no damage to them is", "[mesh_checker]") {
  const double offset = GENERATE(0.0, 1.0, 1e3, 1e6, 1e9, 1e12);
  CAPTURE(offset);
  const Pslg pslg = far_away(offset);
  const Mesh mesh = mesh_of(pslg, 2);
  REQUIRE(is_valid(mesh, pslg));
  REQUIRE(is_valid_by_search(mesh, pslg));

  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    CAPTURE(t);
    Mesh dropped = mesh;
    dropped.triangles.erase(dropped.triangles.begin() + std::ptrdiff_t(t));
    complete(dropped);
    CHECK_FALSE(mesh_quality_2(dropped, pslg).is_valid());
    CHECK_FALSE(is_valid_by_search(dropped, pslg));
    Mesh turned = mesh;
    std::swap(turned.triangles[t][0], turned.triangles[t][1]);
    CHECK_FALSE(mesh_quality_2(turned, pslg).is_valid());
    Mesh doubled = mesh;
    doubled.triangles.push_back(doubled.triangles[t]);
    complete(doubled);
    CHECK_FALSE(mesh_quality_2(doubled, pslg).is_valid());
  }
  for (std::size_t e = 0; e < mesh.constrained_edges.size(); ++e) {
    CAPTURE(e);
    Mesh lacking = mesh;
    lacking.constrained_edges.erase(lacking.constrained_edges.begin() + std::ptrdiff_t(e));
    CHECK_FALSE(mesh_quality_2(lacking, pslg).is_valid());
    Mesh elsewhere = mesh;
    auto& segment = elsewhere.constrained_edges[e].segment;
    segment = Segment_index((std::size_t(segment) + 1) % pslg.segments.size());
    CHECK_FALSE(mesh_quality_2(elsewhere, pslg).is_valid());
  }
}

TEST_CASE("A vertex on a segment may be four units off, no more", "[mesh_checker]") {
  const double offset = GENERATE(0.0, 1.0, 1e3, 1e6, 1e9, 1e12);
  CAPTURE(offset);
  const Pslg pslg = far_away(offset);
  const Mesh mesh = mesh_of(pslg, 2);
  std::size_t tried = 0, found = 0;
  for (std::size_t v = pslg.vertices.size(); v < mesh.points.size(); ++v) {
    const Segment_index s = mesh.segment_of_vertex[v];
    if (!s.is_valid() || std::size_t(s) >= 12) continue; // those of the squares are parallel to the axes
    if (found++ % (is_full_run() ? 1 : 3) != 0) continue;
    CAPTURE(v);
    const Point &p = pslg.point(pslg.segments[std::size_t(s)][0]),
                &q = pslg.point(pslg.segments[std::size_t(s)][1]);
    const bool is_level = p.y() == q.y();
    const double at = is_level ? p.y() : p.x();
    REQUIRE((is_level ? mesh.points[v].y() : mesh.points[v].x()) == at);
    const double unit = unit_in_last_place(at);
    for (int units : {-6, -5, -4, -1, 1, 4, 5, 6}) {
      Mesh changed = mesh;
      changed.points[v] = is_level ? Point(mesh.points[v].x(), at + units * unit)
                                   : Point(at + units * unit, mesh.points[v].y());
      CAPTURE(units);
      const bool is_beyond =
          std::abs((is_level ? changed.points[v].y() : changed.points[v].x()) - at) > 4 * unit;
      CHECK(mesh_quality_2(changed, pslg).is_valid() != is_beyond);
      CHECK(is_valid_by_search(changed, pslg) != is_beyond);
      if (at != 0) CHECK(is_valid(changed, pslg) != is_beyond); // scaled, the unit of 0 stays what it is
    }
    ++tried;
  }
  CHECK(tried > 4);
}

TEST_CASE("Slanted segments: as many units as the definition allows", "[mesh_checker]") {
  // From (8, 8) to (24, 16); units are 2^-48 along x, 2^-48 along y, and lines of slope 1/2 are 4 + 8 units apart along
  // y between one that touches the box of four units about a vertex and one that does on the other side.
  Pslg pslg;
  add_polygon(pslg, {Point(8, 8), Point(24, 16), Point(12, 20)});
  const double unit = 0x1p-48;
  for (int x = -9; x <= 9; ++x)
    for (int y = -9; y <= 9; ++y) {
      CAPTURE(x, y);
      const Mesh mesh = make_mesh(pslg, {{Point(16 + x * unit, 12 + y * unit), 0}}, {{0, 3, 2}, {3, 1, 2}},
                                  {{0, 3, 0}, {3, 1, 0}, {1, 2, 1}, {2, 0, 2}});
      const bool is_near = std::abs(2 * y - x) <= 4 * (2 + 1);
      CHECK(is_valid(mesh, pslg) == is_near);
      CHECK(is_valid_by_search(mesh, pslg) == is_near);
    }
}

TEST_CASE("A chain goes ahead all the way", "[mesh_checker]") {
  Pslg pslg;
  add_polygon(pslg, {Point(0, 0), Point(8, 0), Point(8, 8)});
  const auto mesh_with = [&](double x1, double x2) {
    return make_mesh(pslg, {{Point(x1, 0), 0}, {Point(x2, 0), 0}}, {{0, 3, 2}, {3, 4, 2}, {4, 1, 2}},
                     {{0, 3, 0}, {3, 4, 0}, {4, 1, 0}, {1, 2, 1}, {2, 0, 2}});
  };
  CHECK(is_valid(mesh_with(2, 5), pslg));
  CHECK(is_valid(mesh_with(2, std::nextafter(2, 3)), pslg));
  CHECK_FALSE(is_valid(mesh_with(2, 2), pslg));
  CHECK_FALSE(is_valid(mesh_with(2, std::nextafter(2, 1)), pslg));
  CHECK_FALSE(is_valid(mesh_with(-1, 2), pslg));
  CHECK_FALSE(is_valid(mesh_with(2, 9), pslg));
}

TEST_CASE("Parts of the domain do not overlap, by not even a unit", "[mesh_checker]") {
  const double y = GENERATE(8.0, 1e3, 1e6, 1e9, 1e12);
  const int gap = GENERATE(1, 2, 8);
  const double unit = unit_in_last_place(y);
  CAPTURE(y, gap);
  Pslg pslg;
  add_polygon(pslg, {Point(y, y - 4), Point(y + 4, y - 4), Point(y + 4, y), Point(y, y)});
  add_polygon(pslg,
              {Point(y, y + gap * unit), Point(y + 4, y + gap * unit), Point(y + 4, y + 4), Point(y, y + 4)});
  for (int units = -5; units <= 5; ++units) {
    CAPTURE(units);
    const Mesh mesh = make_mesh(
        pslg, {{Point(y + 2, y + units * unit), 2}}, {{0, 1, 8}, {1, 2, 8}, {0, 8, 3}, {4, 5, 6}, {4, 6, 7}},
        {{0, 1, 0}, {1, 2, 1}, {2, 8, 2}, {8, 3, 2}, {3, 0, 3}, {4, 5, 4}, {5, 6, 5}, {6, 7, 6}, {7, 4, 7}});
    const bool is_apart = std::abs(units) <= 4 && units < gap;
    CHECK(is_valid(mesh, pslg) == is_apart);
    CHECK(is_valid_by_search(mesh, pslg) == is_apart);
  }
}

TEST_CASE("A part of the domain is not within another", "[mesh_checker]") {
  const double y = GENERATE(8.0, 1e3, 1e6, 1e9, 1e12);
  const double unit = unit_in_last_place(y);
  CAPTURE(y);
  Pslg pslg;
  add_polygon(pslg, {Point(y, y - 4), Point(y + 4, y - 4), Point(y + 4, y), Point(y, y)});
  add_polygon(pslg, {Point(y + 2, y + unit), Point(y + 2 + unit, y + unit), Point(y + 2, y + 2 * unit)});
  for (int units = -4; units <= 4; ++units) {
    CAPTURE(units);
    const Mesh mesh =
        make_mesh(pslg, {{Point(y + 2, y + units * unit), 2}}, {{0, 1, 7}, {1, 2, 7}, {0, 7, 3}, {4, 5, 6}},
                  {{0, 1, 0}, {1, 2, 1}, {2, 7, 2}, {7, 3, 2}, {3, 0, 3}, {4, 5, 4}, {5, 6, 5}, {6, 4, 6}});
    CHECK(is_valid(mesh, pslg) == (units < 1));
  }
}

TEST_CASE("Without a domain, triangles do not overlap either", "[mesh_checker]") {
  const Options any =
      Options().check_domain(Options::Domain::ANY).check_arrays(Options::Arrays::POINTS_AND_TRIANGLES);
  const auto is_fine = [&](const std::vector<Point>& points,
                           const std::vector<std::array<std::size_t, 3>>& triangles) {
    Pslg pslg;
    pslg.vertices = points;
    return mesh_quality_2(make_mesh(pslg, {}, triangles, {}), pslg, any).is_valid();
  };
  const Point a(0, 0), b(4, 0), c(0, 4), d(4, 4);
  CHECK(is_fine({a, b, c, d}, {{0, 1, 2}, {1, 3, 2}}));
  CHECK(is_fine({a, b, c, Point(5, 0), Point(9, 0), Point(5, 4)}, {{0, 1, 2}, {3, 4, 5}}));
  // beside each other, one in the other, crossing, with a vertex on a side, touching in a vertex
  CHECK(is_fine({a, b, c, Point(4, 1), Point(6, 0), Point(6, 1)}, {{0, 1, 2}, {3, 4, 5}}));
  CHECK_FALSE(is_fine({a, b, c, Point(1, 1), Point(1.5, 1), Point(1, 1.5)}, {{0, 1, 2}, {3, 4, 5}}));
  CHECK_FALSE(is_fine({a, b, c, Point(1, 1), Point(5, 1), Point(5, 2)}, {{0, 1, 2}, {3, 4, 5}}));
  CHECK_FALSE(is_fine({a, b, c, Point(2, 2), Point(5, 1), Point(5, 2)}, {{0, 1, 2}, {3, 4, 5}}));
  CHECK(is_fine({a, b, c, Point(5, -1), Point(5, 2)}, {{0, 1, 2}, {1, 3, 4}}));
  // a fan that goes around its center twice
  std::vector<Point> star;
  for (int i = 0; i < 10; ++i)
    star.emplace_back((i + 1) * std::cos(0.4 * i * CGAL_PI), (i + 1) * std::sin(0.4 * i * CGAL_PI));
  star.emplace_back(0, 0);
  std::vector<std::array<std::size_t, 3>> fan;
  for (std::size_t i = 0; i < 9; ++i) fan.push_back({i, i + 1, 10});
  CHECK_FALSE(is_fine(star, fan));
  fan.resize(4);
  star.erase(star.begin() + 5, star.begin() + 10);
  for (auto& t : fan) t[2] = 5;
  CHECK(is_fine(star, fan));
}

TEST_CASE("Two segments do not meet at a vertex that is none of the input's", "[mesh_checker]") {
  Pslg pslg;
  add_polygon(pslg, {Point(1, 1), Point(3, 1), Point(3, 3), Point(1, 3)});
  const double y = 1 + 0x1p-51; // as near to the lower side as rounding is
  pslg.add_vertex(Point(1.5, y)), pslg.add_vertex(Point(2.5, y));
  add_segment(pslg, 4, 5);
  Mesh mesh = make_mesh(pslg, {{Point(2, 1), 0}},
                        {{0, 6, 4}, {4, 6, 5}, {6, 1, 5}, {1, 2, 5}, {4, 5, 3}, {5, 2, 3}, {0, 4, 3}},
                        {{0, 6, 0}, {6, 1, 0}, {1, 2, 1}, {2, 3, 2}, {3, 0, 3}, {4, 5, 4}});
  CHECK(is_valid(mesh, pslg));
  // the vertex below, now of both segments
  mesh.triangles = {{Vertex_index(0), Vertex_index(6), Vertex_index(4)},
                    {Vertex_index(6), Vertex_index(1), Vertex_index(5)},
                    {Vertex_index(1), Vertex_index(2), Vertex_index(5)},
                    {Vertex_index(4), Vertex_index(6), Vertex_index(3)},
                    {Vertex_index(6), Vertex_index(5), Vertex_index(3)},
                    {Vertex_index(5), Vertex_index(2), Vertex_index(3)},
                    {Vertex_index(0), Vertex_index(4), Vertex_index(3)}};
  complete(mesh);
  mesh.constrained_edges.back().vertices = {Vertex_index(4), Vertex_index(6)};
  mesh.constrained_edges.push_back({{Vertex_index(6), Vertex_index(5)}, Segment_index(4)});
  CHECK_FALSE(is_valid(mesh, pslg));
  CHECK_FALSE(is_valid_by_search(mesh, pslg));
}

TEST_CASE("A point of a hole or region on a segment between components is an error", "[mesh_checker]") {
  Pslg pslg = far_away(0);
  const Mesh mesh = mesh_of(pslg, 2);
  const Pslg good = pslg;
  pslg.holes[0] = Point(-3.5, 0.5);
  CHECK_FALSE(mesh_quality_2(mesh, pslg).is_valid());
  pslg.holes[0] = Point(-3.5, 2);
  CHECK_FALSE(mesh_quality_2(mesh, pslg).is_valid());
  pslg = good;
  pslg.holes.push_back(Point(100, 100));
  CHECK(mesh_quality_2(mesh, pslg).is_valid());
  pslg.regions.push_back({Point(2, 0), 1, 0}); // on a segment that dangles: one component on both sides
  Mesh with_regions = mesh;
  const auto is_in_island = [&](const auto& t) {
    const auto is_there = [&](Vertex_index v) {
      return std::abs(mesh.point(v).x() + 1.5) <= 1 && std::abs(mesh.point(v).y()) <= 1;
    };
    return is_there(t[0]) && is_there(t[1]) && is_there(t[2]);
  };
  for (const auto& t : mesh.triangles) with_regions.region_of_triangle.push_back(is_in_island(t) ? -1 : 0);
  CHECK(mesh_quality_2(with_regions, pslg).is_valid());
  for (int& r : with_regions.region_of_triangle) r = -1 - r;
  CHECK_FALSE(mesh_quality_2(with_regions, pslg).is_valid());
}

TEST_CASE("Wedges excuse angles of at least nine tenths of theirs, however small", "[mesh_checker]") {
  const int e = GENERATE(1, 5, 20, 40, 52, 57, 100, 400);
  CAPTURE(e);
  const double phi = std::ldexp(1., -e);
  // The triangle of the vertices 3, 1 and 4 has half the wedge's angle at vertex 1.
  Pslg pslg;
  add_polygon(pslg, {Point(0, 0), Point(3, 0), Point(3, 3 * phi)});
  const Mesh mesh = make_mesh(pslg, {{Point(1, 0), 0}, {Point(1, phi), 2}}, {{0, 3, 4}, {3, 1, 4}, {1, 2, 4}},
                              {{0, 3, 0}, {3, 1, 0}, {1, 2, 1}, {2, 4, 2}, {4, 0, 2}});
  for (int scale : {-600, 0, 600}) {
    CAPTURE(scale);
    const auto quality = mesh_quality_2(scaled(mesh, scale), scaled(pslg, scale), Options().min_angle(20.7));
    CHECK(quality.is_valid());
    CHECK(quality.exempt_triangles == (e == 1 ? 0 : 2));
    CHECK(quality.unmet_triangles.size() == 1);
    if (e > 5) CHECK(quality.min_angle == Approx(phi / 2 * 180 / CGAL_PI).epsilon(1e-6));
  }
}

TEST_CASE("Coordinates that are no numbers are errors", "[mesh_checker]") {
  const Pslg pslg = far_away(0);
  const Mesh mesh = mesh_of(pslg, 2);
  for (double bad : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    Mesh changed = mesh;
    changed.points.back() = Point(bad, 0);
    CHECK_FALSE(mesh_quality_2(changed, pslg).is_valid());
    Pslg input = pslg;
    input.vertices[3] = Point(0, bad);
    CHECK_FALSE(mesh_quality_2(mesh, input).is_valid());
    input = pslg;
    input.holes[0] = Point(0, bad);
    CHECK_FALSE(mesh_quality_2(mesh, input).is_valid());
  }
}

TEST_CASE("Angles of meshes of any size", "[mesh_checker]") {
  const Pslg pslg = far_away(1);
  const Mesh mesh = mesh_of(pslg, 2);
  const auto quality = mesh_quality_2(mesh, pslg);
  for (int e : exponents) {
    CAPTURE(e);
    const auto other = mesh_quality_2(scaled(mesh, e), scaled(pslg, e));
    CHECK(other.min_angle == quality.min_angle);
    CHECK(other.max_angle == quality.max_angle);
    CHECK(other.angle_histogram == quality.angle_histogram);
    CHECK(other.shortest_edge == std::ldexp(quality.shortest_edge, e));
    CHECK(other.longest_edge == std::ldexp(quality.longest_edge, e));
    CHECK(other.largest_area == std::ldexp(quality.largest_area, 2 * e));
  }
}

TEST_CASE("A triangle of 2^-900 beside one of 1", "[mesh_checker]") {
  const double tiny = 0x1p-900;
  Pslg pslg;
  add_polygon(pslg, {Point(0, 0), Point(4, 0), Point(0, 4)});
  add_polygon(pslg, {Point(-3 * tiny, -3 * tiny), Point(-2 * tiny, -3 * tiny), Point(-3 * tiny, -2 * tiny)});
  const Mesh mesh = make_mesh(pslg, {}, {{0, 1, 2}, {3, 4, 5}},
                              {{0, 1, 0}, {1, 2, 1}, {2, 0, 2}, {3, 4, 3}, {4, 5, 4}, {5, 3, 5}});
  const auto quality = mesh_quality_2(mesh, pslg, Options().min_angle(44));
  CHECK(quality.errors == std::vector<std::string>());
  CHECK(quality.triangles == 2);
  CHECK(quality.min_angle == Approx(45));
  CHECK(quality.max_angle == Approx(90));
  CHECK(quality.shortest_edge == tiny);
  CHECK(quality.is_met());
}

} // namespace test_mesh_checker
