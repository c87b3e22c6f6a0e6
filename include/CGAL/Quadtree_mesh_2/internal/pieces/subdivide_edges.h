// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The pieces of segments in the leaves of a quadtree, by centroid trees, all segments in parallel.
//
// Computes: for each segment the leaves that it passes through, in order (Edge_pieces.h), as walk_edges()
//           does.
// Bound:    O(log n) rounds for n segments. Each round has at most about as many items as there are pieces
//           and pairs of a segment and a part. So O(k log n) work for k pieces and leaves, not counting the
//           sorting of k integers.
// Source:   Bern, Eppstein, Teng, section 6: "test whether the edge misses the square, is contained in the
//           square, or crosses the square's boundary"; "process all edges in parallel, one level of T_C at a
//           time"; "partition the quadtree into O(k/n) subtrees, each of O(n) squares".
// Method:   An item is an interval of a segment at a node of a centroid tree. The part in the node's square
//           goes on inside. The parts before and behind it go on outside, as one item each. There is always
//           something left. So a level has no more items than pieces, except items that pass only through
//           squares cut out of a part. These end where they do not meet the leaf.
// Deviates: the list of a segment is not split in order but sorted at the end. A segment that ascends in x
//           and y passes through leaves in shuffle order. Others pass through them in reverse, or in the
//           shuffle order of the quadtree upside down. So pieces are sorted by integers.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_SUBDIVIDE_EDGES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_SUBDIVIDE_EDGES_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/radix_sort.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sort_by_keys.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Centroid_tree.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Edge_pieces.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Grid_path.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What a subdivision did.
struct Subdivision_rounds {
  std::size_t parts = 0;
  /// Of the tallest centroid tree.
  int height = 0;
  /// The number of rounds in which segments were tested against squares: one for a level of the trees, one for
  /// the parts and one for the leaves.
  std::size_t rounds = 0;
  /// The number of tests in all rounds, and in the largest but the first, which tests all pairs of a segment
  /// and a part.
  std::size_t tests = 0;
  std::size_t tests_of_largest_round = 0;
};

/// The places of leaves in shuffle order, and in that of the quadtree upside down.
class Leaf_orders {
public:
  template <class ConcurrencyTag, class Tree>
  static Leaf_orders of(const Tree& tree) {
    Leaf_orders result;
    const std::size_t n = tree.number_of_nodes();
    Uninitialized_vector<std::uint32_t> place(n); // of the first leaf below each node
    result.place_.resize(tree.number_of_leaves());
    result.leaf_.resize(tree.number_of_leaves());
    place[0] = 0;
    // Nodes are numbered level by level.
    for (std::size_t begin = 0; begin < n;) {
      const std::size_t end = end_of_level(tree, begin);
      for_each_index<ConcurrencyTag>(
          end - begin, [&](std::size_t i) { result.place_below(tree, Node_index(begin + i), place); });
      begin = end;
    }
    return result;
  }

  /// The place of a leaf in the order in which a path in given directions passes leaves.
  template <class Path>
  std::uint32_t place(const Path& path, Leaf_index l) const {
    return reversed(path, is_upside_down(path) ? place_[l.value()] : l.value());
  }
  /// The leaf at a place.
  template <class Path>
  Leaf_index leaf(const Path& path, std::uint32_t place) const {
    const std::uint32_t i = reversed(path, place);
    return Leaf_index(is_upside_down(path) ? leaf_[i] : i);
  }

private:
  template <class Path>
  static bool is_upside_down(const Path& path) {
    return path.is_ascending(0) != path.is_ascending(1);
  }
  template <class Path>
  std::uint32_t reversed(const Path& path, std::uint32_t place) const {
    return path.is_ascending(0) ? place : static_cast<std::uint32_t>(leaf_.size()) - 1 - place;
  }

  template <class Tree>
  static std::size_t end_of_level(const Tree& tree, std::size_t begin) {
    const int level = tree.level(Node_index(begin));
    std::size_t low = begin + 1, high = tree.number_of_nodes();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (tree.level(Node_index(middle)) == level)
        low = middle + 1;
      else
        high = middle;
    }
    return low;
  }

  template <class Tree>
  void place_below(const Tree& tree, Node_index v, Uninitialized_vector<std::uint32_t>& place) {
    std::uint32_t next = place[v.value()];
    if (tree.is_leaf(v)) {
      place_[tree.leaf(v).value()] = next;
      leaf_[next] = tree.leaf(v).value();
      return;
    }
    for (const int q : {1, 0, 3, 2}) {
      const Node_index child = tree.child(v, q);
      place[child.value()] = next;
      next += static_cast<std::uint32_t>(tree.leaves(child).size());
    }
  }

  Uninitialized_vector<std::uint32_t> place_, leaf_; // upside down
};

/// Subdivides segments by centroid trees.
template <class ConcurrencyTag, class Tree, class Segments>
class Edge_subdivider {
public:
  using Word = typename Tree::Word;
  using Path = Grid_path<Word>;
  using Coordinate = typename Path::Coordinate;
  using Interval = typename Path::Interval;

  Edge_subdivider(const Tree& tree, const Centroid_tree<typename Tree::Word>& centroids,
                  const Segments& segments)
      : tree_(tree), centroids_(centroids), orders_(Leaf_orders::of<ConcurrencyTag>(tree)),
        order_(order_of_first_ends(tree, segments)), paths_(segments.size()) {
    rounds_.parts = centroids.parts().size();
    rounds_.height = centroids.height();
    for_each_index<ConcurrencyTag>(segments.size(),
                                   [&](std::size_t s) { paths_[s] = path_of_segment(tree, segments[s]); });
  }

  Edge_pieces subdivide() {
    test_parts();
    while (!items_.empty()) test_items();
    return sorted_pieces();
  }

  const Subdivision_rounds& rounds() const { return rounds_; }

private:
  struct Item {
    std::uint32_t segment;
    Centroid_node node;
    Interval interval;
  };

  /// What a block of tests leaves behind: items to go on with, and pieces as their segment and the place of
  /// their leaf.
  struct Block {
    std::vector<Item> items;
    std::vector<std::uint64_t> pieces;
  };

  static constexpr std::size_t block_length_ = 1024;
  static constexpr std::size_t most_pieces_ = 0xffffffffu;

  Interval inside(const Path& path, const Interval& i, const Quadtree_square_2<Word>& square) const {
    return path.inside(
        i, {square.x, square.y},
        Coordinate(Word_operations<Word>::power_of_two(tree_.framework().grid().depth() - square.level)));
  }

  /// Segments that begin near each other are tested one after the other, as they go down the same way.
  static Order order_of_first_ends(const Tree& tree, const Segments& segments) {
    return radix_order<ConcurrencyTag>(segments.size(), [&](std::size_t s) {
      return std::uint64_t(tree.leaf(Point_index(segments[s][0].value())).value());
    });
  }

  /// Tests every segment against the square of every part.
  void test_parts() {
    const auto& parts = centroids_.parts();
    const std::size_t m = paths_.size();
    run_round(m * parts.size(), [&](std::size_t i, Block& block) {
      const std::size_t s = order_[i % m];
      const auto& part = parts[i / m];
      const Interval interval = inside(paths_[s], paths_[s].whole(), part.square);
      if (!paths_[s].is_empty(interval))
        block.items.push_back({static_cast<std::uint32_t>(s), part.root, interval});
    });
  }

  /// Tests every item against the square of its node.
  void test_items() {
    const Uninitialized_vector<Item> items = std::move(items_);
    rounds_.tests_of_largest_round = std::max(rounds_.tests_of_largest_round, items.size());
    run_round(items.size(), [&](std::size_t i, Block& block) {
      if (block.items.capacity() == 0) block.items.reserve(block_length_ + block_length_ / 4);
      if (items[i].node.is_leaf())
        test_leaf(items[i], block);
      else
        test_split(items[i], block);
    });
  }

  /// Runs independent tests and collects what they leave behind.
  template <class Test>
  void run_round(std::size_t n, const Test& test) {
    std::vector<Block> blocks((n + block_length_ - 1) / block_length_);
    for_each_block<ConcurrencyTag>(n, block_length_, [&](std::size_t b, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) test(i, blocks[b]);
    });
    items_.clear();
    append(blocks, &Block::items, items_);
    append(blocks, &Block::pieces, pieces_);
    if (pieces_.size() > most_pieces_) throw std::length_error("too many pieces of segments");
    ++rounds_.rounds;
    rounds_.tests += n;
  }

  template <class T, class Vector>
  static void append(const std::vector<Block>& blocks, std::vector<T> Block::*list, Vector& all) {
    count_allocate_and_place<ConcurrencyTag>(
        blocks.size(), [&](std::size_t b, std::size_t) { return (blocks[b].*list).size(); },
        [&](std::size_t n) { all.resize(all.size() + n); },
        [&, old = all.size()](std::size_t b, std::size_t, std::size_t place) {
          std::copy((blocks[b].*list).begin(), (blocks[b].*list).end(),
                    all.begin() + static_cast<std::ptrdiff_t>(old + place));
        },
        1);
  }

  void test_leaf(const Item& item, Block& block) const {
    const Path& path = paths_[item.segment];
    const Leaf_index l = item.node.leaf();
    if (path.is_empty(inside(path, item.interval, tree_.square(l)))) return;
    block.pieces.push_back(std::uint64_t(item.segment) << 32 | orders_.place(path, l));
  }

  void test_split(const Item& item, Block& block) const {
    const Path& path = paths_[item.segment];
    const auto& split = centroids_.split(item.node);
    const Interval in = inside(path, item.interval, split.square);
    const auto go_on = [&](Centroid_node node, const Interval& interval) {
      if (!path.is_empty(interval)) block.items.push_back({item.segment, node, interval});
    };
    if (path.is_empty(in)) {
      go_on(split.outside, item.interval);
    } else {
      go_on(split.outside, {item.interval.first, in.first});
      go_on(split.inside, in);
      go_on(split.outside, {in.last, item.interval.last});
    }
  }

  Edge_pieces sorted_pieces() {
    const std::size_t k = pieces_.size();
    sort_words<ConcurrencyTag>(pieces_.data(), uncleared_words(k).get(), k, true);
    std::vector<Leaf_index> leaves(k);
    for_each_index<ConcurrencyTag>(k, [&](std::size_t i) {
      leaves[i] = orders_.leaf(paths_[pieces_[i] >> 32], static_cast<std::uint32_t>(pieces_[i]));
    });
    return Edge_pieces(Leaf_pieces::begin_of_lists<ConcurrencyTag>(pieces_.data(), k, paths_.size()),
                       std::move(leaves));
  }

  const Tree& tree_;
  const Centroid_tree<typename Tree::Word>& centroids_;
  const Leaf_orders orders_;
  const Order order_; // in which segments are tested
  Uninitialized_vector<Path> paths_;
  Uninitialized_vector<Item> items_;
  Uninitialized_vector<std::uint64_t> pieces_;
  Subdivision_rounds rounds_;
};

/// Returns the pieces of segments, each given by its two vertices, which are points of the tree, by centroid
/// trees of the quadtree.
/// \throws std::length_error if there are 2^32 pieces or more
template <class ConcurrencyTag, class Tree, class Segments>
Edge_pieces subdivide_edges(const Tree& tree, const Centroid_tree<typename Tree::Word>& centroids,
                            const Segments& segments, Subdivision_rounds* rounds = nullptr) {
  Edge_subdivider<ConcurrencyTag, Tree, Segments> subdivider(tree, centroids, segments);
  Edge_pieces result = subdivider.subdivide();
  if (rounds != nullptr) *rounds = subdivider.rounds();
  return result;
}

/// The same by centroid trees of parts with O(m) leaves for m segments.
template <class ConcurrencyTag, class Tree, class Segments>
Edge_pieces subdivide_edges(const Tree& tree, const Segments& segments,
                            Subdivision_rounds* rounds = nullptr) {
  const std::size_t leaves_per_part = std::max<std::size_t>(1, 5 * segments.size());
  return subdivide_edges<ConcurrencyTag>(tree, centroid_tree<ConcurrencyTag>(tree, leaves_per_part), segments,
                                         rounds);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_SUBDIVIDE_EDGES_H
