// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Meshes whose features quadtrees separate: what holds for every mesh, and that quadtrees alone meet the bound.

#include "catch.h"
#include "numbers_of_threads.h"
#include "theorem_5_tools.h"

#include <CGAL/Quality_mesher_2.h>
#include <CGAL/Trapezoidal_vertex_edge_neighbors_2.h>
#include <CGAL/bounding_box.h>
#include <CGAL/mesh_quality_2.h>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace test_theorem_5 {

namespace {

using namespace theorem_5_test;
using pslg_test::make_pslg;
using pslg_test::Point;
using pslg_test::unit_square;
using Domain = Options::Domain;

/// The number of triangles that refinement on demand makes of the same input.
std::size_t number_on_demand(const Pslg& pslg, Options options) {
  Mesher mesher(options.separate(Options::Separation::ON_DEMAND));
  return mesher(pslg).number_of_triangles();
}

/// Squares with half sides 4, 3, 2, 1 in each other.
Pslg nested_squares() {
  Pslg pslg;
  for (const double half : {4., 3., 2., 1.}) {
    const std::size_t first = pslg.number_of_vertices();
    for (const auto& p : unit_square().vertices)
      pslg.add_vertex(Point(half * (2 * p.x() - 1), half * (2 * p.y() - 1)));
    for (std::size_t i = 0; i < 4; ++i)
      pslg.add_segment(pslg_test::Vertex_index(first + i), pslg_test::Vertex_index(first + (i + 1) % 4));
  }
  return pslg;
}

} // namespace

TEST_CASE("Every small input of test/data is meshed by quadtrees to the bound", "[mesher][theorem5]") {
  const std::string name =
      GENERATE(as<std::string>(), "syn_square.poly", "syn_sliver_1deg.poly", "syn_wedge_10deg.poly",
               "syn_wedge_1deg.poly", "syn_wedge_0.01deg.poly", "syn_near_1e-06.poly", "syn_near_1e-12.poly",
               "syn_parallel_0.001.poly", "syn_comb.poly", "syn_fan_1deg.poly", "syn_holes_400.poly.gz");
  const double angle = GENERATE(18.43, 20.7);
  CAPTURE(name, angle);
  const Pslg pslg = read(name);
  const Options options = by_quadtrees().min_angle(angle);
  const Run r = run_by_quadtrees(pslg, options);
  CHECK(is_about_as_many(r.report.triangles, number_on_demand(pslg, options)));
}

TEST_CASE("Inputs that random search found to be hard are meshed by quadtrees", "[mesher][theorem5]") {
  const std::string name = GENERATE(as<std::string>(), "hard_lattice_21260.poly",
                                    "hard_visibility_graph_11091.poly", "hard_visibility_graph_2608.poly",
                                    "hard_visibility_graph_3314.poly", "hard_visibility_graph_8327.poly",
                                    "hard_visibility_graph_8360.poly", "hard_visibility_graph_9113.poly");
  const double angle = GENERATE(18.43, 20.7);
  CAPTURE(name, angle);
  const Pslg pslg = read(name);
  const Options options = by_quadtrees().min_angle(angle);
  const Run r = run_by_quadtrees(pslg, options);
  CHECK(is_about_as_many(r.report.triangles, number_on_demand(pslg, options)));
}

TEST_CASE("A map takes as many triangles by quadtrees as on demand", "[mesher][theorem5]") {
  const Pslg pslg = read("us_states_10m.poly.gz");
  const Run r = run_by_quadtrees(pslg, by_quadtrees());
  CHECK(double(r.report.triangles) <= 1.05 * double(number_on_demand(pslg, Options())));
}

TEST_CASE("One round of placing is enough where refinement cures what it misses", "[mesher][theorem5]") {
  const std::string name =
      GENERATE(as<std::string>(), "us_states_10m.poly.gz", "syn_holes_400.poly.gz", "syn_comb.poly",
               "syn_fan_1deg.poly", "syn_wedge_0.01deg.poly", "syn_near_1e-12.poly");
  const auto coarsen = GENERATE(Options::Coarsening::GUARDED_REMOVAL, Options::Coarsening::NONE);
  CAPTURE(name, int(coarsen));
  const Pslg pslg = read(name);
  const Run r = run_to_the_bound(pslg, Options().separate(Tree_options()).coarsen(coarsen));
  const auto& trees = r.report.trees;
  CHECK(trees.rounds == 1);
  CHECK(trees.missed == trees.missed_by_rule);
  CHECK(trees.end == (trees.missed == 0 ? End::DONE : End::ROUNDS));
  // The mesh is that of the quadtrees, and not refinement's of the graph.
  CHECK(trees.triangles > 0);
  CHECK(trees.kept <= trees.placed);
  const double steiner = double(r.report.vertices) - double(pslg.number_of_vertices());
  CHECK(double(trees.kept) >
        (coarsen == Options::Coarsening::NONE ? 0.9 * double(trees.placed) : 0.1 * steiner));
  if (coarsen == Options::Coarsening::GUARDED_REMOVAL)
    CHECK(is_about_as_many(r.report.triangles, number_on_demand(pslg, Options())));
}

TEST_CASE("Rounds of placing vertices are counted", "[mesher][theorem5]") {
  const Pslg pslg = read("us_states_10m.poly.gz");
  for (const std::size_t most : {2u, 3u, 100u}) {
    CAPTURE(most);
    const Run r = run_to_the_bound(pslg, Options().separate(Tree_options::of_theorem().rounds(most)));
    CHECK(r.report.trees.rounds <= most);
    CHECK(r.report.trees.end == (r.report.trees.missed == 0 ? End::DONE : End::ROUNDS));
    if (most == 100) CHECK(r.report.trees.missed == 0);
  }
}

TEST_CASE("An edge through leaves that are split keeps its vertices elsewhere", "[mesher][theorem5]") {
  const Run r = run_by_quadtrees(read("hard_edge_through_changes.poly.gz"), by_quadtrees());
  const auto& t = r.report.trees;
  CHECK((t.rounds > 1 && 20 * t.placed < 21 * (t.triangles / 2))); // few are placed again
}

TEST_CASE("Large maps take as many triangles by quadtrees as on demand", "[mesher][theorem5][.slow]") {
  const std::string name = GENERATE(as<std::string>(), "gshhg_aegean_h.poly.gz", "gshhg_norway_f.poly.gz");
  CAPTURE(name);
  const Pslg pslg = read(name);
  for (const double angle : {18.43, 20.7}) {
    const Options options = by_quadtrees().min_angle(angle);
    const Run r = run_by_quadtrees(pslg, options);
    CHECK(double(r.report.triangles) <= 1.05 * double(number_on_demand(pslg, options)));
  }
}

TEST_CASE("What the report says of trees", "[mesher][theorem5]") {
  const Pslg pslg = read("syn_holes_400.poly.gz");
  const auto trees = run_by_quadtrees(pslg, by_quadtrees()).report.trees;
  CHECK(trees.leaves_of_points > pslg.number_of_vertices() / 4);
  CHECK(trees.leaves_of_points <= trees.leaves_of_vertices);
  CHECK(trees.leaves_of_vertices <= trees.leaves_of_pieces);
  CHECK(trees.leaves_of_pieces <= trees.leaves_of_edges);
  CHECK(trees.triangles > 0);
  CHECK(trees.missed <= trees.missed_by_rule);
  const auto none = run(pslg, Options()).report.trees;
  CHECK(none.rounds + none.leaves_of_points + none.leaves_of_edges + none.triangles == 0);
  CHECK(none.end == End::NONE);
}

TEST_CASE("Without removal the mesh by quadtrees meets the bound by itself", "[mesher][theorem5]") {
  for (const std::string name : {"syn_comb.poly", "syn_holes_400.poly.gz"}) {
    CAPTURE(name);
    const Pslg pslg = read(name);
    const Run all = run_by_quadtrees(pslg, by_quadtrees().coarsen(Options::Coarsening::NONE));
    CHECK(all.report.triangles > 2 * run(pslg, by_quadtrees()).report.triangles);
    // and but for exact Delaunay flips and what is left out it is what was placed
    CHECK(all.report.triangles <= all.report.trees.triangles);
    CHECK(all.report.triangles + 2 * all.report.trees.left_out >= all.report.trees.triangles);
  }
}

TEST_CASE("The paper's constants and other distances", "[mesher][theorem5]") {
  const Pslg pslg = read("syn_holes_400.poly.gz");
  std::size_t leaves = 0;
  for (const Tree_options& trees :
       {Tree_options::of_theorem(), Tree_options::of_theorem().distances(1, 1), Tree_options::of_paper()}) {
    const Run r = run_by_quadtrees(pslg, Options().separate(trees));
    CHECK(r.report.trees.leaves_of_edges > leaves);
    leaves = r.report.trees.leaves_of_edges;
  }
}

TEST_CASE("Both models of neighbors and both subdivisions give the same mesh", "[mesher][theorem5]") {
  using Trapezoids = CGAL::Trapezoidal_vertex_edge_neighbors_2<Mesher::Geom_traits>;
  for (const std::string name : {"us_states_10m.poly.gz", "syn_fan_1deg.poly", "syn_near_1e-12.poly"}) {
    CAPTURE(name);
    const Pslg pslg = read(name);
    const Mesh mesh = Mesher(by_quadtrees())(pslg);
    CHECK(are_same(mesh, Mesher(by_quadtrees()).find_neighbors_by<Trapezoids>()(pslg)));
    CHECK(are_same(mesh, Mesher(Options().separate(Tree_options::of_theorem().subdivide(
                             Tree_options::Subdivision::CENTROID_TREE)))(pslg)));
  }
}

TEST_CASE("A map is meshed by quadtrees to the same bits with any number of threads",
          "[mesher][theorem5][parallel]") {
  const Pslg pslg = read("us_states_10m.poly.gz");
  const Mesh sequential = Mesher(by_quadtrees())(pslg);
  for_numbers_of_threads([&] {
    using Parallel = CGAL::Quality_mesher_2<CGAL::Filtered_quadtree_traits_2<>, CGAL::Parallel_tag>;
    CHECK(are_same(Parallel(by_quadtrees())(pslg), sequential));
  });
}

// ---- domains and sizes

TEST_CASE("Nested squares by each rule and by quadtrees", "[mesher][theorem5]") {
  Pslg pslg = nested_squares();
  const auto area = [&pslg](Domain domain) {
    return run_by_quadtrees(pslg, by_quadtrees().mesh_domain(domain)).quality.area;
  };
  CHECK(area(Domain::ENCLOSED) == Approx(64));
  CHECK(area(Domain::NESTING_PARITY) == Approx(64 - 36 + 16 - 4));
  pslg.holes = {Point(0, 1.5)};
  CHECK(area(Domain::ENCLOSED) == Approx(64 - 12));
  pslg.regions.push_back({Point(0, 2.5), 1, 0});
  pslg.regions.push_back({Point(0, 0), 2, 0});
  CHECK(area(Domain::MARKED) == Approx(36 - 16 + 4));
}

TEST_CASE("Regions keep their labels and bounds in meshes by quadtrees", "[mesher][theorem5]") {
  Pslg pslg = make_pslg<double>({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}},
                                {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {1, 4}});
  pslg.regions.push_back({Point(1.5, 0.5), 7.0, 0.001});
  const Run r = run_by_quadtrees(pslg, by_quadtrees());
  REQUIRE(r.mesh.region_of_triangle.size() == r.mesh.number_of_triangles());
  std::size_t wrong = 0, large = 0;
  for (std::size_t t = 0; t < r.mesh.number_of_triangles(); ++t) {
    const auto& v = r.mesh.triangles[t];
    const Point &a = r.mesh.point(v[0]), &b = r.mesh.point(v[1]), &c = r.mesh.point(v[2]);
    const bool is_right = CGAL::centroid(a, b, c).x() > 1;
    wrong += r.mesh.region_of_triangle[t] == (is_right ? 0 : -1) ? 0 : 1;
    large += is_right && CGAL::area(a, b, c) > 0.001 ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(large == 0);
  CHECK(r.report.triangles > 1000);
}

TEST_CASE("What quadtrees leave too large is refined", "[mesher][theorem5]") {
  for (const std::string name : {"syn_square.poly", "syn_wedge_1deg.poly", "syn_comb.poly"}) {
    CAPTURE(name);
    const Pslg pslg = read(name);
    const auto box = CGAL::bounding_box(pslg.vertices.begin(), pslg.vertices.end());
    const double area = (box.xmax() - box.xmin()) * (box.ymax() - box.ymin()) / 2000;
    const Run r = run_by_quadtrees(pslg, by_quadtrees().max_area(area));
    CHECK(double(r.report.triangles) < 2.5 * double(number_on_demand(pslg, Options().max_area(area))));
    run_by_quadtrees(pslg, by_quadtrees().max_edge(std::sqrt(area)));
  }
}

// ---- what stops it

TEST_CASE("A callback that returns false stops construction by quadtrees", "[mesher][theorem5]") {
  const Pslg pslg = read("us_states_10m.poly.gz");
  for (const int last : {0, 1, 3, 6}) {
    int calls = 0;
    double share_before = 0;
    const Run r = run(pslg, by_quadtrees().progress([&](double share) {
      CHECK((share >= share_before && share <= 1));
      share_before = share;
      return calls++ < last;
    }));
    CHECK(r.report.is_cancelled == (calls > last));
    if (!r.report.is_cancelled) CHECK(r.report.is_met());
    CHECK(r.report.unmet_triangles.size() == r.quality.unmet_triangles.size());
    if (last == 0) CHECK(r.report.trees.end == End::CANCELLED);
  }
}

TEST_CASE("Where quadtrees exhaust a budget refinement makes the mesh", "[mesher][theorem5]") {
  // The trees alone have 97 000 leaves. Refinement on demand needs 23 000 vertices, not as few as the first budget.
  const Pslg pslg = read("us_states_10m.poly.gz");
  for (const std::size_t budget : {15000u, 30000u}) {
    CAPTURE(budget);
    const Run r = run(pslg, by_quadtrees().max_vertices(budget));
    CHECK(r.report.trees.end == End::BUDGET);
    CHECK(r.report.trees.rounds == 0);
    CHECK(r.report.is_budget_exhausted == (budget == 15000u));
    CHECK(r.report.is_met() == (budget == 30000u));
    CHECK(are_same(r.mesh, Mesher(Options().max_vertices(budget))(pslg)));
    CHECK(r.report.unmet_triangles.size() == r.quality.unmet_triangles.size());
    for (const auto& unmet : r.report.unmet_triangles)
      CHECK(unmet.reason == CGAL::Quality_mesh_report_2::Reason::BUDGET);
  }
}

TEST_CASE("Rounds that use up a budget are no start for refinement", "[mesher][theorem5]") {
  const Pslg pslg = read("syn_near_1e-06.poly");
  constexpr std::size_t budget = 420; // one round reaches it, a second would have no triangle below the bound
  const Run r = run(pslg, by_quadtrees().max_vertices(budget));
  CHECK(r.report.trees.end == End::BUDGET);
  CHECK(r.report.trees.rounds > 0);
  CHECK(r.report.trees.placed == 0); // none of them is in the mesh
  CHECK(r.report.trees.kept == 0);
  CHECK(r.report.is_met());
  CHECK(are_same(r.mesh, Mesher(Options().max_vertices(budget))(pslg)));
}

TEST_CASE("Quadtrees keep to a limit of vertices, whatever the rounds", "[mesher][theorem5][budget]") {
  for (const std::string name : {"us_states_10m.poly.gz", "syn_holes_400.poly.gz", "syn_comb.poly"})
    for (const std::size_t rounds : {0u, 1u})
      for (const std::size_t limit : {100u, 1000u}) {
        CAPTURE(name, rounds, limit);
        const Pslg pslg = read(name);
        Mesher mesher(Options().separate(Tree_options().rounds(rounds)).max_steiner_vertices(limit));
        CHECK(mesher(pslg).number_of_vertices() <= pslg.number_of_vertices() + limit);
      }
}

TEST_CASE("Vertices of edges a few steps apart stay within rounding of their edges", "[mesher][theorem5]") {
  for (const char* name : {"hard_legs_a_few_steps_apart.poly", "hard_lattice_doubled_by_steps.poly"}) {
    CAPTURE(name);
    const Run r = run(read(name), by_quadtrees());
    CHECK(r.report.trees.triangles > 0);
  }
}

TEST_CASE("Corners of leaves between legs for long beside each other are found next to each other",
          "[mesher][theorem5][.slow]") {
  const Pslg pslg =
      read("hard_legs_beside_each_other_for_long.poly"); // a million corners, refused in the end
  CHECK_THROWS_AS(Mesher(Options().separate(Options::Separation::THEOREM_5))(pslg), CGAL::Pslg_error_2);
}

TEST_CASE("Legs units apart, beside gaps that are wider, are refined within rounding of each other",
          "[mesher][theorem5][.slow]") {
  const Run r = run(read("hard_legs_units_apart_beside_gaps.poly"), by_quadtrees());
  CHECK(r.report.trees.end == End::ROUNDS);
}

TEST_CASE("Edges a few units apart force no small leaves along their length", "[mesher][theorem5]") {
  for (const std::string name : {"hard_lattice_edges_for_long_beside.poly", "hard_legs_for_long_beside.poly",
                                 "hard_legs_for_many_leaves.poly"}) {
    CAPTURE(name);
    const Pslg pslg = read(name);
    const Run r = run(pslg, Options().separate(Options::Separation::THEOREM_5));
    CHECK(r.report.trees.end == End::ROUNDS);
    CHECK(r.report.trees.leaves_of_edges < 10000);
    CHECK(r.mesh.number_of_triangles() < 3000);
  }
}

TEST_CASE("Errors of the input are the same whatever separates features", "[mesher][theorem5]") {
  const auto is_same = [](const Pslg& pslg, const Options& options = Options()) {
    Options by_trees = options;
    by_trees.separate(Tree_options::of_theorem());
    const std::string error = pslg_test::error_of([&] {
      Mesher mesher(by_trees);
      mesher(pslg);
    });
    CHECK_FALSE(error.empty());
    CHECK(error == pslg_test::error_of([&] {
            Mesher mesher(options);
            mesher(pslg);
          }));
  };
  is_same(Pslg());
  is_same(make_pslg<double>({{0, 0}}));
  is_same(make_pslg<double>({{0, 0}, {1, 1}, {2, 2}}, {{0, 1}, {1, 2}}));
  is_same(make_pslg<double>({{0, 0}, {1, 0}, {0, 1}}));
  is_same(make_pslg<double>({{0, 0}, {1, 0}, {0, 1}}, {{0, 1}, {1, 2}}));
  is_same(
      make_pslg<double>({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}, {1, 3}}));
  is_same(unit_square(), Options().mesh_domain(Domain::MARKED));
  Pslg hollow = unit_square();
  hollow.holes.push_back(Point(0.5, 0.5));
  is_same(hollow);
  Pslg wrong = unit_square();
  wrong.vertices[2] = Point(std::numeric_limits<double>::quiet_NaN(), 0);
  is_same(wrong);
}

// ---- where coordinates have no room

namespace {

/// Whether all vertices of a graph without holes are in its mesh, at their places.
bool are_all_in_mesh(const Pslg& pslg, const Mesh& mesh) {
  std::vector<char> is_used(mesh.points.size(), 0);
  for (const auto& triangle : mesh.triangles)
    for (const auto v : triangle) is_used[std::size_t(v)] = 1;
  for (std::size_t v = 0; v < pslg.number_of_vertices(); ++v)
    if (is_used[v] == 0 || mesh.points[v] != pslg.vertices[v]) return false;
  return true;
}

/// The unit square with two vertices in it, 2^-70 apart.
Pslg two_vertices_beyond_the_grid() {
  Pslg pslg = unit_square();
  for (Point& p : pslg.vertices) p = Point(p.x() - 0.5, p.y() - 0.5);
  pslg.add_vertex(Point(0x1p-70, 0));
  pslg.add_vertex(Point(0x1p-69, 0));
  return pslg;
}

} // namespace

TEST_CASE("Features as near as coordinates allow are left to refinement", "[mesher][theorem5]") {
  const std::string name = GENERATE(as<std::string>(), "hard_vertices_ulps_apart.poly",
                                    "hard_vertex_ulps_from_edge.poly", "hard_edge_of_an_ulp.poly");
  CAPTURE(name);
  const Pslg pslg = read(name);
  const Run r = run(pslg, by_quadtrees());
  CHECK(are_all_in_mesh(pslg, r.mesh));
  CHECK(r.report.trees.end == End::COORDINATES);
  CHECK(r.report.trees.handed_over > 0);
  CHECK(r.report.trees.handed_over <= r.report.trees.missed);
  CHECK(r.report.unmet_triangles.size() == r.quality.unmet_triangles.size());
  CHECK(r.report.triangles < 2000);
}

TEST_CASE("Isolated features near the last place, at any offset, are meshed by quadtrees",
          "[mesher][theorem5]") {
  random_pslg::Random random(3);
  for (const double offset : {0., 1e3, 1e9, -1e12})
    for (const int exponent : {-20, -30, -40, -45}) {
      const double extent = std::max(1., std::fabs(offset) * 1e-6), size = std::ldexp(extent, exponent);
      Pslg pslg = unit_square();
      for (Point& p : pslg.vertices) p = Point(offset + extent * p.x(), offset + extent * p.y());
      const Point at(offset + extent * random.between(0.2, 0.8), offset + extent * random.between(0.2, 0.8));
      const double least = 8 * (std::nextafter(std::fabs(at.x()), 1e300) - std::fabs(at.x()));
      const auto a = pslg.add_vertex(at), b = pslg.add_vertex(Point(at.x() + std::max(size, least), at.y())),
                 c = pslg.add_vertex(Point(at.x(), at.y() + extent * 0.1));
      pslg.add_segment(a, c);
      CAPTURE(offset, exponent, b);
      const Run r = run(pslg, by_quadtrees());
      CHECK(are_all_in_mesh(pslg, r.mesh));
      CHECK(r.report.unmet_triangles.size() == r.quality.unmet_triangles.size());
      CHECK((r.report.trees.end == End::DONE || r.report.trees.end == End::COORDINATES));
      CHECK((r.report.trees.end == End::DONE) == (r.report.trees.missed == 0));
    }
}

TEST_CASE("Vertices that the grid cannot tell apart are named as the user does", "[mesher][theorem5]") {
  const std::string error = pslg_test::error_of([] {
    Mesher mesher(by_quadtrees());
    mesher(two_vertices_beyond_the_grid());
  });
  CAPTURE(error);
  CHECK(error.find("vertex 4 (8.470329472543003e-22, 0)") != std::string::npos);
  CHECK(error.find("vertex 5 (1.6940658945086007e-21, 0)") != std::string::npos);
}

TEST_CASE("Where quadtrees fail to take over the report says so, and refinement goes on",
          "[mesher][theorem5]") {
  const Pslg pslg = two_vertices_beyond_the_grid();
  const Run r = run_to_the_bound(pslg, Options().patience(0));
  CHECK(r.report.trees.has_taken_over);
  CHECK(r.report.trees.end == End::FAILED);
  CHECK_FALSE(r.report.is_budget_exhausted);
  CHECK(are_all_in_mesh(pslg, r.mesh));
}

// ---- quadtrees where refinement does not come to rest

TEST_CASE("Without patience quadtrees take over", "[mesher][theorem5]") {
  for (const std::string name : {"us_states_10m.poly.gz", "syn_comb.poly", "syn_fan_1deg.poly"}) {
    CAPTURE(name);
    const Pslg pslg = read(name);
    const Run r = run_by_quadtrees(pslg, Options().patience(0));
    CHECK_FALSE(r.report.is_budget_exhausted);
    CHECK(r.report.trees.has_taken_over);
    CHECK(run(pslg, Options()).report.trees.rounds == 0);
  }
}

TEST_CASE("With a budget quadtrees do not take over", "[mesher][theorem5]") {
  const Run r = run(read("us_states_10m.poly.gz"), Options().patience(0).max_vertices(20000));
  CHECK(r.report.trees.end == End::NONE);
  CHECK(r.report.is_budget_exhausted);
  CHECK(r.report.unmet_triangles.size() == r.quality.unmet_triangles.size());
}

TEST_CASE("Where quadtrees cannot take over patience is not looked at", "[mesher][theorem5]") {
  const Pslg pslg = read("syn_holes_400.poly.gz");
  for (const Options& options : {Options().min_angle(25), Options().min_edge(1e-9),
                                 Options().refine_where([](const Options::Corners&) { return false; })}) {
    const Run r = run(pslg, Options(options).patience(0));
    CHECK(r.report.trees.end == End::NONE);
    CHECK_FALSE(r.report.is_budget_exhausted);
    CHECK(r.report.is_met());
    CHECK(are_same(r.mesh, Mesher(options)(pslg)));
  }
}

TEST_CASE("A little memory for patience changes nothing where refinement comes to rest",
          "[mesher][theorem5]") {
  const Pslg pslg = read("us_states_10m.poly.gz");
  CHECK(are_same(Mesher(Options().patience_memory(1))(pslg), Mesher(Options())(pslg)));
}

TEST_CASE("Random inputs without patience", "[mesher][theorem5]") {
  const std::uint64_t seeds = is_full_run() ? 100 : 2;
  for (const random_pslg::Family& family : random_pslg::families())
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      CAPTURE(family.name, seed);
      run_to_the_bound(family.make(seed), Options().patience(0));
    }
}

} // namespace test_theorem_5
