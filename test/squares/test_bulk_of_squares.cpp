// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes of which size bounds make the most: their bulk is made of a quadtree's squares.

#include "catch.h"
#include "meshers_in_words32.h"
#include "pslg_test_tools.h"
#include "random_pslg.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/square_templates.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_bulk_of_squares {

namespace {

using pslg_test::data_file;
using pslg_test::make_pslg;
using pslg_test::Point;
using pslg_test::Pslg;
using pslg_test::unit_square;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesher = CGAL::Quality_mesher_2<>;
using Mesh = Mesher::Mesh;
using Options = CGAL::Quality_mesh_options_2;

Pslg read(const std::string& name) {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(data_file(name), pslg);
  return pslg;
}

/// Triangles with an edge that is longer than the field wants at the centroid.
std::size_t number_of_long_triangles(const Mesh& mesh, const Options& options) {
  std::size_t count = 0;
  for (const auto& t : mesh.triangles) {
    double x = 0, y = 0, longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &p = mesh.point(t[k]), &q = mesh.point(t[(k + 1) % 3]);
      x += p.x() / 3, y += p.y() / 3;
      longest = std::max(longest, CGAL::squared_distance(p, q));
    }
    if (std::sqrt(longest) > options.size()(x, y) * (1 + 1e-12)) ++count;
  }
  return count;
}

/// Free edges with a vertex opposite in the circle of the triangle on the other side; exact.
std::size_t number_of_edges_not_Delaunay(const Mesh& mesh) {
  std::vector<std::array<std::size_t, 2>> constrained;
  for (const auto& e : mesh.constrained_edges)
    constrained.push_back({std::min(std::size_t(e.vertices[0]), std::size_t(e.vertices[1])),
                           std::max(std::size_t(e.vertices[0]), std::size_t(e.vertices[1]))});
  std::sort(constrained.begin(), constrained.end());
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      if (!mesh.neighbors[t][k].is_valid()) continue;
      const auto& r = mesh.triangles[t];
      const std::size_t a = std::size_t(r[(k + 1) % 3]), b = std::size_t(r[(k + 2) % 3]);
      const auto& other = mesh.triangles[std::size_t(mesh.neighbors[t][k])];
      const bool is_in_circle = std::any_of(other.begin(), other.end(), [&](const auto v) {
        return v != r[(k + 1) % 3] && v != r[(k + 2) % 3] &&
               CGAL::side_of_oriented_circle(mesh.point(r[0]), mesh.point(r[1]), mesh.point(r[2]),
                                             mesh.point(v)) == CGAL::ON_POSITIVE_SIDE;
      });
      if (is_in_circle && !std::binary_search(constrained.begin(), constrained.end(),
                                              std::array<std::size_t, 2>{std::min(a, b), std::max(a, b)}))
        ++count;
    }
  return count;
}

enum class Bounds { MET, MET_OR_NOT };

/// Meshes, and checks that the mesh is valid, constrained Delaunay, within all bounds of size, and the same when
/// it is made once more.
Mesh run(const Pslg& pslg, const Options& options, Bounds bounds = Bounds::MET_OR_NOT) {
  Mesher mesher(options);
  Mesh mesh = mesher(pslg);
  if (bounds == Bounds::MET) CHECK(mesher.report().is_met());
  const auto quality = CGAL::mesh_quality_2(mesh, pslg,
                                            CGAL::Mesh_quality_options_2()
                                                .min_angle(options.min_angle())
                                                .max_edge(options.max_edge())
                                                .max_area(options.max_area()));
  for (const std::string& error : quality.errors) UNSCOPED_INFO(error);
  CHECK(quality.is_valid());
  CHECK(mesher.report().triangles == quality.triangles);
  if (mesher.report().is_met()) {
    CHECK(quality.unmet_triangles.empty());
    if (options.size()) CHECK(number_of_long_triangles(mesh, options) == 0);
  }
  CHECK(number_of_edges_not_Delaunay(mesh) == 0);
  const Mesh again = Mesher(options)(pslg);
  CHECK(again.points == mesh.points);
  CHECK(again.triangles == mesh.triangles);
  return mesh;
}

/// And that all bounds are met.
Mesh run_to_the_bounds(const Pslg& pslg, const Options& options) { return run(pslg, options, Bounds::MET); }

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += CGAL::area(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]));
  return area;
}

void add_loop(Pslg& pslg, const std::vector<Point>& corners) {
  const std::size_t first = pslg.number_of_vertices(), n = corners.size();
  for (const Point& p : corners) pslg.add_vertex(p);
  for (std::size_t i = 0; i < n; ++i)
    pslg.add_segment(pslg_test::Vertex_index(first + i), pslg_test::Vertex_index(first + (i + 1) % n));
}
void add_box(Pslg& pslg, double x0, double y0, double x1, double y1) {
  add_loop(pslg, {Point(x0, y0), Point(x1, y0), Point(x1, y1), Point(x0, y1)});
}

} // namespace

TEST_CASE("Templates of squares are triangulations with angles of at least atan(1/2)", "[bulk]") {
  using namespace CGAL::Quadtree_mesh_2::internal;
  const double x[] = {0, 1, 1, 0, 0.5, 1, 0.5, 0, 0.5}, y[] = {0, 0, 1, 1, 0, 0.5, 1, 0.5, 0.5};
  for (unsigned bits = 0; bits < 32; ++bits) {
    CAPTURE(bits);
    const Square_form form{static_cast<std::uint8_t>(bits)};
    const Square_template& t = square_template(form);
    double area2 = 0;
    std::array<int, 8> pieces{};
    std::array<bool, 9> is_used{};
    for (std::size_t i = 0; i < std::size_t(t.size); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto v = [&](std::size_t j) { return std::size_t(t.triangle[i][j % 3]); };
        is_used[v(k)] = true;
        const Vector a{x[v(k + 1)] - x[v(k)], y[v(k + 1)] - y[v(k)]},
            b{x[v(k + 2)] - x[v(k)], y[v(k + 2)] - y[v(k)]};
        if (k == 0) area2 += cross(a, b);
        CHECK(cross(a, b) > 0);
        CHECK(dot(a, b) >= 0); // no angle above 90 degrees
        const double least2 = bits == 0 || form.has_center() ? 0.5 : sin2_of_halved_square;
        CHECK(cross(a, b) * cross(a, b) >= least2 * dot(a, a) * dot(b, b) * (1 - 1e-12));
        if (t.piece[i][k] >= 0) {
          ++pieces[std::size_t(t.piece[i][k])];
          const auto side = t.side_of_piece[std::size_t(t.piece[i][k])];
          CHECK((std::size_t(side.triangle) == i && std::size_t(side.slot) == k));
        } else {
          const auto o = t.across[i][k];
          const auto back = t.across[std::size_t(o.triangle)][std::size_t(o.slot)];
          CHECK((std::size_t(back.triangle) == i && std::size_t(back.slot) == k));
          const auto& other = t.triangle[std::size_t(o.triangle)];
          CHECK(std::size_t(other[(std::size_t(o.slot) + 1) % 3]) == v(k + 2));
          CHECK(std::size_t(other[(std::size_t(o.slot) + 2) % 3]) == v(k + 1));
        }
      }
    CHECK(area2 == 2);
    for (int side = 0; side < 4; ++side) {
      CHECK(pieces[std::size_t(2 * side)] == 1);
      CHECK(pieces[std::size_t(2 * side + 1)] == (form.is_halved(side) ? 1 : 0));
    }
    for (int i = 0; i < 9; ++i) {
      const bool has_vertex = i == Square_template::center ? form.has_center() : form.has_vertex(i);
      CHECK(is_used[std::size_t(i)] == has_vertex);
      if (!has_vertex) continue;
      const auto& t_at = t.triangle[std::size_t(t.triangle_at[std::size_t(i)])];
      CHECK(std::find(t_at.begin(), t_at.end(), i) != t_at.end());
    }
    for (const Square_place place : all_square_places) {
      CHECK(form.places().has(place) == form.has_vertex(vertex_at(place)));
      CHECK(form.places().before(place).size() + form.places().without(form.places().before(place)).size() ==
            form.places().size());
    }
  }
}

TEST_CASE("A bound of area gives hardly more triangles than area divided by it", "[bulk]") {
  const double angle = GENERATE(0.0, 20.7, 26.0, 30.0);
  const double area = GENERATE(1e-4, 1.7e-5);
  CAPTURE(angle, area);
  const Mesh mesh = run_to_the_bounds(unit_square(), Options().min_angle(angle).max_area(area));
  CHECK(static_cast<double>(mesh.number_of_triangles()) < 1.06 / area);
}

TEST_CASE("A bound of edge length is met by squares with that diagonal", "[bulk]") {
  const double length = GENERATE(0.02, 0.0077);
  const Mesh mesh = run_to_the_bounds(unit_square(), Options().max_edge(length));
  CHECK(static_cast<double>(mesh.number_of_triangles()) < 1.1 * 4 / (length * length));
  const Mesh both = run_to_the_bounds(unit_square(), Options().max_edge(length).max_area(0.01 * length));
  CHECK(both.triangles == mesh.triangles);
}

TEST_CASE("The bulk is filled wherever the domain lies and however large it is", "[bulk]") {
  const double x = GENERATE(0.0, -0.3, 1e3, -1e6, 3e9), scale = GENERATE(1.0, 1e-30, 1e30);
  CAPTURE(x, scale);
  Pslg pslg;
  add_box(pslg, scale * x, scale * 0.1, scale * (x + 1), scale * 1.2);
  const Mesh mesh = run_to_the_bounds(pslg, Options().max_area(1e-3 * scale * scale * 0.5));
  CHECK(static_cast<double>(mesh.number_of_triangles()) < 1.12 * 1.1 / 0.5e-3);
}

TEST_CASE("Maps, holes and thin parts with a bound of area", "[bulk]") {
  const double angle = GENERATE(20.7, 30.0);
  const auto [name, area] = GENERATE(table<std::string, double>({{"us_states_10m.poly.gz", 3e8},
                                                                 {"syn_holes_400.poly.gz", 5e-3},
                                                                 {"syn_comb.poly", 1e-4},
                                                                 {"syn_fan_1deg.poly", 1e-4},
                                                                 {"syn_near_1e-12.poly", 1e-4},
                                                                 {"syn_parallel_0.001.poly", 1e-3},
                                                                 {"syn_wedge_1deg.poly", 1e-3},
                                                                 {"syn_wedge_0.01deg.poly", 1e-3},
                                                                 {"syn_sliver_1deg.poly", 1e-6}}));
  CAPTURE(angle, name);
  const Options options = Options().min_angle(angle).max_area(area);
  if (angle < 21)
    run_to_the_bounds(read(name), options);
  else
    run(read(name), options);
}

TEST_CASE("Random inputs of hard families with bounds of size", "[bulk]") {
  const std::uint64_t seeds = is_full_run() ? 60 : 3;
  for (const random_pslg::Family& family : random_pslg::families())
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      CAPTURE(family.name, seed);
      const Pslg pslg = family.make(seed);
      const double area = area_of(Mesher(Options().min_angle(0))(pslg));
      // with any bound of size, filled bulk or not, a few of the lattices drive refinement out of coordinates
      const Bounds bounds = family.name == std::string("lattice") ? Bounds::MET_OR_NOT : Bounds::MET;
      run(pslg, Options().max_area(area / 4000), bounds);
      run(pslg, Options().min_angle(30).max_area(area / 3000));
      run(pslg, Options().max_edge(std::sqrt(area / 1500)), bounds);
    }
}

TEST_CASE("A size field from 1 to 100 is followed", "[bulk]") {
  const double angle = GENERATE(20.7, 30.0);
  const double x = GENERATE(0.5, 0.123, -0.2);
  CAPTURE(angle, x);
  const Options options = Options().min_angle(angle).size(
      [x](double px, double py) { return 0.001 + 0.1 * std::hypot(px - x, py - 0.4); });
  const Mesh mesh = run_to_the_bounds(unit_square(), options);
  CHECK(mesh.number_of_triangles() > 1000);
}

TEST_CASE("Size fields that are constant, that jump, or that are fine in spots", "[bulk]") {
  const Options constant = Options().size([](double, double) { return 0.02; });
  const Mesh mesh = run_to_the_bounds(unit_square(), constant);
  CHECK(mesh.number_of_triangles() < 11000);
  run_to_the_bounds(unit_square(), Options().size([](double x, double) { return x < 0.377 ? 0.3 : 0.006; }));
  run_to_the_bounds(unit_square(), Options().max_area(1e-3).size([](double x, double y) {
    return std::hypot(x - 0.51, y - 0.77) < 0.013 ? 0.0005 : 0.05;
  }));
  run_to_the_bounds(read("syn_holes_400.poly.gz"),
                    Options().size([](double x, double y) { return 0.02 + 0.03 * std::fabs(x + y - 20); }));
}

TEST_CASE("A size field is looked up inside the domain only", "[bulk]") {
  // an annulus: two boxes, the inner one a hole; values outside would stop everything
  Pslg pslg;
  add_box(pslg, 0, 0, 3, 3);
  add_box(pslg, 1, 1, 2, 2);
  pslg.holes.push_back(Point(1.5, 1.5));
  const auto size = [](double x, double y) {
    const bool is_inside = x >= 0 && x <= 3 && y >= 0 && y <= 3 && !(x > 1 && x < 2 && y > 1 && y < 2);
    REQUIRE(is_inside);
    return 0.03 + 0.05 * x;
  };
  run_to_the_bounds(pslg, Options().size(size));
}

TEST_CASE("Several components, with holes, touching and within each other", "[bulk]") {
  Pslg pslg;
  add_box(pslg, 0, 0, 2, 1);
  add_box(pslg, 0.3, 0.3, 1.2, 0.7); // a hole with an island
  add_box(pslg, 0.5, 0.4, 1, 0.6);
  add_box(pslg, 2.5, 0, 3.5, 1);
  add_box(pslg, 3.5, 1, 4.5, 2);                                 // touches the one before in a corner
  add_loop(pslg, {Point(0, 1.5), Point(2, 1.6), Point(0, 1.7)}); // of 5.7 degrees
  pslg.holes.push_back(Point(0.4, 0.4));
  for (const double angle : {20.7, 30.0}) {
    const Mesh mesh = run(pslg, Options().min_angle(angle).max_area(4e-4));
    CHECK(area_of(mesh) == Approx(2 - 0.36 + 0.1 + 1 + 1 + 0.2));
  }
}

TEST_CASE("Channels narrower than squares are left to refinement", "[bulk]") {
  Pslg pslg;
  add_box(pslg, 0, 0, 1, 1);
  for (int i = 1; i < 100; ++i) { // walls
    const std::size_t n = pslg.number_of_vertices();
    pslg.add_vertex(Point(i * 0.01, 0.05)), pslg.add_vertex(Point(i * 0.01, 0.95));
    pslg.add_segment(pslg_test::Vertex_index(n), pslg_test::Vertex_index(n + 1));
  }
  run_to_the_bounds(pslg, Options().max_area(1e-4));
}

TEST_CASE("Vertices, alone and in a cluster, amid the bulk", "[bulk]") {
  Pslg pslg = unit_square();
  random_pslg::Random random(7);
  for (int i = 0; i < 20; ++i) pslg.add_vertex(Point(random.between(0, 1), random.between(0, 1)));
  for (int i = 0; i < 20; ++i)
    pslg.add_vertex(Point(0.4 + 1e-7 * random.between(0, 1), 0.6 + 1e-7 * random.between(0, 1)));
  const double h = std::ldexp(1, -5); // on corners of squares
  for (int i = 1; i < 32; ++i) pslg.add_vertex(Point(i * h, i * h));
  run_to_the_bounds(pslg, Options().max_area(h * h / 2));
  run(pslg, Options().min_angle(30).max_area(1e-4));
}

TEST_CASE("The bulk respects the vertex budget and does without removal", "[bulk]") {
  Mesher mesher(Options().max_area(1e-5).max_vertices(30000));
  CHECK(mesher(unit_square()).number_of_vertices() <= 30000);
  CHECK(mesher.report().is_budget_exhausted);
  run_to_the_bounds(unit_square(), Options().max_area(1e-4).coarsen(Options::Coarsening::NONE));
}

TEST_CASE("Areas of regions are followed, each by squares of its own size", "[bulk]") {
  Pslg pslg;
  add_box(pslg, 0, 0, 2, 1);
  pslg.add_vertex(Point(1.1, 0)), pslg.add_vertex(Point(0.9, 1));
  pslg.add_segment(pslg_test::Vertex_index(4), pslg_test::Vertex_index(5));
  pslg.regions.push_back({Point(0.1, 0.5), 1, 1e-4});
  pslg.regions.push_back({Point(1.9, 0.5), 2, 1.5e-3});
  const Mesh mesh = run_to_the_bounds(pslg, Options());
  double largest[2] = {0, 0};
  std::size_t count[2] = {0, 0};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto region = std::size_t(mesh.region_of_triangle[t]);
    const auto& r = mesh.triangles[t];
    largest[region] =
        std::max(largest[region], CGAL::area(mesh.point(r[0]), mesh.point(r[1]), mesh.point(r[2])));
    ++count[region];
  }
  CHECK(largest[0] <= 1e-4);
  CHECK(largest[1] <= 1.5e-3);
  CHECK(count[0] < 12000);
  CHECK(count[1] < 2500);
}

TEST_CASE("Threads make the same mesh around a bulk", "[bulk][parallel]") {
  using Parallel_mesher = CGAL::Quality_mesher_2<Mesher::Geom_traits, CGAL::Parallel_tag>;
  const auto [name, area] = GENERATE(table<std::string, double>({{"syn_square.poly", 2e-5},
                                                                 {"thin_box_10000.poly", 0.05},
                                                                 {"us_states_10m.poly.gz", 3e8},
                                                                 {"gshhg_norway_f.poly.gz", 1e6}}));
  CAPTURE(name);
  const Pslg pslg = read(name);
  const Options options = Options().max_area(area);
  const Mesh sequential = Mesher(options)(pslg), parallel = Parallel_mesher(options)(pslg);
  CHECK(sequential.points == parallel.points);
  CHECK(sequential.triangles == parallel.triangles);
}

TEST_CASE("Threads make the same mesh where sizes vary", "[bulk][parallel]") {
  using Parallel_mesher = CGAL::Quality_mesher_2<Mesher::Geom_traits, CGAL::Parallel_tag>;
  const Options options =
      Options().size([](double x, double y) { return 0.002 + 0.02 * std::hypot(x - 0.123, y - 0.4); });
  const Mesh sequential = Mesher(options)(unit_square()), parallel = Parallel_mesher(options)(unit_square());
  CHECK(sequential.points == parallel.points);
  CHECK(sequential.triangles == parallel.triangles);
  CHECK(sequential.neighbors == parallel.neighbors);
  CHECK(sequential.vertex_markers == parallel.vertex_markers);
}

TEMPLATE_TEST_CASE("The bulk of integers has integer corners", "[bulk]", std::uint32_t, std::uint64_t) {
  using Traits = CGAL::Fixed_point_quadtree_traits_2<TestType>;
  using Fixed_point = typename Traits::Point_2;
  const auto [name, squares] =
      GENERATE(table<std::string, double>({{"syn_square.poly", 5e3}, {"syn_holes_400.poly.gz", 5e4}}));
  CAPTURE(name);
  const Pslg pslg = read(name);
  const auto scale = CGAL::Fixed_point_scale_2<TestType>::of_points(pslg.vertices);
  CGAL::Pslg_2<Fixed_point> fixed;
  for (const Point& p : pslg.vertices) fixed.vertices.push_back(scale.to_fixed(p.x(), p.y()));
  for (const Point& p : pslg.holes) fixed.holes.push_back(scale.to_fixed(p.x(), p.y()));
  fixed.segments = pslg.segments;
  const double extent =
      (pslg.point(pslg_test::Vertex_index(2)).x() - pslg.point(pslg_test::Vertex_index(0)).x()) /
      scale.unit();
  const double area = extent * extent / squares / 2;
  CGAL::Quality_mesher_2<Traits> mesher(Options().max_area(area));
  const auto mesh = mesher(fixed);
  CHECK(mesher.report().is_met());
  const auto quality =
      CGAL::mesh_quality_2(mesh, fixed, CGAL::Mesh_quality_options_2().min_angle(20.7).max_area(area));
  for (const std::string& error : quality.errors) UNSCOPED_INFO(error);
  CHECK(quality.is_valid());
  CHECK(quality.unmet_triangles.empty());
  CHECK(static_cast<double>(mesh.number_of_triangles()) > 0.4 * squares);
}

TEST_CASE("Squares of a few integers", "[bulk]") {
  using Traits = CGAL::Fixed_point_quadtree_traits_2<std::uint32_t>;
  const auto box =
      make_pslg<double>({{7, 3}, {307, 3}, {307, 303}, {7, 303}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  CGAL::Pslg_2<Traits::Point_2> pslg;
  for (const Point& p : box.vertices)
    pslg.vertices.push_back({static_cast<std::uint32_t>(p.x()), static_cast<std::uint32_t>(p.y())});
  pslg.segments = box.segments;
  CGAL::Quality_mesher_2<Traits> mesher(Options().max_area(19));
  const auto mesh = mesher(pslg);
  CHECK(mesher.report().is_met());
  CHECK(CGAL::mesh_quality_2(mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7).max_area(19))
            .is_valid());
}

TEST_CASE("Squares of a step or two of the coordinates leave nothing of the domain uncovered", "[bulk]") {
  using Traits = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
  const Pslg pslg = read("hard_squares_of_one_step.poly");
  CGAL::Pslg_2<Traits::Point_2> fixed;
  for (const Point& p : pslg.vertices)
    fixed.vertices.push_back({static_cast<std::uint64_t>(p.x()), static_cast<std::uint64_t>(p.y())});
  fixed.segments = pslg.segments;
  for (const double area : {0.972933, 2.0, 5.0}) {
    CAPTURE(area);
    CGAL::Quality_mesher_2<Traits> mesher(Options().min_angle(0).max_area(area));
    const auto mesh = mesher(fixed);
    CHECK(CGAL::mesh_quality_2(mesh, fixed).is_valid());
    for (const auto& left : mesher.report().unmet_triangles)
      CHECK(left.reason == CGAL::Quality_mesh_report_2::Reason::COORDINATES);
  }
}

} // namespace test_bulk_of_squares
