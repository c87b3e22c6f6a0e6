// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "adapt_tools.h"

#include <CGAL/Mesh_sizing_field_2.h>
#include <CGAL/Quadtree_mesh_2/internal/adaptation/Triangle_tree.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace test_triangle_tree {

namespace {

using namespace adapt_test;
using CGAL::Quadtree_mesh_2::internal::corner_weights;
using CGAL::Quadtree_mesh_2::internal::Triangle_tree;

Triangle_tree::Corners corners(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  return {mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])};
}

/// The first triangle with the place in it; invalid if there is none.
Triangle_index first_with(const Mesh& mesh, const Point& p) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (Triangle_tree::has_inside_or_on(corners(mesh, t), p)) return Triangle_index(t);
  return {};
}

double distance_from(const Mesh& mesh, std::size_t t, const Point& p) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto c = corners(mesh, t);
  return std::sqrt(CGAL::squared_distance(p, Kernel::Triangle_2(c[0], c[1], c[2])));
}

} // namespace

TEST_CASE("A tree of triangles finds the first one with a place in it, or else the nearest one", "[adapt]") {
  const Mesh mesh = fresh_mesh(frame(), Options().max_area(0.1));
  const Triangle_tree tree(mesh.points, mesh.triangles);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 5);
  for (int i = 0; i < 2000; ++i) {
    const Point p(coordinate(random), coordinate(random));
    const auto found = tree.nearest(p);
    const Triangle_index inside = first_with(mesh, p);
    CHECK((found.distance == 0) == inside.is_valid());
    if (inside.is_valid()) CHECK(found.triangle == inside);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      least = std::min(least, distance_from(mesh, t, p));
    CHECK(found.distance == Approx(least).margin(1e-12));
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v) // on borders of triangles the first one, too
    CHECK(tree.nearest(mesh.points[v]).triangle == first_with(mesh, mesh.points[v]));
}

TEST_CASE("A tree of triangles finds the same at any scale", "[adapt]") {
  const Mesh mesh = fresh_mesh(frame(), Options().max_area(0.1));
  const Triangle_tree tree(mesh.points, mesh.triangles);
  for (const double scale : {0x1p-900, 0x1p-540, 0x1p540, 0x1p900}) {
    CAPTURE(scale);
    Mesh scaled = mesh;
    for (Point& p : scaled.points) p = Point(scale * p.x(), scale * p.y());
    const Triangle_tree scaled_tree(scaled.points, scaled.triangles);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-1, 5);
    for (int i = 0; i < 200; ++i) {
      const Point p(coordinate(random), coordinate(random)), q(scale * p.x(), scale * p.y());
      const auto found = tree.nearest(p), found_scaled = scaled_tree.nearest(q);
      CHECK(found.triangle == found_scaled.triangle);
      CHECK(scale * found.distance == found_scaled.distance);
      const std::size_t t(found.triangle);
      CHECK(corner_weights(corners(mesh, t), p) == corner_weights(corners(scaled, t), q));
    }
  }
}

TEST_CASE("A tree of triangles finds all whose boxes meet a box", "[adapt]") {
  const Mesh mesh = fresh_mesh(frame(), Options().max_area(0.1));
  const Triangle_tree tree(mesh.points, mesh.triangles);
  const Triangle_tree::Box box{{0.5, 0.25}, {1.5, 3}};
  std::vector<char> is_found(mesh.triangles.size(), 0);
  tree.for_each_meeting(box, [&](const auto&, Triangle_index t) { ++is_found[std::size_t(t)]; });
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto own = Triangle_tree::box_of(corners(mesh, t));
    const bool meets = own.low[0] <= 1.5 && own.high[0] >= 0.5 && own.low[1] <= 3 && own.high[1] >= 0.25;
    CHECK(is_found[t] == (meets ? 1 : 0));
  }
}

TEST_CASE("Weights of corners are exact at corners, and never negative", "[adapt]") {
  const Triangle_tree::Corners t{Point(0.1, 0.2), Point(0.7, 0.3), Point(0.3, 0.9)};
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<double, 3> unit{};
    unit[k] = 1;
    CHECK(corner_weights(t, t[k]) == unit);
  }
  for (const Point& p : {Point(-5, 3), Point(9, 9), Point(0.4, 0.4), Point(0.1, -7)}) {
    const auto w = corner_weights(t, p);
    CHECK(std::min({w[0], w[1], w[2]}) >= 0);
    CHECK(w[0] + w[1] + w[2] == Approx(1));
  }
}

TEST_CASE("Weights of corners give the nearest place, also in triangles as flat as doubles can tell",
          "[adapt]") {
  using Segment = Triangle_tree::Kernel::Segment_2;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(0, 1);
  for (const double height : {1., 1e-3, 1e-9, 0x1p-52}) {
    CAPTURE(height);
    const Triangle_tree::Corners t{Point(0, 0), Point(1, 0.75), Point(0.5, 0.375 + height)};
    for (int i = 0; i < 1000; ++i) {
      const double x = coordinate(random);
      const Point p(x, 0.75 * x + height * (3 * coordinate(random) - 1));
      const auto w = corner_weights(t, p);
      CHECK(std::min({w[0], w[1], w[2]}) >= 0);
      CHECK(w[0] + w[1] + w[2] == Approx(1).epsilon(1e-15));
      const Point q(w[1] * t[1].x() + w[2] * t[2].x(), w[1] * t[1].y() + w[2] * t[2].y());
      double distance =
          std::numeric_limits<double>::infinity(); // CGAL's from triangles is too large for some
      for (std::size_t k = 0; k < 3; ++k)
        distance = std::min(distance, std::sqrt(CGAL::squared_distance(p, Segment(t[k], t[(k + 1) % 3]))));
      if (Triangle_tree::has_inside_or_on(t, p)) distance = 0;
      CHECK(std::hypot(q.x() - p.x(), q.y() - p.y()) == Approx(distance).margin(1e-12));
    }
  }
}

TEST_CASE("A sizing field of a mesh is linear in its triangles", "[adapt]") {
  const Mesh mesh = fresh_mesh(frame(), Options().max_area(0.1));
  std::vector<double> sizes;
  for (const Point& p : mesh.points) sizes.push_back(1 + 2 * p.x() + 3 * p.y());
  const CGAL::Mesh_sizing_field_2 field(mesh, sizes);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    CHECK(field(mesh.points[v].x(), mesh.points[v].y()) == sizes[v]);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Point p = centroid(mesh, t);
    CHECK(field(p.x(), p.y()) == Approx(1 + 2 * p.x() + 3 * p.y()));
  }
  CHECK(field(2, 0.9) == Approx(5 + 2.7));
  CHECK(field(-100, 0.001) > 0); // far outside, the nearest triangle tells
}

TEST_CASE("A sizing field of a mesh names the vertex at fault", "[adapt]") {
  const Mesh mesh = fresh_mesh(frame(), Options());
  std::vector<double> sizes(mesh.points.size(), 1);
  CHECK_THROWS_WITH(CGAL::Mesh_sizing_field_2(Mesh(), {}), "a sizing field of a mesh needs a triangle");
  for (const double bad : {0., -1., std::nan(""), std::numeric_limits<double>::infinity()}) {
    sizes[3] = bad;
    CHECK_THROWS_WITH(CGAL::Mesh_sizing_field_2(mesh, sizes),
                      "the size at vertex 3 is not a positive number");
  }
  sizes.pop_back();
  CHECK_THROWS_AS(CGAL::Mesh_sizing_field_2(mesh, sizes), std::invalid_argument);
}

} // namespace test_triangle_tree
