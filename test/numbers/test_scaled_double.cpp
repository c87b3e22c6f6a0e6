// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Doubles with exponents of their own, against rationals.

#include "catch.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Scaled_double.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace test_scaled_double {

namespace {

using Field = CGAL::Exact_rational;
using CGAL::Quadtree_mesh_2::internal::Scaled_double;

Field power(int k) { return CGAL::Quadtree_mesh_2::internal::power_of_two<Field>(k); }
Field magnitude(const Field& v) { return v < 0 ? Field(-v) : v; }

/// Up to three units in the last place of the magnitude.
bool is_rounded(const Scaled_double& a, const Field& b, const Field& largest) {
  return magnitude(a.exact<Field>() - b) <= largest * power(-51);
}

} // namespace

TEST_CASE("scaled doubles compute like rationals, rounded, at any size", "[scaled]") {
  std::vector<Scaled_double> numbers{0., 1., -1.};
  for (const int k :
       {-20000, -5000, -1100, -769, -768, -512, -257, -256, -255, 0, 255, 256, 257, 511, 768, 1030, 9000})
    for (const double v : {1., 1.75, -0.3}) numbers.push_back(Scaled_double::scaled(v, k));
  for (const Scaled_double& a : numbers) {
    const Field x = a.exact<Field>();
    CHECK(is_rounded(Scaled_double::of(x), x, magnitude(x)));
    if (magnitude(x) < power(1000) && magnitude(x) > power(-1000)) {
      CHECK(Field(a.to_double()) == x);
      CHECK(Scaled_double(a.to_double()) == a);
    }
    if (x > 0) {
      CHECK(is_rounded(sqrt(a) * sqrt(a), x, x));
      CHECK(power(ilogb(a)) <= x);
      CHECK(x < power(ilogb(a) + 1));
      CHECK(std::fabs(log(a) - ilogb(a) * std::log(2.)) < 1);
    }
    for (const Scaled_double& b : numbers) {
      const Field y = b.exact<Field>();
      CHECK((a < b) == (x < y));
      CHECK((a == b) == (x == y));
      CHECK((a <= b) == (x <= y));
      const Field larger = magnitude(x) < magnitude(y) ? magnitude(y) : magnitude(x);
      CHECK(is_rounded(a + b, x + y, larger));
      CHECK(is_rounded(a - b, x - y, larger));
      CHECK(is_rounded(a * b, x * y, magnitude(x * y)));
      if (!b.is_zero()) CHECK(is_rounded(a / b, x / y, magnitude(x / y)));
    }
  }
}

} // namespace test_scaled_double
