// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The work of filling the bulk and of refining what is left, counted in predicates.

#include "catch.h"
#include "graph_state.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Corner_finder.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Refiner.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Size_estimate.h>
#include <CGAL/Quadtree_mesh_2/internal/squares/Bulk_filler.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_bulk_filler {

namespace {

struct Counting_kernel : CGAL::Exact_predicates_inexact_constructions_kernel {
  inline static std::size_t predicates = 0;
};

} // namespace

} // namespace test_bulk_filler

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Counts the steps of walks and the sides looked at for flips.
template <>
struct Double_geometry_2<test_bulk_filler::Counting_kernel>
    : Double_geometry_2<Exact_predicates_inexact_constructions_kernel> {
  using Base = Double_geometry_2<Exact_predicates_inexact_constructions_kernel>;

  static int orientation(Point a, Point b, Point c) {
    ++test_bulk_filler::Counting_kernel::predicates;
    return Base::orientation(a, b, c);
  }
  static bool is_certainly_in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
    ++test_bulk_filler::Counting_kernel::predicates;
    return Base::is_certainly_in_circle(a, b, c, d);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

namespace test_bulk_filler {

namespace {

using namespace CGAL::Quadtree_mesh_2::internal;
using Geometry = Double_geometry_2<Counting_kernel>;
using Point = Geometry::Point;

/// Meshes the inside of a polygon with a bound of area, which makes a bulk.
/// \returns the predicates asked for each triangle
double predicates_per_triangle(const std::vector<Point>& polygon, double area) {
  Meshing_problem<Geometry> problem;
  Meshing_state<Geometry> state(problem);
  std::vector<std::array<std::size_t, 2>> segments;
  graph_state_test::append_loop(segments, 0, polygon.size());
  graph_state_test::triangulate(polygon, segments, problem, state);
  problem.bounds = Bounds<Geometry>(20.7 * radians_per_degree, area, 0);
  Size_estimate<Geometry> estimate(state, CGAL::Sequential_tag());
  Corner_finder<CGAL::Sequential_tag, Geometry>(state, estimate.take_acute_starts()).run();
  Splitter<Geometry> splitter(state);
  Refiner<Geometry> refiner(state, splitter);
  splitter.cut_rings();
  constexpr std::size_t budget = 10000000;
  Counting_kernel::predicates = 0;
  Bulk_filler<CGAL::Sequential_tag, Geometry>(state, splitter).run(budget);
  CHECK(state.bulk.number_of_triangles() > 0);
  refiner.push_all();
  CHECK(refiner.run({budget}, [] { return true; }) == Refinement_end::DONE);
  return static_cast<double>(Counting_kernel::predicates) /
         static_cast<double>(state.mesh.number_of_triangles());
}

std::vector<Point> box(double length) { return {{0, 0}, {length, 0}, {length, 1}, {0, 1}}; }

/// A base with teeth of width 1 and the given length.
std::vector<Point> comb(int teeth, double length) {
  std::vector<Point> p = {{0, 0}, {2.0 * teeth, 0}, {2.0 * teeth, 1}};
  for (int i = teeth - 1; i >= 0; --i)
    for (const Point corner : {Point{1.5, 1}, Point{1.5, 1 + length}, Point{0.5, 1 + length}, Point{0.5, 1}})
      p.push_back({2 * i + corner.x, corner.y});
  p.push_back({0, 1});
  return p;
}

/// A strip of width 1 along an Archimedean spiral.
std::vector<Point> spiral(int turns, int corners_of_turn) {
  std::vector<Point> p;
  const int n = turns * corners_of_turn;
  const auto add = [&](int i, double shift) {
    const double angle = 2 * CGAL_PI * i / corners_of_turn, r = 3 + 1.5 * i / corners_of_turn + shift;
    p.push_back({r * std::cos(angle), r * std::sin(angle)});
  };
  for (int i = 0; i <= n; ++i) add(i, 1);
  for (int i = n; i >= 0; --i) add(i, 0);
  return p;
}

} // namespace

TEST_CASE("A bulk with a long border takes work linear in its size", "[bulk]") {
  constexpr double area = 0.02, growth = 1.2;
  const int more = is_full_run() ? 20 : 4;
  const double of_comb = predicates_per_triangle(comb(10, 50), area);
  CHECK(predicates_per_triangle(box(500 * more), area) < growth * predicates_per_triangle(box(500), area));
  CHECK(predicates_per_triangle(comb(10, 50 * more), area) < growth * of_comb);
  CHECK(predicates_per_triangle(comb(10 * more, 50), area) < growth * of_comb);
  CHECK(predicates_per_triangle(spiral(is_full_run() ? 30 : 16, 24), area) <
        growth * predicates_per_triangle(spiral(8, 24), area));
}

} // namespace test_bulk_filler
