// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "quadtree_test_inputs.h"

#include <CGAL/Quadtree_mesh_2/internal/frame/points_in_box.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/validate_pslg_2.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace test_points_in_box {

namespace {

using namespace quadtree_test;
using CGAL::Quadtree_mesh_2::internal::box_of_points;
using CGAL::Quadtree_mesh_2::internal::nearest_power_to_spacing;
using CGAL::Quadtree_mesh_2::internal::points_in_box;

/// The points, then the corners and sides of a rectangle that has the points in it.
template <class Point>
void check_graph(const CGAL::Pslg_2<Point>& pslg, const std::vector<Point>& points) {
  const std::size_t n = points.size();
  REQUIRE(pslg.number_of_vertices() == n + 4);
  REQUIRE(pslg.number_of_segments() == 4);
  const auto corner = [&](std::size_t i) { return pslg.vertices[n + i % 4]; };
  CHECK(corner(0).x() < corner(1).x());
  CHECK(corner(0).y() < corner(3).y());
  CHECK(corner(1).x() == corner(2).x());
  CHECK(corner(3).x() == corner(0).x());
  CHECK(corner(0).y() == corner(1).y());
  CHECK(corner(2).y() == corner(3).y());
  bool are_same = true, are_inside = true;
  for (std::size_t i = 0; i < n; ++i) {
    const Point& p = points[i];
    are_same &= pslg.vertices[i] == p;
    are_inside &=
        corner(0).x() <= p.x() && p.x() <= corner(2).x() && corner(0).y() <= p.y() && p.y() <= corner(2).y();
  }
  CHECK(are_same);
  CHECK(are_inside);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(std::size_t(pslg.segments[i][0]) == n + i);
    CHECK(std::size_t(pslg.segments[i][1]) == n + (i + 1) % 4);
  }
}

Input beside_corner_of_range() {
  return {"beside the corner of the range", {{0, 0}, {std::uint64_t(1) << 59, std::uint64_t(5) << 50}}};
}

} // namespace

TEST_CASE("The distance of a box is the power of two next to the spacing", "[points_in_box]") {
  for (double extent : {1e-300, 0.3, 1.0, 1.5, 99.0, 1e300})
    for (std::size_t n : {1u, 2u, 3u, 4u, 10u, 1000u, 4000000000u}) {
      const double power = nearest_power_to_spacing(extent, n);
      CHECK(std::ldexp(1.0, std::ilogb(power)) == power);
      const double quotient = extent / std::sqrt(double(n)) / power;
      CHECK(quotient >= std::sqrt(0.5) * (1 - 1e-12));
      CHECK(quotient <= std::sqrt(2.0) * (1 + 1e-12));
    }
}

TEMPLATE_TEST_CASE("Points in a box are meshed", "[points_in_box]", Filtered_traits, Fixed_32_traits,
                   Fixed_64_traits, Exact_traits) {
  std::vector<Input> inputs = {{"none", {}}, uniform(5, 1), uniform(150, 2), duplicates(4)};
  const std::uint64_t large = std::uint64_t(1) << 56;
  inputs.push_back({"one", {{large, 3 * large}}});
  inputs.push_back({"equal", {{large, large}, {large, large}, {large, large}}});
  inputs.push_back({"two", {{large, large}, {large + 7 * (large >> 5), large}}});
  inputs.push_back(collinear(large / 2, 0));
  inputs.push_back(collinear(large / 3, large / 5));
  inputs.push_back(cocircular());
  inputs.push_back(beside_corner_of_range());
  for (Input& input : inputs) {
    CAPTURE(input.name);
    for (Raw_point& p : input.points) p = {p.x / 2, p.y / 2}; // the mesher's words span 2^61
    const auto points = make_points<TestType>(input);
    const auto pslg = points_in_box(points);
    check_graph(pslg, points);

    CGAL::Quality_mesher_2<TestType> mesher;
    const auto mesh = mesher(pslg);
    CHECK(mesher.report().is_met());
    CHECK(mesher.report().exempt_triangles.empty());
    std::vector<char> is_used(mesh.number_of_vertices(), 0);
    for (const auto& t : mesh.triangles)
      for (const auto v : t) is_used[std::size_t(v)] = 1;
    std::size_t unused = 0;
    for (std::size_t i = 0; i < points.size(); ++i) unused += is_used[i] == 0;
    CHECK(unused <= mesher.report().merged_vertices);
  }
}

TEST_CASE("Boxes of words stay in range", "[points_in_box]") {
  using Point = Fixed_64_traits::Point_2;
  const std::uint64_t end = std::uint64_t(1) << 62, half = end / 2;
  const auto box = [](std::vector<Point> points) { return box_of_points(points); };
  CHECK(box({{0, 0}}).low == Point{0, 0});
  CHECK(box({{end - 1, end - 1}}).high == Point{end - 1, end - 1});
  const auto widest = box({{0, 0}, {half, half}});
  CHECK(widest.low == Point{0, 0});
  CHECK(widest.high == Point{half, half});
  for (const std::uint64_t low : {std::uint64_t(0), std::uint64_t(3), half - 1, half}) {
    const auto wide = box({{low, 7}, {low + half - 5, 9}});
    CHECK(wide.high.x() < end);
    CHECK(wide.high.x() - wide.low.x() <= half);
  }
  using Small = Fixed_32_traits::Point_2;
  const std::vector<Small> small = {{0, 0x7fffffff}, {0x3fffffff, 0x7fffff00}};
  CHECK(box_of_points(small).high.y() < 0x80000000u);
  const std::vector<Small> wide_small = {{0x1000u, 0x1000u}, {0x7f000000u, 0x2000u}};
  CHECK(box_of_points(wide_small).high.x() > 0x7f000000u);
  CHECK(box_of_points(wide_small).low.y() < 0x1000u);
}

TEST_CASE("Boxes of doubles are apart from the points wherever they are", "[points_in_box]") {
  using Point = Filtered_traits::Point_2;
  for (const double x : {0.0, 1e-310, 1.0, -1e15, 1e200, 1e290}) {
    CAPTURE(x);
    const auto box = box_of_points(std::vector<Point>{Point(x, 1), Point(std::nextafter(x, 1e300), 1)});
    CHECK(box.low.x() < x);
    CHECK(box.high.x() > x);
    CHECK(box.low.y() < 1);
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS(CGAL::check_pslg_structure(points_in_box(std::vector<Point>{Point(0, 0), Point(1, none)})));
}

} // namespace test_points_in_box
