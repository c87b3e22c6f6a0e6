// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The leaves that each segment passes through, in order, and the pieces of segments in each leaf.
//
// Computes: both kinds of lists, one after the other in one array, and where the list of each segment or leaf
//           begins.
// Bound:    O(n + m + k) work for n leaves, m segments and k pieces, not counting the sorting of integers.
// Source:   Bern, Eppstein, Teng, section 6: "subdivide the PSLG edges into pieces contained in each quadtree
//           square".
//
// Segments go between the grid points of their ends, and squares are half open. A segment passes through a
// leaf if one of its points is in the half-open square. So the pieces of a segment in its leaves are disjoint
// and cover it, and it passes through each leaf once.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_EDGE_PIECES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_EDGE_PIECES_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/radix_sort.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Members of a list that follow each other.
template <class T>
struct List_range {
  const T* first;
  const T* last;
  const T* begin() const { return first; }
  const T* end() const { return last; }
  std::size_t size() const { return static_cast<std::size_t>(last - first); }
  bool empty() const { return first == last; }
  const T& operator[](std::size_t i) const { return first[i]; }
  const T& front() const { return *first; }
  const T& back() const { return last[-1]; }
};

/// For each segment the leaves that it passes, from its first end to its second.
class Edge_pieces {
public:
  using Range = List_range<Leaf_index>;

  /// Of no segments.
  Edge_pieces() : begin_(1) {}
  /// \param begin for each segment the place of its first leaf, and at last the number of all
  Edge_pieces(std::vector<std::uint32_t> begin, std::vector<Leaf_index> leaves)
      : begin_(std::move(begin)), leaves_(std::move(leaves)) {
    CGAL_precondition(!begin_.empty() && begin_.back() == leaves_.size());
  }

  Range operator[](Segment_index s) const {
    return {leaves_.data() + begin_[s.value()], leaves_.data() + begin_[s.value() + 1]};
  }
  /// The number of pieces of all segments.
  std::size_t size() const { return leaves_.size(); }
  std::size_t number_of_segments() const { return begin_.size() - 1; }

  /// Pieces are numbered along the segments, one segment after the other: this is the first one's number.
  std::uint32_t first_piece(Segment_index s) const { return begin_[s.value()]; }
  /// The leaf of a piece by its number.
  Leaf_index leaf(std::size_t piece) const { return leaves_[piece]; }

  friend bool operator==(const Edge_pieces& a, const Edge_pieces& b) {
    return a.begin_ == b.begin_ && a.leaves_ == b.leaves_;
  }
  friend bool operator!=(const Edge_pieces& a, const Edge_pieces& b) { return !(a == b); }

private:
  std::vector<std::uint32_t> begin_; // for each segment, and the end
  std::vector<Leaf_index> leaves_;
};

/// A piece of a segment: member `position` of the list of the segment's leaves.
struct Edge_piece {
  Segment_index segment;
  std::uint32_t position;

  friend bool operator==(const Edge_piece& a, const Edge_piece& b) {
    return a.segment == b.segment && a.position == b.position;
  }
};

/// For each leaf the pieces in it, by increasing segment.
class Leaf_pieces {
public:
  using Range = List_range<Edge_piece>;

  /// Of no leaves.
  Leaf_pieces() : begin_(1) {}

  template <class ConcurrencyTag>
  static Leaf_pieces of(const Edge_pieces& pieces, std::size_t number_of_leaves) {
    using Key = std::uint64_t;
    // The leaf, then the number of the piece.
    const auto keys = uncleared_words(pieces.size());
    const auto buffer = uncleared_words(pieces.size());
    Uninitialized_vector<std::uint32_t> segment(pieces.size());
    for_each_index<ConcurrencyTag>(
        pieces.number_of_segments(),
        [&](std::size_t s) {
          const std::uint32_t first = pieces.first_piece(Segment_index(s));
          const std::uint32_t last = pieces.first_piece(Segment_index(s + 1));
          for (std::uint32_t p = first; p < last; ++p) {
            segment[p] = static_cast<std::uint32_t>(s);
            keys[p] = Key(pieces.leaf(p).value()) << 32 | p;
          }
        },
        block_of_segments_);
    sort_words<ConcurrencyTag>(keys.get(), buffer.get(), pieces.size(), true);
    Leaf_pieces result;
    result.pieces_.resize(pieces.size());
    for_each_index<ConcurrencyTag>(pieces.size(), [&](std::size_t i) {
      const std::uint32_t p = static_cast<std::uint32_t>(keys[i]);
      const Segment_index s(segment[p]);
      result.pieces_[i] = {s, p - pieces.first_piece(s)};
    });
    result.begin_ = begin_of_lists<ConcurrencyTag>(keys.get(), pieces.size(), number_of_leaves);
    return result;
  }

  Range operator[](Leaf_index l) const {
    return {pieces_.data() + begin_[l.value()], pieces_.data() + begin_[l.value() + 1]};
  }
  std::size_t size() const { return pieces_.size(); }
  std::size_t number_of_leaves() const { return begin_.size() - 1; }

  /// Returns where the keys with each number in their high half begin, for keys in order, and the end.
  template <class ConcurrencyTag>
  static std::vector<std::uint32_t> begin_of_lists(const std::uint64_t* keys, std::size_t n,
                                                   std::size_t lists) {
    std::vector<std::uint32_t> begin(lists + 1);
    // The lists of all numbers after that of key i - 1, up to that of key i, begin at i.
    for_each_index<ConcurrencyTag>(n + 1, [&](std::size_t i) {
      const std::size_t first = i == 0 ? 0 : static_cast<std::size_t>(keys[i - 1] >> 32) + 1;
      const std::size_t last = i == n ? lists : static_cast<std::size_t>(keys[i] >> 32);
      for (std::size_t l = first; l <= last; ++l) begin[l] = static_cast<std::uint32_t>(i);
    });
    return begin;
  }

private:
  static constexpr std::size_t block_of_segments_ = 256;

  std::vector<std::uint32_t> begin_; // for each leaf, and the end
  Uninitialized_vector<Edge_piece> pieces_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PIECES_EDGE_PIECES_H
