// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Values at vertices between ranks of MPI: foreign vertices get what owners have, and owners the sums that one rank has
// for the whole mesh.

#include "catch.h"
#include "meshes_by_all_parts.h"
#include "random_pslg_shapes.h"

#include <CGAL/Distributed_quality_mesher_2.h>
#include <CGAL/Vertex_scatter_2.h>
#include <CGAL/distribute_mesh_2.h>

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace test_vertex_scatter_2 {

using namespace meshes_by_all_parts;

/// The numbers of triangles at the vertices of a mesh, at all ranks.
std::vector<std::int64_t> degrees_of_all(const Part& part) {
  const Mesh mesh = CGAL::gather_mesh_2(MPI_COMM_WORLD, part);
  std::vector<std::int64_t> degrees(static_cast<std::size_t>(part.number_of_vertices()), 0);
  for (const auto& t : mesh.triangles) // of the first rank alone
    for (const auto v : t) ++degrees[std::size_t(v)];
  MPI_Bcast(degrees.data(), static_cast<int>(degrees.size()), MPI_INT64_T, 0, MPI_COMM_WORLD);
  return degrees;
}

void check_values(const Part& part) {
  CGAL::Vertex_scatter_2 scatter(MPI_COMM_WORLD, part);
  std::vector<std::int64_t> numbers(part.points.size(), -1), sums(part.points.size(), 0);
  for (std::size_t i = 0; i < part.number_of_own_vertices(); ++i) numbers[i] = part.number_of_vertex(i);
  scatter.forward(numbers);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) wrong += numbers[i] != part.number_of_vertex(i);
  CHECK(wrong == 0);

  for (std::size_t t = 0; t < part.number_of_own_triangles(); ++t)
    for (const auto v : part.triangles[t]) ++sums[part.index_of_vertex(v)];
  scatter.add_backward(sums);
  scatter.forward(sums);
  const std::vector<std::int64_t> expected = degrees_of_all(part);
  for (std::size_t i = 0; i < sums.size(); ++i)
    wrong += sums[i] != expected[static_cast<std::size_t>(part.number_of_vertex(i))];
  CHECK(wrong == 0);
}

TEST_CASE("values go from owners to all ranks, and sums to owners", "[distributed]") {
  for (const auto& family : random_pslg::all_families()) {
    CAPTURE(family.name);
    CGAL::Distributed_quality_mesher_2<> mesher(MPI_COMM_WORLD);
    check_values(mesher(family.make(12)));
  }
}

TEST_CASE("a rank knows its vertices and triangles, and no others", "[distributed]") {
  CGAL::Distributed_quality_mesher_2<> mesher(MPI_COMM_WORLD);
  const Part part = mesher(random_pslg::all_families().front().make(13));
  std::size_t vertices = 0, triangles = 0;
  for (Part::Number v = 0; v < part.number_of_vertices(); ++v) {
    if (!part.knows_vertex(v)) continue;
    CHECK(part.number_of_vertex(part.index_of_vertex(v)) == v);
    ++vertices;
  }
  CHECK(vertices == part.points.size());
  for (Part::Number t = 0; t < part.number_of_triangles(); ++t) {
    if (!part.knows_triangle(t)) continue;
    CHECK(part.number_of_triangle(part.index_of_triangle(t)) == t);
    ++triangles;
  }
  CHECK(triangles == part.triangles.size());
  for (const auto& of_triangle : part.neighbors)
    for (const auto t : of_triangle) CHECK((t == -1 || part.knows_triangle(t)));
}

TEST_CASE("values that are too many at one rank are refused by all", "[distributed]") {
  const Part part;
  CGAL::Vertex_scatter_2 scatter(MPI_COMM_WORLD, part);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::vector<double> values(rank == 0 ? 1 : 0); // all have none
  CHECK_THROWS_AS(scatter.forward(values), std::invalid_argument);
  CHECK_THROWS_AS(scatter.add_backward(values), std::invalid_argument);
}

} // namespace test_vertex_scatter_2
