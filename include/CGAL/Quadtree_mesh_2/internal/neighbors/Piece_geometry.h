// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Predicates on pieces of segments, for a sweep, by index.
//
// Computes: the order of places and crossings, on which side of a piece they lie, how two pieces lie to each
//           other beside a common point, and where two pieces meet.
// Bound:    O(1) each, plus O(log c) to look up one of c crossings.
// Method:   Pieces end at places, which are numbered in the order of the sweep, and at crossings, which are
//           numbered after them as they are found. Between places only orientations are needed. Only
//           crossings have coordinates that are not in the input; these are rational numbers.
//
// Pieces are never along the rays: each goes from the left to the right, where rays go up.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_PIECE_GEOMETRY_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_PIECE_GEOMETRY_H

#include <CGAL/Quadtree_mesh_2/internal/geometry/Point_arithmetic.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Ranked_places.h>
#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A piece of a segment. If several segments overlap there, it names the first of them.
struct Segment_piece {
  Place left, right;
  Segment_index segment;
};

template <class Point>
class Piece_geometry {
  using Arithmetic = Point_arithmetic<Point>;
  using Exact = typename Arithmetic::Exact;

public:
  using Places = Ranked_places<Point>;

  explicit Piece_geometry(const Places& places) : places_(places) {}

  const Places& places() const { return places_; }
  /// Whether a vertex lies there, rather than a crossing only.
  bool is_vertex(Place p) const { return p.value() < places_.size(); }

  /// The order of the sweep: from left to right, and upwards where that is equal.
  int compare(Place p, Place q) const {
    if (is_vertex(p) && is_vertex(q)) return compare_numbers(p.value(), q.value());
    const int c = compare_exactly(p, q, 0);
    return c != 0 ? c : compare_exactly(p, q, 1);
  }
  /// The order from left to right.
  int compare_lines(Place p, Place q) const {
    if (is_vertex(p) && is_vertex(q)) return compare_numbers(places_.line(p), places_.line(q));
    return compare_exactly(p, q, 0);
  }

  /// Whether `p` is above (positive), on or below (negative) a piece.
  /// \pre it is not left or right of it
  int side(Place p, const Segment_piece& c) const {
    if (p == c.left || p == c.right) return 0;
    const auto base = ends(c);
    if (is_vertex(p)) return places_.orientation(base[0], base[1], p);
    const auto& through = crossing(p).segments;
    if (through[0] == c.segment || through[1] == c.segment) return 0;
    const Vector to_right = from_to(base[0], base[1]), to_p = from_to(base[0], p);
    return static_cast<int>(CGAL::sign(cross(to_right, to_p)));
  }

  /// Whether `c` is above (positive), on or below (negative) `d` just right of a common point.
  int compare_right(const Segment_piece& c, const Segment_piece& d) const {
    const auto base = ends(c);
    return -places_.orientation(base[0], base[1], ends(d)[1]);
  }
  /// The same just left of it.
  int compare_left(const Segment_piece& c, const Segment_piece& d) const {
    const auto base = ends(c);
    return -places_.orientation(base[0], base[1], ends(d)[0]);
  }

  /// Where two pieces meet, nowhere or in a point. Notes a crossing.
  /// \pre they do not overlap
  Place meeting(const Segment_piece& c, const Segment_piece& d) {
    // Of the two ends, those that the other piece reaches.
    const int lefts = compare(c.left, d.left), rights = compare(c.right, d.right);
    const Place l = lefts >= 0 ? c.left : d.left, r = rights <= 0 ? c.right : d.right;
    const int length = compare(l, r);
    if (length > 0) return Place();
    if (length == 0) return l;
    const int at_left = lefts == 0 ? 0 : lefts > 0 ? side(l, d) : -side(l, c);
    if (at_left == 0) return l;
    const int at_right = rights == 0 ? 0 : rights < 0 ? side(r, d) : -side(r, c);
    if (at_right == 0) return r;
    return at_left == at_right ? Place() : place_of_crossing(c.segment, d.segment);
  }

  /// An order of the lines through segments; 0 if they are the same. Above and below are for parallel ones.
  int compare_supporting_lines(Segment_index s, Segment_index t) const {
    const auto &a = places_.ends(s), &b = places_.ends(t);
    const int left = places_.orientation(a[0], a[1], b[0]), right = places_.orientation(a[0], a[1], b[1]);
    if (left == 0 && right == 0) return 0;
    const int turn = static_cast<int>(CGAL::sign(cross(from_to(a[0], a[1]), from_to(b[0], b[1]))));
    return turn != 0 ? -turn : -left;
  }

  /// Coordinate 0 is across the rays, 1 along them. Needs the rounding mode of `Interval::Protector`.
  Interval enclosed_coordinate(Place p, int i) const { return Interval(bounds(p, i)); }
  /// That of `q` less that of `p`.
  /// \pre vertices lie there
  Interval enclosed_difference(Place p, Place q, int i) const {
    return Arithmetic::template difference<Interval>(places_.point(q), places_.point(p), input_axis(i));
  }

private:
  using Segment_pair = std::pair<Segment_index, Segment_index>;
  using Vector = std::array<Exact, 2>; ///< across the rays, and along them

  struct Crossing_point {
    Vector position;
    std::array<std::pair<double, double>, 2> bounds;
    std::array<Segment_index, 2> segments;
  };

  template <class Number>
  static int compare_numbers(const Number& a, const Number& b) {
    return a < b ? -1 : b < a ? 1 : 0;
  }

  const Crossing_point& crossing(Place p) const { return crossings_[p.value() - places_.size()]; }

  /// Two vertices on the line of a piece, the left one first.
  typename Places::Ends ends(const Segment_piece& c) const {
    const auto& of_segment = places_.ends(c.segment);
    return {{is_vertex(c.left) ? c.left : of_segment[0], is_vertex(c.right) ? c.right : of_segment[1]}};
  }

  /// The axis of the input that coordinate `i` is along.
  int input_axis(int i) const { return i == 0 ? 1 - places_.axis() : places_.axis(); }

  Exact coordinate(Place p, int i) const {
    if (!is_vertex(p)) return crossing(p).position[std::size_t(i)];
    return Arithmetic::coordinate(places_.point(p), input_axis(i));
  }
  std::pair<double, double> bounds(Place p, int i) const {
    return is_vertex(p) ? Arithmetic::bounds(places_.point(p), input_axis(i))
                        : crossing(p).bounds[std::size_t(i)];
  }
  int compare_exactly(Place p, Place q, int i) const {
    if (p == q) return 0;
    return compare_filtered(Interval(bounds(p, i)), Interval(bounds(q, i)),
                            [&] { return compare_numbers(coordinate(p, i), coordinate(q, i)); });
  }

  Vector from_to(Place p, Place q) const {
    return {{Exact(coordinate(q, 0) - coordinate(p, 0)), Exact(coordinate(q, 1) - coordinate(p, 1))}};
  }
  static Exact cross(const Vector& u, const Vector& v) { return Exact(u[0] * v[1] - u[1] * v[0]); }

  Place place_of_crossing(Segment_index s, Segment_index t) {
    if (t < s) std::swap(s, t);
    const auto found = place_of_crossing_.find({s, t});
    if (found != place_of_crossing_.end()) return found->second;
    const auto &a = places_.ends(s), &b = places_.ends(t);
    const Vector u = from_to(a[0], a[1]), v = from_to(b[0], b[1]);
    const Exact part(cross(from_to(a[0], b[0]), v) / cross(u, v));
    Crossing_point c;
    for (int i = 0; i < 2; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      c.position[k] = Exact(coordinate(a[0], i) + part * u[k]);
      c.bounds[k] = CGAL::to_interval(c.position[k]);
    }
    c.segments = {{s, t}};
    crossings_.push_back(std::move(c));
    const Place p(places_.size() + crossings_.size() - 1);
    place_of_crossing_.emplace(Segment_pair(s, t), p);
    return p;
  }

  const Places& places_;
  std::deque<Crossing_point> crossings_;
  std::map<Segment_pair, Place> place_of_crossing_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_PIECE_GEOMETRY_H
