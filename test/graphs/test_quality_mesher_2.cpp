// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "mesher_test_tools.h"
#include "meshers_in_words32.h"
#include "pslg_test_tools.h"
#include "random_pslg.h"

#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quadtree_mesh_2/internal/checker/Straight_segment.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/refine_quality_mesh_2.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_rational.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_quality_mesher_2 {

namespace {

using pslg_test::make_pslg;
using pslg_test::Point;
using pslg_test::Pslg;
using pslg_test::unit_square;
using namespace mesher_test;

bool are_same(const Mesh& a, const Mesh& b) {
  return a.points == b.points && a.triangles == b.triangles && a.neighbors == b.neighbors &&
         a.segment_of_vertex == b.segment_of_vertex;
}

} // namespace

TEST_CASE("Every input of test/data is meshed to the bound", "[mesher]") {
  const std::string name =
      GENERATE(as<std::string>(), "syn_square.poly", "syn_sliver_1deg.poly", "syn_wedge_10deg.poly",
               "syn_wedge_1deg.poly", "syn_wedge_0.01deg.poly", "syn_near_1e-06.poly", "syn_near_1e-12.poly",
               "syn_parallel_0.001.poly", "syn_comb.poly", "syn_fan_1deg.poly", "syn_holes_400.poly.gz",
               "us_states_10m.poly.gz", "gshhg_aegean_h.poly.gz", "gshhg_norway_f.poly.gz");
  const double angle = GENERATE(18.43, 20.7);
  CAPTURE(name, angle);
  run_to_the_bound(read(name), Options().min_angle(angle));
}

TEST_CASE("Inputs that random search found to be hard are meshed to the bound", "[mesher]") {
  // Two corners whose legs have the same far end; shells next to each other; triangles given up.
  const std::string name = GENERATE(as<std::string>(), "hard_lattice_21260.poly",
                                    "hard_visibility_graph_11091.poly", "hard_visibility_graph_2608.poly",
                                    "hard_visibility_graph_3314.poly", "hard_visibility_graph_8327.poly",
                                    "hard_visibility_graph_8360.poly", "hard_visibility_graph_9113.poly");
  const double angle = GENERATE(18.43, 20.7);
  CAPTURE(name, angle);
  const Run r = run_to_the_bound(read(name), Options().min_angle(angle));
  CHECK(r.report.triangles < 100); // nothing is refined down to the precision of doubles
}

TEST_CASE("Real maps take fewer triangles than Delaunay refinement", "[mesher]") {
  // The counts of Shewchuk's Triangle, -pq20.7.
  CHECK(run(read("us_states_10m.poly.gz"), Options()).report.triangles < 47500);
  CHECK(run(read("gshhg_aegean_h.poly.gz"), Options()).report.triangles < 106800);
  CHECK(run(read("gshhg_norway_f.poly.gz"), Options()).report.triangles < 421300);
}

TEST_CASE("Random hard inputs are meshed to the bound", "[mesher]") {
  const std::uint64_t seeds = is_full_run() ? 1500 : 40;
  for (const random_pslg::Family& family : random_pslg::families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      CAPTURE(family.name, seed);
      const Pslg pslg = family.make(seed);
      run_to_the_bound(pslg, Options().min_angle(seed % 2 == 0 ? 20.7 : 18.43));
    }
}

TEST_CASE(
    "Above the established angle meshes are valid, nearly all meet the bound, and what is left is reported",
    "[mesher]") {
  const std::uint64_t seeds = is_full_run() ? 400 : 12;
  std::size_t runs = 0, met = 0;
  for (const random_pslg::Family& family : random_pslg::families()) {
    for (std::uint64_t seed = 0; seed < random_pslg::number_of_seeds(family, seeds); ++seed) {
      CAPTURE(family.name, seed);
      const Pslg pslg = family.make(seed);
      constexpr double angles[] = {25, 30, 32, 34};
      const Run r = run(pslg, Options().min_angle(angles[seed % 4]));
      CHECK(r.report.unmet_triangles.size() == r.quality.unmet_triangles.size());
      CHECK_FALSE(r.report.is_budget_exhausted);
      ++runs, met += r.report.is_met() ? 1 : 0;
    }
  }
  CHECK(100 * met >= 99 * runs);
}

TEST_CASE("Two corners of one vertex at the origin do not drive each other on without end at 30 degrees",
          "[mesher]") {
  run(random_pslg::lattice(286), Options().min_angle(30));
}

TEST_CASE("A map is meshed at bounds up to the greatest", "[mesher]") {
  const double angle = GENERATE(30., 32., Options::greatest_min_angle);
  const Run r = run(read("us_states_10m.poly.gz"), Options().min_angle(angle));
  CHECK(r.report.is_met());
}

TEST_CASE("The same input gives the same bits", "[mesher]") {
  const Pslg pslg = read("us_states_10m.poly.gz");
  const Mesh first = Mesher()(pslg);
  CHECK(are_same(first, Mesher()(pslg)));
  Mesher used;
  used(unit_square());
  CHECK(are_same(first, used(pslg)));
}

TEST_CASE("Without removal there are more triangles, and they meet the bound too", "[mesher]") {
  const Pslg pslg = read("syn_holes_400.poly.gz");
  const Run all = run_to_the_bound(pslg, Options().coarsen(Options::Coarsening::NONE));
  CHECK(all.report.triangles > run_to_the_bound(pslg, Options()).report.triangles);
}

TEST_CASE("Smoothing takes fewer triangles, with better angles, and keeps the bounds", "[mesher]") {
  const Pslg pslg = read("us_states_10m.poly.gz");
  const Run plain = run_to_the_bound(pslg, Options()), smooth = run_to_the_bound(pslg, Options().smooth(1));
  CHECK(smooth.report.triangles < plain.report.triangles);
  const auto share_below_30 = [](const Run& r) {
    std::size_t below = 0;
    for (std::size_t degree = 0; degree < 30; ++degree) below += r.report.least_angle_histogram[degree];
    return static_cast<double>(below) / static_cast<double>(r.report.triangles);
  };
  CHECK(share_below_30(smooth) < share_below_30(plain));
}

TEST_CASE("Bounds on edges and areas are met", "[mesher]") {
  run_to_the_bound(unit_square(), Options().max_edge(0.05));
  run_to_the_bound(unit_square(), Options().max_area(0.0005));
  run_to_the_bound(unit_square(), Options().min_angle(0).max_area(0.01));
  run_to_the_bound(read("syn_wedge_1deg.poly"), Options().max_edge(0.1));
  run_to_the_bound(read("syn_comb.poly"), Options().max_area(0.5));
  run_to_the_bound(read("us_states_10m.poly.gz"), Options().max_edge(20000).max_area(1e8));
}

TEST_CASE("Features across an outside gap force nothing", "[mesher]") {
  const Pslg pslg = make_pslg<double>(
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1.001, 0.3}, {2.001, 0.3}, {2.001, 1.3}, {1.001, 1.3}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}});
  CHECK(run_to_the_bound(pslg, Options()).report.triangles == 4);
}

TEST_CASE("Holes, nested holes and islands", "[mesher]") {
  Pslg pslg = make_pslg<double>(
      {{0, 0},
       {4, 0},
       {4, 4},
       {0, 4},
       {1, 1},
       {3, 1},
       {3, 3},
       {1, 3},
       {1.5, 1.5},
       {2.5, 1.5},
       {2.5, 2.5},
       {1.5, 2.5}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {8, 9}, {9, 10}, {10, 11}, {11, 8}});
  CHECK(run_to_the_bound(pslg, Options()).quality.area == Approx(16));
  pslg.holes = {Point(1.2, 2)};
  CHECK(run_to_the_bound(pslg, Options()).quality.area == Approx(13));
  pslg.holes = {Point(1.2, 2), Point(2, 2), Point(9, 9)}; // the last is outside anyway
  CHECK(run_to_the_bound(pslg, Options()).quality.area == Approx(12));
}

TEST_CASE("Regions are carried to triangles", "[mesher]") {
  Pslg pslg = make_pslg<double>({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}},
                                {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {1, 4}});
  pslg.regions.push_back({Point(1.5, 0.5), 7.0, 0.0});
  const Run r = run_to_the_bound(pslg, Options());
  REQUIRE(r.mesh.region_of_triangle.size() == r.mesh.number_of_triangles());
  for (std::size_t t = 0; t < r.mesh.number_of_triangles(); ++t) {
    double x = 0;
    for (const auto v : r.mesh.triangles[t]) x += r.mesh.point(v).x() / 3;
    CHECK(r.mesh.region_of_triangle[t] == (x > 1 ? 0 : -1));
  }
}

TEST_CASE("Duplicates, vertices on segments, overlaps, dangling and isolated parts", "[mesher]") {
  SECTION("duplicate vertices stand for one") {
    const Pslg pslg =
        make_pslg<double>({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}}, {{0, 1}, {2, 3}, {4, 5}, {5, 0}});
    CHECK(run_to_the_bound(pslg, Options()).report.merged_vertices == 2);
  }
  SECTION("a vertex on a segment splits it") {
    const Pslg pslg = make_pslg<double>({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {1, 2}},
                                        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}});
    CHECK(run_to_the_bound(pslg, Options()).report.vertices_on_segments == 2);
  }
  SECTION("a segment that ends on another at 10 degrees makes a wedge") {
    const Pslg pslg = make_pslg<double>({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {3.5, 0.2644904710626973}},
                                        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}});
    CHECK(!run_to_the_bound(pslg, Options()).report.exempt_triangles.empty());
  }
  SECTION("overlapping segments share their pieces") {
    const Pslg pslg = make_pslg<double>({{0, 0}, {3, 0}, {3, 1}, {0, 1}, {1, 0}, {2, 0}},
                                        {{0, 5}, {4, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 1}, {1, 1}});
    run_to_the_bound(pslg, Options());
  }
  SECTION("dangling segments, isolated vertices, one part touching another in a vertex") {
    const Pslg pslg =
        make_pslg<double>({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {2, 3}, {1, 1}, {6, 4}, {6, 6}, {9, 9}},
                          {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {2, 7}, {7, 8}, {8, 2}, {8, 9}});
    run_to_the_bound(pslg, Options());
  }
}

TEST_CASE("Extreme coordinates", "[mesher]") {
  const double scale = GENERATE(1e-290, 1e-150, 1e-9, 1.0, 1e9, 1e150, 1e299);
  CAPTURE(scale);
  const Pslg unit = read("syn_wedge_1deg.poly");
  Pslg pslg = unit;
  for (Point& p : pslg.vertices) p = Point(scale * p.x(), scale * p.y());
  run_to_the_bound(pslg, Options());
  run_to_the_bound(pslg, Options().max_edge(0.1 * scale));
}

TEST_CASE("A budget or the callback stops with a valid mesh and a true report", "[mesher]") {
  const Pslg pslg = read("us_states_10m.poly.gz");
  SECTION("budget") {
    const Run r = run(pslg, Options().max_vertices(15000));
    CHECK(r.report.is_budget_exhausted);
    CHECK(r.report.vertices <= 15000);
    CHECK(r.report.unmet_triangles.size() == r.quality.unmet_triangles.size());
    CHECK_FALSE(r.report.is_met());
  }
  SECTION("cancelled") {
    int calls = 0;
    const Run r = run(pslg, Options().progress([&calls](double share) {
      CHECK((share >= 0 && share <= 1));
      return ++calls < 2;
    }));
    CHECK(r.report.is_cancelled);
    CHECK(calls == 2);
    CHECK(r.report.unmet_triangles.size() == r.quality.unmet_triangles.size());
  }
}

TEST_CASE("What cannot be meshed is an error that names the culprit", "[mesher]") {
  const auto error_of = [](const Pslg& pslg) { return pslg_test::error_of([&] { Mesher()(pslg); }); };
  CHECK(error_of(Pslg()).find("vertices") != std::string::npos);
  CHECK_FALSE(error_of(make_pslg<double>({{0, 0}})).empty());
  CHECK_FALSE(error_of(make_pslg<double>({{0, 0}, {1, 1}, {2, 2}}, {{0, 1}, {1, 2}})).empty());
  CHECK(error_of(make_pslg<double>({{0, 0}, {1, 0}, {0, 1}})).find("no segments") != std::string::npos);
  CHECK(error_of(make_pslg<double>({{0, 0}, {1, 0}, {0, 1}}, {{0, 1}, {1, 2}})).find("enclose no domain") !=
        std::string::npos);
  Pslg hollow = unit_square();
  hollow.holes.push_back(Point(0.5, 0.5));
  CHECK(error_of(hollow).find("holes") != std::string::npos);
  const std::string crossing = error_of(
      make_pslg<double>({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}, {1, 3}}));
  CHECK(crossing.find("segment 5") != std::string::npos);
  CHECK(crossing.find("crosses segment 4") != std::string::npos);
  Pslg wrong = unit_square();
  wrong.vertices[2] = Point(std::numeric_limits<double>::quiet_NaN(), 0);
  CHECK(error_of(wrong).find("vertex 2") != std::string::npos);
}

TEST_CASE("Options out of range are refused", "[mesher]") {
  CHECK_THROWS_AS(Mesher(Options().min_angle(35)), std::invalid_argument);
  CHECK_THROWS_AS(Mesher(Options().min_angle(-1)), std::invalid_argument);
  CHECK_THROWS_AS(Mesher(Options().min_angle(std::numeric_limits<double>::quiet_NaN())),
                  std::invalid_argument);
  CHECK_THROWS_AS(Mesher(Options().max_edge(-1)), std::invalid_argument);
  CHECK_THROWS_AS(Mesher(Options().max_area(-1)), std::invalid_argument);
}

TEMPLATE_TEST_CASE("Integers are meshed in integers", "[mesher]", std::uint32_t, std::uint64_t) {
  using Traits = CGAL::Fixed_point_quadtree_traits_2<TestType>;
  using Fixed_point = typename Traits::Point_2;
  const std::string name =
      GENERATE(as<std::string>(), "us_states_10m.poly.gz", "syn_holes_400.poly.gz", "syn_wedge_1deg.poly");
  CAPTURE(name);
  const Pslg pslg = read(name);
  const auto scale = CGAL::Fixed_point_scale_2<TestType>::of_points(pslg.vertices);
  CGAL::Pslg_2<Fixed_point> fixed;
  for (const Point& p : pslg.vertices) fixed.vertices.push_back(scale.to_fixed(p.x(), p.y()));
  for (const Point& p : pslg.holes) fixed.holes.push_back(scale.to_fixed(p.x(), p.y()));
  fixed.segments = pslg.segments;
  CGAL::Quality_mesher_2<Traits> mesher;
  const auto mesh = mesher(fixed);
  CHECK(mesher.report().is_met());
  const auto quality = CGAL::mesh_quality_2(mesh, fixed, CGAL::Mesh_quality_options_2().min_angle(20.7));
  for (const std::string& error : quality.errors) UNSCOPED_INFO(error);
  CHECK(quality.is_valid());
  CHECK(quality.unmet_triangles.empty());
}

TEST_CASE("A CGAL triangulation is refined in place", "[mesher]") {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vb = CGAL::Triangulation_vertex_base_2<Kernel>;
  using Fb = CGAL::Delaunay_mesh_face_base_2<Kernel>;
  using Cdt =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vb, Fb>>;
  const Pslg pslg = read("syn_holes_400.poly.gz");
  Cdt cdt;
  for (const auto& s : pslg.segments) cdt.insert_constraint(pslg.point(s[0]), pslg.point(s[1]));
  const auto report = CGAL::refine_quality_mesh_2(cdt, pslg.holes);
  CHECK(report.is_met());
  CHECK(cdt.is_valid());
  std::size_t inside = 0;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
    inside += f->is_in_domain() ? 1 : 0;
  CHECK(inside == report.triangles);

  Cdt open;
  open.insert_constraint(Point(0, 0), Point(1, 0));
  open.insert(Point(0, 1));
  CHECK(CGAL::refine_quality_mesh_2(open).triangles == 0); // no domain
  CHECK(open.number_of_vertices() == 3);
}

TEST_CASE("Meshes that are fine are called fine, whatever is small beside what", "[mesher]") {
  const std::string name = GENERATE(as<std::string>(), "unit_quad_at_3e6.poly",
                                    "near_border_and_segment.poly", "wedge_3e-14deg.poly");
  CAPTURE(name);
  const Pslg pslg = read(name);
  const Run r =
      name == "near_border_and_segment.poly" ? run(pslg, Options()) : run_to_the_bound(pslg, Options());
  if (name == "wedge_3e-14deg.poly") CHECK(r.quality.exempt_triangles == 1);
}

TEST_CASE("Rounding of vertices on segments does not add up", "[mesher]") {
  // A vertex next to a slanted segment has it split about fifty times.
  using Number = CGAL::Exact_rational;
  using CGAL::Quadtree_mesh_2::internal::unit_in_last_place;
  for (const double offset : {0., 1e3})
    for (int i = 0; i < (is_full_run() ? 1000 : 50); ++i) {
      const double share = 0.2 + 0.012 * (i % 50), slope = 0.3 + 0.001 * i;
      const double distance = std::ldexp(1., offset > 0 ? -10 - i % 25 : -10 - i % 35);
      const Point p(offset + 0.1, offset + 0.2), q(offset + 0.9, offset + 0.2 + 0.8 * slope);
      const Point beside(p.x() + share * (q.x() - p.x()), p.y() + share * (q.y() - p.y()) + distance);
      const auto at = [offset](double x, double y) {
        return std::pair<double, double>(offset + x, offset + y);
      };
      const Pslg pslg = make_pslg<double>(
          {at(0, 0), at(1, 0), at(1, 2), at(0, 2), {p.x(), p.y()}, {q.x(), q.y()}, {beside.x(), beside.y()}},
          {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}});
      CAPTURE(offset, i);
      const Run r = run(pslg, Options());
      const Number dx = Number(q.x()) - Number(p.x()), dy = Number(q.y()) - Number(p.y());
      const Number reach =
          2 * (dx * Number(unit_in_last_place(q.y())) + dy * Number(unit_in_last_place(q.x())));
      for (std::size_t v = 0; v < r.mesh.points.size(); ++v) {
        if (r.mesh.segment_of_vertex[v] != pslg_test::Segment_index(4)) continue;
        const Number ux = Number(r.mesh.points[v].x()) - Number(p.x()),
                     uy = Number(r.mesh.points[v].y()) - Number(p.y());
        const Number off = dx * uy - dy * ux;
        CHECK(off <= reach);
        CHECK(off >= -reach);
      }
    }
}

TEST_CASE("Meshes of the maps are valid CGAL triangulations", "[mesher]") {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vb = CGAL::Triangulation_vertex_base_2<Kernel>;
  using Fb = CGAL::Delaunay_mesh_face_base_2<Kernel>;
  using Cdt =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vb, Fb>>;
  const std::string name = GENERATE(as<std::string>(), "us_states_10m.poly.gz", "gshhg_aegean_h.poly.gz",
                                    "syn_fan_1deg.poly", "syn_comb.poly", "syn_wedge_0.01deg.poly");
  CAPTURE(name);
  const Pslg pslg = read(name);
  Cdt cdt;
  CGAL::indexed_mesh_to_constrained_Delaunay_triangulation_2(Mesher()(pslg), pslg, cdt);
  CHECK(cdt.is_valid());
}

} // namespace test_quality_mesher_2
