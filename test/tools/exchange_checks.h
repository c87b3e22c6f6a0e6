// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_EXCHANGE_CHECKS_H
#define QUADTREE_MESH_2_TEST_EXCHANGE_CHECKS_H

// What has to hold of every exchange. All parts run these checks, and none ends before the others: what is wrong is
// counted, and told at the end.

#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace exchange_checks {

using namespace CGAL::Quadtree_mesh_2::internal;

/// A number that both ends of a message know: how many bytes `from` sends to `to` in step `step`, or -1 for nothing.
inline int length_of(int from, int to, int step) {
  std::mt19937 random(static_cast<unsigned>(from * 7919 + to * 104729 + step * 1299709));
  random.discard(3);
  const unsigned kind = static_cast<unsigned>(random()) % 8;
  return kind < 5 ? -1 : kind == 5 ? 0 : static_cast<int>(random() % 2000);
}
inline char byte_of(int from, int to, int step, int i) {
  return static_cast<char>(from * 31 + to * 17 + step * 5 + i);
}

/// Random sparse patterns, step after step without a pause. \returns how much is wrong
template <class Exchange>
int check_exchanges(Exchange& exchange, int steps) {
  int wrong = 0;
  const int me = exchange.rank();
  for (int step = 0; step < steps; ++step) {
    Parcels outbox;
    for (int to = exchange.size() - 1; to >= 0; --to) {
      const int n = length_of(me, to, step);
      if (n < 0) continue;
      outbox.push_back({to, {}});
      for (int i = 0; i < n; ++i) outbox.back().bytes.push_back(byte_of(me, to, step, i));
    }
    const Parcels inbox = exchange.exchange(std::move(outbox));
    std::size_t next = 0;
    for (int from = 0; from < exchange.size(); ++from) {
      const int n = length_of(from, me, step);
      if (n < 0) continue;
      if (next == inbox.size()) return wrong + 1;
      const Parcel& parcel = inbox[next++];
      wrong += parcel.part != from || parcel.bytes.size() != static_cast<std::size_t>(n);
      for (std::size_t i = 0; i < parcel.bytes.size(); ++i)
        wrong += parcel.bytes[i] != byte_of(from, me, step, static_cast<int>(i));
    }
    wrong += next != inbox.size();
  }
  return wrong;
}

/// Records by sender, and those of all senders one after the other, with what a part tells itself at its place.
template <class Exchange>
int check_records(Exchange& exchange, int steps) {
  using Record = std::array<std::int64_t, 3>; // from, to, number
  int wrong = 0;
  const int me = exchange.rank();
  for (int step = 0; step < steps; ++step) {
    Records_of_parts<Record> outbox, expected;
    for (int part = 0; part < exchange.size(); ++part) {
      const int to_part = length_of(me, part, step), from_part = length_of(part, me, step);
      for (int i = 0; i < to_part; ++i) outbox[part].push_back({me, part, i});
      for (int i = 0; i < from_part; ++i) expected[part].push_back({part, me, i});
    }
    wrong += exchange_records(exchange, outbox) != expected;
    std::vector<Record> all;
    for (const auto& of_part : expected) all.insert(all.end(), of_part.second.begin(), of_part.second.end());
    wrong += exchange_and_join(exchange, std::move(outbox)) != all;
  }
  return wrong;
}

template <class Exchange>
int check_numbers(Exchange& exchange) {
  const std::int64_t me = exchange.rank(), n = exchange.size(), large = std::int64_t(1) << 40;
  int wrong = 0;
  wrong += exchange.sum(large + me) != n * large + n * (n - 1) / 2;
  wrong += exchange.min(5 - me) != 5 - (n - 1);
  wrong += exchange.max(me * large) != (n - 1) * large;
  wrong += exchange.exclusive_scan(large + me) != me * large + me * (me - 1) / 2;
  Numbers both{me, -me};
  exchange.sum(both);
  wrong += both != Numbers{n * (n - 1) / 2, -n * (n - 1) / 2};
  const Numbers all = exchange.gather(Numbers{me, large});
  wrong += all.size() != static_cast<std::size_t>(2 * n);
  for (std::int64_t i = 0; i < n; ++i)
    wrong += all[static_cast<std::size_t>(2 * i)] != i || all[static_cast<std::size_t>(2 * i + 1)] != large;
  for (int root = 0; root < std::min(exchange.size(), 3); ++root) {
    Bytes bytes;
    if (exchange.rank() == root) bytes.assign(static_cast<std::size_t>(1000 * root), 'x');
    exchange.broadcast(bytes, root);
    wrong += bytes != Bytes(static_cast<std::size_t>(1000 * root), 'x');
  }
  return wrong;
}

/// The text of what `work` throws, at this part.
template <class Exchange, class Work>
std::string agreed_error(Exchange& exchange, const Work& work) {
  try {
    agree_on_work(exchange, work);
  } catch (const CGAL::Quadtree_mesh_2::Distributed_point_error& error) {
    return "point: " + std::string(error.what());
  } catch (const CGAL::Pslg_error_2& error) {
    return "graph " + std::to_string(static_cast<int>(error.kind())) + ": " + error.what();
  } catch (const std::bad_alloc&) {
    return "memory";
  } catch (const std::length_error& error) {
    return "length: " + std::string(error.what());
  } catch (const std::invalid_argument& error) {
    return "argument: " + std::string(error.what());
  } catch (const std::runtime_error& error) {
    return "runtime: " + std::string(error.what());
  }
  return std::string();
}

/// Errors at one part, at several and at none.
template <class Exchange>
int check_errors(Exchange& exchange) {
  using CGAL::Pslg_error_2;
  using CGAL::Quadtree_mesh_2::Distributed_point_error;
  const int me = exchange.rank(), last = exchange.size() - 1;
  int wrong = 0;
  wrong += !agreed_error(exchange, [] {}).empty();
  wrong += agreed_error(exchange, [&] {
             if (me == last) throw std::length_error("too long");
           }) != "length: too long";
  wrong += agreed_error(exchange, [&] {
             if (me >= last / 2) throw std::runtime_error("part " + std::to_string(me));
           }) != "runtime: part " + std::to_string(last / 2);
  wrong += agreed_error(exchange, [&] {
             if (me == last)
               throw Distributed_point_error(Distributed_point_error::Kind::NOT_FINITE, std::int64_t(1) << 33,
                                             -1, "r");
           }) != "point: point 8589934592 r";
  wrong += agreed_error(exchange, [] {
             throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE, "f:7: x");
           }) != "graph 0: f:7: x";
  wrong += agreed_error(exchange, [] { throw std::bad_alloc(); }) != "memory";
  // The least item decides before the part does.
  try {
    agree_on_error(exchange, std::make_exception_ptr(std::invalid_argument(std::to_string(me))), 100 - me);
    ++wrong;
  } catch (const std::invalid_argument& error) {
    wrong += error.what() != std::to_string(last);
  }
  // Nobody is left behind.
  wrong += exchange.sum(1) != exchange.size();
  return wrong;
}

} // namespace exchange_checks

#endif // QUADTREE_MESH_2_TEST_EXCHANGE_CHECKS_H
