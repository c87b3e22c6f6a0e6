// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshing in blocks: the same bits for any number of threads, and all that holds for every mesh on inputs that are
// cut into blocks of a few triangles each, so that most of the work lies at seams.

#include "catch.h"
#include "mesher_test_tools.h"
#include "numbers_of_threads.h"
#include "random_pslg_shapes.h"
#include "tiny_blocks.h"

#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/bounding_box.h>
#include <CGAL/centroid.h>
#include <CGAL/mesh_quality_2.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <string>

namespace test_quality_mesher_blocks {

namespace {

using namespace mesher_test;
using pslg_test::error_of;
using pslg_test::has_text;
using pslg_test::Point;
using pslg_test::Vertex_index;

using Filtered_traits = CGAL::Filtered_quadtree_traits_2<>;
template <class Tag>
using Mesher_of = CGAL::Quality_mesher_2<Filtered_traits, Tag>;

bool are_same(const Mesh& a, const Mesh& b) {
  return a.points == b.points && a.triangles == b.triangles && a.neighbors == b.neighbors &&
         a.segment_of_vertex == b.segment_of_vertex && a.vertex_markers == b.vertex_markers &&
         a.region_of_triangle == b.region_of_triangle;
}

/// Meshes in tiny blocks, and checks what `run_to_the_bound()` does.
Mesh mesh_in_tiny_blocks(const Pslg& pslg, const Options& options) {
  Mesher_of<Tiny_blocks_tag> mesher(options);
  const Mesh mesh = mesher(pslg);
  const CGAL::Mesh_quality_2 quality =
      CGAL::mesh_quality_2(mesh, pslg,
                           CGAL::Mesh_quality_options_2()
                               .min_angle(options.min_angle())
                               .max_area(options.max_area())
                               .check_domain(rule_to_check(options.mesh_domain())));
  for (const std::string& error : quality.errors) UNSCOPED_INFO(error);
  CHECK(quality.is_valid());
  CHECK(quality.is_met());
  CHECK(mesher.report().is_met());
  CHECK(mesher.report().triangles == quality.triangles);
  CHECK(mesher.report().exempt_triangles.size() == quality.exempt_triangles);
  return mesh;
}

/// A box with a lattice of points on a few long segments, each lattice row one segment.
Pslg rows_of_points(std::size_t rows, std::size_t columns) {
  Pslg pslg;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) pslg.add_vertex(Point(double(j), double(i)));
    pslg.add_segment(Vertex_index(i * columns), Vertex_index((i + 1) * columns - 1));
  }
  for (std::size_t j : {std::size_t(0), columns - 1})
    pslg.add_segment(Vertex_index(j), Vertex_index((rows - 1) * columns + j));
  return pslg;
}

/// A box of 24 x 24 cells with a hexagonal hole in each, somewhere in its cell; that of the first cell is moved on.
Pslg holes_in_cells(double moved) {
  constexpr int side = 24;
  std::mt19937 random(4);
  const auto place = [&random] { return double(random() % 1024) / 2048; };
  Pslg pslg;
  for (int i = 0; i < 4; ++i) pslg.add_vertex(Point(i == 1 || i == 2 ? side : 0, i >= 2 ? side : 0));
  for (std::size_t i = 0; i < 4; ++i) pslg.add_segment(Vertex_index(i), Vertex_index((i + 1) % 4));
  for (int cell = 0; cell < side * side; ++cell) {
    const double x = cell % side + 0.3 + place() + (cell == 0 ? moved : 0), y = cell / side + 0.3 + place();
    const std::size_t first = pslg.number_of_vertices();
    constexpr std::array<std::array<double, 2>, 6> corners{
        {{4, 0}, {2, 3.5}, {-2, 3.5}, {-4, 0}, {-2, -3.5}, {2, -3.5}}};
    for (const auto& [dx, dy] : corners) pslg.add_vertex(Point(x + dx / 32, y + dy / 32));
    for (std::size_t i = 0; i < 6; ++i)
      pslg.add_segment(Vertex_index(first + i), Vertex_index(first + (i + 1) % 6));
    pslg.holes.push_back(Point(x, y));
  }
  return pslg;
}

/// The coordinates of all triangles beyond a distance from the first cell, each from its least corner on.
std::set<std::array<double, 6>> triangles_beyond(double distance, const Mesh& mesh) {
  std::set<std::array<double, 6>> found;
  for (const auto& t : mesh.triangles) {
    std::array<Point, 3> p{mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])};
    std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    if (std::all_of(p.begin(), p.end(), [&](const Point& q) { return q.x() + q.y() > distance; }))
      found.insert({p[0].x(), p[0].y(), p[1].x(), p[1].y(), p[2].x(), p[2].y()});
  }
  return found;
}

Point inside_triangle(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  return CGAL::centroid(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
}

/// Checks that meshes have the same bits with any number of threads.
void check_threads(const Pslg& pslg, const Options& options) {
  const Mesh sequential = Mesher_of<CGAL::Sequential_tag>(options)(pslg);
  for_numbers_of_threads([&] {
    CAPTURE(options.min_angle());
    CHECK(are_same(Mesher_of<CGAL::Parallel_tag>(options)(pslg), sequential));
  });
}

} // namespace

TEST_CASE("A map is meshed to the same bits with any number of threads", "[mesher][parallel]") {
  const double angle = GENERATE(20.7, 28.0);
  const bool is_large = is_full_run() || angle < 21;
  check_threads(read(is_large ? "gshhg_norway_f.poly.gz" : "gshhg_aegean_h.poly.gz"),
                Options().min_angle(angle));
}

TEST_CASE("A bulk of squares has the same bits with any number of threads", "[mesher][parallel]") {
  Pslg pslg = read("us_states_10m.poly.gz");
  const auto box = CGAL::bounding_box(pslg.vertices.begin(), pslg.vertices.end());
  const double area = box.area(), side = std::sqrt(area);
  Pslg::Region region;
  region.point = inside_triangle(CGAL::Quality_mesher_2<>()(pslg), 0);
  region.max_area = area / 2e5;
  pslg.regions.push_back(region);
  const double angle = GENERATE(20.7, 28.0); // without centers, and with
  check_threads(pslg, Options().min_angle(angle).max_area(area / (is_full_run() ? 5e4 : 3e4)));
  const double middle = (box.xmin() + box.xmax()) / 2;
  check_threads(pslg, Options().min_angle(angle).size([&](double x, double) {
    return side / (x < middle ? 60 : is_full_run() ? 240 : 160);
  }));
}

TEST_CASE("What moves in one place changes no triangle far from it", "[mesher]") {
  const double angle = GENERATE(20.7, 30.0);
  const Options options = Options().min_angle(angle);
  const Mesh before = mesh_in_tiny_blocks(holes_in_cells(0), options),
             after = mesh_in_tiny_blocks(holes_in_cells(0.0625), options);
  CHECK(before.points != after.points);
  CHECK(triangles_beyond(8, before) == triangles_beyond(8, after));
}

TEST_CASE("The map's mesh in words is the same with any number of threads", "[mesher][parallel]") {
  using Traits = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
  const Pslg pslg =
      read(is_full_run() ? "gshhg_norway_f.poly.gz" : "gshhg_aegean_h.poly.gz"); // of several blocks
  CGAL::Pslg_2<Traits::Point_2> words;
  for (const Point& p : pslg.vertices)
    words.add_vertex(
        {static_cast<std::uint64_t>((p.x() + 1e7) * 1024), static_cast<std::uint64_t>((p.y() + 1e7) * 1024)});
  words.segments = pslg.segments;
  const auto sequential = CGAL::Quality_mesher_2<Traits, CGAL::Sequential_tag>()(words);
  const auto parallel = CGAL::Quality_mesher_2<Traits, CGAL::Parallel_tag>()(words);
  CHECK(sequential.triangles == parallel.triangles);
}

TEST_CASE("Inputs of test/data are meshed to the bound in tiny blocks", "[mesher]") {
  const std::string name =
      GENERATE(as<std::string>(), "syn_near_1e-06.poly", "syn_parallel_0.001.poly", "syn_comb.poly",
               "syn_fan_1deg.poly", "syn_holes_400.poly.gz", "us_states_10m.poly.gz");
  CAPTURE(name);
  mesh_in_tiny_blocks(read(name), Options());
}

TEST_CASE("Corners between whose legs vertices were removed are meshed in tiny blocks", "[mesher]") {
  const double angle = GENERATE(20.7, 30.0), area = GENERATE(0.03, 0.01);
  CAPTURE(angle, area);
  mesh_in_tiny_blocks(read("star_of_72_spikes.poly"), Options().min_angle(angle).max_area(area));
}

TEST_CASE("Random hard inputs are meshed to the bound in tiny blocks", "[mesher]") {
  for (const random_pslg::Family& family : random_pslg::all_families())
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      CAPTURE(family.name, seed);
      mesh_in_tiny_blocks(family.make(seed), Options().min_angle(seed % 2 == 0 ? 20.7 : 18.43));
    }
}

TEST_CASE("Regions, bounds of size and rules of domain hold across seams", "[mesher]") {
  Pslg pslg = read("us_states_10m.poly.gz");
  const Mesh plain = CGAL::Quality_mesher_2<>()(pslg);
  Pslg::Region region;
  for (std::size_t r = 0; r < 3; ++r) {
    region.point = inside_triangle(plain, r * 9970);
    region.attribute = double(r);
    pslg.regions.push_back(region);
  }
  const Mesh mesh = mesh_in_tiny_blocks(pslg, Options());
  CHECK(mesh.region_of_triangle.size() == mesh.triangles.size());

  const auto box = CGAL::bounding_box(pslg.vertices.begin(), pslg.vertices.end());
  const double area = box.area();
  mesh_in_tiny_blocks(pslg, Options().max_area(area / 20000));
}

TEST_CASE("Many vertices on long segments, overlaps and duplicates are found across seams", "[mesher]") {
  Pslg pslg = rows_of_points(12, 40);
  const std::size_t n = pslg.number_of_vertices();
  for (std::size_t v = 0; v < n; v += 7) pslg.add_vertex(pslg.vertices[v]);
  // pieces of rows again, with higher numbers than the row's
  for (std::size_t i = 0; i < 12; ++i) pslg.add_segment(Vertex_index(i * 40 + 3), Vertex_index(i * 40 + 30));
  Mesher_of<Tiny_blocks_tag> mesher(Options{});
  const Mesh mesh = mesher(pslg);
  CHECK(CGAL::mesh_quality_2(mesh, pslg).is_valid());
  CHECK(mesher.report().merged_vertices == pslg.number_of_vertices() - n);
  Mesher whole;
  whole(pslg);
  CHECK(mesher.report().vertices_on_segments == whole.report().vertices_on_segments);
  for (const Mesh::Constrained_edge& e : mesh.constrained_edges) CHECK(std::size_t(e.segment) < 14);
}

TEST_CASE("Segments that cross in different blocks are an error that names one pair", "[mesher]") {
  Pslg pslg = rows_of_points(12, 40);
  const std::size_t n = pslg.number_of_vertices();
  for (const double x : {5.5, 20.5, 33.5}) { // each crosses a row
    const Vertex_index a = pslg.add_vertex(Point(x, 4.4)), b = pslg.add_vertex(Point(x, 5.6));
    pslg.add_segment(a, b);
  }
  const auto mesh_it = [&] { Mesher_of<Tiny_blocks_tag>()(pslg); };
  const std::string error = error_of(mesh_it);
  CAPTURE(error);
  CHECK(has_text(error, "crosses segment"));
  CHECK(error == error_of(mesh_it));
  CHECK(n == 480);
}

TEST_CASE("Cancelling from several threads leaves a valid mesh", "[mesher][parallel]") {
  const Pslg pslg = read("gshhg_norway_f.poly.gz");
  std::atomic<int> calls{0};
  Mesher_of<CGAL::Parallel_tag> mesher(Options().progress([&](double) { return ++calls < 12; }));
  const Mesh mesh = mesher(pslg);
  CHECK(mesher.report().is_cancelled);
  CHECK(CGAL::mesh_quality_2(mesh, pslg).is_valid());
}

TEST_CASE("A budget is kept in blocks", "[mesher]") {
  const Pslg pslg = read("us_states_10m.poly.gz");
  const std::size_t budget = pslg.number_of_vertices() + 1000;
  Mesher_of<Tiny_blocks_tag> mesher(Options().max_vertices(budget));
  std::string refusal;
  try {
    const Mesh mesh = mesher(pslg);
    CHECK(mesher.report().is_budget_exhausted);
    CHECK(mesher.report().vertices <= budget + 64);
    CHECK(CGAL::mesh_quality_2(mesh, pslg).is_valid());
  } catch (const CGAL::Pslg_error_2& error) {
    refusal = error.what();
    CHECK(has_text(refusal, "budget"));
  }
}

} // namespace test_quality_mesher_blocks
