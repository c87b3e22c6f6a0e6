// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The benchmark of meshes of points: that its families are what they say, and that the program runs. What it
// includes of the benchmark is little, for the meshers would take a minute to compile here, too.

#include "catch.h"
#include "scratch_folder.h"

#include "quadtree_inputs.h"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#ifdef QUADTREE_MESH_POINTS_BENCHMARK
#include <nlohmann/json.hpp>
#endif

namespace test_points_benchmark {

namespace {

Points make(const std::string& family, std::size_t n) { return quadtree_inputs::by_name(family).make(n, n); }

double distance(const Point_2& p, const Point_2& q) { return std::hypot(p.x() - q.x(), p.y() - q.y()); }

/// The distance of the points `first`, ..., `last - 1` that are farthest from each other.
double diameter(const Points& points, std::size_t first, std::size_t last) {
  double result = 0;
  for (std::size_t i = first; i < last; ++i)
    for (std::size_t j = first; j < i; ++j) result = std::max(result, distance(points[i], points[j]));
  return result;
}

} // namespace

TEST_CASE("Families of points have the size they are asked for, and are the same every time", "[benchmark]") {
  for (const auto& family : quadtree_inputs::all())
    for (const std::size_t n : {2, 3, 10, 1001}) {
      CAPTURE(family.name, n);
      const Points points = family.make(n, 7);
      CHECK(points.size() == n);
      CHECK(points == family.make(n, 7));
      CHECK(std::all_of(points.begin(), points.end(),
                        [](const Point_2& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); }));
    }
  CHECK_THROWS(quadtree_inputs::by_name("nothing"));
}

TEST_CASE("Clusters of the benchmark are of different widths", "[benchmark]") {
  const Points points = make("clusters", 900);
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  for (std::size_t first = 0; first < points.size(); first += 30) {
    const double width = diameter(points, first, first + 30);
    least = std::min(least, width), largest = std::max(largest, width);
  }
  CHECK(least < 1e-3);
  CHECK(largest > 30 * least);
  CHECK(largest < 0.3);
  CHECK(diameter(points, 0, points.size()) > 0.7);
}

TEST_CASE("Close pairs are far from all others", "[benchmark]") {
  for (const std::size_t n : {300, 1200}) {
    const Points points = make("close-pairs", n);
    const double pair = 1e-8 * std::sqrt(300 / double(n));
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(distance(points[i], points[i ^ 1]) == Approx(pair).epsilon(1e-6));
      for (std::size_t j = 0; j < i; ++j)
        if (j != (i ^ 1) && distance(points[i], points[j]) < 1000 * pair)
          FAIL_CHECK("near: " << i << ' ' << j);
    }
  }
}

TEST_CASE("Nested clusters are nested", "[benchmark]") {
  const Points points = make("nested", 500);
  for (std::size_t k = 0; k < 5; ++k) {
    const double width = diameter(points, 100 * k, points.size());
    CHECK(width > std::ldexp(1.5, -30 * int(k)));
    CHECK(width < std::ldexp(3.0, -30 * int(k)));
  }
}

TEST_CASE("A spiral goes inwards, a line is straight", "[benchmark]") {
  const Point_2 center(0.5, 0.5);
  for (const char* name : {"spiral", "short-spiral"}) {
    const Points spiral = make(name, 1000);
    for (std::size_t i = 100; i < spiral.size(); i += 100)
      CHECK(distance(spiral[i], center) < 0.1 * distance(spiral[i - 100], center));
  }
  const Points line = make("line", 100);
  for (const Point_2& p : line)
    CHECK(p.y() * line.front().x() == Approx(line.front().y() * p.x()).epsilon(1e-14));
}

#ifdef QUADTREE_MESH_POINTS_BENCHMARK

namespace {

/// A program that takes the switches of Triangle and makes a triangle, whatever it is given.
std::string write_stand_in(const Scratch_folder& folder) {
  const std::string script = R"(#!/bin/sh
test "$1" = -pq20.700000 || test "$1" = -pq33.000000 || exit 3
stem=${2%.poly}
printf '3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n' >"$stem.1.node"
printf '1 3 0\n0 0 1 2\n' >"$stem.1.ele"
echo 'Delaunay milliseconds:  1'
echo 'Quality milliseconds:  2'
echo 'Total running milliseconds:  4'
)";
  const std::string name = folder.write("triangle", script);
  std::filesystem::permissions(name, std::filesystem::perms::owner_all);
  return name;
}

} // namespace

TEST_CASE("The benchmark of meshes of points runs", "[benchmark][program]") {
  const Scratch_folder folder;
  const auto status_of = [&folder](const std::string& arguments) {
    const int status = std::system(
        ("'" QUADTREE_MESH_POINTS_BENCHMARK "' " + arguments + " >'" + folder.file("out") + "' 2>/dev/null")
            .c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  const std::string triangle = write_stand_in(folder), json_file = folder.file("json");
  REQUIRE(status_of("nested --n 100 --modes acute:1 bounded points --repeat 2 --triangle '" + triangle +
                    "' --json '" + json_file + "'") == 0);
  const auto json = nlohmann::json::parse(content(json_file));
  const auto& meshers = json["comparisons"][0]["meshers"];
  REQUIRE(meshers.size() == 6);
  CHECK(meshers[0]["is_valid"] == true);
  CHECK(meshers[0]["clusters"] == 4);
  CHECK(meshers[0]["runs"] == 2);
  CHECK(meshers[0]["max_angle"] < 90 + 1e-9);
  CHECK(meshers[1].find("triangles") == meshers[1].end()); // points too near to each other
  CHECK(meshers[2]["is_valid"] == true);
  CHECK(meshers[2]["min_angle"] > 20.6);
  CHECK(meshers[3]["mesher"] == "Mesh_2, 20.7");
  CHECK(meshers[3]["is_valid"] == true);
  CHECK(meshers[3]["min_angle"] > 20.6);
  CHECK(meshers[4]["triangles"] == 1);
  CHECK(meshers[5]["mesher"] == "Triangle, 33");
  const std::string tables = content(folder.file("out"));
  CHECK(tables.find("### nested") != std::string::npos);

  REQUIRE(status_of("uniform --n 100 --modes points --repeat 1 --triangle '" + triangle + "'") == 0);
  CHECK(content(folder.file("out")).find("| 100 | points | Triangle, 20.7 | ") != std::string::npos);

  CHECK(status_of("uniform --growth --n 50 100 --modes warped bounded:0 --repeat 1") == 0);
  CHECK(content(folder.file("out")).find("relative to the fewest points") != std::string::npos);
#ifdef CGAL_LINKED_WITH_TBB
  CHECK(status_of("uniform --n 100 --modes points warped --peers none --repeat 1 --threads 1 2") == 0);
  CHECK(content(folder.file("out")).find("| 100 | warped, 2 threads | ") != std::string::npos);
#endif
  CHECK(status_of("--help") == 0);
  for (const char* arguments : {"nobody", "--modes bounded:4", "--modes obtuse", "--peers nobody",
                                "--peers triangle", "--n 0", "--nothing"})
    CHECK(status_of(arguments) == 2);
}

#endif

} // namespace test_points_benchmark
