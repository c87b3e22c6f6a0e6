// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Without a viewer draw() says so, as that of CGAL does.

#include "catch.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/draw_balanced_quadtree.h>
#include <CGAL/draw_indexed_mesh_2.h>

#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace test_draw {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

/// What a call writes to std::cerr.
template <class Function>
std::string errors_of(const Function& call) {
  std::ostringstream text;
  std::streambuf* const before = std::cerr.rdbuf(text.rdbuf());
  call();
  std::cerr.rdbuf(before);
  return text.str();
}

} // namespace

TEST_CASE("Without a viewer nothing is drawn, and a line says so", "[draw]") {
  const std::string message = "Impossible to draw, CGAL_USE_BASIC_VIEWER is not defined.\n";
  CGAL::Indexed_mesh_2<Point> mesh;
  CHECK(errors_of([&] { CGAL::draw(mesh); }) == message);
  mesh.points = {Point(0, 0), Point(1, 0), Point(0, 1)};
  mesh.triangles.push_back({CGAL::Quadtree_mesh_2::Vertex_index(0), CGAL::Quadtree_mesh_2::Vertex_index(1),
                            CGAL::Quadtree_mesh_2::Vertex_index(2)});
  CHECK(errors_of([&] { CGAL::draw(mesh, "a triangle"); }) == message);
  const CGAL::Balanced_quadtree<CGAL::Filtered_quadtree_traits_2<>> tree(mesh.points);
  CHECK(errors_of([&] { CGAL::draw(tree); }) == message);
}

} // namespace test_draw
