// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// All ranks run the same tests, in the same order. Tests use CHECK and not REQUIRE, so that a rank at which something
// is wrong still meets the others. Only the first rank tells that all is well; others tell what is wrong.

#define CATCH_CONFIG_RUNNER
#include "catch.h"

#include <mpi.h>

#include <iostream>
#include <sstream>
#include <streambuf>

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::ostringstream told;
  std::streambuf* const out = rank == 0 ? nullptr : std::cout.rdbuf(told.rdbuf());
  int failed = Catch::Session().run(argc, argv);
  if (out != nullptr) std::cout.rdbuf(out);
  if (rank != 0 && failed != 0) std::cout << "rank " << rank << ":\n" << told.str() << std::flush;
  MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return failed == 0 ? 0 : 1;
}
