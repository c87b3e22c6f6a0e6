// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Sizes at points: what a field of them gives is the least over all points, to the last bit, be they as uneven as
// they may.

#include "catch.h"
#include "random_numbers.h"

#include <CGAL/Points_sizing_field_2.h>
#include <CGAL/Quadtree_mesh_2/internal/grading/Graded_sizes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace test_points_sizing_field_2 {

namespace {

using Field = CGAL::Points_sizing_field_2;
using Point = Field::Sized_point;
using Place = std::array<double, 2>;
using CGAL::Quadtree_mesh_2::internal::Graded_sizes;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Points with sizes over 12 orders of magnitude: clusters within clusters, some all on a line, some twice, and many
/// that others leave without a say.
std::vector<Point> uneven_points(std::uint64_t seed, std::size_t n) {
  Random_numbers random(seed);
  std::vector<Point> points;
  Place center{0, 0};
  double radius = 1;
  while (points.size() < n) {
    if (random() < 0.1) {
      radius = std::pow(10, random.between(-12, 0));
      if (random() < 0.3) center = {random.between(-1, 1), random.between(-1, 1)};
    }
    const double x = center[0] + radius * random.between(-1, 1);
    const double y = seed % 3 == 0 ? x : center[1] + radius * random.between(-1, 1);
    const double size =
        seed % 2 == 0 ? radius * random.between(0.1, 1) : std::pow(10, random.between(-12, 0));
    points.push_back({x, y, size});
    if (seed % 5 == 0) points.push_back(points.back());
  }
  return points;
}

/// Near points, between them, and far from all.
Place random_place(const std::vector<Point>& points, Random_numbers& random) {
  const auto& p = points[static_cast<std::size_t>(random() * double(points.size()))];
  const double reach = std::pow(10, random.between(-13, 3));
  return {p.x + reach * random.between(-1, 1), p.y + reach * random.between(-1, 1)};
}

/// By fields of one point each, so that the same operations are rounded.
double least_of_all(const std::vector<Point>& points, double gradation, const Place& place) {
  double least = infinity;
  for (const Point& p : points) least = std::min(least, Field({p}, gradation)(place[0], place[1]));
  return least;
}

double gradation_of(std::uint64_t seed, Random_numbers& random) {
  return seed % 4 == 0 ? 0 : seed % 4 == 1 ? 1 : random.between(0, 2);
}

} // namespace

TEST_CASE("The size field of points is the least over all points", "[mesher][sizes]") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random_numbers random(seed);
    const double gradation = gradation_of(seed, random);
    const auto points = uneven_points(seed, 1 + static_cast<std::size_t>(random() * (seed < 20 ? 20 : 600)));
    const Field field(points, gradation);
    for (int i = 0; i < 100; ++i) {
      const Place p = random_place(points, random);
      const double size = least_of_all(points, gradation, p);
      CHECK(field(p[0], p[1]) == size);
      for (const double most : {size / 2, size, 2 * size})
        CHECK(field(p[0], p[1], most) == std::min(size, most));
      double definition = infinity;
      for (const Point& q : points)
        definition = std::min(definition, q.size + gradation * std::hypot(q.x - p[0], q.y - p[1]));
      CHECK(size == Approx(definition).epsilon(1e-14));
    }
  }
}

TEST_CASE("The size at a triangle's corners is the least of theirs", "[mesher][sizes]") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random_numbers random(seed);
    const auto points = uneven_points(seed, 500);
    const Field field(points, gradation_of(seed, random));
    for (int i = 0; i < 500; ++i) {
      std::array<Place, 3> corners;
      corners[0] = random_place(points, random);
      const double length = std::pow(10, random.between(-12, 1));
      for (std::size_t k : {1, 2})
        for (std::size_t axis : {0, 1}) corners[k][axis] = corners[0][axis] + length * random.between(-1, 1);
      double size = infinity;
      for (const auto& [x, y] : corners) size = std::min(size, field(x, y));
      for (const double most : {size / 2, size, 2 * size, infinity})
        CHECK(field.least(corners, most) == std::min(size, most));
    }
  }
}

TEST_CASE("Sizes of points added one after the other are those of all", "[gradation]") {
  const auto points = uneven_points(7, 800);
  Graded_sizes sizes(0.3);
  Random_numbers random(1);
  CHECK(sizes.least({}, 5) == 5);
  CHECK_FALSE(sizes.dominate(points[0]));
  CHECK_FALSE(sizes.is_less_by_last({}, 5));
  std::vector<Point> so_far;
  for (std::size_t begin = 0; begin < points.size(); begin += 200) {
    const std::vector<Point> some(points.begin() + std::ptrdiff_t(begin),
                                  points.begin() + std::ptrdiff_t(begin) + 200);
    sizes.add(some), so_far.insert(so_far.end(), some.begin(), some.end());
    for (int i = 0; i < 50; ++i) {
      const Place p = random_place(points, random);
      const double size = least_of_all(so_far, 0.3, p), by_last = least_of_all(some, 0.3, p);
      CHECK(sizes.least({p, p, p}, infinity) == size);
      CHECK(sizes.dominate({p[0], p[1], 1.1 * size}));
      CHECK_FALSE(sizes.dominate({p[0], p[1], size}));
      CHECK(sizes.is_less_by_last(p, 1.1 * by_last));
      CHECK_FALSE(sizes.is_less_by_last(p, by_last));
    }
  }
}

TEST_CASE("Zones hold triangles with a corner in them", "[gradation]") {
  Graded_sizes sizes(1);
  CHECK_FALSE(sizes.is_any_in_zone({}));
  sizes.set_zones({{{0, 0}, 1}, {{9, 9}, 1e-6}});
  CHECK(sizes.is_any_in_zone({{{5, 5}, {0.9, 0}, {6, 6}}}));
  CHECK(sizes.is_any_in_zone({{{5, 5}, {4, 4}, {9, 9 + 9e-7}}}));
  CHECK_FALSE(sizes.is_any_in_zone({{{1.1, 0}, {0, -1.1}, {9, 9 + 2e-6}}}));
  sizes.set_zones({});
  CHECK_FALSE(sizes.is_any_in_zone({}));
}

TEST_CASE("A size field of points refuses what has no size", "[mesher][sizes]") {
  CHECK_THROWS_AS(Field({}), std::invalid_argument);
  CHECK_THROWS_AS(Field({{0, 0, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(Field({{0, std::nan(""), 1}}), std::invalid_argument);
  CHECK_THROWS_AS(Field({{0, 0, 1}}, -1), std::invalid_argument);
}

} // namespace test_points_sizing_field_2
