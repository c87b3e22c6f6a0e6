// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Vertex-edge neighbors by their definition: every segment for every ray and sector, with the intersections
// of an exact kernel. Shares no code with the models of the concept.

#ifndef QUADTREE_MESH_2_TEST_VERTEX_EDGE_BRUTE_FORCE_H
#define QUADTREE_MESH_2_TEST_VERTEX_EDGE_BRUTE_FORCE_H

#include "random_pslg.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/Direction.h>
#include <CGAL/Quadtree_mesh_2/internal/base/compat.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace vertex_edge_test {

using CGAL::Quadtree_mesh_2::Direction;
using CGAL::Quadtree_mesh_2::Segment_index;
using CGAL::Quadtree_mesh_2::Vertex_index;
using CGAL::Quadtree_mesh_2::internal::held_in;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using EP = Exact::Point_2;
using FT = Exact::FT;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<Direction, 4> axis_directions{
    {Direction::EAST, Direction::NORTH, Direction::WEST, Direction::SOUTH}};

inline EP exact_point(const random_pslg::Point& p) { return EP(p.x(), p.y()); }
inline EP exact_point(const EP& p) { return p; }
template <class Word>
EP exact_point(const CGAL::Fixed_point_2<Word>& p) {
  const auto number = [](Word w) {
    const std::uint64_t v = w;
    return FT(static_cast<double>(v >> 31)) * FT(0x1p31) + FT(static_cast<double>(v & 0x7fffffff));
  };
  return EP(number(p.x()), number(p.y()));
}

/// What is nearest, among exact values.
struct Nearest {
  FT squared_distance = 0;
  Vertex_index vertex;
  Segment_index segment;

  bool exists() const { return vertex.is_valid() || segment.is_valid(); }
  void offer(const FT& d, Vertex_index v, Segment_index s) {
    if (exists() && !(d < squared_distance)) return;
    squared_distance = d;
    vertex = v;
    segment = s;
  }
  double distance() const {
    // That of the lazy number itself would be less precise.
    return exists() ? std::sqrt(CGAL::to_double(CGAL::exact(squared_distance))) : infinity;
  }
};

/// All segments for every query.
class Brute_force {
public:
  template <class Pslg>
  explicit Brute_force(const Pslg& pslg) : segments_(pslg.segments) {
    for (const auto& p : pslg.vertices) points_.push_back(exact_point(p));
    for (const EP& p : points_) boxes_.push_back(p.bbox());
  }

  Nearest first_hit(Vertex_index v, Direction d) const {
    const EP& p = point(v);
    const Exact::Ray_2 ray(p, Exact::Direction_2(step_x(d), step_y(d)));
    Nearest best;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const auto ends = segments_[i];
      if (!may_hit(v, d, ends) || point(ends[0]) == p || point(ends[1]) == p) continue;
      if (point(ends[0]) == point(ends[1])) {
        if (ray.has_on(point(ends[0])))
          best.offer(CGAL::squared_distance(p, point(ends[0])), Vertex_index(), Segment_index(i));
        continue;
      }
      const auto meeting = CGAL::intersection(ray, segment(i));
      if (!meeting) continue;
      best.offer(squared_distance(p, meeting), Vertex_index(), Segment_index(i));
    }
    return best;
  }

  Nearest nearest_hit(Vertex_index v) const {
    Nearest best;
    for (const Direction d : axis_directions) {
      const Nearest hit = first_hit(v, d);
      const bool is_better = !best.exists() || hit.squared_distance < best.squared_distance ||
                             (hit.squared_distance == best.squared_distance && hit.segment < best.segment);
      if (hit.exists() && is_better) best = hit;
    }
    return best;
  }

  Nearest nearest_vertex(Vertex_index v) const {
    Nearest best;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (may_be_nearer(boxes_[i], v, best) && points_[i] != point(v))
        best.offer(CGAL::squared_distance(points_[i], point(v)), Vertex_index(i), Segment_index());
    return best;
  }

  Nearest nearest_segment(Vertex_index v) const {
    Nearest best;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (!may_be_nearer(box(segments_[i]), v, best)) continue;
      const EP &a = point(segments_[i][0]), &b = point(segments_[i][1]);
      if (a == point(v) || b == point(v)) continue;
      best.offer(a == b ? CGAL::squared_distance(a, point(v)) : CGAL::squared_distance(segment(i), point(v)),
                 Vertex_index(), Segment_index(i));
    }
    return best;
  }

  /// The sector is cut off far out, so that it is a triangle.
  Nearest nearest_in_sector(Vertex_index v, Vertex_index right, Vertex_index left) const {
    const EP &p = point(v), &r = point(right), &l = point(left);
    const FT far(0x1p120);
    const Exact::Triangle_2 sector(p, p + far * (r - p), p + far * (l - p));
    Nearest best;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (may_be_nearer(boxes_[i], v, best) && sector.has_on_bounded_side(points_[i]))
        best.offer(CGAL::squared_distance(p, points_[i]), Vertex_index(i), Segment_index());
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const auto ends = segments_[i];
      if (!may_be_nearer(box(ends), v, best) || point(ends[0]) == point(ends[1])) continue;
      const auto side = [&](const EP& from, const EP& to, Vertex_index u) {
        return CGAL::orientation(from, to, point(u)) != CGAL::LEFT_TURN;
      };
      if ((side(p, r, ends[0]) && side(p, r, ends[1])) || (side(l, p, ends[0]) && side(l, p, ends[1])))
        continue;
      const auto meeting = CGAL::intersection(segment(i), sector);
      if (!meeting) continue;
      if (const auto* s = held_in<Exact::Segment_2>(*meeting))
        if (sector.has_on_bounded_side(CGAL::midpoint(s->source(), s->target())))
          best.offer(CGAL::squared_distance(p, *s), Vertex_index(), Segment_index(i));
    }
    return best;
  }

  const EP& point(Vertex_index v) const { return points_[std::size_t(v)]; }

private:
  std::vector<EP> points_;
  std::vector<CGAL::Bbox_2> boxes_;
  std::vector<std::array<Vertex_index, 2>> segments_;

  Exact::Segment_2 segment(std::size_t i) const {
    return Exact::Segment_2(point(segments_[i][0]), point(segments_[i][1]));
  }

  CGAL::Bbox_2 box(const std::array<Vertex_index, 2>& ends) const {
    return boxes_[std::size_t(ends[0])] + boxes_[std::size_t(ends[1])];
  }

  /// Whether boxes do not tell that what is in a box is no nearer to a vertex than the best so far.
  bool may_be_nearer(const CGAL::Bbox_2& b, Vertex_index v, const Nearest& best) const {
    if (!best.exists()) return true;
    const CGAL::Bbox_2& p = boxes_[std::size_t(v)];
    const double dx = std::max({0., b.xmin() - p.xmax(), p.xmin() - b.xmax()}),
                 dy = std::max({0., b.ymin() - p.ymax(), p.ymin() - b.ymax()});
    return (dx * dx + dy * dy) * (1 - 1e-9) <= CGAL::to_interval(best.squared_distance).second;
  }

  /// Whether boxes do not tell that it does not.
  bool may_hit(Vertex_index v, Direction d, const std::array<Vertex_index, 2>& ends) const {
    const CGAL::Bbox_2 b = box(ends);
    const CGAL::Bbox_2& p = boxes_[std::size_t(v)];
    return (step_x(d) > 0 || b.xmin() <= p.xmax()) && (step_x(d) < 0 || b.xmax() >= p.xmin()) &&
           (step_y(d) > 0 || b.ymin() <= p.ymax()) && (step_y(d) < 0 || b.ymax() >= p.ymin());
  }

  template <class Meeting>
  static FT squared_distance(const EP& p, const Meeting& meeting) {
    const auto* s = held_in<Exact::Segment_2>(*meeting);
    return s ? CGAL::squared_distance(p, *s) : CGAL::squared_distance(p, *held_in<EP>(*meeting));
  }
};

} // namespace vertex_edge_test

#endif // QUADTREE_MESH_2_TEST_VERTEX_EDGE_BRUTE_FORCE_H
