// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes brought to doubles: either a valid mesh over doubles, by the checker and by exact predicates, or an error that
// names a place.

#include "catch.h"
#include "mesher_test_tools.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_quadtree_traits_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Quadtree_mesh_2/internal/output/Rounded_mesh_topology.h>
#include <CGAL/Quadtree_mesh_2/internal/output/Segment_chains.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/Tree_separation_options_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/round_mesh_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <regex>
#include <string>
#include <vector>

namespace test_round_mesh_2 {

namespace {

using mesher_test::read;
using pslg_test::error_of;
using pslg_test::has_text;
using pslg_test::Point;
using pslg_test::Pslg;
using pslg_test::Vertex_index;
using Rounded = CGAL::Rounded_mesh_2<Point>;
using Mesh = CGAL::Indexed_mesh_2<Point>;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_point = Exact_kernel::Point_2;
using Exact_mesh = CGAL::Indexed_mesh_2<Exact_point>;

struct Exact_run {
  Exact_mesh mesh;
  CGAL::Quality_mesh_report_2 report;
};

Exact_run mesh_exactly(const Pslg& pslg, const CGAL::Quality_mesh_options_2& options = {}) {
  CGAL::Pslg_2<Exact_point> graph;
  for (const Point& p : pslg.vertices) graph.add_vertex(Exact_point(p.x(), p.y()));
  graph.segments = pslg.segments;
  CGAL::Quality_mesher_2<CGAL::Exact_quadtree_traits_2<>> mesher(options);
  Exact_run run;
  run.mesh = mesher(graph);
  run.report = mesher.report();
  return run;
}

std::size_t number_not_counterclockwise(const Mesh& mesh) {
  std::size_t n = 0;
  for (const auto& t : mesh.triangles)
    n += CGAL::orientation(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])) == CGAL::LEFT_TURN ? 0 : 1;
  return n;
}

/// What must hold for every rounded mesh.
void check(const Rounded& rounded, const Pslg& pslg, const CGAL::Quality_mesh_options_2& options = {}) {
  const auto rule = mesher_test::rule_to_check(options.mesh_domain());
  const CGAL::Mesh_quality_2 quality =
      CGAL::mesh_quality_2(rounded.mesh, pslg, CGAL::Mesh_quality_options_2().check_domain(rule));
  for (const std::string& error : quality.errors) UNSCOPED_INFO(error);
  CHECK(quality.is_valid());
  CHECK(number_not_counterclockwise(rounded.mesh) == 0);
  CHECK(std::equal(pslg.vertices.begin(), pslg.vertices.end(), rounded.mesh.points.begin()));
}

/// Rounds the exact mesh; nothing if there is none over doubles, or it would be too large.
std::optional<Rounded> round_exact_mesh(const Pslg& pslg, const CGAL::Quality_mesh_options_2& options = {}) {
  std::optional<Rounded> rounded;
  const std::string error =
      error_of([&] { rounded = CGAL::round_mesh_2<Point>(mesh_exactly(pslg, options).mesh); });
  if (rounded)
    check(*rounded, pslg, options);
  else
    CHECK(std::regex_search(error, std::regex("vertex (at|[0-9]+) \\(")));
  return rounded;
}

using Words = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
using Scale = CGAL::Fixed_point_scale_2<std::uint64_t>;

/// The mesh over words, brought back to doubles.
Rounded round_mesh_in_words(const Pslg& pslg, const CGAL::Quality_mesh_options_2& options = {}) {
  const Scale scale = Scale::of_points(pslg.vertices);
  CGAL::Pslg_2<Words::Point_2> words;
  words.segments = pslg.segments;
  for (const Point& p : pslg.vertices) words.add_vertex(scale.to_fixed(p.x(), p.y()));
  CGAL::Quality_mesher_2<Words> mesher(options);
  return CGAL::round_mesh_2<Point>(mesher(words), pslg.vertices, [&scale](const Words::Point_2& p) {
    const auto [x, y] = scale.to_double(p);
    return Point(x, y);
  });
}

/// A box with a segment in it, and a vertex so many ulps above the middle of the segment.
Pslg missed_junction(std::mt19937_64& random, double far, int ulps) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Pslg pslg;
  for (const auto& [x, y] : std::vector<std::array<double, 2>>{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}})
    pslg.add_vertex(Point(far + x, far + y));
  for (std::size_t i = 0; i < 4; ++i) pslg.add_segment(Vertex_index(i), Vertex_index((i + 1) % 4));
  const double ay = coordinate(random), ax = coordinate(random), by = coordinate(random),
               bx = coordinate(random);
  const Point a(far + ax, far + ay), b(far + bx, far + by);
  double y = (a.y() + b.y()) / 2;
  for (int i = 0; i < ulps; ++i) y = std::nextafter(y, 2 * std::fabs(y) + 1);
  pslg.add_segment(pslg.add_vertex(a), pslg.add_vertex(b));
  pslg.add_segment(pslg.add_vertex(Point((a.x() + b.x()) / 2, y)), Vertex_index(2));
  return pslg;
}

/// Two triangles at one vertex, with sides that are so many ulps apart at their far ends.
Pslg wedges_apart(std::mt19937_64& random, int ulps) {
  std::uniform_real_distribution<double> coordinate(-8, 8);
  const double ax = coordinate(random), ay = coordinate(random), bx = coordinate(random),
               by = coordinate(random);
  double y = by;
  for (int i = 0; i < ulps; ++i) y = std::nextafter(y, 100);
  Pslg pslg;
  for (const Point& p : {Point(ax, ay), Point(bx, by), Point(bx, by - 5), Point(bx, y), Point(bx, by + 5)})
    pslg.add_vertex(p);
  for (const auto& [a, b] :
       std::vector<std::array<std::size_t, 2>>{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}})
    pslg.add_segment(Vertex_index(a), Vertex_index(b));
  return pslg;
}

} // namespace

TEST_CASE("meshes that need no cure are rounded as they are", "[round]") {
  for (const std::string name : {"syn_comb.poly", "syn_wedge_1deg.poly", "syn_near_1e-12.poly"}) {
    CAPTURE(name);
    const Pslg pslg = read(name);
    const Exact_run run = mesh_exactly(pslg);
    const Rounded rounded = CGAL::round_mesh_2<Point>(run.mesh);
    check(rounded, pslg);
    CHECK(rounded.is_as_it_was());
    CHECK(rounded.mesh.triangles == run.mesh.triangles);
  }
}

TEST_CASE("meshes with features of an ulp are valid over doubles, or refused by a place", "[round]") {
  for (const std::string name :
       {"hard_exact_rounding.poly", "hard_cgal781_tiny_edge.poly", "hard_ulps_apart.poly"}) {
    CAPTURE(name);
    round_exact_mesh(read(name));
  }
  CHECK(round_exact_mesh(read("hard_cgal781_tiny_edge.poly")));
}

TEST_CASE("junctions missed by ulps, near the origin and far from it", "[round]") {
  const std::uint64_t seeds = is_full_run() ? 1000 : 2;
  std::size_t trials = 0, refused = 0;
  for (const double far : {0., 1e3, 1e9})
    for (const int ulps : {1, 2, 7, 100})
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        CAPTURE(far, ulps, seed);
        std::mt19937_64 random(seed);
        const Pslg pslg = missed_junction(random, far, ulps);
        ++trials;
        if (!round_exact_mesh(pslg)) ++refused;
      }
  CHECK(refused * 4 <= trials);
}

TEST_CASE("a report's triangles are found in the rounded mesh", "[round]") {
  const Pslg pslg = read("hard_cgal781_tiny_edge.poly");
  Exact_run run = mesh_exactly(pslg);
  const Rounded rounded = CGAL::round_mesh_2<Point>(run.mesh);
  std::size_t kept = 0;
  for (std::size_t t = 0; t < rounded.new_triangle.size(); ++t)
    if (rounded.new_triangle[t].is_valid()) CHECK(std::size_t(rounded.new_triangle[t]) == kept++);
  CHECK(kept == rounded.mesh.triangles.size());
  CHECK(run.mesh.points.size() == rounded.mesh.points.size() + rounded.merged_vertices);
  rounded.renumber(run.report);
  CHECK(run.report.triangles == rounded.mesh.triangles.size());
  for (const auto& e : run.report.exempt_triangles)
    CHECK(std::size_t(e.triangle) < rounded.mesh.triangles.size());
}

TEST_CASE("words far from the origin keep all digits of doubles", "[round][fixed]") {
  Pslg pslg = read("hard_false_crossing.poly");
  pslg.segments.clear(); // they are so near to each other that meshes would be too large
  for (const auto& [x, y] :
       std::vector<std::array<double, 2>>{{-6378160, -10}, {-6378130, -10}, {-6378130, 40}, {-6378160, 40}})
    pslg.add_vertex(Point(x, y));
  for (std::size_t i = 0; i < 4; ++i) pslg.add_segment(Vertex_index(4 + i), Vertex_index(4 + (i + 1) % 4));
  const Scale scale = Scale::of_points(pslg.vertices);
  for (const Point& p : pslg.vertices) CHECK(scale.is_exact(p.x(), p.y()));
  check(round_mesh_in_words(pslg), pslg);
}

TEST_CASE("pieces of segments go ahead after rounding", "[round][fixed]") {
  CGAL::Quality_mesh_options_2 by_trees, fine;
  by_trees.separate(CGAL::Tree_separation_options_2());
  fine.max_edge(0.1);
  for (const std::string name : {"hard_round_vertex_beside_side.poly", "hard_round_tiny_square.poly",
                                 "hard_round_split_corners.poly"}) {
    CAPTURE(name);
    const Pslg pslg = read(name);
    // The tiny square has a vertex half a step of the coordinates beside a segment: some meshes have no doubles.
    CHECK((round_exact_mesh(pslg) || name == "hard_round_tiny_square.poly"));
    const Rounded rounded = round_mesh_in_words(pslg), rounded_by_trees = round_mesh_in_words(pslg, by_trees);
    check(rounded, pslg), check(rounded_by_trees, pslg);
  }
  CHECK(round_exact_mesh(read("hard_round_vertex_beside_side.poly"), fine));
}

TEST_CASE("rounding spoils angles only beside features of ulps", "[round]") {
  const Pslg pslg = read("hard_far_end_two_ulps.poly");
  const Exact_run run = mesh_exactly(pslg);
  CHECK(run.report.is_met());
  const Rounded rounded = CGAL::round_mesh_2<Point>(run.mesh);
  check(rounded, pslg);
  const auto quality =
      CGAL::mesh_quality_2(rounded.mesh, pslg, CGAL::Mesh_quality_options_2().min_angle(20.7));
  for (const auto& unmet : quality.unmet_triangles) {
    const Point place(unmet.centroid[0], unmet.centroid[1]);
    CHECK(std::any_of(pslg.vertices.begin(), pslg.vertices.end(),
                      [&](const Point& p) { return CGAL::squared_distance(p, place) < 1e-16; }));
  }
}

TEST_CASE("edges do not cross over gaps outside after rounding", "[round][fixed]") {
  using Options = CGAL::Quality_mesh_options_2;
  const Options::Domain parity = Options::Domain::NESTING_PARITY;
  const auto check_exact_and_in_words = [](const std::string& name, const Options& options) {
    CAPTURE(name);
    const Pslg pslg = read(name);
    CHECK(round_exact_mesh(pslg, options));
    check(round_mesh_in_words(pslg, options), pslg, options);
  };
  check_exact_and_in_words("hard_round_gap_outside.poly", {});
  check_exact_and_in_words("hard_round_gap_of_a_tenth.poly", {});
  check_exact_and_in_words("hard_round_gap_at_triangle.poly", Options().mesh_domain(parity));
  CHECK(round_exact_mesh(read("hard_round_gap_outside.poly"), Options().max_edge(0.5)));
  CHECK(round_exact_mesh(read("hard_round_gap_in_hole.poly"),
                         Options().mesh_domain(parity).separate(CGAL::Tree_separation_options_2())));
}

TEST_CASE("wedges with sides units in the last place apart outside", "[round]") {
  const std::uint64_t seeds = is_full_run() ? 500 : 10;
  CGAL::Quality_mesh_options_2 fine;
  fine.max_edge(0.5);
  std::size_t refused = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    if (!round_exact_mesh(wedges_apart(random, 1 + static_cast<int>(seed % 4)), fine)) ++refused;
  }
  CHECK(refused * 10 <= seeds);
}

TEST_CASE("a mesh beside subnormal features is rounded, or refused by a place", "[round]") {
  round_exact_mesh(read("hard_round_subnormal.poly"));
}

TEST_CASE("no edge is made twice, whatever triangles are at fault", "[round]") {
  using CGAL::Quadtree_mesh_2::Triangle_index;
  Mesh mesh; // a triangle with a Steiner vertex in it
  mesh.number_of_input_vertices = 3;
  for (const auto& [x, y] : std::vector<std::array<double, 2>>{{0, 0}, {3, 0}, {0, 3}, {1, 1}})
    mesh.points.emplace_back(x, y);
  for (std::size_t k = 0; k < 3; ++k) {
    mesh.triangles.push_back({Vertex_index(k), Vertex_index((k + 1) % 3), Vertex_index(3)});
    mesh.neighbors.push_back({Triangle_index((k + 1) % 3), Triangle_index((k + 2) % 3), Triangle_index()});
  }
  mesh.segment_of_vertex.resize(mesh.points.size());
  CGAL::Quadtree_mesh_2::internal::Segment_chains<Point> chains(mesh);
  const CGAL::Quadtree_mesh_2::internal::Rounded_mesh_topology<Point> topology(mesh, chains);
  for (std::size_t t = 0; t < 3; ++t)
    for (int k = 0; k < 3; ++k) CHECK_FALSE(topology.may_flip(Triangle_index(t), k));
}

TEST_CASE("pieces go ahead as chains of their segments say", "[round]") {
  using CGAL::Quadtree_mesh_2::Segment_index;
  Mesh mesh; // a segment with three Steiner vertices, of which the second and third changed places
  mesh.number_of_input_vertices = 2;
  for (const double x : {0., 8., 2., 5., 4.}) mesh.points.emplace_back(x, 0);
  for (const auto& [a, b] : std::vector<std::array<std::size_t, 2>>{{3, 4}, {2, 0}, {1, 4}, {2, 3}})
    mesh.constrained_edges.push_back({{Vertex_index(a), Vertex_index(b)}, Segment_index(0)});
  CGAL::Quadtree_mesh_2::internal::Segment_chains<Point> chains(mesh);
  CHECK_FALSE(chains.goes_ahead(0));
  for (const std::size_t e : {1, 2, 3}) CHECK(chains.goes_ahead(e));
}

} // namespace test_round_mesh_2
