// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Points of all parts in shuffle order, cut into runs of about the same length, one for each part.
//
// Computes: from a slice of the points at each part, the grid of all points, and the distinct points in shuffle order;
//           a part has those between those of the part before and those of the part behind. Equal points become the
//           one with the least index, and the part that was given the others is told so.
// Bound:    O(k log k) time for k points at a part. A point goes to another part once. What parts are told of each
//           other's places, and how many points one gets, is in agree_on_order.h.
// Source:   Shi, Schaeffer, "Parallel sorting by regular sampling", JPDC 1992.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_POINT_ORDER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_POINT_ORDER_H

#include <CGAL/Quadtree_mesh_2/Distributed_point_error.h>
#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_order.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Place_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/morton.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {

/// \ingroup PkgQuadtreeMesh2Distributed
/// An input point that equals an earlier one and was merged with it. Both are counted over all ranks.
struct Distributed_duplicate_point {
  std::int64_t kept;      ///< the earlier one
  std::int64_t duplicate; ///< the one that equals it
};

namespace internal {

/// A point of the input, as it is sent.
struct Numbered_point {
  double x, y;
  std::int64_t index;
};

/// A point with its place on the grid.
struct Placed_point {
  Grid_point_2<std::uint64_t> place;
  double x, y;
  std::int64_t index;

  Numbered_point without_place() const { return {x, y, index}; }
  bool is_at_same_point(const Placed_point& p) const { return x == p.x && y == p.y; }
};

/// The points of this part, see the head of this file.
template <class Traits>
struct Ordered_points {
  static_assert(std::is_same_v<typename Traits::Word, std::uint64_t>, "places have words of 64 bits");
  typename Traits::Grid_2 grid;
  std::vector<Placed_point> points;
  Numbers begins{0}; ///< the number of the first point of each part, and of all points
  std::int64_t number_of_input_points = 0;
  std::vector<Distributed_duplicate_point> duplicates; ///< of the slice of this part, by index
};

/// Makes `Ordered_points`.
template <class Traits, class Exchange>
class Point_sorter {
public:
  using Point_2 = typename Traits::Point_2;

  Point_sorter(Exchange& exchange, const Traits& traits) : exchange_(exchange), traits_(traits) {}

  /// \param slice the points of this part, a random access range; those of the parts before come before them
  template <class PointRange>
  Ordered_points<Traits> sort(const PointRange& slice) {
    const auto n = static_cast<std::int64_t>(std::distance(std::begin(slice), std::end(slice)));
    first_index_ = exchange_.exclusive_scan(n);
    result_.number_of_input_points = exchange_.sum(n);
    agree_on_work(exchange_, [&] { check(slice); });
    make_grid(slice);
    std::vector<Placed_point> own;
    agree_on_work(exchange_, [&] { own = sorted_slice(slice); });
    receive(send(std::move(own)));
    agree_on_work(exchange_, [&] { merge(); });
    learn_of_duplicates();
    count();
    return std::move(result_);
  }

private:
  /// As one part alone would find it, but for the number of the point.
  template <class PointRange>
  void check(const PointRange& slice) const try {
    if (static_cast<std::uint64_t>(std::distance(std::begin(slice), std::end(slice))) >=
        (std::uint64_t(1) << 32))
      throw std::length_error("Distributed_quadtree_2: 2^32 points or more at one rank");
    traits_.construct_grid_2_object()(slice);
  } catch (const Point_error& error) {
    throw Distributed_point_error(error.kind(), first_index_ + error.point().value(), -1, error.reason());
  }

  /// The grid of a box is that of the points in it.
  template <class PointRange>
  void make_grid(const PointRange& slice) {
    if (result_.number_of_input_points == 0) {
      result_.grid = traits_.construct_grid_2_object()(slice);
      return;
    }
    Double_box box;
    for (const Point_2& p : slice) box.add(p.x(), p.y());
    box = agree_on_box(exchange_, box);
    const std::array<Point_2, 2> corners{Point_2(box.low[0], box.low[1]), Point_2(box.high[0], box.high[1])};
    result_.grid = traits_.construct_grid_2_object()(corners);
  }

  template <class PointRange>
  std::vector<Placed_point> sorted_slice(const PointRange& slice) {
    const auto first = std::begin(slice);
    const auto n = static_cast<std::size_t>(std::distance(first, std::end(slice)));
    const auto at = [&](std::size_t i) -> decltype(auto) {
      return first[static_cast<typename std::iterator_traits<decltype(first)>::difference_type>(i)];
    };
    const auto sorted = shuffled(n, [&](std::size_t i) { return result_.grid.grid_point(at(i)); });
    std::vector<Placed_point> own;
    own.reserve(n);
    std::size_t run = 0; // where the points at the last place begin, in `own`
    for (std::size_t k = 0; k < n; ++k) {
      const Point_2& p = at(sorted.order[k]);
      const Placed_point placed{sorted.keys[k], p.x(), p.y(), first_index_ + sorted.order[k]};
      if (own.empty() || own[run].place != placed.place) run = own.size();
      if (run < own.size() && own[run].is_at_same_point(placed))
        result_.duplicates.push_back({own[run].index, placed.index});
      else if (own.size() < run + 2) // one that differs is enough for an error
        own.push_back(placed);
    }
    return own;
  }

  Records_of_parts<Numbered_point> send(std::vector<Placed_point> own) {
    const std::vector<std::size_t> cuts =
        sampled_cuts(exchange_, own.size(), [&own](std::size_t i) { return own[i].place; });
    Records_of_parts<Numbered_point> outbox;
    for (std::size_t part = 0, i = 0; part < cuts.size(); ++part)
      for (; i < cuts[part]; ++i) outbox[static_cast<int>(part)].push_back(own[i].without_place());
    std::vector<Placed_point>().swap(own);
    return exchange_records(exchange_, std::move(outbox));
  }

  void receive(Records_of_parts<Numbered_point> inbox) {
    for (auto& [part, points] : inbox) {
      for (const Numbered_point& p : points)
        received_.push_back({{result_.grid.grid_point(Point_2(p.x, p.y)), p.x, p.y, p.index}, part});
      std::vector<Numbered_point>().swap(points);
    }
    std::sort(received_.begin(), received_.end(), [](const Received_point& a, const Received_point& b) {
      return a.point.place != b.point.place ? less_shuffle(a.point.place, b.point.place)
                                            : a.point.index < b.point.index;
    });
  }

  void merge() {
    result_.points.reserve(received_.size());
    for (const Received_point& received : received_) {
      const Placed_point& p = received.point;
      if (result_.points.empty() || result_.points.back().place != p.place) {
        result_.points.push_back(p);
        continue;
      }
      const Placed_point& kept = result_.points.back();
      if (!kept.is_at_same_point(p)) {
        const Point_error::Kind kind = Point_error::Kind::INDISTINGUISHABLE;
        throw Distributed_point_error(kind, kept.index, p.index, Point_error(kind, Point_index(0)).reason());
      }
      replaced_[received.part].push_back({kept.index, p.index});
    }
    std::vector<Received_point>().swap(received_);
  }

  /// A point that was kept here may equal one of a lower part.
  void learn_of_duplicates() {
    std::vector<Distributed_duplicate_point> replaced = exchange_and_join(exchange_, std::move(replaced_));
    const auto less = [](const auto& a, const auto& b) { return a.duplicate < b.duplicate; };
    std::sort(replaced.begin(), replaced.end(), less);
    for (Distributed_duplicate_point& own : result_.duplicates) {
      const auto found =
          std::lower_bound(replaced.begin(), replaced.end(), Distributed_duplicate_point{0, own.kept}, less);
      if (found != replaced.end() && found->duplicate == own.kept) own.kept = found->kept;
    }
    result_.duplicates.insert(result_.duplicates.end(), replaced.begin(), replaced.end());
    std::sort(result_.duplicates.begin(), result_.duplicates.end(), less);
  }

  void count() {
    const Numbers counts = exchange_.gather(static_cast<std::int64_t>(result_.points.size()));
    for (const std::int64_t n : counts) result_.begins.push_back(result_.begins.back() + n);
  }

  struct Received_point {
    Placed_point point;
    int part;
  };

  Exchange& exchange_;
  const Traits& traits_;
  std::int64_t first_index_ = 0;
  std::vector<Received_point> received_;
  Records_of_parts<Distributed_duplicate_point> replaced_; // by the part that has to know
  Ordered_points<Traits> result_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_POINT_ORDER_H
