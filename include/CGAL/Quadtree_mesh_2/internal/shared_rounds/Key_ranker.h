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
// Bound:    O(k + m) time for k keys that a part has and m that it gets. A key takes 5 bytes, and some 40 in its pass.
//           It is sent once, to the part of its upper bits, and 4 bytes come back.
// Method:   sorting by buckets, some on each part, with a pass for one bucket of each. There is nothing to sample, as
//           numbers are spread evenly.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_KEY_RANKER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_KEY_RANKER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
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
  /// \param at_a_time about how many keys of a part are in a pass, if there are not many more
  Key_ranker(Exchange& exchange, std::uint64_t range, std::size_t at_a_time = std::size_t(1) << 16)
      : exchange_(exchange), range_(range), at_a_time_(at_a_time) {}

  Key_positions positions_of(const Uninitialized_vector<std::uint64_t>& own) {
    const auto most = static_cast<std::size_t>(exchange_.max(static_cast<std::int64_t>(own.size())));
    buckets_of_part_ = std::min((most + at_a_time_ - 1) / at_a_time_, most_passes);
    pass_of_.resize(own.size());
    for (std::size_t i = 0; i < own.size(); ++i)
      pass_of_[i] = static_cast<unsigned char>(bucket_of(own[i]) % buckets_of_part_);
    Key_positions positions(own.size());
    std::uint32_t received = 0;
    for (std::size_t pass = 0; pass < buckets_of_part_; ++pass) rank(own, pass, received, positions);
    std::vector<std::uint32_t> first_of_part{0};
    for (const std::int64_t n : exchange_.gather({static_cast<std::int64_t>(received)}))
      first_of_part.push_back(first_of_part.back() + static_cast<std::uint32_t>(n));
    for (std::size_t i = 0; i < own.size(); ++i) positions[i] += first_of_part[part_of(own[i])];
    return positions;
  }

private:
  using Keys = Records_of_parts<std::uint64_t>;
  using Positions = Records_of_parts<std::uint32_t>;

  /// Each looks at a byte of all keys.
  static constexpr std::size_t most_passes = 16;

  Exchange& exchange_;
  std::uint64_t range_;
  std::size_t at_a_time_, buckets_of_part_ = 1;
  Uninitialized_vector<unsigned char> pass_of_; // of each own key

  std::size_t bucket_of(std::uint64_t key) const {
    const std::uint64_t buckets = static_cast<std::uint64_t>(exchange_.size()) * buckets_of_part_;
    return static_cast<std::size_t>((key >> 32) * buckets / range_);
  }
  std::size_t part_of(std::uint64_t key) const { return bucket_of(key) / buckets_of_part_; }

  /// Finds where the keys of a pass are among those that their part has received up to then.
  /// \param received how many this part has received before; becomes more
  void rank(const Uninitialized_vector<std::uint64_t>& own, std::size_t pass, std::uint32_t& received,
            Key_positions& positions) {
    const auto for_each_in_pass = [&](const auto& f) {
      for (std::size_t i = 0; i < own.size(); ++i)
        if (pass_of_[i] == pass) f(i, part_of(own[i]));
    };
    Keys outbox;
    for_each_in_pass(
        [&](std::size_t i, std::size_t part) { outbox[static_cast<int>(part)].push_back(own[i]); });
    const Keys inbox = exchange_records(exchange_, std::move(outbox));
    const Positions found = exchange_records(exchange_, positions_in(inbox, received));
    for (const auto& [sender, keys] : inbox) received += static_cast<std::uint32_t>(keys.size());
    std::vector<std::size_t> next(static_cast<std::size_t>(exchange_.size()), 0);
    for_each_in_pass([&](std::size_t i, std::size_t part) {
      positions[i] = found.at(static_cast<int>(part))[next[part]++];
    });
  }

  /// The positions of keys in their order, the first of which has the position `begin`, by sender.
  static Positions positions_in(const Keys& keys, std::uint32_t begin) {
    Uninitialized_vector<std::uint64_t> all;
    std::vector<std::uint32_t*> to; // where those of each sender end
    std::vector<std::size_t> end;
    Positions positions;
    for (const auto& [sender, of_sender] : keys) {
      all.insert(all.end(), of_sender.begin(), of_sender.end());
      positions[sender].resize(of_sender.size());
      to.push_back(positions[sender].data() + of_sender.size()), end.push_back(all.size());
    }
    const Order order = radix_order(all.size(), [&all](std::size_t i) { return all[i]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto sender = static_cast<std::size_t>(
          std::upper_bound(end.begin(), end.end(), std::size_t(order[i])) - end.begin());
      *(to[sender] - (end[sender] - order[i])) = begin + static_cast<std::uint32_t>(i);
    }
    return positions;
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_KEY_RANKER_H
