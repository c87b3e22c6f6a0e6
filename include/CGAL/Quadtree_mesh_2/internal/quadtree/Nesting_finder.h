// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The nesting of intervals that a sequence of levels induces.
//
// Computes: from the level of each gap between neighbors in a sequence, the intervals that these levels
//           induce. The interval of a gap is the largest one around it in which no gap is shallower.
//           Intervals are listed in preorder, each with the end of its subtree. For each gap, its interval is
//           the smallest one around it.
// Bound:    O(n) work. O(1) rounds over blocks of gaps, and a pass over blocks that takes O(log n) for each.
// Source:   Bern, Eppstein, Teng, Lemma 3: all nearest larger values. Berkman, Schieber, Vishkin, "Optimal
//           doubly logarithmic parallel algorithms based on finding all nearest smaller values", for cutting
//           the sequence into blocks that need only the minima around them.
// Method:   From right to left, a stack holds the gaps of the intervals that are open. Each gap is the next
//           shallower one to the right of the gap above it. So gaps get shallower toward the bottom. The
//           stack with which a block begins can be read from the sequence: it is the chain of next shallower
//           gaps from the block's right end. The piece of that chain in a block is found without the other
//           blocks.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_NESTING_FINDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_NESTING_FINDER_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The intervals of a sequence in preorder. Interval v has the members `begin[v]` to `end[v]` (exclusive).
template <class Level>
struct Nested_intervals {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  Uninitialized_vector<std::uint32_t> begin;
  Uninitialized_vector<std::uint32_t> end;
  Uninitialized_vector<Level> level;
  /// The first interval after the descendants.
  Uninitialized_vector<std::uint32_t> subtree_end;
  /// By gap: its level, and the smallest interval with members to both sides, which has the same level.
  Uninitialized_vector<Level> gap_level;
  Uninitialized_vector<std::uint32_t> of_gap;

  std::size_t size() const { return begin.size(); }
};

/// Finds the nested intervals, see the head of this file.
template <class ConcurrencyTag, class Level>
class Nesting_finder {
public:
  /// \param levels `levels[i]` is the level of gap i, between members i and i + 1.
  explicit Nesting_finder(Uninitialized_vector<Level> levels)
      : blocks_((levels.size() + block_length_ - 1) / block_length_) {
    result_.gap_level = std::move(levels);
  }

  /// Gaps of equal level with no shallower gap between them give the same interval, once.
  Nested_intervals<Level> find() {
    for_each_block<ConcurrencyTag>(
        levels_.size(), block_length_,
        [&](std::size_t b, std::size_t begin, std::size_t end) { find_chain(blocks_[b], begin, end); });
    for (std::size_t b = blocks_.size(); b-- > 0;) continue_chain(b);
    result_.of_gap.resize(levels_.size());
    for_each_block<ConcurrencyTag>(
        levels_.size(), block_length_,
        [&](std::size_t b, std::size_t begin, std::size_t end) { close_intervals(b, begin, end); });
    place_intervals();
    find_subtree_ends();
    return std::move(result_);
  }

private:
  static constexpr std::size_t block_length_ = default_block;
  static constexpr std::uint32_t none_ = Nested_intervals<Level>::none;

  /// A member of the chain of next shallower gaps: number `at` of those that block `block` holds.
  struct Chain_place {
    std::size_t block;
    std::size_t at;
  };

  struct Closed_interval {
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t leftmost_gap;
  };

  struct Block {
    std::vector<std::uint32_t> chain; ///< from the block's first gap on
    Chain_place next{0, 0};           ///< behind the last one; past all blocks if there is none
    std::vector<Closed_interval> closed;
  };

  /// Finds the strict minima of the prefixes of a block.
  void find_chain(Block& block, std::size_t begin, std::size_t end) const {
    for (std::size_t i = begin; i < end; ++i)
      if (block.chain.empty() || levels_[i] < levels_[block.chain.back()])
        block.chain.push_back(static_cast<std::uint32_t>(i));
  }

  bool is_in_chain(const Chain_place& p) const { return p.block < blocks_.size(); }
  std::uint32_t gap(const Chain_place& p) const { return blocks_[p.block].chain[p.at]; }
  Chain_place next(const Chain_place& p) const {
    const Block& block = blocks_[p.block];
    return p.at + 1 < block.chain.size() ? Chain_place{p.block, p.at + 1} : block.next;
  }

  /// Finds the first gap to the right of block `b` that is shallower than all of the block.
  void continue_chain(std::size_t b) {
    const Level least = levels_[blocks_[b].chain.back()];
    Chain_place place{b + 1, 0};
    while (is_in_chain(place)) {
      const std::vector<std::uint32_t>& chain = blocks_[place.block].chain;
      const auto first = chain.begin() + static_cast<std::ptrdiff_t>(place.at);
      const auto found =
          std::partition_point(first, chain.end(), [&](std::uint32_t g) { return levels_[g] >= least; });
      if (found != chain.end()) {
        place.at = static_cast<std::size_t>(found - chain.begin());
        break;
      }
      place = blocks_[place.block].next;
    }
    blocks_[b].next = place;
  }

  /// The open intervals, by their leftmost gaps: those that this block opened, above a part of the chain.
  class Open_intervals {
  public:
    Open_intervals(const Nesting_finder& finder, const Chain_place& below) : finder_(finder), below_(below) {}

    bool is_empty() const { return own_.empty() && !finder_.is_in_chain(below_); }
    std::uint32_t top() const { return own_.empty() ? finder_.gap(below_) : own_.back(); }
    void push(std::uint32_t gap) { own_.push_back(gap); }
    void pop() {
      if (own_.empty())
        below_ = finder_.next(below_);
      else
        own_.pop_back();
    }

  private:
    const Nesting_finder& finder_;
    std::vector<std::uint32_t> own_;
    Chain_place below_;
  };

  /// Goes from right to left through a block. An interval closes after those inside it, the right ones first:
  /// preorder backwards. Gaps of an interval are linked from left to right in `of_gap`.
  void close_intervals(std::size_t b, std::size_t begin, std::size_t end) {
    std::vector<Closed_interval>& closed = blocks_[b].closed;
    closed.reserve(end - begin);
    Open_intervals open(*this, {b + 1, 0});
    const auto close = [&](std::uint32_t interval_begin) {
      const std::uint32_t leftmost_gap = open.top();
      open.pop();
      const std::uint32_t interval_end =
          open.is_empty() ? static_cast<std::uint32_t>(levels_.size() + 1) : open.top() + 1;
      closed.push_back({interval_begin, interval_end, leftmost_gap});
    };
    for (std::size_t i = end; i-- > begin;) {
      const std::uint32_t gap = static_cast<std::uint32_t>(i);
      while (!open.is_empty() && levels_[open.top()] > levels_[i]) close(gap + 1);
      result_.of_gap[i] = none_;
      if (!open.is_empty() && levels_[open.top()] == levels_[i]) {
        result_.of_gap[i] = open.top();
        open.pop();
      }
      open.push(gap);
    }
    if (b == 0)
      while (!open.is_empty()) close(0);
  }

  void place_intervals() {
    std::vector<std::size_t> after(blocks_.size()); // how many intervals follow those that a block closed
    std::size_t sum = 0;
    for (std::size_t b = blocks_.size(); b-- > 0;) {
      after[b] = sum;
      sum += blocks_[b].closed.size();
    }
    result_.begin.resize(sum);
    result_.end.resize(sum);
    result_.level.resize(sum);
    Executor<ConcurrencyTag>::run(blocks_.size(), [&](std::size_t b) {
      std::size_t v = sum - after[b];
      for (const Closed_interval& interval : blocks_[b].closed) {
        --v;
        result_.begin[v] = interval.begin;
        result_.end[v] = interval.end;
        result_.level[v] = levels_[interval.leftmost_gap];
        for (std::uint32_t gap = interval.leftmost_gap; gap != none_;) {
          const std::uint32_t next_gap = result_.of_gap[gap];
          result_.of_gap[gap] = static_cast<std::uint32_t>(v);
          gap = next_gap;
        }
      }
      std::vector<Closed_interval>().swap(blocks_[b].closed);
    });
  }

  /// The first interval after the descendants of one is the first that begins where it ends, or later.
  void find_subtree_ends() {
    const std::size_t m = result_.size();
    Uninitialized_vector<std::uint32_t> first_from(levels_.size() + 2); // by member: the first from there on
    for_each_index<ConcurrencyTag>(m + 1, [&](std::size_t v) {
      const std::size_t from = v == 0 ? 0 : result_.begin[v - 1] + std::size_t(1);
      const std::size_t to = v == m ? first_from.size() : result_.begin[v] + std::size_t(1);
      for (std::size_t p = from; p < to; ++p) first_from[p] = static_cast<std::uint32_t>(v);
    });
    result_.subtree_end.resize(m);
    for_each_index<ConcurrencyTag>(
        m, [&](std::size_t v) { result_.subtree_end[v] = first_from[result_.end[v]]; });
  }

  std::vector<Block> blocks_;
  Nested_intervals<Level> result_;
  const Uninitialized_vector<Level>& levels_ = result_.gap_level;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_NESTING_FINDER_H
