// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The shells of a leg, beside a list that is searched from end to end; and what a search costs.

#include "catch.h"

#include <CGAL/Quadtree_mesh_2/internal/refinement/Shells.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <vector>

namespace test_shells {

namespace {

namespace internal = CGAL::Quadtree_mesh_2::internal;
using internal::Vertex_id;

/// A number that counts how often it is compared.
struct Counted {
  double value;
  static std::size_t comparisons;
  Counted(double x) : value(x) {}
  friend bool operator<(const Counted& a, const Counted& b) { return ++comparisons, a.value < b.value; }
};
std::size_t Counted::comparisons = 0;

struct Listed {
  double radius;
  Vertex_id vertex;
};

void check_queries(const internal::Shells<double>& shells, const std::vector<Listed>& list, double radius) {
  const auto is_alive = [](Vertex_id v) { return v.value() % 5 != 0; };
  const Vertex_id apex(1000);
  Listed below{0, apex}, above{0, {}};
  for (const Listed& s : list) {
    if (!is_alive(s.vertex)) continue;
    if (s.radius <= radius && s.radius > below.radius) below = s;
    if (s.radius > radius && (!above.vertex.is_valid() || s.radius < above.radius)) above = s;
  }
  const auto around = shells.around(radius, apex, is_alive);
  CHECK((around.below.vertex == below.vertex && around.below.radius == below.radius));
  CHECK((around.above.vertex == above.vertex && around.above.radius == above.radius));
}

} // namespace

TEST_CASE("Shells are found by radius and by vertex", "[shells]") {
  std::mt19937_64 random(GENERATE(1u, 2u, 3u));
  internal::Shells<double> shells;
  std::vector<Listed> list;
  for (const Vertex_id v : internal::Id_range<Vertex_id>(1, 60)) {
    const double radius = std::uniform_real_distribution<double>(1, 2)(random);
    shells.insert(radius, v), list.push_back({radius, v});
    for (const Listed& s : list) {
      REQUIRE(shells.radius_of(s.vertex) == s.radius);
      check_queries(shells, list, s.radius);
    }
    REQUIRE(shells.radius_of(Vertex_id(v.value() + 1)) == -1);
    for (const double r : {0.5, 1.25, 1.5, 1.75, 2.5}) check_queries(shells, list, r);
  }
  // in another mesh, which lacks some
  const auto renamed = [](Vertex_id v) {
    return v.value() % 3 == 0 ? Vertex_id() : Vertex_id(100 - v.value());
  };
  shells.rename(renamed);
  std::size_t alive = 0;
  for (const Listed& s : list) {
    if (!renamed(s.vertex).is_valid()) continue;
    ++alive;
    CHECK(shells.radius_of(renamed(s.vertex)) == s.radius);
  }
  CHECK(static_cast<std::size_t>(std::distance(shells.begin(), shells.end())) == alive);
}

TEST_CASE("A search for a shell takes logarithmic time", "[shells]") {
  internal::Shells<Counted> shells;
  Vertex_id v(0);
  shells.insert(1.0, v);
  Counted::comparisons = 0;
  // intervals are halved level by level, as a segment along the leg asks for
  constexpr int levels = 16;
  for (int level = 1; level <= levels; ++level) {
    const double step = std::ldexp(1.0, -level);
    for (double radius = step; radius < 1; radius += 2 * step) {
      const auto around = shells.around(radius, Vertex_id(), [](Vertex_id) { return true; });
      REQUIRE((shells.radius_of(around.above.vertex).value == radius + step));
      shells.insert(radius, ++v);
    }
  }
  CHECK(v.value() + 1 == 1u << levels);
  CHECK(Counted::comparisons < std::size_t(v) * 8 * levels);
}

} // namespace test_shells
