// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "adapt_tools.h"
#include "mesher_test_tools.h"
#include "numbers_of_threads.h"
#include "random_pslg_shapes.h"

#include <CGAL/Mesh_sizing_field_2.h>
#include <CGAL/refine_mesh_2.h>
#include <CGAL/renumber_mesh_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace test_adapt_mesh_2 {

namespace {

using namespace adapt_test;

std::size_t number_kept(const CGAL::Adapted_mesh_2& made) {
  return std::size_t(std::count_if(made.transfer.old_vertex.begin(), made.transfer.old_vertex.end(),
                                   [](Vertex_index v) { return v.is_valid(); }));
}

/// Small around a place, larger with the distance.
Options sizes_around(const Point& p, double small, double growth) {
  return Options().size(
      [=](double x, double y) { return small + growth * std::hypot(x - p.x(), y - p.y()); });
}

/// A coast; a small one but in full runs.
Pslg map() {
  if (is_full_run()) return mesher_test::read("gshhg_aegean_h.poly.gz");
  Pslg pslg;
  CGAL::IO::read_triangle_poly(QUADTREE_MESH_SOURCE_DIR "/examples/data/great_lakes.poly.gz", pslg);
  return pslg;
}

} // namespace

TEST_CASE("Where sizes stay, an adapted mesh stays, bit for bit", "[adapt]") {
  for (const auto& family : random_pslg::all_families()) {
    const Pslg pslg = family.make(4);
    if (pslg.vertices.size() > 400) continue;
    CAPTURE(family.name);
    CGAL::Quality_mesher_2<> mesher{Options()};
    const Mesh mesh = mesher(pslg);
    const auto made = CGAL::adapt_mesh_2(mesh, pslg, Options());
    check_transfer(made, mesh);
    check_valid(made.mesh, pslg);
    if (mesher.report().exempt_triangles.empty() && mesher.report().is_met())
      CHECK(number_kept(made) == mesh.points.size());
  }
}

TEST_CASE("Ten steps of a moving size keep what is far from it", "[adapt]") {
  const Pslg pslg = frame();
  Mesh mesh = fresh_mesh(pslg, sizes_around(Point(0.5, 0.5), 0.02, 0.3));
  std::size_t kept_in_all = 0;
  for (int step = 1; step <= 10; ++step) {
    CAPTURE(step);
    const Point center(0.5 + 0.3 * step, 0.5);
    const Options options = sizes_around(center, 0.02, 0.3);
    const auto made = CGAL::adapt_mesh_2(mesh, pslg, options);
    check_transfer(made, mesh);
    check_valid(made.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7));
    CHECK(made.report.is_met());
    CHECK(quality(made.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7)).is_met());
    for (std::size_t t = 0; t < made.mesh.triangles.size(); ++t) {
      const Point p = centroid(made.mesh, t);
      CHECK(longest_edge(made.mesh, t) <= options.size()(p.x(), p.y()) * (1 + 1e-12));
    }
    // As small as a fresh mesh, or nearly so.
    const Mesh fresh = fresh_mesh(pslg, options);
    CHECK(double(made.mesh.triangles.size()) < 1.5 * double(fresh.triangles.size()));
    kept_in_all += number_kept(made);
    mesh = made.mesh;
  }
  CHECK(kept_in_all > 1000);
  // Then nothing changes any more, after a step or two.
  const Options last = sizes_around(Point(3.5, 0.5), 0.02, 0.3);
  for (int step = 0; step < 3; ++step) mesh = CGAL::adapt_mesh_2(mesh, pslg, last).mesh;
  const auto made = CGAL::adapt_mesh_2(mesh, pslg, last);
  CHECK(have_same_bits(made.mesh.points.size() == mesh.points.size() ? made.mesh : Mesh(), mesh));
}

TEST_CASE("Vertices away from a change of sizes stay", "[adapt]") {
  const Pslg pslg =
      pslg_test::make_pslg<double>({{0, 0}, {8, 0}, {8, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  const Mesh mesh = fresh_mesh(pslg, Options().max_edge(0.1));
  const Options options = Options().size([](double x, double) {
    return x < 2 ? 0.1 : x < 4 ? 0.04 : x < 6 ? 0.1 : 0.4;
  });
  const auto made = CGAL::adapt_mesh_2(mesh, pslg, options);
  check_transfer(made, mesh);
  check_valid(made.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7));
  std::set<std::size_t> kept;
  for (const auto v : made.transfer.old_vertex)
    if (v.is_valid()) kept.insert(std::size_t(v));
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (mesh.points[v].x() < 5.7) CHECK(kept.count(v) == 1);
  std::size_t left = 0, before = 0;
  for (const Point& p : made.mesh.points) left += p.x() > 6.5 ? 1 : 0;
  for (const Point& p : mesh.points) before += p.x() > 6.5 ? 1 : 0;
  CHECK(left < before / 4);
  for (std::size_t v = 0; v < made.mesh.points.size();
       ++v) // and none is new where the sizes are the old ones
    if (!made.transfer.old_vertex[v].is_valid()) CHECK(made.mesh.points[v].x() > 1.7);
}

TEST_CASE("Coarsening comes down to about a mesh made afresh, and angles hold", "[adapt]") {
  for (const auto& family : random_pslg::all_families()) {
    const Pslg pslg = family.make(2);
    if (pslg.vertices.size() > 400) continue;
    CAPTURE(family.name);
    const Mesh fresh = fresh_mesh(pslg, Options());
    double area_of_all = 0;
    for (std::size_t t = 0; t < fresh.triangles.size(); ++t) area_of_all += area(fresh, t);
    const Mesh mesh = fresh_mesh(pslg, Options().max_area(area_of_all / (is_full_run() ? 5000 : 1500)));
    const auto made = CGAL::adapt_mesh_2(mesh, pslg, Options());
    check_transfer(made, mesh);
    check_valid(made.mesh, pslg);
    CHECK(made.report.is_met());
    CHECK(double(made.mesh.triangles.size()) < 1.5 * double(fresh.triangles.size()) + 50);
  }
}

TEST_CASE("Meshes of maps are refined and coarsened again and again", "[adapt]") {
  const Pslg pslg = map();
  const Point center = pslg.vertices.front();
  Mesh mesh = fresh_mesh(pslg, Options());
  const double fine = 200, coarse = 2e5; // meters
  for (const double size :
       is_full_run() ? std::vector{fine, coarse, fine / 2, coarse} : std::vector{fine, coarse}) {
    CAPTURE(size);
    const auto made = CGAL::adapt_mesh_2<CGAL::Parallel_tag>(mesh, pslg, sizes_around(center, size, 0.2));
    check_transfer(made, mesh);
    check_valid(made.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7));
    CHECK(made.report.is_met());
    if (size == coarse)
      CHECK(made.mesh.triangles.size() < mesh.triangles.size());
    else
      CHECK(made.mesh.triangles.size() > mesh.triangles.size());
    mesh = made.mesh;
  }
}

TEST_CASE("Adapted meshes have the same bits for any number of threads", "[adapt][threads]") {
  const Pslg pslg = random_pslg::polygon(5);
  const Mesh mesh = fresh_mesh(pslg, Options());
  double reach = 0;
  for (const Point& p : pslg.vertices) reach = std::max({reach, std::abs(p.x()), std::abs(p.y())});
  const Options finer = sizes_around(pslg.vertices[0], reach / 300, 0.2);
  const Options coarser = sizes_around(pslg.vertices[1], reach / 300, 0.3);
  const auto fine = CGAL::adapt_mesh_2(mesh, pslg, finer),
             coarse = CGAL::adapt_mesh_2(fine.mesh, pslg, coarser);
  for_numbers_of_threads([&] {
    const auto first = CGAL::adapt_mesh_2<CGAL::Parallel_tag>(mesh, pslg, finer);
    CHECK(have_same_bits(first.mesh, fine.mesh));
    const auto second = CGAL::adapt_mesh_2<CGAL::Parallel_tag>(first.mesh, pslg, coarser);
    CHECK(have_same_bits(second.mesh, coarse.mesh));
    CHECK(second.transfer.old_vertex == coarse.transfer.old_vertex);
  });
}

TEST_CASE("Renumbered meshes keep the order of their vertices", "[adapt]") {
  const Pslg pslg = frame();
  Mesh mesh = fresh_mesh(pslg, Options().max_area(0.01));
  CGAL::renumber_by_place(mesh);
  const auto made = CGAL::adapt_mesh_2(mesh, pslg, sizes_around(Point(0, 0), 0.05, 0.5));
  check_transfer(made, mesh);
  check_valid(made.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7));
  CHECK(made.mesh.input_index.size() == made.mesh.points.size());
}

TEST_CASE("A linear function is carried over as it is", "[adapt]") {
  const Pslg pslg = frame();
  const Mesh mesh = fresh_mesh(pslg, Options().max_area(0.05));
  std::vector<double> values;
  for (const Point& p : mesh.points) values.push_back(3 * p.x() - p.y() + 1);
  const auto made = CGAL::adapt_mesh_2(mesh, pslg, sizes_around(Point(4, 4), 0.03, 0.4));
  const auto carried = made.transfer.carry_over(mesh, values);
  REQUIRE(carried.size() == made.mesh.points.size());
  for (std::size_t v = 0; v < carried.size(); ++v)
    CHECK(carried[v] == Approx(3 * made.mesh.points[v].x() - made.mesh.points[v].y() + 1).margin(1e-12));
}

TEST_CASE("Sizes at vertices refine and coarsen", "[adapt]") {
  const Pslg pslg = frame();
  const Mesh mesh = fresh_mesh(pslg, Options().max_edge(0.15));
  std::vector<double> sizes;
  for (const Point& p : mesh.points) sizes.push_back(0.04 + 0.2 * p.x());
  const CGAL::Mesh_sizing_field_2 field(mesh, sizes);
  const auto made = CGAL::adapt_mesh_2(mesh, pslg, Options().size(field));
  check_transfer(made, mesh);
  check_valid(made.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7));
  CHECK(number_kept(made) < mesh.points.size());
  CHECK(number_kept(made) < made.mesh.points.size());
  for (std::size_t t = 0; t < made.mesh.triangles.size(); ++t) {
    const Point p = centroid(made.mesh, t);
    CHECK(longest_edge(made.mesh, t) <= field(p.x(), p.y()) * (1 + 1e-9));
  }
}

TEST_CASE("What is stopped leaves nothing out", "[adapt]") {
  const Pslg pslg = frame();
  const Mesh mesh = fresh_mesh(pslg, Options().max_area(0.001));
  const auto cancelled = CGAL::adapt_mesh_2(mesh, pslg, Options().progress([](double) { return false; }));
  check_valid(cancelled.mesh, pslg);
  check_transfer(cancelled, mesh);
  CHECK(number_kept(cancelled) == mesh.points.size());
  std::vector<double> shares;
  const auto whole = CGAL::adapt_mesh_2(mesh, pslg, Options().progress([&shares](double share) {
    shares.push_back(share);
    return true;
  }));
  CHECK(whole.mesh.points.size() < mesh.points.size());
  CHECK(std::is_sorted(shares.begin(), shares.end()));
}

} // namespace test_adapt_mesh_2
