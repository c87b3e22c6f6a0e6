// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Least angles of the column rule: proven by column_certificates.h for all edges, and looked at for random ones.

#include "catch.h"
#include "column_certificates.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/columns/Column_window.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

namespace test_column_rule {

namespace {

using namespace CGAL::Quadtree_mesh_2::internal;
using namespace column_certificates;

void check(const Certificate& c) {
  CAPTURE(c.number_of_boxes, c.least_side, grid);
  CHECK(c.is_proven);
  if (is_full_run()) WARN(c.number_of_boxes << " boxes, least side 1/" << grid / c.least_side);
}

double least_angle_by_cgal(const Column_window& window) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  CGAL::Delaunay_triangulation_2<Kernel> triangulation;
  for (std::size_t v = 0; v < window.number_of_vertices(); ++v)
    triangulation.insert(Point(window.point(v).x, window.point(v).y));
  double least = 180;
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    if (triangulation.triangle(f).area() < 1e-9) continue; // three points on the edge
    for (int i = 0; i < 3; ++i) {
      const auto u = f->vertex((i + 1) % 3)->point() - f->vertex(i)->point(),
                 v = f->vertex((i + 2) % 3)->point() - f->vertex(i)->point();
      least = std::min(least, std::acos(u * v / std::sqrt(u.squared_length() * v.squared_length())));
    }
  }
  return least * 180 / CGAL_PI;
}

struct Random_line {
  std::mt19937_64 generator{5};
  Window_line operator()() {
    std::uniform_real_distribution<double> slope(-1, 1), offset(0, 1);
    // Every fourth with rational numbers, where many points are cocircular.
    if (generator() % 4 == 0) return {double(generator() % 9) / 4 - 1, double(generator() % 8) / 8};
    return {slope(generator), offset(generator)};
  }
};

} // namespace

TEST_CASE("Thresholds belong to places", "[columns]") {
  const Transition_thresholds& t = rule_c;
  const auto least = [&](int widths, Column_corner corner) {
    return least_distance(column_place(widths, corner), t, Opposite_corners::BOTH_KEPT);
  };
  CHECK(least(-2, Column_corner::OF_COARSE_LEAF) == t.before);
  CHECK(least(0, Column_corner::OF_COARSE_LEAF) == t.coarse);
  CHECK(least(0, Column_corner::OF_FINE_LEAVES) == t.hanging);
  CHECK(least(1, Column_corner::OF_FINE_LEAVES) == t.half);
  CHECK(least(2, Column_corner::OF_FINE_LEAVES) == t.one);
  for (const int widths : {-4, 3, 4})
    CHECK(least(widths, Column_corner::OF_FINE_LEAVES) == equal_leaves_threshold);
  // Whichever is larger.
  CHECK(least_distance(Column_place::HANGING, rule_b, Opposite_corners::NOT_BOTH_KEPT) == rule_b.middle);
  CHECK(least_distance(Column_place::HANGING, rule_c, Opposite_corners::NOT_BOTH_KEPT) == rule_c.hanging);
  CHECK_FALSE(CGAL::Quadtree_mesh_2::internal::is_kept(0.62, Column_place::EQUAL_LEAVES, t));
  CHECK(CGAL::Quadtree_mesh_2::internal::is_kept(0.625, Column_place::EQUAL_LEAVES, t));
}

TEST_CASE("Edges are mirrored into the window", "[columns]") {
  const auto same = [](const Window_line& l, double slope, double offset) {
    return l.slope == slope && l.offset == offset;
  };
  CHECK(same(window_line(0.5, 3.25, Fine_side::GREATER, Edge_side::ABOVE), 0.5, 0.25));
  CHECK(same(window_line(0.5, 3.25, Fine_side::LESS, Edge_side::ABOVE), -0.5, 0.25));
  CHECK(same(window_line(0.5, 3.25, Fine_side::GREATER, Edge_side::BELOW), -0.5, 0.75));
  CHECK(same(window_line(0.5, -3.25, Fine_side::LESS, Edge_side::BELOW), 0.5, 0.25));
}

TEST_CASE("Through equal leaves all angles are at least 31.6 degrees", "[columns]") {
  check(certify_equal_leaves(31.6));
  CHECK_FALSE(certify_equal_leaves(31.8).is_proven); // less is possible
}

TEST_CASE("At changes of sizes one vector of thresholds keeps 21.5 degrees", "[columns]") {
  if (is_full_run()) check(certify_transitions({one_rule}, 18.434948));
  if (is_full_run()) check(certify_transitions({one_rule}, 20.7));
  check(certify_transitions({one_rule}, 21.5));
  CHECK_FALSE(certify_transitions({one_rule}, 21.7).is_proven);
}

TEST_CASE("At changes of sizes the better of two vectors keeps 26.3 degrees", "[columns]") {
  if (is_full_run()) check(certify_transitions({rule_b, rule_c}, 25));
  check(certify_transitions({rule_b, rule_c}, 26.3));
  // Neither of them is good enough without the other.
  CHECK_FALSE(certify_transitions({rule_b}, 20.7).is_proven);
  CHECK_FALSE(certify_transitions({rule_c}, 20.7).is_proven);
}

TEST_CASE("Windows have the angles of the Delaunay triangulation", "[columns]") {
  Random_line random_line;
  const int n = is_full_run() ? 100000 : 500;
  double least = 90, least_of_better = 90;
  for (int i = 0; i < n; ++i) {
    const Window_line line = random_line();
    CAPTURE(line.slope, line.offset);
    for (const Transition_thresholds& t : {one_rule, rule_b, rule_c}) {
      const Column_window window(t, line);
      REQUIRE(window.least_angle() == Approx(least_angle_by_cgal(window)).margin(1e-5));
    }
    least = std::min(least, least_angle_in_window(one_rule, line.slope, line.offset));
    const Transition_thresholds& better = better_of(rule_b, rule_c, line.slope, line.offset);
    least_of_better = std::min(least_of_better, least_angle_in_window(better, line.slope, line.offset));
  }
  CHECK(least >= 21.5);
  CHECK(least_of_better >= 26.3);
  if (is_full_run()) WARN("least angles of random edges: " << least << ", " << least_of_better);
}

} // namespace test_column_rule
