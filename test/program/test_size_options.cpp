// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Sizes by the distance from features, alone and with other sizes: judged triangle by triangle, by brute force.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "random_numbers.h"
#include "run_program.h"
#include "scratch_folder.h"

#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/Segments_sizing_field_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_size_options {

using namespace program_test;
using namespace test_meshes;

namespace {

/// By the places on a segment, found by trying: no formula of the class is used.
double distance_to_segment(const Point& a, const Point& b, double x, double y) {
  const auto at = [&](double t) {
    return std::hypot(a.x() + t * (b.x() - a.x()) - x, a.y() + t * (b.y() - a.y()) - y);
  };
  double low = 0, high = 1;
  for (int i = 0; i < 100; ++i) { // the distance is convex in t
    const double third = (high - low) / 3;
    if (at(low + third) < at(high - third))
      high -= third;
    else
      low += third;
  }
  return std::min({at(low), at(0), at(1)});
}

double distance(const Pslg& pslg, double x, double y) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : pslg.segments)
    least = std::min(least, distance_to_segment(pslg.point(a), pslg.point(b), x, y));
  for (const Point& p : pslg.vertices) least = std::min(least, std::hypot(p.x() - x, p.y() - y));
  return least;
}

/// A box with a slanted segment and a vertex that is on none.
Pslg plan() {
  Pslg pslg;
  for (const auto& [x, y] :
       {std::pair(0., 0.), {10., 0.}, {10., 6.}, {0., 6.}, {2., 1.}, {4., 4.}, {7.5, 2.5}})
    pslg.add_vertex(Point(x, y));
  for (const auto& [a, b] : {std::pair(0, 1), {1, 2}, {2, 3}, {3, 0}, {4, 5}}) add_segment(pslg, a, b);
  return pslg;
}

/// Checks that the longest edge of each triangle is at most `size(x, y)` of its centroid; returns the share that
/// uses more than a third of that.
template <class Size>
double check_sizes(const CGAL::Indexed_mesh_2<Point>& mesh, const Size& size) {
  std::size_t large = 0, too_large = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point &p = mesh.point(a), &q = mesh.point(b), &r = mesh.point(c);
    const double longest = std::sqrt(
        std::max({CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p)}));
    const double bound = size((p.x() + q.x() + r.x()) / 3, (p.y() + q.y() + r.y()) / 3);
    if (longest > bound * (1 + 1e-9)) ++too_large;
    if (longest > bound / 3) ++large;
  }
  CHECK(mesh.triangles.size() > 100);
  CHECK(too_large == 0);
  return static_cast<double>(large) / static_cast<double>(mesh.triangles.size());
}

} // namespace

TEST_CASE("sizes by the distance from features", "[sizes]") {
  const Pslg pslg = plan();
  const CGAL::Segments_sizing_field_2 field(pslg, 0.1, 0.25);
  Random_numbers random(11);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.between(-3, 13), y = random.between(-3, 9);
    CHECK(field(x, y) == Approx(0.1 + 0.25 * distance(pslg, x, y)).epsilon(1e-7));
  }
  CHECK(field(7.5, 2.5) == 0.1);
  CHECK(field(3, 2.5) == Approx(0.1)); // on the slanted segment
  const auto mesh = CGAL::Quality_mesher_2<>(CGAL::Quality_mesh_options_2().size(field))(pslg);
  const double used =
      check_sizes(mesh, [&](double x, double y) { return 0.1 + 0.25 * distance(pslg, x, y); });
  CHECK(used > 0.9);

  const Pslg none;
  CHECK_THROWS_AS(CGAL::Segments_sizing_field_2(none, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(CGAL::Segments_sizing_field_2(pslg, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(CGAL::Segments_sizing_field_2(pslg, 1, -1), std::invalid_argument);
}

TEST_CASE("distances from random segments, long and short", "[sizes]") {
  Random_numbers random(3);
  for (const std::size_t n : {1, 5, 300}) {
    Pslg pslg;
    for (std::size_t i = 0; i < n; ++i) {
      const double x = random.between(0, 1), y = random.between(0, 1),
                   length = std::pow(10., -3. * random.between(0, 1));
      pslg.add_vertex(Point(x, y));
      pslg.add_vertex(Point(x + length * random.between(-1, 1), y + length * random.between(-1, 1)));
      if (i % 5 != 4) add_segment(pslg, 2 * i, 2 * i + 1);
    }
    const CGAL::Segments_sizing_field_2 field(pslg, 1, 1);
    for (int i = 0; i < 200; ++i) {
      const double x = random.between(-1, 2), y = random.between(-1, 2);
      CHECK(field.distance(x, y) == Approx(distance(pslg, x, y)).epsilon(1e-7).margin(1e-9));
    }
  }
}

#ifdef QUADTREE_MESH_PROGRAM
TEST_CASE("all sizes of the program hold together, and grow as --gradation says", "[program][sizes]") {
  const Scratch_folder folder;
  const Pslg pslg = plan();
  const std::string input =
      folder.write("plan.poly", "7 2 0 0\n0 0 0\n1 10 0\n2 10 6\n3 0 6\n4 2 1\n5 4 4\n6 7.5 2.5\n"
                                "5 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 4 5\n0\n");
  folder.write("points.xy", "9 5 0.02\n1 5 0.3\n");
  folder.write("sizes.asc", "ncols 5\nnrows 3\nxllcenter 0\nyllcenter 0\ndx 2.5\ndy 3\n"
                            "9 9 9 9 9\n9 9 9 9 9\n9 9 0.05 9 9\n"); // small at (5, 0)
  const std::string all = " --size-points " + folder.file("points.xy") + " --size-grid " +
                          folder.file("sizes.asc") + " --size-from-features 0.2 0.4 ";
  const auto mesh = [&](const std::string& options) {
    const Run r = run(input + options + " -o " + folder.file("m.ele"));
    CAPTURE(options, r.err);
    CHECK(r.status == 0);
    CGAL::Indexed_mesh_2<Point> result;
    CGAL::IO::read_triangle_files(folder.file("m"), result);
    return result;
  };
  const auto by_points = [](double x, double y, double g) {
    return std::min(0.02 + g * std::hypot(x - 9, y - 5), 0.3 + g * std::hypot(x - 1, y - 5));
  };
  check_sizes(mesh(" --size-from-features 0.2 0.4"),
              [&](double x, double y) { return 0.2 + 0.4 * distance(pslg, x, y); });
  const auto free = mesh(all);
  check_sizes(free, [&](double x, double y) {
    return std::min(by_points(x, y, 0.5), 0.2 + 0.4 * distance(pslg, x, y));
  });

  const double g = 0.15;
  const auto limited = mesh(all + "--gradation 0.15");
  // The sizes at the places of the grid, limited by trying all pairs; the least at the corners of a cell is no bound
  // between them, the largest is.
  const auto at_place = [&](int i, int j) {
    return std::min(9., 0.05 + g * std::hypot(2.5 * i - 5, 3. * j));
  };
  const auto by_grid = [&](double x, double y) {
    const int i = std::min(3, static_cast<int>(x / 2.5)), j = std::min(1, static_cast<int>(y / 3));
    const double u = x / 2.5 - i, v = y / 3 - j;
    return (1 - v) * ((1 - u) * at_place(i, j) + u * at_place(i + 1, j)) +
           v * ((1 - u) * at_place(i, j + 1) + u * at_place(i + 1, j + 1));
  };
  const auto size = [&](double x, double y) {
    return std::min({by_points(x, y, g), by_grid(x, y), 0.2 + g * distance(pslg, x, y)});
  };
  check_sizes(limited, size);
  CHECK(limited.triangles.size() > free.triangles.size() + free.triangles.size() / 10);
  // What is promised of any two triangles: their bounds differ by at most sqrt(2) g times the distance.
  Random_numbers random(5);
  for (int i = 0; i < 3000; ++i) {
    const double x = random.between(0, 10), y = random.between(0, 6), p = random.between(0, 10),
                 q = random.between(0, 6);
    CHECK(std::abs(size(x, y) - size(p, q)) <= std::sqrt(2.) * g * std::hypot(x - p, y - q) + 1e-12);
  }
}

TEST_CASE("sizes from features are meters on the ground for graphs in degrees", "[program][sizes]") {
  const Scratch_folder folder;
  const std::string input = folder.write("a.geojson", R"({"type": "Polygon",
    "coordinates": [[[10, 60], [10.1, 60], [10.1, 60.05], [10, 60.05], [10, 60]]]})");
  const Run r = run(input + " --size-from-features 100 0.2 -o " + folder.file("m.ele"));
  CAPTURE(r.err);
  CHECK(r.status == 0);
  CGAL::Indexed_mesh_2<Point> mesh;
  CGAL::IO::read_triangle_files(folder.file("m"), mesh);
  // A plane of meters that is exact to a thousandth here.
  const double degree = 6371008.8 * 3.14159265358979323846 / 180;
  for (Point& p : mesh.points)
    p = Point((p.x() - 10) * degree * std::cos(p.y() * 3.14159265358979323846 / 180), (p.y() - 60) * degree);
  const double width = 0.1 * degree * 0.5, height = 0.05 * degree;
  const double used = check_sizes(mesh, [&](double x, double y) {
    return 1.02 * (100 + 0.2 * std::max(0., std::min({x, width - x, y, height - y})));
  });
  CHECK(used > 0.5);
}
#endif

} // namespace test_size_options
