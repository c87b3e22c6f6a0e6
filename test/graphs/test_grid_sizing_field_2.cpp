// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Grids of sizes: places without a bound, and the limit on the gradient, against brute force.

#include "catch.h"
#include "random_numbers.h"

#include <CGAL/Grid_sizing_field_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace test_grid_sizing_field_2 {

namespace {

using Grid = CGAL::Grid_sizing_field_2;
constexpr double no_bound = std::numeric_limits<double>::infinity();

struct Data {
  std::array<double, 2> origin, spacing;
  std::size_t columns, rows;
  std::vector<double> sizes;

  Grid grid() const { return Grid(origin, spacing, columns, rows, sizes); }
  double x(std::size_t n) const { return origin[0] + static_cast<double>(n % columns) * spacing[0]; }
  double y(std::size_t n) const { return origin[1] + static_cast<double>(n / columns) * spacing[1]; }
};

/// Sizes over four orders of magnitude, some of them without a bound; grids of one row, one column, one place.
Data random_data(std::uint64_t seed) {
  Random_numbers random(seed);
  const auto number = [&](int most) { return 1 + static_cast<std::size_t>(random() * most); };
  Data data{{0, 0}, {1, seed % 2 == 0 ? 1 : random.between(0.1, 3)}, number(12), number(12), {}};
  if (seed % 5 == 1) data.rows = 1;
  if (seed % 5 == 2) data.columns = 1;
  if (seed % 4 == 3) data.origin = {random.between(-9, 9), random.between(-9, 9)};
  const double share_without = seed % 3 == 0 ? random() : 0;
  for (std::size_t n = data.columns * data.rows; n > 0; --n)
    data.sizes.push_back(random() < share_without ? no_bound : std::pow(10, random.between(-2, 2)));
  return data;
}

/// The size at (x, y) by the definition: each place of the grid with its share, those without a bound left out.
double by_definition(const Data& data, double x, double y) {
  const auto inside = [](double place, double origin, double spacing, std::size_t count) {
    return std::min(std::max((place - origin) / spacing, 0.0), static_cast<double>(count - 1));
  };
  const double column = inside(x, data.origin[0], data.spacing[0], data.columns);
  const double row = inside(y, data.origin[1], data.spacing[1], data.rows);
  double sum = 0, weight = 0, nearest = no_bound, size_there = no_bound;
  for (std::size_t n = 0; n < data.sizes.size(); ++n) {
    const double dx = std::fabs(static_cast<double>(n % data.columns) - column);
    const double dy = std::fabs(static_cast<double>(n / data.columns) - row);
    const double share = std::max(0.0, 1 - dx) * std::max(0.0, 1 - dy), distance = std::max(dx, dy);
    if (distance < nearest) nearest = distance, size_there = data.sizes[n];
    if (share > 0 && std::isfinite(data.sizes[n])) sum += share * data.sizes[n], weight += share;
  }
  return nearest <= 0.5 && std::isfinite(size_there) ? sum / weight : no_bound;
}

double least_bound(const Data& data, double gradient, std::size_t n) {
  double least = no_bound;
  for (std::size_t m = 0; m < data.sizes.size(); ++m)
    least =
        std::min(least, data.sizes[m] + gradient * std::hypot(data.x(m) - data.x(n), data.y(m) - data.y(n)));
  return least;
}

} // namespace

TEST_CASE("Infinite sizes on a grid are no bound around them", "[sizes]") {
  const Grid row({0, 0}, {1, 1}, 3, 1, {2, no_bound, 4});
  CHECK(row(0, 0) == 2);
  CHECK(row(0.49, 5) == 2);
  CHECK(row(0.51, 5) == no_bound);
  CHECK(row(1, 0) == no_bound);
  CHECK(row(1.51, 0) == 4);
  CHECK(row(7, 0) == 4);
  CHECK(Grid({0, 0}, {1, 1}, 1, 1, {no_bound})(3, 4) == no_bound);
  CHECK_THROWS_AS(Grid({0, 0}, {1, 1}, 2, 1, {1, std::nan("")}), std::invalid_argument);
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    const Data data = random_data(seed);
    const Grid grid = data.grid();
    Random_numbers random(seed);
    for (int i = 0; i < 100; ++i) {
      const double x = data.origin[0] + random.between(-1, 13), y = data.origin[1] + random.between(-1, 13);
      const double expected = by_definition(data, x, y);
      if (std::isfinite(expected))
        CHECK(grid(x, y) == Approx(expected).epsilon(1e-9));
      else
        CHECK(grid(x, y) == no_bound);
    }
  }
}

TEST_CASE("A limited grid has the largest sizes with the gradient", "[sizes]") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    const Data data = random_data(seed);
    Random_numbers random(seed);
    const double gradient = seed % 7 == 0 ? 0 : random.between(0, 2);
    Grid grid = data.grid();
    CHECK(&grid.limit_gradient(gradient) == &grid);
    Data limited = data;
    for (std::size_t n = 0; n < data.sizes.size(); ++n) {
      limited.sizes[n] = grid(data.x(n), data.y(n));
      const double expected = least_bound(data, gradient, n);
      if (std::isfinite(expected))
        CHECK(limited.sizes[n] == Approx(expected).epsilon(1e-9));
      else
        CHECK(limited.sizes[n] == no_bound);
      CHECK(limited.sizes[n] <= data.sizes[n] * (1 + 1e-9)); // the place itself is rounded
    }
  }
}

TEST_CASE("Between places of a limited grid sizes grow little faster", "[sizes]") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Data data = random_data(seed);
    Random_numbers random(seed);
    const double gradient = random.between(0.05, 1);
    const bool is_line = data.rows == 1 || data.columns == 1;
    const double most = gradient * (is_line ? 1 : std::sqrt(2.0)) * (1 + 1e-9);
    Grid grid = data.grid();
    grid.limit_gradient(gradient);
    if (!std::isfinite(grid(0, 0))) continue; // nothing has a bound
    const auto place = [&] {
      return std::array<double, 2>{data.origin[0] + random.between(-1, 13),
                                   data.origin[1] + random.between(-1, 13)};
    };
    for (int i = 0; i < 500; ++i) {
      const auto p = place();
      auto q = place();
      if (i % 2 == 0) q = {p[0] + (q[0] - p[0]) * 1e-3, p[1] + (q[1] - p[1]) * 1e-3}; // near each other, too
      const double rise = std::fabs(grid(p[0], p[1]) - grid(q[0], q[1]));
      if (rise > most * std::hypot(p[0] - q[0], p[1] - q[1]) + 1e-12)
        FAIL_CHECK("seed " << seed << ", pair " << i);
    }
  }
}

TEST_CASE("Limits of gradients", "[sizes]") {
  Grid grid({0, 0}, {1, 1}, 3, 1, {1, 100, no_bound});
  CHECK_THROWS_AS(grid.limit_gradient(-1), std::invalid_argument);
  CHECK_THROWS_AS(grid.limit_gradient(std::nan("")), std::invalid_argument);
  CHECK_THROWS_AS(grid.limit_gradient(no_bound), std::invalid_argument);
  CHECK(grid(1, 0) == 100); // unchanged
  CHECK(grid.limit_gradient(0.25)(2, 0) == 1.5);
  CHECK(grid(1, 0) == 1.25);
  CHECK(grid.limit_gradient(0)(2, 0) == 1);
  CHECK(Grid({0, 0}, {1, 1}, 1, 1, {no_bound}).limit_gradient(1)(0, 0) == no_bound);
  // Far from the origin of coordinates no digits are lost: places are told apart by their columns.
  Grid far({1e12, 1e12}, {1e-3, 1e-3}, 3, 1, {1, 100, 100});
  CHECK(far.limit_gradient(0.5)(1e12 + 1, 1e12) == Approx(1.001).epsilon(1e-12));
}

} // namespace test_grid_sizing_field_2
