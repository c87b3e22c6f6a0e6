// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The size of the mesh is known before memory is spent on it.

#include "catch.h"
#include "mesher_test_tools.h"
#include "pslg_test_tools.h"
#include "random_pslg.h"

#include <CGAL/Quality_mesher_2.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace test_quality_mesher_budget {

namespace {

using namespace mesher_test;
using pslg_test::has_text;
using pslg_test::Point;
using pslg_test::unit_square;

/// The estimate over the true number.
double ratio(const Run& r) { return r.report.estimated_triangles / double(r.report.triangles); }

/// Two segments of length 2 at a distance, in a box.
Pslg parallel_segments(double gap) {
  random_pslg::Builder b;
  b.loop({Point(-4, -4), Point(4, -4), Point(4, 4), Point(-4, 4)});
  for (const double y : {0.0, gap}) {
    const auto v = b.vertex(Point(-1, y));
    b.segment(v, b.vertex(Point(1, y)));
  }
  return b.pslg;
}

/// Of length 1, as all of the thin ones.
Pslg box(double width) {
  random_pslg::Builder b;
  b.loop({Point(0, 0), Point(1, 0), Point(1, width), Point(0, width)});
  return b.pslg;
}

/// A box that is ten times as wide at its other end.
Pslg opening_strip(double width) {
  random_pslg::Builder b;
  b.loop({Point(0, 0), Point(1, 0), Point(1, 10 * width), Point(0, width)});
  return b.pslg;
}

/// Between two regular polygons.
Pslg polygonal_ring(double width) {
  constexpr int corners = 24;
  random_pslg::Builder b;
  for (const double r : {1.0, 1 - width}) {
    std::vector<Point> loop;
    for (int i = 0; i < corners; ++i)
      loop.emplace_back(r * std::cos(2 * CGAL_PI * i / corners), r * std::sin(2 * CGAL_PI * i / corners));
    b.loop(loop);
  }
  b.pslg.holes.emplace_back(0, 0);
  return b.pslg;
}

/// Teeth of a width, as far from each other.
Pslg comb(double width) {
  constexpr int teeth = 10;
  std::vector<Point> p = {Point(0, 0), Point(2 * teeth * width, 0), Point(2 * teeth * width, width)};
  for (int i = teeth - 1; i >= 0; --i)
    for (const Point& corner : {Point(1.5, width), Point(1.5, 1), Point(0.5, 1), Point(0.5, width)})
      p.emplace_back((2 * i + corner.x()) * width, corner.y());
  p.emplace_back(0, width);
  random_pslg::Builder b;
  b.loop(p);
  return b.pslg;
}

Pslg segment_above_border(double gap) {
  random_pslg::Builder b;
  b.loop({Point(-1, 0), Point(1, 0), Point(1, 4), Point(-1, 4)});
  const auto v = b.vertex(Point(-0.9, gap));
  b.segment(v, b.vertex(Point(0.9, gap)));
  return b.pslg;
}

std::string error(const Pslg& pslg, const Options& options = {}) {
  Mesher mesher(options);
  return pslg_test::error_of([&] { mesher(pslg); });
}

} // namespace

TEST_CASE("The estimate is near the true number of triangles", "[mesher][budget]") {
  SECTION("maps and regular inputs") {
    const std::string name =
        GENERATE(as<std::string>(), "us_states_10m.poly.gz", "gshhg_aegean_h.poly.gz", "syn_comb.poly",
                 "syn_fan_1deg.poly", "syn_holes_400.poly.gz", "syn_parallel_0.001.poly");
    CAPTURE(name);
    const Pslg pslg = read(name);
    for (const double angle : {20.7, 30.0}) {
      const Run r = run(pslg, Options().min_angle(angle));
      CHECK(ratio(r) < 3);
      CHECK(ratio(r) > 1 / 3.);
    }
  }
  SECTION("bounds of size") {
    const auto is_near = [](const Options& options) {
      const Run r = run(unit_square(), options);
      CHECK(ratio(r) < 2);
      CHECK(ratio(r) > 0.5);
    };
    is_near(Options().max_edge(0.02));
    is_near(Options().max_area(0.0002));
    is_near(Options().max_edge(0.05).max_area(0.0002));
    is_near(Options().size([](double x, double y) { return 0.01 + 0.2 * std::hypot(x, y); }));
    Pslg pslg = unit_square();
    pslg.regions.push_back({Point(0.5, 0.5), 0, 0.0002});
    CHECK(ratio(run(pslg, Options())) < 2);
    CHECK(ratio(run(pslg, Options())) > 0.5);
  }
  SECTION("narrow gaps, also with something in them") {
    for (const double gap : {1e-2, 1e-3, 1e-4}) {
      Pslg pslg = parallel_segments(gap);
      CHECK(ratio(run(pslg, Options())) < 4);
      CHECK(ratio(run(pslg, Options())) > 1);
      pslg.add_vertex(Point(0.3, gap / 2));
      CHECK(ratio(run(pslg, Options())) < 4);
      CHECK(ratio(run(pslg, Options())) > 1);
    }
  }
  SECTION("thin boxes, rings and combs of every aspect") {
    for (const double width : {0.1, 1e-2, 1e-3, 1e-4})
      for (const Pslg& pslg : {box(width), polygonal_ring(width), comb(width), opening_strip(width),
                               segment_above_border(width)}) {
        CAPTURE(width, pslg.number_of_vertices());
        const Run r = run(pslg, Options());
        CHECK(ratio(r) < 4);
        CHECK(ratio(r) > 1 / 3.);
      }
  }
  SECTION("random hard inputs") {
    const std::uint64_t seeds = is_full_run() ? 400 : 25;
    for (const random_pslg::Family& family : random_pslg::families())
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        CAPTURE(family.name, seed);
        const Run r = run(family.make(seed), Options());
        CHECK(ratio(r) < 4);
        // needles with several short legs in them may take many more (doc/guarantees.md, a known weakness)
        if (r.report.triangles > 1000 && std::string(family.name) != "wedge") CHECK(ratio(r) > 0.25);
      }
  }
}

TEST_CASE("A gap that memory cannot hold is refused at once, and named", "[mesher][budget]") {
  const auto start = std::chrono::steady_clock::now();
  const std::string text = error(parallel_segments(1e-9));
  CHECK(std::chrono::steady_clock::now() - start <
        std::chrono::seconds(1)); // a millisecond, but machines stall
  CAPTURE(text);
  for (const char* part : {"segment 4", "segment 5", "vertex 4 (-1, 0)", "at a distance of 1e-09"})
    CHECK(has_text(text, part));
  CHECK(error(parallel_segments(1e-3)).empty());
  CHECK(error(parallel_segments(1e-9), Options().min_edge(1e-3)).empty());
}

TEST_CASE("Bounds of size whose squares doubles do not have are refused in words", "[mesher][budget]") {
  const Pslg pslg = read("syn_square.poly");
  for (const Options& options : {Options().max_area(1e-320), Options().max_edge(1e-310)}) {
    const std::string text = error(pslg, options);
    CAPTURE(text);
    CHECK(has_text(text, "more than 1e+300 vertices"));
    CHECK(has_text(text, "for the bounds of size"));
  }
}

TEST_CASE("A gap below a unit in the last place is refused as any other that is too long",
          "[mesher][budget]") {
  const auto start = std::chrono::steady_clock::now();
  const std::string text = error(read("hard_overlap_ulps_apart.poly"));
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
  CAPTURE(text);
  for (const char* part :
       {"segment 4", "segment 5", "vertex 6 (-709482.2202024617, ", "at a distance of 4.8"})
    CHECK(has_text(text, part));
}

TEST_CASE("A graph of few vertices that asks for more than it is given is refused, unless it has a budget",
          "[mesher][budget]") {
  const Pslg pslg = read("hard_leg_in_narrow_wedge.poly");
  const std::string text = error(pslg);
  CAPTURE(text);
  for (const char* part : {"a graph of fewer than 1000 vertices is allowed 2000000", "segment 4", "segment 6",
                           "vertex 4 (0.2297441020366099, ", "meet at an angle of 1.3"})
    CHECK(has_text(text, part));
  CHECK(has_text(error(pslg, Options().max_vertices(1000000)), "the vertex budget allows 1000000"));
  CHECK(error(pslg, Options().min_edge(1e-3)).empty());
  CHECK(
      has_text(error(read("hard_stretched_polygon.poly")), "a graph of fewer than 1000 vertices is allowed"));
}

TEST_CASE("A graph of few vertices whose mesh turns out too large is refused, too", "[mesher][budget]") {
  const Pslg pslg = parallel_segments(2e-6);
  const std::string text = error(pslg);
  CAPTURE(text);
  for (const char* part : {"not done with 2000000 triangles", "segment 4", "segment 5",
                           "face each other at a distance of 2e-06"})
    CHECK(has_text(text, part));
  // What bounds of size ask for is added to the limit, and is no whole number.
  const std::string with_bound =
      error(read("hard_legs_for_a_million_triangles.poly"), Options().max_area(0.00056211354693648118));
  CAPTURE(with_bound);
  for (const char* part : {"not done with 24", "meet at an angle of 1.49"}) CHECK(has_text(with_bound, part));
}

TEST_CASE("Bounds of size give a graph of few vertices no more for its gaps", "[mesher][budget]") {
  const Pslg pslg = read("hard_overlaps_in_words.poly");
  constexpr double extent = 0x1p29;
  for (const Options& options :
       {Options(), Options().max_area(0.005 * extent * extent), Options().max_edge(0.04 * extent),
        Options().size([](double, double) { return 0.04 * extent; })}) {
    const std::string text = error(pslg, options);
    CAPTURE(text);
    CHECK(has_text(text, "a graph of fewer than 1000 vertices is allowed 20"));
    CHECK(has_text(text, "segment 4"));
  }
  // What bounds of size ask for themselves is not refused.
  CHECK(error(unit_square(), Options().max_area(1e-6)).empty());
}

TEST_CASE("A size field gives a graph of few vertices no more for its gaps", "[mesher][budget]") {
  const auto start = std::chrono::steady_clock::now();
  const std::string text =
      error(read("gap_1e-8_in_triangle.poly"), Options().size([](double, double) { return 0.1; }));
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
  CAPTURE(text);
  for (const char* part : {"a graph of fewer than 1000 vertices is allowed", "segment 1", "segment 4"})
    CHECK(has_text(text, part));
  // What the field asks for itself is not refused.
  CHECK(error(unit_square(), Options().size([](double x, double) { return x < 0.5 ? 1e-3 : 0.1; })).empty());
}

TEST_CASE("A thin box is not refused that the limit of few vertices has room for", "[mesher][budget]") {
  Mesher mesher;
  const auto mesh = mesher(read("thin_box_2500000.poly"));
  CHECK(mesher.report().is_met());
  CHECK(mesh.number_of_triangles() < 2000000);
  CHECK(mesher.report().estimated_triangles < 3 * double(mesh.number_of_triangles()));
  CHECK(mesher.report().estimated_triangles > double(mesh.number_of_triangles()) / 3);
}

TEST_CASE("Vertices units in the last place from a segment do not spoil the estimate", "[mesher][budget]") {
  random_pslg::Builder b;
  b.loop({Point(-4, -4), Point(4, -4), Point(4, 4), Point(-4, 4)});
  const double slope = 0.7;
  const auto from = b.vertex(Point(-3, -3 * slope)), to = b.vertex(Point(3, 3 * slope));
  b.segment(from, to);
  for (int k = -5; k <= 5; ++k) // on either side, or on the segment
    b.vertex(Point(0.3 * k + 0.1, (0.3 * k + 0.1) * slope));
  const Run r = run(b.pslg, Options());
  CHECK(ratio(r) < 4);
  CHECK(ratio(r) > 0.25);
}

TEST_CASE("Sizes that memory cannot hold are refused", "[mesher][budget]") {
  const auto is_refused = [](const Options& options) {
    return has_text(error(unit_square(), options), "for the bounds of size");
  };
  CHECK(is_refused(Options().max_edge(1e-7)));
  CHECK(is_refused(Options().max_area(1e-14)));
  CHECK(is_refused(Options().size([](double, double) { return 1e-7; })));
  // the least edge keeps it small: nothing to refuse
  CHECK(error(unit_square(), Options().max_edge(1e-7).min_edge(0.1)).empty());
}

TEST_CASE("A budget refuses beforehand only what is far beyond it", "[mesher][budget]") {
  const Pslg pslg = parallel_segments(1e-3); // 4000 triangles
  CHECK(has_text(error(pslg, Options().max_vertices(200)), "vertices, and the vertex budget allows 200:"));
  const Run r = run(pslg, Options().max_vertices(1500));
  CHECK(r.report.is_budget_exhausted);
  CHECK(r.report.vertices <= 1500);
}

TEST_CASE("A callback that returns false stops with a valid mesh wherever it does", "[mesher][budget]") {
  const Pslg pslg = read("us_states_10m.poly.gz");
  for (int last = 0; last < 20; last += 3) {
    int calls = 0;
    const Run r = run(pslg, Options().progress([&](double) { return calls++ < last; }));
    CHECK((r.report.is_cancelled || r.report.is_met()));
    CHECK(r.report.unmet_triangles.size() == r.quality.unmet_triangles.size());
  }
}

} // namespace test_quality_mesher_budget
