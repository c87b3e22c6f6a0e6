// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "exact_facts.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace soak {

namespace {

/// Features nearer to each other than this many steps of the coordinates may be left as they are: a vertex between them
/// and the angles around it are rounded by as much as their size.
constexpr long double least_room = 256;

using Real = long double;
using Segment = CGAL::Exact_predicates_inexact_constructions_kernel::Segment_2;

struct Place {
  Real x, y;
  explicit Place(const Point& p) : x(p.x()), y(p.y()) {}
  Place(Real x_, Real y_) : x(x_), y(y_) {}
};
/// Of a place that is one of doubles.
Point point(const Place& p) { return Point(static_cast<double>(p.x), static_cast<double>(p.y)); }
Real distance(const Place& a, const Place& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// The nearest place of the segment from `a` to `b`. Differences of doubles are rounded to 64 bits, which is more than
/// enough to count steps.
Place nearest_on(const Place& a, const Place& b, const Place& p) {
  const Real length = distance(a, b);
  if (length == 0) return a;
  const Real ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
  const Real t = std::clamp((p.x - a.x) * ux + (p.y - a.y) * uy, Real(0), length);
  return {a.x + t * ux, a.y + t * uy};
}
Real distance_to_segment(const Place& a, const Place& b, const Place& p) {
  return distance(nearest_on(a, b, p), p);
}

/// Where the segment from `a` to `b` is nearest to `p` and, if that is next to an end, as far from the end as it is
/// within reach: two legs leave no room at their apex where they are too near to each other that far from it.
std::vector<Place> places_on(const Place& a, const Place& b, const Place& p, Real reach) {
  const Place nearest = nearest_on(a, b, p);
  std::vector<Place> places{nearest};
  const Real share = std::min(Real(1), reach / distance(a, b));
  if (distance(a, nearest) <= reach)
    places.emplace_back(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y));
  if (distance(b, nearest) <= reach)
    places.emplace_back(b.x + share * (a.x - b.x), b.y + share * (a.y - b.y));
  return places;
}

bool is_same(const Place& a, const Place& b) { return a.x == b.x && a.y == b.y; }

/// The distance of the place `q` on the segment from `a` to `b` to the one from `c` to `d`; 0 where it is no more than
/// what it is rounded by. Of legs of one apex it is found by the angle, which is not rounded so.
Real width_between(const Place& a, const Place& b, const Place& c, const Place& d, const Place& q) {
  constexpr Real rounding = 0x1p-61L; // of coordinates; a small share of the steps of doubles
  const Place &apex = is_same(a, c) || is_same(a, d) ? a : b, &far = &apex == &a ? b : a;
  if (!is_same(apex, c) && !is_same(apex, d)) {
    const Real width = distance_to_segment(c, d, q);
    return width > rounding * std::max(std::fabs(q.x), std::fabs(q.y)) ? width : 0;
  }
  const Place& other = is_same(apex, c) ? d : c;
  if (CGAL::orientation(point(apex), point(far), point(other)) == CGAL::COLLINEAR) return 0;
  const Real ux = far.x - apex.x, uy = far.y - apex.y, vx = other.x - apex.x, vy = other.y - apex.y;
  if (ux * vx + uy * vy <= 0) return distance(q, apex);
  const Real sine = std::fabs(ux * vy - uy * vx) / (std::hypot(ux, uy) * std::hypot(vx, vy));
  return distance(q, apex) * std::max(sine, std::numeric_limits<Real>::epsilon());
}

Real least_positive(Real a, Real b) { return b > 0 ? std::min(a, b) : a; }

/// The graph with segments cut at the vertices on them, so that segments that meet there have a common end.
Pslg cut_at_vertices(const Pslg& graph) {
  Pslg result;
  result.vertices = graph.vertices;
  for (const auto& [a, b] : graph.segments) {
    const Segment segment(graph.point(a), graph.point(b));
    const CGAL::Bbox_2 box = segment.bbox();
    std::vector<Pslg::Vertex_index> on{a};
    for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
      const Point& p = graph.vertices[v];
      // Boxes first: next to the origin, where intervals underflow, has_on is exact and slow.
      if (CGAL::do_overlap(box, p.bbox()) && segment.has_on(p) && p != graph.point(a)) on.emplace_back(v);
    }
    std::sort(on.begin() + 1, on.end(), [&, a = a](auto v, auto w) {
      return CGAL::has_smaller_distance_to_point(graph.point(a), graph.point(v), graph.point(w));
    });
    for (std::size_t i = 1; i < on.size(); ++i)
      if (graph.point(on[i - 1]) != graph.point(on[i])) result.add_segment(on[i - 1], on[i]);
  }
  return result;
}

/// The same, made once for the many places of one graph that are asked about.
const Pslg& cut_once(const Pslg& graph) {
  thread_local Pslg uncut, cut;
  if (uncut.vertices != graph.vertices || uncut.segments != graph.segments) {
    cut = cut_at_vertices(graph);
    uncut = graph;
  }
  return cut;
}

} // namespace

bool do_cross(const Pslg& graph, std::size_t s, std::size_t t) {
  const Point &a = graph.point(graph.segments[s][0]), &b = graph.point(graph.segments[s][1]),
              &c = graph.point(graph.segments[t][0]), &d = graph.point(graph.segments[t][1]);
  return CGAL::orientation(a, b, c) * CGAL::orientation(a, b, d) < 0 &&
         CGAL::orientation(c, d, a) * CGAL::orientation(c, d, b) < 0;
}

std::optional<std::pair<std::size_t, std::size_t>> find_crossing(const Pslg& graph) {
  const std::size_t n = graph.segments.size();
  std::vector<CGAL::Bbox_2> boxes;
  for (const auto& s : graph.segments) boxes.push_back(graph.point(s[0]).bbox() + graph.point(s[1]).bbox());
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t s, std::size_t t) { return boxes[s].xmin() < boxes[t].xmin(); });
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n && boxes[order[j]].xmin() <= boxes[order[i]].xmax(); ++j) {
      const std::size_t s = std::min(order[i], order[j]), t = std::max(order[i], order[j]);
      if (CGAL::do_overlap(boxes[s], boxes[t]) && do_cross(graph, s, t)) return std::pair(s, t);
    }
  return {};
}

bool are_on_a_line(const std::vector<Point>& points) {
  std::size_t other = 0;
  while (other < points.size() && points[other] == points[0]) ++other;
  for (std::size_t i = other; i < points.size(); ++i)
    if (CGAL::orientation(points[0], points[other], points[i]) != CGAL::COLLINEAR) return false;
  return true;
}

bool is_on_a_segment(const Pslg& graph, const Point& p) {
  return std::any_of(graph.segments.begin(), graph.segments.end(),
                     [&](const auto& s) { return Segment(graph.point(s[0]), graph.point(s[1])).has_on(p); });
}

Real distance_to_nearest_segment(const Pslg& graph, const Point& p) {
  Real least = std::numeric_limits<Real>::infinity();
  for (const auto& s : graph.segments)
    least =
        std::min(least, distance_to_segment(Place(graph.point(s[0])), Place(graph.point(s[1])), Place(p)));
  return least;
}

Resolution::Resolution(const Soak_case& c) : is_of_doubles_(c.kernel != Kernel::FIXED32) {
  if (c.kernel == Kernel::FILTERED || c.kernel == Kernel::EXACT) return;
  // Words of 64 bits have the middle half of a root of 2^62 units; a graph for those of 32 bits is one of words.
  unit_ = c.kernel == Kernel::FIXED ? std::ldexp(Real(extent_of(c.graph.vertices)), -60) : 1;
}

Real Resolution::at(const Point& p) const {
  const double largest = std::max(std::fabs(p.x()), std::fabs(p.y()));
  const Real step = Real(std::nextafter(largest, std::numeric_limits<double>::infinity())) - largest;
  return is_of_doubles_ ? std::max(step, unit_) : unit_;
}

Real least_feature_distance(const Pslg& uncut, const Point& place, Real reach, Real enough) {
  const Pslg& graph = cut_once(uncut);
  const Place p(place);
  std::vector<std::size_t> vertices, segments;
  for (std::size_t v = 0; v < graph.vertices.size(); ++v)
    if (distance(Place(graph.vertices[v]), p) <= reach) vertices.push_back(v);
  Real least = std::numeric_limits<Real>::infinity();
  const auto ends_of = [&](std::size_t s) {
    return std::pair(Place(graph.point(graph.segments[s][0])), Place(graph.point(graph.segments[s][1])));
  };
  for (std::size_t s = 0; s < graph.segments.size(); ++s) {
    const auto [a, b] = ends_of(s);
    if (distance_to_segment(a, b, p) <= reach) segments.push_back(s);
  }
  const auto look = [&](const Point& q, std::size_t s) {
    const Point &a = graph.point(graph.segments[s][0]), &b = graph.point(graph.segments[s][1]);
    // a distance of 0 is one too small to be told from 0
    const Real d = distance_to_segment(Place(a), Place(b), Place(q));
    if (d < least && !Segment(a, b).has_on(q)) least = d;
  };
  for (const std::size_t v : vertices) {
    if (least <= enough) return least;
    const Point& q = graph.vertices[v];
    for (const Point& r : graph.vertices) least = least_positive(least, distance(Place(q), Place(r)));
    for (std::size_t s = 0; s < graph.segments.size(); ++s) look(q, s);
  }
  for (const std::size_t s : segments) {
    if (least <= enough) return least;
    for (const Point& r : graph.vertices) look(r, s);
    const auto [a, b] = ends_of(s);
    for (const std::size_t t : segments) {
      if (s == t) continue;
      const auto [c, d] = ends_of(t);
      for (const Place& q : places_on(a, b, p, reach))
        least = least_positive(least, width_between(a, b, c, d, q));
    }
  }
  return least;
}

bool is_without_room(const Soak_case& c, const Point& p, Real reach) {
  const Real room = least_room * Resolution(c).at(p);
  return least_feature_distance(c.graph, p, reach, room) <= room;
}

bool is_within_needle(const Soak_case& c, const Point& point) {
  const Place p(point);
  const Pslg graph = cut_at_vertices(c.graph);
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    const Place apex(graph.vertices[v]);
    std::vector<Place> ends;
    for (const auto& [a, b] : graph.segments)
      if (graph.point(a) == graph.vertices[v] || graph.point(b) == graph.vertices[v])
        ends.emplace_back(graph.point(graph.point(a) == graph.vertices[v] ? b : a));
    const Real room = least_room * Resolution(c).at(graph.vertices[v]);
    for (const Place& end : ends)
      for (const Place& other : ends) {
        const Real reach = std::min(distance(apex, end), distance(apex, other));
        if (distance(apex, p) > reach) continue;
        const Real share = distance(apex, p) / distance(apex, end);
        const Place at(apex.x + share * (end.x - apex.x), apex.y + share * (end.y - apex.y));
        const Real width = width_between(apex, end, apex, other, at);
        if (width > 0 && width <= room) return true;
      }
  }
  return false;
}

bool do_sizes_lack_room(const Soak_case& c, const Point& p) {
  const Real extent = extent_of(c.graph.vertices), room = least_room * Resolution(c).at(p);
  const auto is_short = [&](Real side) { return side > 0 && side <= room; };
  return is_short(c.wishes.max_edge * extent) || is_short(std::sqrt(Real(c.wishes.max_area)) * extent) ||
         is_short(c.wishes.size * extent) ||
         std::any_of(c.graph.regions.begin(), c.graph.regions.end(),
                     [&](const auto& r) { return is_short(std::sqrt(Real(r.max_area))); });
}

} // namespace soak
