// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The checker finds the same by any number of threads: in meshes of several ranges of its loops, with and without
// errors in them.

#include "catch.h"
#include "mesh_from_cdt.h"
#include "numbers_of_threads.h"

#include <CGAL/mesh_quality_2.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace test_checker_loops {

using namespace test_meshes;
using Options = CGAL::Mesh_quality_options_2;
using Quality = CGAL::Mesh_quality_2;

namespace {

/// A square with a side of 1, and its diagonal.
Pslg halved_square() {
  Pslg pslg;
  add_polygon(pslg, {Point(0, 0), Point(1, 0), Point(1, 1), Point(0, 1)});
  add_segment(pslg, 0, 2);
  return pslg;
}

/// Its grid of n x n squares, each of them halved, too. Corners come first.
Mesh grid(std::size_t n) {
  Mesh mesh;
  std::vector<std::vector<Vertex_index>> at(n + 1, std::vector<Vertex_index>(n + 1));
  const auto place = [&](std::size_t i, std::size_t j) {
    at[i][j] = Vertex_index(mesh.points.size());
    mesh.points.emplace_back(static_cast<double>(i) / static_cast<double>(n),
                             static_cast<double>(j) / static_cast<double>(n));
  };
  place(0, 0), place(n, 0), place(n, n), place(0, n);
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      if ((i != 0 && i != n) || (j != 0 && j != n)) place(i, j);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      mesh.triangles.push_back({at[i][j], at[i + 1][j], at[i + 1][j + 1]});
      mesh.triangles.push_back({at[i][j], at[i + 1][j + 1], at[i][j + 1]});
    }
  return mesh;
}

std::vector<Triangle_index> unmet_triangles(const Quality& quality) {
  std::vector<Triangle_index> triangles;
  for (const auto& unmet : quality.unmet_triangles) triangles.push_back(unmet.triangle);
  return triangles;
}

/// The same bits for any number of threads.
Quality quality_by_threads(const Mesh& mesh, const Options& bounds) {
  auto options = bounds;
  options.check_arrays(Options::Arrays::POINTS_AND_TRIANGLES).max_errors(1000);
  const Quality one = CGAL::mesh_quality_2(mesh, halved_square(), options);
  for_numbers_of_threads([&] {
    const Quality several = CGAL::mesh_quality_2<CGAL::Parallel_tag>(mesh, halved_square(), options);
    CHECK(several.errors == one.errors);
    CHECK(several.number_of_errors == one.number_of_errors);
    CHECK(several.vertices == one.vertices);
    CHECK(several.edges == one.edges);
    CHECK(several.border_edges == one.border_edges);
    CHECK(several.area == one.area);
    CHECK(several.domain_area == one.domain_area);
    CHECK(several.total_length == one.total_length);
    CHECK(several.shortest_edge == one.shortest_edge);
    CHECK(several.longest_edge == one.longest_edge);
    CHECK(several.largest_area == one.largest_area);
    CHECK(several.min_angle == one.min_angle);
    CHECK(several.max_angle == one.max_angle);
    CHECK(several.min_new_angle == one.min_new_angle);
    CHECK(several.angle_histogram == one.angle_histogram);
    CHECK(several.exempt_triangles == one.exempt_triangles);
    CHECK(unmet_triangles(several) == unmet_triangles(one));
  });
  return one;
}

} // namespace

TEST_CASE("threads find the same of a mesh", "[mesh_quality_2][threads]") {
  const std::size_t n = 200;
  const Quality quality = quality_by_threads(grid(n), Options().min_angle(30));
  CHECK(quality.errors.empty());
  CHECK(quality.is_met());
  CHECK(quality.triangles == 2 * n * n);
  CHECK(quality.edges == 3 * n * n + 2 * n);
  CHECK(quality.border_edges == 4 * n);
  CHECK(quality.area == Approx(1));
  CHECK(quality.domain_area == Approx(1));
  CHECK(quality.total_length == Approx(2 * (n + 1) + n * std::sqrt(2.)));
  CHECK(quality.angle_histogram[4] + quality.angle_histogram[8] + quality.angle_histogram[9] == 6 * n * n);
}

TEST_CASE("threads find the same errors, in the same order", "[mesh_quality_2][threads]") {
  Mesh mesh = grid(200);
  for (const std::size_t t : {7u, 40000u, 79999u}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  mesh.triangles[35000] = mesh.triangles[36000];
  mesh.points[20000] = mesh.points[20001];
  const Quality quality = quality_by_threads(mesh, Options().min_angle(46).max_area(1e-5));
  CHECK(quality.number_of_errors > 8);
  CHECK(quality.errors.front().find("triangle 7 ") == 0);
  CHECK(quality.unmet_triangles.size() > 79000);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("what ends other tasks of the caller does not end the checker", "[mesh_quality_2][threads]") {
  const Mesh mesh = grid(2);
  const auto options = Options().check_arrays(Options::Arrays::POINTS_AND_TRIANGLES);
  Quality quality;
  tbb::task_group_context context;
  tbb::parallel_for(
      0, 1,
      [&](int) {
        context.cancel_group_execution();
        quality = CGAL::mesh_quality_2<CGAL::Parallel_tag>(mesh, halved_square(), options);
      },
      context);
  CHECK(quality.is_valid());
  CHECK(quality.triangles == 8);
  CHECK(quality.edges == 16);
}
#endif

} // namespace test_checker_loops
