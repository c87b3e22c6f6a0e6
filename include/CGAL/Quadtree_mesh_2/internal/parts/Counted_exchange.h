// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Counts what parts of a mesh send each other, superstep by superstep, as a machine with a memory for each would have
// to. In a superstep, all that one part has to tell another goes into one message. What a part tells itself is free.
//
// Sums over all parts, and scans, go up a binary tree of parts and down again. They count as 2 ceil(log2 P) messages
// for each of P parts, which is the most that one of them sends.
//
// Nothing is delivered: all parts are in one memory. Expected O(1) for what is sent; for each superstep O(P) time and
// memory, and O(1) more for each message in it.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARTS_COUNTED_EXCHANGE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARTS_COUNTED_EXCHANGE_H

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parts/Part_records.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The supersteps of a round, in their order; marks have one for each ring.
enum class Superstep_kind {
  CORNER_REQUESTS,
  CORNER_MARKS,
  MARKS,
  SUM_OF_SQUARES,
  SQUARE_COUNTS,
  SQUARE_WORKERS,
  FUTURE_OWNERS,
  TRIANGLES, ///< with their vertices and corners
  SEAMS,
  FLIPS,
  NAMES
};

inline const char* name_of(Superstep_kind kind) {
  static constexpr const char* names[] = {
      "corner requests", "corner marks", "marks", "sum of squares", "square counts", "square workers",
      "future owners",   "triangles",    "seams", "flips",          "names"};
  return names[static_cast<int>(kind)];
}

struct Traffic {
  std::size_t messages = 0, bytes = 0;

  Traffic& operator+=(const Traffic& other) {
    messages += other.messages, bytes += other.bytes;
    return *this;
  }
};

class Counted_exchange {
public:
  using Traffic_of_parts = Indexed_vector<Part_id, Traffic>;

  struct Superstep {
    int round;
    Superstep_kind kind;
    Traffic_of_parts sent, received;
  };

  /// \pre there is at least one part
  explicit Counted_exchange(std::size_t parts) : parts_(parts) {}

  std::size_t number_of_parts() const { return parts_; }

  /// Counts a record, or several, that go out at the end of the superstep.
  template <class Record>
  void send(Part_id from, Part_id to, std::size_t number = 1) {
    if (from != to && number > 0) bytes_[from.value() * parts_ + to.value()] += number * sizeof(Record);
  }

  /// Ends a superstep, which counts unless nobody had anything to say.
  void end_superstep(int round, Superstep_kind kind) {
    if (bytes_.empty()) return;
    Superstep step = empty_step(round, kind);
    for (const auto& [sender_and_receiver, bytes] : bytes_) {
      step.sent[static_cast<Part_id>(sender_and_receiver / parts_)] += {1, bytes};
      step.received[static_cast<Part_id>(sender_and_receiver % parts_)] += {1, bytes};
    }
    bytes_.clear();
    supersteps_.push_back(std::move(step));
  }

  /// Counts one sum or scan over all parts, of so many numbers at once.
  void sum(int round, Superstep_kind kind, std::size_t numbers) {
    std::size_t messages = 0;
    for (std::size_t reached = 1; reached < parts_; reached *= 2) messages += 2;
    if (messages == 0) return;
    Superstep step = empty_step(round, kind);
    const Traffic traffic{messages, messages * numbers * sizeof(std::uint64_t)};
    std::fill(step.sent.begin(), step.sent.end(), traffic);
    std::fill(step.received.begin(), step.received.end(), traffic);
    supersteps_.push_back(std::move(step));
  }

  const std::vector<Superstep>& supersteps() const { return supersteps_; }

  /// What each part has sent in all.
  Traffic_of_parts sent() const {
    Traffic_of_parts sum(parts_);
    for (const Superstep& step : supersteps_)
      for (const Part_id p : sum.ids()) sum[p] += step.sent[p];
    return sum;
  }

private:
  std::size_t parts_;
  std::unordered_map<std::size_t, std::size_t> bytes_; // of this superstep's messages, by sender and receiver
  std::vector<Superstep> supersteps_;

  Superstep empty_step(int round, Superstep_kind kind) const {
    return {round, kind, Traffic_of_parts(parts_), Traffic_of_parts(parts_)};
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARTS_COUNTED_EXCHANGE_H
