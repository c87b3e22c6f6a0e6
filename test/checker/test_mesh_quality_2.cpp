// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "mesh_from_cdt.h"

#include <CGAL/mesh_quality_2.h>

#include <array>
#include <cstdint>
#include <sstream>
#include <string>

namespace test_mesh_quality_2 {

using namespace test_meshes;
using CGAL::mesh_quality_2;
using Options = CGAL::Mesh_quality_options_2;

namespace {

/// A square with a square hole, an island in the hole, a segment that dangles into the domain and an isolated
/// vertex.
Pslg square_with_hole() {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 4));
  add_polygon(pslg, square(0, 0, 2));
  add_polygon(pslg, square(0, 0, 1));
  pslg.add_vertex(Point(3, -3));
  pslg.add_vertex(Point(3.5, -1));
  add_segment(pslg, 12, 13);
  pslg.add_vertex(Point(-3, 0.25));
  pslg.holes.push_back(Point(1.5, 0));
  return pslg;
}

void require_valid(const Mesh& mesh, const Pslg& pslg, const Options& options = {}) {
  const auto quality = mesh_quality_2(mesh, pslg, options);
  INFO(quality);
  REQUIRE(quality.is_valid());
}

/// Requires that the mesh is refused with an error that contains `text`.
void require_error(const Mesh& mesh, const Pslg& pslg, const std::string& text, Options options = {}) {
  options.max_errors(100000);
  const auto quality = mesh_quality_2(mesh, pslg, options);
  INFO("expected: " << text << ", first of " << quality.number_of_errors
                    << " errors: " << (quality.errors.empty() ? "none" : quality.errors.front()));
  REQUIRE_FALSE(quality.is_valid());
  bool is_found = false;
  for (const auto& e : quality.errors) is_found = is_found || e.find(text) != std::string::npos;
  REQUIRE(is_found);
}

void forget_triangle(Mesh& mesh, std::size_t t) {
  const std::size_t last = mesh.triangles.size() - 1;
  for (auto& n : mesh.neighbors)
    for (auto& i : n)
      i = i == Triangle_index(t) ? Triangle_index() : i == Triangle_index(last) ? Triangle_index(t) : i;
  mesh.triangles[t] = mesh.triangles[last];
  mesh.neighbors[t] = mesh.neighbors[last];
  mesh.triangles.pop_back();
  mesh.neighbors.pop_back();
}

} // namespace

TEST_CASE("meshes by Mesh_2 are valid", "[mesh_quality_2]") {
  const Pslg pslg = square_with_hole();
  for (double size : {0., 10., 0.5}) {
    const Mesh mesh = mesh_of(pslg, size);
    require_valid(mesh, pslg);
    require_valid(mesh, pslg, Options().check_arrays(Options::Arrays::POINTS_AND_TRIANGLES));
    const auto quality = mesh_quality_2(mesh, pslg);
    CHECK(quality.area == Approx(64 - 16 + 4));
    CHECK(quality.domain_area == Approx(52));
  }
}

TEST_CASE("the statistics of one right triangle", "[mesh_quality_2]") {
  Pslg pslg;
  add_polygon(pslg, {Point(0, 0), Point(4, 0), Point(0, 3)});
  const auto quality = mesh_quality_2(mesh_of(pslg), pslg);
  CHECK(quality.is_valid());
  CHECK(quality.triangles == 1);
  CHECK(quality.vertices == 3);
  CHECK(quality.edges == 3);
  CHECK(quality.border_edges == 3);
  CHECK(quality.area == Approx(6));
  CHECK(quality.largest_area == Approx(6));
  CHECK(quality.total_length == Approx(12));
  CHECK(quality.shortest_edge == Approx(3));
  CHECK(quality.longest_edge == Approx(5));
  CHECK(quality.min_angle == Approx(36.8698976));
  CHECK(quality.max_angle == Approx(90));
  CHECK(quality.min_new_angle == 180);
  CHECK(quality.angle_histogram[3] == 1);
  CHECK(quality.angle_histogram[5] == 1);
  CHECK(quality.angle_histogram[9] + quality.angle_histogram[8] == 1);
  std::ostringstream text;
  text << quality;
  CHECK(text.str().find("valid mesh") == 0);
}

TEST_CASE("bounds on angle, edge and area", "[mesh_quality_2]") {
  Pslg pslg;
  add_polygon(pslg, {Point(0, 0), Point(4, 0), Point(0, 3)});
  const Mesh mesh = mesh_of(pslg);
  CHECK(mesh_quality_2(mesh, pslg, Options().max_edge(5).max_area(6)).is_met());
  const auto edge = mesh_quality_2(mesh, pslg, Options().max_edge(4.9));
  REQUIRE(edge.unmet_triangles.size() == 1);
  CHECK(edge.unmet_triangles[0].bound == CGAL::Mesh_quality_2::Bound::EDGE_LENGTH);
  CHECK(mesh_quality_2(mesh, pslg, Options().max_area(5.9)).unmet_triangles.size() == 1);
  // The wedge of 36.87 degrees excuses the triangle from any angle bound that is higher.
  CHECK(mesh_quality_2(mesh, pslg, Options().min_angle(36)).exempt_triangles == 0);
  CHECK(mesh_quality_2(mesh, pslg, Options().min_angle(37)).exempt_triangles == 1);
  CHECK(mesh_quality_2(mesh, pslg, Options().min_angle(37)).is_met());
}

TEST_CASE("only a wedge of two segments excuses a small angle", "[mesh_quality_2]") {
  Pslg pslg;
  SECTION("a flat rectangle has no wedge") {
    add_polygon(pslg, {Point(0, 0), Point(10, 0), Point(10, 1), Point(0, 1)});
    const auto quality = mesh_quality_2(mesh_of(pslg), pslg, Options().min_angle(20));
    CHECK(quality.exempt_triangles == 0);
    REQUIRE(quality.unmet_triangles.size() == 2);
    CHECK(quality.unmet_triangles[0].least_angle == Approx(5.7105931));
    CHECK(quality.min_new_angle == Approx(5.7105931));
  }
  SECTION("a triangle across the wedge is excused, one behind it is not") {
    // Apex 0; sides 0 1 2 and 0 3, an edge from 1 to 3 that is not in the input, then a sliver 1 2 3.
    add_polygon(pslg, {Point(0, 0), Point(1, 0), Point(1.05, 0.001), Point(1, 0.2)});
    const auto quality = mesh_quality_2(mesh_of(pslg), pslg, Options().min_angle(20));
    CHECK(quality.exempt_triangles == 1);
    CHECK(quality.unmet_triangles.size() == 1);
  }
  SECTION("a triangle in the wedge with an angle far below the wedge's is not excused") {
    add_polygon(pslg, {Point(0, 0), Point(10, 0), Point(10, 3), Point(1, 0.3)});
    pslg.segments.pop_back();
    add_segment(pslg, 3, 0);
    const auto quality = mesh_quality_2(mesh_of(pslg), pslg, Options().min_angle(20));
    CHECK(quality.exempt_triangles + quality.unmet_triangles.size() >= 1);
    CHECK(quality.unmet_triangles.size() >= 1);
  }
}

TEST_CASE("every kind of damage is found", "[mesh_quality_2]") {
  const Pslg pslg = square_with_hole();
  Mesh mesh = mesh_of(pslg, 0.5);
  require_valid(mesh, pslg);
  const auto is_interior = [&](std::size_t t) {
    return mesh.neighbors[t][0].is_valid() && mesh.neighbors[t][1].is_valid() &&
           mesh.neighbors[t][2].is_valid();
  };
  std::size_t inner = 0;
  while (!is_interior(inner)) ++inner;

  SECTION("index out of range") {
    mesh.triangles[3][1] = Vertex_index(mesh.points.size());
    require_error(mesh, pslg, "triangle 3 has vertex");
  }
  SECTION("a vertex twice in a triangle") {
    mesh.triangles[3][1] = mesh.triangles[3][2];
    require_error(mesh, pslg, "twice");
  }
  SECTION("clockwise triangle") {
    std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
    require_error(mesh, pslg, "is clockwise");
  }
  SECTION("missing triangle inside") {
    forget_triangle(mesh, inner);
    require_error(mesh, pslg, "on the border of the mesh");
    require_error(mesh, pslg, "Euler");
  }
  SECTION("missing triangles beside a segment") {
    std::size_t t = 0;
    while (is_interior(t)) ++t;
    forget_triangle(mesh, t);
    require_error(mesh, pslg, "segment");
  }
  SECTION("duplicate triangle") {
    mesh.triangles.push_back(mesh.triangles[inner]);
    mesh.neighbors.push_back(mesh.neighbors[inner]);
    require_error(mesh, pslg, "both have the directed edge");
  }
  SECTION("moved input vertex, by one bit") {
    mesh.points[14] = Point(std::nextafter(mesh.points[14].x(), 0.), mesh.points[14].y());
    require_error(mesh, pslg, "input vertex 14 moved");
  }
  SECTION("folded over: a Steiner vertex moved across an edge") {
    for (std::size_t v = mesh.points.size(); v-- > pslg.vertices.size();)
      if (!mesh.segment_of_vertex[v].is_valid()) {
        mesh.points[v] = Point(mesh.points[v].x() + 3, mesh.points[v].y());
        break;
      }
    require_error(mesh, pslg, "clockwise");
  }
  SECTION("a vertex on a segment moved off it") {
    for (std::size_t v = mesh.points.size(); v-- > pslg.vertices.size();)
      if (mesh.segment_of_vertex[v].is_valid()) {
        mesh.points[v] = Point(mesh.points[v].x() + 1e-6, mesh.points[v].y() + 1e-6);
        break;
      }
    require_error(mesh, pslg, "is not on input segment");
    require_error(mesh, pslg, "is not a chain of mesh edges",
                  Options().check_arrays(Options::Arrays::POINTS_AND_TRIANGLES));
  }
  SECTION("wrong neighbor") {
    mesh.neighbors[inner][0] = Triangle_index(inner);
    require_error(mesh, pslg, "neighbor 0 of triangle " + std::to_string(inner));
  }
  SECTION("missing neighbor") {
    mesh.neighbors[inner][2] = Triangle_index();
    require_error(mesh, pslg, "neighbor 2 of triangle " + std::to_string(inner) + " is none");
  }
  SECTION("two vertices at one place") {
    mesh.points.push_back(mesh.points[std::size_t(mesh.triangles[inner][0])]);
    mesh.segment_of_vertex.emplace_back();
    mesh.triangles[inner][0] = Vertex_index(mesh.points.size() - 1);
    require_error(mesh, pslg, "at one place");
  }
  SECTION("dangling Steiner vertex") {
    mesh.points.push_back(Point(0.123, 0.456));
    mesh.segment_of_vertex.emplace_back();
    require_error(mesh, pslg, "neither an input vertex nor used");
  }
  SECTION("missing constrained edge") {
    mesh.constrained_edges.pop_back();
    require_error(mesh, pslg, "not all edges of input segment");
  }
  SECTION("constrained edge twice") {
    mesh.constrained_edges.push_back(mesh.constrained_edges.front());
    require_error(mesh, pslg, "listed twice");
  }
  SECTION("constrained edge on the wrong segment") {
    mesh.constrained_edges.front().segment = Segment_index(5);
    require_error(mesh, pslg, "not in the chain of input segment 5");
  }
  SECTION("constrained edge that is no edge") {
    mesh.constrained_edges.push_back({{Vertex_index(0), Vertex_index(2)}, Segment_index(0)});
    require_error(mesh, pslg, "is not an edge of the mesh");
  }
  SECTION("wrong segment of a vertex") {
    mesh.segment_of_vertex[0] = Segment_index(0);
    require_error(mesh, pslg, "segment_of_vertex of vertex 0");
  }
  SECTION("arrays of the wrong length") {
    mesh.neighbors.pop_back();
    require_error(mesh, pslg, "neighbors for");
    mesh = mesh_of(pslg);
    mesh.region_of_triangle.resize(mesh.triangles.size());
    require_error(mesh, pslg, "region_of_triangle");
  }
  SECTION("hole filled") {
    Pslg without_hole = pslg;
    without_hole.holes.clear();
    require_error(mesh_of(without_hole), pslg, "is outside the domain");
  }
  SECTION("domain taken for a hole") {
    require_error(
        mesh_of(pslg),
        [&] {
          Pslg p = pslg;
          p.holes.clear();
          return p;
        }(),
        "no triangle on the left");
  }
  SECTION("segment flipped away") {
    Pslg crossed = pslg;
    crossed.segments[0] = {Vertex_index(12), Vertex_index(1)};
    require_error(mesh, crossed, "");
  }
  SECTION("no triangles at all") {
    mesh.triangles.clear();
    mesh.neighbors.clear();
    require_error(mesh, pslg, "input vertex 0 is in the domain, but not in the mesh");
  }
}

TEST_CASE("an overlap of two sheets is found", "[mesh_quality_2]") {
  // A fan that goes twice around its center: counterclockwise triangles, paired edges, and yet no
  // triangulation.
  Pslg pslg;
  std::vector<Point> ring;
  for (int i = 0; i < 5; ++i)
    ring.emplace_back(std::cos(i * 1.2566370614359172), std::sin(i * 1.2566370614359172));
  add_polygon(pslg, ring);
  pslg.add_vertex(Point(0.01, 0.02));
  Mesh mesh = mesh_of(pslg);
  require_valid(mesh, pslg);
  mesh.triangles.clear();
  mesh.neighbors.clear();
  const Options loose = Options().check_arrays(Options::Arrays::POINTS_AND_TRIANGLES);
  for (std::size_t i = 0; i < 5; ++i)
    mesh.triangles.push_back({Vertex_index(2 * i % 5), Vertex_index((2 * i + 2) % 5), Vertex_index(5)});
  require_error(mesh, pslg, "on the border of the mesh", loose);
}

TEST_CASE("duplicates, vertices on segments, overlaps and dangling parts outside", "[mesh_quality_2]") {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 2));
  pslg.add_vertex(Point(-2, -2)); // 4, duplicate of 0
  pslg.add_vertex(Point(0, -2));  // 5, on segment 0
  pslg.add_vertex(Point(0, 0));   // 6
  add_segment(pslg, 5, 6);
  add_segment(pslg, 4, 5);       // overlaps segment 0
  add_segment(pslg, 1, 0);       // is segment 0
  add_segment(pslg, 4, 0);       // has no length
  pslg.add_vertex(Point(5, -2)); // 7
  add_segment(pslg, 5, 7);       // overlaps segment 0, then leaves the domain
  pslg.add_vertex(Point(8, 8));  // 8, outside
  add_segment(pslg, 7, 8);       // outside
  for (double size : {0., 0.7}) {
    Mesh mesh = mesh_of(pslg, size);
    require_valid(mesh, pslg);
    for (auto& t : mesh.triangles) // the other one of the two vertices at one place will do as well
      for (auto& v : t)
        if (v == Vertex_index(0)) v = Vertex_index(4);
    for (auto& e : mesh.constrained_edges)
      for (auto& v : e.vertices)
        if (v == Vertex_index(0)) v = Vertex_index(4);
    require_valid(mesh, pslg);
    mesh.constrained_edges[0].segment = Segment_index(6); // lies on it, but segment 0 is the first
    require_error(mesh, pslg, "not all edges of input segment 0");
    require_error(mesh, pslg, "input segment 6, or this is not the first one along it");
  }
}

TEST_CASE("components that touch in a vertex", "[mesh_quality_2]") {
  Pslg pslg;
  add_polygon(pslg, square(-1, -1, 1));
  for (const Point& p : {Point(2, 0), Point(2, 2), Point(0, 2)}) pslg.add_vertex(p);
  for (auto e : {std::array<std::size_t, 2>{2, 4}, {4, 5}, {5, 6}, {6, 2}}) add_segment(pslg, e[0], e[1]);
  require_valid(mesh_of(pslg), pslg);
  require_valid(mesh_of(pslg, 0.3), pslg);
}

TEST_CASE("inputs without sense give errors, not crashes", "[mesh_quality_2]") {
  Pslg pslg;
  require_valid(Mesh(), pslg);
  CHECK(mesh_quality_2(Mesh(), pslg).triangles == 0);
  add_polygon(pslg, square(0, 0, 1));
  require_error(Mesh(), pslg, "fewer than the input's");
  Mesh mesh = mesh_of(pslg);
  add_segment(pslg, 0, 99);
  require_error(mesh, pslg, "ends at vertex 99");
  pslg.segments.pop_back();
  add_segment(pslg, 0, 2);
  add_segment(pslg, 1, 3);
  require_error(mesh, pslg, "cross");
}

TEST_CASE("meshes of points are checked without a domain", "[mesh_quality_2]") {
  Pslg pslg;
  for (const Point& p : square(0, 0, 1)) pslg.add_vertex(p);
  Cdt cdt = triangulate(pslg);
  for (auto f : cdt.finite_face_handles()) f->set_in_domain(true);
  const Mesh mesh = mesh_from_cdt(cdt, pslg);
  require_valid(mesh, pslg, Options().check_domain(Options::Domain::ANY));
  require_error(mesh, pslg, "on no input segment");
}

TEST_CASE("regions do not change without a segment between", "[mesh_quality_2]") {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 2));
  pslg.regions.push_back({Point(0, 0), 1, 0});
  Mesh mesh = mesh_of(pslg);
  mesh.region_of_triangle.assign(mesh.triangles.size(), 0);
  require_valid(mesh, pslg);
  mesh.region_of_triangle[0] = -1;
  require_error(mesh, pslg, "no input segment separates");
  mesh.region_of_triangle[0] = 1;
  require_error(mesh, pslg, "which does not exist");
  mesh.region_of_triangle.assign(mesh.triangles.size(), -1);
  require_error(mesh, pslg, "by the regions' points in 0");
}

namespace {
struct Integer_point {
  std::uint64_t x_ = 0, y_ = 0;
  std::uint64_t x() const { return x_; }
  std::uint64_t y() const { return y_; }
};
} // namespace

TEST_CASE("integer points are converted", "[mesh_quality_2]") {
  CGAL::Pslg_2<Integer_point> pslg;
  const std::uint64_t side = std::uint64_t(1) << 62;
  for (const Integer_point& p : {Integer_point{0, 0}, Integer_point{side, 0}, Integer_point{0, side}})
    pslg.add_vertex(p);
  for (std::size_t i = 0; i < 3; ++i) pslg.add_segment(Vertex_index(i), Vertex_index((i + 1) % 3));
  CGAL::Indexed_mesh_2<Integer_point> mesh;
  mesh.number_of_input_vertices = 3;
  mesh.points = pslg.vertices;
  mesh.triangles.push_back({Vertex_index(0), Vertex_index(1), Vertex_index(2)});
  mesh.neighbors.resize(1);
  mesh.segment_of_vertex.resize(3);
  for (std::size_t i = 0; i < 3; ++i) mesh.constrained_edges.push_back({pslg.segments[i], Segment_index(i)});
  const auto quality = mesh_quality_2(mesh, pslg);
  INFO(quality);
  CHECK(quality.is_valid());
  CHECK(quality.area == std::ldexp(1., 123));
}

} // namespace test_mesh_quality_2
