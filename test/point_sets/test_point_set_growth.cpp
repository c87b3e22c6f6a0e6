// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Theorems 3 and 4: total lengths are within a constant of the least, and so are numbers of triangles. What is
// asserted is that they do not grow with the number of points, not even as its logarithm.

#include "catch.h"
#include "growth.h"
#include "point_sets.h"
#include "quadtree_inputs.h"

#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/point_set_lengths_2.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace test_point_set_growth {

namespace {

using CGAL::Point_set_mesh_options_2;
using point_sets::Points;

/// Points that become more in one way.
struct Family {
  const char* name;
  Points (*make)(std::size_t n);
};

/// On these meshes with bounded angles have O(n) triangles, as no points are much nearer to each other than to others,
/// and a spanning tree is within a constant of the least mesh. (Points on a circle are no such family: every
/// triangulation of these is longer than the circle by a logarithm.)
const std::vector<Family>& even_families() {
  static const std::vector<Family> all{
      {"uniform", [](std::size_t n) { return quadtree_inputs::uniform(n, 1); }},
      {"on a line", [](std::size_t n) { return quadtree_inputs::line(n, 2); }},
      {"on a horizontal line", [](std::size_t n) { return point_sets::horizontal_line(n, 3); }},
      {"grid", [](std::size_t n) { return quadtree_inputs::grid(n, 4); }}};
  return all;
}

const std::vector<Family>& uneven_families() {
  static const std::vector<Family> all{
      {"uniform", [](std::size_t n) { return quadtree_inputs::uniform(n, 1); }},
      {"spiral", [](std::size_t n) { return point_sets::spiral(n, 0x1p-36); }},
      {"close pairs", [](std::size_t n) { return point_sets::close_pairs(n, 1e-10, 1); }},
      {"nested clusters", [](std::size_t n) { return point_sets::nested_clusters(n, 1e-3, 3, 2); }}};
  return all;
}

/// Four sizes or more, from the first one on.
std::vector<std::size_t> sizes(std::size_t first, std::size_t most) {
  std::vector<std::size_t> result;
  for (std::size_t n = first; n <= 64 * first || (is_full_run() && n <= most); n *= 4) result.push_back(n);
  return result;
}

struct Shares {
  std::vector<double> triangles; ///< for each point
  std::vector<double> lengths;   ///< by the lower bound for all meshes of the points
};

/// Without removal: what the trees make, which is what the theorems count.
Shares shares(const Family& family, Point_set_mesh_options_2 options, const std::vector<std::size_t>& sizes) {
  options.effort(0);
  Shares result;
  for (const std::size_t n : sizes) {
    const Points points = family.make(n);
    CGAL::Point_set_mesher_2<> mesher(options);
    const auto mesh = mesher(points);
    result.triangles.push_back(double(mesh.number_of_triangles()) / double(points.size()));
    result.lengths.push_back(CGAL::total_edge_length_2(mesh) /
                             CGAL::point_set_lengths_2(points).least_mesh());
  }
  return result;
}

void print(const char* name, const std::vector<double>& values) {
  std::string text;
  for (const double v : values) text += ' ' + std::to_string(v);
  if (is_full_run()) WARN(name << ':' << text);
}

} // namespace

TEST_CASE("The growth that a logarithm brings is noticed", "[growth]") {
  const std::vector<std::size_t> n = sizes(is_full_run() ? 50 : 25, 20000);
  std::vector<double> constant, falling, logarithmic;
  for (std::size_t i = 0; i < n.size(); ++i) {
    constant.push_back(i % 2 == 0 ? 10 : 11);
    falling.push_back(10 + 100 / double(n[i]));
    logarithmic.push_back(std::log2(double(n[i])));
  }
  CHECK(growth::is_bounded(constant));
  CHECK(growth::is_bounded(falling));
  CHECK_FALSE(growth::is_bounded(logarithmic));
}

TEST_CASE("Numbers of triangles and lengths of meshes with bounded angles grow as those needed",
          "[point_set_mesher][growth]") {
  for (const Family& family : even_families()) {
    const Shares s = shares(family, Point_set_mesh_options_2(), sizes(is_full_run() ? 50 : 25, 20000));
    CAPTURE(family.name, s.triangles, s.lengths);
    print(family.name, s.triangles), print(family.name, s.lengths);
    CHECK(growth::is_bounded(s.triangles));
    CHECK(growth::is_bounded(s.lengths));
  }
}

TEST_CASE("Numbers of triangles and lengths of acute meshes grow as those needed, however near points are",
          "[point_set_mesher][growth]") {
  for (const Family& family : uneven_families()) {
    const Shares s = shares(family, Point_set_mesh_options_2().acute(), sizes(15, 4000));
    CAPTURE(family.name, s.triangles, s.lengths);
    print(family.name, s.triangles), print(family.name, s.lengths);
    CHECK(growth::is_bounded(s.triangles));
    CHECK(growth::is_bounded(s.lengths));
  }
}

} // namespace test_point_set_growth
