// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_SEGMENTS_SIZING_FIELD_2_H
#define CGAL_SEGMENTS_SIZING_FIELD_2_H

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// A sizing field by the distance from a graph, for `Quality_mesh_options_2::size()`. The size at a place is
/// `size + gradation * distance`, for the distance to the nearest segment or vertex of the graph.
///
/// Segments are in a tree of boxes (a k-d tree of their middles). A search visits the nearer branch first and skips
/// branches that are farther than what is found. Several threads may call it at once. O(n log n) time to build. A call
/// takes O(log n) where segments are not much longer than the distances between them, which is usual.
/// \cgalModels{SizingField_2}
class Segments_sizing_field_2 {
public:
  /// A field of one size on all of a graph.
  /// \param pslg a graph with a vertex or more, which is not needed afterward.
  /// \param size that on segments and vertices; positive.
  /// \param gradation how much the size grows over a unit of length; at least 0. A mesh follows up to about 1.
  /// \throws std::invalid_argument if there is no vertex, one is not finite, the size is not positive, or the
  /// gradation is negative.
  template <class Point>
  Segments_sizing_field_2(const Pslg_2<Point>& pslg, double size, double gradation)
      : size_(size), gradation_(gradation) {
    if (!(size > 0) || !std::isfinite(size))
      throw std::invalid_argument("the size of a sizing field has to be positive");
    if (!(gradation >= 0) || !std::isfinite(gradation))
      throw std::invalid_argument("the gradation of a sizing field must not be negative");
    collect(pslg);
    if (segments_.empty()) throw std::invalid_argument("a sizing field needs a vertex");
    nodes_.resize(2 * number_of_leaves() - 1);
    build(0, 0, segments_.size());
  }

  /// The size at (x, y).
  double operator()(double x, double y) const { return size_ + gradation_ * distance(x, y); }

  /// The distance from (x, y) to the nearest segment or vertex.
  double distance(double x, double y) const {
    double best = std::numeric_limits<double>::infinity();
    search(0, 0, segments_.size(), {x, y}, best);
    return std::sqrt(best);
  }

private:
  static constexpr std::size_t leaf_size = 4;

  using Place = std::array<double, 2>;
  /// A vertex alone has two equal ends.
  struct Segment {
    Place a, b;
  };
  struct Box {
    Place low, high;
  };

  std::vector<Segment> segments_; // in the order of the leaves
  std::vector<Box> nodes_;        // the children of node i are 2 i + 1 and 2 i + 2
  double size_, gradation_;

  template <class Point>
  void collect(const Pslg_2<Point>& pslg) {
    using Quadtree_mesh_2::internal::as_double;
    std::vector<Place> places;
    places.reserve(pslg.vertices.size());
    for (const Point& p : pslg.vertices) {
      places.push_back({as_double(p.x()), as_double(p.y())});
      if (!std::isfinite(places.back()[0]) || !std::isfinite(places.back()[1]))
        throw std::invalid_argument("a sizing field needs finite vertices");
    }
    std::vector<char> is_end(places.size(), 0);
    for (const auto& [a, b] : pslg.segments) {
      segments_.push_back({places[std::size_t(a)], places[std::size_t(b)]});
      is_end[std::size_t(a)] = is_end[std::size_t(b)] = 1;
    }
    for (std::size_t v = 0; v < places.size(); ++v)
      if (is_end[v] == 0) segments_.push_back({places[v], places[v]});
  }

  /// A power of two, so that leaves hold at most `leaf_size` segments when intervals are halved.
  std::size_t number_of_leaves() const {
    std::size_t leaves = 1;
    while (leaves * leaf_size < segments_.size()) leaves *= 2;
    return leaves;
  }
  bool is_leaf(std::size_t node) const { return 2 * node + 1 >= nodes_.size(); }

  void build(std::size_t node, std::size_t begin, std::size_t end) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box& box = nodes_[node];
    box = {{infinity, infinity}, {-infinity, -infinity}};
    for (std::size_t i = begin; i < end; ++i)
      for (const Place& p : {segments_[i].a, segments_[i].b})
        for (std::size_t axis = 0; axis < 2; ++axis) {
          box.low[axis] = std::min(box.low[axis], p[axis]);
          box.high[axis] = std::max(box.high[axis], p[axis]);
        }
    if (is_leaf(node)) return;
    const std::size_t axis = box.high[0] - box.low[0] >= box.high[1] - box.low[1] ? 0 : 1;
    const std::size_t middle = begin + (end - begin) / 2;
    using Offset = std::vector<Segment>::difference_type;
    std::nth_element(segments_.begin() + Offset(begin), segments_.begin() + Offset(middle),
                     segments_.begin() + Offset(end), [axis](const Segment& s, const Segment& t) {
                       return s.a[axis] + s.b[axis] < t.a[axis] + t.b[axis];
                     });
    build(2 * node + 1, begin, middle);
    build(2 * node + 2, middle, end);
  }

  // Distances are squared below.

  static double to_segment(const Segment& s, const Place& p) {
    const double x = s.b[0] - s.a[0], y = s.b[1] - s.a[1];
    const double px = p[0] - s.a[0], py = p[1] - s.a[1];
    const double length = x * x + y * y, share = length > 0 ? (px * x + py * y) / length : 0;
    const double t = std::min(std::max(share, 0.0), 1.0);
    const double dx = px - t * x, dy = py - t * y;
    return dx * dx + dy * dy;
  }

  double to_box(std::size_t node, const Place& p) const {
    const Box& box = nodes_[node];
    const double dx = std::max({box.low[0] - p[0], p[0] - box.high[0], 0.0});
    const double dy = std::max({box.low[1] - p[1], p[1] - box.high[1], 0.0});
    return dx * dx + dy * dy;
  }

  void search(std::size_t node, std::size_t begin, std::size_t end, const Place& p, double& best) const {
    if (is_leaf(node)) {
      for (std::size_t i = begin; i < end; ++i) best = std::min(best, to_segment(segments_[i], p));
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const double left = to_box(2 * node + 1, p), right = to_box(2 * node + 2, p);
    const auto search_left = [&] {
      if (left < best) search(2 * node + 1, begin, middle, p, best);
    };
    const auto search_right = [&] {
      if (right < best) search(2 * node + 2, middle, end, p, best);
    };
    if (left <= right)
      search_left(), search_right();
    else
      search_right(), search_left();
  }
};

} // namespace CGAL

#endif // CGAL_SEGMENTS_SIZING_FIELD_2_H
