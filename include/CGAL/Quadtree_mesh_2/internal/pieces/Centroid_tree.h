// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The accelerated centroid tree of a quadtree: a binary tree over its leaves that is never tall.
//
// Computes: a binary tree for a part of the quadtree. A part is all squares below a node except those below
//           some further nodes. Each inner node of the tree, a split, has a square of the quadtree. Its child
//           `inside` is for the leaves of the part in that square, and `outside` is for the rest. This goes
//           on down to single leaves. The quadtree may be cut into parts of a given size first, each with a
//           tree of its own.
// Bound:    O(k log k) work in O(log k) rounds of O(1) steps, each of tasks as long as a block or O(log^2 k). Each
//           chosen square holds more than 1/5 and at most 4/5 of the leaves. So a part of k leaves has k - 1
//           splits and a height of at most log k / log 5/4 = 3.11 log_2 k. Parts have at most 5 n leaves. If there
//           are several, each has more than n.
// Source:   Bern, Eppstein, Teng, section 6: "this produces a binary tree T_C, which has logarithmic height
//           and linear size"; "partition the quadtree into O(k/n) subtrees, each of O(n) squares". The
//           technique is that of Atallah, Cole, Goodrich, "Cascading divide-and-conquer".
// Method:   The leaves of a part are a slice of an array in shuffle order. So those in a square follow each
//           other. A square with more than half of them contains the one in the middle. Climbing from this
//           leaf to the first such square u widens a range of the slice, by bisection. If u is many levels up, its
//           level is found by bisection, too, as nodes are numbered by level and then in shuffle order. If u has too
//           many leaves, its heaviest child has more than a fifth and at most a half. The range then moves to the
//           end of the slice, which splits the slice into those of the two children. All threads move the leaves of
//           a long slice, block by block. A slice of up to 2048 leaves is a block, and one task splits it to the end.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_CENTROID_TREE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_CENTROID_TREE_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A node of a centroid tree: a split, or a leaf of the quadtree.
class Centroid_node {
public:
  Centroid_node() = default;
  static Centroid_node of_leaf(std::uint32_t leaf) { return Centroid_node(leaf | leaf_flag_); }
  static Centroid_node of_split(std::uint32_t split) { return Centroid_node(split); }

  bool is_leaf() const { return (value_ & leaf_flag_) != 0; }
  /// \pre `is_leaf()`
  Leaf_index leaf() const { return Leaf_index(value_ & ~leaf_flag_); }
  /// \pre `!is_leaf()`
  std::uint32_t split() const { return value_; }

private:
  explicit Centroid_node(std::uint32_t value) : value_(value) {}

  static constexpr std::uint32_t leaf_flag_ = 0x80000000u; // trees have less than 2^31 leaves
  std::uint32_t value_;
};

/// A number of leaves that no part reaches.
constexpr std::size_t all_leaves = std::numeric_limits<std::size_t>::max();

/// The centroid trees of the parts of a quadtree.
template <class Word>
class Centroid_tree {
public:
  using Square = Quadtree_square_2<Word>;

  /// Has a square rather than a node of the quadtree: whoever goes down reads one place, and often the next.
  struct Split {
    Square square;
    Centroid_node inside;
    Centroid_node outside;
  };

  /// A part of the quadtree: leaves in a square, not all of them if there are other parts.
  struct Part {
    Square square;
    Centroid_node root;
  };

  /// Makes the trees of parts with at most `leaves_per_part` leaves; these have more than a fifth of that if
  /// there are several.
  /// \pre `leaves_per_part >= 1`
  template <class ConcurrencyTag, class Tree>
  static Centroid_tree of(const Tree& tree, std::size_t leaves_per_part) {
    Centroid_tree result;
    Builder<ConcurrencyTag, Tree>(tree, result).build(leaves_per_part);
    return result;
  }

  const std::vector<Part>& parts() const { return parts_; }
  /// \pre `!v.is_leaf()`
  const Split& split(Centroid_node v) const { return splits_[v.split()]; }
  /// The greatest number of splits above a leaf, among all parts.
  int height() const { return height_; }
  /// The number of rounds in which the quadtree was cut into parts and these into short slices.
  int rounds() const { return rounds_; }

  /// The greatest height of the tree of a part with `leaves` leaves.
  static double height_bound(std::size_t leaves) {
    return std::log(static_cast<double>(leaves)) / std::log(1.25);
  }

private:
  template <class ConcurrencyTag, class Tree>
  class Builder;

  Uninitialized_vector<Split> splits_;
  std::vector<Part> parts_;
  int height_ = 0;
  int rounds_ = 0;
};

template <class Word>
template <class ConcurrencyTag, class Tree>
class Centroid_tree<Word>::Builder {
public:
  Builder(const Tree& tree, Centroid_tree& result)
      : tree_(tree), result_(result), leaves_(tree.number_of_leaves()) {}

  void build(std::size_t leaves_per_part) {
    const std::uint32_t k = static_cast<std::uint32_t>(leaves_.size());
    for_each_index<ConcurrencyTag>(k, [&](std::size_t i) { leaves_[i] = static_cast<std::uint32_t>(i); });
    result_.splits_.resize(k);
    std::vector<Slice> slices = split_long({{0, k, 0, 0, tree_.root()}}, leaves_per_part, Record::NOTHING);
    result_.parts_.resize(slices.size());
    for_each_index<ConcurrencyTag>(slices.size(), [&](std::size_t i) {
      Slice& s = slices[i];
      s.first_split = s.begin;
      s.depth = 0;
      result_.parts_[i] = {tree_.square(s.square), node_of(s)};
    });
    slices = split_long(std::move(slices), short_slice_, Record::SPLITS);
    std::vector<int> height(slices.size());
    for_each_index<ConcurrencyTag>(
        slices.size(), [&](std::size_t i) { height[i] = finish(slices[i]); }, 1);
    result_.height_ = reduce<ConcurrencyTag>(
        height.size(), 0,
        [&](std::size_t begin, std::size_t end) {
          return *std::max_element(height.begin() + static_cast<std::ptrdiff_t>(begin),
                                   height.begin() + static_cast<std::ptrdiff_t>(end));
        },
        [](int a, int b) { return std::max(a, b); });
  }

private:
  /// The leaves of a part, in shuffle order at some places of the array, and the numbers of their splits: one
  /// less, its own first, then those of the leaves outside its square, then those of the leaves inside.
  struct Slice {
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t first_split;
    int depth;         // the number of splits above
    Node_index square; // holds all leaves

    std::uint32_t size() const { return end - begin; }
  };

  struct Halves {
    Slice outside;
    Slice inside;
  };

  /// A square and the places of the leaves in it.
  struct Candidate {
    Node_index square;
    std::uint32_t begin;
    std::uint32_t end;

    std::uint32_t size() const { return end - begin; }
  };

  /// Whether splits are those of a centroid tree or only cut into parts.
  enum class Record { NOTHING, SPLITS };

  static constexpr std::size_t short_slice_ = 2048;
  static constexpr std::uint32_t few_leaves_ = 256;
  static constexpr int most_climbed_ = 16; // levels, one by one

  Centroid_node node_of(const Slice& s) const {
    return s.size() == 1 ? Centroid_node::of_leaf(leaves_[s.begin]) : Centroid_node::of_split(s.first_split);
  }

  /// Splits slices, in rounds, until none is longer than `most`. Returns all.
  std::vector<Slice> split_long(std::vector<Slice> open, std::size_t most, Record record) {
    std::vector<Slice> finished;
    while (!open.empty()) {
      const std::vector<Slice> long_ones = take_long(open, most, finished);
      open.resize(2 * long_ones.size());
      for_each_index<ConcurrencyTag>(
          long_ones.size(),
          [&](std::size_t i) {
            const Slice& s = long_ones[i];
            const Candidate inside = centroid(s);
            if (s.size() > default_block && !is_sequential<ConcurrencyTag>())
              move_to_end_in_blocks(s, inside);
            else
              move_to_end(s, inside);
            const Halves halves = split_at(s, inside, record);
            open[2 * i] = halves.outside;
            open[2 * i + 1] = halves.inside;
          },
          1);
      ++result_.rounds_;
    }
    return finished;
  }

  /// Returns the slices longer than `most`, and appends the others to those that are finished.
  static std::vector<Slice> take_long(const std::vector<Slice>& open, std::size_t most,
                                      std::vector<Slice>& finished) {
    const auto slice = [&](std::size_t i) { return open[i]; };
    const std::vector<Slice> short_ones = pack_values<ConcurrencyTag, Slice>(
        open.size(), [&](std::size_t i) { return open[i].size() <= most; }, slice);
    finished.insert(finished.end(), short_ones.begin(), short_ones.end());
    return pack_values<ConcurrencyTag, Slice>(
        open.size(), [&](std::size_t i) { return open[i].size() > most; }, slice);
  }

  /// Splits a slice into single leaves. Returns the greatest number of splits above one.
  int finish(const Slice& slice) {
    int height = 0;
    std::vector<Slice> open(1, slice);
    while (!open.empty()) {
      const Slice s = open.back();
      open.pop_back();
      height = std::max(height, s.depth);
      if (s.size() == 1) continue;
      const Halves halves = split(s);
      open.push_back(halves.inside);
      open.push_back(halves.outside);
    }
    return height;
  }

  /// Moves the leaves inside a square to the end of their slice.
  void move_to_end(const Slice& s, const Candidate& inside) {
    const auto begin = leaves_.begin();
    std::rotate(begin + inside.begin, begin + inside.end, begin + s.end);
  }

  /// The same in blocks.
  void move_to_end_in_blocks(const Slice& s, const Candidate& inside) {
    const std::size_t n = s.end - inside.begin, size = inside.size();
    Uninitialized_vector<std::uint32_t> moved(n);
    for_each_index<ConcurrencyTag>(
        n, [&](std::size_t i) { moved[i < size ? n - size + i : i - size] = leaves_[inside.begin + i]; });
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) { leaves_[inside.begin + i] = moved[i]; });
  }

  /// \pre `s.size() >= 2`
  Halves split(const Slice& s) {
    const Candidate inside = centroid(s);
    move_to_end(s, inside);
    return split_at(s, inside, Record::SPLITS);
  }

  /// The two halves of a slice, when the leaves inside the square are at its end.
  Halves split_at(const Slice& s, const Candidate& inside, Record record) {
    const std::uint32_t middle = s.end - inside.size();
    const Halves halves{{s.begin, middle, s.first_split + 1, s.depth + 1, s.square},
                        {middle, s.end, s.first_split + (middle - s.begin), s.depth + 1, inside.square}};
    if (record == Record::SPLITS)
      result_.splits_[s.first_split] = {tree_.square(inside.square), node_of(halves.inside),
                                        node_of(halves.outside)};
    return halves;
  }

  /// Returns a square with more than 1/5 and at most 4/5 of the leaves of a slice.
  Candidate centroid(const Slice& s) const {
    const std::uint32_t middle = s.begin + s.size() / 2;
    Candidate c{tree_.node(Leaf_index(leaves_[middle])), middle, middle + 1};
    for (int climbed = 0; is_light(c, s); ++climbed) {
      if (climbed == most_climbed_) {
        c = first_heavy(c, s);
        break;
      }
      c = widened({tree_.parent(c.square), c.begin, c.end}, s);
    }
    if (3 * std::uint64_t(c.size()) <= 2 * std::uint64_t(s.size())) return c;
    const Candidate child = heaviest_child(c);
    return s.size() - child.size() < c.size() ? child : c;
  }

  /// Whether a square has no more than half of the leaves.
  static bool is_light(const Candidate& c, const Slice& s) { return 2 * std::uint64_t(c.size()) <= s.size(); }

  /// Extends a range of leaves to all of the slice that are in the square: leaf by leaf as far as that is few, then by
  /// bisection.
  Candidate widened(Candidate c, const Slice& s) const {
    const auto all = tree_.leaves(c.square);
    const auto leaves = leaves_.begin();
    const std::uint32_t first = all.begin.value(), end = all.end.value();
    const std::uint32_t low = c.begin - std::min(c.begin - s.begin, few_leaves_),
                        high = c.end + std::min(s.end - c.end, few_leaves_);
    while (c.begin > low && leaves_[c.begin - 1] >= first) --c.begin;
    if (c.begin == low)
      c.begin = static_cast<std::uint32_t>(std::lower_bound(leaves + s.begin, leaves + low, first) - leaves);
    while (c.end < high && leaves_[c.end] < end) ++c.end;
    if (c.end == high)
      c.end = static_cast<std::uint32_t>(std::lower_bound(leaves + high, leaves + s.end, end) - leaves);
    return c;
  }

  /// The first square on the way up from a light one that is not.
  Candidate first_heavy(const Candidate& light, const Slice& s) const {
    Candidate heavy{s.square, s.begin, s.end};
    int low = tree_.level(s.square), high = tree_.level(light.square);
    while (high - low > 1) {
      const int level = low + (high - low) / 2;
      const Candidate c = widened({square_around(leaves_[light.begin], level), light.begin, light.end}, s);
      if (is_light(c, s))
        high = level;
      else
        low = level, heavy = c;
    }
    return heavy;
  }

  /// The square of a level around a leaf of that level or a deeper one.
  Node_index square_around(std::uint32_t leaf, int level) const {
    std::size_t begin = 0,
                end = tree_.number_of_nodes(); // the square is the last node that is not behind the leaf
    while (end - begin > 1) {
      const std::size_t middle = begin + (end - begin) / 2;
      const Node_index v(middle);
      const int l = tree_.level(v);
      if (l < level || (l == level && tree_.leaves(v).begin.value() <= leaf))
        begin = middle;
      else
        end = middle;
    }
    return Node_index(begin);
  }

  /// \pre the square is split
  Candidate heaviest_child(const Candidate& c) const {
    Candidate heaviest{c.square, c.begin, c.begin};
    const auto begin = leaves_.begin();
    std::uint32_t child_begin = c.begin;
    for (int q = 0; q < 4; ++q) {
      const Node_index v = tree_.child(c.square, q);
      const std::uint32_t child_end = static_cast<std::uint32_t>(
          std::lower_bound(begin + child_begin, begin + c.end, tree_.leaves(v).end.value()) - begin);
      if (child_end - child_begin > heaviest.size()) heaviest = {v, child_begin, child_end};
      child_begin = child_end;
    }
    return heaviest;
  }

  const Tree& tree_;
  Centroid_tree& result_;
  std::vector<std::uint32_t> leaves_;
};

/// Makes the centroid trees of a quadtree, in parts of at most `leaves_per_part` leaves.
template <class ConcurrencyTag, class Tree>
Centroid_tree<typename Tree::Word> centroid_tree(const Tree& tree, std::size_t leaves_per_part) {
  return Centroid_tree<typename Tree::Word>::template of<ConcurrencyTag>(tree, leaves_per_part);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_CENTROID_TREE_H
