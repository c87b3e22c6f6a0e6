// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The leaves of the smallest quadtree that separates points, cut among parts without a leaf in two of them.
//
// Computes: for each part a run of places along the shuffle order that begins with a square of the tree, the points in
//           it, and the leaves in it, down to level 29.
// Bound:    O(30 k) time for k points and leaves of a part, and memory for two numbers of each part.
// Method:   A square is split if it has more than m points. Point i of the order and point i + m are m + 1 points, so
//           the smallest square of both is split, and its four children are squares of the tree. The run of a part
//           begins with that child which has the part's first point, or where that of the part before begins, if this
//           is farther on. Each square that is around such a beginning is split, and of the others a part has all
//           points. So one foreign point for each part is all that it needs to know.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_SEPARATING_LEAVES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_SEPARATING_LEAVES_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Word_operations.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Coarse_square.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Point_order.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Sends points to parts.
/// \param part_of called as `part_of(code)` for points in order, returns the part
/// \returns those that arrive, in order if the points of parts were
template <class Exchange, class Grid, class Part_of>
std::vector<Placed_point> moved_points(Exchange& exchange, std::vector<Placed_point> points, const Grid& grid,
                                       const Part_of& part_of) {
  Records_of_parts<Numbered_point> outbox;
  for (const Placed_point& p : points) outbox[part_of(coarse_code(p.place))].push_back(p.without_place());
  std::vector<Placed_point>().swap(points);
  const std::vector<Numbered_point> arrived = exchange_and_join(exchange, std::move(outbox));
  points.reserve(arrived.size());
  for (const Numbered_point& p : arrived) points.push_back({grid.grid_point({p.x, p.y}), p.x, p.y, p.index});
  return points;
}

/// The first point from `begin` on whose place has the code or a later one.
inline std::size_t first_point_from(const std::vector<Placed_point>& points, std::size_t begin,
                                    Coarse_code code) {
  const auto found = std::partition_point(points.begin() + static_cast<std::ptrdiff_t>(begin), points.end(),
                                          [&](const Placed_point& p) { return coarse_code(p.place) < code; });
  return static_cast<std::size_t>(found - points.begin());
}

/// Finds the leaves, see the head of this file.
template <class Traits, class Exchange>
class Separating_leaves {
public:
  /// Moves the points of `order` to the parts in whose runs they are.
  /// \param most so many points a leaf may hold, at least 1
  Separating_leaves(Exchange& exchange, Ordered_points<Traits>& order, std::size_t most)
      : exchange_(exchange), order_(order), most_(most) {
    find_runs();
    order_.points = moved_points(exchange_, std::move(order_.points), order_.grid,
                                 [this](Coarse_code code) { return part_of(code); });
    begin_ = runs_[part()], end_ = runs_[part() + 1];
    if (begin_.code < end_.code) descend({0, 0}, 0, order_.points.size());
  }

  /// In order.
  const std::vector<Coarse_square>& leaves() const { return leaves_; }

private:
  std::size_t part() const { return static_cast<std::size_t>(exchange_.rank()); }

  /// For each part the place of the point that is `most_` behind its first one; none if there is no such point.
  std::vector<Grid_point_2<std::uint64_t>> point_of_window() {
    const Numbers& begins = order_.begins;
    Records_of_parts<Grid_point_2<std::uint64_t>> outbox;
    for (int to = 0; to < exchange_.size(); ++to) {
      const std::size_t p = static_cast<std::size_t>(to);
      if (begins[p] == begins[p + 1]) continue;
      if (most_ >= static_cast<std::size_t>(begins.back() - begins[p])) break;
      const std::int64_t wanted = begins[p] + static_cast<std::int64_t>(most_);
      if (begins[part()] <= wanted && wanted < begins[part() + 1])
        outbox[to].push_back(order_.points[static_cast<std::size_t>(wanted - begins[part()])].place);
    }
    return exchange_and_join(exchange_, std::move(outbox));
  }

  /// Where the run of this part may begin, by its own points. The tree is its root if there is no window in it.
  Coarse_square own_beginning() {
    const auto behind = point_of_window();
    if (order_.points.empty()) return {0, 0};
    if (behind.empty()) return {code_behind_all(), 0};
    const auto first = order_.points.front().place;
    const int level = level_of_derived_square(first, behind.front(), fine_depth) + 1;
    return Coarse_square::around(coarse_code(first), std::min(level, last_coarse_level));
  }

  void find_runs() {
    const Coarse_square own = own_beginning();
    const Numbers all = exchange_.gather({static_cast<std::int64_t>(own.code), own.level});
    runs_.push_back({0, 0});
    for (std::size_t at = 2; at < all.size(); at += 2) {
      const Coarse_square next{static_cast<Coarse_code>(all[at]), static_cast<int>(all[at + 1])};
      runs_.push_back(std::max(runs_.back(), next, [](const Coarse_square& a, const Coarse_square& b) {
        return a.code != b.code ? a.code < b.code : a.level < b.level;
      }));
    }
    runs_.push_back({code_behind_all(), 0});
  }

  /// The last part whose run begins there or before: those before it with the same beginning have none.
  int part_of(Coarse_code code) const {
    const auto behind =
        std::upper_bound(runs_.begin(), runs_.end() - 1, code,
                         [](Coarse_code c, const Coarse_square& run) { return c < run.code; });
    return static_cast<int>(behind - runs_.begin()) - 1;
  }

  bool is_around(const Coarse_square& s, Coarse_code beginning) const {
    return s.code < beginning && beginning < s.end();
  }

  /// \param first, last the points of this part that are in the square
  void descend(const Coarse_square& s, std::size_t first, std::size_t last) {
    if (s.end() <= begin_.code || end_.code <= s.code) return;
    const bool is_split = is_around(s, begin_.code) || is_around(s, end_.code) || last - first > most_;
    if (!is_split || s.level == last_coarse_level) return leaves_.push_back(s);
    for (int q = 0; q < 4; ++q) {
      const Coarse_square child = s.child(q);
      const std::size_t behind =
          q == 3 ? last : std::min(last, first_point_from(order_.points, first, child.end()));
      descend(child, first, behind);
      first = behind;
    }
  }

  Exchange& exchange_;
  Ordered_points<Traits>& order_;
  std::size_t most_;
  std::vector<Coarse_square> runs_; // where that of each part begins; and behind all
  Coarse_square begin_{0, 0}, end_{0, 0};
  std::vector<Coarse_square> leaves_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_SEPARATING_LEAVES_H
