// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Graphs meshed by all ranks of MPI: the mesh and the report of one memory; the same errors at all ranks.

#include "catch.h"
#include "meshes_by_all_parts.h"
#include "random_pslg_shapes.h"

#include <CGAL/Distributed_quality_mesher_2.h>
#include <CGAL/IO/read_slices.h>
#include <CGAL/distribute_mesh_2.h>

#include <mpi.h>

#include <cstdint>
#include <string>

namespace test_distributed_quality_mesher_2 {

using namespace meshes_by_all_parts;
using Distributed_mesher = CGAL::Distributed_quality_mesher_2<>;

TEST_CASE("all ranks make the meshes of random graphs that one makes", "[distributed]") {
  Mpi_exchange exchange(MPI_COMM_WORLD);
  for (const auto& family : random_pslg::all_families()) {
    CAPTURE(family.name);
    const Pslg pslg = family.make(11);
    const Result expected = in_one_memory<Tiny_blocks_tag>(pslg, Options());
    CHECK(check_mesh_of_all<Tiny_blocks_tag>(exchange, expected, pslg, Options()) == "");
    CHECK(error_of_all<Tiny_blocks_tag>(exchange, pslg, sizes_that_fail(pslg)) == "no size is known here");
  }
}

TEST_CASE("all ranks mesh a coast that they have read in slices", "[distributed]") {
  // The larger one has blocks for each of four ranks; with fewer ranks the other one does, or some have none.
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const std::string name = is_full_run() || ranks == 4 ? "gshhg_norway_f.poly.gz" : "gshhg_aegean_h.poly.gz";
  const std::string file = QUADTREE_MESH_TEST_DATA_DIR "/" + name;
  Distributed_mesher::Pslg_slice slice;
  CGAL::IO::read_triangle_poly_slice(MPI_COMM_WORLD, file, slice);
  Distributed_mesher mesher(MPI_COMM_WORLD);
  const Part part = mesher(slice);
  CHECK(mesher.report().is_met());
  CHECK(CGAL::defect_of_distributed_mesh_2(MPI_COMM_WORLD, part) == "");
  const Mesh mesh = CGAL::gather_mesh_2(MPI_COMM_WORLD, part);
  Pslg pslg;
  CGAL::IO::read_triangle_poly(file, pslg);
  if (part.rank == 0) {
    const Result expected = in_one_memory<CGAL::Sequential_tag>(pslg, Options());
    CHECK(distributed_mesh_checks::is_same(mesh, expected.mesh));
    CHECK(is_same(mesher.report(), expected.report));
    CHECK(is_valid(mesh, pslg));
  }
}

TEST_CASE("a slice with a segment to nowhere is refused by all ranks", "[distributed]") {
  Mpi_exchange exchange(MPI_COMM_WORLD);
  Distributed_mesher::Pslg_slice slice;
  slice.vertices = {Point(exchange.rank(), 0), Point(exchange.rank(), 1)};
  slice.segments = {{0, 1}};
  if (exchange.rank() + 1 == exchange.size()) slice.segments.push_back({0, 100});
  std::string text;
  std::size_t segment = 0;
  try {
    Distributed_mesher mesher(MPI_COMM_WORLD);
    mesher(slice);
  } catch (const CGAL::Pslg_error_2& error) {
    text = error.what();
    if (!error.parts().segments.empty()) segment = std::size_t(error.parts().segments.front());
  }
  CHECK(segment == static_cast<std::size_t>(exchange.size()));
  CHECK(text == "segment " + std::to_string(exchange.size()) +
                    " ends at vertex 100, but the vertices are 0 to " +
                    std::to_string(2 * exchange.size() - 1));
}

} // namespace test_distributed_quality_mesher_2
