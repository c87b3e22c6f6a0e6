// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Vertices at which half of all edges of the first triangulation meet: corners of boxes around points in convex
// position or on a line, hubs of fans. Work that is quadratic in their degree would take minutes here.

#include "catch.h"
#include "mesher_test_tools.h"
#include "pslg_test_tools.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace {

using namespace mesher_test;
using pslg_test::Point;
using pslg_test::Vertex_index;

/// A box around the unit square.
void add_box(Pslg& pslg) {
  const std::size_t first = pslg.number_of_vertices();
  for (const Point& p : {Point(-1.25, -1.25), Point(1.5, -1.25), Point(1.5, 1.5), Point(-1.25, 1.5)})
    pslg.add_vertex(p);
  for (std::size_t i = 0; i < 4; ++i)
    pslg.add_segment(Vertex_index(first + i), Vertex_index(first + (i + 1) % 4));
}

/// A chain, or a fan whose hub is the origin, of n points of a curve.
Pslg curve(const std::string& name, std::size_t n) {
  Pslg pslg;
  const bool is_fan = name == "fan";
  if (is_fan) pslg.add_vertex(Point(0, 0));
  for (std::size_t i = 0; i < n; ++i) {
    const double t = double(i) / double(n), turn = 6.283185307179586 * t;
    const Vertex_index v = pslg.add_vertex(name == "line"       ? Point(t, 0)
                                           : name == "upright"  ? Point(0, t)
                                           : name == "parabola" ? Point(t, t * t)
                                           : name == "comb"     ? Point(t, double(i % 2))
                                                                : Point(std::cos(turn), std::sin(turn)));
    if (i > 0 || is_fan) pslg.add_segment(is_fan ? Vertex_index(0) : Vertex_index(std::size_t(v) - 1), v);
  }
  add_box(pslg);
  return pslg;
}

} // namespace

TEST_CASE("Vertices of huge degree are meshed to the bound", "[quality_mesher_2][hubs]") {
  const std::string name =
      GENERATE(as<std::string>(), "line", "upright", "parabola", "circle", "comb", "fan");
  CAPTURE(name);
  run_to_the_bound(curve(name, 3000), Options());
}

TEST_CASE("Vertices of huge degree cost no quadratic time", "[quality_mesher_2][hubs]") {
  const std::string name = GENERATE(as<std::string>(), "upright", "circle", "comb", "fan");
  CAPTURE(name);
  constexpr std::size_t n = 200000;
  Mesher mesher;
  mesher(curve(name, n));
  CHECK(mesher.report().is_met());
  CHECK(mesher.report().triangles < 6 * n);
}
