// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The framework of points that are in shuffle order across parts.
//
// Computes: at each part, the squares of the framework whose first point it has, in preorder. One part after the
//           other, they are those of `Quadtree_framework`, in its order.
// Bound:    O(k) time for k points at a part. Each part tells its last point to the next one. The squares that are
//           open at the ends of parts are found in log2 P + 1 exchanges, each of one parcel with at most as many
//           numbers as the grid has levels.
// Source:   Bern, Eppstein, Teng, section 2, Theorem 1: two neighbors in the order give a square, so a part needs one
//           foreign point on either side. A square ends at the next gap that gives a larger one. Those beyond the end
//           of a part are the next larger values of Lemma 3, seen from there: one for each level at most.
// Method:   The chain of a part has the gaps that are shallower than all before them. Chains of neighboring runs of
//           parts are put together, as in a scan, twice as many parts each time.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_FRAMEWORK_PART_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_FRAMEWORK_PART_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Point_order.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {

/// \ingroup PkgQuadtreeMesh2Distributed
/// A square of the framework of points of all ranks.
struct Distributed_framework_square {
  Quadtree_square_2<std::uint64_t> square; ///< in the grid
  std::int64_t begin;                      ///< its first point, counted over all ranks in shuffle order
  std::int64_t end;                        ///< one past its last point
  int level_of_parent;                     ///< of the smallest other one around it; -1 if there is none
};

namespace internal {

/// Finds the squares of the framework, see the head of this file.
template <class Traits, class Exchange>
class Framework_part_finder {
public:
  using Square = Distributed_framework_square;

  Framework_part_finder(Exchange& exchange, const Ordered_points<Traits>& order)
      : exchange_(exchange), order_(order), depth_(order.grid.depth()),
        first_(order.begins[static_cast<std::size_t>(exchange.rank())]) {}

  std::vector<Square> find() {
    find_gaps();
    const std::vector<Gap> open = open_behind(chain_of_gaps());
    return squares(open);
  }

private:
  /// Between point `at` and the one before it; the square of both has the level.
  struct Gap {
    std::int64_t at;
    std::int64_t level;
  };

  void find_gaps() {
    using Place = Grid_point_2<std::uint64_t>;
    Records_of_parts<Place> outbox;
    if (!order_.points.empty()) {
      const int next = next_part_with_points();
      if (next < exchange_.size()) outbox[next].push_back(order_.points.back().place);
    }
    const std::vector<Place> before = exchange_and_join(exchange_, std::move(outbox));
    for (std::size_t i = 0; i < order_.points.size(); ++i) {
      const Place* const previous = i > 0            ? &order_.points[i - 1].place
                                    : before.empty() ? nullptr
                                                     : before.data();
      levels_.push_back(
          previous == nullptr ? -1 : level_of_derived_square(*previous, order_.points[i].place, depth_));
    }
  }

  int next_part_with_points() const {
    int next = exchange_.rank() + 1;
    while (next < exchange_.size() &&
           order_.begins[static_cast<std::size_t>(next)] == order_.begins[static_cast<std::size_t>(next) + 1])
      ++next;
    return next;
  }

  /// The gaps of this part that are shallower than all before them. That before the first of all points is none.
  std::vector<Gap> chain_of_gaps() const {
    std::vector<Gap> chain;
    for (std::size_t i = 0; i < levels_.size(); ++i)
      add_to_chain(chain, {first_ + static_cast<std::int64_t>(i), levels_[i]});
    return chain;
  }
  static void add_to_chain(std::vector<Gap>& chain, const Gap& gap) {
    if (gap.level >= 0 && (chain.empty() || gap.level < chain.back().level)) chain.push_back(gap);
  }

  /// The chain of all parts behind this one.
  std::vector<Gap> open_behind(std::vector<Gap> chain) {
    for (int parts = 1; parts < exchange_.size(); parts *= 2)
      for (const Gap& gap : chain_from(parts, chain)) add_to_chain(chain, gap);
    return chain_from(1, chain);
  }

  /// What the part that is `parts` behind this one has; what is given goes to the part as far before it.
  std::vector<Gap> chain_from(int parts, const std::vector<Gap>& chain) {
    Records_of_parts<Gap> outbox;
    if (exchange_.rank() >= parts) outbox[exchange_.rank() - parts] = chain;
    return exchange_and_join(exchange_, std::move(outbox));
  }

  /// Goes from right to left. The open gaps are those of squares that do not begin behind the point, the nearest and
  /// deepest at last.
  std::vector<Square> squares(std::vector<Gap> open) const {
    std::reverse(open.begin(), open.end());
    std::vector<Square> result;
    for (std::size_t i = levels_.size(); i-- > 0;) {
      const Gap gap{first_ + static_cast<std::int64_t>(i), levels_[i]};
      while (!open.empty() && open.back().level > gap.level) {
        const std::int64_t level = open.back().level;
        open.pop_back();
        result.push_back(square(i, level, gap.level, open));
      }
      if (!open.empty() && open.back().level == gap.level) open.pop_back();
      if (gap.level >= 0) open.push_back(gap);
    }
    std::reverse(result.begin(), result.end());
    return result;
  }

  /// The square of level `level` that begins at point `i` of this part.
  Square square(std::size_t i, std::int64_t level, std::int64_t level_before,
                const std::vector<Gap>& open) const {
    const auto corner = corner_of_square(order_.points[i].place, static_cast<int>(level), depth_);
    const std::int64_t level_behind = open.empty() ? -1 : open.back().level;
    return {{corner.x, corner.y, static_cast<int>(level)},
            first_ + static_cast<std::int64_t>(i),
            open.empty() ? order_.begins.back() : open.back().at,
            static_cast<int>(std::max(level_before, level_behind))};
  }

  Exchange& exchange_;
  const Ordered_points<Traits>& order_;
  int depth_;
  std::int64_t first_;
  std::vector<std::int64_t> levels_; // of the gap before each point; -1 before the first of all
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_FRAMEWORK_PART_H
