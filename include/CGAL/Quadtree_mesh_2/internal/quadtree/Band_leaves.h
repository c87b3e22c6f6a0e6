// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The numbers of the leaves of a quadtree, by bands of levels.
//
// Computes: what `Linked_squares::number_leaves()` computes: leaves in shuffle order over all levels, those in
//           each square, and the leaf of each point.
// Bound:    O(k) work for k squares. Two rounds for each level of a band, as bands are gone through at the same
//           time, and a constant number besides: O(log n), whatever the depth.
// Method:   The tops of a band are its squares on the uppermost level. A leaf's place under a top is the number
//           of the leaves of the band before it there. What hangs under each top follows from level to level.
//           Then a list goes around all tops: from where one begins through the next lower tops in it to where
//           it ends. Sums along this list are the numbers of leaves before each top and up to its end
//           (sums_along_list.h). Places in bands, and the numbers at the end of the last lower top before, are
//           the numbers of leaves.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_BAND_LEAVES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_BAND_LEAVES_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/sums_along_list.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Numbers the leaves of `Linked_squares`; see the head of this file.
template <class Squares, class ConcurrencyTag>
class Band_leaves {
public:
  /// \param first_level the first level of each band, 0 for the first one, and the number of all levels
  Band_leaves(Squares& squares, std::vector<int> first_level)
      : squares_(squares), first_level_(std::move(first_level)), number_of_bands_(first_level_.size() - 1) {}

  /// \param points how many there are
  void number(std::size_t points) {
    number_tops();
    count_leaves();
    place_in_bands();
    before_ = sums_along_list<ConcurrencyTag>(list_of_tops(), 0);
    find_leaves_of_squares();
    number_leaves();
    find_leaves_of_points(points);
  }

private:
  using Numbers = Uninitialized_vector<std::uint32_t>;

  /// A top of a band as a part of the band above.
  struct Top {
    std::uint32_t parent; ///< the top above; for those of the first band itself
    std::uint32_t place;  ///< how many leaves of the band above are before it under its parent
  };

  std::uint32_t begin(std::size_t band) const { return squares_.level_begin(first_level_[band]); }
  std::uint32_t end(std::size_t band) const { return squares_.level_begin(first_level_[band + 1]); }
  std::uint32_t end_of_tops(std::size_t band) const { return squares_.level_begin(first_level_[band] + 1); }
  std::uint32_t top_of_family(std::size_t band, std::uint32_t family) const {
    return first_top_[band] + (family - begin(band));
  }

  template <class F>
  void for_each_top(const F& f) const {
    Executor<ConcurrencyTag>::run(number_of_bands_, [&](std::size_t band) {
      for_each_index<ConcurrencyTag>(end_of_tops(band) - begin(band), [&](std::size_t i) {
        f(band, begin(band) + static_cast<std::uint32_t>(i),
          first_top_[band] + static_cast<std::uint32_t>(i));
      });
    });
  }

  void number_tops() {
    first_top_.resize(number_of_bands_ + 1);
    for_each_index<ConcurrencyTag>(number_of_bands_,
                                   [&](std::size_t b) { first_top_[b] = end_of_tops(b) - begin(b); });
    exclusive_scan<ConcurrencyTag>(first_top_.data(), first_top_.size());
    resize_to_write(tops_, first_top_.back());
    tops_[0] = {0, 0};
  }

  /// Counts the leaves of a band and the lower tops under each of its squares, from the lowest level up.
  void count_leaves() {
    Numbers& leaves = squares_.last_leaf_; // until they are known
    resize_to_write(leaves, squares_.number_of_families());
    resize_to_write(lower_tops_, squares_.number_of_families());
    Executor<ConcurrencyTag>::run(number_of_bands_, [&](std::size_t band) {
      for (int l = first_level_[band + 1]; l-- > first_level_[band];)
        squares_.template for_each_family_of_level<ConcurrencyTag>(l, [&](std::uint32_t f) {
          std::uint32_t own = 0, lower = 0;
          for (int q = 0; q < 4; ++q) {
            const Node_index v = Squares::member(f, q);
            if (squares_.is_leaf(v)) {
              ++own;
            } else if (squares_.family(v) < end(band)) {
              own += leaves[squares_.family(v)];
              lower += lower_tops_[squares_.family(v)];
            } else {
              ++lower;
            }
          }
          leaves[f] = own;
          lower_tops_[f] = lower;
        });
    });
  }

  /// Finds the places of all squares under the tops of their bands, from these down.
  void place_in_bands() {
    resize_to_write(squares_.first_leaf_, squares_.number_of_families());
    resize_to_write(next_lower_, squares_.number_of_families());
    resize_to_write(top_, squares_.number_of_families());
    Executor<ConcurrencyTag>::run(number_of_bands_, [&](std::size_t band) {
      place_tops(band);
      for (int l = first_level_[band]; l < first_level_[band + 1]; ++l)
        squares_.template for_each_family_of_level<ConcurrencyTag>(
            l, [&](std::uint32_t f) { place_children(band, f); });
    });
  }

  void place_tops(std::size_t band) {
    const std::uint32_t first = begin(band), n = end_of_tops(band) - first;
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) {
      squares_.first_leaf_[first + i] = 0;
      next_lower_[first + i] = lower_tops_[first + i];
      top_[first + i] = first_top_[band] + static_cast<std::uint32_t>(i);
    });
    exclusive_scan<ConcurrencyTag>(next_lower_.data() + first, n);
    const std::uint32_t first_lower = first_top_[band + 1];
    for_each_index<ConcurrencyTag>(n, [&](std::size_t i) { next_lower_[first + i] += first_lower; });
  }

  void place_children(std::size_t band, std::uint32_t f) {
    std::uint32_t place = squares_.first_leaf_[f], lower = next_lower_[f];
    for (int q = 0; q < 4; ++q) {
      const Node_index v = Squares::member(f, q);
      if (squares_.is_leaf(v)) {
        ++place;
      } else if (squares_.family(v) < end(band)) {
        const std::uint32_t child = squares_.family(v);
        squares_.first_leaf_[child] = place;
        next_lower_[child] = lower;
        top_[child] = top_[f];
        place += squares_.last_leaf_[child];
        lower += lower_tops_[child];
      } else {
        tops_[lower++] = {top_[f], place};
      }
    }
  }

  /// The beginnings and ends of tops, numbers 2 t and 2 t + 1, linked in shuffle order. Weights are the leaves of
  /// bands between them.
  Uninitialized_vector<List_link> list_of_tops() const {
    Uninitialized_vector<List_link> list(2 * tops_.size());
    for_each_top([&](std::size_t band, std::uint32_t f, std::uint32_t t) {
      const std::uint32_t lower = next_lower_[f];
      list[2 * t] = lower_tops_[f] == 0 ? List_link{2 * t + 1, squares_.last_leaf_[f]}
                                        : List_link{2 * lower, tops_[lower].place};
      if (band == 0) {
        list[2 * t + 1] = {List_link::none, 0};
        return;
      }
      const std::uint32_t parent = tops_[t].parent;
      const bool is_last = t + 1 == first_top_[band + 1] || tops_[t + 1].parent != parent;
      const std::uint32_t above = begin(band - 1) + (parent - first_top_[band - 1]);
      list[2 * t + 1] = is_last ? List_link{2 * parent + 1, squares_.last_leaf_[above] - tops_[t].place}
                                : List_link{2 * (t + 1), tops_[t + 1].place - tops_[t].place};
    });
    return list;
  }

  /// The number of leaves before a place under a top, behind which the next lower top is `lower`.
  std::uint32_t leaves_before(std::uint32_t top, std::uint32_t first_lower, std::uint32_t place,
                              std::uint32_t lower) const {
    return lower == first_lower ? before_[2 * top] + place
                                : before_[2 * (lower - 1) + 1] + place - tops_[lower - 1].place;
  }

  void find_leaves_of_squares() {
    Executor<ConcurrencyTag>::run(number_of_bands_, [&](std::size_t band) {
      const std::uint32_t first = begin(band);
      for_each_index<ConcurrencyTag>(end(band) - first, [&](std::size_t i) {
        const std::size_t f = first + i;
        const std::uint32_t top = top_[f], first_lower = next_lower_[first + (top - first_top_[band])];
        const std::uint32_t place = squares_.first_leaf_[f], lower = next_lower_[f];
        const std::uint32_t end_place = place + squares_.last_leaf_[f], end_lower = lower + lower_tops_[f];
        squares_.first_leaf_[f] = leaves_before(top, first_lower, place, lower);
        squares_.last_leaf_[f] = leaves_before(top, first_lower, end_place, end_lower) - 1;
      });
    });
  }

  void number_leaves() {
    squares_.node_of_leaf_.resize(squares_.number_of_nodes() - squares_.number_of_families());
    for_each_index<ConcurrencyTag>(
        squares_.number_of_families(),
        [&](std::size_t f) {
          std::uint32_t next = squares_.first_leaf_[f];
          for (int q = 0; q < 4; ++q) {
            const Node_index v = Squares::member(static_cast<std::uint32_t>(f), q);
            if (squares_.is_leaf(v)) {
              squares_.leaf_or_family_[v.value()] = Squares::leaf_flag | next;
              squares_.node_of_leaf_[next++] = v.value();
            } else {
              next = squares_.last_leaf_[squares_.family(v)] + 1;
            }
          }
        },
        default_block / 4);
  }

  /// Leaves are in shuffle order, so the points of the next leaf follow.
  void find_leaves_of_points(std::size_t points) {
    squares_.leaf_of_point_.resize(points);
    for_each_index<ConcurrencyTag>(
        squares_.number_of_leaves(),
        [&](std::size_t l) {
          const std::size_t last = l + 1 < squares_.number_of_leaves() ? first_point_of_leaf(l + 1) : points;
          for (std::size_t r = first_point_of_leaf(l); r < last; ++r)
            squares_.leaf_of_point_[r] = static_cast<std::uint32_t>(l);
        },
        default_block / 4);
  }

  std::uint32_t first_point_of_leaf(std::size_t l) const {
    return squares_.point_begin_[squares_.node_of_leaf_[l]];
  }

  Squares& squares_;
  std::vector<int> first_level_;
  std::size_t number_of_bands_;

  // By band; by top, band after band.
  std::vector<std::uint32_t> first_top_;
  Uninitialized_vector<Top> tops_;
  /// Leaves before the beginning and before the end of each.
  Numbers before_;

  // By family: lower tops under it, the first of them or the next one behind, and its top. `first_leaf_` and
  // `last_leaf_` are places and numbers of leaves until the list is summed up.
  Numbers lower_tops_;
  Numbers next_lower_;
  Numbers top_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_QUADTREE_BAND_LEAVES_H
