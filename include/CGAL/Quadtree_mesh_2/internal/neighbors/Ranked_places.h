// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The vertices of a graph in the order in which a line sweeps over them.
//
// Computes: the places of vertices, sorted by the coordinate across the rays of one axis and then by that
//           along them. Equal vertices share a place. For each segment, its two places, the lower one first.
// Bound:    O(n log n) work; that of parallel_sort.h.
//
// A sweep mostly asks which of two vertices comes first, and whether they lie on one line along the rays.
// Both are then comparisons of integers.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_RANKED_PLACES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_RANKED_PLACES_H

#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/Point_arithmetic.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel.h>
#include <CGAL/Quadtree_mesh_2/internal/parallel/parallel_sort.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

struct Place_tag {};
/// The rank of a place in the order of a sweep.
using Place = Index<Place_tag>;

template <class Point>
class Ranked_places {
  using Arithmetic = Point_arithmetic<Point>;

public:
  /// A segment's places, the lower one first.
  using Ends = std::array<Place, 2>;

  /// \param axis that of the rays: 0 for those along x, 1 for those along y.
  template <class ConcurrencyTag, class Graph>
  static Ranked_places of(const Graph& graph, int axis) {
    Ranked_places result;
    result.axis_ = axis;
    result.rank_vertices<ConcurrencyTag>(graph.vertices);
    result.ends_.resize(graph.segments.size());
    for_each_index<ConcurrencyTag>(graph.segments.size(), [&](std::size_t s) {
      const Place a = result.place(graph.segments[s][0]), b = result.place(graph.segments[s][1]);
      result.ends_[Segment_index(s)] = a < b ? Ends{{a, b}} : Ends{{b, a}};
    });
    return result;
  }

  std::size_t size() const { return points_.size(); }
  int axis() const { return axis_; }
  const Point& point(Place p) const { return points_[p]; }
  Place place(Vertex_index v) const { return place_of_[v]; }
  const Ends& ends(Segment_index s) const { return ends_[s]; }

  /// Lines along the rays are numbered, too.
  std::uint32_t line(Place p) const { return lines_[p]; }
  /// Whether a segment lies along the rays. A single point does.
  bool is_along_rays(Segment_index s) const { return line(ends(s)[0]) == line(ends(s)[1]); }

  /// The sign of the turn p, q, r, positive to the left, where rays go up.
  int orientation(Place p, Place q, Place r) const {
    const int turn = Arithmetic::orientation(point(p), point(q), point(r));
    return axis_ == 1 ? turn : -turn;
  }

private:
  /// A vertex, and bounds on its coordinate across the rays, which tell most of them apart.
  struct Key {
    std::pair<double, double> across;
    std::uint32_t vertex;
  };

  template <class ConcurrencyTag>
  void rank_vertices(const std::vector<Point>& vertices) {
    std::vector<Key> keys(vertices.size());
    for_each_index<ConcurrencyTag>(keys.size(), [&](std::size_t i) {
      keys[i] = {Arithmetic::bounds(vertices[i], 1 - axis_), static_cast<std::uint32_t>(i)};
    });
    sort<ConcurrencyTag>(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
      if (a.across.second < b.across.first) return true;
      if (b.across.second < a.across.first) return false;
      const Point &p = vertices[a.vertex], &q = vertices[b.vertex];
      const int c = Arithmetic::compare(p, q, 1 - axis_);
      return c < 0 || (c == 0 && Arithmetic::compare(p, q, axis_) < 0);
    });
    points_.reserve(keys.size());
    lines_.reserve(keys.size());
    place_of_.resize(keys.size());
    for (const Key& key : keys) {
      const Point& p = vertices[key.vertex];
      const bool is_on_last_line = !points_.empty() && Arithmetic::compare(points_.back(), p, 1 - axis_) == 0;
      if (!is_on_last_line || Arithmetic::compare(points_.back(), p, axis_) != 0) {
        lines_.push_back(lines_.empty() ? 0 : lines_.back() + (is_on_last_line ? 0 : 1));
        points_.push_back(p);
      }
      place_of_[Vertex_index(key.vertex)] = Place(points_.size() - 1);
    }
  }

  int axis_ = 1;
  Indexed_vector<Place, Point> points_;
  Indexed_vector<Place, std::uint32_t> lines_;
  Indexed_vector<Vertex_index, Place> place_of_;
  Indexed_vector<Segment_index, Ends> ends_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_RANKED_PLACES_H
