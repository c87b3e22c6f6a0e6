// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// An exchange between parts that are threads of one process: a model of several machines, for tests and counts.
//
// Nothing of one part is seen by another but what they send. If a part ends by an exception that it did not agree on
// with the others, these end where they meet next, instead of waiting without end.
// O(P) time for each function, besides what is sent.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_IN_MEMORY_EXCHANGE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_IN_MEMORY_EXCHANGE_H

#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Where the parts of an `In_memory_exchange` meet.
class Meeting_place {
public:
  /// Thrown at all other parts where one has left.
  struct Abandoned : std::runtime_error {
    Abandoned() : std::runtime_error("another part has ended by an error") {}
  };

  explicit Meeting_place(int parts) : inboxes(at(parts)), numbers(at(parts)), parts_(parts) {}

  /// Waits until all parts are here.
  /// \throws Abandoned if one has left
  void meet() {
    std::unique_lock<std::mutex> lock(mutex_);
    if (is_abandoned_) throw Abandoned();
    const std::size_t meeting = meeting_;
    if (++present_ == parts_) {
      present_ = 0, ++meeting_;
      all_are_here_.notify_all();
      return;
    }
    all_are_here_.wait(lock, [&] { return meeting_ != meeting || is_abandoned_; });
    if (meeting_ == meeting) throw Abandoned();
  }
  void leave() {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_abandoned_ = true;
    all_are_here_.notify_all();
  }

  void deliver(int from, int to, Bytes bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    inboxes[at(to)].push_back({from, std::move(bytes)});
  }

  // By part. Only between two meetings does a part read what others have put here.
  std::vector<Parcels> inboxes;
  std::vector<Numbers> numbers;
  Bytes announced;

private:
  static std::size_t at(int part) { return static_cast<std::size_t>(part); }

  std::mutex mutex_;
  std::condition_variable all_are_here_;
  int parts_, present_ = 0;
  std::size_t meeting_ = 0;
  bool is_abandoned_ = false;
};

/// See the head of this file.
class In_memory_exchange : public Exchange_base<In_memory_exchange> {
public:
  using Exchange_base::exclusive_scan;
  using Exchange_base::gather;
  using Exchange_base::max;
  using Exchange_base::min;
  using Exchange_base::sum;

  /// Runs `work(exchange)` as each of so many parts. \returns what each has sent
  /// \throws what the lowest part threw that did not end because of another
  template <class Work>
  static std::vector<Exchange_traffic> run(int parts, const Work& work) {
    Meeting_place place(parts);
    std::vector<Exchange_traffic> traffic(static_cast<std::size_t>(parts));
    std::vector<std::exception_ptr> errors(traffic.size());
    std::vector<std::thread> threads;
    for (int part = 0; part < parts; ++part)
      threads.emplace_back([&, part] {
        In_memory_exchange exchange(place, part, parts);
        try {
          work(exchange);
        } catch (const Meeting_place::Abandoned&) {
        } catch (...) {
          errors[static_cast<std::size_t>(part)] = std::current_exception();
          place.leave();
        }
        traffic[static_cast<std::size_t>(part)] = exchange.traffic();
      });
    for (std::thread& thread : threads) thread.join();
    for (const std::exception_ptr& error : errors)
      if (error) std::rethrow_exception(error);
    return traffic;
  }

  int rank() const { return rank_; }
  int size() const { return size_; }

  Parcels exchange(Parcels outbox) {
    count(outbox);
    for (Parcel& parcel : outbox) place_.deliver(rank_, parcel.part, std::move(parcel.bytes));
    place_.meet();
    Parcels inbox = std::move(place_.inboxes[static_cast<std::size_t>(rank_)]);
    place_.inboxes[static_cast<std::size_t>(rank_)].clear();
    place_.meet(); // nobody delivers the next parcels before all have taken these
    std::sort(inbox.begin(), inbox.end(), [](const Parcel& a, const Parcel& b) { return a.part < b.part; });
    return inbox;
  }

  void sum(Numbers& values) { combine(values, size_, add); }
  void min(Numbers& values) {
    combine(values, size_, [](std::int64_t a, std::int64_t b) { return std::min(a, b); });
  }
  void max(Numbers& values) {
    combine(values, size_, [](std::int64_t a, std::int64_t b) { return std::max(a, b); });
  }
  void exclusive_scan(Numbers& values) { combine(values, rank_, add); }

  void broadcast(Bytes& bytes, int root) {
    count_collective();
    if (rank_ == root) place_.announced = bytes;
    place_.meet();
    if (rank_ != root) bytes = place_.announced;
    place_.meet();
  }

  Numbers gather(const Numbers& values) {
    Numbers all;
    share(values, [&](const std::vector<Numbers>& of_parts) {
      for (const Numbers& of_part : of_parts) all.insert(all.end(), of_part.begin(), of_part.end());
    });
    return all;
  }

private:
  In_memory_exchange(Meeting_place& place, int rank, int size) : place_(place), rank_(rank), size_(size) {}

  static std::int64_t add(std::int64_t a, std::int64_t b) { return a + b; }

  template <class Read>
  void share(const Numbers& values, const Read& read) {
    count_collective();
    place_.numbers[static_cast<std::size_t>(rank_)] = values;
    place_.meet();
    read(place_.numbers);
    place_.meet();
  }

  /// Replaces values by those of the first parts, 0 of none.
  template <class Combine>
  void combine(Numbers& values, int parts, const Combine& f) {
    Numbers result(values.size(), 0);
    share(values, [&](const std::vector<Numbers>& of_parts) {
      for (int part = 0; part < parts; ++part)
        for (std::size_t i = 0; i < result.size(); ++i) {
          const std::int64_t value = of_parts[static_cast<std::size_t>(part)][i];
          result[i] = part == 0 ? value : f(result[i], value);
        }
    });
    values = std::move(result);
  }

  Meeting_place& place_;
  int rank_, size_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_IN_MEMORY_EXCHANGE_H
