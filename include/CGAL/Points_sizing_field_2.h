// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_POINTS_SIZING_FIELD_2_H
#define CGAL_POINTS_SIZING_FIELD_2_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// A sizing field from points with sizes, for `Quality_mesh_options_2::size()`. The size at a place is the
/// least of `size of the point + gradation * distance to it` over all points.
///
/// The points are in a k-d tree (Bentley, 1975), whose nodes know their bounding box and least size. A search
/// visits the more promising branch first and skips branches that cannot hold the least value. Several
/// threads may call it at once. O(n log n) time to build. A call takes O(log n) where sizes grow more slowly than the
/// gradation, which is usual. Where they grow as fast, many points give about the least value, and all are visited.
/// \cgalModels{SizingField_2}
class Points_sizing_field_2 {
public:
  /// A place, and the size there.
  struct Sized_point {
    double x;    ///< the first coordinate of the place
    double y;    ///< the second coordinate of the place
    double size; ///< positive
  };

  /// A field of the sizes at some places.
  /// \param points places with sizes, at least one.
  /// \param gradation how much the size grows over a unit of length; at least 0. A mesh follows up to about
  /// 1.
  /// \throws std::invalid_argument if there are no points, one is not finite, a size is not positive, or the
  /// gradation is negative.
  explicit Points_sizing_field_2(std::vector<Sized_point> points, double gradation = 0.5)
      : points_(std::move(points)), gradation_(gradation) {
    if (points_.empty()) throw std::invalid_argument("a sizing field needs a point");
    if (!(gradation >= 0) || !std::isfinite(gradation))
      throw std::invalid_argument("the gradation of a sizing field must not be negative");
    for (const Sized_point& p : points_)
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !(p.size > 0))
        throw std::invalid_argument("a sizing field needs finite points with positive sizes");
    nodes_.resize(2 * number_of_leaves() - 1);
    build(0, 0, points_.size());
  }

  /// The size at (x, y).
  double operator()(double x, double y) const {
    return (*this)(x, y, std::numeric_limits<double>::infinity());
  }
  /// The lesser of `most` and the size at (x, y). This is found sooner.
  double operator()(double x, double y, double most) const { return least<1>({{{x, y}}}, most); }

  /// The least of `most` and the sizes at some places. Where they are near each other, as the corners of a triangle,
  /// this is found sooner than one size after the other.
  template <std::size_t number_of_places>
  double least(const std::array<std::array<double, 2>, number_of_places>& places, double most) const {
    static_assert(number_of_places > 0, "there has to be a place");
    const Places<number_of_places> query(places);
    if (bound(0, query) < most) search(0, 0, points_.size(), query, most);
    return most;
  }

private:
  static constexpr std::size_t leaf_size = 8;

  struct Node {
    double low[2], high[2];
    double least_size;
  };

  template <std::size_t number_of_places>
  struct Places {
    std::array<std::array<double, 2>, number_of_places> places;
    std::array<double, 2> low, high; // their bounding box

    explicit Places(const std::array<std::array<double, 2>, number_of_places>& given)
        : places(given), low(given[0]), high(given[0]) {
      for (const auto& p : places)
        for (std::size_t axis = 0; axis < 2; ++axis) {
          low[axis] = std::min(low[axis], p[axis]);
          high[axis] = std::max(high[axis], p[axis]);
        }
    }
  };

  std::vector<Sized_point> points_; // in the order of the leaves
  std::vector<Node> nodes_;         // the children of node i are 2 i + 1 and 2 i + 2
  double gradation_;

  /// A power of two, so that leaves hold at most `leaf_size` points when intervals are halved.
  std::size_t number_of_leaves() const {
    std::size_t leaves = 1;
    while (leaves * leaf_size < points_.size()) leaves *= 2;
    return leaves;
  }
  bool is_leaf(std::size_t node) const { return 2 * node + 1 >= nodes_.size(); }

  void build(std::size_t node, std::size_t begin, std::size_t end) {
    Node& n = nodes_[node];
    n = {{points_[begin].x, points_[begin].y}, {points_[begin].x, points_[begin].y}, points_[begin].size};
    for (std::size_t i = begin; i < end; ++i) {
      const Sized_point& p = points_[i];
      n.low[0] = std::min(n.low[0], p.x), n.high[0] = std::max(n.high[0], p.x);
      n.low[1] = std::min(n.low[1], p.y), n.high[1] = std::max(n.high[1], p.y);
      n.least_size = std::min(n.least_size, p.size);
    }
    if (is_leaf(node)) return;
    const bool is_wide = n.high[0] - n.low[0] >= n.high[1] - n.low[1];
    const std::size_t middle = begin + (end - begin) / 2;
    using Offset = std::vector<Sized_point>::difference_type;
    std::nth_element(
        points_.begin() + Offset(begin), points_.begin() + Offset(middle), points_.begin() + Offset(end),
        [is_wide](const Sized_point& p, const Sized_point& q) { return is_wide ? p.x < q.x : p.y < q.y; });
    build(2 * node + 1, begin, middle);
    build(2 * node + 2, middle, end);
  }

  /// No point below the node gives less at one of the places, rounding included: all operations are monotone.
  template <class Query>
  double bound(std::size_t node, const Query& query) const {
    const Node& n = nodes_[node];
    const double dx = std::max({n.low[0] - query.high[0], query.low[0] - n.high[0], 0.0});
    const double dy = std::max({n.low[1] - query.high[1], query.low[1] - n.high[1], 0.0});
    return n.least_size + gradation_ * std::sqrt(dx * dx + dy * dy);
  }

  template <class Query>
  void search(std::size_t node, std::size_t begin, std::size_t end, const Query& query, double& best) const {
    if (is_leaf(node)) {
      double least = best;
      for (std::size_t i = begin; i < end; ++i) {
        const Sized_point& p = points_[i];
        if (!(p.size < least)) continue;
        for (const auto& [x, y] : query.places) {
          const double dx = p.x - x, dy = p.y - y;
          least = std::min(least, p.size + gradation_ * std::sqrt(dx * dx + dy * dy));
        }
      }
      best = least;
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const double left = bound(2 * node + 1, query), right = bound(2 * node + 2, query);
    const auto search_left = [&] {
      if (left < best) search(2 * node + 1, begin, middle, query, best);
    };
    const auto search_right = [&] {
      if (right < best) search(2 * node + 2, middle, end, query, best);
    };
    if (left <= right)
      search_left(), search_right();
    else
      search_right(), search_left();
  }
};

} // namespace CGAL

#endif // CGAL_POINTS_SIZING_FIELD_2_H
