// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Ranks of MPI: what is sent arrives, once and in order, also in several messages; sums, scans and errors are the same
// for all.

#include "catch.h"
#include "exchange_checks.h"

#include <CGAL/Quadtree_mesh_2/internal/distributed/Mpi_exchange.h>

#include <mpi.h>

#include <cstddef>

namespace test_mpi_exchange {

using namespace CGAL::Quadtree_mesh_2::internal;

TEST_CASE("ranks exchange parcels, numbers and errors", "[distributed]") {
  const std::size_t longest_message = GENERATE(std::size_t(1) << 30, 7);
  Mpi_exchange exchange(MPI_COMM_WORLD, longest_message);
  CHECK(exchange_checks::check_exchanges(exchange, 50) == 0);
  CHECK(exchange_checks::check_numbers(exchange) == 0);
  CHECK(exchange_checks::check_records(exchange, is_full_run() ? 20 : 8) == 0);
  CHECK(exchange_checks::check_errors(exchange) == 0);
  CHECK(exchange_checks::check_exchanges(exchange, 50) == 0);
}

TEST_CASE("two exchanges of the same ranks do not meet", "[distributed]") {
  Mpi_exchange first(MPI_COMM_WORLD), second(MPI_COMM_WORLD);
  CHECK(exchange_checks::check_exchanges(first, 3) == 0);
  CHECK(exchange_checks::check_exchanges(second, 3) == 0);
  CHECK(exchange_checks::check_exchanges(first, 3) == 0);
}

TEST_CASE("ranks of a part of the communicator exchange among themselves", "[distributed]") {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm half = MPI_COMM_NULL;
  MPI_Comm_split(MPI_COMM_WORLD, rank % 2, rank, &half);
  {
    Mpi_exchange exchange(half);
    CHECK(exchange_checks::check_exchanges(exchange, 5) == 0);
    CHECK(exchange_checks::check_numbers(exchange) == 0);
  }
  MPI_Comm_free(&half);
}

} // namespace test_mpi_exchange
