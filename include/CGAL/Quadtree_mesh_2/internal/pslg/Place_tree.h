// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Which of some places are near a segment.
//
// Computes: all places within a distance of a segment, up to rounding errors.
// Bound:    O(n log n) time to build for n places. Along a segment, O(sqrt(n) + k) for k places near it, if places
//           are spread evenly.
// Method:   A binary tree, halved along x and y by turns. Each half is asked about the piece of the segment that
//           may have places of that half near it.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_PLACE_TREE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_PLACE_TREE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Two coordinates, as CGAL's points need none of their operations here.
using Place_2 = std::array<double, 2>;

inline double distance_of_places(const Place_2& p, const Place_2& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1]);
}

/// A place as seen from a segment from `a` to `b`.
class Place_beside_segment {
public:
  Place_beside_segment(const Place_2& a, const Place_2& b, const Place_2& place) {
    const double length = distance_of_places(a, b);
    const double dx = length > 0 ? (b[0] - a[0]) / length : 1, dy = length > 0 ? (b[1] - a[1]) / length : 0;
    const double x = place[0] - a[0], y = place[1] - a[1];
    along_ = x * dx + y * dy;
    const double past_the_ends = (std::max)((std::max)(-along_, along_ - length), 0.);
    distance_ = std::hypot(x * dy - y * dx, past_the_ends);
    is_between_ = std::isfinite(length) && distance_of_places(a, place) < length &&
                  distance_of_places(b, place) < length;
  }

  double distance() const { return distance_; }   ///< from the segment
  double along() const { return along_; }         ///< from `a`, in the direction of `b`
  bool is_between() const { return is_between_; } ///< nearer to both ends than they are to each other

private:
  double along_, distance_;
  bool is_between_;
};

class Place_tree {
public:
  explicit Place_tree(std::vector<Place_2> places) : places_(std::move(places)), order_(places_.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t(0));
    build(0, order_.size(), 0);
  }

  const Place_2& place(std::size_t i) const { return places_[i]; }

  /// Calls `visit` with the index of each place within `reach` of the segment from `a` to `b`.
  template <class Visit>
  void for_each_near(const Place_2& a, const Place_2& b, double reach, Visit visit) const {
    ask({a, b, reach}, {0, 1}, {0, order_.size(), 0}, [&](std::size_t i) {
      if (Place_beside_segment(a, b, places_[i]).distance() <= reach) visit(i);
    });
  }

private:
  struct Question {
    Place_2 a, b;
    double reach;
  };
  /// Part of `order_`, halved along x (0) or y (1).
  struct Part {
    std::size_t begin, end, axis;
    std::size_t middle() const { return begin + (end - begin) / 2; }
  };
  /// A piece of the segment: shares of the way from `a` to `b`.
  struct Piece {
    double begin, end;
  };

  void build(std::size_t begin, std::size_t end, std::size_t axis) {
    if (end - begin < 2) return;
    const auto at = [this](std::size_t i) { return order_.begin() + std::ptrdiff_t(i); };
    const std::size_t middle = Part{begin, end, axis}.middle();
    std::nth_element(at(begin), at(middle), at(end), [this, axis](std::size_t i, std::size_t j) {
      return places_[i][axis] < places_[j][axis];
    });
    build(begin, middle, 1 - axis);
    build(middle + 1, end, 1 - axis);
  }

  template <class Visit>
  void ask(const Question& question, const Piece& piece, const Part& part, const Visit& visit) const {
    if (part.begin == part.end || piece.begin > piece.end) return;
    const std::size_t middle = part.middle();
    visit(order_[middle]);
    const double cut = places_[order_[middle]][part.axis];
    // Shares are rounded by less than the reach, which is at least a unit of the ends.
    const double slack = 8 * question.reach;
    ask(question, clipped(question, piece, part.axis, 1, cut + slack), {part.begin, middle, 1 - part.axis},
        visit);
    ask(question, clipped(question, piece, part.axis, -1, slack - cut), {middle + 1, part.end, 1 - part.axis},
        visit);
  }

  /// Where `sign` times the coordinate is at most `bound`; a piece that ends before it begins if nowhere.
  static Piece clipped(const Question& question, Piece piece, std::size_t axis, int sign, double bound) {
    const double start = sign * question.a[axis], way = sign * question.b[axis] - start;
    if (way == 0) return start <= bound ? piece : Piece{1, 0};
    const double share = (bound - start) / way;
    if (way > 0)
      piece.end = (std::min)(piece.end, share);
    else
      piece.begin = (std::max)(piece.begin, share);
    return piece;
  }

  std::vector<Place_2> places_;
  std::vector<std::size_t> order_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_PLACE_TREE_H
