// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Parts in one memory: what is sent arrives, once and in order; sums, scans and errors are the same for all.

#include "catch.h"
#include "exchange_checks.h"

#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>

#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_in_memory_exchange {

using namespace CGAL::Quadtree_mesh_2::internal;

TEST_CASE("parts in one memory exchange parcels, numbers and errors", "[distributed][threads]") {
  const int parts = GENERATE(1, 2, 3, 7, 16, is_full_run() ? 64 : 30);
  const int steps = is_full_run() ? 20 : 5;
  std::atomic<int> wrong{0};
  In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
    wrong += exchange_checks::check_exchanges(exchange, steps);
    wrong += exchange_checks::check_numbers(exchange);
    wrong += exchange_checks::check_records(exchange, steps);
    wrong += exchange_checks::check_errors(exchange);
    wrong += exchange_checks::check_exchanges(exchange, 5);
  });
  CHECK(wrong == 0);
}

TEST_CASE("one part alone exchanges with itself", "[distributed]") {
  Local_exchange exchange;
  CHECK(exchange_checks::check_exchanges(exchange, 20) == 0);
  CHECK(exchange_checks::check_numbers(exchange) == 0);
  CHECK(exchange_checks::check_records(exchange, 20) == 0);
  CHECK(exchange_checks::check_errors(exchange) == 0);
  CHECK(exchange.traffic().messages == 0);
}

TEST_CASE("parts in one memory count what they send to others", "[distributed]") {
  const auto traffic = In_memory_exchange::run(5, [](In_memory_exchange& exchange) {
    Records_of_parts<double> outbox;
    outbox[exchange.rank()] = {1, 2, 3};
    if (exchange.rank() > 0) outbox[exchange.rank() - 1] = {4, 5};
    outbox[4] = {}; // nothing to say
    exchange_records(exchange, std::move(outbox));
    exchange.sum(1);
  });
  for (std::size_t part = 0; part < 5; ++part) {
    CHECK(traffic[part].messages == (part == 0 ? 0 : 1));
    CHECK(traffic[part].bytes == (part == 0 ? 0 : 2 * sizeof(double)));
    CHECK(traffic[part].exchanges == 1);
    CHECK(traffic[part].collectives == 1);
  }
}

TEST_CASE("an error that parts do not agree on ends all of them", "[distributed][threads]") {
  const int parts = GENERATE(1, 2, 9);
  for (int bad = 0; bad < parts; ++bad)
    for (int others = 0; others < 5; ++others) {
      const auto run = [&] {
        In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
          exchange_checks::check_exchanges(exchange, 2);
          if (exchange.rank() == bad) throw std::length_error("alone");
          Bytes bytes;
          for (;;) {
            if (others == 0) exchange.sum(1);
            if (others == 1) exchange.exclusive_scan(1);
            if (others == 2) exchange.gather(1);
            if (others == 3) exchange.broadcast(bytes, bad);
            if (others == 4) exchange.exchange({});
          }
        });
      };
      CHECK_THROWS_AS(run(), std::length_error);
    }
}

TEST_CASE("of errors that parts do not agree on the lowest part's is told", "[distributed][threads]") {
  const auto run = [] {
    In_memory_exchange::run(5, [](In_memory_exchange& exchange) {
      exchange.sum(1);
      if (exchange.rank() == 2) throw std::invalid_argument("lowest");
      if (exchange.rank() == 4) throw std::length_error("highest");
      exchange.sum(1);
    });
  };
  for (int i = 0; i < 20; ++i) CHECK_THROWS_AS(run(), std::invalid_argument);
}

TEST_CASE("half a record is no record", "[distributed]") {
  CHECK_THROWS_AS(records_of<double>(Bytes(12)), std::logic_error);
  CHECK(records_of<double>(Bytes()).empty());
}

} // namespace test_in_memory_exchange
