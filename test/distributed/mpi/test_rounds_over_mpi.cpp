// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Rounds of blocks of a mesh whose parts are ranks of MPI: the bits of one memory.

#include "catch.h"
#include "random_pslg_shapes.h"
#include "rounds_of_parts_checks.h"
#include "tiny_blocks.h"

#include <CGAL/Quadtree_mesh_2/internal/distributed/Mpi_exchange.h>

#include <mpi.h>

#include <cstdint>

namespace test_rounds_over_mpi {

using namespace rounds_of_parts_checks;

TEST_CASE("rounds of blocks of all ranks have the bits of one memory", "[distributed]") {
  Mpi_exchange exchange(MPI_COMM_WORLD);
  const auto unchanged = [](Prepared&) {};
  int cut = 0;
  for (const auto& family : random_pslg::all_families())
    for (std::uint64_t seed = 100; seed < (is_full_run() ? 102 : 101); ++seed) {
      CAPTURE(family.name, seed);
      const auto pslg = family.make(seed);
      const One_memory<Tiny_blocks_tag> expected(pslg, unchanged);
      const Comparison comparison = compare_with_one_memory(exchange, expected, pslg, unchanged);
      CHECK(comparison.faults == 0);
      if (comparison.has_blocks) ++cut;
    }
  CHECK(cut > 5);
}

} // namespace test_rounds_over_mpi
