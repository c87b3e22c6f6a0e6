// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// What the points in each square of a framework have in common, a maximum for example.
//
// Computes: for each square of the framework the combination of the values of its points.
// Bound:    O(n) work, and O(b log b) for b blocks of points; O(1) rounds over blocks and log2 b short ones,
//           whatever the depth of the framework.
// Method:   The points of a square are an interval (Lemma 1). Squares are in preorder. So the values of a
//           square whose points are in one block follow from its children's, from the last square of the
//           block to the first. Any other interval is the end of a block, blocks, and the beginning of a
//           block. For the blocks between, two overlapping runs of 2^j blocks are combined.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_COMBINE_POINTS_OF_NODES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_COMBINE_POINTS_OF_NODES_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/bits.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The first node of a framework whose points begin at rank `p` or later.
template <class Framework>
std::size_t first_node_from(const Framework& framework, std::size_t p) {
  std::size_t low = 0, high = framework.number_of_nodes();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (framework.points(typename Framework::Node_index(middle)).begin.value() < p)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

/// Combines values of intervals of blocks: two look-ups for each.
template <class Value, class ConcurrencyTag, class Combine>
class Block_combinations {
public:
  /// \param values those of the blocks
  Block_combinations(std::vector<Value> values, const Combine& combine) : combine_(combine) {
    const std::size_t n = values.size();
    of_runs_.push_back(std::move(values));
    for (std::size_t length = 1; 2 * length <= n; length *= 2) {
      const std::vector<Value>& half = of_runs_.back();
      std::vector<Value> runs(n - 2 * length + 1);
      for_each_index<ConcurrencyTag>(runs.size(),
                                     [&](std::size_t i) { runs[i] = combine_(half[i], half[i + length]); });
      of_runs_.push_back(std::move(runs));
    }
  }

  /// \pre `begin < end`
  Value of(std::size_t begin, std::size_t end) const {
    const std::size_t j = static_cast<std::size_t>(bit_width(end - begin) - 1);
    return combine_(of_runs_[j][begin], of_runs_[j][end - (std::size_t(1) << j)]);
  }

private:
  const Combine& combine_;
  std::vector<std::vector<Value>> of_runs_; // number j of the runs of 2^j blocks, by their first block
};

/// Combines the values of the points in each node; see the head of this file.
template <class Value, class ConcurrencyTag, class Framework, class Of_point, class Combine>
class Node_combiner {
public:
  using Of_nodes = Indexed_vector<Node_index, Value, Uninitialized_allocator<Value>>;

  Node_combiner(const Framework& framework, const Of_point& of_point, const Combine& combine)
      : framework_(framework), of_point_(of_point), combine_(combine), of_node_(framework.number_of_nodes()),
        up_to_(framework.number_of_points()), of_block_((up_to_.size() + block_length_ - 1) / block_length_) {
  }

  Of_nodes find() {
    for_each_block<ConcurrencyTag>(up_to_.size(), block_length_,
                                   [&](std::size_t b, std::size_t begin, std::size_t end) {
                                     combine_points(b, begin, end);
                                     combine_nodes(begin, end);
                                   });
    if (of_block_.size() > 1) add_further_blocks();
    return std::move(of_node_);
  }

private:
  static constexpr std::size_t block_length_ = default_block;

  void combine_points(std::size_t b, std::size_t begin, std::size_t end) {
    up_to_[begin] = of_point_(begin);
    for (std::size_t p = begin + 1; p < end; ++p) up_to_[p] = combine_(up_to_[p - 1], of_point_(p));
    of_block_[b] = up_to_[end - 1];
  }

  /// Combines the points of the nodes that begin in a block, as far as they are in it.
  void combine_nodes(std::size_t begin, std::size_t end) {
    std::size_t p = end - 1;
    Value from = of_point_(p); // from p to the end of the block
    const std::size_t first = first_node_from(framework_, begin);
    for (std::size_t v = first_node_from(framework_, end); v-- > first;) {
      const auto points = framework_.points(Node_index(v));
      while (p > points.begin.value()) from = combine_(from, of_point_(--p));
      of_node_[Node_index(v)] = points.end.value() > end ? from : of_children(Node_index(v));
    }
  }

  Value of_children(Node_index v) const {
    Value value = of_point_(framework_.points(v).begin.value());
    framework_.for_each_child(
        v, [&](Node_index child) { value = combine_(value, of_node_[child]); },
        [&](typename Framework::Point_rank r) { value = combine_(value, of_point_(r.value())); });
    return value;
  }

  void add_further_blocks() {
    const Block_combinations<Value, ConcurrencyTag, Combine> blocks(std::move(of_block_), combine_);
    for_each_index<ConcurrencyTag>(of_node_.size(), [&](std::size_t v) {
      const auto points = framework_.points(Node_index(v));
      const std::size_t first = points.begin.value() / block_length_;
      const std::size_t last = (points.end.value() - 1) / block_length_;
      if (first == last) return;
      Value& value = of_node_[Node_index(v)];
      if (first + 1 < last) value = combine_(value, blocks.of(first + 1, last));
      value = combine_(value, up_to_[points.end.value() - 1]);
    });
  }

  const Framework& framework_;
  const Of_point& of_point_;
  const Combine& combine_;

  Of_nodes of_node_;
  Uninitialized_vector<Value> up_to_; // by point, from the beginning of its block on
  std::vector<Value> of_block_;
};

/// Returns for each node of a framework what `combine` makes of the values of its points.
/// \tparam Of_point returns the value of a point of the framework, by rank; called several times for each.
/// \tparam Combine combines two values; the order does not matter, nor that a value is there twice.
template <class Value, class ConcurrencyTag, class Framework, class Of_point, class Combine>
auto combine_points_of_nodes(const Framework& framework, const Of_point& of_point, const Combine& combine) {
  return Node_combiner<Value, ConcurrencyTag, Framework, Of_point, Combine>(framework, of_point, combine)
      .find();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_COMBINE_POINTS_OF_NODES_H
