// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where the keys of parts are in the order of all of them.
//
// Computes: for each of this part's keys, how many keys of all parts are less. Keys are distinct, and their upper 32
//           bits are numbers from 0 on, of which all are about as frequent: numbers of vertices in the order of places.
// Bound:    O(k) time and 24 bytes for each of k keys of a part. A key is sent once, to the part of its upper bits, and
//           4 bytes come back.
// Source:   sorting by buckets; there is nothing to sample, as numbers are spread evenly.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_KEY_RANKER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_KEY_RANKER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Key_positions = Uninitialized_vector<std::uint32_t>;

template <class Exchange>
class Key_ranker {
public:
  /// \param range upper bits are below this
  Key_ranker(Exchange& exchange, std::uint64_t range) : exchange_(exchange), range_(range) {}

  Key_positions positions_of(const Uninitialized_vector<std::uint64_t>& own) {
    receive(own);
    const Records_of_parts<std::uint32_t> found = exchange_records(exchange_, sorted());
    Key_positions positions(own.size());
    std::vector<std::size_t> next(static_cast<std::size_t>(exchange_.size()), 0);
    for (std::size_t i = 0; i < own.size(); ++i) {
      const int part = part_of(own[i]);
      positions[i] = found.at(part)[next[static_cast<std::size_t>(part)]++];
    }
    return positions;
  }

private:
  /// How many keys are on their way at a time.
  static constexpr std::size_t at_a_time = std::size_t(1) << 16;

  Exchange& exchange_;
  std::uint64_t range_;
  std::vector<Uninitialized_vector<std::uint64_t>> received_; // by sender

  int part_of(std::uint64_t key) const {
    return static_cast<int>((key >> 32) * static_cast<std::uint64_t>(exchange_.size()) / range_);
  }

  void receive(const Uninitialized_vector<std::uint64_t>& own) {
    received_.resize(static_cast<std::size_t>(exchange_.size()));
    const auto end = static_cast<std::size_t>(exchange_.max(static_cast<std::int64_t>(own.size())));
    for (std::size_t begin = 0; begin < end; begin += at_a_time) {
      Records_of_parts<std::uint64_t> outbox;
      for (std::size_t i = begin; i < std::min(own.size(), begin + at_a_time); ++i)
        outbox[part_of(own[i])].push_back(own[i]);
      for (const auto& [part, keys] : exchange_records(exchange_, std::move(outbox))) {
        auto& of_part = received_[static_cast<std::size_t>(part)];
        of_part.insert(of_part.end(), keys.begin(), keys.end());
      }
    }
  }

  /// The positions of what has been received, for the senders.
  Records_of_parts<std::uint32_t> sorted() {
    Uninitialized_vector<std::uint64_t> all;
    std::vector<std::size_t> first{0};
    for (const auto& of_part : received_) first.push_back(first.back() + of_part.size());
    all.reserve(first.back());
    for (auto& of_part : received_) {
      all.insert(all.end(), of_part.begin(), of_part.end());
      free_arrays(of_part);
    }
    const auto begin =
        static_cast<std::uint32_t>(exchange_.exclusive_scan(static_cast<std::int64_t>(all.size())));
    const Order order = radix_order(all.size(), [&all](std::size_t i) { return all[i]; });
    free_arrays(all);
    std::vector<std::vector<std::uint32_t>> positions(first.size() - 1); // by sender
    for (std::size_t part = 0; part < positions.size(); ++part)
      positions[part].resize(first[part + 1] - first[part]);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto behind = std::upper_bound(first.begin(), first.end(), std::size_t(order[i]));
      const auto part = static_cast<std::size_t>(behind - first.begin()) - 1;
      positions[part][order[i] - first[part]] = begin + static_cast<std::uint32_t>(i);
    }
    Records_of_parts<std::uint32_t> answers;
    for (std::size_t part = 0; part < positions.size(); ++part)
      answers[static_cast<int>(part)] = std::move(positions[part]);
    return answers;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_KEY_RANKER_H
