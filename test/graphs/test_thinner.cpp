// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Thinning: never more triangles, every bound kept, the same bits for any number of threads.

#include "catch.h"
#include "mesher_test_tools.h"
#include "numbers_of_threads.h"
#include "random_pslg_shapes.h"

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace test_thinner {

namespace {

using namespace mesher_test;
using pslg_test::Point;
using pslg_test::unit_square;

bool are_same(const Mesh& a, const Mesh& b) {
  return a.points == b.points && a.triangles == b.triangles && a.neighbors == b.neighbors &&
         a.segment_of_vertex == b.segment_of_vertex;
}

/// Meshes without and with thinning, and checks that this takes no more triangles.
/// \returns the share of triangles left
double share_left(const Pslg& pslg, Options options, int rounds) {
  const Run plain = run_to_the_bound(pslg, options), thin = run_to_the_bound(pslg, options.thin(rounds));
  CHECK(thin.report.triangles <= plain.report.triangles);
  return double(thin.report.triangles) / double(plain.report.triangles);
}

double area_of_box(const Pslg& pslg) {
  const auto box = CGAL::bounding_box(pslg.vertices.begin(), pslg.vertices.end());
  return (box.xmax() - box.xmin()) * (box.ymax() - box.ymin());
}

} // namespace

TEST_CASE("Maps are thinned", "[mesher][thinning]") {
  const Pslg states = read("us_states_10m.poly.gz");
  CHECK(share_left(states, Options(), 1) < 0.985);
  CHECK(share_left(read("syn_holes_400.poly.gz"), Options(), 3) <= 1);
}

TEST_CASE("Each round of thinning takes away more triangles of a coast", "[mesher][thinning]") {
  const Pslg coast = read("gshhg_aegean_h.poly.gz");
  std::size_t before = run(coast, Options()).report.triangles;
  const double first = double(before);
  for (const int rounds : {1, 3}) {
    const Run r = run_to_the_bound(coast, Options().thin(rounds));
    CHECK(r.report.triangles < before);
    before = r.report.triangles;
  }
  CHECK(double(before) < 0.96 * first);
}

TEST_CASE("Small inputs are thinned, or left as they are", "[mesher][thinning]") {
  const std::string name =
      GENERATE(as<std::string>(), "syn_square.poly", "syn_sliver_1deg.poly", "syn_wedge_10deg.poly",
               "syn_wedge_1deg.poly", "syn_wedge_0.01deg.poly", "syn_near_1e-06.poly", "syn_near_1e-12.poly",
               "syn_parallel_0.001.poly", "syn_comb.poly", "syn_fan_1deg.poly");
  CAPTURE(name);
  share_left(read(name), Options(), 3);
  share_left(read(name), Options().min_angle(18.43), 1);
}

TEST_CASE("Small inputs take no more triangles than by Shewchuk's Triangle", "[mesher][thinning]") {
  struct Counts {
    std::string name;
    std::size_t at_20_7, at_25, at_30; // of Triangle 1.6, -pqDEGREES
  };
  const Counts counts =
      GENERATE(values<Counts>({{"small_lattice_164", 50, 50, 135}, {"small_lattice_275", 16, 16, 77},
                               {"small_polygon_109", 14, 16, 22},  {"small_polygon_23", 12, 11, 21},
                               {"small_segments_176", 10, 14, 32}, {"small_segments_242", 5, 5, 19},
                               {"small_spokes_74", 25, 34, 89},    {"small_star_220", 7, 7, 13},
                               {"small_star_56", 1, 1, 6},         {"small_star_58", 8, 18, 19},
                               {"small_walk_112", 24, 28, 56},     {"small_walk_129", 11, 15, 30},
                               {"small_walk_155", 33, 42, 155},    {"small_walk_219", 10, 10, 38},
                               {"small_walk_25", 13, 23, 31},      {"small_walk_550", 11, 20, 51},
                               {"small_square_32", 148, 169, 759}, {"small_square_11", 133, 159, 560},
                               {"small_square_28", 87, 92, 438},   {"syn_wedge_0.01deg", 127, 187, 298},
                               {"syn_wedge_10deg", 30, 43, 54},    {"syn_wedge_1deg", 64, 85, 155},
                               {"syn_near_1e-06", 233, 416, 732},  {"syn_near_1e-12", 452, 793, 1831}}));
  CAPTURE(counts.name);
  const Pslg pslg = read(counts.name + ".poly");
  CHECK(run_to_the_bound(pslg, Options()).report.triangles <= counts.at_20_7);
  CHECK(run_to_the_bound(pslg, Options().min_angle(25)).report.triangles <= counts.at_25);
  CHECK(run_to_the_bound(pslg, Options().min_angle(30)).report.triangles <= counts.at_30);
}

TEST_CASE("A plate takes no more triangles than by Shewchuk's Triangle at 30 degrees", "[mesher][thinning]") {
  const Run r = run_to_the_bound(read("syn_holes_400.poly.gz"), Options().min_angle(30));
  CHECK(r.report.triangles <= 8455); // Triangle 1.6, -pq30
}

TEST_CASE("Random inputs are thinned to the bound", "[mesher][thinning]") {
  const std::uint64_t seeds = is_full_run() ? 300 : 8;
  for (const random_pslg::Family& family : random_pslg::all_families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      CAPTURE(family.name, seed);
      share_left(family.make(seed), Options().min_angle(seed % 2 == 0 ? 20.7 : 18.43), seed % 3 == 0 ? 3 : 1);
    }
}

TEST_CASE("Above the established angle thinning leaves no more undone", "[mesher][thinning]") {
  const Pslg states = read("us_states_10m.poly.gz");
  for (const double angle : {25., 30.}) {
    CAPTURE(angle);
    const Run plain = run(states, Options().min_angle(angle)),
              thin = run(states, Options().min_angle(angle).thin(1));
    CHECK(thin.report.triangles <= plain.report.triangles);
    CHECK(thin.report.unmet_triangles.size() <= plain.report.unmet_triangles.size());
    CHECK(thin.report.unmet_triangles.size() == thin.quality.unmet_triangles.size());
  }
  for (const random_pslg::Family& family : random_pslg::families()) {
    for (std::uint64_t seed = 0; seed < random_pslg::number_of_seeds(family, is_full_run() ? 200 : 5);
         ++seed) {
      CAPTURE(family.name, seed);
      const Options options = Options().min_angle(seed % 2 == 0 ? 25 : 30);
      const Pslg pslg = family.make(seed);
      const Run plain = run(pslg, options), thin = run(pslg, Options(options).thin(2));
      CHECK(thin.report.triangles <= plain.report.triangles);
      CHECK(thin.report.unmet_triangles.size() <= plain.report.unmet_triangles.size());
    }
  }
}

TEST_CASE("Bounds of size are kept when meshes are thinned", "[mesher][thinning]") {
  // The last flips may make a triangle too large, and so take back what little was won.
  const auto thin = [](const Pslg& pslg, const Options& options, int rounds) {
    const Run before = run_to_the_bound(pslg, options);
    const Run after = run_to_the_bound(pslg, Options(options).thin(rounds));
    CHECK(double(after.report.triangles) <= 1.002 * double(before.report.triangles) + 2);
  };
  thin(unit_square(), Options().max_edge(0.05), 3);
  thin(unit_square(), Options().max_area(0.0005), 3);
  thin(read("syn_comb.poly"), Options().max_area(0.5), 2);
  const Pslg states = read("us_states_10m.poly.gz");
  thin(states, Options().max_area(area_of_box(states) / 20000), 1);

  const auto field = [](double x, double y) { return 0.02 + 0.2 * std::hypot(x, y); };
  thin(unit_square(), Options().size(field), 2);
  const Run r = run_to_the_bound(unit_square(), Options().size(field).thin(2));
  std::size_t large = 0;
  for (const auto& v : r.mesh.triangles) {
    const Point &a = r.mesh.point(v[0]), &b = r.mesh.point(v[1]), &c = r.mesh.point(v[2]);
    const Point m = CGAL::centroid(a, b, c);
    const double longest = std::sqrt(
        std::max({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)}));
    large += longest > field(m.x(), m.y()) * (1 + 1e-12) ? 1 : 0;
  }
  CHECK(large == 0);
}

TEST_CASE("The least edge is kept when meshes are thinned", "[mesher][thinning]") {
  const Pslg states = read("us_states_10m.poly.gz");
  const double least = std::sqrt(area_of_box(states)) / 3000;
  const Run r = run(states, Options().min_edge(least).thin(1));
  double shortest = 1e300;
  for (const auto& v : r.mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = v[k], b = v[(k + 1) % 3];
      if (std::size_t(a) < r.mesh.number_of_input_vertices &&
          std::size_t(b) < r.mesh.number_of_input_vertices)
        continue;
      shortest = std::min(shortest, CGAL::squared_distance(r.mesh.point(a), r.mesh.point(b)));
    }
  CHECK(std::sqrt(shortest) >= least * (1 - 1e-12));
}

TEST_CASE("A map is thinned to the same bits with any number of threads", "[mesher][thinning][parallel]") {
  const Pslg states = read("us_states_10m.poly.gz");
  const Options options = Options().thin(2);
  const Mesh sequential = Mesher(options)(states);
  for_numbers_of_threads([&] {
    using Parallel = CGAL::Quality_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag>;
    CHECK(are_same(Parallel(options)(states), sequential));
  });
}

TEST_CASE("Cancelled thinning, or with a budget, leaves a valid mesh", "[mesher][thinning]") {
  const Pslg states = read("us_states_10m.poly.gz");
  int all = 0;
  run(states, Options().thin(2).progress([&all](double) { return ++all > 0; }));
  for (const int last : {all - 1, all - 2, all / 2}) {
    int calls = 0;
    const Run r = run(states, Options().thin(2).progress([&](double) { return calls++ < last; }));
    CHECK((r.report.is_cancelled || r.report.is_met()));
    CHECK(r.report.unmet_triangles.size() == r.quality.unmet_triangles.size());
  }
  const std::size_t enough = run(states, Options()).report.vertices;
  for (const std::size_t budget : {std::size_t(15000), enough + 3000}) {
    const Run r = run(states, Options().thin(1).max_vertices(budget));
    CHECK(r.report.unmet_triangles.size() == r.quality.unmet_triangles.size());
    CHECK(r.report.vertices <= budget);
  }
}

} // namespace test_thinner
