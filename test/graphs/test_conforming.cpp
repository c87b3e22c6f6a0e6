// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Conforming Delaunay meshes, convex hulls and limits on Steiner vertices: what Triangle's manual promises of -D,
// -c and -S, judged by brute force and by CGAL.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "pslg_test_tools.h"
#include "random_pslg.h"
#include "random_pslg_shapes.h"

#include <CGAL/IO/read_triangle_files.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/Tree_separation_options_2.h>
#include <CGAL/add_convex_hull_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/dual_of_mesh_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace test_conforming {

using namespace test_meshes;
using Options = CGAL::Quality_mesh_options_2;
using Report = CGAL::Quality_mesh_report_2;
using Mesher = CGAL::Quality_mesher_2<>;

namespace {

constexpr auto delaunay = Options::Conforming::DELAUNAY;

/// How many pairs of a triangle and a vertex in its circle there are, exactly; all vertices that are used count.
std::size_t vertices_in_circles(const Mesh& mesh) {
  std::set<Vertex_index> used;
  for (const auto& t : mesh.triangles) used.insert(t.begin(), t.end());
  std::size_t n = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    for (const Vertex_index v : used)
      n += CGAL::side_of_oriented_circle(mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(v)) ==
                   CGAL::ON_POSITIVE_SIDE
               ? 1
               : 0;
  return n;
}

/// How many constrained edges have the vertex of a triangle beside them in their diametral circle, by more than
/// rounding.
std::size_t obtuse_angles_at_edges(const Mesh& mesh) {
  std::set<std::set<Vertex_index>> constrained;
  for (const auto& e : mesh.constrained_edges) constrained.insert({e.vertices[0], e.vertices[1]});
  std::size_t n = 0;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex_index a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      if (constrained.count({a, b}) == 0) continue;
      const auto u = mesh.point(a) - mesh.point(t[k]), v = mesh.point(b) - mesh.point(t[k]);
      n += u * v < -1e-12 * std::max(u.squared_length(), v.squared_length()) ? 1 : 0;
    }
  return n;
}

/// That cells of vertices inside do not touch the border: they are made of the triangles between their vertex and what
/// is between them and other cells.
void check_cells_inside(const Mesh& mesh) {
  const CGAL::Mesh_dual_2 dual = CGAL::dual_of_mesh_2(mesh);
  std::vector<double> areas(mesh.points.size(), 0);
  std::vector<char> is_on_border(mesh.points.size(), 0);
  double total = 0;
  for (std::size_t e = 0; e < dual.edges.size(); ++e) {
    const auto& [a, b] = dual.edges[e].vertices;
    const double length = std::sqrt(CGAL::squared_distance(mesh.point(a), mesh.point(b)));
    for (const Vertex_index v : {a, b}) {
      areas[std::size_t(v)] += length / 2 * dual.lengths[e] / 2;
      if (dual.edges[e].is_on_border()) is_on_border[std::size_t(v)] = 1;
    }
    total += length * dual.lengths[e] / 2;
  }
  for (std::size_t v = 0; v < areas.size(); ++v)
    if (is_on_border[v] == 0) CHECK(std::abs(areas[v] - dual.areas[v]) <= 1e-9 * total);
}

/// Legs a degree apart in a box.
Pslg fan_of_random_lengths(std::size_t legs) {
  Pslg pslg;
  random_pslg::Random random(legs);
  add_polygon(pslg, square(0, 0, 2));
  const Vertex_index apex = pslg.add_vertex(Point(0, 0));
  for (std::size_t i = 0; i < legs; ++i) {
    const double angle = double(i) * 0.0174533, length = random.between(0.5, 1);
    pslg.add_segment(apex, pslg.add_vertex(Point(length * std::cos(angle), length * std::sin(angle))));
  }
  return pslg;
}

/// A square with segments in it that need not be cut for any bound but have vertices in their circles.
Pslg square_with_segments() {
  Pslg pslg;
  add_polygon(pslg, square(0, 0, 10));
  add_polygon(pslg, square(1, 1, 0.5));
  pslg.add_vertex(Point(-9, -3));
  pslg.add_vertex(Point(9, -3.2));
  add_segment(pslg, 8, 9);
  for (const double x : {-7., -2., 3.}) pslg.add_vertex(Point(x, -2.5));
  return pslg;
}

} // namespace

TEST_CASE("conforming meshes of convex domains are the Delaunay triangulations of their vertices",
          "[conforming]") {
  std::vector<Pslg> graphs{square_with_segments()};
  for (const std::size_t family : {0u, 3u, 4u}) graphs.push_back(random_pslg::families()[family].make(2));
  for (Pslg& pslg : graphs) {
    pslg.holes.clear();
    CGAL::add_convex_hull_2(pslg);
    if (pslg.vertices.size() > 500) continue;
    Mesher plain, mesher(Options().conform(delaunay));
    const Mesh before = plain(pslg), mesh = mesher(pslg);
    CAPTURE(pslg.vertices.size(), before.triangles.size(), mesh.triangles.size());
    CHECK(mesher.report().encroached_edges == 0);
    CHECK(mesher.report().unmet_triangles.size() <= plain.report().unmet_triangles.size());
    const auto quality = CGAL::mesh_quality_2(mesh, pslg);
    CHECK(quality.number_of_errors == 0);
    if (mesh.triangles.size() < 3000) CHECK(vertices_in_circles(mesh) == 0);
    CHECK(obtuse_angles_at_edges(mesh) == 0);
  }
}

TEST_CASE("without the option, the same graphs are constrained Delaunay only", "[conforming]") {
  const Pslg pslg = square_with_segments();
  CHECK(obtuse_angles_at_edges(Mesher()(pslg)) > 0);
}

TEST_CASE("in conforming meshes of any domain no circumcenter is outside", "[conforming]") {
  std::size_t graphs = 0;
  for (const auto& family : random_pslg::all_families()) {
    const Pslg pslg = family.make(3);
    if (pslg.vertices.size() > 400 || family.make == random_pslg::wedge) continue;
    CAPTURE(family.name);
    Mesher mesher(Options().conform(delaunay).max_vertices(60000));
    const Mesh mesh = mesher(pslg);
    CHECK(CGAL::mesh_quality_2(mesh, pslg).number_of_errors == 0);
    if (mesher.report().is_budget_exhausted) continue;
    CHECK(mesher.report().encroached_edges == 0);
    CHECK(obtuse_angles_at_edges(mesh) == 0);
    check_cells_inside(mesh);
    ++graphs;
  }
  CHECK(graphs > 5);
}

TEST_CASE("fans with legs of any length get some ten times as many triangles, not thousands",
          "[conforming]") {
  std::vector<Pslg> fans;
  if (is_full_run())
    CGAL::IO::read_triangle_poly(pslg_test::data_file("syn_fan_1deg.poly"), fans.emplace_back());
  for (const std::size_t legs : {24u, 60u}) fans.push_back(fan_of_random_lengths(legs));
  for (const Pslg& fan : fans)
    for (const double angle : {20.7, 28.}) {
      CAPTURE(fan.segments.size(), angle);
      Mesher plain(Options().min_angle(angle)), mesher(Options().min_angle(angle).conform(delaunay));
      const Mesh before = plain(fan), mesh = mesher(fan);
      CHECK(CGAL::mesh_quality_2(mesh, fan).number_of_errors == 0);
      CHECK(mesher.report().is_met());
      CHECK(obtuse_angles_at_edges(mesh) == 0);
      CHECK(mesh.triangles.size() <= 30 * before.triangles.size());
    }
}

TEST_CASE("edges are split at ends, too, where angles would ask for no more", "[conforming][.slow]") {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(pslg_test::data_file("hard_encroached_at_ends_of_teeth.poly"), pslg);
  for (const std::size_t rounds : {std::size_t(1), std::size_t(0)}) {
    Mesher mesher(Options()
                      .separate(CGAL::Tree_separation_options_2().rounds(rounds))
                      .conform(delaunay)
                      .min_angle(25)
                      .max_edge(0.25));
    const Mesh mesh = mesher(pslg);
    CHECK(CGAL::mesh_quality_2(mesh, pslg).number_of_errors == 0);
    CHECK(mesher.report().encroached_edges == 0);
    CHECK(obtuse_angles_at_edges(mesh) == 0);
  }
}

TEST_CASE("a budget ends conforming meshes, and what is left is counted", "[conforming]") {
  const Pslg pslg = square_with_segments();
  Mesher unlimited(Options().conform(delaunay));
  const std::size_t all = unlimited(pslg).points.size();
  Mesher mesher(Options().conform(delaunay).max_vertices(all - 10));
  const Mesh mesh = mesher(pslg);
  CHECK(mesh.points.size() <= all - 10);
  CHECK(mesher.report().encroached_edges == obtuse_angles_at_edges(mesh));
  CHECK_FALSE(mesher.report().is_met());
}

TEST_CASE("the least angle holds in conforming meshes, and threads make the same", "[conforming][threads]") {
  Pslg pslg = random_pslg::shape_families()[7].make(4);
  Mesher mesher(Options().conform(delaunay).max_edge(0.05));
  const Mesh mesh = mesher(pslg);
  CHECK(CGAL::mesh_quality_2(mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7).max_edge(0.05))
            .is_met());
  CGAL::Quality_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag> parallel(mesher.options());
  const Mesh by_all = parallel(pslg);
  CHECK(by_all.points == mesh.points);
  CHECK(by_all.triangles == mesh.triangles);
}

TEST_CASE("Steiner vertices are as few as is asked for", "[max_steiner]") {
  Pslg star = random_pslg::families()[1].make(1); // with acute corners, of which many legs are cut
  CGAL::add_convex_hull_2(star);
  for (const Pslg& pslg : {square_with_segments(), star})
    for (const std::size_t most : {std::size_t(0), std::size_t(1), std::size_t(7), std::size_t(40)}) {
      Mesher mesher(Options().max_steiner_vertices(most));
      const Mesh mesh = mesher(pslg);
      CAPTURE(most, pslg.vertices.size());
      CHECK(mesh.points.size() <= pslg.vertices.size() + most);
      CHECK(CGAL::mesh_quality_2(mesh, pslg).number_of_errors == 0);
      if (mesh.points.size() == pslg.vertices.size() + most) CHECK_FALSE(mesher.report().is_met());
    }
  // A graph that a budget of vertices refuses.
  Pslg near = square_with_segments();
  near.add_vertex(Point(1, -3.0999999));
  Mesher mesher(Options().max_steiner_vertices(3));
  CHECK(mesher(near).points.size() <= near.vertices.size() + 3);
  CHECK(Options().max_steiner_vertices() == std::nullopt);
  CHECK(Options().max_steiner_vertices(0).max_steiner_vertices() == std::size_t(0));
}

TEST_CASE("the convex hull is added where no segment lies on it", "[hull]") {
  Pslg pslg;
  for (const Point p : {Point(0, 0), Point(4, 0), Point(4, 4), Point(0, 4), Point(2, 0), Point(4, 2),
                        Point(1, 1), Point(4, 0), Point(4, 1), Point(0, 1)})
    pslg.add_vertex(p);
  SECTION("of points alone") {
    CHECK(CGAL::add_convex_hull_2(pslg) == 8);
    CHECK(CGAL::add_convex_hull_2(pslg) == 0);
    CHECK(pslg.segment_markers.empty());
    const Mesh mesh = Mesher()(pslg);
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
      area += CGAL::area(mesh.point(a), mesh.point(b), mesh.point(c));
    CHECK(area == Approx(16));
  }
  SECTION("of a graph, some of whose segments lie on it") {
    add_segment(pslg, 2, 7); // all of the right side, from a second vertex at its lower end
    add_segment(pslg, 0, 9); // a part of the left one
    add_segment(pslg, 6, 2);
    pslg.segment_markers = {5, 6, 7};
    CHECK(CGAL::add_convex_hull_2(pslg) == 4);
    CHECK(pslg.segment_markers == std::vector<int>{5, 6, 7, 0, 0, 0, 0});
    CHECK(CGAL::mesh_quality_2(Mesher()(pslg), pslg).number_of_errors == 0);
  }
  SECTION("not of points on a line") {
    Pslg line;
    for (int i = 0; i < 5; ++i) line.add_vertex(Point(i, 2 * i));
    CHECK(CGAL::add_convex_hull_2(line) == 0);
    line = Pslg();
    CHECK(CGAL::add_convex_hull_2(line) == 0);
  }
  SECTION("that CGAL finds, too") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      random_pslg::Random random(seed);
      Pslg lattice; // many on the border
      for (int i = 0; i < 60; ++i)
        lattice.add_vertex(Point(std::floor(random.between(0, 6)), std::floor(random.between(0, 6))));
      std::vector<Point> hull;
      CGAL::convex_hull_2(lattice.vertices.begin(), lattice.vertices.end(), std::back_inserter(hull));
      CGAL::add_convex_hull_2(lattice);
      for (const auto& s : lattice.segments)
        for (const Point& p : lattice.vertices)
          CHECK(CGAL::orientation(lattice.point(s[0]), lattice.point(s[1]), p) != CGAL::RIGHT_TURN);
      double length = 0, wanted = 0;
      for (const auto& s : lattice.segments)
        length += std::sqrt(CGAL::squared_distance(lattice.point(s[0]), lattice.point(s[1])));
      for (std::size_t i = 0; i < hull.size(); ++i)
        wanted += std::sqrt(CGAL::squared_distance(hull[i], hull[(i + 1) % hull.size()]));
      CHECK(length == Approx(wanted));
    }
  }
}

} // namespace test_conforming
