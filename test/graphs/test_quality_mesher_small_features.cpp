// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Features as small as coordinates can tell: the bound is met wherever they leave room for a vertex, and no triangle is
// clockwise or flat where they do not.

#include "mesher_test_tools.h"

#include <CGAL/Fixed_point_quadtree_traits_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace test_quality_mesher_small_features {

using namespace mesher_test;

namespace {

using Point = pslg_test::Pslg::Point_2;
using Reason = CGAL::Quality_mesh_report_2::Reason;
using Traits_of_words = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
using Word_point = Traits_of_words::Point_2;

Options to_the_bound() { return Options().min_angle(20.7); }

double unit_in_the_last_place(double x) {
  const double magnitude = std::fabs(x);
  return std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
}

/// The shortest side of a triangle or its height above the longest, whichever is less, in units in the last place of
/// its coordinates.
double least_width_in_units(const Mesh& mesh, std::size_t t) {
  double unit = 0, shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &p = mesh.point(mesh.triangles[t][k]), &q = mesh.point(mesh.triangles[t][(k + 1) % 3]);
    unit = std::max({unit, unit_in_the_last_place(p.x()), unit_in_the_last_place(p.y())});
    const double length = std::hypot(q.x() - p.x(), q.y() - p.y());
    shortest = std::min(shortest, length), longest = std::max(longest, length);
  }
  const Point &a = mesh.point(mesh.triangles[t][0]), &b = mesh.point(mesh.triangles[t][1]),
              &c = mesh.point(mesh.triangles[t][2]);
  const double area2 = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  return std::min(shortest, std::fabs(area2) / longest) / unit;
}

/// Checks that whatever is left unmet is so near to the limit of coordinates that a vertex has no place.
void check_reasons(const Run& r) {
  constexpr double most_units = 64;
  for (const auto& unmet : r.report.unmet_triangles) {
    CHECK(unmet.reason == Reason::COORDINATES);
    CHECK(least_width_in_units(r.mesh, std::size_t(unmet.triangle)) < most_units);
  }
}

Pslg unit_box() {
  Pslg pslg;
  const auto a = pslg.add_vertex(Point(0, 0)), b = pslg.add_vertex(Point(1, 0)),
             c = pslg.add_vertex(Point(1, 1)), d = pslg.add_vertex(Point(0, 1));
  pslg.add_segment(a, b), pslg.add_segment(b, c), pslg.add_segment(c, d), pslg.add_segment(d, a);
  return pslg;
}

using Random = std::mt19937_64;
double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A polygon of 1 to 5 vertices about a place of the box, `size` in diameter; open, closed, or of vertices only.
void add_small_feature(Pslg& pslg, double size, Random& random) {
  const double x = uniform(random, 0.1, 0.9), y = uniform(random, 0.1, 0.9), turn = uniform(random, 0, 6);
  const int n = 2 + static_cast<int>(random() % 4), kind = static_cast<int>(random() % 3);
  std::vector<CGAL::Quadtree_mesh_2::Vertex_index> v;
  for (int i = 0; i < n; ++i) {
    const double angle = turn + 2 * CGAL_PI * i / n;
    v.push_back(pslg.add_vertex(Point(x + size / 2 * std::cos(angle), y + size / 2 * std::sin(angle))));
  }
  for (std::size_t i = 0; kind > 0 && i + 1 < v.size(); ++i) pslg.add_segment(v[i], v[i + 1]);
  if (kind > 1 && n > 2) pslg.add_segment(v.back(), v.front());
}

/// In words with 61 bits for the extent.
CGAL::Pslg_2<Word_point> in_words(const Pslg& pslg) {
  const auto scale = CGAL::Fixed_point_scale_2<std::uint64_t>::of_points(pslg.vertices);
  CGAL::Pslg_2<Word_point> words;
  for (const Point& p : pslg.vertices) words.add_vertex(scale.to_fixed(p.x(), p.y()));
  words.segments = pslg.segments;
  return words;
}

__extension__ using Wide = __int128;
bool is_counterclockwise(const Word_point& a, const Word_point& b, const Word_point& c) {
  return (Wide(b.x()) - Wide(a.x())) * (Wide(c.y()) - Wide(a.y())) >
         (Wide(b.y()) - Wide(a.y())) * (Wide(c.x()) - Wide(a.x()));
}

void check_words(const Pslg& pslg) {
  CGAL::Quality_mesher_2<Traits_of_words> mesher(to_the_bound());
  const auto mesh = mesher(in_words(pslg));
  CHECK(mesher.report().is_met());
  std::size_t wrong = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    wrong += is_counterclockwise(mesh.point(a), mesh.point(b), mesh.point(c)) ? 0 : 1;
  CHECK(wrong == 0);
}

} // namespace

TEST_CASE("Features of 2^-40 of the extent are meshed to the bound", "[mesher][small]") {
  for (const char* name :
       {"hard_near_pair_2e-40.poly", "hard_tiny_square.poly", "hard_inverted_near_end.poly"}) {
    INFO(name);
    const Pslg pslg = read(name);
    run_to_the_bound(pslg, to_the_bound());
    check_words(pslg);
  }
}

TEST_CASE("Isolated features of any size that coordinates tell are meshed to the bound", "[mesher][small]") {
  const int runs = is_full_run() ? 10000 : 50;
  for (int seed = 0; seed < runs; ++seed) {
    INFO("seed " << seed);
    Random random(static_cast<std::uint64_t>(seed));
    Pslg pslg = unit_box();
    add_small_feature(pslg, std::exp2(-uniform(random, 20, 45)), random);
    run_to_the_bound(pslg, to_the_bound());
    check_words(pslg);
  }
}

TEST_CASE("Vertices some units in the last place from a segment leave a valid mesh", "[mesher][small]") {
  const int runs = is_full_run() ? 10000 : 100;
  for (int seed = 0; seed < runs; ++seed) {
    INFO("seed " << seed);
    Random random(static_cast<std::uint64_t>(seed));
    Pslg pslg = unit_box();
    const double y0 = uniform(random, 0.1, 0.9), y1 = uniform(random, 0.1, 0.9);
    const auto a = pslg.add_vertex(Point(0.2, y0)), b = pslg.add_vertex(Point(0.8, y1));
    pslg.add_segment(a, b);
    for (const double share : {0.25, 0.75}) {
      const double y = y0 + share * (y1 - y0);
      const auto units = static_cast<double>(1 + random() % 100) * unit_in_the_last_place(y);
      pslg.add_vertex(Point(0.2 + share * 0.6, random() % 2 == 0 ? y + units : y - units));
    }
    check_reasons(run(pslg, to_the_bound()));
  }
}

TEST_CASE("Features next to a leg, far from its apex, may be as small as coordinates tell",
          "[mesher][small]") {
  for (const char* name :
       {"hard_vertex_at_far_end_of_leg.poly", "hard_vertex_beside_leg.poly", "hard_tips_of_legs.poly"}) {
    INFO(name);
    run_to_the_bound(read(name), to_the_bound());
  }
}

TEST_CASE(
    "Triangles in a corner on segments that run through its apex are exempt for mesher and checker alike",
    "[mesher][small]") {
  for (const char* name : {"hard_segment_through_apex.poly", "hard_segments_through_a_vertex.poly"}) {
    INFO(name);
    const Run r = run(read(name), to_the_bound());
    CHECK(r.report.exempt_triangles.size() > 0);
    CHECK(r.report.exempt_triangles.size() == r.quality.exempt_triangles);
    CHECK(r.report.unmet_triangles.size() == r.quality.unmet_triangles.size());
    check_reasons(r);
  }
}

TEST_CASE("Rounded vertices of the border keep clear of what is outside", "[mesher][small]") {
  run_to_the_bound(read("hard_wedge_outside.poly"), to_the_bound());
  for (const double longest : {0.3, 0.03}) {
    INFO("edges of at most " << longest);
    const Run r = run(read("hard_wedge_outside_cut_finely.poly"), to_the_bound().max_edge(longest));
    for (const auto& unmet : r.report.unmet_triangles) CHECK(unmet.reason == Reason::COORDINATES);
  }
}

TEST_CASE("Between edges within rounding of each other nothing but triangles without room is left",
          "[mesher][small]") {
  for (const char* name : {"hard_overlap_on_border.poly", "hard_overlap_beside_border.poly"}) {
    INFO(name);
    const Run r = run(read(name), to_the_bound());
    CHECK_FALSE(r.report.is_budget_exhausted);
    check_reasons(r);
  }
}

TEST_CASE("Triangles without room may all be gone when there is more", "[mesher][small]") {
  check_reasons(run(read("hard_refused_are_gone.poly"), to_the_bound().max_edge(8.68065)));
}

TEST_CASE("A square of two units in the last place is meshed", "[mesher][small]") {
  const Run r = run(read("hard_square_of_ulps.poly"), to_the_bound());
  CHECK(r.report.triangles == 2);
}

TEST_CASE("A feature at a leg's far end finds none at the same radius on other legs", "[mesher][small]") {
  run_to_the_bound(read("hard_far_end_beside_apex.poly"), to_the_bound());
}

TEST_CASE("Legs as near as their ends are cut at the same radii", "[mesher][small]") {
  const Run r = run(read("hard_legs_end_beside.poly"), to_the_bound());
  constexpr double angle = 7.3e-13, unit = 0x1p-50, least_room = 256; // between the legs, at their apex
  for (const auto& unmet : r.report.unmet_triangles) {
    CHECK(unmet.reason == Reason::COORDINATES);
    CHECK(std::hypot(unmet.centroid[0] - 4, unmet.centroid[1] - 3) * angle < least_room * unit);
  }
}

TEST_CASE("Subnormal coordinates are kept", "[mesher][small]") {
  const Pslg pslg = read("subnormal_vertices.poly");
  const Run r = run_to_the_bound(pslg, to_the_bound());
  for (std::size_t v = 0; v < pslg.vertices.size(); ++v) CHECK(r.mesh.points[v] == pslg.vertices[v]);
  const Run half = run_to_the_bound(read("subnormal_hole.poly"), to_the_bound());
  for (const auto& t : half.mesh.triangles)
    for (const auto v : t) CHECK(half.mesh.point(v).x() <= 0); // the hole takes the half to the right
}

TEST_CASE("An edge of one unit in the last place is all that is left unmet", "[mesher][small]") {
  const Run r = run(read("hard_cgal781_tiny_edge.poly"), to_the_bound());
  CHECK(r.report.unmet_triangles.size() <= 1);
  check_reasons(r);
}

TEST_CASE("Vertices nearer than angles can be compared are refused by their names", "[mesher][small]") {
  for (const char* name : {"hard_spiral_to_2e-899.poly", "subnormal_beside_segment.poly"}) {
    INFO(name);
    const Pslg pslg = read(name);
    Mesher mesher(to_the_bound());
    try {
      mesher(pslg);
      FAIL("not refused");
    } catch (const CGAL::Pslg_error_2& error) {
      const std::string text = error.what();
      CHECK(text.find("vertex ") != std::string::npos);
      CHECK(text.find("2^-420 of the extent") != std::string::npos);
    }
  }
}

TEST_CASE("A spiral to 2^-400 of the extent is meshed to the bound", "[mesher][small]") {
  const Pslg whole = read("hard_spiral_to_2e-899.poly");
  Pslg part;
  for (const Point& p : whole.vertices)
    if (std::max(std::fabs(p.x()), std::fabs(p.y())) > 0x1p-400) part.add_vertex(p);
  const std::size_t n = part.vertices.size();
  for (std::size_t k = 0; k < 4; ++k) // the square around it, its last vertices
    part.add_segment(CGAL::Quadtree_mesh_2::Vertex_index(n - 4 + k),
                     CGAL::Quadtree_mesh_2::Vertex_index(n - 4 + (k + 1) % 4));
  run_to_the_bound(part, to_the_bound());
}

} // namespace test_quality_mesher_small_features
